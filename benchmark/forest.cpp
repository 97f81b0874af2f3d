// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes a plot of scanned trees, in tiles as surveys have them: to measure what many processes
// take. `forest --help` tells the options; `check_forest.py` compares skeletons with it.

#include "write_little_endian.h"

#include "generator/branching_tree.h"
#include "generator/scanned_families.h"
#include "generator/scanner.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct Forest_options
{
  std::string folder;
  std::size_t trees = 200, points = 2000000, tiles = 16;
  double buffer = 0; // around each tile, in metres
  unsigned int seed = 1;
  int levels = 0; // of one tree instead
};

// Far from the origin, as surveys are. A tree has a square of its own.
const shapes::Vector plot_corner(500000, 5400000, 300);
constexpr double side_of_square = 12, height = 9; // metres; height: of a tree, about

// The tiles of a plot: files that are open for writing, side by side and row by row.
class Tiles
{
public:
  Tiles(const Forest_options& options, double side)
      : rows_(static_cast<int>(std::lround(std::sqrt(static_cast<double>(options.tiles)))))
      , step_(side / rows_)
      , buffer_(options.buffer)
      , counts_(static_cast<std::size_t>(rows_ * rows_), 0)
  {
    std::ofstream list(options.folder + "/tiles.txt");
    list << std::setprecision(12);
    for(int row = 0; row < rows_; ++row)
      for(int column = 0; column < rows_; ++column) {
        const std::string name = options.folder + "/tile_" + std::to_string(files_.size()) + ".ply";
        files_.emplace_back(name, std::ios::binary);
        write_header(files_.size() - 1);
        const double x = plot_corner.x() + step_ * column, y = plot_corner.y() + step_ * row;
        list << name << ' ' << x << ' ' << y << " -inf " << x + step_ << ' ' << y + step_
             << " inf\n";
      }
  }

  void write(const shapes::Vector& p)
  {
    const shapes::Vector q = p - plot_corner;
    for(int row = place(q.y() - buffer_); row <= place(q.y() + buffer_); ++row)
      for(int column = place(q.x() - buffer_); column <= place(q.x() + buffer_); ++column) {
        const auto tile = static_cast<std::size_t>(row * rows_ + column);
        for(const double x : {p.x(), p.y(), p.z()})
          write_little_endian<std::uint64_t>(files_[tile], x);
        ++counts_[tile];
      }
  }

  // Writes how many points there are, which is known now.
  void finish()
  {
    for(std::size_t tile = 0; tile < files_.size(); ++tile) {
      files_[tile].seekp(0);
      write_header(tile);
      files_[tile].close();
      if(!files_[tile])
        throw std::runtime_error("cannot write the tiles: check the free space on the disk");
    }
  }

private:
  int place(double x) const { return std::clamp(static_cast<int>(x / step_), 0, rows_ - 1); }

  void write_header(std::size_t tile)
  {
    files_[tile] << "ply\nformat binary_little_endian 1.0\nelement vertex " << std::setw(12)
                 << counts_[tile] << "\nproperty double x\nproperty double y\nproperty double z\n"
                 << "end_header\n";
  }

  int rows_;
  double step_, buffer_; // metres
  std::vector<std::size_t> counts_;
  std::vector<std::ofstream> files_;
};

void make_forest(const Forest_options& options)
{
  std::filesystem::create_directories(options.folder);
  const auto columns =
      static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(options.trees))));
  Tiles tiles(options, side_of_square * static_cast<double>(columns));
  std::ofstream truth(options.folder + "/truth.csv");
  truth << "tree,xmin,ymin,xmax,ymax,ends\n" << std::setprecision(12);
  for(std::size_t tree = 0; tree < options.trees; ++tree) {
    const auto seed = options.seed + static_cast<unsigned int>(tree);
    const shapes::Known_shape shape = shapes::scanned_shape("tree", seed);
    shapes::Scan_options scan;
    scan.points = options.points / options.trees;
    shapes::Random random(seed);
    const Eigen::AlignedBox3d box = bounding_box(shape);
    const double wide = std::max(box.sizes().x(), box.sizes().y());
    const double scale = std::min(random.uniform(0.7, 1.3) * height / box.sizes().z(),
                                  0.9 * side_of_square / wide); // its square is its own
    const shapes::Vector corner =
        plot_corner + side_of_square * shapes::Vector(static_cast<double>(tree % columns),
                                                      static_cast<double>(tree / columns), 0);
    const shapes::Vector foot =
        corner + shapes::Vector(side_of_square / 2, side_of_square / 2, random.uniform(0, 2));
    const shapes::Vector middle(box.center().x(), box.center().y(), box.min().z());
    for(const shapes::Vector& p : shapes::scan(shape, scan, seed).points)
      tiles.write(foot + scale * (p - middle));
    truth << tree << ',' << corner.x() << ',' << corner.y() << ',' << corner.x() + side_of_square
          << ',' << corner.y() + side_of_square << ',' << shape.ends << '\n';
  }
  tiles.finish();
}

// One shape in one piece, of any number of details.
void make_branching_tree(const Forest_options& options)
{
  constexpr double side = 50;
  std::filesystem::create_directories(options.folder);
  const shapes::Known_shape shape = shapes::branching_tree(options.levels, options.seed);
  const Eigen::AlignedBox3d box = bounding_box(shape);
  const double scale = side / box.sizes().maxCoeff();
  Tiles tiles(options, side);
  shapes::Random random(options.seed);
  for(std::size_t k = 0; k < options.points; ++k)
    tiles.write(plot_corner + scale * (shape.solid.random_point(random) - box.min()));
  tiles.finish();
}

} // namespace

int main(int argc, char** argv)
{
  Forest_options options;
  CLI::App app("Makes a plot of scanned trees in tiles: FOLDER/tile_*.ply, tiles.txt, truth.csv.",
               "forest");
  app.add_option("FOLDER", options.folder, "folder to write to")->required();
  app.add_option("--trees", options.trees, "number of trees [200]");
  app.add_option("--points", options.points, "about so many of all trees [2000000]");
  app.add_option("--tiles", options.tiles, "number of tiles, a square [16]");
  app.add_option("--buffer", options.buffer, "around each tile, in metres [0]");
  app.add_option("--seed", options.seed, "of the first tree [1]");
  app.add_option("--levels", options.levels,
                 "one tree in one piece instead, that forks so many times: 2^N tips")
      ->check(CLI::Range(1, 14));
  CLI11_PARSE(app, argc, argv);
  try {
    if(options.levels > 0)
      make_branching_tree(options);
    else
      make_forest(options);
  } catch(const std::exception& error) {
    std::cerr << "forest: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
