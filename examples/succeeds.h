// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_SUCCEEDS_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_SUCCEEDS_H

#include <exception>
#include <iostream>
#include <new>
#include <string>

/// Returns whether an action succeeded; otherwise one line on standard error says why.
/// \param out_of_memory what to say if there was not enough memory
template <typename Action>
bool succeeds(const std::string& program, const Action& action, const std::string& out_of_memory)
{
  const auto fail = [&program](const std::string& why) {
    std::cerr << program + ": " + why + '\n' << std::flush; // at once: processes share the stream
    return false;
  };
  try {
    action();
    return true;
  } catch(const std::bad_alloc&) {
    return fail(out_of_memory);
  } catch(const std::exception& error) {
    return fail(error.what());
  }
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_SUCCEEDS_H
