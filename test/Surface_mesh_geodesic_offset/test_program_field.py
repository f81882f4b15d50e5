# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Signed distances and sides: the field in all formats, as VTK reads it too, and offsets as sources of another run."""

import csv
import math

from program_bench import (A, B, HORIZONTAL, LENGTH, TILTED, check, check_close, from_center, from_segment, polyline_text,
                           read_ply, run_test, vtk_readers, write_grid)


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
    again, table = bench.path("again.ply"), bench.path("field.csv")
    bench.run(mesh, *bench.segment(TILTED), "--field", again, "--field", table)
    with open(field, "rb") as one, open(again, "rb") as other:
        check(one.read() == other.read(), "the first of two fields")
    with open(table) as file:
        rows = list(csv.reader(file))
    check(len(rows) == 170, "%d rows of the second field" % len(rows))
    down = bench.write("down.off", "OFF\n4 2 0\n0 0 0\n0 1 0\n1 1 0\n1 0 0\n3 0 1 2\n3 0 2 3\n")
    bench.run(down, "--source-vertex", 0, "--distance", 0.3, "--field", table, "--field-details", "--output",
              bench.path("offset.csv"))
    for name in (table, bench.path("offset.csv")):
        with open(name) as file:
            check("-0" not in file.read().replace("\n", ",").split(","), "-0 in " + name)
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


def test_details(bench):
    """Nearest sources, sides and gradients, and the same columns in all formats."""
    vtkDelimitedTextReader, vtkPolyDataReader = vtk_readers("vtkIOInfovis.vtkDelimitedTextReader", "vtkIOLegacy.vtkPolyDataReader")
    plane, far = TILTED, (10.2, 2.1)
    sources = (bench.grid(plane), "--source-point", plane.text(far), *bench.segment(plane))
    files = [bench.path("field" + extension) for extension in (".ply", ".vtk", ".csv")]
    names = ["x", "y", "z", "distance", "signed_distance", "source", "side", "gradient_x", "gradient_y", "gradient_z"]
    for limit in ((), ("--maximum-distance", 3)):
        for file in files:
            bench.run(*sources, *limit, "--field", file, "--field-details")
        found, vertices = read_field(files[0])
        check(found == names and len(vertices) == 169, "properties %s" % found)
        kinds = set()
        for v in vertices:
            p = plane.plane((v["x"], v["y"], v["z"]))
            to_far, (to_segment, side) = math.dist(p, far), from_segment(p)
            gradient = (v["gradient_x"], v["gradient_y"], v["gradient_z"])
            if limit and min(to_far, to_segment) > 3:
                check(v["distance"] == math.inf and v["source"] == -1 and v["side"] == 0 and gradient == (0, 0, 0),
                      "a vertex beyond the limit: %s" % v)
                kinds.add(None)
                continue
            nearest = far
            if to_far > to_segment:
                t = ((p[0] - A[0]) * (B[0] - A[0]) + (p[1] - A[1]) * (B[1] - A[1])) / LENGTH ** 2
                nearest = tuple(a + min(max(t, 0), 1) * (b - a) for a, b in zip(A, B))
            else:
                side = 0
            kinds.add((v["source"], v["side"]))
            check(v["source"] == (0 if nearest == far else 1), "source at %s" % (p,))
            check(side is None or v["side"] == side, "side at %s" % (p,))
            direction = plane.space(p), plane.space(nearest)
            expected = [(a - b) / v["distance"] for a, b in zip(*direction)]
            check(math.dist(gradient, expected) < 1e-9, "gradient %s at %s, not %s" % (gradient, p, expected))
        check(kinds == {(0, 0), (1, 1), (1, 2), (1, 3)} | ({None} if limit else set()), "sources and sides: %s" % kinds)

        with open(files[2], newline="") as file:
            rows = list(csv.reader(file))
        check(rows[0] == names and len(rows) == 170, "columns %s" % rows[0])
        same = all(float(x) == v[name] or x == "nan" and math.isnan(v[name])
                   for row, v in zip(rows[1:], vertices) for name, x in zip(names, row))
        check(same, "the table has the numbers of the PLY file")
        reader = vtkDelimitedTextReader()
        reader.SetFileName(files[2])
        reader.SetHaveHeaders(True)
        reader.Update()
        table = reader.GetOutput()
        check(table.GetNumberOfRows() == 169 and table.GetNumberOfColumns() == 10, "the table in VTK")

        reader = vtkPolyDataReader()
        reader.SetFileName(files[1])
        reader.ReadAllFieldsOn()
        reader.Update()
        data = reader.GetOutput()
        check(data.GetNumberOfPoints() == 169 and data.GetNumberOfPolys() == 288, "the mesh in VTK")
        arrays = data.GetPointData()
        check({arrays.GetArrayName(k) for k in range(arrays.GetNumberOfArrays())}
              == {"distance", "signed_distance", "source", "side", "gradient"}, "arrays in VTK")
        check(arrays.GetScalars().GetName() == "distance", "distance is active")
        for i, v in enumerate(vertices):
            values = [*data.GetPoint(i), *(arrays.GetArray(name).GetTuple1(i) for name in names[3:7]),
                      *arrays.GetArray("gradient").GetTuple3(i)]
            check(all(a == v[name] or math.isnan(a) and math.isnan(v[name]) for name, a in zip(names, values)),
                  "vertex %d in VTK: %s" % (i, values))
    ids = data.GetCell(0).GetPointIds()
    first = read_ply(files[0])["face"][1][0]["vertex_indices"]
    check(tuple(ids.GetId(k) for k in range(3)) == first, "the first face")


def test_sources(bench):
    """Start values, and one curve of a section, in files as VTK reads them."""
    vtkPolyDataReader = vtk_readers("vtkIOLegacy.vtkPolyDataReader")
    plane, far, files = TILTED, (10.2, 2.1), (bench.path("field.vtk"), bench.path("offsets.vtk"))
    reader = vtkPolyDataReader()
    reader.ReadAllFieldsOn()

    def read(path):
        reader.SetFileName(path)
        reader.Modified()
        reader.Update()
        return reader.GetOutput()

    # the point begins at 2, the segment at 0.25: an offset at 2.75 is a circle of radius 0.75 and a stadium of 2.5
    start = (2, 0.25)
    stats = bench.run(bench.grid(plane), "--source-point", plane.text(far), *bench.segment(plane),
                      "--start-value", "0,2", "--start-value", "1,0.25", "--field", files[0], "--field-details",
                      "--distance", 2.75, "--output", files[1])
    data = read(files[0])
    distance, source = (data.GetPointData().GetArray(name) for name in ("distance", "source"))
    for i in range(169):
        p = plane.plane(data.GetPoint(i))
        expected = (start[0] + math.dist(p, far), start[1] + from_segment(p)[0])
        check_close(distance.GetTuple1(i), min(expected), 1e-12 * 12, "distance with start values")
        check(abs(expected[0] - expected[1]) < 1e-9 or source.GetTuple1(i) == (0 if expected[0] < expected[1] else 1), "source")
    data = read(files[1])
    check(data.GetNumberOfPoints() > 20, "%d points of an offset" % data.GetNumberOfPoints())
    for i in range(data.GetNumberOfPoints()):
        p = plane.plane(data.GetPoint(i))
        check_close(min(start[0] + math.dist(p, far), start[1] + from_segment(p)[0]), 2.75, 1e-9, "an offset with start values")
    check(stats["curves"][0]["number"] > 0, "curves")
    # of the boundary, too: all of the reach, so that a spacing finds the last offset
    stats = bench.run(bench.grid(HORIZONTAL), "--source-boundary", "--start-value", "0,10", "--spacing", 1, "--start", 11)
    check([level["distance"] for level in stats["curves"] if level["number"] > 0] == [11, 12, 13, 14, 15],
          "offsets of the boundary with a start value: %s" % stats["curves"])
    check_close(stats["largest_distance"], 16, 1e-9, "largest distance with a start value")
    bench.run(bench.grid(HORIZONTAL), "--source-boundary", "--start-value", "0,10", "--distance", 9,
              warning="no offset at distance 9: the smallest --start-value is 10")

    # a section of two separate squares has two curves
    with open(bench.grid(HORIZONTAL)) as file:
        lines = file.read().rstrip("\n").split("\n")
    points, faces = [tuple(map(float, line.split())) for line in lines[2:171]], lines[171:]
    with open(bench.path("two.off"), "w") as out:
        out.write("OFF\n338 576 0\n")
        for shift in (0, 20):
            out.writelines("%.17g %.17g %.17g\n" % (x + shift, y, z) for x, y, z in points)
        for shift in (0, 169):
            out.writelines("3 %d %d %d\n" % tuple(int(i) + shift for i in face.split()[1:]) for face in faces)
    for near, low in (("6,1,3", 0), ("25,9,3", 20), (None, None)):
        bench.run(bench.path("two.off"), "--source-plane", "0,1,0,-5.1", *(("--section-near", near) if near else ()),
                  "--field", files[0],
                  warning="1 of 2 parts of the surface has no source: its 169 vertices are not reached" if near else None)
        data = read(files[0])
        distance = data.GetPointData().GetArray("distance")
        for i in range(338):
            x, y, _ = data.GetPoint(i)
            if low is None or low <= x <= low + 12:
                check_close(distance.GetTuple1(i), abs(y - 5.1), 1e-12 * 12, "distance from the section")
            else:
                check(distance.GetTuple1(i) == math.inf, "the other part is not reached")

    # one of the two borders
    bench.run(bench.path("two.off"), "--source-boundary", "--boundary-near", "21,13,5", "--field", files[0],
              warning="1 of 2 parts of the surface has no source: its 169 vertices are not reached")
    data = read(files[0])
    for i in range(338):
        x, y, _ = data.GetPoint(i)
        expected = min(x - 20, 32 - x, y, 12 - y) if x > 15 else math.inf
        actual = data.GetPointData().GetArray("distance").GetTuple1(i)
        check(actual == expected or abs(actual - expected) < 1e-11, "distance %g from one border, not %g" % (actual, expected))

    # one of two chains of sharp edges: a ramp between two horizontal parts
    def ramp(p):
        x = min((q for q in (4, 8) if abs(p[0] - q) < 0.25), default=p[0])
        return x, p[1], -0.75 * (min(max(x, 4), 8) - 4)

    write_grid(bench.path("ramp.off"), ramp)
    for near, chain in (("4.2,3,1", 4), ("8,9,-3", 9), (None, None)):
        bench.run(bench.path("ramp.off"), "--source-sharp-edges", 20, *(("--sharp-edges-near", near) if near else ()), "--field",
                  files[0])
        data = read(files[0])
        for i in range(169):
            x = data.GetPoint(i)[0]
            x = x + 0.25 * (min(max(x, 4), 8) - 4)  # unfolded
            expected = abs(x - chain) if chain else min(abs(x - 4), abs(x - 9))
            check_close(data.GetPointData().GetArray("distance").GetTuple1(i), expected, 1e-11, "distance from a sharp chain")

    # a chain that ends at corners where three sharp edges meet, and a closed one
    corners = "".join("%d %d %d\n" % (i % 2, i // 2 % 2, i // 4) for i in range(8))
    cube = bench.write("cube.off", "OFF\n8 6 0\n%s4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n" % corners)
    bench.run(cube, "--source-sharp-edges", 60, "--sharp-edges-near", "0.5,0,0", "--field", files[0])
    data = read(files[0]).GetPointData().GetArray("distance")
    for i, expected in enumerate((0, 0, 1, 1, 1, 1, math.sqrt(2), math.sqrt(2))):
        check_close(data.GetTuple1(i), expected, 1e-12, "distance from one edge of a cube")
    with open(bench.path("prism.off"), "w") as out:
        out.write("OFF\n16 10 0\n")
        out.writelines("%.17g %.17g %d\n" % (math.cos(k * math.pi / 4), math.sin(k * math.pi / 4), z) for z in (0, 3) for k in range(8))
        out.writelines("4 %d %d %d %d\n" % (k, (k + 1) % 8, (k + 1) % 8 + 8, k + 8) for k in range(8))
        out.write("8 7 6 5 4 3 2 1 0\n8 8 9 10 11 12 13 14 15\n")
    bench.run(bench.path("prism.off"), "--source-sharp-edges", 60, "--sharp-edges-near", "1,0,3", "--field", files[0])
    data = read(files[0]).GetPointData().GetArray("distance")
    for i in range(16):
        check_close(data.GetTuple1(i), 3 if i < 8 else 0, 1e-12, "distance from one rim of a prism")

    # points above and below the mesh, moved along a slanted direction: (2, 3, 1) per unit of height; no warning about far points
    moved = bench.write("moved.polylines.txt", polyline_text([(4.1 + 8, 5.2 + 12, 0.3 + 4), (7.3 - 2, 6.4 - 3, 0.3 - 1)]))
    bench.run(bench.grid(HORIZONTAL), "--source-polyline", moved, "--source-point", "10.3,2.25,0.35", "--project", "2,3,1",
              "--field", files[0], "--path-from", "6.3,10.6,2.3", "--path-output", files[1])
    data = read(files[0])
    for i in range(169):
        p = HORIZONTAL.plane(data.GetPoint(i))
        expected = min(from_segment(p)[0], math.dist(p, far))
        check_close(data.GetPointData().GetArray("distance").GetTuple1(i), expected, 1e-9, "distance from projected points")
    start = read(files[1]).GetPoint(0)
    check(math.dist(start, (2.3, 4.6, 0.3)) < 1e-9, "the projected start of a path: %s" % (start,))


def test_tolerance(bench):
    """Distances within a tolerance are within their error bounds, and within the tolerance."""
    write_grid(bench.path("bumps.off"), lambda p: (p[0], p[1], 0.5 * math.sin(p[0]) * math.cos(p[1])), n=24)
    mesh, files = bench.path("bumps.off"), (bench.path("exact.csv"), bench.path("field.csv"))

    def rows(file):
        with open(file, newline="") as text:
            return [{name: float(x) for name, x in row.items()} for row in csv.DictReader(text)]

    source = "--source-vertex", 8, "--field"
    stats = bench.run(mesh, *source, files[0])
    check("error_bound" not in stats, "error bound of exact distances")
    exact = [row["distance"] for row in rows(files[0])]
    for option, relative, absolute in (("--relative-tolerance", 1e-3, 0), ("--merging-tolerance", 0, 1e-3)):
        stats = bench.run(mesh, option, 1e-3, *source, files[1], "--picture", bench.path("a.png"))
        field = rows(files[1])
        check(len(field) == len(exact) == 625, "%d rows" % len(field))
        for row, d in zip(field, exact):
            check(row["distance"] <= d * (1 + 1e-13), "%g is longer than %g" % (row["distance"], d))
            check(d - row["distance"] <= row["error_bound"] + 1e-13 * d, "the bound %g of an error" % row["error_bound"])
            check(row["error_bound"] <= (relative * d + absolute) * (1 + 1e-12), "the bound %g of a tolerance" % row["error_bound"])
        check(max(d - row["distance"] for row, d in zip(field, exact)) > 1e-7, "no tolerance was used")
        check(max(row["error_bound"] for row in field) <= stats["error_bound"], "the largest bound")

    # offsets of these distances
    levels = "--source-vertex", 8, "--spacing", 5, "--count", 3, "--output", bench.path("offsets.polylines.txt")
    exact, near = bench.run(mesh, *levels)["curves"], bench.run(mesh, *levels, "--relative-tolerance", 1e-3)["curves"]
    check(len(exact) == len(near) == 3, "%d offsets" % len(near))
    for a, b in zip(exact, near):
        check(a["number"] == b["number"] and a["length"] != b["length"], "curves within a tolerance: %s, %s" % (a, b))
        check_close(b["length"], a["length"], 0.01 * a["length"], "length within a tolerance")


if __name__ == "__main__":
    run_test(polylines=test_polylines, field=test_field, details=test_details, tolerance=test_tolerance, sources=test_sources)
