// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scanner.h"

#include "Depth_image.h"
#include "Drop_outs.h"
#include "Random.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shapes {

namespace {

/// Of the scanner from the middle, in diagonals; so that all of the shape is in front of it.
constexpr double distance_of_places = 1.5;

/// Evenly around the upright axis, from the height of the shape's feet to well above its head; the
/// sixth looks down on it.
std::vector<Vector> scanner_places(const Eigen::AlignedBox3d& box, int number,
                                   Random& random)
{
  const double distance = distance_of_places * box.diagonal().norm();
  const double phase = random.uniform();
  std::vector<Vector> places;
  for(int i = 0; i < number; ++i) {
    const double turns = phase + (i + random.uniform(-0.1, 0.1)) / number;
    const double rise = i == 5 ? random.uniform(1.3, 1.5) : random.uniform(-0.1, 0.6);
    const Vector level(std::cos(full_turn * turns), std::sin(full_turn * turns), 0);
    places.push_back(box.center() +
                     distance * (std::cos(rise) * level + std::sin(rise) * Vector::UnitZ()));
  }
  return places;
}

/// The image of a shape by rays of which four make a pulse: a pulse is as wide as it is far from
/// the next one, and a wire that is thinner returns it nevertheless.
Depth_image image_of(const Known_shape& shape, const Vector& place, double pulse_step)
{
  Depth_image image(place, bounding_box(shape), pulse_step / 2);
  for(const Solid::Primitive& primitive : shape.solid.primitives())
    std::visit([&](const auto& x) { image.draw(x); }, primitive);
  for(const Triangle& triangle : shape.sheets)
    image.draw(triangle);
  return image;
}

/// What the four rays of a pulse meet, nearest first.
using Echoes = std::array<double, 4>;

/// Calls `visit` with the middle of every pulse on the image that returns, and its echoes. `beams`:
/// distance of rows.
template <typename Visit>
void for_returns(const Depth_image& image, int beams, const Visit& visit)
{
  const auto even = [](int x) { return x - (x & 1); };
  for(int y = even(image.begin().y()); y < image.end().y(); y += 2 * beams)
    for(int x = even(image.begin().x()); x < image.end().x(); x += 2) {
      Echoes echoes = {image.distance({x, y}), image.distance({x + 1, y}),
                       image.distance({x, y + 1}), image.distance({x + 1, y + 1})};
      std::sort(echoes.begin(), echoes.end());
      if(echoes.front() < no_hit)
        visit(Eigen::Array2d(x + 1, y + 1), echoes);
    }
}

/// Of the echoes up to a distance.
double mean_echo(const Echoes& echoes, double farthest)
{
  double sum = 0;
  int number = 0;
  for(const double echo : echoes)
    if(echo <= farthest && echo < no_hit) {
      sum += echo;
      ++number;
    }
  return sum / number;
}

/// The angle between pulses for which about as many return as there shall be points: from few
/// pulses, which are quick, to more.
double step_for(const Known_shape& shape, const std::vector<Vector>& places,
                const Scan_options& options)
{
  double step = 0.01;
  for(const double share : {0.06, 0.25, 0.7, 1.0}) {
    double returns = 0;
    for(const Vector& place : places)
      for_returns(image_of(shape, place, step), options.beams,
                  [&](const Eigen::Array2d&, const Echoes&) { ++returns; });
    step *= std::sqrt(returns / (share * static_cast<double>(options.points)));
  }
  return step;
}

/// Adds the points of a place.
void add_returns(const Depth_image& image, double diagonal, double spacing,
                 const Scan_options& options, Random& random, std::vector<Vector>& points)
{
  // Echoes that are further apart come from different surfaces: no surface is that steep.
  const double gap = 4 * spacing;
  Drop_outs drop_outs(options.lost);
  for_returns(image, options.beams, [&](const Eigen::Array2d& at, const Echoes& echoes) {
    const double mixed = random.uniform(), noise = random.normal();
    if(drop_outs.next(random))
      return;
    const double farthest = mixed < options.mixed ? no_hit : echoes.front() + gap;
    const double distance = mean_echo(echoes, farthest);
    points.push_back(image.ray(at).at(distance + options.range_noise * diagonal * noise));
  });
}

} // namespace

Scan scan(const Known_shape& shape, const Scan_options& options, unsigned seed)
{
  Random random(seed);
  const Eigen::AlignedBox3d box = bounding_box(shape);
  const double diagonal = box.diagonal().norm();
  Scan scan;
  scan.places = scanner_places(box, options.places, random);
  const double step = step_for(shape, scan.places, options);
  scan.spacing = step * distance_of_places * diagonal;
  for(const Vector& place : scan.places)
    add_returns(image_of(shape, place, step), diagonal, scan.spacing, options,
                          random, scan.points);
  return scan;
}

} // namespace shapes
