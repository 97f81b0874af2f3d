// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which separators are known to cut, compared with a search of the whole graph.

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/separators/Known_cuts.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Local_separator.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Path_search.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace known_cuts_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

/// Rings of three patches one after another. Each is adjacent to the one before, in a tree of rings
/// with a few more links.
class Tree_of_rings
{
public:
  Tree_of_rings(std::size_t rings, std::size_t more, std::mt19937& random)
    : patches(3 * rings), is_linked_(rings)
  {
    for(std::size_t r = 0; r < rings; ++r) {
      link(3 * r, 3 * r + 1);
      link(3 * r + 1, 3 * r + 2);
      if(r > 0)
        join(r, random() % 4 == 0 ? random() % r : r - 1);
    }
    for(; more > 0; --more) {
      const std::size_t a = random() % rings, b = random() % rings;
      if(a != b)
        join(a, b);
    }
  }

  Patch_graph graph()
  {
    std::vector<Patch_pair> pairs;
    for(const auto& [a, b] : links_)
      pairs.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
    return Patch_graph(patches, pairs);
  }

  /// A ring, and those before and behind it in the order of the numbers, on two sides.
  Local_separator separator(std::size_t ring) const
  {
    Local_separator result;
    for(std::size_t k = 0; k < 3; ++k)
      result.patches.push_back(3 * ring + k);
    for(std::size_t other : is_linked_[ring])
      for(std::size_t k = 0; k < 3; ++k)
        result.sides[other < ring ? 0 : 1].push_back(3 * other + k);
    return result;
  }

  Patches patches;

private:
  void link(std::size_t a, std::size_t b)
  {
    if(links_.insert(std::minmax(a, b)).second) {
      patches[a].neighbors.push_back(b);
      patches[b].neighbors.push_back(a);
    }
  }

  void join(std::size_t a, std::size_t b)
  {
    for(std::size_t k = 0; k < 3; ++k)
      link(3 * a + k, 3 * b + k);
    is_linked_[a].insert(b);
    is_linked_[b].insert(a);
  }

  std::set<std::pair<std::size_t, std::size_t>> links_;
  std::vector<std::set<std::size_t>> is_linked_;
};

} // namespace

TEST_CASE("Around a separator that is known to cut there is no path; in a tree all are known")
{
  std::size_t known = 0, unknown = 0, around = 0;
  for(unsigned int seed = 1; seed <= 200; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const std::size_t rings = 2 + random() % 40, more = random() % 4;
    CAPTURE(rings, more);
    Tree_of_rings tree(rings, more, random);
    const Patch_graph graph = tree.graph();
    Path_search search(tree.patches, graph);
    Known_cuts cuts(graph, tree.patches.size());
    std::vector<std::size_t> order(rings);
    for(std::size_t r = 0; r < rings; ++r)
      order[r] = r;
    std::shuffle(order.begin(), order.end(), random);
    for(std::size_t r : order) {
      const Local_separator separator = tree.separator(r);
      const bool is_cut = search.around(separator).empty();
      const bool is_known = cuts.add_if_cuts(separator);
      if(is_known)
        CHECK(is_cut);
      if(more == 0)
        CHECK(is_known == is_cut);
      known += is_known;
      unknown += is_cut && !is_known;
      around += !is_cut;
    }
  }
  CHECK(known > 10 * unknown);
  CHECK(around > 0);
}

} // namespace known_cuts_test
