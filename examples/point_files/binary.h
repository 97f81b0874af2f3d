// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_BINARY_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_BINARY_H

#include "Input.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace point_files {

enum class Byte_order
{
  little,
  big
};

/// The number that `bytes` hold, on a machine of any byte order.
template <typename Number>
Number decoded(const char* bytes, Byte_order order)
{
  std::uint64_t bits = 0;
  for(std::size_t i = 0; i < sizeof(Number); ++i) {
    const std::size_t place = order == Byte_order::little ? i : sizeof(Number) - 1 - i;
    bits |= std::uint64_t(static_cast<unsigned char>(bytes[i])) << (8 * place);
  }
  Number result;
  if constexpr(sizeof(Number) == 8)
    std::memcpy(&result, &bits, 8);
  else if constexpr(sizeof(Number) == 4) {
    const auto word = static_cast<std::uint32_t>(bits);
    std::memcpy(&result, &word, 4);
  }
  else
    result = static_cast<Number>(bits);
  return result;
}

/// Reads numbers one after the other.
class Numbers
{
public:
  Numbers(Input& input, Byte_order order)
      : input_(input)
      , order_(order)
  {}

  /// \throw Ends_early
  template <typename Number>
  Number read()
  {
    std::array<char, sizeof(Number)> bytes;
    input_.read(bytes.data(), bytes.size());
    return decoded<Number>(bytes.data(), order_);
  }

private:
  Input& input_;
  Byte_order order_;
};

/// A number in one of the types that point clouds are stored in.
enum class Number_type
{
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64
};

inline std::size_t size_of(Number_type type)
{
  constexpr std::array<std::size_t, 10> sizes{{1, 1, 2, 2, 4, 4, 8, 8, 4, 8}};
  return sizes[static_cast<std::size_t>(type)];
}

inline bool is_integer(Number_type type)
{
  return type != Number_type::float32 && type != Number_type::float64;
}

/// Calls `visit(number)` with the number of this type that `bytes` hold.
template <typename Visit>
auto decode(const char* bytes, Number_type type, Byte_order order, const Visit& visit)
{
  switch(type) {
  case Number_type::int8:
    return visit(decoded<std::int8_t>(bytes, order));
  case Number_type::uint8:
    return visit(decoded<std::uint8_t>(bytes, order));
  case Number_type::int16:
    return visit(decoded<std::int16_t>(bytes, order));
  case Number_type::uint16:
    return visit(decoded<std::uint16_t>(bytes, order));
  case Number_type::int32:
    return visit(decoded<std::int32_t>(bytes, order));
  case Number_type::uint32:
    return visit(decoded<std::uint32_t>(bytes, order));
  case Number_type::int64:
    return visit(decoded<std::int64_t>(bytes, order));
  case Number_type::uint64:
    return visit(decoded<std::uint64_t>(bytes, order));
  case Number_type::float32:
    return visit(decoded<float>(bytes, order));
  default:
    return visit(decoded<double>(bytes, order));
  }
}

/// The number as a coordinate.
inline double to_double(const char* bytes, Number_type type, Byte_order order)
{
  return decode(bytes, type, order, [](auto number) { return static_cast<double>(number); });
}

} // namespace point_files

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_BINARY_H
