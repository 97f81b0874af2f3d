// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "clouds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapes {

const std::vector<Variant>& all_variants()
{
  static const std::vector<Variant> variants = [] {
    std::vector<Variant> result = usual_variants();
    result.push_back(Variant::slices);
    return result;
  }();
  return variants;
}

const std::vector<Variant>& usual_variants()
{
  static const std::vector<Variant> variants = {
      Variant::clean, Variant::noise_half_percent, Variant::noise_one_percent, Variant::outliers,
      Variant::holes, Variant::falling_density};
  return variants;
}

const char* to_string(Variant variant)
{
  switch(variant) {
  case Variant::clean:
    return "clean";
  case Variant::noise_half_percent:
    return "noise_half_percent";
  case Variant::noise_one_percent:
    return "noise_one_percent";
  case Variant::outliers:
    return "outliers";
  case Variant::holes:
    return "holes";
  case Variant::falling_density:
    return "falling_density";
  case Variant::slices:
    return "slices";
  }
  return "";
}

namespace {

/// The radius of the limb that a point on the surface belongs to.
double local_radius(const Known_shape& shape, const Vector& p)
{
  double nearest = std::numeric_limits<double>::infinity(), radius = 0;
  for(const Axis_segment& s : shape.axis) {
    const double place = (p - s.a).dot(s.b - s.a) / (s.b - s.a).squaredNorm();
    const double t = std::min(1.0, std::max(0.0, place));
    const double radius_there = s.radius_a + t * (s.radius_b - s.radius_a);
    const double distance = (p - s.a - t * (s.b - s.a)).norm() - radius_there;
    if(distance < nearest) {
      nearest = distance;
      radius = radius_there;
    }
  }
  return radius;
}

} // namespace

std::vector<Ball> random_holes(const Known_shape& shape, Random& random)
{
  constexpr double share_of_limb = 0.8, share_of_limb_apart = 3;
  constexpr int attempts = 60;
  const std::size_t wanted = static_cast<std::size_t>(random.integer(6, 10));
  std::vector<Ball> holes;
  for(int i = 0; i < attempts && holes.size() < wanted; ++i) {
    const Vector p = shape.solid.random_point(random);
    const double limb = local_radius(shape, p);
    const bool is_alone = std::all_of(holes.begin(), holes.end(), [&](const Ball& hole) {
      const double larger = std::max(limb, hole.radius / share_of_limb);
      return (p - hole.centre).norm() > share_of_limb_apart * larger;
    });
    if(is_alone)
      holes.push_back({p, share_of_limb * limb});
  }
  return holes;
}

std::vector<Vector> sample_clean(const Known_shape& shape, std::size_t number_of_points,
                                 Random& random)
{
  std::vector<Vector> points(number_of_points);
  for(Vector& p : points)
    p = shape.solid.random_point(random);
  return points;
}

std::vector<Vector> sample_all(const Known_shape& shape, std::size_t number_of_points,
                               unsigned seed)
{
  Random random(seed);
  const double area_of_solid = shape.solid.area(random);
  std::vector<double> areas_up_to; // of the sheets
  double area = 0;
  for(const Triangle& triangle : shape.sheets)
    areas_up_to.push_back(area += triangle.area());
  std::vector<Vector> points(number_of_points);
  for(Vector& p : points) {
    const double part = random.uniform() * (area_of_solid + area);
    // Without a solid, what rounding puts behind the last sheet belongs to it.
    const auto end = areas_up_to.end() - (area_of_solid == 0 ? 1 : 0);
    const auto chosen = std::upper_bound(areas_up_to.begin(), end, part);
    p = chosen == areas_up_to.end()
          ? shape.solid.random_point(random)
          : shape.sheets[static_cast<std::size_t>(chosen - areas_up_to.begin())].random_point(
              random);
  }
  return points;
}

namespace {

/// `noise`: standard deviation, in diagonals of the bounding box.
std::vector<Vector> sample_noisy(const Known_shape& shape, std::size_t number_of_points,
                                 double noise, Random& random)
{
  const double sigma = noise * shape.solid.bounding_box().diagonal().norm();
  std::vector<Vector> points = sample_clean(shape, number_of_points, random);
  for(Vector& p : points)
    p += sigma * random.normal_vector();
  return points;
}

/// The outliers come last.
std::vector<Vector> sample_with_outliers(const Known_shape& shape,
                                         std::size_t number_of_points, Random& random)
{
  constexpr std::size_t points_per_outlier = 50;
  constexpr double enlargement = 1.2;
  const Eigen::AlignedBox3d box = shape.solid.bounding_box();
  const std::size_t number_of_outliers = number_of_points / points_per_outlier;
  std::vector<Vector> points = sample_clean(shape, number_of_points - number_of_outliers, random);
  while(points.size() < number_of_points) {
    const Vector place = random.uniform_vector().array() - 0.5;
    points.push_back(box.center() + enlargement * place.cwiseProduct(box.diagonal()));
  }
  return points;
}

std::vector<Vector> sample_with_holes(const Known_shape& shape, std::size_t number_of_points,
                                      Random& random)
{
  const std::vector<Ball> holes = random_holes(shape, random);
  std::vector<Vector> points;
  while(points.size() < number_of_points) {
    const Vector p = shape.solid.random_point(random);
    const auto contains_p = [&](const Ball& hole) { return hole.contains(p); };
    if(std::none_of(holes.begin(), holes.end(), contains_p))
      points.push_back(p);
  }
  return points;
}

std::vector<Vector> sample_falling(const Known_shape& shape, std::size_t number_of_points,
                                   Random& random)
{
  constexpr double factor = 8;
  const Vector direction = random.direction();
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for(const Axis_segment& s : shape.axis) {
    low = std::min({low, s.a.dot(direction), s.b.dot(direction)});
    high = std::max({high, s.a.dot(direction), s.b.dot(direction)});
  }
  std::vector<Vector> points;
  while(points.size() < number_of_points) {
    const Vector p = shape.solid.random_point(random);
    const double place = (p.dot(direction) - low) / (high - low);
    const double kept = std::pow(factor, -std::min(1.0, std::max(0.0, place)));
    if(random.uniform() < kept)
      points.push_back(p);
  }
  return points;
}

/// Slices as of a computer tomograph, or of a scanner with a few beams.
std::vector<Vector> sample_slices(const Known_shape& shape, std::size_t number_of_points,
                                  Random& random)
{
  constexpr double apart = 6, thickness = 0.1; // distances of points in a slice
  const double area = shape.solid.area(random) / static_cast<double>(number_of_points);
  const double distance = std::sqrt(apart * area);
  const Vector direction = random.direction();
  std::vector<Vector> points;
  while(points.size() < number_of_points) {
    const Vector p = shape.solid.random_point(random);
    const double place = p.dot(direction) / distance;
    if(std::abs(place - std::round(place)) < thickness / apart / 2)
      points.push_back(p);
  }
  return points;
}

} // namespace

std::vector<Vector> sample(const Known_shape& shape, Variant variant,
                           std::size_t number_of_points, unsigned seed)
{
  Random random(seed);
  switch(variant) {
  case Variant::clean:
    break;
  case Variant::noise_half_percent:
    return sample_noisy(shape, number_of_points, 0.005, random);
  case Variant::noise_one_percent:
    return sample_noisy(shape, number_of_points, 0.01, random);
  case Variant::outliers:
    return sample_with_outliers(shape, number_of_points, random);
  case Variant::holes:
    return sample_with_holes(shape, number_of_points, random);
  case Variant::falling_density:
    return sample_falling(shape, number_of_points, random);
  case Variant::slices:
    return sample_slices(shape, number_of_points, random);
  }
  return sample_clean(shape, number_of_points, random);
}

} // namespace shapes
