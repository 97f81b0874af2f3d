// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_WRITE_SEGMENTED_CLOUD_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_WRITE_SEGMENTED_CLOUD_H

#include "Segment_tree.h"
#include "Skeletonized_cloud.h"
#include "write_little_endian.h"

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <vector>

/// The edges of a skeleton, and its lone vertices as edges of no length.
inline metrics::Segment_tree segment_tree_of(const Skeletonized_cloud& cloud)
{
  const auto& vertices = cloud.skeleton.graph.vertices;
  const auto point = [&vertices](std::size_t v) {
    const auto& p = vertices[v].point;
    return metrics::Point(p[0], p[1], p[2]);
  };
  std::vector<metrics::Segment> segments;
  for(const auto& branch : cloud.skeleton.branches) {
    const auto& path = branch.vertices;
    if(path.size() == 1)
      segments.emplace_back(point(path[0]), point(path[0]));
    for(std::size_t i = 1; i < path.size(); ++i)
      segments.emplace_back(point(path[i - 1]), point(path[i]));
  }
  return metrics::Segment_tree(std::move(segments));
}

/// Writes points as a binary PLY with the `branch` of each, the `order` of that branch, and its
/// `distance` to the skeleton. Branch and order are -1 for a point that belongs to no vertex.
class Segmented_points
{
public:
  /// Of `size` points. Refers to the cloud, of which the skeleton is used.
  Segmented_points(std::ostream& os, const Skeletonized_cloud& cloud, std::size_t size)
      : os_(os)
      , cloud_(cloud)
      , tree_(segment_tree_of(cloud))
  {
    os_ << "ply\nformat binary_little_endian 1.0\n"
        << "comment branch and order are -1 for outliers\n"
        << "element vertex " << size << '\n'
        << "property double x\nproperty double y\nproperty double z\n"
        << "property int branch\nproperty int order\nproperty double distance\nend_header\n";
  }

  void write(const Skeletonized_cloud::Point& p, std::uint32_t branch)
  {
    for(double x : {p.x(), p.y(), p.z()})
      write_little_endian<std::uint64_t>(os_, x);
    const bool is_outlier = branch == Skeletonized_cloud::no_branch;
    const std::size_t order = is_outlier ? 0 : cloud_.skeleton.branches[branch].order;
    write_little_endian<std::uint32_t>(os_, is_outlier ? -1 : static_cast<std::int32_t>(branch));
    write_little_endian<std::uint32_t>(os_, is_outlier ? -1 : static_cast<std::int32_t>(order));
    write_little_endian<std::uint64_t>(os_, tree_.nearest(p).distance);
  }

private:
  std::ostream& os_;
  const Skeletonized_cloud& cloud_;
  metrics::Segment_tree tree_;
};

/// The same for all points of a cloud.
inline void write_segmented_cloud(std::ostream& os, const Skeletonized_cloud& cloud)
{
  Segmented_points points(os, cloud, cloud.points.size());
  for(std::size_t i = 0; i < cloud.points.size(); ++i)
    points.write(cloud.points[i], cloud.branch_of_point[i]);
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_WRITE_SEGMENTED_CLOUD_H
