// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_L1_MEDIAL_STAGES_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_L1_MEDIAL_STAGES_H

#include "Method.h"

#include <CGAL/Named_function_parameters.h>

/// A class of this package on the points, its steps as stages.
template <typename Skeletonization,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Method_result l1_medial_stages(const Method_input& input,
                               const NamedParameters& np = CGAL::parameters::default_values())
{
  Method_result result;
  Skeletonization steps(input.points, np);
  timed_stage(result, "mixture", [&] { steps.fit_mixture(); });
  timed_stage(result, "projection", [&] { steps.project(); });
  timed_stage(result, "linking", [&] { steps.link(); });
  steps.extract_skeleton(result.skeleton);
  return result;
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_L1_MEDIAL_STAGES_H
