// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_FUZZ_FUZZED_READER_H
#define POINT_SET_SKELETONIZATION_3_TEST_FUZZ_FUZZED_READER_H

#include "read_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <vector>

/// Bytes in memory, handed out in pieces as small as a pipe might.
class Piecewise_bytes : public std::streambuf
{
public:
  Piecewise_bytes(const std::uint8_t* data, std::size_t size, std::size_t piece)
      : bytes_(data, data + size)
      , piece_(piece)
  {}

protected:
  std::streamsize xsgetn(char* to, std::streamsize most) override
  {
    const std::size_t size =
        std::min({piece_, static_cast<std::size_t>(most), bytes_.size() - next_});
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(next_), size, to);
    next_ += size;
    return static_cast<std::streamsize>(size);
  }

private:
  std::vector<char> bytes_;
  std::size_t piece_, next_ = 0;
};

/// What a reader makes of bytes.
struct Read_bytes
{
  bool success = false;
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<std::size_t>> faces;
};

inline void require(bool condition)
{
  if(!condition)
    std::abort();
}

/// Reads bytes as a file of this format, and aborts if a point or a face is impossible.
inline Read_bytes read(const std::uint8_t* data, std::size_t size, const std::string& format,
                       bool skip_invalid, bool as_pipe)
{
  Piecewise_bytes bytes(data, size, as_pipe ? 7 : size);
  point_files::Input input(bytes, as_pipe ? point_files::Input::unknown : size);
  point_files::Reading_options options;
  options.format = format;
  options.skip_invalid = skip_invalid;
  Read_bytes result;
  point_files::Rows rows(
      [&result](double x, double y, double z) {
        require(std::isfinite(x) && std::isfinite(y) && std::isfinite(z));
        result.points.push_back({{x, y, z}});
      },
      skip_invalid);
  rows.keep_faces();
  try {
    point_files::read_bytes(input, "fuzzed", options, rows);
    result.success = true;
  } catch(const std::runtime_error& error) {
    const std::string message = error.what();
    require(!message.empty() && message.find('\n') == std::string::npos);
  }
  require(result.points.size() == rows.number_of_points());
  result.faces = rows.faces();
  if(result.success)
    for(const auto& face : result.faces)
      for(const std::size_t v : face)
        require(v < result.points.size());
  return result;
}

/// Bytes are read the same way from a file as from a pipe.
inline void fuzz_reader(const std::uint8_t* data, std::size_t size, const std::string& format)
{
  for(const bool skip_invalid : {false, true}) {
    const Read_bytes file = read(data, size, format, skip_invalid, false);
    const Read_bytes pipe = read(data, size, format, skip_invalid, true);
    require(file.success == pipe.success);
    if(file.success)
      require(file.points == pipe.points && file.faces == pipe.faces);
  }
}

#endif // POINT_SET_SKELETONIZATION_3_TEST_FUZZ_FUZZED_READER_H
