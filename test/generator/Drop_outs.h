// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_DROP_OUTS_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_DROP_OUTS_H

#include "Random.h"

namespace shapes {

/// Loses pulses in runs, as where a surface is dark or wet.
class Drop_outs
{
public:
  explicit Drop_outs(double share)
      : share_(share)
  {}

  bool next(Random& random)
  {
    constexpr double mean_run = 5; // pulses
    const double change = is_lost_ ? 1 / mean_run : share_ / (1 - share_) / mean_run;
    is_lost_ = is_lost_ != (random.uniform() < change);
    return is_lost_;
  }

private:
  double share_;
  bool is_lost_ = false;
};

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_DROP_OUTS_H
