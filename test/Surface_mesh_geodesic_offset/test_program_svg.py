# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Offsets in the format .svg, as svgelements reads and librsvg paints them."""

import math
import shutil
import subprocess
from xml.etree import ElementTree

from program_bench import (E, HORIZONTAL, TILTED, Plane, check, check_close, check_levels, from_center,
                           from_plate_center, from_segment, readers, run_test, skip, vtk_readers)
from test_program_picture import Picture

SVG = "{http://www.w3.org/2000/svg}"


def read_svg(path):
    """The viewBox, the width of the stroke, and texts of paths by distance."""
    root = ElementTree.parse(path).getroot()
    check(root.tag == SVG + "svg", "root " + root.tag)
    groups = {}
    (outer,) = root.findall(SVG + "g")
    for group in outer.findall(SVG + "g"):
        distance = float(group.get("data-distance"))
        check(distance not in groups, "one group a distance")
        check(group.find(SVG + "title").text == "distance %.15g" % distance, "title of a group")
        groups[distance] = [p.get("d") for p in group.findall(SVG + "path")]
    check(len(list(root.iter(SVG + "path"))) == sum(map(len, groups.values())), "all paths are in groups")
    return [float(x) for x in root.get("viewBox").split()], float(outer.get("stroke-width")), groups


def check_picture(bench, path, level, distance):
    """What librsvg paints: dark on the level and nowhere else. `distance` takes user units."""
    if shutil.which("rsvg-convert") is None:
        skip("librsvg2-bin")
    (left, top, width, height), stroke, _ = read_svg(path)
    size = 500
    png = bench.path("out.png")
    subprocess.run(["rsvg-convert", "-w", str(size), "-b", "white", "-f", "png", "-o", png, path], check=True, timeout=120)
    picture = Picture(vtk_readers("vtkIOImage.vtkPNGReader"), png)
    check(picture.width == size and abs(picture.height - size * height / width) <= 1, "size of the picture")
    pixel = width / size
    dark = 0
    for j in range(picture.height):
        for i in range(size):
            grey = picture.rgb(i, j)[0]
            off = abs(distance((left + (i + 0.5) * pixel, top + (j + 0.5) * pixel)) - level)
            dark += grey < 128
            if grey < 250:
                check(off <= stroke / 2 + pixel, "a dark pixel away from the curve")
            elif off <= stroke / 2 - 0.75 * pixel or off < 1e-9:
                check(False, "a white pixel on the curve")
            if off <= 0.1 * pixel:
                check(grey < 192, "a light pixel on the curve")
    check(dark > 1000, "%d dark pixels" % dark)


def test_svg(bench):
    Arc, Line, Move, Path = readers("python3-svgelements", *("svgelements." + name for name in ("Arc", "Line", "Move", "Path")))
    out = bench.path("out.svg")
    levels = ("--distance", 0.3, "--distance", 2.5, "--distance", 7)
    for name, plane, is_turned in (("horizontal", HORIZONTAL, False), ("looking down", HORIZONTAL, True),
                                   ("tilted", TILTED, False), ("upright", Plane((1, 2, 3), (1, 0, 0), (0, 0, 1)), False)):
        mesh = bench.grid(plane, is_turned)
        for source, distance, arcs, lines in ((bench.segment(plane), lambda p: from_segment(p)[0], 4, 2),
                                              (bench.center(plane), from_center, 3, 0)):
            stats = bench.run(mesh, *source, *levels, "--output", out)
            check_levels(stats, [0.3, 2.5, 7])
            (left, top, width, height), stroke, groups = read_svg(out)
            check(sorted(groups) == [0.3, 2.5, 7], name + ": groups")
            for level in stats["curves"]:
                d = level["distance"]
                texts = groups[d]
                check(len(texts) == level["number"], name + ": number of paths")
                check(sum(t.endswith("Z") for t in texts) == level["closed"], name + ": closed paths")
                paths = [Path(t) for t in texts]
                length = sum(p.length(error=1e-13) for p in paths)
                check_close(length, level["length"], 1e-9 * length, name + ": length")
                for path in paths:
                    x0, y0, x1, y1 = path.bbox()
                    check(left < x0 - stroke and top < y0 - stroke and x1 + stroke < left + width
                          and y1 + stroke < top + height, name + ": inside the view")
                    if d < 7:
                        kinds = [type(s) for s in path]
                        check((kinds.count(Arc), kinds.count(Line)) == (arcs, lines), name + ": arcs and lines %s" % kinds)
                        check(abs(path[-1].end - path[0].end) == 0, name + ": returns to its start")
                    for piece in path:
                        if isinstance(piece, Move):
                            continue
                        for part in (0.2, 0.5, 1):
                            p = piece.point(part)
                            if name in ("horizontal", "looking down"):
                                check_close(distance((p.x, -p.y)), d, 1e-9, name + ": a point")
                            elif name == "upright":  # seen from outside: along the y axis, z up
                                check_close(distance((p.x - 1, -p.y - 3)), d, 1e-9, name + ": a point")
            check(len(groups[7]) > 1 and not any(t.endswith("Z") for t in groups[7]), name + ": open paths")
            if name == "tilted":
                check_close(width, max(Path(t).bbox()[2] for t in sum(groups.values(), []))
                            - min(Path(t).bbox()[0] for t in sum(groups.values(), [])),
                            0.1 * width, name + ": width of the view")

    mesh = bench.grid(HORIZONTAL)
    bench.run(mesh, *bench.segment(HORIZONTAL), "--distance", 2, "--output", out)
    check_picture(bench, out, 2, lambda p: from_segment((p[0], -p[1]))[0])
    bench.run(mesh, *bench.center(HORIZONTAL), "--distance", 4, "--output", out)
    check_picture(bench, out, 4, lambda p: from_center((p[0], -p[1])))

    # around the border of a plate: the part on the other side keeps its position, and turns in the other direction
    bench.run(bench.plate(HORIZONTAL), "--source-point", "%g,%g,0.3" % E, "--distance", 3, "--output", out)
    (text,) = read_svg(out)[2][3]
    path, sides = Path(text), [set(), set()]
    check(text.endswith("Z"), "closed round the border")
    check_close(path.length(error=1e-13), 6 * math.pi, 1e-8, "length round the border")
    for arc in (piece for piece in path if isinstance(piece, Arc)):
        p = arc.point(0.5)
        above, below = from_plate_center((p.x, -p.y))
        check_close(min(abs(above - 3), abs(below - 3)), 0, 1e-9, "a point on one of both sides")
        sides[abs(above - 3) > abs(below - 3)].add(arc.sweep > 0)
    check(len(sides[0]) == len(sides[1]) == 1 and sides[0] != sides[1], "arcs on both sides turn in different ways")

    # curves on the horizontal half of a non-planar mesh
    bench.run(bench.ridge(), "--source-point", "3,6,0", "--distance", 1.5, "--output", out)
    check_close(sum(Path(t).length(error=1e-13) for t in read_svg(out)[2][1.5]), 3 * math.pi, 1e-8, "on the horizontal half")

    bench.run(mesh, *bench.center(HORIZONTAL), "--distance", 100, "--output", out, warning="no offset at distance 100")
    check(read_svg(out)[2] == {}, "no curves")


if __name__ == "__main__":
    run_test(svg=test_svg)
