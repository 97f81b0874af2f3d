// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_contraction.h"

#include <CGAL/boost/graph/iterator.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace methods {
namespace {

constexpr double growth = 2;              // s_L of the article
constexpr double enough = 1e-6;           // of the volume, there as well
constexpr std::size_t maximum_steps = 20; // there: 5 to 20 are needed

Eigen::Vector3d row(const Positions& points, std::size_t i)
{
  return points.row(static_cast<Eigen::Index>(i));
}

/// Three times six times the volume inside: every triangle is in three fans.
double signed_volume(const Positions& points, const std::vector<Fan>& fans)
{
  double sum = 0;
  for(std::size_t i = 0; i < fans.size(); ++i)
    for(const auto& [j, k] : fans[i])
      sum += row(points, i).dot(row(points, j).cross(row(points, k)));
  return sum;
}

} // namespace

Positions positions_of(const Mesh& mesh)
{
  Positions positions(static_cast<Eigen::Index>(mesh.number_of_vertices()), 3);
  for(const auto v : mesh.vertices())
    positions.row(static_cast<Eigen::Index>(v.idx())) << mesh.point(v).x(), mesh.point(v).y(),
        mesh.point(v).z();
  return positions;
}

std::vector<Fan> fans_of(const Mesh& mesh)
{
  std::vector<Fan> fans(mesh.number_of_vertices());
  for(const auto f : mesh.faces())
    for(const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
      fans[mesh.target(h).idx()].push_back({mesh.target(mesh.next(h)).idx(), mesh.source(h).idx()});
  return fans;
}

Positions contract_mesh(const Mesh& mesh)
{
  const std::vector<Fan> fans = fans_of(mesh);
  const auto has_no_volume = [&](const Positions& first, const Positions&, const Positions& after) {
    return signed_volume(after, fans) < enough * signed_volume(first, fans);
  };
  return contract(positions_of(mesh), fans, {growth, maximum_steps, has_no_volume});
}

Method_result contract_and_add(const Method_input& input, const std::string& stage,
                               Add_component add)
{
  Method_result result;
  std::vector<Positions> contracted;
  timed_stage(result, "contraction", [&] {
    for(const Mesh& mesh : input.components)
      contracted.push_back(contract_mesh(mesh));
  });
  timed_stage(result, stage, [&] {
    for(std::size_t i = 0; i < contracted.size(); ++i)
      add(result.skeleton, input.components[i], contracted[i]);
  });
  return result;
}

} // namespace methods
