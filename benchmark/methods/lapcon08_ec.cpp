// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "lapcon08_ec.h"

#include "add_curve.h"
#include "edge_collapse.h"
#include "mesh_contraction.h"

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace {

using Displacement = Eigen::RowVector3d;
using methods::Edge_collapse;
using methods::Fan;
using methods::Positions;

/// A mean that grows.
struct Mean
{
  Displacement mean = Displacement::Zero();
  double size = 0;

  void add(const Displacement& displacement)
  {
    size += 1;
    mean += (displacement - mean) / size;
  }
};

/// The vertex of the skeleton that every vertex of the mesh went to.
std::vector<std::size_t> owners_of(const Edge_collapse& collapse, std::size_t size)
{
  std::vector<std::size_t> owner(size);
  for(const std::size_t i : collapse.vertices())
    for(const std::size_t j : collapse.region(i))
      owner[j] = i;
  return owner;
}

/// How far back a region goes, from the `displacements` of its vertices.
Displacement way_back(const std::vector<std::size_t>& region, const std::vector<Fan>& fans,
                      const std::vector<std::size_t>& owner, const Positions& displacements)
{
  Mean all;
  std::map<std::size_t, Mean> boundaries; // by region beyond
  for(const std::size_t i : region) {
    const Displacement displacement = displacements.row(static_cast<Eigen::Index>(i));
    all.add(displacement);
    for(const auto& edge : fans[i])
      if(owner[edge[0]] != owner[i])
        boundaries[owner[edge[0]]].add(displacement);
  }
  if(boundaries.size() < 2)
    return all.mean;
  Mean mean;
  for(const auto& boundary : boundaries)
    mean.add(boundary.second.mean);
  return mean.mean;
}

void add_component(Skeleton& skeleton, const Mesh& mesh, const Positions& contracted)
{
  const std::vector<Fan> fans = methods::fans_of(mesh);
  Edge_collapse collapse(contracted, fans);
  collapse.collapse_all();
  const std::vector<std::size_t> owner = owners_of(collapse, fans.size());
  const Positions displacements = methods::positions_of(mesh) - contracted;
  std::vector<Point> points;
  std::vector<std::size_t> position(fans.size());
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for(const std::size_t i : collapse.vertices()) {
    const Displacement p = contracted.row(static_cast<Eigen::Index>(i)) +
                           way_back(collapse.region(i), fans, owner, displacements);
    position[i] = points.size();
    points.emplace_back(p.x(), p.y(), p.z());
    for(const std::size_t j : collapse.neighbors(i))
      if(j < i)
        edges.emplace_back(position[j], position[i]);
  }
  add_curve(skeleton, points, edges);
}

} // namespace

Method_result lapcon08_ec(const Method_input& input)
{
  return methods::contract_and_add(input, "edge collapses", add_component);
}
