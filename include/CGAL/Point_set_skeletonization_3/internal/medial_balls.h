// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_BALLS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_BALLS_H

#include <CGAL/Point_set_skeletonization_3/internal/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/Per_thread.h>
#include <CGAL/Point_set_skeletonization_3/internal/parallel_for.h>
#include <CGAL/Point_set_skeletonization_3/internal/patch_orientation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Normals that enclose more than this angle (cosine -0.3: 107 degrees) face each other. Balls
/// between such patches only are stable medial balls: a bump or noise on one side makes none.
constexpr double facing_normals = -0.3;

/// The balls between the patches whose orientation can be trusted.
///
/// Patches next to each other are asked for together, in single precision and without a branch: what
/// touches their balls is much the same, and the balls are filtered afterwards.
class Facing_balls
{
public:
  /// `tree` is over the patches; it has to stay.
  Facing_balls(const std::vector<Patch>& patches, const std::vector<double>& confidence,
               const Box_tree& tree)
    : tree_(tree)
  {
    const auto normal = [&](std::size_t i) -> Vector3 {
      if(confidence[i] >= trusted_orientation)
        return patches[i].normal;
      return Vector3::Zero(); // which faces nothing
    };
    for(const Box& box : tree.boxes())
      boxes_.emplace_back(box);
    for(const Box& box : tree.boxes_of(normal))
      normal_boxes_.emplace_back(box);
    sides_.reserve(patches.size());
    for(std::size_t i : tree.order())
      sides_.push_back({patches[i].mean.cast<float>(), normal(i).cast<float>()});
  }

  /// Radii of the balls that touch a patch from inside and a patch that faces it: of the three
  /// smallest the largest, so that two stray patches cannot make one. 0: nothing faces the patch.
  template <typename ConcurrencyTag>
  std::vector<double> radii() const
  {
    std::vector<double> result(sides_.size(), 0);
    constexpr std::size_t rows = 16; // of the patches of a task
    constexpr std::size_t task = rows * row;
    parallel_for<ConcurrencyTag>((sides_.size() + task - 1) / task, [&](std::size_t t) {
      std::vector<Leaf> touched;
      const std::size_t end = std::min(sides_.size(), (t + 1) * task);
      for(std::size_t first = t * task; first < end; first += row) {
        Row_of_balls balls(sides_, first);
        find_smallest(balls, touched);
        for(std::size_t k = 0; k < row && first + k < end; ++k)
          if(const float curvature = balls.third[static_cast<Eigen::Index>(k)]; curvature > 0)
            result[tree_.order()[first + k]] = 1 / static_cast<double>(curvature);
      }
    });
    return result;
  }

private:
  static constexpr std::size_t row = 8; // two or four registers
  using Values = Eigen::Array<float, row, 1>;
  using Leaf = std::pair<std::size_t, std::size_t>; ///< Begin and end of its patches.

  /// What there is to know of a patch.
  struct Side
  {
    Eigen::Vector3f mean;
    Eigen::Vector3f normal; ///< 0 if not to be trusted.
  };

  struct Float_box
  {
    explicit Float_box(const Box& box) : lower(box.lower.cast<float>()), upper(box.upper.cast<float>())
    {}

    Eigen::Vector3f lower, upper;
  };

  /// The smallest balls of patches next to each other.
  struct Row_of_balls
  {
    Row_of_balls(const std::vector<Side>& sides, std::size_t begin)
    {
      for(std::size_t k = 0; k < row; ++k) {
        const Side& side = sides[std::min(begin + k, sides.size() - 1)];
        mean.row(static_cast<Eigen::Index>(k)) = side.mean.transpose();
        normal.row(static_cast<Eigen::Index>(k)) = side.normal.transpose();
      }
    }

    /// Adds the balls that touch another patch; whether they are among the smallest of any.
    void add(const Side& other)
    {
      const Values x = other.mean.x() - mean.col(0), y = other.mean.y() - mean.col(1),
                   z = other.mean.z() - mean.col(2);
      const Values cosine = other.normal.x() * normal.col(0) + other.normal.y() * normal.col(1) +
                            other.normal.z() * normal.col(2);
      const Values depth = -(x * normal.col(0) + y * normal.col(1) + z * normal.col(2));
      // Whether they face each other, 0 or 1.
      const Values facing =
        ((static_cast<float>(facing_normals) - cosine) * std::numeric_limits<float>::max())
          .max(0).min(1);
      const Values curvature = (2 * facing * depth / (x * x + y * y + z * z).max(least)).max(0);
      const Values first_rest = curvature.min(first), second_rest = first_rest.min(second);
      first = first.max(curvature);
      second = second.max(first_rest);
      third = third.max(second_rest);
    }

    /// Whether there may be a patch in a box, with its normal in another box, that touches a ball
    /// among the smallest of any.
    bool may_touch(const Float_box& box, const Float_box& normals) const
    {
      const Values cosine = (normal.col(0) * normals.lower.x()).min(normal.col(0) * normals.upper.x()) +
                            (normal.col(1) * normals.lower.y()).min(normal.col(1) * normals.upper.y()) +
                            (normal.col(2) * normals.lower.z()).min(normal.col(2) * normals.upper.z());
      // Of the points of the box the one with the least power to the largest ball.
      const Values radius = 1 / third.max(least);
      const auto offset = [&](Eigen::Index axis) -> Values {
        return (-radius * normal.col(axis))
          .max(box.lower[axis] - mean.col(axis))
          .min(box.upper[axis] - mean.col(axis));
      };
      const Values x = offset(0), y = offset(1), z = offset(2);
      const Values power = x * (third * x + 2 * normal.col(0)) + y * (third * y + 2 * normal.col(1)) +
                           z * (third * z + 2 * normal.col(2));
      return (cosine - static_cast<float>(facing_normals)).max(power).minCoeff() < 0;
    }

    static constexpr float least = 1e-20f; // instead of 0

    Eigen::Array<float, row, 3> mean, normal;
    // Of the three smallest, the smallest first; 0: there is none.
    Values first = Values::Zero(), second = Values::Zero(), third = Values::Zero();
  };

  /// Finds the smallest balls of a row. Begins with the leaves that those of the row before touch, and
  /// leaves behind which ones they do.
  void find_smallest(Row_of_balls& balls, std::vector<Leaf>& touched) const
  {
    constexpr std::size_t most = 8; // leaves, all around a limb
    const std::vector<Leaf> likely = std::exchange(touched, {});
    const auto look_at = [&](const Leaf& leaf) {
      const Values before = balls.third;
      for(std::size_t other = leaf.first; other < leaf.second; ++other)
        balls.add(sides_[other]);
      if((balls.third - before).maxCoeff() > 0)
        touched.push_back(leaf);
    };
    std::for_each(likely.begin(), likely.end(), look_at);
    tree_.visit_leaves(
      [&](std::size_t node) { return balls.may_touch(boxes_[node], normal_boxes_[node]); },
      [&](std::size_t begin, std::size_t end) {
        const Leaf leaf(begin, end);
        if(std::find(likely.begin(), likely.end(), leaf) == likely.end())
          look_at(leaf);
      });
    if(touched.size() > most) // the balls were smaller when the last ones were found
      touched.erase(touched.begin(), touched.end() - most);
  }

  const Box_tree& tree_;
  std::vector<Float_box> boxes_, normal_boxes_; ///< Of every node of the tree.
  std::vector<Side> sides_;                     ///< In the order of the tree.
};

/// The median of a dozen values, by counting for every one how many are less: in a row that is faster
/// than to sort, where no processor can guess which of two is. \pre there is one
inline double median_of_few(const std::vector<double>& values)
{
  const auto middle = static_cast<int>(values.size() / 2);
  for(double candidate : values) {
    int less = 0, no_greater = 0;
    for(double value : values) {
      less += value < candidate;
      no_greater += value <= candidate;
    }
    if(less <= middle && middle < no_greater)
      return candidate;
  }
  return values.front(); // never: one of them is in the middle
}

/// One pass of a median filter over the neighbours on the surface that have a value (> 0).
template <typename ConcurrencyTag>
std::vector<double> median_filtered(const std::vector<double>& values,
                                    const std::vector<Patch>& patches)
{
  std::vector<double> result = values;
  Per_thread<ConcurrencyTag, std::vector<double>> buffers([] { return std::vector<double>(); });
  parallel_for<ConcurrencyTag>(patches.size(), [&](std::size_t i) {
    std::vector<double>& known = buffers.local();
    known.clear();
    if(values[i] > 0)
      known.push_back(values[i]);
    for(std::size_t j : patches[i].neighbors)
      if(values[j] > 0)
        known.push_back(values[j]);
    if(!known.empty())
      result[i] = median_of_few(known);
  });
  return result;
}

/// Bounds every value by those of the patches around it plus half of the way there: thickness changes
/// no faster. What faces the tip of a limb is the body at its other end, not the tip's other side.
inline void limit_slope(std::vector<double>& values, const std::vector<Patch>& patches)
{
  constexpr double slope = 0.5;
  using Step = std::pair<double, std::size_t>;
  std::priority_queue<Step, std::vector<Step>, std::greater<Step>> queue;
  const auto bound = [&](std::size_t i, std::size_t j) {
    return values[i] + slope * (patches[i].mean - patches[j].mean).norm();
  };
  const auto exceeds = [&](std::size_t j, double most) {
    return values[j] > most || !(values[j] > 0);
  };
  const auto bounds_another = [&](std::size_t i) { // few do
    return std::any_of(patches[i].neighbors.begin(), patches[i].neighbors.end(),
                       [&](std::size_t j) { return exceeds(j, bound(i, j)); });
  };
  for(std::size_t i = 0; i < values.size(); ++i)
    if(values[i] > 0 && bounds_another(i))
      queue.emplace(values[i], i);
  while(!queue.empty()) {
    const auto [value, i] = queue.top();
    queue.pop();
    if(value > values[i])
      continue;
    for(std::size_t j : patches[i].neighbors)
      if(const double most = bound(i, j); exceeds(j, most)) {
        values[j] = most;
        queue.emplace(most, j);
      }
  }
}

/// The radius of the medial ball at every patch: how thick the shape is there. Shrinking balls (Ma
/// et al. 2012) are at the mercy of every patch nearby; restricted to patches that face each other
/// the relative error is that of the patches over the thickness. Three passes of a median filter
/// remove what is left of outliers, and patches without a ball get that of their surroundings; 0 where
/// there is none at all. `tree` is over the patches.
template <typename ConcurrencyTag>
std::vector<double> medial_ball_radii(const std::vector<Patch>& patches,
                                      const std::vector<double>& confidence, const Box_tree& tree)
{
  std::vector<double> radii = Facing_balls(patches, confidence, tree).radii<ConcurrencyTag>();
  for(int pass = 0; pass < 3; ++pass)
    radii = median_filtered<ConcurrencyTag>(radii, patches);
  limit_slope(radii, patches);
  return radii;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_BALLS_H
