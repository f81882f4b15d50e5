# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Offsets in the formats .vtk, .vtp and .obj, as VTK reads them, and .csv; memory of files written level by level."""

import csv
import math

from program_bench import (LENGTH, TILTED, chain_length, check, check_close, check_levels, from_center, from_segment,
                           polyline_text, run_test, stadium, vtk_readers)


def read_vtk(reader, path, with_values=True):
    """Lines with their values, as a reader gives them that nobody told what to read."""
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()

    def values(attributes):
        count = attributes.GetNumberOfArrays() if with_values else 0
        return {attributes.GetArrayName(k): attributes.GetArray(k) for k in range(count)}

    cells, points = values(data.GetCellData()), values(data.GetPointData())
    lines = []
    for i in range(data.GetNumberOfCells()):
        ids = data.GetCell(i).GetPointIds()
        ids = [ids.GetId(k) for k in range(ids.GetNumberOfIds())]
        lines.append({"points": [data.GetPoint(k) for k in ids], "is_closed": ids[0] == ids[-1],
                      "cell": {name: array.GetTuple1(i) for name, array in cells.items()},
                      "at": [{name: array.GetTuple1(k) if array.GetNumberOfComponents() == 1 else array.GetTuple3(k)
                              for name, array in points.items()} for k in ids]})
    check(data.GetNumberOfPoints() == sum(len(l["points"]) - l["is_closed"] for l in lines), "points that no line uses")
    return lines, set(cells), set(points), data


TILTED_NORMAL = (1 / 3, -2 / 3, 2 / 3)


def test_vtk(bench):
    vtkPolyDataReader = vtk_readers("vtkIOLegacy.vtkPolyDataReader")
    plane = TILTED
    out = bench.path("out.vtk")
    sources = (bench.grid(plane), *bench.center(plane), *bench.segment(plane))

    # both sides of a segment, and a circle around a point whose distance from it exceeds their sum
    far = ("--source-point", plane.text((10.2, 2.1)))
    stats = bench.run(sources[0], *far, *bench.segment(plane), "--distance", 1.25, "--distance", 0.5, "--tolerance", 1e-3,
                      "--output", out)
    check_levels(stats, [0.5, 1.25])
    lines, cells, points, data = read_vtk(vtkPolyDataReader(), out)
    check(cells == {"distance", "closed", "source", "side"}, "cell arrays %s" % cells)
    check(points == {"source", "side", "normal", "tangent", "face", "barycentric"}, "point arrays %s" % points)
    check(data.GetCellData().GetScalars().GetName() == "distance", "distance is active")
    check(data.GetPointData().GetScalars() is None, "no values of points are active")
    check(len(lines) == 4 == sum(level["number"] for level in stats["curves"]), "%d lines" % len(lines))
    kinds = set()
    seen_sides = set()
    for line in lines:
        cell, d = line["cell"], line["cell"]["distance"]
        check(d in (0.5, 1.25) and cell["closed"] == 1 and line["is_closed"], "closed lines at their distances")
        kinds.add((d, cell["source"], cell["side"]))
        for p, at in zip(line["points"], line["at"]):
            q = plane.plane(p)
            distance, side = from_segment(q)
            if at["source"] == 0:
                distance, side = math.dist(q, (10.2, 2.1)), 0
            check_close(distance, d, 1e-9, "a point of a line")
            check(at["source"] in (0, 1) and (side is None or at["side"] == side), "source and side of a point")
            seen_sides.add(at["side"])
            check(math.dist(at["normal"], TILTED_NORMAL) < 1e-12, "normal of a point: %s" % (at["normal"],))
        exact = 2 * math.pi * d if cell["source"] == 0 else stadium(d)
        length = chain_length(line["points"])
        # an arc of radius r and angle a is longer than its chord of height h by about a r (8 h / r) / 24
        check(exact - 1e-3 * exact / d <= length <= exact, "length %.17g of a line of %.17g" % (length, exact))
    check(kinds == {(0.5, 0, 0), (1.25, 0, 0), (0.5, 1, -1), (1.25, 1, -1)}, "kinds of lines: %s" % kinds)
    check(seen_sides == {0, 1, 2, 3}, "sides: %s" % seen_sides)

    # one side: one open line, without the caps; round: with them
    for side, value in (("left", 1), ("right", 2)):
        bench.run(sources[0], *bench.segment(plane), "--distance", 0.75, "--side", side, "--output", out)
        lines, _, _, _ = read_vtk(vtkPolyDataReader(), out)
        if check(len(lines) == 1, "%d lines of the %s side" % (len(lines), side)):
            check(lines[0]["cell"]["side"] == value and lines[0]["cell"]["closed"] == 0, "an open line of the %s side" % side)
            check_close(chain_length(lines[0]["points"]), LENGTH, 1e-9, "the %s side" % side)
            check(all(from_segment(plane.plane(p))[1] in (value, None) for p in lines[0]["points"]), "points are %s" % side)
        bench.run(sources[0], *bench.segment(plane), "--distance", 0.75, "--side", side, "--end", "round",
                  "--tolerance", 1e-6, "--output", out)
        lines, _, _, _ = read_vtk(vtkPolyDataReader(), out)
        check_close(sum(chain_length(l["points"]) for l in lines), LENGTH + 2 * math.pi * 0.75, 1e-4, "%s and caps" % side)
    stats = bench.run(sources[0], *bench.segment(plane), "--distance", 0.75, "--end", "butt", "--output", out)
    lines, _, _, _ = read_vtk(vtkPolyDataReader(), out)
    check(sorted(l["cell"]["side"] for l in lines) == [1, 2], "both sides without caps")
    check_close(stats["curves"][0]["length"], 2 * LENGTH, 1e-9, "length of both sides without caps")

    # a file without curves is valid
    bench.run(*sources, "--distance", 100, "--output", out, warning="no offset at distance 100")
    check(len(read_vtk(vtkPolyDataReader(), out)[0]) == 0, "no lines")


def write_ridge_offsets(bench, name, *options):
    """Offsets of a vertex and a segment on a ridge, as .vtk and in the format of the name; returns both paths."""
    with open(bench.path("segment.polylines.txt"), "w") as out:
        out.write(polyline_text([(3.1, 5.2, 0), (5.3, 7.4, 0)]))
    files = bench.path("out.vtk"), bench.path(name)
    bench.run(bench.ridge(), "--source-vertex", 0, "--source-polyline", bench.path("segment.polylines.txt"), "--spacing", 0.7,
              "--output", files[0], "--output", files[1], *options)
    return files


def test_vtp(bench):
    """The lines of a file with a piece per level are those of a .vtk file; also without curves."""
    vtkPolyDataReader, vtkXMLPolyDataReader = vtk_readers("vtkIOLegacy.vtkPolyDataReader", "vtkIOXML.vtkXMLPolyDataReader")
    files = write_ridge_offsets(bench, "out.vtp")
    expected, cells, points, _ = read_vtk(vtkPolyDataReader(), files[0])
    lines, xml_cells, xml_points, data = read_vtk(vtkXMLPolyDataReader(), files[1])
    check(cells == xml_cells and points == xml_points, "arrays %s, %s" % (xml_cells, xml_points))
    check(data.GetCellData().GetScalars().GetName() == "distance", "distance is active")
    check(data.GetPointData().GetNormals().GetName() == "normal", "normals are active")
    check(len(lines) > 8 and lines == expected, "%d lines, expected %d" % (len(lines), len(expected)))
    normals = [at["normal"] for line in lines for at in line["at"]]
    sides = (0, 0, 1), (0.6, 0, 0.8)
    check(all(min(math.dist(n, side) for side in sides) < 1e-12 for n in normals), "normals of a ridge")
    check(all(min(math.dist(n, side) for n in normals) < 1e-12 for side in sides), "normals of both sides of a ridge")
    bench.run(bench.ridge(), "--source-vertex", 0, "--distance", 100, "--output", files[1], warning="no offset at distance 100")
    check(len(read_vtk(vtkXMLPolyDataReader(), files[1])[0]) == 0, "no lines")


VECTORS = {"normal": ("nx", "ny", "nz"), "barycentric": ("b0", "b1", "b2"), "tangent": ("tx", "ty", "tz")}


def read_off(path):
    with open(path) as file:
        words = file.read().split()
    vertices, faces = int(words[1]), int(words[2])
    numbers = list(map(float, words[4:4 + 3 * vertices]))
    corners = list(map(int, words[4 + 3 * vertices:4 + 3 * vertices + 4 * faces]))
    return [tuple(numbers[k:k + 3]) for k in range(0, 3 * vertices, 3)], [corners[k + 1:k + 4] for k in range(0, 4 * faces, 4)]


def test_csv(bench):
    """The rows of a .csv file are the points of the .vtk file, in faces of the mesh file."""
    vtkPolyDataReader = vtk_readers("vtkIOLegacy.vtkPolyDataReader")

    def rows_of(*options):
        files = write_ridge_offsets(bench, "out.csv", *options)
        expected = read_vtk(vtkPolyDataReader(), files[0])[0]
        with open(files[1], newline="") as file:
            reader = csv.DictReader(file)
            rows = [{name: float(x) for name, x in row.items()} for row in reader]
        check(reader.fieldnames == "curve distance source side x y z nx ny nz face b0 b1 b2 tx ty tz".split(), "columns")
        wanted = [{"curve": i, "distance": line["cell"]["distance"], "source": at["source"], "side": at["side"],
                   "face": at["face"], **dict(zip("xyz", p)),
                   **{name: x for array, names in VECTORS.items() for name, x in zip(names, at[array])}}
                  for i, line in enumerate(expected) for p, at in zip(line["points"], line["at"])]
        check(len(rows) > 200 and rows == wanted, "%d rows, expected %d" % (len(rows), len(wanted)))
        points, faces = read_off(bench.path("ridge.off"))
        for row in rows:
            weights = [row[b] for b in VECTORS["barycentric"]]
            corners = [points[v] for v in faces[int(row["face"])]]
            p = [sum(w * c[i] for w, c in zip(weights, corners)) for i in range(3)]
            check(math.dist(p, [row[x] for x in "xyz"]) < 1e-12, "a point in its face")
            normal, tangent = ([row[x] for x in VECTORS[array]] for array in ("normal", "tangent"))
            check_close(math.hypot(*normal), 1, 1e-12, "a unit normal")
            check_close(math.hypot(*tangent), 1, 1e-12, "a unit tangent")
        return rows

    rows_of()
    spaced = rows_of("--point-spacing", 0.1, "--smooth-normals")
    sides, between = ((0, 0, 1), (0.6, 0, 0.8)), 0
    for i in range(int(spaced[-1]["curve"]) + 1):
        curve = [row for row in spaced if row["curve"] == i]
        chords = [math.dist(*([row[x] for x in "xyz"] for row in pair)) for pair in zip(curve, curve[1:])]
        check(max(chords) <= 0.1 + 1e-9, "spacing %g" % max(chords))
        # shorter only at corners and bends
        check(sorted(chords)[len(chords) // 2] > 0.98 * max(chords), "even spacing")
        for row in curve:
            normal = tuple(row[x] for x in VECTORS["normal"])
            check(abs(normal[1]) < 1e-12 and -1e-12 <= normal[0] <= 0.6 + 1e-12, "a smooth normal: %s" % (normal,))
            between += min(math.dist(normal, side) for side in sides) > 1e-3
    check(between > 10, "normals between those of the sides")


def test_levels(bench):
    """Files that are written level by level take no memory for more levels."""
    def peak(name, levels):
        out = bench.path(name)
        stats = bench.run(bench.plate(TILTED), *bench.center(TILTED), "--spacing", 8 / levels, "--count", levels, "--tolerance", 1e-3,
                          "--threads", 1, "--output", out)
        check(len(stats["curves"]) == levels and all(level["number"] > 0 for level in stats["curves"]), "curves at all levels")
        with open(out) as file:
            check(sum(1 for line in file) >= levels, "lines of %s" % name)
        return stats["peak_rss_bytes"]

    for name in "a.vtp", "a.obj", "a.csv", "a.polylines.txt":
        few, many = peak(name, 10), peak(name, 1000)
        check(many <= 1.2 * few, "%s: %d bytes with 10 levels, %d with 1000" % (name, few, many))
    check(peak("a.vtk", 1000) > 1.2 * few, "this test detects curves that are kept")


def test_obj(bench):
    vtkOBJReader, vtkPolyDataReader = vtk_readers("vtkIOGeometry.vtkOBJReader", "vtkIOLegacy.vtkPolyDataReader")
    bench.run(bench.grid(TILTED), *bench.center(TILTED), "--spacing", 1.5, "--output", bench.path("out.obj"),
              "--output", bench.path("out.vtk"))
    expected = read_vtk(vtkPolyDataReader(), bench.path("out.vtk"))[0]
    lines = read_vtk(vtkOBJReader(), bench.path("out.obj"), False)[0]
    check(len(lines) == len(expected) > 4, "%d lines, expected %d" % (len(lines), len(expected)))
    check({l["is_closed"] for l in lines} == {True, False}, "closed and open lines")
    for line, other in zip(lines, expected):
        check(line["is_closed"] == other["is_closed"] and len(line["points"]) == len(other["points"]), "sizes of lines")
        for p, q in zip(line["points"], other["points"]):
            check(math.dist(p, q) < 1e-5, "a point of a line")  # VTK reads this format in single precision
            check_close(from_center(TILTED.plane(p)), other["cell"]["distance"], 1e-5, "distance of a point")
    with open(bench.path("out.obj")) as file:
        groups = [line.split() for line in file if line.startswith("g ")]
    check(groups == [["g", "offset_%g" % d] for d in sorted({l["cell"]["distance"] for l in expected})], "groups %s" % groups)


if __name__ == "__main__":
    run_test(vtk=test_vtk, vtp=test_vtp, csv=test_csv, levels=test_levels, obj=test_obj)
