// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_BULK_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_BULK_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Normalization.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Points in the finest cubic grid of which they occupy at most 4096 cells: with the number and the
/// bounding box of the points of each cell. The widths of cells are powers of two in the
/// coordinates of the input, from the least to the greatest number, so that neither the box of the
/// points nor their order matters: cells are as fine as the bulk of the points allows, however far
/// away others are.
class Bulk_cells
{
public:
  struct Cell
  {
    std::size_t size = 0;
    Box box;
  };

  /// The lower corner of a cell.
  using Corner = std::array<double, 3>;

  /// Adds a point. \pre it is finite
  void add(const Vector3& p)
  {
    const Corner corner = corner_of(p);
    if(cells_.empty() || corner != corners_[last_]) // often the cell of the point before
      last_ = number_of(corner);
    ++cells_[last_].size;
    cells_[last_].box.add(p);
    limit();
  }

  /// Adds the points of others.
  void add(const Bulk_cells& others)
  {
    coarsen_to(std::max(level_, others.level_));
    for(std::size_t i = 0; i < others.cells_.size(); ++i) {
      add(others.cells_[i], grid_.corner_of(others.corners_[i]));
      limit();
    }
  }

  const std::vector<Cell>& cells() const { return cells_; }

  /// Makes the cells as wide as 2^`level`, if they are not.
  void coarsen_to(int level)
  {
    if(level <= level_)
      return;
    level_ = (std::min)(level, coarsest_level);
    grid_ = Grid(level_);
    last_ = 0;
    const Corners corners = std::exchange(corners_, Corners());
    const std::vector<Cell> cells = std::exchange(cells_, {});
    for(std::size_t i = 0; i < cells.size(); ++i)
      add(cells[i], grid_.corner_of(corners[i]));
  }

  /// Calls `visit(j)` for each cell that touches the `i`-th one, and for itself.
  template <typename Visit>
  void visit_neighbors(std::size_t i, const Visit& visit) const
  {
    for(int x = -1; x <= 1; ++x)
      for(int y = -1; y <= 1; ++y)
        for(int z = -1; z <= 1; ++z) {
          const Corner& corner = corners_[i];
          const std::size_t cell =
              corners_.find({{corner[0] + x * grid_.width, corner[1] + y * grid_.width,
                              corner[2] + z * grid_.width}});
          if(cell < cells_.size())
            visit(cell);
        }
  }

  /// Writes or reads them, for archives as those of Boost.Serialization.
  template <typename Archive>
  void serialize(Archive& archive, unsigned int)
  {
    std::int32_t level = level_;
    std::uint64_t number = cells_.size();
    archive & level & number;
    if constexpr(Archive::is_loading::value) {
      *this = Bulk_cells();
      coarsen_to(level);
      for(; number > 0; --number) {
        Cell cell;
        archive & cell.size & cell.box;
        const Vector3& inside = cell.box.lower();
        add(cell, corner_of(inside));
      }
    } else
      for(Cell& cell : cells_)
        archive & cell.size & cell.box;
  }

private:
  static constexpr std::size_t most_cells = 1 << 12;
  static constexpr int finest_level = -1022, coarsest_level = 1023; ///< Logarithms of widths.

  struct Hash
  {
    std::size_t operator()(const Corner& corner) const
    {
      std::uint64_t hash = 0;
      for(double x : corner) {
        x += 0.0; // -0 is 0
        std::uint64_t bits;
        std::memcpy(&bits, &x, sizeof(bits));
        hash = (hash ^ bits) * 0x9E3779B97F4A7C15u; // Fibonacci hashing
        hash ^= hash >> 32;
      }
      return static_cast<std::size_t>(hash);
    }
  };

  /// Maps coordinates to the grid of a level.
  struct Grid
  {
    explicit Grid(int level)
        : width(std::ldexp(1, level))
        , inverse(std::ldexp(1, -level))
        , multiples(std::ldexp(1, (std::min)(level + 53, 1023)))
    {}

    double corner_of(double x) const
    {
      // Rounds a number of less than 52 bits; std::floor() would be a function call.
      constexpr double half_bits = 0x1p51, to_integer = 0x1.8p52;
      const double scaled = x * inverse;
      if(std::abs(scaled) < half_bits) {
        const double rounded = (scaled + to_integer) - to_integer;
        return (rounded - static_cast<double>(rounded > scaled)) * width; // without a branch
      }
      return std::abs(x) < multiples ? std::floor(scaled) * width : x;
    }

    Corner corner_of(const Corner& p) const
    {
      return {{corner_of(p[0]), corner_of(p[1]), corner_of(p[2])}};
    }

    double width, inverse;
    double multiples; ///< All greater numbers are multiples of the width.
  };

  Corner corner_of(const Vector3& p) const { return grid_.corner_of(Corner{{p[0], p[1], p[2]}}); }

  /// Corners in the order in which they were inserted, with a table of their numbers.
  class Corners
  {
  public:
    std::size_t size() const { return corners_.size(); }
    const Corner& operator[](std::size_t i) const { return corners_[i]; }

    /// The number of a corner, which is inserted if it is new.
    std::size_t inserted(const Corner& corner)
    {
      std::uint32_t& slot = slots_[slot_of(corner)];
      if(slot == 0) {
        corners_.push_back(corner);
        slot = static_cast<std::uint32_t>(corners_.size());
      }
      return slot - 1;
    }

    /// The number of a corner; `size()` if it is not there.
    std::size_t find(const Corner& corner) const
    {
      const std::uint32_t slot = slots_[slot_of(corner)];
      return slot == 0 ? size() : slot - 1;
    }

  private:
    static constexpr std::size_t number_of_slots = 4 * most_cells;

    /// The slot of a corner, or the free slot where it would be: at most a quarter of them is
    /// taken.
    std::size_t slot_of(const Corner& corner) const
    {
      std::size_t slot = Hash()(corner) % number_of_slots;
      while(slots_[slot] != 0 && corners_[slots_[slot] - 1] != corner)
        slot = (slot + 1) % number_of_slots;
      return slot;
    }

    std::vector<Corner> corners_;
    std::vector<std::uint32_t> slots_ = std::vector<std::uint32_t>(number_of_slots, 0); ///< From 1.
  };

  /// The cell with this corner, which is added if it is new.
  std::size_t number_of(const Corner& corner)
  {
    const std::size_t number = corners_.inserted(corner);
    if(number == cells_.size())
      cells_.emplace_back();
    return number;
  }

  void add(const Cell& cell, const Corner& corner)
  {
    Cell& sum = cells_[number_of(corner)];
    sum.size += cell.size;
    sum.box.add(cell.box);
  }

  bool are_few_at(int level) const
  {
    const Grid grid(level);
    Corners coarse;
    for(std::size_t i = 0; i < corners_.size(); ++i)
      if(coarse.inserted(grid.corner_of(corners_[i])) == most_cells)
        return false;
    return true;
  }

  /// Coarsens until there are few enough: grids of powers of two are nested, so by a binary
  /// search.
  void limit()
  {
    if(cells_.size() <= most_cells)
      return;
    // At first nothing is known of the width; later a slightly greater one will do.
    int many = level_, few = level_ == finest_level ? coarsest_level : many + 1;
    while(few < coarsest_level && !are_few_at(few)) {
      const int step = few - many;
      many = few;
      few = (std::min)(few + 2 * step, coarsest_level);
    }
    while(few - many > 1) {
      const int middle = many + (few - many) / 2;
      (are_few_at(middle) ? few : many) = middle;
    }
    coarsen_to(few);
  }

  int level_ = finest_level;
  Grid grid_{finest_level};
  Corners corners_;
  std::vector<Cell> cells_; ///< In the order of the corners.
  std::size_t last_ = 0;    ///< The cell that a point was added to last.
};

/// Finds the bulk of a cloud: all points but at most a thousandth of them that are farther away
/// from the rest than the rest is large. Those are no part of the shape, as the gap is as wide as
/// it, and too few to be another one; but in its bounding box the shape would be small.
///
/// Points are added in passes over the cloud, nearly always one.
class Bulk
{
public:
  /// Adds the `i`-th point.
  void add(std::size_t i, const Vector3& p)
  {
    if(!p.allFinite())
      not_finite_ = (std::min)(not_finite_, i);
    else if(contains(p))
      cells_.add(p);
  }

  /// Adds the points of another part of the same pass.
  void add(const Bulk& other)
  {
    not_finite_ = (std::min)(not_finite_, other.not_finite_);
    cells_.add(other.cells_);
  }

  /// Ends a pass.
  /// \returns whether the bulk is found; if not, all points are to be added once more: some of them
  ///          are far, and the cells were made for all
  /// \throws std::invalid_argument that names the first point with a coordinate that is not finite
  bool end_pass()
  {
    check_finite(not_finite_);
    std::size_t size = 0;
    for(const Bulk_cells::Cell& cell : cells_.cells())
      size += cell.size;
    size_ = (std::max)(size_, size);
    number_of_far_ = size_ - size;
    const auto [bulk, is_all] = bulk_of(cells_, size_ / 1000 - number_of_far_);
    box_ = bulk;
    cells_ = Bulk_cells();
    return is_all;
  }

  /// The bounding box of the bulk. \pre the last pass has ended
  const Box& box() const { return box_; }

  /// Number of points outside of it. \pre the last pass has ended
  std::size_t number_of_far() const { return number_of_far_; }

  /// Writes or reads what is known, for archives as those of Boost.Serialization.
  template <typename Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive & not_finite_ & cells_ & box_ & size_ & number_of_far_;
  }

private:
  /// A box, and whether it contains all cells.
  struct Bulk_box
  {
    Box box;
    bool is_all;
  };

  bool contains(const Vector3& p) const { return size_ == 0 || box_.contains(p); }

  /// Distances are halved, as those between the least and the greatest number are no numbers.
  static double half_distance(const Vector3& p, const Vector3& q)
  {
    return (p / 2 - q / 2).cwiseAbs().maxCoeff();
  }

  static double farthest(const Box& box, const Vector3& p)
  {
    return (std::max)(half_distance(box.lower(), p), half_distance(box.upper(), p));
  }

  static double nearest(const Box& box, const Vector3& p)
  {
    return half_distance(p.cwiseMax(box.lower()).cwiseMin(box.upper()), p);
  }

  /// The median of the points along each axis, as far as cells tell.
  static Vector3 median(const std::vector<Bulk_cells::Cell>& cells)
  {
    Vector3 result = Vector3::Zero();
    std::vector<std::pair<double, std::size_t>> places;
    for(int axis = 0; axis < 3; ++axis) {
      places.clear();
      std::size_t size = 0;
      for(const Bulk_cells::Cell& cell : cells) {
        places.emplace_back(cell.box.lower()[axis] / 2 + cell.box.upper()[axis] / 2, cell.size);
        size += cell.size;
      }
      std::sort(places.begin(), places.end());
      std::size_t below = 0;
      for(const auto& [place, count] : places) {
        result[axis] = place;
        below += count;
        if(2 * below >= size)
          break;
      }
    }
    return result;
  }

  /// The distance from `centre` within which all points are but `most` of them.
  static double radius(const std::vector<Bulk_cells::Cell>& cells, const Vector3& centre,
                       std::size_t most)
  {
    std::vector<std::pair<double, std::size_t>> distances;
    for(const Bulk_cells::Cell& cell : cells)
      distances.emplace_back(farthest(cell.box, centre), cell.size);
    std::sort(distances.rbegin(), distances.rend());
    std::size_t beyond = 0;
    for(const auto& [distance, count] : distances)
      if((beyond += count) > most)
        return distance;
    return 0;
  }

  /// All but at most `most` points that are farther from the centre than twice the shape.
  static Bulk_box bulk_of(const Bulk_cells& cells, std::size_t most)
  {
    Box all;
    for(const Bulk_cells::Cell& cell : cells.cells())
      all.add(cell.box);
    if(cells.cells().empty() || most == 0)
      return {all, true};
    const Vector3 centre = median(cells.cells());
    const double bulk = radius(cells.cells(), centre, most);
    if(farthest(all, centre) <= 2 * bulk)
      return {all, true};

    // A mast may have few points, and is longer than all the rest: the shape goes on as long as
    // occupied cells touch whose width is an eighth of the radius, at most.
    Bulk_cells wide = cells;
    if(bulk > 0)
      wide.coarsen_to(std::ilogb(bulk) - 2);
    std::vector<std::size_t> reached;
    std::vector<char> is_reached(wide.cells().size(), 0);
    const auto reach = [&](std::size_t i) {
      if(!std::exchange(is_reached[i], char(1)))
        reached.push_back(i);
    };
    for(std::size_t i = 0; i < wide.cells().size(); ++i)
      if(nearest(wide.cells()[i].box, centre) <= bulk)
        reach(i);
    double shape = 0;
    for(std::size_t k = 0; k < reached.size(); ++k) {
      shape = (std::max)(shape, farthest(wide.cells()[reached[k]].box, centre));
      wide.visit_neighbors(reached[k], reach);
    }

    Bulk_box result{Box(), true};
    for(const Bulk_cells::Cell& cell : wide.cells())
      if(nearest(cell.box, centre) <= 2 * shape)
        result.box.add(cell.box);
      else
        result.is_all = false;
    return result;
  }

  std::size_t not_finite_ = none_not_finite;
  Bulk_cells cells_;     ///< Of the points of the pass that are in the box.
  Box box_;              ///< As known from the passes before.
  std::size_t size_ = 0; ///< Number of points of the cloud; 0 in the first pass.
  std::size_t number_of_far_ = 0;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_BULK_H
