// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Compared_input.h"

#include "../methods/alpha_wrap.h"
#include "../methods/remesh.h"
#include "decimate.h"
#include "oriented_normals.h"

#include <CGAL/L1_medial_skeletonization_3.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <utility>

namespace {

/// As `with_noise()`, for the vertices of the components one after the other.
std::vector<Mesh> with_noisy_vertices(std::vector<Mesh> components, double deviation,
                                      unsigned int seed)
{
  std::vector<Point> points;
  for(const Mesh& component : components)
    for(const auto v : component.vertices())
      points.push_back(component.point(v));
  points = with_noise(points, deviation, seed);
  auto next = points.begin();
  for(Mesh& component : components)
    for(const auto v : component.vertices())
      component.point(v) = *next++;
  return components;
}

/// Of this package's Gaussian mixture.
std::size_t number_of_mixture_components(const std::vector<Point>& points)
{
  CGAL::L1_medial_skeletonization_3<Kernel> steps(points);
  steps.fit_mixture();
  return steps.number_of_components();
}

Method_input input_of(std::vector<Mesh> components)
{
  Method_input input;
  input.components = std::move(components);
  return input;
}

} // namespace

Compared_input::Compared_input(const Model& model, const std::vector<Mesh>& fine_components,
                               double noise, unsigned int seed,
                               const Comparison_options& options)
    : cloud_(std::make_shared<std::vector<Point>>(
          with_noise(model.points, noise * model.diagonal, seed + 1)))
    , components_(with_noisy_vertices(fine_components, noise * model.diagonal, seed + 2))
    , decimate_(options.decimate)
{}

std::vector<Task> Compared_input::tasks(const Registered_method& method) const
{
  switch(method.needs) {
  case Needs::points:
    return {{method.name, input_kind(method.needs), [=] {
               Method_input input;
               input.points = *cloud_;
               return method.run(input);
             }}};
  case Needs::points_and_normals:
    return {{method.name, input_kind(method.needs), [=] {
               Method_result result;
               const Method_input input =
                   timed_stage(result, "normals", [&] { return with_normals(*cloud_); });
               return after(result, method.run(input));
             }}};
  case Needs::mesh:
    break;
  }
  if(components_.empty())
    return {wrap_task(method)};
  if(decimate_)
    return {mesh_task(method), decimation_task(method)};
  return {mesh_task(method)};
}

Task Compared_input::mesh_task(const Registered_method& method) const
{
  return {method.name, input_kind(method.needs), [=] { return method.run(input_of(components_)); }};
}

Task Compared_input::wrap_task(const Registered_method& method) const
{
  return {method.name, "wrapped mesh", [=] {
            Method_result result;
            const Method_input input =
                timed_stage(result, "wrap", [&] { return input_of(fine_alpha_wrap(*cloud_)); });
            return after(result, method.run(input));
          }};
}

Task Compared_input::decimation_task(const Registered_method& method) const
{
  return {method.name, "decimated mesh", [=] {
            Method_result result;
            const Method_input input = timed_stage(result, "decimation", [&] {
              return input_of(decimate(components_, number_of_mixture_components(*cloud_)));
            });
            return after(result, method.run(input));
          }};
}

std::vector<Mesh> fine_components(const Model& model, std::size_t number_of_vertices)
{
  if(!model.is_closed)
    return {};
  std::vector<Mesh> components = remesh_to(model.components, number_of_vertices);
  for(Mesh& component : components)
    if(!CGAL::Polygon_mesh_processing::is_outward_oriented(component))
      CGAL::Polygon_mesh_processing::reverse_face_orientations(component);
  return components;
}

std::string input_kind(Needs needs)
{
  switch(needs) {
  case Needs::points:
    return "points";
  case Needs::points_and_normals:
    return "points+normals";
  case Needs::mesh:
    break;
  }
  return "mesh";
}
