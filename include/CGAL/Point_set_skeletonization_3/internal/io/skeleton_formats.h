// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_SKELETON_FORMATS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_SKELETON_FORMATS_H

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
#include <iterator>
#include <ostream>
#include <string>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A format of skeletons: how its files are named, and how they are written.
struct Skeleton_format
{
  const char* ending;
  void (*write)(std::ostream&, const Written_skeleton&);
};

inline constexpr Skeleton_format skeleton_formats[] = {
    {".polylines.txt", write_polylines},
    {".obj", write_obj},
    {".ply", write_ply},
    {".vtp", write_vtp},
    {".graphml", write_graphml},
    {".swc", write_swc},
    {".dxf", write_dxf},
    {".csv", write_cylinders},
    {".off", write_tubes},
};

/// Whether `text` ends with `ending`, given in small letters, in small or capital letters.
inline bool ends_with(const std::string& text, const std::string& ending)
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

/// Returns all endings as a list in a sentence.
inline std::string skeleton_endings()
{
  std::string result;
  for(const Skeleton_format& format : skeleton_formats) {
    const bool is_last = &format == std::end(skeleton_formats) - 1;
    result += (result.empty() ? "" : is_last ? " or " : ", ") + std::string(format.ending);
  }
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_SKELETON_FORMATS_H
