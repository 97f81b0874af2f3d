// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which candidates come first, compared with all pairs.

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/separators/Waiting_candidates.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <random>
#include <set>
#include <vector>

namespace waiting_candidates_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr std::size_t patches = 40;

std::vector<Local_separator> random_candidates(std::mt19937& random)
{
  std::vector<Local_separator> result(30);
  for(Local_separator& candidate : result) {
    std::set<std::size_t> ring;
    const std::size_t size = 1 + random() % 5;
    while(ring.size() < size)
      ring.insert(random() % patches);
    candidate.patches.assign(ring.begin(), ring.end());
  }
  return result;
}

bool have_common_patch(const Local_separator& a, const Local_separator& b)
{
  std::vector<std::size_t> common;
  std::set_intersection(a.patches.begin(), a.patches.end(), b.patches.begin(), b.patches.end(),
                        std::back_inserter(common));
  return !common.empty();
}

} // namespace

TEST_CASE("Those candidates come first that share no patch with an earlier one that waits")
{
  for(unsigned int seed = 1; seed <= 100; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const std::vector<Local_separator> candidates = random_candidates(random);
    Waiting_candidates waiting(candidates, patches);
    std::set<std::size_t> left, returned;
    for(std::size_t s = 0; s < candidates.size(); ++s)
      left.insert(s);
    while(!left.empty()) {
      std::vector<std::size_t> expected;
      for(std::size_t s : left)
        if(returned.count(s) == 0 && std::none_of(left.begin(), left.find(s), [&](std::size_t t) {
             return have_common_patch(candidates[s], candidates[t]);
           }))
          expected.push_back(s);
      const std::vector<std::size_t> first = waiting.take_first();
      CHECK(first == expected);
      returned.insert(first.begin(), first.end());

      const std::size_t patch = random() % patches;
      expected.clear();
      for(std::size_t s : left)
        if(std::binary_search(candidates[s].patches.begin(), candidates[s].patches.end(), patch))
          expected.push_back(s);
      CHECK(waiting.on_patch(patch) == expected);

      const std::size_t gone = *std::next(left.begin(), random() % left.size());
      waiting.remove(gone, candidates[gone]);
      left.erase(gone);
      CHECK_FALSE(waiting.waits(gone));
    }
    CHECK(waiting.take_first().empty());
  }
}

} // namespace waiting_candidates_test
