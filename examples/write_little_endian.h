// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_WRITE_LITTLE_ENDIAN_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_WRITE_LITTLE_ENDIAN_H

#include <cstddef>
#include <cstring>
#include <ostream>

/// Writes the bytes of a number, the lowest first on any machine.
template <typename Bits, typename Number>
void write_little_endian(std::ostream& os, Number number)
{
  static_assert(sizeof(Bits) == sizeof(Number), "as many bits as the number has");
  Bits bits;
  std::memcpy(&bits, &number, sizeof bits);
  for(std::size_t byte = 0; byte < sizeof bits; ++byte)
    os.put(static_cast<char>(bits >> 8 * byte & 0xff));
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_WRITE_LITTLE_ENDIAN_H
