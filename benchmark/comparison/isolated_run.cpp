// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "isolated_run.h"

#include "../forked.h"
#include "../methods/defect_of.h"
#include "message.h"

#include <CGAL/Real_timer.h>

#include <cstdint>
#include <exception>
#include <utility>
#include <vector>

namespace {

std::string first_line(const std::string& text)
{
  return text.substr(0, text.find('\n'));
}

Message message_of(const std::function<Method_result()>& work)
{
  Message message;
  CGAL::Real_timer timer;
  timer.start();
  try {
    message.result = work();
  } catch(const std::exception& error) {
    message.error = first_line(error.what());
    if(message.error.empty())
      message.error = "an exception";
  }
  message.seconds = timer.time();
  return message;
}

/// Reads the answer into the result, and from it what became of the work.
void judge(Isolated_result& run, const std::vector<std::uint8_t>& answer)
{
  Message message;
  try {
    message = to_message(answer);
  } catch(const std::exception& error) {
    run.status = "invalid";
    run.message = first_line(error.what());
    return;
  }
  run.seconds = message.seconds;
  run.result.stages = message.result.stages;
  const std::string defect = defect_of(message.result.skeleton);
  if(!message.error.empty()) {
    run.status = "failed";
    run.message = message.error;
  }
  else if(!defect.empty()) {
    run.status = "invalid";
    run.message = defect;
  }
  else {
    run.status = "ok";
    run.result.skeleton = std::move(message.result.skeleton);
  }
}

} // namespace

Isolated_result run_isolated(const std::function<Method_result()>& work, double time_limit)
{
  const Forked forked = run_forked([&work] { return to_bytes(message_of(work)); }, time_limit);
  Isolated_result run;
  run.seconds = forked.seconds;
  run.peak_memory = forked.peak_memory;
  if(!forked.in_time) {
    run.status = "time_limit";
    run.message = "stopped";
  }
  else if(!forked.death.empty()) {
    run.status = "failed";
    run.message = forked.death;
  }
  else {
    judge(run, forked.answer);
  }
  return run;
}
