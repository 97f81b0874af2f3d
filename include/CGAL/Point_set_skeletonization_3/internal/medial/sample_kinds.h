// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_SAMPLE_KINDS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_SAMPLE_KINDS_H

#include <CGAL/Point_set_skeletonization_3/Medial_sample_kind.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/straightness.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/dimensionality_around.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Calls `visit(k)` for each patch around patch `i`, with it.
template <typename Visit>
void visit_surroundings(const Surface& surface, std::size_t i, const Visit& visit)
{
  const Patch& patch = surface.patches[i];
  surface.tree.visit_within(patch.mean, spacings_around * patch.spacing,
                            [&](std::size_t k, double) { visit(surface.tree.order()[k]); });
}

/// Returns how many neighbours of each patch are coplanar with it. O(n).
inline std::vector<std::size_t> coplanar_neighbors(const Patches& patches,
                                                   double least_coplanarity)
{
  std::vector<std::size_t> result;
  for(const Patch& patch : patches)
    result.push_back(static_cast<std::size_t>(
      std::count_if(patch.neighbors.begin(), patch.neighbors.end(), [&](std::size_t j) {
        return coplanarity(patch, patches[j]) >= least_coplanarity;
      })));
  return result;
}

/// Whether patch `i` is on a surface: most pairs of adjacent patches around it are coplanar. A
/// surface with creases looks scattered from afar; a crease leaves about two thirds of the pairs
/// coplanar, scattered leaves and twigs a quarter, and seldom half. O(patches around).
/// \param coplanar `coplanar_neighbors()`
inline bool is_on_surface(const Surface& surface, std::size_t i,
                          const std::vector<std::size_t>& coplanar)
{
  constexpr double most = 2. / 3;
  std::size_t on_surface = 0, all = 0;
  visit_surroundings(surface, i, [&](std::size_t k) {
    on_surface += coplanar[k];
    all += surface.patches[k].neighbors.size();
  });
  return static_cast<double>(on_surface) > most * static_cast<double>(all);
}

/// Returns what each sample is in the middle of. O(n log n).
/// \param least_coplanarity of two patches of one surface, in (0, 1)
inline std::vector<Medial_sample_kind> sample_kinds(const Surface& surface, const Samples& samples,
                                                    double least_coplanarity)
{
  const std::vector<std::size_t> coplanar =
    coplanar_neighbors(surface.patches, least_coplanarity);
  std::vector<Medial_sample_kind> result;
  for(std::size_t i = 0; i < samples.size(); ++i) {
    Medial_sample_kind kind = is_off_surface(samples[i], surface.patches[i])
                                ? Medial_sample_kind::solid
                                : dimensionality_around(surface.patches[i],
                                                        surface.component_tree)
                                    .kind();
    if(kind == Medial_sample_kind::scatter && is_on_surface(surface, i, coplanar))
      kind = Medial_sample_kind::sheet;
    result.push_back(kind);
  }
  return result;
}

/// Whether a patch and the nearest of those adjacent to it are straight.
inline bool is_straight(const Patches& patches, std::size_t i)
{
  std::vector<Vector3> near{Vector3::Zero()};
  for(std::size_t j : patches[i].neighbors)
    near.push_back(patches[j].mean - patches[i].mean);
  const std::size_t number = (std::min)(places_of_line, near.size());
  const auto is_nearer = [](const Vector3& p, const Vector3& q) {
    return p.squaredNorm() < q.squaredNorm();
  };
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(number), near.end(),
                    is_nearer);
  return are_straight(number, [&](std::size_t k) -> const Vector3& { return near[k]; });
}

/// Marks the unresolved patches of twigs. From afar many twigs are scattered: so the nearest
/// neighbours are looked at first. There are no leaves, whatever is scattered there by its kind is
/// of twigs. O(n log n).
inline std::vector<bool> twig_patches(const Surface& surface, const Samples& samples)
{
  const Patches& patches = surface.patches;
  std::vector<bool> result(patches.size(), false);
  std::vector<bool> is_straight_patch;
  for(std::size_t i = 0; i < patches.size(); ++i)
    is_straight_patch.push_back(is_straight(patches, i));
  for(std::size_t i = 0; i < patches.size(); ++i) {
    if(is_off_surface(samples[i], patches[i]))
      continue;
    Straightness straightness;
    visit_surroundings(surface, i, [&](std::size_t k) { straightness.add(is_straight_patch[k]); });
    result[i] = straightness.is_on_lines() ||
                dimensionality_around(patches[i], surface.component_tree).kind() ==
                  Medial_sample_kind::scatter;
  }
  return result;
}

/// Marks the patches of limbs that are not resolved: their other side was not seen, and they are in
/// no sheet. They are what most around them are: at the rim of a sheet there are few patches to see
/// it by, and a scattered leaf may have another by chance where its other side would be.
/// O(n log n).
/// \param least_coplanarity see `sample_kinds()`
inline std::vector<bool> unresolved_patches(const Surface& surface, const Samples& samples,
                                            double least_coplanarity)
{
  const std::vector<Medial_sample_kind> kinds = sample_kinds(surface, samples, least_coplanarity);
  std::vector<bool> result;
  for(std::size_t i = 0; i < kinds.size(); ++i) {
    std::size_t unresolved = 0, all = 0;
    visit_surroundings(surface, i, [&](std::size_t k) {
      const bool seems_unresolved =
        kinds[k] == Medial_sample_kind::line || kinds[k] == Medial_sample_kind::scatter;
      unresolved += seems_unresolved ? 1 : 0;
      ++all;
    });
    result.push_back(2 * unresolved > all);
  }
  return result;
}

/// How many components there are around some patches, within one, two and four spacings.
struct Components_around
{
  double one = 0, two = 0, four = 0;

  void add(const Components_around& other)
  {
    one += other.one;
    two += other.two;
    four += other.four;
  }

  /// The exponent by which their number grows from one spacing to two (correlation dimension,
  /// Grassberger and Procaccia 1983): 1 on lines, 2 on surfaces, 3 in space and if there are none.
  double dimension() const { return one > 0 ? std::log2(two / one) : 3; }

  /// The same from one spacing to four: of a whole cloud, where it depends less on how components
  /// happen to lie.
  double dimension_of_cloud() const { return one > 0 ? std::log2(four / one) / 2 : 3; }
};

/// Returns the components around each marked patch; none around others. O(n log n).
inline std::vector<Components_around> components_around(const Surface& surface,
                                                        const std::vector<bool>& is_marked)
{
  std::vector<Components_around> result(is_marked.size());
  for(std::size_t i = 0; i < is_marked.size(); ++i) {
    if(!is_marked[i])
      continue;
    const double spacing = surface.patches[i].resolution();
    Components_around& around = result[i];
    around = {-1, -1, -1}; // without itself, or one of the components that it consists of
    surface.component_tree.visit_within(surface.patches[i].mean, 4 * spacing,
                                        [&](std::size_t, double squared_distance) {
                                          const double squared = spacing * spacing;
                                          around.one += squared_distance <= squared;
                                          around.two += squared_distance <= 4 * squared;
                                          ++around.four;
                                        });
  }
  return result;
}

/// Limbs that are not resolved, by their patches.
struct Unresolved_limbs
{
  std::vector<bool> is_of_twig; ///< Of twigs thinner than the spacing, in a cloud of such.
  std::vector<bool> is_loose;   ///< Of others.
};

/// Divides unresolved patches into those of twigs and others. Twigs are told by their dimension, in
/// a cloud most of whose patches are not resolved, and less than a surface; a limb as wide as the
/// noise among them is none, nor is one a few points wide. O(n log n).
inline Unresolved_limbs without_twigs(const Surface& surface, const Samples& samples,
                                      std::vector<bool> is_unresolved)
{
  // Of most scanned trees whose twigs are thinner, 1.4 to 1.74; of real trees 1.76 to 1.85, 2.35 to
  // 2.38, however they are turned, of simulated crowns 1.5 to 2.3, of narrow sheets 1.6 to 2.
  constexpr double of_twigs = 1.74, of_surface = 2;
  const std::size_t size = is_unresolved.size();
  Unresolved_limbs result{std::vector<bool>(size, false), std::move(is_unresolved)};
  const std::vector<bool>& loose = result.is_loose;
  const auto unresolved = std::count(loose.begin(), loose.end(), true);
  if(2 * static_cast<std::size_t>(unresolved) <= size)
    return result;
  const std::vector<Components_around> around = components_around(surface, loose);
  Components_around all;
  for(const Components_around& one : around)
    all.add(one);
  if(all.dimension_of_cloud() >= of_twigs)
    return result;
  result.is_of_twig = twig_patches(surface, samples);
  for(std::size_t i = 0; i < size; ++i) {
    if(!result.is_of_twig[i] && !result.is_loose[i])
      continue;
    Components_around here;
    visit_surroundings(surface, i, [&](std::size_t k) { here.add(around[k]); });
    result.is_of_twig[i] = result.is_of_twig[i] && here.dimension() < of_surface;
    result.is_loose[i] = result.is_loose[i] && !result.is_of_twig[i];
  }
  return result;
}

/// Returns the limbs that are not resolved. In a cloud of lines all are twigs. O(n log n).
/// \param least_coplanarity see `sample_kinds()`
inline Unresolved_limbs unresolved_limbs(const Surface& surface, const Samples& samples,
                                         double least_coplanarity)
{
  if(surface.is_of_lines)
    return {twig_patches(surface, samples), std::vector<bool>(samples.size(), false)};
  return without_twigs(surface, samples, unresolved_patches(surface, samples, least_coplanarity));
}

/// Returns the share of the patches that are of limbs that are not resolved, and on no surface; 0 if
/// there is none. A strip a few patches wide looks like a line or scattered from afar, but adjacent
/// patches of it are coplanar. O(n log n).
/// \param least_coplanarity see `sample_kinds()`
inline double share_unresolved(const Surface& surface, const Unresolved_limbs& limbs,
                               double least_coplanarity)
{
  const std::size_t size = limbs.is_loose.size();
  const std::vector<std::size_t> coplanar =
    coplanar_neighbors(surface.patches, least_coplanarity);
  std::size_t unresolved = 0;
  for(std::size_t i = 0; i < size; ++i)
    if((limbs.is_of_twig[i] || limbs.is_loose[i]) && !is_on_surface(surface, i, coplanar))
      ++unresolved;
  return size > 0 ? static_cast<double>(unresolved) / static_cast<double>(size) : 0;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_SAMPLE_KINDS_H
