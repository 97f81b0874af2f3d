// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_CROSSING_ROWS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_CROSSING_ROWS_H

#include <CGAL/Point_set_skeletonization_3/internal/consolidation/Component_cells.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Finds the levels of an octree at which the rows of several scans that cross on a sheet, such as
/// a leaf, fill it.
///
/// Where rows cross none has another alongside, see `Parallel_rows`; but the occupied cells of the
/// octree tell rows and twigs apart (box counting): cells narrower than the distance of the rows
/// contain a line, and wider ones fill a plane, in which each is surrounded by others. Cells of
/// twigs do so by chance only, which is why the cells around must be surrounded too.
class Crossing_rows
{
public:
  /// Rows that cross are hardly further apart than four finest cells; in nets of wires, which
  /// would look the same in wider cells, wires are.
  static constexpr int most_levels = 2;

  /// Refers to the first three arguments. `flatness`: greatest variance across a cell of one sheet,
  /// relative to that of a cell filled with points. O(n).
  Crossing_rows(const Gaussians& components, const K_nearest_neighbors& nearest,
                const Component_octree& octree, double flatness, Concurrency concurrency)
    : components_(components), nearest_(nearest), octree_(octree), flatness_(flatness),
      concurrency_(concurrency), roundness_(roundness_around())
  {}

  /// The level of the cells that each component is merged in; 0: it is in no row. O(n log n).
  std::vector<int> levels() const
  {
    std::vector<int> inside(roundness_.size(), 0), border(roundness_.size(), 0);
    if(std::none_of(roundness_.begin(), roundness_.end(), is_long))
      return inside;
    for(int level = 1; level <= most_levels; ++level) {
      const Component_cells cells = octree_.cells(level);
      const std::vector<char> is_row = row_cells(cells, level);
      const std::vector<char> is_core = core_cells(cells, is_row, level);
      for(std::size_t c = 0; c < cells.size(); ++c) {
        const bool is_near_core = is_row[c] && any_around(cells, c, is_core);
        for(std::size_t k = cells[c].begin; k < cells[c].end; ++k) {
          const std::size_t i = octree_.component(k);
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
    return inside;
  }

private:
  /// Average ratio of variances, the middle to the largest, of the ten neighbours of a component:
  /// it is 0.62 on a plane that is sampled evenly, and so small for less than one in a thousand.
  static bool is_long(double roundness) { return roundness < 0.45; }

  std::vector<double> roundness_around() const
  {
    std::vector<double> single(nearest_.size(), 1), result(nearest_.size(), 1);
    parallel_for(concurrency_, single.size(), [&](std::size_t i) {
      Moments moments;
      for(const Neighbor& neighbor : nearest_[i])
        moments.add(1, components_[neighbor.index].mean - components_[i].mean);
      const Vector3 variances =
        principal_axes(moments.gaussian(Vector3::Zero()).covariance).variances;
      if(variances[2] > 0)
        single[i] = variances[1] / variances[2];
    });
    parallel_for(concurrency_, result.size(), [&](std::size_t i) {
      double sum = 0;
      for(const Neighbor& neighbor : nearest_[i])
        sum += single[neighbor.index];
      result[i] = sum / static_cast<double>(nearest_[i].size());
    });
    return result;
  }

  Vector3 mean_of(const Component_cell& cell) const
  {
    Vector3 sum = Vector3::Zero();
    for(std::size_t k = cell.begin; k < cell.end; ++k)
      sum += components_[octree_.component(k)].mean;
    return sum / cell.size();
  }

  double roundness_in(const Component_cell& cell) const
  {
    double sum = 0;
    for(std::size_t k = cell.begin; k < cell.end; ++k)
      sum += roundness_[octree_.component(k)];
    return sum / cell.size();
  }

  /// Which cells, with those around, have components as a line has: neighbourhoods are long, and
  /// the number of components grows with the width of the cells more as that of a line, to the
  /// power of 1, than as that of a sheet, of 2, or of single points, of 0.
  std::vector<char> row_cells(const Component_cells& cells, int level) const
  {
    const double least = std::pow(2, 0.5 * level), most = std::pow(2, 1.5 * level); // of a cell
    std::vector<char> result(cells.size(), false);
    parallel_for(concurrency_, cells.size(), [&](std::size_t c) {
      if(!is_long(roundness_in(cells[c])))
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
  std::vector<char> core_cells(const Component_cells& cells, const std::vector<char>& is_row,
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
  bool is_surrounded(const Component_cells& cells, std::size_t c, int level) const
  {
    const Vector3 middle = mean_of(cells[c]);
    std::vector<Vector3> offsets;
    Moments moments;
    moments.add(1, Vector3::Zero());
    visit_around(cells, c, [&](std::size_t d) {
      offsets.push_back(mean_of(cells[d]) - middle);
      moments.add(1, offsets.back());
    });
    const auto [variances, directions] =
      principal_axes(moments.gaussian(Vector3::Zero()).covariance);
    const double width = 3 * octree_.cell_size(level);
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

  const Gaussians& components_;
  const K_nearest_neighbors& nearest_;
  const Component_octree& octree_;
  double flatness_;
  Concurrency concurrency_;
  std::vector<double> roundness_; ///< Of each component and its neighbours, on average.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_CROSSING_ROWS_H
