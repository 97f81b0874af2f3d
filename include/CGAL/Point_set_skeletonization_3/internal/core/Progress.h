// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PROGRESS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PROGRESS_H

#include <functional>
#include <utility>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Thrown if the user's callback cancels; caught by `Steps::run()`.
struct Cancelled
{};

/// The user's callback, for a stage that is a part of the whole. Always called from the thread that
/// runs the stage, outside parallel loops.
class Progress
{
public:
  using Callback = std::function<bool(double)>;

  Progress() = default;
  explicit Progress(Callback callback, double begin = 0, double end = 1)
    : callback_(std::move(callback)), begin_(begin), end_(end)
  {}

  /// The same callback for the part [`begin`, `end`] of this one.
  Progress part(double begin, double end) const { return Progress(callback_, at(begin), at(end)); }

  /// Reports `fraction`, in [0, 1], of this stage. \throws Cancelled if the callback returns
  /// `false`
  void operator()(double fraction) const
  {
    if(callback_ && !callback_(at(fraction)))
      throw Cancelled();
  }

private:
  double at(double fraction) const { return begin_ + fraction * (end_ - begin_); }

  Callback callback_;
  double begin_ = 0;
  double end_ = 1;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PROGRESS_H
