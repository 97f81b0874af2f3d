// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_BALLS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_BALLS_H

#include <CGAL/Point_set_skeletonization_3/internal/Box_tree.h>
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

/// The patches whose orientation can be trusted, for queries of the balls between them.
class Facing_balls
{
public:
  Facing_balls(const std::vector<Patch>& patches, const std::vector<double>& confidence)
    : patches_(patches), trusted_(trusted(confidence)),
      tree_(trusted_.size(), [&](std::size_t k) { return patches[trusted_[k]].mean; }),
      normals_(tree_.boxes_of([&](std::size_t k) { return patches[trusted_[k]].normal; }))
  {}

  /// Radii of the balls that touch a patch from inside and a patch that faces it: of the three
  /// smallest the largest, so that two stray patches cannot make one. 0: nothing faces the patch.
  double radius(const Patch& patch) const
  {
    constexpr double none = std::numeric_limits<double>::infinity();
    std::array<double, 3> smallest{{none, none, none}};
    const auto bound = [&](std::size_t node) {
      const Box& box = tree_.boxes()[node];
      const double depth = patch.normal.dot(patch.mean) - box.least(patch.normal);
      return normals_[node].least(patch.normal) > facing_normals || !(depth > 0)
               ? none
               : box.squared_distance(patch.mean) / (2 * depth);
    };
    tree_.visit_below(smallest[2], bound, [&](std::size_t k) {
      const Patch& other = patches_[trusted_[k]];
      if(other.normal.dot(patch.normal) > facing_normals)
        return;
      const Vector3 d = other.mean - patch.mean;
      const double depth = -patch.normal.dot(d);
      const double squared = d.squaredNorm();
      if(!(depth > 0) || squared >= 2 * depth * smallest[2])
        return;
      smallest[2] = squared / (2 * depth);
      std::sort(smallest.begin(), smallest.end());
    });
    return smallest[2] < none ? smallest[2] : 0;
  }

private:
  static std::vector<std::size_t> trusted(const std::vector<double>& confidence)
  {
    std::vector<std::size_t> result;
    for(std::size_t i = 0; i < confidence.size(); ++i)
      if(confidence[i] >= trusted_orientation)
        result.push_back(i);
    return result;
  }

  const std::vector<Patch>& patches_;
  std::vector<std::size_t> trusted_;
  Box_tree tree_;
  std::vector<Box> normals_; ///< Of every node of the tree.
};

/// One pass of a median filter over the neighbours on the surface that have a value (> 0).
inline std::vector<double> median_filtered(const std::vector<double>& values,
                                           const std::vector<Patch>& patches)
{
  std::vector<double> result = values;
  std::vector<double> known;
  for(std::size_t i = 0; i < patches.size(); ++i) {
    known.clear();
    if(values[i] > 0)
      known.push_back(values[i]);
    for(std::size_t j : patches[i].neighbors)
      if(values[j] > 0)
        known.push_back(values[j]);
    if(known.empty())
      continue;
    const auto middle = known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2);
    std::nth_element(known.begin(), middle, known.end());
    result[i] = *middle;
  }
  return result;
}

/// Bounds every value by those of the patches around it plus half of the way there: thickness changes
/// no faster. What faces the tip of a limb is the body at its other end, not the tip's other side.
inline void limit_slope(std::vector<double>& values, const std::vector<Patch>& patches)
{
  constexpr double slope = 0.5;
  using Step = std::pair<double, std::size_t>;
  std::priority_queue<Step, std::vector<Step>, std::greater<Step>> queue;
  for(std::size_t i = 0; i < values.size(); ++i)
    if(values[i] > 0)
      queue.emplace(values[i], i);
  while(!queue.empty()) {
    const std::size_t i = queue.top().second;
    const double value = queue.top().first;
    queue.pop();
    if(value > values[i])
      continue;
    for(std::size_t j : patches[i].neighbors) {
      const double bound = value + slope * (patches[i].mean - patches[j].mean).norm();
      if(values[j] > bound || !(values[j] > 0)) {
        values[j] = bound;
        queue.emplace(bound, j);
      }
    }
  }
}

/// The radius of the medial ball at every patch: how thick the shape is there. Shrinking balls (Ma
/// et al. 2012) are at the mercy of every patch nearby; restricted to patches that face each other
/// the relative error is that of the patches over the thickness. Three passes of a median filter
/// remove what is left of outliers, and patches without a ball get that of their surroundings; 0 where
/// there is none at all.
template <typename ConcurrencyTag>
std::vector<double> medial_ball_radii(const std::vector<Patch>& patches,
                                      const std::vector<double>& confidence)
{
  const Facing_balls balls(patches, confidence);
  std::vector<double> radii(patches.size(), 0);
  parallel_for<ConcurrencyTag>(patches.size(), [&](std::size_t i) {
    if(confidence[i] >= trusted_orientation)
      radii[i] = balls.radius(patches[i]);
  });
  for(int pass = 0; pass < 3; ++pass)
    radii = median_filtered(radii, patches);
  limit_slope(radii, patches);
  return radii;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_BALLS_H
