// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wave_fronts.h"

#include "add_curve.h"

#include <boost/graph/breadth_first_search.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace {

using Vertex = Mesh::Vertex_index;

constexpr std::size_t rings_per_step = 3;

/// The least number of edges from a vertex to every other one.
std::vector<std::size_t> hops_from(Vertex seed, const Mesh& mesh)
{
  std::vector<std::size_t> hops(mesh.number_of_vertices(), 0);
  const auto index = get(boost::vertex_index, mesh);
  const auto record = boost::record_distances(
      boost::make_iterator_property_map(hops.begin(), index), boost::on_tree_edge());
  boost::breadth_first_search(
      mesh, seed, boost::visitor(boost::make_bfs_visitor(record)).vertex_index_map(index));
  return hops;
}

/// A vertex that is as many edges as possible away from the first one.
Vertex tip_of(const Mesh& mesh)
{
  const std::vector<std::size_t> hops = hops_from(*mesh.vertices_begin(), mesh);
  const auto farthest = std::max_element(hops.begin(), hops.end());
  return Vertex(static_cast<Mesh::size_type>(farthest - hops.begin()));
}

std::pair<std::size_t, std::size_t> ends_of(Mesh::Edge_index e, const Mesh& mesh)
{
  return {mesh.vertex(e, 0).idx(), mesh.vertex(e, 1).idx()};
}

/// The number of the ring of every vertex; rings are numbered as they come.
std::vector<std::size_t> rings_of(const Mesh& mesh)
{
  const std::vector<std::size_t> hops = hops_from(tip_of(mesh), mesh);
  const auto step = [&hops](std::size_t v) {
    return (hops[v] + rings_per_step - 1) / rings_per_step;
  };
  boost::disjoint_sets_with_storage<> sets(hops.size());
  for(const auto e : mesh.edges()) {
    const auto [source, target] = ends_of(e, mesh);
    if(step(source) == step(target))
      sets.union_set(source, target);
  }
  constexpr std::size_t none = std::size_t(-1);
  std::vector<std::size_t> number(hops.size(), none), ring;
  std::size_t rings = 0;
  for(std::size_t v = 0; v < hops.size(); ++v) {
    std::size_t& root_number = number[sets.find_set(v)];
    if(root_number == none)
      root_number = rings++;
    ring.push_back(root_number);
  }
  return ring;
}

/// The means of the vertices with the same ring.
std::vector<Point> centres_of(const std::vector<std::size_t>& ring, const Mesh& mesh)
{
  const std::size_t rings = 1 + *std::max_element(ring.begin(), ring.end());
  std::vector<Vector> sum(rings, CGAL::NULL_VECTOR);
  std::vector<double> size(rings, 0);
  for(const auto v : mesh.vertices()) {
    sum[ring[v.idx()]] += mesh.point(v) - CGAL::ORIGIN;
    size[ring[v.idx()]] += 1;
  }
  std::vector<Point> centres;
  for(std::size_t i = 0; i < rings; ++i)
    centres.push_back(CGAL::ORIGIN + sum[i] / size[i]);
  return centres;
}

void add_component(Skeleton& skeleton, const Mesh& mesh)
{
  const std::vector<std::size_t> ring = rings_of(mesh);
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for(const auto e : mesh.edges()) {
    const auto [source, target] = ends_of(e, mesh);
    if(ring[source] != ring[target])
      edges.insert(std::minmax(ring[source], ring[target]));
  }
  add_curve(skeleton, centres_of(ring, mesh), {edges.begin(), edges.end()});
}

} // namespace

Method_result wave_fronts(const Method_input& input)
{
  Method_result result;
  timed_stage(result, "waves", [&] {
    for(const Mesh& mesh : input.components)
      add_component(result.skeleton, mesh);
  });
  return result;
}
