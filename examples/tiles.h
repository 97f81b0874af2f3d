// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_TILES_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_TILES_H

#include "for_each_point.h"

#include <cstddef>
#include <exception>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// A file with a part of a cloud. Tiles may overlap, as those with a buffer do: then each has a
/// box, and only the points in it count.
struct Tile
{
  std::string file;

  /// Smallest x, y and z, then largest; empty: all points count. The largest belong to the next
  /// tile: a point on the border of two is in one of them.
  std::vector<double> box;

  template <typename Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive & file & box;
  }

  template <typename Point>
  bool contains(const Point& p) const
  {
    return box.empty() || (box[0] <= p.x() && p.x() < box[3] && //
                           box[1] <= p.y() && p.y() < box[4] && //
                           box[2] <= p.z() && p.z() < box[5]);
  }

  /// The file and the box: what must not be counted twice.
  std::string name() const
  {
    std::ostringstream result;
    result.precision(std::numeric_limits<double>::max_digits10);
    result << file;
    for(double x : box)
      result << ' ' << x;
    return result.str();
  }
};

/// Whether these are six numbers of which none of the first three is greater than its partner.
inline bool is_box(const std::vector<double>& box)
{
  return box.size() == 6 && box[0] <= box[3] && box[1] <= box[4] && box[2] <= box[5];
}

/// Makes a tile from a line of a list: a file, and the six numbers of a box if there are any.
inline Tile tile_of_line(const std::string& line)
{
  constexpr char blank[] = " \t\r";
  Tile all{line.substr(0, line.find_last_not_of(blank) + 1), {}}, tile = all;
  for(int k = 0; k < 6; ++k) { // from the end
    const std::size_t before = tile.file.find_last_of(blank);
    if(before == std::string::npos)
      return all;
    std::size_t read = 0;
    const std::string number = tile.file.substr(before + 1);
    try {
      tile.box.insert(tile.box.begin(), std::stod(number, &read));
    } catch(const std::exception&) {
    }
    if(read != number.size())
      return all;
    tile.file.erase(tile.file.find_last_not_of(blank, before) + 1);
  }
  return tile;
}

/// Reads a list of tiles, one a line; blank lines and those that begin with # are comments.
/// \throw std::runtime_error that names the file
inline std::vector<Tile> read_tile_list(const std::string& filename)
{
  const auto fail = [&filename](const std::string& why) {
    throw std::runtime_error("cannot read '" + filename + "': " + why);
  };
  std::ifstream file(filename);
  if(!file)
    fail("there is no such file, or it may not be read");
  std::vector<Tile> tiles;
  std::string line;
  for(std::size_t number = 1; std::getline(file, line); ++number) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if(begin == std::string::npos || line[begin] == '#')
      continue;
    tiles.push_back(tile_of_line(line.substr(begin)));
    if(!tiles.back().box.empty() && !is_box(tiles.back().box))
      fail("line " + std::to_string(number) + ": give the smallest x, y and z, then the largest");
  }
  if(tiles.empty())
    fail("there are no tiles in it");
  return tiles;
}

/// Calls `use` with the points that count of the `i`-th tile; `options.progress` gets the share of
/// all tiles. \returns the number of rows left out; else as `for_each_point()`
template <typename Point, typename Use>
std::size_t for_each_point_of(const std::vector<Tile>& tiles, std::size_t i, const Use& use,
                              point_files::Reading_options options)
{
  options.progress = [&tiles, i, all = std::move(options.progress)](double share) {
    all((static_cast<double>(i) + share) / static_cast<double>(tiles.size()));
  };
  const auto use_if_it_counts = [&](const Point& p) {
    if(tiles[i].contains(p))
      use(p);
  };
  return for_each_point<Point>(tiles[i].file, use_if_it_counts, options);
}

/// The same for all tiles.
template <typename Point, typename Use>
std::size_t for_each_point_of(const std::vector<Tile>& tiles, const Use& use,
                              const point_files::Reading_options& options)
{
  std::size_t skipped = 0;
  for(std::size_t i = 0; i < tiles.size(); ++i)
    skipped += for_each_point_of<Point>(tiles, i, use, options);
  return skipped;
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_TILES_H
