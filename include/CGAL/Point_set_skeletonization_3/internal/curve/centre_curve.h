// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CENTRE_CURVE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CENTRE_CURVE_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/quantile.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/cross_section.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/points_across.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/round_section.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/visit_around.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>

#include <CGAL/number_utils.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Moves the vertices of a skeleton to the middle of the cross-sections of its limbs, smoothly.
///
/// The plane through a vertex orthogonal to its branch cuts the limb; the centroid c of the area of
/// the cross-section is the target of the vertex. It is known from a few points only. There is no
/// area if less than a third of the boundary was seen: where limbs join, vertices stay. In an open
/// limb there is none if less than half was seen (a leaf), or if it is scattered (a twig in leaf).
/// Then the target is the L1-median of the points of the cross-section, moved onto the sheet that
/// they are on, so that the curve stays on them, and the radius is their median distance from it. In
/// between, the target is between both: it would jump from one to the other, and the curve would
/// wave. If the points are on a circle, along half of a trunk, its centre is the target, in a limb
/// that is not resolved, too. A limb is round or not along some length, so where one cross-section
/// does not tell, those around it do: the curve would go from the axis to the points and back.
/// Medians that would fold the curve are ignored.
/// The positions x minimise the squared distances to the targets plus a bending energy,
///
///     sum w |x - c|^2 + sum (l / h)^4 |second difference of x|^2
///
/// with the share w of the boundary of the cross-section that is known, the distance h of vertices,
/// and a length l in proportion to the radius: limbs do not undulate within their own width. This
/// is a low-pass filter of fourth order: it keeps one half of a wave of length 2 pi l, and of ten
/// times that all but 1 in 10000. Cross-sections move with the skeleton, so a few rounds are
/// needed. A centroid outside the shape, as that of a channel, is ignored.
class Curve_centring
{
public:
  /// Tells for many places at once whether they are inside the shape.
  using Are_inside = std::function<std::vector<bool>(const std::vector<Vector3>&)>;

  /// Refers to all arguments.
  /// \param graph has roughly the radii of the limbs
  /// \param surface `surface[v]` are the surface points of vertex v before denoising, which shrinks
  ///        curved surfaces
  Curve_centring(Skeleton_graph& graph, const std::vector<std::vector<Vector3>>& surface,
                 const Are_inside& inside, const Curve_options& options,
                 Concurrency concurrency)
      : options_(options)
      , concurrency_(concurrency)
      , graph_(graph)
      , surface_(surface)
      , inside_(inside)
      , adjacency_(graph.adjacency())
      , start_(graph.vertices)
      , drawn_(graph.vertices.size())
  {
    for(std::size_t v = 0; v < drawn_.size(); ++v)
      drawn_[v].radius = first_radius(v);
  }

  /// Solves a sparse linear system in each of three rounds. Returns the median distance of the
  /// points of each vertex that is centred on them, 0 for the others.
  std::vector<double> run()
  {
    constexpr int rounds = 3; // each leaves a tenth of the distance
    for(int round = 0; round < rounds; ++round) {
      std::vector<std::size_t> moved; // since their targets were computed
      for(std::size_t v = 0; v < drawn_.size(); ++v) {
        const bool is_fixed = round > 0 && graph_.vertices[v].is_on_line &&
                              drawn_[v].target == start_[v].position;
        if(!is_fixed &&
           (graph_.vertices[v].position - drawn_[v].from).norm() >= stays * drawn_[v].radius)
          moved.push_back(v);
      }
      parallel_for(concurrency_, moved.size(),
                   [&](std::size_t k) { drawn_[moved[k]] = drawn(moved[k]); });
      keep_inside(moved);
      draw_axes_on();
      keep_in_order();
      move();
    }
    std::vector<double> distances;
    for(const Drawn& drawn : drawn_)
      distances.push_back(drawn.spread);
    return distances;
  }

private:
  /// What draws a vertex.
  struct Drawn
  {
    /// Position of the vertex when this was computed; nowhere at first.
    Vector3 from = Vector3::Constant(std::numeric_limits<double>::infinity());
    Vector3 middle = Vector3::Zero(); ///< Of its cross-section.
    double weight = 0;
    double radius = 0;        ///< Of the limb there, at least the distance of points.
    bool is_centroid = false; ///< Of an area, which contains it.
    bool is_median = false;   ///< Of points, or in part: they may be those of another limb.
    double spread = 0; ///< Median distance of the points from an L1-median or the centre of a
                       ///< circle; 0 elsewhere.
    double point_radius = 0; ///< Of an open limb, by its points; if 0 the next two are unknown.
    Vector3 median = Vector3::Zero(); ///< L1-median of the points.
    double axis_share = 0;    ///< How much of the middle is the axis of a round limb, not this.
    double unknown_share = 0; ///< How much of the middle, in [0, 1], the axis beside tells better.
    Vector3 target = Vector3::Zero(); ///< The middle, less what sections around know better.
  };

  /// Radii; a vertex that has moved less keeps its target: a target moves by at most a tenth of the
  /// distance that its vertex moves.
  static constexpr double stays = 0.02;

  /// Weight of a vertex without a cross-section: its neighbours dominate, its first position is the
  /// target.
  static constexpr double least_weight = 0.1;

  /// The radius of the limb at a vertex before there is a cross-section. That of an open limb is
  /// the median distance, across the limb, of the points of the vertex.
  double first_radius(std::size_t v) const
  {
    const Skeleton_graph::Vertex& vertex = graph_.vertices[v];
    const double radius = (std::max)(vertex.radius, vertex.resolution);
    if(!is_open(vertex) || surface_[v].empty())
      return radius;
    const Vector3 axis = piece_around(v, radius).axis;
    std::vector<double> distances;
    for(const Vector3& p : surface_[v]) {
      const Vector3 offset = p - vertex.position;
      distances.push_back((offset - axis.dot(offset) * axis).norm());
    }
    return (std::max)(radius, quantile(std::move(distances), 0.5));
  }

  /// The target of a vertex without a cross-section.
  Drawn not_drawn(std::size_t v, double radius) const
  {
    if(graph_.vertices[v].is_on_line)
      return {graph_.vertices[v].position, start_[v].position, 1, least_spacing};
    return {graph_.vertices[v].position, start_[v].position, least_weight, radius};
  }

  /// The target of a vertex.
  Drawn drawn(std::size_t v) const
  {
    const Skeleton_graph::Vertex& vertex = graph_.vertices[v];
    const double known = (std::max)(vertex.radius, vertex.resolution);
    const double radius = is_open(vertex) ? (std::max)(known, drawn_[v].radius) : known;
    const Piece piece = piece_around(v, radius);
    if(!(piece.half_chord > 0)) // a junction
      return not_drawn(v, radius);
    const Vector3 e1 = piece.axis.unitOrthogonal(), e2 = piece.axis.cross(e1);
    const auto in_space = [&](const Eigen::Vector2d& p) -> Vector3 {
      return vertex.position + p.x() * e1 + p.y() * e2;
    };
    const Slab slab = slab_at(v, piece, e1, e2, radius);
    const std::vector<Eigen::Vector2d>& points = slab.across;
    const Cross_section section = cross_section(points);
    // With a gap of 180 degrees the centroid is inaccurate, but better than none; it is not used
    // with a gap of 240 degrees.
    constexpr double half_unknown = CGAL_PI;
    const double weight = 1 - section.unknown / half_unknown;
    const double share =
      section.area > 0 && weight > least_weight ? share_of_area(vertex, weight) : 0;
    const double area_radius = (std::max)(radius, std::sqrt(section.area / CGAL_PI));
    if(share == 1 && !vertex.is_on_line)
      return {vertex.position, in_space(section.center), weight, area_radius, true};
    if(points.size() < (vertex.is_on_line ? fewest_on_circle : 1) || !is_open(vertex))
      return not_drawn(v, radius);
    const Points_across across = points_across(slab, 1 - share_seen(weight), vertex.facing,
                                               vertex.resolution, options_.aligned);
    const bool is_round = across.round_share > 0;
    const double point_radius = (std::max)(vertex.resolution, across.spread);
    const auto mean = [share](const auto& of_points, const auto& of_area) {
      return (1 - share) * of_points + share * of_area;
    };
    Drawn result;
    if(vertex.is_on_line && !is_round)
      result = not_drawn(v, radius);
    else if(share == 0 || is_round)
      result = {vertex.position, in_space(across.middle), 1, point_radius, false, !is_round,
                across.spread};
    else
      result = {vertex.position, in_space(mean(across.middle, section.center)), mean(1., weight),
                mean(point_radius, area_radius), false, true};
    result.point_radius = point_radius;
    result.median = in_space(across.median);
    result.axis_share = across.round_share;
    const double known_share = vertex.is_on_line || is_round ? across.round_share : share;
    // Points on all sides tell what is in the middle of them, and so does another limb opposite.
    result.unknown_share = (1 - vertex.facing) * (1 - known_share) *
                           (std::min)(1.0, section.unknown / between_points);
    return result;
  }

  /// Whether points are around a cross-section, in [0, 1]: not at all if the gap of the boundary is
  /// more than 180 degrees, wholly from 120 degrees on.
  static double share_seen(double weight)
  {
    constexpr double half_seen = 1. / 3, mostly_seen = 2. / 3; // the weights with these gaps
    return std::clamp((weight - half_seen) / (mostly_seen - half_seen), 0., 1.);
  }

  /// How much the area of a cross-section counts beside its points, in [0, 1]. In an open limb not
  /// at all if it is scattered, if points are not around it (the centroid of what was seen would be
  /// beside them), or as far as it faces another limb, which bounds no area of its own.
  double share_of_area(const Skeleton_graph::Vertex& vertex, double weight) const
  {
    if(!is_open(vertex))
      return 1;
    return vertex.evidence < options_.limb_evidence ? 0
                                                    : (1 - vertex.facing) * share_seen(weight);
  }

  /// Ignores centroids outside the shape.
  void keep_inside(std::vector<std::size_t> vertices)
  {
    vertices.erase(std::remove_if(vertices.begin(), vertices.end(),
                                  [&](std::size_t v) { return !drawn_[v].is_centroid; }),
                   vertices.end());
    std::vector<Vector3> targets;
    for(std::size_t v : vertices)
      targets.push_back(drawn_[v].middle);
    const std::vector<bool> is_inside = inside_(targets);
    for(std::size_t k = 0; k < vertices.size(); ++k)
      if(!is_inside[k])
        drawn_[vertices[k]] = not_drawn(vertices[k], first_radius(vertices[k]));
  }

  /// Sets the targets. Where a cross-section does not tell the middle of an open limb, the target
  /// is as far off the L1-median of its points as the axis of a round limb is beside it, within two
  /// radii. The middle of an area beside it tells nothing: a leaf that is rolled up opens.
  void draw_axes_on()
  {
    constexpr double reach = 2; // radii
    for(std::size_t v = 0; v < drawn_.size(); ++v) {
      Drawn& drawn = drawn_[v];
      drawn.target = drawn.middle;
      if(drawn.point_radius == 0)
        continue;
      double number = 0, known = 0, radius = 0;
      Vector3 offset = Vector3::Zero();
      for(std::size_t to : adjacency_[v])
        visit_along(v, to, reach * drawn.point_radius, [&](std::size_t w) {
          const Drawn& other = drawn_[w];
          if(other.point_radius == 0)
            return;
          ++number;
          known += other.axis_share;
          radius += other.axis_share * other.point_radius;
          offset += other.axis_share > 0 ? Vector3(other.middle - other.median) : Vector3::Zero();
        });
      if(!(known > 0))
        continue;
      const double share = drawn.unknown_share * known / number;
      drawn.target += share * (drawn.median + offset / known - drawn.middle);
      drawn.radius = (std::max)(drawn.radius, share * radius / known);
    }
  }

  /// Ignores medians of points that would fold or stretch a piece of a curve, a radius long:
  /// cross-sections follow each other along a limb. Planes across a curve that is short for the
  /// width of what was seen of a body meet on it, or cut it in places far from each other. The
  /// displacements of two vertices differ by no more than what turns the piece as far as limbs
  /// bend.
  void keep_in_order()
  {
    const double most = std::sqrt(1 - options_.aligned * options_.aligned); // share of length
    std::vector<bool> is_torn(drawn_.size(), false);
    for(std::size_t v = 0; v < drawn_.size(); ++v) {
      if(!drawn_[v].is_median)
        continue;
      for(std::size_t to : adjacency_[v]) {
        const std::size_t w = along(v, to, drawn_[v].radius);
        const Vector3 now = graph_.vertices[w].position - graph_.vertices[v].position,
                      then = drawn_[w].target - drawn_[v].target;
        if((then - now).norm() > most * now.norm())
          is_torn[v] = is_torn[w] = true;
      }
    }
    for(std::size_t v = 0; v < is_torn.size(); ++v)
      if(is_torn[v] && drawn_[v].is_median) {
        drawn_[v] = not_drawn(v, drawn_[v].radius);
        drawn_[v].target = drawn_[v].middle;
      }
  }

  /// A piece of a branch, approximated by a parabola.
  struct Piece
  {
    Vector3 axis = Vector3::Zero(); ///< Unit length, along the chord.
    Vector3 sag = Vector3::Zero();  ///< From the vertex to the middle of the chord.
    double half_chord = 0;          ///< 0: there is no such piece.
  };

  /// The piece around a vertex, `reach` to either side or to the end of the branch.
  Piece piece_around(std::size_t v, double reach) const
  {
    Piece result;
    const std::vector<std::size_t>& next = adjacency_[v];
    if(next.empty() || next.size() > 2)
      return result;
    const Vector3& here = graph_.vertices[v].position;
    const Vector3 to = graph_.vertices[along(v, next.front(), reach)].position;
    const Vector3 from = next.size() == 1 ? Vector3(2 * here - to) // a tip: straight on
                                          : graph_.vertices[along(v, next.back(), reach)].position;
    result.half_chord = (to - from).norm() / 2;
    if(result.half_chord > 0)
      result.axis = (to - from) / (2 * result.half_chord);
    result.sag = (to + from) / 2 - here;
    return result;
  }

  /// The surface points near the plane at a vertex, see `cut()`: a slab wide enough for a dozen
  /// points around a thin limb, narrow enough for varying thickness. In an open limb it is twice as
  /// wide if it takes that to have as many points as show whether the limb is round.
  Slab slab_at(std::size_t v, const Piece& piece, const Vector3& e1, const Vector3& e2,
               double radius) const
  {
    const double half_width = (std::max)(graph_.vertices[v].resolution, options_.step * radius);
    Slab result = cut(v, piece, e1, e2, radius, half_width);
    const std::size_t number = result.across.size();
    if(is_open(graph_.vertices[v]) && number < fewest_on_circle && 2 * number >= fewest_on_circle)
      result = cut(v, piece, e1, e2, radius, 2 * half_width);
    return result;
  }

  /// The surface points closer than `half_width` to the plane at a vertex spanned by `e1` and `e2`,
  /// moved across as far as the branch bends. The plane of an open limb may cut others that join it:
  /// beyond a junction, only what leads further away from the plane is of the same limb. One that
  /// was seen from all sides is cut as a whole, where others join it, too.
  Slab cut(std::size_t v, const Piece& piece, const Vector3& e1, const Vector3& e2, double radius,
           double half_width) const
  {
    // Points of the cross-section may belong to vertices further along the limb, not to other
    // limbs: within two radii, or, since a plane may cut a wide limb at an angle of up to 30 degrees
    // to a cross-section, half as far along the curve as they are away from the vertex.
    constexpr double reach = 2; // radii
    constexpr double slope = 0.5;
    double widest = 0;
    Slab result;
    const bool is_whole = !is_open(graph_.vertices[v]);
    const auto height = [&](std::size_t u) {
      return std::abs(piece.axis.dot(graph_.vertices[u].position - graph_.vertices[v].position));
    };
    const auto leads = [&](std::size_t u, std::size_t w) {
      return is_whole || adjacency_[u].size() <= 2 || height(w) > height(u);
    };
    visit_around(graph_, adjacency_, v, leads, [&](std::size_t u, double way) {
      const double least_width = way > half_width + reach * radius ? (way - half_width) / slope : 0;
      for(const Vector3& p : surface_[u]) {
        Vector3 d = p - graph_.vertices[v].position;
        const double z = piece.axis.dot(d);
        if(std::abs(z) >= half_width)
          continue;
        const double width = d.norm();
        if(width < least_width)
          continue;
        widest = (std::max)(widest, width);
        const double t = (std::min)(1.0, std::abs(z) / piece.half_chord);
        d -= t * t * piece.sag;
        result.across.emplace_back(e1.dot(d), e2.dot(d));
        result.along.push_back(z);
      }
      return least_width <= widest;
    });
    return result;
  }

  /// Calls `visit(w)` for the vertices from `v` through its neighbour `to` up to the first one at
  /// least `reach` away, or to the end of the branch.
  template <typename Visit>
  void visit_along(std::size_t v, std::size_t to, double reach, const Visit& visit) const
  {
    std::size_t from = v;
    double way = distance(from, to);
    visit(to);
    while(way < reach && adjacency_[to].size() == 2 && to != v) {
      const std::size_t next = adjacency_[to][0] == from ? adjacency_[to][1] : adjacency_[to][0];
      from = to;
      to = next;
      way += distance(from, to);
      visit(to);
    }
  }

  /// The last of these vertices.
  std::size_t along(std::size_t v, std::size_t to, double reach) const
  {
    std::size_t result = to;
    visit_along(v, to, reach, [&](std::size_t w) { result = w; });
    return result;
  }

  double distance(std::size_t v, std::size_t w) const
  {
    return (graph_.vertices[v].position - graph_.vertices[w].position).norm();
  }

  /// Solves the linear system for the positions.
  void move()
  {
    const auto size = static_cast<Eigen::Index>(drawn_.size());
    std::vector<Entry> entries;
    Eigen::MatrixX3d right(size, 3);
    for(std::size_t v = 0; v < drawn_.size(); ++v) {
      entries.emplace_back(static_cast<int>(v), static_cast<int>(v), drawn_[v].weight);
      right.row(static_cast<Eigen::Index>(v)) = drawn_[v].weight * drawn_[v].target.transpose();
      add_stiffness(v, entries);
    }
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    if(solver_.rows() == 0)
      solver_.analyzePattern(matrix); // the same in all rounds
    solver_.factorize(matrix);
    const Eigen::MatrixX3d solution = solver_.solve(right);
    for(std::size_t v = 0; v < drawn_.size(); ++v)
      graph_.vertices[v].position = solution.row(static_cast<Eigen::Index>(v)).transpose();
  }

  using Entry = Eigen::Triplet<double>;

  /// Adds the bending energy at a vertex. At a junction the second difference is that to the mean
  /// of the neighbours. Tips are free.
  void add_stiffness(std::size_t v, std::vector<Entry>& entries) const
  {
    const std::vector<std::size_t>& next = adjacency_[v];
    if(next.size() < 2)
      return;
    const double share = 1 / static_cast<double>(next.size());
    double h = 0;
    std::vector<std::pair<std::size_t, double>> difference{{v, -2.0}};
    for(std::size_t w : next) {
      h += share * distance(v, w);
      difference.emplace_back(w, 2 * share);
    }
    // Bounds the stiffness of short branches, whose vertices are closer.
    h = (std::max)(h, 0.1 * drawn_[v].radius);
    const double stiffness = std::pow(options_.stiffness * drawn_[v].radius / h, 4);
    for(const auto& a : difference)
      for(const auto& b : difference)
        entries.emplace_back(static_cast<int>(a.first), static_cast<int>(b.first),
                             stiffness * a.second * b.second);
  }

  const Curve_options& options_;
  Concurrency concurrency_;
  Skeleton_graph& graph_;
  const std::vector<std::vector<Vector3>>& surface_;
  const Are_inside& inside_;
  std::vector<std::vector<std::size_t>> adjacency_;
  const std::vector<Skeleton_graph::Vertex> start_;
  std::vector<Drawn> drawn_; ///< For each vertex.
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

/// Centres a skeleton in the cross-sections of its limbs; parameters as for `Curve_centring`. Three
/// sparse linear systems. Returns the median distance of the points of each vertex that is centred
/// on them, 0 for the others.
inline std::vector<double> centre_curve(Skeleton_graph& graph,
                                        const std::vector<std::vector<Vector3>>& surface,
                                        const Curve_centring::Are_inside& inside,
                                        const Curve_options& options, Concurrency concurrency)
{
  return Curve_centring(graph, surface, inside, options, concurrency).run();
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CENTRE_CURVE_H
