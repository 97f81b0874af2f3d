// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MEDIAL_SAMPLE_3_H
#define CGAL_MEDIAL_SAMPLE_3_H

namespace CGAL {

/// A surface patch, or as published an input point, that moved to the middle of the shape. Lengths
/// in the unit of the input.
template <typename GeomTraits>
struct Medial_sample_3
{
  using FT = typename GeomTraits::FT;
  using Point_3 = typename GeomTraits::Point_3;

  Point_3 origin{0, 0, 0}; ///< Where it started: the mean of its patch, or an input point.
  Point_3 point{0, 0, 0};  ///< Where it is.
  FT kernel_radius = 0;    ///< Support radius of its kernel, > 0.
  FT radius = 0;           ///< Distance to the nearest surface that it sees from inside; 0 if none.
  bool frozen = false;     ///< Whether an iteration found it arrived; it no longer moves.
};

/// Why a projection stopped.
enum class Projection_stop_reason
{
  empty,           ///< There was nothing to project.
  converged,       ///< No sample moves any more, or none was to.
  iteration_limit, ///< The bound on the iterations was reached first.
  fixed_number,    ///< The published method: its fixed number of iterations is done.
  cancelled        ///< The callback returned `false`.
};

/// The reason in one lower-case word, for logs.
inline const char* to_string(Projection_stop_reason reason)
{
  switch(reason) {
  case Projection_stop_reason::converged:
    return "converged";
  case Projection_stop_reason::iteration_limit:
    return "iteration_limit";
  case Projection_stop_reason::fixed_number:
    return "fixed_number";
  case Projection_stop_reason::cancelled:
    return "cancelled";
  case Projection_stop_reason::empty:
    break;
  }
  return "empty";
}

} // namespace CGAL

#endif // CGAL_MEDIAL_SAMPLE_3_H
