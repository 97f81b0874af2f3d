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
    normal_boxes_ = tree.boxes_of(normal);
    normals_.reserve(patches.size());
    for(std::size_t i : tree.order())
      normals_.push_back(normal(i));
  }

  /// Radii of the balls that touch a patch from inside and a patch that faces it: of the three
  /// smallest the largest, so that two stray patches cannot make one. 0: nothing faces the patch.
  template <typename ConcurrencyTag>
  std::vector<double> radii() const
  {
    std::vector<double> result(normals_.size(), 0);
    constexpr std::size_t row = 128; // of patches next to each other, which touch much the same ones
    parallel_for<ConcurrencyTag>((normals_.size() + row - 1) / row, [&](std::size_t r) {
      std::array<Touches, row> smallest;
      const std::size_t begin = r * row, end = std::min(normals_.size(), begin + row);
      for(std::size_t k = begin; k < end; ++k) {
        if(normals_[k].isZero(0))
          continue;
        Touches& touches = smallest[k - begin];
        // What touches the balls of a patch nearby on the same side bounds them from the start.
        for(std::size_t other = k; other-- > begin && !(touches[2].radius < infinity);)
          for(const Touch& touch : smallest[other - begin])
            add(k, touch.patch, touches);
        find_smallest(k, touches);
        if(touches[2].radius < infinity)
          result[tree_.order()[k]] = touches[2].radius;
      }
    });
    return result;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  /// A patch that a ball touches.
  struct Touch
  {
    double radius = infinity;
    std::size_t patch = none;
  };
  using Touches = std::array<Touch, 3>; ///< Those of three balls, the smallest first.

  /// Adds to the smallest balls of a patch the one that touches another one, if it is among them.
  void add(std::size_t patch, std::size_t other, Touches& smallest) const
  {
    if(other == none || normals_[other].dot(normals_[patch]) > facing_normals)
      return;
    const Vector3 d = tree_.positions()[other] - tree_.positions()[patch];
    const double depth = -normals_[patch].dot(d);
    const Touch touch{depth > 0 ? d.squaredNorm() / (2 * depth) : infinity, other};
    if(!(touch.radius < smallest[2].radius) || smallest[0].patch == other ||
       smallest[1].patch == other || smallest[2].patch == other)
      return;
    smallest[2] = touch;
    for(std::size_t i = 2; i > 0 && smallest[i].radius < smallest[i - 1].radius; --i)
      std::swap(smallest[i], smallest[i - 1]);
  }

  /// Finds the smallest balls of a patch; `smallest` are some of its balls at first.
  void find_smallest(std::size_t patch, Touches& smallest) const
  {
    const Vector3 &mean = tree_.positions()[patch], &normal = normals_[patch];
    const auto may_touch = [&](std::size_t node) {
      if(normal_boxes_[node].least(normal) > facing_normals)
        return false;
      // Of the points of the box the one with the least power to the largest ball.
      const Box& box = tree_.boxes()[node];
      const double radius = std::min(smallest[2].radius, std::numeric_limits<double>::max());
      const Vector3 d = (-radius * normal).cwiseMax(box.lower - mean).cwiseMin(box.upper - mean);
      return d.dot(d / radius + 2 * normal) < 0;
    };
    tree_.visit_leaves(may_touch, [&](std::size_t begin, std::size_t end) {
      for(std::size_t other = begin; other < end; ++other)
        add(patch, other, smallest);
    });
  }

  const Box_tree& tree_;
  std::vector<Box> normal_boxes_; ///< Of every node of the tree.
  std::vector<Vector3> normals_;  ///< In the order of the tree; 0 if not to be trusted.
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
