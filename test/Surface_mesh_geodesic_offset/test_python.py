# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python module: against closed forms and files of the program; exceptions, threads, memory, interrupts, and the examples.

    test_python.py MODULE PART [PROGRAM]
"""

import gc
import itertools
import math
import os
import re
import runpy
import signal
import sys
import threading
import time

import program_bench
from program_bench import A, B, C, E, LENGTH, TILTED, check, check_close, polyline_text, run_test, skip, stadium

try:
    import numpy as np
except ImportError:
    print("skipped: python3-numpy is not installed")
    sys.exit(77)
sys.path.insert(0, os.path.dirname(os.path.abspath(sys.argv[1])))
import geodesic_offset  # noqa: E402, with the folder of the first argument

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
INSIDE = np.random.default_rng(11).uniform(1, 11, (200, 2))  # points of the plane of the grid


def read_off(path):
    with open(path) as file:
        words = file.read().split()
    n, m = int(words[1]), int(words[2])
    points = np.array(words[4:4 + 3 * n], dtype=float).reshape(n, 3)
    return points, np.array(words[4 + 3 * n:], dtype=int).reshape(m, 4)[:, 1:]


def grid(bench, plane=TILTED):
    """The mesh, and the coordinates of its vertices in the plane."""
    points, faces = read_off(bench.grid(plane))
    return geodesic_offset.Mesh(points, faces), np.array([plane.plane(p) for p in points])


def torus(n, m=None):
    """A grid on a torus, of n times m vertices, made by NumPy for its size."""
    m = m or n
    i, j = (a.ravel() for a in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    a, b = 2 * np.pi * i / n, 2 * np.pi * j / m
    points = np.column_stack([(1 + 0.4 * np.cos(b)) * np.cos(a), (1 + 0.4 * np.cos(b)) * np.sin(a), 0.4 * np.sin(b)])
    p, q, r, s = i * m + j, (i + 1) % n * m + j, (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m
    return points, np.vstack([np.column_stack([p, q, r]), np.column_stack([p, r, s])])


def check_all(actual, expected, tolerance, text):
    actual, expected = np.asarray(actual), np.asarray(expected)
    if check(actual.shape == expected.shape, "%s: shape %s, not %s" % (text, actual.shape, expected.shape)):
        with np.errstate(invalid="ignore"):
            difference = np.where(actual == expected, 0, np.abs(actual - expected))
        check(difference.max(initial=0) <= tolerance, "%s: difference %g" % (text, difference.max(initial=0)))


def in_space(points):
    return np.array([TILTED.space(p) for p in points])


def test_distances(bench):
    mesh, plane = grid(bench)
    check(mesh.number_of_vertices == 169 and mesh.number_of_faces == 288, "size of the mesh")
    center, line = np.array(TILTED.space(C)), in_space([A, B])
    from_center = np.hypot(*(plane - C).T)
    from_line = np.array([program_bench.from_segment(p)[0] for p in plane])
    check_all(mesh.distances(40), np.hypot(*(plane - plane[40]).T), 1e-13, "from a vertex")
    check_all(mesh.distances(center), from_center, 1e-13, "from a point")
    check_all(mesh.distances(mesh.locate(center)), from_center, 1e-13, "from a location")
    check_all(mesh.distances(line), from_line, 1e-13, "from a polyline")
    check_all(mesh.distances(mesh.locate_polyline(line)), from_line, 1e-13, "from a located polyline")
    check_all(mesh.distances([40, center, line]), np.minimum(np.minimum(from_center, from_line), mesh.distances(40)), 1e-13, "from all")
    check_all(mesh.distances([3, 40]), np.minimum(mesh.distances(3), mesh.distances(np.array([40]))), 1e-13, "from two vertices")
    far = np.array(TILTED.space(E))
    check_all(mesh.distances([center, far]), np.minimum(from_center, np.hypot(*(plane - E).T)), 1e-13, "from a list of points")
    check_all(mesh.distances(line.tolist()), from_line, 1e-13, "from a list of lists, a polyline")
    edge = np.array([[0, 1]])
    check_all(plane[:2, 1], [0, 0], 1e-14, "an edge of the border")
    beside = plane[:, 0] <= plane[1, 0]
    check_all(mesh.distances(edge)[beside], plane[beside, 1], 1e-13, "from an edge")
    started = geodesic_offset.Source_set(mesh)
    check(list(started.add_points([3, 40], start_value=0.5)) == [0, 1] and started.add_polyline(line) == 2 and len(started) == 3,
          "numbers of sources")
    check_all(mesh.distances(started), np.minimum(from_line, mesh.distances([3, 40]) + 0.5), 1e-13, "with start values")
    limited = mesh.distances(center, distance_limit=3)
    check_all(limited, np.where(from_center <= 3, from_center, np.inf), 1e-13, "with a limit")
    near = mesh.distances(center, relative_tolerance=1e-3)
    check(np.all(near <= from_center + 1e-13) and np.all(near >= (1 - 1e-3) * from_center), "with a tolerance")
    bounds = mesh.distance_bounds(center)
    check(np.all(bounds[:, 0] <= from_center + 1e-13) and np.all(bounds[:, 1] >= from_center - 1e-13), "certified bounds")
    check(np.all(bounds[:, 1] - bounds[:, 0] < 1e-11), "width of bounds")

    # a surface without points: the flat torus
    n = 12
    _, faces = torus(n)
    corners = np.array([[f // n, f % n] for f in faces.ravel()]).reshape(-1, 3, 2)
    sides = (np.roll(corners, -1, axis=1) - corners + n // 2) % n - n // 2
    flat = geodesic_offset.Mesh(faces=faces, edge_lengths=np.hypot(sides[..., 0], sides[..., 1]) / n)
    i, j = np.divmod(np.arange(n * n), n)
    check_all(flat.distances(0), np.hypot(np.minimum(i, n - i), np.minimum(j, n - j)) / n, 1e-13, "flat torus")


def test_fields(bench):
    mesh, plane = grid(bench)
    line, targets = in_space([A, B]), in_space(INSIDE)
    field = mesh.field([line, 0], keep_windows=True)
    check_all(field.distances(), mesh.distances([line, 0]), 1e-13, "distances")
    to_vertex = np.hypot(*(INSIDE - plane[0]).T)
    to_line, sides = map(np.array, zip(*(program_bench.from_segment(p) for p in INSIDE)))
    expected = np.minimum(to_vertex, to_line)
    locations = mesh.locate(targets)
    corners = mesh.points[read_off(bench.path("grid.off"))[1][locations[0]]]
    check_all(np.einsum("ij,ijk->ik", locations[1], corners), targets, 1e-13, "weights of corners")
    for given in (targets, locations):
        check_all(field.distance_to_sources(given), expected, 1e-13, "queries")
    check(isinstance(float(field.distance_to_sources(targets[0])), float), "one query")
    check_all(field.distance_to_sources(np.array([0, 1])), [0, field.distances()[1]], 0, "queries at vertices")
    is_line = to_line < to_vertex
    signed = field.signed_distance_to_sources(targets)
    for s, d, side, near in zip(signed, to_line, sides, is_line):
        if not near or side == 3:
            check(math.isnan(s), "no side: %g" % s)
        elif side:
            check_close(s, -d if side == 1 else d, 1e-13, "signed distance")
    numbers, (faces, weights) = field.nearest_source(targets)
    check_all(numbers, np.where(is_line, 0, 1), 0, "nearest source")
    check(faces.shape == (200,) and weights.shape == (200, 3), "nearest points")
    check_all(field.source_labels(), np.where(mesh.distances(0) < mesh.distances(line), 1, 0), 0, "labels")
    gradient, step = field.gradient(targets), 1e-6
    for k in range(200):
        path = field.shortest_path_points_to_sources(targets[k])
        check_close(program_bench.chain_length([tuple(p) for p in path]), expected[k], 1e-12, "length of a path")
        check_all(path[0], targets[k], 1e-12, "start of a path")
        check_all(gradient[k] * expected[k] + path[-1], targets[k], 1e-10, "gradient")
    locations = field.shortest_path_to_sources(targets[0])
    check(len(locations[0]) == len(field.shortest_path_points_to_sources(targets[0])) and locations[1].shape[1] == 3, "path as locations")
    (face, weights), distance = field.farthest_point()
    check(face >= 0 and distance == field.largest_distance() >= field.largest_vertex_distance(), "farthest point")
    check(field.covered_distance == math.inf and not field.is_cancelled and field.statistics["windows_created"] > 0, "properties")


def test_matrix(bench):
    points, faces = torus(30, 14)
    mesh = geodesic_offset.Mesh(points, faces)
    sources = np.arange(0, 420, 7)
    expected = np.array([mesh.distances(int(v)) for v in sources])
    for parallel in (False, True):
        check_all(mesh.distance_matrix(sources, parallel=parallel), expected, 1e-13, "matrix")
    square = expected[:, sources]
    check_all(square, square.T, 1e-12, "symmetry")
    check_all(mesh.distance_matrix(sources, sources, upper_half=True), np.where(np.tri(60, k=-1) > 0, np.inf, square), 1e-13, "half")
    check_all(mesh.distance_matrix(sources, distance_limit=0.7), np.where(expected <= 0.7, expected, np.inf), 1e-13, "limit")
    rows = [[0, 7], points[14], mesh.locate_polyline(points[[21, 22]])]
    check_all(mesh.distance_matrix(rows), [mesh.distances(s) for s in rows], 1e-13, "rows of any sources")
    centers = points[faces].mean(axis=1)[:20]
    to_centers = mesh.distance_matrix(sources[:3], mesh.locate(centers))
    check_all(to_centers, mesh.distance_matrix(centers, sources[:3]).T, 1e-12, "to locations, and back")
    check_close(mesh.distance(0, 28), expected[0, 28], 1e-13, "a pair")
    check(mesh.distance(0, 28, distance_limit=0.01) == math.inf, "a pair beyond a limit")

    selected = mesh.farthest_points(12, start_set=5)
    known = [5]
    for k, v in enumerate(selected.vertices):
        radius = mesh.distances(known)
        check_close(radius[v], radius.max(), 1e-12, "farthest vertex %d" % k)
        known.append(int(v))
    check_all(selected.distances, mesh.distances(known), 1e-12, "distances of samples")
    check_close(selected.covering_radius, selected.distances.max(), 0, "covering radius")
    check_all(np.array(mesh.distance_matrix(known))[selected.labels, np.arange(420)], selected.distances, 1e-12, "labels of samples")
    check(len(mesh.farthest_points(400, covering_radius=0.5).vertices) < 60, "radius that ends the selection")


def test_curves(bench):
    mesh, _ = grid(bench)
    line, center = in_space([A, B]), np.array(TILTED.space(C))
    curve, = mesh.offsets(center, 2)
    element, = curve.elements()
    check(curve.is_closed and curve.distance == 2 and curve.tolerance == 0, "properties of a circle")
    for value, expected in ((curve.length, 4 * math.pi), (element["radius"], 2), (element["sweep"], 2 * math.pi),
                            (element["length"], 4 * math.pi), (math.dist(element["center"], center), 0)):
        check_close(value, expected, 1e-11, "a circle")
    polyline = curve.points(chord_tolerance=1e-3)
    radii = np.linalg.norm(polyline - center, axis=1)
    check(radii.max() < 2 + 1e-11 and radii.min() > 2 - 1e-11 and (polyline[0] == polyline[-1]).all(), "points of a circle")
    middles = np.linalg.norm((polyline[1:] + polyline[:-1]) / 2 - center, axis=1)
    check(2 - 1e-3 - 1e-11 <= middles.min() < 2 - 1e-4, "chords of a circle: %g" % middles.min())
    faces, weights = curve.face_locations(1e-3)
    check(len(faces) == len(weights) > len(polyline), "locations of a circle")
    spaced = curve.points_at_spacing(0.5)
    check(len(spaced) == 27, "%d points at a spacing" % len(spaced))
    check_all(np.einsum("ij,ij->i", spaced["tangent"], spaced["point"] - center), np.zeros(27), 1e-9, "tangents")

    levels = [0.5, 1, 1.5]
    for curves in (mesh.offsets(line, levels), mesh.field(line, keep_windows=True).offset_curves(levels), mesh.field(line).offset_curves(levels),
                   mesh.offsets(line, geodesic_offset.Levels.equally_spaced(0.5, 3)), mesh.offsets(line, levels, parallel=True)):
        check([c.distance for c in curves] == levels, "distances of stadiums")
        for c in curves:
            check_close(c.length, stadium(c.distance), 1e-10, "length of a stadium")
            kinds = c.elements()
            check(len(kinds) == 4 and sorted(np.isnan(kinds["radius"])) == [False, False, True, True], "elements of a stadium")
    unlimited = mesh.offsets(line, geodesic_offset.Levels.equally_spaced(0.5))
    largest = mesh.field(line, compute_largest_distance=True).largest_distance()
    check({c.distance for c in unlimited} == {0.5 * k for k in range(1, int(largest / 0.5) + 1)}, "all levels")
    left, = mesh.offsets(line, 1, offset_side=geodesic_offset.Offset_side.LEFT)
    check_close(left.length, LENGTH, 1e-11, "one side")
    check(left.side == geodesic_offset.Source_side.LEFT and not left.is_closed, "a side")
    left, = mesh.offsets(line, 1, offset_side={0: geodesic_offset.Offset_side.LEFT}, end_style=geodesic_offset.Offset_end.ROUND)
    check_close(left.length, LENGTH + 2 * math.pi, 1e-11, "one side with round ends")


def test_diagrams(bench):
    mesh, plane = grid(bench)
    points = in_space([C, E])
    diagram = mesh.voronoi(mesh.locate(points))
    curve, = diagram.curves
    line = np.array([TILTED.plane(p) for p in curve.points(1e-3)])
    check_all(np.hypot(*(line - C).T), np.hypot(*(line - E).T), 1e-11, "a bisector")
    check({curve.source_on_left, curve.source_on_right} == {0, 1} and not curve.is_closed and curve.start_vertex is None, "its sources")
    nearest = np.where(np.hypot(*(INSIDE - C).T) < np.hypot(*(INSIDE - E).T), 0, 1)
    check_all(diagram.source_at(in_space(INSIDE)), nearest, 0, "cells")
    check(diagram.source_at_face().shape == (288,) and diagram.vertices.shape == (0, 3), "faces and vertices of a diagram")

    def area(split, chosen):
        a, b, c = (split.points[split.faces[chosen][:, k]] for k in range(3))
        return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2

    split = mesh.split(diagram)
    centers = np.array([TILTED.plane(p) for p in split.points[split.faces].mean(axis=1)])
    check_all(split.face_source, np.where(np.hypot(*(centers - C).T) < np.hypot(*(centers - E).T), 0, 1), 0, "cells of a split mesh")
    check(split.face_band is None and len(split.constrained_edges) > 5, "a split along a diagram")
    curves = mesh.offsets(points[0], [1, 2])
    split = mesh.split(curves, chord_tolerance=1e-6)
    check_close(area(split, split.face_band == 0), math.pi, 1e-4, "inner band")
    check_close(area(split, split.face_band == 1), 3 * math.pi, 1e-4, "next band")
    check_close(area(split, split.face_band >= 0), 144, 1e-10, "all bands")
    check((split.points[:169] == mesh.points).all() and mesh.number_of_faces == 288, "the mesh does not change")
    again = geodesic_offset.Mesh(split.points, split.faces)
    check_all(again.distances(split.constrained_edges)[:169], np.abs(np.hypot(*(plane - C).T)[:, None] - [1, 2]).min(axis=1), 1e-5, "from the edges on curves")
    along = mesh.split([mesh.locate_polyline(points)])
    ends = along.points[along.constrained_edges]
    check_close(np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).sum(), math.dist(C, E), 1e-11, "a split along a polyline")

    for given in ([curves[1]], [curves[1].points(1e-4)], [curves[1].face_locations(1e-4)]):
        certificate = mesh.certify(points[0], 2, given)
        check(certificate.bounds_region and certificate.tolerance < (1e-10 if given[0] is curves[1] else 2e-4), "a certified circle: %g" % certificate.tolerance)
    moved = mesh.certify(points[0], 2.25, [curves[1]])
    check_close(moved.tolerance, 0.25, 1e-9, "a circle of another distance")
    check(moved.limit == geodesic_offset.Offset_certificate_limit.CURVE_TOO_NEAR and moved.curve == 0 and moved.location[0] >= 0, "its limit")
    check(not mesh.certify(points[0], 1, [points]).bounds_region, "an open curve")


def test_files(bench):
    """The files of the program hold the same numbers."""
    bench.program = bench.options[0]
    path = bench.grid(TILTED)
    mesh, _ = grid(bench)
    line = bench.write("line.polylines.txt", polyline_text(in_space([A, B])))
    field, offsets = bench.path("field.csv"), bench.path("offsets.polylines.txt")
    bench.run(path, "--source-polyline", line, "--field", field)
    bench.run(path, "--source-polyline", line, "--distance", 1, "--distance", 2, "--tolerance", 1e-3, "--output", offsets)
    with open(field) as file:
        column = file.readline().strip().split(",").index("distance")
        expected = [float(row.split(",")[column]) for row in file]
    source = in_space([A, B])
    check_all(mesh.distances(source), expected, 0, "distances of a file")
    polylines = program_bench.read_polylines(offsets)
    curves = mesh.offsets(source, [1, 2])
    check(len(curves) == len(polylines) == 2, "polylines of a file")
    for curve, polyline in zip(curves, polylines):
        check_all(curve.points(1e-3), polyline, 1e-13, "a polyline of a file")


def expect(exception, words, function, *arguments, **options):
    try:
        function(*arguments, **options)
    except exception as error:
        check(words in str(error), "'%s' is not in: %s" % (words, error))
        return
    except BaseException as error:  # pylint: disable=broad-except
        check(False, "%s instead of %s: %s" % (type(error), exception, error))
        return
    check(False, "no exception with '%s'" % words)


def test_errors(bench):
    mesh, _ = grid(bench)
    points, faces = mesh.points, read_off(bench.path("grid.off"))[1]
    two = [[0, 1, 2], [0, 1, 3]]
    flat = geodesic_offset.Mesh(faces=[[0, 1, 2]], edge_lengths=[[1, 1, 1]])
    field, curve = mesh.field(0), mesh.offsets(0, 1)[0]
    for exception, words, function, arguments in (
            (TypeError, "either points or edge lengths", geodesic_offset.Mesh, (points,)),
            (TypeError, "integers", geodesic_offset.Mesh, (points, faces.astype(float))),
            (ValueError, "points are an array with three columns", geodesic_offset.Mesh, (points[:, :2], faces)),
            (ValueError, "faces are an array with three columns", geodesic_offset.Mesh, (points, faces[:, :2])),
            (ValueError, "face 0 has vertex 169, but there are 169", geodesic_offset.Mesh, (points, [[0, 1, 169]])),
            (ValueError, "face 0 has vertex -1", geodesic_offset.Mesh, (points, [[0, 1, -1]])),
            (ValueError, "face 1 has vertex 4 twice", geodesic_offset.Mesh, (points, [[0, 1, 30], [4, 40, 4]])),
            (ValueError, "face 1 and one before it both pass from vertex 0 to vertex 1", geodesic_offset.Mesh, (points[[0, 1, 30, 40]], two)),
            (ValueError, "Surface_mesh_geodesic_offset: ", geodesic_offset.Mesh, ([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]])),
            (ValueError, "Surface_mesh_geodesic_offset: ", geodesic_offset.Mesh, ([[0, 0, 0], [1, 0, 0], [2, math.nan, 0]], [[0, 1, 2]])),
            (ValueError, "Surface_mesh_geodesic_offset: ", geodesic_offset.Mesh, (None, [[0, 1, 2]], [[1, 1, 3]])),
            (ValueError, "a row per face", geodesic_offset.Mesh, (None, [[0, 1, 2]], [1, 1, 1])),
            (ValueError, "side 0 of face 1 has the length 2", geodesic_offset.Mesh, (None, [[0, 1, 2], [1, 0, 3]], [[1, 1, 1], [2, 1, 1]])),
            (ValueError, "Surface_mesh_geodesic_offset: ", mesh.distances, (169,)),
            (ValueError, "Surface_mesh_geodesic_offset: ", mesh.distances, (-1,)),
            (ValueError, "Surface_mesh_geodesic_offset: ", mesh.distances, (2**40,)),
            (ValueError, "Surface_mesh_geodesic_offset: ", mesh.distances, ((288, [1, 0, 0]),)),
            (ValueError, "Surface_mesh_geodesic_offset: ", mesh.distances, ((0, [-1, 0, 0]),)),
            (ValueError, "Surface_mesh_geodesic_offset: ", mesh.distances, (np.array([0, math.nan, 0]),)),
            (ValueError, "three weights", mesh.distances, ((0, [1, 0]),)),
            (ValueError, "no edge from vertex 0 to vertex 99", mesh.distances, ([[0, 99]],)),
            (ValueError, "vertices are integers", mesh.distances, (np.array([1.5, 2]),)),
            (TypeError, "locations are", mesh.distances, ("0",)),
            (ValueError, "Surface_mesh_geodesic_offset: ", mesh.distances, (0, -1.)),
            (ValueError, "has no face", geodesic_offset.Mesh(points, faces[:1]).distance, (168, 0)),
            (ValueError, "positive finite number", mesh.offsets, (0, 0)),
            (ValueError, "positive finite number", mesh.offsets, (0, [1, math.inf])),
            (ValueError, "positive finite number", geodesic_offset.Levels.equally_spaced, (-1,)),
            (TypeError, "levels are", mesh.offsets, (0, "1")),
            (ValueError, "Surface_mesh_geodesic_offset: ", mesh.offsets, (points[:2], 1, geodesic_offset.Offset_side.INSIDE)),
            (ValueError, "Surface_mesh_geodesic_offset: ", curve.points, (0,)),
            (ValueError, "Surface_mesh_geodesic_offset: ", curve.elements, (-1,)),
            (ValueError, "another mesh", flat.split, ([curve],)),
            (ValueError, "Surface_mesh_geodesic_offset: ", mesh.split, ([curve], 0)),
            (ValueError, "Surface_mesh_geodesic_enclosure: ", mesh.certify, (0, -1, [curve])),
            (RuntimeError, "keep_windows", field.distance_to_sources, (points[0] + 0.1,)),
            (RuntimeError, "Surface_mesh_geodesic_offset: ", field.largest_distance, ()),
            (RuntimeError, "Surface_mesh_geodesic_offset: ", field.voronoi_diagram, ()),
            (RuntimeError, "Surface_mesh_geodesic_offset: ", flat.locate, ([0, 0, 0.],)),
            (RuntimeError, "Surface_mesh_geodesic_offset: ", flat.distance_bounds, (0,)),
            (ValueError, "Surface_mesh_geodesic_offset: half of a matrix", lambda: mesh.distance_matrix([0], upper_half=True), ()),
            (ValueError, "with 1 rows and 169 columns", lambda: mesh.distance_matrix([0], out=np.empty((1, 168))), ()),
            (ValueError, "with 1 rows and 169 columns", lambda: mesh.distance_matrix([0], out=np.empty((1, 169), "f4")), ()),
            (ValueError, "with 1 rows and 169 columns", lambda: mesh.distance_matrix([0], out=np.empty((169, 2)).T[:1]), ()),
            (ValueError, "Surface_mesh_geodesic_offset: ", lambda: mesh.farthest_points(3, covering_radius=-1), ()),
            (KeyError, "from a visitor", lambda: mesh.distances(0, visitor=lambda fraction: {}["from a visitor"]), ())):
        expect(exception, words, function, *arguments)
    for name, member in itertools.chain.from_iterable(vars(c).items() for c in (geodesic_offset.Mesh, geodesic_offset.Field)):
        check(name.startswith("__") or len(member.__doc__) > 2, "no documentation of %s" % name)


def test_threads(bench):
    points, faces = torus(150)
    mesh = geodesic_offset.Mesh(points, faces, parallel=True)
    sources = [0, 5000, 11111, 17000]
    expected = [mesh.distances(s) for s in sources]
    found = [None] * len(sources)

    def run(k):
        found[k] = mesh.distances(sources[k])

    threads = [threading.Thread(target=run, args=(k,)) for k in range(len(sources))]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    for a, b in zip(found, expected):
        check_all(a, b, 0, "a build among others")
    check_all(mesh.distances(0, parallel=True), expected[0], 1e-12, "a build by several threads")

    # other threads of Python run during a build
    count, is_done = 0, threading.Event()

    def work():
        is_done.clear()
        found[0] = mesh.distance_matrix(sources * 3)
        is_done.set()

    thread = threading.Thread(target=work)
    thread.start()
    while not is_done.is_set():
        count += 1
        time.sleep(1e-3)
    thread.join()
    check(count > 20, "%d turns of another thread" % count)


def test_memory(bench):
    mesh, _ = grid(bench)
    points = mesh.points
    check(not points.flags.writeable and points.base is mesh and points.shape == (169, 3), "a view of points")
    copy = points.copy()
    again = mesh.points
    check(np.shares_memory(points, again), "views of the same memory")
    curve, diagram = mesh.offsets(0, 1)[0], mesh.voronoi([0, 20])
    field = mesh.field(0)
    del mesh, again
    gc.collect()
    check((points == copy).all() and curve.length > 1 and field.distances()[0] == 0 and diagram.curves[0].points(1e-3).size, "without the mesh")
    for array in (curve.points(1e-3), curve.elements(), curve.face_locations(1e-3)[1], field.shortest_path_points_to_sources(5)):
        check(not array.flags.owndata and array.flags.c_contiguous, "an array with the memory of the library")

    other = geodesic_offset.Mesh(np.asfortranarray(copy).astype("f4"), read_off(bench.path("grid.off"))[1].astype("i4"))
    check_all(other.points, copy.astype("f4"), 0, "points of another type")
    path = bench.path("matrix.npy")
    out = np.lib.format.open_memmap(path, "w+", shape=(169, 169))
    result = other.distance_matrix(np.arange(169), out=out)
    check(result is out, "the given array")
    out.flush()
    check_all(np.load(path), other.distance_matrix(np.arange(169)), 0, "a matrix in a file")
    rows = other.distance_matrix(np.arange(169), visitor=lambda fraction: fraction < 0.5)
    check(0 < np.isnan(rows[:, 0]).sum() < 169, "rows of a cancelled matrix")


def test_interrupt(bench):
    """Ctrl-C in the middle of builds, and visitors."""
    points, faces = torus(350, 200)
    mesh = geodesic_offset.Mesh(points, faces)
    builds = (lambda: mesh.distances(0), lambda: mesh.distances(0, parallel=True), lambda: mesh.offsets(0, 0.5 * np.arange(1, 9)),
              lambda: mesh.distance_matrix(np.arange(0, 70000, 17500), parallel=True), lambda: mesh.farthest_points(20))
    for k, build in enumerate(builds):
        start = time.perf_counter()
        build()
        whole = time.perf_counter() - start
        check(whole > 0.2, "build %d takes %g seconds, too few for this test" % (k, whole))
        timer = threading.Timer(whole / 4, os.kill, (os.getpid(), signal.SIGINT))
        start = time.perf_counter()
        timer.start()
        try:
            build()
            time.sleep(1)
            check(False, "build %d was not interrupted" % k)
        except KeyboardInterrupt:
            seconds = time.perf_counter() - start
            check(seconds < 0.8 * whole, "build %d of %g seconds was interrupted after %g" % (k, whole, seconds))
        timer.join()
    fractions = []
    field = mesh.field(0, visitor=lambda fraction: fractions.append(fraction) or fraction < 0.3)
    check(field.is_cancelled and 0 < field.covered_distance < math.inf and fractions == sorted(fractions), "a visitor that cancels")
    whole = []
    check(not mesh.field(0, visitor=whole.append).is_cancelled and whole[-1] == 1, "a visitor without a result")


def test_examples(bench):
    with open(os.path.join(ROOT, "README.md")) as file:
        example = re.search(r"```python\n(.*?)```", file.read(), re.DOTALL).group(1)
    check(example.count("\n") <= 10, "the example of README.md has %d lines" % example.count("\n"))
    with open(os.path.join(ROOT, "doc/Surface_mesh_geodesic_offset/python.md")) as file:
        blocks = re.findall(r"```python\n(.*?)```", file.read(), re.DOTALL)
    check(len(blocks) > 1, "the examples of the manual")
    points, faces = torus(40, 20)
    os.chdir(bench.folder)
    np.save("points.npy", points)
    np.save("faces.npy", faces)
    for text in (example, "\n".join(blocks)):
        exec(compile(text, "example", "exec"), {})  # pylint: disable=exec-used
    try:
        import matplotlib
    except ImportError:
        skip("python3-matplotlib")
    matplotlib.use("Agg")
    script = sys.argv
    sys.argv = ["plot_offsets.py", "picture.png"]
    runpy.run_path(os.path.join(ROOT, "examples/Surface_mesh_geodesic_offset_python/plot_offsets.py"), run_name="__main__")
    check(os.path.getsize("picture.png") > 50000, "a picture")
    sys.argv = script


if __name__ == "__main__":
    run_test(distances=test_distances, fields=test_fields, matrix=test_matrix, curves=test_curves, diagrams=test_diagrams, files=test_files,
             errors=test_errors, threads=test_threads, memory=test_memory, interrupt=test_interrupt, examples=test_examples)
