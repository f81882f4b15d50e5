# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours of the picture: those of the legend at the distance of each point, also inside faces, as VTK reads the file."""

import collections
import math

from program_bench import check, check_close, run_test, vtk_readers, write_off

WIDTH, HEIGHT = 100, 60  # of the plate
HOLE = (35, 20, 65, 40)
# the farthest point of the plate is equidistant from its left side, its lower side and a corner of its hole
REACH = 55 - math.sqrt(1400)


def write_plate(path, step=None):
    """With 8 vertices, or as a grid."""
    if step is None:
        corners = [(0, 0), (WIDTH, 0), (WIDTH, HEIGHT), (0, HEIGHT)]
        x0, y0, x1, y1 = HOLE
        points = corners + [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
        faces = []
        for i in range(4):
            j = (i + 1) % 4
            faces += [(i, j, 4 + j), (i, 4 + j, 4 + i)]
    else:
        number, points, faces = {}, [], []

        def vertex(i, j):
            if (i, j) not in number:
                number[i, j] = len(points)
                points.append((i * step, j * step))
            return number[i, j]

        for i in range(round(WIDTH / step)):
            for j in range(round(HEIGHT / step)):
                x, y = (i + 0.5) * step, (j + 0.5) * step
                if HOLE[0] < x < HOLE[2] and HOLE[1] < y < HOLE[3]:
                    continue
                a, b, c, d = vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)
                faces += [(a, b, c), (a, c, d)]
    write_off(path, [(x, y, 0) for x, y in points], faces)


def from_boundary(x, y):
    x0, y0, x1, y1 = HOLE
    hole = math.hypot(max(x0 - x, 0, x - x1), max(y0 - y, 0, y - y1))
    return min(x, WIDTH - x, y, HEIGHT - y, hole)


class Picture:
    """Pixels from the left and from the top."""

    def __init__(self, reader_class, path):
        reader = reader_class()
        reader.SetFileName(path)
        reader.Update()
        self.width, self.height, _ = reader.GetOutput().GetDimensions()
        self.data = bytes(memoryview(reader.GetOutput().GetPointData().GetScalars()))
        self.numbers = len(self.data) // (self.width * self.height)  # of a pixel

    def rgb(self, x, y):
        at = self.numbers * ((self.height - 1 - y) * self.width + x)
        return tuple(self.data[at:at + 3])

    def colors(self):
        """The number of pixels of each colour"""
        return collections.Counter(zip(*(self.data[k::self.numbers] for k in range(3))))

    def light(self, x, y):
        """What can be added and multiplied, unlike the numbers of the file."""
        return tuple(v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in (c / 255 for c in self.rgb(x, y)))

    def source_box(self):
        """First and last columns and rows of the plate's source, and half the width of its line."""
        row = self.height // 2
        columns = [x for x in range(self.width) if is_red(self.rgb(x, row))]
        rows = [y for y in range(self.height) if is_red(self.rgb(columns[0] + 20, y))]
        half = next(i for i in range(20) if columns[0] + i not in columns) / 2
        return columns[0], columns[-1], rows[0], rows[-1], half


def is_red(c):
    return c[0] > 180 and c[1] < 60 and c[2] < 90


def is_ink(c):
    return max(abs(c[0] - 48), abs(c[1] - 52), abs(c[2] - 66)) < 4


class Legend:
    """The bar on the right of the mesh: a frame of ink, which is no darker than its numbers."""

    def __init__(self, picture, first_column):
        row = picture.height // 2
        ink = [x for x in range(first_column, picture.width) if is_ink(picture.rgb(x, row))]
        self.is_there = len(ink) > 1
        if not self.is_there:
            return
        right = next(x for x in ink if x > ink[0] + 5)
        self.picture, self.column = picture, (ink[0] + right) // 2
        rows = [y for y in range(picture.height) if is_ink(picture.rgb(self.column, y))]
        self.top, self.bottom = next(y for y in rows if y + 1 not in rows) + 1, next(y for y in rows[::-1] if y - 1 not in rows)

    def light(self, part):
        """Between two pixels; part 0 is at the bottom."""
        at = self.bottom - 0.5 - part * (self.bottom - self.top)
        y = min(max(int(at), self.top + 1), self.bottom - 3)
        t = at - y
        low, high = self.picture.light(self.column, y), self.picture.light(self.column, y + 1)
        return tuple(a + t * (b - a) for a, b in zip(low, high))


def shading(pairs):
    """k, s and the largest error of `actual = k * legend + s`, by least squares: all of a plate has the same light."""
    n = len(pairs)
    mx, my = sum(x for x, _ in pairs) / n, sum(y for _, y in pairs) / n
    k = sum((x - mx) * (y - my) for x, y in pairs) / sum((x - mx) ** 2 for x, _ in pairs)
    s = my - k * mx
    return k, s, max(abs(y - k * x - s) for x, y in pairs)


def check_boundary(bench, reader):
    """The plate of 8 vertices, all of them at distance 0, and the plate of thousands."""
    for step in (None, 0.5):
        name = "plate of 8 vertices" if step is None else "plate of many vertices"
        write_plate(bench.path("plate.off"), step)
        stats = bench.run(bench.path("plate.off"), "--source-boundary", "--view", "0,0,1", "--picture", bench.path("p.png"))
        check_close(stats["largest_distance"], REACH, 1e-12, "largest distance of the " + name)
        picture = Picture(reader, bench.path("p.png"))
        left, right, top, bottom, half = picture.source_box()
        legend = Legend(picture, right + 10)
        if not check(legend.is_there and legend.bottom - legend.top > 300, "legend of the " + name):
            continue
        pairs = []
        for i in range(5, 2 * WIDTH, 7):
            for j in range(5, 2 * HEIGHT, 5):
                x, y = i / 2, j / 2
                d = from_boundary(x, y)
                if d < 2:  # beside the red line, and in the hole
                    continue
                column = int(left + half + (right + 1 - left - 2 * half) * x / WIDTH)
                row = int(bottom + 1 - half - (bottom + 1 - top - 2 * half) * y / HEIGHT)
                pairs += zip(legend.light(d / REACH), picture.light(column, row))
        check(len(pairs) > 1000, "%d places" % len(pairs))
        k, s, error = shading(pairs)
        check(0.6 < k < 1.2 and abs(s) < 0.05, "light of the %s: %g, %g" % (name, k, s))
        check(error < 0.02, "colours of the %s: off by %g" % (name, error))


def check_across(bench, reader):
    """Coarse and fine plates look alike, whatever the source, and so does a distance limit."""
    with open(bench.path("across.polylines.txt"), "w") as out:
        out.write("2 0 10 0 100 50 0\n")
    for options in (("--source-polyline", bench.path("across.polylines.txt")), ("--source-point", "20,45,0"),
                    ("--source-point", "20,45,0", "--maximum-distance", 40)):
        pictures = []
        for step in (None, 0.5):
            write_plate(bench.path("plate.off"), step)
            bench.run(bench.path("plate.off"), *options, "--view", "0,0,1", "--picture", bench.path("p.png"))
            pictures.append(Picture(reader, bench.path("p.png")))
        check((pictures[0].width, pictures[0].height) == (pictures[1].width, pictures[1].height), "sizes")
        different, compared = 0, 0
        for y in range(1, pictures[0].height, 5):
            for x in range(1, pictures[0].width, 5):
                compared += 1
                different += max(abs(a - b) for a, b in zip(pictures[0].rgb(x, y), pictures[1].rgb(x, y))) > 6
        # along the limit, and at the line of the source, which differs by rounding
        check(compared > 50000 and different < 0.003 * compared, "%s: %d of %d pixels differ" % (options, different, compared))


def check_far_side(bench, reader):
    """What lies on the far side of a plate of eight pixels does not show through it: no path, no source, and no white rim."""
    with open(bench.path("thin.off"), "w") as out:
        out.write("OFF\n8 12 0\n" + "".join("%g %g %g\n" % (x, y, z) for z in (0, 0.5) for y in (0, 60) for x in (0, 100)))
        for a, b, c, d in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)):
            out.write("3 %d %d %d\n3 %d %d %d\n" % (a, b, c, a, c, d))
    for view, is_near in (("0,0,-1", True), ("0,0,1", False)):
        bench.run(bench.path("thin.off"), "--source-point", "20,30,0", "--path-from", "80,40,0", "--view", view,
                  "--picture", bench.path("p.png"))
        picture = Picture(reader, bench.path("p.png"))
        colors = picture.colors()
        for name, mark in (("rim", (255, 255, 255)), ("path", (24, 60, 190)), ("source", (226, 24, 54))):
            marked = colors[mark]
            check(marked > 100 if is_near else marked == 0, "view %s: %d pixels of the %s" % (view, marked, name))


def test_picture(bench):
    vtkPNGReader = vtk_readers("vtkIOImage.vtkPNGReader")
    check_boundary(bench, vtkPNGReader)
    check_across(bench, vtkPNGReader)
    check_far_side(bench, vtkPNGReader)


if __name__ == "__main__":
    run_test(picture=test_picture)
