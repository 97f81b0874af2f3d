// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_SEPARATE_PARTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_SEPARATE_PARTS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cell_map.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cell_set.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cubic_grid.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Grid_mixture.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Moment_grid.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The part of each cell: cells that touch, also at a corner, are in one part. The number of a part
/// is the least place of its cells. O(cells). \pre the cells are distinct
inline std::vector<std::size_t> touching_parts(const std::vector<std::uint64_t>& cells)
{
  Cell_map<std::uint32_t> place_of(cells.size()); // from 1; 0 for a cell that is not there
  for(std::size_t i = 0; i < cells.size(); ++i)
    place_of[cells[i]] = static_cast<std::uint32_t>(i + 1);
  Union_find parts(cells.size());
  for(std::size_t i = 0; i < cells.size(); ++i) {
    const Grid_cell cell = unpacked(cells[i]);
    for(std::int32_t k = 14; k < 27; ++k) { // one of each pair of opposite neighbours
      const std::uint64_t neighbor =
          packed({{cell[0] + k / 9 - 1, cell[1] + k / 3 % 3 - 1, cell[2] + k % 3 - 1}});
      if(const std::uint32_t* place = place_of.find(neighbor))
        parts.join(i, *place - 1);
    }
  }
  std::vector<std::size_t> result(cells.size());
  for(std::size_t i = 0; i < cells.size(); ++i)
    result[i] = parts.find(i);
  return result;
}

/// Divides a cloud into parts with a gap between them that is wider than `gap` cells of its
/// mixture. Those with less than `stray_share` of the points of the largest one are left out, as
/// strays. The largest comes first. O(cells log cells).
inline std::vector<Moment_grid> separate_parts(const Moment_grid& points, std::int32_t gap,
                                               double stray_share)
{
  if(points.cells().size() == 0)
    return {};
  Grid_options options = Grid_options::of_fine_cells(points.maximum_cells());
  // Cells as for the skeleton of a small cloud would be narrower than the distance of its points,
  // and each a part.
  options.minimum_cells = 8;
  std::vector<std::uint64_t> fine = points.cells().cells();
  std::sort(fine.begin(), fine.end()); // nothing depends on the order in which they came
  const Cubic_grid wide = patch_level(fine, points.grid(), options.cells(points.size()),
                                      Concurrency::sequential)
                              .grid.coarsened(gap);
  const Cell_around around = wide.around(points.grid());
  std::vector<std::uint64_t> cells =
      cells_around(fine, around, fine.size(), Concurrency::sequential).cells();
  std::sort(cells.begin(), cells.end());
  const std::vector<std::size_t> part_of = touching_parts(cells);
  Cell_map<std::uint32_t> place_of(cells.size());
  for(std::size_t i = 0; i < cells.size(); ++i)
    place_of[cells[i]] = static_cast<std::uint32_t>(i);

  std::vector<std::vector<std::uint64_t>> members(cells.size()); // of the part with this number
  std::vector<std::size_t> size(cells.size(), 0);
  for(const std::uint64_t cell : fine) {
    const std::size_t part = part_of[place_of.at(packed(around(unpacked(cell))))];
    members[part].push_back(cell);
    size[part] += points.cells().of(cell).number();
  }
  std::vector<std::size_t> order;
  const std::size_t largest = *std::max_element(size.begin(), size.end());
  for(std::size_t part = 0; part < size.size(); ++part)
    if(size[part] > 0 &&
       static_cast<double>(size[part]) >= stray_share * static_cast<double>(largest))
      order.push_back(part);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return size[a] > size[b]; });
  std::vector<Moment_grid> result;
  for(const std::size_t part : order)
    result.push_back(points.restricted_to(members[part]));
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_SEPARATE_PARTS_H
