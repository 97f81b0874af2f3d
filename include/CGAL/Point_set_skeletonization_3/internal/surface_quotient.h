// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_QUOTIENT_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_QUOTIENT_H

#include <CGAL/Point_set_skeletonization_3/internal/Neighbor_search.h>
#include <CGAL/Point_set_skeletonization_3/internal/essential_cycles.h>
#include <CGAL/Point_set_skeletonization_3/internal/patch_adjacency.h>
#include <CGAL/Point_set_skeletonization_3/internal/samples.h>
#include <CGAL/Point_set_skeletonization_3/internal/skeleton_branches.h>
#include <CGAL/Point_set_skeletonization_3/internal/solid_side.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Samples that stand for the same place of the skeleton.
struct Sample_groups
{
  std::vector<std::size_t> group_of_sample;
  std::vector<Skeleton_graph::Vertex> groups;
};

/// Samples closer than this share of the local radius are one place: a ball is covered by a few
/// groups, and a limb keeps its bends.
constexpr double group_reach = 0.5;

/// Covers the samples by balls of `group_reach` times their radius, the thickest first. Such a ball
/// lies deep inside the solid, so what it covers belongs together.
inline Sample_groups group_samples(const std::vector<Sample>& samples,
                                   const std::vector<Patch>& patches)
{
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> order(samples.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return samples[a].radius != samples[b].radius ? samples[a].radius > samples[b].radius : a < b;
  });

  const Neighbor_search search(samples.size(), [&](std::size_t i) { return samples[i].position; });
  Sample_groups result;
  result.group_of_sample.assign(samples.size(), none);
  std::vector<std::size_t> covered;
  for(std::size_t seed : order) {
    if(result.group_of_sample[seed] != none)
      continue;
    // No place can be told from another within half the spacing of the patches.
    const double reach = group_reach * std::max(samples[seed].radius, patches[seed].spacing);
    search.within(samples[seed].position, reach, covered);
    covered.push_back(seed); // within() may leave out what lies on its sphere
    Skeleton_graph::Vertex group{Vector3::Zero(), 0};
    double count = 0;
    for(std::size_t i : covered) {
      if(result.group_of_sample[i] != none)
        continue;
      result.group_of_sample[i] = result.groups.size();
      group.position += samples[i].position - samples[seed].position;
      group.radius += samples[i].radius;
      count += 1;
    }
    group.position = samples[seed].position + group.position / count;
    group.radius /= count;
    result.groups.push_back(group);
  }
  return result;
}

/// Groups further apart than this many radii of the larger are not asked whether they see each
/// other: a junction of limbs lies within two radii of the body they leave.
constexpr double sight_reach = 2;

/// The complex that carries the shape's topology: groups of samples that see each other inside the
/// solid.
class Visibility_complex
{
public:
  Visibility_complex(const std::vector<Skeleton_graph::Vertex>& groups, const Solid_side& side)
    : groups_(groups), side_(side)
  {}

  /// Whether the segment between two groups stays in the solid. The ball of one may hold the other:
  /// then there is nothing to ask.
  bool sees(std::size_t a, std::size_t b) const
  {
    return length(a, b) < std::max(groups_[a].radius, groups_[b].radius) ||
           !side_.leaves_solid(groups_[a].position, groups_[b].position);
  }

  /// Whether the triangle between three groups that see each other stays in the solid: not if there
  /// is a hole narrower than the triangle.
  bool fills(std::size_t a, std::size_t b, std::size_t c) const
  {
    const double radius = std::max({groups_[a].radius, groups_[b].radius, groups_[c].radius});
    if(length(a, b) < radius && length(b, c) < radius && length(c, a) < radius)
      return true;
    const Vector3 center = (groups_[a].position + groups_[b].position + groups_[c].position) / 3;
    return !side_.leaves_solid(groups_[a].position, center) &&
           !side_.leaves_solid(groups_[b].position, center) &&
           !side_.leaves_solid(groups_[c].position, center);
  }

  double length(std::size_t a, std::size_t b) const
  {
    return (groups_[a].position - groups_[b].position).norm();
  }

private:
  const std::vector<Skeleton_graph::Vertex>& groups_;
  const Solid_side& side_;
};

/// Pairs of groups that are worth asking: their patches are adjacent on the surface, or they are
/// close for their size. Shortest first, without duplicates.
inline std::vector<Skeleton_graph::Edge> neighboring_groups(const Sample_groups& groups,
                                                            const std::vector<Patch>& patches)
{
  std::vector<Skeleton_graph::Edge> edges;
  const auto add = [&](std::size_t a, std::size_t b) {
    if(a != b)
      edges.emplace_back(std::min(a, b), std::max(a, b));
  };
  for(std::size_t i = 0; i < patches.size(); ++i)
    for(std::size_t j : patches[i].neighbors)
      add(groups.group_of_sample[i], groups.group_of_sample[j]);

  const Neighbor_search search(groups.groups.size(),
                               [&](std::size_t g) { return groups.groups[g].position; });
  std::vector<std::size_t> near;
  for(std::size_t g = 0; g < groups.groups.size(); ++g) {
    search.within(groups.groups[g].position, sight_reach * groups.groups[g].radius, near);
    for(std::size_t h : near)
      add(g, h);
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  const auto squared_length = [&](const Skeleton_graph::Edge& e) {
    return (groups.groups[e.first].position - groups.groups[e.second].position).squaredNorm();
  };
  std::stable_sort(edges.begin(), edges.end(),
                   [&](const Skeleton_graph::Edge& a, const Skeleton_graph::Edge& b) {
                     return squared_length(a) < squared_length(b);
                   });
  return edges;
}

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

/// The path between two vertices of a forest.
inline std::vector<std::size_t> forest_path(std::size_t from, std::size_t to,
                                            const std::vector<std::vector<std::size_t>>& forest)
{
  std::vector<std::size_t> previous(forest.size(), forest.size()), front{from};
  previous[from] = from;
  for(std::size_t k = 0; k < front.size() && previous[to] == forest.size(); ++k)
    for(std::size_t v : forest[front[k]])
      if(previous[v] == forest.size()) {
        previous[v] = front[k];
        front.push_back(v);
      }
  std::vector<std::size_t> path{to};
  while(path.back() != from)
    path.push_back(previous[path.back()]);
  return path;
}

/// An edge of a loop that is blocked more than this leads through a contact of two limbs. A tube
/// blocks its axis hardly, a bend or a junction on the way to a third.
constexpr double contact = 0.4;

/// The points of a closed curve half a turn away from its vertices, with their radii.
inline std::vector<Skeleton_graph::Vertex> half_a_turn_away(const std::vector<std::size_t>& loop,
                                                            const Skeleton_graph& graph)
{
  Branch twice(loop.begin(), loop.end());
  twice.insert(twice.end(), loop.begin(), loop.end());
  twice.push_back(loop.front());
  const double half = length(twice, graph) / 4;
  std::vector<Skeleton_graph::Vertex> result;
  double s = 0;
  for(std::size_t k = 0; k < loop.size(); ++k) {
    result.push_back(point_at(s + half, twice, graph));
    s += (graph.vertices[twice[k + 1]].position - graph.vertices[twice[k]].position).norm();
  }
  return result;
}

/// Whether opposite balls of a closed curve keep clear of each other. Around a hole they do: there
/// is the hole between them. A curve that runs back along itself is no loop.
inline bool is_open(const std::vector<std::size_t>& loop, const Skeleton_graph& graph,
                    double spacing)
{
  constexpr double overlap = 0.75; // balls of patches, not of points, may overlap a little
  const std::vector<Skeleton_graph::Vertex> opposite = half_a_turn_away(loop, graph);
  for(std::size_t k = 0; k < loop.size(); ++k) {
    const Skeleton_graph::Vertex& v = graph.vertices[loop[k]];
    // A hole narrower than half a patch cannot be seen.
    if((v.position - opposite[k].position).norm() <
       overlap * (v.radius + opposite[k].radius) + spacing / 2)
      return false;
  }
  return true;
}

/// Whether a closed curve goes around air. Every surface that spans the loop of a solid leaves the
/// solid; so if only one - here the fan from the centre of gravity - stays in it, the loop can be
/// contracted and is none.
inline bool spans_air(const std::vector<std::size_t>& loop, const Skeleton_graph& graph,
                      const Solid_side& side)
{
  if(!is_open(loop, graph, side.spacing()))
    return false;
  Vector3 center = Vector3::Zero();
  for(std::size_t v : loop)
    center += graph.vertices[v].position / static_cast<double>(loop.size());
  for(std::size_t k = 0; k < loop.size(); ++k) {
    const Vector3& a = graph.vertices[loop[k]].position;
    const Vector3& b = graph.vertices[loop[(k + 1) % loop.size()]].position;
    if(side.leaves_solid(a, center) || side.leaves_solid((a + b) / 2, center))
      return true;
  }
  return false;
}

/// The edge of a loop that is blocked most, and how much. Edges shorter than half a patch do not
/// count: their middle is as good as their ends.
inline std::pair<Skeleton_graph::Edge, double> most_blocked(const std::vector<std::size_t>& loop,
                                                            const Skeleton_graph& graph,
                                                            const Solid_side& side)
{
  std::pair<Skeleton_graph::Edge, double> worst{{0, 0}, 0};
  for(std::size_t k = 0; k < loop.size(); ++k) {
    const std::size_t u = loop[k], v = loop[(k + 1) % loop.size()];
    const Vector3& a = graph.vertices[u].position;
    const Vector3& b = graph.vertices[v].position;
    const double blocked = (b - a).norm() > side.spacing() / 2 ? side.blocked(a, b) : 0;
    if(blocked > worst.second)
      worst = {{std::min(u, v), std::max(u, v)}, blocked};
  }
  return worst;
}

/// Adds to a forest the edges that close loops around air. A loop through a contact is opened
/// there, which may be anywhere on it, and not where it happened to be closed.
inline void close_loops(Skeleton_graph& graph, const std::vector<Skeleton_graph::Edge>& closing,
                        const Solid_side& side)
{
  std::vector<Skeleton_graph::Edge> loops;
  for(const Skeleton_graph::Edge& e : closing) {
    const std::vector<std::size_t> loop = forest_path(e.first, e.second, graph.adjacency());
    if(!spans_air(loop, graph, side))
      continue;
    const auto worst = most_blocked(loop, graph, side);
    if(worst.second <= contact)
      loops.push_back(e);
    else
      std::replace(graph.edges.begin(), graph.edges.end(), worst.first, e); // if it is not e itself
  }
  graph.edges.insert(graph.edges.end(), loops.begin(), loops.end());
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
