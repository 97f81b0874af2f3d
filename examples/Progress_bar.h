// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_PROGRESS_BAR_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_PROGRESS_BAR_H

#include <algorithm>
#include <iostream>
#include <string>

#include <unistd.h>

/// A bar on standard error, if that is a terminal; gone when the work is done.
class Progress_bar
{
public:
  explicit Progress_bar(bool enabled) : enabled_(enabled && isatty(STDERR_FILENO) != 0) {}
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  ~Progress_bar()
  {
    if(shown_ >= 0)
      std::cerr << '\r' << std::string(width + 7, ' ') << '\r' << std::flush;
  }

  /// Shows a `fraction` in [0, 1].
  void show(double fraction)
  {
    const int percent = static_cast<int>(100 * std::clamp(fraction, 0., 1.));
    if(!enabled_ || percent == shown_)
      return;
    shown_ = percent;
    const std::string number = std::to_string(percent);
    const std::string::size_type done = static_cast<std::string::size_type>(percent) * width / 100;
    std::cerr << "\r[" << std::string(done, '#') << std::string(width - done, ' ') << "] "
              << std::string(3 - number.size(), ' ') << number << '%' << std::flush;
  }

private:
  static constexpr std::string::size_type width = 50; // characters; fits any terminal
  bool enabled_;
  int shown_ = -1; // percent
};

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_PROGRESS_BAR_H
