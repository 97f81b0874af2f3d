// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_PAGE_FILES_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_PAGE_FILES_H

#include <map>
#include <string>

/// The contents of the files that make a page, by their names. The build puts them into the
/// program, see embed_files.cmake.
const std::map<std::string, std::string>& page_files();

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_PAGE_FILES_H
