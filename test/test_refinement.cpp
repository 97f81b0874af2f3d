// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Resampled branches keep what they connect, whatever the step.

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/refine_curve.h>

#include <cstddef>
#include <set>
#include <utility>

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

// Squares in a row: every second branch is closed, those between lead from square to square.
Skeleton_graph squares(std::size_t size)
{
  Skeleton_graph graph;
  const auto add = [&](double x, double y) {
    graph.vertices.push_back({Vector3(x, y, 0), 0.1});
    return graph.vertices.size() - 1;
  };
  for(std::size_t i = 0; i < size; ++i) {
    const double x = 3 * static_cast<double>(i);
    const std::size_t corner = add(x, 0);
    if(i > 0)
      graph.edges.emplace_back(corner - 4, corner);
    graph.edges.emplace_back(corner, add(x, 1));
    graph.edges.emplace_back(corner + 1, add(x + 1, 1));
    graph.edges.emplace_back(corner + 2, add(x + 1, 0));
    graph.edges.emplace_back(corner + 3, corner);
  }
  return graph;
}

std::size_t components(const Skeleton_graph& graph)
{
  Union_find connectivity(graph.vertices.size());
  std::size_t result = graph.vertices.size();
  for(const Skeleton_graph::Edge& e : graph.edges)
    result -= connectivity.join(e.first, e.second) ? 1 : 0;
  return result;
}

} // namespace

TEST_CASE("Resampling keeps components and cycles and makes no parallel edges")
{
  constexpr std::size_t size = 5;
  for(int k = 1; k < 200; ++k) {
    const double step = 0.02 * k;
    CAPTURE(step);
    const Skeleton_graph graph = resampled(squares(size), step);
    CHECK(components(graph) == 1);
    CHECK(graph.edges.size() + 1 - graph.vertices.size() == size);
    std::set<std::pair<std::size_t, std::size_t>> different;
    for(const Skeleton_graph::Edge& e : graph.edges)
      different.insert(std::minmax(e.first, e.second));
    CHECK(different.size() == graph.edges.size());
  }
}
