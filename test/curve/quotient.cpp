// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The graph of the pieces that separators cut a surface into, on rings of patches; and what is
// pruned from it.

#include "surface_of.h"

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Refined_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/handle_fronts.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/prune.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/line_trees.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/path_trees.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/stray_components.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/ways_through_pieces.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Ball_overlaps.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Separator_options.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace quotient_test {

using namespace CGAL::Point_set_skeletonization_3::internal;
using surfaces::Tube;
using surfaces::tube_radius;

namespace {

Ball_overlaps overlaps_of(const Surface& surface, const Samples& samples)
{
  constexpr double unknown = 0;
  return Ball_overlaps(surface, samples, unknown, Separator_options().overlap,
                       Concurrency::sequential);
}

Surface_quotient quotient_of(const Tube& tube, const std::vector<int>& rings)
{
  const Surface surface = surfaces::surface_of(tube.patches());
  const Samples samples = surfaces::samples_of(surface.patches);
  std::vector<Local_separator> separators;
  for(int ring : rings)
    separators.push_back(tube.separator(ring));
  return surface_quotient(surface.patches, samples, overlaps_of(surface, samples), separators,
                          Concurrency::sequential);
}

std::size_t number_of_components(const Skeleton_graph& graph)
{
  Union_find sets(graph.vertices.size());
  std::size_t result = graph.vertices.size();
  for(const Skeleton_graph::Edge& e : graph.edges)
    result -= sets.join(e.first, e.second) ? 1 : 0;
  return result;
}

std::size_t number_of_cycles(const Skeleton_graph& graph)
{
  return graph.edges.size() + number_of_components(graph) - graph.vertices.size();
}

// All vertices have two neighbours, those of one cycle without double edges.
bool is_cycle(const Skeleton_graph& graph)
{
  const auto adjacency = graph.adjacency();
  return number_of_components(graph) == 1 &&
         std::all_of(adjacency.begin(), adjacency.end(), [](const auto& neighbors) {
           return neighbors.size() == 2 && neighbors[0] != neighbors[1];
         });
}

bool is_path(const Skeleton_graph& graph)
{
  const auto adjacency = graph.adjacency();
  return number_of_components(graph) == 1 && graph.edges.size() + 1 == graph.vertices.size() &&
         std::all_of(adjacency.begin(), adjacency.end(),
                     [](const auto& neighbors) { return neighbors.size() <= 2; });
}

// A quotient made by hand: vertices with a ring of patches around each.
class Made_up_quotient
{
public:
  Surface_quotient quotient;
  Patches patches;

  // \param ring how many patches, around an axis
  std::size_t add_vertex(const Vector3& position, const Vector3& axis, double radius, int ring = 12)
  {
    const std::size_t v = quotient.graph.vertices.size();
    quotient.graph.vertices.push_back({position, radius, 0, false});
    quotient.members.emplace_back();
    quotient.piece_of.push_back(v);
    const Vector3 e1 = axis.unitOrthogonal(), e2 = axis.normalized().cross(e1);
    for(int k = 0; k < ring; ++k) {
      const Vector3 direction = surfaces::around(2 * CGAL_PI * k / ring);
      Patch patch;
      patch.mean = position + radius * (direction.x() * e1 + direction.y() * e2);
      patch.weight = 1;
      quotient.vertex_of_patch.push_back(v);
      quotient.members[v].push_back(patches.size());
      patches.push_back(patch);
    }
    return v;
  }

  // A branch from a vertex, of `size` vertices one `step` apart: a cross-section, a piece, and so
  // on.
  std::size_t add_branch(std::size_t from, const Vector3& step, int size, double radius,
                         int ring = 12)
  {
    for(int k = 0; k < size; ++k) {
      const Vector3 position = quotient.graph.vertices[from].position + step;
      const std::size_t next = add_vertex(position, step, radius, ring);
      quotient.graph.vertices[next].is_cross_section = k % 2 == 0;
      quotient.graph.edges.emplace_back(from, next);
      from = next;
    }
    return from;
  }

  Pruned_quotient pruned() const
  {
    std::vector<Vector3> means;
    for(const Patch& patch : patches)
      means.push_back(patch.mean);
    return prune(quotient, patches, pairs(), means, Patch_groups(patches.size()),
                 Curve_options());
  }

private:
  // Patches are adjacent to the next one of their vertex, and to one of each adjacent vertex.
  std::vector<Patch_pair> pairs() const
  {
    std::vector<Patch_pair> result;
    const auto add = [&](std::size_t i, std::size_t j) {
      result.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)});
    };
    for(const std::vector<std::size_t>& ring : quotient.members)
      for(std::size_t k = 1; k < ring.size(); ++k)
        add(ring[k - 1], ring[k]);
    for(const auto& [v, w] : quotient.graph.edges)
      add(quotient.members[v].front(), quotient.members[w].front());
    return result;
  }
};

std::size_t number_of_ends(const Skeleton_graph& graph)
{
  const auto adjacency = graph.adjacency();
  std::size_t result = 0;
  for(const std::vector<std::size_t>& neighbors : adjacency)
    result += neighbors.size() == 1;
  return result;
}

// Two long limbs in a line from the first vertex, which end with cross-sections.
Made_up_quotient two_limbs()
{
  Made_up_quotient result;
  const Vector3 z = Vector3::UnitZ();
  const std::size_t middle = result.add_vertex(Vector3::Zero(), z, 1);
  result.add_branch(middle, z, 9, 1);
  result.add_branch(middle, -z, 9, 1);
  return result;
}

/// A quotient of pieces that are not connected.
Surface_quotient pieces_of(const std::vector<std::size_t>& vertex_of_patch, const Patches& patches,
                           const Samples& samples)
{
  Surface_quotient result;
  result.vertex_of_patch = vertex_of_patch;
  result.members = patches_of_vertices(
    vertex_of_patch, 1 + *std::max_element(vertex_of_patch.begin(), vertex_of_patch.end()));
  for(const std::vector<std::size_t>& members : result.members) {
    result.piece_of.push_back(result.graph.vertices.size());
    result.graph.vertices.push_back(middle(members, patches, samples));
  }
  return result;
}

/// A quotient with one vertex.
Surface_quotient one_piece(const Patches& patches, const Samples& samples)
{
  return pieces_of(std::vector<std::size_t>(patches.size(), 0), patches, samples);
}

std::vector<bool> none_of(const Patches& patches)
{
  return std::vector<bool>(patches.size(), false);
}

} // namespace

TEST_CASE("A torus with separators is a cycle, however many they are")
{
  for(const std::vector<int>& rings :
      {std::vector<int>{10}, {10, 40}, {10, 30, 50}, {5, 15, 25, 35, 45, 55}}) {
    CAPTURE(rings.size());
    const Surface_quotient quotient = quotient_of(surfaces::torus, rings);
    CHECK(is_cycle(quotient.graph));
    // One vertex for every separator and every piece; a third one where there is one of both.
    CHECK(quotient.graph.vertices.size() == std::max<std::size_t>(3, 2 * rings.size()));
  }
}

TEST_CASE("A tube with separators is a path")
{
  for(const std::vector<int>& rings : {std::vector<int>{15}, {7, 20}, {4, 12, 18, 25}}) {
    CAPTURE(rings.size());
    const Surface_quotient quotient = quotient_of(surfaces::tube, rings);
    CHECK(is_path(quotient.graph));
    CHECK(quotient.graph.vertices.size() == 2 * rings.size() + 1);
  }
}

TEST_CASE("Without separators all is one vertex in the middle")
{
  const Surface_quotient quotient = quotient_of(surfaces::tube, {});
  REQUIRE(quotient.graph.vertices.size() == 1);
  CHECK(quotient.graph.edges.empty());
  CHECK(quotient.graph.vertices[0].radius == Approx(tube_radius));
}

TEST_CASE("Separators that touch still have a piece between them")
{
  const Surface_quotient quotient = quotient_of(surfaces::tube, {14, 15});
  CHECK(is_path(quotient.graph));
  CHECK(quotient.graph.vertices.size() == 5);
}

TEST_CASE("A vertex lies in the middle of its patches, and separators are cross-sections")
{
  const std::vector<int> rings = {7, 20};
  const Surface_quotient quotient = quotient_of(surfaces::tube, rings);
  const Patches patches = surfaces::tube.patches();
  REQUIRE(quotient.vertex_of_patch.size() == patches.size());
  for(std::size_t v = 0; v < quotient.graph.vertices.size(); ++v) {
    const auto& vertex = quotient.graph.vertices[v];
    CHECK(vertex.is_cross_section == (v < rings.size()));
    CHECK(vertex.position.tail<2>().norm() < 1e-6);
    CHECK(vertex.radius == Approx(tube_radius));
  }
  for(std::size_t s = 0; s < rings.size(); ++s) {
    const double x = patches[surfaces::tube.index(rings[s], 0)].mean.x();
    CHECK(quotient.graph.vertices[s].position.x() == Approx(x));
    for(int j = 0; j < surfaces::across; ++j)
      CHECK(quotient.vertex_of_patch[surfaces::tube.index(rings[s], j)] == s);
  }
}

TEST_CASE("Where balls do not overlap, limbs that touch are joined once: there is no loop")
{
  // A torus of which one ring has its balls outside: these meet those of no other ring.
  const Tube tube = surfaces::torus;
  const Surface surface = surfaces::surface_of(tube.patches());
  const Patches& patches = surface.patches;
  Samples samples = surfaces::samples_of(patches);
  for(int j = 0; j < surfaces::across; ++j) {
    const std::size_t i = tube.index(tube.along - 1, j);
    samples[i].position = patches[i].mean + tube_radius * patches[i].normal;
  }
  const Ball_overlaps overlaps = overlaps_of(surface, samples);
  const std::vector<Local_separator> separators = {tube.separator(20), tube.separator(40)};
  const Surface_quotient quotient =
    surface_quotient(patches, samples, overlaps, separators, Concurrency::sequential);
  CHECK(number_of_components(quotient.graph) == 1);
  CHECK(quotient.graph.edges.size() + 1 == quotient.graph.vertices.size());
}

TEST_CASE("Fronts lead around a handle that one ring cuts")
{
  const Tube& torus = surfaces::torus;
  const Patches patches = torus.patches();
  const Surface_quotient quotient = quotient_of(torus, {5});
  REQUIRE(quotient.handles.size() == 1);
  const auto off_axis = [&](const Surface_quotient& q) {
    double result = 0;
    for(const Skeleton_graph::Vertex& vertex : q.graph.vertices)
      result = (std::max)(result,
                          (vertex.position - surfaces::ring_radius * vertex.position.normalized())
                            .norm());
    return result;
  };
  CHECK(off_axis(quotient) > 0.5 * surfaces::ring_radius); // the piece is all of the torus
  const Surface_quotient fronts =
    with_handle_fronts(quotient, {torus.separator(5)}, patches, surfaces::samples_of(patches),
                       adjacent_pairs(patches));
  CHECK(is_cycle(fronts.graph));
  CHECK(off_axis(fronts) < tube_radius);
  CHECK(fronts.handles.empty());
  for(std::size_t i = 0; i < patches.size(); ++i) { // each patch is at its vertex
    const auto& members = fronts.members[fronts.vertex_of_patch[i]];
    CHECK(std::count(members.begin(), members.end(), i) == 1);
  }
  CHECK(quotient_of(torus, {5, 25}).handles.empty());
  CHECK(quotient_of(surfaces::tube, {5}).handles.empty());
}

TEST_CASE("Fronts lead around a handle that two rings cut close to each other")
{
  const Tube& torus = surfaces::torus;
  const Patches patches = torus.patches();
  const Samples samples = surfaces::samples_of(patches);
  const Surface_quotient quotient = quotient_of(torus, {5, 9});
  REQUIRE(quotient.handles.empty());
  const auto is_round = [&](const Surface_quotient& q) {
    return std::all_of(q.graph.vertices.begin(), q.graph.vertices.end(), [](const auto& vertex) {
      return std::abs(vertex.position.norm() - surfaces::ring_radius) < tube_radius;
    });
  };
  CHECK_FALSE(is_round(quotient)); // one piece is most of the torus
  const Surface_quotient fronts =
    with_handle_fronts(quotient, {torus.separator(5), torus.separator(9)}, patches, samples,
                       adjacent_pairs(patches));
  CHECK(is_cycle(fronts.graph));
  CHECK(is_round(fronts));
  for(std::size_t i = 0; i < patches.size(); ++i) { // each patch is at its vertex
    const auto& members = fronts.members[fronts.vertex_of_patch[i]];
    CHECK(std::count(members.begin(), members.end(), i) == 1);
  }
}

TEST_CASE("Nothing leads through the pieces of a tree, and one piece with two loops has two ways")
{
  const Tube& tube = surfaces::tube;
  const std::vector<Local_separator> separators = {tube.separator(7), tube.separator(20)};
  CHECK(ways_through_pieces(quotient_of(tube, {7, 20}), separators).empty());

  // Four separators; the middle piece is on two cycles, each through two of them and another piece.
  const Tube& torus = surfaces::torus;
  Surface_quotient quotient = quotient_of(torus, {5, 15, 25, 35});
  const auto adjacency = quotient.graph.adjacency();
  const std::size_t middle = adjacency[0][0];
  const auto pieces = quotient.graph.vertices.size() - 4;
  REQUIRE(pieces == 4);
  quotient.graph.edges.clear();
  std::vector<std::size_t> others;
  for(std::size_t v = 4; v < quotient.graph.vertices.size(); ++v)
    if(v != middle)
      others.push_back(v);
  quotient.graph.edges = {{0, middle}, {0, others[0]}, {1, others[0]}, {1, middle},
                          {2, middle}, {2, others[1]}, {3, others[1]}, {3, middle}};
  const Ways_through_pieces ways =
    ways_through_pieces(quotient, {torus.separator(5), torus.separator(15), torus.separator(25),
                                   torus.separator(35)});
  REQUIRE(ways.count(middle) == 1);
  REQUIRE(ways.at(middle).size() == 2);
  for(const Way_through& way : ways.at(middle)) {
    CHECK_FALSE(way.leads_around());
    CHECK(way.from.separator / 2 == way.to.separator / 2); // of one cycle
  }
  CHECK(ways.at(others[0]).size() == 1);
}

TEST_CASE("A handle stays known until one of its vertices is replaced")
{
  const Patches patches = surfaces::torus.patches();
  const Samples samples = surfaces::samples_of(patches);
  const Surface_quotient quotient = quotient_of(surfaces::torus, {5});
  REQUIRE(quotient.handles.size() == 1);
  const Surface_quotient same = Refined_quotient(quotient).take(patches, samples);
  REQUIRE(same.handles.size() == 1);
  CHECK(same.handles[0].separator == quotient.handles[0].separator);
  CHECK(same.handles[0].piece == quotient.handles[0].piece);
  CHECK(same.handles[0].extra == quotient.handles[0].extra);
  Refined_quotient refined(quotient);
  const std::size_t piece = quotient.handles[0].piece, front = refined.add_front();
  refined.remove(piece);
  for(std::size_t i : quotient.members[piece])
    refined.add_to_front(front, i);
  CHECK(refined.take(patches, samples).handles.empty());
}

TEST_CASE("Fronts around a handle keep what is attached to the piece")
{
  // A piece around a handle, made of a torus with one ring, and a limb that is attached to it
  // opposite of the ring.
  const Tube& torus = surfaces::torus;
  const Patches patches = torus.patches();
  const int ring = 5, far = ring + torus.along / 2;
  Surface_quotient quotient = quotient_of(torus, {ring});
  const std::size_t piece = quotient.handles.front().piece, limb = quotient.graph.vertices.size();
  quotient.graph.vertices.emplace_back();
  quotient.graph.edges.emplace_back(piece, limb);
  quotient.members.push_back({torus.index(far, 0)});
  quotient.vertex_of_patch[torus.index(far, 0)] = limb;
  auto& members = quotient.members[piece];
  members.erase(std::find(members.begin(), members.end(), torus.index(far, 0)));
  const Surface_quotient fronts =
    with_handle_fronts(quotient, {torus.separator(ring)}, patches, surfaces::samples_of(patches),
                       adjacent_pairs(patches));
  CHECK(number_of_components(fronts.graph) == 1);
  CHECK(number_of_cycles(fronts.graph) == 1);
  CHECK(number_of_ends(fronts.graph) == 1);
  const std::size_t tip = fronts.vertex_of_patch[torus.index(far, 0)];
  const auto adjacent = fronts.graph.adjacency()[tip];
  REQUIRE(adjacent.size() == 1);
  CHECK((fronts.graph.vertices[adjacent[0]].position -
         surfaces::ring_radius * surfaces::around(2 * CGAL_PI * far / torus.along))
          .norm() < 0.5 * surfaces::ring_radius);
}

TEST_CASE("Fronts of two pieces that are joined without a separator stay joined")
{
  const Tube& torus = surfaces::torus;
  const Patches patches = torus.patches();
  const int first = 5, second = 25;
  Surface_quotient quotient = quotient_of(torus, {first, second});
  const std::size_t a = quotient.vertex_of_patch[torus.index(first + 3, 0)],
                    b = quotient.vertex_of_patch[torus.index(first - 3, 0)];
  REQUIRE(is_piece(a, quotient));
  REQUIRE(is_piece(b, quotient));
  quotient.graph.edges.emplace_back(a, b);
  const Surface_quotient fronts =
    with_handle_fronts(quotient, {torus.separator(first), torus.separator(second)}, patches,
                       surfaces::samples_of(patches), adjacent_pairs(patches));
  CHECK(fronts.graph.vertices.size() > quotient.graph.vertices.size());
  for(const Skeleton_graph::Edge& e : fronts.graph.edges)
    REQUIRE((std::max)(e.first, e.second) < fronts.graph.vertices.size());
  CHECK(number_of_components(fronts.graph) == 1);
  CHECK(number_of_cycles(quotient.graph) == 2);
  CHECK(number_of_cycles(fronts.graph) == 2);
}

TEST_CASE("Trees of paths in pieces have each patch at a vertex and close no cycle")
{
  const std::vector<int> rings = {5, 25};
  for(const Tube& tube : {surfaces::tube, surfaces::torus}) {
    const Patches patches = tube.patches();
    const Surface_quotient quotient = quotient_of(tube, rings);
    const auto with_trees = [&](bool is_marked) {
      return with_path_trees(quotient, surfaces::surface_of(patches), surfaces::samples_of(patches),
                             adjacent_pairs(patches), std::vector<bool>(patches.size(), is_marked),
                             Concurrency::parallel);
    };
    const Surface_quotient trees = with_trees(true), same = with_trees(false);
    CHECK(number_of_components(trees.graph) == 1);
    CHECK(number_of_cycles(trees.graph) == 0);
    CHECK(same.graph.edges == quotient.graph.edges);
    CHECK(same.vertex_of_patch == quotient.vertex_of_patch);
    for(std::size_t i = 0; i < patches.size(); ++i) {
      const auto& members = trees.members[trees.vertex_of_patch[i]];
      CHECK(std::count(members.begin(), members.end(), i) == 1);
    }
    for(std::size_t s = 0; s < rings.size(); ++s) // separators stay
      for(std::size_t i : quotient.members[s])
        CHECK(trees.vertex_of_patch[i] == s);
  }
}

TEST_CASE("A cluster in the tube of a limb that it is not connected with belongs to it")
{
  // A limb that is as thick as long, and beside its middle patches that have only each other as
  // nearest neighbours.
  Patches patches;
  std::vector<Vector3> places;
  const auto add = [&](const Vector3& place, double thickness, double spacing) {
    Patch patch;
    patch.mean = place + Vector3(0, 0, thickness);
    patch.spacing = spacing;
    patch.weight = patch.area = 1;
    patches.push_back(patch);
    places.push_back(place);
  };
  for(int k = 0; k < 100; ++k)
    add(Vector3(0.1 * k, 0, 0), k % 2 == 0 ? 6 : -6, 1);
  for(int k = 0; k < 30; ++k)
    add(Vector3(5, 1.5 + 0.001 * k, 0), 0, 0.001);
  const Samples samples = surfaces::samples_of(patches);
  const Surface_quotient piece = one_piece(patches, samples);
  const std::vector<bool> is_loose(patches.size(), true);
  const Surface_quotient trees =
    Path_trees(piece, surfaces::surface_of(patches), samples, places, {}, is_loose,
               Concurrency::sequential)
      .run();
  CHECK(number_of_components(trees.graph) == 1);
  for(std::size_t i = 0; i < patches.size(); ++i) {
    REQUIRE(trees.vertex_of_patch[i] < trees.members.size());
    const auto& members = trees.members[trees.vertex_of_patch[i]];
    CHECK(std::count(members.begin(), members.end(), i) == 1);
  }
}

TEST_CASE("Parts of a piece between two separators close no cycle")
{
  // Two strips along a tube are unresolved: two others are left of the piece between its rings.
  const Tube& tube = surfaces::tube;
  const Patches patches = tube.patches();
  const Surface_quotient quotient = quotient_of(tube, {5, 25});
  const std::size_t around = tube.index(1, 0), piece = quotient.vertex_of_patch[tube.index(15, 0)];
  std::vector<bool> is_out;
  for(std::size_t i = 0; i < patches.size(); ++i)
    is_out.push_back(quotient.vertex_of_patch[i] == piece && i % around % (around / 2) < 2);
  Refined_quotient refined(quotient);
  Union_find sets = refined.take_out(is_out, adjacent_pairs(patches));
  const std::size_t parts = refined.number_of_vertices() - quotient.graph.vertices.size();
  CHECK(parts == 2);
  CHECK(sets.find(0) == sets.find(1)); // the rings
  const std::size_t rest = refined.add_front();
  for(std::size_t i = 0; i < patches.size(); ++i)
    if(is_out[i])
      refined.add_to_front(rest, i);
  const Skeleton_graph graph = refined.take(patches, surfaces::samples_of(patches)).graph;
  CHECK(number_of_cycles(graph) == 0);
  CHECK(number_of_components(graph) == 2); // without what was taken out
}

TEST_CASE("What has no cross-section between unresolved patches is as these, unless it is the most")
{
  // All of a tube is one piece, of which one half is resolved, and a third of the other.
  const Tube& tube = surfaces::tube;
  const Patches patches = tube.patches();
  const Surface_quotient quotient = quotient_of(tube, {});
  const auto loose_if_unresolved_until = [&](int ring) {
    std::vector<bool> is_unresolved;
    for(std::size_t i = 0; i < patches.size(); ++i)
      is_unresolved.push_back(i < tube.index(ring, 0));
    const std::vector<bool> loose =
      loose_patches(quotient, adjacent_pairs(patches), is_unresolved);
    CHECK(std::equal(is_unresolved.begin(),
                     is_unresolved.begin() + static_cast<std::ptrdiff_t>(tube.index(ring, 0)),
                     loose.begin()));
    return std::count(loose.begin(), loose.end(), true);
  };
  const auto size = static_cast<std::ptrdiff_t>(patches.size());
  CHECK(loose_if_unresolved_until(tube.along / 3) ==
        static_cast<std::ptrdiff_t>(tube.index(tube.along / 3, 0)));
  CHECK(loose_if_unresolved_until(2 * tube.along / 3) == size);
}

TEST_CASE("A path ends where what follows was seen less than is missing before it")
{
  constexpr int limb = 60; // patches, so long that the root is in it
  constexpr double gap = 3.4;
  const auto end_of_path = [&](int pieces, int patches_of_piece) { // one behind the other
    Patches patches;
    double x = 0;
    const auto add = [&](int number) {
      for(int k = 0; k < number; ++k, ++x) {
        Patch patch;
        patch.mean = Vector3(x, 0, 0);
        patch.spacing = patch.weight = patch.area = 1;
        patches.push_back(patch);
      }
    };
    add(limb);
    for(int k = 0; k < pieces; ++k) {
      x += gap - 1;
      add(patches_of_piece);
    }
    Samples samples;
    for(const Patch& patch : patches)
      samples.push_back({patch.mean, 0});
    const Skeleton_graph tree =
      with_path_trees(one_piece(patches, samples), surfaces::surface_of(patches), samples, {},
                      std::vector<bool>(patches.size(), true), Concurrency::sequential)
        .graph;
    double furthest = 0;
    for(const Skeleton_graph::Vertex& vertex : tree.vertices)
      furthest = std::max(furthest, vertex.position.x());
    return furthest;
  };
  for(int pieces : {1, 2, 3}) {
    CAPTURE(pieces);
    CHECK(end_of_path(pieces, 3) == limb - 1);
    CHECK(end_of_path(pieces, 6) == Approx(limb - 1 + pieces * (gap + 5)));
  }
}

TEST_CASE("What is missing before a twig is made up for by all of its branches")
{
  constexpr int limb = 60;
  constexpr double gap = 3.4;
  for(const std::size_t branches : {1, 2}) { // each shorter than the gap
    CAPTURE(branches);
    std::vector<Vector3> places;
    for(int k = 0; k < limb; ++k)
      places.emplace_back(k, 0, 0);
    for(int k = branches == 1 ? 0 : -3; k <= 3; ++k)
      places.emplace_back(limb - 1 + gap, k, 0);
    Patches patches(places.size());
    for(std::size_t i = 0; i < patches.size(); ++i) {
      patches[i].mean = places[i];
      patches[i].spacing = patches[i].weight = patches[i].area = 1;
    }
    const Samples samples = surfaces::samples_of(patches);
    const Skeleton_graph tree =
      Path_trees(one_piece(patches, samples), surfaces::surface_of(patches), samples, places, {},
                 std::vector<bool>(patches.size(), true), Concurrency::sequential)
        .run()
        .graph;
    CHECK(number_of_components(tree) == 1);
    CHECK(number_of_ends(tree) == branches + 1);
    CHECK((tree.vertices.size() == places.size()) == (branches == 2));
  }
}

TEST_CASE("What is resolved is joined over a gap if as much as is missing was seen")
{
  constexpr std::size_t limb = 60;
  constexpr double gap = 3.4;
  for(const std::size_t beyond : {3, 6}) {
    CAPTURE(beyond);
    Patches patches(limb + beyond);
    std::vector<Vector3> places;
    std::vector<Patch_pair> pairs;
    for(std::size_t i = 0; i < patches.size(); ++i) {
      patches[i].mean.x() = static_cast<double>(i) + (i < limb ? 0 : gap - 1);
      patches[i].spacing = patches[i].weight = patches[i].area = 1;
      places.push_back(patches[i].mean);
      if(i > limb)
        pairs.push_back({static_cast<std::uint32_t>(i - 1), static_cast<std::uint32_t>(i)});
    }
    std::vector<bool> is_loose(patches.size(), true);
    std::fill_n(is_loose.rbegin(), beyond, false);
    const Samples samples = surfaces::samples_of(patches);
    const Surface_quotient piece = one_piece(patches, samples);
    const Surface_quotient trees =
      Path_trees(piece, surfaces::surface_of(patches), samples, places, pairs, is_loose,
                 Concurrency::sequential)
        .run();
    CHECK(number_of_components(trees.graph) == (static_cast<double>(beyond - 1) > gap ? 1 : 2));
  }
}

TEST_CASE("Where a limb has no medial balls, trees join its parts, not where both sides have some")
{
  // Two parts of a limb next to each other, and others, not resolved, from the end of one around to
  // the beginning of the other.
  constexpr std::size_t part = 30, limb = 2 * part, around = 50;
  std::vector<Vector3> places;
  for(std::size_t i = 0; i < limb; ++i)
    places.emplace_back(i, 0, 0);
  for(std::size_t k = 0; k < around; ++k) {
    const double t = (static_cast<double>(k) + 1) / (around + 1) * CGAL_PI;
    places.emplace_back(29.5 * (1 + std::cos(t)), 40 * std::sin(t), 0);
  }
  Patches patches(places.size());
  std::vector<Patch_pair> pairs;
  std::vector<std::size_t> piece_of_patch;
  std::vector<bool> is_around;
  for(std::size_t i = 0; i < patches.size(); ++i) {
    patches[i].mean = places[i];
    patches[i].spacing = patches[i].weight = patches[i].area = 1;
    const std::size_t next = (i + 1) % patches.size();
    pairs.push_back({static_cast<std::uint32_t>(std::min(i, next)),
                     static_cast<std::uint32_t>(std::max(i, next))});
    piece_of_patch.push_back(i < part ? 0 : i < limb ? 1 : 2);
    is_around.push_back(i >= limb);
  }
  for(const bool have_balls : {false, true}) {
    CAPTURE(have_balls);
    Samples samples;
    for(std::size_t i = 0; i < patches.size(); ++i)
      samples.push_back(have_balls && !is_around[i] ? Sample{places[i] + Vector3(0, 0, 1), 1}
                                                    : Sample{places[i], 0});
    const Surface_quotient pieces = pieces_of(piece_of_patch, patches, samples);
    const auto joins_parts = [&](const Surface_quotient& trees) {
      CHECK(number_of_components(trees.graph) == 1);
      CHECK(number_of_cycles(trees.graph) == 0);
      const std::vector<Skeleton_graph::Edge>& edges = trees.graph.edges;
      const std::size_t a = trees.vertex_of_patch[0], b = trees.vertex_of_patch[part];
      return std::any_of(edges.begin(), edges.end(), [&](const Skeleton_graph::Edge& e) {
        return std::minmax(e.first, e.second) == std::minmax(a, b);
      });
    };
    const std::vector<bool> none = none_of(patches);
    CHECK(joins_parts(Path_trees(pieces, surfaces::surface_of(patches), samples, places, pairs,
                                 is_around, Concurrency::sequential)
                        .run()) == !have_balls);
    CHECK(joins_parts(with_line_trees(pieces, patches, samples, pairs, {is_around, none})) ==
          !have_balls);
  }
}

TEST_CASE("A tree of paths follows scattered points around a corner: their middle is in the air")
{
  // A grid in the form of an L, of 24 x 4 x 4 patches and another 4 x 24 x 4.
  constexpr int length = 24, width = 4;
  Patches patches;
  std::map<std::array<int, 3>, std::size_t> index;
  for(int x = 0; x < length; ++x)
    for(int y = 0; y < length; ++y)
      for(int z = 0; z < width && (x < width || y < width); ++z) {
        index[{x, y, z}] = patches.size();
        Patch patch;
        patch.mean = Vector3(x, y, z);
        patch.spacing = patch.weight = patch.area = 1;
        patches.push_back(patch);
      }
  for(const auto& [place, i] : index)
    for(std::size_t axis = 0; axis < 3; ++axis)
      for(int step : {-1, 1}) {
        std::array<int, 3> beside = place;
        beside[axis] += step;
        const auto found = index.find(beside);
        if(found != index.end())
          patches[i].neighbors.push_back(found->second);
      }
  Samples samples;
  for(Patch& patch : patches) {
    std::sort(patch.neighbors.begin(), patch.neighbors.end());
    samples.push_back({patch.mean, 0});
  }
  const Surface_quotient piece = one_piece(patches, samples);
  const auto distance = [&](const Vector3& p) { // of the nearest patch
    double result = std::numeric_limits<double>::infinity();
    for(const Patch& patch : patches)
      result = std::min(result, (patch.mean - p).norm());
    return result;
  };
  const Skeleton_graph tree =
    with_path_trees(piece, surfaces::surface_of(patches), samples, adjacent_pairs(patches),
                    std::vector<bool>(patches.size(), true), Concurrency::sequential)
      .graph;
  CHECK(number_of_components(tree) == 1);
  CHECK(number_of_cycles(tree) == 0);
  CHECK(distance(piece.graph.vertices[0].position) > 1);
  for(const Skeleton_graph::Vertex& vertex : tree.vertices)
    CHECK(distance(vertex.position) < 1);
  double length_of_path = 0; // from one end to the other
  for(const Skeleton_graph::Edge& e : tree.edges)
    length_of_path +=
      (tree.vertices[e.first].position - tree.vertices[e.second].position).norm();
  CHECK(number_of_ends(tree) < 5);
  CHECK(length_of_path > 1.5 * (length - width));
}

TEST_CASE("Trees of twigs have a vertex at each patch and close no cycle")
{
  for(const Tube& tube : {Tube{true, 30}, Tube{false, 30}}) {
    const Patches patches = tube.patches();
    const Surface_quotient quotient = quotient_of(tube, {4, 13, 22});
    const auto with_trees = [&](const std::vector<bool>& is_of_twig) {
      return with_line_trees(quotient, patches, surfaces::samples_of(patches),
                             adjacent_pairs(patches), {is_of_twig, none_of(patches)});
    };
    const Surface_quotient same = with_trees(std::vector<bool>(patches.size(), false));
    CHECK(same.graph.edges == quotient.graph.edges);
    // All pieces, or one of them: in a ring it is joined to the rest once.
    std::vector<bool> one(patches.size(), false);
    for(std::size_t i = 0; i < patches.size(); ++i)
      one[i] = quotient.vertex_of_patch[i] == quotient.vertex_of_patch[tube.index(8, 0)];
    for(const std::vector<bool>& is_of_twig : {std::vector<bool>(patches.size(), true), one}) {
      const Surface_quotient trees = with_trees(is_of_twig);
      CHECK(number_of_components(trees.graph) == 1);
      CHECK(number_of_cycles(trees.graph) == 0);
      for(std::size_t i = 0; i < patches.size(); ++i) {
        const std::size_t v = trees.vertex_of_patch[i];
        if(is_of_twig[i] && is_piece(quotient.vertex_of_patch[i], quotient)) {
          CHECK(trees.members[v] == std::vector<std::size_t>{i});
          CHECK(trees.graph.vertices[v].is_cross_section);
          CHECK(trees.graph.vertices[v].position == patches[i].mean); // not where its ball is
        }
      }
    }
  }
}

TEST_CASE("A piece that is mostly of twigs is single points but for other limbs, others are not")
{
  const Tube tube{false, 30};
  const Patches patches = tube.patches();
  const Surface_quotient quotient = quotient_of(tube, {4, 22});
  const std::size_t piece = quotient.vertex_of_patch[tube.index(12, 0)];
  const std::vector<std::size_t>& members = quotient.members[piece];
  const auto ring_of = [&](std::size_t i) { return i / tube.index(1, 0); };
  const auto number_alone = [&](bool are_twigs, std::size_t loose_ring) { // of every third ring
    std::vector<bool> is_of_twig(patches.size(), false), is_loose(patches.size(), false);
    for(const std::size_t i : members) {
      is_loose[i] = ring_of(i) == loose_ring;
      is_of_twig[i] = !is_loose[i] && (ring_of(i) % 3 == 0) == are_twigs;
    }
    const Surface_quotient trees =
      with_line_trees(quotient, patches, surfaces::samples_of(patches), adjacent_pairs(patches),
                      {is_of_twig, is_loose});
    CHECK(number_of_components(trees.graph) == 1);
    return std::count_if(members.begin(), members.end(), [&](std::size_t i) {
      return trees.members[trees.vertex_of_patch[i]].size() == 1;
    });
  };
  constexpr std::size_t no_ring = 0, ring_in_piece = 12;
  const auto all = static_cast<std::ptrdiff_t>(members.size());
  const auto around = static_cast<std::ptrdiff_t>(tube.index(1, 0));
  CHECK(number_alone(false, no_ring) == all); // two of three
  CHECK(number_alone(false, ring_in_piece) == all - around);
  const auto few = number_alone(true, no_ring); // one of three
  CHECK(few > 0);
  CHECK(2 * few < all);
}

TEST_CASE("The middle of samples is not drawn away by one that went astray")
{
  Samples samples;
  for(int k = 0; k < 20; ++k)
    samples.push_back({surfaces::around(2 * CGAL_PI * k / 20), 1});
  samples.push_back({Vector3(100, 0, 0), 1});
  std::vector<std::size_t> members(samples.size());
  for(std::size_t i = 0; i < members.size(); ++i)
    members[i] = i;
  CHECK(middle(members, Patches(samples.size()), samples).position.norm() < 0.2); // the mean is off by 5
}

TEST_CASE("The middle of samples is that of the surface, however finely it is divided")
{
  // A line of components, in its second half of four to a patch.
  Samples samples;
  Patches patches;
  for(double x = 0, length = 0; x < 20; x += length) {
    patches.emplace_back();
    patches.back().components = x < 10 ? 1 : 4;
    length = 0.25 * static_cast<double>(patches.back().components);
    samples.push_back({Vector3(x + length / 2, 0, 0), 1});
  }
  std::vector<std::size_t> members(samples.size());
  for(std::size_t i = 0; i < members.size(); ++i)
    members[i] = i;
  CHECK(middle(members, patches, samples, Average::mean).position.x() == Approx(10));
}

TEST_CASE("Components with next to no points are stray")
{
  constexpr double share = 0.01;
  Skeleton_graph graph;
  graph.vertices.resize(6);
  graph.edges = {{0, 1}, {1, 2}, {3, 4}};
  CHECK(stray_vertices(graph, {500, 400, 100, 2, 3, 11}, share) ==
        std::vector<bool>{false, false, false, true, true, false});
  CHECK(stray_vertices(graph, {0, 1, 0, 1, 0, 1}, share) == std::vector<bool>(6, false));
  CHECK(stray_vertices(Skeleton_graph(), {}, share).empty());
}

TEST_CASE("A bump is pruned, a limb stays")
{
  Made_up_quotient bump = two_limbs(), limb = two_limbs();
  const std::size_t plain = number_of_ends(two_limbs().pruned().graph);
  CHECK(plain == 2);
  bump.add_branch(0, Vector3(0.5, 0, 0), 2, 0.9); // hardly longer than half of its width
  limb.add_branch(0, Vector3(0.5, 0, 0), 15, 0.9);
  CHECK(number_of_ends(bump.quotient.graph) == 3);
  CHECK(number_of_ends(bump.pruned().graph) == 2);
  CHECK(number_of_ends(limb.pruned().graph) == 3);
  CHECK(is_path(bump.pruned().graph));
}

TEST_CASE("A long branch of a few patches is one of outliers")
{
  Made_up_quotient outliers = two_limbs();
  outliers.add_branch(0, Vector3(1, 0, 0), 3, 0.1, 1);
  CHECK(number_of_ends(outliers.quotient.graph) == 3);
  CHECK(number_of_ends(outliers.pruned().graph) == 2);
}

TEST_CASE("A bridge of a few patches between two limbs is taken off, one of a limb stays")
{
  for(const int ring : {1, 12}) {
    CAPTURE(ring);
    Made_up_quotient loop = two_limbs();
    const std::size_t end = loop.add_branch(4, Vector3(0.5, 0, -0.5), 3, 0.2, ring);
    loop.quotient.graph.edges.emplace_back(end, 14);
    const Skeleton_graph pruned = loop.pruned().graph;
    CHECK(number_of_components(pruned) == 1);
    CHECK(number_of_cycles(pruned) == (ring == 1 ? 0 : 1));
  }
}

TEST_CASE("Stray components go, and tell that they were stray")
{
  Made_up_quotient quotient = two_limbs();
  const std::size_t stray = quotient.add_vertex(Vector3(50, 0, 0), Vector3::UnitX(), 1, 1);
  const Pruned_quotient pruned = quotient.pruned();
  CHECK(number_of_components(pruned.graph) == 1);
  for(std::size_t v = 0; v < pruned.is_stray.size(); ++v)
    CHECK(pruned.is_stray[v] == (v == stray));
}

TEST_CASE("Caps go, but for those of a single cross-section")
{
  const std::size_t size = two_limbs().quotient.graph.vertices.size();
  CHECK(two_limbs().pruned().graph.vertices.size() == size);
  Made_up_quotient capped = two_limbs();
  for(const std::size_t end : {9u, 18u}) {
    const Vector3 tip = 1.1 * capped.quotient.graph.vertices[end].position;
    const std::size_t cap = capped.add_vertex(tip, tip, 1);
    capped.quotient.graph.edges.emplace_back(end, cap);
  }
  CHECK(capped.quotient.graph.vertices.size() == size + 2);
  CHECK(capped.pruned().graph.vertices.size() == size);

  Made_up_quotient single;
  const std::size_t first = single.add_vertex(Vector3::Zero(), Vector3::UnitZ(), 1);
  single.add_branch(first, Vector3::UnitZ(), 2, 1);
  CHECK(single.pruned().graph.vertices.size() == 3);
}

} // namespace quotient_test
