// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_FLAT_GROUPS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_FLAT_GROUPS_H

#include <CGAL/Point_set_skeletonization_3/Medial_sample_kind.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cell_map.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Octree.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_groups.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/dimensionality_around.h>

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

/// Merges the cells of an octree, from the finest level upwards, where they are one flat patch.
///
/// Eight cells become their parent if none of them is divided, if the parent is flat, and if no
/// neighbour of the parent has divided children: so adjacent patches differ in width by a factor of
/// two at most. A round limb then has about the same number of patches around it however thick it
/// is, and the number of patches is that of the details of the shape, not of its points.
///
/// A piece of a line is no patch, however straight: narrow strips, such as wires and what a scanner
/// sees of them, are divided into pieces that are about as long as wide, and where the cloud is like
/// a line, components stay alone: of a twig there is nothing more to be seen than each of them.
class Flat_merging
{
public:
  /// See `flat_groups()`. Refers to all but the cell size. O(n log n).
  Flat_merging(const Gaussians& gaussians, const Box_tree& tree, const Patches& fine,
               double cell_size, const Surface_options& options, Concurrency concurrency)
    : gaussians_(gaussians), tree_(tree), fine_(fine), grid_(gaussians, cell_size),
      options_(options), concurrency_(concurrency), order_(grid_.order(gaussians)),
      level_of_(gaussians.size(), 0)
  {}

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

  std::vector<Cell> finest_cells() const
  {
    std::vector<Cell> cells;
    cells.reserve(order_.size()); // nearly every component has a cell of its own
    for(std::size_t k = 0; k < order_.size(); ++k) {
      const Gaussian& g = gaussians_[order_[k].second];
      if(cells.empty() || cells.back().code != order_[k].first) {
        cells.emplace_back();
        cells.back().code = order_[k].first;
        cells.back().place = grid_.place_of(g.mean);
        cells.back().begin = k;
      }
      Cell& cell = cells.back();
      cell.end = k + 1;
      cell.moments.add(g.weight, g.mean - grid_.center(cell.place, 0), g.covariance);
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
                           grid_.center(child.place, level - 1) -
                             grid_.center(parent.place, level));
    }
    Cell_map<char> incomplete; // none at the first level, where cells are many
    for(const Cell& parent : parents)
      if(!parent.is_complete)
        incomplete[parent.code] = true;
    parallel_for(concurrency_, parents.size(), [&](std::size_t i) {
      Cell& parent = parents[i];
      parent.is_whole = parent.is_complete && is_flat(parent, level) &&
                        (incomplete.size() == 0 || !touches_any(incomplete, parent.place)) &&
                        !is_line(parent, parents) && (level > 1 || !is_of_twig(parent));
    });
    return parents;
  }

  /// Whether the cloud is like a line around most components of a cell: the limb is thin, but may
  /// be a few components wide, and these are flat by chance. Nearly everywhere the first component
  /// asked is on a surface, and settles it. O(log n + components around), for the smallest cells.
  bool is_of_twig(const Cell& cell) const
  {
    const std::size_t middle = (cell.begin + cell.end) / 2;
    if(!is_on_line(middle))
      return false;
    std::size_t on_lines = 0;
    for(std::size_t k = cell.begin; k < cell.end; ++k)
      on_lines += k == middle || is_on_line(k) ? 1 : 0;
    return 2 * on_lines > cell.end - cell.begin;
  }

  /// \param k place of the component in Morton order
  bool is_on_line(std::size_t k) const
  {
    return dimensionality_around(fine_[order_[k].second], tree_).kind() ==
           Medial_sample_kind::line;
  }

  /// Whether the variance across the cell is a small share of that of a cell filled with points.
  bool is_flat(const Cell& cell, int level) const
  {
    const double size = grid_.cell_size(level);
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
      const Cell* other = cell_at(cells, place);
      if(other != nullptr && other->moments.weight() > largest->moments.weight())
        largest = other;
      return false;
    });
    return largest == &cell || is_narrow(largest->moments);
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
  const Box_tree& tree_; ///< Over the means of the Gaussians.
  const Patches& fine_;  ///< One of each Gaussian.
  Octree_grid grid_;
  const Surface_options& options_;
  Concurrency concurrency_;
  std::vector<std::pair<std::uint64_t, std::size_t>> order_; ///< Components in Morton order.
  std::vector<int> level_of_; ///< Level of the whole cell of a component, in Morton order.
};

/// Returns groups of components that are flat together, see `Flat_merging`: each one is alone if
/// `cell_size` is 0 or too small for an octree. O(n log n). \pre there is a component
/// \param tree over the means of the components
/// \param fine one patch per component, from `estimate_patches()`
/// \param cell_size edge length of the finest cells
inline Patch_groups flat_groups(const Gaussians& gaussians, const Box_tree& tree,
                                const Patches& fine, double cell_size,
                                const Surface_options& options, Concurrency concurrency)
{
  if(!has_octree(cell_size))
    return Patch_groups(gaussians.size());
  return Flat_merging(gaussians, tree, fine, cell_size, options, concurrency).run();
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_FLAT_GROUPS_H
