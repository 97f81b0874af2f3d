// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_MEDIAL_BALLS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_MEDIAL_BALLS_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Per_thread.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Packet_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface_options.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Balls that touch two patches whose orientation is trusted: the first at its mean, the other
/// anywhere on a disc of its area, since across a thin wall no mean is opposite.
class Facing_balls
{
public:
  /// `tree` is over the patches; `confidence` is that of their orientation. O(n).
  Facing_balls(const Patches& patches, const std::vector<double>& confidence, const Box_tree& tree,
               const Surface_options& options)
    : box_tree_(tree), tree_(tree), facing_(static_cast<float>(options.opposite_normals))
  {
    std::vector<Vector3> normals(patches.size(), Vector3::Zero()); // a zero vector faces nothing
    for(std::size_t i = 0; i < patches.size(); ++i)
      if(confidence[i] >= options.trusted_orientation)
        normals[i] = patches[i].normal;
    for(const Box_tree::Box& box : tree.boxes_of(normals))
      normal_boxes_.push_back(box.cast<float>());
    std::vector<Vector3> discs; // the radius, three times
    for(const Patch& patch : patches)
      discs.push_back(Vector3::Constant(std::sqrt(patch.area / CGAL_PI)));
    for(const Box_tree::Box& box : tree.boxes_of(discs))
      largest_discs_.push_back(static_cast<float>((box.max)().x()));
    for(std::size_t i : tree.order()) {
      normals_.push_back(normals[i].cast<float>());
      discs_.push_back(static_cast<float>(discs[i].x()));
    }
  }

  /// Returns for each patch the radius of the third smallest ball that touches it from inside and a
  /// patch that faces it, so that two outliers cannot make a wrong ball. 0 if fewer than three
  /// patches face it. O(n log n) in practice.
  std::vector<double> radii(Concurrency concurrency) const
  {
    const std::vector<std::size_t>& order = box_tree_.order();
    std::vector<double> result(order.size(), 0);
    constexpr std::size_t task_size = 16 * packet_size; // consecutive patches
    const std::size_t tasks = (order.size() + task_size - 1) / task_size;
    parallel_for(concurrency, tasks, [&](std::size_t task) {
      Leaves touched;
      const std::size_t end = (std::min)(order.size(), (task + 1) * task_size);
      for(std::size_t first = task * task_size; first < end; first += packet_size) {
        Packet balls(*this, first);
        find_smallest(balls, touched);
        for(std::size_t k = 0; k < packet_size && first + k < end; ++k)
          result[order[first + k]] = balls.radius(k);
      }
    });
    return result;
  }

private:
  /// Ranges of patches of leaves.
  using Leaves = std::vector<std::pair<std::size_t, std::size_t>>;

  /// Packet query: the three smallest balls of eight consecutive patches.
  class Packet
  {
  public:
    Packet(const Facing_balls& all, std::size_t first)
        : all_(all)
        , mean_(packet_of(
              [&](std::size_t k) { return all.tree_.positions()[all.bounded(first + k)]; }))
        , normal_(packet_of([&](std::size_t k) { return all.normals_[all.bounded(first + k)]; }))
    {}

    /// Radius of the third smallest ball of the `k`-th patch; 0 if there is none.
    double radius(std::size_t k) const
    {
      const auto curvature = static_cast<double>(third_[k]);
      return curvature > 0 ? 1 / curvature : 0;
    }

    /// Tests the patches from `begin` to before `end`. Returns whether a third smallest ball became
    /// smaller.
    bool look_at(std::size_t begin, std::size_t end)
    {
      const Packet_values before = third_;
      for(std::size_t other = begin; other < end; ++other)
        look_at(other);
      return (third_ - before).maxCoeff() > 0;
    }

    /// A ball with radius r and centre p - r n touches the plane through q = p + d with normal m at
    /// p + r (m - n), if r = d.m / (1 - n.m). It touches the disc around q at the place nearest to
    /// that, p + e. A ball through that has the curvature -2 e.n / e^2.
    void look_at(std::size_t other)
    {
      const Eigen::Vector3f& normal = all_.normals_[other];
      const Packet_vectors d = mean_.to(all_.tree_.positions()[other]);
      const Packet_values cosine = normal_.dot(normal);
      const Packet_values face = is_positive(all_.facing_ - cosine);
      const Packet_values height = d.dot(normal).max(0); // 0 behind it, where its mean counts
      const Packet_values radius = height / (1 - cosine).max(1);
      const Packet_vectors away{radius * (normal.x() - normal_.x) - d.x,
                                radius * (normal.y() - normal_.y) - d.y,
                                radius * (normal.z() - normal_.z) - d.z};
      const Packet_values share =
        is_positive(height) *
        (all_.discs_[other] / away.squared_norm().max(least).sqrt()).min(1);
      const Packet_vectors e{d.x + share * away.x, d.y + share * away.y, d.z + share * away.z};
      const Packet_values curvature =
          (-2 * face * e.dot(normal_) / e.squared_norm().max(least)).max(0);
      const Packet_values rest = curvature.min(first_), second_rest = rest.min(second_);
      first_ = first_.max(curvature);
      second_ = second_.max(rest);
      third_ = third_.max(second_rest);
    }

    /// Whether a patch of `node` may face one of the packet and touch its third smallest ball.
    bool may_matter(std::size_t node) const
    {
      const Eigen::AlignedBox3f &box = all_.tree_.boxes()[node],
                                &normals = all_.normal_boxes_[node];
      const Eigen::Vector3f &least_normal = (normals.min)(), &most_normal = (normals.max)();
      const Packet_values cosine =
        (normal_.x * least_normal.x()).min(normal_.x * most_normal.x()) +
        (normal_.y * least_normal.y()).min(normal_.y * most_normal.y()) +
        (normal_.z * least_normal.z()).min(normal_.z * most_normal.z());
      // The point of the discs' box with the least power with respect to the ball.
      const Packet_values radius = 1 / third_.max(least);
      const Eigen::Vector3f disc = Eigen::Vector3f::Constant(all_.largest_discs_[node]);
      const Packet_vectors lower = mean_.to((box.min)() - disc),
                           upper = mean_.to((box.max)() + disc);
      const Packet_vectors d{(-radius * normal_.x).max(lower.x).min(upper.x),
                          (-radius * normal_.y).max(lower.y).min(upper.y),
                          (-radius * normal_.z).max(lower.z).min(upper.z)};
      const Packet_values power = third_ * d.squared_norm() + 2 * d.dot(normal_);
      return (cosine - all_.facing_).max(power).minCoeff() < 0;
    }

  private:
    static constexpr float least = 1e-20f; // instead of 0

    const Facing_balls& all_;
    Packet_vectors mean_, normal_;
    // Curvatures of the three smallest balls, the smallest ball first; 0: none.
    Packet_values first_ = Packet_values::Zero(), second_ = Packet_values::Zero(),
                  third_ = Packet_values::Zero();
  };

  /// Finds the smallest balls of a packet. Starts with the leaves `touched` by those of the packet
  /// before, and replaces them by its own.
  void find_smallest(Packet& balls, Leaves& touched) const
  {
    constexpr std::size_t most = 8; // leaves around a limb
    const Leaves likely = std::exchange(touched, {});
    const auto look_into = [&](const Leaves::value_type& leaf) {
      if(balls.look_at(leaf.first, leaf.second))
        touched.push_back(leaf);
    };
    std::for_each(likely.begin(), likely.end(), look_into);
    tree_.visit_leaves(balls, [&](std::size_t begin, std::size_t end) {
      const Leaves::value_type leaf(begin, end);
      if(std::find(likely.begin(), likely.end(), leaf) == likely.end())
        look_into(leaf);
    });
    if(touched.size() > most) // the last ones touch the smallest balls
      touched.erase(touched.begin(), touched.end() - most);
  }

  std::size_t bounded(std::size_t place) const
  {
    return (std::min)(place, box_tree_.order().size() - 1);
  }

  Box_tree box_tree_;
  Packet_tree tree_;
  float facing_; ///< Cosine of two normals below which they face each other.
  // Of each node of the tree.
  std::vector<Eigen::AlignedBox3f> normal_boxes_;
  std::vector<float> largest_discs_; ///< Radii.
  // Of each patch, in the order of the tree.
  std::vector<Eigen::Vector3f> normals_; ///< 0 if not trusted.
  std::vector<float> discs_;             ///< Radii.
};

/// Returns the upper median of about a dozen values by counting for each how many are less. That is
/// O(n^2), but faster than sorting, whose branches are unpredictable. \pre there is a value
inline double median_of_few(const std::vector<double>& values)
{
  const auto middle = static_cast<int>(values.size() / 2);
  for(double candidate : values) {
    int less = 0, no_greater = 0;
    for(double value : values) {
      less += value < candidate;
      no_greater += value <= candidate;
    }
    if(less <= middle && middle < no_greater)
      return candidate;
  }
  return values.front(); // unreachable
}

/// Returns for each patch the median of the known values (> 0) of the patch and its neighbours: one
/// pass of a median filter. O(n).
inline std::vector<double> median_filtered(const std::vector<double>& values,
                                           const Patches& patches, Concurrency concurrency)
{
  std::vector<double> result = values;
  Per_thread<std::vector<double>> buffers(concurrency, [] { return std::vector<double>(); });
  parallel_for(concurrency, patches.size(), [&](std::size_t i) {
    std::vector<double>& known = buffers.local();
    known.clear();
    if(values[i] > 0)
      known.push_back(values[i]);
    for(std::size_t j : patches[i].neighbors)
      if(values[j] > 0)
        known.push_back(values[j]);
    if(!known.empty())
      result[i] = median_of_few(known);
  });
  return result;
}

/// Lowers each value to at most those of adjacent patches plus `slope` times their distance.
/// Unknown values (0) become this bound.
inline void limit_slope(std::vector<double>& values, const Patches& patches, double slope)
{
  std::vector<std::size_t> queue; // label-correcting: any order gives the same values
  std::vector<bool> waits(values.size(), true);
  for(std::size_t i = 0; i < values.size(); ++i)
    queue.push_back(i);
  for(std::size_t next = 0; next < queue.size(); ++next) {
    const std::size_t i = queue[next];
    waits[i] = false;
    if(!(values[i] > 0))
      continue;
    for(std::size_t j : patches[i].neighbors) {
      const double most = values[i] + slope * (patches[i].mean - patches[j].mean).norm();
      if(values[j] > most || !(values[j] > 0)) {
        values[j] = most;
        if(!waits[j])
          queue.push_back(j);
        waits[j] = true;
      }
    }
  }
}

/// Returns the radius of the medial ball at each patch. Shrinking balls (Ma et al. 2012) depend on
/// every patch nearby; among patches that face each other the relative error is that of the patches
/// over the thickness. Three passes of a median filter remove outliers; patches without a ball get
/// the radius of their surroundings, 0 if there is none. `slope` bounds the change of the radius
/// along the surface. O(n log n) in practice.
inline std::vector<double> medial_ball_radii(const Surface& surface, double slope,
                                             Concurrency concurrency)
{
  const Patches& patches = surface.patches;
  std::vector<double> radii =
    Facing_balls(patches, surface.confidence, surface.tree, surface.options).radii(concurrency);
  for(int pass = 0; pass < 3; ++pass)
    radii = median_filtered(radii, patches, concurrency);
  limit_slope(radii, patches, slope);
  return radii;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_MEDIAL_BALLS_H
