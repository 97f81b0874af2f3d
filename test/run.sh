#!/bin/sh
# Builds everything and runs the tests.
set -eu
cd "$(dirname "$0")/.."
. cmake/prepare.sh
cmake --build build
cd build
exec ctest --output-on-failure --parallel 2
