// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_WINDING_NUMBER_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_WINDING_NUMBER_H

#include <CGAL/Point_set_skeletonization_3/internal/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/parallel_for.h>
#include <CGAL/Point_set_skeletonization_3/internal/patch_adjacency.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Winding number from which a place counts as inside. Not 0.5: it is low near a hole of the data and
/// in a limb so thin that its patches are no planes.
constexpr double least_inside = 0.25;

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
                          patches[i].spacing * patches[i].spacing / 4});
    groups_.reserve(tree_.nodes().size());
    for(const Box_tree::Node& node : tree_.nodes())
      groups_.emplace_back(dipoles_.data() + node.begin, dipoles_.data() + node.end);
  }

  double operator()(const Vector3& q) const { return at(std::array<Vector3, 1>{{q}})[0]; }

  /// At two places close to each other, in little more time than at one.
  std::array<double, 2> operator()(const Vector3& p, const Vector3& q) const
  {
    return at(std::array<Vector3, 2>{{p, q}});
  }

private:
  struct Dipole
  {
    Vector3 position;
    Vector3 moment;       ///< Normal times area.
    double squared_reach; ///< Below this squared distance it does not count.

    double at(const Vector3& q) const
    {
      const Vector3 d = position - q;
      const double squared = d.squaredNorm();
      return squared > squared_reach ? moment.dot(d) / (squared * std::sqrt(squared)) : 0;
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
      Matrix3 second = Matrix3::Zero(); // sum of offsets from the centre times moments
      double radius = 0, dipole_reach = 0;
      for(const Dipole* dipole = begin; dipole != end; ++dipole) {
        const Vector3 offset = dipole->position - center;
        moment += dipole->moment;
        second += offset * dipole->moment.transpose();
        radius = std::max(radius, offset.norm());
        dipole_reach = std::max(dipole_reach, std::sqrt(dipole->squared_reach));
      }
      diagonal = Vector3::Constant(second.trace()) - 3 * second.diagonal();
      mixed = -3 * Vector3(second(1, 2) + second(2, 1), second(2, 0) + second(0, 2),
                           second(0, 1) + second(1, 0));
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
      const double quadratic = d.x() * (diagonal.x() * d.x() + mixed.z() * d.y()) +
                               d.y() * (diagonal.y() * d.y() + mixed.x() * d.z()) +
                               d.z() * (diagonal.z() * d.z() + mixed.y() * d.x());
      return (moment.dot(d) + quadratic / squared) / (squared * std::sqrt(squared));
    }

    Vector3 center = Vector3::Zero(); ///< Of their area.
    Vector3 moment = Vector3::Zero();
    Vector3 diagonal, mixed;  ///< The second term: a quadratic form of xx, yy, zz and yz, zx, xy.
    double squared_reach = 0; ///< Beyond this squared distance `far()` holds.
  };

  template <std::size_t N>
  std::array<double, N> at(const std::array<Vector3, N>& places) const
  {
    std::array<double, N> sum{}, squared;
    std::array<Vector3, N> d;
    for(std::size_t n = 0; n < groups_.size();) {
      const Group& group = groups_[n];
      double nearest = std::numeric_limits<double>::infinity();
      for(std::size_t k = 0; k < N; ++k) {
        d[k] = group.center - places[k];
        squared[k] = d[k].squaredNorm();
        nearest = std::min(nearest, squared[k]);
      }
      if(nearest > group.squared_reach) {
        for(std::size_t k = 0; k < N; ++k)
          sum[k] += group.far(d[k], squared[k]);
        n = tree_.nodes()[n].after;
        continue;
      }
      if(tree_.is_leaf(n))
        for(std::size_t i = tree_.nodes()[n].begin; i < tree_.nodes()[n].end; ++i)
          for(std::size_t k = 0; k < N; ++k)
            sum[k] += dipoles_[i].at(places[k]);
      ++n;
    }
    for(double& value : sum)
      value /= 4 * CGAL_PI;
    return sum;
  }

  Box_tree tree_;
  std::vector<Dipole> dipoles_; ///< In the order of the tree.
  std::vector<Group> groups_;   ///< Of every node of the tree.
};

/// Turns the patches around whose normals point into the shape: the spanning tree of the orientation
/// may have taken a wrong turn at a thin or sharp place. The rest of the surface tells: it winds once
/// around what is behind a patch, and not around what is in front. First whole limbs that are inside
/// out, then patches that have more inside in front of them than behind. Returns the winding number of
/// what comes out.
template <typename ConcurrencyTag>
std::unique_ptr<Winding_number> settle_orientation(std::vector<Patch>& patches)
{
  std::unique_ptr<Winding_number> winding_number;
  std::vector<std::array<double, 2>> sides(patches.size()); // in front of a patch and behind it
  const auto look = [&] {
    winding_number = std::make_unique<Winding_number>(patches);
    parallel_for<ConcurrencyTag>(patches.size(), [&](std::size_t i) {
      const Vector3 step = patches[i].spacing * patches[i].normal;
      sides[i] = (*winding_number)(patches[i].mean + step, patches[i].mean - step);
    });
  };
  const auto turn_where = [&](const auto& is_wrong) {
    bool any = false;
    for(std::size_t i = 0; i < patches.size(); ++i)
      if(is_wrong(sides[i][0], sides[i][1])) {
        patches[i].normal = -patches[i].normal;
        any = true;
      }
    return any;
  };
  look();
  // The sum of both sides is 1 where the surroundings are oriented well, -1 where they are inside
  // out, and 0 on an open sheet, which has no inside.
  constexpr double inside_out = -0.5;
  if(turn_where([](double in_front, double behind) { return in_front + behind < inside_out; }))
    look();
  if(turn_where([](double in_front, double behind) { return in_front > behind; }))
    winding_number = std::make_unique<Winding_number>(patches);
  return winding_number;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_WINDING_NUMBER_H
