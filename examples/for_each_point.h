// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_FOR_EACH_POINT_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_FOR_EACH_POINT_H

#include "read_points.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/IO/read_ply_points.h>

#include <cstddef>
#include <istream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace read_points_internal {

/// A container, as far as std::back_inserter knows it, that keeps nothing: CGAL's readers of point
/// sets write every point as soon as they have it, but want to know from the iterator what it is.
template <typename Point, typename Use>
class Point_sink
{
public:
  using value_type = Point;

  explicit Point_sink(const Use& use) : use_(use) {}

  void push_back(const Point& p)
  {
    if(!is_finite(p.x()) || !is_finite(p.y()) || !is_finite(p.z()))
      throw std::invalid_argument("point " + std::to_string(size_) + " is not finite");
    use_(p);
    ++size_;
  }

  std::size_t size() const { return size_; }

private:
  const Use& use_;
  std::size_t size_ = 0;
};

template <typename Sink>
bool read_point_set(std::istream& in, const std::string& format, Sink& sink)
{
  if(format == ".ply")
    return CGAL::IO::read_PLY(in, std::back_inserter(sink));
#ifdef CGAL_LINKED_WITH_LASLIB
  if(format == ".las" || format == ".laz")
    return CGAL::IO::read_LAS(in, std::back_inserter(sink));
#endif
  return CGAL::IO::read_XYZ(in, std::back_inserter(sink));
}

} // namespace read_points_internal

/// Calls `use` with the points of a PLY (text or binary), XYZ or LAS file one after the other, in
/// memory that does not depend on their number; a mesh's vertices are points. Else as
/// `read_points()`: the same errors, also what `use` throws as std::invalid_argument.
///
/// \throw std::runtime_error with a message of one line that names the file and, where there is
///   one, the line or the point.
template <typename Point, typename Use>
void for_each_point(const std::string& filename, const Use& use)
{
  using namespace read_points_internal;
  if(extension_of(filename) == ".off")
    fail(filename, "an .off file cannot be streamed; convert it to .ply");
  Point_sink<Point, Use> sink(use);
  read_file(
      filename,
      [&sink](std::istream& in, const std::string& format) {
        return read_point_set(in, format, sink);
      },
      [&sink] { return sink.size(); });
}

/// The bounding box of the points of a file; see `for_each_point()`.
template <typename Point>
CGAL::Bbox_3 box_of_file(const std::string& filename)
{
  CGAL::Bbox_3 box;
  for_each_point<Point>(filename, [&box](const Point& p) { box += p.bbox(); });
  return box;
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_FOR_EACH_POINT_H
