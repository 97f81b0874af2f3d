// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Separators of a torus and of a tube: rings of patches that regions find, and that paths, closed
// curves and the balls of patches tell from arcs; and of sheets: arcs from border to border.

#include "surface_of.h"

#include "catch2.h"
#include "generator/Random.h"
#include "threads.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Ball_overlaps.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Closed_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Growing_region.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Path_search.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Separator_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/bounds_solid.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/choose_separators.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/local_separators.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace separators_test {

using namespace CGAL::Point_set_skeletonization_3::internal;
using surfaces::across;
using surfaces::around;
using surfaces::ring_radius;
using surfaces::surface_of;

namespace {

const Separator_options options;

Patch_graph graph_of(const Patches& patches)
{
  return Patch_graph(patches, adjacent_pairs(patches));
}

Ball_overlaps overlaps_of(const Surface& surface, const Samples& samples, double unknown = 0)
{
  return Ball_overlaps(surface, samples, unknown, options.overlap, Concurrency::sequential);
}

// Patches of a flat sheet, on a lattice without some places.
Patches sheet(int length, int width,
              const std::function<bool(int, int)>& is_hole = [](int, int) { return false; })
{
  std::map<std::pair<int, int>, std::size_t> index;
  for(int i = 0; i < length; ++i)
    for(int j = 0; j < width; ++j)
      if(!is_hole(i, j))
        index.emplace(std::make_pair(i, j), index.size());
  Patches patches;
  for(const auto& entry : index) {
    const auto [i, j] = entry.first;
    Patch patch;
    patch.mean = Vector3(i, j, 0);
    patch.spacing = patch.weight = patch.area = patch.planarity = 1;
    for(const auto& beside : {std::make_pair(i - 1, j), std::make_pair(i, j - 1),
                              std::make_pair(i, j + 1), std::make_pair(i + 1, j)})
      if(index.count(beside) > 0)
        patch.neighbors.push_back(index[beside]);
    patches.push_back(patch);
  }
  return patches;
}

// Patches of a square sheet at random places of the squares of a lattice, each adjacent to its
// seven nearest and to those whose nearest it is.
Patches irregular_sheet(int width, unsigned int seed)
{
  constexpr std::size_t nearest = 7;
  shapes::Random random(seed);
  Patches patches;
  std::vector<Vector3> places;
  for(int i = 0; i < width; ++i)
    for(int j = 0; j < width; ++j) {
      const double x = random.uniform(-0.5, 0.5), y = random.uniform(-0.5, 0.5);
      Patch patch;
      patch.mean = Vector3(i + x, j + y, 0);
      patch.spacing = patch.weight = patch.area = patch.planarity = 1;
      patches.push_back(patch);
      places.push_back(patch.mean);
    }
  std::vector<std::set<std::size_t>> adjacent(patches.size());
  const Box_tree tree(places);
  for(std::size_t i = 0; i < patches.size(); ++i) {
    std::vector<std::pair<double, std::size_t>> others;
    tree.visit_within(places[i], 5, [&](std::size_t k, double) {
      const std::size_t j = tree.order()[k];
      if(j != i)
        others.emplace_back((places[i] - places[j]).norm(), j);
    });
    std::sort(others.begin(), others.end());
    others.resize(nearest);
    for(const auto& other : others) {
      adjacent[i].insert(other.second);
      adjacent[other.second].insert(i);
    }
  }
  for(std::size_t i = 0; i < patches.size(); ++i)
    patches[i].neighbors.assign(adjacent[i].begin(), adjacent[i].end());
  return patches;
}

// Samples of patches whose other side was not seen.
Samples samples_on(const Patches& patches)
{
  Samples samples;
  for(const Patch& patch : patches)
    samples.push_back({patch.mean, 0});
  return samples;
}

// Curves in the solid torus.
class Solid_torus
{
public:
  Closed_curve curve(const std::vector<Vector3>& points) const
  {
    return Closed_curve(points, surface_.patches.front().spacing, surface_);
  }

  bool is_contractible(const std::vector<Vector3>& points) const
  {
    return curve(points).is_contractible();
  }

private:
  Surface surface_ = surface_of(surfaces::torus.patches());
};

// A part of the torus along a circle in its plane, from one angle to another.
std::vector<Vector3> arc(double radius, double from, double to)
{
  std::vector<Vector3> result;
  for(int i = 0; i < 20; ++i)
    result.push_back(radius * around(from + i * (to - from) / 20));
  return result;
}

std::vector<Vector3> there_and_back(const std::vector<Vector3>& there,
                                    const std::vector<Vector3>& back)
{
  std::vector<Vector3> result = there;
  result.insert(result.end(), back.rbegin(), back.rend());
  return result;
}

// The patches of a tube in the `j`-th row along it, all around the torus.
std::vector<std::size_t> loop_along(int j, bool backwards = false)
{
  std::vector<std::size_t> result;
  for(int i = 0; i < surfaces::torus.along; ++i)
    result.push_back(surfaces::torus.index(i, j));
  if(backwards)
    std::reverse(result.begin(), result.end());
  return result;
}

// Whether what is left without some patches hangs together, as far as patches next to those go.
std::size_t pieces_without(const Patches& patches, const std::vector<std::size_t>& removed)
{
  Union_find sets(patches.size());
  std::vector<bool> is_removed(patches.size(), false);
  for(std::size_t i : removed)
    is_removed[i] = true;
  std::set<std::size_t> pieces;
  for(std::size_t i = 0; i < patches.size(); ++i)
    for(std::size_t j : patches[i].neighbors)
      if(!is_removed[i] && !is_removed[j])
        sets.join(i, j);
  for(std::size_t i = 0; i < patches.size(); ++i)
    if(!is_removed[i])
      pieces.insert(sets.find(i));
  return pieces.size();
}

} // namespace

TEST_CASE("A closed curve around the hole of a torus is not contractible")
{
  std::vector<Vector3> curve;
  for(int i = 0; i < 20; ++i)
    curve.push_back((ring_radius + (i % 2 == 0 ? 0.1 : -0.1)) * around(2 * CGAL_PI * i / 20));
  CHECK_FALSE(Solid_torus().is_contractible(curve));
}

TEST_CASE("A closed curve that goes there and back in a bent limb is contractible")
{
  CHECK(Solid_torus().is_contractible(there_and_back(arc(ring_radius + 0.1, 0, 1.5 * CGAL_PI),
                                                     arc(ring_radius - 0.1, 0, 1.5 * CGAL_PI))));
}

TEST_CASE("A closed curve is solid if all of it is in the solid")
{
  const Solid_torus solid;
  CHECK(solid.curve(arc(ring_radius, 0, 2 * CGAL_PI)).is_solid());
  CHECK_FALSE(solid.curve(arc(ring_radius, 0, CGAL_PI)).is_solid()); // closed through the hole
}

TEST_CASE("A closed curve can be moved onto one that goes around as often, wherever that starts")
{
  const Solid_torus solid;
  const Closed_curve curve = solid.curve(arc(ring_radius, 0, 2 * CGAL_PI));
  CHECK(curve.can_be_moved_onto(curve));
  CHECK(curve.can_be_moved_onto(solid.curve(arc(ring_radius + 0.1, 1, 1 + 2 * CGAL_PI))));
  CHECK(curve.can_be_moved_onto(solid.curve(arc(ring_radius - 0.1, 2, 2 - 2 * CGAL_PI))));
  const std::vector<Vector3> bent = arc(ring_radius, 0, 1.5 * CGAL_PI);
  CHECK_FALSE(curve.can_be_moved_onto(solid.curve(there_and_back(bent, bent))));
}

TEST_CASE("A closed curve is along one that goes around as often within half a resolution")
{
  const Solid_torus solid;
  const double near = 0.25 * surfaces::torus.patches().front().spacing;
  const Closed_curve curve = solid.curve(arc(ring_radius, 0, 2 * CGAL_PI));
  CHECK(curve.is_along(solid.curve(arc(ring_radius + near, 1, 1 + 2 * CGAL_PI))));
  CHECK(curve.is_along(solid.curve(arc(ring_radius - near, 2, 2 - 2 * CGAL_PI))));
  CHECK_FALSE(curve.is_along(solid.curve(arc(ring_radius + 4 * near, 0, 2 * CGAL_PI))));
  const std::vector<Vector3> around = arc(ring_radius, 0, 2 * CGAL_PI);
  CHECK_FALSE(curve.is_along(solid.curve(there_and_back(around, around))));
  CHECK_FALSE(solid.curve(there_and_back(around, around)).is_along(curve));
}

TEST_CASE("A path around an arc is short, that around a ring of a torus goes around the hole")
{
  const Patches patches = surfaces::torus.patches();
  const Patch_graph graph = graph_of(patches);
  Path_search search(patches, graph);
  for(int round = 0; round < 2; ++round) { // one object may be asked again
    const Path_search::Path short_path = search.around(surfaces::torus.separator(10, 0, 4));
    CHECK(short_path.size() <= 8);
    const Path_search::Path long_path = search.around(surfaces::torus.separator(10));
    CHECK(long_path.size() >= static_cast<std::size_t>(surfaces::torus.along) - 3);
    for(std::size_t k = 1; k < long_path.size(); ++k) {
      const std::vector<std::size_t>& neighbors = patches[long_path[k]].neighbors;
      REQUIRE(std::binary_search(neighbors.begin(), neighbors.end(), long_path[k - 1]));
    }
    const Path_search::Path closed = search.closed(long_path, surfaces::torus.separator(10));
    CHECK(search.algebraic_intersection_number(closed, surfaces::torus.separator(10)) != 0);
    CHECK(search.algebraic_intersection_number(closed, surfaces::torus.separator(40)) != 0);
  }
}

TEST_CASE("There is no path around a ring of a tube")
{
  const Patches patches = surfaces::tube.patches();
  const Patch_graph graph = graph_of(patches);
  CHECK(Path_search(patches, graph).around(surfaces::tube.separator(15)).empty());
}

TEST_CASE("A loop along a torus crosses each ring once, and in which direction it goes shows")
{
  const Patches patches = surfaces::torus.patches();
  const Patch_graph graph = graph_of(patches);
  Path_search search(patches, graph);
  for(const int i : {3, 30}) {
    const Local_separator ring = surfaces::torus.separator(i);
    CHECK(search.algebraic_intersection_number(loop_along(0), ring) == 1);
    CHECK(search.algebraic_intersection_number(loop_along(7, true), ring) == -1);
    const Local_separator other = surfaces::torus.separator(i + 9);
    CHECK(search.algebraic_intersection_number(ring.patches, other) == 0);
  }
}

TEST_CASE("Overlap of balls: whole within a limb, none between limbs that touch")
{
  CHECK(relative_overlap(1, 1, 0) == 1);
  CHECK(relative_overlap(1, 1, 0.1) > 0.99);
  CHECK(relative_overlap(1, 1, 2) == 0);
  CHECK(relative_overlap(1, 1, 50) == 0);
  // A small limb that leaves a large one.
  CHECK(relative_overlap(1, 0.1, 0.9) == 1);
  // The circle where two unit balls at distance d meet has the radius sqrt(1 - d^2 / 4).
  CHECK(relative_overlap(1, 1, 1.6) == Approx(0.6));
}

TEST_CASE("Balls are as near as across the limb if its patches are longer than it is wide")
{
  const Medial_ball ball{Vector3::Zero(), 1, Vector3(0, 0, 1)}; // of a patch below it
  Patch here, there;
  here.mean = ball.center - ball.offset;
  const auto distance = [&](const Vector3& center, const Vector3& offset) {
    there.mean = center - offset;
    return distance_in_limb(here, ball, there, {center, 1, offset});
  };
  const Vector3 beside(0, 1, 0);
  CHECK(distance(Vector3(3, 0, 0), beside) == Approx(0).margin(1e-9)); // along the limb
  CHECK(distance(Vector3(3, 0.5, 0), beside) == Approx(0.5));          // and a bit across it
  CHECK(distance(Vector3(0.9, 0, 0), beside) == Approx(0.9));          // patches are short
  CHECK(distance(Vector3(0, 2, 0), Vector3(0, -1, 0)) == Approx(2));   // two limbs that touch
}

TEST_CASE("Patches longer than a limb is wide are in one limb, those of limbs that touch are not")
{
  constexpr double length = 3; // of patches along limbs of radius 1
  constexpr std::size_t around = 6, along = 4, limb = along * around;
  Patches patches;
  Samples samples;
  for(const Vector3& begin : {Vector3(0, 0, 0), Vector3(length / 2, 2.2, 0)}) // nearly touching
    for(std::size_t k = 0; k < limb; ++k) {
      const double angle = 2 * CGAL_PI * static_cast<double>(k % around) / around;
      const Vector3 axis = begin + length * static_cast<double>(k / around) * Vector3::UnitX();
      Patch patch;
      patch.normal = Vector3(0, std::cos(angle), std::sin(angle));
      patch.mean = axis + patch.normal;
      patch.spacing = length / 2;
      patch.weight = patch.area = 1;
      patches.push_back(patch);
      const bool is_at_gap = k % (around / 2) == 0;
      if(is_at_gap || k / around != 1)
        samples.push_back({axis, 1});
      else // it takes a ball from beside
        samples.push_back({patch.mean, 0});
    }
  const auto are_of_one_limb = [](std::size_t i, std::size_t j) { return i / limb == j / limb; };
  for(std::size_t i = 0; i < patches.size(); ++i)
    for(std::size_t j = 0; j < patches.size(); ++j) {
      constexpr double along_limb = 1.1 * length, across_gap = 0.6 * length;
      const double distance = (patches[i].mean - patches[j].mean).norm();
      if(i != j && distance < (are_of_one_limb(i, j) ? along_limb : across_gap))
        patches[i].neighbors.push_back(j);
    }
  const Ball_overlaps overlaps = overlaps_of(surface_of(patches), samples);
  Union_find joined(patches.size());
  std::size_t between = 0;
  for(std::size_t k = 0; k < overlaps.pairs().size(); ++k) {
    const auto [a, b] = overlaps.pairs()[k];
    if(overlaps.are_in_one_limb(k))
      joined.join(a, b);
    between += are_of_one_limb(a, b) ? 0 : 1;
  }
  CHECK(between > 0);
  for(std::size_t i = 0; i < patches.size(); ++i) {
    CAPTURE(i);
    CHECK(joined.find(i) == joined.find(i / limb * limb));
  }
  CHECK(joined.find(0) != joined.find(limb));
}

TEST_CASE("A ball moves along the surface that it was found at until it touches a place")
{
  const Medial_ball ball{Vector3(1, 2, 3), 2, Vector3(0, 0, 2)}; // its surface is below
  const auto center = [&](const Vector3& place) -> Vector3 {
    return moved_to_touch(ball, ball.center + place).center - ball.center;
  };
  CHECK(center(Vector3(0.5, 1, -1)) == Vector3::Zero()); // it touches
  CHECK((center(Vector3(7, 0, -2)) - Vector3(7, 0, 0)).norm() < 1e-12);   // along a limb,
  CHECK((center(Vector3(0, -7, 2)) - Vector3(0, -7, 0)).norm() < 1e-12);  // also opposite,
  CHECK((center(Vector3(7, 0, 0)) - Vector3(5, 0, 0)).norm() < 1e-12);    // beside it
  CHECK((center(Vector3(0, 0, -5)) - Vector3(0, 0, -3)).norm() < 1e-12);  // below the surface
  for(const Vector3& place : {Vector3(7, 1, -3), Vector3(2, 5, 1.5), Vector3(-3, 0, 4)})
    CHECK((place - center(place)).norm() == Approx(ball.radius));
}

TEST_CASE("Balls guessed from both ends of what is unknown of a limb overlap")
{
  constexpr double length = 1.5; // of patches along a limb of radius 1
  constexpr std::size_t around = 6, along = 6;
  Patches patches;
  Samples samples;
  for(std::size_t k = 0; k < along * around; ++k) {
    const double angle = 2 * CGAL_PI * static_cast<double>(k % around) / around;
    const Vector3 axis = length * static_cast<double>(k / around) * Vector3::UnitX();
    Patch patch;
    patch.normal = Vector3(0, std::cos(angle), std::sin(angle));
    patch.mean = axis + patch.normal;
    patch.spacing = length;
    patch.weight = patch.area = 1;
    patches.push_back(patch);
    const Vector3 off_axis = k / around < along / 2 ? Vector3(0, 0, 0.2) : Vector3(0, 0, -0.2);
    const bool is_known = k / around < 2 || k / around >= along - 2;
    samples.push_back(is_known ? Sample{axis + off_axis, 1} : Sample{patch.mean, 0});
  }
  for(std::size_t i = 0; i < patches.size(); ++i)
    for(std::size_t j = 0; j < patches.size(); ++j)
      if(i != j && (patches[i].mean - patches[j].mean).norm() < 1.1 * length)
        patches[i].neighbors.push_back(j);
  const Ball_overlaps overlaps = overlaps_of(surface_of(patches), samples);
  for(std::size_t k = 0; k < overlaps.pairs().size(); ++k) {
    CAPTURE(overlaps.pairs()[k].a, overlaps.pairs()[k].b);
    CHECK(overlaps.are_in_one_limb(k));
  }
}

TEST_CASE("In one limb all balls overlap, and an unknown one at least as one is told")
{
  const Surface surface = surface_of(surfaces::tube.patches());
  const Patches& patches = surface.patches;
  Samples samples = surfaces::samples_of(patches);
  const Ball_overlaps overlaps = overlaps_of(surface, samples);
  REQUIRE(overlaps.pairs().size() == adjacent_pairs(patches).size());
  for(std::size_t k = 0; k < overlaps.pairs().size(); ++k)
    REQUIRE(overlaps.are_in_one_limb(k));
  for(std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = {patches[i].mean, 0};
  for(const double unknown : {0.0, 1.0}) {
    const Ball_overlaps nothing = overlaps_of(surface, samples, unknown);
    for(std::size_t k = 0; k < nothing.pairs().size(); ++k)
      REQUIRE(nothing[k] == (std::max)(unknown, coplanarity(patches[nothing.pairs()[k].a],
                                                           patches[nothing.pairs()[k].b])));
  }
}

TEST_CASE("The separator of a region in a tube is a ring around it")
{
  const Patches patches = surfaces::tube.patches();
  const Samples samples = surfaces::samples_of(patches);
  const Patch_graph graph = graph_of(patches);
  Growing_region region(patches, graph, samples, options);
  for(const int i : {10, 15, 19})
    for(const int j : {0, 7}) {
      CAPTURE(i, j);
      const Local_separator separator = region.grow_from(surfaces::tube.index(i, j)).separator;
      REQUIRE(!separator.patches.empty());
      CHECK(pieces_without(patches, separator.patches) == 2);
      std::set<int> rows; // all around
      double middle = 0;
      for(std::size_t patch : separator.patches) {
        rows.insert(static_cast<int>(patch) % across);
        middle += static_cast<double>(patch / across);
      }
      CHECK(rows.size() == across);
      CHECK(middle / static_cast<double>(separator.patches.size()) == Approx(i).margin(1.5));
      // What is beside it belongs to it neither, and is on its side.
      for(std::size_t side = 0; side < 2; ++side)
        for(std::size_t patch : separator.sides[side]) {
          REQUIRE(!std::binary_search(separator.patches.begin(), separator.patches.end(), patch));
          const auto& other = separator.sides[1 - side];
          REQUIRE(!std::binary_search(other.begin(), other.end(), patch));
        }
    }
}

TEST_CASE("A region that meets no limb has no separator")
{
  // A flat sheet, whose samples have a radius: they are in a flat solid.
  const Patches patches = sheet(30, 30);
  Samples samples;
  for(const Patch& patch : patches)
    samples.push_back({patch.mean, 1});
  const Patch_graph graph = graph_of(patches);
  Growing_region region(patches, graph, samples, options);
  CHECK(region.grow_from(15 * 30 + 15).separator.patches.empty());
}

TEST_CASE("In a wide solid of irregular patches no front splits by chance")
{
  // Where a front has gaps: its patches are not all adjacent.
  const unsigned int seed = GENERATE(1u, 2u, 3u);
  CAPTURE(seed);
  constexpr int width = 40, margin = 10; // the flattest limb is nine times as wide as thick
  const Patches patches = irregular_sheet(width, seed);
  Samples samples;
  for(const Patch& patch : patches)
    samples.push_back({patch.mean - Vector3(0, 0, 1), 1});
  const Patch_graph graph = graph_of(patches);
  Growing_region region(patches, graph, samples, options);
  int split = 0, tried = 0;
  for(int i = margin; i < width - margin; ++i)
    for(int j = margin; j < width - margin; ++j, ++tried)
      split += region.grow_from(static_cast<std::size_t>(i * width + j)).separator.patches.empty()
                 ? 0
                 : 1;
  CHECK(100 * split < tried);
}

TEST_CASE("A separator of a sheet leads from border to border, however wide it is")
{
  for(const int width : {5, 30}) {
    CAPTURE(width);
    const int length = 4 * width;
    const Patches patches = sheet(length, width);
    const Samples samples = samples_on(patches);
    const Patch_graph graph = graph_of(patches);
    Growing_region region(patches, graph, samples, options);
    const auto middle = static_cast<std::size_t>(length / 2 * width + width / 2);
    const Local_separator separator = region.grow_from(middle).separator;
    std::set<std::size_t> rows;
    for(std::size_t i : separator.patches)
      rows.insert(i % static_cast<std::size_t>(width));
    CHECK(rows.size() == static_cast<std::size_t>(width));
    CHECK(pieces_without(patches, separator.patches) == 2);
  }
}

TEST_CASE("A narrow hole of a sheet may be one of the data, a wide one is not")
{
  constexpr int length = 60, width = 31;
  const auto is_chosen = [&](int half_width, bool fills_gaps) {
    // A hole in the middle, 20 long. From there a separator leads to one border.
    const Patches patches = sheet(length, width, [&](int i, int j) {
      return std::abs(i - length / 2) <= 10 && std::abs(j - width / 2) <= half_width;
    });
    const Surface surface = surface_of(patches);
    const Samples samples = samples_on(surface.patches);
    Local_separator separator;
    for(std::size_t i = 0; i < patches.size(); ++i) {
      const Vector3& p = patches[i].mean;
      if(p.y() >= width / 2 || std::abs(p.x() - length / 2) > 1)
        continue;
      if(p.x() == length / 2) {
        separator.patches.push_back(i);
        separator.length += 1;
      } else
        separator.sides[p.x() < length / 2 ? 0 : 1].push_back(i);
    }
    const Patch_graph graph = graph_of(patches);
    return Separator_choice({}, surface, samples, graph, fills_gaps, options,
                            Concurrency::sequential)
      .cuts_limb(separator);
  };
  CHECK(is_chosen(1, false));
  CHECK(!is_chosen(1, true));
  CHECK(is_chosen(9, true)); // beside a bar, a third as wide as the opening
  CHECK(is_chosen(14, true)); // one patch to the border
}

TEST_CASE("Coplanar patches without balls overlap, others do not")
{
  Patches patches = sheet(2, 3);
  const auto number_in_one_limb = [&] {
    const Surface surface = surface_of(patches);
    const Ball_overlaps overlaps = overlaps_of(surface, samples_on(patches));
    CHECK(overlaps.has_unknown());
    std::size_t result = 0;
    for(std::size_t k = 0; k < overlaps.pairs().size(); ++k)
      result += overlaps.are_in_one_limb(k) ? 1 : 0;
    return result;
  };
  CHECK(number_in_one_limb() == 7);
  for(std::size_t i : {0, 1, 2})
    patches[i].normal = Vector3::UnitX(); // folded
  CHECK(number_in_one_limb() == 4);
  for(Patch& patch : patches)
    patch.planarity = 0.5; // scattered
  CHECK(number_in_one_limb() == 0);
}

TEST_CASE("Rings around limbs and sheets bound solid, those around the walls of a pipe do not")
{
  // A ring of patches with a radius, whose samples are `inwards` of them.
  const auto bounds = [](double radius, double inwards) {
    Patches patches;
    Samples samples;
    Local_separator ring;
    for(int j = 0; j < across; ++j) {
      const Vector3 outwards = around(2 * CGAL_PI * j / across);
      Patch patch;
      patch.mean = radius * outwards;
      patch.spacing = 2 * CGAL_PI * radius / across;
      patches.push_back(patch);
      samples.push_back({(radius - inwards) * outwards, std::abs(inwards)});
      ring.patches.push_back(ring.patches.size());
    }
    return bounds_solid(ring, patches, samples);
  };
  CHECK(bounds(1, 1)); // a round limb
  CHECK(bounds(1, 0.7)); // off its axis
  CHECK(bounds(1, 0)); // a sheet
  for(double thickness : {0.1, 0.3}) { // of a wall
    CAPTURE(thickness);
    CHECK_FALSE(bounds(1, thickness / 2));
    CHECK_FALSE(bounds(1 - thickness, -thickness / 2));
  }

  // A flat limb, 10 times as wide as thick.
  Patches patches;
  Samples samples;
  Local_separator ring;
  for(int j = 0; j < 20; ++j)
    for(double side : {-1., 1.}) {
      Patch patch;
      patch.mean = Vector3(j, 0, side);
      patch.spacing = 1;
      patches.push_back(patch);
      samples.push_back({Vector3(j, 0, 0), 1});
      ring.patches.push_back(ring.patches.size());
    }
  CHECK(bounds_solid(ring, patches, samples));
}

TEST_CASE("A ring around a limb is chosen, an arc of it is not")
{
  const Surface surface = surface_of(surfaces::torus.patches());
  const Samples samples = surfaces::samples_of(surface.patches);
  const Patch_graph graph = graph_of(surface.patches);
  const auto number_chosen = [&](const std::vector<Local_separator>& candidates) {
    return Separator_choice(candidates, surface, samples, graph, false, options,
                            Concurrency::sequential)
      .run()
      .size();
  };
  CHECK(number_chosen({surfaces::torus.separator(10, 0, across / 2)}) == 0);
  CHECK(number_chosen({surfaces::torus.separator(10)}) == 1);
  CHECK(number_chosen({surfaces::torus.separator(10), surfaces::torus.separator(30)}) == 2);
  CHECK(number_chosen({surfaces::torus.separator(10), surfaces::torus.separator(10)}) == 1);
  CHECK(number_chosen({surfaces::torus.separator(30, 3, across - 3),
                       surfaces::torus.separator(10)}) == 1);
}

TEST_CASE("A torus is cut all around, in disjoint rings, by any number of threads")
{
  const Surface surface = surface_of(surfaces::torus.patches());
  const Samples samples = surfaces::samples_of(surface.patches);
  const Ball_overlaps overlaps = overlaps_of(surface, samples);
  const auto separators = [&](Concurrency concurrency) {
    return local_separators(
      separator_candidates(surface, samples, overlaps.pairs(), options, concurrency), surface,
      samples, overlaps, false, options, concurrency);
  };
  const std::vector<Local_separator> expected = separators(Concurrency::sequential);
  CHECK(expected.size() >= 3);
  std::set<std::size_t> used;
  for(const Local_separator& separator : expected) {
    CHECK(pieces_without(surface.patches, separator.patches) == 1); // a torus stays in one piece
    for(std::size_t i : separator.patches)
      CHECK(used.insert(i).second);
  }
  for_threads([&](Concurrency concurrency) {
    const std::vector<Local_separator> found = separators(concurrency);
    REQUIRE(found.size() == expected.size());
    for(std::size_t s = 0; s < found.size(); ++s) {
      CHECK(found[s].patches == expected[s].patches);
      CHECK(found[s].sides == expected[s].sides);
    }
  });
}

} // namespace separators_test
