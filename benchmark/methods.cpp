// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#include "methods.h"

#include <CGAL/Point_set_skeletonization_3/parameters.h>
#include <CGAL/extract_l1_medial_skeleton.h>

#include <cmath>

bool has_finite_points(const Skeleton& skeleton)
{
  for(const auto v : CGAL::make_range(vertices(skeleton))) {
    const Point& p = skeleton[v].point;
    if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      return false;
  }
  return true;
}

std::vector<Outcome> skeletonize(const std::vector<Point>& points, bool also_as_published)
{
  const auto extract = [&points](bool as_published) {
    Skeleton skeleton;
    CGAL::extract_l1_medial_skeleton(points, skeleton,
                                     CGAL::parameters::as_published(as_published));
    return skeleton;
  };
  std::vector<Outcome> outcomes;
  outcomes.push_back(run_method("default", [&] { return extract(false); }));
  if(also_as_published)
    outcomes.push_back(run_method("published", [&] { return extract(true); }));
  return outcomes;
}
