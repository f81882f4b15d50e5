// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_distance_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_source_set.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_curve.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/statistics_report.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/build_parameters.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/functions/cut_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/source_classification.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief computes exact geodesic distances and exact geodesic offset curves on a triangle mesh, from any number of points,
polylines and edges, by the extended Xin-Wang algorithm \cgalCite{XYH11}.

The distance of a point of the surface is the length of the shortest path on the surface from the point to the nearest
source. The use has three steps: add the sources, call `build()`, which propagates the distances, and call the const member
functions. Points that no path reaches are at `infinity()`.

The object has a mesh (`Geodesic_mesh`), a set of sources (`Geodesic_source_set`), and the field of the last build
(`Geodesic_distance_field`). Queries are those of the field, which `build()` also returns: a field is an immutable value that
can be kept, and that later builds do not change. Adding or removing sources does not change it; only `build()`, `update()` and
`build_with_offset_curves()` replace the field of the object. With floating point numbers the const member functions may be
called from several threads at once.

The mesh is neither copied nor modified; it must outlive the object and must not change meanwhile. A vertex that several fans
of faces share is one point of the surface: paths pass through it from each fan into the others, whether the fans are open or
closed. Lengths and distances are in the units of the mesh's points. Offset curves need a number type with at least the
precision of `double`; distances are also available with `float`.

\anchor Surface_mesh_geodesic_distance_callbacks
\cgalHeading{Callbacks, Copies, Moves}

The functions that are passed to a member function - visitors, callbacks that receive offset curves, output iterators, property
maps - may call all member functions of the object, also those that add or remove sources and those that build. A query
continues with the field with which it began; a build and an update continue with the sources that there were when they began,
and their field replaces the last one when they return. So if a callback builds within a build, the field of the outer build is the
result. These functions must not assign to the object, move it or destroy it.

Copies share the field of the last build; the next build of one of them does not change that of the other. An object that was
moved from has no mesh and no field: `is_built()` is false, it can be destroyed and assigned to, and functions that need the
mesh or a field throw `std::logic_error`.

\anchor Surface_mesh_geodesic_distance_threads
\cgalHeading{Several Threads}

The constructor and the functions that propagate read the named parameter `concurrency_tag`, as in
`build(parameters::concurrency_tag(Parallel_tag()))`:
- `Sequential_tag`, the default: the calling thread works alone.
- `Parallel_tag`: all threads work that TBB permits at the call, as limited by `tbb::global_control` and
  `tbb::task_arena`. \cgal must be linked with TBB (`CGAL_LINKED_WITH_TBB`), otherwise the call does not compile.
- `Parallel_if_available_tag`: `Parallel_tag` with TBB, `Sequential_tag` without.

With `Parallel_tag` the results are the same to the last bit for any number of threads, one included, and in each run. They
differ from the results with `Sequential_tag` by rounding alone: distances by no more than a relative \f$10^{-13}\f$ in all
tests. The distance at which a build stops, at its targets or because the visitor cancels it, may differ, and so may the
counts of the statistics; memory is larger by some percent. The calling thread alone calls the visitor and the callbacks that
receive offset curves; TBB's threads remain occupied until the function returns.

Several threads call the functors of the traits concurrently, and, during construction, the functions and maps that read the
mesh. All this holds for `float`, `double` and `long double` only: with other number types, whose operations may share
memory, `Parallel_tag` does what `Sequential_tag` does.

\tparam Traits_ a model of `SurfaceMeshGeodesicOffsetTraits`
\tparam VertexIndexMap a model of `ReadablePropertyMap` with `vertex_descriptor` as key and an unsigned integer type as
        value: indices from 0. %Default: the internal map of the mesh, or a map that the constructor makes.
\tparam FaceIndexMap a model of `ReadablePropertyMap` with `face_descriptor` as key and an unsigned integer type as value:
        indices from 0. %Default: the internal map of the mesh, or a map that the constructor makes.
\tparam VertexPointMap a model of `ReadablePropertyMap` with `vertex_descriptor` as key and a 3D point as value.
        %Default: the `vertex_point` map of the mesh.
*/
template <class Traits_, class VertexIndexMap = Default, class FaceIndexMap = Default, class VertexPointMap = Default>
class Surface_mesh_geodesic_offset
{
public:
  /// \name Types
  /// @{

  /// the traits
  typedef Traits_ Traits;
  /// the prepared mesh: plane coordinates of its faces, traits and point locator
  typedef Geodesic_mesh<Traits, VertexIndexMap, FaceIndexMap, VertexPointMap> Mesh;
  /// a set of sources
  typedef typename Mesh::Source_set Source_set;
  /// the distances of a build
  typedef Geodesic_distance_field<Mesh> Field;

  /// the mesh
  typedef typename Mesh::Triangle_mesh Triangle_mesh;
  /// a vertex of the mesh
  typedef typename Mesh::vertex_descriptor vertex_descriptor;
  /// a halfedge of the mesh
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;
  /// an edge of the mesh
  typedef typename Mesh::edge_descriptor edge_descriptor;
  /// a face of the mesh
  typedef typename Mesh::face_descriptor face_descriptor;

  /// the number type of distances and of coordinates
  typedef typename Mesh::FT FT;
  /// a point in space
  typedef typename Mesh::Point_3 Point_3;
  /// a vector in space
  typedef typename Mesh::Vector_3 Vector_3;
  /// a ray in space
  typedef typename Mesh::Ray_3 Ray_3;
  /// a plane in space
  typedef typename Mesh::Plane_3 Plane_3;

  /// barycentric coordinates in a face
  typedef typename Mesh::Barycentric_coordinates Barycentric_coordinates;
  /// a point of the surface
  typedef typename Mesh::Face_location Face_location;
  /// a polyline on the surface
  typedef typename Mesh::Polyline Polyline;
  /// the result of `plane_section()`
  typedef typename Mesh::Plane_section Plane_section;

  /// the result of `nearest_source()`
  typedef typename Field::Nearest_source Nearest_source;
  /// counts and times of a build
  typedef typename Field::Statistics Statistics;
  /// an offset curve
  typedef typename Field::Offset_curve Offset_curve;
  /// @}

private:
  typedef Geodesic_offset::internal::Surface_of<Mesh> Surface;
  typedef Geodesic_offset::internal::Geodesic_mesh_data<Surface> Data;
  typedef typename Surface::Number Number;
  typedef Geodesic_offset::internal::Build_request<Number> Request;
  typedef Geodesic_offset::internal::Geodesic_build<typename Data::Computing_traits> Build;
  typedef typename Source_set::Source Source;
  typedef typename Source_set::Kind Kind;

public:
  /// \name Construction
  /// @{

  /// sets up the mesh.
  /// \param tm the mesh
  /// \param np an optional sequence of named parameters, those of `Geodesic_mesh::Geodesic_mesh()`
  /// \throws std::invalid_argument and std::length_error as `Geodesic_mesh::Geodesic_mesh()`
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Surface_mesh_geodesic_offset(const Triangle_mesh& tm, const NamedParameters& np = parameters::default_values())
    : m_mesh(tm, np)
  {
  }

  /// Deleted: the object refers to the mesh, which must not be temporary.
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Surface_mesh_geodesic_offset(const Triangle_mesh&& tm,
                                        const NamedParameters& np = parameters::default_values()) = delete;

  /// shares a mesh that is set up.
  explicit Surface_mesh_geodesic_offset(const Mesh& mesh) : m_mesh(mesh) {}
  /// @}

  /// \name Parts
  /// @{

  /// the prepared mesh: plane coordinates of its faces, traits and point locator.
  const Mesh& mesh() const { return m_mesh; }

  /// the sources of the next build.
  const Source_set& sources() const { return m_sources; }

  /// the field of the last build.
  /// \throws std::logic_error if `!is_built()`
  const Field& field() const
  {
    if (!is_built()) throw std::logic_error("Surface_mesh_geodesic_offset: build() has not been called");
    return m_field;
  }
  /// @}

  /// \name Sources
  /// Each function that adds a source returns its id: 0, 1, 2, ... Ids of removed sources are not used again. If a function
  /// throws, it has added nothing. An element of another mesh is recognized by its descriptor: if that is also the descriptor of an
  /// element of this mesh, as indices are, it stands for this element.
  ///
  /// A source may have a *start value*, a distance that is added to all distances from the source. Distances are then
  /// \f$\min_i (s_i + d_i)\f$ over the sources \f$i\f$ with their start values \f$s_i\f$, and with the distances
  /// \f$d_i\f$ from one source alone. A source in a region where another source is nearer has no effect there. All
  /// functions count the start value as a part of the distance: the offset at distance \f$d\f$ from a source with the start
  /// value \f$s\f$ alone is the offset at distance \f$d - s\f$ without it. Its points have the distance \f$s\f$; they
  /// have no gradient, and their signed distance is positive.
  /// @{

  /// adds a vertex.
  /// \param v the vertex
  /// \param np an optional named parameter
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{start_value}
  ///     \cgalParamDescription{the start value}
  ///     \cgalParamType{convertible to `FT`, a finite number that is not negative}
  ///     \cgalParamDefault{0}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \throws std::invalid_argument if the vertex is null, removed or of another mesh, or if the start value is not a finite
  ///         number or is negative.
  template <class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_source_point(vertex_descriptor v, const NamedParameters& np = parameters::default_values())
  {
    return add(Source{Kind::VERTEX, v, {}, {}, Geodesic_offset::internal::start_value_of<FT>(np)});
  }

  /// adds a point anywhere on the surface. The coordinates are divided by their sum. If one of them is then less than 1e-13,
  /// the point is the nearest one of the edge; if two are, it is at the vertex. With an exact number type, this holds for zero.
  /// \param location the point
  /// \param np as for a vertex
  /// \throws std::invalid_argument if the face is null, removed or of another mesh; if the coordinates are not finite, their sum is
  ///         not positive, or one is negative by more than 1e-9, or with an exact number type at all; or if the start value is not
  ///         a finite number or is negative.
  template <class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_source_point(const Face_location& location, const NamedParameters& np = parameters::default_values())
  {
    return add(Source{Kind::LOCATION, no_vertex(), {location}, {}, Geodesic_offset::internal::start_value_of<FT>(np)});
  }

  /// Overload for a location with the coordinates of another kernel, which are converted.
  template <class Coordinate, class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_source_point(const std::pair<face_descriptor, std::array<Coordinate, 3>>& location,
                               const NamedParameters& np = parameters::default_values())
  {
    return add_source_point(Geodesic_offset::internal::converted_location<FT>(location), np);
  }

#ifndef DOXYGEN_RUNNING
  // Chosen for points in space.
  template <class Point, class NamedParameters = parameters::Default_named_parameters,
            class = std::enable_if_t<Geodesic_offset::internal::is_point_in_space<Point>>>
  std::size_t add_source_point(const Point&, const NamedParameters& = parameters::default_values())
  {
    static_assert(!Geodesic_offset::internal::is_point_in_space<Point>, CGAL_GEODESIC_OFFSET_NEEDS_LOCATION);
    return 0;
  }
#endif

  /// adds each point of a range as a source of its own.
  /// \return the ids of the sources, in the order of the range
  /// \tparam LocationRange a model of `ConstRange` with `vertex_descriptor`, `Face_location`, or a location with the coordinates of
  ///         another kernel, as value type
  /// \param locations the points
  /// \param np as for a vertex; the start value is that of all points
  /// \throws std::invalid_argument as `add_source_point()` does; no point has been added then.
  template <class LocationRange, class NamedParameters = parameters::Default_named_parameters>
  std::vector<std::size_t> add_source_points(const LocationRange& locations,
                                             const NamedParameters& np = parameters::default_values())
  {
    Source_set set;
    for (const auto& l : locations) Geodesic_offset::internal::add_point(set, l, np);
    return add_sources(set);
  }

  /// adds a polyline whose vertices lie anywhere on the surface, and each of whose segments is straight within one closed
  /// face. The polyline may cross itself and other sources. Repeated points are allowed; a polyline of one point is a point.
  ///
  /// \tparam FaceLocationRange a model of `ConstRange` with `Face_location`, or a location with the coordinates of another kernel,
  ///         as value type
  /// \param locations the vertices of the polyline
  /// \param np an optional sequence of named parameters among those listed below
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{is_closed}
  ///     \cgalParamDescription{whether the last point is joined to the first one. The range may repeat the first point at its end.}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`true` if the range repeats its first point at its end, see `polyline_closing()`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{start_value}
  ///     \cgalParamDescription{the start value}
  ///     \cgalParamType{convertible to `FT`, a finite number that is not negative}
  ///     \cgalParamDefault{0}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{start_values}
  ///     \cgalParamDescription{a start value for each location, linear between them, so that offsets have a width that varies, see
  ///                           \ref SurfaceMeshGeodesicOffsetUseLocations. Where they vary, segments must be on edges.}
  ///     \cgalParamType{a model of `ConstRange` of numbers, or a `std::reference_wrapper` of one}
  ///     \cgalParamDefault{`start_value` for all}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \throws std::invalid_argument if the range is empty, if two consecutive points have no face in common, if a location is not
  ///         valid, or if a start value is not a finite number or is negative; if there are not as many start values as points, or if
  ///         they vary along a segment that is not on an edge.
  template <class FaceLocationRange, class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_source_polyline(const FaceLocationRange& locations, const NamedParameters& np = parameters::default_values())
  {
    Source_set set;
    set.add_polyline(locations, np);
    Source source = set.sources().begin()->second;
    if constexpr (!Geodesic_offset::internal::has_parameter<internal_np::geodesic_is_closed_t, NamedParameters>)
      Geodesic_offset::internal::close_if_ends_meet(data(), source);
    return add(std::move(source));
  }

  /// Overload for a polyline that is open or closed itself, such as the results of `locate_polyline()`, `join_polyline()` and
  /// `plane_section()`, with the start values of the polyline if it has any. The only named parameter is `start_value`.
  template <class Location, class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_source_polyline(const Geodesic_polyline<Location>& polyline,
                                  const NamedParameters& np = parameters::default_values())
  {
    Source_set set;
    set.add_polyline(polyline, np);
    return add(set.sources().begin()->second);
  }

  /// adds a set of edges.
  /// \tparam EdgeRange a model of `ConstRange` with `edge_descriptor` as value type
  /// \param edges the edges
  /// \param np as for a vertex
  /// \throws std::invalid_argument if the range is empty, if an edge has no face, if an edge is null, removed or of another mesh,
  ///         or if the start value is not a finite number or is negative.
  template <class EdgeRange, class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_source_edges(const EdgeRange& edges, const NamedParameters& np = parameters::default_values())
  {
    return add(Source{Kind::EDGES,
                      no_vertex(),
                      {},
                      std::vector<edge_descriptor>(std::begin(edges), std::end(edges)),
                      Geodesic_offset::internal::start_value_of<FT>(np)});
  }

  /// adds the sources of a set, in the order of their ids in the set.
  /// \return the ids of the sources in this object
  /// \throws std::invalid_argument if a source does not fit the mesh
  std::vector<std::size_t> add_sources(const Source_set& set)
  {
    return Geodesic_offset::internal::add_checked(data(), m_sources, set);
  }

  /// Overload for a set with another number type, which is converted.
  template <class Number>
  std::vector<std::size_t> add_sources(const Geodesic_source_set<Triangle_mesh, Number>& set)
  {
    return add_sources(Source_set(set));
  }

  /// adds the boundary of the surface: one source, a set of edges, per boundary cycle. Edges without a face are left out. Takes
  /// time linear in the size of the mesh.
  /// \param np as for a vertex; the start value is that of all cycles
  /// \return the ids of the sources; no ids if the surface has no boundary
  /// \throws std::invalid_argument if the start value is not a finite number or is negative.
  template <class NamedParameters = parameters::Default_named_parameters>
  std::vector<std::size_t> add_source_boundary(const NamedParameters& np = parameters::default_values())
  {
    Source_set set;
    for (const std::vector<edge_descriptor>& cycle : m_mesh.boundary_edges()) set.add_edges(cycle, np);
    return add_sources(set);
  }

  /// adds one boundary cycle, that of a border halfedge: a set of edges. Edges without a face are left out.
  /// \param border the halfedge
  /// \param np as for a vertex
  /// \throws std::invalid_argument if the halfedge is not a border halfedge, if it is null, removed or of another mesh, if no
  ///         edge of the cycle has a face, or if the start value is not a finite number or is negative.
  template <class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_source_boundary(halfedge_descriptor border, const NamedParameters& np = parameters::default_values())
  {
    return add_source_edges(m_mesh.boundary_edges(border), np);
  }

  /// adds the edges that `sharp_edges()` finds, as one source.
  /// \param angle as for `sharp_edges()`
  /// \param np as for a vertex
  /// \return the id of the source; empty if there is no such edge
  /// \throws std::invalid_argument as `sharp_edges()` does, or if the start value is not a finite number or is negative.
  template <class NamedParameters = parameters::Default_named_parameters>
  std::optional<std::size_t> add_source_sharp_edges(double angle, const NamedParameters& np = parameters::default_values())
  {
    std::vector<edge_descriptor> edges;
    sharp_edges(angle, std::back_inserter(edges));
    if (edges.empty()) return std::nullopt;
    return add_source_edges(edges, np);
  }

  /// adds the section of the mesh by a plane: each polyline of the section; the edges that the plane only touches, as one set of
  /// edges, which has no sides; and each vertex that the plane only touches.
  /// \param plane the plane
  /// \param np as for a vertex; the start value is that of all these sources
  /// \return the ids of these sources, in this order; no ids if the plane misses the mesh.
  /// \throws std::invalid_argument as `plane_section()` does, or if the start value is not a finite number or is negative.
  template <class NamedParameters = parameters::Default_named_parameters>
  std::vector<std::size_t> add_source_plane_section(const Plane_3& plane,
                                                    const NamedParameters& np = parameters::default_values())
  {
    const Plane_section section = plane_section(plane);
    Source_set set;
    for (const auto& polyline : section.polylines) set.add_polyline(polyline, np);
    if (!section.touched_edges.empty()) set.add_edges(section.touched_edges, np);
    for (const vertex_descriptor v : section.touched_vertices) set.add_vertex(v, np);
    return add_sources(set);
  }

  /// removes a source.
  /// \throws std::invalid_argument if there is no source with this id.
  void remove_source(std::size_t id) { m_sources.remove(id); }

  /// removes all sources.
  void clear_sources() { m_sources.clear(); }

  /// the number of sources.
  std::size_t number_of_sources() const { return m_sources.size(); }

  /// forwards to `Geodesic_mesh::inner_sides()` with the sources of this object.
  std::map<std::size_t, Geodesic_inner_side> inner_sides() const { return m_mesh.inner_sides(m_sources); }
  /// @}

  /// \name Building
  /// @{

  /*!
  propagates the distances from the sources over the surface. Without any source, all points are at infinity.

  On most meshes of n vertices the number of windows that are propagated grows like n^1.5; in the worst case the lower
  envelopes together have O(n^2) windows \cgalCite{MMP87}. A window takes constant time on average. All other work takes
  time linear in the size of the mesh, also with a distance limit. Memory is that of the front, and some 40 bytes per
  window if windows are kept.

  With a tolerance, distances may be smaller than the exact ones, within the bounds that `statistics()` reports, but not
  larger, and a few windows per vertex are propagated on smooth fine meshes, however fine; see \ref
  SurfaceMeshGeodesicOffsetTolerance. A point whose exact distance exceeds the distance limit by no more than the bound
  may then have a distance, too. Offset curves then have a tolerance, see `Geodesic_offset_curve::tolerance()`. The functions for
  paths, nearest points, the farthest point and Voronoi diagrams need an exact build, and throw `std::logic_error` otherwise.

  \tparam NamedParameters a sequence of named parameters
  \param np an optional sequence of named parameters among those listed below
  \return the field, which is also that of the object

  \cgalNamedParamsBegin
    \cgalParamNBegin{distance_limit}
      \cgalParamDescription{the largest distance that is computed, inclusive. Points farther away are at infinity.}
      \cgalParamType{convertible to `FT`}
      \cgalParamDefault{infinity}
    \cgalParamNEnd
    \cgalParamNBegin{keep_windows}
      \cgalParamDescription{whether the windows are kept after the propagation, which queries at points other than vertices
                            need}
      \cgalParamType{`bool`}
      \cgalParamDefault{`false`}
    \cgalParamNEnd
    \cgalParamNBegin{compute_largest_distance}
      \cgalParamDescription{whether the largest distance of the surface is computed while the front advances, for
                            `largest_distance()` and `farthest_point()`. Takes little time, and memory for one face.}
      \cgalParamType{`bool`}
      \cgalParamDefault{`false`; these functions need kept windows then}
    \cgalParamNEnd
    \cgalParamNBegin{targets}
      \cgalParamDescription{the points whose distances are requested: the propagation stops once all of these distances are
                            final. An empty range has no effect.}
      \cgalParamType{a model of `ConstRange` with `vertex_descriptor` or `Face_location` as value type, or a
                     `std::reference_wrapper` of one}
      \cgalParamDefault{none: all distances are requested}
      \cgalParamExtra{Ranges are copied; `std::cref` avoids the copy.}
    \cgalParamNEnd
    \cgalParamNBegin{visitor}
      \cgalParamDescription{called periodically with the completed fraction of the surface: a number from 0 to 1 that never
                            decreases and is 1 at the end only. If the visitor returns `false`, the build is cancelled.}
      \cgalParamType{a function object `bool(double)`, or a `std::reference_wrapper` of one}
      \cgalParamDefault{none}
      \cgalParamExtra{The function object is copied; `std::ref` passes an object with a state.}
    \cgalParamNEnd
    \cgalParamNBegin{relative_tolerance}
      \cgalParamDescription{the largest relative amount by which a distance may be smaller than the exact distance: a number
                            from 0 to 0.5, in practice from 1e-9 to 1e-3}
      \cgalParamType{convertible to `FT`}
      \cgalParamDefault{0: exact distances}
      \cgalParamExtra{On smooth fine meshes a tolerance saves much time and memory: neighbouring windows are merged if all
                      distances stay within the tolerance, so that a few windows per vertex are propagated. `statistics()`
                      reports the error bound that was reached. Distances, signed distances, gradients, labels and offset
                      curves are available then. Needs a floating point number type.}
    \cgalParamNEnd
    \cgalParamNBegin{merging_tolerance}
      \cgalParamDescription{the largest length by which a distance may be smaller than the exact distance, in the units of the
                            mesh's points: finite, and not negative}
      \cgalParamType{convertible to `FT`}
      \cgalParamDefault{0}
      \cgalParamExtra{A length far below the size of the faces merges windows that differ only by noise in the coordinates, for
                      instance in the planes of a CAD model. Otherwise as `relative_tolerance`; if both are given, a distance
                      may be smaller by the sum, but never by more than half of the exact distance.}
    \cgalParamNEnd
    \cgalParamNBegin{concurrency_tag}
      \cgalParamDescription{whether several threads propagate, see \ref Surface_mesh_geodesic_distance_threads "Several
                            Threads"}
      \cgalParamType{`Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`}
      \cgalParamDefault{`Sequential_tag`}
    \cgalParamNEnd
    \cgalParamNBegin{verbose}
      \cgalParamDescription{whether a line with counts and times is written to `std::clog`}
      \cgalParamType{`bool`}
      \cgalParamDefault{`false`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throws std::invalid_argument if the distance limit is negative or not a number, or a target is not a valid location,
          or the relative tolerance is not a number from 0 to 0.5, or the merging tolerance is negative or not a finite
          number, or one of the tolerances is not 0 and the number type is exact.
  \throws std::runtime_error if thousands of windows reach one edge of a small mesh, as in needle faces thinner than some
          1e-9, where windows differ by less than rounding and their number grows without a bound.
          After all these exceptions, and those of the visitor, the field of the object is unchanged.
  */
  template <class NamedParameters = parameters::Default_named_parameters>
  Field build(const NamedParameters& np = parameters::default_values())
  {
    namespace internal = Geodesic_offset::internal;
    internal::check_named_parameters<internal::Build_parameters, NamedParameters>();
    const auto fresh = std::make_shared<Build>(data().unfolded(), classified_sources(), request(np));
    fresh->template propagate<internal::Concurrency_tag_of<NamedParameters>,
                              Build::parts_for(internal::build_parts_of<NamedParameters>)>(data().traits);
    internal::report(fresh->statistics, np);
    return m_field = field_of(fresh);
  }

  /// brings the field up to date with the sources. Only the distances that the sources added since the last build improve are
  /// propagated. The result is that of `build()` with the parameters `distance_limit`, `keep_windows` and
  /// `compute_largest_distance` of the last build. If sources were removed since then, or if the last build was cancelled,
  /// stopped at its targets, had a tolerance, or computed the largest distance without kept windows, all distances are
  /// computed anew, with that tolerance. During the update there are two fields in memory; kept windows of the last build are
  /// copied, which takes time linear in their number. If the visitor cancels the update, the field of the object is unchanged.
  /// \param np an optional sequence of named parameters among those listed below
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{visitor}
  ///     \cgalParamDescription{receives the progress and may cancel the update, as in `build()`}
  ///     \cgalParamType{a function object `bool(double)`, or a `std::reference_wrapper` of one}
  ///     \cgalParamDefault{none}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{concurrency_tag}
  ///     \cgalParamDescription{whether several threads propagate, as in `build()`}
  ///     \cgalParamType{`Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`}
  ///     \cgalParamDefault{`Sequential_tag`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{verbose}
  ///     \cgalParamDescription{whether a line with counts and times is written to `std::clog`}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`false`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \return the field of the object
  /// \throws std::logic_error if `!is_built()`, and std::runtime_error as `build()`
  template <class NamedParameters = parameters::Default_named_parameters>
  Field update(const NamedParameters& np = parameters::default_values())
  {
    namespace internal = Geodesic_offset::internal;
    internal::check_named_parameters<internal::Update_parameters, NamedParameters>();
    const Field last = field();
    const Build& b = *internal::Field_access::shared_build(last);
    Request r = request(np);
    r.maximum = b.request().maximum;
    r.keeps_windows = b.kept;
    r.tolerance = b.request().tolerance;
    r.finds_farthest = b.request().finds_farthest;
    const bool can_grow = b.is_whole() && !b.is_approximate() && (b.kept || !r.finds_farthest);
    const auto sources = classified_sources();
    const bool grows = can_grow && sources.extends(b.sources);
    const auto fresh = grows ? std::make_shared<Build>(b, sources, r) : std::make_shared<Build>(data().unfolded(), sources, r);
    fresh->template propagate<internal::Concurrency_tag_of<NamedParameters>, Build::parts_for(internal::ALL_PARTS)>(
      data().traits);
    internal::report(fresh->statistics, np);
    if (!fresh->is_cancelled) m_field = field_of(fresh);
    return m_field;
  }

  /*!
  builds the field as `build()` does and cuts the offset curves at the given levels in the same propagation.

  Curves come by increasing distance, as soon as the front has passed them: memory is that of the front and of the
  curves that the front crosses. Without `distance_limit`, distances beyond the largest level are computed, too. With a
  limit that is equal to the largest level, the curves are the same up to rounding, and nothing beyond is computed. Levels
  beyond the distance limit give no curves. A selection by inside or outside takes the time of `inner_sides()` more. With a
  tolerance, the curves are those of the distances that the build gives, see `Geodesic_offset_curve::tolerance()`.

  \param levels a distance, a range of distances such as `{1., 2.}`, or an `Offset_levels` object
  \param out an output iterator for `Offset_curve`
  \param np an optional sequence of named parameters: those of `build()`, and those listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{offset_side}
      \cgalParamDescription{the side of all polylines, or of each. Curves are cut where they leave it, so they may be open with
                            ends inside the surface.}
      \cgalParamType{`Offset_side`, or a range of pairs of the id of a source and its `Offset_side`, such as
                     `std::map<std::size_t, Offset_side>`}
      \cgalParamDefault{`Offset_side::BOTH`, also for sources that are not in the range}
      \cgalParamExtra{`inner_sides()` has the sides that are inside.}
    \cgalParamNEnd
    \cgalParamNBegin{end_style}
      \cgalParamDescription{the cap style at the ends of open polylines}
      \cgalParamType{`Offset_end`}
      \cgalParamDefault{`Offset_end::ROUND` for sources with both sides, `Offset_end::BUTT` for those with one side}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throws std::invalid_argument if a distance is not a positive finite number; if the spacing of unlimited levels is less
          than the rounding of distances; if the side is inside or outside and a source is an open polyline, or a
          closed polyline that does not divide the surface; and the exceptions of `build()`.
          The field of the object is unchanged then.
  */
  template <class Levels = std::initializer_list<FT>, class OutputIterator,
            class NamedParameters = parameters::Default_named_parameters>
  OutputIterator build_with_offset_curves(const Levels& levels, OutputIterator out,
                                          const NamedParameters& np = parameters::default_values())
  {
    build_with_offset_curves_by_distance(levels, Geodesic_offset::internal::curve_writer<Offset_curve>(out), np);
    return out;
  }

  /// builds the field and passes the offset curves to a callback, distance by distance.
  ///
  /// `f(distance, curves)` is called once per distance, in increasing order, with a `const FT&` and a
  /// `std::vector<Offset_curve>&&`, also if there are no curves. If the number of levels is unlimited, the last call is
  /// that of the largest level that has curves, or of one at the largest distance, which has none. All else is as in
  /// `build_with_offset_curves()`.
  template <class Levels = std::initializer_list<FT>, class Function,
            class NamedParameters = parameters::Default_named_parameters>
  void build_with_offset_curves_by_distance(const Levels& levels, Function&& f,
                                            const NamedParameters& np = parameters::default_values())
  {
    namespace internal = Geodesic_offset::internal;
    internal::check_named_parameters<internal::Build_and_offset_parameters, NamedParameters>();
    const auto wanted = internal::offset_levels<Surface>(levels);
    const auto fresh = std::make_shared<Build>(data().unfolded(), classified_sources(), request(np));
    internal::propagate_and_cut<internal::Concurrency_tag_of<NamedParameters>, internal::build_parts_of<NamedParameters>>(
      data(), *fresh, wanted, internal::offset_selection(np), false, f);
    internal::report(fresh->statistics, np);
    m_field = field_of(fresh);
  }

  /// whether there is a field.
  bool is_built() const { return m_field.is_built(); }
  /// @}

  /// \name Queries
  /// These functions forward to the field, and throw `std::logic_error` if `!is_built()`. A `Location` is a `vertex_descriptor`
  /// or a `Face_location`.
  /// @{

  /// forwards to `Geodesic_distance_field::is_cancelled()`.
  bool is_cancelled() const { return field().is_cancelled(); }

  /// forwards to `Geodesic_distance_field::covered_distance()`.
  FT covered_distance() const { return field().covered_distance(); }

  /// forwards to `Geodesic_distance_field::statistics()`. The reference is valid until the next build.
  const Statistics& statistics() const { return field().statistics(); }

  /// forwards to `Geodesic_distance_field::distance_to_sources()`.
  template <class Location>
  FT distance_to_sources(const Location& location) const
  {
    return field().distance_to_sources(location);
  }

  /// forwards to `Geodesic_distance_field::signed_distance_to_sources()`.
  template <class Location>
  std::optional<double> signed_distance_to_sources(const Location& location) const
  {
    return field().signed_distance_to_sources(location);
  }

  /// forwards to `Geodesic_distance_field::nearest_source()`.
  template <class Location>
  std::optional<Nearest_source> nearest_source(const Location& location) const
  {
    return field().nearest_source(location);
  }

  /// forwards to `Geodesic_distance_field::gradient()`.
  template <class Location>
  std::optional<Vector_3> gradient(const Location& location) const
  {
    return field().gradient(location);
  }

  /// forwards to `Geodesic_distance_field::error_bound()`.
  FT error_bound(vertex_descriptor v) const { return field().error_bound(v); }

  /// forwards to `Geodesic_distance_field::vertex_distances()`.
  template <class VertexDistanceMap>
  void vertex_distances(VertexDistanceMap map) const
  {
    return Field(field()).vertex_distances(map);
  }

  /// forwards to `Geodesic_distance_field::source_labels()`.
  template <class VertexLabelMap>
  void source_labels(VertexLabelMap map) const
  {
    return Field(field()).source_labels(map);
  }

  /// forwards to `Geodesic_distance_field::largest_vertex_distance()`.
  std::optional<FT> largest_vertex_distance() const { return field().largest_vertex_distance(); }

  /// forwards to `Geodesic_distance_field::farthest_point()`.
  std::optional<std::pair<Face_location, FT>> farthest_point() const { return field().farthest_point(); }

  /// forwards to `Geodesic_distance_field::largest_distance()`.
  std::optional<FT> largest_distance() const { return field().largest_distance(); }

  /// forwards to `Geodesic_distance_field::shortest_path_to_sources()`.
  template <class Location, class OutputIterator>
  OutputIterator shortest_path_to_sources(const Location& location, OutputIterator out) const
  {
    return Field(field()).shortest_path_to_sources(location, out);
  }

  /// forwards to `Geodesic_distance_field::shortest_path_points_to_sources()`.
  template <class Location, class OutputIterator>
  OutputIterator shortest_path_points_to_sources(const Location& location, OutputIterator out) const
  {
    return Field(field()).shortest_path_points_to_sources(location, out);
  }

  /// forwards to `Geodesic_distance_field::shortest_path_sequence_to_sources()`.
  template <class Location, class Visitor>
  void shortest_path_sequence_to_sources(const Location& location, Visitor& visitor) const
  {
    return Field(field()).shortest_path_sequence_to_sources(location, visitor);
  }

  /// forwards to `Geodesic_distance_field::offset_curves()`.
  template <class Levels = std::initializer_list<FT>, class OutputIterator,
            class NamedParameters = parameters::Default_named_parameters>
  OutputIterator offset_curves(const Levels& levels, OutputIterator out,
                               const NamedParameters& np = parameters::default_values()) const
  {
    return Field(field()).offset_curves(levels, out, np);
  }

  /// forwards to `Geodesic_distance_field::offset_curves_by_distance()`.
  template <class Levels = std::initializer_list<FT>, class Function,
            class NamedParameters = parameters::Default_named_parameters>
  void offset_curves_by_distance(const Levels& levels, Function&& f,
                                 const NamedParameters& np = parameters::default_values()) const
  {
    return Field(field()).offset_curves_by_distance(levels, f, np);
  }

  /// forwards to `Geodesic_distance_field::infinity()`.
  static FT infinity() { return Field::infinity(); }

  /// forwards to `Geodesic_distance_field::no_source()`.
  static constexpr std::size_t no_source() { return Field::no_source(); }
  /// @}

  /// \name Location, Polylines and Sections
  /// These functions forward to the mesh.
  /// @{

  /// forwards to `Geodesic_mesh::locate()`.
  template <class NamedParameters = parameters::Default_named_parameters>
  Face_location locate(const Point_3& p, const NamedParameters& np = parameters::default_values()) const
  {
    return m_mesh.locate(p, np);
  }

  /// Overload for a point of another kernel.
  template <class Point, class NamedParameters = parameters::Default_named_parameters>
  Face_location locate(const Point& p, const NamedParameters& np = parameters::default_values()) const
  {
    return m_mesh.locate(p, np);
  }

  /// forwards to `Geodesic_mesh::locate()`.
  template <class NamedParameters = parameters::Default_named_parameters>
  std::optional<Face_location> locate(const Ray_3& r, const NamedParameters& np = parameters::default_values()) const
  {
    return m_mesh.locate(r, np);
  }

  /// forwards to `Geodesic_mesh::locate_with_distance()`.
  template <class NamedParameters = parameters::Default_named_parameters>
  std::pair<Face_location, FT> locate_with_distance(const Point_3& p,
                                                    const NamedParameters& np = parameters::default_values()) const
  {
    return m_mesh.locate_with_distance(p, np);
  }

  /// Overload for a point of another kernel.
  template <class Point, class NamedParameters = parameters::Default_named_parameters>
  std::pair<Face_location, FT> locate_with_distance(const Point& p,
                                                    const NamedParameters& np = parameters::default_values()) const
  {
    return m_mesh.locate_with_distance(p, np);
  }

  /// forwards to `Geodesic_mesh::locate_polyline()`.
  template <class PointRange, class NamedParameters = parameters::Default_named_parameters>
  Polyline locate_polyline(const PointRange& points, const NamedParameters& np = parameters::default_values()) const
  {
    return m_mesh.locate_polyline(points, np);
  }

  /// forwards to `Geodesic_mesh::locate_polyline_with_distance()`.
  template <class PointRange, class NamedParameters = parameters::Default_named_parameters>
  std::pair<Polyline, FT> locate_polyline_with_distance(const PointRange& points,
                                                        const NamedParameters& np = parameters::default_values()) const
  {
    return m_mesh.locate_polyline_with_distance(points, np);
  }

  /// forwards to `Geodesic_mesh::join_polyline()`.
  template <class FaceLocationRange, class NamedParameters = parameters::Default_named_parameters>
  Polyline join_polyline(const FaceLocationRange& locations, const NamedParameters& np = parameters::default_values()) const
  {
    return m_mesh.join_polyline(locations, np);
  }

  /// forwards to `Geodesic_mesh::plane_section()`.
  Plane_section plane_section(const Plane_3& plane) const { return m_mesh.plane_section(plane); }

  /// forwards to `Geodesic_mesh::sharp_edges()`.
  template <class OutputIterator>
  OutputIterator sharp_edges(double angle, OutputIterator out) const
  {
    return m_mesh.sharp_edges(angle, out);
  }
  /// @}

private:
  const Data& data() const { return Geodesic_offset::internal::Mesh_access::data(m_mesh); }

  static vertex_descriptor no_vertex() { return boost::graph_traits<Triangle_mesh>::null_vertex(); }

  std::size_t add(Source source)
  {
    Geodesic_offset::internal::check_source(data(), source);
    return m_sources.add(std::move(source));
  }

  auto classified_sources() const { return Geodesic_offset::internal::classified_sources(data(), m_sources); }

  template <class NamedParameters>
  Request request(const NamedParameters& np) const
  {
    return Geodesic_offset::internal::read_build_request<Number>(np, [this](const auto& t) { return data().classified(t); });
  }

  Field field_of(const std::shared_ptr<const Build>& build) const
  {
    return Geodesic_offset::internal::Field_access::make<Field>(m_mesh, build);
  }

  Mesh m_mesh;
  Source_set m_sources;
  Field m_field;
};

} // namespace CGAL

#endif
