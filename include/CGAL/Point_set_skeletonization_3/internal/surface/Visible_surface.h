// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_VISIBLE_SURFACE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_VISIBLE_SURFACE_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Packet_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/facing.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Distances from places to the surface that is visible from inside.
class Visible_surface
{
public:
  /// `tree` is over the patches; `confidence` is that of their orientation. O(n).
  Visible_surface(const Patches& patches, const std::vector<double>& confidence,
                  const Box_tree& tree)
    : box_tree_(tree), tree_(tree)
  {
    for(std::size_t i : tree.order()) {
      normals_.push_back(patches[i].normal.cast<float>());
      least_cosines_.push_back(static_cast<float>(least_visible_cosine(confidence[i])));
    }
  }

  /// Returns the distance from each place to the nearest patch visible from inside, see
  /// `least_visible_cosine()`; 0 if none is. Fast if consecutive places are close (packet
  /// traversal).
  std::vector<double> distances(const std::vector<Vector3>& places, Concurrency concurrency) const
  {
    return distances(places, concurrency, [](Packet&, std::size_t, std::size_t) {});
  }

  /// The same for one place per patch, in their order; faster if it sees the patch.
  std::vector<double> distances_beside_patches(const std::vector<Vector3>& places,
                                               Concurrency concurrency) const
  {
    std::vector<Vector3> in_order;
    in_order.reserve(places.size());
    for(std::size_t i : box_tree_.order())
      in_order.push_back(places[i]);
    return box_tree_.by_index(distances(
      in_order, concurrency, [](Packet& packet, std::size_t first, std::size_t end) {
        packet.look_at(first, end); // the patches themselves, as a first bound
      }));
  }

private:
  class Packet
  {
  public:
    template <typename Place>
    Packet(const Visible_surface& patches, const Place& place)
      : patches_(patches),
        places_(packet_of([&](std::size_t k) { return patches.tree_.place(place(k)); }))
    {}

    double distance(std::size_t k) const
    {
      const float squared = squared_[k];
      return squared < far ? std::sqrt(static_cast<double>(squared)) : 0;
    }

    void look_at(std::size_t begin, std::size_t end)
    {
      for(std::size_t patch = begin; patch < end; ++patch)
        look_at(patch);
    }

    void look_at(std::size_t patch)
    {
      const Packet_vectors d = places_.to(patches_.tree_.positions()[patch]);
      const Packet_values squared = d.squared_norm();
      const Packet_values hidden = is_positive(patches_.least_cosines_[patch] * squared.sqrt() -
                                            d.dot(patches_.normals_[patch]));
      squared_ = squared_.min(squared + far * hidden);
    }

    /// Whether a patch of `node` may be nearer than the nearest so far.
    bool may_matter(std::size_t node) const
    {
      return places_.is_any_closer(patches_.tree_.boxes()[node], squared_);
    }

  private:
    static constexpr float far = 1e20f; // greater than any squared distance

    const Visible_surface& patches_;
    Packet_vectors places_;
    Packet_values squared_ = Packet_values::Constant(far); ///< Squared distances so far.
  };

  /// `begin(packet, first, end)` may test probable patches first, as a bound.
  template <typename Begin>
  std::vector<double> distances(const std::vector<Vector3>& places, Concurrency concurrency,
                                const Begin& begin) const
  {
    std::vector<double> result(places.size());
    for_each_packet(concurrency, places.size(), [&](std::size_t first, std::size_t end) {
      Packet packet(*this, [&](std::size_t k) { return places[(std::min)(first + k, end - 1)]; });
      begin(packet, first, end);
      tree_.visit_leaves(packet, [&](std::size_t b, std::size_t e) { packet.look_at(b, e); });
      for(std::size_t k = first; k < end; ++k)
        result[k] = packet.distance(k - first);
    });
    return result;
  }

  Box_tree box_tree_;
  Packet_tree tree_;
  // Of the patches, in the order of the tree.
  std::vector<Eigen::Vector3f> normals_;
  std::vector<float> least_cosines_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_VISIBLE_SURFACE_H
