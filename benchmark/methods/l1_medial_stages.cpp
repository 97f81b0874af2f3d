// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#include "l1_medial_stages.h"

#include <CGAL/L1_medial_skeletonization_3.h>

Method_result l1_medial_stages(const Method_input& input, bool as_published)
{
  Method_result result;
  CGAL::L1_medial_skeletonization_3<Kernel> steps(input.points,
                                                  CGAL::parameters::as_published(as_published));
  timed_stage(result, "mixture", [&] { steps.fit_mixture(); });
  timed_stage(result, "projection", [&] { steps.project(); });
  timed_stage(result, "linking", [&] { steps.link(); });
  steps.extract_skeleton(result.skeleton);
  return result;
}
