# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The programs validate_geodesic_distances and validate_geodesic_offsets: results of geodesic_offset are within the certified bounds;
errors in others are detected, located and summarized correctly; tables that cannot be read give one line."""

import heapq
import math
import random
import re
import struct

from program_bench import (TILTED, check, check_close, cube, polyline_text, read_ply, run_test, sphere, torus, write_grid, write_off)
from test_program_outputs import read_off

INFINITY = math.inf
ORDERS = "", "<", ">"  # of bytes in PLY files; the first is text
FORMATS = {"": "ascii", "<": "binary_little_endian", ">": "binary_big_endian"}
USUAL_NAMES = "distance", "quality", "scalar", "geodesic_distance", "geodesic", "value"


def tilted(p):
    w = (-1 / 3, 2 / 3, -2 / 3)  # normal of the plane
    return tuple(a - p[2] * b for a, b in zip(TILTED.space(p), w))


def column(distances):
    return "# distances\n" + "".join("%.17g\n" % d for d in distances)


def pairs(distances, seed):
    order = random.Random(seed).sample(range(len(distances)), len(distances))
    return "".join("\n  %d\t%.17g # a vertex\r\n" % (v, distances[v]) for v in order)


def table(order, name, mesh, distances, kind="double", with_faces=True):
    """A PLY file of the mesh, with the distances between other properties."""
    points, faces = mesh

    def row(codes, *values):
        if order:
            return struct.pack(order + codes, *values)
        return (" ".join("%.17g" % x for x in values) + " \n").encode()

    def single(x):
        return struct.unpack("f", struct.pack("f", x))[0]

    header = ("ply\nformat %s 1.0\ncomment a table\nelement camera 2\nproperty float zoom\nelement vertex %d\nproperty float x\n"
              "property float y\nproperty uchar mark\nproperty float z\nproperty %s %s\nproperty double weight\n"
              % (FORMATS[order], len(distances), kind, name))
    if with_faces:
        header += "element face %d\nproperty list uchar int vertex_indices\n" % len(faces)
    data = (header + "end_header\n").encode() + row("f", 0) + row("f", 1)
    for i, ((x, y, z), d) in enumerate(zip(points, distances)):
        data += row("ffBf%sd" % kind[0], single(x), single(y), i % 256, single(z), single(d) if kind == "float" else d, -1)
    return data + b"".join(row("B3i", 3, *f) for f in faces if with_faces)


class Report:
    """Lines "label: value (meaning)"."""

    def __init__(self, text):
        self.lines = dict(line.split(": ", 1) for line in text.splitlines() if ": " in line)

    def number(self, label, word=""):
        found = re.match(r"(?:.* )?%s *([-+.\w]+)" % word, self.lines.get(label, "")) if word else \
            re.match(r"([-+.\w]+)", self.lines.get(label, ""))
        if not check(found is not None, "%s %s in %s" % (label, word, self.lines)):
            return math.nan
        return float(found[1])

    def counts(self):
        return [int(self.number(label)) for label in ("inside", "too short", "too long", "infinite in the table only",
                                                      "finite in the table only", "beyond the tolerance")]


class Case:
    """A mesh, and the distances of its vertices from one of them, as geodesic_offset computes them."""

    def __init__(self, bench, name, mesh, source=None):
        self.bench, self.name, self.source = bench, name, len(mesh[0]) // 2 if source is None else source
        write_off(bench.path("mesh.off"), *mesh)
        self.mesh = read_off(bench.path("mesh.off"))
        result = bench.start("mesh.off", "--source-vertex", self.source, "--field", "exact.ply", "--quiet")
        check(result.returncode == 0, result.stderr)
        self.exact = [v["distance"] for v in read_ply(bench.path("exact.ply"))["vertex"][1]]

    def run(self, code, name, data, *options):
        """Report on a table; `rows` has lower and upper bound, distance and error of each vertex."""
        self.bench.write(name, data)
        result = self.bench.start("mesh.off", "--source-vertex", self.source, "--distances", name, "--per-vertex", "rows.txt", *options,
                                  program="validate_geodesic_distances")
        what = "%s, %s: " % (self.name, name)
        if not check(result.returncode == code and not result.stderr,
                     "%sexit code %d: %s%s" % (what, result.returncode, result.stdout, result.stderr)):
            raise SystemExit(1)
        with open(self.bench.path("rows.txt")) as file:
            header, *lines = file.read().splitlines()
        rows = [line.split() for line in lines]
        check(header == "# vertex lower upper distance error" and [int(r[0]) for r in rows] == list(range(len(self.exact))), what + header)
        self.rows = [tuple(map(float, r[1:])) for r in rows]
        report = Report(result.stdout)
        check(report.number("vertices") == sum(report.counts()[:5]) == len(self.exact), what + result.stdout)
        return report


def check_exact(case):
    n = len(case.exact)

    def inside(name, data):
        report = case.run(0, name, data)
        check(report.counts() == [n, 0, 0, 0, 0, 0] and report.lines["worst vertex"].startswith("none")
              and report.number("outside, absolute", "largest") == 0, "%s: %s" % (case.name, report.lines))
        for (lower, upper, distance, error), d in zip(case.rows, case.exact):
            check(distance == d and error == 0 and lower <= d <= upper, "%s: %.17g is %.17g" % (case.name, d, distance))

    inside("column.txt", column(case.exact))
    inside("pairs.txt", pairs(case.exact, 7))
    for order in ORDERS:
        for name in USUAL_NAMES:
            inside("table.ply", table(order, name, case.mesh, case.exact, with_faces=name[0] == "d"))


def check_disturbed(case):
    """A single error of 1e-9 is detected, and nothing else."""
    generator, n = random.Random(3), len(case.exact)
    candidates = [v for v, d in enumerate(case.exact) if 1e-3 <= d < INFINITY]
    for error in 1e-9, -1e-9:
        for kind in range(4):
            v, distances = generator.choice(candidates), list(case.exact)
            distances[v] += error
            name, data = (("column.txt", column(distances)), ("pairs.txt", pairs(distances, 5)),
                          ("ascii.ply", table("", "quality", case.mesh, distances)),
                          ("binary.ply", table("<", "quality", case.mesh, distances)))[kind]
            report = case.run(3, name, data)
            check(report.counts() == [n - 1, int(error < 0), int(error > 0), 0, 0, 1] and report.number("worst vertex") == v,
                  "vertex %d, error %g: %s" % (v, error, report.lines))
            for label in "outside, absolute", "outside, relative":
                check(report.number(label, "at vertex") == v, "%s at vertex %d: %s" % (label, v, report.lines))
            check_close(report.number("outside, absolute", "largest"), 1e-9, 1e-12, "the largest error")
            for u, row in enumerate(case.rows):
                check(abs(row[3] - (error if u == v else 0)) < (1e-12 if u == v else 1e-300), "error %g of vertex %d" % (row[3], u))
            part = abs(error) / case.exact[v]  # the tolerance is relative to the bound
            case.run(0, name, data, "--tolerance", repr(1.01 * part))
            check(case.run(3, name, data, "--tolerance", repr(0.99 * part)).counts()[5] == 1, "beyond the tolerance")


def along_edges(case):
    points, faces = case.mesh
    neighbours = [set() for _ in points]
    for f in faces:
        for k in range(3):
            neighbours[f[k - 1]].add(f[k])
            neighbours[f[k]].add(f[k - 1])
    length, queue = [INFINITY] * len(points), [(0, case.source)]
    length[case.source] = 0
    while queue:
        d, v = heapq.heappop(queue)
        if d == length[v]:
            for u in neighbours[v]:
                if d + math.dist(points[u], points[v]) < length[u]:
                    length[u] = d + math.dist(points[u], points[v])
                    heapq.heappush(queue, (length[u], u))
    return length


def check_figures(case, report):
    """Recomputes all figures from the rows."""
    counts = dict.fromkeys(("inside", "too short", "too long", "infinite in the table only", "finite in the table only"), 0)
    figures = {"absolute": [], "relative": []}  # width, distance outside, distance off the middle
    for lower, upper, distance, error in case.rows:
        if INFINITY in (upper, distance):
            label, expected = (("inside", 0) if upper == distance else ("infinite in the table only", INFINITY)
                               if distance == INFINITY else ("finite in the table only", -INFINITY))
            counts[label] += 1
            check(error == expected, "error %g" % error)
            continue
        bound, middle = lower if distance < lower else upper, 0.5 * (lower + upper)
        check(error == (0 if lower <= distance <= upper else distance - bound), "error %g" % error)
        counts["inside" if error == 0 else "too short" if error < 0 else "too long"] += 1
        figures["absolute"].append((upper - lower, abs(error), distance - middle))
        if middle > 0:
            figures["relative"].append(((upper - lower) / middle, abs(error) / bound, (distance - middle) / middle))
    for label, count in counts.items():
        check(report.number(label) == count, "%s: %d, not %s" % (label, count, report.lines))
    check(report.number("compared") == len(figures["absolute"]) and report.number("compared relatively") == len(figures["relative"]),
          "numbers of compared vertices")

    def same(expected, label, word=""):
        actual = report.number(label, word)
        check(actual == expected or abs(actual - expected) <= 2e-5 * abs(expected), "%s %s: %g, not %g" % (label, word, actual, expected))

    for kind, rows in figures.items():
        widths, outside, off = zip(*rows)
        for label, values in ("outside, " + kind, outside), ("off the middle, " + kind, off):
            same(max(map(abs, values)), label, "largest")
            same(sum(map(abs, values)) / len(rows), label, "mean")
            same(math.sqrt(sum(x * x for x in values) / len(rows)), label, "rms")
        same(sum(off) / len(rows), "bias, " + kind)
        same(sorted(widths)[len(rows) // 2], "width, " + kind, "median")
        same(max(widths), "width, " + kind, "largest")
        check(max(widths) < 1e-11, "width %g" % max(widths))


def check_other_methods(case, is_flat):
    n = len(case.exact)
    report = case.run(3, "edges.txt", column(along_edges(case)))  # paths on the surface
    counts = report.counts()
    check(counts[1] == 0 and counts[2] > n / 4 and report.number("bias, absolute") > 0 and report.number("bias, relative") > 0,
          "paths along edges: %s" % report.lines)
    check_figures(case, report)
    worst = case.rows[int(report.number("worst vertex"))][3]
    check(all(0 <= row[3] <= worst for row in case.rows), "the worst vertex")

    # straight lines in space are never longer than paths on the surface; on a flat convex surface they are the paths
    points = case.mesh[0]
    straight = [INFINITY if d == INFINITY else math.dist(points[case.source], p) * (1 - 1e-15) for p, d in zip(points, case.exact)]
    report = case.run(0 if is_flat else 3, "straight.txt", column(straight), "--tolerance", "1e-14" if is_flat else "0")
    counts = report.counts()
    check(counts[2] == 0 and (is_flat or counts[1] > n / 4 and report.number("bias, absolute") < 0), "straight lines: %s" % report.lines)
    check_figures(case, report)

    generator = random.Random(4)
    check_figures(case, case.run(3, "noisy.txt", column([d * generator.uniform(0.9, 1.2) for d in case.exact])))
    rounded = table("<", "distance", case.mesh, case.exact, "float")
    case.run(3, "float.ply", rounded)
    check(case.run(0, "float.ply", rounded, "--tolerance", "1e-7").counts()[0] < n, "numbers of single precision")


def rectangle(bench):
    write_grid(bench.path("grid.off"), tilted_plane)
    return read_off(bench.path("grid.off"))


def tilted_plane(p):
    return TILTED.space((p[0] / 6, p[1] / 12))


def test_distances(bench):
    box = cube(1, 4, lambda x: x + 0.1 * x * (4 - x))
    for name, mesh in (("sphere", sphere(2)), ("torus", torus(14, 9)), ("rectangle", rectangle(bench)),
                       ("box", ([tilted((x, 0.7 * y, 0.1 * z)) for x, y, z in box[0]], box[1]))):
        case = Case(bench, name, mesh)
        check_exact(case)
        check_disturbed(case)
        check_other_methods(case, name == "rectangle")

    # two parts and a vertex without faces
    (points, faces), (others, other_faces) = sphere(1), sphere(0)
    n = len(points)
    points, faces = points + [(x + 5, y, z) for x, y, z in others] + [(9, 9, 9)], faces + [tuple(i + n for i in f) for f in other_faces]
    case = Case(bench, "two parts", (points, faces), 3)
    check(case.exact.count(INFINITY) == len(others) + 1, "vertices that are not reached")
    check_exact(case)
    check_disturbed(case)
    check_other_methods(case, False)
    for order in "", "<":
        distances = list(case.exact)
        distances[4], distances[n + 2], distances[n + 3] = INFINITY, 7, 8
        report = case.run(3, "some.ply", table(order, "d", case.mesh, distances), "--property", "d", "--tolerance", "1e100")
        check(report.counts() == [len(points) - 3, 0, 0, 1, 2, 3] and report.number("worst vertex") == 4, "infinities: %s" % report.lines)
        check_figures(case, report)
    report = case.run(3, "none.txt", column([INFINITY] * len(points)))
    check(report.number("compared") == 0 and report.counts()[3] == n, "no distances: %s" % report.lines)

    # two triangles that share no vertex, along an edge at the same place: borders stay apart
    case = Case(bench, "two borders", ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (3, 4, 5)]), 0)
    check("mesh" in case.run(0, "apart.txt", "0\n1\n1\ninf\ninf\ninf\n").lines, "the mesh is reported")
    case.run(3, "joined.txt", "0\n1\n1\n1\n1.4142135623730951\n1\n")


def test_fields(bench):
    """Sources of all kinds, with the field of geodesic_offset"""
    curve = "--source-polyline", bench.write("curve.polylines.txt", polyline_text([(-1, -1, 0.2), (1, -0.5, 0.3), (1.2, 1, 0.2)]))
    vertex, point, plane = ("--source-vertex", 5), ("--source-point", "0.3,0.2,0.1"), ("--source-plane", "0.3,1,0.2,-0.1")
    write_off(bench.path("round.off"), *torus(18, 12))
    write_grid(bench.path("flat.off"), lambda p: (p[0] / 6, p[1] / 12, 0))
    box = cube(1, 4, lambda x: x + 0.1 * x * (4 - x))
    write_off(bench.path("box.off"), [tilted((x, 0.7 * y, 0.4 * z)) for x, y, z in box[0]], box[1])
    for mesh, *sources in (("round.off", *vertex), ("round.off", *point), ("round.off", *curve), ("round.off", *plane),
                           ("round.off", *vertex, "--source-point", "1,1,1", *curve),
                           ("round.off", *vertex, *plane, "--start-value", "0,0.1"), ("flat.off", "--source-boundary"),
                           ("flat.off", "--source-plane", "1,0.2,0,-0.7", "--source-point", "1.7,0.6,0"), ("flat.off", *curve),
                           ("box.off", "--source-sharp-edges", 60), ("box.off", *point)):
        what = "%s from %s: " % (mesh, sources)
        result = bench.start(mesh, "--field", "field.ply", "--quiet", *sources)
        check(result.returncode == 0, what + result.stderr)
        arguments = (mesh, "--distances", "field.ply", "--per-vertex", "rows.txt", *sources)
        result = bench.start(*arguments, program="validate_geodesic_distances")
        n = len(read_off(bench.path(mesh))[0])
        check(result.returncode == 0 and Report(result.stdout).counts()[0] == n, what + result.stdout + result.stderr)
        # with a source more, the distances are too long there, and nowhere too short
        with open(bench.path("rows.txt")) as file:
            lower = [float(line.split()[1]) for line in file.readlines()[1:]]
        farthest = lower.index(max(lower))
        result = bench.start(*arguments, "--source-vertex", farthest, program="validate_geodesic_distances")
        report = Report(result.stdout)
        check(result.returncode == 3 and report.lines["worst vertex"].startswith("%d:" % farthest) and report.number("too long") > 0
              and report.number("too short") == 0, what + result.stdout + result.stderr)


def test_tables(bench):
    """PLY tables that cannot be read, or end early: one line that names the file, and no output."""
    case = Case(bench, "sphere", sphere(1), 0)
    n, mesh, exact = len(case.exact), case.mesh, case.exact

    def refuse(data, words, *options):
        bench.write("bad.ply", data)
        bench.expect_error(1, ["'bad.ply'", *words], "mesh.off", "--source-vertex", 0, "--distances", "bad.ply", "--per-vertex",
                           "none.txt", *options, program="validate_geodesic_distances")

    def changed(data, old, new):
        check(old in data, "%s in the table" % old)
        return data.replace(old, new, 1)

    def with_distance(d, order, kind="double"):
        return table(order, "distance", mesh, exact[:11] + [d] + exact[12:], kind)

    generator = random.Random(9)
    for order in ORDERS:
        data = table(order, "distance", mesh, exact)
        case.run(0, "whole.ply", data)
        refuse(data, ["no property 'heat'", "distance"], "--property", "heat")
        refuse(table(order, "heat", mesh, exact), ["--property", "heat"])
        refuse(data, ["'weight'", "negative"], "--property", "weight")
        refuse(data, ["'mark'", "uchar"], "--property", "mark")
        refuse(changed(data, b"property double distance", b"property list uchar double distance"), ["'distance'", "list"])
        for kind in "half", "list", "list uchar", "list float int", "list uchar half":
            refuse(changed(data, b"property uchar mark", b"property %s mark" % kind.encode()),
                   ["'mark'", "unknown type '%s'" % kind])
        refuse(table(order, "distance", mesh, exact[:-1]), ["41 vertices", "mesh.off", "42"])
        refuse(changed(data, b"vertex 42", b"vertex 43"), ["43 vertices", "mesh.off", "42"])
        refuse(changed(data, b"vertex 42", b"vertex 4000000000"), ["4000000000 vertices", "mesh.off"])
        refuse(changed(data, b"element vertex 42", b"element point 42"), ["no vertices"])
        refuse(changed(data, b"element vertex", b"element nothing 99999999999\nelement vertex"), ["'nothing'"])
        refuse(changed(data, b"format " + FORMATS[order].encode(), b"format other"), ["malformed"])
        points = list(mesh[0])
        points[7], points[30] = points[30], points[7]
        refuse(table(order, "distance", (points, mesh[1]), exact), ["vertex 7 ", "mesh.off", "order"])
        refuse(with_distance(-0.25, order), ["vertex 11", "-0.25", "negative"])
        for kind in "float", "double":
            refuse(with_distance(math.nan, order, kind), ["vertex 11", "nan"])
        header, row = data.index(b"end_header\n") + 11, 29 if order else 60
        for size in (2, 20, header // 2, header - 4, *(header + i * row for i in range(1, 40, 7))):
            refuse(data[:size], [])
        if order:
            refuse(data[:header] + generator.randbytes(5000), [])
    for words, message in (("-1", "-1e-300"), "negative"), (
            ("x", "1.5x", "1,5", "0x10", "1e999", "nan", "-nan", "NaN", "-inf"), "neither a finite number nor inf"):
        for word in words:
            refuse(changed(table("", "distance", mesh, exact), b" 0 -1 \n", b" %s -1 \n" % word.encode()),
                   ["line ", "vertex 0", "'%s'" % word, message])
    refuse("ply\nformat ascii 1.0\nelement vertex %d\n%send_header\n"
           % (n, "".join("property float p%d\n" % i for i in range(1000))), [])
    bench.write("noise.txt", generator.randbytes(3000))
    bench.expect_error(1, ["'noise.txt', line "], "mesh.off", "--source-vertex", 0, "--distances", "noise.txt",
                       program="validate_geodesic_distances")


def test_offsets(bench):
    """Offsets of geodesic_offset are certified within their chord tolerance, and curves with faults are found."""
    write_off(bench.path("mesh.off"), *torus(16, 12))
    result = bench.start("mesh.off", "--source-vertex", 0, "--distance", 1.6, "--tolerance", 1e-4, "--output", "own.polylines.txt",
                         "--quiet")
    check(result.returncode == 0, result.stderr)
    with open(bench.path("own.polylines.txt")) as file:
        own = [line.split() for line in file]
    check(len(own) > 1 and all(len(c) == 1 + 3 * int(c[0]) and int(c[0]) > 4 and c[1:4] == c[-3:] for c in own), "closed curves")

    def run(curves, code, *options, distance=("--distance", 1.6)):
        bench.write("tested.polylines.txt", "".join(" ".join(c) + "\n" for c in curves))
        result = bench.start("mesh.off", "--source-vertex", 0, "--curves", "tested.polylines.txt", *distance, *options,
                             program="validate_geodesic_offsets")
        check(result.returncode == code and not result.stderr,
              "%s: exit code %d: %s%s" % (options, result.returncode, result.stdout, result.stderr))
        return result.stdout

    text = run(own, 0)
    check("region: yes" in text and Report(text).number("tolerance") <= 1.2e-4 and "reversed" not in text
          and "curves: %d curves" % len(own) in text, text)
    run(own, 0, "--tolerance", 2e-4)
    run(own, 3, "--tolerance", 1e-7)
    for level in "1.6", "1.61", "1.62", "1.63", "1.65", "1.67", "1.71":  # the printed tolerance is rounded up, so that it is accepted
        distance = "--distance", level
        tolerance = Report(run(own, 0, distance=distance)).lines["tolerance"].split(",")[0]
        run(own, 0, "--tolerance", tolerance, distance=distance)
    text = run([], 0, "--tolerance", 1e-9, distance=("--distance", 100))  # beyond the surface, no curve is the offset
    check("tolerance: 0 (" in text, text)
    check(Report(run([], 0)).number("tolerance") > 0.1, "no curves within the surface")
    text = run(own, 0, distance=("--distance", 1.7))
    check(0.0999 < Report(text).number("tolerance") < 0.1002 and "nearer to the sources" in text, text)

    for i, curve in enumerate(own):
        def with_curve(points):
            return own[:i] + [[str(len(points) // 3), *points]] + own[i + 1:]

        points = curve[1:]
        run(own[:i] + own[i + 1:], 3, "--tolerance", 1e-3)
        text = run(with_curve(points[:-3]), 3)
        check("region: no (a curve ends inside the surface)\nat: " in text and "curve in line %d" % (i + 1) in text, text)
        text = run(with_curve([x for k in range(len(points) - 3, -1, -3) for x in points[k:k + 3]]), 0)
        check("\nreversed: 1 " in text and "the first one in line %d)" % (i + 1) in text, text)
        away = with_curve(["9"] * 3 + points[3:-3] + ["9"] * 3)
        text = run(away, 3)
        check("\nsurface: no (" in text and "line %d: point 0 is " % (i + 1) in text, text)
        run(away, 3, "--surface-tolerance", 100, "--tolerance", 1e-3)


if __name__ == "__main__":
    run_test(distances=test_distances, fields=test_fields, tables=test_tables, offsets=test_offsets)
