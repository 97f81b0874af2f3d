// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A source that CMake compiles the header for; test_main.cpp configures Catch in another way.
