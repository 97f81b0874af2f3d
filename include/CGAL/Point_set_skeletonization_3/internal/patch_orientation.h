// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PATCH_ORIENTATION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PATCH_ORIENTATION_H

#include <CGAL/Point_set_skeletonization_3/internal/parallel_for.h>
#include <CGAL/Point_set_skeletonization_3/internal/patch_adjacency.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// How well the normal of `b` continues that of `a`: the cosine between `a`'s normal and `b`'s
/// mirrored in the plane halfway between them, which is 1 for any two patches of one round tube
/// however far apart (Hoppe et al. 1992 compare the normals themselves and lose thin limbs).
inline double continuation(const Patch& a, const Patch& b)
{
  const Vector3 d = (b.mean - a.mean).normalized();
  return a.normal.dot(b.normal - 2 * d.dot(b.normal) * d);
}

/// Flips every normal of one connected piece of surface so that the volume it encloses is positive.
inline void turn_outwards(std::vector<Patch>& patches, const std::vector<std::size_t>& piece)
{
  Vector3 center = Vector3::Zero();
  double weight = 0;
  for(std::size_t i : piece) {
    center += patches[i].weight * patches[i].mean;
    weight += patches[i].weight;
  }
  center /= weight;
  double flux = 0; // of the field x - center through the oriented patches: 3 times the volume
  for(std::size_t i : piece)
    flux += patches[i].planarity * patches[i].spacing * patches[i].spacing *
            patches[i].normal.dot(patches[i].mean - center);
  if(flux < 0)
    for(std::size_t i : piece)
      patches[i].normal = -patches[i].normal;
}

/// Makes the normals of adjacent patches consistent and outward: a spanning tree that crosses the
/// best continued edges first (Hoppe et al. 1992) hands the sign on, and the sign of the enclosed
/// volume fixes it for every connected piece.
inline void orient_patches(std::vector<Patch>& patches)
{
  using Step = std::tuple<double, std::size_t, std::size_t>; // trust, to, from
  std::vector<bool> done(patches.size(), false);
  std::vector<double> best(patches.size(), 0); // trust of the steps to a patch: others come too late
  std::vector<std::size_t> piece;
  for(std::size_t root = 0; root < patches.size(); ++root) {
    if(done[root])
      continue;
    piece.clear();
    std::priority_queue<Step> front;
    front.emplace(1, root, root);
    while(!front.empty()) {
      const std::size_t i = std::get<1>(front.top()), from = std::get<2>(front.top());
      front.pop();
      if(done[i])
        continue;
      done[i] = true;
      piece.push_back(i);
      if(continuation(patches[from], patches[i]) < 0)
        patches[i].normal = -patches[i].normal;
      for(std::size_t j : patches[i].neighbors) {
        if(done[j])
          continue;
        const double trust = std::abs(continuation(patches[i], patches[j])) *
                             std::min(patches[i].planarity, patches[j].planarity);
        if(trust >= best[j]) {
          best[j] = trust;
          front.emplace(trust, j, i);
        }
      }
    }
    turn_outwards(patches, piece);
  }
}

/// How far the orientation of every patch can be trusted, in [0, 1]: how flat it is, times how well
/// its neighbours' normals agree with it. Near 0 on twigs thinner than the sampling and in heavy
/// noise: there whatever relies on a normal has to fade out.
template <typename ConcurrencyTag>
std::vector<double> orientation_confidence(const std::vector<Patch>& patches)
{
  std::vector<double> confidence(patches.size(), 0);
  parallel_for<ConcurrencyTag>(patches.size(), [&](std::size_t i) {
    double agreement = 0;
    for(std::size_t j : patches[i].neighbors)
      agreement += continuation(patches[i], patches[j]);
    if(!patches[i].neighbors.empty())
      agreement /= static_cast<double>(patches[i].neighbors.size());
    confidence[i] = patches[i].planarity * std::max(0.0, agreement);
  });
  return confidence;
}

/// Below this confidence a normal is a guess, and nothing is built on it.
constexpr double trusted_orientation = 0.3;

/// Whether two patches look at each other through the air between them: they belong to two limbs
/// that nearly touch.
inline bool look_at_each_other(const Patch& a, const Patch& b)
{
  constexpr double opposite = -0.3; // cosine: a crease between two limbs is a right angle or so
  constexpr double towards = 0.8;   // sum of two cosines: both by 66 degrees, or one straight
  const Vector3 d = (b.mean - a.mean).normalized();
  const double from_a = a.normal.dot(d), from_b = -b.normal.dot(d);
  return a.normal.dot(b.normal) < opposite && from_a > 0 && from_b > 0 &&
         from_a + from_b > towards;
}

/// The orientation gate: patches that look at each other are no neighbours, as far as their
/// orientation can be trusted.
template <typename ConcurrencyTag>
void part_facing_patches(std::vector<Patch>& patches, const std::vector<double>& confidence)
{
  parallel_for<ConcurrencyTag>(patches.size(), [&](std::size_t i) {
    std::vector<std::size_t>& neighbors = patches[i].neighbors;
    neighbors.erase(std::remove_if(neighbors.begin(), neighbors.end(),
                                   [&](std::size_t j) {
                                     return confidence[i] > trusted_orientation &&
                                            confidence[j] > trusted_orientation &&
                                            look_at_each_other(patches[i], patches[j]);
                                   }),
                    neighbors.end());
  });
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PATCH_ORIENTATION_H
