// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_QUOTIENT_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_QUOTIENT_H

#include <CGAL/Point_set_skeletonization_3/internal/Connectivity.h>
#include <CGAL/Point_set_skeletonization_3/internal/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/local_separators.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The graph of the pieces that separators cut the surface into, with the patches of every vertex.
struct Surface_quotient
{
  Skeleton_graph graph;
  std::vector<std::size_t> vertex_of_patch;
};

/// Cuts the surface along separators. Every separator becomes a vertex between the two pieces on
/// its sides, so that the graph has the loops of the surface: a handle is cut open by its
/// separators, which its pieces connect, and what touches a separator on one side is one piece
/// however many strips it falls into.
class Surface_cut
{
public:
  Surface_cut(const std::vector<Patch>& patches, const std::vector<Local_separator>& separators)
    : separators_(separators), piece_of_patch_(patches.size(), none),
      connectivity_(2 * separators.size() + patches.size())
  {
    std::vector<std::size_t> separator_of_patch(patches.size(), none);
    for(std::size_t s = 0; s < separators.size(); ++s)
      for(std::size_t i : separators[s].patches)
        separator_of_patch[i] = s;

    // Nodes: the two sides of every separator, then every patch that belongs to none.
    for(std::size_t i = 0; i < patches.size(); ++i)
      for(std::size_t j : patches[i].neighbors)
        if(separator_of_patch[i] == none && separator_of_patch[j] == none)
          connectivity_.join(node(i), node(j));
    for(std::size_t s = 0; s < separators.size(); ++s)
      for(std::size_t side = 0; side < 2; ++side)
        for(std::size_t i : separators[s].sides[side]) {
          if(separator_of_patch[i] == none)
            connectivity_.join(node(s, side), node(i));
          else
            join_touching(s, side, i, separator_of_patch[i], separator_of_patch, patches);
        }
    for(std::size_t i = 0; i < patches.size(); ++i)
      if(separator_of_patch[i] == none)
        piece_of_patch_[i] = connectivity_.root(node(i));
    separator_of_patch_ = std::move(separator_of_patch);
  }

  /// The separator of a patch; `none` if it belongs to a piece.
  std::size_t separator(std::size_t patch) const { return separator_of_patch_[patch]; }
  /// A name of the piece of a patch that belongs to no separator.
  std::size_t piece(std::size_t patch) const { return piece_of_patch_[patch]; }
  /// The same name for the piece on a side of a separator.
  std::size_t piece(std::size_t separator, std::size_t side)
  {
    return connectivity_.root(node(separator, side));
  }

  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

private:
  std::size_t node(std::size_t separator, std::size_t side) const { return 2 * separator + side; }
  std::size_t node(std::size_t patch) const { return 2 * separators_.size() + patch; }

  /// Where two separators touch, the side of the one is the side of the other.
  void join_touching(std::size_t s, std::size_t side, std::size_t i, std::size_t t,
                     const std::vector<std::size_t>& separator_of_patch,
                     const std::vector<Patch>& patches)
  {
    for(std::size_t j : patches[i].neighbors)
      if(separator_of_patch[j] == s)
        for(std::size_t other = 0; other < 2; ++other)
          if(std::binary_search(separators_[t].sides[other].begin(),
                                separators_[t].sides[other].end(), j))
            connectivity_.join(node(s, side), node(t, other));
  }

  const std::vector<Local_separator>& separators_;
  std::vector<std::size_t> separator_of_patch_;
  std::vector<std::size_t> piece_of_patch_;
  Connectivity connectivity_;
};

/// The surface quotient: every separator and every piece between separators made one vertex, in the
/// middle of the samples of its patches.
inline Surface_quotient surface_quotient(const std::vector<Patch>& patches,
                                         const std::vector<Sample>& samples,
                                         const std::vector<Local_separator>& separators)
{
  constexpr std::size_t none = Surface_cut::none;
  Surface_cut surface(patches, separators);
  Surface_quotient result;
  result.graph.vertices.resize(separators.size(), {Vector3::Zero(), 0});
  std::vector<std::size_t> vertex_of_piece(2 * separators.size() + patches.size(), none);
  const auto vertex = [&](std::size_t piece) {
    if(vertex_of_piece[piece] == none) {
      vertex_of_piece[piece] = result.graph.vertices.size();
      result.graph.vertices.push_back({Vector3::Zero(), 0});
    }
    return vertex_of_piece[piece];
  };
  for(std::size_t s = 0; s < separators.size(); ++s) {
    const std::size_t a = vertex(surface.piece(s, 0)), b = vertex(surface.piece(s, 1));
    result.graph.edges.emplace_back(s, a);
    if(a != b)
      result.graph.edges.emplace_back(s, b);
  }
  for(std::size_t i = 0; i < patches.size(); ++i)
    result.vertex_of_patch.push_back(surface.separator(i) != none ? surface.separator(i)
                                                                   : vertex(surface.piece(i)));

  std::vector<double> count(result.graph.vertices.size(), 0);
  const auto add = [&](std::size_t v, const Sample& sample, double share) {
    result.graph.vertices[v].position += share * sample.position;
    result.graph.vertices[v].radius += share * sample.radius;
    count[v] += share;
  };
  for(std::size_t i = 0; i < patches.size(); ++i)
    add(result.vertex_of_patch[i], samples[i], 1);
  // Separators that touch leave no patch in between: the piece lies in the middle of them.
  const std::vector<double> patches_of = count;
  for(const Skeleton_graph::Edge& e : result.graph.edges)
    if(patches_of[e.second] == 0)
      for(std::size_t i : separators[e.first].patches)
        add(e.second, samples[i], 1);
  for(std::size_t v = 0; v < count.size(); ++v) {
    result.graph.vertices[v].position /= count[v];
    result.graph.vertices[v].radius /= count[v];
  }
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_QUOTIENT_H
