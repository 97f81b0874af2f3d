// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_MEASURED_PLANT_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_MEASURED_PLANT_H

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Point_set_skeletonization_3/parameters.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/number_type_config.h>
#include <CGAL/skeleton_branches.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

/// A leaf as it is measured, in the unit of the points and in degrees.
template <typename Kernel>
struct Measured_leaf
{
  typename Kernel::Point_3 start; ///< where it leaves the stem
  double length;                  ///< along its middle, up to its last point
  double angle;                   ///< of the straight line to its middle, to the stem
};

/// The stem and the leaves of a plant that stands upright, from the points of a scan.
template <typename Kernel>
class Measured_plant
{
  using Point = typename Kernel::Point_3;
  using Vector = typename Kernel::Vector_3;
  using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
  using Branch = CGAL::Skeleton_branch_of<Skeleton>;
  using Path = std::vector<typename Skeleton::vertex_descriptor>;

public:
  explicit Measured_plant(const std::vector<Point>& points)
  {
    CGAL::extract_l1_medial_skeleton(points, skeleton_, CGAL::parameters::is_tree(true));
    branches_ = CGAL::skeleton_branches(skeleton_); // from the lowest vertex
    children_.resize(branches_.size());
    for(std::size_t b = 0; b < branches_.size(); ++b)
      if(branches_[b].parent != Branch::none)
        children_[branches_[b].parent].push_back(b);
    if(branches_.empty())
      return;

    // The stem goes straight on, what leaves it are leaves.
    Path stem;
    std::vector<Path> leaves;
    for(std::size_t b = 0; b != Branch::none;) {
      const std::vector<std::size_t>& next = children_[b];
      stem.insert(stem.end(), branches_[b].vertices.begin(), branches_[b].vertices.end());
      const auto straightest =
          std::min_element(next.begin(), next.end(), [this](std::size_t c, std::size_t d) {
            return branches_[c].angle < branches_[d].angle;
          });
      for(auto c = next.begin(); c != next.end(); ++c)
        if(c != straightest)
          leaves.push_back(longest_path_from(*c));
      b = next.empty() ? Branch::none : *straightest;
    }
    stem_length_ = length(stem, points);
    const Vector up = skeleton_[stem.back()].point - skeleton_[stem.front()].point;
    for(const Path& leaf : leaves) {
      constexpr double bump = 0.03; // metres
      const double leaf_length = length(leaf, points);
      const Point start = skeleton_[leaf.front()].point;
      if(leaf_length > bump)
        leaves_.push_back({start, leaf_length, angle(up, point_at(leaf, leaf_length / 2) - start)});
    }
    std::sort(leaves_.begin(), leaves_.end(),
              [](const auto& a, const auto& b) { return a.start.z() < b.start.z(); });
  }

  const Skeleton& skeleton() const { return skeleton_; }
  double stem_length() const { return stem_length_; }
  /// From the lowest to the highest.
  const std::vector<Measured_leaf<Kernel>>& leaves() const { return leaves_; }

private:
  static double angle(const Vector& u, const Vector& v)
  {
    return std::acos(u * v / std::sqrt(u.squared_length() * v.squared_length())) * 180 / CGAL_PI;
  }

  double edge_length(const Path& path, std::size_t i) const
  {
    return std::sqrt(
        CGAL::squared_distance(skeleton_[path[i - 1]].point, skeleton_[path[i]].point));
  }

  /// Along a path and from its end to the farthest point there: the skeleton ends inside the shape.
  double length(const Path& path, const std::vector<Point>& points) const
  {
    double beyond = 0;
    for(std::size_t i : skeleton_[path.back()].indices)
      beyond = (std::max)(beyond,
                          CGAL::squared_distance(points[i], skeleton_[path.back()].point));
    double result = std::sqrt(beyond);
    for(std::size_t i = 1; i < path.size(); ++i)
      result += edge_length(path, i);
    return result;
  }

  /// The point of a path at this length.
  Point point_at(const Path& path, double length) const
  {
    for(std::size_t i = 1; i < path.size(); length -= edge_length(path, i), ++i)
      if(const double edge = edge_length(path, i); length < edge) {
        const Point& p = skeleton_[path[i - 1]].point;
        return p + length / edge * (skeleton_[path[i]].point - p);
      }
    return skeleton_[path.back()].point;
  }

  /// Along a branch and what grows from it.
  Path longest_path_from(std::size_t branch) const
  {
    Path rest;
    double longest = -1;
    for(std::size_t b : children_[branch]) {
      Path path = longest_path_from(b);
      double path_length = 0;
      for(std::size_t i = 1; i < path.size(); ++i)
        path_length += edge_length(path, i);
      if(path_length > longest) {
        longest = path_length;
        rest = std::move(path);
      }
    }
    Path result = branches_[branch].vertices;
    result.insert(result.end(), rest.begin(), rest.end());
    return result;
  }

  Skeleton skeleton_;
  std::vector<Branch> branches_;
  std::vector<std::vector<std::size_t>> children_; // of branches
  double stem_length_ = 0;
  std::vector<Measured_leaf<Kernel>> leaves_;
};

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_MEASURED_PLANT_H
