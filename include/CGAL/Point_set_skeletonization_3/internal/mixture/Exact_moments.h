// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_EXACT_MOMENTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_EXACT_MOMENTS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Int128.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Lattice_point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Number, first and second moments of points of the lattice about its origin. The sums are exact:
/// the same for any order of the points, any division into parts and any order of the parts.
class Exact_moments
{
public:
  /// Adds a point. \pre there are less than 2^40
  void add(const Lattice_point& p)
  {
    ++number_;
    for(std::size_t k = 0; k < 3; ++k)
      first_[k] += p[k];
    for(std::size_t k = 0; k < 6; ++k)
      second_[k] += Int128(p[entries[k].first]) * p[entries[k].second];
  }

  void add(const Exact_moments& other)
  {
    number_ += other.number_;
    for(std::size_t k = 0; k < 3; ++k)
      first_[k] += other.first_[k];
    for(std::size_t k = 0; k < 6; ++k)
      second_[k] += other.second_[k];
  }

  /// Number of points.
  std::uint64_t number() const { return number_; }

  /// The Gaussian with these moments, in normalised coordinates. The weight is the number.
  /// \pre there are points
  Gaussian gaussian() const
  {
    const double weight = static_cast<double>(number_);
    // About a place of the lattice near the mean, still exact: nothing cancels after that.
    std::array<std::int64_t, 3> origin;
    std::array<Int128, 3> first;
    Vector3 mean, offset;
    for(std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      origin[k] = static_cast<std::int64_t>(static_cast<double>(first_[k]) / weight);
      first[k] = first_[k] - Int128(origin[k]) * number_;
      offset[axis] = static_cast<double>(first[k]) / weight;
      mean[axis] = (static_cast<double>(origin[k]) + offset[axis]) / lattice_steps;
    }
    Matrix3 covariance;
    for(std::size_t k = 0; k < 6; ++k) {
      const auto [i, j] = entries[k];
      const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
      const Int128 second = second_[k] - first_[j] * origin[i] - first[i] * origin[j];
      covariance(row, column) = covariance(column, row) =
          (static_cast<double>(second) / weight - offset[row] * offset[column]) / lattice_steps /
          lattice_steps;
    }
    return {weight, mean, covariance};
  }

  /// The sums as numbers of 64 bits; those that may be negative as two, of a sum that is not.
  static constexpr std::size_t number_of_words = 1 + 2 * 9;
  using Words = std::array<std::uint64_t, number_of_words>;

  Words words() const
  {
    Words result;
    std::size_t i = 0;
    result[i++] = number_;
    const auto append = [&](const Int128& sum) {
      const Int128 positive = sum + above_all;
      result[i++] = static_cast<std::uint64_t>(positive & ~std::uint64_t(0));
      result[i++] = static_cast<std::uint64_t>(positive >> 64);
    };
    for(const Int128& sum : first_)
      append(sum);
    for(const Int128& sum : second_)
      append(sum);
    return result;
  }

  /// The inverse of `words()`.
  static Exact_moments of_words(const Words& words)
  {
    Exact_moments result;
    std::size_t i = 0;
    result.number_ = words[i++];
    const auto next = [&] {
      const Int128 low = words[i++];
      const Int128 high = words[i++];
      return (high << 64) + low - above_all;
    };
    for(Int128& sum : result.first_)
      sum = next();
    for(Int128& sum : result.second_)
      sum = next();
    return result;
  }

private:
  /// Greater than all sums.
  inline static const Int128 above_all = Int128(1) << 126;

  /// The upper triangle of a matrix, row by row.
  static constexpr std::array<std::pair<std::size_t, std::size_t>, 6> entries = {
      {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};

  std::uint64_t number_ = 0;
  std::array<Int128, 3> first_{};
  std::array<Int128, 6> second_{};
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_EXACT_MOMENTS_H
