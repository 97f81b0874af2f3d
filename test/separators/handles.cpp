// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Closed paths that cannot be shrunk on a surface, and the rings that cut handles there.

#include "surface_of.h"

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/separators/Ball_overlaps.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Local_separator.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Separator_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Surface_loops.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/local_separators.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Shortest_paths.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace handles_test {

using namespace CGAL::Point_set_skeletonization_3::internal;
using surfaces::across;
using surfaces::Tube;

namespace {

const Separator_options options;

// The patches of a tube, with a diagonal in each quadrilateral of the grid.
Patches triangulated(const Tube& tube)
{
  Patches result = tube.patches();
  for(int i = 0; i < tube.along; ++i)
    for(int j = 0; j < across; ++j) {
      if(!tube.is_closed && i + 1 == tube.along)
        continue;
      const std::size_t a = tube.index(i, j), b = tube.index(i + 1, j + 1);
      result[a].neighbors.push_back(b);
      result[b].neighbors.push_back(a);
    }
  for(Patch& patch : result)
    std::sort(patch.neighbors.begin(), patch.neighbors.end());
  return result;
}

int number_of_rings(const std::vector<std::size_t>& patches)
{
  std::set<std::size_t> rings;
  for(std::size_t i : patches)
    rings.insert(i / across);
  return static_cast<int>(rings.size());
}

// How many places around the axis of a tube some patches are at.
int number_around(const std::vector<std::size_t>& patches)
{
  std::set<std::size_t> places;
  for(std::size_t i : patches)
    places.insert(i % across);
  return static_cast<int>(places.size());
}

bool is_closed_path(const Surface_loops::Path& path, const Patches& patches)
{
  for(std::size_t k = 0; k < path.size(); ++k) {
    const std::vector<std::size_t>& neighbors = patches[path[k]].neighbors;
    if(!std::binary_search(neighbors.begin(), neighbors.end(), path[(k + 1) % path.size()]))
      return false;
  }
  return true;
}

// The rings around handles of a tube, some rings of which are separators already.
std::vector<Local_separator> handle_separators(const Tube& tube, const std::vector<int>& rings,
                                               const Samples* others = nullptr)
{
  const Surface surface = surfaces::surface_of(triangulated(tube));
  const Samples samples = others ? *others : surfaces::samples_of(surface.patches);
  const Ball_overlaps overlaps(surface, samples, 1, options.overlap, Concurrency::sequential);
  std::vector<Local_separator> candidates;
  for(int ring : rings)
    candidates.push_back(tube.separator(ring));
  std::vector<Local_separator> result = local_separators(
    candidates, surface, samples, overlaps, false, options, Concurrency::sequential);
  REQUIRE(result.size() >= rings.size());
  result.erase(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(rings.size()));
  return result;
}

} // namespace

TEST_CASE("Shortest paths on a tube are those on the plane that it unrolls to")
{
  const Tube& tube = surfaces::tube;
  const Patches patches = tube.patches();
  const Patch_graph graph(patches, adjacent_pairs(patches));
  const double spacing = patches.front().spacing; // along; around, the chord is a little less
  Shortest_paths paths(graph, patches.size());
  for(int start : {3, 20}) { // the second search forgets the first
    const std::vector<std::size_t> order =
      paths.spread({{0., tube.index(start, 0)}},
                   [&](std::size_t i) { return i / across <= 20; });
    CHECK(order.size() == 21 * across);
    for(std::size_t k = 0; k + 1 < order.size(); ++k)
      CHECK(paths.distance(order[k]) <= paths.distance(order[k + 1]));
    for(int j : {0, 5, across / 2})
      CHECK(std::abs(paths.distance(tube.index(10, j)) -
                     spacing * (std::abs(10 - start) + j)) < 0.02 * spacing * (1 + j));
    CHECK(!paths.is_reached(tube.index(21, 0)));
    CHECK(paths.before(tube.index(start, 0)) == Shortest_paths::none);
  }
}

TEST_CASE("Closed paths that cannot be shrunk: none on a sheet, one on a tube, two on a torus")
{
  const auto loops = [](const Tube& tube, const auto& is_inside) {
    const Patches patches = triangulated(tube);
    const Patch_graph graph(patches, adjacent_pairs(patches));
    const std::vector<Surface_loops::Path> result =
      Surface_loops(graph, patches.size()).through(tube.index(3, 4), is_inside);
    for(const Surface_loops::Path& path : result)
      CHECK(is_closed_path(path, patches));
    return result;
  };
  const auto everywhere = [](std::size_t) { return true; };
  CHECK(loops(surfaces::tube, [](std::size_t i) { return i % across != 0; }).empty()); // slit
  const std::vector<Surface_loops::Path> on_tube = loops(surfaces::tube, everywhere);
  REQUIRE(on_tube.size() == 1);
  CHECK(on_tube[0].size() == across);
  CHECK(number_around(on_tube[0]) == across);
  const std::vector<Surface_loops::Path> on_torus = loops(surfaces::torus, everywhere);
  REQUIRE(on_torus.size() >= 2); // and what goes around both
  CHECK(on_torus[0].size() == across);
  CHECK(number_around(on_torus[0]) == across);
  CHECK(number_of_rings(on_torus[1]) == surfaces::torus.along);
}

TEST_CASE("A handle that no separator cuts gets a ring around the limb")
{
  const std::vector<Local_separator> rings = handle_separators(surfaces::torus, {});
  REQUIRE(rings.size() == 1);
  CHECK(number_around(rings[0].patches) == across);
  CHECK(number_of_rings(rings[0].patches) < 10); // of 60
  CHECK(handle_separators(surfaces::torus, {10}).empty());
  CHECK(handle_separators(surfaces::torus, {10, 40}).empty());
  CHECK(handle_separators(surfaces::tube, {}).empty());
  CHECK(handle_separators(surfaces::tube, {10}).empty());
}

TEST_CASE("What encloses no solid has no handle")
{
  Samples on_surface;
  for(const Vector3& mean : surfaces::means_of(surfaces::torus.patches()))
    on_surface.push_back({mean, 0});
  CHECK(handle_separators(surfaces::torus, {}, &on_surface).empty());
}

} // namespace handles_test
