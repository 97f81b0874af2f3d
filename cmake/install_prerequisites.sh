#!/bin/sh
# Installs what is missing on Debian and its relatives; run from anywhere. Does nothing if nothing is.
# Usage: install_prerequisites.sh program|test|all
#   program  to build the program, with its pages and pictures
#   test     also for the program of many processes, the Python module and the tests
#   all      also for the comparison, for pages in a browser, files read by VTK, and the manual
set -eu
program="cmake ninja-build g++ libcgal-dev libeigen3-dev libtbb-dev libcli11-dev nlohmann-json3-dev
  libcairo2-dev libjs-three"
test="catch2 help2man python3-dev pybind11-dev python3-dask python3-matplotlib python3-numpy
  python3-ezdxf python3-meshio python3-networkx libboost-mpi-dev openmpi-bin procps"
report="doxygen libjs-chart.js libjs-jquery libjs-jquery-tablesorter
  chromium chromium-driver python3-selenium python3-vtk9 clang-tidy valgrind"
case ${1-} in
  program) packages=$program ;;
  test) packages="$program $test" ;;
  all) packages="$program $test $report" ;;
  *) echo "usage: install_prerequisites.sh program|test|all" >&2; exit 2 ;;
esac

missing=
for package in $packages; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2> /dev/null || true)
  [ "$status" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

echo "== Installing$missing"
as_root=
[ "$(id -u)" = 0 ] || as_root=sudo
$as_root apt-get update -q
# shellcheck disable=SC2086 # one word per package
$as_root env DEBIAN_FRONTEND=noninteractive \
  apt-get install -q -y --no-install-recommends -o DPkg::Lock::Timeout=600 $missing
