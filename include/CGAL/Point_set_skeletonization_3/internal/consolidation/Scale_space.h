// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_SCALE_SPACE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_SCALE_SPACE_H

#include <CGAL/Point_set_skeletonization_3/internal/consolidation/Mixture_window.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Radii of the windows, ascending.
struct Window_radii
{
  static constexpr std::size_t size = 12;
  static constexpr double ratio = 1.4; ///< Of one to that before.

  /// From two spacings, the narrowest window that shows a plane.
  explicit Window_radii(double spacing)
  {
    for(std::size_t k = 0; k < size; ++k)
      radii[k] = 2 * spacing * std::pow(ratio, static_cast<double>(k));
  }

  double operator[](std::size_t k) const { return radii[k]; }

  std::array<double, size> radii;
};

/// Current positions of the components of a mixture, and which of them were dropped.
struct Moving_mixture
{
  const Gaussians& mixture;
  std::vector<Vector3> positions; ///< Of each component.
  std::vector<bool> is_outlier;
};

/// A mixture in windows of twelve radii, at one state of its positions.
class Scale_space
{
public:
  /// For a mixture of which nothing was moved or dropped; `tree` is over its means. Refers to the
  /// mixture.
  Scale_space(const Gaussians& mixture, const Box_tree& tree, double spacing,
              Concurrency concurrency)
    : radii_(spacing), spacing_(spacing), concurrency_(concurrency), finest_(&mixture, tree),
      kept_(tree.order())
  {}

  /// For the remaining components of a mixture. O(n log n).
  Scale_space(const Moving_mixture& moving, double spacing, Concurrency concurrency)
    : radii_(spacing), spacing_(spacing), concurrency_(concurrency),
      finest_(left_of(moving), concurrency)
  {
    std::vector<std::size_t> left;
    for(std::size_t i = 0; i < moving.mixture.size(); ++i)
      if(!moving.is_outlier[i])
        left.push_back(i);
    for(std::size_t k : finest_.tree().order())
      kept_.push_back(left[k]);
  }

  /// Tree over the remaining components.
  const Box_tree& tree() const { return finest_.tree(); }

  /// Indices of the remaining components, in the order of the tree.
  const std::vector<std::size_t>& kept() const { return kept_; }

  /// Makes the windows of one size (an index of `Window_radii`), for `for_each()`. O(n log n).
  void make_window(std::size_t size)
  {
    if(!windows_[size])
      windows_[size].emplace(finest_, spacing_, radii_[size], concurrency_);
  }

  /// The windows around the places in a box, by size. \pre `make_window()` was called for the size
  class Views
  {
  public:
    Views(const Scale_space& space, const Eigen::AlignedBox3d& box) : space_(space), box_(box) {}

    Window_view& operator[](std::size_t size)
    {
      if(!views_[size])
        views_[size] = space_.windows_[size]->around(box_);
      return *views_[size];
    }

  private:
    const Scale_space& space_;
    Eigen::AlignedBox3d box_;
    std::array<std::optional<Window_view>, Window_radii::size> views_;
  };

  /// Calls `visit(i, views)` for each remaining component, possibly concurrently.
  template <typename Visit>
  void for_each(const Visit& visit) const
  {
    constexpr std::size_t most = 64; // components: about as many as in one window
    std::vector<std::size_t> groups;
    for(std::size_t n = 0; n < tree().nodes().size();) {
      const Box_tree::Node& node = tree().nodes()[n];
      const bool small = node.end - node.begin <= most;
      if(small)
        groups.push_back(n);
      n = small ? node.after : n + 1;
    }
    parallel_for(concurrency_, groups.size(), [&](std::size_t g) {
      const Box_tree::Node& node = tree().nodes()[groups[g]];
      Views views(*this, tree().boxes()[groups[g]]);
      for(std::size_t k = node.begin; k < node.end; ++k)
        visit(kept_[k], views);
    });
  }

private:
  /// The remaining components at their current positions.
  static Gaussians left_of(const Moving_mixture& moving)
  {
    Gaussians result;
    for(std::size_t i = 0; i < moving.mixture.size(); ++i)
      if(!moving.is_outlier[i])
        result.push_back(
          {moving.mixture[i].weight, moving.positions[i], moving.mixture[i].covariance});
    return result;
  }

  Window_radii radii_;
  double spacing_;
  Concurrency concurrency_;
  Mixture_tree finest_;
  std::vector<std::size_t> kept_;
  std::array<std::optional<Mixture_window>, Window_radii::size> windows_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_SCALE_SPACE_H
