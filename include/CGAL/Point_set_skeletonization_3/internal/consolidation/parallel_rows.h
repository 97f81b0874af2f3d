// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_PARALLEL_ROWS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_PARALLEL_ROWS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Finds the rows of points that a surface was sampled in, and how far they are apart.
///
/// Scanners with a few beams, slices, and all that see a surface at a grazing angle leave rows of
/// points, which are closer to each other than to the next row. The nearest neighbours of a place
/// are then in its own row, as they are in a twig. What tells them apart is that a surface has only
/// two sides across a row, and there is a row on either that runs alongside; it may be curved as
/// much as a limb with six rows around it. Twigs run along each other on one side by chance, and on
/// both seldom. From where most places around have such neighbours, rows are followed to their
/// ends, and to the last ones of a surface. If that leads to few of all lines, it was by chance.
class Parallel_rows
{
public:
  /// Refers to places, the tree over them, and their nearest neighbours, each first itself. Rows
  /// are one place after the other: those further apart than `longest_step` are no row. O(n).
  Parallel_rows(const std::vector<Vector3>& places, const Box_tree& tree,
                const K_nearest_neighbors& nearest, double longest_step, Concurrency concurrency)
    : places_(places), tree_(tree), nearest_(nearest), longest_step_(longest_step),
      concurrency_(concurrency), rows_(places.size())
  {
    parallel_for(concurrency_, rows_.size(), [&](std::size_t i) { rows_[i] = row_at(i); });
  }

  /// The share of places that are on a line, a row or a twig. By chance 1 % are on a surface that
  /// is sampled evenly, and of places at random in a plane 7 %. O(n).
  double share_on_lines() const
  {
    const auto lines =
      std::count_if(rows_.begin(), rows_.end(), [](const Row& row) { return row.is_seen; });
    return rows_.empty() ? 0 : static_cast<double>(lines) / static_cast<double>(rows_.size());
  }

  /// How far the next rows are from that of each place, on average; 0: it is in no row. O(n log n).
  std::vector<double> distances()
  {
    std::vector<double> distances(rows_.size(), 0);
    parallel_for(concurrency_, rows_.size(), [&](std::size_t i) {
      if(rows_[i].is_seen)
        distances[i] = distance_of_sides(i);
    });
    distances = followed(cores(distances));
    if(!are_more_than_chance(distances))
      std::fill(distances.begin(), distances.end(), 0);
    return distances;
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  /// What the places around one say of the row that they are in.
  struct Row
  {
    bool is_seen = false;            ///< Most steps between neighbours are along one line.
    Vector3 along = Vector3::Zero(); ///< Direction of that line.
    double step = 0;                 ///< Between neighbours, the root of the mean square.
    std::size_t beside = none;       ///< The nearest place in another row.
    std::size_t opposite = none;     ///< The nearest in the row on the other side.
  };

  /// The steps are those to the two nearest neighbours: of seven places, fewer show lines by
  /// chance, and more do not where a slice of a thin limb is round.
  Row row_at(std::size_t i) const
  {
    constexpr std::ptrdiff_t around = 7, steps = 2;
    const auto k = static_cast<std::ptrdiff_t>(nearest_.k());
    Matrix3 products = Matrix3::Zero();
    double number = 0;
    for(std::ptrdiff_t near = 0; near < (std::min)(around, k); ++near) {
      const std::size_t from = nearest_[i][near].index;
      for(std::ptrdiff_t next = 1; next <= (std::min)(steps, k - 1); ++next, ++number) {
        const Vector3 step = places_[nearest_[from][next].index] - places_[from];
        products += step * step.transpose();
      }
    }
    constexpr double along_line = 0.8; // share of the largest variance; half of it in a plane
    Row result;
    const double trace = products.trace();
    // Without eigenvalues: the norm is at least the largest of them.
    if(!(trace > 0) || products.squaredNorm() < along_line * along_line * trace * trace)
      return result;
    const auto [variances, directions] = principal_axes(products);
    result.step = std::sqrt(trace / number);
    result.is_seen = variances[2] > along_line * trace && result.step <= longest_step_;
    result.along = directions.col(2);
    return result;
  }

  /// The direction from a place to another, across the row of the former.
  Vector3 across(std::size_t from, std::size_t to) const
  {
    const Vector3 offset = places_[to] - places_[from];
    return (offset - offset.dot(rows_[from].along) * rows_[from].along).normalized();
  }

  /// Rows begin where three run along each other closely, and are followed where they still do.
  static constexpr double closely = 0.94, still = 0.87; // cosines of 20 and 30 degrees

  bool are_parallel(std::size_t i, std::size_t j, double least_cosine) const
  {
    return rows_[i].is_seen && rows_[j].is_seen &&
           std::abs(rows_[i].along.dot(rows_[j].along)) >= least_cosine;
  }

  /// The mean distance to the nearest places in the rows on both sides of a place; 0 if there are
  /// no such rows. Sets these places.
  double distance_of_sides(std::size_t i)
  {
    constexpr double farthest = 16; // steps; wires in nets and harps are further apart
    constexpr double opposite = -0.5; // cosine of 120 degrees: six rows are around a limb
    std::vector<std::pair<double, std::size_t>> beside; // and their distances
    for(double steps = 2; steps <= farthest; steps *= 2) {
      beside = places_beside(i, steps * rows_[i].step);
      if(beside.empty())
        continue;
      const auto [first, near] = beside.front();
      rows_[i].beside = near;
      const Vector3 side = across(i, near);
      const auto other = std::find_if(beside.begin(), beside.end(), [&](const auto& place) {
        return side.dot(across(i, place.second)) < opposite;
      });
      if(other == beside.end())
        continue;
      const auto [second, far] = *other;
      rows_[i].opposite = far;
      return second <= 2 * first && are_parallel(i, near, closely) &&
                 are_parallel(i, far, closely)
               ? (first + second) / 2
               : 0;
    }
    return 0;
  }

  /// The places within a distance that are across the row of one rather than along it, and further
  /// than those of one row may scatter: distances, ascending, and indices.
  std::vector<std::pair<double, std::size_t>> places_beside(std::size_t i, double reach) const
  {
    constexpr double least = 1.5; // steps
    std::vector<std::pair<double, std::size_t>> result;
    tree_.visit_within(places_[i], reach, [&](std::size_t k, double squared_distance) {
      const double along = rows_[i].along.dot(tree_.positions()[k] - places_[i]);
      const double squared_across = squared_distance - along * along;
      if(squared_across > along * along &&
         squared_across > least * least * rows_[i].step * rows_[i].step)
        result.emplace_back(std::sqrt(squared_distance), tree_.order()[k]);
    });
    std::sort(result.begin(), result.end());
    return result;
  }

  /// The distances of those between rows, as most around them and one beside them; of others 0.
  /// Three turns of a coil are no rows.
  std::vector<double> cores(const std::vector<double>& distances) const
  {
    std::vector<double> result(distances.size(), 0);
    for(std::size_t i = 0; i < result.size(); ++i) {
      std::size_t number = 0;
      for(const Neighbor& near : nearest_[i])
        number += distances[near.index] > 0;
      const auto is_between = [&](std::size_t j) { return j != none && distances[j] > 0; };
      if(distances[i] > 0 && 2 * number > nearest_.k() &&
         (is_between(rows_[i].beside) || is_between(rows_[i].opposite)))
        result[i] = distances[i];
    }
    return result;
  }

  /// Gives distances to others in the same rows, and in those beside. O(n log n).
  std::vector<double> followed(std::vector<double> distances) const
  {
    std::vector<std::size_t> reached;
    for(std::size_t i = 0; i < distances.size(); ++i)
      if(distances[i] > 0)
        reached.push_back(i);
    if(reached.empty())
      return distances;
    const std::vector<std::vector<std::size_t>> followers = followers_of_places();
    while(!reached.empty()) {
      std::vector<std::size_t> next;
      for(const std::size_t i : reached)
        for(const std::size_t follower : followers[i])
          if(distances[follower] == 0)
            next.push_back(follower);
      std::sort(next.begin(), next.end());
      next.erase(std::unique(next.begin(), next.end()), next.end());
      std::vector<double> found(next.size()); // all of the same distances, whatever their order
      parallel_for(concurrency_, next.size(),
                   [&](std::size_t k) { found[k] = distance_around(next[k], distances); });
      reached.clear();
      for(std::size_t k = 0; k < next.size(); ++k)
        if(found[k] > 0) {
          distances[next[k]] = found[k];
          reached.push_back(next[k]);
        }
    }
    return distances;
  }

  /// For each place those whose distances depend on its own, see `distance_around()`.
  std::vector<std::vector<std::size_t>> followers_of_places() const
  {
    std::vector<std::vector<std::size_t>> result(rows_.size());
    for(std::size_t i = 0; i < rows_.size(); ++i) {
      for(const Neighbor& near : nearest_[i])
        result[near.index].push_back(i);
      if(rows_[i].beside != none)
        result[rows_[i].beside].push_back(i);
    }
    return result;
  }

  /// The mean of the distances around a place: of all if most are in rows, otherwise if it is in a
  /// row of those that are parallel to it.
  double distance_around(std::size_t i, const std::vector<double>& distances) const
  {
    double sum = 0, number = 0;
    for(const Neighbor& near : nearest_[i])
      if(distances[near.index] > 0 && (!rows_[i].is_seen || are_parallel(i, near.index, still))) {
        sum += distances[near.index];
        ++number;
      }
    if(rows_[i].is_seen ? number > 0 : 2 * number > static_cast<double>(nearest_.k()))
      return sum / number;
    const std::size_t beside = rows_[i].beside;
    return beside != none && are_parallel(i, beside, still) ? distances[beside] : 0;
  }

  /// Whether the places in rows are more of those on lines than by chance: of samples of trees up
  /// to 15 % are, of slices and of scans with a few beams 41 % and more.
  bool are_more_than_chance(const std::vector<double>& distances) const
  {
    constexpr double least = 0.25;
    double in_rows = 0;
    for(std::size_t i = 0; i < rows_.size(); ++i)
      in_rows += rows_[i].is_seen && distances[i] > 0;
    return in_rows >= least * share_on_lines() * static_cast<double>(rows_.size());
  }

  const std::vector<Vector3>& places_;
  const Box_tree& tree_;
  const K_nearest_neighbors& nearest_;
  double longest_step_;
  Concurrency concurrency_;
  std::vector<Row> rows_; ///< At each place.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_PARALLEL_ROWS_H
