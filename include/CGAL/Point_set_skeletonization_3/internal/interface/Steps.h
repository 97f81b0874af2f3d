// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_STEPS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_STEPS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>

#include <utility>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The steps of a skeletonization: how many are done, and the user's callback.
class Steps
{
public:
  explicit Steps(Progress progress) : progress_(std::move(progress)) {}

  /// Number of steps done.
  int done() const { return done_; }

  /// Runs step `number` by `step(progress)`, whose progress covers [`begin`, `end`] of the whole.
  /// \returns `false` if the callback cancelled; then the step is not done
  template <typename Step>
  bool run(int number, double begin, double end, const Step& step)
  {
    done_ = number - 1;
    if(!run_polled([&] { step(progress_.part(begin, end)); }))
      return false;
    done_ = number;
    return true;
  }

  /// Runs what has no progress of its own, but can be cancelled by `Progress::poll()`.
  /// \returns `false` if it was
  template <typename Function>
  bool run_polled(const Function& function) const
  {
    const Progress::Polled polled(progress_);
    try {
      function();
    } catch(const Cancelled&) {
      return false;
    }
    return true;
  }

private:
  Progress progress_;
  int done_ = 0;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_STEPS_H
