// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_DISTANCE_FIELD_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_DISTANCE_FIELD_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_nearest_source.h>
#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_offset_statistics.h>
#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_curve.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/vertex_results.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/functions/cut_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/Path_visits.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief represents the geodesic distances from a set of sources: distances, shortest paths, nearest sources and offset curves.

`Surface_mesh_geodesic_offset::build()` makes fields. A field is an immutable value: copies are cheap and share the data, later
builds do not change it, and with floating point numbers its member functions may be called from several threads at once. It
may outlive the object that has built it, but not the triangle mesh. The functions of a default-constructed field, and of one
that was moved from, throw `std::logic_error`.

The functions that are passed to a member function - callbacks that receive offset curves, output iterators, property maps -
may build other fields and query this one. They must not assign to the field, move it or destroy it.

Points that no path reaches are at `infinity()`. Lengths and distances are in the units of the mesh's points.

\tparam GeodesicMesh an instance of `Geodesic_mesh`
*/
template <class GeodesicMesh>
class Geodesic_distance_field
{
public:
  /// \name Types
  /// @{

  /// the prepared mesh: plane coordinates of its faces, traits and point locator
  typedef GeodesicMesh Mesh;
  /// a vertex of the mesh
  typedef typename Mesh::vertex_descriptor vertex_descriptor;
  /// the number type of distances and of coordinates
  typedef typename Mesh::FT FT;
  /// a point in space
  typedef typename Mesh::Point_3 Point_3;
  /// a vector in space
  typedef typename Mesh::Vector_3 Vector_3;
  /// a point of the surface
  typedef typename Mesh::Face_location Face_location;

  /// the result of `nearest_source()`
  typedef Geodesic_nearest_source<FT, Face_location> Nearest_source;

  /// counts and times of a build
  typedef Geodesic_offset_statistics Statistics;

#ifdef DOXYGEN_RUNNING
  /// an offset curve
  typedef Geodesic_offset_curve<unspecified_type> Offset_curve;
#else
  typedef Geodesic_offset_curve<Geodesic_offset::internal::Surface_of<Mesh>> Offset_curve;
#endif

#ifdef DOXYGEN_RUNNING
  /// the Voronoi diagram of the sources
  typedef Geodesic_voronoi_diagram<unspecified_type> Voronoi_diagram;
#else
  typedef Geodesic_voronoi_diagram<Geodesic_offset::internal::Surface_of<Mesh>> Voronoi_diagram;
#endif
  /// @}

private:
  typedef Geodesic_offset::internal::Surface_of<Mesh> Surface;
  typedef Geodesic_offset::internal::Geodesic_mesh_data<Surface> Data;
  typedef typename Data::Surface_point Surface_point;
  typedef typename Data::Located_point Located_point;
  typedef typename Surface::Number Number;
  typedef Geodesic_offset::internal::Index Index;
  typedef Geodesic_offset::internal::Number_policy<Number> Policy;
  typedef Geodesic_offset::internal::Geodesic_build<typename Data::Computing_traits> Build;
  typedef Geodesic_offset::internal::Path_start<Number> Path_start;

  friend struct Geodesic_offset::internal::Field_access;

  Geodesic_distance_field(const Mesh& mesh, std::shared_ptr<const Build> build) : m_mesh(mesh), m_build(std::move(build)) {}

public:
  /// \name Construction
  /// @{

  /// constructs a field without distances.
  Geodesic_distance_field() = default;
  /// @}

  /// \name The Build
  /// These functions, and all queries, throw `std::logic_error` if the field has no distances.
  /// @{

  /// whether the field has distances: it is neither default-constructed nor moved from.
  bool is_built() const { return m_build != nullptr; }

  /// the mesh.
  const Mesh& mesh() const
  {
    built();
    return *m_mesh;
  }

  /// whether the visitor has cancelled the build. Distances up to `covered_distance()` are valid nevertheless.
  bool is_cancelled() const { return built().is_cancelled; }

  /// the distance up to which the distances were computed, inclusive: the distance limit, or less if the build was
  /// cancelled or has stopped at its targets; infinity if all distances were computed. All points farther away are at
  /// infinity.
  FT covered_distance() const { return Surface::exported(built().maximum); }

  /// counts and times of the build.
  const Statistics& statistics() const { return built().statistics; }
  /// @}

  /// \name Queries
  /// A `Location` is a `vertex_descriptor` or a `Face_location`. At vertices these functions take constant time.
  /// Elsewhere they need kept windows, and take time linear in the number of windows of a face. They throw
  /// `std::invalid_argument` if the location is not valid, and `std::logic_error` if they need windows that were not kept.
  /// @{

  /// the distance of a point from the nearest source; infinity if the point is unreachable or farther than
  /// `covered_distance()`.
  template <class Location>
  FT distance_to_sources(const Location& location) const
  {
    const Located_point p = classified(location);
    const Build& b = built_for(p);
    const Number d = b.distance(p);
    return Surface::exported(d > b.maximum ? Policy::infinity() : d);
  }

  /// the amount by which the distance of a vertex may be smaller than the exact distance: 0 if the build had no tolerance.
  /// For all other points, `statistics()` has the largest such bound. Excludes rounding error.
  /// \throws std::invalid_argument if the vertex is null, removed or of another mesh.
  FT error_bound(vertex_descriptor v) const
  {
    const Build& b = built();
    const Located_point p = classified(v);
    return b.is_approximate() ? FT(Surface::exported(Number(b.field.error[p.element]))) : FT(0);
  }

  /// the distance, rounded to `double`, with a sign: negative on the left of polylines, which is the inside of
  /// counterclockwise ones, and positive on their right. Infinity if the point is unreachable or farther than
  /// `covered_distance()`. At a point of a source, the start value of the source. Elsewhere empty if the nearest source is a
  /// point or a set of edges, which have no sides, or if the nearest point is an end of an open polyline. The side is that of
  /// `nearest_source_and_side()`, and so is the time; with a tolerance, it is that of the window, without a path.
  template <class Location>
  std::optional<double> signed_distance_to_sources(const Location& location) const
  {
    const Located_point p = classified(location);
    const Path_start start = start_at(p);
    const double d = CGAL::to_double(start.distance);
    if (start.is_at_source() || !start.is_reached()) return d;
    switch (built().source_ref(p, start).side())
    {
    case Source_side::LEFT: return -d;
    case Source_side::RIGHT: return d;
    default: return std::nullopt;
    }
  }

  /// the id of the nearest source, and the side of it on which the point lies; empty if the point is unreachable or farther than
  /// `covered_distance()`. Where sources or sides are equally far up to rounding, one of them. A path is traced, as by
  /// `nearest_source()`, only if it is not longer than the edges of the faces around the point, if a corner of these faces has
  /// another source or side, or if the nearest segment is shorter than 2<sup>-16</sup> edges; otherwise the time is constant.
  /// \throws std::logic_error if the build had a tolerance
  template <class Location>
  std::optional<std::pair<std::size_t, Source_side>> nearest_source_and_side(const Location& location) const
  {
    built_exactly();
    const Located_point p = classified(location);
    const Path_start start = start_at(p);
    if (!start.is_reached()) return std::nullopt;
    const auto source_ref = built().source_ref(p, start);
    return std::make_pair(std::size_t(built().initial.source_of[source_ref.primitive()]), source_ref.side());
  }

  /// the nearest source and the nearest point of it; empty if the point is unreachable or farther than
  /// `covered_distance()`. Takes, in addition, time linear in the number of edges that the shortest path crosses.
  /// \throws std::logic_error if the build had a tolerance
  template <class Location>
  std::optional<Nearest_source> nearest_source(const Location& location) const
  {
    built_exactly();
    const Located_point p = classified(location);
    const Path_start start = start_at(p);
    if (!start.is_reached()) return std::nullopt;
    const auto end = built().path_end(p, start);
    const auto& primitive = built().initial.primitives[end.source_ref.primitive()];
    const bool is_there = start.is_at_source();
    return Nearest_source{primitive.source,
                          primitive.part,
                          primitive.is_segment,
                          end.source_ref.side(),
                          Surface::exported(start.distance),
                          is_there ? surface().location(p) : surface().location(end.point)};
  }

  /// the gradient of the distance: the unit vector opposite to the direction in which the shortest path to the nearest source
  /// starts, in the plane of the face in which the path starts. Empty at sources, at points that have no distance, and where the
  /// distance is so small that rounding leaves no direction. If there are several shortest paths, the gradient is that of the
  /// path which `shortest_path_to_sources()` writes.
  template <class Location>
  std::optional<Vector_3> gradient(const Location& location) const
  {
    const Path_start start = start_at(classified(location));
    if (!start.is_reached() || start.halfedge == Geodesic_offset::internal::no_index || start.is_at_source())
      return std::nullopt;
    const Number size = length(start.direction);
    if (CGAL::is_zero(size)) return std::nullopt;
    return surface().vector(start.halfedge, (Number(-1) / size) * start.direction);
  }

  /// writes the distances of all vertices to a map.
  /// \tparam VertexDistanceMap a model of `WritablePropertyMap` with `vertex_descriptor` as key and `FT` as value
  template <class VertexDistanceMap>
  void vertex_distances(VertexDistanceMap map) const
  {
    Geodesic_offset::internal::write_vertex_distances(data(), built(), map);
  }

  /// writes the id of the nearest source of each vertex to a map; of sources that tie, any. The cells of sources also divide faces, see `voronoi_diagram()`.
  /// \tparam VertexLabelMap a model of `WritablePropertyMap` with `vertex_descriptor` as key and `std::size_t` as value
  template <class VertexLabelMap>
  void source_labels(VertexLabelMap map) const
  {
    Geodesic_offset::internal::write_source_labels(data(), built(), map);
  }

  /// the largest distance of the vertices that have a distance. Points between vertices may be farther, see
  /// `largest_distance()`. Empty if no vertex has a distance, as without sources. Takes linear time.
  std::optional<FT> largest_vertex_distance() const
  {
    const auto& field = built().field;
    const Number* largest = nullptr;
    for (Index v = 0; v < unfolded().number_of_vertices(); ++v)
    {
      const Number& d = field.distance_of_path(v);
      if (Policy::is_finite(d) && (largest == nullptr || *largest < d)) largest = &d;
    }
    if (largest == nullptr) return std::nullopt;
    return FT(Surface::exported(*largest));
  }

  /// the largest distance of the points of the surface that have a distance, and a point at that distance, which may lie
  /// inside a face. Empty if no point has a distance, as without sources. After a build with `compute_largest_distance(true)`
  /// this takes constant time; from kept windows it takes time linear in the size of the mesh and little more, on most meshes.
  /// \throws std::logic_error if the build had neither of these parameters, or had a tolerance, or `covered_distance()` is
  ///         finite
  std::optional<std::pair<Face_location, FT>> farthest_point() const
  {
    built_exactly();
    if (Policy::is_finite(built().maximum))
      throw std::logic_error("Surface_mesh_geodesic_offset: there is no farthest point: distances were not computed "
                             "everywhere");
    const auto farthest = this->farthest();
    if (!farthest) return std::nullopt;
    return std::pair<Face_location, FT>(Face_location(surface().face_of[farthest->face], Surface::exported(farthest->weights)),
                                        Surface::exported(farthest->distance));
  }

  /// the largest distance of the points of the surface that have a distance; `covered_distance()` if other points are farther
  /// away. Empty if no point has a distance. With a tolerance it may be smaller than the exact one by the tolerance. Takes the time
  /// of `farthest_point()`.
  /// \throws std::logic_error if the build had not the parameters that `farthest_point()` needs
  std::optional<FT> largest_distance() const
  {
    const auto farthest = this->farthest();
    if (!farthest) return std::nullopt;
    return FT(Surface::exported(farthest->distance));
  }
  /// @}

  /// \name Offset Curves
  /// @{

  /// cuts the offset curves at one or several distances. The curves are cut from the kept windows; if none
  /// were kept, one more propagation cuts all of them, up to the largest level, or to the first one larger than all start values
  /// at which the selected sides have no curves.
  ///
  /// A level on which a vertex or a whole edge lies is cut as if these were infinitesimally farther: the curve bounds the
  /// points that are strictly nearer. With an inexact number type, the offset at \f$d\f$ is cut 1024 units in the last place
  /// below it, with `double` at \f$(1 - 2^{-42})\, d\f$. Levels beyond the largest distance of the surface, or beyond the
  /// distance limit of the build, give no curves. If the build had a tolerance, so have the curves, see
  /// `Geodesic_offset_curve::tolerance()`.
  ///
  /// Takes time linear in the size of the mesh and of the curves; in each face, quadratic in the number of windows that reach
  /// the distance, and up to cubic if they start at sources that cross each other. Hundreds of source segments in one face take
  /// seconds: subdivide such a face first.
  /// \param levels a distance, a range of distances such as `{1., 2.}`, or an `Offset_levels` object
  /// \param out an output iterator for `Offset_curve`; curves come by increasing distance
  /// \param np an optional sequence of named parameters among those listed below, with the meaning and the defaults that they
  ///        have in `Surface_mesh_geodesic_offset::build_with_offset_curves()`
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{offset_side}
  ///     \cgalParamDescription{the side of polylines}
  ///     \cgalParamType{`Offset_side`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{end_style}
  ///     \cgalParamDescription{whether there are offsets around the ends of open polylines}
  ///     \cgalParamType{`Offset_end`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{concurrency_tag}
  ///     \cgalParamDescription{whether several threads cut}
  ///     \cgalParamType{`Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \throws std::invalid_argument as `Surface_mesh_geodesic_offset::build_with_offset_curves()`
  template <class Levels = std::initializer_list<FT>, class OutputIterator,
            class NamedParameters = parameters::Default_named_parameters>
  OutputIterator offset_curves(const Levels& levels, OutputIterator out,
                               const NamedParameters& np = parameters::default_values()) const
  {
    offset_curves_by_distance(levels, Geodesic_offset::internal::curve_writer<Offset_curve>(out), np);
    return out;
  }

  /// calls `f(distance, curves)` for each distance, as `Surface_mesh_geodesic_offset::build_with_offset_curves_by_distance()`
  /// does. All else is as in `offset_curves()`.
  template <class Levels = std::initializer_list<FT>, class Function,
            class NamedParameters = parameters::Default_named_parameters>
  void offset_curves_by_distance(const Levels& levels, Function&& f,
                                 const NamedParameters& np = parameters::default_values()) const
  {
    namespace internal = Geodesic_offset::internal;
    internal::check_named_parameters<internal::Offset_parameters, NamedParameters>();
    const auto wanted = internal::offset_levels<Surface>(levels);
    internal::cut_offset_curves<internal::Concurrency_tag_of<NamedParameters>>(data(), built(), wanted,
                                                                               internal::offset_selection(np), f);
  }
  /// @}

  /// \name Voronoi Diagram
  /// @{

  /// computes the exact Voronoi diagram of the sources, from kept windows. The time is linear in the size of the mesh and the
  /// number of kept windows, plus \f$ O(n^3) \f$ in each crossed face for the \f$ n \f$ windows that may be nearest there;
  /// faces with more than 12 of them are divided. The distances agree on both sides of the curves up to rounding; see
  /// `Geodesic_voronoi_diagram` for its limits.
  /// \throws std::logic_error if the build kept no windows, or had a tolerance, or `covered_distance()` is finite
  Voronoi_diagram voronoi_diagram() const
  {
    built_exactly();
    return Voronoi_diagram(data(), built_with_windows());
  }
  /// @}

  /// \name Special Values
  /// @{

  /// the distance of points that no path reaches: `std::numeric_limits<FT>::infinity()`, or, for number types without an
  /// infinity, such as exact ones, a number that is larger than any distance on a mesh.
  static FT infinity() { return Surface::exported(Policy::infinity()); }

  /// the label that `source_labels()` gives to vertices that have no distance.
  static constexpr std::size_t no_source() { return Geodesic_offset::internal::no_source_label; }
  /// @}

  /// \name Shortest Paths
  /// A path from a `Location`, a `vertex_descriptor` or a `Face_location`, to its nearest source consists of the point
  /// itself, a point on each edge that it crosses, the vertices through which it passes, and the source point. It is empty if
  /// the point has no distance, and only the point if the point lies on a source. As a location, an isolated vertex is in the null
  /// face. Two consecutive points are different and have a
  /// face in common. The path ends at the nearest point of `nearest_source()`. The time is linear in the number of points, and
  /// the exceptions are those of the queries. The straight parts from vertex to vertex, which many paths have in common, are
  /// cached: in up to 264 bytes per vertex of the mesh for paths as points, and as many for the other forms.
  /// @{

  /// writes a shortest path to the nearest source as locations.
  /// \param location the start of the path
  /// \param out an output iterator for `Face_location`
  template <class Location, class OutputIterator>
  OutputIterator shortest_path_to_sources(const Location& location, OutputIterator out) const
  {
    trace_from(location, [&](const auto& p) { *out++ = surface().location(p); });
    return out;
  }

  /// writes a shortest path to the nearest source as points in space.
  /// \param location the start of the path
  /// \param out an output iterator for `Point_3`
  template <class Location, class OutputIterator>
  OutputIterator shortest_path_points_to_sources(const Location& location, OutputIterator out) const
  {
    const Build& b = built_exactly();
    if constexpr (decltype(b.suffixes_in_space)::keeps)
    {
      std::vector<typename Surface::Space_point> points;
      const Located_point p = classified(location);
      b.trace_path_in_space(p, start_at(p), surface(), points);
      for (const auto& q : points) *out++ = Geodesic_offset::internal::converted_point<Point_3, FT>(q);
    }
    else trace_from(location, [&](const auto& p) { *out++ = surface().point(p); });
    return out;
  }

  /// calls a visitor for each point of a shortest path to the nearest source.
  /// \param location the start of the path
  /// \param visitor is called as that of `Surface_mesh_shortest_path`: `visitor(halfedge, t)` for a point on an edge, at the
  ///        fraction `t` of the way from the source of the halfedge to its target; `visitor(vertex)`;
  ///        `visitor(face, barycentric_coordinates)` for a point inside a face.
  template <class Location, class Visitor>
  void shortest_path_sequence_to_sources(const Location& location, Visitor& visitor) const
  {
    trace_from(location, Geodesic_offset::internal::Path_visits<Surface, Visitor>(surface(), visitor));
  }
  /// @}

private:
  const Build& built() const
  {
    if (!m_build) throw std::logic_error("Surface_mesh_geodesic_offset: build() has not been called");
    return *m_build;
  }

  const Build& built_exactly() const
  {
    if (built().is_approximate())
      throw std::logic_error("Surface_mesh_geodesic_offset: this query needs a build without a tolerance");
    return *m_build;
  }

  const Build& built_with_windows() const
  {
    if (!built().kept)
      throw std::logic_error("Surface_mesh_geodesic_offset: this query needs build(parameters::keep_windows(true))");
    return *m_build;
  }

  std::optional<Geodesic_offset::internal::Farthest<Number>> farthest() const
  {
    const Build& b = built();
    if (!b.request().finds_farthest)
    {
      if (!b.kept)
        throw std::logic_error("Surface_mesh_geodesic_offset: this query needs "
                               "build(parameters::compute_largest_distance(true))");
      return b.find_farthest();
    }
    return b.farthest;
  }

  const Build& built_for(const Surface_point& p) const
  {
    return p.kind == Surface_point::VERTEX ? built() : built_with_windows();
  }

  Path_start start_at(const Located_point& p) const { return built_for(p).path_start(p); }

  template <class Location, class Function>
  void trace_from(const Location& location, const Function& out) const
  {
    const Build& b = built_exactly();
    const Located_point p = classified(location);
    Geodesic_offset::internal::visit_path(b, p, start_at(p), out);
  }

  const Data& data() const
  {
    built();
    return Geodesic_offset::internal::Mesh_access::data(*m_mesh);
  }
  const Surface& surface() const { return data().surface(); }
  const Geodesic_offset::internal::Unfolded_mesh<Number>& unfolded() const { return data().unfolded(); }

  template <class Location>
  Located_point classified(const Location& location) const
  {
    Located_point p = data().classified(location);
    if constexpr (std::is_convertible<const Location&, vertex_descriptor>::value)
      p.element = Geodesic_offset::internal::nearest_copy(unfolded(), built().field, p.element);
    return p;
  }

  std::optional<Mesh> m_mesh;
  std::shared_ptr<const Build> m_build;
};

} // namespace CGAL

#endif
