#!/bin/sh
# Checks that every public header tells by which licence it may be used, as those of CGAL do.
# Usage: license.sh COMPILER
set -eu
cd "$(dirname "$0")/../../include"
license=CGAL/license/Point_set_skeletonization_3.h
without=$(grep -L "#include <$license>" CGAL/*.h CGAL/IO/*.h \
  CGAL/Point_set_skeletonization_3/*.h || true)
[ -z "$without" ] || { echo "without the licence: $without"; exit 1; }

# What a compiler says of the header, with these options.
said() {
  echo "#include <$license>" | LC_ALL=C "$compiler" "$@" -I. -x c++ -fsyntax-only - 2>&1 || true
}
compiler=$1
[ -z "$(said)" ] || { echo "it says something without being asked"; exit 1; }
said -DCGAL_LICENSE_WARNING | grep "Point Set Skeletonization package under .* GPLv3+"
said -DCGAL_LICENSE_ERROR | grep "error.*Point Set Skeletonization package"
