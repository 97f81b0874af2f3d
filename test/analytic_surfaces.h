// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_ANALYTIC_SURFACES_H
#define POINT_SET_SKELETONIZATION_3_TEST_ANALYTIC_SURFACES_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Local_separator.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

/// Patches of tubes in a regular grid, with all that is known of them: rings of patches, one after
/// the other along the axis. The neighbours of a patch are the four beside it.
namespace surfaces {

using CGAL::Point_set_skeletonization_3::internal::Box_tree;
using CGAL::Point_set_skeletonization_3::internal::Local_separator;
using CGAL::Point_set_skeletonization_3::internal::Patch;
using CGAL::Point_set_skeletonization_3::internal::Patches;
using CGAL::Point_set_skeletonization_3::internal::Sample;
using CGAL::Point_set_skeletonization_3::internal::Samples;
using CGAL::Point_set_skeletonization_3::internal::Vector3;

constexpr double ring_radius = 1;    ///< Of the axis of the torus.
constexpr double tube_radius = 0.25; ///< Of the torus and of the tube.
constexpr int across = 18;           ///< Patches of a ring.

/// In the xy plane.
inline Vector3 around(double angle)
{
  return Vector3(std::cos(angle), std::sin(angle), 0);
}

/// A tube of `along` rings: closed, as a torus around the z axis, or straight along the x axis,
/// open at both ends.
struct Tube
{
  bool is_closed;
  int along;

  /// The `j`-th patch of the `i`-th ring. \pre there is such a ring, if the tube is not closed
  std::size_t index(int i, int j) const
  {
    return static_cast<std::size_t>((i + along) % along * across + (j + across) % across);
  }

  /// With outward normals.
  Patches patches() const
  {
    Patches result;
    for(int i = 0; i < along; ++i)
      for(int j = 0; j < across; ++j) {
        const double angle = 2 * CGAL_PI * j / across;
        Patch patch;
        patch.weight = 1;
        patch.spacing = 2 * CGAL_PI * tube_radius / across;
        patch.planarity = 1;
        if(is_closed) {
          const Vector3 radial = around(2 * CGAL_PI * i / along);
          patch.normal = std::cos(angle) * radial + std::sin(angle) * Vector3::UnitZ();
          patch.mean = ring_radius * radial + tube_radius * patch.normal;
          patch.area = 2 * CGAL_PI / along * (ring_radius + tube_radius * std::cos(angle)) *
                       patch.spacing;
        } else {
          patch.normal = Vector3(0, std::cos(angle), std::sin(angle));
          patch.mean = i * patch.spacing * Vector3::UnitX() + tube_radius * patch.normal;
          patch.area = patch.spacing * patch.spacing;
        }
        patch.neighbors = {index(i, j - 1), index(i, j + 1)};
        if(is_closed || i > 0)
          patch.neighbors.push_back(index(i - 1, j));
        if(is_closed || i + 1 < along)
          patch.neighbors.push_back(index(i + 1, j));
        std::sort(patch.neighbors.begin(), patch.neighbors.end());
        result.push_back(patch);
      }
    return result;
  }

  /// The patches of a ring, from one to before another.
  Local_separator separator(int i, int first = 0, int last = across) const
  {
    Local_separator result;
    for(int j = first; j < last; ++j) {
      result.patches.push_back(index(i, j));
      result.sides[0].push_back(index(i - 1, j));
      result.sides[1].push_back(index(i + 1, j));
    }
    result.length = 2 * CGAL_PI * tube_radius * (last - first) / across;
    return result;
  }
};

constexpr Tube torus{true, 60};
constexpr Tube tube{false, 30};

/// A sample on the axis for every patch.
inline Samples samples_of(const Patches& patches)
{
  Samples result;
  for(const Patch& patch : patches)
    result.push_back({patch.mean - tube_radius * patch.normal, tube_radius});
  return result;
}

inline std::vector<Vector3> means_of(const Patches& patches)
{
  std::vector<Vector3> result;
  for(const Patch& patch : patches)
    result.push_back(patch.mean);
  return result;
}

inline Box_tree tree_of(const Patches& patches)
{
  return Box_tree(means_of(patches));
}

} // namespace surfaces

#endif // POINT_SET_SKELETONIZATION_3_TEST_ANALYTIC_SURFACES_H
