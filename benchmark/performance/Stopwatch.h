// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_PERFORMANCE_STOPWATCH_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_PERFORMANCE_STOPWATCH_H

#include <CGAL/Real_timer.h>

#include <ctime>
#include <string>
#include <vector>

struct Stage_seconds
{
  std::string name;
  double cpu = 0;  ///< seconds, of all threads
  double wall = 0; ///< seconds
};

/// Seconds of the stages of a method, in order.
class Stopwatch
{
public:
  /// Calls `work` and returns what it returns.
  template <typename Work>
  auto stage(const std::string& name, const Work& work)
  {
    const Running running{stages_, name};
    return work();
  }

  const std::vector<Stage_seconds>& stages() const { return stages_; }

private:
  /// Until the end of its life, so that work may return nothing.
  class Running
  {
  public:
    Running(std::vector<Stage_seconds>& stages, const std::string& name)
        : stages_(stages)
        , name_(name)
        , cpu_(std::clock())
    {
      timer_.start();
    }

    ~Running()
    {
      const double cpu = static_cast<double>(std::clock() - cpu_) / CLOCKS_PER_SEC;
      stages_.push_back({name_, cpu, timer_.time()});
    }

  private:
    std::vector<Stage_seconds>& stages_;
    const std::string& name_;
    std::clock_t cpu_;
    CGAL::Real_timer timer_;
  };

  std::vector<Stage_seconds> stages_;
};

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_PERFORMANCE_STOPWATCH_H
