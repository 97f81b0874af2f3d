// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#define CATCH_CONFIG_RUNNER
#include "catch2.h"

int main(int argc, char** argv)
{
  return Catch::Session().run(argc, argv);
}
