// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes a report of rows that no method has made: every status, every kind of input, and texts
// that a page could trip over. Usage: made_up_report FILE

#include "html_report.h"
#include "shapes.h"

#include <cmath>
#include <cstddef>
#include <iostream>
#include <map>
#include <memory>
#include <tuple>

namespace {

const std::vector<std::pair<std::string, std::string>>& methods()
{
  static const std::vector<std::pair<std::string, std::string>> names_and_inputs = {
      {"l1_medial", "points"},
      {"l1_medial_published", "points"},
      {"mcf", "mesh"},
      {"wrap_mcf", "points"},
      {"poisson_mcf", "points+normals"},
      {"l1_wlop", "points"},
      {"rosa", "points+normals"},
      {"lapcon10", "points"},
      {"lapcon08_vc", "mesh"},
      {"lapcon08_ec", "wrapped mesh"},
      {"wave_fronts", "mesh"},
      {"wave_fronts", "decimated mesh"},
      {"teasar", "mesh"},
      {"tangent_ball", "points+normals"},
      {"a_new_one", "points"}};
  return names_and_inputs;
}

/// The axes of a shape, cut into short edges, all vertices shaken.
Skeleton shaken_axes(const shapes::Shape& shape, double shake, std::mt19937& generator)
{
  constexpr int pieces = 8;
  Skeleton skeleton;
  std::map<std::tuple<double, double, double>, std::size_t> known; // shapes repeat their corners
  const auto vertex_at = [&](const shapes::Vector& p) {
    const auto [it, is_new] = known.try_emplace({p.x(), p.y(), p.z()}, num_vertices(skeleton));
    if(is_new) {
      const shapes::Vector q = p + shake * shapes::random_direction(generator);
      add_vertex({Point(q.x(), q.y(), q.z()), 0.1, {}}, skeleton);
    }
    return it->second;
  };
  for(const shapes::Capsule& c : shape)
    for(int i = 0; i < pieces; ++i)
      add_edge(vertex_at(c.a + i * (c.b - c.a) / pieces),
               vertex_at(i + 1 == pieces ? c.b : c.a + (i + 1) * (c.b - c.a) / pieces), skeleton);
  return skeleton;
}

/// More ends on more vertices the worse.
void add_spurs(Skeleton& skeleton, std::size_t count, std::mt19937& generator)
{
  const std::size_t size = num_vertices(skeleton);
  for(std::size_t i = 0; i < count; ++i) {
    const std::size_t at = generator() % size;
    const shapes::Vector d = 0.1 * shapes::random_direction(generator);
    const Point end = skeleton[at].point + Vector(d.x(), d.y(), d.z());
    add_edge(at, add_vertex({end, 0.1, {}}, skeleton), skeleton);
  }
}

struct Input
{
  std::string name;
  shapes::Shape shape;
  Truth truth;
};

/// A row that is ok; the quality falls with the noise and with the number of the method.
Compared made_up_row(const Input& input, double noise, std::size_t method)
{
  std::mt19937 generator(static_cast<unsigned>(100 * method) + static_cast<unsigned>(1e4 * noise));
  Compared row;
  row.input = input.name;
  row.noise = noise;
  std::tie(row.method, row.input_kind) = methods()[method];
  row.status = "ok";
  const double badness = static_cast<double>(method) * (0.001 + noise);
  row.skeleton = shaken_axes(input.shape, badness, generator);
  add_spurs(row.skeleton, static_cast<std::size_t>(200 * noise * badness / 0.01), generator);
  row.stages = {{"main", 0.02 * std::pow(2, method)}};
  if(row.input_kind == "points+normals")
    row.stages.insert(row.stages.begin(), {"normals", 0.3});
  row.seconds = 0;
  for(const auto& [name, seconds] : row.stages)
    row.seconds += seconds;
  row.peak_memory = 100 + 10 * static_cast<double>(method);
  row.measured.truth = input.truth;
  row.measured.got = count_graph(row.skeleton);
  row.measured.off_centre = badness;
  if(noise > 0)
    row.measured.moved_mean = badness + 1e-3;
  return row;
}

void fail(Compared& row, const std::string& status, const std::string& message)
{
  row.status = status;
  row.message = message;
  row.skeleton.clear();
  row.measured = Measurements();
}

std::vector<Compared> made_up_rows()
{
  const std::vector<Input> inputs = {{"cylinder", shapes::cylinder(), {1, 0, 2}},
                                     {"y_junction", shapes::y_junction(), {1, 0, 3}},
                                     {"ring", shapes::ring(0.2), {1, 1, 0}},
                                     {"two_parts", shapes::two_parts(), {2, 0, 4}},
                                     {"linked", shapes::ring(0.2), {3, 1, 0}}, // taken for one
                                     {"<b>&amp; 3\xb5</script>", shapes::cube_frame(), {}}};
  std::vector<Compared> rows;
  for(const Input& input : inputs)
    for(const double noise : {0., 0.002, 0.01}) {
      std::vector<shapes::Vector> cloud = shapes::sample(input.shape, 5000, 1);
      std::mt19937 generator(2);
      for(shapes::Vector& p : cloud)
        p += 2 * noise * shapes::random_direction(generator);
      const auto points =
          std::make_shared<const std::vector<Point>>(shapes::to_points<Kernel>(cloud));
      for(std::size_t method = 0; method < methods().size(); ++method) {
        rows.push_back(made_up_row(input, noise, method));
        rows.back().cloud = points;
        if(rows.back().method == "rosa" && input.name == "ring")
          fail(rows.back(), "time_limit", "600 s");
        if(rows.back().method == "poisson_mcf" && input.name == "two_parts")
          fail(rows.back(), "failed", "</script><script>throw 'not text'</script>");
        if(rows.back().method == "teasar" && noise > 0.005)
          fail(rows.back(), "invalid", "a coordinate is not finite");
        if(rows.back().method == "l1_wlop" && input.name == "cylinder") {
          rows.push_back(rows.back());
          rows.back().seed = 1;
          rows.back().measured.got.junctions += 4;
        }
      }
    }
  for(std::size_t method = 0; method < methods().size(); ++method) {
    rows.push_back(made_up_row({"nowhere", shapes::cylinder(), {}}, 0, method));
    fail(rows.back(), "unreadable", "cannot open 'nowhere.off'");
  }
  return rows;
}

} // namespace

int main(int argc, char** argv)
{
  if(argc != 2) {
    std::cerr << "usage: made_up_report FILE\n";
    return 1;
  }
  try {
    write_html_report(argv[1], made_up_rows());
  } catch(const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
