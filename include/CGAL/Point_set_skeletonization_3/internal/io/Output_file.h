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
/// `filename.part` beside it and renamed by `commit()`. Whatever happens before that, an exception
/// or a full disk, leaves an older file of that name as it was and no other file behind.
class Output_file
{
public:
  /// \throw std::runtime_error if the file cannot be created
  explicit Output_file(const std::string& filename)
    : filename_(filename), part_(filename + ".part"), stream_(part_, std::ios::binary)
  {
    if(!stream_)
      fail("cannot create", "check that the folder exists and may be written to");
    // Not the program's locale, which might write a comma, and all digits of a double.
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

  /// Puts the file in its place. \throw std::runtime_error if not all of it could be written
  void commit()
  {
    stream_.close(); // the last bytes go to the disk here, so only now an error shows
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
