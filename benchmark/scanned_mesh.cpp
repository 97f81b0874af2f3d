// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scanned_mesh.h"

#include "Model.h"
#include "Outcome.h"

#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace {

shapes::Triangle triangle_of(Mesh::Face_index face, const Mesh& mesh)
{
  std::vector<shapes::Vector> corners;
  for(const Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(face), mesh)) {
    const Point& p = mesh.point(v);
    corners.emplace_back(p.x(), p.y(), p.z());
  }
  return {corners[0], corners[1], corners[2]};
}

} // namespace

Scene scanned_mesh(const std::string& file, unsigned int seed)
{
  constexpr std::size_t points_of_reference = 20000;
  const Model model = turned(read_model(file, points_of_reference, 0), seed);
  if(!model.is_closed)
    throw std::runtime_error("it is no closed mesh");
  Scene scene;
  scene.shape.family = model.name;
  scene.shape.seed = seed;
  scene.shape.components = *model.truth.components;
  scene.shape.cycles = *model.truth.cycles;
  for(const Mesh::Face_index face : model.mesh.faces())
    scene.shape.sheets.push_back(triangle_of(face, model.mesh));
  scene.reference = skeletonize(model.points, Quality_options()).front().skeleton;
  return scene;
}
