// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SKELETON_SAMPLES_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SKELETON_SAMPLES_H

#include "Segment_tree.h"

#include <CGAL/boost/graph/split_graph_into_polylines.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace metrics {

/// The middle of a short piece of a skeleton.
struct Skeleton_sample
{
  Point point;
  Vector direction; ///< of the piece, unit length; null for a vertex without edges
  double length;    ///< of the piece
};

namespace internal {

/// Collects the branches for `CGAL::split_graph_into_polylines()`.
template <typename Skeleton>
struct Branch_collector
{
  const Skeleton& skeleton;
  std::vector<std::vector<Point>>& branches;

  void start_new_polyline() { branches.emplace_back(); }
  void add_node(typename boost::graph_traits<Skeleton>::vertex_descriptor v)
  {
    branches.back().push_back(to_point(skeleton[v].point));
  }
  void end_polyline() {}
};

/// Arc length from the first point to each.
inline std::vector<double> arc_lengths(const std::vector<Point>& polyline)
{
  std::vector<double> lengths(1, 0.);
  for(std::size_t i = 1; i < polyline.size(); ++i)
    lengths.push_back(lengths.back() +
                      std::sqrt(CGAL::squared_distance(polyline[i - 1], polyline[i])));
  return lengths;
}

/// The point at arc length `s` of a polyline of at least two points.
inline Point point_at(const std::vector<Point>& polyline, const std::vector<double>& lengths,
                      double s)
{
  const auto after = std::lower_bound(lengths.begin() + 1, lengths.end() - 1, s);
  const auto i = static_cast<std::size_t>(after - lengths.begin());
  const double piece = lengths[i] - lengths[i - 1];
  return polyline[i - 1] +
         (piece > 0 ? (s - lengths[i - 1]) / piece : 0) * (polyline[i] - polyline[i - 1]);
}

/// Cuts a branch into pieces of equal length, and into three at least, so that a piece of a closed
/// branch has a direction.
inline void sample_branch(const std::vector<Point>& branch, double step,
                          std::vector<Skeleton_sample>& samples)
{
  const std::vector<double> lengths = arc_lengths(branch);
  const double length = lengths.back();
  if(!(length > 0)) {
    samples.push_back({branch.front(), CGAL::NULL_VECTOR, step});
    return;
  }
  const double pieces = std::max(3., std::ceil(length / step));
  const double piece = length / pieces;
  for(double i = 0; i < pieces; ++i) {
    const Vector chord =
        point_at(branch, lengths, (i + 1) * piece) - point_at(branch, lengths, i * piece);
    const double norm = std::sqrt(chord.squared_length());
    samples.push_back({point_at(branch, lengths, (i + 0.5) * piece),
                       norm > 0 ? chord / norm : Vector(CGAL::NULL_VECTOR), piece});
  }
}

} // namespace internal

/// Samples a skeleton, a BGL graph whose vertices bundle a `.point`, evenly along its branches.
///
/// \param step the largest length of a piece; > 0, in the unit of the points. A vertex without
/// edges
///   counts as a piece of this length.
template <typename Skeleton>
std::vector<Skeleton_sample> sample_skeleton(const Skeleton& skeleton, double step)
{
  std::vector<std::vector<Point>> branches;
  internal::Branch_collector<Skeleton> collector{skeleton, branches};
  CGAL::split_graph_into_polylines(skeleton, collector);
  std::vector<Skeleton_sample> samples;
  for(const std::vector<Point>& branch : branches)
    internal::sample_branch(branch, step, samples);
  return samples;
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SKELETON_SAMPLES_H
