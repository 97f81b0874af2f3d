// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_PERFORMANCE_MEASURE_RUNS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_PERFORMANCE_MEASURE_RUNS_H

#include "Stopwatch.h"
#include "statistics.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

/// Medians of several runs.
struct Measured_runs
{
  std::size_t runs = 0;
  std::vector<Stage_seconds> stages;  ///< the last is "total"
  std::vector<std::vector<Stage_seconds>> stages_of_runs; ///< empty if something went wrong
  double peak_memory = not_measured;  ///< MiB, of the process, which includes program and input
  double extra_memory = not_measured; ///< MiB, what came on top of these
  std::string status = "ok";          ///< or what went wrong in the last run
};

struct Work
{
  std::function<void(Stopwatch&)> run;
  std::size_t threads = 1; ///< at work before the clock starts, as in a program that has used them
};

/// Runs every work `runs` times, each time in a process of its own, one after the other and then
/// all of them again: the speed of a processor changes from minute to minute. A work that goes
/// wrong or takes longer than `time_limit` seconds is not run again.
std::vector<Measured_runs> measure_runs(const std::vector<Work>& works, std::size_t runs,
                                        double time_limit);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_PERFORMANCE_MEASURE_RUNS_H
