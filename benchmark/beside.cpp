// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "beside.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/bounding_box.h>

#include <cmath>
#include <cstddef>
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

Skeleton part_of_cloud(const Skeleton& skeleton, double border)
{
  Skeleton result;
  std::vector<Skeleton::vertex_descriptor> copies(num_vertices(skeleton));
  const auto is_kept = [&](auto v) { return skeleton[v].point.x() < border; };
  for(const auto v : CGAL::make_range(vertices(skeleton)))
    if(is_kept(v))
      copies[v] = add_vertex(skeleton[v], result);
  for(const auto e : CGAL::make_range(edges(skeleton))) {
    const auto a = source(e, skeleton), b = target(e, skeleton);
    if(is_kept(a) && is_kept(b))
      add_edge(copies[a], copies[b], skeleton[e], result);
    else if(is_kept(a) != is_kept(b)) {
      const auto outside = add_vertex(skeleton[is_kept(a) ? b : a], result);
      add_edge(copies[is_kept(a) ? a : b], outside, skeleton[e], result);
    }
  }
  return result;
}
