#!/bin/sh
# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs the required packages (Debian), builds the program, and runs it on a generated mesh or on the given one.
# Offsets, distances and a picture are in out/ afterwards.
#
#   examples/run_example.sh [MESH]

set -eu

if [ $# -gt 1 ]; then
  echo "usage: $0 [MESH]" >&2
  exit 2
fi

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
build=$root/build
out=$root/out

mesh=${1-}
if [ -n "$mesh" ]; then
  if [ ! -r "$mesh" ]; then
    echo "$0: cannot read '$mesh'" >&2
    exit 1
  fi
  mesh=$(CDPATH='' cd -- "$(dirname -- "$mesh")" && pwd)/$(basename -- "$mesh")
fi

install_packages() {
  packages="g++ cmake ninja-build libcgal-dev libboost-dev libboost-program-options-dev libgmp-dev libmpfr-dev libpng-dev zlib1g-dev libtbb-dev"
  missing=
  for package in $packages; do
    if ! dpkg-query -W -f='${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^.i'; then
      missing="$missing $package"
    fi
  done
  [ -n "$missing" ] || return 0
  echo "installing:$missing"
  sudo=
  [ "$(id -u)" -eq 0 ] || sudo=sudo
  $sudo apt-get update
  # shellcheck disable=SC2086 # a list of words
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
}

if command -v apt-get >/dev/null 2>&1; then
  install_packages
fi
# make would compile the program only after the whole library
if command -v ninja >/dev/null 2>&1; then
  export CMAKE_GENERATOR=Ninja # of new build folders
fi

# a compiler takes up to 1.4 GB
jobs=$(nproc 2>/dev/null || echo 1)
[ "$jobs" -le 4 ] || jobs=4

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release
if [ ! -x "$build/bin/geodesic_offset" ]; then
  echo "Compiling the library and the program geodesic_offset, with up to $jobs compilers at a time: two to three minutes with two."
fi
cmake --build "$build" --target geodesic_offset generate_example_mesh -j "$jobs"

mkdir -p "$out"
program=$build/bin/geodesic_offset
if [ -n "$mesh" ]; then
  # the largest distance from the first vertex determines the spacing for about twenty offsets
  set -- --source-vertex 0
  echo "Computing distances from vertex 0, for the spacing of the offsets."
  "$program" "$mesh" "$@" --quiet --stats "$out/stats.json"
  spacing=$(awk -F '[:,]' '/"largest_distance"/ { print $2 / 20 }' "$out/stats.json")
else
  mesh=$out/vase.off
  curve=$out/vase.polylines.txt
  echo "Generating a mesh and a curve."
  "$build/bin/generate_example_mesh" "$mesh" "$curve"
  set -- --source-polyline "$curve"
  spacing=0.1
fi

"$program" "$mesh" "$@" --spacing "$spacing" \
  --output "$out/offsets.polylines.txt" --output "$out/offsets.vtk" \
  --field "$out/field.ply" --picture "$out/picture.png" --stats "$out/stats.json"

echo "Offsets, distances, picture and figures are in $out."
