// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A representative part of `quality generated` (see benchmark/README.md): shapes whose skeleton is
// known, as a scanner sees them.

#include "Point_tree.h"
#include "axis_distance.h"
#include "catch2.h"
#include "generator/Random.h"
#include "generator/clouds.h"
#include "generator/families.h"
#include "generator/scanned_families.h"
#include "generator/scanner.h"
#include "graph_counts.h"
#include "inside_share.h"
#include "share_within.h"
#include "skeleton_checks.h"
#include "spurs.h"

#include <CGAL/Iterator_range.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/extract_l1_medial_skeleton.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace scanned_shapes_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using shapes::Variant;

namespace {

constexpr std::size_t number_of_points = 10000;

Skeleton skeleton_of(const shapes::Known_shape& shape, Variant variant)
{
  std::vector<Kernel::Point_3> points;
  for(const shapes::Vector& p : shapes::sample(shape, variant, number_of_points, shape.seed))
    points.emplace_back(p.x(), p.y(), p.z());
  Skeleton skeleton;
  REQUIRE(CGAL::extract_l1_medial_skeleton(points, skeleton));
  check_valid(skeleton, points.size());
  return skeleton;
}

void check_counts(const Skeleton& skeleton, const shapes::Known_shape& shape)
{
  const Graph_counts counts = count_graph(skeleton);
  CHECK(counts.components == shape.components);
  CHECK(counts.cycles == shape.cycles);
  CHECK(counts.ends == shape.ends);
  CHECK(metrics::count_spurs(skeleton) == 0);
}

// The mean distance to the true axis, in local radii.
void check_centred(const Skeleton& skeleton, const shapes::Known_shape& shape, double bound)
{
  CHECK(metrics::axis_distance(skeleton, shape.axis, shape.junctions).mean < bound);
}

void check_inside(const Skeleton& skeleton, const shapes::Known_shape& shape)
{
  const auto inside = [&shape](const metrics::Point& p) {
    return shape.solid.signed_distance({p.x(), p.y(), p.z()}) <= 0;
  };
  constexpr double step = 0.002; // the shapes have a size of about one
  CHECK(metrics::inside_share(skeleton, inside, step) == 1);
}

std::vector<Kernel::Point_3> to_points(const std::vector<shapes::Vector>& cloud)
{
  std::vector<Kernel::Point_3> points;
  for(const shapes::Vector& p : cloud)
    points.emplace_back(p.x(), p.y(), p.z());
  return points;
}

Skeleton skeleton_of(const std::vector<Kernel::Point_3>& points)
{
  Skeleton skeleton;
  REQUIRE(CGAL::extract_l1_medial_skeleton(points, skeleton));
  return skeleton;
}

/// Of the true axis as far as it has points within 1.5 % of the diagonal, the share that has the
/// skeleton as near.
double share_found(const shapes::Known_shape& shape, const Skeleton& skeleton,
                   const std::vector<Kernel::Point_3>& points)
{
  Skeleton axis;
  for(const shapes::Axis_segment& piece : shape.axis) {
    const auto a = add_vertex(axis), b = add_vertex(axis);
    axis[a].point = Kernel::Point_3(piece.a.x(), piece.a.y(), piece.a.z());
    axis[b].point = Kernel::Point_3(piece.b.x(), piece.b.y(), piece.b.z());
    add_edge(a, b, axis);
  }
  const double near = 0.015 * shapes::bounding_box(shape).diagonal().norm();
  const metrics::Point_tree tree(points);
  const auto is_seen = [&](const metrics::Point& p) { return tree.distance(p) <= near; };
  return metrics::share_within(near, axis, skeleton, is_seen, near / 10);
}

/// The counts of the skeleton of a scan without noise from some places.
Graph_counts counts_of_scan(const shapes::Known_shape& shape, std::size_t size, int places,
                            unsigned int seed, int beams = 1)
{
  return count_graph(
    skeleton_of(to_points(shapes::scan(shape, {size, places, 0, 0, 0, beams}, seed).points)));
}

} // namespace

TEST_CASE("Clean clouds: exact, centred and inside")
{
  const std::string family = GENERATE(as<std::string>(), "ring", "frame", "plant", "knot",
                                      "body_with_limbs", "parallel_prongs", "two_parts");
  const unsigned int seed = GENERATE(1u, 2u);
  CAPTURE(family, seed);
  const shapes::Known_shape shape = shapes::known_shape(family, seed);
  const Skeleton skeleton = skeleton_of(shape, Variant::clean);
  check_counts(skeleton, shape);
  check_centred(skeleton, shape, 0.1);
  check_inside(skeleton, shape);
}

TEST_CASE("Noise of half a per cent of the diagonal: exact and centred")
{
  const std::string family =
      GENERATE(as<std::string>(), "ring", "frame", "plant", "knot", "body_with_limbs", "two_parts");
  CAPTURE(family);
  const shapes::Known_shape shape = shapes::known_shape(family, 1);
  const Skeleton skeleton = skeleton_of(shape, Variant::noise_half_percent);
  check_counts(skeleton, shape);
  check_centred(skeleton, shape, 0.15);
}

TEST_CASE("What else a scanner does: exact and centred")
{
  const Variant variant = GENERATE(Variant::noise_one_percent, Variant::outliers, Variant::holes,
                                   Variant::falling_density, Variant::slices);
  const std::string family = GENERATE(as<std::string>(), "ring", "body_with_limbs");
  CAPTURE(family, shapes::to_string(variant));
  const shapes::Known_shape shape = shapes::known_shape(family, 1);
  const Skeleton skeleton = skeleton_of(shape, variant);
  check_counts(skeleton, shape);
  check_centred(skeleton, shape, 0.15);
}

TEST_CASE("Slices: every slice is no limb, and what is between two is no loop")
{
  // Up to 74 false loops while only the slices of a plane were told from lines.
  const std::string family = GENERATE(as<std::string>(), "frame", "knot", "theta", "two_parts");
  const unsigned int seed = GENERATE(1u, 2u);
  CAPTURE(family, seed);
  const shapes::Known_shape shape = shapes::known_shape(family, seed);
  check_counts(skeleton_of(shape, Variant::slices), shape);
}

TEST_CASE("Twigs of a few points across are no noise: most tips of a sparse scan are found")
{
  const unsigned int seed = 2001; // 24 of 57 tips while the thickness of twigs coarsened the cells
  CAPTURE(seed);
  const shapes::Known_shape tree = shapes::scanned_shape("tree", seed);
  const Graph_counts counts = counts_of_scan(tree, 5000, 6, seed);
  CHECK(counts.components == 1);
  CHECK(counts.cycles == 0);
  CHECK(3 * counts.ends > 2 * tree.ends);
}

TEST_CASE("Twigs of single points, further apart than the twigs, are found in a sparse sample")
{
  // Found 0.38 and 0.41 of while they were outliers, or one piece without a cross-section; 0.63
  // and 0.64 while their patches were merged and they were drawn together as noise is; 0.71 and 0.79
  // while a twig had to have as many points as a ring.
  const unsigned int seed = GENERATE(2021u, 2024u);
  CAPTURE(seed);
  const shapes::Known_shape tree = shapes::scanned_shape("tree", seed);
  const auto points = to_points(shapes::sample_all(tree, 1000, seed));
  const Skeleton skeleton = skeleton_of(points);
  const Graph_counts counts = count_graph(skeleton);
  CHECK(counts.components == 1);
  CHECK(counts.cycles == 0);
  CHECK(share_found(tree, skeleton, points) > 0.8);
}

TEST_CASE("Wires go on behind others that hide them: a frame scanned from one place has its loops")
{
  const unsigned int seed = GENERATE(711u, 713u, 714u); // 8 of 9, 11 of 11 and 4 of 5 if a limb had
  CAPTURE(seed); // to be longer than a gap on each side, and gaps began where the curve ends
  const shapes::Known_shape frame = shapes::scanned_shape("wire_frame", seed);
  const Graph_counts counts = counts_of_scan(frame, 20000, 1, seed);
  CHECK(counts.components == 1);
  CHECK(counts.cycles == frame.cycles);
}

TEST_CASE("Rows of points on a leaf are no twigs")
{
  const int beams = GENERATE(4, 8);
  const unsigned int seed = GENERATE(2023u, 2024u); // 582 of 7 tips while rows were lines
  CAPTURE(beams, seed);
  const shapes::Known_shape plant = shapes::scanned_shape("leafy_plant", seed);
  const Graph_counts counts = counts_of_scan(plant, 20000, 3, seed, beams);
  CHECK(counts.cycles == 0);
  CHECK(counts.ends >= plant.ends);
  CHECK(counts.ends < 3 * plant.ends);
}

TEST_CASE("Stairs seen from above are no bundle of twigs, though creases look scattered from afar")
{
  const unsigned int seed = GENERATE(1u, 2u, 3u); // 25 to 35 ends while they were
  CAPTURE(seed);
  shapes::Random random(seed);
  const Eigen::Matrix3d turn = random.rotation();
  constexpr int steps = 6;
  constexpr double width = 3; // steps
  std::vector<shapes::Vector> cloud;
  for(int k = 0; k < 5000; ++k) {
    const double step = random.integer(0, steps - 1), t = random.uniform();
    const bool is_tread = random.integer(0, 1) == 0;
    const double y = random.uniform(0, width);
    cloud.push_back(turn * (is_tread ? shapes::Vector(step + t, y, step)
                                     : shapes::Vector(step + 1, y, step + t)));
  }
  const Skeleton skeleton = skeleton_of(to_points(cloud));
  const Graph_counts counts = count_graph(skeleton);
  CHECK(counts.components == 1);
  CHECK(counts.cycles == 0);
  CHECK(counts.ends >= 2);
  CHECK(counts.ends <= 4); // the first and the last step are three times as wide as deep
}

TEST_CASE("The curve leads into a dome beside half of a trunk, with a gap around it")
{
  const unsigned int seed = GENERATE(1u, 2u, 3u);
  const double radius = GENERATE(0.5, 0.8); // of the dome; that of the trunk is 1
  CAPTURE(seed, radius);
  shapes::Random random(seed);
  const Eigen::Matrix3d turn = random.rotation();
  constexpr double length = 7, gap = 0.4; // 5 spacings
  const shapes::Vector middle(length / 2, 1 + gap + radius, 0);
  const double share_of_dome = 2 * radius * radius / (2 * radius * radius + length);
  std::vector<shapes::Vector> cloud;
  for(int k = 0; k < 5000; ++k) {
    const bool is_on_dome = random.uniform() < share_of_dome;
    const shapes::Vector upwards = random.direction().cwiseProduct(shapes::Vector(1, 1, 0));
    const double angle = random.uniform(0, std::acos(-1.)), along = random.uniform(0, length);
    const shapes::Vector dome =
      middle + radius * (upwards + std::sqrt(1 - upwards.squaredNorm()) * shapes::Vector::UnitZ());
    cloud.push_back(turn * (is_on_dome
                              ? dome
                              : shapes::Vector(along, std::cos(angle), std::sin(angle))));
  }
  const Skeleton skeleton = skeleton_of(to_points(cloud));
  const shapes::Vector place = turn * (middle + radius / 2 * shapes::Vector::UnitZ());
  double nearest = length;
  for(const auto v : CGAL::make_range(vertices(skeleton))) {
    const Kernel::Point_3& p = skeleton[v].point;
    nearest = (std::min)(nearest, (shapes::Vector(p.x(), p.y(), p.z()) - place).norm());
  }
  CHECK(nearest < radius);
}

} // namespace scanned_shapes_test
