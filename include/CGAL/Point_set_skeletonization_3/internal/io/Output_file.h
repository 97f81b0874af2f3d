// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_OUTPUT_FILE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_OUTPUT_FILE_H

#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <ostream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A text file that appears under its name only when it is complete: it is written to
/// `filename.part` and renamed by `commit()`. If an exception or a full disk prevents that, an
/// older file of that name is unchanged and no other file is left.
class Output_file
{
public:
  /// \throw std::runtime_error if the file cannot be created
  explicit Output_file(const std::string& filename)
    : filename_(filename), part_(filename + ".part"), stream_(part_, std::ios::binary)
  {
    if(!stream_)
      fail("cannot create", "check that the folder exists and may be written to");
    // Not the locale of the program, which might write commas; all digits of a double.
    stream_.imbue(std::locale::classic());
    stream_.precision(std::numeric_limits<double>::max_digits10);
  }

  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  ~Output_file()
  {
    if(committed_)
      return;
    stream_.close();
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
  }

  std::ostream& stream() { return stream_; }

  /// Renames the file to its final name.
  /// \throw std::runtime_error if not all of it could be written
  void commit()
  {
    stream_.close(); // flushes: errors may appear only here
    if(!stream_)
      fail("cannot write", "check the free space on the disk");
    std::error_code error;
    std::filesystem::rename(part_, filename_, error);
    if(error)
      fail("cannot replace", error.message());
    committed_ = true;
  }

private:
  [[noreturn]] void fail(const std::string& what, const std::string& hint) const
  {
    throw std::runtime_error(what + " '" + filename_ + "': " + hint);
  }

  std::string filename_;
  std::string part_;
  std::ofstream stream_;
  bool committed_ = false;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_OUTPUT_FILE_H
