# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Barriers and regions of the program, against closed forms in a plane."""

import csv
import json
import math

from program_bench import (HORIZONTAL, TILTED, chain_length, check, check_close, cube, polyline_text, read_ply, read_polylines,
                           run_test, sphere, torus, vtk_readers, write_off)


def rectangle(a, b, c, d):
    return [(a, b), (c, b), (c, d), (a, d), (a, b)]


def write_curves(bench, name, plane, *curves):
    return bench.write(name, "".join(polyline_text([plane.space(p) for p in curve]) for curve in curves))


def read_field(bench, plane):
    """The vertices in the plane, and their distances."""
    with open(bench.path("field.csv")) as file:
        rows = [[float(x) for x in row] for row in list(csv.reader(file))[1:]]
    return [(plane.plane(row[:3]), row[3]) for row in rows]


def around_wall(p, q, x, low, high):
    """The length of the shortest path around a wall from (x, low) to (x, high)."""
    if (p[0] - x) * (q[0] - x) < 0:
        y = p[1] + (q[1] - p[1]) * (x - p[0]) / (q[0] - p[0])
        if low < y < high:
            return min(math.dist(p, end) + math.dist(end, q) for end in ((x, low), (x, high)))
    return math.dist(p, q)


def test_walls(bench):
    """One wall: distances, paths that bend at its ends, arcs that end on it, and the largest level."""
    wall = (6, 2.1, 9.7)
    for plane in (HORIZONTAL, TILTED):
        mesh = bench.grid(plane)
        curve = write_curves(bench, "wall.polylines.txt", plane, [(6, 2.1), (6, 9.7)])
        source, target = (4, 6), (7.5, 6.3)
        arguments = (mesh, "--barrier", curve, "--source-point", plane.text(source))
        stats = bench.run(*arguments, "--distance", 3, "--field", bench.path("field.csv"), "--path-from", plane.text(target),
                          "--path-output", bench.path("path.polylines.txt"))
        for p, distance in read_field(bench, plane):
            check_close(distance, around_wall(source, p, *wall), 1e-12, "distance at %g, %g" % p)
        check_close(stats["curves"][0]["length"], 3 * (2 * math.pi - 2 * math.acos(2 / 3)), 1e-9, "an arc that ends on the wall")
        path, = read_polylines(bench.path("path.polylines.txt"))
        check_close(chain_length(path), around_wall(source, target, *wall), 1e-12, "length of the path")
        check(any(math.dist(plane.plane(p), (6, 9.7)) < 1e-12 for p in path), "the path bends at an end: %s" % path)
        # the level of a spacing that needs the way around the wall, which is longer than all paths along edges
        high = write_curves(bench, "high.polylines.txt", plane, [(6, 0), (6, 11.5)])
        stats = bench.run(mesh, "--barrier", high, "--source-point", plane.text((5.9, 0.1)), "--spacing", 22)
        check([c["distance"] for c in stats["curves"]] == [22] and stats["curves"][0]["number"] == 1, "levels %s" % stats["curves"])
    output = bench.start(*arguments).stdout
    check("barriers: 1 polyline and 0 sharp edges, of length 7.6" in output and "divided along curves" in output, output)
    # a source on a barrier starts on both sides, and a source that crosses one goes around it
    stats = bench.run(mesh, "--barrier", curve, "--source-polyline", curve, "--distance", 0.5)
    check_close(stats["curves"][0]["length"], 2 * 7.6 + math.pi, 1e-11, "the wall as source")
    across = write_curves(bench, "across.polylines.txt", plane, [(4, 6), (8, 6)])
    bench.run(mesh, "--barrier", curve, "--source-polyline", across, "--source-output", bench.path("source.polylines.txt"),
              warning="the path on the surface has length 8.41")
    check_close(chain_length(read_polylines(bench.path("source.polylines.txt"))[0]), around_wall((4, 6), (8, 6), *wall), 1e-11,
                "a source polyline around the wall")


def test_cut_off(bench):
    mesh = bench.grid(HORIZONTAL)
    ring = write_curves(bench, "ring.polylines.txt", HORIZONTAL, rectangle(3.4, 3.4, 8.6, 8.6))
    bench.run(mesh, "--barrier", ring, "--source-vertex", 0, "--field", bench.path("field.csv"),
              warning="barriers cut off 25 vertices from all sources: their distances are infinite")
    for p, distance in read_field(bench, HORIZONTAL):
        is_inside = all(3.4 < x < 8.6 for x in p)
        check(math.isinf(distance) == is_inside, "distance %g at %g, %g" % (distance, *p))
    result = bench.start(mesh, "--barrier", ring, "--source-vertex", 0, "--path-from", "6,6,0.3", "--path-output", "a.vtk")
    check("no path for --path-from 6,6,0.3: barriers cut it off" in result.stderr, result.stderr)
    bench.run(mesh, "--barrier", ring, "--source-vertex", 0, "--distance", 1, "--maximum-distance", 2)  # it is not known there
    # a point has no effect
    dot = write_curves(bench, "dot.polylines.txt", HORIZONTAL, [(3, 3)])
    bench.run(mesh, "--barrier", dot, "--source-vertex", 0, warning="1 polyline of --barrier without effect, as short as a point")


def test_sharp(bench):
    """A cube whose edges are barriers: only one side is reached."""
    box = bench.path("box.off")
    points, faces = cube(3, 3)
    write_off(box, points, faces)
    on_side = [p for p in points if p[2] == 3]
    stats = bench.run(box, "--barrier-sharp-edges", 45, "--source-point", "1.2,1.4,3", "--distance", 0.5, "--field",
                      bench.path("field.csv"), warning="barriers cut off %d vertices" % (len(points) - len(on_side)))
    check_close(stats["curves"][0]["length"], math.pi, 1e-12, "a circle")
    for p, distance in zip(points, (d for _, d in read_field(bench, HORIZONTAL))):
        check(abs(distance - math.dist(p, (1.2, 1.4, 3))) < 1e-12 if p[2] == 3 else math.isinf(distance), "distance at %s" % (p,))
    # an edge keeps its barrier where a curve divides it
    curve = bench.write("curve.polylines.txt", polyline_text([(1.3, 0.7, 3), (1.3, 0, 1.7)]))
    stats = bench.run(box, "--barrier-sharp-edges", 45, "--barrier", curve, "--source-point", "1.2,1.4,3", "--distance", 0.5)
    check_close(stats["curves"][0]["length"], math.pi, 1e-12, "the circle")


def from_outline(p, outlines):
    """The distance from rectangles, and the number of them around the point."""
    distance, number = math.inf, 0
    for a, b, c, d in outlines:
        number += a < p[0] < c and b < p[1] < d
        for u, v in zip(rectangle(a, b, c, d), rectangle(a, b, c, d)[1:]):
            t = ((p[0] - u[0]) * (v[0] - u[0]) + (p[1] - u[1]) * (v[1] - u[1])) / math.dist(u, v) ** 2
            t = min(max(t, 0), 1)
            distance = min(distance, math.dist(p, (u[0] + t * (v[0] - u[0]), u[1] + t * (v[1] - u[1]))))
    return distance, number


def test_regions(bench):
    mesh = bench.grid(HORIZONTAL)
    # a pocket with islands, and a part inside of an island: inside of an odd number of curves
    outlines = [(1, 1, 11, 10), (3.3, 3.2, 6.4, 7.6), (7.5, 6.1, 8.2, 8.3), (4.1, 4.2, 5.3, 6.3)]
    for direction in (1, -1):
        pocket = write_curves(bench, "pocket.polylines.txt", HORIZONTAL, rectangle(*outlines[0])[::direction])
        islands = write_curves(bench, "islands.polylines.txt", HORIZONTAL, *(rectangle(*o)[::-direction] for o in outlines[1:]))
        stats = bench.run(mesh, "--region", pocket, "--region", islands, "--source-boundary", "--distance", 0.25, "--field",
                          bench.path("field.csv"))
        perimeters = [2 * (c - a + d - b) for a, b, c, d in outlines]
        check_close(stats["curves"][0]["length"], sum(perimeters) + 4 * math.pi * 0.25 - 16 * 0.25, 1e-9, "the offset")
        check((stats["parts"], stats["border_cycles"]) == (2, 4), "two parts and four borders: %s" % stats)
        check(math.dist(sum(stats["bounding_box"], []), (1, 1, 0.3, 11, 10, 0.3)) < 1e-12, "bounding box %s" % stats["bounding_box"])
        for p, distance in read_field(bench, HORIZONTAL):
            expected, number = from_outline(p, outlines)
            check(abs(distance - expected) < 1e-12 if number % 2 else math.isinf(distance), "distance at %g, %g" % p)
    output = bench.start(mesh, "--region", pocket, "--source-boundary").stdout
    check("line 1: inside = right, the side without border" in output and "faces removed" in output, output)
    # a clamp: a barrier that goes beyond the region
    clamp = write_curves(bench, "clamp.polylines.txt", HORIZONTAL, [(6, 0.4), (6, 8)])
    bench.run(mesh, "--region", pocket, "--barrier", clamp, "--source-point", "4,2,0.3", "--field", bench.path("field.csv"))
    for p, distance in read_field(bench, HORIZONTAL):
        number = from_outline(p, outlines[:1])[1]
        expected = math.dist(p, (4, 2)) if p[0] <= 6 else None
        if expected is None:
            y = 2 + (p[1] - 2) * 2 / (p[0] - 4)
            expected = math.dist(p, (4, 2)) if y > 8 else math.hypot(2, 6) + math.dist(p, (6, 8))
        check(abs(distance - expected) < 1e-12 if number else math.isinf(distance), "distance at %g, %g" % p)


def test_touching(bench):
    """Regions that touch at a point or along a curve: no path leads from one to the other."""
    mesh = bench.grid(HORIZONTAL)
    regions = write_curves(bench, "regions.polylines.txt", HORIZONTAL, rectangle(2, 2, 6.1, 6.2), rectangle(6.1, 6.2, 10, 10.5))
    stats = bench.run(mesh, "--region", regions, "--source-point", "3,3,0.3", "--distance", 0.5, warning="1 of 2 parts")
    check_close(stats["curves"][0]["length"], math.pi, 1e-9, "a circle")
    # the part of the curves along which they touch is a barrier
    regions = write_curves(bench, "regions.polylines.txt", HORIZONTAL, rectangle(2, 2, 6.1, 6.2), rectangle(6.1, 2, 10, 6.2))
    result = bench.start(mesh, "--region", regions, "--source-point", "3,3,0.3", "--field", bench.path("field.csv"))
    check("barriers cut off" in result.stderr, result.stderr)
    for p, distance in read_field(bench, HORIZONTAL):
        is_inside = 2 < p[0] < 6.1 and 2 < p[1] < 6.2
        check(abs(distance - math.dist(p, (3, 3))) < 1e-12 if is_inside else math.isinf(distance), "distance at %g, %g" % p)


def test_pinched(bench):
    """A cone that touches the plane at its tip is inside of the region around the tip, and paths lead through the tip."""
    mesh = bench.path("cone.off")
    points = [(i, j, 0.3) for j in range(13) for i in range(13)]
    cells = [13 * j + i for j in range(12) for i in range(12)]
    faces = [f for a in cells for f in ((a, a + 1, a + 14), (a, a + 14, a + 13))]
    tip, rim = 13 * 5 + 4, [(5, 5), (4, 6), (3, 5), (4, 4)]
    first = len(points)
    points += [(x, y, 1.3) for x, y in rim]
    write_off(mesh, points, faces + [(tip, first + (k + 1) % 4, first + k) for k in range(4)])
    pocket = write_curves(bench, "pocket.polylines.txt", HORIZONTAL, rectangle(1.5, 1.5, 8.2, 8.2))
    result = bench.start(mesh, "--region", pocket, "--source-point", "7,7.5,0.3", "--field", bench.path("field.csv"))
    check(result.returncode == 0 and "1 vertex is shared by fans" in result.stderr, result.stderr)
    with open(bench.path("field.csv")) as file:
        rows = [[float(x) for x in row] for row in list(csv.reader(file))[1:]]
    for x, y, z, distance in rows[-4:]:
        check_close(distance, math.dist((7, 7.5), (4, 5)) + math.sqrt(2), 1e-12, "the rim of the cone at %g, %g" % (x, y))
    # beyond the region, it is left out
    result = bench.start(mesh, "--region", write_curves(bench, "other.polylines.txt", HORIZONTAL, rectangle(6.5, 6.5, 8.2, 8.2)),
                         "--source-point", "7,7.5,0.3", "--field", bench.path("field.csv"))
    check(all(math.isinf(d) for _, d in read_field(bench, HORIZONTAL)[-4:]), "the cone beyond the region")


def area_of(ply):
    points = [tuple(v[c] for c in "xyz") for v in ply["vertex"][1]]
    area = 0
    for face in ply["face"][1]:
        p, q, r = (points[i] for i in face["vertex_indices"])
        u, v = [b - a for a, b in zip(p, q)], [b - a for a, b in zip(p, r)]
        area += math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2
    return area


def test_curved(bench):
    """Sections of closed surfaces: the kept faces have the area that is inside, and the offset the length of that of the section."""
    for name, (points, faces), plane in (("sphere.off", sphere(3), "0.2,0.3,1,-0.4"), ("torus.off", torus(24, 12), "1,0.1,0,-1.1")):
        mesh, curve = bench.path(name), bench.path("section.polylines.txt")
        write_off(bench.path(name), points, faces)
        bench.run(mesh, "--source-plane", plane, "--source-output", curve)
        check(len(read_polylines(curve)) == 1, "one curve")
        inside = bench.run(mesh, "--source-polyline", curve + ":inside", "--distance", 0.1)
        result = bench.start(mesh, "--region", curve, "--source-boundary", "--distance", 0.1, "--split", bench.path("split.ply"),
                             "--stats", bench.path("stats.json"))
        check(result.returncode == 0 and not result.stderr, result.stderr)
        check_close(area_of(read_ply(bench.path("split.ply"))), inside["insides"][0]["area"], 1e-9, "the area of the region")
        with open(bench.path("stats.json")) as file:
            check_close(json.load(file)["curves"][0]["length"], inside["curves"][0]["length"], 1e-9, "the offset in the region")


def test_picture(bench):
    """Black lines of barriers, and the background where faces are removed."""
    png_reader = vtk_readers("vtkIOImage.vtkPNGReader")
    mesh = bench.grid(HORIZONTAL)
    pocket = write_curves(bench, "pocket.polylines.txt", HORIZONTAL, rectangle(1, 1, 11, 10), rectangle(3, 3, 5, 5))
    clamp = write_curves(bench, "clamp.polylines.txt", HORIZONTAL, [(8, 0.4), (8, 8)])
    bench.run(mesh, "--region", pocket, "--barrier", clamp, "--source-point", "4,2,0.3", "--picture", bench.path("a.png"), "--view",
              "0,0,1")
    reader = png_reader()
    reader.SetFileName(bench.path("a.png"))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    data = bytes(memoryview(reader.GetOutput().GetPointData().GetScalars()))
    scale = min((width - 290) / 10, 1480 / 9)  # as in picture.h: margins of 60, the legend of 170
    left = 60 + (width - 290 - 10 * scale) / 2

    def pixel(x, y):
        column, row = round(left + (x - 1) * scale), round(height / 2 + (y - 5.5) * scale)
        at = 3 * (row * width + column)
        return tuple(data[at:at + 3])

    for y in (2, 4, 6, 7.5):
        check(pixel(8, y) == (0, 0, 0), "the barrier at %g: %s" % (y, pixel(8, y)))
    for x, y in ((4, 4), (3.5, 4.5), (10.5, 10.3)):
        check(min(pixel(x, y)) > 220, "the background at %g, %g: %s" % (x, y, pixel(x, y)))
    for x, y in ((8, 9), (4, 6), (9, 3)):
        check(10 < max(pixel(x, y)) and min(pixel(x, y)) < 220, "the surface at %g, %g: %s" % (x, y, pixel(x, y)))


run_test(walls=test_walls, cut_off=test_cut_off, sharp=test_sharp, regions=test_regions, touching=test_touching,
         pinched=test_pinched, curved=test_curved, picture=test_picture)
