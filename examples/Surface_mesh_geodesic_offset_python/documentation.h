// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The documentation of the Python module. The signatures with the defaults are added by pybind11.

#ifndef GEODESIC_OFFSET_PYTHON_DOCUMENTATION_H
#define GEODESIC_OFFSET_PYTHON_DOCUMENTATION_H

namespace geodesic_offset_python::docs {

inline const char* const module = R"(Exact geodesic distances and exact offset curves on triangle meshes.

Lengths and distances are in the units of the points. What no path reaches has the distance inf.

A *location* argument is
- a vertex: an integer; or vertices: an integer array (n,);
- a point in space, which is located on the mesh: a float array (3,); or points: an array (n, 3);
- a point of a face: a tuple of the face and of three weights of its corners; or points: a tuple of an integer array (n,) and a
  float array (n, 3).
A result for one location is a number or a row; for several locations it is an array with a row per location.

A *sources* argument is
- a location or locations, each of which is a source, but not an array (n, 3) of points;
- an array (n, 3) of points: the vertices of one polyline, which is closed if the last point is the first one;
- an integer array (n, 2): edges by their vertices, together one source;
- a Polyline, or a Source_set, which also has start values;
- a list of these. A list of numbers, or of lists of numbers, is an array.
Sources have the numbers 0, 1, 2, ... in their order; -1 stands for no source.

A *visitor* is called with the completed fraction of the work, from 0 to 1; a false result, other than None, cancels the work.
With or without one, Ctrl-C stops a build with KeyboardInterrupt, if it runs in the main thread.

Errors are exceptions with the text of the library: ValueError for arguments, RuntimeError for queries that the object does not
allow, TypeError for arguments of other types. Objects can be used from several threads at once; computations release the
interpreter lock. `parallel=True` lets all threads of one build work, if the module was built with TBB.
)";

inline const char* const mesh = R"(A triangle mesh that is set up for geodesic computations. It does not change.)";

inline const char* const mesh_init = R"(Sets up a mesh, in linear time.

points: float array (n, 3). It is copied once.
faces: integer array (m, 3), vertices of the triangles. Edges with one face are border; vertices may belong to several fans.
edge_lengths: in place of points: float array (m, 3), the length from corner 0 to 1, from 1 to 2, and from 2 to 0 of each face.
    Functions that need points raise RuntimeError then.
parallel: whether several threads set up the mesh.

ValueError: a face has the same vertex twice, or one that does not exist; three faces share an edge, or two in the same direction;
a face has collinear corners, or lengths against the triangle inequality; or a number is not finite.)";

inline const char* const mesh_points = R"(Points of the vertices: a read-only view (n, 3) of the mesh, without a copy.)";

inline const char* const locate = R"(Nearest points of the mesh.

points: float array (3,) or (n, 3).
Returns a location: a tuple of faces, int64 () or (n,), and weights of their corners, float64 (3,) or (n, 3).
ValueError: a coordinate is not finite, or the mesh has no faces.)";

inline const char* const locate_polyline = R"(The polyline on the surface through points, joined by shortest paths.

points: float array (n, 3) of points in space, or locations.
is_closed: whether the last point is joined to the first one; None: if they are equal.
start_values: a distance for each point, linear between them, where the polyline is on edges.
Returns a Polyline. ValueError: no points, or no path between two of them.)";

inline const char* const distances = R"(Exact geodesic distances of all vertices from the nearest source.

distance_limit: vertices farther away are at inf.
targets: locations; the computation stops when their distances are final, and others may be inf.
relative_tolerance, merging_tolerance: allow distances that are smaller by this factor or length, in less time.
visitor, parallel: see the module.
Returns float64 (number_of_vertices,). ValueError: a source or an option is not valid.)";

inline const char* const field = R"(The distances as a Field, for queries. Options as for `distances`, and:

keep_windows: whether the field answers queries at points that are no vertices; 40 bytes per window, some 20 windows per vertex.
compute_largest_distance: whether `largest_distance` and `farthest_point` work without windows.)";

inline const char* const distance =
  R"(Exact geodesic distance between two locations: a float, inf if no path joins them, or if it is
longer than `distance_limit`. The time is that of the disc around one of them up to the other one.)";

inline const char* const distance_matrix = R"(Exact geodesic distances of targets from sources.

sources: a list of sources, one per row; or locations, one per row, also if they are an array (n, 3) of points.
targets: locations; None: all vertices.
distance_limit: targets farther away are at inf; a row costs what is within the limit.
upper_half: whether entries left of the diagonal are inf and not computed; the targets are the sources.
out: a contiguous float64 array (rows, columns), such as a numpy.memmap, that receives the rows without another copy.
visitor: a cancelled matrix has nan in rows that are not computed. parallel: each thread computes rows by itself.
Returns float64 (rows, columns), or `out`. ValueError: a source, a target or the array is not valid.)";

inline const char* const farthest_points = R"(Selects vertices, each farthest from those before it.

n: the number of vertices; fewer if all vertices are selected, or by `covering_radius` or `visitor`.
start_set: sources that count as selected before the first vertex.
covering_radius: ends the selection when all vertices are within this distance.
Returns a Farthest_points tuple. ValueError: an argument is not valid.)";

inline const char* const farthest_points_tuple = R"(Result of Mesh.farthest_points:
vertices: uint32 (k,); covering_radius: float, the largest distance of a vertex; distances: float64 (number_of_vertices,) from the
nearest selected vertex or source; labels: int64 (number_of_vertices,), its number, sources of the start set first.)";

inline const char* const split_tuple = R"(Result of Mesh.split:
points: float64 (n, 3), those of the mesh first; faces: int64 (m, 3); face_band: int64 (m,), of offset curves the number of distances
below those in the face, otherwise None; face_source: int64 (m,), of a Voronoi diagram the source of the cell, otherwise None;
constrained_edges: int64 (k, 2), the vertices of the edges on curves.)";

inline const char* const field_class = R"(Distances from the sources of one build. Mesh.field makes it; it does not change.)";
inline const char* const field_distances = R"(Distances of all vertices: float64 (number_of_vertices,).)";
inline const char* const source_labels =
  R"(Number of the nearest source of each vertex: int64 (number_of_vertices,), -1 for none.)";
inline const char* const distance_to_sources =
  R"(Distances at locations. RuntimeError: a location is no vertex, and the field has no
windows (`keep_windows`).)";
inline const char* const signed_distance_to_sources =
  R"(Distances with a sign: negative on the left of polylines, positive on the right, nan
where the nearest source has no sides. RuntimeError as for `distance_to_sources`.)";
inline const char* const gradient =
  R"(Gradients of the distance at locations: unit vectors (3,) or (n, 3); nan at sources and at points without a
distance. RuntimeError as for `distance_to_sources`, and without points.)";
inline const char* const nearest_source =
  R"(Nearest sources of locations, and the nearest points on them: a tuple of numbers of sources, int64 () or
(n,), -1 for none, and of locations. RuntimeError: no windows (`keep_windows`), or a tolerance.)";
inline const char* const path_points =
  R"(A shortest path from one location to the nearest source: float64 (k, 3), points on the edges that it crosses,
empty if there is none. RuntimeError as for `nearest_source`, and without points.)";
inline const char* const path_locations =
  R"(A shortest path from one location to the nearest source, as a tuple of faces, int64 (k,), and weights,
float64 (k, 3). RuntimeError as for `nearest_source`.)";
inline const char* const largest_distance =
  R"(Largest distance of all points of the surface: a float, or None. RuntimeError: neither `keep_windows`
nor `compute_largest_distance`.)";
inline const char* const farthest_point =
  R"(A point at the largest distance: a tuple of a location and the distance, or None. RuntimeError as for
`largest_distance`, and with a distance limit or a tolerance.)";

inline const char* const polyline = R"(A polyline on the surface; Mesh.locate_polyline makes it.)";
inline const char* const source_set = R"(Sources with start values: distances that are added to those from the source.)";
inline const char* const add = R"(Adds sources without start values, and returns the range of their numbers.)";
inline const char* const add_points = R"(Adds each location as a source, and returns the range of their numbers.

ValueError when the distances are computed: a location is not valid, or a start value is negative or not finite.)";
inline const char* const add_polyline =
  R"(Adds a polyline, and returns its number. Arguments as for Mesh.locate_polyline, or a Polyline.)";
inline const char* const add_edges = R"(Adds edges, integer array (n, 2), as one source, and returns its number.

ValueError: there is no edge between two vertices.)";

inline const char* const offsets = R"(Exact offset curves of sources.

levels: a distance, an array of distances, or Levels.
offset_side: Offset_side of all polylines, or a dict from numbers of sources to sides.
end_style: Offset_end, at the ends of open polylines; None: round with both sides, butt with one.
distance_limit and the others: as for `distances`. Nothing beyond the largest level is computed.
Returns a list of Offset_curve by increasing distance. ValueError: a level is not positive and finite; inside or outside of an open
polyline; or an argument is not valid.)";

inline const char* const offset_curves =
  R"(Exact offset curves from the field: arguments and result as for Mesh.offsets. Without windows
(`keep_windows`) the distances are propagated once more.)";

inline const char* const levels =
  R"(Equally spaced distances: start, start + spacing, ...; as many as the surface has if `count` is None.

ValueError: a number is not positive and finite.)";

inline const char* const offset_curve =
  R"(An oriented chain of circular arcs and segments with the smaller distances on its left.)";
inline const char* const curve_points =
  R"(A polyline within `chord_tolerance`, a length, of the curve, with few points: float64 (n, 3). A closed curve
repeats its first point. ValueError: the tolerance is not positive.)";
inline const char* const curve_locations =
  R"(Points where the curve crosses edges, and points between them within `chord_tolerance`: a tuple of faces,
int64 (n,), and weights of their corners, float64 (n, 3). ValueError: the tolerance is not positive.)";
inline const char* const curve_elements =
  R"(The exact curve as maximal segments and arcs in space, across faces that are flat together.

tolerance: a length by which parts of one element may be off its line, circle or plane.
Returns a structured array with the fields start, end, center, normal (3 numbers each; center is nan for segments), radius (nan for
segments), sweep (angle in radians, counterclockwise about the normal; 0 for segments), length, source (-1 for several) and side
(Source_side, -1 for several). ValueError: the tolerance is negative. RuntimeError: the mesh has no points.)";
inline const char* const points_at_spacing = R"(Points that are evenly spaced by arc length, at most `spacing`, a length, apart.

Returns a structured array with the fields point, tangent, normal (3 numbers each) and face. ValueError: not positive.)";

inline const char* const voronoi =
  R"(Exact Voronoi diagram of sources. Options as for `distances`. Returns a Voronoi_diagram.)";
inline const char* const voronoi_diagram =
  R"(Exact Voronoi diagram of the sources. RuntimeError: no windows (`keep_windows`), a distance limit or a
tolerance.)";
inline const char* const diagram_class = R"(The curves between the cells of sources, and the vertices where they meet.)";
inline const char* const source_at = R"(Numbers of the sources in whose cells locations are: int64 () or (n,), -1 for none.)";
inline const char* const bisector =
  R"(A curve between the cells of two sources, of segments and arcs of parabolas and hyperbolas.)";

inline const char* const split = R"(The mesh split along curves, so that they are edges.

curves: a list of Offset_curve, a Voronoi_diagram, or a list of Polyline, of this mesh.
chord_tolerance: largest distance of the edges from the curves, a length; None: 1e-4 of the diagonal of the bounding box.
Returns a Split tuple; the mesh itself does not change. ValueError: the tolerance is not positive, or a curve has a tolerance.)";

inline const char* const certify = R"(Proves a tolerance for offset curves of any program.

sources: as for `distances`. distance: that of the offset. curves: a list of Offset_curve, or a list of polylines: Polyline, points
(n, 3), which are located, or locations.
Returns a Certificate: all points that are nearer than distance - tolerance are in the region that the curves bound, and no point
that is farther than distance + tolerance is. Time: about twice that of a build.
ValueError: the distance is negative or not finite, or a curve is not valid. RuntimeError: the mesh has no points, or the
distances cannot be bounded.)";
inline const char* const distance_bounds =
  R"(Certified bounds of the distances of all vertices: float64 (number_of_vertices, 2), lower and upper.
RuntimeError: the mesh has no points, or the distances cannot be bounded.)";
inline const char* const certificate = R"(Result of Mesh.certify.

bounds_region: bool; tolerance: float, inf without a region; limit: name of what the tolerance is needed for, or why there is no
region; location: the place of the limit, or None; distance_bounds: bounds there; curve: the number of its curve, or None;
number_of_reversed_curves: int, curves with the region on their right.)";

} // namespace geodesic_offset_python::docs

#endif // GEODESIC_OFFSET_PYTHON_DOCUMENTATION_H
