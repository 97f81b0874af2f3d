// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PUBLIC_DATA_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PUBLIC_DATA_H

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Gaussian_mixture_3.h>
#include <CGAL/Medial_sample_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Point_source.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/plain_data.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Conversions between plain data and public data structures of the user's kernel. O(size).

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

template <typename Point_3>
Plain_point to_plain(const Point_3& p)
{
  return {{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}};
}

template <typename GeomTraits>
typename GeomTraits::Point_3 to_public(const Plain_point& p, const GeomTraits& traits)
{
  using FT = typename GeomTraits::FT;
  return traits.construct_point_3_object()(static_cast<FT>(p[0]), static_cast<FT>(p[1]),
                                           static_cast<FT>(p[2]));
}

template <typename GeomTraits>
Gaussian_component_3<GeomTraits> to_public(const Plain_gaussian& g, const GeomTraits& traits)
{
  using FT = typename GeomTraits::FT;
  Gaussian_component_3<GeomTraits> result{static_cast<FT>(g.weight), to_public(g.mean, traits), {}};
  std::transform(g.covariance.begin(), g.covariance.end(), result.covariance.begin(),
                 [](double x) { return static_cast<FT>(x); });
  return result;
}

template <typename GeomTraits>
Plain_gaussian to_plain(const Gaussian_component_3<GeomTraits>& g)
{
  Plain_gaussian result{CGAL::to_double(g.weight), to_plain(g.mean), {}};
  std::transform(g.covariance.begin(), g.covariance.end(), result.covariance.begin(),
                 [](const auto& x) { return CGAL::to_double(x); });
  return result;
}

inline Bbox_3 to_public(const Plain_box& box)
{
  return box.is_known ? Bbox_3(box.lower[0], box.lower[1], box.lower[2], //
                               box.upper[0], box.upper[1], box.upper[2])
                      : Bbox_3();
}

inline Plain_box to_plain(const Bbox_3& box)
{
  return {{{(box.xmin)(), (box.ymin)(), (box.zmin)()}},
          {{(box.xmax)(), (box.ymax)(), (box.zmax)()}},
          (box.xmin)() <= (box.xmax)()};
}

template <typename GeomTraits>
Gaussian_mixture_3<GeomTraits> to_public(const Plain_mixture& mixture, const GeomTraits& traits)
{
  Gaussian_mixture_3<GeomTraits> result;
  for(const std::vector<Plain_gaussian>& level : mixture.levels) {
    result.levels.emplace_back();
    for(const Plain_gaussian& g : level)
      result.levels.back().push_back(to_public(g, traits));
  }
  result.cell_size = static_cast<typename GeomTraits::FT>(mixture.cell_size);
  result.bbox = to_public(mixture.box);
  return result;
}

template <typename GeomTraits>
Plain_mixture to_plain(const Gaussian_mixture_3<GeomTraits>& mixture)
{
  Plain_mixture result;
  for(const auto& level : mixture.levels) {
    result.levels.emplace_back();
    for(const auto& g : level)
      result.levels.back().push_back(to_plain(g));
  }
  result.cell_size = CGAL::to_double(mixture.cell_size);
  result.box = to_plain(mixture.bbox);
  return result;
}

template <typename GeomTraits>
Medial_samples_3<GeomTraits> to_public(const Plain_samples& samples, const GeomTraits& traits)
{
  using FT = typename GeomTraits::FT;
  Medial_samples_3<GeomTraits> result;
  for(const Plain_sample& s : samples.samples)
    result.samples.push_back(
      {to_public(s.patch, traits), to_public(s.point, traits), static_cast<FT>(s.radius), s.kind,
       s.object});
  for(double noise : samples.noise)
    result.noise.push_back(static_cast<FT>(noise));
  result.bbox = to_public(samples.box);
  for(const Plain_surface_point& p : samples.surface)
    result.surface.push_back({to_public(p.point, traits), to_public(p.denoised, traits),
                              static_cast<FT>(p.weight), p.sample});
  return result;
}

/// Whether the strength of the noise of each object is in [0, 1].
template <typename GeomTraits>
bool have_possible_noise(const Medial_samples_3<GeomTraits>& samples)
{
  return std::all_of(samples.noise.begin(), samples.noise.end(),
                     [](const auto& noise) { return noise >= 0 && noise <= 1; });
}

/// Whether there are no more objects than samples.
template <typename GeomTraits>
bool have_possible_objects(const Medial_samples_3<GeomTraits>& samples)
{
  return std::all_of(samples.samples.begin(), samples.samples.end(),
                     [&](const auto& s) { return s.object < samples.samples.size(); });
}

/// Whether the surface points of samples, if there are any, are of each sample, and of no other.
template <typename GeomTraits>
bool has_points_of_all_samples(const Medial_samples_3<GeomTraits>& samples)
{
  if(samples.surface.empty())
    return true;
  std::vector<bool> has_point(samples.samples.size(), false);
  for(const auto& p : samples.surface) {
    if(p.sample >= has_point.size())
      return false;
    has_point[p.sample] = true;
  }
  return std::find(has_point.begin(), has_point.end(), false) == has_point.end();
}

template <typename GeomTraits>
Plain_samples to_plain(const Medial_samples_3<GeomTraits>& samples)
{
  Plain_samples result;
  for(const auto& s : samples.samples)
    result.samples.push_back(
      {to_plain(s.patch), to_plain(s.point), CGAL::to_double(s.radius), s.kind, s.object});
  for(const auto& noise : samples.noise)
    result.noise.push_back(CGAL::to_double(noise));
  result.box = to_plain(samples.bbox);
  for(const auto& p : samples.surface)
    result.surface.push_back(
      {to_plain(p.point), to_plain(p.denoised), CGAL::to_double(p.weight), p.sample});
  return result;
}

/// Returns the points of a range through a property map; refers to the range. Advances an iterator
/// through it once: O(blocks) for random access, else O(n).
template <typename PointRange, typename PointMap>
Point_source point_source(const PointRange& points, const PointMap& map)
{
  using Iterator = decltype(std::begin(points));
  Point_source result;
  result.size = static_cast<std::size_t>(std::distance(std::begin(points), std::end(points)));
  auto first = std::make_shared<std::vector<Iterator>>(); // of every block
  auto item = std::begin(points);
  for(std::size_t b = 0; b < result.number_of_blocks(); ++b) {
    first->push_back(item);
    std::advance(item, static_cast<std::ptrdiff_t>(result.size_of_block(b)));
  }
  const std::size_t size = result.size;
  result.read = [first, map, size](std::size_t b, double* xyz) {
    Iterator next = (*first)[b];
    const std::size_t begin = b * Point_source::block_size;
    const std::size_t end = (std::min)(size, begin + Point_source::block_size);
    for(std::size_t i = begin; i < end; ++i, ++next) {
      const auto& p = get(map, *next);
      *xyz++ = CGAL::to_double(p.x());
      *xyz++ = CGAL::to_double(p.y());
      *xyz++ = CGAL::to_double(p.z());
    }
  };
  return result;
}

/// The type of the list of points of a vertex of `Graph`; `void` if it has none.
template <typename Graph, typename = void>
struct Indices_of
{
  using type = void;
};

template <typename Graph>
struct Indices_of<Graph, std::void_t<decltype(boost::vertex_bundle_type<Graph>::type::indices)>>
{
  using type = decltype(boost::vertex_bundle_type<Graph>::type::indices);
};

/// Whether the edges of `Graph` say which of them are bridges.
template <typename Graph, typename = void>
struct Has_bridges : std::false_type
{};

template <typename Graph>
struct Has_bridges<Graph, std::void_t<decltype(boost::edge_bundle_type<Graph>::type::is_bridge)>>
  : std::true_type
{};

/// Returns the lists of points of all vertices, filled by `fill(lists)`.
/// \throws std::length_error if the points outnumber the values of an index
template <typename Indices, typename Fill>
std::vector<Indices> filled_indices(std::size_t points, std::size_t vertices, const Fill& fill)
{
  using Index = typename Indices::value_type;
  static_assert(std::is_integral<Index>::value, "the indices of a vertex must be integers");
  constexpr auto greatest = static_cast<std::uintmax_t>((std::numeric_limits<Index>::max)());
  if(points > 0 && points - 1 > greatest)
    throw std::length_error(
        "indices of " + std::to_string(points) +
        " points do not fit into those of the skeleton's vertices, of which the "
        "greatest is " +
        std::to_string(greatest) + "; use a wider type");
  std::vector<Indices> result(vertices);
  Index_lists lists;
  lists.bytes_of_index = sizeof(Index);
  lists.reserve = [&](std::size_t v, std::size_t capacity) { result[v].reserve(capacity); };
  lists.resize = [&](std::size_t v, std::size_t size) -> void* {
    result[v].resize(size);
    return result[v].data();
  };
  fill(lists);
  return result;
}

/// Replaces `skeleton` by a public graph; `fill(lists)` fills the lists of `points` points.
template <typename GeomTraits, typename SkeletonGraph, typename Fill>
void set_public_skeleton(const Plain_skeleton& plain, std::size_t points, const Fill& fill,
                         const GeomTraits& traits, SkeletonGraph& skeleton)
{
  using FT = typename GeomTraits::FT;
  SkeletonGraph result(plain.vertices.size());
  for(std::size_t v = 0; v < plain.vertices.size(); ++v) {
    auto& bundle = result[vertex(v, result)];
    bundle.point = to_public(plain.vertices[v].point, traits);
    bundle.radius = static_cast<FT>(plain.vertices[v].radius);
  }
  for(std::size_t k = 0; k < plain.edges.size(); ++k) {
    const auto& [v, w] = plain.edges[k];
    const auto added = add_edge(vertex(v, result), vertex(w, result), result);
    if constexpr(Has_bridges<SkeletonGraph>::value)
      result[added.first].is_bridge = k + plain.number_of_bridges >= plain.edges.size();
    else
      static_cast<void>(added);
  }
  // Assignment copies a BGL graph, so indices are moved in afterwards. They are made before, as
  // this may throw.
  using Indices = typename Indices_of<SkeletonGraph>::type;
  if constexpr(std::is_void<Indices>::value)
    skeleton = result;
  else {
    std::vector<Indices> indices =
      filled_indices<Indices>(points, plain.vertices.size(), fill);
    skeleton = result;
    for(std::size_t v = 0; v < indices.size(); ++v)
      skeleton[vertex(v, skeleton)].indices = std::move(indices[v]);
  }
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PUBLIC_DATA_H
