// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Input.h"

#include <algorithm>
#include <cstring>

namespace point_files {

namespace {

// A buffer of this size is read in about a millisecond; small files take a smaller one.
constexpr std::uint64_t buffer_size = std::uint64_t(1) << 18;
constexpr std::uint64_t least_buffer_size = std::uint64_t(1) << 8;

// The face of a mesh with a million corners fits; a file without ends of lines is not read into
// memory.
constexpr std::size_t longest_line = std::size_t(1) << 24;

} // namespace

Input::Input(std::streambuf& bytes, std::uint64_t size)
    : bytes_(bytes)
    , size_(size)
    , buffer_(static_cast<std::size_t>(
          size == unknown ? buffer_size : std::clamp(size + 1, least_buffer_size, buffer_size)))
{}

// Reads more behind what is in the buffer, which grows if it is full.
bool Input::refill()
{
  if(begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, in_buffer());
    end_ -= begin_;
    begin_ = 0;
  }
  if(end_ == buffer_.size())
    buffer_.resize(2 * buffer_.size());
  const std::streamsize count =
      bytes_.sgetn(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
  end_ += static_cast<std::size_t>(std::max<std::streamsize>(count, 0));
  if(size_ != unknown)
    size_ = std::max(size_, position_ + end_); // a file that grows while it is read
  if(progress_)
    progress_(size_ == unknown || size_ == 0
                  ? 0
                  : static_cast<double>(position_) / static_cast<double>(size_));
  return count > 0;
}

bool Input::next_line(std::string_view& line)
{
  std::size_t searched = 0;
  const char* line_end = nullptr;
  while(!line_end) {
    line_end = static_cast<const char*>(
        std::memchr(buffer_.data() + begin_ + searched, '\n', in_buffer() - searched));
    searched = in_buffer();
    if(!line_end && searched > longest_line)
      throw Bad_file("line " + std::to_string(line_number_ + 1) + " never ends: this is no text");
    if(!line_end && !refill())
      break;
  }
  if(!line_end && in_buffer() == 0)
    return false;
  const char* const first = buffer_.data() + begin_;
  const std::size_t size = line_end ? static_cast<std::size_t>(line_end - first) : in_buffer();
  line = std::string_view(first, size);
  const std::size_t consumed = size + (line_end ? 1 : 0);
  begin_ += consumed;
  position_ += consumed;
  ++line_number_;
  in_text_ = true;
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if(line_number_ == 1 && line.substr(0, byte_order_mark.size()) == byte_order_mark)
    line.remove_prefix(byte_order_mark.size());
  if(!line.empty() && line.back() == '\r')
    line.remove_suffix(1);
  return true;
}

std::string_view Input::peek(std::size_t size)
{
  while(in_buffer() < size && refill())
    continue;
  return {buffer_.data() + begin_, std::min(size, in_buffer())};
}

void Input::read(void* to, std::size_t size)
{
  in_text_ = false;
  for(char* next = static_cast<char*>(to); size > 0;) {
    if(in_buffer() == 0 && !refill())
      throw Ends_early();
    const std::size_t part = std::min(size, in_buffer());
    std::memcpy(next, buffer_.data() + begin_, part);
    next += part;
    begin_ += part;
    position_ += part;
    size -= part;
  }
}

void Input::skip(std::uint64_t size)
{
  in_text_ = false;
  if(size_ != unknown && size > bytes_left())
    throw Ends_early();
  while(size > 0) {
    if(in_buffer() == 0 && !refill())
      throw Ends_early();
    const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(size, in_buffer()));
    begin_ += part;
    position_ += part;
    size -= part;
  }
}

} // namespace point_files
