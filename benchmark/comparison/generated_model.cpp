// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generated_model.h"

#include "../Closed_mesh.h"
#include "../methods/components_of.h"
#include "filigree.h"

#include "generator/clouds.h"
#include "generator/families.h"

#include <CGAL/alpha_wrap_3.h>
#include <boost/lexical_cast.hpp>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace {

constexpr std::size_t wrapped_points = 100000;
// In diagonals. Alpha is above the gaps between so many points and below those between limbs, which
// are as wide as a limb's radius, 0.025.
constexpr double wrap_alpha = 0.015, wrap_offset = 0.001;

std::vector<Point> draw(const shapes::Known_shape& shape, std::size_t number, unsigned int seed)
{
  shapes::Random random(seed);
  std::vector<Point> points;
  for(const shapes::Vector& p : shapes::sample_clean(shape, number, random))
    points.emplace_back(p.x(), p.y(), p.z());
  return points;
}

/// The distance to the surface of the shape is exact outside, where a wrap is.
Point on_surface(const shapes::Solid& solid, const Point& point)
{
  constexpr double step = 1e-6; // the shapes have a size of about one
  const shapes::Vector p(point.x(), point.y(), point.z());
  shapes::Vector gradient;
  for(int i = 0; i < 3; ++i) {
    const shapes::Vector offset = step * shapes::Vector::Unit(i);
    gradient[i] =
        (solid.signed_distance(p + offset) - solid.signed_distance(p - offset)) / (2 * step);
  }
  const shapes::Vector q = p - solid.signed_distance(p) * gradient;
  return {q.x(), q.y(), q.z()};
}

} // namespace

std::vector<std::string> generated_names()
{
  std::vector<std::string> names = shapes::family_names();
  names.push_back("filigree");
  return names;
}

bool is_generated(const std::string& input)
{
  const std::vector<std::string> families = generated_names();
  return input.find(':') != std::string::npos &&
         std::find(families.begin(), families.end(), input.substr(0, input.find(':'))) !=
             families.end();
}

Model generated_model(const std::string& input, std::size_t number_of_points, unsigned int seed)
{
  const std::size_t colon = input.find(':');
  unsigned int shape_seed = 0;
  if(!boost::conversion::try_lexical_convert(input.substr(colon + 1), shape_seed))
    throw std::runtime_error("no seed after the colon");
  const std::string family = input.substr(0, colon);
  const shapes::Known_shape shape =
      family == "filigree" ? filigree(shape_seed) : shapes::known_shape(family, shape_seed);
  Model model;
  model.name = input;
  model.diagonal = shape.solid.bounding_box().diagonal().norm();
  model.points = draw(shape, number_of_points, seed);
  model.truth = {shape.components, shape.cycles, shape.ends};
  Mesh wrap;
  CGAL::alpha_wrap_3(draw(shape, wrapped_points, seed + 1), wrap_alpha * model.diagonal,
                     wrap_offset * model.diagonal, wrap);
  model.components = components_of(wrap);
  model.is_closed = true;
  std::size_t genus = 0;
  for(Mesh& component : model.components) {
    for(const auto v : component.vertices())
      component.point(v) = on_surface(shape.solid, component.point(v));
    genus += genus_of(component);
    model.mesh.join(component);
  }
  if(model.components.size() != shape.components || genus != shape.cycles)
    throw std::runtime_error("its mesh has not the topology of the shape");
  return model;
}
