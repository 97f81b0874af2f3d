#!/bin/sh
# Another project with this package as a subfolder: builds what it links, which is the headers alone, and
# installs its own only.
# Usage: run.sh BUILD_FOLDER CMAKE GENERATOR COMPILER
set -eu
cmake=$2 generator=$3 compiler=$4
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$cmake" -S "$here" -B "$work/build" -G "$generator" -DCMAKE_CXX_COMPILER="$compiler" \
  -DPACKAGE="$here/../.."
if grep -E '^(CLI11|nlohmann_json|Catch2|LASLIB|CGAL_DATA)_DIR|^JAVASCRIPT_DIR|^CMAKE_BUILD_TYPE:.*=.' \
    "$work/build/CMakeCache.txt"; then
  echo "FAILED: looked for, or set, by a guest"
  exit 1
fi
"$cmake" --build "$work/build"
"$cmake" --install "$work/build" --prefix "$work/prefix"
(cd "$work/prefix" && find . -type f) > "$work/installed"
[ "$(cat "$work/installed")" = ./host/CMakeLists.txt ] ||
  { echo "FAILED: installed by a guest:"; cat "$work/installed"; exit 1; }
"$work/build/header_only"
if find "$work/build" -name "*compiled*.o*" | grep .; then
  echo "FAILED: compiled, though nothing links it"
  exit 1
fi
