// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "l1_medial_stages.h"

#include <CGAL/L1_medial_skeletonization_3.h>

#include <optional>

Method_result l1_medial_stages(const Method_input& input, bool as_published)
{
  Method_result result;
  std::optional<CGAL::L1_medial_skeletonization_3<Kernel>> steps;
  timed_stage(result, "mixture", [&] { // the constructor reads the points
    steps.emplace(input.points, CGAL::parameters::as_published(as_published));
    steps->fit_mixture();
  });
  timed_stage(result, "projection", [&] { steps->project(); });
  timed_stage(result, "linking", [&] { steps->link(); });
  steps->extract_skeleton(result.skeleton);
  return result;
}
