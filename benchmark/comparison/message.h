// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_MESSAGE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_MESSAGE_H

#include "../methods/Method.h"

#include <cstdint>
#include <string>
#include <vector>

/// What the process of a method tells its parent.
struct Message
{
  std::string error; ///< of the exception; empty if there was none
  Method_result result;
  double seconds = 0;
};

/// As CBOR, which keeps all bits of a number, also of one that is not finite. The skeleton goes
/// without indices.
std::vector<std::uint8_t> to_bytes(const Message& message);

/// \throw std::exception if these are not all the bytes of a message
Message to_message(const std::vector<std::uint8_t>& bytes);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_MESSAGE_H
