# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths of the program in both of its formats, and the farthest point: closed forms in a plane, as VTK reads the file."""

import math

from program_bench import (A, B, HORIZONTAL, TILTED, chain_length, check, check_close, from_center, from_segment,
                           read_polylines, run_test, vtk_readers)
from test_program_picture import REACH, from_boundary, write_plate
from test_program_vtk import read_vtk

QUERIES = ((1.2, 2.3), (10.7, 8.9), (5, 5.3), (9.4, 7.2))


def nearest_on_segment(p):
    ab = (B[0] - A[0], B[1] - A[1])
    t = ((p[0] - A[0]) * ab[0] + (p[1] - A[1]) * ab[1]) / (ab[0] ** 2 + ab[1] ** 2)
    t = min(max(t, 0), 1)
    return A[0] + t * ab[0], A[1] + t * ab[1]


def test_paths(bench):
    vtkPolyDataReader = vtk_readers("vtkIOLegacy.vtkPolyDataReader")
    plane = TILTED
    mesh = bench.grid(plane)
    with open(mesh) as file:
        vertices = [tuple(map(float, line.split())) for line in file.read().split("\n")[2:171]]
    chosen = (0, 40, 168)
    options = [word for q in QUERIES for word in ("--path-from", plane.text(q))]
    options += [word for v in chosen for word in ("--path-from-vertex", v)]
    text, vtk = bench.path("paths.polylines.txt"), bench.path("paths.vtk")
    bench.run(mesh, *bench.segment(plane), *options, "--path-output", text, "--path-output", vtk)
    starts = [plane.plane(vertices[v]) for v in chosen] + list(QUERIES)
    paths = read_polylines(text)
    lines, cells, _, data = read_vtk(vtkPolyDataReader(), vtk)
    check(cells == {"distance", "query", "source", "side"}, "cell arrays %s" % cells)
    check(data.GetCellData().GetScalars().GetName() == "distance", "distance is active")
    check(len(paths) == len(lines) == len(starts), "%d and %d paths" % (len(paths), len(lines)))
    for i, (start, path, line) in enumerate(zip(starts, paths, lines)):
        check(path == [tuple(p) for p in line["points"]], "both files have the same points")
        distance, side = from_segment(start)
        check_close(chain_length(path), distance, 1e-10, "length of path %d" % i)
        check_close(line["cell"]["distance"], distance, 1e-10, "distance of path %d" % i)
        check(line["cell"]["query"] == i and line["cell"]["source"] == 0, "query and source of path %d" % i)
        check(line["cell"]["side"] == side, "side %g of path %d, not %s" % (line["cell"]["side"], i, side))
        check(math.dist(plane.plane(path[0]), start) < 1e-10, "start of path %d" % i)
        check(math.dist(plane.plane(path[-1]), nearest_on_segment(start)) < 1e-9, "end of path %d" % i)
        check(len(path) > (2 if distance > 1 else 1), "path %d has a point on each edge" % i)

    # on the source: one point in the text, a line without length in VTK
    bench.run(mesh, "--source-vertex", 17, "--path-from-vertex", 17, "--path-output", text, "--path-output", vtk)
    check(len(read_polylines(text)[0]) == 1, "a path of one point")
    reader = vtkPolyDataReader()
    reader.SetFileName(vtk)
    reader.Update()
    check(reader.GetOutput().GetNumberOfLines() == 1 and reader.GetOutput().GetLength() >= 0, "a line of one point in VTK")

    # beyond the limit there is no path, with a warning; the numbers of the others remain
    far = ("--path-from-vertex", 0, "--path-from-vertex", 84)
    bench.run(mesh, *bench.center(plane), *far, "--maximum-distance", 3, "--path-output", vtk,
              warning="no path for --path-from-vertex 0")
    lines = read_vtk(vtkPolyDataReader(), vtk)[0]
    check([line["cell"]["query"] for line in lines] == [1], "the path that exists")
    bench.run(mesh, *bench.center(plane), "--path-from-vertex", 0, "--maximum-distance", 3, "--path-output", vtk,
              warning="no path for --path-from-vertex 0")
    check(len(read_vtk(vtkPolyDataReader(), vtk)[0]) == 0, "a file without paths")


def test_picture(bench):
    """The path is in the picture: blue pixels along it, and none without it."""
    vtkPNGReader = vtk_readers("vtkIOImage.vtkPNGReader")
    from test_program_picture import Picture
    mesh = bench.grid(HORIZONTAL)
    counts = []
    for path in ((), ("--path-from-vertex", 0)):
        bench.run(mesh, *bench.center(HORIZONTAL), *path, "--view", "0,0,1", "--picture", bench.path("p.png"))
        picture = Picture(vtkPNGReader, bench.path("p.png"))
        counts.append(sum(n for color, n in picture.colors().items() if max(abs(a - b) for a, b in zip(color, (24, 60, 190))) < 8))
    # a line 3.4 pixels wide from a corner to the middle of a square of more than 1000 pixels
    check(counts[0] == 0 and counts[1] > 1350, "blue pixels: %s" % counts)


def test_farthest(bench):
    for step in (None, 5):
        write_plate(bench.path("plate.off"), step)
        stats = bench.run(bench.path("plate.off"), "--source-boundary", "--farthest-point")
        x, y, z = stats["farthest_point"]
        check_close(stats["largest_distance"], REACH, 1e-12, "largest distance")
        check_close(from_boundary(x, y), REACH, 1e-9, "distance of the farthest point %g, %g" % (x, y))
        check(z == 0, "the farthest point is on the plate")
    stats = bench.run(bench.grid(HORIZONTAL), *bench.center(HORIZONTAL), "--farthest-point")
    p = HORIZONTAL.plane(stats["farthest_point"])
    check(p == (0, 0) or p == (12, 0) or p == (0, 12) or p == (12, 12), "the farthest point of a square is a corner: %s" % (p,))
    check_close(from_center(p), stats["largest_distance"], 1e-12, "its distance")
    check("farthest_point" not in bench.run(bench.grid(HORIZONTAL), *bench.center(HORIZONTAL)), "only if requested")


if __name__ == "__main__":
    run_test(paths=test_paths, picture=test_picture, farthest=test_farthest)
