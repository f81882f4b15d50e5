// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_SOURCES_H
#define CGAL_SURFACE_MESH_GEODESIC_SOURCES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_plane_section.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_offset_traits.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Geodesic_surface.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Normal_angle.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_locator.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Polyline_joining.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Plane_cutting.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Source_set.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

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

\brief holds a triangle mesh and a set of sources on it: points, polylines, and edges. Base of the classes that compute
distances and offset curves.

The mesh is neither copied nor modified; it must outlive the object and must not change meanwhile.

Copies share what was set up of the mesh. An object that was moved from has no mesh: it can be destroyed and assigned to, and
functions that need the mesh throw `std::logic_error`.

\tparam Traits a model of `SurfaceMeshGeodesicOffsetTraits`
\tparam VertexIndexMap a model of `ReadablePropertyMap` with `vertex_descriptor` as key and an unsigned integer type as
        value: indices from 0. %Default: the internal map of the mesh, or a map that the constructor makes.
\tparam FaceIndexMap a model of `ReadablePropertyMap` with `face_descriptor` as key and an unsigned integer type as value:
        indices from 0. %Default: the internal map of the mesh, or a map that the constructor makes.
\tparam VertexPointMap a model of `ReadablePropertyMap` with `vertex_descriptor` as key and a 3D point as value.
        %Default: the `vertex_point` map of the mesh.
*/
template <class Traits, class VertexIndexMap = Default, class FaceIndexMap = Default, class VertexPointMap = Default>
class Surface_mesh_geodesic_sources
{
public:
#ifndef DOXYGEN_RUNNING
  typedef boost::graph_traits<typename Traits::Triangle_mesh> Graph_traits;
#endif

  /// \name Types
  /// @{

  /// the mesh
  typedef typename Traits::Triangle_mesh Triangle_mesh;
  /// a vertex of the mesh
  typedef typename boost::graph_traits<Triangle_mesh>::vertex_descriptor vertex_descriptor;
  /// a halfedge of the mesh
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor halfedge_descriptor;
  /// an edge of the mesh
  typedef typename boost::graph_traits<Triangle_mesh>::edge_descriptor edge_descriptor;
  /// a face of the mesh
  typedef typename boost::graph_traits<Triangle_mesh>::face_descriptor face_descriptor;

  /// the number type of distances and of coordinates
  typedef typename Traits::FT FT;
  /// a point in space
  typedef typename Traits::Point_3 Point_3;
  /// a vector in space
  typedef typename Traits::Vector_3 Vector_3;
  /// a ray in space
  typedef typename Traits::Kernel::Ray_3 Ray_3;
  /// a plane in space
  typedef typename Traits::Kernel::Plane_3 Plane_3;

  /// barycentric coordinates in a face, the same type as `Polygon_mesh_processing::Barycentric_coordinates`
  typedef std::array<FT, 3> Barycentric_coordinates;
  /// a point of the surface, the same type as `Polygon_mesh_processing::Face_location`: a face, and the coordinates of the
  /// point with respect to the source of the face's halfedge, its target, and the third vertex
  typedef std::pair<face_descriptor, Barycentric_coordinates> Face_location;

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
  typedef typename Default::Get<VertexIndexMap, typename GetInitializedVertexIndexMap<Triangle_mesh>::const_type>::type
    Vertex_index_map;
  typedef typename Default::Get<FaceIndexMap, typename GetInitializedFaceIndexMap<Triangle_mesh>::const_type>::type
    Face_index_map;
  typedef typename Default::Get<
    VertexPointMap, typename boost::property_map<Triangle_mesh, boost::vertex_point_t>::const_type>::type
    Vertex_point_map;
#endif
  /// @}

protected:
  typedef Geodesic_offset::internal::Geodesic_surface<Traits, Vertex_index_map, Face_index_map, Vertex_point_map>
    Surface;
  typedef typename Surface::Computing_traits Computing_traits;
  typedef typename Surface::Number Number;
  typedef Geodesic_offset::internal::Surface_point<Number> Surface_point;
  typedef Geodesic_offset::internal::Located_point<Number> Located_point;
  typedef Geodesic_offset::internal::Source_set<Number> Source_set;
  typedef Geodesic_offset::internal::Index Index;

public:
  /// \name Construction
  /// Construction takes time linear in the size of the mesh, and some 250 bytes per vertex. If the indices of a large mesh
  /// scatter neighbours over memory, the object numbers vertices and faces anew internally, which takes little time and saves
  /// more later.
  /// @{

  /// sets up the mesh, with the points and the index maps of the mesh.
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
  /// \param tm the mesh
  /// \param traits the traits
  /// \param tag whether several threads set up the mesh; these read the mesh and its maps concurrently
  /// \pre All faces of `tm` are triangles with three different vertices that are not collinear.
  /// \throws std::invalid_argument if the precondition does not hold, with the index of the face in the message; if a
  ///         coordinate is not finite; or if the longest edge is not between 1e-77 and 1e77 (1e-9 and 1e9 for `float`), where
  ///         fourth powers of lengths overflow or underflow.
  /// \throws std::length_error if the mesh has more than 2^29 vertices, or 2^30 faces, counted by the largest index.
  template <class ConcurrencyTag = Sequential_tag>
  explicit Surface_mesh_geodesic_sources(const Triangle_mesh& tm, const Traits& traits = Traits(),
                                         const ConcurrencyTag& tag = ConcurrencyTag())
    : Surface_mesh_geodesic_sources(tm, get_initialized_vertex_index_map(tm), get_initialized_face_index_map(tm),
                                    get(boost::vertex_point, tm), traits, tag)
  {
  }

  /// sets up the mesh with the points of another map, and with the index maps of the mesh. For instance, with moved points:
  /// \code
  /// CGAL::Surface_mesh_geodesic_offset<Traits, CGAL::Default, CGAL::Default, Moved_points> geodesic(mesh, moved_points);
  /// \endcode
  template <class ConcurrencyTag = Sequential_tag>
  Surface_mesh_geodesic_sources(const Triangle_mesh& tm, Vertex_point_map vertex_point_map, const Traits& traits = Traits(),
                                const ConcurrencyTag& tag = ConcurrencyTag())
    : Surface_mesh_geodesic_sources(tm, get_initialized_vertex_index_map(tm), get_initialized_face_index_map(tm),
                                    vertex_point_map, traits, tag)
  {
  }

  /// sets up the mesh with other maps. The indices in an index map are numbers from 0 on, and no two vertices, or faces, have
  /// the same index.
  template <class ConcurrencyTag = Sequential_tag>
  Surface_mesh_geodesic_sources(const Triangle_mesh& tm, Vertex_index_map vertex_index_map, Face_index_map face_index_map,
                                Vertex_point_map vertex_point_map, const Traits& traits = Traits(),
                                const ConcurrencyTag& = ConcurrencyTag())
    : m_traits(Geodesic_offset::internal::Computation<Traits>::computing_traits(traits))
  {
    static_assert(std::is_convertible<ConcurrencyTag, Sequential_tag>::value, "the last argument must be a concurrency tag");
    {
      auto&& team = Geodesic_offset::internal::Concurrency<ConcurrencyTag, Number>::Team::make();
      m_surface = std::make_shared<Surface>(tm, vertex_index_map, face_index_map, vertex_point_map, traits, team);
    }
    m_locator = std::make_shared<Geodesic_offset::internal::Surface_locator<Surface>>(m_surface);
  }
  /// @}

  /// \name Sources
  /// Each function that adds a source returns its id: 0, 1, 2, ... Ids of removed sources are not used again.
  /// @{

  /// adds a vertex.
  /// \pre The vertex belongs to the mesh.
  /// \throws std::invalid_argument if the vertex is null, or if its index is out of range.
  std::size_t add_source_point(vertex_descriptor v)
  {
    return m_sources.add(unfolded(), {classified(v)}, Source_set::POINT);
  }

  /// adds a point anywhere on the surface. The coordinates are divided by their sum. If one of them is zero up to round-off
  /// (1e-13), the point is on the edge; if two are, it is at the vertex.
  /// \throws std::invalid_argument if the coordinates are not finite, if they are outside the face, or if their sum is not
  ///         positive.
  std::size_t add_source_point(const Face_location& location)
  {
    return m_sources.add(unfolded(), {classified(location)}, Source_set::POINT);
  }

  /// adds each point of a range as a source of its own.
  /// \return the ids of the sources, in the order of the range
  /// \tparam LocationRange a model of `ConstRange` with `vertex_descriptor` or `Face_location` as value type
  /// \throws std::invalid_argument as `add_source_point()` does; no point has been added then.
  template <class LocationRange>
  std::vector<std::size_t> add_source_points(const LocationRange& locations)
  {
    std::vector<Surface_point> points;
    for (const auto& l : locations) points.push_back(classified(l));
    std::vector<std::size_t> ids;
    for (const Surface_point& p : points) ids.push_back(m_sources.add(unfolded(), {p}, Source_set::POINT));
    return ids;
  }

  /// adds a polyline whose vertices lie anywhere on the surface, and each of whose segments is straight within one closed
  /// face. The polyline may cross itself and other sources. Repeated points are allowed; a polyline of one point is a point.
  ///
  /// \tparam FaceLocationRange a model of `ConstRange` with `Face_location` as value type
  /// \param closed whether the last point is joined to the first one
  /// \throws std::invalid_argument if the range is empty, or if two consecutive points have no face in common.
  template <class FaceLocationRange>
  std::size_t add_source_polyline(const FaceLocationRange& locations, bool closed = false)
  {
    std::vector<Surface_point> points;
    for (const Face_location& l : locations) points.push_back(classified(l));
    return m_sources.add(unfolded(), std::move(points), closed ? Source_set::CLOSED_POLYLINE : Source_set::OPEN_POLYLINE);
  }

  /// adds a set of edges.
  /// \tparam EdgeRange a model of `ConstRange` with `edge_descriptor` as value type
  /// \pre The edges belong to the mesh.
  /// \throws std::invalid_argument if the range is empty, or if an edge has no face, or if an edge is null or of another mesh.
  ///         An edge of another mesh that has the descriptor of an edge of this mesh, an index for instance, is that edge. If
  ///         there is an exception, nothing is added.
  template <class EdgeRange>
  std::size_t add_source_edges(const EdgeRange& edges)
  {
    std::vector<Index> halfedges;
    for (const edge_descriptor e : edges) halfedges.push_back(surface().index_beside_edge(halfedge(e, surface().tm)));
    return m_sources.add_edges(unfolded(), std::move(halfedges));
  }

  /// adds the boundary of the surface: one source, a set of edges, per boundary cycle. Edges without a face are left out. Takes
  /// time linear in the size of the mesh.
  /// \return the ids of the sources; no ids if the surface has no boundary
  std::vector<std::size_t> add_source_boundary()
  {
    std::vector<halfedge_descriptor> cycles;
    Polygon_mesh_processing::extract_boundary_cycles(surface().tm, std::back_inserter(cycles));
    std::vector<std::size_t> ids;
    for (const halfedge_descriptor h : cycles)
      if (const std::vector<edge_descriptor> cycle = edges_of_cycle(h); !cycle.empty()) ids.push_back(add_source_edges(cycle));
    return ids;
  }

  /// adds one boundary cycle, that of a border halfedge: a set of edges. Edges without a face are left out.
  /// \pre The halfedge belongs to the mesh.
  /// \throws std::invalid_argument if the halfedge is not a border halfedge, or is null, or if no edge of the cycle has a face.
  std::size_t add_source_boundary(halfedge_descriptor border)
  {
    surface().check_halfedge(border);
    if (!is_border(border, surface().tm))
      throw std::invalid_argument("Surface_mesh_geodesic_offset: the halfedge of a boundary cycle is not on the border");
    return add_source_edges(edges_of_cycle(border));
  }

  /// adds the edges that `sharp_edges()` finds, as one source.
  /// \return the id of the source; empty if there is no such edge
  /// \throws std::invalid_argument as `sharp_edges()` does.
  std::optional<std::size_t> add_source_sharp_edges(double angle)
  {
    std::vector<edge_descriptor> edges;
    sharp_edges(angle, std::back_inserter(edges));
    if (edges.empty()) return std::nullopt;
    return add_source_edges(edges);
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
    const Triangle_mesh& tm = surface().tm;
    for (const edge_descriptor e : edges(tm))
    {
      const halfedge_descriptor h = halfedge(e, tm);
      if (is_border_edge(h, tm)) continue;
      if (Geodesic_offset::internal::angle_of_normals(surface(), h) > angle) *out++ = e;
    }
    return out;
  }

  /// adds the section of the mesh by a plane: each polyline of the section; the edges that the plane only touches, as one set of
  /// edges, which has no sides; and each vertex that the plane only touches.
  /// \return the ids of these sources, in this order; no ids if the plane misses the mesh.
  /// \throws std::invalid_argument as `plane_section()` does.
  std::vector<std::size_t> add_source_plane_section(const Plane_3& plane)
  {
    const Plane_section section = plane_section(plane);
    std::vector<std::size_t> ids;
    for (const auto& polyline : section.polylines)
      ids.push_back(add_source_polyline(polyline.locations, polyline.is_closed));
    if (!section.touched_edges.empty()) ids.push_back(add_source_edges(section.touched_edges));
    for (const vertex_descriptor v : section.touched_vertices) ids.push_back(add_source_point(v));
    return ids;
  }

  /// removes a source.
  /// \throws std::invalid_argument if there is no source with this id.
  void remove_source(std::size_t id) { m_sources.remove(id); }

  /// removes all sources.
  void clear_sources() { m_sources.clear(); }

  /// the number of sources.
  std::size_t number_of_sources() const { return m_sources.size(); }
  /// @}

  /// \name Location
  /// The first hundred calls search all faces, in linear time. Further calls use an AABB tree and take logarithmic time on most
  /// meshes; a call with more than a hundred points builds the tree at once, in the time of some hundred searches. The results
  /// do not depend on the tree: of several faces at the same distance, the location is in the face with the lowest index. A
  /// location whose distance from a vertex or an edge is at most `tolerance`, a length that is not negative, is exactly there;
  /// the default tolerance is the round-off of the coordinates.
  /// @{

  /// the location nearest to a point in space.
  /// \throws std::invalid_argument if the mesh has no faces, or a coordinate or its square is not finite, or if the
  ///         tolerance is negative or not a number.
  Face_location locate(const Point_3& p) const { return locate(p, locator().default_tolerance()); }
  /// Overload with a tolerance.
  Face_location locate(const Point_3& p, const FT& tolerance) const { return locator().locate(p, tolerance); }

  /// the location nearest to a point in space, and the distance in space of the point from the location, in the units of the
  /// mesh's points. With a tolerance, the distance can exceed the distance from the surface by no more than the tolerance.
  std::pair<Face_location, FT> locate_with_distance(const Point_3& p) const
  {
    return locate_with_distance(p, locator().default_tolerance());
  }
  /// Overload with a tolerance.
  std::pair<Face_location, FT> locate_with_distance(const Point_3& p, const FT& tolerance) const
  {
    const Face_location l = locate(p, tolerance);
    return {l, Geodesic_offset::internal::square_root<FT>((p - surface().point(l)).squared_length())};
  }

  /// the location where a ray meets the surface first; if the ray misses the surface, a location whose face is the null face.
  /// \throws std::invalid_argument as the overload for points, and if the ray is degenerate.
  Face_location locate(const Ray_3& r) const { return locate(r, locator().default_tolerance()); }
  /// Overload with a tolerance.
  Face_location locate(const Ray_3& r, const FT& tolerance) const { return locator().locate(r, tolerance); }
  /// @}

  /// \name Polylines and Sections
  /// @{

  /// the polyline on the surface through the locations of points in space. Consecutive locations without a common face are
  /// joined by the shortest path on the surface. A location that repeats the one before it is left out. The time for a path
  /// depends on the number of faces that the path may pass, not on the size of the mesh.
  /// \tparam PointRange a model of `ConstRange` with `Point_3` as value type
  /// \param closed whether the last point is joined to the first one. The range may repeat the first point at its end.
  /// \throws std::invalid_argument if the range is empty, or if there is no path from a point to the next one; and as
  ///         `locate()` does.
  template <class PointRange>
  Polyline locate_polyline(const PointRange& points, bool closed = false) const
  {
    return locate_polyline_with_distance(points, closed).first;
  }

  /// the polyline of `locate_polyline()`, and the largest distance in space of a point from its location.
  /// \tparam PointRange a model of `ConstRange` with `Point_3` as value type
  /// \param points the points
  /// \param closed whether the last point is joined to the first one. The range may repeat the first point at its end.
  /// \throws std::invalid_argument as `locate_polyline()` does.
  template <class PointRange>
  std::pair<Polyline, FT> locate_polyline_with_distance(const PointRange& points, bool closed = false) const
  {
    locator().expect(std::size_t(std::distance(std::begin(points), std::end(points))));
    std::vector<Face_location> locations;
    FT largest(0);
    for (const Point_3& p : points)
    {
      const std::pair<Face_location, FT> l = locate_with_distance(p);
      locations.push_back(l.first);
      largest = (std::max)(largest, l.second);
    }
    return {join_polyline(locations, closed), largest};
  }

  /// the polyline on the surface through locations. Overload of `locate_polyline()` for points that are on the surface.
  /// \tparam FaceLocationRange a model of `ConstRange` with `Face_location` as value type
  template <class FaceLocationRange>
  Polyline join_polyline(const FaceLocationRange& locations, bool closed = false) const
  {
    const Geodesic_offset::internal::Polyline_joining<Surface> join(surface(), m_traits);
    Polyline polyline;
    std::optional<Located_point> last;
    std::size_t i = 0;
    const auto add = [&](const Face_location& given) {
      auto& path = polyline.locations;
      const Located_point p = classified(given);
      const Face_location l = snapped(given, p);
      if (last && surface().point(path.back()) == surface().point(l)) return;
      if (last && !join(*last, p, path))
        throw std::invalid_argument("Surface_mesh_geodesic_offset: there is no path on the surface to point " +
                                    std::to_string(i) + " of a polyline from the one before");
      path.push_back(l);
      last = p;
    };
    for (const Face_location& l : locations)
    {
      add(l);
      ++i;
    }
    if (!last) throw std::invalid_argument("Surface_mesh_geodesic_offset: a polyline without points");
    if (closed)
    {
      i = 0;
      add(Face_location(polyline.locations.front()));
      if (polyline.locations.size() > 1) polyline.locations.pop_back();
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
    return Geodesic_offset::internal::Plane_cutting<Surface, Plane_3>(surface(), plane)();
  }
  /// @}

protected:
  // \throws std::logic_error if the object was moved from, as all that needs the mesh
  const Surface& surface() const
  {
    if (!m_surface) throw std::logic_error("Surface_mesh_geodesic_offset: this object was moved from, it has no mesh");
    return *m_surface;
  }

  const Geodesic_offset::internal::Unfolded_mesh<Number>& unfolded() const { return surface().unfolded; }

  Located_point classified(vertex_descriptor v) const
  {
    const bool is_null = v == Graph_traits::null_vertex();
    const Index i = is_null ? Geodesic_offset::internal::no_index : surface().index_of(v);
    if (!(i < unfolded().number_of_vertices()))
      throw std::invalid_argument("Surface_mesh_geodesic_offset: a vertex that is not of this mesh");
    return Surface_point::at_vertex(i);
  }
  Located_point classified(const Face_location& l) const
  {
    const auto name = [&] { return surface().numbers.index_in_mesh(l.first); };
    return Geodesic_offset::internal::classify<Number>(unfolded(), surface().index_of(l.first), name,
                                                       Surface::imported(l.second));
  }

  Computing_traits m_traits;
  std::shared_ptr<const Surface> m_surface;
  Source_set m_sources;

private:
  // The location of a classified point, exactly on the edge or at the vertex; the given one if it is there already.
  Face_location snapped(const Face_location& given, const Located_point& p) const
  {
    const auto zeros = std::count(given.second.begin(), given.second.end(), FT(0));
    const int needed = p.kind == Surface_point::VERTEX ? 2 : p.kind == Surface_point::EDGE ? 1 : 0;
    return zeros == needed ? given : surface().location(p);
  }

  // Those that have a face on the other side of the border.
  std::vector<edge_descriptor> edges_of_cycle(halfedge_descriptor border) const
  {
    const Triangle_mesh& tm = surface().tm;
    std::vector<edge_descriptor> edges;
    for (const halfedge_descriptor h : halfedges_around_face(border, tm))
      if (!is_border(opposite(h, tm), tm)) edges.push_back(edge(h, tm));
    return edges;
  }

  const Geodesic_offset::internal::Surface_locator<Surface>& locator() const
  {
    surface(); // or an exception
    return *m_locator;
  }

  std::shared_ptr<const Geodesic_offset::internal::Surface_locator<Surface>> m_locator;
};

} // namespace CGAL

#endif
