# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every output of the program, read without other packages, and every kind of source, against closed forms on a planar mesh and a
cube. The tests in other files read outputs with other software."""

import csv
import math
import re
import struct
import zlib

from program_bench import (check, check_close, cube, polyline_text, read_ply, read_polylines, run_test, write_grid, write_off)

SOURCE = 84  # in the middle of the grid


def read_off(path):
    with open(path) as file:
        rows = [line.split() for line in file]
    n, m = map(int, rows[1][:2])
    return [tuple(map(float, r)) for r in rows[2:2 + n]], [tuple(map(int, r[1:])) for r in rows[2 + n:2 + n + m]]


def read_vtk(path):
    """Points, distance, and whether it is closed, of each curve of a legacy file, as `closed` of the file has it."""
    with open(path) as file:
        first, text = file.readline(), file.read()
    words = text.split()
    check(first.startswith("# vtk DataFile"), "header: " + first)

    def numbers(key, behind, count, kind=float):
        at = words.index(key) + behind
        return [kind(word) for word in words[at:at + count]]

    n, m = int(words[words.index("POINTS") + 1]), int(words[words.index("LINES") + 1])
    flat, size = numbers("POINTS", 3, 3 * n), int(words[words.index("LINES") + 2])
    points, cells = list(zip(*[iter(flat)] * 3)), iter(numbers("LINES", 3, size, int))
    lines = [[points[next(cells)] for _ in range(length)] for length in cells]
    check(len(lines) == m and ["CELL_DATA", str(m)] == words[words.index("CELL_DATA"):][:2] and "POINT_DATA %d\n" % n in text, "sizes")
    for name, low, high in ("closed", 0, 1), ("source", -1, 3), ("side", -1, 3):
        for at in (i for i, word in enumerate(words) if word == name):
            size, count = map(int, words[at + 1:at + 3])
            check(size == 1 and count in (m, n) and words[at + 3] == "int"
                  and all(low <= int(x) <= high for x in words[at + 4:at + 4 + count]), "values of " + name)
    if m == 0:
        return []
    return list(zip(lines, numbers("distance", 5, m), (x == 1 for x in numbers("closed", 4, m, int))))


def read_obj(path):
    points, curves = [], []
    with open(path) as file:
        for key, *words in (line.split() for line in file if line.strip()):
            if key == "v":
                points.append(tuple(map(float, words)))
            elif key == "l":
                curves.append([points[int(i) - 1] for i in words])
    return [(c, None, c[0] == c[-1]) for c in curves]


def read_lines(path):
    return [(c, None, len(c) > 2 and c[0] == c[-1]) for c in read_polylines(path)]


def check_curves(name, curves, levels, number, closed, distance):
    check(len(curves) == number and sum(c for _, _, c in curves) == closed, "%s: %d curves" % (name, len(curves)))
    seen = set()
    for points, value, _ in curves:
        level = min(levels, key=lambda x: abs(distance(points[0]) - x))
        check(len(points) >= 2 and value in (None, level), "%s: distance %s of a curve at %g" % (name, value, level))
        seen.add(level)
        for p in points:
            check_close(distance(p), level, 1e-9, name + ": a point")
    check(seen == set(levels), "%s: levels %s" % (name, seen))


def check_field(bench, mesh, distance, name="field.ply"):
    """All distances, points and faces; no tolerance for infinity."""
    elements, (points, faces) = read_ply(bench.path(name)), read_off(mesh)
    vertices = elements["vertex"][1]
    check([(v["x"], v["y"], v["z"]) for v in vertices] == points, "points of " + name)
    check([f["vertex_indices"] for f in elements["face"][1]] == faces, "faces of " + name)
    for v, p in zip(vertices, points):
        expected = distance(p)
        check(v["distance"] == expected or abs(v["distance"] - expected) < 1.2e-11, "distance %.17g, not %.17g" % (v["distance"], expected))
    return vertices


def planar(bench):
    write_grid(bench.path("plane.off"), lambda p: (p[0], p[1], 0))
    return bench.path("plane.off")


def from_point(x, y):
    return lambda p: math.hypot(p[0] - x, p[1] - y)


def from_segments(*corners):
    def distance(p):
        result = math.inf
        for a, b in zip(corners, corners[1:]):
            u, v = (b[0] - a[0], b[1] - a[1]), (p[0] - a[0], p[1] - a[1])
            t = min(max((u[0] * v[0] + u[1] * v[1]) / (u[0] ** 2 + u[1] ** 2), 0), 1)
            result = min(result, math.hypot(v[0] - t * u[0], v[1] - t * u[1]))
        return result
    return distance


def test_all(bench):
    mesh = planar(bench)
    points = read_off(mesh)[0]
    distance = from_point(*points[SOURCE][:2])
    source = mesh, "--source-vertex", SOURCE
    files = {bench.path("out" + extension): reader for extension, reader in
             ((".polylines.txt", read_lines), (".vtk", read_vtk), (".obj", read_obj))}
    stats = bench.run(*source, "--distance", 1.25, "--distance", 3, "--distance", 7.5, "--tolerance", 0.001,
                      *(word for file in files for word in ("--output", file)), "--field", bench.path("field.ply"),
                      "--picture", bench.path("picture.png"))
    for file, reader in files.items():  # the circle of radius 7.5 crosses all four sides of the square
        check_curves(file, reader(file), [1.25, 3, 7.5], 6, 2, distance)
    check_field(bench, mesh, distance)
    with open(bench.path("picture.png"), "rb") as file:
        data = file.read()
    check(data[:8] == b"\x89PNG\r\n\x1a\n" and data[12:16] == b"IHDR" and data[-8:-4] == b"IEND"
          and min(struct.unpack(">II", data[16:24])) >= 100, "a PNG file")
    check((stats["vertices"], stats["faces"]) == (169, 288) and stats["threads"] >= 1, "sizes in the statistics")
    check(all(stats[key + "_seconds"] >= 0 for key in ("setup", "solve", "offset")), "seconds")
    check(all(stats[key] > 0 for key in ("windows_created", "windows_propagated", "windows_peak", "pieces_peak", "peak_rss_bytes")),
          "counts: %s" % stats)
    first = stats["curves"][0]
    check((first["distance"], first["number"], first["closed"]) == (1.25, 1, 1), "the first level: %s" % first)
    check_close(first["length"], 2.5 * math.pi, 1e-10, "length of a circle")

    out = bench.path("spaced.vtk")
    bench.run(*source, "--spacing", 1.5, "--output", out)
    check(len({d for _, d, _ in read_vtk(out)}) == int(max(map(distance, points)) / 1.5), "levels until the surface is covered")
    for threads in (), ("--threads", 1), ("--threads", 2):
        result = bench.start(*source, "--spacing", 1.5, "--count", 2, *threads, "--output", out, "--quiet")
        if result.returncode == 2 and threads == ("--threads", 2):
            check("without TBB" in result.stderr, "several threads: " + result.stderr)
        else:
            check(result.returncode == 0 and not result.stderr, "%s: %s" % (threads, result.stderr))
            check_curves("threads %s" % (threads,), read_vtk(out), [1.5, 3], 2, 2, distance)
    bench.run(*source, "--maximum-distance", 4, "--field", bench.path("field.ply"))
    check_field(bench, mesh, lambda p: distance(p) if distance(p) <= 4 else math.inf)


def test_sources(bench):
    mesh, out, field = planar(bench), bench.path("out.vtk"), bench.path("field.ply")
    curve = bench.write("curve.polylines.txt", "3 3.1 4.2 0 8.3 7.7 0 8.9 3.3 0\n")
    from_curve = from_segments((3.1, 4.2), (8.3, 7.7), (8.9, 3.3))
    for source, distance in ((("--source-point", "5.3,6.1,4"), from_point(5.3, 6.1)),  # above its nearest point
                             (("--source-polyline", curve), from_curve),
                             (("--source-boundary",), lambda p: min(p[0], 12 - p[0], p[1], 12 - p[1]))):
        bench.run(mesh, *source, "--distance", 1.5, "--output", out, "--field", field,
                  warning="4 away from the surface" if "--source-point" in source else None)
        check_field(bench, mesh, distance)
        check_curves(source[0], read_vtk(out), [1.5], 1, 1, distance)

    bench.run(mesh, "--source-plane", "3,4,0,-41.3", "--distance", 1.5, "--output", out, "--field", field)
    check([c for _, _, c in read_vtk(out)] == [False, False], "two offsets of a line, from boundary to boundary")
    for v in read_ply(field)["vertex"][1]:
        t = (3 * v["x"] + 4 * v["y"] - 41.3) / 25  # exact if the foot on the line is inside the square, and never smaller
        check(v["distance"] >= 5 * abs(t) - 1e-12, "a distance from a line that is too small")
        if 0 < v["x"] - 3 * t < 12 and 0 < v["y"] - 4 * t < 12:
            check_close(v["distance"], 5 * abs(t), 1e-11, "distance from a line")

    box = bench.path("cube.off")
    write_off(box, *cube(1, 4, lambda x: x + 0.1 * x * (4 - x)))  # squares of different sizes

    def from_edges(p):  # the second smallest distance from the plane of a side
        return max(0, sorted(min(x, 1.0 - x) for x in p)[1])

    bench.run(box, "--source-sharp-edges", 60, "--distance", 0.3, "--output", out, "--field", field)
    check_field(bench, box, from_edges)
    check_curves("sharp edges", read_vtk(out), [0.3], 6, 6, from_edges)

    bench.run(mesh, "--source-vertex", 0, "--source-vertex", 168, "--source-point", "5.3,6.1,0", "--source-polyline", curve,
              "--field", field)
    several = from_curve, from_point(5.3, 6.1), from_point(0, 0), from_point(12, 12)
    check_field(bench, mesh, lambda p: min(d(p) for d in several))


def test_sides(bench):
    """Sides of a polyline across the whole square, with the signed distance, and of a closed polyline."""
    mesh, out, field = planar(bench), bench.path("out.vtk"), bench.path("field.ply")
    across = bench.write("across.polylines.txt", "2 -1 6.1 0 13 6.1 0\n")  # the upper part is on the left
    square = bench.write("square.polylines.txt", polyline_text([(4, 4, 0), (8, 4, 0), (8, 8, 0), (4, 8, 0), (4, 4, 0)]))

    def run(curve, *options):
        return bench.run(mesh, "--source-polyline", curve, "--distance", 1.5, "--output", out, "--field", field, *options,
                         warning="1 away from the surface" if curve == across else None)["curves"][0]

    for options, sign in ((), 0), (("--side", "left"), 1), (("--side", "right"), -1):
        curves = run(across, *options)
        distance = (lambda p: sign * (p[1] - 6.1)) if sign else (lambda p: abs(p[1] - 6.1))
        check_curves("across %s" % (options,), read_vtk(out), [1.5], 1 if sign else 2, 0, distance)
        check_close(curves["length"], 12 if sign else 24, 1e-9, "length across %s" % (options,))
        for v in read_ply(field)["vertex"][1]:
            check_close(v["signed_distance"], 6.1 - v["y"], 1e-12, "signed distance")
    inside, outside = 4, 16 + 3 * math.pi
    for options, length in (((), inside + outside), (("--side", "both", "--end", "butt"), inside + outside),  # there are no ends
                            (("--side", "inside"), inside), (("--side", "left"), inside),
                            (("--side", "outside"), outside), (("--side", "right"), outside)):
        check_close(run(square, *options)["length"], length, 1e-9, "a square, %s" % (options,))


def test_formats(bench):
    """Equal distances from each format, from quadrangles, and from a soup that needs repair."""
    points = [(i, j, 0) for j in range(6) for i in range(7)]  # exact in every format
    corners = [(7 * j + i, 7 * j + i + 1, 7 * j + i + 8, 7 * j + i + 7) for j in range(5) for i in range(6)]
    faces = [f for n, (a, b, c, d) in enumerate(corners) for f in (((a, b, c), (a, c, d)) if n % 2 else ((a, b, d), (b, c, d)))]
    distance, out, field = from_point(3, 2), bench.path("out.vtk"), bench.path("field.ply")
    off = bench.path("grid.off")
    write_off(off, points, faces)
    lines = ["%d %d %d\n" % p for p in points]
    bench.write("grid.obj", "".join("v " + line for line in lines) + "".join("f %d %d %d\n" % tuple(i + 1 for i in f) for f in faces))
    bench.write("grid.ply", "ply\nformat ascii 1.0\nelement vertex 42\nproperty float x\nproperty float y\nproperty float z\n"
                "element face 60\nproperty list uchar int vertex_indices\nend_header\n" + "".join(lines)
                + "".join("3 %d %d %d\n" % f for f in faces))
    bench.write("grid.stl", "solid\n" + "".join(
        "facet normal 0 0 1\nouter loop\n%sendloop\nendfacet\n" % "".join("vertex " + lines[i] for i in f) for f in faces) + "endsolid\n")
    for name in "grid.off", "grid.obj", "grid.ply":
        bench.run(bench.path(name), "--source-vertex", 17, "--field", field)
        check_field(bench, off, distance)
    bench.run(bench.path("grid.stl"), "--source-point", "3,2,0", "--distance", 1.5, "--output", out)
    check_curves(".stl", read_vtk(out), [1.5], 1, 1, distance)

    bench.write("quads.off", "OFF\n42 30 0\n" + "".join(lines) + "".join("4 %d %d %d %d\n" % c for c in corners))
    bench.run(bench.path("quads.off"), "--source-vertex", 17, "--distance", 1.5, "--output", out, "--field", field)
    check_curves("quadrangles", read_vtk(out), [1.5], 1, 1, distance)
    check_field(bench, bench.path("quads.off"), distance)

    write_off(bench.path("turned.off"), points, [f[::-1] if i % 3 == 0 else f for i, f in enumerate(faces)])
    result = bench.start("turned.off", "--source-vertex", 17, "--distance", 1.5, "--output", out)
    check(result.returncode == 0 and "orient" in result.stdout + result.stderr, "the repair is reported: " + result.stdout + result.stderr)
    check_curves("faces that were turned", read_vtk(out), [1.5], 1, 1, distance)


def test_order(bench):
    """Circles around the middle of the grid, the largest ones open at its border: order, parents in all formats, and starts."""
    write_grid(bench.path("order.off"), lambda p: (p[0], p[1], 0))
    for order in "nesting", "distance":
        vtk, vtp, table = (bench.path("order." + extension) for extension in ("vtk", "vtp", "csv"))
        stats = bench.run(bench.path("order.off"), "--source-vertex", SOURCE, "--spacing", 1.5, "--order", order, "--output", vtk,
                          "--output", vtp, "--output", table)
        curves = stats["nesting"]
        closed = [c for c in curves if c["closed"]]
        check(len(closed) > 2 and len(curves) > len(closed), "closed and open curves")
        by_distance = sorted(c["distance"] for c in closed)
        check([c["distance"] for c in closed] == (by_distance[::-1] if order == "nesting" else by_distance), "the order")
        for i, c in enumerate(curves):
            around = [k for k in closed if k["distance"] > c["distance"]] if c["closed"] else []
            parent = min(around, key=lambda k: k["distance"])["curve"] if around else None
            check(c["curve"] == i and c["parent"] == parent and c["depth"] == len(around), "curve %s, parent %s" % (c, parent))
            check(c["inner_side"] == ("left" if c["closed"] else None), "the inner side")
        wanted = [(-1 if c["parent"] is None else c["parent"], 1 if c["closed"] else 0) for c in curves]
        with open(vtk) as file:
            words = file.read().split()
        columns = [list(map(int, words[words.index(name) + 4:words.index(name) + 4 + len(curves)])) for name in ("parent", "inner_side")]
        check(list(zip(*columns)) == wanted and words[words.index("FIELD") + 2] == "5", "cell data of .vtk: %s" % columns)
        with open(vtp) as file:
            text = file.read()
        columns = [list(map(int, re.search('Name="%s"[^>]*>([^<]*)<' % name, text).group(1).split())) for name in ("parent", "inner_side")]
        check(list(zip(*columns)) == wanted, "cell data of .vtp: %s" % columns)
        starts = {}
        with open(table, newline="") as file:
            for row in csv.DictReader(file):
                i = int(row["curve"])
                check((int(row["parent"]), int(row["inner_side"])) == wanted[i], "columns")
                starts.setdefault(i, [float(row[x]) for x in "xyz"])
        for c in closed:
            if c["parent"] is not None:
                gap = math.dist(starts[c["curve"]], starts[c["parent"]])
                check_close(gap, curves[c["parent"]]["distance"] - c["distance"], 1e-9, "starts on one ray")


def read_png(path):
    """Rows of pixels of a file with 8 bits per channel."""
    with open(path, "rb") as file:
        data = file.read()
    width, height, bits, kind = struct.unpack(">IIBB", data[16:26])
    check(data[:8] == b"\x89PNG\r\n\x1a\n" and bits == 8 and kind == 2, "the format of the picture")
    at, packed = 8, b""
    while at < len(data):
        size, name = struct.unpack(">I4s", data[at:at + 8])
        packed += data[at + 8:at + 8 + size] if name == b"IDAT" else b""
        at += 12 + size
    raw, rows, above = zlib.decompress(packed), [], bytes(3 * width)
    for y in range(height):
        mode, row = raw[y * (3 * width + 1)], bytearray(raw[y * (3 * width + 1) + 1:(y + 1) * (3 * width + 1)])
        for i in range(3 * width if mode else 0):
            a, b, c = (row[i - 3] if i > 2 else 0), above[i], (above[i - 3] if i > 2 else 0)
            paeth = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            row[i] = (row[i] + (0, a, b, (a + b) // 2, paeth)[mode]) & 255
        rows.append(bytes(row))
        above = rows[-1]
    return rows


def test_picture(bench):
    """Parts of the picture on request, each where it must be: on a plate with two sources, seen from above."""
    # 8 x 4 of two triangles; the bisector of the sources is the line x = 4
    mesh = bench.path("plate.off")
    write_off(mesh, [(0, 0, 0), (8, 0, 0), (8, 4, 0), (0, 4, 0)], [(0, 1, 2), (0, 2, 3)])

    def picture(*options):
        out = bench.path("out.png")
        bench.run(mesh, "--source-point", "2,2,0", "--source-point", "6,2,0", "--distance", 1.5, "--view", "0,0,1", "--picture", out, *options)
        return read_png(out)

    plain = picture()
    width, height = len(plain[0]) // 3, len(plain)
    # the plate, from the red points of the sources
    red = [(x, y) for y in range(height) for x in range(width) if plain[y][3 * x] > 200 and max(plain[y][3 * x + 1:3 * x + 3]) < 80]
    scale = (sum(x for x, y in red if x > width * 0.4) / sum(x > width * 0.4 for x, y in red)
             - sum(x for x, y in red if x < width * 0.4) / sum(x < width * 0.4 for x, y in red)) / 4
    middle, center = sum(x for x, y in red) / len(red), sum(y for x, y in red) / len(red)
    left, right, top, bottom = middle - 4 * scale, middle + 4 * scale, center - 2 * scale, center + 2 * scale

    def changed(item):
        rows = picture("--picture-with", item)
        check(len(rows) == height and len(rows[0]) == 3 * width, "the size of the picture")
        return [(x, y) for y in range(height) if rows[y] != plain[y]
                for x in range(width) if rows[y][3 * x:3 * x + 3] != plain[y][3 * x:3 * x + 3]]

    boundary = changed("voronoi")
    check(all(abs(x - middle) < 5 for x, y in boundary), "the bisector")
    check({y for x, y in boundary} >= set(range(int(top) + 5, int(bottom) - 5)), "the whole bisector")
    box = changed("box")
    near = [min(abs(x - left), abs(x - right), abs(y - top), abs(y - bottom)) for x, y in box]
    check(len(box) > 6 * scale and max(near) < 5, "the bounding box is the border of the plate: %s" % max(near, default=None))
    axes = changed("axes")
    check(len(axes) > 100 and all(x < 220 and y > height - 220 for x, y in axes), "axes in the lower left corner")
    labels = changed("labels")
    x, y = (sum(p[k] for p in labels) / len(labels) for k in (0, 1))
    check(len(labels) > 100 and max(math.dist(p, (x, y)) for p in labels) < 40, "one label")
    off = [math.dist(((min(p[0] for p in labels) - middle) / scale, (y - center) / scale), (s, 0)) - 1.5 for s in (-2, 2)]
    check(min(map(abs, off)) < 0.15, "the label is at its offset: %s" % off)
    check(len(changed("voronoi,box")) > max(len(boundary), len(box)), "two items")


if __name__ == "__main__":
    run_test(all=test_all, sources=test_sources, sides=test_sides, formats=test_formats, order=test_order, picture=test_picture)
