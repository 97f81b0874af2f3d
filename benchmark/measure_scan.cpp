// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measure_scan.h"

#include "Point_tree.h"
#include "axis_distance.h"
#include "methods/average_spacing.h"
#include "radius_factor.h"
#include "share_within.h"
#include "unsupported_share.h"

#include <CGAL/bounding_box.h>

#include <algorithm>
#include <cmath>

namespace {

/// Of the vertex nearest to a place. \pre there is a vertex
double radius_at(const metrics::Point& p, const Skeleton& skeleton)
{
  const auto all = vertices(skeleton);
  const auto distance = [&](auto v) {
    return CGAL::squared_distance(metrics::to_point(skeleton[v].point), p);
  };
  return skeleton[*std::min_element(all.first, all.second,
                                    [&](auto v, auto w) { return distance(v) < distance(w); })]
    .radius;
}

} // namespace

void measure_scan(Row& row, const Skeleton& skeleton, const Skeleton& reference,
                  const shapes::Known_shape& shape, const std::vector<Point>& points)
{
  constexpr double tolerance = 0.015; // diagonals
  constexpr double samples = 3;       // in the tolerance
  constexpr double support = 3;       // spacings
  const auto box = CGAL::bounding_box(points.begin(), points.end());
  const double near = tolerance * std::sqrt(CGAL::squared_distance(box.min(), box.max()));
  const metrics::Point_tree tree(points);
  const auto is_seen = [&](const metrics::Point& p) {
    return tree.distance(p) <= near + radius_at(p, reference);
  };
  const auto always = [](const metrics::Point&) { return true; };
  std::size_t seen_ends = 0;
  for(const auto v : boost::make_iterator_range(vertices(reference)))
    if(out_degree(v, reference) == 1 && is_seen(metrics::to_point(reference[v].point)))
      ++seen_ends;
  row.seen_ends = seen_ends;
  const double step = near / samples;
  row.found = metrics::share_within(near, reference, skeleton, is_seen, step);
  row.true_share = metrics::share_within(near, skeleton, reference, always, step);
  row.unsupported = metrics::unsupported_share(skeleton, tree, support * average_spacing(points));
  row.radius = metrics::radius_factor(skeleton, shape.axis, near);
  if(!shape.axis.empty())
    row.centred = metrics::axis_distance(skeleton, shape.axis, shape.junctions).centred;
}
