// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_READ_POINTS_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_READ_POINTS_H

#include "Text_buffer.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/read_xyz_points.h>
#include <CGAL/number_utils.h>
#ifdef CGAL_LINKED_WITH_LASLIB
#include <CGAL/IO/read_las_points.h>
#endif

#include <cctype>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <istream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// What a file holds: points, and the faces between them if it is a mesh.
template <typename Point>
struct Points_and_faces
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
};

namespace read_points_internal {

/// Keeps quiet what CGAL's readers print on `std::cerr`: an error is reported once, by exception.
class Silent_cerr
{
public:
  Silent_cerr() : saved_(std::cerr.rdbuf(sink_.rdbuf())) {}
  Silent_cerr(const Silent_cerr&) = delete;
  Silent_cerr& operator=(const Silent_cerr&) = delete;
  ~Silent_cerr() { std::cerr.rdbuf(saved_); }

private:
  std::ostringstream sink_;
  std::streambuf* saved_;
};

[[noreturn]] inline void fail(const std::string& filename, const std::string& why)
{
  throw std::runtime_error("cannot read '" + filename + "': " + why);
}

/// With its dot, in lower case.
inline std::string extension_of(const std::string& filename)
{
  std::string extension = std::filesystem::path(filename).extension().string();
  for(char& c : extension)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

/// The format by content, as a file extension; empty if it has no signature, as .xyz has none.
inline std::string format_of_content(std::istream& in)
{
  std::string first;
  in >> first;
  in.clear();
  in.seekg(0);
  if(first == "ply")
    return ".ply";
  if(first.compare(0, 4, "LASF") == 0)
    return ".las";
  const bool is_off = first.size() >= 3 && first.compare(first.size() - 3, 3, "OFF") == 0;
  return is_off ? ".off" : "";
}

/// Whether an OFF or PLY file says in its second word or line that it is binary.
inline bool is_binary(std::istream& in)
{
  std::string word;
  bool binary = false;
  for(int i = 0; i < 3 && in >> word; ++i)
    binary = binary || word == "BINARY" || word.compare(0, 7, "binary_") == 0;
  in.clear();
  in.seekg(0);
  return binary;
}

/// CGAL's PLY readers take it for granted that a vertex has `x`, `y`, `z` of a floating type.
inline bool has_ply_coordinates(std::istream& in)
{
  std::string line;
  bool is_vertex = false;
  int found = 0;
  while(std::getline(in, line)) {
    std::istringstream words(line);
    std::string keyword, type, name;
    words >> keyword >> type >> name;
    if(keyword == "end_header")
      break;
    if(keyword == "element")
      is_vertex = type == "vertex" || type == "vertices";
    const bool is_floating =
        type == "float" || type == "float32" || type == "double" || type == "float64";
    if(keyword == "property" && is_vertex && is_floating)
      found += name == "x" || name == "y" || name == "z" ? 1 : 0;
  }
  in.clear();
  in.seekg(0);
  return found == 3;
}

template <typename Point>
bool read(std::istream& in, const std::string& format, Points_and_faces<Point>& result)
{
  if(format == ".off")
    return CGAL::IO::read_OFF(in, result.points, result.faces);
  if(format == ".ply")
    return CGAL::IO::read_PLY(in, result.points, result.faces);
#ifdef CGAL_LINKED_WITH_LASLIB
  if(format == ".las" || format == ".laz")
    return CGAL::IO::read_LAS(in, std::back_inserter(result.points));
#endif
  return CGAL::IO::read_XYZ(in, std::back_inserter(result.points));
}

/// The extension, in lower case, once it is known that the file is there and can be what it says.
inline std::string check_format(const std::string& filename, std::istream& in)
{
  if(std::filesystem::is_directory(filename))
    fail(filename, "it is a folder");
  if(!in)
    fail(filename, std::filesystem::exists(filename) ? "no permission" : "there is no such file");
  std::string extension = extension_of(filename);
  const bool is_las = extension == ".las" || extension == ".laz";
  if(extension != ".off" && extension != ".ply" && extension != ".xyz" && !is_las)
    fail(filename, "its extension is not .off, .ply, .xyz or .las");
#ifndef CGAL_LINKED_WITH_LASLIB
  if(is_las)
    fail(filename, "this program was built without LASlib");
#endif
  const std::string content = format_of_content(in);
  if(!content.empty() && content != extension && !(content == ".las" && is_las))
    fail(filename, "by its content it is a " + content + " file, rename it");
  if(extension == ".ply" && content == ".ply" && !has_ply_coordinates(in))
    fail(filename, "its vertices have no x, y, z of type float or double");
  return extension;
}

template <typename FT>
bool is_finite(const FT& x)
{
  return std::isfinite(CGAL::to_double(x));
}

template <typename Point>
void check_points(const std::string& filename, const Points_and_faces<Point>& result)
{
  for(std::size_t i = 0; i < result.points.size(); ++i) {
    const Point& p = result.points[i];
    if(!is_finite(p.x()) || !is_finite(p.y()) || !is_finite(p.z()))
      fail(filename, "point " + std::to_string(i) + " is not finite");
  }
  for(std::size_t i = 0; i < result.faces.size(); ++i)
    for(const std::size_t v : result.faces[i])
      if(v >= result.points.size())
        fail(filename, "face " + std::to_string(i) + " names vertex " + std::to_string(v) + " of " +
                           std::to_string(result.points.size()));
}

/// Opens a file and hands it to `read` with its format. \throw std::runtime_error that says in one
/// line what is wrong and where
/// \param read returns whether it succeeded, or throws std::invalid_argument to say what is wrong
/// \param size returns the number of points read so far
template <typename Read, typename Size>
void read_file(const std::string& filename, const Read& read, const Size& size)
{
  std::ifstream file(filename, std::ios::binary);
  const std::string format = check_format(filename, file);
  const bool text =
      format == ".xyz" || ((format == ".off" || format == ".ply") && !is_binary(file));

  Text_buffer buffer(file);
  std::istream lines(&buffer);
  const auto line = [&buffer] { return "line " + std::to_string(buffer.line_number()); };
  bool success = false;
  try {
    const Silent_cerr silence;
    success = read(text ? lines : static_cast<std::istream&>(file), format);
  } catch(const std::invalid_argument& error) {
    fail(filename, (text ? line() + ": " : "") + error.what());
  } catch(const std::exception&) {
    // A broken file makes some readers ask for more memory than there is.
  }
  if(!success && text)
    fail(filename, line() + (format == ".xyz" ? " is neither 'x y z' nor 'x y z nx ny nz'"
                             : file.eof()     ? " is the last, but more is expected"
                                              : " is not understood"));
  if(!success)
    fail(filename, "it breaks off or is damaged after " + std::to_string(size()) + " points");
  if(size() == 0)
    fail(filename, "there are no points in it");
}

} // namespace read_points_internal

/// Reads points, or a mesh, from an OFF, PLY (text or binary), XYZ or LAS file with CGAL's readers;
/// LAS needs LASlib. Points are counted from 0, lines from 1.
///
/// \throw std::runtime_error with a message of one line that names the file and, where there is
///   one, the line or the point.
template <typename Point>
Points_and_faces<Point> read_points_and_faces(const std::string& filename)
{
  using namespace read_points_internal;
  Points_and_faces<Point> result;
  read_file(
      filename,
      [&result](std::istream& in, const std::string& format) { return read(in, format, result); },
      [&result] { return result.points.size(); });
  check_points(filename, result);
  return result;
}

/// Only the points; a mesh's vertices are points.
template <typename Point>
std::vector<Point> read_points(const std::string& filename)
{
  return read_points_and_faces<Point>(filename).points;
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_READ_POINTS_H
