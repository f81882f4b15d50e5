#!/bin/sh
# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# User seconds of the compiler for the small programs of this folder, beyond those for kernel and mesh alone, and its memory: linked
# with the compiled library, and header-only. As a Markdown table. Needs GNU time.
#
#   compile_times.sh [RUNS [OPTIONS OF THE COMPILER...]]       default: 3 runs, -O2; the least time counts

set -eu
folder=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
include=$(CDPATH='' cd -- "$folder/../../../../include" && pwd)
runs=${1-3}
[ $# -gt 0 ] && shift
[ $# -gt 0 ] || set -- -O2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# measure FILE OPTION...: the least user seconds, and megabytes
measure() {
  file=$1
  shift
  least= megabytes=
  for _ in $(seq "$runs"); do
    /usr/bin/time -o "$scratch/time" -f '%U %M' "${CXX:-g++}" -std=c++17 "$@" -I"$include" -c "$folder/$file" -o "$scratch/object.o"
    read -r seconds kilobytes <"$scratch/time"
    least=$(echo "$seconds ${least:-1e9}" | awk '{ print $1 < $2 ? $1 : $2 }')
    megabytes=$((kilobytes / 1024))
  done
}

measure kernel_and_mesh.cpp "$@"
base=$least
echo "kernel and mesh: $base s, $megabytes MB"
echo
echo "| program | compiled library, s | MB | header-only, s | MB |"
echo "|---|---|---|---|---|"
for program in distances_from_vertex offsets_of_polyline class_with_paths voronoi_diagram exact_distances; do
  measure $program.cpp -DCGAL_GEODESIC_OFFSET_COMPILED "$@"
  compiled=$least compiled_megabytes=$megabytes
  measure $program.cpp "$@"
  echo "$compiled $compiled_megabytes $least $megabytes" |
    awk -v base="$base" -v name="$program" '{ printf "| %s | %.1f | %d | %.1f | %d |\n", name, $1 - base, $2, $3 - base, $4 }'
done
