# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sides, closing and place on the surface of the polylines of the program, against closed forms."""

import math

from program_bench import HORIZONTAL, chain_length, check, check_close, polyline_text, read_polylines, run_test, write_grid, write_off


def rectangle(a, b, c, d, z=0.3):
    return [(a, b, z), (c, b, z), (c, d, z), (a, d, z), (a, b, z)]


def write_curves(bench, name, *curves):
    return bench.write(name, "".join(map(polyline_text, curves)))


def test_pocket(bench):
    mesh = bench.grid(HORIZONTAL)  # a square of side 12
    for is_reversed in (False, True):
        points = rectangle(1, 1, 11, 10)[::-1 if is_reversed else 1]
        pocket = write_curves(bench, "pocket.polylines.txt", points)
        side, other = ("right", "left") if is_reversed else ("left", "right")
        stats = bench.run(mesh, "--source-polyline", pocket, "--distance", 0.5, "--side", "inside")
        check_close(stats["curves"][0]["length"], 38 - 8 * 0.5, 1e-9, "the pocket has no border, although it is larger")
        check([(i["source"], i["inside"]) for i in stats["insides"]] == [(0, side)], "insides: %s" % stats["insides"])
        check_close(stats["insides"][0]["area"], 90, 1e-9, "area inside")
        check_close(stats["insides"][0]["outer_area"], 54, 1e-9, "area outside")
        same = bench.run(mesh, "--source-polyline", pocket + ":" + side, "--distance", 0.5)
        check_close(same["curves"][0]["length"], 34, 1e-9, "a side of a file")
        check("insides" not in same, "no inside is needed")
        outside = bench.run(mesh, "--source-polyline", pocket + ":" + other, "--distance", 0.5, "--side", "inside")
        check_close(outside["curves"][0]["length"], 38 + math.pi, 1e-9, "the side of a file precedes --side")
        output = bench.start(mesh, "--source-polyline", pocket, "--distance", 0.5, "--side", "inside").stdout
        check("line 1: inside = %s, the side without border" % side in output, output)
    # a pocket with islands in one run, and points, which have no side
    islands = write_curves(bench, "islands.polylines.txt", rectangle(3, 3, 4, 4), rectangle(7, 6, 8, 8)[::-1])
    stats = bench.run(mesh, "--source-polyline", pocket + ":inside", "--source-polyline", islands + ":outside",
                      "--source-vertex", 0, "--distance", 0.25)
    check_close(stats["curves"][0]["length"], 38 - 2 + 4 + 6 + math.pi + math.pi / 8, 1e-9, "a pocket with islands")
    check([i["inside"] for i in stats["insides"]] == ["right", "left", "right"], "insides: %s" % stats["insides"])
    # a file whose name ends like a side
    odd = write_curves(bench, "odd:left", rectangle(3, 3, 4, 4))
    check_close(bench.run(mesh, "--source-polyline", odd, "--distance", 0.25)["curves"][0]["length"], 2 + 4 + math.pi / 2, 1e-9,
                "a name with a colon")
    # the smaller area of a closed surface, with a warning if it is in doubt
    shell = bench.path("shell.off")
    write_shell(shell, 0.1)
    for e, warning in ((0.1, None), (0.05, "in doubt")):  # 96.04 of 204, 98.01 of 204
        near_rim = write_curves(bench, "rim.polylines.txt", rectangle(e, e, 10 - e, 10 - e, 0.1))
        stats = bench.run(shell, "--source-polyline", near_rim, "--distance", 0.01, "--side", "inside", warning=warning)
        check_close(stats["insides"][0]["area"], (10 - 2 * e) ** 2, 1e-9, "area inside")
        check_close(stats["curves"][0]["length"], 4 * (10 - 2 * e) - 8 * 0.01, 1e-9, "inside")


def test_holes(bench):
    """Border on both sides, or around the only side: the inner side is said to be in doubt."""
    holed = bench.path("holed.off")
    points = [(i, j, 0.3) for j in range(13) for i in range(13)]
    cells = [13 * j + i for j in range(12) for i in range(12) if (i, j) != (5, 5)]
    write_off(holed, points, [f for a in cells for f in ((a, a + 1, a + 14), (a, a + 14, a + 13))])
    pocket = write_curves(bench, "pocket.polylines.txt", rectangle(1, 1, 11, 10))
    stats = bench.run(holed, "--source-polyline", pocket, "--distance", 0.25, "--side", "inside",
                      warning="both sides have border of the surface")
    check_close(stats["insides"][0]["area"], 54, 1e-9, "the smaller area")
    hole = write_curves(bench, "hole.polylines.txt", rectangle(5, 5, 6, 6))
    bench.run(holed, "--source-polyline", hole, "--distance", 0.25, "--side", "inside", warning="there is another one on its only side")
    outline = write_curves(bench, "outline.polylines.txt", rectangle(0, 0, 12, 12))
    stats = bench.run(bench.grid(HORIZONTAL), "--source-polyline", outline, "--distance", 0.25, "--side", "inside")
    check_close(stats["curves"][0]["length"], 46, 1e-9, "along the only border")


def test_digits(bench):
    """Curves through vertices of the mesh, written with some digits: one closed curve on each side, all of the length of both."""
    mesh = bench.path("grid.off")
    for embed in (HORIZONTAL.space, lambda p: (p[0], p[1], 0.3 * math.sin(p[0]) * math.cos(0.7 * p[1]))):
        write_grid(mesh, embed)
        with open(mesh) as file:
            points = [line.split() for line in file.read().splitlines()[2:171]]
        ring = [(i, 2) for i in range(2, 10)] + [(10, j) for j in range(2, 10)]
        ring += [(12 - i, 12 - j) for i, j in ring]
        for digits in range(7, 15):
            curve = bench.path("ring.polylines.txt")
            with open(curve, "w") as out:
                rounded = ["%.*g" % (digits, float(x)) for i, j in ring + ring[:1] for x in points[13 * j + i]]
                out.write("%d %s\n" % (len(ring) + 1, " ".join(rounded)))
            lengths = {}
            for side in ("inside", "outside", "both"):
                curves = bench.run(mesh, "--source-polyline", curve, "--distance", 0.25, "--side", side)["curves"][0]
                number = 2 if side == "both" else 1
                check(curves["number"] == curves["closed"] == number, "%d digits, %s: %s" % (digits, side, curves))
                lengths[side] = curves["length"]
            check_close(lengths["inside"] + lengths["outside"], lengths["both"], 1e-5, "both sides")


def test_ends(bench):
    mesh = bench.grid(HORIZONTAL)
    curve = write_curves(bench, "open.polylines.txt", [(3, 5, 0.3), (8, 5, 0.3)])
    lengths = {"both": 10 + 2 * math.pi, "left": 5, "right": 5}
    for side, length in lengths.items():
        check_close(bench.run(mesh, "--source-polyline", curve, "--distance", 1, "--side", side)["curves"][0]["length"], length,
                    1e-9, "default end, " + side)
        stats = bench.run(mesh, "--source-polyline", curve + ":" + side, "--distance", 1, "--end", "round")
        check_close(stats["curves"][0]["length"], length + (0 if side == "both" else 2 * math.pi), 1e-9, "round, " + side)


def test_closing(bench):
    """The table of the manual, and --close-gap."""
    mesh = bench.grid(HORIZONTAL)
    for points, length, area in ((rectangle(1, 1, 9, 6)[:4], 26, 40), (rectangle(1, 1, 9, 6)[:3], 13 + math.sqrt(89), 20)):
        curve = write_curves(bench, "curve.polylines.txt", points)
        arguments = mesh, "--source-polyline", curve, "--distance", 0.25
        stats = bench.run(*arguments, "--side", "inside", "--close-gap", 10)
        check_close(stats["insides"][0]["area"], area, 1e-9, "closed by a segment")
        stats = bench.run(*arguments, "--side", "outside", "--close-gap", 10)
        check_close(stats["curves"][0]["length"], length + 0.5 * math.pi, 1e-9, "outside")
        check("closed by a segment of length" in bench.start(*arguments, "--close-gap", 10).stdout, "closed by a segment")
        check("insides" not in bench.run(*arguments, "--close-gap", 4.9), "open")
    is_closed = {0: True, 1e-16: True, 1e-12: True, 1e-10: True, 0.99e-9: True, 1.01e-9: False, 1e-6: False, 0.99e-4: False,
                 1.01e-4: False, 1e-3: False}
    for part, closed in is_closed.items():
        points = rectangle(3, 2, 9, 6)  # 20 is its length
        points[4] = (3, 2 + 20 * part, 0.3)
        curve = write_curves(bench, "curve.polylines.txt", points)
        result = bench.start(mesh, "--source-polyline", curve, "--distance", 0.25, "--side", "inside")
        gap = points[4][1] - 2
        check((result.returncode == 0) == closed, "gap %g: %s" % (part, result.stderr))
        check(("line 1: closed, its ends are" in result.stdout) == (closed and gap > 0), "gap %g: %s" % (part, result.stdout))
        result = bench.start(mesh, "--source-polyline", curve, "--distance", 0.25)
        warns = 1e-9 < part < 1e-4
        check(result.returncode == 0 and ("open, although its ends are only" in result.stderr) == warns, result.stderr)
        if warns:
            remedy = result.stderr.split("; ")[1].split()[:2]
            stats = bench.run(mesh, "--source-polyline", curve, "--distance", 0.25, "--side", "inside", *remedy)
            check_close(stats["curves"][0]["length"], 20 - 2, 1e-9, "closed by " + " ".join(remedy))


def write_shell(path, thickness, n=5):
    """A square of side 10 with this thickness."""
    points, faces = [], []
    for z in (0, thickness):
        points += [(10 * i / n, 10 * j / n, z) for i in range(n + 1) for j in range(n + 1)]
    layer = (n + 1) ** 2
    for i in range(n):
        for j in range(n):
            a, b, c, d = (k * (n + 1) + m for k, m in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
            faces += [(a, c, b), (a, d, c), (a + layer, b + layer, c + layer), (a + layer, c + layer, d + layer)]
    rim = [(i, 0) for i in range(n)] + [(n, j) for j in range(n)] + [(n - i, n) for i in range(n)] + [(0, n - j) for j in range(n)]
    rim = [i * (n + 1) + j for i, j in rim]
    for a, b in zip(rim, rim[1:] + rim[:1]):
        faces += [(a, b, b + layer), (a, b + layer, a + layer)]
    write_off(path, points, faces)


def test_chains(bench):
    """Borders and edges among the sources are written as polylines, divided where other than two of the edges meet."""
    placed = bench.path("placed.polylines.txt")

    def written(mesh, *sources):
        bench.run(mesh, *sources, "--source-output", placed)
        curves = read_polylines(placed)
        return sorted((len(c), c[0] == c[-1], round(chain_length(c), 9)) for c in curves)

    check(written(bench.grid(HORIZONTAL), "--source-boundary") == [(49, True, 48)], "one border")
    box = bench.path("box.off")
    write_off(box, [(i % 2, i // 2 % 2, i // 4) for i in range(8)],
              [(a, b, c) for q in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
               for a, b, c in ((q[0], q[1], q[2]), (q[0], q[2], q[3]))])
    check(written(box, "--source-sharp-edges", 60) == 12 * [(2, False, 1)], "the edges of a cube")
    check(written(box, "--source-sharp-edges", 60, "--sharp-edges-near", "0.5,0,0") == [(2, False, 1)], "one of them")
    # a sheet with one bend
    write_off(box, [(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 1, 0), (1, 1, 0), (2, 1, 0), (0, 0, 1), (1, 0, 1), (2, 0, 1)],
              [(0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4), (1, 0, 6), (1, 6, 7), (2, 1, 7), (2, 7, 8)])
    check(written(box, "--source-sharp-edges", 60, "--source-boundary") == [(3, False, 2), (9, True, 8)], "a bent sheet")


def test_skins(bench):
    shell, placed = bench.path("shell.off"), bench.path("placed.polylines.txt")
    write_shell(shell, 0.1)
    curve = write_curves(bench, "middle.polylines.txt",
                         [(x, 5, 0.055 if i % 2 == 0 else 0.045) for i, x in enumerate((2, 4, 5, 6, 8))])
    arguments = shell, "--source-polyline", curve, "--distance", 0.5, "--source-output", placed
    bench.run(*arguments, warning="from point 1 at 4,5,0.045 to the next one the path on the surface has length")
    check(chain_length(read_polylines(placed)[0]) > 20, "the curve goes around the rim")
    for direction in ("0,0,1", "0,0,-1", "0.001,0.002,1"):
        stats = bench.run(*arguments, "--project", direction)
        check_close(stats["curves"][0]["length"], 12 + math.pi, 1e-3, "in a thin shell, along " + direction)
        check(len({p[2] for p in read_polylines(placed)[0]}) == 1, "points on both skins")
    # near the rim, where the ways around it are short
    near_rim = write_curves(bench, "near_rim.polylines.txt",
                            [(x, 0.5, 0.055 if x % 2 == 0 else 0.045) for x in range(2, 9)])
    bench.run(shell, "--source-polyline", near_rim, "--distance", 0.05, warning="to the next one the path on the surface has length")
    # one skin for each polyline, the nearer one
    both = write_curves(bench, "both.polylines.txt", [(2, 3, 0.2), (8, 3, 0.2)], [(2, 7, -0.2), (8, 7, -0.2)])
    bench.run(shell, "--source-polyline", both, "--distance", 0.5, "--source-output", placed, "--project", "0,0,1")
    check([{p[2] for p in c} for c in read_polylines(placed)] == [{0.1}, {0}], "the nearer skin")

    # between the walls of a groove: points go to both, and the curve crosses the bottom again and again
    groove = bench.path("groove.off")
    write_off(groove, [(-5, 0, 5), (-5, 9, 5), (0, 0, 0), (0, 9, 0), (5, 0, 5), (5, 9, 5)],
              [(0, 2, 3), (0, 3, 1), (2, 4, 5), (2, 5, 3)])
    zigzag = write_curves(bench, "zigzag.polylines.txt", [(0.01 * (-1) ** i, 2 + i / 40, 0.06) for i in range(9)])
    bench.run(groove, "--source-polyline", zigzag, "--distance", 0.1, warning="so have 7 more")
    bench.run(groove, "--source-polyline", zigzag, "--distance", 0.1, "--project", "0,0,1")


if __name__ == "__main__":
    run_test(pocket=test_pocket, holes=test_holes, digits=test_digits, ends=test_ends, closing=test_closing, chains=test_chains, skins=test_skins)
