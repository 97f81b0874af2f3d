// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Files hold the skeleton exactly, or are not there.

#include "catch2.h"

#include "graph_counts.h"

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/IO/Curve_skeleton_3.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace curve_skeleton_test {

namespace fs = std::filesystem;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;

namespace {

// An empty folder, removed again.
struct Folder
{
  fs::path path = fs::temp_directory_path() / "Point_set_skeletonization_3_test_io";
  Folder()
  {
    fs::remove_all(path);
    fs::create_directory(path);
  }
  ~Folder() { fs::remove_all(path); }
  std::string operator/(const std::string& name) const { return (path / name).string(); }
};

// A ring of four vertices with a tail, and a vertex alone; coordinates need all digits of a double.
Skeleton ring_with_tail()
{
  Skeleton skeleton;
  for(int i = 0; i < 7; ++i) {
    const auto v = add_vertex(skeleton);
    skeleton[v].point = Point(500000. + i / 3., -i / 7., 1e-300 * i);
    skeleton[v].radius = 0.1 * i;
  }
  for(const auto& e :
      std::vector<std::pair<int, int>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {3, 4}, {4, 5}})
    add_edge(static_cast<std::size_t>(e.first), static_cast<std::size_t>(e.second), skeleton);
  return skeleton;
}

std::vector<std::string> lines_of(const std::string& filename)
{
  std::ifstream file(filename);
  std::vector<std::string> lines;
  for(std::string line; std::getline(file, line);)
    lines.push_back(line);
  return lines;
}

// The numbers of a line after skipping the first `skip` words.
std::vector<double> numbers(const std::string& line, int skip = 0)
{
  std::istringstream words(line);
  std::string word;
  for(int i = 0; i < skip; ++i)
    words >> word;
  std::vector<double> result;
  while(words >> word)
    result.push_back(std::stod(word));
  return result;
}

bool is_point(const std::vector<double>& n, std::size_t at, const Point& p)
{
  return n.at(at) == p.x() && n.at(at + 1) == p.y() && n.at(at + 2) == p.z();
}

std::size_t files_in(const Folder& folder)
{
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()));
}

// The message, which has to be one line that names the file.
std::string message_of_writing(const std::string& filename)
{
  try {
    CGAL::IO::write_curve_skeleton(filename, ring_with_tail());
  } catch(const std::runtime_error& error) {
    std::string message = error.what();
    CHECK(message.find(filename) != std::string::npos);
    CHECK(message.find('\n') == std::string::npos);
    return message;
  }
  return "";
}

} // namespace

TEST_CASE("an .obj holds every vertex and edge exactly")
{
  const Folder folder;
  const Skeleton skeleton = ring_with_tail();
  CGAL::IO::write_curve_skeleton(folder / "s.obj", skeleton);
  const auto lines = lines_of(folder / "s.obj");
  REQUIRE(lines.size() == num_vertices(skeleton) + num_edges(skeleton));
  for(std::size_t i = 0; i < num_vertices(skeleton); ++i) {
    CHECK(lines[i].substr(0, 2) == "v ");
    CHECK(is_point(numbers(lines[i], 1), 0, skeleton[i].point));
  }
  CHECK(lines[num_vertices(skeleton)] == "l 1 2");
  CHECK(lines.back() == "l 5 6");
}

TEST_CASE("a .ply holds every vertex, radius and edge exactly")
{
  const Folder folder;
  const Skeleton skeleton = ring_with_tail();
  CGAL::IO::write_curve_skeleton(folder / "s.ply", skeleton);
  const auto lines = lines_of(folder / "s.ply");
  const std::size_t header = 11;
  REQUIRE(lines.size() == header + num_vertices(skeleton) + num_edges(skeleton));
  CHECK(lines[2] == "element vertex 7");
  CHECK(lines[7] == "element edge 6");
  CHECK(lines[header - 1] == "end_header");
  for(std::size_t i = 0; i < num_vertices(skeleton); ++i) {
    const auto n = numbers(lines[header + i]);
    CHECK(is_point(n, 0, skeleton[i].point));
    CHECK(n.at(3) == skeleton[i].radius);
  }
  CHECK(lines.back() == "4 5");
}

TEST_CASE("polylines cover every edge once, close a loop and keep a lone vertex")
{
  const Folder folder;
  const Skeleton skeleton = ring_with_tail();
  CGAL::IO::write_curve_skeleton(folder / "s.polylines.txt", skeleton);
  std::size_t edges = 0, closed = 0, lone = 0;
  for(const std::string& line : lines_of(folder / "s.polylines.txt")) {
    const auto n = numbers(line);
    const auto size = static_cast<std::size_t>(n.at(0));
    REQUIRE(n.size() == 1 + 3 * size);
    edges += size - 1;
    lone += size == 1 ? 1 : 0;
    const Point last(n[3 * size - 2], n[3 * size - 1], n[3 * size]);
    closed += size > 1 && is_point(n, 1, last) ? 1 : 0;
  }
  CHECK(edges == num_edges(skeleton));
  CHECK(closed == 1);
  CHECK(lone == 1);
}

TEST_CASE("an empty skeleton is written, too")
{
  const Folder folder;
  for(const char* name : {"s.obj", "s.ply", "s.polylines.txt"}) {
    CGAL::IO::write_curve_skeleton(folder / name, Skeleton());
    CHECK(fs::exists(folder / name));
  }
}

TEST_CASE("the program's locale does not change what is written")
{
  struct Comma : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
  };
  const Folder folder;
  const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
  CGAL::IO::write_curve_skeleton(folder / "s.obj", ring_with_tail());
  std::locale::global(before);
  for(const std::string& line : lines_of(folder / "s.obj"))
    CHECK(line.find(',') == std::string::npos);
}

TEST_CASE("an unknown ending is an error that says what to do")
{
  const Folder folder;
  for(const char* name : {"s.txt", "s.stl", "s", "s.PLY.gz"}) {
    CHECK(!CGAL::IO::is_curve_skeleton_filename(folder / name));
    CHECK(message_of_writing(folder / name).find(".ply") != std::string::npos);
  }
  CHECK(files_in(folder) == 0);
}

TEST_CASE("a folder that is not there is an error")
{
  const Folder folder;
  CHECK(!message_of_writing(folder / "none/s.ply").empty());
  CHECK(files_in(folder) == 0);
}

TEST_CASE("a file that cannot be put in its place leaves nothing behind")
{
  const Folder folder;
  fs::create_directory(folder / "s.ply");
  CHECK(!message_of_writing(folder / "s.ply").empty());
  CHECK(files_in(folder) == 1);
}

TEST_CASE("counts of a skeleton")
{
  const Graph_counts counts = count_graph(ring_with_tail());
  CHECK(counts.components == 2);
  CHECK(counts.cycles == 1);
  CHECK(counts.ends == 1);
  CHECK(counts.junctions == 1);

  Skeleton square;
  for(const Point& p : {Point(0, 0, 0), Point(2, 0, 0), Point(2, 2, 0), Point(0, 2, 0)})
    square[add_vertex(square)].point = p;
  for(std::size_t i = 0; i < 4; ++i)
    add_edge(i, (i + 1) % 4, square);
  CHECK(count_graph(square).length == 8);
  CHECK(count_graph(square).cycles == 1);
  CHECK(count_graph(square).ends == 0);
  CHECK(count_graph(Skeleton()).components == 0);
}

} // namespace curve_skeleton_test
