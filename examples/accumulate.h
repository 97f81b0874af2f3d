// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_ACCUMULATE_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_ACCUMULATE_H

#include "Options.h"
#include "Progress_bar.h"
#include "tiles.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Bulk_bbox_3.h>
#include <CGAL/IO/Gaussian_mixture_builder_3.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// `skeletonize_point_set accumulate` and `merge`: clouds in tiles, on one machine or several.

namespace moments_files {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;

inline Builder read(const std::string& filename)
{
  Builder builder;
  CGAL::IO::read_moments(filename, builder);
  return builder;
}

inline void print_summary(const std::string& filename, const Builder& builder)
{
  std::cout << filename << ": points " << builder.number_of_points() << ", cells "
            << builder.number_of_cells() << ", tiles " << builder.sources().size() << std::endl;
  if(!std::cout)
    throw std::runtime_error("cannot write to standard output");
}

/// The box that `--box` gives, or that of the bulk of the tiles, which are read for it.
inline Builder empty_builder(const Accumulation& job, const std::vector<Tile>& tiles,
                             const point_files::Reading_options& reading)
{
  const std::vector<double>& b = job.box;
  if(!b.empty())
    return Builder(CGAL::Bbox_3(b[0], b[1], b[2], b[3], b[4], b[5]), job.cells);
  for(const Tile& tile : tiles)
    if(!point_files::can_be_read_twice(tile.file))
      throw std::runtime_error("'" + tile.file + "' cannot be read twice: give --box");
  CGAL::Bulk_bbox_3<Kernel> bulk;
  do
    for_each_point_of<Point>(
        tiles, [&bulk](const Point& p) { bulk.insert(p); }, reading);
  while(!bulk.end_pass());
  return Builder(bulk, job.cells);
}

/// What is in the file of `--append`, which is to go on.
inline Builder read_to_go_on(const Accumulation& job)
{
  Builder builder = read(job.output);
  const std::vector<double>& b = job.box;
  if(!b.empty() && builder.box() != CGAL::Bbox_3(b[0], b[1], b[2], b[3], b[4], b[5]))
    throw std::runtime_error("cannot append to '" + job.output + "': it has another --box");
  return builder;
}

} // namespace moments_files

/// Adds the points of tiles to a file of moments.
inline void accumulate(const Accumulation& job)
{
  using namespace moments_files;
  std::vector<Tile> tiles;
  for(const std::string& file : job.files)
    tiles.push_back({file, job.tile_box});
  if(!job.list.empty())
    for(Tile& tile : read_tile_list(job.list))
      tiles.push_back(std::move(tile));

  Progress_bar bar(!job.quiet);
  point_files::Reading_options reading;
  reading.format = job.format;
  reading.skip_invalid = job.skip_invalid;
  reading.progress = [&bar](double share) { bar.show(share); };
  const bool goes_on = job.append && std::filesystem::exists(job.output);
  Builder builder = goes_on ? read_to_go_on(job) : empty_builder(job, tiles, reading);
  std::size_t left_out = 0;
  for(std::size_t i = 0; i < tiles.size(); ++i) {
    if(!builder.insert_source(tiles[i].name())) {
      if(!job.append)
        throw std::runtime_error("'" + tiles[i].file + "' is given twice");
      ++left_out;
      continue;
    }
    for_each_point_of<Point>(
        tiles, i, [&builder](const Point& p) { builder.insert(p); }, reading);
    if(job.append) // whatever happens to the next tile, this one is done
      CGAL::IO::write_moments(job.output, builder);
  }
  if(!job.append)
    CGAL::IO::write_moments(job.output, builder);
  if(!job.quiet && left_out > 0)
    std::cout << left_out << " tiles were in it before\n";
  if(!job.quiet)
    print_summary(job.output, builder);
}

/// Adds up files of moments.
inline void merge(const Merging& job)
{
  using namespace moments_files;
  Builder sum = read(job.files.front());
  for(std::size_t i = 1; i < job.files.size(); ++i) {
    try {
      sum.merge(read(job.files[i]));
    } catch(const std::invalid_argument& error) {
      throw std::runtime_error("cannot add '" + job.files[i] + "': " + error.what());
    }
  }
  CGAL::IO::write_moments(job.output, sum);
  if(!job.quiet)
    print_summary(job.output, sum);
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_ACCUMULATE_H
