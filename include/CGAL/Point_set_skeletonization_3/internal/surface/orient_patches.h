// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_ORIENT_PATCHES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_ORIENT_PATCHES_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/minimum_spanning_forest.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/facing.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns how well the normal of `b` continues that of `a`, in [-1, 1]: the cosine between `a`'s
/// normal and `b`'s mirrored in the plane halfway between them. 1 for any two patches around a
/// round tube (Hoppe et al. 1992 compare the normals themselves and lose thin limbs).
inline double continuation(const Patch& a, const Patch& b)
{
  const Vector3 d = (b.mean - a.mean).normalized();
  return a.normal.dot(b.normal - 2 * d.dot(b.normal) * d);
}

/// Flips the normals of a connected component if its enclosed volume is negative. O(size of the
/// component).
inline void turn_outwards(Patches& patches, const std::vector<std::size_t>& piece)
{
  Vector3 center = Vector3::Zero();
  double weight = 0;
  for(std::size_t i : piece) {
    center += patches[i].weight * patches[i].mean;
    weight += patches[i].weight;
  }
  center /= weight;
  double flux = 0; // of the field x - center: 3 times the volume
  for(std::size_t i : piece)
    flux += patches[i].planarity * patches[i].spacing * patches[i].spacing *
            patches[i].normal.dot(patches[i].mean - center);
  if(flux < 0)
    for(std::size_t i : piece)
      patches[i].normal = -patches[i].normal;
}

/// Relative sign of the normals of two adjacent patches.
struct Sign_link // small: there are many
{
  std::uint32_t a = 0, b = 0;
  std::uint32_t index = 0;
  bool is_opposite = false; ///< One of the two normals has to be flipped.
  double trust = 0;         ///< In [0, 1].

  /// Greater trust comes first.
  bool operator<(const Sign_link& other) const
  {
    return trust != other.trust ? trust > other.trust : index < other.index;
  }
};

/// Returns the links of all adjacent pairs. O(pairs).
inline std::vector<Sign_link> sign_links(const Patches& patches, Concurrency concurrency)
{
  const std::vector<Patch_pair> pairs = adjacent_pairs(patches);
  std::vector<Sign_link> links(pairs.size());
  parallel_for(concurrency, pairs.size(), [&](std::size_t k) {
    const Patch &a = patches[pairs[k].a], &b = patches[pairs[k].b];
    const double cosine = continuation(a, b);
    const double trust = (std::max)(0.0, std::abs(cosine) * (std::min)(a.planarity, b.planarity));
    links[k] = {pairs[k].a, pairs[k].b, static_cast<std::uint32_t>(k), cosine < 0, trust};
  });
  return links;
}

/// Sign of each patch relative to the first of its connected component: union-find over two nodes
/// per patch, one for each sign.
class Signed_pieces
{
public:
  /// Each patch is a component.
  explicit Signed_pieces(std::size_t size) : sets_(2 * size) {}

  /// The first patch of the component of a patch, and whether their signs are opposite.
  std::size_t piece(std::size_t i) { return sets_.find(node(i, false)) / 2; }
  bool is_opposite(std::size_t i) { return sets_.find(node(i, false)) % 2 == 1; }

  /// Joins two components. \pre the patches of the link are in different ones
  void join(const Sign_link& link)
  {
    for(bool sign : {false, true})
      sets_.join(node(link.a, sign), node(link.b, sign != link.is_opposite));
  }

private:
  static std::size_t node(std::size_t i, bool sign) { return 2 * i + (sign ? 1 : 0); }

  Union_find sets_;
};

/// Returns the signs propagated along the spanning forest of greatest trust. O(links log n).
inline Signed_pieces signed_pieces(std::vector<Sign_link> links, std::size_t size)
{
  Union_find pieces(size);
  Signed_pieces result(size);
  for(const Sign_link& link : minimum_spanning_forest(pieces, size, std::move(links)))
    result.join(link);
  return result;
}

/// Makes normals consistent and outward: propagates signs along a maximum spanning forest of the
/// best continued pairs (Hoppe et al. 1992), then makes the enclosed volume of each connected
/// component positive. O(n log n).
inline void orient_patches(Patches& patches, Concurrency concurrency)
{
  Signed_pieces pieces = signed_pieces(sign_links(patches, concurrency), patches.size());
  std::map<std::size_t, std::vector<std::size_t>> members;
  for(std::size_t i = 0; i < patches.size(); ++i) {
    members[pieces.piece(i)].push_back(i);
    if(pieces.is_opposite(i))
      patches[i].normal = -patches[i].normal;
  }
  for(const auto& piece : members)
    turn_outwards(patches, piece.second);
}

/// Returns the orientation confidence of each patch, in [0, 1]: its planarity times the mean
/// continuation by its neighbours. Near 0 on twigs thinner than the sampling and in heavy noise,
/// where normals must not be used. O(n).
inline std::vector<double> orientation_confidence(const Patches& patches, Concurrency concurrency)
{
  std::vector<double> confidence(patches.size(), 0);
  parallel_for(concurrency, patches.size(), [&](std::size_t i) {
    double agreement = 0;
    for(std::size_t j : patches[i].neighbors)
      agreement += continuation(patches[i], patches[j]);
    if(!patches[i].neighbors.empty())
      agreement /= static_cast<double>(patches[i].neighbors.size());
    confidence[i] = patches[i].planarity * (std::max)(0.0, agreement);
  });
  return confidence;
}

/// Makes patches that face each other non-adjacent, if both orientations are
/// trusted. O(n).
inline void part_facing_patches(Patches& patches, const std::vector<double>& confidence,
                                const Surface_options& options, Concurrency concurrency)
{
  parallel_for(concurrency, patches.size(), [&](std::size_t i) {
    std::vector<std::size_t>& neighbors = patches[i].neighbors;
    neighbors.erase(std::remove_if(neighbors.begin(), neighbors.end(),
                                   [&](std::size_t j) {
                                     return confidence[i] > options.trusted_orientation &&
                                            confidence[j] > options.trusted_orientation &&
                                            face_each_other(patches[i], patches[j], options);
                                   }),
                    neighbors.end());
  });
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_ORIENT_PATCHES_H
