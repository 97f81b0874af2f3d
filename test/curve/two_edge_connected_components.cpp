// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/two_edge_connected_components.h>

#include <cstddef>
#include <random>
#include <vector>

namespace two_edge_connected_components_test {

namespace internal = CGAL::Point_set_skeletonization_3::internal;

using internal::Skeleton_graph;

namespace {

// Whether the ends of an edge are not connected by the others: the definition of a bridge.
bool is_bridge(const Skeleton_graph& graph, std::size_t e)
{
  internal::Union_find connected(graph.vertices.size());
  for(std::size_t f = 0; f < graph.edges.size(); ++f)
    if(f != e)
      connected.join(graph.edges[f].first, graph.edges[f].second);
  return connected.find(graph.edges[e].first) != connected.find(graph.edges[e].second);
}

void check_bridges(const Skeleton_graph& graph)
{
  const std::vector<std::size_t> part = internal::two_edge_connected_components(graph);
  REQUIRE(part.size() == graph.vertices.size());
  for(std::size_t e = 0; e < graph.edges.size(); ++e) {
    const auto [v, w] = graph.edges[e];
    CHECK((part[v] != part[w]) == is_bridge(graph, e));
  }
}

} // namespace

TEST_CASE("Parts between bridges: two cycles and the path between them, a parallel edge")
{
  Skeleton_graph graph;
  graph.vertices.resize(9);
  graph.edges = {{3, 1}, {1, 0}, {0, 3}, {3, 5}, {5, 8}, {8, 2}, {2, 4}, {4, 8}, {6, 7}};
  check_bridges(graph);
  const std::vector<std::size_t> part = internal::two_edge_connected_components(graph);
  CHECK(part[6] != part[7]);
  CHECK(part[5] != part[3]);
  CHECK(part[2] == part[8]);

  graph.edges.emplace_back(7, 6); // 6 and 7 stay connected without either
  check_bridges(graph);
}

TEST_CASE("Parts between bridges of random graphs, with few and many cycles")
{
  for(unsigned seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    Skeleton_graph graph;
    graph.vertices.resize(20);
    for(unsigned e = 0; e < 10 + seed / 3; ++e) {
      const std::size_t v = random() % 20, w = random() % 20;
      if(v != w)
        graph.edges.emplace_back(v, w);
    }
    check_bridges(graph);
  }
}

} // namespace two_edge_connected_components_test
