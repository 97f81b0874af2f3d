#!/bin/sh
# Checks what .clang-tidy names, as errors: all headers of the library, the program and its readers.
# Usage: tidy.sh CLANG_TIDY BUILD_FOLDER
set -eu
cd "$(dirname "$0")/.."
# GCC's commands: its default is C++17, and it has warnings of its own.
exec "$1" -p "$2" --quiet --extra-arg=-std=c++17 --extra-arg=-Wno-unknown-warning-option \
  test/headers/header_only.cpp examples/skeletonize_point_set.cpp examples/point_files/*.cpp
