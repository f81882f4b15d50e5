# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Signed distances and sides: the field, as VTK reads it too, and offsets as sources of another run."""

import math

from program_bench import (HORIZONTAL, TILTED, check, check_close, from_center, from_segment, read_ply, run_test)


def read_field(path):
    """Names of the vertex properties, and the vertices."""
    return read_ply(path)["vertex"]


def test_polylines(bench):
    """Offsets as sources of another run: the offsets of a circle are circles."""
    mesh = bench.grid(HORIZONTAL)
    circle, field = bench.path("circle.polylines.txt"), bench.path("field.ply")
    bench.run(mesh, *bench.center(HORIZONTAL), "--distance", 3, "--tolerance", 1e-6, "--output", circle)
    stats = bench.run(mesh, "--source-polyline", circle, "--distance", 1, "--field", field)
    check(stats["curves"][0]["number"] == stats["curves"][0]["closed"] == 2, "two circles")
    check_close(stats["curves"][0]["length"], 12 * math.pi, 1e-4, "length of both")
    names, vertices = read_field(field)
    check(names == ["x", "y", "z", "distance", "signed_distance"], "properties %s" % names)
    for v in vertices:
        # the curve has the smaller distances on its left, so its left is inside
        check_close(v["signed_distance"], from_center((v["x"], v["y"])) - 3, 2e-6, "signed distance from a circle")
    inside = bench.run(mesh, "--source-polyline", circle, "--distance", 1, "--side", "inside")
    check_close(inside["curves"][0]["length"], 4 * math.pi, 1e-4, "length inside")
    outside = bench.run(mesh, "--source-polyline", circle, "--distance", 1, "--side", "outside")
    check_close(outside["curves"][0]["length"], 8 * math.pi, 1e-4, "length outside")


def test_field(bench):
    field = bench.path("field.ply")
    mesh = bench.grid(TILTED)
    bench.run(mesh, *bench.segment(TILTED), "--field", field)
    names, vertices = read_field(field)
    check(names == ["x", "y", "z", "distance", "signed_distance"] and len(vertices) == 169, "properties %s" % names)
    sides = set()
    for v in vertices:
        distance, side = from_segment(TILTED.plane((v["x"], v["y"], v["z"])))
        check_close(v["distance"], distance, 1e-12 * 12, "distance")
        signed = v["signed_distance"]
        sides.add(side)
        if side == 3:
            check(math.isnan(signed), "no sign beyond the ends: %g" % signed)
        elif side is not None:
            check_close(signed, -distance if side == 1 else distance, 1e-12 * 12, "signed distance")
    check(sides >= {1, 2, 3}, "vertices on all sides")

    # a plane section has the positive side of the plane on its left
    for a, b, c, d in ((1, -2, 0.5, 1), (-1, 2, -0.5, -1)):
        bench.run(mesh, "--source-plane", "%g,%g,%g,%g" % (a, b, c, d), "--field", field)
        left = right = 0
        for v in read_field(field)[1]:
            signed, value = v["signed_distance"], a * v["x"] + b * v["y"] + c * v["z"] + d
            if math.isnan(signed):
                continue
            check_close(abs(signed), v["distance"], 0, "absolute value")
            check(abs(value) < 1e-9 or (signed < 0) == (value > 0), "side of a section")
            left += signed < 0
            right += signed > 0
        check(left > 20 and right > 20, "vertices on both sides of a section: %d, %d" % (left, right))

    # without polylines there are no sides
    bench.run(mesh, *bench.center(TILTED), "--source-boundary", "--field", field)
    check(read_field(field)[0] == ["x", "y", "z", "distance"], "properties without polylines")

    try:
        from vtkmodules.vtkIOPLY import vtkPLYReader
    except ImportError:
        print("without python3-vtk9: its reader of PLY is left out")
        return
    bench.run(mesh, *bench.segment(TILTED), "--field", field)
    reader = vtkPLYReader()
    reader.SetFileName(field)
    reader.Update()
    check(reader.GetOutput().GetNumberOfPoints() == 169 and reader.GetOutput().GetNumberOfPolys() == 288, "PLY in VTK")


if __name__ == "__main__":
    run_test(polylines=test_polylines, field=test_field)
