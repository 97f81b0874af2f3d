// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Limbs in the pieces that they stick out of.

#include "analytic_surfaces.h"
#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/curve/Limb_roots.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/prune.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace limb_roots_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr int around = 12; // patches of a ring
constexpr double step = 0.5; // from ring to ring

/// Rings of patches around the x axis, and what they are part of.
struct Tube
{
  Surface_quotient quotient;
  Patches patches;

  std::size_t add_vertex(double x, bool is_cross_section)
  {
    quotient.graph.vertices.push_back({Vector3(x, 0, 0), 1, 0, is_cross_section});
    quotient.members.emplace_back();
    quotient.piece_of.push_back(is_cross_section ? Surface_quotient::no_piece
                                                 : quotient.members.size() - 1);
    return quotient.members.size() - 1;
  }

  void add_ring(std::size_t vertex, double x)
  {
    for(int k = 0; k < around; ++k) {
      const Vector3 direction = surfaces::around(2 * CGAL_PI * k / around);
      const std::size_t i = patches.size();
      patches.emplace_back();
      patches[i].mean = Vector3(x, direction.x(), direction.y());
      patches[i].spacing = step;
      patches[i].weight = 1;
      quotient.members[vertex].push_back(i);
      quotient.vertex_of_patch.push_back(vertex);
    }
  }

  /// Makes patches neighbours that are next to each other along or around the axis.
  void connect()
  {
    for(std::size_t i = 0; i < patches.size(); ++i)
      for(std::size_t j = 0; j < patches.size(); ++j)
        if(i != j && (patches[i].mean - patches[j].mean).norm() < 1.2 * step)
          patches[i].neighbors.push_back(j);
  }

  std::vector<Vector3> means() const
  {
    std::vector<Vector3> result;
    for(const Patch& patch : patches)
      result.push_back(patch.mean);
    return result;
  }
};

/// A limb of radius 1 with its tip at x = 0 and a single separator, at x = 0.5; its root ends at
/// `x = root`, where two other limbs begin, one on each side.
/// \param is_divided whether there are two fronts in the piece of the root
Tube limb_with_root(double root, bool is_divided = false)
{
  Tube tube;
  const std::size_t cap = tube.add_vertex(0, false), separator = tube.add_vertex(0.5, true);
  const std::size_t piece = tube.add_vertex(root / 2 + 0.5, is_divided);
  tube.quotient.graph.edges = {{cap, separator}, {separator, piece}};
  tube.add_ring(cap, 0);
  tube.add_ring(separator, 0.5);
  std::size_t last = piece;
  for(double x = 1; x < root; x += step) {
    if(is_divided && last == piece && x > root / 2) {
      last = tube.add_vertex(root / 2 + 1, true);
      tube.quotient.graph.edges.emplace_back(piece, last);
      tube.quotient.piece_of[last] = tube.quotient.piece_of[piece] = piece;
    }
    tube.add_ring(last, x);
  }
  for(const double side : {-1, 1}) {
    std::size_t before = side < 0 ? piece : last;
    for(int k = 0; k < 20; ++k) {
      const std::size_t next = tube.add_vertex(root + k * step, k % 2 == 0);
      tube.quotient.graph.vertices[next].position.y() = 3 * side;
      tube.quotient.graph.edges.emplace_back(before, next);
      tube.add_ring(next, root + k * step);
      for(std::size_t i : tube.quotient.members[next])
        tube.patches[i].mean.y() += 0.2 * k * side;
      before = next;
    }
  }
  tube.connect();
  return tube;
}

std::size_t number_of_tips_left(double root, bool is_divided = false)
{
  const Tube tube = limb_with_root(root, is_divided);
  const Skeleton_graph pruned =
    prune(tube.quotient, tube.patches, adjacent_pairs(tube.patches), tube.means(),
          Patch_groups(tube.patches.size()), Curve_options())
      .graph;
  std::size_t result = 0;
  for(const std::vector<std::size_t>& neighbors : pruned.adjacency())
    result += neighbors.size() == 1 ? 1 : 0;
  return result;
}

} // namespace

TEST_CASE("The root of a limb has rings up to where another limb begins")
{
  constexpr double root = 4;
  const Tube tube = limb_with_root(root);
  const std::vector<Patch_pair> pairs = adjacent_pairs(tube.patches);
  const std::vector<Vector3> means = tube.means();
  const Patch_groups groups(tube.patches.size());
  Limb_roots roots(tube.quotient, tube.patches, pairs, means, groups);
  double before = root;
  std::size_t number = 0;
  roots.for_rings(2, {0, 1}, [&](const std::vector<Vector3>& ring,
                                 const std::vector<Vector3>& root_points) {
    REQUIRE(ring.size() >= around);
    Vector3 middle = Vector3::Zero();
    for(const Vector3& p : ring)
      middle += p / static_cast<double>(ring.size());
    CHECK(std::hypot(middle.y(), middle.z()) < 1e-9); // it has no gap
    CHECK(middle.x() <= before);
    const bool reaches_piece =
      std::any_of(ring.begin(), ring.end(), [](const Vector3& p) { return p.x() > 0.9; });
    for(const Vector3& p : root_points)
      CHECK((p.x() > 0.9 && p.x() < root));
    CHECK(reaches_piece == !root_points.empty());
    before = middle.x();
    ++number;
  });
  CHECK(number >= 3);
  CHECK(before < 1.1); // the last one is beside the limb
}

TEST_CASE("A limb is as long as its root makes it, whatever its only separator")
{
  CHECK(number_of_tips_left(4) == 3);
  CHECK(number_of_tips_left(1.5) == 2); // half as long as wide
}

TEST_CASE("The root of a limb is the whole piece, however fronts around a handle divide that")
{
  CHECK(number_of_tips_left(4, true) == 3);
  CHECK(number_of_tips_left(1.5, true) == 2);
}

} // namespace limb_roots_test
