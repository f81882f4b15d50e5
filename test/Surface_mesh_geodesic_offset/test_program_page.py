# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the page of the programs says about `geodesic_offset`: its options, and the example of its polyline format."""

import os
import re

from program_bench import HORIZONTAL, check, run_test

PAGE = "doc/Surface_mesh_geodesic_offset/programs.md"
ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def read(name):
    with open(os.path.join(ROOT, name), encoding="utf-8") as file:
        return file.read()


def test_options(bench):
    """The options of --help are the options of the tables."""
    page = read(PAGE)
    tables = page[page.index("## geodesic_offset"):page.index("## geodesic_distance_matrix")]
    described = set(re.findall(r"--[a-z-]+", "\n".join(re.findall(r"^\| (`-.*?) \|", tables, re.MULTILINE))))
    listed = set(re.findall(r"^ *(--[a-z-]+)", bench.start("--help").stdout, re.MULTILINE))
    check(len(listed) > 20 and described == listed, "not on the page: %s, not in --help: %s"
          % (sorted(listed - described), sorted(described - listed)))
    version = re.search(r"VERSION (\d+\.\d+\.\d+)", read("CMakeLists.txt")).group(1)
    check(bench.start("--version").stdout.startswith("geodesic_offset " + version + " "), "the version")


def test_polylines(bench):
    mesh = bench.grid(HORIZONTAL)

    # the example of the format is a segment and a triangle
    example = re.search(r"```\n(2  0 .*?)```", read(PAGE), re.DOTALL).group(1)
    curves = bench.path("curves.polylines.txt")
    with open(curves, "w") as file:
        file.write(example)
    result = bench.start(mesh, "--source-polyline", curves, "--distance", 0.1, "--side", "left")
    check(result.returncode == 0 and "2 sources" in result.stdout, "two polylines: %s%s" % (result.stdout, result.stderr))
    check("warning" in result.stderr, "a warning about points away from the surface")
    result = bench.start(mesh, "--source-polyline", curves, "--distance", 0.1, "--side", "inside")
    check(result.returncode == 1 and "line 1" in result.stderr, "the segment is open: " + result.stderr)


run_test(options=test_options, polylines=test_polylines)
