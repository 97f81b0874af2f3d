// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_OUTPUTS_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_OUTPUTS_H

#include "Skeletonized_cloud.h"
#include "draw_picture.h"
#include "write_page.h"

#include <CGAL/Point_set_skeletonization_3/internal/io/Output_file.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/skeleton_file.h>

#include <ostream>
#include <stdexcept>
#include <string>

/// A page or a picture: how its files are named, and how they are written. Which there are depends
/// on what was found when the program was built.
struct View_format
{
  const char* ending;
  void (*write)(std::ostream&, const Skeletonized_cloud&); ///< Null if it cannot be written.
  const char* needs;                                       ///< What that would take.
};

#ifdef WITH_THREE_JS
constexpr auto page_writer = &write_page;
#else
constexpr decltype(&write_page) page_writer = nullptr;
#endif
#ifdef WITH_CAIRO
constexpr auto png_writer = &write_png;
constexpr auto svg_writer = &write_svg;
#else
constexpr decltype(&write_png) png_writer = nullptr, svg_writer = nullptr;
#endif

inline constexpr View_format view_formats[] = {{".html", page_writer, "three.js"},
                                               {".png", png_writer, "cairo"},
                                               {".svg", svg_writer, "cairo"}};

inline const View_format* view_format_of(const std::string& filename)
{
  for(const View_format& format : view_formats)
    if(CGAL::Point_set_skeletonization_3::internal::ends_with(filename, format.ending))
      return &format;
  return nullptr;
}

/// All endings that `-o` takes, as a list in a sentence.
inline std::string output_endings()
{
  std::string result;
  for(const View_format& format : view_formats)
    if(format.write != nullptr)
      result += std::string(format.ending) + ", ";
  return result + CGAL::Point_set_skeletonization_3::internal::skeleton_endings();
}

/// \throw std::runtime_error if `-o` does not take a file of this name
inline void check_output_format(const std::string& filename)
{
  const View_format* view = view_format_of(filename);
  if(view != nullptr && view->write == nullptr)
    throw std::runtime_error("cannot write '" + filename + "': this program was built without " +
                             view->needs);
  if(view == nullptr &&
     !CGAL::Point_set_skeletonization_3::internal::is_skeleton_filename(filename))
    throw std::runtime_error("cannot write '" + filename + "': name it " + output_endings());
}

/// Writes a file by `write(stream)`; it appears only when it is complete. \throw std::runtime_error
template <typename Write>
void write_file(const std::string& filename, const Write& write)
{
  CGAL::Point_set_skeletonization_3::internal::Output_file file(filename);
  write(file.stream());
  file.commit();
}

/// Writes the skeleton, a page or a picture, as the name says. \pre `check_output_format(filename)`
inline void write_output(const std::string& filename, const Skeletonized_cloud& cloud)
{
  write_file(filename, [&](std::ostream& os) {
    if(const View_format* view = view_format_of(filename))
      view->write(os, cloud);
    else
      CGAL::Point_set_skeletonization_3::internal::write_skeleton(os, filename, cloud.skeleton);
  });
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_OUTPUTS_H
