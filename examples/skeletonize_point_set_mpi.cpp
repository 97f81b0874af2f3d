// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads the tiles of a cloud in many processes, writes its curve skeleton.
// `skeletonize_point_set_mpi --help` tells the options.

#include "End_on_signals.h"
#include "Options.h"
#include "Progress_bar.h"
#include "Ranks.h"
#include "outputs.h"
#include "peak_memory.h"
#include "skeletonize_cloud.h"
#include "succeeds.h"
#include "tiles.h"
#include "write_segmented_cloud.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Bulk_bbox_3.h>
#include <CGAL/Point_assignment_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/Output_file.h>
#include <CGAL/Real_timer.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

using Bulk = CGAL::Bulk_bbox_3<Kernel>;
using Assignment = CGAL::Point_assignment_3<Kernel>;

// The tiles of every rank, by size: the largest that is left goes to the rank with the least.
std::vector<std::vector<Tile>> shared_out(std::vector<Tile> tiles, int ranks)
{
  const auto size_of = [](const Tile& tile) {
    std::error_code unknown; // an error for the rank that will read it
    const std::uintmax_t size = std::filesystem::file_size(tile.file, unknown);
    return unknown ? 0 : size;
  };
  std::vector<std::pair<std::uintmax_t, std::size_t>> order;
  for(std::size_t i = 0; i < tiles.size(); ++i)
    order.emplace_back(size_of(tiles[i]), i);
  std::sort(order.rbegin(), order.rend());
  std::vector<std::vector<Tile>> result(static_cast<std::size_t>(ranks));
  std::vector<std::uintmax_t> load(result.size(), 0);
  for(const auto& [size, i] : order) {
    const auto least = static_cast<std::size_t>(std::min_element(load.begin(), load.end()) -
                                                load.begin());
    load[least] += size + 1;
    result[least].push_back(std::move(tiles[i]));
  }
  return result;
}

// A run: each member function is called in all ranks, and throws in all if it fails in one.
class Run
{
public:
  Run(const boost::mpi::communicator& world, const Mpi_options& options)
      : world_(world), ranks_(world), options_(options)
  {}

  void operator()()
  {
    share_tiles();
    CGAL::Real_timer timer;
    timer.start();
    Builder builder = accumulated();
    Reading reading;
    reading.points = builder.number_of_points(); // in the first rank
    reading.seconds = timer.time();
    if(options_.skip_invalid)
      reading.skipped = boost::mpi::all_reduce(world_, skipped_, std::plus<std::size_t>());
    skeletonize(std::move(builder), reading);
    if(!options_.segment_directory.empty())
      segment();
    report_all();
  }

  // Whether all ranks know that one failed.
  bool has_stopped() const { return ranks_.have_stopped(); }

private:
  // The first rank reads the list, and looks at sizes, for all.
  void share_tiles()
  {
    std::vector<std::vector<Tile>> shares;
    together([&](const Ranks::Report&) {
      if(!ranks_.is_first())
        return;
      std::vector<Tile> tiles;
      for(const std::string& file : options_.tiles)
        tiles.push_back({file, {}});
      if(!options_.list.empty())
        for(Tile& tile : read_tile_list(options_.list))
          tiles.push_back(std::move(tile));
      check_tiles(tiles);
      shares = shared_out(std::move(tiles), ranks_.size());
    });
    boost::mpi::broadcast(world_, shares, 0);
    tiles_ = std::move(shares[static_cast<std::size_t>(ranks_.rank())]);
  }

  void check_tiles(const std::vector<Tile>& tiles) const
  {
    std::set<std::string> names, segments;
    for(const Tile& tile : tiles) {
      if(!names.insert(tile.name()).second)
        throw std::runtime_error("'" + tile.file + "' is given twice");
      if(!options_.segment_directory.empty() && !segments.insert(segment_file(tile)).second)
        throw std::runtime_error("cannot write the points of '" + tile.file +
                                 "': another tile has the same name");
    }
  }

  std::string segment_file(const Tile& tile) const
  {
    const std::string name = std::filesystem::path(tile.file).stem().string() + ".ply";
    return (std::filesystem::path(options_.segment_directory) / name).string();
  }

  template <typename Work>
  void together(const Work& work)
  {
    Progress_bar bar(!options_.quiet && ranks_.is_first());
    ranks_.together(work, [&bar](double share) { bar.show(share); });
  }

  point_files::Reading_options reading_options(const Ranks::Report& report) const
  {
    point_files::Reading_options reading;
    reading.format = options_.format;
    reading.skip_invalid = options_.skip_invalid;
    reading.progress = report;
    return reading;
  }

  // The moments of all points, in the first rank.
  Builder accumulated()
  {
    const std::vector<double>& b = options_.box;
    Builder builder =
        b.empty() ? Builder(common_bulk(), options_.cells)
                  : Builder(CGAL::Bbox_3(b[0], b[1], b[2], b[3], b[4], b[5]), options_.cells);
    together([&](const Ranks::Report& report) {
      const point_files::Reading_options reading = reading_options(report);
      for(std::size_t i = 0; i < tiles_.size(); ++i) {
        std::size_t points = 0;
        const auto insert = [&](const Point& p) {
          builder.insert(p);
          ++points;
        };
        skipped_ += for_each_point_of<Point>(tiles_, i, insert, reading);
        points_of_tile_.push_back(points);
      }
    });
    ranks_.reduce(builder);
    return builder;
  }

  // The same for any number of ranks: what each of them knows of the bulk adds up.
  Bulk common_bulk()
  {
    Bulk bulk;
    do {
      together([&](const Ranks::Report& report) {
        for_each_point_of<Point>(
            tiles_, [&bulk](const Point& p) { bulk.insert(p); }, reading_options(report));
      });
      const auto merged = [](Bulk a, const Bulk& b) {
        a.merge(b);
        return a;
      };
      bulk = boost::mpi::all_reduce(world_, bulk, merged);
    } while(!bulk.end_pass());
    return bulk;
  }

  // In the first rank; the others wait.
  void skeletonize(Builder builder, const Reading& reading)
  {
    together([&](const Ranks::Report&) {
      if(ranks_.is_first())
        reported_ = skeletonize_streamed(std::move(builder), reading, options_);
      else
        reported_.emplace_back(); // to be received
    });
  }

  // Each rank reads its tiles once more, and writes what its points belong to.
  void segment()
  {
    Result& result = reported_.front().result;
    broadcast(result);
    const std::vector<Point> none;
    const Skeletonized_cloud cloud = with_branches(result.skeleton, none, 0, options_);
    together([&](const Ranks::Report& report) {
      for(std::size_t i = 0; i < tiles_.size(); ++i)
        write_file(segment_file(tiles_[i]), [&](std::ostream& os) {
          Segmented_points points(os, cloud, points_of_tile_[i]);
          const auto write = [&](const Point& p) {
            const std::size_t v = result.assignment(p);
            points.write(p, v == Assignment::none
                                ? Skeletonized_cloud::no_branch
                                : static_cast<std::uint32_t>(cloud.branch_of_vertex[v]));
          };
          for_each_point_of<Point>(tiles_, i, write, reading_options(report));
        });
    });
  }

  void broadcast(Result& result)
  {
    Skeleton& skeleton = result.skeleton;
    std::vector<double> coordinates;
    std::vector<std::size_t> ends;
    for(const auto v : CGAL::make_range(vertices(skeleton)))
      for(const double x : {skeleton[v].point.x(), skeleton[v].point.y(), skeleton[v].point.z(),
                            skeleton[v].radius})
        coordinates.push_back(x);
    for(const auto e : CGAL::make_range(edges(skeleton))) {
      ends.push_back(source(e, skeleton));
      ends.push_back(target(e, skeleton));
    }
    boost::mpi::broadcast(world_, coordinates, 0);
    boost::mpi::broadcast(world_, ends, 0);
    boost::mpi::broadcast(world_, result.assignment, 0);
    if(ranks_.is_first())
      return;
    skeleton = Skeleton(coordinates.size() / 4);
    for(const auto v : CGAL::make_range(vertices(skeleton))) {
      skeleton[v].point =
          Point(coordinates[4 * v], coordinates[4 * v + 1], coordinates[4 * v + 2]);
      skeleton[v].radius = coordinates[4 * v + 3];
    }
    for(std::size_t e = 0; e < ends.size(); e += 2)
      add_edge(ends[e], ends[e + 1], skeleton);
  }

  void report_all()
  {
    std::vector<double> memory; // of every rank, in MB
    boost::mpi::gather(world_, peak_megabytes(), memory, 0);
    if(ranks_.is_first())
      for(const Reported& r : reported_)
        report(r, options_, memory);
  }

  boost::mpi::communicator world_;
  Ranks ranks_;
  const Mpi_options& options_;
  std::vector<Tile> tiles_; // of this rank
  std::vector<std::size_t> points_of_tile_;
  std::size_t skipped_ = 0;
  std::vector<Reported> reported_;
};

int main(int argc, char** argv)
{
  end_on_signals(
      [] { CGAL::Point_set_skeletonization_3::internal::unfinished_files().abandon(); });
  std::string program = "skeletonize_point_set_mpi";
  std::optional<Mpi_options> options;
  std::exception_ptr error;
  try {
    options = parse_mpi_options(argc, argv);
    if(!options)
      return EXIT_SUCCESS; // it was only to show help
  } catch(const std::exception&) {
    error = std::current_exception();
  }

  // Only the thread of main() sends; the others are those of TBB in the first rank.
  boost::mpi::environment environment(argc, argv, boost::mpi::threading::funneled);
  const boost::mpi::communicator world;
  if(error && world.rank() == 0) // all have the same command line, one complains of it
    succeeds(program, [&] { std::rethrow_exception(error); }, "not enough memory");
  if(error)
    return EXIT_FAILURE;

  if(world.size() > 1)
    program += ", rank " + std::to_string(world.rank());
  Run run(world, *options);
  bool success = false;
  try {
    success = succeeds(
        program, [&run] { run(); }, "not enough memory; try fewer --cells");
  } catch(const Another_rank_failed&) { // which has said why
  }
  if(!success && !run.has_stopped())
    environment.abort(EXIT_FAILURE); // the others might wait for this rank
  return success ? EXIT_SUCCESS : EXIT_FAILURE;
}
