// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_INT128_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_INT128_H

#include <boost/config.hpp>

#ifndef BOOST_HAS_INT128
#include <boost/multiprecision/cpp_int.hpp>
#endif

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A signed integer of 128 bits; the compiler's own if it has one.
#ifdef BOOST_HAS_INT128
using Int128 = boost::int128_type;
#else
using Int128 = boost::multiprecision::int128_t;
#endif

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_INT128_H
