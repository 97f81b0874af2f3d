// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_INPUT_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_INPUT_H

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace point_files {

/// What is wrong with a file, in one line without the name of the file.
class Bad_file : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Thrown where a file ends too early; the text says after how many points.
class Ends_early : public std::exception
{
};

/// The bytes of a file, a pipe or memory, read once from begin to end through a buffer of bounded
/// size. No count in a file makes it ask for memory: it hands out what is there.
class Input
{
public:
  static constexpr std::uint64_t unknown = (std::numeric_limits<std::uint64_t>::max)();

  /// \param size the number of bytes, if it is known
  explicit Input(std::streambuf& bytes, std::uint64_t size = unknown);

  /// Calls `progress` with the share in [0, 1] of the bytes read so far, some hundred times a
  /// second; always 0 if the size is unknown. It may throw.
  void report_to(std::function<void(double)> progress) { progress_ = std::move(progress); }

  /// The next line, without its end and without a byte order mark; valid until the next call.
  /// \returns `false` at the end of the file
  /// \throw Bad_file if the line is longer than any line of text
  bool next_line(std::string_view& line);

  /// The next bytes, at most `size`; fewer only at the end of the file. They are not consumed.
  /// \pre `size <= 65536`
  std::string_view peek(std::size_t size);

  /// Consumes `size` bytes. \throw Ends_early
  void read(void* to, std::size_t size);

  /// Consumes `size` bytes unseen. \throw Ends_early, at once if the size of the file is known
  void skip(std::uint64_t size);

  /// The number of bytes left; `unknown` in a pipe.
  std::uint64_t bytes_left() const { return size_ == unknown ? unknown : size_ - position_; }

  /// The line read last, from 1.
  std::size_t line_number() const { return line_number_; }

  /// "line 7", to begin a message with.
  std::string line() const { return "line " + std::to_string(line_number_); }

  /// Where the reader is: "line 7: " in text, nothing in binary data.
  std::string location() const { return in_text_ ? line() + ": " : std::string(); }

private:
  std::size_t in_buffer() const { return end_ - begin_; }
  bool refill();

  std::streambuf& bytes_;
  std::uint64_t size_;
  std::uint64_t position_ = 0; ///< Of the first byte not consumed.
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0; ///< In the buffer: what is read and not consumed.
  std::size_t line_number_ = 0;
  bool in_text_ = false;
  std::function<void(double)> progress_;
};

} // namespace point_files

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_INPUT_H
