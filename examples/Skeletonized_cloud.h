// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_SKELETONIZED_CLOUD_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_SKELETONIZED_CLOUD_H

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/Written_skeleton.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// A cloud with its skeleton and branches: what pages, pictures and tables are made from.
struct Skeletonized_cloud
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point = Kernel::Point_3;
  using Graph = CGAL::Curve_skeleton_3<Kernel>;
  using Branch = CGAL::Point_set_skeletonization_3::internal::Plain_branch;

  /// The branch of a point that has none.
  static constexpr std::uint32_t no_branch = std::uint32_t(-1);

  /// Refers to the points.
  explicit Skeletonized_cloud(const std::vector<Point>& all_points)
      : points(all_points)
  {}

  std::string name;                 ///< Of the file.
  const std::vector<Point>& points; ///< Empty if they were streamed.
  std::size_t number_of_points = 0;
  std::size_t up = 2; ///< The vertical axis: 0 for x, 1 for y, 2 for z.
  CGAL::Point_set_skeletonization_3::internal::Written_skeleton skeleton;
  std::vector<std::size_t> branch_of_vertex;
  std::vector<std::size_t> points_of_vertex;  ///< Their number.
  std::vector<std::size_t> points_of_branch;  ///< Empty if the points were streamed.
  std::vector<std::uint32_t> branch_of_point; ///< `no_branch` for an outlier.
};

/// Sets what the branches tell of vertices and points. O(points + vertices).
inline void assign_branches(const Skeletonized_cloud::Graph& graph, Skeletonized_cloud& cloud)
{
  const auto& branches = cloud.skeleton.branches;
  cloud.branch_of_vertex.resize(num_vertices(graph));
  for(std::size_t b = branches.size(); b-- > 0;) // of several, the first stays
    for(std::size_t v : branches[b].vertices)
      cloud.branch_of_vertex[v] = b;
  cloud.branch_of_point.assign(cloud.points.size(), Skeletonized_cloud::no_branch);
  if(!cloud.points.empty())
    cloud.points_of_branch.assign(branches.size(), 0);
  for(std::size_t v = 0; v < num_vertices(graph); ++v) {
    const std::size_t b = cloud.branch_of_vertex[v];
    cloud.points_of_vertex.push_back(graph[v].indices.size());
    if(!cloud.points_of_branch.empty())
      cloud.points_of_branch[b] += graph[v].indices.size();
    for(std::size_t i : graph[v].indices)
      cloud.branch_of_point[i] = static_cast<std::uint32_t>(b);
  }
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_SKELETONIZED_CLOUD_H
