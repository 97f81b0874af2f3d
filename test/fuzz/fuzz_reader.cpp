// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The target of libFuzzer for the reader of FORMAT, a macro.

#include "fuzzed_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz_reader(data, size, FORMAT);
  return 0;
}
