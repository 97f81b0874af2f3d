// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Blocks.h>

#include <cstddef>
#include <random>
#include <vector>

namespace blocks_test {

namespace internal = CGAL::Point_set_skeletonization_3::internal;

using internal::Skeleton_graph;

namespace {

// The sets of vertices connected by the edges with `is_kept(e)`.
template <typename IsKept>
internal::Union_find connected_by(const Skeleton_graph& graph, const IsKept& is_kept)
{
  internal::Union_find result(graph.vertices.size());
  for(std::size_t e = 0; e < graph.edges.size(); ++e)
    if(is_kept(e))
      result.join(graph.edges[e].first, graph.edges[e].second);
  return result;
}

bool is_at(const Skeleton_graph::Edge& e, std::size_t v)
{
  return e.first == v || e.second == v;
}

// By definition: the ends of a bridge are not connected by the other edges, and a cycle leads
// through two edges at a vertex if their other ends are connected without that vertex.
void check_blocks(const Skeleton_graph& graph)
{
  const internal::Blocks blocks = internal::blocks_of(graph);
  REQUIRE(blocks.of_edge.size() == graph.edges.size());
  REQUIRE(blocks.is_bridge.size() == graph.edges.size());
  for(std::size_t e = 0; e < graph.edges.size(); ++e) {
    internal::Union_find others = connected_by(graph, [&](std::size_t f) { return f != e; });
    const auto [v, w] = graph.edges[e];
    CHECK(blocks.is_bridge[e] == (others.find(v) != others.find(w)));
  }
  for(std::size_t v = 0; v < graph.vertices.size(); ++v) {
    internal::Union_find others =
      connected_by(graph, [&](std::size_t f) { return !is_at(graph.edges[f], v); });
    const auto other_end = [&](std::size_t e) {
      return graph.edges[e].first == v ? graph.edges[e].second : graph.edges[e].first;
    };
    for(std::size_t e = 0; e < graph.edges.size(); ++e)
      for(std::size_t f = 0; f < e; ++f)
        if(is_at(graph.edges[e], v) && is_at(graph.edges[f], v))
          CHECK((blocks.of_edge[e] == blocks.of_edge[f]) ==
                (others.find(other_end(e)) == others.find(other_end(f))));
  }
}

} // namespace

TEST_CASE("Blocks: two cycles with a common vertex, a path to a third, a parallel edge")
{
  Skeleton_graph graph;
  graph.vertices.resize(11);
  graph.edges = {{3, 1}, {1, 0},  {0, 3}, {3, 9}, {9, 10}, {10, 3},
                 {3, 5}, {5, 8}, {8, 2}, {2, 4}, {4, 8},  {6, 7}};
  check_blocks(graph);
  const internal::Blocks blocks = internal::blocks_of(graph);
  CHECK(blocks.of_edge[0] == blocks.of_edge[2]);
  CHECK(blocks.of_edge[0] != blocks.of_edge[3]);
  CHECK(blocks.is_bridge[6]);

  graph.edges.emplace_back(7, 6); // 6 and 7 stay connected without either
  check_blocks(graph);
}

TEST_CASE("Blocks of random graphs, with few and many cycles")
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
    check_blocks(graph);
  }
}

} // namespace blocks_test
