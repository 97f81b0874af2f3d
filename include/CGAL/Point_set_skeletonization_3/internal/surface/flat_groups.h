// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_FLAT_GROUPS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_FLAT_GROUPS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cell_map.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_groups.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface_options.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A cell of an octree, by the place of its lower corner in cells of the finest level.
using Octree_place = std::array<std::uint32_t, 3>;

/// Bits of a coordinate in a Morton code.
constexpr int octree_bits = 21;

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

/// Merges the cells of an octree, from the finest level upwards, where they are one flat patch.
///
/// Eight cells become their parent if none of them is divided, if the parent is flat, and if no
/// neighbour of the parent has divided children: so adjacent patches differ in width by a factor of
/// two at most. A round limb then has about the same number of patches around it however thick it
/// is, and the number of patches is that of the details of the shape, not of its points.
///
/// A piece of a line is no patch, however straight: lines and narrow strips, such as wires, twigs
/// and what a scanner sees of them, are divided into pieces that are about as long as wide.
class Flat_merging
{
public:
  /// `cell_size` is the edge length of the finest cells. O(n log n).
  Flat_merging(const Gaussians& gaussians, double cell_size, const Surface_options& options,
               Concurrency concurrency)
    : gaussians_(gaussians), cell_size_(cell_size), options_(options), concurrency_(concurrency),
      level_of_(gaussians.size(), 0)
  {
    origin_ = gaussians.front().mean;
    for(const Gaussian& g : gaussians)
      origin_ = origin_.cwiseMin(g.mean);
    // The corner of a cell of the grid, at any level.
    origin_ = cell_size_ * ((origin_ / cell_size_).array().floor() - 1);
    order_.reserve(gaussians.size());
    for(std::size_t i = 0; i < gaussians.size(); ++i)
      order_.emplace_back(morton_code(place_of(gaussians[i].mean)), i);
    std::sort(order_.begin(), order_.end());
  }

  Patch_groups run()
  {
    std::vector<Cell> cells = finest_cells();
    for(int level = 1; level < octree_bits; ++level) {
      cells = parents_of(cells, level);
      if(std::none_of(cells.begin(), cells.end(), [](const Cell& c) { return c.is_whole; }))
        break;
      for(const Cell& cell : cells)
        if(cell.is_whole)
          for(std::size_t k = cell.begin; k < cell.end; ++k)
            level_of_[k] = level;
    }
    return groups();
  }

private:
  struct Cell
  {
    std::uint64_t code = 0;         ///< Without the bits of finer levels.
    Octree_place place{};           ///< In cells of its level.
    std::size_t begin = 0, end = 0; ///< Components, in Morton order.
    Moments moments;                ///< About the centre.
    bool is_complete = true;        ///< No child is divided.
    bool is_whole = true;           ///< It is not divided itself.
  };

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
    return origin_ + std::ldexp(cell_size_, level) *
                       (Vector3(place[0], place[1], place[2]) + Vector3::Constant(0.5));
  }

  std::vector<Cell> finest_cells() const
  {
    std::vector<Cell> cells;
    cells.reserve(order_.size()); // nearly every component has a cell of its own
    for(std::size_t k = 0; k < order_.size(); ++k) {
      const Gaussian& g = gaussians_[order_[k].second];
      if(cells.empty() || cells.back().code != order_[k].first) {
        cells.emplace_back();
        cells.back().code = order_[k].first;
        cells.back().place = place_of(g.mean);
        cells.back().begin = k;
      }
      Cell& cell = cells.back();
      cell.end = k + 1;
      cell.moments.add(g.weight, g.mean - center(cell.place, 0), g.covariance);
    }
    return cells;
  }

  std::vector<Cell> parents_of(const std::vector<Cell>& children, int level) const
  {
    std::vector<Cell> parents;
    for(const Cell& child : children) {
      const std::uint64_t code = child.code >> 3;
      if(parents.empty() || parents.back().code != code) {
        parents.emplace_back();
        parents.back().code = code;
        for(std::size_t axis = 0; axis < 3; ++axis)
          parents.back().place[axis] = child.place[axis] >> 1;
        parents.back().begin = child.begin;
      }
      Cell& parent = parents.back();
      parent.end = child.end;
      parent.is_complete = parent.is_complete && child.is_whole;
      if(parent.is_complete)
        parent.moments.add(child.moments,
                           center(child.place, level - 1) - center(parent.place, level));
    }
    Cell_map<char> incomplete; // none at the first level, where cells are many
    for(const Cell& parent : parents)
      if(!parent.is_complete)
        incomplete[parent.code] = true;
    parallel_for(concurrency_, parents.size(), [&](std::size_t i) {
      Cell& parent = parents[i];
      parent.is_whole = parent.is_complete && is_flat(parent, level) &&
                        (incomplete.size() == 0 || !touches_any(incomplete, parent.place)) &&
                        !is_line(parent, parents);
    });
    return parents;
  }

  /// Whether the variance across the cell is a small share of that of a cell filled with points.
  bool is_flat(const Cell& cell, int level) const
  {
    const double size = std::ldexp(cell_size_, level);
    const Matrix3 covariance = cell.moments.gaussian(Vector3::Zero()).covariance;
    return principal_axes(covariance).variances[0] < options_.flatness * size * size / 12;
  }

  /// Whether some points are nearly twice as long as wide, and not by chance.
  bool is_narrow(const Moments& moments) const
  {
    const Gaussian points = moments.gaussian(Vector3::Zero());
    const Vector3 variances = principal_axes(points.covariance).variances;
    return variances[1] < (options_.narrow - anisotropy_by_chance(points.weight)) * variances[2];
  }

  /// Whether a cell is a piece of a line: it is narrow, and so is the one with most points among it
  /// and its 26 neighbours. A cell that is narrow alone may hold the rim of a surface. O(log n).
  bool is_line(const Cell& cell, const std::vector<Cell>& cells) const
  {
    if(!is_narrow(cell.moments))
      return false;
    const Cell* largest = &cell;
    visit_block(cell.place, [&](const Octree_place& place) {
      const std::uint64_t code = morton_code(place);
      const auto found = std::lower_bound(
        cells.begin(), cells.end(), code,
        [](const Cell& other, std::uint64_t sought) { return other.code < sought; });
      if(found != cells.end() && found->code == code &&
         found->moments.weight() > largest->moments.weight())
        largest = &*found;
      return false;
    });
    return largest == &cell || is_narrow(largest->moments);
  }

  /// Calls `visit(place)` for a cell and its 26 neighbours until it returns true; returns whether
  /// it did.
  template <typename Visit>
  static bool visit_block(const Octree_place& place, const Visit& visit)
  {
    for(std::uint32_t x = place[0] - 1; x != place[0] + 2; ++x)
      for(std::uint32_t y = place[1] - 1; y != place[1] + 2; ++y)
        for(std::uint32_t z = place[2] - 1; z != place[2] + 2; ++z)
          if(visit(Octree_place{{x, y, z}}))
            return true;
    return false;
  }

  /// Whether one of the 26 neighbours of a cell is in a table.
  static bool touches_any(const Cell_map<char>& codes, const Octree_place& place)
  {
    return visit_block(
      place, [&](const Octree_place& other) { return codes.find(morton_code(other)) != nullptr; });
  }

  /// The components of the largest cells that are whole.
  Patch_groups groups() const
  {
    std::vector<std::size_t> group_of(order_.size());
    std::size_t size = 0;
    for(std::size_t k = 0; k < order_.size(); ++k) {
      const int shift = 3 * level_of_[k];
      const bool is_first = k == 0 || level_of_[k] == 0 || level_of_[k - 1] != level_of_[k] ||
                            order_[k - 1].first >> shift != order_[k].first >> shift;
      size += is_first;
      group_of[order_[k].second] = size - 1;
    }
    return {std::move(group_of), size};
  }

  const Gaussians& gaussians_;
  double cell_size_;
  const Surface_options& options_;
  Concurrency concurrency_;
  Vector3 origin_;
  std::vector<std::pair<std::uint64_t, std::size_t>> order_; ///< Components in Morton order.
  std::vector<int> level_of_; ///< Level of the whole cell of a component, in Morton order.
};

/// Returns groups of components that are flat together, see `Flat_merging`: each one is alone if
/// `cell_size` is 0 or too small for an octree. O(n log n). \pre there is a component
inline Patch_groups flat_groups(const Gaussians& gaussians, double cell_size,
                                const Surface_options& options,
                                Concurrency concurrency = Concurrency::sequential)
{
  constexpr double least_cell_size = 1.0 / (1 << (octree_bits - 2)); // bounding box diagonals
  if(!(cell_size > least_cell_size))
    return Patch_groups(gaussians.size());
  return Flat_merging(gaussians, cell_size, options, concurrency).run();
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_FLAT_GROUPS_H
