// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_VOXELS_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_VOXELS_H

#include "Random.h"
#include "Solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace shapes {

/// A solid as the interior of a union of cubes: those whose centre is inside it or within an offset
/// of it. The interior, for then gaps are open where empty cubes touch at a vertex.
class Voxels
{
public:
  /// \param size edge of a cube, in the unit of the solid
  Voxels(const Solid& solid, double offset, double size)
      : solid_(solid)
      , offset_(offset)
      , size_(size)
  {
    const Eigen::AlignedBox3d box = solid.bounding_box();
    origin_ = box.min().array() - offset - 2 * size; // an empty layer all around
    const double edge = box.diagonal().maxCoeff() + 2 * offset + 4 * size;
    while(static_cast<double>(edge_) * size < edge)
      edge_ *= 2;
    inside_.assign(edge_ * edge_ * edge_, 0);
    fill({0, 0, 0}, edge_);
  }

  /// Components less tunnels plus cavities.
  long euler_number() const
  {
    long number = 0;
    for(std::size_t x = 1; x < edge_; ++x)
      for(std::size_t y = 1; y < edge_; ++y)
        for(std::size_t z = 1; z < edge_; ++z)
          number += contribution({x, y, z});
    return number;
  }

private:
  using Index = std::array<std::size_t, 3>;

  char& inside(const Index& i) { return inside_[(i[0] * edge_ + i[1]) * edge_ + i[2]]; }
  char inside(const Index& i) const { return inside_[(i[0] * edge_ + i[1]) * edge_ + i[2]]; }

  /// Fills a block. One that is deep inside or far outside needs a single distance.
  void fill(const Index& corner, std::size_t edge)
  {
    const Vector low(static_cast<double>(corner[0]), static_cast<double>(corner[1]),
                     static_cast<double>(corner[2]));
    const double half = static_cast<double>(edge) / 2;
    const Vector centre = origin_ + size_ * (low.array() + half).matrix();
    const double distance = solid_.signed_distance(centre) - offset_;
    if(distance > std::sqrt(3.0) * half * size_)
      return;
    if(edge == 1) {
      inside(corner) = distance < 0;
      return;
    }
    for(std::size_t part = 0; part < 8; ++part) {
      const std::size_t step = edge / 2;
      fill({corner[0] + (part & 1) * step, corner[1] + (part >> 1 & 1) * step,
            corner[2] + (part >> 2) * step},
           step);
    }
  }

  /// Of the cells whose largest vertex this is: cubes and edges less squares and vertices.
  long contribution(const Index& vertex) const
  {
    unsigned around = 0; // which of the eight cubes at the vertex are inside
    for(unsigned step = 0; step < 8; ++step)
      if(inside({vertex[0] - (step & 1), vertex[1] - (step >> 1 & 1), vertex[2] - (step >> 2)}))
        around |= 1u << step;
    if(around == 0 || around == 255)
      return 0;
    long number = 0;
    for(unsigned directions = 0; directions < 8; ++directions)
      if(is_inner(around, directions))
        number += is_even(directions) ? -1 : 1;
    return number;
  }

  /// Whether all cubes are inside that have the cell with these directions as a face.
  static bool is_inner(unsigned around, unsigned directions)
  {
    for(unsigned step = 0; step < 8; ++step)
      if((step & directions) == directions && (around >> step & 1) == 0)
        return false;
    return true;
  }

  static bool is_even(unsigned directions)
  {
    return ((directions & 1) + (directions >> 1 & 1) + (directions >> 2)) % 2 == 0;
  }

  const Solid& solid_;
  double offset_, size_;
  Vector origin_;
  std::size_t edge_ = 1;
  std::vector<char> inside_;
};

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_VOXELS_H
