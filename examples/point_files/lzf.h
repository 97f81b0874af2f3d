// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_LZF_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_LZF_H

#include "Input.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace point_files {

/// No stream is longer than this many times its compressed size: three bytes make 264.
constexpr std::size_t lzf_greatest_ratio = 88;

/// What was compressed with LZF, the method of compressed PCD files: a sequence of literal bytes
/// and of copies of earlier output. \throw Bad_file if it is not `size` bytes
inline std::string lzf_decompressed(std::string_view in, std::size_t size)
{
  const auto damaged = [] { throw Bad_file("its compressed data are damaged"); };
  std::string out;
  std::size_t next = 0;
  const auto byte = [&]() -> std::size_t {
    if(next == in.size())
      damaged();
    return static_cast<unsigned char>(in[next++]);
  };
  while(next < in.size()) {
    const std::size_t control = byte();
    std::size_t length = control < 32 ? control + 1 : control / 32;
    if(control < 32) {
      if(length > in.size() - next || length > size - out.size())
        damaged();
      out += in.substr(next, length);
      next += length;
      continue;
    }
    if(length == 7)
      length += byte();
    length += 2;
    const std::size_t distance = (control % 32) * 256 + byte() + 1;
    if(distance > out.size() || length > size - out.size())
      damaged();
    for(; length > 0; --length) // may copy what it has just written
      out += out[out.size() - distance];
  }
  if(out.size() != size)
    damaged();
  return out;
}

} // namespace point_files

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_LZF_H
