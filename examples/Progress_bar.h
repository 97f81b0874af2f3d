// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_PROGRESS_BAR_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_PROGRESS_BAR_H

#include <algorithm>
#include <iostream>
#include <string>

#include <sys/ioctl.h>
#include <unistd.h>

/// A bar on standard error, if that is a terminal, and no wider than it; gone when the work is
/// done.
class Progress_bar
{
public:
  explicit Progress_bar(bool enabled)
    : enabled_(enabled && isatty(STDERR_FILENO) != 0), width_(bar_width())
  {}
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  ~Progress_bar()
  {
    if(shown_ >= 0)
      std::cerr << '\r' << std::string(width_ + around, ' ') << '\r' << std::flush;
  }

  /// Shows a `fraction` in [0, 1].
  void show(double fraction)
  {
    const int percent = static_cast<int>(100 * std::clamp(fraction, 0., 1.));
    if(!enabled_ || percent == shown_)
      return;
    shown_ = percent;
    const std::string number = std::to_string(percent);
    const std::string::size_type done = static_cast<std::string::size_type>(percent) * width_ / 100;
    std::cerr << "\r[" << std::string(done, '#') << std::string(width_ - done, ' ') << "] "
              << std::string(3 - number.size(), ' ') << number << '%' << std::flush;
  }

private:
  static constexpr std::string::size_type around = 7; // characters: brackets and percent

  /// In characters: 50, or what the terminal has room for.
  static std::string::size_type bar_width()
  {
    constexpr std::string::size_type widest = 50;
    winsize terminal{};
    if(ioctl(STDERR_FILENO, TIOCGWINSZ, &terminal) != 0 || terminal.ws_col == 0)
      return widest;
    // The last column stays free, where some terminals break the line.
    return std::clamp<std::string::size_type>(terminal.ws_col, around + 1, widest + around + 1) -
           around - 1;
  }

  bool enabled_;
  std::string::size_type width_;
  int shown_ = -1; // percent
};

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_PROGRESS_BAR_H
