// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "alpha_wrap.h"

#include "average_spacing.h"
#include "components_of.h"
#include "remesh.h"

#include <CGAL/alpha_wrap_3.h>

std::vector<Mesh> alpha_wrap(const std::vector<Point>& points)
{
  constexpr double alpha = 3, offset = 0.3; // spacings
  const double spacing = average_spacing(points);
  Mesh wrap;
  CGAL::alpha_wrap_3(points, alpha * spacing, offset * spacing, wrap);
  return components_of(wrap);
}

std::vector<Mesh> fine_alpha_wrap(const std::vector<Point>& points)
{
  return remesh_to(alpha_wrap(points), points.size());
}
