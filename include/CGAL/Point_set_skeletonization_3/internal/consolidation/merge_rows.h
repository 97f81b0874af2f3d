// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_MERGE_ROWS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_MERGE_ROWS_H

#include <CGAL/Point_set_skeletonization_3/internal/consolidation/consolidate.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Octree.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Finds the rows of a sheet, and the level of the octree whose cells are as wide as the distance
/// of the rows.
///
/// Scanners with a few beams, and all that see a surface at a grazing angle, leave rows of points,
/// which are closer to each other than to the next row. The nearest neighbours of a component are
/// then in its own row, as they are in a twig. The occupied cells of the octree tell rows and twigs
/// apart (box counting): cells narrower than the distance of the rows contain a line, and wider
/// ones fill a plane, in which each is surrounded by others. Cells of twigs do so by chance only,
/// which is why the cells around must be surrounded too.
class Row_levels
{
public:
  /// Refers to the mixture. `flatness`: greatest variance across a cell of one sheet, relative to
  /// that of a cell filled with points. O(n log n). \pre the mixture has cells of an octree
  Row_levels(const Consolidated_mixture& mixture, double flatness, Concurrency concurrency)
    : mixture_(mixture), grid_(mixture.components, mixture.cell_size), flatness_(flatness),
      concurrency_(concurrency), roundness_(roundness_around())
  {}

  /// The level of the cells that each component is merged in; 0: it is in no row. O(n) a level.
  std::vector<int> run()
  {
    std::vector<int> inside(roundness_.size(), 0), border(roundness_.size(), 0);
    if(std::none_of(roundness_.begin(), roundness_.end(), is_long))
      return inside;
    order_ = grid_.order(mixture_.components);
    for(int level = 1; level < octree_bits; ++level) {
      const std::vector<Cell> cells = cells_of(level);
      const std::vector<char> is_row = row_cells(cells, level);
      if(std::find(is_row.begin(), is_row.end(), true) == is_row.end())
        break;
      const std::vector<char> is_core = core_cells(cells, is_row, level);
      for(std::size_t c = 0; c < cells.size(); ++c) {
        const bool is_near_core = is_row[c] && any_around(cells, c, is_core);
        for(std::size_t k = cells[c].begin; k < cells[c].end; ++k) {
          const std::size_t i = order_[k].second;
          if(inside[i] == 0 && is_core[c])
            inside[i] = level;
          if(border[i] == 0 && is_near_core)
            border[i] = level;
        }
      }
    }
    for(std::size_t i = 0; i < inside.size(); ++i)
      if(inside[i] == 0)
        inside[i] = border[i];
    balance(inside);
    return inside;
  }

private:
  struct Cell
  {
    std::uint64_t code = 0; ///< Without the bits of finer levels.
    Octree_place place{};
    std::size_t begin = 0, end = 0;  ///< Components, in Morton order.
    Vector3 mean = Vector3::Zero();  ///< Of its components.
    double roundness = 0;            ///< Their average.

    double size() const { return static_cast<double>(end - begin); }
  };

  /// Average ratio of variances, the middle to the largest, of the ten neighbours of a component:
  /// it is 0.62 on a plane that is sampled evenly, and so small for less than one in a thousand.
  static bool is_long(double roundness) { return roundness < 0.45; }

  std::vector<double> roundness_around() const
  {
    const K_nearest_neighbors& nearest = mixture_.neighbors;
    std::vector<double> single(nearest.size(), 1), result(nearest.size(), 1);
    parallel_for(concurrency_, single.size(), [&](std::size_t i) {
      Moments moments;
      for(const Neighbor& neighbor : nearest[i])
        moments.add(1, mixture_.components[neighbor.index].mean - mixture_.components[i].mean);
      const Vector3 variances =
        principal_axes(moments.gaussian(Vector3::Zero()).covariance).variances;
      if(variances[2] > 0)
        single[i] = variances[1] / variances[2];
    });
    parallel_for(concurrency_, result.size(), [&](std::size_t i) {
      double sum = 0;
      for(const Neighbor& neighbor : nearest[i])
        sum += single[neighbor.index];
      result[i] = sum / static_cast<double>(nearest[i].size());
    });
    return result;
  }

  std::vector<Cell> cells_of(int level) const
  {
    std::vector<Cell> cells;
    for(std::size_t k = 0; k < order_.size(); ++k) {
      const auto [code, i] = order_[k];
      if(cells.empty() || cells.back().code != code >> 3 * level) {
        cells.emplace_back();
        cells.back().code = code >> 3 * level;
        cells.back().place = grid_.place_of(mixture_.components[i].mean);
        for(std::uint32_t& coordinate : cells.back().place)
          coordinate >>= level;
        cells.back().begin = k;
      }
      cells.back().end = k + 1;
      cells.back().mean += mixture_.components[i].mean;
      cells.back().roundness += roundness_[i];
    }
    for(Cell& cell : cells) {
      cell.mean /= cell.size();
      cell.roundness /= cell.size();
    }
    return cells;
  }

  /// Calls `visit(d)` for the other occupied cells among the 26 neighbours of a cell.
  template <typename Visit>
  static void visit_around(const std::vector<Cell>& cells, std::size_t c, const Visit& visit)
  {
    visit_block(cells[c].place, [&](const Octree_place& place) {
      const Cell* cell = cell_at(cells, place);
      if(cell != nullptr && cell != &cells[c])
        visit(static_cast<std::size_t>(cell - cells.data()));
      return false;
    });
  }

  static bool any_around(const std::vector<Cell>& cells, std::size_t c,
                         const std::vector<char>& is_marked)
  {
    bool result = false;
    visit_around(cells, c, [&](std::size_t d) { result = result || is_marked[d]; });
    return result;
  }

  /// Raises levels until those of components in neighbouring cells differ by one at most: patches
  /// that are much smaller than their neighbours are not adjacent to them.
  void balance(std::vector<int>& level_of) const
  {
    for(int level = *std::max_element(level_of.begin(), level_of.end()); level > 1; --level) {
      const std::vector<Cell> cells = cells_of(level);
      std::vector<char> is_whole(cells.size(), false);
      const auto for_components = [&](std::size_t c, const auto& visit) {
        for(std::size_t k = cells[c].begin; k < cells[c].end; ++k)
          visit(level_of[order_[k].second]);
      };
      for(std::size_t c = 0; c < cells.size(); ++c)
        for_components(c, [&](int other) { is_whole[c] = is_whole[c] || other >= level; });
      for(std::size_t c = 0; c < cells.size(); ++c)
        if(is_whole[c] || any_around(cells, c, is_whole))
          for_components(c, [&](int& own) { own = (std::max)(own, level - 1); });
    }
  }

  /// Which cells, with those around, have components as a line has: neighbourhoods are long, and
  /// the number of components grows with the width of the cells more as that of a line, to the
  /// power of 1, than as that of a sheet, of 2, or of single points, of 0.
  std::vector<char> row_cells(const std::vector<Cell>& cells, int level) const
  {
    const double least = std::pow(2, 0.5 * level), most = std::pow(2, 1.5 * level); // of a cell
    std::vector<char> result(cells.size(), false);
    parallel_for(concurrency_, cells.size(), [&](std::size_t c) {
      if(!is_long(cells[c].roundness))
        return;
      double number = 1, components = cells[c].size();
      visit_around(cells, c, [&](std::size_t d) {
        ++number;
        components += cells[d].size();
      });
      result[c] = components > least * number && components < most * number;
    });
    return result;
  }

  /// Which cells of rows are in the plane of those around, which surround them, as most of those
  /// are themselves.
  std::vector<char> core_cells(const std::vector<Cell>& cells, const std::vector<char>& is_row,
                               int level) const
  {
    constexpr int most_around = 4; // of eight in a plane
    std::vector<char> is_inside(cells.size(), false), result(cells.size(), false);
    parallel_for(concurrency_, cells.size(), [&](std::size_t c) {
      is_inside[c] = is_row[c] && is_surrounded(cells, c, level);
    });
    parallel_for(concurrency_, cells.size(), [&](std::size_t c) {
      if(!is_inside[c])
        return;
      int number = 0;
      visit_around(cells, c, [&](std::size_t d) { number += is_inside[d]; });
      result[c] = number >= most_around;
    });
    return result;
  }

  /// Whether the cells around are in a plane, in which no quarter is empty.
  bool is_surrounded(const std::vector<Cell>& cells, std::size_t c, int level) const
  {
    std::vector<Vector3> offsets;
    Moments moments;
    moments.add(1, Vector3::Zero());
    visit_around(cells, c, [&](std::size_t d) {
      offsets.push_back(cells[d].mean - cells[c].mean);
      moments.add(1, offsets.back());
    });
    const auto [variances, directions] =
      principal_axes(moments.gaussian(Vector3::Zero()).covariance);
    const double width = 3 * grid_.cell_size(level);
    if(offsets.empty() || !(variances[0] < flatness_ * width * width / 12))
      return false;
    std::vector<double> angles;
    for(const Vector3& offset : offsets)
      angles.push_back(
        std::atan2(offset.dot(directions.col(1)), offset.dot(directions.col(2))));
    std::sort(angles.begin(), angles.end());
    double gap = angles.front() + 2 * CGAL_PI - angles.back();
    for(std::size_t k = 1; k < angles.size(); ++k)
      gap = (std::max)(gap, angles[k] - angles[k - 1]);
    return gap < CGAL_PI / 2;
  }

  const Consolidated_mixture& mixture_;
  Octree_grid grid_;
  double flatness_;
  Concurrency concurrency_;
  std::vector<double> roundness_; ///< Of each component and its neighbours, on average.
  std::vector<std::pair<std::uint64_t, std::size_t>> order_; ///< Components in Morton order.
};

/// Returns a mixture in which the rows of a sheet are pieces that are about as long as the rows are
/// apart, see `Row_levels`: so neighbours are as near along the rows as across. What looked like a
/// cloud of lines were rows. Nothing changes in a cloud without rows, or if the cells are too small
/// for an octree. O(n log n).
inline Consolidated_mixture with_rows_merged(Consolidated_mixture mixture, double flatness,
                                             Concurrency concurrency)
{
  if(!has_octree(mixture.cell_size))
    return mixture;
  const Gaussians& components = mixture.components;
  const std::vector<int> level_of = Row_levels(mixture, flatness, concurrency).run();
  if(std::all_of(level_of.begin(), level_of.end(), [](int level) { return level == 0; }))
    return mixture;
  const Octree_grid grid(components, mixture.cell_size);
  const auto cell_of = [&](std::size_t i) {
    return morton_code(grid.place_of(components[i].mean)) >> 3 * level_of[i];
  };
  Union_find pieces(components.size()); // two rows, or two sheets, in one cell are not joined
  for(std::size_t i = 0; i < components.size(); ++i)
    if(level_of[i] > 0)
      for(const Neighbor& neighbor : mixture.neighbors[i])
        if(level_of[neighbor.index] == level_of[i] && cell_of(neighbor.index) == cell_of(i))
          pieces.join(i, neighbor.index);
  std::vector<std::size_t> piece_of(components.size());
  std::vector<Moments> moments;
  std::vector<Vector3> first;
  for(std::size_t i = 0; i < components.size(); ++i) {
    if(pieces.find(i) == i) { // the first of a piece has the smallest number
      piece_of[i] = moments.size();
      moments.emplace_back();
      first.push_back(components[i].mean);
    }
    else
      piece_of[i] = piece_of[pieces.find(i)];
    const std::size_t piece = piece_of[i];
    moments[piece].add(components[i].weight, components[i].mean - first[piece]);
  }
  Consolidated_mixture result;
  for(std::size_t piece = 0; piece < moments.size(); ++piece)
    result.components.push_back(
      {moments[piece].weight(), moments[piece].gaussian(first[piece]).mean, Matrix3::Zero()});
  result.tree = Box_tree(means_of(result.components), concurrency);
  for(const std::size_t i : mixture.merged_into)
    result.merged_into.push_back(i == Consolidated_mixture::none ? i : piece_of[i]);
  result.noise = mixture.noise;
  result.cell_size = mixture.cell_size;
  result.neighbors = k_nearest_neighbors(result.tree, surface_neighbors + 1, concurrency);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_MERGE_ROWS_H
