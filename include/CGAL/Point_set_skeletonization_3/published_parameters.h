// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_PUBLISHED_PARAMETERS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_PUBLISHED_PARAMETERS_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Point_set_skeletonization_3/parameters.h>

#include <cstddef>
#include <optional>

namespace CGAL {
namespace internal_np {

enum published_tuned_t { published_tuned };
enum published_h_0_t { published_h_0 };
enum published_delta_h_t { published_delta_h };
enum published_mu_t { published_mu };
enum published_halt_t { published_halt };
enum published_samples_t { published_samples };
enum published_alpha_t { published_alpha };
enum published_levels_t { published_levels };
enum published_flatness_t { published_flatness };
enum published_sample_flatness_t { published_sample_flatness };
enum published_alpha_min_t { published_alpha_min };
enum published_b_min_t { published_b_min };
enum published_d_max_t { published_d_max };

} // namespace internal_np

namespace parameters {

/// The named parameters of `extract_published_l1_medial_skeleton()`, with the symbols of the paper.
/// As `single_component`, they take the rest of the chain as a second argument: `mu(0.3,
/// d_max(0.2))`. `std::nullopt` means the default.
namespace published {

/// Whether the defaults are those of `Published_options::tuned()` instead of the printed ones.
inline constexpr Parameter<internal_np::published_tuned_t, bool> tuned{};

/// h^(0), the first kernel radius; in diagonals of the bounding box.
inline constexpr Parameter<internal_np::published_h_0_t, std::optional<double>> h_0{};

/// Delta h, the growth of a kernel per iteration; in units of h^(0).
inline constexpr Parameter<internal_np::published_delta_h_t, std::optional<double>> delta_h{};

/// mu, the weight of the repulsion.
inline constexpr Parameter<internal_np::published_mu_t, std::optional<double>> mu{};

/// Whether to halt when most samples lie on curves.
inline constexpr Parameter<internal_np::published_halt_t, bool> halt{};

/// |X|, the number of samples.
inline constexpr Parameter<internal_np::published_samples_t, std::optional<std::size_t>> samples{};

/// alpha, the reach of a parent of the hierarchical EM; in standard deviations.
inline constexpr Parameter<internal_np::published_alpha_t, std::optional<double>> alpha{};

/// Number of levels of the hierarchical EM.
inline constexpr Parameter<internal_np::published_levels_t, std::optional<std::size_t>> levels{};

/// Regularisation of the mixture M of the points.
inline constexpr Parameter<internal_np::published_flatness_t, std::optional<double>> flatness{};

/// Regularisation of the mixture M_X of the samples.
inline constexpr Parameter<internal_np::published_sample_flatness_t, std::optional<double>>
  sample_flatness{};

/// alpha_min, the least angle of adjacent segments; in degrees.
inline constexpr Parameter<internal_np::published_alpha_min_t, std::optional<double>> alpha_min{};

/// b_min, the least number of components of a branch.
inline constexpr Parameter<internal_np::published_b_min_t, std::optional<std::size_t>> b_min{};

/// d_max, the greatest distance of adjacent components; in diagonals of the bounding box.
inline constexpr Parameter<internal_np::published_d_max_t, std::optional<double>> d_max{};

} // namespace published
} // namespace parameters
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_PUBLISHED_PARAMETERS_H
