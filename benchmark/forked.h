// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_FORKED_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_FORKED_H

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// How the life of a process went.
struct Forked
{
  std::string death;                ///< why there is no answer, e.g. a signal; empty if there is
  bool in_time = true;              ///< else it was killed
  std::vector<std::uint8_t> answer; ///< what the work returned
  double seconds = 0;               ///< wall-clock
  double peak_memory = 0;           ///< MiB, with the program and all that the caller held
};

/// Does the work in a process of its own, whose memory can be told and whose crash does no harm.
/// What it prints is dropped. It is killed after `time_limit` seconds.
/// \throw std::runtime_error if the system gives no process
/// \pre the caller has one thread: others would not be there in the new process
Forked run_forked(const std::function<std::vector<std::uint8_t>()>& work, double time_limit);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_FORKED_H
