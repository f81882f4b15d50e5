// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_offset_statistics.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_curve.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_offset_traits.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Curve_output.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_surface.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Inner_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Path_tracing.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Source_set.h>
#include <CGAL/Surface_mesh_geodesic_offset/named_parameters.h>

#include <CGAL/Default.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief computes exact geodesic distances and exact geodesic offset curves on a triangle mesh, from any number of points,
polylines and edges, by the extended Xin-Wang algorithm \cgalCite{XYH11}.

The distance of a point of the surface is the length of the shortest path on the surface from it to the nearest source.
Sources are added, then `build()` propagates the distances, then the const member functions answer. They may be called
from several threads at once. Points that no path reaches are at infinity.

Adding or removing sources leaves the result of the last `build()` as it is until `build()` is called again.

The mesh is not copied and not modified; it must outlive the object and must not change meanwhile. Lengths and distances
are in the units of the mesh's points.

\tparam Traits a model of `SurfaceMeshGeodesicOffsetTraits`
\tparam VertexIndexMap a model of `ReadablePropertyMap` with `vertex_descriptor` as key and an unsigned integer type as
        value: indices from 0. %Default: the mesh's internal map, or one made for it.
\tparam FaceIndexMap the same for faces
\tparam VertexPointMap a model of `ReadablePropertyMap` with `vertex_descriptor` as key and a 3D point as value.
        %Default: the mesh's `vertex_point`.
*/
template <class Traits, class VertexIndexMap = Default, class FaceIndexMap = Default, class VertexPointMap = Default>
class Surface_mesh_geodesic_offset
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

  /// as `Polygon_mesh_processing::Barycentric_coordinates`
  typedef std::array<FT, 3> Barycentric_coordinates;
  /// as `Polygon_mesh_processing::Face_location`: a face and coordinates with respect to the source of the face's
  /// halfedge, its target, and the third vertex
  typedef std::pair<face_descriptor, Barycentric_coordinates> Face_location;

  typedef typename Default::Get<VertexIndexMap, typename GetInitializedVertexIndexMap<Triangle_mesh>::const_type>::type
    Vertex_index_map;
  typedef typename Default::Get<FaceIndexMap, typename GetInitializedFaceIndexMap<Triangle_mesh>::const_type>::type
    Face_index_map;
  typedef typename Default::Get<
    VertexPointMap, typename boost::property_map<Triangle_mesh, boost::vertex_point_t>::const_type>::type
    Vertex_point_map;

private:
  typedef Geodesic_offset::internal::Geodesic_surface<Traits, Vertex_index_map, Face_index_map, Vertex_point_map>
    Surface;
  typedef Geodesic_offset::internal::Surface_point<FT> Surface_point;
  typedef Geodesic_offset::internal::Point_in_face<FT> Point_in_face;
  typedef Geodesic_offset::internal::Number_policy<FT> Policy;
  typedef Geodesic_offset::internal::Source_set<FT> Source_set;
  typedef Geodesic_offset::internal::Geodesic_build<Traits> Build;
  typedef Geodesic_offset::internal::Path_tracing<FT> Path_tracing;
  typedef Geodesic_offset::internal::Index Index;

public:
  /// an offset curve
  typedef Geodesic_offset_curve<Surface> Offset_curve;

  /// counts and times of a build
  typedef Geodesic_offset_statistics Statistics;
  /// @}

  /// \name Construction
  /// Takes time linear in the size of the mesh, and some 250 bytes a vertex.
  /// @{

  /// \pre All faces of `tm` are triangles with three different vertices that are not collinear.
  /// \throws std::invalid_argument that names the face if that is not so, or if a coordinate is not finite.
  explicit Surface_mesh_geodesic_offset(const Triangle_mesh& tm, const Traits& traits = Traits())
    : Surface_mesh_geodesic_offset(tm, get_initialized_vertex_index_map(tm), get_initialized_face_index_map(tm),
                                   get(boost::vertex_point, tm), traits)
  {
  }

  /// the same with property maps.
  Surface_mesh_geodesic_offset(const Triangle_mesh& tm, Vertex_index_map vertex_index_map,
                               Face_index_map face_index_map, Vertex_point_map vertex_point_map,
                               const Traits& traits = Traits())
    : m_traits(traits),
      m_surface(std::make_shared<Surface>(tm, vertex_index_map, face_index_map, vertex_point_map))
  {
  }
  /// @}

  /// \name Sources
  /// Each function that adds a source returns its id: 0, 1, 2, ... Ids of removed sources are not used again.
  /// @{

  /// adds a vertex.
  std::size_t add_source_point(vertex_descriptor v)
  {
    return m_sources.add(unfolded(), {Surface_point::at_vertex(m_surface->index_of(v))}, Source_set::POINT);
  }

  /// adds a point anywhere on the surface. Coordinates that are zero up to round-off (1e-13) put it on the edge, or at
  /// the vertex.
  /// \throws std::invalid_argument if the coordinates are not finite or outside of the face.
  std::size_t add_source_point(const Face_location& location)
  {
    return m_sources.add(unfolded(), {classified(location)}, Source_set::POINT);
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
  /// \throws std::invalid_argument if the range is empty.
  template <class EdgeRange>
  std::size_t add_source_edges(const EdgeRange& edges)
  {
    std::vector<Index> halfedges;
    for (const edge_descriptor e : edges)
    {
      halfedge_descriptor h = halfedge(e, m_surface->tm);
      if (is_border(h, m_surface->tm)) h = opposite(h, m_surface->tm);
      halfedges.push_back(Geodesic_offset::internal::index_of_halfedge(h, m_surface->tm, m_surface->fim));
    }
    return m_sources.add_edges(unfolded(), std::move(halfedges));
  }

  /// removes a source.
  /// \throws std::invalid_argument if there is no source with this id.
  void remove_source(std::size_t id) { m_sources.remove(id); }

  void clear_sources() { m_sources.clear(); }

  std::size_t number_of_sources() const { return m_sources.size(); }
  /// @}

  /// \name Building
  /// @{

  /// propagates the distances from the sources over the surface. Without any source, all points are at infinity.
  ///
  /// In the worst case O(n^2) windows are propagated; on most meshes their number grows like n^1.5. Memory is that of the
  /// front, unless windows are kept.
  ///
  /// \param np optional named parameters: `parameters::maximum_distance(d)`, `parameters::keep_windows(b)`, or both as
  ///        `parameters::geodesic(d, b)`
  /// \throws std::invalid_argument if the maximum distance is negative or not a number.
  template <class NamedParameters = parameters::Default_named_parameters>
  void build(const NamedParameters& np = parameters::default_values())
  {
    const std::shared_ptr<Build> fresh = new_build(np);
    fresh->propagate(m_traits);
    m_built = fresh;
  }

  /// does the same and at once cuts the offset curves at the given levels, in one propagation.
  ///
  /// Curves come by increasing distance, as soon as the front has passed them, so memory is that of the front and of the
  /// curves it crosses. Without `maximum_distance`, distances beyond the largest level are computed, too. Levels beyond
  /// the maximum distance give no curves.
  /// \param levels a distance, a range of distances, or an `Offset_levels` object
  /// \param out an output iterator for `Offset_curve`
  /// \param selection the side of polylines, and the form at their ends
  /// \throws std::invalid_argument if a distance is not a positive finite number, or if a selection by inside and outside is
  ///         asked for and there is an open polyline, or a closed one that does not divide the surface. Then the last
  ///         build is still there.
  template <class Levels, class OutputIterator, class NamedParameters = parameters::Default_named_parameters>
  OutputIterator build_with_offset_curves(const Levels& levels, OutputIterator out,
                                          const NamedParameters& np = parameters::default_values(),
                                          const Offset_selection& selection = Offset_selection())
  {
    build_with_offset_curves_by_distance(levels, writer_to(out), np, selection);
    return out;
  }

  /// the same with a callback: `f(distance, curves)` is called once for each distance, in increasing order, with a
  /// `const FT&` and a `std::vector<Offset_curve>&&`, also if there are no curves. If the number of levels is unlimited, it is
  /// called up to the largest one that has curves.
  template <class Levels, class Function, class NamedParameters = parameters::Default_named_parameters>
  void build_with_offset_curves_by_distance(const Levels& levels, const Function& f,
                                            const NamedParameters& np = parameters::default_values(),
                                            const Offset_selection& selection = Offset_selection())
  {
    const Offset_levels<FT> wanted(as_levels(levels));
    const std::shared_ptr<Build> fresh = new_build(np);
    propagate_and_cut(*fresh, wanted, selection, f);
    m_built = fresh;
  }

  /// whether distances have been computed.
  bool is_built() const { return m_built != nullptr; }

  /// counts of the last `build()` or `build_with_offset_curves()`.
  /// \throws std::logic_error if `!is_built()`, like all queries.
  const Statistics& statistics() const { return built().statistics; }
  /// @}

  /// \name Queries
  /// @{

  /// the distance of a vertex from the nearest source; infinity if it is unreachable or beyond the maximum distance.
  /// Takes constant time.
  FT distance_to_sources(vertex_descriptor v) const { return built().field.distance[m_surface->index_of(v)]; }

  /// the distance of any point of the surface. Takes time linear in the number of windows of its face.
  /// \throws std::logic_error if the windows were not kept
  /// \throws std::invalid_argument if the location is not valid
  FT distance_to_sources(const Face_location& location) const
  {
    Geodesic_offset::internal::Root root;
    return distance_at(location, root);
  }

  /// the distance with a sign: negative on the left of polylines, that is inside of counterclockwise ones, and positive on
  /// their right. Infinity if the vertex is unreachable or beyond the maximum distance. Not a number where the nearest
  /// source has no sides: points, sets of edges, and beyond the ends of open polylines. Takes constant time.
  double signed_distance_to_sources(vertex_descriptor v) const
  {
    const Index i = m_surface->index_of(v);
    return with_sign(built().field.distance[i], built().field.root[i]);
  }

  /// the same for any point of the surface. Takes time linear in the number of windows of its face.
  /// \throws std::logic_error if the windows were not kept
  /// \throws std::invalid_argument if the location is not valid
  double signed_distance_to_sources(const Face_location& location) const
  {
    Geodesic_offset::internal::Root root;
    const FT d = distance_at(location, root);
    return with_sign(d, root);
  }

  /// puts the distances of all vertices into a map.
  /// \tparam VertexDistanceMap a model of `WritablePropertyMap` with `vertex_descriptor` as key and `FT` as value
  template <class VertexDistanceMap>
  void vertex_distances(VertexDistanceMap map) const
  {
    const Build& b = built();
    for (vertex_descriptor v : vertices(m_surface->tm)) put(map, v, b.field.distance[m_surface->index_of(v)]);
  }

  /// the offset curves at one or several distances. From kept windows, if there are any; else distances are propagated once more,
  /// up to the largest level and once for all levels.
  ///
  /// A level on which a vertex or a whole edge lies is cut as if these were infinitesimally farther: the curve bounds the
  /// points that are strictly nearer. With an inexact number type every level is cut \f$2^{-42}\f$ of its value below
  /// itself. Levels beyond the largest distance of the surface, or beyond the maximum distance of the build, give no curves.
  /// \param levels a distance, a range of distances, or an `Offset_levels` object
  /// \param out an output iterator for `Offset_curve`; curves come by increasing distance
  /// \param selection the side of polylines, and the form at their ends
  /// \throws std::invalid_argument as `build_with_offset_curves()`
  template <class Levels, class OutputIterator>
  OutputIterator offset_curves(const Levels& levels, OutputIterator out,
                               const Offset_selection& selection = Offset_selection()) const
  {
    offset_curves_by_distance(levels, writer_to(out), selection);
    return out;
  }

  /// the same with a callback as that of `build_with_offset_curves_by_distance()`.
  template <class Levels, class Function>
  void offset_curves_by_distance(const Levels& levels, const Function& f,
                                 const Offset_selection& selection = Offset_selection()) const
  {
    const Offset_levels<FT> wanted(as_levels(levels));
    const Build& b = built();
    if (b.kept)
    {
      const auto output = curve_output(b, wanted, selection, f);
      b.cut(wanted, output);
      output.finish();
      return;
    }
    FT maximum = b.maximum;
    if (!wanted.is_unlimited() && wanted.size() > 0) maximum = (std::min)(maximum, wanted[wanted.size() - 1]);
    Build again(unfolded(), b.sources, maximum, false);
    propagate_and_cut(again, wanted, selection, f);
  }

  /// a shortest path from a point to its nearest source, as `Face_location`s: the point itself, a point on each edge that
  /// is crossed and at each vertex that is passed, and the source point. Nothing if the point is unreachable.
  /// \throws std::logic_error if the windows were not kept
  /// \throws std::invalid_argument if the location is not valid
  template <class OutputIterator>
  OutputIterator shortest_path_to_sources(const Face_location& location, OutputIterator out) const
  {
    const Build& b = built_with_windows();
    const Path_tracing trace(unfolded(), b.initial, b.field);
    trace(classified(location),
          [&](Index f, const Point_in_face& p, int edge) { *out++ = m_surface->location(f, p, edge); });
    return out;
  }
  /// @}

private:
  const Geodesic_offset::internal::Unfolded_mesh<FT>& unfolded() const { return m_surface->unfolded; }

  Surface_point classified(const Face_location& l) const
  {
    return Geodesic_offset::internal::classify<FT>(unfolded(), m_surface->index_of(l.first), l.second);
  }

  template <class Levels>
  static Offset_levels<FT> as_levels(const Levels& levels)
  {
    if constexpr (std::is_convertible<Levels, FT>::value)
      return Offset_levels<FT>(std::array<FT, 1>{FT(levels)});
    else
      return Offset_levels<FT>(levels);
  }

  template <class OutputIterator>
  static auto writer_to(OutputIterator& out)
  {
    return [&out](const FT&, std::vector<Offset_curve>&& curves) {
      out = std::move(curves.begin(), curves.end(), out);
    };
  }

  const Build& built() const
  {
    if (!m_built) throw std::logic_error("Surface_mesh_geodesic_offset: build() has not been called");
    return *m_built;
  }

  const Build& built_with_windows() const
  {
    if (!built().kept)
      throw std::logic_error("Surface_mesh_geodesic_offset: this query needs build(parameters::keep_windows(true))");
    return *m_built;
  }

  template <class NamedParameters>
  std::shared_ptr<Build> new_build(const NamedParameters& np) const
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    const FT maximum = choose_parameter(get_parameter(np, internal_np::geodesic_maximum_distance), Policy::infinity());
    if (!(maximum >= FT(0)))
      throw std::invalid_argument("Surface_mesh_geodesic_offset: the maximum distance is negative or not a number");
    const bool keep = choose_parameter(get_parameter(np, internal_np::geodesic_keep_windows), false);
    return std::make_shared<Build>(unfolded(), m_sources, maximum, keep);
  }

  template <class Function>
  void propagate_and_cut(Build& b, const Offset_levels<FT>& levels, const Offset_selection& selection,
                         const Function& f) const
  {
    const auto output = curve_output(b, levels, selection, f);
    b.propagate_and_cut(m_traits, levels, output);
    output.finish();
  }

  template <class Function>
  auto curve_output(const Build& b, const Offset_levels<FT>& levels, const Offset_selection& selection,
                    const Function& f) const
  {
    const bool by_inside = selection.side == Offset_side::INSIDE || selection.side == Offset_side::OUTSIDE;
    std::map<Index, Source_side> inside;
    if (by_inside) inside = Geodesic_offset::internal::inner_sides(unfolded(), m_traits, b.sources);
    return Geodesic_offset::internal::Curve_output<Surface, Function>(m_surface, b.initial.primitives, levels, selection,
                                                                     std::move(inside), f);
  }

  FT distance_at(const Face_location& location, Geodesic_offset::internal::Root& root) const
  {
    const Build& b = built_with_windows();
    const FT d = Path_tracing(unfolded(), b.initial, b.field).distance(classified(location), root);
    return d > b.maximum ? Policy::infinity() : d;
  }

  static double with_sign(const FT& distance, const Geodesic_offset::internal::Root& root)
  {
    const double d = CGAL::to_double(distance);
    if (d == 0 || !Policy::is_finite(distance)) return d;
    switch (root.side())
    {
    case Source_side::LEFT: return -d;
    case Source_side::RIGHT: return d;
    default: return std::numeric_limits<double>::quiet_NaN();
    }
  }

  Traits m_traits;
  std::shared_ptr<const Surface> m_surface;
  Source_set m_sources;
  std::shared_ptr<const Build> m_built;
};

} // namespace CGAL

#endif
