// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_POINT_SEARCH_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_POINT_SEARCH_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Neighbor.h>

#include <CGAL/Euclidean_distance.h>
#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Splitters.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// CGAL's kd-tree over indices of points. O(n log n) to build. Queries may run concurrently.
/// Results are ordered by index, or by distance and index, and so do not depend on the layout of
/// the tree.
class Point_search
{
  using Kernel = Simple_cartesian<double>;
  using Point = Kernel::Point_3;

  struct Index_point_map
  {
    using key_type = std::size_t;
    using value_type = Point;
    using reference = const Point&;
    using category = boost::lvalue_property_map_tag;

    const std::vector<Point>* points;
    const Point& operator[](std::size_t i) const { return (*points)[i]; }
    friend const Point& get(const Index_point_map& map, std::size_t i) { return map[i]; }
  };

  using Traits = Search_traits_adapter<std::size_t, Index_point_map, Search_traits_3<Kernel>>;
  using Distance = Distance_adapter<std::size_t, Index_point_map,
                                    Euclidean_distance<Search_traits_3<Kernel>>>;

  /// So that building can be cancelled: it splits a node at a time.
  struct Splitter : Sliding_midpoint<Traits>
  {
    template <typename... Arguments>
    void operator()(Arguments&&... arguments) const
    {
      Progress::poll();
      Sliding_midpoint<Traits>::operator()(std::forward<Arguments>(arguments)...);
    }
  };
  using Tree = Kd_tree<Traits, Splitter, Tag_true>;
  using K_search = Orthogonal_k_neighbor_search<Traits, Distance, Splitter, Tree>;

  static Point to_point(const Vector3& v) { return Point(v.x(), v.y(), v.z()); }

public:
  explicit Point_search(const std::vector<Vector3>& points)
    : tree_(boost::counting_iterator<std::size_t>(0), boost::counting_iterator<std::size_t>(0),
            Splitter(), Traits(Index_point_map{&points_}))
  {
    points_.reserve(points.size());
    for(const Vector3& p : points)
      points_.push_back(to_point(p));
    tree_.insert(boost::counting_iterator<std::size_t>(0),
                 boost::counting_iterator<std::size_t>(points.size()));
    if(!points.empty())
      tree_.build();
  }

  Point_search(const Point_search&) = delete;
  Point_search& operator=(const Point_search&) = delete;

  /// Writes the indices of all points closer than `radius` to `center` to `result`, ascending;
  /// those at exactly that distance may be included or not.
  void within(const Vector3& center, double radius, std::vector<std::size_t>& result) const
  {
    result.clear();
    if(points_.empty())
      return;
    const Fuzzy_sphere<Traits> ball(to_point(center), radius, 0, tree_.traits());
    tree_.search(std::back_inserter(result), ball);
    std::sort(result.begin(), result.end());
  }

  /// Writes the `k` points nearest to `center` to `result`, nearest first; all if there are fewer.
  void nearest(const Vector3& center, std::size_t k, std::vector<Neighbor>& result) const
  {
    result.clear();
    if(points_.empty() || k == 0)
      return;
    K_search search(tree_, to_point(center), static_cast<unsigned int>(k), 0, true,
                    Distance(Index_point_map{&points_}));
    result.reserve(std::min(k, points_.size()));
    for(const auto& found : search)
      result.push_back({found.second, found.first});
    std::sort(result.begin(), result.end());
  }

  /// The point nearest to `center`. \pre there is at least one point
  Neighbor nearest(const Vector3& center) const
  {
    std::vector<Neighbor> result;
    nearest(center, 1, result);
    return result.front();
  }

private:
  std::vector<Point> points_;
  Tree tree_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_POINT_SEARCH_H
