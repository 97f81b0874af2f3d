// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "forked.h"

#include <CGAL/Real_timer.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace {

using Bytes = std::vector<std::uint8_t>;

[[noreturn]] void fail(const std::string& what)
{
  throw std::runtime_error(what + ": " + std::strerror(errno));
}

/// `/dev/null` in the place of standard output and error.
void be_silent()
{
  const int null = open("/dev/null", O_WRONLY);
  dup2(null, STDOUT_FILENO);
  dup2(null, STDERR_FILENO);
}

/// The life of the new process. It ends without cleaning up what belongs to its parent; an
/// exception ends it as any other crash.
[[noreturn]] void live(const std::function<Bytes()>& work, int pipe) noexcept
{
  be_silent();
  const Bytes bytes = work();
  for(std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = write(pipe, bytes.data() + done, bytes.size() - done);
    if(written < 0)
      _exit(EXIT_FAILURE);
    done += static_cast<std::size_t>(written);
  }
  _exit(EXIT_SUCCESS);
}

/// Reads until the other side closes. \return whether it did in time
bool read_all(int pipe, double time_limit, Bytes& bytes)
{
  CGAL::Real_timer timer;
  timer.start();
  std::array<std::uint8_t, 65536> buffer;
  for(;;) {
    const double left = std::min(time_limit - timer.time(), 1e6); // what poll() can wait
    pollfd waiting{pipe, POLLIN, 0};
    if(left <= 0 || poll(&waiting, 1, static_cast<int>(std::ceil(1000 * left))) == 0)
      return false;
    const ssize_t got = read(pipe, buffer.data(), buffer.size());
    if(got == 0 || (got < 0 && errno != EINTR))
      return true;
    if(got > 0)
      bytes.insert(bytes.end(), buffer.begin(), buffer.begin() + got);
  }
}

std::string cause_of_death(int state)
{
  if(WIFSIGNALED(state))
    return strsignal(WTERMSIG(state));
  return WEXITSTATUS(state) == EXIT_SUCCESS ? "" : "no answer";
}

} // namespace

Forked run_forked(const std::function<Bytes()>& work, double time_limit)
{
  int ends[2];
  if(pipe(ends) != 0)
    fail("no pipe");
  CGAL::Real_timer timer;
  timer.start();
  const pid_t process = fork();
  if(process < 0)
    fail("no process");
  if(process == 0) {
    close(ends[0]);
    live(work, ends[1]);
  }
  close(ends[1]);
  Forked result;
  result.in_time = read_all(ends[0], time_limit, result.answer);
  close(ends[0]);
  if(!result.in_time)
    kill(process, SIGKILL);
  int state = 0;
  rusage usage{};
  while(wait4(process, &state, 0, &usage) < 0)
    if(errno != EINTR)
      fail("no news of a process");
  result.seconds = timer.time();
  result.peak_memory = static_cast<double>(usage.ru_maxrss) / 1024; // KiB on Linux
  result.death = cause_of_death(state);
  return result;
}
