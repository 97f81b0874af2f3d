// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_HANDLE_SEPARATORS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_HANDLE_SEPARATORS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Growing_region.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Local_separator.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Separator_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Surface_loops.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/bounds_solid.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/choose_separators.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Cuts the handles that local separators leave. The wall of a pipe or a plate with a hole may be
/// too wide for any ball, so that no front splits; but a shape whose pieces still have handles has
/// more loops than its skeleton. In each piece the shortest closed path that leaves it connected,
/// and cuts a limb, becomes a ring. (One around a tunnel does not: the way around it can be shrunk
/// in the solid.)
class Handle_cuts
{
public:
  /// Refers to all arguments but the separators.
  /// \param limbs the graph of adjacent patches within limbs
  /// \param graph that of all adjacent patches
  Handle_cuts(std::vector<Local_separator> separators, Separator_choice& choice,
              const Patches& patches, const Samples& samples, const Patch_graph& limbs,
              const Patch_graph& graph, const Separator_options& options)
    : separators_(std::move(separators)), choice_(choice), patches_(patches), samples_(samples),
      limbs_(limbs), options_(options), loops_(limbs, patches.size()),
      region_(patches, graph, samples, options), is_free_(patches.size(), true),
      mark_(patches.size(), 0)
  {
    for(const Local_separator& separator : separators_)
      occupy(separator, true);
  }

  /// Returns the separators, then those added. To be called once. O(n log n) for each of these.
  std::vector<Local_separator> run()
  {
    std::vector<bool> is_done(patches_.size(), false);
    for(std::size_t i = 0; i < patches_.size(); ++i) {
      if(!is_free_[i] || is_done[i])
        continue;
      Progress::poll();
      const std::vector<std::size_t> piece = connected_with({i});
      for(std::size_t j : piece)
        is_done[j] = true;
      auto root = piece.begin();
      do
        root = std::find_if(root, piece.end(), [&](std::size_t j) { return is_free_[j]; });
      while(root != piece.end() && cut_handle(*root));
    }
    return std::move(separators_);
  }

private:
  using Borders = std::array<std::vector<std::size_t>, 2>;

  bool is_free(const Local_separator& separator) const
  {
    return std::all_of(separator.patches.begin(), separator.patches.end(),
                       [&](std::size_t i) { return is_free_[i]; });
  }

  void occupy(const Local_separator& separator, bool is_occupied)
  {
    for(std::size_t i : separator.patches)
      is_free_[i] = !is_occupied;
  }

  /// Cuts a handle of the piece of a patch; returns whether there is one.
  bool cut_handle(std::size_t root)
  {
    for(const Surface_loops::Path& path :
        loops_.through(root, [&](std::size_t i) { return is_free_[i]; })) {
      Progress::poll();
      if(static_cast<double>(path.size()) <= options_.around_a_tip)
        continue;
      Local_separator ring = region_.grow_from_ring(path);
      const bool cuts_handle = !ring.patches.empty() && is_free(ring) && encloses_solid(ring) &&
                               leaves_connected(ring) && choice_.cuts_limb(ring);
      if(!cuts_handle)
        continue;
      ring = straightened(std::move(ring));
      if(!bounds_solid(ring, patches_, samples_)) // now it is around a tunnel
        continue;
      separators_.push_back(std::move(ring));
      separators_.back().is_of_handle = true;
      occupy(separators_.back(), true);
      return true;
    }
    return false;
  }

  /// Whether the other side of the limb was seen from most patches of a ring: in a sheet separators
  /// are arcs.
  bool encloses_solid(const Local_separator& ring) const
  {
    const auto solid =
      std::count_if(ring.patches.begin(), ring.patches.end(), [&](std::size_t i) {
        return is_off_surface(samples_[i], patches_[i]);
      });
    return 2 * static_cast<std::size_t>(solid) > ring.patches.size();
  }

  /// Whether a path leads from one side of a ring to the other, off all separators.
  bool leaves_connected(const Local_separator& ring)
  {
    occupy(ring, true);
    connected_with(ring.sides[0]);
    occupy(ring, false);
    return std::any_of(ring.sides[1].begin(), ring.sides[1].end(),
                       [&](std::size_t i) { return mark_[i] == marks_; });
  }

  /// The patches that are connected with some in one limb, off all separators; they are marked.
  std::vector<std::size_t> connected_with(const std::vector<std::size_t>& start)
  {
    ++marks_;
    std::vector<std::size_t> result;
    const auto reach = [&](std::size_t i) {
      if(is_free_[i] && mark_[i] != marks_) {
        mark_[i] = marks_;
        result.push_back(i);
      }
    };
    for(std::size_t i : start)
      reach(i);
    for(std::size_t next = 0; next < result.size(); ++next)
      for(const auto& edge : limbs_[result[next]])
        reach(edge.patch);
    return result;
  }

  /// Returns the ring halfway around the handle from that halfway around from a ring: it is where
  /// that one is, but straight. If there is none, what comes nearest to it.
  Local_separator straightened(Local_separator ring)
  {
    for(int k = 0; k < 2; ++k) {
      Local_separator opposite = opposite_of(ring);
      if(opposite.patches.empty())
        break;
      ring = std::move(opposite);
    }
    return ring;
  }

  /// The ring halfway around the handle; empty if it is not one ring.
  Local_separator opposite_of(const Local_separator& ring)
  {
    occupy(ring, true);
    const std::vector<std::size_t> piece = connected_with(ring.sides[1]);
    Borders borders;
    for(std::size_t k = 0; k < 2; ++k)
      std::copy_if(ring.sides[1 - k].begin(), ring.sides[1 - k].end(),
                   std::back_inserter(borders[k]),
                   [&](std::size_t i) { return mark_[i] == marks_; });
    occupy(ring, false);
    Local_separator result;
    if(!borders[0].empty() && !borders[1].empty())
      result = region_.halfway(piece, borders);
    const bool is_ring = !result.patches.empty() && !result.sides[0].empty() &&
                         !result.sides[1].empty() && is_nearly_connected(result);
    return is_ring ? result : Local_separator();
  }

  /// Whether all of a separator but small parts is connected.
  bool is_nearly_connected(const Local_separator& separator)
  {
    const std::size_t in_no_part = ++marks_;
    for(std::size_t i : separator.patches)
      mark_[i] = in_no_part;
    double largest = 0;
    for(std::size_t first : separator.patches) {
      if(mark_[first] != in_no_part)
        continue;
      std::vector<std::size_t> part{first};
      double length = 0;
      mark_[first] = ++marks_;
      for(std::size_t next = 0; next < part.size(); ++next) {
        length += patches_[part[next]].spacing;
        for(std::size_t j : patches_[part[next]].neighbors)
          if(mark_[j] == in_no_part) {
            mark_[j] = marks_;
            part.push_back(j);
          }
      }
      largest = (std::max)(largest, length);
    }
    return separator.length - largest < options_.least_share * largest;
  }

  std::vector<Local_separator> separators_;
  Separator_choice& choice_;
  const Patches& patches_;
  const Samples& samples_;
  const Patch_graph& limbs_;
  const Separator_options& options_;
  Surface_loops loops_;
  Growing_region region_;

  // For each patch.
  std::vector<bool> is_free_;     ///< It is on no separator.
  std::vector<std::size_t> mark_; ///< The last search that reached it.
  std::size_t marks_ = 0;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_HANDLE_SEPARATORS_H
