// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SETTLE_ORIENTATION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SETTLE_ORIENTATION_H

#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Packet_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Winding_number.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Whether the normals of the neighbours are along that of a patch, in the mean.
inline bool is_like_its_neighbors(const Patch& patch, const Patches& patches,
                                  const Surface_options& options)
{
  Vector3 sum = Vector3::Zero();
  for(std::size_t j : patch.neighbors)
    sum += patches[j].normal;
  return patch.normal.dot(sum) >
         options.along_normal * static_cast<double>(patch.neighbors.size());
}

/// Returns the winding number at each patch: 0.5 where the surface is oriented outwards, -0.5
/// inwards, 0 on an open sheet, which has no inside. Limbs oriented inwards are larger than a
/// packet of patches: if the first of a packet has at least `well`, all get 0.5.
inline std::vector<double> winding_numbers_on_surface(const Winding_number& winding_number,
                                                      const Box_tree& tree, double well,
                                                      Concurrency concurrency)
{
  const std::vector<Vector3>& positions = tree.positions();
  std::vector<Vector3> first_of_packets;
  for(std::size_t place = 0; place < positions.size(); place += packet_size)
    first_of_packets.push_back(positions[place]);
  const std::vector<double> of_packets = winding_number.at_places(first_of_packets, concurrency);
  std::vector<std::size_t> unsure; // positions in the order of the tree
  std::vector<Vector3> unsure_positions;
  for(std::size_t place = 0; place < positions.size(); ++place)
    if(of_packets[place / packet_size] < well) {
      unsure.push_back(place);
      unsure_positions.push_back(positions[place]);
    }
  const std::vector<double> of_unsure = winding_number.at_places(unsure_positions, concurrency);
  std::vector<double> result(positions.size(), 0.5);
  for(std::size_t k = 0; k < unsure.size(); ++k)
    result[tree.order()[unsure[k]]] = of_unsure[k];
  return result;
}

/// Flips normals that point inwards: the spanning forest may propagate a wrong sign across a thin
/// or sharp place. The winding number should be higher behind a patch than in front of it. First
/// flips limbs that are oriented inwards, then patches unlike their neighbours with a higher
/// winding number in front. Returns the winding number of the result. O(n log n).
inline Winding_number settle_orientation(Patches& patches, const Box_tree& tree,
                                         const Surface_options& options, Concurrency concurrency)
{
  constexpr double decided = 0.25; // halfway between an open sheet and one side of a solid
  Winding_number winding_number(patches, tree, concurrency);
  const auto turn_where = [&](const auto& is_wrong) {
    std::vector<char> wrong(patches.size());
    parallel_for(concurrency, patches.size(), [&](std::size_t i) { wrong[i] = is_wrong(i); });
    for(std::size_t i = 0; i < patches.size(); ++i)
      if(wrong[i])
        patches[i].normal = -patches[i].normal;
    if(std::any_of(wrong.begin(), wrong.end(), [](char is) { return is; }))
      winding_number = Winding_number(patches, tree, concurrency);
  };
  const std::vector<double> on_surface =
    winding_numbers_on_surface(winding_number, tree, decided, concurrency);
  turn_where([&](std::size_t i) { return on_surface[i] < -decided; });
  turn_where([&](std::size_t i) {
    const Patch& patch = patches[i];
    if(is_like_its_neighbors(patch, patches, options))
      return false;
    const Vector3 step = patch.spacing * patch.normal;
    const auto [in_front, behind] =
      winding_number(std::array<Vector3, 2>{{patch.mean + step, patch.mean - step}});
    return in_front > behind;
  });
  return winding_number;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SETTLE_ORIENTATION_H
