// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_SKELETON_FILE_IMPL_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_SKELETON_FILE_IMPL_H

#include <CGAL/Point_set_skeletonization_3/internal/branches/ordered_branches.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/linkage.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/Output_file.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/skeleton_file.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/Written_skeleton.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/write_cylinders.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/write_dxf.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/write_graphml.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/write_obj.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/write_ply.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/write_polylines.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/write_swc.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/write_tubes.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/write_vtp.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A format of skeletons: how its files are named, and how they are written. The first ending that
/// fits counts.
struct Skeleton_format
{
  const char* ending;
  void (*write)(std::ostream&, const Written_skeleton&);
};

inline constexpr Skeleton_format skeleton_formats[] = {
    {".polylines.txt", write_polylines},
    {".obj", write_obj},
    {".tubes.ply", write_tubes_ply},
    {".ply", write_ply},
    {".vtp", write_vtp},
    {".graphml", write_graphml},
    {".swc", write_swc},
    {".dxf", write_dxf},
    {".csv", write_cylinders},
    {".off", write_tubes_off},
};

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
bool ends_with(const std::string& text, const std::string& ending)
{
  return text.size() >= ending.size() &&
         std::equal(ending.rbegin(), ending.rend(), text.rbegin(), [](char small, char any) {
           return small == std::tolower(static_cast<unsigned char>(any));
         });
}

/// Returns the format that the ending of a filename chooses; null if none does.
inline const Skeleton_format* format_of(const std::string& filename)
{
  for(const Skeleton_format& format : skeleton_formats)
    if(ends_with(filename, format.ending))
      return &format;
  return nullptr;
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
bool is_skeleton_filename(const std::string& filename)
{
  return format_of(filename) != nullptr;
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
std::string skeleton_endings()
{
  std::string result;
  for(const Skeleton_format& format : skeleton_formats) {
    const bool is_last = &format == std::end(skeleton_formats) - 1;
    result += (result.empty() ? "" : is_last ? " or " : ", ") + std::string(format.ending);
  }
  return result;
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
void write_skeleton(std::ostream& os, const std::string& filename, const Written_skeleton& skeleton)
{
  format_of(filename)->write(os, skeleton);
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
void write_skeleton_file(const std::string& filename, const Plain_skeleton& skeleton,
                         const std::vector<std::size_t>& roots)
{
  if(!is_skeleton_filename(filename))
    throw std::runtime_error("cannot write '" + filename + "': name it " + skeleton_endings());
  Output_file file(filename);
  write_skeleton(file.stream(), filename, {skeleton, ordered_branches(skeleton, roots)});
  file.commit();
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_SKELETON_FILE_IMPL_H
