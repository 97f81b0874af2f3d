// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The compiled part of the Python package `point_set_skeletonization`.

#include "Array_points.h"
#include "run_with_progress.h"

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Gaussian_mixture_builder_3.h>
#include <CGAL/IO/Curve_skeleton_3.h>
#include <CGAL/IO/Gaussian_mixture_builder_3.h>
#include <CGAL/Point_set_skeletonization_3/parameters.h>
#include <CGAL/Point_set_skeletonization_3/published_parameters.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/extract_published_l1_medial_skeleton.h>
#include <CGAL/skeleton_branches.h>

#include <CGAL/Bbox_3.h>

#include <boost/range/counting_range.hpp>
#include <boost/range/iterator_range.hpp>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;
using namespace pybind11::literals;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Graph = CGAL::Curve_skeleton_3<Kernel>;
using Branch = CGAL::Skeleton_branch_of<Graph>;
using Builder = CGAL::Gaussian_mixture_builder_3<Kernel>;
using Roots = std::vector<std::size_t>;
template <typename Number>
using Array = py::array_t<Number>;

/// The name of a file that is given as str or as os.PathLike.
std::string name_of(const py::object& filename)
{
  return py::str(py::module_::import("os").attr("fspath")(filename));
}

struct Skeleton
{
  Graph graph;
  std::size_t points = 0;

  void check_roots(const Roots& roots) const
  {
    for(std::size_t v : roots)
      if(v >= num_vertices(graph))
        throw py::value_error("root " + std::to_string(v) + " is no vertex: there are " +
                              std::to_string(num_vertices(graph)));
  }

  std::vector<Branch> branches(const Roots& roots = {}) const
  {
    check_roots(roots);
    return CGAL::skeleton_branches(graph, roots);
  }

  Array<double> vertices() const
  {
    Array<double> result({py::ssize_t(num_vertices(graph)), py::ssize_t(3)});
    auto rows = result.mutable_unchecked<2>();
    for(std::size_t v = 0; v < num_vertices(graph); ++v)
      for(int k = 0; k < 3; ++k)
        rows(py::ssize_t(v), k) = graph[v].point[k];
    return result;
  }

  Array<double> radius() const
  {
    Array<double> result(py::ssize_t(num_vertices(graph)));
    for(std::size_t v = 0; v < num_vertices(graph); ++v)
      result.mutable_at(v) = graph[v].radius;
    return result;
  }

  Array<std::int64_t> edges() const
  {
    Array<std::int64_t> result({py::ssize_t(num_edges(graph)), py::ssize_t(2)});
    auto rows = result.mutable_unchecked<2>();
    py::ssize_t row = 0;
    for(const auto e : boost::make_iterator_range(boost::edges(graph))) {
      rows(row, 0) = std::int64_t(source(e, graph));
      rows(row++, 1) = std::int64_t(target(e, graph));
    }
    return result;
  }

  Array<std::int64_t> point_map() const
  {
    Array<std::int64_t> result{py::ssize_t(points)};
    auto vertex = result.mutable_unchecked<1>();
    for(py::ssize_t i = 0; i < vertex.shape(0); ++i)
      vertex(i) = -1;
    for(std::size_t v = 0; v < num_vertices(graph); ++v)
      for(std::size_t i : graph[v].indices)
        vertex(py::ssize_t(i)) = std::int64_t(v);
    return result;
  }

  py::object to_networkx() const
  {
    py::object result = py::module_::import("networkx").attr("Graph")();
    for(std::size_t v = 0; v < num_vertices(graph); ++v) {
      const auto& p = graph[v].point;
      result.attr("add_node")(v, "x"_a = p.x(), "y"_a = p.y(), "z"_a = p.z(),
                              "radius"_a = graph[v].radius);
    }
    const std::vector<Branch> all = branches();
    for(std::size_t b = 0; b < all.size(); ++b)
      for(std::size_t i = 1; i < all[b].vertices.size(); ++i) {
        const std::size_t v = all[b].vertices[i - 1], w = all[b].vertices[i];
        const double length = std::sqrt(CGAL::squared_distance(graph[v].point, graph[w].point));
        result.attr("add_edge")(v, w, "branch"_a = b, "axis"_a = all[b].axis,
                                "order"_a = all[b].order, "length"_a = length);
      }
    return result;
  }

  void save(const py::object& filename, const Roots& roots) const
  {
    check_roots(roots);
    const std::string name = name_of(filename);
    const py::gil_scoped_release unlock;
    CGAL::IO::write_curve_skeleton(name, graph, roots);
  }
};

/// Calls `run(callback)` as `run_with_progress()` does, with so many threads.
template <typename Run>
void run_with_threads(std::optional<int> threads, const py::object& progress, const Run& run)
{
  if(threads && *threads < 1)
    throw py::value_error("threads must be at least 1, not " + std::to_string(*threads));
#ifdef CGAL_LINKED_WITH_TBB
  std::optional<tbb::global_control> control;
  if(threads)
    control.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(*threads));
#endif
  run_with_progress(progress, run);
}

/// Returns `visit(rows, map)` for the rows of a `to_point_array()` and the map to points.
template <typename Visit>
auto visit_rows(const py::array& array, const Visit& visit)
{
  const auto rows = boost::counting_range(std::size_t(0), std::size_t(array.shape(0)));
  return array.itemsize() == sizeof(float) ? visit(rows, Array_points<float>(array))
                                           : visit(rows, Array_points<double>(array));
}

/// Calls `extract(rows, map, skeleton, callback)`.
template <typename Extract>
Skeleton extract_from(const py::object& points, std::optional<int> threads,
                      const py::object& progress, const Extract& extract)
{
  const py::array array = to_point_array(points);
  Skeleton result;
  result.points = static_cast<std::size_t>(array.shape(0));
  run_with_threads(threads, progress, [&](const std::function<bool(double)>& callback) {
    return visit_rows(array, [&](const auto& rows, const auto& map) {
      return extract(rows, map, result.graph, callback);
    });
  });
  return result;
}

using Real = std::optional<double>;
using Count = std::optional<std::size_t>;

/// \throw pybind11::value_error if a number is not in the range of its named parameter
template <typename Number>
void check(const char* name, const std::optional<Number>& value, bool is_in_range,
           const char* range)
{
  if(value && !is_in_range)
    throw py::value_error(std::string(name) + " must be " + range + ", not " +
                          std::string(py::str(py::cast(*value))));
}

void check_cells(std::size_t maximum_cells)
{
  check("maximum_cells", Count(maximum_cells),
        maximum_cells >= 1000 && maximum_cells <= std::size_t(1) << 26, "in [1000, 2^26]");
}

void check_feature(Real smallest_feature)
{
  check("smallest_feature", smallest_feature,
        smallest_feature > 0. && std::isfinite(*smallest_feature), "more than 0, and finite");
}

Skeleton skeletonize(const py::object& points, bool single_component, bool is_tree,
                     std::size_t maximum_cells, Real smallest_feature, std::optional<int> threads,
                     const py::object& progress)
{
  check_cells(maximum_cells);
  check_feature(smallest_feature);
  return extract_from(
      points, threads, progress,
      [&](const auto& rows, const auto& map, Graph& graph, const auto& callback) {
        namespace p = CGAL::parameters;
        const auto common = p::point_map(map).geom_traits(Kernel()).callback(callback);
        const auto topology = p::single_component(single_component, p::is_tree(is_tree, common));
        return CGAL::extract_l1_medial_skeleton<CGAL::Parallel_if_available_tag>(
            rows, graph,
            p::maximum_cells(maximum_cells, p::smallest_feature(smallest_feature, topology)));
      });
}

Skeleton skeletonize_as_published(const py::object& points, bool tuned, bool halt,
                                  Count number_of_iterations, unsigned int random_seed, Real h_0,
                                  Real delta_h, Real mu, Count samples, Real alpha, Count levels,
                                  Real flatness, Real sample_flatness, Real alpha_min, Count b_min,
                                  Real d_max, std::optional<int> threads,
                                  const py::object& progress)
{
  check("h_0", h_0, h_0 >= 1e-4 && h_0 <= 1e4, "in [0.0001, 10000]");
  check("delta_h", delta_h, delta_h >= 0., "at least 0");
  check("mu", mu, mu >= 0. && mu < 0.5, "in [0, 0.5)");
  check("samples", samples, samples >= std::size_t(1), "at least 1");
  check("alpha", alpha, alpha > 0., "more than 0");
  check("flatness", flatness, flatness > 0., "more than 0");
  check("sample_flatness", sample_flatness, sample_flatness > 0., "more than 0");
  check("alpha_min", alpha_min, alpha_min >= 0. && alpha_min < 180., "in [0, 180)");
  check("b_min", b_min, b_min >= std::size_t(2), "at least 2");
  check("d_max", d_max, d_max > 0., "more than 0");
  return extract_from(
      points, threads, progress,
      [&](const auto& rows, const auto& map, Graph& graph, const auto& callback) {
        namespace p = CGAL::parameters::published;
        const auto common = CGAL::parameters::point_map(map)
                                .geom_traits(Kernel())
                                .callback(callback)
                                .random_seed(random_seed)
                                .number_of_iterations(number_of_iterations);
        const auto mixtures = p::alpha(
            alpha,
            p::levels(levels, p::flatness(flatness, p::sample_flatness(sample_flatness, common))));
        const auto projection = p::h_0(
            h_0, p::delta_h(delta_h, p::mu(mu, p::halt(halt, p::samples(samples, mixtures)))));
        return CGAL::extract_published_l1_medial_skeleton<CGAL::Parallel_if_available_tag>(
            rows, graph,
            p::tuned(tuned, p::alpha_min(alpha_min, p::b_min(b_min, p::d_max(d_max, projection)))));
      });
}

using Box = std::array<double, 6>;

Builder new_builder(const Box& box, std::size_t maximum_cells)
{
  check_cells(maximum_cells);
  return Builder(CGAL::Bbox_3(box[0], box[1], box[2], box[3], box[4], box[5]), maximum_cells);
}

void insert(Builder& builder, const py::object& points, const std::optional<std::string>& source)
{
  if(source && builder.sources().count(*source) > 0)
    throw py::value_error("it has '" + *source + "' already");
  const py::array array = to_point_array(points);
  const py::gil_scoped_release unlock;
  visit_rows(array, [&](const auto& rows, const auto& map) {
    builder.insert(rows, CGAL::parameters::point_map(map));
  });
  if(source)
    builder.insert_source(*source);
}

Builder load(const py::object& filename)
{
  const std::string name = name_of(filename);
  const py::gil_scoped_release unlock;
  Builder result;
  CGAL::IO::read_moments(name, result);
  return result;
}

void save(const Builder& builder, const py::object& filename)
{
  const std::string name = name_of(filename);
  const py::gil_scoped_release unlock;
  CGAL::IO::write_moments(name, builder);
}

py::bytes bytes_of(const Builder& builder)
{
  std::ostringstream stream;
  CGAL::IO::write_moments(stream, builder);
  return stream.str();
}

Builder builder_of(const py::bytes& bytes)
{
  std::istringstream stream{std::string(bytes)};
  Builder result;
  CGAL::IO::read_moments(stream, result);
  return result;
}

Skeleton skeletonize_builder(const Builder& builder, bool single_component, bool is_tree,
                             Real smallest_feature, std::optional<int> threads,
                             const py::object& progress)
{
  check_feature(smallest_feature);
  Skeleton result;
  run_with_threads(threads, progress, [&](const std::function<bool(double)>& callback) {
    namespace p = CGAL::parameters;
    const auto common = p::geom_traits(Kernel()).callback(callback);
    const auto topology = p::single_component(single_component, p::is_tree(is_tree, common));
    return CGAL::extract_l1_medial_skeleton<CGAL::Parallel_if_available_tag>(
        builder, result.graph, p::smallest_feature(smallest_feature, topology));
  });
  return result;
}

} // namespace

PYBIND11_MODULE(_core, module)
{
  module.attr("__version__") = VERSION;

  py::class_<Branch>(module, "Branch",
                     "A path between two vertices whose degree is not 2, or a whole cycle, or a "
                     "lone vertex. Lengths are in the unit of the points.")
      .def_property_readonly(
          "vertices", [](const Branch& b) { return Array<std::int64_t>(py::cast(b.vertices)); },
          "vertices of the path, from the end nearer to the root, int64; closed: first = last")
      .def_property_readonly(
          "parent",
          [](const Branch& b) {
            return b.parent == Branch::none ? std::nullopt : std::optional(b.parent);
          },
          "number of the branch that leads here from the root; None if this starts at the root")
      .def_readonly("axis", &Branch::axis, "number of the limb: it goes on through junctions")
      .def_readonly("order", &Branch::order, "number of axes between this one and the root")
      .def_readonly("closes_cycle", &Branch::closes_cycle,
                    "whether both ends are reached from the root without it")
      .def_readonly("length", &Branch::length, "length of the path")
      .def_readonly("chord", &Branch::chord, "distance of its ends")
      .def_readonly("mean_radius", &Branch::mean_radius, "mean along the path")
      .def_readonly("volume", &Branch::volume, "of truncated cones, one per edge")
      .def_readonly("angle", &Branch::angle,
                    "to the parent, in degrees, 0 is straight on; nan if there is no parent")
      .def("__repr__", [](const Branch& b) {
        return "<Branch of order " + std::to_string(b.order) + " with " +
               std::to_string(b.vertices.size()) + " vertices>";
      });

  py::class_<Skeleton>(module, "Skeleton", "A curve skeleton: an undirected graph in space.")
      .def_property_readonly("vertices", &Skeleton::vertices, "positions, float64, shape (v, 3)")
      .def_property_readonly("radius", &Skeleton::radius,
                             "distance of each vertex to the surface, float64, shape (v,)")
      .def_property_readonly("edges", &Skeleton::edges, "pairs of vertices, int64, shape (e, 2)")
      .def_property_readonly(
          "point_map", &Skeleton::point_map,
          "vertex of each point, -1 for an outlier, int64, shape (n,): groups points by vertex")
      .def_property_readonly(
          "branches", [](const Skeleton& s) { return s.branches(); },
          "branches from the lowest end (least z) outwards, parents before children")
      .def("branches_from", &Skeleton::branches, "roots"_a,
           "Branches from these vertices outwards; components without one start at their lowest "
           "end. Raises ValueError if a root is no vertex.")
      .def("to_networkx", &Skeleton::to_networkx,
           "A networkx.Graph: nodes with x, y, z and radius, edges with branch, axis, order and "
           "length.")
      .def("save", &Skeleton::save, "filename"_a, "roots"_a = Roots(),
           "Writes a file in the format that its ending chooses: .polylines.txt, .obj, .ply, .vtp, "
           ".graphml, .swc, .dxf, .csv (cylinders), .off or .tubes.ply (tubes). Raises RuntimeError "
           "if that fails.")
      .def("__repr__", [](const Skeleton& s) {
        return "<Skeleton of " + std::to_string(num_vertices(s.graph)) + " vertices and " +
               std::to_string(num_edges(s.graph)) + " edges>";
      });

  py::class_<Builder>(module, "MixtureBuilder",
                      R"(The moments of points that are inserted chunk after chunk: for clouds
larger than memory or than one machine; see the page on large clouds in the manual.

box: xmin, ymin, zmin, xmax, ymax, zmax; contains all points, best their bounding box.
maximum_cells: as for skeletonize(). Four times as many cells are stored, of some 350 bytes each.

The result is the same, bit for bit, for any order of the points, any chunks and any merging. It
can be pickled, so that Dask and multiprocessing send it as it is. Raises ValueError if the box is
none. Not to be changed by two threads at once.)")
      .def(py::init(&new_builder), "box"_a, py::kw_only(),
           "maximum_cells"_a = Builder::default_maximum_cells)
      .def("insert", &insert, "points"_a, py::kw_only(), "source"_a = py::none(),
           R"(Adds points: an array as for skeletonize(). O(n).

source: where they come from, for instance the name of a file; so that none is counted twice.

Raises ValueError if the source was inserted before, or a coordinate is not finite or outside of the
box; the message names the point by its number among all inserted, and those before it stay.)")
      .def("merge", &Builder::merge, "other"_a, py::call_guard<py::gil_scoped_release>(),
           "Adds the points of another builder. O(cells). Raises ValueError if it has another box, "
           "another maximum_cells, or a source of this one.")
      .def("save", &save, "filename"_a,
           "Writes a file of moments, complete or not at all: .moments, as the program reads and "
           "writes. Raises RuntimeError if that fails.")
      .def_static("load", &load, "filename"_a,
                  "Reads a file of moments. Raises RuntimeError that says what is wrong with it.")
      .def("skeletonize", &skeletonize_builder, py::kw_only(), "single_component"_a = false,
           "is_tree"_a = false, "smallest_feature"_a = py::none(), "threads"_a = py::none(),
           "progress"_a = py::none(),
           "Extracts the curve skeleton; parameters as for skeletonize(). Its point_map is empty.")
      .def_property_readonly(
          "box",
          [](const Builder& b) {
            return Box{{b.box().xmin(), b.box().ymin(), b.box().zmin(), b.box().xmax(),
                        b.box().ymax(), b.box().zmax()}};
          },
          "xmin, ymin, zmin, xmax, ymax, zmax")
      .def_property_readonly("sources", &Builder::sources, "the sources inserted")
      .def_property_readonly("number_of_points", &Builder::number_of_points, "points inserted")
      .def_property_readonly("number_of_cells", &Builder::number_of_cells, "cells stored")
      .def(py::pickle(&bytes_of, &builder_of))
      .def("__repr__", [](const Builder& b) {
        return "<MixtureBuilder of " + std::to_string(b.number_of_points()) + " points in " +
               std::to_string(b.number_of_cells()) + " cells>";
      });

  module.def("skeletonize", &skeletonize, "points"_a, py::kw_only(), "single_component"_a = false,
             "is_tree"_a = false, "maximum_cells"_a = 131072, "smallest_feature"_a = py::none(),
             "threads"_a = py::none(), "progress"_a = py::none(),
             R"(Extracts the curve skeleton of a point cloud.

points: array of shape (n, 3), float32 or float64 in any layout, which is not copied; in any unit.
    It must not change meanwhile. Other numbers are converted.
single_component: join all components, for a shape known to be in one piece.
is_tree: open every cycle, for a shape known to have none.
maximum_cells: the resolution, at most so many grid cells of about 1 kB of memory each.
smallest_feature: thickness of the thinnest limb that must be found, in the unit of the points, > 0;
    thinner ones may be missing or merged. Saves time if there are many points. None: as thin as
    the points allow.
threads: number of threads; None: all cores. The result does not depend on it.
progress: called with the progress in [0, 1]; returning False cancels (RuntimeError).

Raises ValueError if the shape is another one or a coordinate is not finite; the message names the
row. Ctrl-C cancels. Other Python threads go on meanwhile. Time is O(n), and O(m log m) for
m <= maximum_cells grid cells.)");

  module.def(
      "skeletonize_as_published", &skeletonize_as_published, "points"_a, py::kw_only(),
      "tuned"_a = false, "halt"_a = false, "number_of_iterations"_a = py::none(),
      "random_seed"_a = 0, "h_0"_a = py::none(), "delta_h"_a = py::none(), "mu"_a = py::none(),
      "samples"_a = py::none(), "alpha"_a = py::none(), "levels"_a = py::none(),
      "flatness"_a = py::none(), "sample_flatness"_a = py::none(), "alpha_min"_a = py::none(),
      "b_min"_a = py::none(), "d_max"_a = py::none(), "threads"_a = py::none(),
      "progress"_a = py::none(),
      R"(Extracts a curve skeleton by the method of Lengauer, Houska and Preiner as published.

points, threads, progress: as for skeletonize().
tuned: another set of defaults, given second.
halt: halt when no more samples come to lie on curves; number_of_iterations is then a bound.
number_of_iterations: of the projection [30, 60; with halt 60, 120].
random_seed: of parents and samples [0].
h_0: first kernel radius, in diagonals, in [1e-4, 1e4] [2 / cbrt(n)].
delta_h: growth per iteration, in h_0, >= 0 [1/2, 1/3].
mu: weight of the repulsion, in [0, 0.5) [0.2].
samples: number of samples, >= 1 [n / 20, at least 500].
alpha: reach of a parent of the EM, in deviations, > 0 [2.2].
levels: levels of the EM [3].
flatness, sample_flatness: added variance of Gaussians, > 0 [0.3; 0.3, 0.05].
alpha_min: least angle of a branch, in degrees, in [0, 180) [90, 120].
b_min: least components of a branch, >= 2 [5].
d_max: longest edge of a branch, in diagonals, > 0 [0.15].

Raises ValueError as skeletonize() does, and for a number out of its range.)");
}
