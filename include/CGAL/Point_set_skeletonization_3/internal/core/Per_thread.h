// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PER_THREAD_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PER_THREAD_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/combinable.h>
#endif

#include <type_traits>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// An object of every thread, for the body of a `parallel_for()` to work with. Which thread's it was
/// must not matter to the result.
template <typename ConcurrencyTag, typename Object, typename = void>
class Per_thread
{
public:
  /// `make()` makes one.
  template <typename Make>
  explicit Per_thread(const Make& make) : object_(make())
  {}

  Object& local() { return object_; }

  /// Calls `visit(object)` for each there is.
  template <typename Visit>
  void for_each(const Visit& visit)
  {
    visit(object_);
  }

private:
  Object object_;
};

#ifdef CGAL_LINKED_WITH_TBB
template <typename ConcurrencyTag, typename Object>
class Per_thread<ConcurrencyTag, Object,
                 std::enable_if_t<std::is_convertible<ConcurrencyTag, Parallel_tag>::value>>
{
public:
  template <typename Make>
  explicit Per_thread(const Make& make) : objects_(make)
  {}

  Object& local() { return objects_.local(); }

  template <typename Visit>
  void for_each(const Visit& visit)
  {
    objects_.combine_each(visit);
  }

private:
  tbb::combinable<Object> objects_;
};
#endif

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PER_THREAD_H
