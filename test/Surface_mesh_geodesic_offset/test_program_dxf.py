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

    # in a tilted plane: true arcs, in the axes of the format for the normal of the plane
    stats = bench.run(bench.grid(TILTED), *bench.segment(TILTED), "--distance", 1.5, "--distance", 5.5, "--output", out)
    entities = read_dxf(readfile, out)
    check(len(entities) == sum(level["number"] for level in stats["curves"]) and len(entities) > 1, "number of curves")
    check({e.dxftype() for e in entities} == {"LWPOLYLINE"}, "polylines in a tilted plane")
    for level in stats["curves"]:
        d = level["distance"]
        some = [e for e in entities if e.dxf.layer == "offset_%.15g" % d]
        check(len(some) == level["number"] and sum(e.closed for e in some) == level["closed"], "closed curves")
        length = sum(bulge_length(*piece) for e in some for piece in bulge_pieces(e))
        check_close(length, level["length"], 1e-9 * length, "length in a tilted plane")
        check(len(bulge_pieces(some[0])) == 4 or d == 5.5, "a stadium has four parts")
        for entity in some:
            axes = entity.ocs()
            for piece in bulge_pieces(entity):
                for part in (0, 0.3, 0.5, 1):
                    p = tuple(axes.to_wcs((*bulge_point(*piece, part), entity.dxf.elevation)))
                    check_close(math.dist(p, TILTED.space(TILTED.plane(p))), 0, 1e-9, "a point in the tilted plane")
                    check_close(from_segment(TILTED.plane(p))[0], d, 1e-9, "a point of a polyline in the tilted plane")
    check({e.closed for e in entities} == {True, False}, "closed and open curves")

    # over a ridge: one polyline in space
    d = 3.0
    stats = bench.run(bench.ridge(), "--source-point", "4.5,6.2,0", "--distance", d, "--tolerance", 1e-5, "--output", out)
    check(stats["curves"][0]["number"] == stats["curves"][0]["closed"] == 1, "one closed curve over the ridge")
    check_close(stats["curves"][0]["length"], 2 * math.pi * d, 1e-9, "length over the ridge")
    entities = read_dxf(readfile, out)
    check([e.dxftype() for e in entities] == ["POLYLINE"], "one entity over the ridge")
    check(entities[0].is_3d_polyline and entities[0].is_closed, "a closed polyline in space")
    points = vertices_3d(entities[0])
    check_close(chain_length(points), 2 * math.pi * d, 1e-4, "length in space")
    for p in points:
        check_close(math.dist(ridge_unfolded(p), (4.5, 6.2)), d, 1e-9, "a point on the ridge's sides")
        check_close(p[2], min(0, -0.75 * (p[0] - 6)), 1e-12, "a point of a side")
    check(min(p[2] for p in points) < -0.1, "points of both sides")

    # a family on a part with some horizontal faces: one entity per curve
    stats = bench.run(bench.path("ridge.off"), "--source-point", "4.5,6.2,0", *(w for k in range(1, 12) for w in ("--distance", k / 2)),
                      "--output", out)
    entities = read_dxf(readfile, out)
    check(len(entities) == sum(level["number"] for level in stats["curves"]), "one entity per curve: %d" % len(entities))
    check({e.dxftype() for e in entities} == {"LWPOLYLINE", "POLYLINE"}, "horizontal and other curves")
    check(sum(e.closed if e.dxftype() == "LWPOLYLINE" else e.is_closed for e in entities)
          == sum(level["closed"] for level in stats["curves"]), "closed curves")

    # straight over the ridge: polylines in space
    bench.run(bench.path("ridge.off"), "--source-plane", "0,1,0,-6", "--distance", 1.7, "--output", out)
    entities = read_dxf(readfile, out)
    check([e.dxftype() for e in entities] == ["POLYLINE"] * 2, "straight curves: %s" % entities)

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
