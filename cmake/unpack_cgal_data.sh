#!/bin/sh
# Unpacks CGAL's sample models into FOLDER/data, from Debian's package libcgal-demo.
# Usage: unpack_cgal_data.sh FOLDER
set -eu
folder=$1
[ ! -e "$folder/data" ] || exit 0
mkdir -p "$folder"
cd "$folder"

archive=usr/share/doc/libcgal-dev/data.tar.gz
if [ -e "/$archive" ]; then
  archive=/$archive
else
  # A slim system leaves out /usr/share/doc when it installs a package, so take the archive out of
  # the package instead of installing it.
  apt-get download -q libcgal-demo
  dpkg-deb -x libcgal-demo_*.deb .
fi
# Only a complete folder gets its name.
mkdir -p unpacking
tar -xzf "$archive" -C unpacking
mv unpacking/data data
rm -rf unpacking usr libcgal-demo_*.deb
