// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_PERFORMANCE_PERFORMANCE_ROW_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_PERFORMANCE_PERFORMANCE_ROW_H

#include "measure_runs.h"

#include <cstddef>
#include <string>
#include <vector>

/// One method on one input.
struct Performance_row
{
  std::string input; ///< name of the model
  std::size_t points = 0;
  std::string method;
  std::size_t threads = 1;
  Measured_runs measured;

  /// The seconds of a stage; not a number if something went wrong or there is no such stage.
  double cpu(const std::string& stage) const { return median(stage, &Stage_seconds::cpu); }
  double wall(const std::string& stage) const { return median(stage, &Stage_seconds::wall); }

  /// CPU or wall seconds of a stage in every run; none if something went wrong.
  std::vector<double> of_runs(const std::string& stage, double Stage_seconds::*kind) const
  {
    std::vector<double> result;
    if(measured.status == "ok")
      for(const std::vector<Stage_seconds>& stages : measured.stages_of_runs)
        result.push_back(seconds(stages, stage, kind));
    return result;
  }

private:
  double median(const std::string& stage, double Stage_seconds::*kind) const
  {
    return measured.status == "ok" ? seconds(measured.stages, stage, kind) : not_measured;
  }

  static double seconds(const std::vector<Stage_seconds>& stages, const std::string& name,
                        double Stage_seconds::*kind)
  {
    for(const Stage_seconds& stage : stages)
      if(stage.name == name)
        return stage.*kind;
    return not_measured;
  }
};

/// The names of the methods in the table.
namespace method_names {

inline const std::string ours = "l1_medial";
inline const std::string bare = "l1_medial bare"; ///< its vertices have no indices
inline const std::string streamed = "l1_medial stream";
inline const std::string flow = "MCF of mesh";
inline const std::string wrap_and_flow = "alpha wrap + MCF";
inline const std::string wlop = "WLOP";
inline const std::string neighbors = "Kd_tree 16-NN";

} // namespace method_names

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_PERFORMANCE_PERFORMANCE_ROW_H
