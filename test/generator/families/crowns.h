// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_CROWNS_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_CROWNS_H

#include "../Random.h"
#include "../Ray.h"
#include "../drawing.h"
#include "trees.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

/// Upright trees with many tips.
namespace shapes {
namespace families {

/// How a tree grows.
struct Growth
{
  double twig_radius, twig_length;
  std::vector<Limb> limbs;
};

/// A little thinner than all its twigs together (Leonardo's rule has a half in place of 0.42), so
/// that most of the surface is twigs.
inline double limb_radius(const Growth& growth, int tips)
{
  return growth.twig_radius * std::pow(tips, 0.42);
}

/// Distance from the far half of a straight limb to the limbs that are there, but for `parent`.
inline double clearance(const Growth& growth, const Limb& parent, const Bead& begin,
                        const Vector& end)
{
  double least = no_hit;
  for(const Limb& limb : growth.limbs)
    if(limb.back().centre != parent.back().centre)
      for(const Bead& bead : limb)
        for(const double t : {0.5, 0.75, 1.0}) {
          const Vector p = begin.centre + t * (end - begin.centre);
          least = std::min(least, (p - bead.centre).norm() - bead.radius);
        }
  return least;
}

/// The direction, of a dozen at about an angle from another one, in which there is most room: as
/// plants grow towards the light.
inline Vector direction_with_room(const Growth& growth, const Limb& parent, const Vector& straight,
                                  double angle, double length, Random& random)
{
  constexpr int candidates = 12;
  constexpr double upwards = 0.15;
  Vector best = straight;
  double most = -no_hit;
  for(const Vector& candidate : fork(straight, candidates, angle, random)) {
    const Vector direction = (candidate + upwards * Vector::UnitZ()).normalized();
    const Bead& begin = parent.back();
    const double room = clearance(growth, parent, begin, begin.centre + length * direction);
    if(room > most) {
      most = room;
      best = direction;
    }
  }
  return best;
}

/// Grows a limb that shall have some tips, and all that follow. Limbs with more tips are longer.
inline void grow_tree(Growth& growth, const Bead& begin, const Vector& direction, double length,
                      int tips, Random& random)
{
  constexpr double taper = 0.9;
  const Bead end = {begin.centre + length * direction, taper * begin.radius};
  const Vector bend = 0.04 * length * random.direction();
  growth.limbs.push_back(bent_limb(begin, end, bend));
  if(tips == 1)
    return;
  const Limb parent = growth.limbs.back();
  const double share = random.uniform(0.25, 0.5);
  const int fewer = std::max(1, static_cast<int>(std::lround(share * tips)));
  for(const int child : {tips - fewer, fewer}) {
    const double radius = std::min(end.radius, limb_radius(growth, child));
    // Out of its parent first.
    const double longer = growth.twig_length * std::pow(child, 0.35) * random.uniform(0.8, 1.2);
    const double child_length = 1.5 * end.radius + longer;
    // The smaller part goes aside, the larger one nearly straight on.
    const double angle = child == fewer ? random.uniform(0.7, 1) : random.uniform(0.2, 0.45);
    const Vector aside =
        direction_with_room(growth, parent, direction, angle, child_length, random);
    grow_tree(growth, {end.centre, radius}, aside, child_length, child, random);
  }
}

/// The limbs of a tree; those that do not meet do not touch.
inline std::vector<Limb> tree_limbs(int tips, Random& random)
{
  Growth growth;
  growth.twig_radius = random.uniform(0.004, 0.006);
  growth.twig_length = random.uniform(0.07, 0.09);
  do {
    growth.limbs.clear();
    const Bead root = {Vector::Zero(), limb_radius(growth, tips)};
    const double trunk = growth.twig_length * std::pow(tips, 0.35) * random.uniform(1, 1.5);
    grow_tree(growth, root, Vector::UnitZ(), trunk, tips, random);
  } while(!are_apart(growth.limbs));
  return growth.limbs;
}

inline Known_shape tree_of(const std::vector<Limb>& limbs, int tips)
{
  Known_shape shape;
  for(const Limb& limb : limbs)
    add_limb(shape, limb);
  set_counts(shape, 1, 0, static_cast<std::size_t>(tips) + 1); // with the foot of the trunk
  return shape;
}

/// A tree without leaves, with 40 to 300 tips; small and large ones are equally frequent.
inline Known_shape tree(Random& random)
{
  const int tips = static_cast<int>(40 * std::pow(300.0 / 40, random.uniform()));
  return tree_of(tree_limbs(tips, random), tips);
}

/// A leaf that is too small to have a branch of its own: a rhombus somewhere about a twig.
inline void add_small_leaf(Known_shape& shape, const Limb& twig, Random& random)
{
  const double length = (twig.back().centre - twig.front().centre).norm();
  const std::size_t bead =
      static_cast<std::size_t>(random.integer(0, static_cast<int>(twig.size()) - 1));
  const double away = random.uniform(0, 0.8) * length;
  const Vector middle = twig[bead].centre + away * random.direction();
  const Vector along = 0.12 * length * random.direction();
  const Vector across = 0.5 * along.cross(random.direction());
  shape.sheets.push_back({middle - along, middle - across, middle + along});
  shape.sheets.push_back({middle - along, middle + across, middle + along});
}

/// A smaller tree in leaf: in most of the crown the points are scattered, and hide the twigs.
inline Known_shape crown_in_leaf(Random& random)
{
  const int tips = random.integer(30, 60);
  const std::vector<Limb> limbs = tree_limbs(tips, random);
  Known_shape shape = tree_of(limbs, tips);
  for(const Limb& limb : limbs)
    if(is_free(limb, limbs)) {
      const int leaves = random.integer(30, 60);
      for(int i = 0; i < leaves; ++i)
        add_small_leaf(shape, limb, random);
    }
  return shape;
}

} // namespace families
} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_CROWNS_H
