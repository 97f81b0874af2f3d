// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_END_ON_SIGNALS_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_END_ON_SIGNALS_H

#include <csignal>

#include <thread>
#include <utility>

#if defined(__unix__) || defined(__APPLE__)
#include <pthread.h>
#endif

/// Ends the program at Ctrl-C (SIGINT) and SIGTERM, and when its terminal is closed (SIGHUP), at
/// once and whatever it is doing: a thread of its own waits for them, calls `clean_up()` and lets
/// the signal have its usual effect. To be called first in `main()`, since threads inherit what
/// they are not to be interrupted by.
///
/// A closed pipe or a file that may not grow are errors of the writing, not the end.
template <typename Clean_up>
void end_on_signals(Clean_up clean_up)
{
#if defined(__unix__) || defined(__APPLE__)
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  sigset_t signals;
  sigemptyset(&signals);
  for(const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const bool is_ignored = std::signal(number, SIG_DFL) == SIG_IGN;
    if(number == SIGHUP && is_ignored)
      std::signal(number, SIG_IGN); // as nohup wants it
    else
      sigaddset(&signals, number);
  }
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals, clean_up = std::move(clean_up)]() mutable {
    int number = 0;
    if(sigwait(&signals, &number) != 0)
      return;
    clean_up();
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    std::raise(number);
  }).detach();
#else
  static_cast<void>(clean_up);
#endif
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_END_ON_SIGNALS_H
