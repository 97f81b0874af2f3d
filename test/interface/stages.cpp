// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The stages as functions of their own: points to a mixture, that to samples, those to a skeleton.

#include "analytic_surfaces.h"

#include "catch2.h"
#include "generator/Random.h"
#include "graph_counts.h"
#include "shapes.h"
#include "skeleton_checks.h"

#include <CGAL/compute_medial_samples.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/fit_gaussian_mixture.h>
#include <CGAL/link_medial_samples.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace stages_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Points = std::vector<Point>;
using Mixture = CGAL::Gaussian_mixture_3<Kernel>;
using Samples = CGAL::Medial_samples_3<Kernel>;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
namespace parameters = CGAL::parameters;

namespace {

const std::function<bool(double)> cancel = [](double) { return false; };

Points cloud_of(const shapes::Shape& shape, std::size_t size)
{
  return shapes::to_points<Kernel>(shapes::sample(shape, size, 31));
}

Points cloud() { return cloud_of(shapes::cylinder(), 1500); }

Samples samples_of(const Points& points)
{
  Samples samples;
  REQUIRE(CGAL::compute_medial_samples(CGAL::fit_gaussian_mixture(points), samples));
  return samples;
}

Point to_point(const shapes::Vector& p) { return Point(p.x(), p.y(), p.z()); }

// Samples made by hand, on the axis of a tube of which all is known.
Samples samples_of(const surfaces::Tube& tube)
{
  const surfaces::Patches patches = tube.patches();
  Samples result;
  for(const surfaces::Patch& patch : patches) {
    CGAL::Medial_sample_3<Kernel> sample;
    sample.patch.weight = patch.weight;
    sample.patch.mean = to_point(patch.mean);
    sample.point = to_point(patch.mean - surfaces::tube_radius * patch.normal);
    sample.radius = surfaces::tube_radius;
    result.samples.push_back(sample);
  }
  return result;
}

Skeleton linked(const Samples& samples)
{
  Skeleton skeleton;
  REQUIRE(CGAL::link_medial_samples(samples, skeleton));
  check_valid(skeleton, samples.samples.size());
  return skeleton;
}

void check_same_topology(const Graph_counts& a, const Graph_counts& b)
{
  CHECK(a.components == b.components);
  CHECK(a.cycles == b.cycles);
  CHECK(a.ends == b.ends);
  CHECK(a.junctions == b.junctions);
}

std::size_t number_of_indices(const Skeleton& skeleton)
{
  std::size_t result = 0;
  for(const auto v : boost::make_iterator_range(vertices(skeleton)))
    result += skeleton[v].indices.size();
  return result;
}

/// Share of the samples of a kind.
double share_of(CGAL::Medial_sample_kind kind, const Samples& samples)
{
  const auto is_of_kind = [&](const auto& sample) { return sample.kind == kind; };
  return static_cast<double>(std::count_if(samples.samples.begin(), samples.samples.end(),
                                           is_of_kind)) /
         static_cast<double>(samples.samples.size());
}

/// Share of the points whose samples are of a kind: a sheet without noise is one patch, and a few
/// points that chance put apart at its border are another.
double share_of_points(CGAL::Medial_sample_kind kind, const Samples& samples)
{
  double of_kind = 0, all = 0;
  for(const auto& sample : samples.samples) {
    all += sample.patch.weight;
    of_kind += sample.kind == kind ? sample.patch.weight : 0;
  }
  return of_kind / all;
}

} // namespace

TEST_CASE("A mixture has the mass, mean and level sizes of its points")
{
  const Points points = cloud();
  const Mixture mixture = CGAL::fit_gaussian_mixture(points);
  REQUIRE(!mixture.levels.empty());
  for(std::size_t k = 0; k < mixture.levels.size(); ++k) {
    CAPTURE(k);
    double mass = 0;
    shapes::Vector sum = shapes::Vector::Zero(), mean = shapes::Vector::Zero();
    for(const auto& c : mixture.levels[k]) {
      mass += c.weight;
      sum += c.weight * shapes::to_vector(c.mean);
    }
    for(const Point& p : points)
      mean += shapes::to_vector(p) / static_cast<double>(points.size());
    CHECK(mass == Approx(static_cast<double>(points.size())));
    CHECK((sum / mass - mean).norm() < 1e-12);
    if(k > 0)
      CHECK(mixture.levels[k].size() <= mixture.levels[k - 1].size());
  }
  CHECK(CGAL::fit_gaussian_mixture(Points()).levels.empty());
  CHECK(CGAL::fit_gaussian_mixture(points, parameters::callback(cancel)).levels.empty());
}

TEST_CASE("A sample says what it is in the middle of")
{
  using Kind = CGAL::Medial_sample_kind;
  const unsigned int seed = GENERATE(1u, 2u, 3u);
  CAPTURE(seed);
  shapes::Random random(seed);
  Points line, sheet, scattered;
  for(int k = 0; k < 4000; ++k) {
    line.emplace_back(random.uniform(), 0, 0);
    sheet.emplace_back(random.uniform(), random.uniform(), 0);
    const double x = random.uniform(), y = random.uniform();
    scattered.emplace_back(x, y, random.uniform());
  }
  CHECK(share_of(Kind::solid, samples_of(cloud())) > 0.9);
  CHECK(share_of(Kind::line, samples_of(line)) > 0.9);
  CHECK(share_of_points(Kind::sheet, samples_of(sheet)) > 0.99);
  const Samples inside_too = samples_of(scattered); // the border of the cube may count as solid
  CHECK(share_of(Kind::scatter, inside_too) > 0.3);
  CHECK(share_of(Kind::line, inside_too) + share_of(Kind::sheet, inside_too) < 0.2);
}

TEST_CASE("Samples are inside of where their patches are, and those of a tube on its axis")
{
  const Mixture mixture = CGAL::fit_gaussian_mixture(cloud());
  const Samples samples = samples_of(cloud());
  REQUIRE(!samples.samples.empty());
  CHECK(samples.samples.size() <= mixture.levels.front().size());
  CHECK(samples.noise == std::vector<double>{0});
  const shapes::Shape shape = shapes::cylinder();
  std::size_t inside = 0;
  for(const auto& sample : samples.samples) {
    REQUIRE(shapes::distance_to_axes(shape, shapes::to_vector(sample.patch.mean)) ==
            Approx(0.1).epsilon(0.1));
    inside += shapes::distance_to_axes(shape, shapes::to_vector(sample.point)) < 0.03;
  }
  CHECK(inside > samples.samples.size() * 9 / 10); // a tenth of the width around the axis
}

TEST_CASE("Without noise the means of patches are those of the components they are made of")
{
  const Mixture mixture = CGAL::fit_gaussian_mixture(cloud());
  const Samples samples = samples_of(cloud());
  REQUIRE(samples.noise == std::vector<double>{0});
  const auto& components = mixture.levels.front();
  std::vector<double> weight(samples.samples.size(), 0);
  std::vector<shapes::Vector> sum(samples.samples.size(), shapes::Vector::Zero());
  for(const auto& p : samples.surface) {
    REQUIRE(p.point == p.denoised);
    const auto is_it = [&](const auto& c) {
      return CGAL::squared_distance(c.mean, p.point) < 1e-20;
    };
    REQUIRE(std::any_of(components.begin(), components.end(), is_it));
    weight[p.sample] += p.weight;
    sum[p.sample] += p.weight * shapes::to_vector(p.point);
  }
  for(std::size_t i = 0; i < samples.samples.size(); ++i) {
    REQUIRE(weight[i] == Approx(samples.samples[i].patch.weight));
    const shapes::Vector mean = shapes::to_vector(samples.samples[i].patch.mean);
    REQUIRE((sum[i] / weight[i] - mean).norm() < 1e-10);
  }
}

TEST_CASE("The stages one after the other give what they give at once")
{
  for(const shapes::Shape& shape :
      {shapes::cylinder(), shapes::y_junction(), shapes::ring(), shapes::two_parts()}) {
    CAPTURE(shape.size());
    const Points points = cloud_of(shape, 6000);
    Skeleton at_once;
    REQUIRE(CGAL::extract_l1_medial_skeleton(points, at_once));
    const Skeleton skeleton = linked(samples_of(points));
    const Graph_counts expected = count_graph(at_once), counts = count_graph(skeleton);
    check_same_topology(counts, expected);
    CHECK(counts.length == Approx(expected.length).epsilon(1e-6));
  }
}

TEST_CASE("The box of the points goes from stage to stage, and need not be known")
{
  const Points points = cloud();
  Mixture mixture = CGAL::fit_gaussian_mixture(points);
  CHECK(mixture.bbox == CGAL::bbox_3(points.begin(), points.end()));
  CHECK(samples_of(points).bbox == mixture.bbox);
  mixture.bbox = CGAL::Bbox_3();
  Samples samples;
  REQUIRE(CGAL::compute_medial_samples(mixture, samples));
  check_same_topology(count_graph(linked(samples)), count_graph(linked(samples_of(points))));
}

TEST_CASE("The concurrency tag changes no bit of a stage")
{
  const Points points = cloud_of(shapes::y_junction(), 6000);
  using Tag = CGAL::Parallel_if_available_tag;
  const Samples expected = samples_of(points);
  Samples samples;
  REQUIRE(CGAL::compute_medial_samples<Tag>(CGAL::fit_gaussian_mixture<Tag>(points), samples));
  REQUIRE(samples.samples.size() == expected.samples.size());
  for(std::size_t i = 0; i < samples.samples.size(); ++i) {
    REQUIRE(samples.samples[i].point == expected.samples[i].point);
    REQUIRE(samples.samples[i].radius == expected.samples[i].radius);
  }
  Skeleton skeleton;
  REQUIRE(CGAL::link_medial_samples<Tag>(samples, skeleton));
  CHECK(have_same_bits(skeleton, linked(expected)));
}

TEST_CASE("Samples made by hand: a tube is a path along its axis")
{
  const Samples samples = samples_of(surfaces::tube);
  const Skeleton skeleton = linked(samples);
  const Graph_counts counts = count_graph(skeleton);
  CHECK(counts.components == 1);
  CHECK(counts.cycles == 0);
  CHECK(counts.ends == 2);
  CHECK(counts.junctions == 0);
  for(const auto v : boost::make_iterator_range(vertices(skeleton)))
    CHECK(std::hypot(skeleton[v].point.y(), skeleton[v].point.z()) < 0.1 * surfaces::tube_radius);
  CHECK(number_of_indices(skeleton) == samples.samples.size());
}

TEST_CASE("Samples made by hand: a torus is a cycle, whose vertices know the samples near them")
{
  const Samples samples = samples_of(surfaces::torus);
  const Skeleton skeleton = linked(samples);
  const Graph_counts counts = count_graph(skeleton);
  CHECK(counts.components == 1);
  CHECK(counts.cycles == 1);
  CHECK(counts.ends == 0);
  CHECK(counts.junctions == 0);
  CHECK(counts.length == Approx(2 * shapes::pi * surfaces::ring_radius).epsilon(0.02));
  CHECK(number_of_indices(skeleton) == samples.samples.size());
  for(const auto v : boost::make_iterator_range(vertices(skeleton))) {
    const shapes::Vector p = shapes::to_vector(skeleton[v].point);
    CHECK(std::hypot(p.head<2>().norm() - surfaces::ring_radius, p.z()) <
          0.1 * surfaces::tube_radius);
    CHECK(skeleton[v].radius == Approx(surfaces::tube_radius).epsilon(0.1));
    for(std::size_t i : skeleton[v].indices)
      REQUIRE((shapes::to_vector(samples.samples[i].point) - p).norm() < surfaces::tube_radius);
  }
}

TEST_CASE("Parts are joined by linking if a single component is asked for")
{
  const Samples samples = samples_of(cloud_of(shapes::two_parts(), 6000));
  Skeleton single;
  REQUIRE(CGAL::link_medial_samples(samples, single, parameters::single_component(true)));
  CHECK(count_graph(linked(samples)).components == 2);
  CHECK(count_graph(single).components == 1);
}

TEST_CASE("Cancelled or of nothing")
{
  Samples samples = samples_of(cloud());
  const std::size_t size = samples.samples.size();
  const Mixture mixture = CGAL::fit_gaussian_mixture(cloud());
  CHECK_FALSE(CGAL::compute_medial_samples(mixture, samples, parameters::callback(cancel)));
  CHECK(samples.samples.size() == size);
  Skeleton skeleton(7);
  CHECK_FALSE(CGAL::link_medial_samples(samples, skeleton, parameters::callback(cancel)));
  CHECK(num_vertices(skeleton) == 7);

  CHECK(CGAL::compute_medial_samples(Mixture(), samples));
  CHECK(samples.samples.empty());
  CHECK(samples.surface.empty());
  CHECK(CGAL::link_medial_samples(samples, skeleton));
  CHECK(num_vertices(skeleton) == 0);
}

TEST_CASE("A mean that is not finite is refused by its position")
{
  const auto complaint = [](const auto& call) {
    try {
      call();
    } catch(const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const Point bad(0, std::numeric_limits<double>::quiet_NaN(), 0);
  Mixture mixture = CGAL::fit_gaussian_mixture(cloud());
  Samples samples = samples_of(cloud());
  mixture.levels.front()[17].mean = bad;
  samples.samples[23].patch.mean = bad;
  Skeleton skeleton;
  CHECK(complaint([&] { CGAL::compute_medial_samples(mixture, samples); }).find("point 17 ") == 0);
  CHECK(complaint([&] { CGAL::link_medial_samples(samples, skeleton); }).find("point 23 ") == 0);
}

} // namespace stages_test
