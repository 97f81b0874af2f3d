// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_SCENE_OBJECTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_SCENE_OBJECTS_H

#include <CGAL/Point_set_skeletonization_3/internal/consolidation/cloud_of_lines.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/quantile.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Neighbor.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/nearest_points.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// What is an object of its own.
struct Scene_options
{
  /// Gap between two parts of a cloud, > 0, in lengths of the smaller one, from which on they are
  /// two objects. A limb whose middle is missing is found by its direction over twice its thickness
  /// (`Curve_options::widest_gap`), so that pieces no more slender than that stay together.
  double apart = 1;

  // As `Consolidation_options::isolated` and `Curve_options::stray_share`, which drop the outliers of
  // an object.
  double isolated = 3;       ///< Spacings of an object, > 1; what is sparser is scattered around it.
  double stray_share = 0.01; ///< Of the points of the largest part, in [0, 1); less is no part.

  /// Checks all ranges.
  void check() const
  {
    CGAL_precondition(apart > 0 && isolated > 1);
    CGAL_precondition(stray_share >= 0 && stray_share < 1);
  }

  /// Calls `visit(name, value)` for every option that is no other's.
  template <typename Visit>
  void visit(const Visit& visit)
  {
    visit("apart", apart);
  }
};

/// A connected part of a cloud.
class Scene_part
{
public:
  /// Of some components. O(n). \pre there is one
  Scene_part(const std::vector<std::size_t>& components, const Gaussians& mixture,
             const K_nearest_neighbors& nearest)
  {
    std::vector<double> spacings;
    for(std::size_t i : components) {
      spacings.push_back(spacing_of(i, nearest));
      weight_ += mixture[i].weight;
      places_.push_back(mixture[i].mean);
      middle_ += mixture[i].mean / static_cast<double>(components.size());
    }
    spacing_ = quantile(std::move(spacings), 0.5);
    for(const Vector3& p : places_)
      radius_ = (std::max)(radius_, (p - middle_).norm());
  }

  double weight() const { return weight_; }   ///< Number of points.
  double spacing() const { return spacing_; } ///< The median.

  /// The means of the components.
  const std::vector<Vector3>& places() const { return places_; }

  /// Whether the gap to another part is less than some lengths of the smaller one. O(n log n) in
  /// the components of both, O(1) if they are far apart.
  bool is_near(const Scene_part& other, double lengths) const
  {
    const double gap = lengths * 2 * (std::min)(radius_, other.radius_);
    if((middle_ - other.middle_).norm() - radius_ - other.radius_ >= gap)
      return false;
    const Box_tree tree(places_);
    return std::any_of(other.places_.begin(), other.places_.end(),
                       [&](const Vector3& p) { return tree.has_any_within(p, gap); });
  }

private:
  std::vector<Vector3> places_;
  double weight_ = 0, spacing_ = 0;
  Vector3 middle_ = Vector3::Zero();
  double radius_ = 0; ///< Of the ball around the middle.
};

/// Returns the connected parts of a mixture with more than a share of the points of the largest, in
/// the order of their first components. Components are connected if each is a neighbour of the
/// other: an outlier is nobody's. A part has more components than one has neighbours. O(n).
inline std::vector<Scene_part> scene_parts(const Gaussians& mixture,
                                           const K_nearest_neighbors& nearest, double stray_share)
{
  Union_find sets(mixture.size());
  for(std::size_t i = 0; i < mixture.size(); ++i)
    for(const Neighbor& neighbor : nearest[i]) {
      const auto back = nearest[neighbor.index];
      if(i < neighbor.index && std::any_of(back.begin(), back.end(), [i](const Neighbor& other) {
           return other.index == i;
         }))
        sets.join(i, neighbor.index);
    }
  std::vector<std::vector<std::size_t>> components(mixture.size());
  std::vector<double> weight(mixture.size(), 0);
  for(std::size_t i = 0; i < mixture.size(); ++i) {
    components[sets.find(i)].push_back(i);
    weight[sets.find(i)] += mixture[i].weight;
  }
  const auto is_part = [&](std::size_t i) { return components[i].size() >= nearest.k(); };
  double most = 0;
  for(std::size_t i = 0; i < mixture.size(); ++i)
    if(is_part(i))
      most = (std::max)(most, weight[i]);
  std::vector<Scene_part> result;
  for(std::size_t i = 0; i < mixture.size(); ++i)
    if(is_part(i) && weight[i] >= stray_share * most)
      result.emplace_back(components[i], mixture, nearest);
  return result;
}

/// Returns the part that each is scattered around: the densest one near it that is much denser and
/// has more points; itself if there is none. O(parts^2), times the components of those that are near.
inline std::vector<std::size_t> scattered_around(const std::vector<Scene_part>& parts,
                                                 const Scene_options& options)
{
  std::vector<std::size_t> result(parts.size());
  for(std::size_t a = 0; a < parts.size(); ++a) {
    result[a] = a;
    for(std::size_t b = 0; b < parts.size(); ++b)
      if(parts[a].spacing() > options.isolated * parts[b].spacing() &&
         parts[a].weight() < parts[b].weight() &&
         parts[b].spacing() < parts[result[a]].spacing() &&
         parts[a].is_near(parts[b], options.apart))
        result[a] = b;
  }
  return result;
}

/// Returns the parts of each object, the objects in the order of their first parts. Parts are one if
/// the gap between them is shorter than the smaller one. What is scattered around a part belongs to
/// its object, and joins it to no other. O(parts^2), times the components of those that are near.
inline std::vector<std::vector<std::size_t>> objects_of(const std::vector<Scene_part>& parts,
                                                        const Scene_options& options)
{
  const std::vector<std::size_t> around = scattered_around(parts, options);
  Union_find sets(parts.size());
  for(std::size_t a = 0; a < parts.size(); ++a)
    for(std::size_t b = a + 1; b < parts.size(); ++b)
      if(around[a] == a && around[b] == b && sets.find(a) != sets.find(b) &&
         parts[a].is_near(parts[b], options.apart))
        sets.join(a, b);
  for(std::size_t a = 0; a < parts.size(); ++a)
    sets.join(a, around[a]);
  std::vector<std::size_t> number(parts.size());
  std::vector<std::vector<std::size_t>> result;
  for(std::size_t a = 0; a < parts.size(); ++a) {
    if(sets.find(a) == a) {
      number[a] = result.size();
      result.emplace_back();
    }
    result[number[sets.find(a)]].push_back(a);
  }
  return result;
}

/// Divides a scene into its objects: returns the components of each, ascending. What stands beside
/// an object says nothing about it: not how noisy it is or how densely it was scanned, nor whether
/// it is a frame or a tree. What is in no part goes with the nearest. O(n log n) in practice.
/// \pre there is a component
inline std::vector<std::vector<std::size_t>> scene_objects(const Gaussians& mixture,
                                                           const K_nearest_neighbors& nearest,
                                                           const Scene_options& options,
                                                           Concurrency concurrency)
{
  options.check();
  const std::vector<Scene_part> parts = scene_parts(mixture, nearest, options.stray_share);
  const std::vector<std::vector<std::size_t>> objects = objects_of(parts, options);
  if(objects.size() < 2) {
    std::vector<std::size_t> all(mixture.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    return {all};
  }
  std::vector<std::size_t> object_of_place;
  std::vector<Vector3> places;
  for(std::size_t object = 0; object < objects.size(); ++object)
    for(std::size_t a : objects[object]) {
      places.insert(places.end(), parts[a].places().begin(), parts[a].places().end());
      object_of_place.resize(places.size(), object);
    }
  const std::vector<std::size_t> nearest_place =
    nearest_points(Box_tree(places, concurrency), means_of(mixture), concurrency);
  std::vector<std::vector<std::size_t>> result(objects.size());
  for(std::size_t i = 0; i < mixture.size(); ++i) // the nearest to what is in a part is itself
    result[object_of_place[nearest_place[i]]].push_back(i);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_SCENE_OBJECTS_H
