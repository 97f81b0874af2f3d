// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_CHOOSE_SEPARATORS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_CHOOSE_SEPARATORS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Per_thread.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Closed_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Known_cuts.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Local_separator.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Path_search.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Separator_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Waiting_candidates.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/bounds_solid.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Chooses candidates that cut a limb, so that no patch is on two of them.
///
/// A separator cuts a limb if there is no path on the surface from one side to the other, or only
/// one around a hole of the shape. An arc that ends in holes of the data, or a ring around a dent,
/// has a path around it whose closed curve is contractible in the solid. A sheet encloses no solid:
/// there a hole that is not much wider than what is beside it is one of the data.
class Separator_choice
{
public:
  /// Refers to all arguments but the candidates. `limbs` is the graph of adjacent patches within
  /// limbs (`Ball_overlaps::are_in_one_limb()`).
  /// \param fills_gaps whether narrow holes of sheets are holes of the data
  Separator_choice(std::vector<Local_separator> candidates, const Surface& surface,
                   const Samples& samples, const Patch_graph& limbs, bool fills_gaps,
                   const Separator_options& options, Concurrency concurrency)
    : options_(options), candidates_(std::move(candidates)), surface_(surface), samples_(samples),
      fills_gaps_(fills_gaps), concurrency_(concurrency),
      search_(concurrency, [&] { return Path_search(surface.patches, limbs); }),
      cuts_(limbs, surface.patches.size()),
      waiting_(candidates_, surface.patches.size()), paths_(candidates_.size())
  {}

  /// Returns the candidates that cut a limb and share no patch with one chosen before; they are
  /// tested in their order. To be called once.
  std::vector<Local_separator> run()
  {
    std::vector<Local_separator> result;
    for(std::size_t s = 0; s < candidates_.size(); ++s) {
      if(!waiting_.waits(s))
        continue;
      if(!paths_[s])
        find_paths();
      const bool cuts = cuts_limb(candidates_[s], *paths_[s]);
      remove(s);
      if(!cuts)
        continue;
      for(std::size_t i : candidates_[s].patches)
        for(std::size_t other : waiting_.on_patch(i))
          remove(other);
      result.push_back(std::move(candidates_[s]));
    }
    return result;
  }

  /// Whether another separator cuts a limb. \pre it shares no patch with a chosen one
  bool cuts_limb(const Local_separator& separator)
  {
    return cuts_limb(separator, paths_around({&separator}).front());
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  /// A path from one side of a candidate to the other.
  struct Path
  {
    Path_search::Path patches; ///< Empty if there is none.
    std::size_t curve = none;  ///< Known curve that it can be moved onto; `none` if it is short.
  };

  /// A closed curve that represents all curves along it or that can be moved onto it.
  struct Known_curve
  {
    Closed_curve curve;
    bool is_solid;        ///< Otherwise no curve can be moved onto it.
    bool is_around_gap;   ///< See `is_around_gap()`; then contractible, whatever is along it.
    bool is_contractible; ///< Known, or set once it is tested.
  };

  void remove(std::size_t s)
  {
    waiting_.remove(s, candidates_[s]);
    paths_[s].reset();
  }

  /// Whether a candidate cuts a limb, for the path around it. Keeps a contractible one.
  bool cuts_limb(const Local_separator& candidate, const Path& path)
  {
    // A contractible closed path has intersection number 0 with each cross-section of a limb.
    if(crosses_contractible_loop(candidate))
      return false;
    if(has_contractible_path(path)) {
      add_contractible_loop(search_.local().closed(path.patches, candidate));
      return false;
    }
    return bounds_solid(candidate, surface_.patches, samples_) &&
           (path.patches.empty() ||
            (path.curve != none && search_.local().is_crossed(candidate)));
  }

  void add_contractible_loop(Path_search::Path loop)
  {
    for(std::size_t i : loop)
      loops_through_[i].push_back(contractible_loops_.size());
    contractible_loops_.push_back(std::move(loop));
  }

  /// Only those that visit its first side cross a candidate.
  bool crosses_contractible_loop(const Local_separator& candidate)
  {
    std::set<std::size_t> loops;
    for(std::size_t i : candidate.sides[0]) {
      const auto found = loops_through_.find(i);
      if(found != loops_through_.end())
        loops.insert(found->second.begin(), found->second.end());
    }
    return std::any_of(loops.begin(), loops.end(), [&](std::size_t k) {
      return search_.local().algebraic_intersection_number(contractible_loops_[k], candidate) != 0;
    });
  }

  bool has_contractible_path(const Path& path) const
  {
    return path.curve != none && curves_[path.curve].is_contractible;
  }

  /// Finds the paths that are needed whatever is chosen before: those around candidates that come
  /// first on all of their patches. So all threads have work.
  void find_paths()
  {
    const std::vector<std::size_t> wanted = waiting_.take_first();
    std::vector<const Local_separator*> candidates;
    for(std::size_t s : wanted)
      candidates.push_back(&candidates_[s]);
    std::vector<Path> found = paths_around(candidates);
    for(std::size_t k = 0; k < wanted.size(); ++k)
      paths_[wanted[k]] = std::move(found[k]);
  }

  /// The path around each of some separators.
  std::vector<Path> paths_around(const std::vector<const Local_separator*>& separators)
  {
    std::vector<Path> result(separators.size());
    std::vector<std::size_t> doubtful;
    for(std::size_t k = 0; k < separators.size(); ++k) {
      Progress::poll();
      if(!cuts_.add_if_cuts(*separators[k]))
        doubtful.push_back(k);
    }
    parallel_for(concurrency_, doubtful.size(), [&](std::size_t k) {
      result[doubtful[k]].patches = search_.local().around(*separators[doubtful[k]]);
    });
    const std::size_t known = curves_.size();
    for(std::size_t k = 0; k < separators.size(); ++k) {
      Path& path = result[k];
      if(static_cast<double>(path.patches.size()) > options_.around_a_tip) {
        const bool is_around_gap = fills_gaps_ && this->is_around_gap(path.patches, *separators[k]);
        path.curve = curve_like(closed_curve(path.patches, *separators[k]), is_around_gap);
      }
    }
    parallel_for(concurrency_, curves_.size() - known, [&](std::size_t k) {
      Known_curve& curve = curves_[known + k];
      curve.is_contractible = curve.is_contractible || curve.curve.is_contractible();
    });
    return result;
  }

  /// Whether a closed path around a separator runs mostly on a sheet, around a hole that is not
  /// much wider than the strip beside it, which the separator cuts.
  bool is_around_gap(const Path_search::Path& path, const Local_separator& separator) const
  {
    // Widths of the strip: holes between the lines of a scanner are about as wide as what is
    // between them, those between the bars of a frame three times, and those between wires ten times
    // as wide.
    constexpr double widest = 2;
    Vector3 area = Vector3::Zero(); // times two; of a closed polygon, whatever the origin
    double length = 0, on_sheet = 0;
    const Vector3 origin = surface_.patches[path.front()].mean;
    for(std::size_t k = 0; k < path.size(); ++k) {
      const std::size_t i = path[k], j = path[k + 1 < path.size() ? k + 1 : 0];
      const Vector3 from = surface_.patches[i].mean - origin,
                    to = surface_.patches[j].mean - origin;
      area += from.cross(to);
      length += (to - from).norm();
      on_sheet += is_off_surface(samples_[i], surface_.patches[i]) ? 0 : 1;
    }
    const double width = length > 0 ? 2 * area.norm() / length : 0; // of a circle its diameter
    return on_sheet >= 0.5 * static_cast<double>(path.size()) && width < widest * separator.length;
  }

  /// The closed curve through the samples of a path around a separator.
  Closed_curve closed_curve(const Path_search::Path& path, const Local_separator& separator) const
  {
    std::vector<Vector3> positions;
    for(std::size_t i : path)
      positions.push_back(samples_[i].position);
    return Closed_curve(positions, surface_.patches[separator.patches.front()].spacing, surface_);
  }

  /// Index of a known curve that this one is along or can be moved onto; it is added if there is
  /// none. Around a gap of a sheet, where there is no solid to move it in, it counts as
  /// contractible.
  std::size_t curve_like(const Closed_curve& curve, bool is_around_gap)
  {
    const auto is_like = [&](const Known_curve& known) {
      return (known.is_around_gap == is_around_gap && curve.is_along(known.curve)) ||
             (known.is_solid && curve.can_be_moved_onto(known.curve));
    };
    const auto found = std::find_if(curves_.begin(), curves_.end(), is_like);
    const auto result = static_cast<std::size_t>(found - curves_.begin());
    if(found == curves_.end()) {
      const bool is_solid = curve.is_solid();
      curves_.push_back({curve, is_solid, is_around_gap, is_around_gap && !is_solid});
    }
    return result;
  }

  const Separator_options& options_;
  std::vector<Local_separator> candidates_;
  const Surface& surface_;
  const Samples& samples_;
  bool fills_gaps_;
  Concurrency concurrency_;
  Per_thread<Path_search> search_;

  // Found so far.
  Known_cuts cuts_;
  Waiting_candidates waiting_;             ///< They share no patch with a chosen separator.
  std::vector<std::optional<Path>> paths_; ///< Around candidates that wait.
  std::vector<Known_curve> curves_;
  std::vector<Path_search::Path> contractible_loops_; ///< Closed paths.
  std::unordered_map<std::size_t, std::vector<std::size_t>> loops_through_; ///< Each patch.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_CHOOSE_SEPARATORS_H
