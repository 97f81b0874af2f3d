// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_CURVE_SKELETON_3_H
#define CGAL_IO_CURVE_SKELETON_3_H

#include <CGAL/Point_set_skeletonization_3/internal/io/Output_file.h>

#include <CGAL/boost/graph/split_graph_into_polylines.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <ostream>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

template <typename Point>
void write_point(std::ostream& os, const Point& p)
{
  os << CGAL::to_double(p.x()) << ' ' << CGAL::to_double(p.y()) << ' ' << CGAL::to_double(p.z());
}

/// Calls `write(i, j)` for every edge with the positions of its ends in `vertices(skeleton)`.
template <typename Skeleton, typename Write>
void for_each_edge(const Skeleton& skeleton, const Write& write)
{
  using vertex_descriptor = typename boost::graph_traits<Skeleton>::vertex_descriptor;
  std::unordered_map<vertex_descriptor, std::size_t> position;
  for(vertex_descriptor v : boost::make_iterator_range(vertices(skeleton)))
    position.emplace(v, position.size());
  for(const auto e : boost::make_iterator_range(edges(skeleton)))
    write(position.at(source(e, skeleton)), position.at(target(e, skeleton)));
}

/// Collects the polylines of `split_graph_into_polylines()`.
template <typename Skeleton>
struct Polyline_collector
{
  using vertex_descriptor = typename boost::graph_traits<Skeleton>::vertex_descriptor;
  std::vector<std::vector<vertex_descriptor>> polylines;

  void start_new_polyline() { polylines.emplace_back(); }
  void add_node(vertex_descriptor v) { polylines.back().push_back(v); }
  void end_polyline() {}
};

template <typename Skeleton>
void write_polylines(std::ostream& os, const Skeleton& skeleton)
{
  Polyline_collector<Skeleton> collector;
  split_graph_into_polylines(skeleton, collector);
  for(const auto& polyline : collector.polylines) {
    os << polyline.size();
    for(const auto v : polyline)
      write_point(os << ' ', skeleton[v].point);
    os << '\n';
  }
}

template <typename Skeleton>
void write_obj(std::ostream& os, const Skeleton& skeleton)
{
  for(const auto v : boost::make_iterator_range(vertices(skeleton))) {
    write_point(os << "v ", skeleton[v].point);
    os << '\n';
  }
  for_each_edge(skeleton, [&os](std::size_t i, std::size_t j) {
    os << "l " << i + 1 << ' ' << j + 1 << '\n'; // OBJ counts from one
  });
}

template <typename Skeleton>
void write_ply(std::ostream& os, const Skeleton& skeleton)
{
  os << "ply\nformat ascii 1.0\n"
     << "element vertex " << num_vertices(skeleton) << '\n'
     << "property double x\nproperty double y\nproperty double z\nproperty double radius\n"
     << "element edge " << num_edges(skeleton) << '\n'
     << "property int vertex1\nproperty int vertex2\nend_header\n";
  for(const auto v : boost::make_iterator_range(vertices(skeleton))) {
    write_point(os, skeleton[v].point);
    os << ' ' << CGAL::to_double(skeleton[v].radius) << '\n';
  }
  for_each_edge(skeleton, [&os](std::size_t i, std::size_t j) { os << i << ' ' << j << '\n'; });
}

inline bool ends_with(const std::string& text, const std::string& ending)
{
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/// Writes in the format that the ending of `filename` chooses.
/// \pre `is_curve_skeleton_filename(filename)`
template <typename Skeleton>
void write_skeleton(std::ostream& os, const std::string& filename, const Skeleton& skeleton)
{
  if(ends_with(filename, ".polylines.txt"))
    write_polylines(os, skeleton);
  else if(ends_with(filename, ".obj"))
    write_obj(os, skeleton);
  else
    write_ply(os, skeleton);
}

} // namespace internal
} // namespace Point_set_skeletonization_3

namespace IO {

/// whether `filename` ends like a file that `write_curve_skeleton()` can write.
inline bool is_curve_skeleton_filename(const std::string& filename)
{
  using Point_set_skeletonization_3::internal::ends_with;
  return ends_with(filename, ".polylines.txt") || ends_with(filename, ".obj") ||
         ends_with(filename, ".ply");
}

/*!
 * writes a curve skeleton to a file whose ending chooses the format:
 *
 * - `.polylines.txt`: CGAL's polylines, cut at junctions, one a line as `n x1 y1 z1 ... xn yn zn`.
 *   A closed one repeats its first point at the end; an isolated vertex is a polyline of one point.
 * - `.obj`: `v` and `l` lines.
 * - `.ply`: vertices with `x y z radius`, edges with `vertex1 vertex2`; text.
 *
 * Coordinates are written with all digits of a `double`. The file appears only when it is complete.
 *
 * \tparam Skeleton a `Curve_skeleton_3`, or another BGL graph with `.point` and `.radius` in its
 *   vertex bundle; it has no loops and no parallel edges (`.polylines.txt` would lose them)
 *
 * \throw std::runtime_error with a message of one line if the ending is another one, or if the file
 *   cannot be written; then the folder is left as it was.
 */
template <typename Skeleton>
void write_curve_skeleton(const std::string& filename, const Skeleton& skeleton)
{
  namespace internal = Point_set_skeletonization_3::internal;
  if(!is_curve_skeleton_filename(filename))
    throw std::runtime_error("cannot write '" + filename +
                             "': name it .polylines.txt, .obj or .ply");
  internal::Output_file file(filename);
  internal::write_skeleton(file.stream(), filename, skeleton);
  file.commit();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_CURVE_SKELETON_3_H
