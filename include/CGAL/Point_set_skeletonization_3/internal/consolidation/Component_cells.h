// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_COMPONENT_CELLS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_COMPONENT_CELLS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Octree.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Components in a cell of an octree.
struct Component_cell
{
  std::uint64_t code = 0; ///< Without the bits of finer levels.
  Octree_place place{};
  std::size_t begin = 0, end = 0; ///< Components, in Morton order.

  double size() const { return static_cast<double>(end - begin); }
};

using Component_cells = std::vector<Component_cell>;

/// The cells of an octree that contain components, level by level.
class Component_octree
{
public:
  /// Refers to the components. `cell_size` is the edge length of the finest cells. O(n log n).
  /// \pre there is a component, and `has_octree(cell_size)`
  Component_octree(const Gaussians& components, double cell_size)
    : components_(components), grid_(components, cell_size), order_(grid_.order(components))
  {}

  double cell_size(int level) const { return grid_.cell_size(level); }

  /// The component that is the `k`-th in Morton order.
  std::size_t component(std::size_t k) const { return order_[k].second; }

  /// The Morton code of the cell of a level that contains a component.
  std::uint64_t code_of(std::size_t component, int level) const
  {
    return morton_code(grid_.place_of(components_[component].mean)) >> 3 * level;
  }

  /// The occupied cells of a level, in Morton order. O(n).
  Component_cells cells(int level) const
  {
    Component_cells result;
    for(std::size_t k = 0; k < order_.size(); ++k) {
      const auto [code, i] = order_[k];
      if(result.empty() || result.back().code != code >> 3 * level) {
        Octree_place place = grid_.place_of(components_[i].mean);
        for(std::uint32_t& coordinate : place)
          coordinate >>= level;
        result.push_back({code >> 3 * level, place, k, k});
      }
      result.back().end = k + 1;
    }
    return result;
  }

private:
  const Gaussians& components_;
  Octree_grid grid_;
  std::vector<std::pair<std::uint64_t, std::size_t>> order_; ///< Codes, and components.
};

/// Calls `visit(d)` for the other occupied cells among the 26 neighbours of a cell.
template <typename Visit>
void visit_around(const Component_cells& cells, std::size_t c, const Visit& visit)
{
  visit_block(cells[c].place, [&](const Octree_place& place) {
    const Component_cell* cell = cell_at(cells, place);
    if(cell != nullptr && cell != &cells[c])
      visit(static_cast<std::size_t>(cell - cells.data()));
    return false;
  });
}

/// Whether one of the cells around a cell is marked.
inline bool any_around(const Component_cells& cells, std::size_t c,
                       const std::vector<char>& is_marked)
{
  bool result = false;
  visit_around(cells, c, [&](std::size_t d) { result = result || is_marked[d]; });
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_COMPONENT_CELLS_H
