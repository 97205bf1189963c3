#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Unpacks Debian's ParaView with what it needs into a folder (600 MB), without installing it: as a package it would remove
# python3-vtk9. The test nightly/paraview then uses it: cmake -DSOFTGRAIN_PARAVIEW=FOLDER build/release
set -e
[ $# -eq 1 ] || { echo "usage: $0 FOLDER" >&2; exit 2; }
mkdir -p "$1/packages"
cd "$1"
packages=$(apt-get install --simulate --no-install-recommends paraview python3-paraview | awk '/^Inst/ { print $2 }')
# shellcheck disable=SC2086
(cd packages && apt-get download $packages)
for package in packages/*.deb; do
  dpkg -x "$package" .
done
rm -r packages
