# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh split along its offsets, or along its Voronoi diagram: bands, sources and colours of its faces, as VTK reads it too;
the curves of the diagram."""

import collections
import math
import os

from program_bench import (HORIZONTAL, TILTED, check, check_close, from_center, from_segment, polyline_text, read_ply,
                           read_polylines, run_test, vtk_readers)
from test_program_vtk import read_vtk

FAR = (10.2, 2.1)  # a point source away from the segment


def read_split(path, properties=("band", "source")):
    """The corners and the other properties of the faces."""
    elements = read_ply(path)
    names, vertices = elements["vertex"]
    check(names == ["x", "y", "z"], "properties of vertices %s" % names)
    names, faces = elements["face"]
    check(names == ["vertex_indices", *properties, "red", "green", "blue"], "properties of faces %s" % names)
    points = [(v["x"], v["y"], v["z"]) for v in vertices]
    check({i for f in faces for i in f["vertex_indices"]} == set(range(len(points))), "each vertex is used")
    sides = collections.Counter((f["vertex_indices"][k - 1], f["vertex_indices"][k]) for f in faces for k in range(3))
    check(max(sides.values()) == 1, "faces have the same orientation")
    border = sum((j, i) not in sides for i, j in sides)
    for f in faces:
        f["corners"] = [points[i] for i in f["vertex_indices"]]
    return points, faces, border


def area(corners):
    (a, b), (c, d), (e, f) = corners
    return ((c - a) * (f - b) - (e - a) * (d - b)) / 2


def octahedron(bench):
    """A closed mesh, with a line over some of its faces."""
    mesh = bench.write("octahedron.off", "OFF\n6 8 0\n6 0 0\n-6 0 0\n0 6 0\n0 -6 0\n0 0 6\n0 0 -6\n3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n"
                       "3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n")
    return mesh, "--source-polyline", bench.write("line.polylines.txt", polyline_text([(2, 2, 2), (-3, 2, 1)])), "--spacing", 1


def test_bands(bench):
    """Two sources in a plane: each face is in the band and near the source of its centroid, and bands have their areas."""
    plane, levels = TILTED, [0.5, 1.25]
    far = ("--source-point", plane.text(FAR))
    split = bench.path("split.ply")
    options = ("--tolerance", 1e-6, "--split", split)
    bench.run(bench.grid(plane), *far, *bench.segment(plane), "--distance", 0.5, "--distance", 1.25, *options)
    points, faces, border = read_split(split)
    off = [min(abs(min(math.dist(q, FAR), from_segment(q)[0]) - d) for d in levels) for q in map(plane.plane, points)]
    check(sum(x <= 1e-10 for x in off) == len(points) - 169, "new vertices are on their levels")
    areas, colors = collections.Counter(), {}
    for f in faces:
        corners = [plane.plane(p) for p in f["corners"]]
        center = tuple(sum(c[k] for c in corners) / 3 for k in range(2))
        distances = (math.dist(center, FAR), from_segment(center)[0])
        band = sum(min(distances) >= d for d in levels)
        nearest = [d for d in levels if abs(min(distances) - d) < 1e-6]
        check(f["band"] == band or nearest, "band %d at distance %g" % (f["band"], min(distances)))
        check(distances[f["source"]] <= min(distances) + 1e-12, "source %d at %s" % (f["source"], center))
        check(area(corners) > 0, "orientation of a face")
        areas[f["band"], f["source"]] += area(corners)
        colors.setdefault(f["band"], set()).add((f["red"], f["green"], f["blue"]))
    check(len(colors) == 3 and all(len(c) == 1 for c in colors.values()) and len(set.union(*colors.values())) == 3,
          "a colour for each band: %s" % colors)
    length = math.dist((4.1, 5.2), (7.3, 6.4))
    for band, (r, s) in enumerate(((0, 0.5), (0.5, 1.25))):
        disk = math.pi * (s * s - r * r)
        check_close(areas[band, 0], disk, 1e-5, "area of band %d around the point" % band)
        check_close(areas[band, 1], disk + 2 * length * (s - r), 1e-5, "area of band %d around the segment" % band)
    check_close(sum(areas.values()), 144, 1e-9, "area of all bands")
    check(border == 48, "%d edges of the border, which no offset reaches" % border)

    # an unreached part is beyond all distances and has no source; a closed surface stays closed
    with open(bench.grid(HORIZONTAL)) as file:
        lines = file.read().split("\n")
    lines[1] = "172 289 0"
    lines[2 + 169:2 + 169] = ["20 0 0", "21 0 0", "20 1 0"]
    with open(bench.path("parts.off"), "w") as file:
        file.write("\n".join(lines).rstrip("\n") + "\n3 169 170 171\n")
    bench.run(bench.path("parts.off"), *bench.center(HORIZONTAL), "--spacing", 1.5, "--split", split,
              warning="1 of 2 parts of the surface has no source: its 3 vertices are not reached")
    points, faces, _ = read_split(split)
    apart = [f for f in faces if f["corners"][0][0] > 15]
    last = max(f["band"] for f in faces)
    check(len(apart) == 1 and apart[0]["source"] == -1 and apart[0]["band"] == last, "an unreached part: %s" % apart)
    check(all(f["source"] == 0 for f in faces if f not in apart), "the only source")
    for f in faces:
        if f not in apart:
            d = from_center(tuple(sum(c[k] for c in f["corners"]) / 3 for k in range(2)))
            check(abs(d / 1.5 - f["band"] - 0.5) <= 0.5 + 1e-2, "band %d at distance %g" % (f["band"], d))
    bench.run(*octahedron(bench), "--split", split)
    check(read_split(split)[2] == 0, "a closed mesh stays closed")


def test_parts(bench):
    """Files of bands and sources: together the faces of the split mesh, each once, with their areas; a part without source."""
    with open(bench.grid(HORIZONTAL)) as file:
        lines = file.read().split("\n")
    lines[1] = "172 289 0"
    lines[2 + 169:2 + 169] = ["20 0 0", "21 0 0", "20 1 0"]
    mesh = bench.write("parts.off", "\n".join(lines).rstrip("\n") + "\n3 169 170 171\n")
    split, folder = bench.path("split.ply"), bench.path("bands")
    os.mkdir(folder)
    for kind, value in ("band", "band"), ("source", "source"), (None, "band"):
        options = ("--bands-by", kind) if kind else ()
        bench.run(mesh, "--source-point", HORIZONTAL.text(FAR), *bench.segment(HORIZONTAL), "--spacing", 1.5, "--split", split,
                  "--bands", os.path.join(folder, "b_"), *options, warning="1 of 2 parts of the surface has no source")
        whole = collections.Counter((f[value], tuple(f["corners"])) for f in read_split(split)[1])
        parts, areas = collections.Counter(), 0
        for name in os.listdir(folder):
            for f in read_split(os.path.join(folder, name))[1]:
                check(name == "b_%s.ply" % (f[value] if f[value] >= 0 else "none"), "a face of %s %d in %s" % (value, f[value], name))
                parts[f[value], tuple(f["corners"])] += 1
                areas += area([c[:2] for c in f["corners"]])
            os.remove(os.path.join(folder, name))
        check(parts == whole and max(whole.values()) == 1, "the faces of the split mesh")
        check(len({v for v, _ in whole}) == (3 if value == "source" else 1 + max(v for v, _ in whole)), "values of %s" % value)
        check_close(areas, 144.5, 1e-9, "area of all parts")


def test_vtk(bench):
    vtkPLYReader, vtkFeatureEdges = vtk_readers("vtkIOPLY.vtkPLYReader", "vtkFiltersCore.vtkFeatureEdges")
    split = bench.path("split.ply")
    bench.run(*octahedron(bench), "--split", split)
    points, faces, _ = read_split(split)
    reader = vtkPLYReader()
    reader.SetFileName(split)
    reader.Update()
    data = reader.GetOutput()
    check(data.GetNumberOfPoints() == len(points) and data.GetNumberOfPolys() == len(faces), "PLY in VTK")
    colors = data.GetCellData().GetArray("RGB")
    if check(colors is not None, "colours in VTK"):
        for i, f in enumerate(faces):
            check(colors.GetTuple3(i) == (f["red"], f["green"], f["blue"]), "colour of face %d" % i)
    edges = vtkFeatureEdges()
    edges.SetInputConnection(reader.GetOutputPort())
    edges.FeatureEdgesOff()
    edges.Update()
    check(edges.GetOutput().GetNumberOfCells() == 0, "VTK finds border edges or edges with several faces")


def test_voronoi(bench):
    """Two points and a segment in a plane: distances on curves from both sources, as VTK reads the file; cells of faces; their
    areas by integration along the curves."""
    vtkPolyDataReader, vtkPLYReader = vtk_readers("vtkIOLegacy.vtkPolyDataReader", "vtkIOPLY.vtkPLYReader")
    plane, second = TILTED, (9.6, 10.1)
    points = [word for p in (FAR, second) for word in ("--source-point", plane.text(p))]
    text, vtk, split = bench.path("cells.polylines.txt"), bench.path("cells.vtk"), bench.path("cells.ply")
    bench.run(bench.grid(plane), *points, *bench.segment(plane), "--tolerance", 1e-6, "--voronoi", text, "--voronoi", vtk,
              "--voronoi", split)

    def distances(p):
        return math.dist(p, FAR), math.dist(p, second), from_segment(p)[0]

    lines, cells, _, _ = read_vtk(vtkPolyDataReader(), vtk)
    check(cells == {"left", "right"}, "cell arrays %s" % cells)
    polylines = read_polylines(text)
    check(len(lines) == len(polylines) == 3, "%d and %d curves, between three cells" % (len(lines), len(polylines)))
    integral = collections.Counter()
    for line, polyline in zip(lines, polylines):
        check([tuple(p) for p in line["points"]] == polyline, "both files have the same points")
        left, right = int(line["cell"]["left"]), int(line["cell"]["right"])
        check(left != right, "two sources")
        chain = [plane.plane(p) for p in line["points"]]
        for p in chain:
            d = distances(p)
            check(abs(d[left] - d[right]) < 1e-9 and min(d) > d[left] - 1e-9, "distances %s on a curve" % (d,))
        for a, b in zip(chain, chain[1:]):
            d = [distances(((a[0] + b[0] - s * (b[1] - a[1])) / 2, (a[1] + b[1] + s * (b[0] - a[0])) / 2)) for s in (1, -1)]
            if math.dist(a, b) > 1e-3:
                check(d[0][left] < d[0][right] and d[1][right] < d[1][left], "the side of source %d" % left)

    points, faces, border = read_split(split, ("source",))
    areas, colors = collections.Counter(), {}
    for f in faces:
        corners = [plane.plane(p) for p in f["corners"]]
        d = distances(tuple(sum(c[k] for c in corners) / 3 for k in range(2)))
        check(d[f["source"]] <= min(d) + 2e-6, "source %d at distances %s" % (f["source"], d))
        check(area(corners) > 0, "orientation of a face")
        areas[f["source"]] += area(corners)
        colors.setdefault(f["source"], set()).add((f["red"], f["green"], f["blue"]))
    check(set(areas) == {0, 1, 2} and all(len(c) == 1 for c in colors.values()) and len(set.union(*colors.values())) == 3,
          "a colour for each cell: %s" % colors)
    check_close(sum(areas.values()), 144, 1e-9, "area of all cells")
    n = 400  # midpoints of squares: those that a boundary crosses count for the nearest source of their middle
    for i in range(n):
        for j in range(n):
            d = distances((12 * (i + 0.5) / n, 12 * (j + 0.5) / n))
            integral[d.index(min(d))] += (12 / n) ** 2
    for source in areas:
        check(abs(areas[source] - integral[source]) < 0.02, "area %g of cell %d" % (areas[source], source))
    reader = vtkPLYReader()
    reader.SetFileName(split)
    reader.Update()
    data = reader.GetOutput()
    check(data.GetNumberOfPoints() == len(points) and data.GetNumberOfPolys() == len(faces), "PLY in VTK")

    # a closed curve on a closed surface, which has its first point once; a single source has no curves
    mesh = octahedron(bench)[0]
    bench.run(mesh, "--source-vertex", 4, "--source-vertex", 5, "--voronoi", vtk, "--voronoi", split)
    lines = read_vtk(vtkPolyDataReader(), vtk)[0]
    check(len(lines) == 1 and lines[0]["is_closed"], "a closed curve")
    check(all(abs(p[2]) < 1e-12 for line in lines for p in line["points"]), "the equator")
    points, faces, border = read_split(split, ("source",))
    check(border == 0 and all(f["source"] == (0 if sum(c[2] for c in f["corners"]) > 0 else 1) for f in faces), "two cells")
    bench.run(mesh, "--source-vertex", 4, "--voronoi", vtk, "--voronoi", split)
    check(len(read_vtk(vtkPolyDataReader(), vtk)[0]) == 0, "no curves")
    check(all(f["source"] == 0 for f in read_split(split, ("source",))[1]), "one cell")


if __name__ == "__main__":
    run_test(bands=test_bands, parts=test_parts, vtk=test_vtk, voronoi=test_voronoi)
