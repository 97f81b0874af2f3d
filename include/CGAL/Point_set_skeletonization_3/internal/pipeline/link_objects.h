// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LINK_OBJECTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LINK_OBJECTS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/bridge_gaps.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/fit_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/join_fragments.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/prune.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/stray_components.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/Linking_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/link_samples.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/medial_objects.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The surface points of an object before denoising, those of one sample consecutive. O(n log n).
inline std::vector<Surface_point> surface_points(const Medial_object& object,
                                                 const Gaussians& mixture)
{
  std::vector<Surface_point> result;
  result.reserve(object.components.size());
  for(std::size_t k = 0; k < object.components.size(); ++k)
    if(const std::size_t patch = object.patch_of(k); patch != Medial_object::none)
      result.push_back({patch, mixture[object.components[k]].mean});
  const auto is_before = [](const Surface_point& a, const Surface_point& b) {
    return a.sample < b.sample;
  };
  std::stable_sort(result.begin(), result.end(), is_before);
  return result;
}

/// Appends the skeleton of the next object. O(n).
inline void append(const Linked_samples& next, Linked_samples& all)
{
  const std::size_t first = all.graph.vertices.size();
  all.graph.vertices.insert(all.graph.vertices.end(), next.graph.vertices.begin(),
                            next.graph.vertices.end());
  for(const Skeleton_graph::Edge& e : next.graph.edges)
    all.graph.edges.emplace_back(first + e.first, first + e.second);
  for(const std::size_t v : next.vertex_of_sample)
    all.vertex_of_sample.push_back(v == Linked_samples::none ? v : first + v);
}

/// The number of points of each vertex, without outliers. O(n).
inline std::vector<double> numbers_of_points(const Linked_samples& linked,
                                             const std::vector<Medial_object>& objects)
{
  std::vector<double> result(linked.graph.vertices.size(), 0);
  auto vertex = linked.vertex_of_sample.begin();
  for(const Medial_object& object : objects)
    for(const Patch& patch : object.medial.surface.patches)
      if(const std::size_t v = *vertex++; v != Linked_samples::none)
        result[v] += patch.weight;
  return result;
}

/// Drops what is stray beside the largest component of a scene: in an object of a hundred points two
/// would be more than a share of it. O(n).
/// \param points number of points of each vertex
inline void drop_strays(Linked_samples& linked, const std::vector<double>& points,
                        double stray_share)
{
  const std::vector<bool> is_stray = stray_vertices(linked.graph, points, stray_share);
  std::vector<std::size_t> number;
  std::size_t kept = 0;
  for(bool stray : is_stray)
    number.push_back(stray ? Linked_samples::none : kept++);
  for(std::size_t& v : linked.vertex_of_sample)
    if(v != Linked_samples::none)
      v = number[v];
  linked.graph = without(linked.graph, is_stray);
}

/// Stage 3: returns the curve skeleton of a scene, and the vertex of each sample of one object after
/// the other. Each is linked by itself; then what was seen of one may turn out to be a fragment of
/// another. O(n log n) in practice.
/// \param mixture as it was measured
inline Linked_samples link_objects(const std::vector<Medial_object>& objects,
                                   const Gaussians& mixture, const Linking_options& options,
                                   Concurrency concurrency, const Progress& progress)
{
  std::size_t all = 0, done = 0;
  for(const Medial_object& object : objects)
    all += object.medial.samples.size();
  const auto share = [&] { return static_cast<double>(done) / static_cast<double>(all); };
  Linked_samples result;
  for(const Medial_object& object : objects) {
    const Medial_surface& medial = object.medial;
    const double begin = share();
    done += medial.samples.size();
    append(link_samples(medial.surface, medial.samples, medial.consolidated.noise,
                        surface_points(object, mixture), options, concurrency,
                        progress.part(begin, share())),
           result);
  }
  if(objects.size() > 1) {
    const std::vector<double> points = numbers_of_points(result, objects);
    join_fragments(result.graph, points, options.curve);
    drop_strays(result, points, options.curve.stray_share);
    if(options.known.single_component)
      join_all(result.graph);
  }
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LINK_OBJECTS_H
