// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_CHECK_COUNTS_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_CHECK_COUNTS_H

#include "../catch2.h"
#include "Axis_graph.h"

#include <boost/graph/connected_components.hpp>

#include <cstddef>
#include <vector>

namespace shapes {

/// The axis has the counts that the shape states.
inline void check_counts(const Known_shape& shape)
{
  const Axis_graph graph = axis_graph(shape);
  std::vector<std::size_t> component(num_vertices(graph));
  const auto components =
      static_cast<std::size_t>(boost::connected_components(graph, component.data()));
  std::size_t ends = 0, junctions = 0;
  for(std::size_t v = 0; v < num_vertices(graph); ++v) {
    ends += out_degree(v, graph) == 1;
    junctions += out_degree(v, graph) >= 3;
  }
  CHECK(components == shape.components);
  CHECK(num_edges(graph) + components - num_vertices(graph) == shape.cycles);
  CHECK(ends == shape.ends);
  CHECK(junctions == shape.junctions.size());
}

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_CHECK_COUNTS_H
