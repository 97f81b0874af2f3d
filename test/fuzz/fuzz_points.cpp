// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The target of libFuzzer for the methods, on points from bytes.

#include "fuzzed_points.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzzed::fuzz_points(data, size);
  return 0;
}
