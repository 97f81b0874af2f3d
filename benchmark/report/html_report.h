// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_REPORT_HTML_REPORT_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_REPORT_HTML_REPORT_H

#include "Compared.h"

#include <string>
#include <vector>

/// Writes one page that needs nothing else and no network: a gallery of methods and shapes with
/// views to turn, plots against noise, the seconds beside the paper's, and a table of all rows.
/// Shapes are shown in the order in which they first come.
/// \throw std::runtime_error if the file cannot be written, or if the page or one of its libraries
/// is not where it was when this was built
void write_html_report(const std::string& file, const std::vector<Compared>& rows);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_REPORT_HTML_REPORT_H
