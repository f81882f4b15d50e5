# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared parts of the tests of output files: counted checks, meshes in a plane, closed forms, and runs of the program.

A test is a function that takes a `Bench`. The scripts are called with the path of the program and, if they hold several
tests, the name of one. Their exit code is 77, for "skipped", where a reader is not installed.
"""

import importlib
import json
import math
import os
import random
import struct
import subprocess
import sys
import tempfile

checks = failures = 0


def check(ok, text):
    global checks, failures
    checks += 1
    if not ok:
        failures += 1
        if failures <= 20:
            print("FAILED", text)
    return ok


def check_close(actual, expected, tolerance, text):
    check(abs(actual - expected) <= tolerance, "%s: %.17g, expected %.17g, difference %.3g"
          % (text, actual, expected, actual - expected))


def skip(reader):
    print("%s: skipped, %s is not installed; before that, %d failures"
          % (os.path.basename(sys.argv[0]), reader, failures))
    sys.exit(1 if failures else 77)


def readers(package, *names):
    """Classes of a package of Debian, by module and name; without it the test is skipped."""
    try:
        found = [getattr(importlib.import_module(module), name) for module, name in (n.rsplit(".", 1) for n in names)]
    except ImportError:
        skip(package)
    return found if len(found) > 1 else found[0]


def vtk_readers(*names):
    return readers("python3-vtk9", *("vtkmodules." + name for name in names))


class Plane:
    """Isometric coordinates of a plane in space; right-handed if it is seen from its positive side."""

    def __init__(self, origin=(0, 0, 0), u=(1, 0, 0), v=(0, 1, 0)):
        self.origin, self.u, self.v = origin, u, v

    def space(self, p):
        return tuple(o + p[0] * a + p[1] * b for o, a, b in zip(self.origin, self.u, self.v))

    def plane(self, p):
        d = [a - b for a, b in zip(p, self.origin)]
        return sum(a * b for a, b in zip(d, self.u)), sum(a * b for a, b in zip(d, self.v))

    def text(self, p):
        """The point as an argument of the program"""
        return ",".join("%.17g" % x for x in self.space(p))


HORIZONTAL = Plane((0, 0, 0.3))
TILTED = Plane((0.5, -2, 1), (2 / 3, 2 / 3, 1 / 3), (-2 / 3, 1 / 3, 2 / 3))


def write_off(path, points, faces):
    with open(path, "w") as out:
        out.write("OFF\n%d %d 0\n" % (len(points), len(faces)))
        for p in points:
            out.write("%.17g %.17g %.17g\n" % tuple(p))
        for f in faces:
            out.write("3 %d %d %d\n" % f)


def write_grid(path, embed, n=12, is_turned=False, is_two_sided=False):
    """n x n squares of side 1 with moved vertices, in the plane. With two sides, the second has the opposite
    orientation and the other diagonals, so that no corner has the same face on both."""
    generator = random.Random(7)

    def moved(i, inside):
        return i + (generator.uniform(-0.24, 0.24) if inside else 0)

    points, faces, faces_below = [], [], []
    for j in range(n + 1):
        for i in range(n + 1):
            points.append(embed((moved(i, 0 < i < n), moved(j, 0 < j < n))))
    for j in range(n):
        for i in range(n):
            a = j * (n + 1) + i
            b, c, d = a + 1, a + n + 2, a + n + 1
            diagonals = [[(a, b, c), (a, c, d)], [(a, b, d), (b, c, d)]]
            faces += diagonals[1 - (i + j) % 2]
            faces_below += diagonals[(i + j) % 2]
    if is_turned:
        faces, faces_below = [f[::-1] for f in faces], [f[::-1] for f in faces_below]
    if is_two_sided:
        below = {}
        for v, p in enumerate(points[:]):
            is_inside = 0 < v % (n + 1) < n and 0 < v // (n + 1) < n
            below[v] = len(points) if is_inside else v
            if is_inside:
                points.append(p)
        faces += [tuple(below[v] for v in f[::-1]) for f in faces_below]
    write_off(path, points, faces)


def sphere(levels):
    """Icosahedron whose faces are divided into four, `levels` times, with the vertices on the unit sphere."""
    g = (1 + math.sqrt(5)) / 2
    points = [p for s in (-1, 1) for t in (-g, g) for p in ((0, s, t), (s, t, 0), (t, 0, s))]
    near = [{j for j, q in enumerate(points) if abs(math.dist(p, q) - 2) < 1e-9} for p in points]
    faces = [(i, j, k) for i in range(12) for j in near[i] for k in near[i] & near[j] if i < j < k]
    faces = [f if determinant(*(points[i] for i in f)) > 0 else f[::-1] for f in faces]
    points = [tuple(x / math.hypot(*p) for x in p) for p in points]
    for _ in range(levels):
        middles = {}

        def middle(i, j):
            key = min(i, j), max(i, j)
            if key not in middles:
                p = [a + b for a, b in zip(points[i], points[j])]
                middles[key] = len(points)
                points.append(tuple(x / math.hypot(*p) for x in p))
            return middles[key]

        faces = [t for a, b, c in faces for x, y, z in ((middle(a, b), middle(b, c), middle(c, a)),)
                 for t in ((a, x, z), (b, y, x), (c, z, y), (x, y, z))]
    return points, faces


def determinant(p, q, r):
    return (p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) + p[2] * (q[0] * r[1] - q[1] * r[0]))


def torus(n, m, major=1, minor=0.4):
    angles = [(2 * math.pi * i / n, 2 * math.pi * j / m) for i in range(n) for j in range(m)]
    points = [((major + minor * math.cos(b)) * math.cos(a), (major + minor * math.cos(b)) * math.sin(a), minor * math.sin(b))
              for a, b in angles]
    corners = [(i * m + j, (i + 1) % n * m + j, (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m)
               for i in range(n) for j in range(m)]
    return points, [f for a, b, c, d in corners for f in ((a, b, c), (a, c, d))]


def cube(side, n, moved=lambda x: x):
    """With n x n squares per side; `moved` takes the coordinates of lines of the grid."""
    number, faces = {}, []
    for axis in range(3):
        for end in (0, n):
            for i in range(n):
                for j in range(n):
                    corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]]
                    keys = [tuple((c[:axis] + [end] + c[axis:])) for c in corners][::1 if (end > 0) == (axis != 1) else -1]
                    a, b, c, d = (number.setdefault(key, len(number)) for key in keys)
                    faces += [(a, b, c), (a, c, d)]
    return [tuple(moved(x) * side / n for x in key) for key in number], faces


def polyline_text(points):
    return "%d %s\n" % (len(points), " ".join("%.17g %.17g %.17g" % tuple(p) for p in points))


A, B = (4.1, 5.2), (7.3, 6.4)  # the ends of the segment of the stadiums
C = (6.3, 5.6)  # the center of the circles


def from_segment(p):
    """The distance from the segment, and the side: 1 left, 2 right, 3 beyond an end; None near a change of side."""
    ab, ap = (B[0] - A[0], B[1] - A[1]), (p[0] - A[0], p[1] - A[1])
    length = math.hypot(*ab)
    t = (ab[0] * ap[0] + ab[1] * ap[1]) / length
    s = (ab[0] * ap[1] - ab[1] * ap[0]) / length
    side = 3 if t < 0 or t > length else 1 if s > 0 else 2
    if min(abs(t), abs(t - length), abs(s)) < 1e-6:
        side = None
    return math.hypot(t - min(max(t, 0), length), s), side


def from_center(p):
    return math.hypot(p[0] - C[0], p[1] - C[1])


E = (10, 6.3)  # a center close to the border x = 12, and its image beyond the border


def from_plate_center(p):
    """The distance on the side of the plate where p is nearer."""
    return math.hypot(p[0] - E[0], p[1] - E[1]), math.hypot(24 - p[0] - E[0], p[1] - E[1])


LENGTH = math.hypot(B[0] - A[0], B[1] - A[1])


def stadium(d):
    return 2 * LENGTH + 2 * math.pi * d


class Bench:
    """A scratch folder in which the program runs."""

    def __init__(self, program, folder, options=()):
        self.program, self.folder, self.options = program, folder, options

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        with open(self.path(name), "wb") as out:
            out.write(content if isinstance(content, bytes) else content.encode())
        return self.path(name)

    def start(self, *arguments, program="geodesic_offset", shell=None):
        """Exit code and output of a program in the scratch folder. `shell`: with a command in front, and a redirection behind."""
        words = [os.path.join(os.path.dirname(self.program), program), *map(str, arguments)]
        if shell:
            words = ["/bin/sh", "-c", '%s exec "$@" %s' % shell, "sh", *words]
        return subprocess.run(words, cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              encoding="utf-8", errors="backslashreplace", timeout=300, env=dict(os.environ, LC_ALL="C"))

    def files(self):
        return {name: os.lstat(self.path(name)).st_mtime_ns for name in os.listdir(self.folder)}

    def expect_error(self, code, words, *arguments, program="geodesic_offset", shell=None):
        """One line with the words, and no file is changed. Validating programs have no output."""
        before = self.files()
        result = self.start(*arguments, program=program, shell=shell)
        text = result.stderr
        check(result.returncode == code and text.count("\n") == 1 and text.startswith(program + ": ") and text.endswith("\n")
              and text[:-1].isprintable() and len(text) < 1000 and all(word in text for word in words)
              and (program == "geodesic_offset" or not result.stdout),
              "%s, %s: exit code %d, not %d: %s%s" % (arguments, shell, result.returncode, code, result.stdout, text))
        check(self.files() == before, "%s, %s: files were changed" % (arguments, shell))

    def run(self, *arguments, warning=None):
        """Returns the statistics. `warning`: words of the warning that is expected, the only one."""
        stats = self.path("stats.json")
        result = self.start(*arguments, "--stats", stats, "--quiet", program=os.path.basename(self.program))
        text = "exit code %d: %s" % (result.returncode, result.stderr)
        lines = result.stderr.splitlines()
        is_expected = not lines if warning is None else len(lines) == 1 and "warning: " in lines[0] and warning in lines[0]
        if not check(result.returncode == 0 and is_expected, text):
            raise SystemExit(1)
        with open(stats) as file:
            return json.load(file)

    def segment(self, plane):
        return "--source-polyline", self.write("segment.polylines.txt", polyline_text([plane.space(A), plane.space(B)]))

    def center(self, plane):
        return "--source-point", plane.text(C)

    def grid(self, plane, is_turned=False):
        write_grid(self.path("grid.off"), plane.space, is_turned=is_turned)
        return self.path("grid.off")

    def plate(self, plane):
        """The grid with its other side."""
        write_grid(self.path("plate.off"), plane.space, is_two_sided=True)
        return self.path("plate.off")

    def ridge(self):
        """A horizontal half, x < 6, and one that goes down; unfolded it is the grid."""
        write_grid(self.path("ridge.off"), lambda p: ridge_point((6 if abs(p[0] - 6) < 0.25 else p[0], p[1])))
        return self.path("ridge.off")


def ridge_point(p):
    return (p[0], p[1], 0) if p[0] <= 6 else (6 + 0.8 * (p[0] - 6), p[1], -0.6 * (p[0] - 6))


def ridge_unfolded(p):
    return (p[0], p[1]) if p[0] <= 6 else (6 + (p[0] - 6) / 0.8, p[1])


def chain_length(points):
    return sum(math.dist(p, q) for p, q in zip(points, points[1:]))


def read_polylines(path):
    with open(path) as file:
        rows = [line.split() for line in file]
    check(all(len(row) == 1 + 3 * int(row[0]) for row in rows), "numbers of points")
    return [[tuple(float(x) for x in row[k:k + 3]) for k in range(1, len(row), 3)] for row in rows]


def read_ply(path):
    """Of each element of a binary PLY file the names of its properties and its rows, as dictionaries; a list is a tuple."""
    codes = {"double": "d", "float": "f", "int": "i", "uint": "I", "uchar": "B"}
    with open(path, "rb") as file:
        header, body = file.read().split(b"end_header\n", 1)
    lines = [line.split() for line in header.decode().split("\n")]
    check(lines[:2] == [["ply"], ["format", "binary_little_endian", "1.0"]], "the header of a binary PLY file")
    elements, at = {}, 0
    for line in lines[2:]:
        if line[:1] == ["element"]:
            elements[line[1]] = (int(line[2]), properties := [])
        elif line[:1] == ["property"]:
            properties.append((line[-1], [codes[t] for t in line[1:-1] if t != "list"]))
    result = {}
    for name, (count, properties) in elements.items():
        rows = []
        for _ in range(count):
            row = {}
            for key, types in properties:
                size = 1
                for code in types:  # of a list: its length, its items
                    values = struct.unpack_from("<%d%s" % (size, code), body, at)
                    at += struct.calcsize("<%d%s" % (size, code))
                    size = values[0]
                row[key] = values if len(types) > 1 else values[0]
            rows.append(row)
        result[name] = ([key for key, _ in properties], rows)
    check(at == len(body), "%d bytes behind the rows" % (len(body) - at))
    return result


def check_levels(stats, distances):
    check([level["distance"] for level in stats["curves"]] == distances, "distances of the statistics")


def run_test(**tests):
    """The `main` of a script."""
    if len(sys.argv) < 3 or not os.path.exists(sys.argv[1]) or sys.argv[2] not in tests:
        print("usage: %s PROGRAM %s" % (os.path.basename(sys.argv[0]), "|".join(tests)))
        sys.exit(2)
    with tempfile.TemporaryDirectory() as folder:
        tests[sys.argv[2]](Bench(os.path.abspath(sys.argv[1]), folder, sys.argv[3:]))
    print("%s: %d checks, %d failures" % (sys.argv[2], checks, failures))
    sys.exit(0 if failures == 0 and checks > 0 else 1)
