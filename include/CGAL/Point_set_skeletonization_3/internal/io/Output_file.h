// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_OUTPUT_FILE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_OUTPUT_FILE_H

#include <CGAL/Point_set_skeletonization_3/internal/io/Unfinished_files.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <ostream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The file that writing to `filename` changes: what symbolic links lead to, as for an editor.
inline std::filesystem::path target_of_output(const std::string& filename)
{
  constexpr int longest_chain = 40; // of links, as in Linux
  std::filesystem::path target = filename;
  std::error_code error;
  for(int i = 0; i < longest_chain && std::filesystem::is_symlink(target, error); ++i) {
    const std::filesystem::path next = std::filesystem::read_symlink(target, error);
    if(error)
      break;
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target;
}

/// Files that appear together, or not at all: each `Output_file` that is committed while an object
/// of this class lives gets its name by the `commit()` of that object. There is one at a time.
class Output_transaction
{
public:
  Output_transaction() { current() = this; }
  Output_transaction(const Output_transaction&) = delete;
  Output_transaction& operator=(const Output_transaction&) = delete;

  ~Output_transaction()
  {
    current() = nullptr;
    for(const Finished_file& file : files_)
      unfinished_files().remove(file.part);
  }

  /// Gives all files their names. \throw std::runtime_error if one cannot have it; then all older
  /// files are as they were, and no other file is left
  void commit() { rename(std::exchange(files_, {})); }

private:
  friend class Output_file;

  static Output_transaction*& current()
  {
    static Output_transaction* object = nullptr;
    return object;
  }

  static void rename(const std::vector<Finished_file>& files)
  {
    std::error_code error;
    unfinished_files().rename(files, error);
    if(error)
      throw std::runtime_error("cannot replace '" + files.front().target.string() +
                               (files.size() > 1 ? "' and the other outputs: " : "': ") +
                               error.message());
  }

  std::vector<Finished_file> files_;
};

/// A file that appears under its name only when it is complete and on the disk: it is written under
/// a temporary name beside it, and renamed by `commit()`. If an exception or a full disk prevents
/// that, an older file of that name is unchanged and no other file is left. It keeps the
/// permissions of the older file.
class Output_file
{
public:
  /// \throw std::runtime_error if the file cannot be created, or an older one must not be changed
  explicit Output_file(const std::string& filename)
      : filename_(filename)
      , target_(target_of_output(filename))
  {
    std::error_code ignored;
    if(std::filesystem::exists(target_, ignored)) {
      if(!std::filesystem::is_regular_file(target_, ignored))
        fail("cannot replace", "it is no ordinary file");
      if(!std::ofstream(target_, std::ios::binary | std::ios::app))
        fail("cannot replace", "it is write-protected");
    }
    part_ = unfinished_files().create(target_);
    if(!part_.empty())
      stream_.open(part_, std::ios::binary);
    if(part_.empty() || !stream_) {
      unfinished_files().remove(part_);
      fail("cannot create", "check that the folder exists and may be written to");
    }
    // Not the locale of the program, which might write commas; all digits of a double.
    stream_.imbue(std::locale::classic());
    stream_.precision(std::numeric_limits<double>::max_digits10);
  }

  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  ~Output_file()
  {
    stream_.close();
    if(!is_finished_ && !part_.empty())
      unfinished_files().remove(part_);
  }

  std::ostream& stream() { return stream_; }

  /// Renames the file to its final name, or leaves that to the `Output_transaction` if there is
  /// one. \throw std::runtime_error if not all of it could be written
  void commit()
  {
    stream_.close(); // flushes: errors may appear only here
    if(!stream_ || !is_on_disk(part_))
      fail("cannot write", "check the free space on the disk");
    std::error_code error; // a file that is new keeps the permissions of new files
    const std::filesystem::file_status older = std::filesystem::status(target_, error);
    if(std::filesystem::is_regular_file(older))
      std::filesystem::permissions(part_, older.permissions(), error);
    is_finished_ = true;
    if(Output_transaction* const transaction = Output_transaction::current())
      transaction->files_.push_back({part_, target_});
    else
      Output_transaction::rename({{part_, target_}});
  }

private:
  [[noreturn]] void fail(const std::string& what, const std::string& hint) const
  {
    throw std::runtime_error(what + " '" + filename_ + "': " + hint);
  }

  std::string filename_;
  std::filesystem::path target_, part_;
  std::ofstream stream_;
  bool is_finished_ = false;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_OUTPUT_FILE_H
