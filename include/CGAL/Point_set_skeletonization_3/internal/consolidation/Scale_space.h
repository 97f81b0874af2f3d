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

/// Radii of the windows through which a mixture is looked at.
struct Window_radii
{
  static constexpr std::size_t size = 6;

  /// From two spacings, the narrowest window with a plane in it, by steps of 1.4.
  explicit Window_radii(double spacing)
  {
    for(std::size_t k = 0; k < size; ++k)
      radii[k] = 2 * spacing * std::pow(1.4, static_cast<double>(k));
  }

  double operator[](std::size_t k) const { return radii[k]; }

  std::array<double, size> radii;
};

/// Where the components of a mixture are, and which of them were dropped.
struct Moving_mixture
{
  const Gaussians& mixture;
  std::vector<Vector3> positions; ///< Of every component.
  std::vector<bool> is_outlier;
};

/// A mixture seen through windows of six sizes, as it is at one time.
class Scale_space
{
public:
  /// Of a mixture from which nothing was dropped or moved; `tree` is over its means. Refers to it.
  Scale_space(const Gaussians& mixture, const Box_tree& tree, double spacing,
              Concurrency concurrency)
    : radii_(spacing), spacing_(spacing), concurrency_(concurrency), finest_(&mixture, tree),
      kept_(tree.order())
  {}

  /// Of what is left of a mixture.
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

  /// Over the components that are left.
  const Box_tree& tree() const { return finest_.tree(); }

  /// Their indices, in the order of the tree.
  const std::vector<std::size_t>& kept() const { return kept_; }

  /// Makes the window of one size; the following see those only that were made.
  void make_window(std::size_t size)
  {
    if(!windows_[size])
      windows_[size].emplace(finest_, spacing_, radii_[size], concurrency_);
  }

  /// The windows around the points of a box.
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

  /// Calls `visit(i, views)` for every component that is left.
  template <typename Visit>
  void for_each(const Visit& visit) const
  {
    constexpr std::size_t most = 64; // components: about as many as one of them sees
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
