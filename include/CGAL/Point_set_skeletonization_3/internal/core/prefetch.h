// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PREFETCH_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PREFETCH_H

#include <cstddef>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Begins to load an object into the cache: what follows need not wait for it. A hint, which
/// changes no result.
template <typename Object>
void prefetch(const Object& object)
{
#ifdef __GNUC__ // and Clang
  constexpr std::size_t cache_line = 64;
  const char* const address = reinterpret_cast<const char*>(&object);
  for(std::size_t at = 0; at < sizeof(Object); at += cache_line)
    __builtin_prefetch(address + at, 1);
#else
  static_cast<void>(object);
#endif
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PREFETCH_H
