#!/usr/bin/env bash
# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds the benchmarks, runs them, and writes their tables and plots; under 15 minutes on two cores:
#
#   benchmark/Surface_mesh_geodesic_offset/run_benchmarks.sh [--limit N] [--jobs N] [--build DIR] [--doc]
#
# --limit  the largest number of vertices of the ladder of sizes; 262144 by default. A million takes 20 minutes more.
# --jobs   how many files are compiled at once; all cores by default. Programs run one at a time.
# --build  where to build; build-benchmark by default. The results go to its folder `benchmarks`.
# --doc    put benchmarks.md and its pictures into the folder of the manual, too.
#
# Meshes come from the folder in the environment variable GEODESIC_OFFSET_DATA_DIR (CGAL's data/meshes), else from where
# test/run_tests.sh has put them; without them the generated ones remain.
# The exit code is 1 if a program fails or finds a fault; the others run nevertheless.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$root/build-benchmark
limit=262144
jobs=$(getconf _NPROCESSORS_ONLN)
doc=
while [ $# -gt 0 ]; do
  case $1 in
    --limit | --jobs | --build)
      [ $# -gt 1 ] || { echo "run_benchmarks.sh: $1 needs a value" >&2; exit 2; }
      declare "${1#--}=$2"
      shift 2 ;;
    --doc) doc=yes; shift ;;
    *) sed -n 's/^# \{0,1\}//; 5,16p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
  esac
done

data=${GEODESIC_OFFSET_DATA_DIR:-$root/build-tests/data/meshes}
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release \
  -DGEODESIC_OFFSET_BUILD_TESTING=OFF -DGEODESIC_OFFSET_BUILD_EXAMPLES=OFF -DGEODESIC_OFFSET_BUILD_BENCHMARK=ON
cmake --build "$build" -j "$jobs" --target size_ladder scaling peers hard_meshes flat_meshes bounded_error tolerance_times tolerance_bounds tolerance_offsets certified_bounds \
  window_counts point_source_against_smsp parallel

bin=$build/bin
results=$build/benchmarks
mkdir -p "$results"
result=0

# Runs a program; its table goes to a file, its errors to another file beside it.
run()
{
  local table=$1 start=$SECONDS
  shift
  if ! "$@" > "$results/$table" 2> "$results/${table%.*}.log"; then
    echo "$(basename "$1") FAILED, see $results/${table%.*}.log and $results/$table" >&2
    result=1
  fi
  echo "$(basename "$1"): $((SECONDS - start)) s"
}

meshes=()
for name in elephant fandisk armadillo bunny00; do
  [ -r "$data/$name.off" ] && meshes+=("$data/$name.off")
done
run flat_meshes.md "$bin/flat_meshes"
run bounded_error.md "$bin/bounded_error" --limit "$limit"
rm -f "$results"/{certified_bounds,tolerance_bounds,tolerance_offsets,tolerance_times,window_counts,point_source_against_smsp}.md
if [ ${#meshes[@]} -gt 0 ]; then
  run certified_bounds.md "$bin/certified_bounds" --repeat 9 "${meshes[@]}"
  run tolerance_bounds.md "$bin/tolerance_bounds" "${meshes[@]}"
  run tolerance_offsets.md "$bin/tolerance_offsets" "${meshes[@]}"
  run tolerance_times.md "$bin/tolerance_times" --vertices "$limit" "${meshes[@]}"
  run window_counts.md "$bin/window_counts" "${meshes[@]}"
  run point_source_against_smsp.md "$bin/point_source_against_smsp" "${meshes[@]}"
fi
run peers.tsv "$bin/peers" --torus 4000 --torus 16000 --torus 64000 ${meshes[@]+"${meshes[@]}"}
if [ -d "$data" ]; then
  run hard_meshes.tsv "$bin/hard_meshes" "$data"
else
  run hard_meshes.tsv "$bin/hard_meshes"
fi
run parallel.md "$bin/parallel" --runs 3 ${meshes[@]+"${meshes[@]}"}
run scaling.md "$bin/scaling"
run size_ladder.tsv "$bin/size_ladder" --limit "$limit"

export PYTHONDONTWRITEBYTECODE=1
python3 "$here/plot_tables.py" "$results"
if [ -n "$doc" ]; then
  manual=$root/doc/Surface_mesh_geodesic_offset
  python3 "$here/plot_tables.py" "$results" "$manual" "$manual/fig"
fi
echo "$results/benchmarks.md"
exit $result
