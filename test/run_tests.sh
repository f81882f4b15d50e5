#!/usr/bin/env bash
# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds everything and runs the tests, starting from a fresh Debian 12:
#
#   test/run_tests.sh [arguments for ctest]        for example: test/run_tests.sh -R offset
#
# Missing Debian packages are installed (as root, or through sudo). The build goes to build-tests/, and the
# meshes of the Debian package libcgal-demo to build-tests/data/meshes. The tests find those through the
# CMake variable GEODESIC_OFFSET_DATA_DIR; set the environment variable of the same name to a folder of
# meshes of your own (or of another CGAL release) to use that instead.
# Some tests run few of their cases; with the environment variable GEODESIC_OFFSET_ALL_CASES they run all.
# The last lines are ctest's summary, and the exit code is ctest's.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build-tests
packages=(g++ cmake ninja-build libcgal-dev libcgal-demo libboost-program-options-dev libboost-dev libpng-dev zlib1g-dev libeigen3-dev
          libgmp-dev libmpfr-dev libtbb-dev libopenmesh-dev python3 python3-dev python3-numpy pybind11-dev libboost-mpi-dev doxygen)
# Readers of the program's files in the tests, and clang-format: large packages, which are installed while the compiler runs.
packages_of_tests=(python3-vtk9 python3-ezdxf python3-svgelements python3-matplotlib librsvg2-bin clang-format)

as_root()
{
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  else
    sudo "$@"
  fi
}

is_installed()
{
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# install_missing(package...)
install_missing()
{
  local missing=() package
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  echo "Installing ${missing[*]}"
  as_root apt-get update
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
}

# Leaves the folder `data/meshes` of CGAL's example data in $1/meshes: all of it or nothing.
unpack_meshes()
{
  local target=$1 archive=/usr/share/doc/libcgal-dev/data.tar.gz scratch
  [ -d "$target/meshes" ] && return
  mkdir -p "$target"
  scratch=$(mktemp -d "$target/unpacking.XXXXXX")
  if [ ! -r "$archive" ]; then
    # Slim images of Debian install packages without their files under /usr/share/doc.
    (cd "$scratch" && apt-get download libcgal-demo && dpkg-deb --extract libcgal-demo_*.deb .)
    archive=$scratch$archive
  fi
  tar -xzf "$archive" -C "$scratch" data/meshes
  mv "$scratch/data/meshes" "$target/meshes"
  rm -rf "$scratch"
}

# Leaves the headers of CGAL of the next release of Debian in $1/include, by the package sources of this system under the name of
# that release. Without them, the test that compiles with a newer CGAL is skipped.
unpack_newer_cgal()
{
  local target=$1 scratch source
  [ -d "$target/include/CGAL" ] && return
  grep -q '^VERSION_CODENAME=bookworm$' /etc/os-release || return
  mkdir -p "$target"
  scratch=$(mktemp -d "$target/unpacking.XXXXXX")
  mkdir -p "$scratch/sources" "$scratch/lists/partial" "$scratch/cache/archives/partial"
  for source in /etc/apt/sources.list /etc/apt/sources.list.d/*; do
    if [ -r "$source" ] && grep -q bookworm "$source"; then
      sed s/bookworm/trixie/g "$source" >"$scratch/sources/${source##*/}"
    fi
  done
  (
    cd "$scratch"
    options=(-o "Dir::Etc::sourcelist=/dev/null" -o "Dir::Etc::sourceparts=$scratch/sources" -o "Dir::State::lists=$scratch/lists"
             -o "Dir::State::status=/dev/null" -o "Dir::Cache=$scratch/cache")
    apt-get "${options[@]}" update && apt-get "${options[@]}" download libcgal-dev && dpkg-deb --extract libcgal-dev_*.deb . &&
      mv usr/include "$target/include"
  )
  rm -rf "$scratch"
}

installation=
if command -v dpkg-query >/dev/null; then
  install_missing "${packages[@]}"
  if [ -z "${GEODESIC_OFFSET_DATA_DIR:-}" ]; then
    unpack_meshes "$build/data"
    GEODESIC_OFFSET_DATA_DIR=$build/data/meshes
  fi
  mkdir -p "$build"
  unpack_newer_cgal "$build/newer_cgal" >"$build/newer_cgal.log" 2>&1 || true
fi
export GEODESIC_OFFSET_DATA_DIR=${GEODESIC_OFFSET_DATA_DIR:-}

# make would compile the programs only after the whole library
if command -v ninja >/dev/null; then
  export CMAKE_GENERATOR=Ninja # of new build folders
fi
# -O1, except for the library, and programs that no test runs are only checked: most of the time of a fresh clone goes into compiling.
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" \
  -DGEODESIC_OFFSET_ONLY_CHECK_PROGRAMS=ON \
  -DGEODESIC_OFFSET_NEWER_CGAL_INCLUDE_DIR="$build/newer_cgal/include" \
  -DGEODESIC_OFFSET_DATA_DIR="$GEODESIC_OFFSET_DATA_DIR"
if command -v dpkg-query >/dev/null; then
  install_missing "${packages_of_tests[@]}" >"$build/packages.log" 2>&1 &
  installation=$!
fi
cmake --build "$build" -j "$(nproc)"
if [ -n "$installation" ] && ! wait "$installation"; then
  cat "$build/packages.log" >&2
  exit 1
fi
cd "$build"
exec ctest --output-on-failure -j "$(nproc)" "$@"
