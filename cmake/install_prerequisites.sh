#!/bin/sh
# Installs what is missing to build, test and draw, on Debian and its relatives; run from anywhere.
# Does nothing if nothing is missing.
set -eu
packages="cmake ninja-build g++ libcgal-dev libeigen3-dev libtbb-dev catch2 libcli11-dev
  nlohmann-json3-dev python3-matplotlib
  libjs-three libjs-chart.js libjs-jquery libjs-jquery-tablesorter
  chromium chromium-driver python3-selenium"

missing=
for package in $packages; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2> /dev/null || true)
  [ "$status" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

echo "Installing:$missing"
as_root=
[ "$(id -u)" = 0 ] || as_root=sudo
$as_root apt-get update -q
# shellcheck disable=SC2086 # one word per package
$as_root env DEBIAN_FRONTEND=noninteractive \
  apt-get install -q -y --no-install-recommends -o DPkg::Lock::Timeout=600 $missing
