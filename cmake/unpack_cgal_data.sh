#!/bin/sh
# Unpacks CGAL's sample models into FOLDER/data, from Debian's package libcgal-demo.
# Usage: unpack_cgal_data.sh FOLDER
set -eu
folder=$1
[ ! -e "$folder/data" ] || exit 0
echo "== Unpacking CGAL's sample models into $folder"
mkdir -p "$folder"
cd "$folder"

archive=usr/share/doc/libcgal-dev/data.tar.gz
if [ -e "/$archive" ]; then
  archive=/$archive
else
  # Not installed, because a slim system leaves out /usr/share/doc when it installs a package; only
  # taken apart here. A system that has not been asked for anything yet may lack the package lists.
  if ! apt-get download -q libcgal-demo; then
    as_root=
    [ "$(id -u)" = 0 ] || as_root=sudo
    $as_root apt-get update -q
    apt-get download -q libcgal-demo
  fi
  dpkg-deb -x libcgal-demo_*.deb .
fi
# Only a complete folder gets its name.
mkdir -p unpacking
tar -xzf "$archive" -C unpacking
mv unpacking/data data
rm -rf unpacking usr libcgal-demo_*.deb
