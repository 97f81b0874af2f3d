// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_ORIENT_PATCHES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_ORIENT_PATCHES_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel_for.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/patches.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// How well the normal of `b` continues that of `a`: the cosine between `a`'s normal and `b`'s
/// mirrored in the plane halfway between them, which is 1 for any two patches of one round tube
/// however far apart (Hoppe et al. 1992 compare the normals themselves and lose thin limbs).
inline double continuation(const Patch& a, const Patch& b)
{
  const Vector3 d = (b.mean - a.mean).normalized();
  return a.normal.dot(b.normal - 2 * d.dot(b.normal) * d);
}

/// Flips every normal of one connected piece of surface so that the volume it encloses is positive.
inline void turn_outwards(std::vector<Patch>& patches, const std::vector<std::size_t>& piece)
{
  Vector3 center = Vector3::Zero();
  double weight = 0;
  for(std::size_t i : piece) {
    center += patches[i].weight * patches[i].mean;
    weight += patches[i].weight;
  }
  center /= weight;
  double flux = 0; // of the field x - center through the oriented patches: 3 times the volume
  for(std::size_t i : piece)
    flux += patches[i].planarity * patches[i].spacing * patches[i].spacing *
            patches[i].normal.dot(patches[i].mean - center);
  if(flux < 0)
    for(std::size_t i : piece)
      patches[i].normal = -patches[i].normal;
}

/// What two patches that are neighbours, or pieces of surface, know of each other's signs.
struct Sign_link
{
  Patch_pair pair;
  double trust;     ///< In [0, 1].
  bool is_opposite; ///< One of the two has to be turned around.
};

/// The links between adjacent patches.
template <typename ConcurrencyTag>
std::vector<Sign_link> sign_links(const std::vector<Patch>& patches)
{
  const std::vector<Patch_pair> pairs = adjacent_pairs(patches);
  std::vector<Sign_link> links(pairs.size());
  parallel_for<ConcurrencyTag>(pairs.size(), [&](std::size_t k) {
    const Patch &a = patches[pairs[k].a], &b = patches[pairs[k].b];
    const double cosine = continuation(a, b);
    const double trust = std::max(0.0, std::abs(cosine) * std::min(a.planarity, b.planarity));
    links[k] = {pairs[k], trust, cosine < 0};
  });
  return links;
}

/// The sign of every patch relative to the first one of its piece.
class Signed_pieces
{
public:
  /// Every patch is a piece.
  explicit Signed_pieces(std::size_t size) : sets_(2 * size) {}

  /// The first patch of the piece of a patch.
  std::size_t piece(std::size_t i) { return sets_.root(node(i, false)) / 2; }
  bool is_opposite(std::size_t i) { return sets_.root(node(i, false)) % 2 == 1; }

  void join(const Sign_link& link)
  {
    if(piece(link.pair.a) == piece(link.pair.b))
      return;
    for(bool sign : {false, true})
      sets_.join(node(link.pair.a, sign), node(link.pair.b, sign != link.is_opposite));
  }

private:
  /// A patch with one of its signs, as if they were two.
  static std::size_t node(std::size_t i, bool sign) { return 2 * i + (sign ? 1 : 0); }

  Union_find sets_;
};

/// The signs that the maximum spanning tree of the links hands on (Boruvka's algorithm).
inline Signed_pieces spanned_pieces(std::vector<Sign_link> links, std::size_t size)
{
  Signed_pieces pieces(size);
  std::vector<double> trust(size); // of the best link of every piece
  std::vector<std::size_t> best(size);
  std::vector<std::uint32_t> piece(size);
  std::vector<char> is_opposite(size);
  while(!links.empty()) {
    std::fill(trust.begin(), trust.end(), -1);
    for(std::size_t k = 0; k < links.size(); ++k)
      for(std::size_t i : {links[k].pair.a, links[k].pair.b})
        if(links[k].trust > trust[i]) {
          trust[i] = links[k].trust;
          best[i] = k;
        }
    for(std::size_t i = 0; i < size; ++i)
      if(trust[i] >= 0)
        pieces.join(links[best[i]]);
    for(std::size_t i = 0; i < size; ++i) {
      piece[i] = static_cast<std::uint32_t>(pieces.piece(i));
      is_opposite[i] = pieces.is_opposite(i);
    }
    std::size_t left = 0; // between pieces, from now on by their first patches
    for(const Sign_link& link : links) {
      const auto [a, b] = link.pair;
      const bool is_turned = is_opposite[a] != is_opposite[b];
      links[left] = {{piece[a], piece[b]}, link.trust, link.is_opposite != is_turned};
      left += piece[a] != piece[b];
    }
    links.resize(left);
  }
  return pieces;
}

/// Makes the normals of adjacent patches consistent and outward: a spanning tree of the best continued
/// edges (Hoppe et al. 1992) hands the sign on, and the sign of the enclosed volume fixes it for every
/// connected piece.
template <typename ConcurrencyTag>
void orient_patches(std::vector<Patch>& patches)
{
  Signed_pieces pieces = spanned_pieces(sign_links<ConcurrencyTag>(patches), patches.size());
  std::map<std::size_t, std::vector<std::size_t>> members;
  for(std::size_t i = 0; i < patches.size(); ++i) {
    members[pieces.piece(i)].push_back(i);
    if(pieces.is_opposite(i))
      patches[i].normal = -patches[i].normal;
  }
  for(const auto& piece : members)
    turn_outwards(patches, piece.second);
}

/// How far the orientation of every patch can be trusted, in [0, 1]: how flat it is, times how well
/// its neighbours' normals agree with it. Near 0 on twigs thinner than the sampling and in heavy
/// noise: there whatever relies on a normal has to fade out.
template <typename ConcurrencyTag>
std::vector<double> orientation_confidence(const std::vector<Patch>& patches)
{
  std::vector<double> confidence(patches.size(), 0);
  parallel_for<ConcurrencyTag>(patches.size(), [&](std::size_t i) {
    double agreement = 0;
    for(std::size_t j : patches[i].neighbors)
      agreement += continuation(patches[i], patches[j]);
    if(!patches[i].neighbors.empty())
      agreement /= static_cast<double>(patches[i].neighbors.size());
    confidence[i] = patches[i].planarity * std::max(0.0, agreement);
  });
  return confidence;
}

/// Below this confidence a normal is a guess, and nothing is built on it.
constexpr double trusted_orientation = 0.3;

/// Whether two patches look at each other through the air between them: they belong to two limbs
/// that nearly touch.
inline bool look_at_each_other(const Patch& a, const Patch& b)
{
  constexpr double opposite = -0.3; // cosine: a crease between two limbs is a right angle or so
  constexpr double towards = 0.8;   // sum of two cosines: both by 66 degrees, or one straight
  const Vector3 d = (b.mean - a.mean).normalized();
  const double from_a = a.normal.dot(d), from_b = -b.normal.dot(d);
  return a.normal.dot(b.normal) < opposite && from_a > 0 && from_b > 0 &&
         from_a + from_b > towards;
}

/// The orientation gate: patches that look at each other are no neighbours, as far as their
/// orientation can be trusted.
template <typename ConcurrencyTag>
void part_facing_patches(std::vector<Patch>& patches, const std::vector<double>& confidence)
{
  parallel_for<ConcurrencyTag>(patches.size(), [&](std::size_t i) {
    std::vector<std::size_t>& neighbors = patches[i].neighbors;
    neighbors.erase(std::remove_if(neighbors.begin(), neighbors.end(),
                                   [&](std::size_t j) {
                                     return confidence[i] > trusted_orientation &&
                                            confidence[j] > trusted_orientation &&
                                            look_at_each_other(patches[i], patches[j]);
                                   }),
                    neighbors.end());
  });
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_ORIENT_PATCHES_H
