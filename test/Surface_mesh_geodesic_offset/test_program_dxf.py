# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Offsets in the format .dxf, as ezdxf reads them."""

import math

from program_bench import (E, HORIZONTAL, TILTED, chain_length, check, check_close, check_levels, from_center,
                           from_plate_center, from_segment, readers, ridge_unfolded, run_test, stadium)


def bulge_pieces(entity):
    """Start, end and bulge of the pieces of an LWPOLYLINE."""
    vertices = [(x, y, bulge) for x, y, _, _, bulge in entity.get_points()]
    following = vertices[1:] + (vertices[:1] if entity.closed else [])
    return [(v[:2], w[:2], v[2]) for v, w in zip(vertices, following)]


def bulge_length(start, end, bulge):
    chord = math.dist(start, end)
    if bulge == 0:
        return chord
    angle = 4 * math.atan(abs(bulge))
    return chord / (2 * math.sin(angle / 2)) * angle


def bulge_point(start, end, bulge, part):
    """The point at parameter `part`: the arc turns by 4 atan(bulge), half of it before the chord's direction."""
    if bulge == 0:
        return start[0] + part * (end[0] - start[0]), start[1] + part * (end[1] - start[1])
    angle = 4 * math.atan(bulge)
    x, y = end[0] - start[0], end[1] - start[1]
    factor = math.sin(part * angle / 2) / math.sin(angle / 2)
    turn = (part - 1) * angle / 2
    return (start[0] + factor * (x * math.cos(turn) - y * math.sin(turn)),
            start[1] + factor * (x * math.sin(turn) + y * math.cos(turn)))


def read_dxf(readfile, path):
    document = readfile(path)
    auditor = document.audit()
    check(not auditor.has_errors and not auditor.has_fixes,
          "audit: %s" % [e.message for e in auditor.errors + auditor.fixes])
    check(document.dxfversion == "AC1015", "version " + document.dxfversion)
    entities = list(document.modelspace())
    layers = {layer.dxf.name for layer in document.layers} - {"0", "Defpoints", "DEFPOINTS"}
    check(layers == {e.dxf.layer for e in entities}, "layers %s" % layers)
    return entities


def vertices_3d(entity):
    points = [tuple(v.dxf.location) for v in entity.vertices]
    return points + points[:1] if entity.is_closed else points


def test_dxf(bench):
    readfile = readers("python3-ezdxf", "ezdxf.readfile")
    out = bench.path("out.dxf")

    # in a horizontal plane: each curve is one polyline with true arcs, independent of the orientation of the faces
    for is_turned in (False, True):
        mesh = bench.grid(HORIZONTAL, is_turned)
        for source, distance, exact, vertices in (
                (bench.segment(HORIZONTAL), lambda p: from_segment(p)[0], stadium, 4),
                (bench.center(HORIZONTAL), from_center, lambda d: 2 * math.pi * d, 2)):
            stats = bench.run(mesh, *source, "--distance", 0.3, "--distance", 2.5, "--output", out)
            check_levels(stats, [0.3, 2.5])
            entities = read_dxf(readfile, out)
            check([e.dxftype() for e in entities] == ["LWPOLYLINE"] * 2, "one polyline a curve")
            check([e.dxf.layer for e in entities] == ["offset_0.3", "offset_2.5"], "names of layers")
            for entity, level in zip(entities, stats["curves"]):
                d = level["distance"]
                pieces = bulge_pieces(entity)
                check(entity.closed and entity.dxf.elevation == 0.3, "closed, at the height of the plane")
                check(len(pieces) == vertices, "%d pieces, not one for each arc and segment" % len(pieces))
                length = sum(bulge_length(*piece) for piece in pieces)
                check_close(length, exact(d), 1e-9 * length, "length of a polyline")
                check_close(length, level["length"], 1e-9 * length, "length of a polyline, from the statistics")
                for piece in pieces:
                    check(piece[2] == 0 or (piece[2] < 0) == is_turned, "direction of an arc")
                    for part in (0, 0.1, 0.5, 0.7):
                        check_close(distance(bulge_point(*piece, part)), d, 1e-9, "a point of a polyline")

    # curves that end on the border of the mesh are open
    mesh = bench.grid(HORIZONTAL)
    stats = bench.run(mesh, *bench.center(HORIZONTAL), "--distance", 7, "--output", out)
    entities = read_dxf(readfile, out)
    check(len(entities) == stats["curves"][0]["number"] == 4, "%d open curves" % len(entities))
    check(not any(e.closed for e in entities), "open curves")
    length = sum(bulge_length(*piece) for e in entities for piece in bulge_pieces(e))
    check_close(length, stats["curves"][0]["length"], 1e-9 * length, "length of open curves")

    # in a tilted plane: polylines in space
    stats = bench.run(bench.grid(TILTED), *bench.segment(TILTED), "--distance", 1.5, "--distance", 5.5,
                      "--tolerance", 1e-4, "--output", out)
    entities = read_dxf(readfile, out)
    check(len(entities) == sum(level["number"] for level in stats["curves"]) and len(entities) > 1, "number of curves")
    for entity in entities:
        check(entity.dxftype() == "POLYLINE" and entity.is_3d_polyline, "polylines in space")
    for level in stats["curves"]:
        d = level["distance"]
        some = [e for e in entities if e.dxf.layer == "offset_%.15g" % d]
        check(len(some) == level["number"] and sum(e.is_closed for e in some) == level["closed"], "closed curves")
        length = sum(chain_length(vertices_3d(e)) for e in some)
        check(level["length"] * (1 - 1e-4 / d) <= length <= level["length"] * (1 + 1e-12), "length in space")
        for p in (p for e in some for p in vertices_3d(e)):
            check_close(from_segment(TILTED.plane(p))[0], d, 1e-9, "a point in space")
    check({e.is_closed for e in entities} == {True, False}, "closed and open curves")

    # over a ridge: an arc in the horizontal half, a polyline in space in the other, end to end
    d = 3.0
    stats = bench.run(bench.ridge(), "--source-point", "4.5,6.2,0", "--distance", d, "--tolerance", 1e-5, "--output", out)
    check(stats["curves"][0]["number"] == stats["curves"][0]["closed"] == 1, "one closed curve over the ridge")
    check_close(stats["curves"][0]["length"], 2 * math.pi * d, 1e-9, "length over the ridge")
    entities = read_dxf(readfile, out)
    check(sorted(e.dxftype() for e in entities) == ["LWPOLYLINE", "POLYLINE"], "two parts over the ridge")
    flat = [e for e in entities if e.dxftype() == "LWPOLYLINE"][0]
    steep = [e for e in entities if e.dxftype() == "POLYLINE"][0]
    check(not flat.closed and not steep.is_closed and flat.dxf.elevation == 0, "open parts at height 0")
    pieces = bulge_pieces(flat)
    check_close(sum(bulge_length(*p) for p in pieces), d * (2 * math.pi - 2 * math.acos(0.5)), 1e-9, "the horizontal arc")
    points = vertices_3d(steep)
    ends = {(*pieces[0][0], 0.0), (*pieces[-1][1], 0.0)}
    check({points[0], points[-1]} == ends and len(ends) == 2, "parts end at the same points")
    check_close(chain_length(points), d * 2 * math.acos(0.5), 1e-4, "the other part")
    for p in points:
        check_close(math.dist(ridge_unfolded(p), (4.5, 6.2)), d, 1e-9, "a point beyond the ridge")
        check_close(p[2], -0.75 * (p[0] - 6), 1e-12, "a point of the slope")

    # straight over the ridge: no split
    bench.run(bench.path("ridge.off"), "--source-plane", "0,1,0,-6", "--distance", 1.7, "--output", out)
    entities = read_dxf(readfile, out)
    check([e.dxftype() for e in entities] == ["POLYLINE"] * 2, "straight curves in one part: %s" % entities)

    # around the border of a plate: its two sides face up and down at the same height
    stats = bench.run(bench.plate(HORIZONTAL), "--source-point", "%g,%g,0.3" % E, "--distance", 3, "--output", out)
    entities = read_dxf(readfile, out)
    check([e.dxftype() for e in entities] == ["LWPOLYLINE"] and entities[0].closed, "one polyline on both sides")
    pieces = bulge_pieces(entities[0])
    check_close(sum(bulge_length(*p) for p in pieces), 6 * math.pi, 1e-8, "length on both sides")
    check_close(stats["curves"][0]["length"], 6 * math.pi, 1e-8, "length on both sides, from the statistics")
    sides = [set(), set()]
    for piece in pieces:
        above, below = from_plate_center(bulge_point(*piece, 0.5))
        check_close(min(abs(above - 3), abs(below - 3)), 0, 1e-9, "a point on one of both sides")
        sides[abs(above - 3) > abs(below - 3)].add(piece[2] > 0)
    check(len(sides[0]) == len(sides[1]) == 1 and sides[0] != sides[1], "arcs on both sides turn in different ways")

    bench.run(mesh, "--source-vertex", 0, "--distance", 100, "--output", out, warning="no offset at distance 100")
    check(read_dxf(readfile, out) == [], "no curves")


if __name__ == "__main__":
    run_test(dxf=test_dxf)
