// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SOLID_SIDE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SOLID_SIDE_H

#include <CGAL/Point_set_skeletonization_3/internal/Neighbor_search.h>
#include <CGAL/Point_set_skeletonization_3/internal/patch_adjacency.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Tells the air around the shape from its inside, as far as the oriented patches nearby agree.
class Solid_side
{
public:
  Solid_side(const std::vector<Patch>& patches, const std::vector<double>& confidence,
             double spacing)
    : patches_(patches), confidence_(confidence), spacing_(spacing),
      search_(patches.size(), [&](std::size_t i) { return patches[i].mean; })
  {}

  /// Distance between patches.
  double spacing() const { return spacing_; }

  /// Whether `q` is certainly outside: in front of the nearest patches' planes by more than they
  /// are rough. Where the orientation is a guess the answer is no.
  bool in_air(const Vector3& q) const
  {
    constexpr std::size_t witnesses = 4;  // one patch may be wrong
    constexpr double roughness = 0.2;     // of the spacing: how far a patch bends from its plane
    std::vector<Neighbor_search::Neighbor> nearest;
    search_.nearest(q, witnesses, nearest);
    double height = 0, trust = 0;
    for(const auto& neighbor : nearest) {
      const std::size_t i = neighbor.index;
      height += confidence_[i] * patches_[i].normal.dot(q - patches_[i].mean);
      trust += confidence_[i];
    }
    return trust > 0.5 * static_cast<double>(nearest.size()) && height > roughness * spacing_ * trust;
  }

  /// How much the surface around the middle of a segment lies across it, in [0, 1]: the mean squared
  /// cosine between the segment and the normals of the nearest patches. 0 inside a tube that goes
  /// the segment's way, 1 between two sheets that touch.
  double blocked(const Vector3& a, const Vector3& b) const
  {
    constexpr std::size_t witnesses = 8; // a ring of patches, or a few on either of two sheets
    const Vector3 direction = (b - a).normalized();
    std::vector<Neighbor_search::Neighbor> nearest;
    search_.nearest((a + b) / 2, witnesses, nearest);
    double across = 0, flat = 0;
    for(const auto& neighbor : nearest) {
      const Patch& patch = patches_[neighbor.index];
      const double cosine = patch.normal.dot(direction);
      across += patch.planarity * cosine * cosine;
      flat += patch.planarity;
    }
    return flat > 0 ? across / flat : 0;
  }

  /// Whether a segment goes through a sheet of the surface: it crosses the disc of a flat patch.
  /// Needs no orientation, and tells two limbs that touch from one that is thick: between the axes
  /// of the former there are points.
  bool pierces_surface(const Vector3& a, const Vector3& b) const
  {
    constexpr double disc = 0.6; // of a patch's spacing: the discs of a grid's patches leave no gap
    constexpr double flat = 0.5; // patches less planar than this have no disc to speak of
    std::vector<std::size_t> near;
    search_.within((a + b) / 2, (b - a).norm() / 2 + spacing_, near);
    return std::any_of(near.begin(), near.end(), [&](std::size_t i) {
      const Patch& patch = patches_[i];
      const double from = patch.normal.dot(a - patch.mean), to = patch.normal.dot(b - patch.mean);
      if(patch.planarity < flat || from * to >= 0)
        return false;
      const Vector3 crossing = a + from / (from - to) * (b - a);
      return (crossing - patch.mean).norm() < disc * patch.spacing;
    });
  }

  /// Whether a segment leads out of the solid: through its surface, or, where that has a hole,
  /// through the air.
  bool leaves_solid(const Vector3& a, const Vector3& b) const
  {
    if(pierces_surface(a, b))
      return true;
    // Half a patch is the finest gap that patches can show; a long way is asked at 64 places.
    const double steps = std::min(64.0, std::ceil(2 * (b - a).norm() / spacing_));
    for(double step = 1; step < steps; ++step)
      if(in_air(a + step / steps * (b - a)))
        return true;
    return false;
  }

private:
  const std::vector<Patch>& patches_;
  const std::vector<double>& confidence_;
  double spacing_;
  Neighbor_search search_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SOLID_SIDE_H
