// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "contestants.h"

#include "for_each_point.h"
#include "methods/alpha_wrap.h"
#include "methods/mcf.h"

#include <CGAL/Gaussian_mixture_builder_3.h>
#include <CGAL/L1_medial_skeletonization_3.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/spatial_sort.h>
#include <CGAL/wlop_simplify_and_regularize_point_set.h>

#include <boost/graph/adjacency_list.hpp>

#include <functional>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace {

struct Bare_vertex
{
  Point point{0, 0, 0};
  double radius = 0;
};

/// A skeleton whose vertices do not know their points.
using Bare_skeleton =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Bare_vertex>;

/// `forget()` is called as soon as the points are not needed any more.
template <typename ConcurrencyTag, typename Graph = Skeleton, typename Points>
void skeletonize(
    const Points& points, Stopwatch& stopwatch, const std::function<void()>& forget = [] {})
{
  using Skeletonization = CGAL::L1_medial_skeletonization_3<Kernel, ConcurrencyTag>;
  Skeletonization steps(points);
  stopwatch.stage("mixture", [&] { steps.fit_mixture(); });
  forget();
  stopwatch.stage("projection", [&] { steps.project(); });
  stopwatch.stage("linking", [&] { steps.link(); });
  Graph skeleton;
  stopwatch.stage("skeleton", [&] { std::move(steps).extract_skeleton(skeleton); });
}

/// Keeps a result from being optimised away.
void use(double result)
{
  volatile double sink = result;
  (void)sink;
}

} // namespace

void skeletonize_points(const std::vector<Point>& points, std::size_t threads,
                        Stopwatch& stopwatch)
{
  if(threads == 1) {
    skeletonize<CGAL::Sequential_tag>(points, stopwatch);
    return;
  }
#ifdef CGAL_LINKED_WITH_TBB
  skeletonize<CGAL::Parallel_tag>(points, stopwatch);
#else
  throw std::runtime_error("built without TBB");
#endif
}

void skeletonize_bare(const std::vector<Point>& points, Stopwatch& stopwatch)
{
  skeletonize<CGAL::Sequential_tag, Bare_skeleton>(points, stopwatch);
}

void skeletonize_stream(const std::string& file, Stopwatch& stopwatch)
{
  const auto box = stopwatch.stage("extent", [&] { return bulk_of_files<Point>({file}); });
  CGAL::Gaussian_mixture_builder_3<Kernel> builder(box);
  stopwatch.stage("moments", [&] {
    for_each_point<Point>(file, [&builder](const Point& p) { builder.insert(p); });
  });
  skeletonize<CGAL::Sequential_tag>(builder, stopwatch, [&builder] { builder = {}; });
}

void flow_mesh(const std::vector<Mesh>& components, Stopwatch& stopwatch)
{
  Method_input input;
  input.components = components;
  stopwatch.stage("skeleton", [&] { mcf(input); });
}

void wrap_and_flow(const std::vector<Point>& points, Stopwatch& stopwatch)
{
  const std::vector<Mesh> wrap = stopwatch.stage("wrap", [&] { return alpha_wrap(points); });
  flow_mesh(wrap, stopwatch);
}

void wlop(const std::vector<Point>& points, Stopwatch& stopwatch)
{
  std::vector<Point> copy = points; // it is reordered
  std::vector<Point> result;
  stopwatch.stage("projection", [&] {
    CGAL::wlop_simplify_and_regularize_point_set<CGAL::Sequential_tag>(
        copy, std::back_inserter(result)); // the defaults: 5 %, 8 spacings, 35 iterations
  });
}

void neighbor_queries(const std::vector<Point>& points, Stopwatch& stopwatch)
{
  using Search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel>>;
  constexpr unsigned int neighbors = 16;
  std::vector<Point> sorted = points;
  stopwatch.stage("sort", [&] { CGAL::spatial_sort(sorted.begin(), sorted.end()); });
  Search::Tree tree(sorted.begin(), sorted.end());
  stopwatch.stage("tree", [&] { tree.build(); });
  stopwatch.stage("queries", [&] {
    double sum = 0;
    for(const Point& p : sorted)
      for(const auto& neighbor : Search(tree, p, neighbors))
        sum += neighbor.second;
    use(sum);
  });
}
