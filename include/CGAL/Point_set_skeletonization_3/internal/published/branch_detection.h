// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_BRANCH_DETECTION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_BRANCH_DETECTION_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Published_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/gaussian_functions.h>

#include <CGAL/number_utils.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns the angle at `b` between the segments to `a` and to `c`, in degrees, in [0, 180]; 180 if
/// a segment has no length.
inline double angle_at(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 u = a - b, v = c - b;
  if(u.isZero(0) || v.isZero(0))
    return 180;
  return std::atan2(u.cross(v).norm(), u.dot(v)) * 180 / CGAL_PI;
}

/// Algorithm 1 of the paper, with branches that do not grow over d_max: the listing bounds only the
/// pair that starts one, the text the distance between components. The set A of the paper is
/// `is_free_`; components leave it as they are added to a branch, which is the same since A is only
/// read as A without b while b grows.
class Branch_detection
{
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /// Squared distance, component, and the free one nearest to it; the smaller index comes first
  /// among equal distances.
  using Pair = std::tuple<double, std::size_t, std::size_t>;

public:
  Branch_detection(const Gaussians& mixture, const Branch_detection_options& options)
    : mixture_(mixture)
    , distance_(mixture)
    , options_(options)
    , is_free_(mixture.size(), true)
    , number_free_(mixture.size())
  {
    for(std::size_t i = 0; i < mixture.size(); ++i)
      push_pair(i);
  }

  std::vector<Branch> run()
  {
    std::vector<Branch> branches;
    while(number_free_ >= options_.b_min) {
      const Pair seed = closest_pair();
      const std::size_t i = std::get<1>(seed), j = std::get<2>(seed);
      if(!is_near(i, j))
        break;
      Branch branch = grown(i, j);
      if(branch.size() >= options_.b_min)
        branches.push_back(std::move(branch));
    }
    return branches;
  }

private:
  /// The free component nearest to `i`; `none` if there is no other.
  std::size_t nearest_free(std::size_t i) const
  {
    Progress::poll();
    std::size_t nearest = none;
    double smallest = std::numeric_limits<double>::infinity();
    for(std::size_t j = 0; j < mixture_.size(); ++j) {
      if(j == i || !is_free_[j])
        continue;
      const double d = distance_(i, j);
      if(nearest == none || d < smallest) {
        smallest = d;
        nearest = j;
      }
    }
    return nearest;
  }

  void push_pair(std::size_t i)
  {
    const std::size_t j = nearest_free(i);
    if(j != none)
      pairs_.emplace(distance_(i, j), i, j);
  }

  /// Whether two components are closer than d_max, and not at one place: these form no chain.
  bool is_near(std::size_t i, std::size_t j) const
  {
    const double distance = (mixture_[i].mean - mixture_[j].mean).norm();
    return distance > 0 && distance < options_.d_max;
  }

  /// The closest pair of free components. Distances to the nearest free component only grow, so an
  /// outdated pair is no later in the queue than its successor, and is replaced when it is first.
  /// \pre there are two free components
  Pair closest_pair()
  {
    for(;;) {
      const Pair pair = pairs_.top();
      const std::size_t i = std::get<1>(pair);
      if(is_free_[i] && is_free_[std::get<2>(pair)])
        return pair;
      pairs_.pop();
      if(is_free_[i])
        push_pair(i);
    }
  }

  Branch grown(std::size_t i, std::size_t j)
  {
    Branch branch{j, i};
    take(i);
    take(j);
    grow_end(branch); // the head: the branch is reversed
    std::reverse(branch.begin(), branch.end());
    grow_end(branch);
    return branch;
  }

  void grow_end(Branch& branch)
  {
    for(;;) {
      const std::size_t end = branch.back(), before = branch[branch.size() - 2];
      const std::size_t next = nearest_free(end);
      if(next == none || !is_near(end, next) ||
         !(angle_at(mixture_[before].mean, mixture_[end].mean, mixture_[next].mean) >
           options_.alpha_min))
        return;
      branch.push_back(next);
      take(next);
    }
  }

  void take(std::size_t i)
  {
    is_free_[i] = false;
    --number_free_;
  }

  const Gaussians& mixture_;
  Squared_mahalanobis_distances distance_;
  Branch_detection_options options_;
  std::vector<bool> is_free_;
  std::size_t number_free_;
  std::priority_queue<Pair, std::vector<Pair>, std::greater<Pair>> pairs_;
};

/// Returns disjoint branches of `mixture` in the order in which Algorithm 1 finds them; none if no
/// chain has `options.b_min` components. O(n^2) time, O(n) memory.
inline std::vector<Branch> detect_branches(const Gaussians& mixture,
                                           const Branch_detection_options& options)
{
  options.check();
  return Branch_detection(mixture, options).run();
}

/// As `detect_branches()`, but with at least one branch unless `mixture` is empty. The paper does
/// not define the skeleton of a shape without a long branch. Here `b_min` is lowered until there is
/// a branch, so that a small or short shape gives its longest chains; components that form no chain
/// (one, or all at one place) give the heaviest of them.
inline std::vector<Branch> detect_longest_branches(const Gaussians& mixture,
                                                   Branch_detection_options options)
{
  for(; options.b_min >= 2; --options.b_min) {
    std::vector<Branch> branches = detect_branches(mixture, options);
    if(!branches.empty())
      return branches;
  }
  if(mixture.empty())
    return {};
  const auto heaviest =
    std::max_element(mixture.begin(), mixture.end(), [](const Gaussian& a, const Gaussian& b) {
      return a.weight < b.weight;
    });
  return {{static_cast<std::size_t>(heaviest - mixture.begin())}};
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_BRANCH_DETECTION_H
