// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Model.h"

#include "Closed_mesh.h"
#include "inside_share.h"
#include "off_centre.h"
#include "sample_surface.h"

#include "generator/Random.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Polygon_mesh_processing/transform.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <utility>

namespace {

using Transformation = Kernel::Aff_transformation_3;

Transformation random_turn(unsigned int seed)
{
  const Eigen::Matrix3d r = shapes::Random(seed).rotation();
  return Transformation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1),
                        r(2, 2));
}

double diagonal(const std::vector<Point>& points)
{
  const auto box = CGAL::bounding_box(points.begin(), points.end());
  return std::sqrt(CGAL::squared_distance(box.min(), box.max()));
}

void add_mesh(Model& model, const Points_and_faces<Point>& soup)
{
  model.mesh = to_triangle_mesh(soup);
  model.components = components_of(model.mesh);
  model.is_closed = CGAL::is_closed(model.mesh);
  model.truth.components = model.components.size();
  if(model.is_closed) {
    model.truth.cycles = 0;
    for(const Mesh& component : model.components)
      *model.truth.cycles += genus_of(component);
  }
}

} // namespace

std::string name_of(const std::string& file)
{
  return std::filesystem::path(file).stem().string();
}

Model read_model(const std::string& file, std::size_t number_of_points, unsigned int seed)
{
  const Points_and_faces<Point> soup = read_points_and_faces<Point>(file);
  Model model;
  model.name = name_of(file);
  model.diagonal = diagonal(soup.points);
  if(soup.faces.empty()) {
    model.points = soup.points;
    return model;
  }
  model.points = sample_surface(soup, number_of_points, seed);
  if(model.points.empty())
    throw std::runtime_error("its faces have no area");
  add_mesh(model, soup);
  return model;
}

std::vector<Point> turned(std::vector<Point> points, unsigned int seed)
{
  std::transform(points.begin(), points.end(), points.begin(), random_turn(seed));
  return points;
}

Model turned(Model model, unsigned int seed)
{
  const Transformation turn = random_turn(seed);
  model.points = turned(std::move(model.points), seed);
  CGAL::Polygon_mesh_processing::transform(turn, model.mesh);
  for(Mesh& component : model.components)
    CGAL::Polygon_mesh_processing::transform(turn, component);
  return model;
}

std::vector<Point> with_noise(std::vector<Point> points, double deviation, unsigned int seed)
{
  shapes::Random random(seed);
  for(Point& p : points) {
    const shapes::Vector offset = deviation * random.normal_vector();
    p += Vector(offset.x(), offset.y(), offset.z());
  }
  return points;
}

void measure_in_model(Measurements& row, const Skeleton& skeleton, const Model& model)
{
  const double step = 0.005 * model.diagonal;
  row.truth = model.truth;
  if(!model.is_closed)
    return;
  const CGAL::Side_of_triangle_mesh<Mesh, Kernel> side(model.mesh);
  const auto inside = [&side](const metrics::Point& p) {
    return side({p.x(), p.y(), p.z()}) != CGAL::ON_UNBOUNDED_SIDE;
  };
  row.inside = metrics::inside_share(skeleton, inside, step);
  row.off_centre = median_of(metrics::off_centre_ratios(skeleton, model.mesh, step));
}
