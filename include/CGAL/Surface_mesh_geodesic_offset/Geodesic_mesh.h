// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_MESH_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_MESH_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_plane_section.h>
#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_source_set.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/Polyline_closing.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_offset_traits.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Polyline_joining.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Inner_sides.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/Geodesic_mesh_data.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/normal_angle.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/own_maps.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/source_classification.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/point_conversion.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/Plane_cutting.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <CGAL/Default.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief represents a triangle mesh that is set up for geodesic computations, and finds locations, polylines and plane sections
on it.

The mesh is neither copied nor modified; it must outlive the object and must not change meanwhile.

Copies are cheap: they share what was set up of the mesh, which is immutable. With floating point numbers the const member
functions may be called from several threads at once. An object that was moved from has no mesh: it can be destroyed and
assigned to, and functions that need the mesh throw `std::logic_error`.

\tparam Traits a model of `SurfaceMeshGeodesicOffsetTraits`
\tparam VertexIndexMap a model of `ReadablePropertyMap` with `vertex_descriptor` as key and an unsigned integer type as
        value: indices from 0. %Default: the internal map of the mesh, or a map that the constructor makes.
\tparam FaceIndexMap a model of `ReadablePropertyMap` with `face_descriptor` as key and an unsigned integer type as value:
        indices from 0. %Default: the internal map of the mesh, or a map that the constructor makes.
\tparam VertexPointMap a model of `ReadablePropertyMap` with `vertex_descriptor` as key and a 3D point as value.
        %Default: the `vertex_point` map of the mesh.
*/
template <class Traits_, class VertexIndexMap = Default, class FaceIndexMap = Default, class VertexPointMap = Default>
class Geodesic_mesh
{
public:
  /// \name Types
  /// @{

  /// the traits
  typedef Traits_ Traits;
#ifndef DOXYGEN_RUNNING
  typedef typename Geodesic_offset::internal::Checked_traits<Traits_>::type Checked_traits;
#endif
  /// the mesh
  typedef typename Checked_traits::Triangle_mesh Triangle_mesh;
  /// a vertex of the mesh
  typedef typename boost::graph_traits<Triangle_mesh>::vertex_descriptor vertex_descriptor;
  /// a halfedge of the mesh
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor halfedge_descriptor;
  /// an edge of the mesh
  typedef typename boost::graph_traits<Triangle_mesh>::edge_descriptor edge_descriptor;
  /// a face of the mesh
  typedef typename boost::graph_traits<Triangle_mesh>::face_descriptor face_descriptor;

  /// the number type of distances and of coordinates
  typedef typename Checked_traits::FT FT;
  /// a point in space
  typedef typename Checked_traits::Point_3 Point_3;
  /// a vector in space
  typedef typename Checked_traits::Vector_3 Vector_3;
  /// a ray in space
  typedef typename Checked_traits::Kernel::Ray_3 Ray_3;
  /// a plane in space
  typedef typename Checked_traits::Kernel::Plane_3 Plane_3;

  /// barycentric coordinates in a face, the same type as `Polygon_mesh_processing::Barycentric_coordinates`
  typedef std::array<FT, 3> Barycentric_coordinates;
  /// a point of the surface, the same type as `Polygon_mesh_processing::Face_location`: a face, and the coordinates of the
  /// point with respect to the source of the face's halfedge, its target, and the third vertex
  typedef std::pair<face_descriptor, Barycentric_coordinates> Face_location;

  /// a set of sources on the mesh
  typedef Geodesic_source_set<Triangle_mesh, FT> Source_set;
  /// a polyline on the surface
  typedef Geodesic_polyline<Face_location> Polyline;
  /// the result of `plane_section()`
  typedef Geodesic_plane_section<Face_location, vertex_descriptor, edge_descriptor> Plane_section;

#ifdef DOXYGEN_RUNNING
  /// the vertex index map: `VertexIndexMap`, or the type that stands for `Default`
  typedef unspecified_type Vertex_index_map;
  /// the face index map: `FaceIndexMap`, or the type that stands for `Default`
  typedef unspecified_type Face_index_map;
  /// the vertex point map: `VertexPointMap`, or the type that stands for `Default`
  typedef unspecified_type Vertex_point_map;
#else
  typedef typename Default::Lazy_get<VertexIndexMap, Geodesic_offset::internal::Own_vertex_index_map<Triangle_mesh>>::type
    Vertex_index_map;
  typedef
    typename Default::Lazy_get<FaceIndexMap, Geodesic_offset::internal::Own_face_index_map<Triangle_mesh>>::type Face_index_map;
  typedef typename Default::Lazy_get<VertexPointMap, Geodesic_offset::internal::Own_vertex_point_map<Triangle_mesh>>::type
    Vertex_point_map;
#endif
  /// @}

private:
  typedef Geodesic_offset::internal::Geodesic_surface<Checked_traits, Vertex_index_map, Face_index_map, Vertex_point_map>
    Surface;
  typedef Geodesic_offset::internal::Geodesic_mesh_data<Surface> Data;
  typedef typename Data::Located_point Located_point;
  typedef typename Data::Surface_point Surface_point;
  typedef Geodesic_offset::internal::Space_kernel<typename Checked_traits::Kernel> Space_kernel;

  friend struct Geodesic_offset::internal::Mesh_access;

public:
  /// \name Construction
  /// @{

  /*!
  sets up the mesh. Takes time linear in the size of the mesh, and some 250 bytes per vertex. If the indices of a large mesh
  scatter neighbours over memory, vertices and faces are numbered anew internally, which takes little time and saves more
  later.

  \tparam NamedParameters a sequence of named parameters
  \param tm the mesh
  \param np an optional sequence of named parameters among those listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{the points of the vertices}
      \cgalParamType{`VertexPointMap`}
      \cgalParamDefault{`get(boost::vertex_point, tm)`}
      \cgalParamExtra{The points may belong to another kernel than that of the traits: their coordinates are converted.}
    \cgalParamNEnd
    \cgalParamNBegin{edge_length_map}
      \cgalParamDescription{the lengths of the edges, instead of points: the surface need not embed in space}
      \cgalParamType{a model of `ReadablePropertyMap` with `edge_descriptor` as key and a value that is convertible to `FT`}
      \cgalParamDefault{the distances of the points}
      \cgalParamExtra{Functions that need points or normals throw `std::logic_error` then.}
    \cgalParamNEnd
    \cgalParamNBegin{edge_is_constrained_map}
      \cgalParamDescription{whether an edge is a barrier: no path crosses it, see Section
                            \ref SurfaceMeshGeodesicOffsetUseBarriers "Barriers and Regions". The map is read by the constructor only.}
      \cgalParamType{a model of `ReadablePropertyMap` with `edge_descriptor` as key and `bool` as value}
      \cgalParamDefault{no edge is, which costs nothing}
      \cgalParamExtra{Border edges may have either value. With barriers, the object has a second copy of the unfolded mesh.}
    \cgalParamNEnd
    \cgalParamNBegin{geom_traits}
      \cgalParamDescription{the traits}
      \cgalParamType{`Traits`}
      \cgalParamDefault{`Traits()`}
    \cgalParamNEnd
    \cgalParamNBegin{vertex_index_map}
      \cgalParamDescription{the indices of the vertices: numbers from 0 on, no two of them equal}
      \cgalParamType{`VertexIndexMap`}
      \cgalParamDefault{the internal map of the mesh, or a map that is made}
    \cgalParamNEnd
    \cgalParamNBegin{face_index_map}
      \cgalParamDescription{the indices of the faces: numbers from 0 on, no two of them equal}
      \cgalParamType{`FaceIndexMap`}
      \cgalParamDefault{the internal map of the mesh, or a map that is made}
    \cgalParamNEnd
    \cgalParamNBegin{concurrency_tag}
      \cgalParamDescription{whether several threads set up the mesh; they read the mesh and its maps concurrently. The result
                            does not depend on it.}
      \cgalParamType{`Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`}
      \cgalParamDefault{`Sequential_tag`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throws std::invalid_argument if a face is not a triangle with three different vertices, if they are collinear, or if the lengths
          of a face do not satisfy the strict triangle inequality, with the index of the face in the message; if a coordinate
          or a length is not finite; or if the longest edge is not between 1e-77 and 1e77 (1e-9 and 1e9 for `float`), where
          fourth powers of lengths overflow or underflow.
  \throws std::length_error if the mesh has more than 2^29 vertices, or 2^30 faces, counted by the largest index.
  */
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Geodesic_mesh(const Triangle_mesh& tm, const NamedParameters& np = parameters::default_values())
    : Geodesic_mesh(tm, np, Geodesic_offset::internal::More_parameters())
  {
    Geodesic_offset::internal::check_named_parameters<Geodesic_offset::internal::Mesh_parameters, NamedParameters>();
  }

  /// Deleted: the object refers to the mesh, which must not be temporary.
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Geodesic_mesh(const Triangle_mesh&& tm, const NamedParameters& np = parameters::default_values()) = delete;
  /// @}

  /// \name Location
  /// The first hundred calls search all faces, in linear time. Later calls use an AABB tree and take logarithmic time on most
  /// meshes. A call with more than a hundred points builds the tree at once, in the time of some hundred searches. Results do not
  /// depend on the tree: of several faces at the same distance, the location is in the face with the lowest index. Points, but
  /// not rays, may belong to another kernel than that of the traits: their coordinates are converted. If the mesh has no points,
  /// but lengths, these functions throw `std::logic_error`.
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{snapping_tolerance}
  ///     \cgalParamDescription{a location whose distance from a vertex or an edge is at most this length is exactly there}
  ///     \cgalParamType{convertible to `FT`, not negative}
  ///     \cgalParamDefault{the round-off of the coordinates}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// @{

  /// the location nearest to a point in space.
  /// \param p the point
  /// \param np an optional named parameter, `snapping_tolerance`
  /// \throws std::invalid_argument if the mesh has no faces, or a coordinate or its square is not finite, or if the
  ///         tolerance is negative or not a number.
  template <class NamedParameters = parameters::Default_named_parameters>
  Face_location locate(const Point_3& p, const NamedParameters& np = parameters::default_values()) const
  {
    return data().surface().location(data().locator().locate(in_space(p), snapping_tolerance(np)));
  }

  /// Overload for a point of another kernel.
  template <class Point, class NamedParameters = parameters::Default_named_parameters>
  Face_location locate(const Point& p, const NamedParameters& np = parameters::default_values()) const
  {
    return locate(Geodesic_offset::internal::converted_point<Point_3, FT>(p), np);
  }

  /// the location nearest to a point in space, and the distance in space of the point from the location, in the units of the
  /// mesh's points. With a tolerance, the distance can exceed the distance from the surface by no more than the tolerance.
  /// \param p the point
  /// \param np an optional named parameter, `snapping_tolerance`
  /// \throws std::invalid_argument as `locate()`
  template <class NamedParameters = parameters::Default_named_parameters>
  std::pair<Face_location, FT> locate_with_distance(const Point_3& p,
                                                    const NamedParameters& np = parameters::default_values()) const
  {
    const Face_location l = locate(p, np);
    return {l, Geodesic_offset::internal::square_root<FT>((p - data().surface().point(l)).squared_length())};
  }

  /// Overload for a point of another kernel.
  template <class Point, class NamedParameters = parameters::Default_named_parameters>
  std::pair<Face_location, FT> locate_with_distance(const Point& p,
                                                    const NamedParameters& np = parameters::default_values()) const
  {
    return locate_with_distance(Geodesic_offset::internal::converted_point<Point_3, FT>(p), np);
  }

  /// the location where a ray meets the surface first, if it does.
  /// \param r the ray
  /// \param np an optional named parameter, `snapping_tolerance`
  /// \throws std::invalid_argument as the overload for points, and if the ray is degenerate.
  template <class NamedParameters = parameters::Default_named_parameters>
  std::optional<Face_location> locate(const Ray_3& r, const NamedParameters& np = parameters::default_values()) const
  {
    const auto found = data().locator().locate(in_space(r), snapping_tolerance(np));
    if (!found) return std::nullopt;
    return data().surface().location(*found);
  }
  /// @}

  /// \name Polylines, Sections and Edges
  /// If the mesh has no points, but lengths, these functions throw `std::logic_error`, except for `boundary_edges()`.
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{is_closed}
  ///     \cgalParamDescription{whether the last point of a polyline is joined to the first one. The range may repeat the first
  ///                           point at its end.}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`true` if the range repeats its first point at its end, see `polyline_closing()`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// @{

  /// the polyline on the surface through the locations of points in space, which `locate()` finds with its default tolerance.
  /// Consecutive locations without a common face are joined by the shortest path on the surface. A location that repeats the one
  /// before it is left out. The time for a path depends on the number of faces that the path may pass, not on the size of the mesh.
  /// \tparam PointRange a model of `ConstRange` with `Point_3`, or a point of another kernel, as value type
  /// \param points the points
  /// \param np optional named parameters: `is_closed`, and `start_values`, which has a start value for each point
  /// \throws std::invalid_argument if the range is empty, or if there is no path from a point to the next one; and as
  ///         `locate()` does.
  template <class PointRange, class NamedParameters = parameters::Default_named_parameters>
  Polyline locate_polyline(const PointRange& points, const NamedParameters& np = parameters::default_values()) const
  {
    return locate_polyline_with_distance(points, np).first;
  }

  /// the polyline of `locate_polyline()`, and the largest distance in space of a point from its location.
  /// \tparam PointRange a model of `ConstRange` with `Point_3`, or a point of another kernel, as value type
  /// \param points the points
  /// \param np optional named parameters, as for `locate_polyline()`
  /// \throws std::invalid_argument as `locate_polyline()` does.
  template <class PointRange, class NamedParameters = parameters::Default_named_parameters>
  std::pair<Polyline, FT> locate_polyline_with_distance(const PointRange& points,
                                                        const NamedParameters& np = parameters::default_values()) const
  {
    data().locator().expect(std::size_t(std::distance(std::begin(points), std::end(points))));
    const bool repeats_first = polyline_closing(points) == Polyline_closing::CLOSED;
    const bool is_closed = Geodesic_offset::internal::is_closed_of(np, repeats_first);
    std::vector<Face_location> locations;
    FT largest(0);
    for (const auto& p : points)
    {
      const std::pair<Face_location, FT> l = locate_with_distance(p);
      locations.push_back(l.first);
      largest = (std::max)(largest, l.second);
    }
    if (is_closed && repeats_first) locations.pop_back();
    Geodesic_offset::internal::check_named_parameters<Geodesic_offset::internal::Joining_parameters, NamedParameters>();
    const std::size_t n = locations.size() + (is_closed && repeats_first ? 1 : 0);
    std::vector<FT> starts = Geodesic_offset::internal::start_values_of<FT>(np, n);
    if (starts.empty()) return {join_polyline(locations, parameters::is_closed(is_closed)), largest};
    Geodesic_offset::internal::drop_repeated_start_value(starts, locations.size());
    return {join_polyline(locations, parameters::is_closed(is_closed).start_values(std::cref(starts))), largest};
  }

  /// the polyline on the surface through locations. Overload of `locate_polyline()` for points that are on the surface.
  /// \tparam FaceLocationRange a model of `ConstRange` with `Face_location`, or a location with the coordinates of another kernel,
  ///         as value type
  /// \param locations the points
  /// \param np optional named parameters, as for `locate_polyline()`
  /// \throws std::invalid_argument as `locate_polyline()` does, and if a location is not valid.
  template <class FaceLocationRange, class NamedParameters = parameters::Default_named_parameters>
  Polyline join_polyline(const FaceLocationRange& locations, const NamedParameters& np = parameters::default_values()) const
  {
    Geodesic_offset::internal::check_named_parameters<Geodesic_offset::internal::Joining_parameters, NamedParameters>();
    constexpr bool has_points = Geodesic_offset::internal::has_points_in_space<FaceLocationRange>;
    static_assert(!has_points, "join_polyline() needs locations on the surface; locate_polyline() accepts points in space");
    const Surface& surface = data().surface_with_points();
    const Geodesic_offset::internal::Polyline_joining<typename Surface::Computing_traits, Space_kernel> joining(
      data().unfolded(), surface, data().traits);
    std::vector<Geodesic_offset::internal::Path_crossing<typename Surface::Number>> passed;
    Polyline polyline;
    std::vector<Face_location> given_locations;
    std::vector<Point_3> points;
    for (const auto& l : locations)
    {
      if constexpr (!has_points) given_locations.push_back(Geodesic_offset::internal::converted_location<FT>(l));
      data().classified(given_locations.back()); // throws if it is not valid
      points.push_back(surface.point(given_locations.back()));
    }
    std::vector<FT> given_starts = Geodesic_offset::internal::start_values_of<FT>(np, given_locations.size());
    const bool repeats_first = polyline_closing(points) == Polyline_closing::CLOSED;
    const bool is_closed = Geodesic_offset::internal::is_closed_of(np, repeats_first);
    if (is_closed && repeats_first) given_locations.pop_back();
    Geodesic_offset::internal::drop_repeated_start_value(given_starts, given_locations.size());
    std::optional<Located_point> last;
    std::size_t i = 0;
    const auto add = [&](const Face_location& given) {
      auto& path = polyline.locations;
      const Located_point p = data().classified(given);
      const Face_location l = snapped(given, p);
      const bool is_repeated = last && surface.point(path.back()) == surface.point(l);
      if (is_repeated && (given_starts.empty() || given_starts[i] == polyline.start_values.back())) return;
      passed.clear();
      if (last && !is_repeated && !joining.join(*last, p, passed))
        throw std::invalid_argument("Surface_mesh_geodesic_offset: there is no path on the surface to point " +
                                    std::to_string(i) + " of a polyline from the one before");
      for (const auto& c : passed) path.push_back(surface.location_of_element(c));
      path.push_back(l);
      if (!given_starts.empty()) add_start_values(given_starts[i], polyline);
      last = p;
    };
    for (const Face_location& l : given_locations)
    {
      add(l);
      ++i;
    }
    if (!last) throw std::invalid_argument("Surface_mesh_geodesic_offset: a polyline without points");
    if (is_closed)
    {
      i = 0;
      add(Face_location(polyline.locations.front()));
      if (polyline.locations.size() > 1) polyline.locations.pop_back();
      if (polyline.locations.size() > 1)
      { // the path to a last point that is the first one in space may end at the vertex that is the first one
        const Located_point p = data().classified(polyline.locations.front()), q = data().classified(polyline.locations.back());
        if (p.kind == Located_point::VERTEX && q.kind == p.kind && q.element == p.element) polyline.locations.pop_back();
      }
      polyline.start_values.resize(given_starts.empty() ? 0 : polyline.locations.size());
      polyline.is_closed = polyline.locations.size() > 2;
    }
    return polyline;
  }

  /// the section of the mesh by a plane. A predicate of the kernel decides on which side of the plane each vertex lies: with
  /// exact predicates, the sequence of edges and vertices that the section crosses is exact, and only the positions of its
  /// points on the edges are rounded. Takes time linear in the size of the mesh.
  /// \throws std::invalid_argument if the plane is degenerate, or a coefficient is not finite.
  Plane_section plane_section(const Plane_3& plane) const
  {
    for (const FT& c : {plane.a(), plane.b(), plane.c(), plane.d()})
      if (!Geodesic_offset::internal::Number_policy<FT>::is_finite(CGAL::abs(c)))
        throw std::invalid_argument("Surface_mesh_geodesic_offset: a plane with a coefficient that is not finite");
    if (plane.is_degenerate()) throw std::invalid_argument("Surface_mesh_geodesic_offset: a degenerate plane");
    return Geodesic_offset::internal::Plane_cutting<Surface, Plane_3>(data().surface_with_points(), plane)();
  }

  /// writes the sharp edges: the edges between two faces whose normals differ by more than `angle` degrees. The difference is
  /// 0 where the surface is flat, 90 at the edges of a cube, and 180 where the surface folds back onto itself. Border edges are
  /// not sharp. Takes time linear in the size of the mesh.
  /// \param angle in degrees, from 0 to less than 180. Angles are rounded to `double`: with 0, edges in a plane with
  ///        rounded coordinates are sharp, too.
  /// \param out an output iterator for `edge_descriptor`
  /// \throws std::invalid_argument if the angle is negative, 180 or more, or not a number.
  template <class OutputIterator>
  OutputIterator sharp_edges(double angle, OutputIterator out) const
  {
    if (!(angle >= 0 && angle < 180))
      throw std::invalid_argument("Surface_mesh_geodesic_offset: the angle of sharp edges is not a number of degrees from 0 "
                                  "to less than 180");
    const Surface& surface = data().surface_with_points();
    for (const edge_descriptor e : edges(surface.tm))
    {
      const halfedge_descriptor h = halfedge(e, surface.tm);
      if (is_border_edge(h, surface.tm)) continue;
      if (Geodesic_offset::internal::angle_of_normals(surface, h) > angle) *out++ = e;
    }
    return out;
  }

  /// the edges of each boundary cycle of the surface. Edges without a face are left out, and so are cycles of such edges. Takes
  /// time linear in the size of the mesh.
  std::vector<std::vector<edge_descriptor>> boundary_edges() const
  {
    std::vector<halfedge_descriptor> cycles;
    Polygon_mesh_processing::extract_boundary_cycles(data().surface().tm, std::back_inserter(cycles));
    std::vector<std::vector<edge_descriptor>> result;
    for (const halfedge_descriptor h : cycles)
      if (std::vector<edge_descriptor> cycle = edges_of_cycle(h); !cycle.empty()) result.push_back(std::move(cycle));
    return result;
  }

  /// the edges of one boundary cycle, that of a border halfedge. Edges without a face are left out.
  /// \throws std::invalid_argument if the halfedge is not a border halfedge, or if it is null, removed or of another mesh.
  std::vector<edge_descriptor> boundary_edges(halfedge_descriptor border) const
  {
    data().surface().check_halfedge(border);
    if (!is_border(border, data().surface().tm))
      throw std::invalid_argument("Surface_mesh_geodesic_offset: the halfedge of a boundary cycle is not on the border");
    return edges_of_cycle(border);
  }

  /// the inner sides of all closed polylines of a set, by their ids; polylines as short as a point have none. Each polyline is taken by
  /// itself. Takes time linear in the size of the mesh and of the polylines, and per polyline linear in the number of regions into
  /// which all polylines together divide the vertices of the surface. Computes in `double`, also with exact number types.
  /// \throws std::invalid_argument if a source does not fit the mesh
  std::map<std::size_t, Geodesic_inner_side> inner_sides(const Source_set& sources) const
  {
    namespace internal = Geodesic_offset::internal;
    return internal::Inner_sides<typename Surface::Number>(data().unfolded(), internal::classified_sources(data(), sources))();
  }
  /// @}

  /// \name Access
  /// @{

  /// the mesh.
  const Triangle_mesh& triangle_mesh() const { return data().surface().tm; }

  /// the mean length of the edges of all faces, up to rounding: an edge of two faces counts twice. 1 if there are no faces.
  double mean_edge_length() const { return data().unfolded().mean_edge_length(); }
  /// @}

private:
  template <class NamedParameters>
  Geodesic_mesh(const Triangle_mesh& tm, const NamedParameters& np, Geodesic_offset::internal::More_parameters)
    : m_data(std::make_shared<const Data>(tm, vertex_index_map(tm, np), face_index_map(tm, np), vertex_point_map(tm, np), np))
  {
  }

  // \throws std::logic_error if the object was moved from
  const Data& data() const
  {
    if (!m_data) throw std::logic_error("Surface_mesh_geodesic_offset: this object was moved from, it has no mesh");
    return *m_data;
  }

  template <class NamedParameters>
  static Vertex_index_map vertex_index_map(const Triangle_mesh& tm, const NamedParameters& np)
  {
    if constexpr (Geodesic_offset::internal::has_parameter<internal_np::vertex_index_t, NamedParameters>)
      return Geodesic_offset::internal::converted_map<Vertex_index_map>(
        parameters::get_parameter(np, internal_np::vertex_index));
    else return (void)np, get_initialized_vertex_index_map(tm);
  }

  template <class NamedParameters>
  static Face_index_map face_index_map(const Triangle_mesh& tm, const NamedParameters& np)
  {
    if constexpr (Geodesic_offset::internal::has_parameter<internal_np::face_index_t, NamedParameters>)
      return Geodesic_offset::internal::converted_map<Face_index_map>(parameters::get_parameter(np, internal_np::face_index));
    else return (void)np, get_initialized_face_index_map(tm);
  }

  template <class NamedParameters>
  static Vertex_point_map vertex_point_map(const Triangle_mesh& tm, const NamedParameters& np)
  {
    if constexpr (Geodesic_offset::internal::has_parameter<internal_np::vertex_point_t, NamedParameters>)
      return Geodesic_offset::internal::converted_map<Vertex_point_map>(
        parameters::get_parameter(np, internal_np::vertex_point));
    else return (void)np, get(boost::vertex_point, tm);
  }

  // Points and rays of the kernel of the locator.
  static decltype(auto) in_space(const Point_3& p)
  {
    return Geodesic_offset::internal::converted_point<typename Space_kernel::Point_3, FT>(p);
  }
  static typename Space_kernel::Ray_3 in_space(const Ray_3& r)
  {
    const Vector_3 v = r.to_vector();
    if constexpr (std::is_same<Ray_3, typename Space_kernel::Ray_3>::value) return r;
    else return typename Space_kernel::Ray_3(in_space(r.source()), typename Space_kernel::Vector_3(v.x(), v.y(), v.z()));
  }

  template <class NamedParameters>
  FT snapping_tolerance(const NamedParameters& np) const
  {
    namespace internal = Geodesic_offset::internal;
    internal::check_named_parameters<internal::Location_parameters, NamedParameters>();
    if constexpr (internal::has_parameter<internal_np::snapping_tolerance_t, NamedParameters>)
      return FT(parameters::get_parameter(np, internal_np::snapping_tolerance));
    else return (void)np, FT(data().locator().default_tolerance());
  }

  // Adds the start values of the points that have been added behind the last one that has a value, linear in the length of the path to
  // the last point, whose value is given.
  void add_start_values(const FT& start, Polyline& polyline) const
  {
    const auto& path = polyline.locations;
    std::vector<FT>& starts = polyline.start_values;
    const FT before = starts.empty() ? start : starts.back();
    std::vector<FT> ways(1, FT(0)); // from the point before
    for (std::size_t k = (std::max)(starts.size(), std::size_t(1)); k < path.size(); ++k)
    {
      const Point_3 p = data().surface().point(path[k - 1]), q = data().surface().point(path[k]);
      ways.push_back(ways.back() + Geodesic_offset::internal::square_root<FT>(CGAL::squared_distance(p, q)));
    }
    for (std::size_t k = 1; k + 1 < ways.size(); ++k) starts.push_back(before + (ways[k] / ways.back()) * (start - before));
    starts.push_back(start);
  }

  // The location of a classified point, exactly on the edge or at the vertex; the given one if it is there already.
  Face_location snapped(const Face_location& given, const Located_point& p) const
  {
    const auto zeros = std::count(given.second.begin(), given.second.end(), FT(0));
    const int needed = p.kind == Surface_point::VERTEX ? 2 : p.kind == Surface_point::EDGE ? 1 : 0;
    return zeros == needed ? given : data().surface().location(p);
  }

  // The edges of the cycle that have a face on the other side of the border.
  std::vector<edge_descriptor> edges_of_cycle(halfedge_descriptor border) const
  {
    const Triangle_mesh& tm = data().surface().tm;
    std::vector<edge_descriptor> edges;
    for (const halfedge_descriptor h : halfedges_around_face(border, tm))
      if (!is_border(opposite(h, tm), tm)) edges.push_back(edge(h, tm));
    return edges;
  }

  std::shared_ptr<const Data> m_data;
};

} // namespace CGAL

#endif
