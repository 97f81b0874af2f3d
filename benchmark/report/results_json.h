// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_REPORT_RESULTS_JSON_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_REPORT_RESULTS_JSON_H

#include "Compared.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

/// What the page of the report reads: `rows`, and the `clouds` that they name by position. Numbers
/// that were not measured are null, and so are the measurements of a row that is not ok.
/// Coordinates are whole numbers from the centre of the cloud's bounding box, in 1/10000 of its
/// diagonal, one after the other; clouds are thinned to what can be seen.
nlohmann::json results_json(const std::vector<Compared>& rows);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_REPORT_RESULTS_JSON_H
