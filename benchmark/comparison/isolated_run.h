// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_ISOLATED_RUN_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_ISOLATED_RUN_H

#include "../methods/Method.h"

#include <functional>
#include <string>

/// How a method's run came out.
struct Isolated_result
{
  std::string status;  ///< ok, failed, time_limit or invalid
  std::string message; ///< why not ok, one line
  Method_result result;
  double seconds = 0;     ///< wall-clock
  double peak_memory = 0; ///< MiB, of the process, which includes program and input
};

/// Does the work in a process of its own, so that whatever it does, the caller goes on: it may
/// throw or crash (failed), take longer than `time_limit` seconds, or return no skeleton
/// (invalid). What it prints is dropped.
/// \throw std::runtime_error if the system gives no process
/// \pre the caller has one thread: others would not be there in the new process
Isolated_result run_isolated(const std::function<Method_result()>& work, double time_limit);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_ISOLATED_RUN_H
