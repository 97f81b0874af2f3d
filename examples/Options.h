// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_OPTIONS_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_OPTIONS_H

// The command lines of the programs.

#include <CGAL/Gaussian_mixture_builder_3.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

using Builder = CGAL::Gaussian_mixture_builder_3<CGAL::Simple_cartesian<double>>;

/// Whether a file has moments, by its name.
bool is_moments_file(const std::string& filename);

/// The parameters of the published method, by the symbols of the paper; what is not given keeps its
/// default.
struct Published_symbols
{
  bool tuned = false, halt = false;
  std::optional<double> h_0, delta_h, mu, alpha, flatness, sample_flatness, alpha_min, d_max;
  std::optional<std::size_t> iterations, samples, levels, b_min;
};

/// The command line of `skeletonize_point_set accumulate`.
struct Accumulation
{
  std::vector<std::string> files; ///< the tiles
  std::string list;               ///< of more tiles
  std::string output;
  std::vector<double> box;      ///< as below
  std::vector<double> tile_box; ///< of each of the files; empty: all points count
  std::size_t cells = Builder::default_maximum_cells;
  bool append = false;
  std::string format;
  bool skip_invalid = false;
  bool quiet = false;
};

/// The command line of `skeletonize_point_set merge`.
struct Merging
{
  std::vector<std::string> files;
  std::string output;
  bool quiet = false;
};

/// The command line of `skeletonize_point_set` without a command.
struct Options
{
  std::string input;           ///< "-": standard input
  bool is_one_of_many = false; ///< whether there are other inputs
  std::string format;          ///< by its extension; empty: as the input is called
  bool skip_invalid = false;
  std::vector<std::string> outputs;
  std::string points;
  std::string branches; ///< table of branches
  std::string segment;  ///< the cloud with the branch of each point
  std::string root = "lowest";
  std::string up = "z"; ///< the vertical axis
  bool as_published = false;
  Published_symbols published;
  bool single_component = false;
  bool is_tree = false;
  bool split = false;
  bool stream = false;
  std::vector<double> box; ///< smallest x, y, z, then largest; empty: read the file twice
  std::size_t cells = Builder::default_maximum_cells; ///< greatest number of the mixture
  std::optional<double> smallest_feature; ///< thickness of a limb, in the unit of the input
  std::size_t sample = 0;                 ///< 0: take the vertices
  int threads = 0;        ///< 0: all cores
  unsigned int seed = 0;
  bool stats = false;
  bool quiet = false;
};

/// The command line of `skeletonize_point_set_mpi`.
struct Mpi_options : Options
{
  std::vector<std::string> tiles;
  std::string list;              ///< of more tiles
  std::string segment_directory; ///< for the points of each tile with their branch; empty: none
};

/// The options for the outputs of a part.
Options options_of_part(Options options, std::size_t part, std::size_t parts);

/// What is to be done; nothing if it was only to show help.
struct Command_line
{
  std::vector<Options> jobs; ///< One input after the other.
  std::optional<Accumulation> accumulation;
  std::optional<Merging> merging;
};

/// \throw std::runtime_error with a message of one line
Command_line parse_options(int argc, char** argv);

/// Returns nothing if it was only to show help.
/// \throw std::runtime_error with a message of one line
std::optional<Mpi_options> parse_mpi_options(int argc, char** argv);

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_OPTIONS_H
