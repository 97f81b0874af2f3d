// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_GAUSSIAN_MIXTURE_BUILDER_3_H
#define CGAL_IO_GAUSSIAN_MIXTURE_BUILDER_3_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Gaussian_mixture_builder_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/Byte_archive.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/Output_file.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <istream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace CGAL {
namespace IO {

/// How a file of moments begins; the number is its version.
inline constexpr char moments_title[] = "Point_set_skeletonization_3 moments 1\n";

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// Writes a builder to a binary stream: the moments of its cells, 160 bytes each, and a checksum.
/// The bytes are the same on all machines, and for any order in which the points came. O(cells log
/// cells).
template <typename Traits>
void write_moments(std::ostream& os, const Gaussian_mixture_builder_3<Traits>& builder)
{
  os.write(moments_title, sizeof(moments_title) - 1);
  Point_set_skeletonization_3::internal::Byte_writer writer(os);
  const unsigned int version = 1;
  builder.save(writer, version);
  writer.write_checksum();
}

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// Replaces a builder by that of a binary stream.
/// \throws std::runtime_error that says what is wrong: no moments, a newer version, damaged,
///         truncated. Then the builder is as it was.
template <typename Traits>
void read_moments(std::istream& is, Gaussian_mixture_builder_3<Traits>& builder)
{
  const std::string expected = moments_title;
  std::string title(expected.size(), '\0');
  is.read(&title[0], static_cast<std::streamsize>(title.size()));
  const std::size_t name = expected.size() - 2; // all but the version
  if(title.compare(0, name, expected, 0, name) != 0)
    throw std::runtime_error("it is no file of moments");
  if(title != expected)
    throw std::runtime_error("it is of another version of this package");
  Point_set_skeletonization_3::internal::Byte_reader reader(is);
  const unsigned int version = 1;
  Gaussian_mixture_builder_3<Traits> read;
  try {
    read.load(reader, version);
  } catch(const std::invalid_argument&) { // a box that is none
    throw std::runtime_error("it is damaged");
  }
  reader.check_checksum();
  builder = std::move(read);
}

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// The same for a file, which appears under its name only when it is complete.
/// \throws std::runtime_error that names the file
template <typename Traits>
void write_moments(const std::string& filename, const Gaussian_mixture_builder_3<Traits>& builder)
{
  Point_set_skeletonization_3::internal::Output_file file(filename);
  write_moments(file.stream(), builder);
  file.commit();
}

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// The same for a file.
/// \throws std::runtime_error that names the file
template <typename Traits>
void read_moments(const std::string& filename, Gaussian_mixture_builder_3<Traits>& builder)
{
  const auto fail = [&filename](const std::string& why) {
    throw std::runtime_error("cannot read '" + filename + "': " + why);
  };
  std::error_code ignored;
  if(!std::filesystem::exists(filename, ignored))
    fail("there is no such file");
  if(std::filesystem::is_directory(filename, ignored))
    fail("it is a folder");
  std::ifstream file(filename, std::ios::binary);
  if(!file)
    fail("it may not be read");
  try {
    read_moments(file, builder);
  } catch(const std::runtime_error& error) {
    fail(error.what());
  }
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_GAUSSIAN_MIXTURE_BUILDER_3_H
