// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GAUSSIAN_MIXTURE_BUILDER_3_H
#define CGAL_GAUSSIAN_MIXTURE_BUILDER_3_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Bulk_bbox_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Normalization.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/named_parameters.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/public_data.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Grid_mixture.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Moment_grid.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/separate_parts.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Named_function_parameters.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

template <typename Traits, typename ConcurrencyTag>
class L1_medial_skeletonization_3;

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// Takes the points of a cloud chunk after chunk and stores their moments only, so that a cloud
/// larger than memory can be skeletonised: pass it to `extract_l1_medial_skeleton()`,
/// `L1_medial_skeletonization_3` or `fit_gaussian_mixture()` in place of the points.
///
/// The moments are those of the cells of a grid over a given box. When 524 288 cells are
/// occupied, 2 x 2 x 2 are merged into one, which is exact. So memory is bounded by about 200 MB
/// for any number of points, up to 2^40.
///
/// Points are rounded to a 2^44th of the box's diagonal, and their sums are integers. So the result
/// does not depend, bit for bit, on the order of the points, on how they are divided into chunks or
/// among builders (one per thread or machine), nor on how builders are merged. With the box of
/// `Bulk_bbox_3` it is that of the whole range given at once.
///
/// `CGAL/IO/Gaussian_mixture_builder_3.h` writes and reads builders. They can also be serialised by
/// Boost.Serialization, after `boost/serialization/array.hpp` is included.
///
/// \tparam Traits a model of `L1MedialSkeletonizationTraits_3`
template <typename Traits>
class Gaussian_mixture_builder_3
{
  using Normalization = Point_set_skeletonization_3::internal::Normalization;
  using Vector3 = Point_set_skeletonization_3::internal::Vector3;

public:
  using FT = typename Traits::FT;
  using Point_3 = typename Traits::Point_3;

  /// The default of `maximum_cells`.
  static constexpr std::size_t default_maximum_cells =
    Point_set_skeletonization_3::internal::Grid_options::default_maximum_cells;

  /// Of an empty box, to be replaced by another one.
  Gaussian_mixture_builder_3() : Gaussian_mixture_builder_3(Bbox_3()) {}

  /// \param box contains all points, best their bounding box. A larger one gives a coarser grid: no
  ///        cell is narrower than 1/4096 of the diagonal, or with twice as many `maximum_cells` half
  ///        of that, down to 1/65536. An empty box contains no points.
  /// \param maximum_cells greatest number of components of the mixture, in [1000, 2^26]. Four times
  ///        as many cells are stored, of about 350 bytes each.
  /// \throws std::invalid_argument if the box is not finite, or a least coordinate greater than the
  ///         greatest
  explicit Gaussian_mixture_builder_3(const Bbox_3& box,
                                      std::size_t maximum_cells = default_maximum_cells)
    : box_(box), normalization_(normalization_of(box)), moments_(fine_cells(maximum_cells))
  {}

  /// The same for the box of the bulk of the points: those outside are not refused, but counted as
  /// outliers.
  explicit Gaussian_mixture_builder_3(const Bulk_bbox_3<Traits>& bulk,
                                      std::size_t maximum_cells = default_maximum_cells)
    : Gaussian_mixture_builder_3(bulk.bbox(), maximum_cells)
  {
    leaves_out_far_ = true;
  }

  /// Adds the points of a range, which is read once. O(1) amortised per point.
  /// \param points the range
  /// \param np
  ///   \cgalNamedParamsBegin
  ///     \cgalParamNBegin{point_map} \cgalParamDescription{gives the `Point_3` of an element}
  ///       \cgalParamDefault{`Identity_property_map`} \cgalParamNEnd
  ///   \cgalNamedParamsEnd
  /// \throws std::invalid_argument if a coordinate is not finite or a point outside the box. The
  ///         message names the point by its number in the order of insertion; the points before it
  ///         stay inserted.
  template <typename PointRange, typename NamedParameters = parameters::Default_named_parameters>
  void insert(const PointRange& points, const NamedParameters& np = parameters::default_values())
  {
    namespace internal = Point_set_skeletonization_3::internal;
    static_assert(internal::Maps_to_points<PointRange, NamedParameters>::value,
                  "the elements of the range are not 3D points: pass point_map(MAP)");
    if constexpr(internal::Maps_to_points<PointRange, NamedParameters>::value) {
      const auto map = internal::point_map_of(points, np);
      for(const auto& item : points)
        insert(get(map, item));
    }
  }

  /// Adds one point.
  /// \throws std::invalid_argument as above
  void insert(const Point_3& point)
  {
    namespace internal = Point_set_skeletonization_3::internal;
    const auto [x, y, z] = internal::to_plain(point);
    const Vector3 p(x, y, z);
    if(!p.allFinite())
      fail("has a coordinate that is not finite; remove or repair it");
    const bool inside = box_.xmin() <= p.x() && p.x() <= box_.xmax() && //
                        box_.ymin() <= p.y() && p.y() <= box_.ymax() && //
                        box_.zmin() <= p.z() && p.z() <= box_.zmax();
    if(!inside && !leaves_out_far_)
      fail("is outside the given box; enlarge the box");
    if(inside)
      moments_.add(internal::lattice_point(normalization_.to_unit(p)));
    else
      ++number_of_far_;
    ++number_of_points_;
  }

  /// Notes where points come from, for instance the name of a file: so that nothing is counted
  /// twice.
  /// \returns whether that was not noted before
  bool insert_source(const std::string& name) { return sources_.insert(name).second; }

  /// What was noted.
  const std::set<std::string>& sources() const { return sources_; }

  /// Adds the points of another builder. O(cells).
  /// \throws std::invalid_argument if `other` has another box or another `maximum_cells`, or a
  ///         source of this one; then this one is unchanged
  void merge(const Gaussian_mixture_builder_3& other)
  {
    if(other.box_ != box_ || other.leaves_out_far_ != leaves_out_far_)
      throw std::invalid_argument("it has another box");
    if(other.moments_.maximum_cells() != moments_.maximum_cells())
      throw std::invalid_argument("it has another bound on the number of cells");
    for(const std::string& source : other.sources_)
      if(sources_.count(source) > 0)
        throw std::invalid_argument("it has '" + source + "' as well, which would count twice");
    sources_.insert(other.sources_.begin(), other.sources_.end());
    moments_.add(other.moments_);
    number_of_points_ += other.number_of_points_;
    number_of_far_ += other.number_of_far_;
  }

  /// The parts that do not touch, such as the trees of a plot without its ground, the largest
  /// first: for skeletons of their own. There is a gap around each, four times as wide as the cells
  /// of `fit_gaussian_mixture()`. Strays, with less than a hundredth of the points of the largest
  /// part, are left out. A part has the box of all, and no sources. O(cells log cells).
  std::vector<Gaussian_mixture_builder_3> split() const
  {
    constexpr std::int32_t gap = 4;      // thin twigs have a few empty cells
    constexpr double stray_share = 0.01; // as in one skeleton of all
    std::vector<Gaussian_mixture_builder_3> result;
    for(auto& part :
        Point_set_skeletonization_3::internal::separate_parts(moments_, gap, stray_share)) {
      result.emplace_back(box_);
      result.back().sources_.clear();
      result.back().number_of_far_ = 0;
      result.back().number_of_points_ = part.size();
      result.back().moments_ = std::move(part);
    }
    return result;
  }

  const Bbox_3& box() const { return box_; }

  /// Number of cells stored.
  std::size_t number_of_cells() const { return moments_.cells().size(); }

  /// Number of points inserted, those far from all others included.
  std::size_t number_of_points() const { return number_of_points_; }

  /// Writes or reads the builder, for archives as those of Boost.Serialization. O(cells log cells).
  template <typename Archive>
  void serialize(Archive& archive, unsigned int version)
  {
    if constexpr(Archive::is_loading::value)
      load(archive, version);
    else
      save(archive, version);
  }

  /// The writing half of `serialize()`.
  template <typename Archive>
  void save(Archive& archive, unsigned int version) const
  {
    const std::array<double, 6> box = {
      {box_.xmin(), box_.ymin(), box_.zmin(), box_.xmax(), box_.ymax(), box_.zmax()}};
    archive& box;
    archive& std::uint64_t(leaves_out_far_ ? 1 : 0);
    archive& std::uint64_t(number_of_points_);
    archive& std::uint64_t(number_of_far_);
    archive& std::uint64_t(sources_.size());
    for(const std::string& source : sources_)
      archive& source;
    moments_.save(archive, version);
  }

  /// The reading half. \throws std::runtime_error if it was no builder that was written
  template <typename Archive>
  void load(Archive& archive, unsigned int version)
  {
    std::array<double, 6> box;
    std::uint64_t leaves_out_far, number_of_points, number_of_far, number_of_sources;
    archive& box;
    archive& leaves_out_far;
    archive& number_of_points;
    archive& number_of_far;
    archive& number_of_sources;
    std::set<std::string> sources;
    for(std::string source; number_of_sources > 0; --number_of_sources) {
      archive& source;
      sources.insert(source);
    }
    moments_.load(archive, version);
    box_ = Bbox_3(box[0], box[1], box[2], box[3], box[4], box[5]);
    normalization_ = normalization_of(box_);
    leaves_out_far_ = leaves_out_far != 0;
    number_of_points_ = static_cast<std::size_t>(number_of_points);
    number_of_far_ = static_cast<std::size_t>(number_of_far);
    sources_ = std::move(sources);
  }

private:
  template <typename T, typename ConcurrencyTag>
  friend class L1_medial_skeletonization_3;

  static std::size_t fine_cells(std::size_t maximum_cells)
  {
    Point_set_skeletonization_3::internal::Grid_options options;
    options.limit_cells(maximum_cells);
    return options.maximum_fine_cells();
  }

  static Normalization normalization_of(const Bbox_3& box)
  {
    if(box == Bbox_3()) // empty
      return Normalization();
    const Vector3 lower(box.xmin(), box.ymin(), box.zmin());
    const Vector3 upper(box.xmax(), box.ymax(), box.zmax());
    if(!(lower.array() <= upper.array()).all())
      throw std::invalid_argument("the box of the points is no box: a least coordinate is greater "
                                  "than the greatest, or no number");
    if(!lower.allFinite() || !upper.allFinite())
      throw std::invalid_argument("the box of the points is not finite");
    return Normalization(lower, upper);
  }

  [[noreturn]] void fail(const std::string& why) const
  {
    throw std::invalid_argument("point " + std::to_string(number_of_points()) + ' ' + why);
  }

  Bbox_3 box_;
  Normalization normalization_;
  std::size_t number_of_points_ = 0;
  bool leaves_out_far_ = false;
  std::size_t number_of_far_ = 0; ///< Of the points.
  std::set<std::string> sources_;
  Point_set_skeletonization_3::internal::Moment_grid moments_;
};

} // namespace CGAL

#endif // CGAL_GAUSSIAN_MIXTURE_BUILDER_3_H
