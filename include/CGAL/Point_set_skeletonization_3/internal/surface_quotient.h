// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_QUOTIENT_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_QUOTIENT_H

#include <CGAL/Point_set_skeletonization_3/internal/essential_cycles.h>
#include <CGAL/Point_set_skeletonization_3/internal/loop_closing.h>
#include <CGAL/Point_set_skeletonization_3/internal/sample_groups.h>
#include <CGAL/Point_set_skeletonization_3/internal/visibility_complex.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Joins components that the surface connects though no group of one sees one of the other, as
/// where a thin limb leaves a body at a sharp angle.
inline void join_along_surface(Skeleton_graph& graph, const Sample_groups& groups,
                               const std::vector<Patch>& patches)
{
  Connectivity connectivity(graph.vertices.size());
  for(const Skeleton_graph::Edge& e : graph.edges)
    connectivity.join(e.first, e.second);
  using Candidate = std::tuple<double, std::size_t, std::size_t>;
  std::vector<Candidate> candidates;
  for(std::size_t i = 0; i < patches.size(); ++i)
    for(std::size_t j : patches[i].neighbors) {
      const std::size_t a = groups.group_of_sample[i], b = groups.group_of_sample[j];
      if(i < j && connectivity.root(a) != connectivity.root(b))
        candidates.emplace_back((graph.vertices[a].position - graph.vertices[b].position).norm(),
                                std::min(a, b), std::max(a, b));
    }
  std::sort(candidates.begin(), candidates.end());
  for(const Candidate& c : candidates)
    if(connectivity.join(std::get<1>(c), std::get<2>(c)))
      graph.edges.emplace_back(std::get<1>(c), std::get<2>(c));
}

/// The surface quotient: samples that coincide made one, connected where the solid connects them,
/// reduced to a curve of the same homotopy type; what only the surface connects is joined last.
inline Skeleton_graph surface_quotient(const Sample_groups& groups,
                                       const std::vector<Patch>& patches, const Solid_side& side)
{
  Skeleton_graph graph;
  graph.vertices = groups.groups;

  const Visibility_complex complex(groups.groups, side);
  std::vector<Skeleton_graph::Edge> visible;
  for(const Skeleton_graph::Edge& e : neighboring_groups(groups, patches))
    if(complex.sees(e.first, e.second))
      visible.push_back(e);

  const Homotopy_edges edges = homotopy_edges(
    graph.vertices.size(), visible,
    [&](std::size_t a, std::size_t b, std::size_t c) { return complex.fills(a, b, c); });
  graph.edges = edges.spanning;
  close_loops(graph, edges.closing, side);
  join_along_surface(graph, groups, patches);
  return graph;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_QUOTIENT_H
