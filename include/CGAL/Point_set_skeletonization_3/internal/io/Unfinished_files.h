// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_UNFINISHED_FILES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_UNFINISHED_FILES_H

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <random>
#include <string>
#include <system_error>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#include <fcntl.h>
#include <unistd.h>
#endif

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A complete file under a temporary name, and the name that it is to get.
struct Finished_file
{
  std::filesystem::path part, target;
};

/// The files of this process that are being written, under temporary names beside those that they
/// are to get. Known in one place, so that a program that is told to end can remove them, from any
/// thread and whatever the others do.
class Unfinished_files
{
public:
  /// Creates an empty file beside `target`, under a name that no file has, of this or of another
  /// program. \returns an empty path if that is not possible
  std::filesystem::path create(const std::filesystem::path& target)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::filesystem::path part = unused_name(target, [](const std::filesystem::path& name) {
      std::FILE* const file = std::fopen(name.string().c_str(), "wbx"); // x: fails if it exists
      return file && std::fclose(file) == 0;
    });
    if(!part.empty())
      parts_.push_back(part);
    return part;
  }

  void remove(const std::filesystem::path& part) noexcept
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    forget(part);
  }

  /// Gives all files their names, in place of older files, or none of them.
  void rename(const std::vector<Finished_file>& files, std::error_code& error)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<Finished_file> replaced; // older files under temporary names
    std::size_t renamed = 0;
    for(; renamed < files.size() && !error; ++renamed) {
      const auto& [part, target] = files[renamed];
      const bool is_last = renamed + 1 == files.size(); // behind it nothing can fail
      if(!is_last && std::filesystem::exists(target))
        replaced.push_back({kept_copy(target, error), target});
      if(!error)
        std::filesystem::rename(part, target, error);
      if(error)
        break;
    }
    std::error_code ignored;
    if(error)
      for(std::size_t i = 0; i < renamed; ++i)
        std::filesystem::remove(files[i].target, ignored);
    for(const auto& [copy, target] : replaced) {
      if(error && !copy.empty())
        std::filesystem::rename(copy, target, ignored);
      std::filesystem::remove(copy, ignored);
    }
    for(const Finished_file& file : files) {
      std::filesystem::remove(file.part, ignored); // if it was not renamed
      forget(file.part);
    }
  }

  /// Removes all, for a program that ends now: other threads that create or rename a file wait for
  /// ever.
  void abandon() noexcept
  {
    mutex_.lock();
    std::error_code ignored;
    for(const std::filesystem::path& part : parts_)
      std::filesystem::remove(part, ignored);
  }

private:
  /// Tries names beside `target` until `take(name)` succeeds.
  template <typename Take>
  static std::filesystem::path unused_name(const std::filesystem::path& target, const Take& take)
  {
    constexpr int attempts = 100; // of 2^32 names
    std::random_device random;
    for(int i = 0; i < attempts; ++i) {
      const std::filesystem::path name =
          target.parent_path() / (".skeleton-" + std::to_string(random()) + ".part");
      errno = 0;
      if(take(name))
        return name;
      if(errno != EEXIST)
        break;
    }
    return {};
  }

  /// Another name for a file, or a copy where files have one name only.
  static std::filesystem::path kept_copy(const std::filesystem::path& file, std::error_code& error)
  {
    const std::filesystem::path name = unused_name(file, [&](const std::filesystem::path& other) {
      error.clear();
      std::filesystem::create_hard_link(file, other, error);
      if(error && error != std::errc::file_exists) {
        error.clear();
        std::filesystem::copy_file(file, other, error);
      }
      errno = error == std::errc::file_exists ? EEXIST : 0;
      return !error;
    });
    return name;
  }

  void forget(const std::filesystem::path& part)
  {
    parts_.erase(std::remove(parts_.begin(), parts_.end(), part), parts_.end());
  }

  std::mutex mutex_;
  std::vector<std::filesystem::path> parts_;
};

/// Those of this process; there until it ends.
inline Unfinished_files& unfinished_files()
{
  static Unfinished_files* const files = new Unfinished_files;
  return *files;
}

/// Waits until what was written to a file is on the disk, where the system can tell.
/// \returns whether it is
inline bool is_on_disk(const std::filesystem::path& file)
{
#if defined(__unix__) || defined(__APPLE__)
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const bool success = descriptor >= 0 && (::fsync(descriptor) == 0 || errno == EINVAL);
  if(descriptor >= 0)
    ::close(descriptor);
  return success;
#else
  static_cast<void>(file);
  return true;
#endif
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_UNFINISHED_FILES_H
