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
#include <CGAL/Point_set_skeletonization_3/internal/curve/continue_limbs.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/doubled_tips.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/extend_open_tips.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/join_fragments.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/limb_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/prune.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/refine_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/spread_of_limbs.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/stray_components.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/nearest_points.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <algorithm>
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

/// Fits a skeleton graph to the surface: first `connect()`, then `centre()`, each once.
class Curve_fitting
{
public:
  /// `points` are the surface points before denoising, and `noise`, in [0, 1], is its strength.
  /// `is_outlier` says which samples are dropped already. Refers to all other arguments.
  Curve_fitting(const Limb_curve& curve, std::vector<bool> is_outlier, const Surface& surface,
                const std::vector<Surface_point>& points, double noise,
                const Curve_options& options, Concurrency concurrency)
      : options_(options)
      , graph_(curve.graph)
      , is_outlier_(std::move(is_outlier))
      , surface_(surface)
      , samples_(curve.samples)
      , points_(points)
      , noise_(noise)
      , concurrency_(concurrency)
  {}

  /// Smooths the graph, connects it over gaps and drops what remains of stray components.
  /// \param is_frame whether limbs are continued over gaps so that cycles close
  void connect(bool is_frame, bool single_component)
  {
    smooth(graph_);
    resample();
    measure_radii();
    const std::vector<std::size_t> vertex_of_sample = vertices_of_samples();
    const std::vector<std::vector<Vector3>> surface = points_of_vertices(vertex_of_sample);
    widen_open_limbs(surface);
    bridge_gaps(graph_, surface, options_);
    std::vector<double> points = numbers_of_points(vertex_of_sample);
    join_fragments(graph_, points, options_);
    if(is_frame)
      continue_limbs(graph_, surface, options_);
    points.resize(graph_.vertices.size(), 0); // there are none in bridges
    drop(stray_vertices(graph_, points, options_.stray_share), vertex_of_sample);
    if(single_component)
      join_all(graph_);
    resample();
  }

  /// Centres the graph, moves the tips to the ends of limbs and measures the radii.
  void centre()
  {
    extend(centre_vertices());
    centre_vertices();
    measure_radii();
    graph_ = without(graph_, doubled_tips(graph_));
    const std::vector<std::vector<Vector3>> points = points_of_vertices();
    std::vector<std::vector<Vector3>> shown = components_of_vertices();
    for(std::size_t v = 0; v < points.size(); ++v)
      if(graph_.vertices[v].is_on_line) // what is scattered around a twig is no noise, but leaves
        shown[v] = points[v];
    constexpr double rings = 2; // around a limb: a single one is uneven
    set_spreads(graph_, shown, static_cast<std::size_t>(rings * options_.least_points),
                options_.thin_gap);
    if(noise_ > 0)
      correct_radii(points);
  }

  const Skeleton_graph& graph() const { return graph_; }

  /// The vertex nearest to each sample. O(n log n). \pre there is a vertex
  std::vector<std::size_t> vertices_of_samples() const
  {
    std::vector<Vector3> in_order; // samples next to each other in the tree are close
    for(std::size_t i : surface_.tree.order())
      in_order.push_back(samples_[i].position);
    return surface_.tree.by_index(
      nearest_points(Box_tree(positions_of(graph_)), in_order, concurrency_));
  }

  /// Whether each sample was dropped.
  const std::vector<bool>& is_outlier() const { return is_outlier_; }

private:
  /// Makes the radius of a vertex of an open limb at least the median distance of its points. Its
  /// other side was not seen, so the distance to the nearest patch tells nothing, and how far a tip
  /// points, and where to, would depend on it. `surface[v]` are the points of vertex v. O(n).
  void widen_open_limbs(const std::vector<std::vector<Vector3>>& surface)
  {
    for(std::size_t v = 0; v < surface.size(); ++v) {
      Skeleton_graph::Vertex& vertex = graph_.vertices[v];
      if(!is_open(vertex) || surface[v].empty())
        continue;
      std::vector<double> distances;
      for(const Vector3& p : surface[v])
        distances.push_back((p - vertex.position).norm());
      vertex.radius = (std::max)(vertex.radius, quantile(std::move(distances), 0.5));
    }
  }

  /// Resamples to the steps that the options ask for, or longer ones (where points coincide): a
  /// skeleton has no more vertices than samples. On lines, steps are short: it turns at each point.
  void resample()
  {
    double length = 0;
    for(const Skeleton_graph::Edge& e : graph_.edges)
      length += (graph_.vertices[e.first].position - graph_.vertices[e.second].position).norm();
    const double least = length / static_cast<double>(samples_.size());
    graph_ = resampled(graph_, [&](const Skeleton_graph::Vertex& vertex) {
      const double step = (std::max)(vertex.resolution, options_.step * vertex.radius);
      return (std::max)(least, vertex.is_on_line ? half_a_spacing * step : step);
    });
  }

  /// Drops vertices; their samples are outliers.
  void drop(const std::vector<bool>& vertices, const std::vector<std::size_t>& vertex_of_sample)
  {
    for(std::size_t i = 0; i < samples_.size(); ++i)
      is_outlier_[i] = is_outlier_[i] || vertices[vertex_of_sample[i]];
    graph_ = without(graph_, vertices);
  }

  /// Returns what `centre_curve()` returns.
  std::vector<double> centre_vertices()
  {
    measure_radii();
    return centre_curve(
      graph_, points_of_vertices(),
      [this](const std::vector<Vector3>& places) { return are_inside(places); }, options_,
      concurrency_);
  }

  /// Moves the tips to the ends of limbs. `spreads` is what centring returned.
  void extend(const std::vector<double>& spreads)
  {
    const std::vector<std::vector<Vector3>> points = points_of_vertices();
    measure_radii();
    if(noise_ > 0)
      correct_radii(points);
    extend_tips(graph_, points, [this](const Vector3& q) { return is_inside(q); });
    extend_open_tips(graph_, components_of_vertices(), spreads, options_);
    resample();
  }

  /// Whether a place is inside. With noise the threshold is lower: winding numbers in thin limbs
  /// are unreliable.
  bool is_inside(const Vector3& q) const
  {
    return surface_.winding_number(q) >= surface_.options.least_inside - noise_;
  }

  /// The same, in packets of places that are close to each other.
  std::vector<bool> are_inside(const std::vector<Vector3>& places) const
  {
    const Box_tree tree(places);
    std::vector<Vector3> in_order;
    for(std::size_t i : tree.order())
      in_order.push_back(places[i]);
    const std::vector<double> values =
      tree.by_index(surface_.winding_number.at_places(in_order, concurrency_));
    std::vector<bool> result;
    for(double value : values)
      result.push_back(value >= surface_.options.least_inside - noise_);
    return result;
  }

  /// Sets the radius of each vertex to the distance of the nearest visible patch, if there is one.
  void measure_radii()
  {
    const std::vector<double> radii =
      surface_.visible.distances(positions_of(graph_), concurrency_);
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

  /// The number of points of each vertex, without outliers.
  std::vector<double> numbers_of_points(const std::vector<std::size_t>& vertex_of_sample) const
  {
    std::vector<double> result(graph_.vertices.size(), 0);
    for(std::size_t i = 0; i < samples_.size(); ++i)
      if(!is_outlier_[i])
        result[vertex_of_sample[i]] += surface_.patches[i].weight;
    return result;
  }

  /// The surface points of each vertex, without outliers.
  std::vector<std::vector<Vector3>>
  points_of_vertices(const std::vector<std::size_t>& vertex_of_sample) const
  {
    std::vector<std::vector<Vector3>> result(graph_.vertices.size());
    for(const Surface_point& point : points_)
      if(!is_outlier_[point.sample])
        result[vertex_of_sample[point.sample]].push_back(point.position);
    return result;
  }

  std::vector<std::vector<Vector3>> points_of_vertices() const
  {
    return points_of_vertices(vertices_of_samples());
  }

  /// The mixture components of each vertex, without outliers: surface points after denoising.
  std::vector<std::vector<Vector3>> components_of_vertices() const
  {
    const std::vector<std::size_t> vertex_of_sample = vertices_of_samples();
    std::vector<std::vector<Vector3>> result(graph_.vertices.size());
    for(std::size_t i = 0; i < samples_.size(); ++i)
      if(!is_outlier_[i])
        for(std::size_t k : surface_.groups[i])
          result[vertex_of_sample[i]].push_back(surface_.components[k]);
    return result;
  }

  const Curve_options& options_;
  Skeleton_graph graph_;
  std::vector<bool> is_outlier_; ///< For each sample.
  const Surface& surface_;
  const Samples& samples_;
  const std::vector<Surface_point>& points_;
  double noise_;
  Concurrency concurrency_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_FIT_CURVE_H
