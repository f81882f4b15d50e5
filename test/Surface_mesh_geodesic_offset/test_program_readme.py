# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What README.md says about the program: its options, the example of its polyline format, levels, files, and exit codes."""

import os
import re
import subprocess

from program_bench import HORIZONTAL, check, check_levels, run_test

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def read(name):
    with open(os.path.join(ROOT, name), encoding="utf-8") as file:
        return file.read()


def run(program, *arguments):
    return subprocess.run([program, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True, timeout=300)


def test_options(bench):
    """The options of --help are the options of the tables."""
    readme = read("README.md")
    tables = readme[readme.index("### geodesic_offset"):readme.index("### validate_geodesic_distances")]
    described = set(re.findall(r"--[a-z-]+", "\n".join(re.findall(r"^\| (`-.*?) \|", tables, re.MULTILINE))))
    listed = set(re.findall(r"^ *(--[a-z-]+)", run(bench.program, "--help").stdout, re.MULTILINE))
    check(len(listed) > 20 and described == listed, "not in README.md: %s, not in --help: %s"
          % (sorted(listed - described), sorted(described - listed)))
    version = re.search(r"VERSION (\d+\.\d+\.\d+)", read("CMakeLists.txt")).group(1)
    check(run(bench.program, "--version").stdout.startswith("geodesic_offset " + version + " "), "the version")


def test_statements(bench):
    mesh = bench.grid(HORIZONTAL)

    # the example of the format is a segment and a triangle
    example = re.search(r"```\n(2  0 .*?)```", read("README.md"), re.DOTALL).group(1)
    curves = bench.path("curves.polylines.txt")
    with open(curves, "w") as file:
        file.write(example)
    result = run(bench.program, mesh, "--source-polyline", curves, "--distance", 0.1, "--side", "left")
    check(result.returncode == 0 and "2 sources" in result.stdout, "two polylines: %s%s" % (result.stdout, result.stderr))
    check("warning" in result.stderr, "a warning about points away from the surface")
    result = run(bench.program, mesh, "--source-polyline", curves, "--distance", 0.1, "--side", "inside")
    check(result.returncode == 1 and "line 1" in result.stderr, "the segment is open: " + result.stderr)

    # levels
    center = bench.center(HORIZONTAL)
    check_levels(bench.run(mesh, *center, "--spacing", 0.5, "--count", 2), [0.5, 1])
    check_levels(bench.run(mesh, *center, "--spacing", 0.5, "--start", 0.75, "--count", 2), [0.75, 1.25])
    check_levels(bench.run(mesh, *center, "--spacing", 0.5, "--count", 2, "--distance", 0.7, "--distance", 0.2),
                 [0.2, 0.5, 0.7, 1])

    # exit codes, with one line
    for code, arguments in ((2, (mesh,)), (2, (mesh, *center, "--spacing", 1e-4)), (2, (mesh, *center, "--unknown")),
                            (1, (bench.path("none.off"), *center)), (1, (mesh, "--source-vertex", 1000000))):
        result = run(bench.program, *arguments)
        check(result.returncode == code and len(result.stderr.splitlines()) == 1,
              "exit code %d, not %d: %s" % (result.returncode, code, result.stderr))

    # files
    names = [bench.path("offsets" + e) for e in (".polylines.txt", ".vtk", ".obj", ".dxf", ".svg")]
    outputs = [word for name in names for word in ("--output", name)]
    bench.run(mesh, *center, "--distance", 1, *outputs, "--unit", "mm")
    check(all(os.path.getsize(name) > 0 for name in names), "a file of each format")
    with open(names[0]) as file:
        words = file.read().split()
    check(len(words) == 1 + 3 * int(words[0]) and words[1:4] == words[-3:], "a closed curve repeats its first point")


run_test(options=test_options, statements=test_statements)
