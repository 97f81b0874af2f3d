// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_PATCH_GROUPS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_PATCH_GROUPS_H

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A partition of the components of a mixture: each group becomes one patch.
class Patch_groups
{
public:
  /// Each of `size` components is a group.
  explicit Patch_groups(std::size_t size = 0) : group_of_(size), size_(size)
  {
    std::iota(group_of_.begin(), group_of_.end(), std::size_t(0));
    sort_members();
  }

  /// `group_of[i]` is the group of component i, below `size`. O(components).
  Patch_groups(std::vector<std::size_t> group_of, std::size_t size)
    : group_of_(std::move(group_of)), size_(size)
  {
    sort_members();
  }

  /// Number of groups.
  std::size_t size() const { return size_; }

  /// The group of each component.
  const std::vector<std::size_t>& group_of() const { return group_of_; }

  /// The components of a group, ascending.
  struct Members
  {
    const std::size_t *first, *last;
    const std::size_t* begin() const { return first; }
    const std::size_t* end() const { return last; }
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
  };
  Members operator[](std::size_t group) const
  {
    return {members_.data() + first_[group], members_.data() + first_[group + 1]};
  }

private:
  /// Counting sort.
  void sort_members()
  {
    first_.assign(size_ + 2, 0);
    for(std::size_t g : group_of_)
      ++first_[g + 2];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    members_.resize(group_of_.size());
    for(std::size_t i = 0; i < group_of_.size(); ++i)
      members_[first_[group_of_[i] + 1]++] = i;
  }

  std::vector<std::size_t> group_of_;
  std::size_t size_;
  std::vector<std::size_t> first_;   ///< Place of the first member of each group.
  std::vector<std::size_t> members_; ///< Of one group after the other.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_PATCH_GROUPS_H
