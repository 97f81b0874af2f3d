// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_WINDING_NUMBER_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_WINDING_NUMBER_H

#include <CGAL/Point_set_skeletonization_3/internal/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/parallel_for.h>
#include <CGAL/Point_set_skeletonization_3/internal/patch_adjacency.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The generalised winding number of oriented patches: 1 inside, 0 outside, in between near holes.
/// The patches are dipoles, and what is far away counts as the first two terms of its Taylor
/// expansion (Barill et al. 2018). Patches closer than half their spacing are left out: a dipole says
/// nothing about its own neighbourhood.
class Winding_number
{
public:
  explicit Winding_number(const std::vector<Patch>& patches)
    : tree_(patches.size(), [&](std::size_t i) { return patches[i].mean; })
  {
    dipoles_.reserve(patches.size());
    for(std::size_t i : tree_.order())
      dipoles_.push_back({patches[i].mean, patches[i].planarity * patches[i].area * patches[i].normal,
                          patches[i].spacing / 2});
    groups_.reserve(tree_.nodes().size());
    for(const Box_tree::Node& node : tree_.nodes())
      groups_.emplace_back(dipoles_.data() + node.begin, dipoles_.data() + node.end);
  }

  double operator()(const Vector3& q) const
  {
    double sum = 0;
    for(std::size_t n = 0; n < groups_.size();) {
      const Vector3 d = groups_[n].center - q;
      const double squared = d.squaredNorm();
      if(squared > groups_[n].squared_reach) {
        sum += groups_[n].far(d, squared);
        n = tree_.nodes()[n].after;
        continue;
      }
      if(tree_.is_leaf(n))
        for(std::size_t k = tree_.nodes()[n].begin; k < tree_.nodes()[n].end; ++k)
          sum += dipoles_[k].at(q);
      ++n;
    }
    return sum / (4 * CGAL_PI);
  }

private:
  struct Dipole
  {
    Vector3 position;
    Vector3 moment; ///< Normal times area.
    double reach;   ///< Below this distance it does not count.

    double at(const Vector3& q) const
    {
      const Vector3 d = position - q;
      const double squared = d.squaredNorm();
      return squared > reach * reach ? moment.dot(d) / (squared * std::sqrt(squared)) : 0;
    }
  };

  /// Dipoles seen from far away.
  struct Group
  {
    Group(const Dipole* begin, const Dipole* end)
    {
      double weight = 0;
      for(const Dipole* dipole = begin; dipole != end; ++dipole) {
        weight += dipole->moment.norm();
        center += dipole->moment.norm() * dipole->position;
      }
      center = weight > 0 ? Vector3(center / weight) : begin->position;
      double radius = 0, dipole_reach = 0;
      for(const Dipole* dipole = begin; dipole != end; ++dipole) {
        const Vector3 offset = dipole->position - center;
        moment += dipole->moment;
        second += offset * dipole->moment.transpose();
        radius = std::max(radius, offset.norm());
        dipole_reach = std::max(dipole_reach, dipole->reach);
      }
      // How many radii away the expansion starts to count. The error at 3 is 0.006 in the mean and
      // 0.03 at most, below what the dipoles themselves are wrong by near the surface; at 2 it is
      // three times that, for two thirds of the time.
      constexpr double beta = 3;
      const double reach = std::max(beta * radius, radius + dipole_reach);
      squared_reach = reach * reach;
    }

    /// The sum of the dipoles at a place that lies `-d` from the centre.
    double far(const Vector3& d, double squared) const
    {
      return (moment.dot(d) + second.trace() - 3 * d.dot(second * d) / squared) /
             (squared * std::sqrt(squared));
    }

    Vector3 center = Vector3::Zero(); ///< Of their area.
    Vector3 moment = Vector3::Zero();
    Matrix3 second = Matrix3::Zero(); ///< Sum of offsets from the centre times moments.
    double squared_reach = 0;         ///< Beyond this squared distance `far()` holds.
  };

  Box_tree tree_;
  std::vector<Dipole> dipoles_; ///< In the order of the tree.
  std::vector<Group> groups_;   ///< Of every node of the tree.
};

/// Turns the patches around whose normals point into the shape: the spanning tree of the orientation
/// may have taken a wrong turn at a thin or sharp place. The rest of the surface tells: it winds once
/// around what is behind a patch, and not around what is in front. First whole limbs that are inside
/// out, then patches that have more inside in front of them than behind.
template <typename ConcurrencyTag>
void settle_orientation(std::vector<Patch>& patches)
{
  const auto turn_where = [&](const auto& is_wrong) {
    const Winding_number winding_number(patches);
    std::vector<char> wrong(patches.size(), 0);
    parallel_for<ConcurrencyTag>(patches.size(), [&](std::size_t i) {
      const Vector3 step = patches[i].spacing * patches[i].normal;
      wrong[i] =
        is_wrong(winding_number(patches[i].mean + step), winding_number(patches[i].mean - step));
    });
    for(std::size_t i = 0; i < patches.size(); ++i)
      if(wrong[i])
        patches[i].normal = -patches[i].normal;
  };
  // The sum of both sides is 1 where the surroundings are oriented well, -1 where they are inside
  // out, and 0 on an open sheet, which has no inside.
  constexpr double inside_out = -0.5;
  turn_where([](double in_front, double behind) { return in_front + behind < inside_out; });
  turn_where([](double in_front, double behind) { return in_front > behind; });
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_WINDING_NUMBER_H
