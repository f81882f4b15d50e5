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

\brief a triangle mesh and a set of sources on it: points, polylines, and edges. The base of the classes that compute
distances and offsets from them.

The mesh is not copied and not modified; it must outlive the object and must not change meanwhile.

\tparam Traits a model of `SurfaceMeshGeodesicOffsetTraits`
\tparam VertexIndexMap a model of `ReadablePropertyMap` with `vertex_descriptor` as key and an unsigned integer type as
        value: indices from 0. %Default: the mesh's internal map, or one made for it.
\tparam FaceIndexMap the same for faces
\tparam VertexPointMap a model of `ReadablePropertyMap` with `vertex_descriptor` as key and a 3D point as value.
        %Default: the mesh's `vertex_point`.
*/
template <class Traits, class VertexIndexMap = Default, class FaceIndexMap = Default, class VertexPointMap = Default>
class Surface_mesh_geodesic_sources
{
public:
  typedef typename Traits::Triangle_mesh Triangle_mesh;
  typedef boost::graph_traits<Triangle_mesh> Graph_traits;

  /// \name Types
  /// @{
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  typedef typename Traits::FT FT;
  typedef typename Traits::Point_3 Point_3;
  typedef typename Traits::Vector_3 Vector_3;
  typedef typename Traits::Kernel::Ray_3 Ray_3;
  typedef typename Traits::Kernel::Plane_3 Plane_3;

  /// as `Polygon_mesh_processing::Barycentric_coordinates`
  typedef std::array<FT, 3> Barycentric_coordinates;
  /// as `Polygon_mesh_processing::Face_location`: a face and coordinates with respect to the source of the face's
  /// halfedge, its target, and the third vertex
  typedef std::pair<face_descriptor, Barycentric_coordinates> Face_location;

  /// a polyline on the surface
  typedef Geodesic_polyline<Face_location> Polyline;
  /// the answer of `plane_section()`
  typedef Geodesic_plane_section<Face_location, vertex_descriptor> Plane_section;

  typedef typename Default::Get<VertexIndexMap, typename GetInitializedVertexIndexMap<Triangle_mesh>::const_type>::type
    Vertex_index_map;
  typedef typename Default::Get<FaceIndexMap, typename GetInitializedFaceIndexMap<Triangle_mesh>::const_type>::type
    Face_index_map;
  typedef typename Default::Get<
    VertexPointMap, typename boost::property_map<Triangle_mesh, boost::vertex_point_t>::const_type>::type
    Vertex_point_map;

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
  /// Takes time linear in the size of the mesh, and some 250 bytes a vertex. If the indices of a large mesh scatter
  /// neighbours, vertices and faces are numbered anew inside, which takes little time and saves more later.
  /// @{

  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
  /// \param tm the mesh
  /// \param traits the traits
  /// \param tag whether several threads work, which read the mesh and its maps at once
  /// \pre All faces of `tm` are triangles with three different vertices that are not collinear.
  /// \throws std::invalid_argument that names the face if that is not so, or if a coordinate is not finite; and if the
  ///         longest edge is not between 1e-77 and 1e77 (1e-9 and 1e9 for `float`), where fourth powers of lengths get lost.
  /// \throws std::length_error if the mesh has more than 2^29 vertices, or 2^30 faces, counted by the largest index.
  template <class ConcurrencyTag = Sequential_tag>
  explicit Surface_mesh_geodesic_sources(const Triangle_mesh& tm, const Traits& traits = Traits(),
                                         const ConcurrencyTag& tag = ConcurrencyTag())
    : Surface_mesh_geodesic_sources(tm, get_initialized_vertex_index_map(tm), get_initialized_face_index_map(tm),
                                    get(boost::vertex_point, tm), traits, tag)
  {
  }

  /// the same with points that are not those of the mesh. For instance, with a map that keeps moved points:
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

  /// the same with index maps, too: of numbers from 0 on, each of which is that of one vertex, or face, at most.
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
  /// \pre The vertex is of the mesh.
  /// \throws std::invalid_argument if it is null, or its index is none of the mesh.
  std::size_t add_source_point(vertex_descriptor v)
  {
    return m_sources.add(unfolded(), {classified(v)}, Source_set::POINT);
  }

  /// adds a point anywhere on the surface. Coordinates are divided by their sum; those that are zero up to round-off (1e-13)
  /// put it on the edge, or at the vertex.
  /// \throws std::invalid_argument if the coordinates are not finite, or outside of the face, or their sum is not positive.
  std::size_t add_source_point(const Face_location& location)
  {
    return m_sources.add(unfolded(), {classified(location)}, Source_set::POINT);
  }

  /// adds each point of a range as a source of its own. Returns their ids, in the order of the range; none if it is empty.
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

  /// adds a polyline whose vertices lie anywhere on the surface, and whose segments are straight in a face, or along an
  /// edge. It may cross itself and other sources. Repeated points are allowed; a polyline of one point is a point.
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
  /// \pre The edges are of the mesh.
  /// \throws std::invalid_argument if the range is empty, or if an edge has no face.
  template <class EdgeRange>
  std::size_t add_source_edges(const EdgeRange& edges)
  {
    std::vector<Index> halfedges;
    for (const edge_descriptor e : edges)
    {
      halfedge_descriptor h = halfedge(e, m_surface->tm);
      if (is_border(h, m_surface->tm)) h = opposite(h, m_surface->tm);
      if (is_border(h, m_surface->tm))
        throw std::invalid_argument("Surface_mesh_geodesic_offset: an edge without a face");
      halfedges.push_back(m_surface->index_of_halfedge(h));
    }
    return m_sources.add_edges(unfolded(), std::move(halfedges));
  }

  /// adds the boundary of the surface, each of its cycles as a source of its own: a set of edges. Returns their ids; none if
  /// the surface is closed. Edges without a face are left out. Takes time linear in the size of the mesh.
  std::vector<std::size_t> add_source_boundary()
  {
    std::vector<halfedge_descriptor> cycles;
    Polygon_mesh_processing::extract_boundary_cycles(m_surface->tm, std::back_inserter(cycles));
    std::vector<std::size_t> ids;
    for (const halfedge_descriptor h : cycles)
      if (const std::vector<edge_descriptor> cycle = edges_of_cycle(h); !cycle.empty()) ids.push_back(add_source_edges(cycle));
    return ids;
  }

  /// adds the boundary cycle of a border halfedge: a set of edges. Edges without a face are left out.
  /// \pre The halfedge is of the mesh.
  /// \throws std::invalid_argument if it is not a border halfedge, or if no edge of the cycle has a face.
  std::size_t add_source_boundary(halfedge_descriptor border)
  {
    if (!is_border(border, m_surface->tm))
      throw std::invalid_argument("Surface_mesh_geodesic_offset: the halfedge of a boundary cycle is not on the border");
    return add_source_edges(edges_of_cycle(border));
  }

  /// adds the edges that `sharp_edges()` finds, as one source. Returns its id; nothing if no edge is as sharp as that.
  /// \throws std::invalid_argument as `sharp_edges()` does.
  std::optional<std::size_t> add_source_sharp_edges(double angle)
  {
    std::vector<edge_descriptor> edges;
    sharp_edges(angle, std::back_inserter(edges));
    if (edges.empty()) return std::nullopt;
    return add_source_edges(edges);
  }

  /// the sharp edges: those between two faces whose normals differ by more than `angle` degrees. The difference is 0 where
  /// the surface is flat, 90 at the edges of a cube, and 180 where it folds back onto itself. Border edges are not sharp.
  /// Takes time linear in the size of the mesh.
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
    const Triangle_mesh& tm = m_surface->tm;
    for (const edge_descriptor e : edges(tm))
    {
      const halfedge_descriptor h = halfedge(e, tm);
      if (is_border_edge(h, tm)) continue;
      if (Geodesic_offset::internal::angle_of_normals(*m_surface, h) > angle) *out++ = e;
    }
    return out;
  }

  /// adds the section of the mesh by a plane: each of its polylines, and each vertex that the plane only touches. Returns
  /// the ids of these sources, in this order; none if the plane misses the mesh.
  /// \throws std::invalid_argument as `plane_section()` does.
  std::vector<std::size_t> add_source_plane_section(const Plane_3& plane)
  {
    const Plane_section section = plane_section(plane);
    std::vector<std::size_t> ids;
    for (const auto& polyline : section.polylines)
      ids.push_back(add_source_polyline(polyline.locations, polyline.is_closed));
    for (const vertex_descriptor v : section.touched_vertices) ids.push_back(add_source_point(v));
    return ids;
  }

  /// removes a source.
  /// \throws std::invalid_argument if there is no source with this id.
  void remove_source(std::size_t id) { m_sources.remove(id); }

  /// removes all sources.
  void clear_sources() { m_sources.clear(); }

  /// how many there are.
  std::size_t number_of_sources() const { return m_sources.size(); }
  /// @}

  /// \name Location
  /// The first hundred calls look at all faces, which takes linear time; then, or if more points are given at once, a tree is
  /// built, in the time of some hundred such calls, and further calls take logarithmic time on most meshes. The answers are
  /// the same: of several faces at the same distance it is the one with the lowest index. The `tolerance` is a length, not
  /// negative: a location within it of a vertex or an edge is exactly there. Without it, it is the round-off of the
  /// coordinates.
  /// @{

  /// the location nearest to a point in space.
  /// \throws std::invalid_argument if the mesh has no faces, or a coordinate or its square is not finite, or if the
  ///         tolerance is negative or not a number.
  Face_location locate(const Point_3& p) const { return locate(p, m_locator->default_tolerance()); }
  Face_location locate(const Point_3& p, const FT& tolerance) const { return m_locator->locate(p, tolerance); }

  /// the same together with the distance in space of the point from its location, in the units of the mesh's points. With a
  /// tolerance it can be larger than the distance from the surface, by no more than the tolerance.
  std::pair<Face_location, FT> locate_with_distance(const Point_3& p) const
  {
    return locate_with_distance(p, m_locator->default_tolerance());
  }
  std::pair<Face_location, FT> locate_with_distance(const Point_3& p, const FT& tolerance) const
  {
    const Face_location l = locate(p, tolerance);
    return {l, Geodesic_offset::internal::square_root<FT>((p - m_surface->point(l)).squared_length())};
  }

  /// the location where a ray meets the surface first; one whose face is the null face if it misses the surface.
  /// \throws std::invalid_argument as above, and if the ray has no direction.
  Face_location locate(const Ray_3& r) const { return locate(r, m_locator->default_tolerance()); }
  Face_location locate(const Ray_3& r, const FT& tolerance) const { return m_locator->locate(r, tolerance); }
  /// @}

  /// \name Polylines and Sections
  /// @{

  /// the polyline through points in space: they are located, and those that follow each other without a face in common are
  /// joined by the shortest path on the surface. Points that fall together are left out. The time for a path depends on the
  /// faces that it may pass, and not on the size of the mesh.
  /// \tparam PointRange a model of `ConstRange` with `Point_3` as value type
  /// \param closed whether the last point is joined to the first one, which may be repeated
  /// \throws std::invalid_argument if the range is empty, or if there is no path from a point to the next one; and as
  ///         `locate()` does.
  template <class PointRange>
  Polyline locate_polyline(const PointRange& points, bool closed = false) const
  {
    return locate_polyline_with_distance(points, closed).first;
  }

  /// the same together with the largest distance in space of one of the points from its location.
  template <class PointRange>
  std::pair<Polyline, FT> locate_polyline_with_distance(const PointRange& points, bool closed = false) const
  {
    m_locator->expect(std::size_t(std::distance(std::begin(points), std::end(points))));
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

  /// the same of points of the surface, which stay where they are.
  /// \tparam FaceLocationRange a model of `ConstRange` with `Face_location` as value type
  template <class FaceLocationRange>
  Polyline join_polyline(const FaceLocationRange& locations, bool closed = false) const
  {
    const Geodesic_offset::internal::Polyline_joining<Surface> join(*m_surface, m_traits);
    Polyline polyline;
    std::optional<Located_point> last;
    std::size_t i = 0;
    const auto add = [&](const Face_location& l) {
      auto& path = polyline.locations;
      const Located_point p = classified(l);
      if (last && m_surface->point(path.back()) == m_surface->point(l)) return;
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

  /// the section of the mesh by a plane. The sides of the vertices are decided by the kernel: if its predicates are exact,
  /// so is the way that the section takes, and only the places of its points on the edges are rounded. Takes time linear in
  /// the size of the mesh.
  /// \throws std::invalid_argument if the plane is degenerate, or a coefficient is not finite.
  Plane_section plane_section(const Plane_3& plane) const
  {
    for (const FT& c : {plane.a(), plane.b(), plane.c(), plane.d()})
      if (!Geodesic_offset::internal::Number_policy<FT>::is_finite(CGAL::abs(c)))
        throw std::invalid_argument("Surface_mesh_geodesic_offset: a plane with a coefficient that is not finite");
    if (plane.is_degenerate()) throw std::invalid_argument("Surface_mesh_geodesic_offset: a degenerate plane");
    return Geodesic_offset::internal::Plane_cutting<Surface, Plane_3>(*m_surface, plane)();
  }
  /// @}

protected:
  const Geodesic_offset::internal::Unfolded_mesh<Number>& unfolded() const { return m_surface->unfolded; }

  Located_point classified(vertex_descriptor v) const
  {
    const bool is_null = v == Graph_traits::null_vertex();
    const Index i = is_null ? Geodesic_offset::internal::no_index : m_surface->index_of(v);
    if (!(i < unfolded().number_of_vertices()))
      throw std::invalid_argument("Surface_mesh_geodesic_offset: a vertex that is not of this mesh");
    return Surface_point::at_vertex(i);
  }
  Located_point classified(const Face_location& l) const
  {
    const auto name = [&] { return m_surface->numbers.index_in_mesh(l.first); };
    return Geodesic_offset::internal::classify<Number>(unfolded(), m_surface->index_of(l.first), name,
                                                       Surface::imported(l.second));
  }

  Computing_traits m_traits;
  std::shared_ptr<const Surface> m_surface;
  Source_set m_sources;

private:
  // Those that have a face on the other side of the border.
  std::vector<edge_descriptor> edges_of_cycle(halfedge_descriptor border) const
  {
    const Triangle_mesh& tm = m_surface->tm;
    std::vector<edge_descriptor> edges;
    for (const halfedge_descriptor h : halfedges_around_face(border, tm))
      if (!is_border(opposite(h, tm), tm)) edges.push_back(edge(h, tm));
    return edges;
  }

  std::shared_ptr<const Geodesic_offset::internal::Surface_locator<Surface>> m_locator;
};

} // namespace CGAL

#endif
