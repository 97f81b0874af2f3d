#!/bin/sh
# Installs the package into a folder of its own and builds and runs another project that finds it.
# Usage: run.sh BUILD_FOLDER CMAKE GENERATOR COMPILER
set -eu
build=$1 cmake=$2 generator=$3 compiler=$4
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$cmake" --install "$build" --prefix "$work/prefix" > "$work/install.log"
diff -r "$here/../../include" "$work/prefix/include" # all headers, as they are
if [ -e "$build/examples/skeletonize_point_set" ]; then
  "$work/prefix/bin/skeletonize_point_set" --help > "$work/help"
  if [ -e "$build/examples/skeletonize_point_set.1" ]; then
    grep -q "^.SH EXAMPLES\|Examples:" "$work/prefix/share/man/man1/skeletonize_point_set.1"
  fi
fi
# Another build type than ours, without the debugging information, which takes time.
"$cmake" -S "$here" -B "$work/build" -G "$generator" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG= -DCMAKE_PREFIX_PATH="$work/prefix"
"$cmake" --build "$work/build"
cd "$work"
build/header_only
build/compiled
test -s one_vertex.ply
