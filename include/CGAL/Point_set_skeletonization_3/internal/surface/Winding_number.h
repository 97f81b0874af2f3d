// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_WINDING_NUMBER_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_WINDING_NUMBER_H

#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Packet_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel_for.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/patches.h>

#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

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
///
/// In single precision, and so in units of the extent of the patches, from their middle: it is compared
/// with a quarter or a half, and several places close to each other cost hardly more than one.
class Winding_number
{
public:
  /// `tree` over the patches; it has to stay.
  template <typename ConcurrencyTag = Sequential_tag>
  Winding_number(const std::vector<Patch>& patches, const Box_tree& tree,
                 ConcurrencyTag = ConcurrencyTag())
    : tree_(tree)
  {
    if(patches.empty())
      return;
    const Box& box = tree_.boxes().front();
    origin_ = (box.lower + box.upper) / 2;
    unit_ = std::max((box.upper - box.lower).maxCoeff(), least_spacing); // patches may coincide
    std::vector<Dipole> dipoles;
    dipoles.reserve(patches.size());
    for(std::size_t i : tree_.order())
      dipoles.push_back({(patches[i].mean - origin_) / unit_,
                         patches[i].planarity * patches[i].area / (unit_ * unit_) * patches[i].normal,
                         patches[i].spacing / (2 * unit_)});
    dipoles_.assign(dipoles.begin(), dipoles.end());
    const std::vector<Sums> sums = sums_of_nodes(dipoles);
    groups_.resize(sums.size());
    parallel_for<ConcurrencyTag>(groups_.size(), [&](std::size_t n) {
      const Box_tree::Node& node = tree_.nodes()[n];
      groups_[n] = Group(sums[n], dipoles.data() + node.begin, dipoles.data() + node.end);
    });
  }

  double operator()(const Vector3& q) const { return (*this)(std::array<Vector3, 1>{{q}})[0]; }

  /// At places close to each other.
  template <std::size_t N>
  std::array<double, N> operator()(const std::array<Vector3, N>& places) const
  {
    Eigen::Array<float, N, 3> q;
    for(std::size_t k = 0; k < N; ++k)
      q.row(static_cast<Eigen::Index>(k)) =
        ((places[k] - origin_) / unit_).transpose().template cast<float>();
    const Values<N> sum = at<N>(q);
    std::array<double, N> result;
    for(std::size_t k = 0; k < N; ++k)
      result[k] = static_cast<double>(sum[static_cast<Eigen::Index>(k)]) / (4 * CGAL_PI);
    return result;
  }

  /// At `place(k)`, k < `size`; quick if places next to each other are close.
  template <typename ConcurrencyTag, typename Place>
  std::vector<double> at_places(std::size_t size, const Place& place) const
  {
    std::vector<double> result(size);
    for_each_packet<ConcurrencyTag>(size, [&](std::size_t first, std::size_t end) {
      std::array<Vector3, packet_size> places;
      for(std::size_t k = 0; k < packet_size; ++k)
        places[k] = place(std::min(first + k, end - 1));
      const std::array<double, packet_size> values = (*this)(places);
      std::copy_n(values.begin(), end - first, result.data() + first);
    });
    return result;
  }

  /// At a place for every patch, `place(i)`; quick if those of patches next to each other are close.
  template <typename ConcurrencyTag, typename Place>
  std::vector<double> beside_patches(const Place& place) const
  {
    const std::vector<std::size_t>& order = tree_.order();
    return tree_.by_index(at_places<ConcurrencyTag>(
      order.size(), [&](std::size_t k) { return place(order[k]); }));
  }

private:
  template <std::size_t N>
  using Values = Eigen::Array<float, N, 1>;

  /// A patch.
  struct Dipole
  {
    Vector3 position;
    Vector3 moment; ///< Normal times area.
    double reach;   ///< Closer than that it does not count.
  };

  struct Near_dipole
  {
    Near_dipole(const Dipole& d)
      : position(d.position.cast<float>()), moment(d.moment.cast<float>()),
        squared_reach(static_cast<float>(d.reach * d.reach))
    {}

    template <std::size_t N>
    Values<N> at(const Eigen::Array<float, N, 3>& q) const
    {
      const Values<N> x = position.x() - q.col(0), y = position.y() - q.col(1),
                      z = position.z() - q.col(2);
      const Values<N> squared = x * x + y * y + z * z;
      const Values<N> count = is_positive(squared - squared_reach); // whether they do
      const Values<N> known = squared.max(squared_reach);
      return count * (moment.x() * x + moment.y() * y + moment.z() * z) / (known * known.sqrt());
    }

    Eigen::Vector3f position, moment;
    float squared_reach;
  };

  /// What adds up over dipoles.
  struct Sums
  {
    double weight = 0;
    Vector3 weighted_position = Vector3::Zero(), moment = Vector3::Zero();
    Matrix3 second = Matrix3::Zero(); ///< Of positions times moments.
    double reach = 0;                 ///< The largest.

    void add(const Dipole& dipole)
    {
      const double own_weight = dipole.moment.norm();
      weight += own_weight;
      weighted_position += own_weight * dipole.position;
      moment += dipole.moment;
      second += dipole.position * dipole.moment.transpose();
      reach = std::max(reach, dipole.reach);
    }

    void add(const Sums& other)
    {
      weight += other.weight;
      weighted_position += other.weighted_position;
      moment += other.moment;
      second += other.second;
      reach = std::max(reach, other.reach);
    }
  };

  /// Of every node of the tree.
  std::vector<Sums> sums_of_nodes(const std::vector<Dipole>& dipoles) const
  {
    std::vector<Sums> result(tree_.nodes().size());
    for(std::size_t n = result.size(); n-- > 0;)
      if(tree_.is_leaf(n))
        for(std::size_t k = tree_.nodes()[n].begin; k < tree_.nodes()[n].end; ++k)
          result[n].add(dipoles[k]);
      else {
        result[n].add(result[tree_.left(n)]);
        result[n].add(result[tree_.right(n)]);
      }
    return result;
  }

  /// Dipoles seen from far away.
  struct Group
  {
    Group() = default;

    Group(const Sums& sums, const Dipole* begin, const Dipole* end)
    {
      const Vector3 middle =
        sums.weight > 0 ? Vector3(sums.weighted_position / sums.weight) : begin->position;
      const Matrix3 second = sums.second - middle * sums.moment.transpose();
      double squared_radius = 0;
      for(const Dipole* dipole = begin; dipole != end; ++dipole)
        squared_radius = std::max(squared_radius, (dipole->position - middle).squaredNorm());
      const double radius = std::sqrt(squared_radius);
      center = middle.cast<float>();
      moment = sums.moment.cast<float>();
      diagonal = (Vector3::Constant(second.trace()) - 3 * second.diagonal()).cast<float>();
      const Matrix3 twice = second + second.transpose();
      mixed = -3 * Vector3(twice(1, 2), twice(2, 0), twice(0, 1)).cast<float>();
      // How many radii away the expansion starts to count. The error at 3 is 0.006 in the mean and
      // 0.03 at most, below what the dipoles themselves are wrong by near the surface; at 2 it is
      // three times that, for two thirds of the time.
      constexpr double beta = 3;
      reach = static_cast<float>(std::max(beta * radius, radius + sums.reach));
    }

    /// The sum of its dipoles.
    template <std::size_t N>
    Values<N> at(const Eigen::Array<float, N, 3>& q) const
    {
      const Values<N> x = center.x() - q.col(0), y = center.y() - q.col(1),
                      z = center.z() - q.col(2);
      const Values<N> squared = x * x + y * y + z * z;
      const Values<N> linear = moment.x() * x + moment.y() * y + moment.z() * z;
      const Values<N> quadratic = x * (diagonal.x() * x + mixed.z() * y) +
                                  y * (diagonal.y() * y + mixed.x() * z) +
                                  z * (diagonal.z() * z + mixed.y() * x);
      return (linear * squared + quadratic) / (squared * squared * squared.sqrt());
    }

    Eigen::Vector3f center;   ///< Of their area.
    Eigen::Vector3f moment;
    Eigen::Vector3f diagonal, mixed; ///< The second term: the factors of xx, yy, zz and yz, zx, xy.
    float reach = 0;                 ///< Beyond this distance from the centre that holds.
  };

  template <std::size_t N>
  Values<N> at(const Eigen::Array<float, N, 3>& q) const
  {
    const Eigen::Vector3f middle = q.colwise().mean().matrix().transpose();
    const float radius = (q.matrix().rowwise() - middle.transpose()).rowwise().norm().maxCoeff();
    Values<N> sum = Values<N>::Zero();
    for(std::size_t n = 0; n < groups_.size();) {
      const Group& group = groups_[n];
      const float away = group.reach + radius;
      if((group.center - middle).squaredNorm() > away * away) {
        sum += group.template at<N>(q);
        n = tree_.nodes()[n].after;
        continue;
      }
      if(tree_.is_leaf(n))
        for(std::size_t i = tree_.nodes()[n].begin; i < tree_.nodes()[n].end; ++i)
          sum += dipoles_[i].template at<N>(q);
      ++n;
    }
    return sum;
  }

  const Box_tree& tree_;
  Vector3 origin_ = Vector3::Zero(); ///< In the middle of the patches,
  double unit_ = 1;                  ///< and their extent.
  std::vector<Near_dipole> dipoles_; ///< In the order of the tree.
  std::vector<Group> groups_;        ///< Of every node of the tree.
};

/// Whether the normals around a patch enclose less than 60 degrees with its own, in the mean.
inline bool is_like_its_neighbors(const Patch& patch, const std::vector<Patch>& patches)
{
  Vector3 sum = Vector3::Zero();
  for(std::size_t j : patch.neighbors)
    sum += patches[j].normal;
  return patch.normal.dot(sum) > 0.5 * static_cast<double>(patch.neighbors.size());
}

/// The winding numbers at the patches: a half where the surroundings are oriented well, minus a half
/// where they are inside out, and 0 on an open sheet, which has no inside. What is inside out is a limb,
/// larger than a few patches next to each other: where one of these is well oriented, so are the others.
template <typename ConcurrencyTag>
std::vector<double> winding_numbers_on_surface(const Winding_number& winding_number,
                                               const Box_tree& tree)
{
  constexpr double well = 0.25;
  const std::vector<Vector3>& positions = tree.positions();
  const std::size_t rows = (positions.size() + packet_size - 1) / packet_size;
  const std::vector<double> of_rows = winding_number.at_places<ConcurrencyTag>(
    rows, [&](std::size_t row) { return positions[row * packet_size]; });
  std::vector<std::size_t> unsure; // places in the tree
  for(std::size_t place = 0; place < positions.size(); ++place)
    if(of_rows[place / packet_size] < well)
      unsure.push_back(place);
  const std::vector<double> of_unsure = winding_number.at_places<ConcurrencyTag>(
    unsure.size(), [&](std::size_t k) { return positions[unsure[k]]; });
  std::vector<double> result(positions.size(), 0.5);
  for(std::size_t k = 0; k < unsure.size(); ++k)
    result[tree.order()[unsure[k]]] = of_unsure[k];
  return result;
}

/// Turns the patches around whose normals point into the shape: the spanning tree of the orientation
/// may have taken a wrong turn at a thin or sharp place. The rest of the surface tells: it winds once
/// around what is behind a patch, and not around what is in front. First whole limbs that are inside
/// out, then patches unlike their neighbours that have more inside in front of them than behind.
/// Returns the winding number of what comes out.
template <typename ConcurrencyTag>
std::unique_ptr<Winding_number> settle_orientation(std::vector<Patch>& patches,
                                                   const Box_tree& tree)
{
  auto winding_number = std::make_unique<Winding_number>(patches, tree, ConcurrencyTag());
  const auto turn_where = [&](const auto& is_wrong) {
    std::vector<char> wrong(patches.size());
    parallel_for<ConcurrencyTag>(patches.size(),
                                 [&](std::size_t i) { wrong[i] = is_wrong(i); });
    for(std::size_t i = 0; i < patches.size(); ++i)
      if(wrong[i])
        patches[i].normal = -patches[i].normal;
    if(std::any_of(wrong.begin(), wrong.end(), [](char is) { return is; }))
      winding_number = std::make_unique<Winding_number>(patches, tree, ConcurrencyTag());
  };
  const std::vector<double> on_surface =
    winding_numbers_on_surface<ConcurrencyTag>(*winding_number, tree);
  constexpr double inside_out = -0.25;
  turn_where([&](std::size_t i) { return on_surface[i] < inside_out; });
  turn_where([&](std::size_t i) {
    const Patch& patch = patches[i];
    if(is_like_its_neighbors(patch, patches))
      return false;
    const Vector3 step = patch.spacing * patch.normal;
    const auto [in_front, behind] =
      (*winding_number)(std::array<Vector3, 2>{{patch.mean + step, patch.mean - step}});
    return in_front > behind;
  });
  return winding_number;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_WINDING_NUMBER_H
