// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PROGRESS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PROGRESS_H

#include <chrono>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Thrown if the user's callback cancels; caught by `Steps::run()`.
struct Cancelled
{
};

/// The user's callback, for a stage that is a part of the whole. Always called from the thread that
/// runs the stage.
class Progress
{
  using Clock = std::chrono::steady_clock;

  /// What all parts share.
  struct State
  {
    std::function<bool(double)> callback;
    double maximum_seconds;
    Clock::time_point first = Clock::time_point(), last = Clock::time_point();
    double fraction = 0;

    void report(double new_fraction)
    {
      fraction = new_fraction;
      last = Clock::now();
      if(first == Clock::time_point())
        first = last;
      const bool is_late = std::chrono::duration<double>(last - first).count() > maximum_seconds;
      if(is_late || (callback && !callback(fraction)))
        throw Cancelled();
    }

    void repeat()
    {
      constexpr std::chrono::milliseconds silence(40);
      if(Clock::now() - last > silence)
        report(fraction);
    }
  };

  /// The state that `poll()` reports to, on this thread.
  static State*& polled()
  {
    thread_local State* state = nullptr;
    return state;
  }

public:
  using Callback = std::function<bool(double)>;

  Progress() = default;

  /// \param maximum_seconds cancels that long after the first report
  explicit Progress(Callback callback,
                    double maximum_seconds = std::numeric_limits<double>::infinity())
  {
    if(callback || maximum_seconds < std::numeric_limits<double>::infinity())
      state_ = std::make_shared<State>(State{std::move(callback), maximum_seconds});
  }

  /// The same callback for the part [`begin`, `end`] of this one.
  Progress part(double begin, double end) const
  {
    Progress result = *this;
    result.begin_ = at(begin);
    result.end_ = at(end);
    return result;
  }

  /// Reports `fraction`, in [0, 1], of this stage. \throws Cancelled if the callback returns
  /// `false`
  void operator()(double fraction) const
  {
    if(state_)
      state_->report(at(fraction));
  }

  /// Makes `Progress::poll()` repeat the last report while this object lives, on this thread.
  class Polled
  {
  public:
    explicit Polled(const Progress& progress)
        : outer_(std::exchange(polled(), progress.state_.get()))
    {}
    Polled(const Polled&) = delete;
    Polled& operator=(const Polled&) = delete;
    ~Polled() { polled() = outer_; }

  private:
    State* outer_;
  };

  /// To be called many times a second by what takes long: repeats the last report if it is too long
  /// ago, so that the user can cancel. Does nothing on other threads than that of the stage.
  /// \throws Cancelled if the callback returns `false`
  static void poll()
  {
    if(polled())
      polled()->repeat();
  }

private:
  double at(double fraction) const { return begin_ + fraction * (end_ - begin_); }

  std::shared_ptr<State> state_; ///< That of the whole; null if nobody wants to know.
  double begin_ = 0;
  double end_ = 1;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PROGRESS_H
