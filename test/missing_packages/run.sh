#!/bin/sh
# With nothing but CGAL, Eigen and Boost the package is configured, and says what it leaves out.
# Usage: run.sh BUILD_FOLDER CMAKE GENERATOR COMPILER
set -eu
cmake=$2 generator=$3 compiler=$4
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for package in TBB CLI11 nlohmann_json Catch2; do
  set -- "$@" "-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON"
done
shift 4
# What -Wno-dev hides is CGAL's: 6.0 looks for Boost in a way that CMake warns its developers of.
"$cmake" -Wno-dev -S "$here/../.." -B "$work/build" -G "$generator" \
  -DCMAKE_CXX_COMPILER="$compiler" -DPoint_set_skeletonization_3_COMPARISON=ON "$@" \
  > "$work/log" 2>&1 || { cat "$work/log"; exit 1; }
for text in "Without the program skeletonize_point_set: there is no CLI11" \
    "Without the program skeletonize_point_set: there is no nlohmann_json" \
    "Without the benchmark: there is no CLI11" "there is no Catch2"; do
  grep -qF "$text" "$work/log" || { cat "$work/log"; echo "FAILED: no '$text'"; exit 1; }
done
if grep -q "CMake Warning\|CMake Error" "$work/log"; then cat "$work/log"; exit 1; fi

# MPI is not there.
"$cmake" -S "$here/../.." -B "$work/mpi" -G "$generator" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_DISABLE_FIND_PACKAGE_MPI=ON > "$work/log" 2>&1 || { cat "$work/log"; exit 1; }
grep -q "Without the program skeletonize_point_set_mpi" "$work/log" || { cat "$work/log"; exit 1; }

# The report's libraries are not there.
"$cmake" -S "$here/../.." -B "$work/other" -G "$generator" -DCMAKE_CXX_COMPILER="$compiler" \
  -DPoint_set_skeletonization_3_COMPARISON=ON -DJAVASCRIPT_DIR="$work" > "$work/log" 2>&1 ||
  { cat "$work/log"; exit 1; }
grep -q "Without compare_skeletons and its HTML report" "$work/log" || { cat "$work/log"; exit 1; }
