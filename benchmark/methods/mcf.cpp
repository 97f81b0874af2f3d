// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mcf.h"

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>

#include <stdexcept>

Method_result mcf(const Method_input& input)
{
  using Flow_skeleton = CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton;
  Method_result result;
  Skeleton& all = result.skeleton;
  timed_stage(result, "skeleton", [&] {
    for(const Mesh& component : input.components) {
      if(!CGAL::is_closed(component))
        throw std::runtime_error("mesh is open");
      Flow_skeleton part;
      CGAL::extract_mean_curvature_flow_skeleton(component, part);
      const auto first = num_vertices(all);
      for(const auto v : CGAL::make_range(vertices(part)))
        all[add_vertex(all)].point = part[v].point;
      for(const auto e : CGAL::make_range(edges(part)))
        add_edge(first + source(e, part), first + target(e, part), all);
    }
  });
  return result;
}
