// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_OPTIONS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_OPTIONS_H

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// How a point becomes a Gaussian; nothing here has a unit.
struct Nearest_neighbor_options
{
  /// Number of neighbours k, at least 1; 8 make a ring around a point of a surface.
  std::size_t neighbors = 8;

  /// Variance added in every direction, as a fraction of the neighbours' mean variance; above 0.
  ///
  /// Patches merge if their divergence is small, and that grows with the angle between them the
  /// faster the flatter they are: two equal discs at angle phi diverge by half of
  /// (R - 1)^2 / R sin^2(phi), where R is the ratio of their variances in and across the plane.
  /// A fraction of 0.01 means R = 151, and the limit of 2.2^2 / 2 is passed at 10 degrees; the
  /// normal of 8 neighbours on a curved or noisy surface is less certain than that, most patches
  /// then never merge, and noise decides how many. A fraction of 0.3 means R = 6: no angle alone
  /// forbids to merge, only together with a distance. The mixture sizes are those of the paper
  /// then, with or without noise. Scaling the whole covariance by 2 or 4 gives these sizes as well,
  /// but blurs the surface along the plane, where nothing needs it.
  /// In mixtures of samples the paper's picture has long thin components; 0.05 makes them so, where
  /// samples have gathered on curves.
  double flatness = 0.3;

  void check() const
  {
    CGAL_precondition(neighbors >= 1);
    CGAL_precondition(flatness > 0);
  }
};

/// Hierarchical expectation maximization; nothing here has a unit.
struct Hierarchical_em_options
{
  /// Reach of a parent, in standard deviations, > 0: it considers components within `alpha` times
  /// its largest deviation and takes those whose divergence from it is at most alpha^2 / 2, that of
  /// an equal component `alpha` deviations away. Preiner et al. use 2.2.
  double alpha = 2.2;

  /// Probability of a component to become a parent, in (0, 1).
  double parent_probability = 1.0 / 3;

  /// Levels above the finest. A fixed number, as in Preiner et al.: merging stops only when no
  /// patches fit each other. A level keeps a third of the components where all merge, more on
  /// surfaces: three levels leave 1/8 to 1/13 of the points, where the paper's mixtures have 1/6 to
  /// 1/15, mostly 1/9.
  std::size_t number_of_levels = 3;

  unsigned int random_seed = 0;

  void check() const
  {
    CGAL_precondition(alpha > 0);
    CGAL_precondition(parent_probability > 0 && parent_probability < 1);
  }
};

/// The projection as published (Sec. 3.1 and 3.2).
struct Published_projection_options
{
  /// Number of samples |X|, at least 1. The paper says "a small subset"; unless given, a twentieth
  /// of the points as in Huang et al. (2013), but at least 500, so that each limb gets some.
  std::optional<std::size_t> number_of_samples;

  /// h^(0), in diagonals of the bounding box, in [1e-4, 1e4]; unless given, 2 / |P|^(1/3), which is
  /// the paper's.
  std::optional<double> initial_kernel_radius;

  /// Delta h of Eq. 10 in units of h^(0), >= 0. The paper's is 1/2.
  double kernel_growth = 0.5;

  /// "20 to 30 iterations turned out to be a good choice for all inputs" (Sec. 5).
  std::size_t iterations = 30;

  /// Whether to halt when most samples lie on curves. The paper leaves the criterion open: the
  /// movement of the samples may have a minimum while they still lie on a sheet, and goes on when
  /// limbs collapse onto each other. The share of samples on curves grows as limbs contract, thin
  /// ones first; it stops growing when none is left, or falls when kernels reach other limbs.
  bool halts = false;

  /// A sample lies on a curve where its kernel hardly grows any more: the growth factor nu (Eq. 11)
  /// is at most this, in [0, 1]. 0.3 means more than twice as much variance along as across.
  double curve_growth = 0.3;

  /// And where it moves across the curve by less than this, in kernel radii h per growth of h^(0),
  /// >= 0: the samples of a limb thinner than its kernel move across while it contracts.
  double curve_movement = 0.01;

  /// Halting needs a share of samples on curves of at least this, in [0, 1].
  double least_on_curves = 0.5;

  /// It halts when that share has not grown by 0.01 while isotropic kernels grow by this, in
  /// h^(0), > 0.
  double halting_growth = 2;

  /// mu of Eq. 2, in [0, 0.5). The paper gives no number; more spreads the samples over curves, and
  /// pushes them off their middle.
  double repulsion = 0.2;

  std::size_t samples_of(std::size_t points) const
  {
    constexpr std::size_t fraction = 20, least = 500;
    return (std::min)(points, number_of_samples.value_or((std::max)(points / fraction, least)));
  }

  double kernel_radius_of(std::size_t points) const
  {
    return initial_kernel_radius.value_or(2 / std::cbrt(static_cast<double>(points)));
  }

  void check() const
  {
    CGAL_precondition(number_of_samples.value_or(1) >= 1);
    CGAL_precondition(initial_kernel_radius.value_or(1) >= 1e-4 &&
                      initial_kernel_radius.value_or(1) <= 1e4);
    CGAL_precondition(kernel_growth >= 0);
    CGAL_precondition(curve_growth >= 0 && curve_growth <= 1);
    CGAL_precondition(curve_movement >= 0);
    CGAL_precondition(least_on_curves >= 0 && least_on_curves <= 1);
    CGAL_precondition(halting_growth > 0);
    CGAL_precondition(repulsion >= 0 && repulsion < 0.5);
  }
};

/// Thresholds of Algorithm 1, named as in the paper.
struct Branch_detection_options
{
  /// Least angle between adjacent segments of a branch; degrees, in [0, 180), where 180 is
  /// straight.
  double alpha_min = 90;

  /// Least number of components of a branch, >= 2.
  std::size_t b_min = 5;

  /// Greatest distance of adjacent components of a branch, > 0, in diagonals of the bounding box:
  /// the "maximum Euclidean distance between components". Where the closest free components are
  /// further apart, detection ends; a branch does not grow further than that. The paper's 0.1 % of
  /// the diagonal is below the spacing of any mixture of usual size, so that no branch would start.
  /// Less than 0.1 loses limbs; more than 0.15 finds hardly any further, and branches jump between
  /// limbs.
  double d_max = 0.15;

  void check() const
  {
    CGAL_precondition(alpha_min >= 0 && alpha_min < 180);
    CGAL_precondition(b_min >= 2);
    CGAL_precondition(d_max > 0);
  }
};

/// Options of the published method.
struct Published_options
{
  Nearest_neighbor_options points;  ///< Gaussians of the points, for M.
  Nearest_neighbor_options samples; ///< Gaussians of the samples, for M_X.
  Hierarchical_em_options em;       ///< Of both mixtures.
  Published_projection_options projection;
  Branch_detection_options branches;

  /// What gives the best skeletons on closed models, within the text of the paper but for its
  /// printed values.
  static Published_options tuned()
  {
    Published_options result;
    result.projection.iterations = 60;
    result.projection.kernel_growth = 1.0 / 3;
    result.samples.flatness = 0.05;
    result.branches.alpha_min = 120;
    return result;
  }

  void check() const
  {
    points.check();
    samples.check();
    em.check();
    projection.check();
    branches.check();
  }
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_OPTIONS_H
