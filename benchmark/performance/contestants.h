// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_PERFORMANCE_CONTESTANTS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_PERFORMANCE_CONTESTANTS_H

#include "Stopwatch.h"
#include "methods/Method.h"

#include <cstddef>
#include <string>
#include <vector>

// What is timed: this package and what it is compared with, stage by stage. All but the first use
// one thread.

/// \throw std::runtime_error for more than one thread without TBB
void skeletonize_points(const std::vector<Point>& points, std::size_t threads,
                        Stopwatch& stopwatch);

/// To a graph whose vertices do not know the points they stand for: these take most of the memory.
void skeletonize_bare(const std::vector<Point>& points, Stopwatch& stopwatch);

/// Reads the file twice: reading is part of it.
void skeletonize_stream(const std::string& file, Stopwatch& stopwatch);

/// CGAL's mean curvature flow skeleton of a closed mesh.
void flow_mesh(const std::vector<Mesh>& components, Stopwatch& stopwatch);

/// The same of the alpha wrap of the points.
void wrap_and_flow(const std::vector<Point>& points, Stopwatch& stopwatch);

/// Weighted locally optimal projection (Huang et al. 2009) to a twentieth of the points, by CGAL.
void wlop(const std::vector<Point>& points, Stopwatch& stopwatch);

/// The 16 nearest neighbours of every point, itself included, by CGAL's Kd_tree. The points are
/// sorted in space before, which halves the time of the queries.
void neighbor_queries(const std::vector<Point>& points, Stopwatch& stopwatch);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_PERFORMANCE_CONTESTANTS_H
