#!/bin/sh
# Installs what is missing, unpacks CGAL's sample models and configures the folder build/.
# Usage: prepare.sh program|test|all [CMAKE_OPTION]...; what the first means is in
# install_prerequisites.sh
set -eu
cd "$(dirname "$0")/.."
sh cmake/install_prerequisites.sh "$1"
shift
sh cmake/unpack_cgal_data.sh build/cgal_data
echo "== Configuring build/"
# Python packages are installed for this interpreter, not for another that may be on the path.
cmake -S . -B build -G Ninja -DPython_EXECUTABLE=/usr/bin/python3 "$@"
