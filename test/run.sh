#!/bin/sh
# Builds and tests the library, the program, the examples and the command `quality`; with --all also the
# comparison with other methods, its report in a browser, and the command `performance`.
# Usage: run.sh [--all]
set -eu
cd "$(dirname "$0")/.."
case ${1-} in
  "") purpose=test comparison=OFF ;;
  --all) purpose=all comparison=ON ;;
  *) echo "usage: run.sh [--all]" >&2; exit 2 ;;
esac
sh cmake/prepare.sh $purpose -DPoint_set_skeletonization_3_STRICT=ON \
  -DPoint_set_skeletonization_3_COMPARISON=$comparison
echo "== Building what is tested"
# One compiler per core: Ninja runs more, and those that wait for each other, as they take much memory,
# are then left over at the end.
cmake --build build --parallel "$(nproc)"
echo "== Testing"
cd build
# One more than cores: some only wait.
exec ctest --output-on-failure --parallel $(($(nproc) + 1))
