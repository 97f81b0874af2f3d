// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_OCTREE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_OCTREE_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A cell of an octree, by its place among the cells of its level.
using Octree_place = std::array<std::uint32_t, 3>;

/// Bits of a coordinate in a Morton code.
constexpr int octree_bits = 21;

/// Whether points in the unit cube have places in an octree with finest cells of this edge length.
inline bool has_octree(double cell_size) { return cell_size > 1.0 / (1 << (octree_bits - 2)); }

/// Returns the Morton code of a place: cells of one octant are consecutive at every level.
inline std::uint64_t morton_code(const Octree_place& place)
{
  std::uint64_t result = 0;
  for(std::size_t axis = 0; axis < 3; ++axis) {
    std::uint64_t bits = place[axis]; // spread so that two zeros follow each bit
    bits = (bits | bits << 32) & 0x001F00000000FFFFu;
    bits = (bits | bits << 16) & 0x001F0000FF0000FFu;
    bits = (bits | bits << 8) & 0x100F00F00F00F00Fu;
    bits = (bits | bits << 4) & 0x10C30C30C30C30C3u;
    bits = (bits | bits << 2) & 0x1249249249249249u;
    result |= bits << axis;
  }
  return result;
}

/// Calls `visit(place)` for a cell and its 26 neighbours until it returns true; returns whether it
/// did.
template <typename Visit>
bool visit_block(const Octree_place& place, const Visit& visit)
{
  for(std::uint32_t x = place[0] - 1; x != place[0] + 2; ++x)
    for(std::uint32_t y = place[1] - 1; y != place[1] + 2; ++y)
      for(std::uint32_t z = place[2] - 1; z != place[2] + 2; ++z)
        if(visit(Octree_place{{x, y, z}}))
          return true;
  return false;
}

/// Returns the cell at a place; a null pointer if it is not there. O(log n).
/// \param cells of one level, with their Morton codes as `code`, ascending
template <typename Cell>
const Cell* cell_at(const std::vector<Cell>& cells, const Octree_place& place)
{
  const std::uint64_t code = morton_code(place);
  const auto found =
    std::lower_bound(cells.begin(), cells.end(), code,
                     [](const Cell& cell, std::uint64_t sought) { return cell.code < sought; });
  return found != cells.end() && found->code == code ? &*found : nullptr;
}

/// The cells of an octree. Level 0 is the finest.
class Octree_grid
{
public:
  /// An octree around the means of some Gaussians; its finest cells are those of the cubic grid
  /// through the origin. \pre `has_octree(cell_size)`, and there is a Gaussian
  Octree_grid(const Gaussians& gaussians, double cell_size) : cell_size_(cell_size)
  {
    origin_ = gaussians.front().mean;
    for(const Gaussian& g : gaussians)
      origin_ = origin_.cwiseMin(g.mean);
    origin_ = cell_size_ * ((origin_ / cell_size_).array().floor() - 1);
  }

  /// Edge length of the cells of a level.
  double cell_size(int level) const { return std::ldexp(cell_size_, level); }

  /// The finest cell that contains `p`.
  Octree_place place_of(const Vector3& p) const
  {
    Octree_place result;
    for(std::size_t axis = 0; axis < 3; ++axis)
      result[axis] = static_cast<std::uint32_t>((p - origin_)[static_cast<Eigen::Index>(axis)] /
                                                cell_size_);
    return result;
  }

  Vector3 center(const Octree_place& place, int level) const
  {
    return origin_ +
           cell_size(level) * (Vector3(place[0], place[1], place[2]) + Vector3::Constant(0.5));
  }

  /// The Morton codes of the finest cells of Gaussians, ascending, and the indices of these.
  /// O(n log n).
  std::vector<std::pair<std::uint64_t, std::size_t>> order(const Gaussians& gaussians) const
  {
    std::vector<std::pair<std::uint64_t, std::size_t>> result;
    result.reserve(gaussians.size());
    for(std::size_t i = 0; i < gaussians.size(); ++i)
      result.emplace_back(morton_code(place_of(gaussians[i].mean)), i);
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  Vector3 origin_;
  double cell_size_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_OCTREE_H
