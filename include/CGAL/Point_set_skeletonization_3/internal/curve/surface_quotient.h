// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_SURFACE_QUOTIENT_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_SURFACE_QUOTIENT_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/l1_median.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/minimum_spanning_forest.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Region_merging.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Ball_overlaps.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Local_separator.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The graph of the separators and the pieces that they cut the surface into, and the vertex of
/// each patch.
struct Surface_quotient
{
  /// A handle that one separator cuts: the same piece is on both of its sides. An extra vertex on
  /// the cycle, in the middle of the second side, avoids parallel edges.
  struct Handle
  {
    std::size_t separator, piece, extra; ///< Vertices.
  };

  Skeleton_graph graph;
  std::vector<std::size_t> vertex_of_patch;
  std::vector<Handle> handles; ///< By their separators.

  /// The patches in whose middle each vertex is: its own; of a piece without any, which is between
  /// adjacent separators, theirs.
  std::vector<std::vector<std::size_t>> members;

  static constexpr std::size_t no_piece = (std::numeric_limits<std::size_t>::max)();

  /// The piece that each vertex is: itself, or the first of the fronts around handles that a piece
  /// was divided into; `no_piece` if it is none, as a separator.
  std::vector<std::size_t> piece_of;
};

/// Cuts the surface along separators (union-find). Each separator is a vertex between the pieces on
/// its two sides, so that the graph has the cycles of the surface: separators cut a handle open,
/// its pieces connect them. All patches on one side of a separator are in one piece, even if they
/// are not connected.
///
/// To the points, limbs that touch are one surface. So adjacent patches are in one piece only if
/// the medial balls on both sides of the border between them overlap (`Region_merging`), or if
/// they would be disconnected otherwise: a weak overlap may connect components but never closes a
/// cycle. O(n log² n) in practice.
class Surface_cut
{
public:
  Surface_cut(const Patches& patches, const Ball_overlaps& overlaps,
              const std::vector<Local_separator>& separators)
    : separators_(separators), separator_of_patch_(patches.size(), none),
      sets_(2 * separators.size() + patches.size())
  {
    for(std::size_t s = 0; s < separators.size(); ++s)
      for(std::size_t i : separators[s].patches)
        separator_of_patch_[i] = s;

    const std::size_t nodes = 2 * separators.size() + patches.size();
    std::vector<Border_link> links = join_certain(overlaps);
    Region_merging(sets_, nodes, links, overlaps.least_overlap()).run();
    Union_find whole = sets_; // the two sides of each separator joined
    for(std::size_t s = 0; s < separators.size(); ++s)
      whole.join(node(s, 0), node(s, 1));
    for(const Border_link& link : minimum_spanning_forest(whole, nodes, std::move(links)))
      sets_.join(link.a, link.b);
  }

  /// The separator of a patch; `none` if it is in a piece.
  std::size_t separator(std::size_t patch) const { return separator_of_patch_[patch]; }
  /// Identifier of the piece of a patch. \pre it is on no separator
  std::size_t piece(std::size_t patch) { return sets_.find(node(patch)); }
  /// Identifier of the piece on a side, 0 or 1, of a separator.
  std::size_t piece(std::size_t separator, std::size_t side)
  {
    return sets_.find(node(separator, side));
  }

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

private:
  // Nodes: the two sides of every separator, then every patch.
  std::size_t node(std::size_t separator, std::size_t side) const { return 2 * separator + side; }
  std::size_t node(std::size_t patch) const { return 2 * separators_.size() + patch; }

  /// Joins adjacent nodes where measured balls overlap wholly; returns the other links.
  std::vector<Border_link> join_certain(const Ball_overlaps& overlaps)
  {
    std::vector<Border_link> links;
    for(std::size_t k = 0; k < overlaps.pairs().size(); ++k) {
      const auto [i, j] = overlaps.pairs()[k];
      if(separator_of_patch_[i] != none && separator_of_patch_[i] == separator_of_patch_[j])
        continue;
      const std::size_t a = end(i, j), b = end(j, i);
      if(a == none || b == none)
        continue;
      if(overlaps.is_measured(k) && overlaps[k] >= 1)
        sets_.join(a, b);
      else
        links.push_back({a, b, i, j, overlaps[k], overlaps.is_measured(k)});
    }
    return links;
  }

  /// The node of patch `i` towards patch `j`: its own or, on a separator, that of the side of `j`;
  /// `none` if `j` is on neither side.
  std::size_t end(std::size_t i, std::size_t j) const
  {
    const std::size_t s = separator_of_patch_[i];
    if(s == none)
      return node(i);
    for(std::size_t side = 0; side < 2; ++side) {
      const std::vector<std::size_t>& beside = separators_[s].sides[side];
      if(std::binary_search(beside.begin(), beside.end(), j))
        return node(s, side);
    }
    return none;
  }

  const std::vector<Local_separator>& separators_;
  std::vector<std::size_t> separator_of_patch_;
  Union_find sets_;
};

/// Returns the patches of each of `vertices` vertices, ascending. O(n).
inline std::vector<std::vector<std::size_t>>
patches_of_vertices(const std::vector<std::size_t>& vertex_of_patch, std::size_t vertices)
{
  std::vector<std::vector<std::size_t>> result(vertices);
  for(std::size_t i = 0; i < vertex_of_patch.size(); ++i)
    result[vertex_of_patch[i]].push_back(i);
  return result;
}

/// Whether more than half of some patches are marked.
inline bool are_mostly(const std::vector<std::size_t>& members, const std::vector<bool>& is_marked)
{
  const auto marked = std::count_if(members.begin(), members.end(),
                                    [&](std::size_t i) { return is_marked[i]; });
  return 2 * static_cast<std::size_t>(marked) > members.size();
}

/// Whether a vertex of a quotient is a piece with patches of its own.
inline bool is_piece(std::size_t vertex, const Surface_quotient& quotient)
{
  return !quotient.graph.vertices[vertex].is_cross_section &&
         quotient.vertex_of_patch[quotient.members[vertex].front()] == vertex;
}

/// How a middle is averaged.
enum class Average
{
  median, ///< The L1-median of all alike, whatever samples went astray.
  mean,   ///< The mean, with the components of patches as weights: across a wide piece of surface
          ///< the median follows those that are divided finely, along one it is ill-determined.
};

/// Returns the middle of some samples, their mean radius, the mean resolution and distance of their
/// patches, and the share that is on its patch. O(samples). \pre there is a sample
inline Skeleton_graph::Vertex middle(const std::vector<std::size_t>& members,
                                     const Patches& patches, const Samples& samples,
                                     Average average = Average::median)
{
  Skeleton_graph::Vertex result;
  const double share = 1 / static_cast<double>(members.size());
  std::vector<Vector3> positions;
  Vector3 sum = Vector3::Zero();
  double components = 0, open = 0;
  for(std::size_t i : members) {
    result.radius += share * samples[i].radius;
    result.resolution += share * patches[i].resolution();
    open += is_off_surface(samples[i], patches[i]) ? 0 : 1;
    positions.push_back(samples[i].position);
    sum += static_cast<double>(patches[i].components) * samples[i].position;
    components += static_cast<double>(patches[i].components);
  }
  result.open = open / static_cast<double>(members.size()); // 1 if all are
  result.position = average == Average::mean
                      ? Vector3(sum / components)
                      : l1_median(positions, 0.1 * result.radius + least_spacing);
  for(std::size_t i : members)
    result.half_width += share * (patches[i].mean - result.position).norm();
  return result;
}

/// Part 3b: returns the quotient graph. Each separator and each piece is a vertex in the middle of
/// the samples of its patches. O(n log² n) in practice.
inline Surface_quotient surface_quotient(const Patches& patches, const Samples& samples,
                                         const Ball_overlaps& overlaps,
                                         const std::vector<Local_separator>& separators,
                                         Concurrency concurrency)
{
  constexpr std::size_t none = Surface_cut::none;
  Surface_cut surface(patches, overlaps, separators);
  Surface_quotient result;
  result.graph.vertices.resize(separators.size());
  std::vector<std::size_t> vertex_of_piece(2 * separators.size() + patches.size(), none);
  const auto vertex = [&](std::size_t piece) {
    if(vertex_of_piece[piece] == none) {
      vertex_of_piece[piece] = result.graph.vertices.size();
      result.graph.vertices.emplace_back();
    }
    return vertex_of_piece[piece];
  };
  for(std::size_t s = 0; s < separators.size(); ++s) {
    const std::size_t a = vertex(surface.piece(s, 0)), b = vertex(surface.piece(s, 1));
    result.graph.edges.emplace_back(s, a);
    if(a != b) {
      result.graph.edges.emplace_back(s, b);
      continue;
    }
    result.graph.edges.emplace_back(s, result.graph.vertices.size());
    result.graph.edges.emplace_back(b, result.graph.vertices.size());
    result.handles.push_back({s, b, result.graph.vertices.size()});
    result.graph.vertices.emplace_back();
  }
  for(std::size_t i = 0; i < patches.size(); ++i)
    result.vertex_of_patch.push_back(surface.separator(i) != none ? surface.separator(i)
                                                                   : vertex(surface.piece(i)));

  std::vector<std::vector<std::size_t>>& members = result.members;
  members = patches_of_vertices(result.vertex_of_patch, result.graph.vertices.size());
  std::vector<bool> empty(members.size());
  for(std::size_t v = 0; v < members.size(); ++v)
    empty[v] = members[v].empty();
  for(const Skeleton_graph::Edge& e : result.graph.edges)
    if(empty[e.second] && e.first < separators.size())
      members[e.second].insert(members[e.second].end(), separators[e.first].patches.begin(),
                               separators[e.first].patches.end());
  for(const Surface_quotient::Handle& handle : result.handles)
    members[handle.extra] = separators[handle.separator].sides[1];
  parallel_for(concurrency, members.size(), [&](std::size_t v) {
    const bool is_cross_section = v < separators.size();
    const bool is_wide = is_cross_section && separators[v].is_of_handle;
    result.graph.vertices[v] =
      middle(members[v], patches, samples, is_wide ? Average::mean : Average::median);
    result.graph.vertices[v].is_cross_section = is_cross_section;
  });
  for(std::size_t v = 0; v < members.size(); ++v)
    result.piece_of.push_back(v < separators.size() ? Surface_quotient::no_piece : v);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_SURFACE_QUOTIENT_H
