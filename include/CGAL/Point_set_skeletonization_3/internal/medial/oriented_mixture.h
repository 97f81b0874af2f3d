// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_ORIENTED_MIXTURE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_ORIENTED_MIXTURE_H

#include <CGAL/Point_set_skeletonization_3/internal/published/Point_search.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/attraction.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/merge_by_cell.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A mixture component with an outward normal, as far as the normal can be trusted.
struct Oriented_gaussian
{
  Gaussian gaussian;
  Vector3 normal = Vector3::Zero(); ///< Unit length, or zero.
  double confidence = 0;            ///< In [0, 1]; 0: the normal says nothing.
};

/// Merges the components that share a cell of a cubic grid; moments merge exactly, and normals that
/// cancel leave no confidence.
inline std::vector<Oriented_gaussian> merged(const std::vector<Oriented_gaussian>& fine,
                                             double cell_size)
{
  const Grid_cells cells =
    grid_cells(fine.size(), [&](std::size_t i) { return fine[i].gaussian.mean; }, cell_size);
  std::vector<std::vector<std::size_t>> members(cells.size);
  for(std::size_t i = 0; i < fine.size(); ++i)
    members[cells.cell_of[i]].push_back(i);

  std::vector<Oriented_gaussian> result;
  for(const std::vector<std::size_t>& cell : members) {
    Moments moments(fine[cell.front()].gaussian.mean);
    Vector3 normal = Vector3::Zero();
    for(std::size_t i : cell) {
      moments.add(fine[i].gaussian);
      normal += fine[i].gaussian.weight * fine[i].confidence * fine[i].normal;
    }
    const double length = normal.norm();
    result.push_back({moments.gaussian(), length > 0 ? Vector3(normal / length) : normal,
                      length / moments.weight()});
  }
  return result;
}

/// Whether one sees a component from inside if it lies at `d` from there, in [0, 1]: the orientation
/// gate. It closes between 6 and 17 degrees behind the component's tangent plane - the plane of a
/// curved patch is only so exact -, and only as far as the normal can be trusted.
inline double visibility(const Vector3& d, const Vector3& normal, double confidence)
{
  const double length = d.norm();
  if(!(length > 0))
    return 1;
  const double cosine = normal.dot(d) / length;
  const double hidden = std::min(1.0, std::max(0.0, (-0.1 - cosine) / 0.2));
  return 1 - confidence * hidden;
}

/// A mixture component as the projection uses it.
struct Oriented_attractor
{
  explicit Oriented_attractor(const Oriented_gaussian& g)
    : attractor(g.gaussian), normal(g.normal), confidence(g.confidence)
  {}

  Attractor attractor;
  Vector3 normal;
  double confidence;

  /// Whether a sample at `q` sees the component from inside, in [0, 1].
  double seen_from(const Vector3& q) const
  {
    return visibility(attractor.mean() - q, normal, confidence);
  }
};

/// An oriented mixture at every scale: a kernel of a given radius reads the level that fits it, so
/// that a sample in a thick body costs as little as one in a thin limb.
class Oriented_mixture
{
public:
  struct Level
  {
    template <typename ConcurrencyTag>
    Level(const std::vector<Oriented_gaussian>& components, double size, ConcurrencyTag tag)
      : attractors(components.begin(), components.end()), cell_size(size),
        search(
          components.size(), [&](std::size_t i) { return components[i].gaussian.mean; }, tag)
    {}

    std::vector<Oriented_attractor> attractors;
    double cell_size;
    Point_search search;
  };

  /// `finest` with components `spacing` apart. Every level is twice as coarse as the one before,
  /// down to a handful of components.
  template <typename ConcurrencyTag>
  Oriented_mixture(const std::vector<Oriented_gaussian>& finest, double spacing, ConcurrencyTag tag)
  {
    std::vector<std::vector<Oriented_gaussian>> levels{finest};
    std::vector<double> sizes{spacing};
    while(levels.back().size() > 16 && sizes.back() < 1) {
      sizes.push_back(2 * sizes.back());
      levels.push_back(merged(levels.back(), sizes.back()));
    }
    levels_.resize(levels.size());
    parallel_for<ConcurrencyTag>(levels.size(), [&](std::size_t k) {
      levels_[k] = std::make_unique<Level>(levels[k], sizes[k], tag);
    });
  }

  const Level& finest() const { return *levels_.front(); }

  /// The coarsest level whose components are not larger than `size`.
  const Level& level_for(double size) const
  {
    std::size_t k = 0;
    while(k + 1 < levels_.size() && levels_[k + 1]->cell_size <= size)
      ++k;
    return *levels_[k];
  }

private:
  std::vector<std::unique_ptr<Level>> levels_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_ORIENTED_MIXTURE_H
