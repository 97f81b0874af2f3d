// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_LETTERS_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_LETTERS_H

#include "../Random.h"
#include "../drawing.h"

#include <algorithm>
#include <cstddef>
#include <vector>

/// Block letters of straight strokes.
namespace shapes {
namespace families {

struct Letter
{
  std::vector<std::vector<Eigen::Vector2d>> strokes;
  std::size_t cycles, ends;
};

/// In a field two units high.
inline const std::vector<Letter>& letters()
{
  static const std::vector<Letter> all = {
      // A
      {{{{0, 0}, {0.5, 1}, {1, 2}, {1.5, 1}, {2, 0}}, {{0.5, 1}, {1.5, 1}}}, 1, 2},
      // B
      {{{{0, 1}, {0, 2}, {0.9, 2}, {1.2, 1.7}, {1.2, 1.3}, {0.9, 1}, {0, 1}},
        {{0, 1}, {0, 0}, {0.9, 0}, {1.2, 0.3}, {1.2, 0.7}, {0.9, 1}}},
       2,
       0},
      // E
      {{{{1.1, 2}, {0, 2}, {0, 1}, {0, 0}, {1.1, 0}}, {{0, 1}, {1, 1}}}, 0, 3},
      // H
      {{{{0, 2}, {0, 1}, {0, 0}}, {{0, 1}, {1.2, 1}}, {{1.2, 2}, {1.2, 1}, {1.2, 0}}}, 0, 4},
      // P
      {{{{0, 0}, {0, 1}, {0, 2}, {1.1, 2}, {1.1, 1}, {0, 1}}}, 1, 1},
      // X
      {{{{0, 0}, {0.7, 1}, {1.4, 2}}, {{0, 2}, {0.7, 1}, {1.4, 0}}}, 0, 4},
      // 8
      {{{{0, 1}, {0, 2}, {1.1, 2}, {1.1, 1}, {0, 1}}, {{0, 1}, {0, 0}, {1.1, 0}, {1.1, 1}}}, 2, 0},
  };
  return all;
}

/// A flat beam; its ends are as far behind the points as its sides are beside them.
inline void add_beam(Known_shape& shape, const Vector& a, const Vector& b, double half_width,
                     double half_depth)
{
  Eigen::Matrix3d axes;
  axes.col(0) = (b - a).normalized();
  axes.col(1) = Vector::UnitZ().cross(axes.col(0));
  axes.col(2) = Vector::UnitZ();
  const double thinner = std::min(half_width, half_depth);
  shape.solid.add(Rounded_box((a + b) / 2, axes,
                              Vector((b - a).norm() / 2 + half_width, half_width, half_depth),
                              0.8 * thinner));
  add_axis(shape, {{a, thinner}, {b, thinner}});
}

inline Known_shape letter(Random& random)
{
  const int last = static_cast<int>(letters().size()) - 1;
  const Letter& chosen = letters()[static_cast<std::size_t>(random.in_turn(0, last))];
  const double width = random.uniform(0.95, 1.2), height = random.uniform(0.95, 1.2);
  const double half_width = random.uniform(0.12, 0.16), aspect = random.uniform(0.9, 2);
  const bool is_round = random.integer(0, 2) == 0;
  const auto place = [&](const Eigen::Vector2d& p) {
    return Vector(width * p.x(), height * p.y(), 0);
  };
  Known_shape shape;
  for(const std::vector<Eigen::Vector2d>& stroke : chosen.strokes)
    for(std::size_t i = 1; i < stroke.size(); ++i) {
      const Vector a = place(stroke[i - 1]), b = place(stroke[i]);
      if(is_round)
        add_limb(shape, {{a, half_width}, {b, half_width}});
      else
        add_beam(shape, a, b, half_width, aspect * half_width);
    }
  set_counts(shape, 1, chosen.cycles, chosen.ends);
  return shape;
}

} // namespace families
} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_LETTERS_H
