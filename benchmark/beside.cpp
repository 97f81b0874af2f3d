// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "beside.h"

#include <CGAL/bounding_box.h>

#include <cmath>
#include <vector>

Scene_beside beside(const std::vector<Point>& cloud, const std::vector<Point>& neighbor)
{
  const auto box = CGAL::bounding_box(cloud.begin(), cloud.end());
  const auto other = CGAL::bounding_box(neighbor.begin(), neighbor.end());
  const auto diagonal = [](const auto& b) {
    return std::sqrt(CGAL::squared_distance((b.min)(), (b.max)()));
  };
  const double length = diagonal(box), scale = length / diagonal(other), gap = 1.5 * length;
  Scene_beside result{cloud, box.xmax() + gap / 2};
  const Point corner = (box.min)() + (box.xmax() - box.xmin() + gap) * Kernel::Vector_3(1, 0, 0);
  for(const Point& p : neighbor)
    result.points.push_back(corner + scale * (p - (other.min)()));
  return result;
}
