// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_CURVE_SKELETON_3_H
#define CGAL_IO_CURVE_SKELETON_3_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Point_set_skeletonization_3/internal/branches/Numbered_skeleton.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/skeleton_file.h>

#include <boost/graph/graph_traits.hpp>

#include <string>
#include <vector>

namespace CGAL {
namespace IO {

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// whether `filename` ends like a file that `write_curve_skeleton()` can write.
inline bool is_curve_skeleton_filename(const std::string& filename)
{
  return Point_set_skeletonization_3::internal::is_skeleton_filename(filename);
}

/*!
 * \ingroup PkgPointSetSkeletonization3Ref
 *
 * writes a curve skeleton to a file whose ending, in small or capital letters, chooses the format:
 *
 * - `.polylines.txt`: CGAL's polylines, a branch a line as `n x1 y1 z1 ... xn yn zn`. A closed one
 *   repeats its first point at the end; an isolated vertex is a polyline of one point.
 * - `.obj`: Wavefront `v` and `l` lines.
 * - `.ply`: vertices with `x y z radius`, edges with `vertex1 vertex2`; text.
 * - `.vtp`: VTK and ParaView. A polyline per branch, with `branch`, `axis`, `order`, `length` and
 *   `mean_radius`; points with `radius`.
 * - `.graphml`: networkx, igraph. Nodes with `x y z radius`, edges with `branch`, `axis`, `order`
 *   and `length`.
 * - `.swc`: neuron reconstructions. Cycles are opened; comments name the edges left out.
 * - `.dxf`: AutoCAD release 12. A 3D polyline per branch, in the layer of its order.
 * - `.csv`: a quantitative structure model (QSM): a cylinder per edge, with the columns of
 *   SimpleForest. Its segments are our branches, its branches are our axes.
 * - `.off`, `.tubes.ply`: tubes as thick as the radii, a closed triangle mesh per branch. Tubes
 *   overlap at junctions.
 *
 * Coordinates are written with all digits of a `double`. The file appears only when it is complete.
 * O(n log n) for n vertices and edges.
 *
 * \tparam Skeleton a `Curve_skeleton_3`, or another BGL graph with `.point` and `.radius` in its
 *   vertex bundle
 *
 * \param filename the file
 * \param skeleton the skeleton
 * \param roots where branches start and orders are counted from, see `skeleton_branches()`
 *
 * \throw std::runtime_error with a message of one line if the ending is another one, or if the file
 *   cannot be written; then the folder is left as it was.
 * \throw std::out_of_range if a root is no vertex of the skeleton
 */
template <typename Skeleton>
void write_curve_skeleton(
    const std::string& filename, const Skeleton& skeleton,
    const std::vector<typename boost::graph_traits<Skeleton>::vertex_descriptor>& roots = {})
{
  namespace internal = Point_set_skeletonization_3::internal;
  const internal::Numbered_skeleton<Skeleton> numbered(skeleton);
  internal::write_skeleton_file(filename, numbered.plain, numbered.numbers_of(roots));
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_CURVE_SKELETON_3_H
