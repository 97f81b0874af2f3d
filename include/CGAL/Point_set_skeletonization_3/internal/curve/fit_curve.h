// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_FIT_CURVE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_FIT_CURVE_H

#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/quantile.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/bridge_gaps.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/centre_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/refine_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Float_packet.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/nearest_points.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A point of the surface, and its sample.
struct Surface_point
{
  std::size_t sample;
  Vector3 position;
};

/// Returns the vertex nearest to each sample. O(n log n). \pre there is a vertex
inline std::vector<std::size_t> vertices_of_samples(const Skeleton_graph& graph,
                                                    const Surface& surface, const Samples& samples,
                                                    Concurrency concurrency)
{
  std::vector<Vector3> vertices, in_order; // samples next to each other in the tree are close
  for(const Skeleton_graph::Vertex& vertex : graph.vertices)
    vertices.push_back(vertex.position);
  for(std::size_t i : surface.tree.order())
    in_order.push_back(samples[i].position);
  return surface.tree.by_index(nearest_points(Box_tree(vertices), in_order, concurrency));
}

/// Fits a skeleton graph to the surface.
class Curve_fitting
{
public:
  /// `points` are the surface points before denoising, without outliers; `noise`, in [0, 1], is its
  /// strength. Refers to all but the graph.
  Curve_fitting(Skeleton_graph graph, const Surface& surface, const Samples& samples,
                const std::vector<Surface_point>& points, double noise,
                const Curve_options& options, Concurrency concurrency)
      : options_(options)
      , graph_(std::move(graph))
      , surface_(surface)
      , samples_(samples)
      , points_(points)
      , noise_(noise)
      , concurrency_(concurrency)
  {}

  /// Smooths the graph, bridges gaps, centres it, moves the tips to the ends of limbs and measures
  /// the radii. To be called once.
  Skeleton_graph run(bool single_component)
  {
    smooth(graph_);
    resample();
    measure_radii();
    bridge(single_component);
    centre();
    extend();
    centre();
    measure_radii();
    if(noise_ > 0)
      correct_radii(points_of_vertices());
    return std::move(graph_);
  }

private:
  /// Resamples to the steps that the options ask for, or longer ones (where points coincide): a
  /// skeleton has no more vertices than samples.
  void resample()
  {
    double length = 0;
    for(const Skeleton_graph::Edge& e : graph_.edges)
      length += (graph_.vertices[e.first].position - graph_.vertices[e.second].position).norm();
    const double least = length / static_cast<double>(samples_.size());
    graph_ = resampled(graph_, [&](const Skeleton_graph::Vertex& vertex) {
      return (std::max)({least, vertex.resolution, options_.step * vertex.radius});
    });
  }

  void bridge(bool single_component)
  {
    Bridging bridging(graph_, points_of_vertices(), options_);
    bridging.bridge_gaps();
    if(single_component)
      bridging.join_all();
    resample();
  }

  void centre()
  {
    measure_radii();
    centre_curve(
      graph_, points_of_vertices(),
      [this](const std::vector<Vector3>& places) { return are_inside(places); }, options_,
      concurrency_);
  }

  void extend()
  {
    const std::vector<std::vector<Vector3>> points = points_of_vertices();
    measure_radii();
    if(noise_ > 0)
      correct_radii(points);
    extend_tips(graph_, points, [this](const Vector3& q) { return is_inside(q); });
    resample();
  }

  /// Whether a place is inside. With noise the threshold is lower: winding numbers in thin limbs
  /// are unreliable.
  bool is_inside(const Vector3& q) const
  {
    return surface_.winding_number(q) >= surface_.options.least_inside - noise_;
  }

  /// In packets of places that are close to each other. Where the result is close, packets in the
  /// order of the vertices decide, some of them wide: patches inside count one by one.
  std::vector<bool> are_inside(const std::vector<Vector3>& places) const
  {
    constexpr double error = 0.06; // twice that of groups
    const double least = surface_.options.least_inside - noise_;
    const Box_tree tree(places);
    std::vector<Vector3> in_order, doubtful;
    for(std::size_t i : tree.order())
      in_order.push_back(places[i]);
    std::vector<double> values =
      tree.by_index(surface_.winding_number.at_places(in_order, concurrency_));
    std::vector<std::size_t> again; // whole packets
    for(std::size_t first = 0; first < places.size(); first += packet_size) {
      const std::size_t end = (std::min)(first + packet_size, places.size());
      bool is_close = false;
      for(std::size_t k = first; k < end; ++k)
        is_close = is_close || std::abs(values[k] - least) < error;
      for(std::size_t k = first; is_close && k < end; ++k) {
        again.push_back(k);
        doubtful.push_back(places[k]);
      }
    }
    const std::vector<double> exact = surface_.winding_number.at_places(doubtful, concurrency_);
    for(std::size_t k = 0; k < again.size(); ++k)
      values[again[k]] = exact[k];
    std::vector<bool> result;
    for(double value : values)
      result.push_back(value >= least);
    return result;
  }

  /// Sets the radius of each vertex to the distance of the nearest visible patch, if there is one.
  void measure_radii()
  {
    std::vector<Vector3> places;
    for(const Skeleton_graph::Vertex& vertex : graph_.vertices)
      places.push_back(vertex.position);
    const std::vector<double> radii = surface_.visible.distances(places, concurrency_);
    for(std::size_t v = 0; v < radii.size(); ++v)
      if(radii[v] > 0)
        graph_.vertices[v].radius = radii[v];
  }

  /// Raises radii to the lower quartile of the distances of surface points, or a share of it if the
  /// strength of the noise is below one half. With noise, some patch is always nearer than the
  /// surface, and none is left around a limb as thin as the noise. A vertex has few points, so
  /// those of adjacent vertices count too, except for tips, whose points lie in front. Not used
  /// without noise: cross-sections need not be round.
  void correct_radii(const std::vector<std::vector<Vector3>>& points)
  {
    const auto adjacency = graph_.adjacency();
    for(std::size_t v = 0; v < points.size(); ++v) {
      std::vector<std::size_t> near = adjacency[v];
      near.push_back(v);
      std::vector<double> distances;
      for(std::size_t w : near)
        if(adjacency[w].size() != 1)
          for(const Vector3& p : points[w])
            distances.push_back((p - graph_.vertices[w].position).norm());
      double& radius = graph_.vertices[v].radius;
      if(!distances.empty())
        radius = (std::max)(radius, (std::min)(1.0, 2 * noise_) *
                                      quantile(std::move(distances), 0.25));
    }
  }

  /// The surface points of each vertex.
  std::vector<std::vector<Vector3>> points_of_vertices() const
  {
    const std::vector<std::size_t> vertex_of_sample =
      vertices_of_samples(graph_, surface_, samples_, concurrency_);
    std::vector<std::vector<Vector3>> result(graph_.vertices.size());
    for(const Surface_point& point : points_)
      result[vertex_of_sample[point.sample]].push_back(point.position);
    return result;
  }

  const Curve_options& options_;
  Skeleton_graph graph_;
  const Surface& surface_;
  const Samples& samples_;
  const std::vector<Surface_point>& points_;
  double noise_;
  Concurrency concurrency_;
};

/// Part 3d: returns a curve through the middle of the limbs that a graph connects; see
/// `Curve_fitting`. O(n log n) in practice, with six sparse linear systems.
/// \pre there is a vertex
inline Skeleton_graph fit_curve(Skeleton_graph graph, const Surface& surface,
                                const Samples& samples, const std::vector<Surface_point>& points,
                                double noise, bool single_component, const Curve_options& options,
                                Concurrency concurrency)
{
  return Curve_fitting(std::move(graph), surface, samples, points, noise, options, concurrency)
    .run(single_component);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_FIT_CURVE_H
