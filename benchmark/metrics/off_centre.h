// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_OFF_CENTRE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_OFF_CENTRE_H

#include "skeleton_samples.h"

#include <CGAL/Kernel_traits.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polygon_mesh_slicer.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace metrics {
namespace internal {

/// Simple closed polygon in a plane; the last point is not the first.
template <typename Traits>
using Ring = std::vector<typename Traits::Point_2>;

/// Coordinates in the plane through `origin` across `direction`, in the unit of space.
template <typename Traits>
class Cutting_plane
{
  using Point_3 = typename Traits::Point_3;
  using Vector_3 = typename Traits::Vector_3;

public:
  /// \param direction of unit length
  Cutting_plane(const Point_3& origin, const Vector_3& direction)
      : origin_(origin)
      , direction_(direction)
  {
    u_ = CGAL::cross_product(direction,
                             std::abs(direction.x()) < 0.5 ? Vector_3(1, 0, 0) : Vector_3(0, 1, 0));
    u_ = u_ / std::sqrt(u_.squared_length());
    v_ = CGAL::cross_product(direction, u_);
  }

  typename Traits::Plane_3 plane() const { return {origin_, direction_}; }

  Ring<Traits> to_ring(const std::vector<Point_3>& polyline) const
  {
    Ring<Traits> ring;
    for(std::size_t i = 0; i + 1 < polyline.size(); ++i)
      ring.emplace_back(u_ * (polyline[i] - origin_), v_ * (polyline[i] - origin_));
    return ring;
  }

private:
  Point_3 origin_;
  Vector_3 direction_, u_, v_;
};

template <typename Traits>
bool contains(const Ring<Traits>& ring, const typename Traits::Point_2& p)
{
  return CGAL::bounded_side_2(ring.begin(), ring.end(), p, Traits()) != CGAL::ON_UNBOUNDED_SIDE;
}

/// Area of a planar region and its first moments.
struct Area_moments
{
  double area = 0, x = 0, y = 0;

  void add(double sign, const Area_moments& other)
  {
    area += sign * other.area;
    x += sign * other.x;
    y += sign * other.y;
  }
};

/// \return with an area >= 0, whichever way round the ring is
template <typename Traits>
Area_moments moments(const Ring<Traits>& ring)
{
  Area_moments sum;
  for(std::size_t i = 0; i < ring.size(); ++i) {
    const auto& p = ring[i];
    const auto& q = ring[(i + 1) % ring.size()];
    const double triangle = (p.x() * q.y() - q.x() * p.y()) / 2; // with the origin
    sum.add(1, {triangle, triangle * (p.x() + q.x()) / 3, triangle * (p.y() + q.y()) / 3});
  }
  Area_moments result;
  result.add(sum.area < 0 ? -1 : 1, sum);
  return result;
}

/// Number of the rings that go around `p`, except for `self`.
template <typename Traits>
std::size_t depth(const std::vector<Ring<Traits>>& rings, const typename Traits::Point_2& p,
                  const Ring<Traits>* self = nullptr)
{
  return static_cast<std::size_t>(
      std::count_if(rings.begin(), rings.end(), [&p, self](const Ring<Traits>& ring) {
        return &ring != self && contains<Traits>(ring, p);
      }));
}

/// Moments of the connected region around the origin that the rings bound; area 0 if the origin is
/// in none. A place is in a region if an odd number of rings goes around it.
template <typename Traits>
Area_moments region_around_origin(const std::vector<Ring<Traits>>& rings)
{
  const typename Traits::Point_2 origin(0, 0);
  const std::size_t rings_around = depth<Traits>(rings, origin);
  if(rings_around % 2 == 0)
    return {};
  // The innermost, also where rings cross because the mesh does.
  const auto extent = [&origin](const Ring<Traits>& ring) {
    return contains<Traits>(ring, origin) ? moments<Traits>(ring).area
                                          : std::numeric_limits<double>::infinity();
  };
  const Ring<Traits>& boundary =
      *std::min_element(rings.begin(), rings.end(),
                        [&extent](const auto& a, const auto& b) { return extent(a) < extent(b); });
  Area_moments region = moments<Traits>(boundary);
  for(const Ring<Traits>& ring : rings)
    if(&ring != &boundary && contains<Traits>(boundary, ring.front()) &&
       depth<Traits>(rings, ring.front(), &ring) == rings_around)
      region.add(-1, moments<Traits>(ring)); // a hole
  return region;
}

} // namespace internal

/// How far a skeleton is off the centre of its limbs: at every sample, the mesh is cut by the plane
/// across the skeleton. Of the cut, the connected region around the sample counts: its outer
/// boundary is the innermost polygon that contains the sample, less the holes in it. The ratio is
/// the distance of the sample to the centroid of that region over the radius of a disc of the same
/// area; infinite if the sample is outside the mesh. Where the skeleton ends or branches the cut is
/// not that of a limb: take the median.
///
/// \param skeleton a BGL graph whose vertices bundle a `.point`
/// \param mesh a closed triangle mesh with points of a kernel with exact predicates
/// \param step distance of the samples; > 0, in the unit of the points. The direction of the
///   skeleton is taken over this length.
template <typename Skeleton, typename Mesh>
std::vector<double> off_centre_ratios(const Skeleton& skeleton, const Mesh& mesh, double step)
{
  using Point_3 = typename boost::property_traits<
      typename boost::property_map<Mesh, CGAL::vertex_point_t>::const_type>::value_type;
  using Traits = typename CGAL::Kernel_traits<Point_3>::Kernel;
  const CGAL::Polygon_mesh_slicer<Mesh, Traits> slicer(mesh);
  std::vector<double> ratios;
  for(const Skeleton_sample& sample : sample_skeleton(skeleton, step)) {
    if(sample.direction == CGAL::NULL_VECTOR)
      continue;
    const internal::Cutting_plane<Traits> cut(
        {sample.point.x(), sample.point.y(), sample.point.z()},
        {sample.direction.x(), sample.direction.y(), sample.direction.z()});
    std::vector<std::vector<Point_3>> polylines;
    slicer(cut.plane(), std::back_inserter(polylines));
    std::vector<internal::Ring<Traits>> rings;
    for(const std::vector<Point_3>& polyline : polylines)
      if(polyline.size() > 3 && polyline.front() == polyline.back())
        rings.push_back(cut.to_ring(polyline));
    const internal::Area_moments region = internal::region_around_origin<Traits>(rings);
    ratios.push_back(region.area > 0 ? std::hypot(region.x, region.y) / region.area /
                                           std::sqrt(region.area / CGAL_PI)
                                     : std::numeric_limits<double>::infinity());
  }
  return ratios;
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_OFF_CENTRE_H
