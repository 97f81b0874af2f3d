// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Stands in for the header of TBB in the preset `threads`, see parallel_for.h.

#ifndef POINT_SET_SKELETONIZATION_3_TEST_THREAD_SANITIZER_COMBINABLE_H
#define POINT_SET_SKELETONIZATION_3_TEST_THREAD_SANITIZER_COMBINABLE_H

#include <atomic>
#include <functional>
#include <thread>

namespace tbb {

/// An object per thread, in a list that only grows. No lock: it would order what threads do between
/// two calls, and so hide that nothing else does.
template <typename Object>
class combinable
{
  struct Node
  {
    std::thread::id thread;
    Object object;
    Node* next;
  };

public:
  explicit combinable(const std::function<Object()>& make) : make_(make) {}
  combinable(const combinable&) = delete;
  combinable& operator=(const combinable&) = delete;

  ~combinable()
  {
    for(Node* node = first_; node;) {
      Node* const next = node->next;
      delete node;
      node = next;
    }
  }

  Object& local()
  {
    const std::thread::id thread = std::this_thread::get_id();
    for(Node* node = first_.load(std::memory_order_acquire); node; node = node->next)
      if(node->thread == thread)
        return node->object;
    Node* const node = new Node{thread, make_(), first_.load(std::memory_order_relaxed)};
    while(!first_.compare_exchange_weak(node->next, node, std::memory_order_release))
      ;
    return node->object;
  }

  template <typename Visit>
  void combine_each(const Visit& visit)
  {
    for(Node* node = first_; node; node = node->next)
      visit(node->object);
  }

private:
  std::function<Object()> make_;
  std::atomic<Node*> first_ = nullptr;
};

} // namespace tbb

#endif // POINT_SET_SKELETONIZATION_3_TEST_THREAD_SANITIZER_COMBINABLE_H
