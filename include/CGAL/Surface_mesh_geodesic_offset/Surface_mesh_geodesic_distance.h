// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_DISTANCE_H
#define CGAL_SURFACE_MESH_GEODESIC_DISTANCE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_nearest_source.h>
#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_offset_statistics.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_sources.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Farthest_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Near_path.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_output.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_tracing.h>
#include <CGAL/Surface_mesh_geodesic_offset/named_parameters.h>

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief computes exact geodesic distances and shortest paths on a triangle mesh, from any number of points, polylines and
edges, by the extended Xin-Wang algorithm \cgalCite{XYH11}.

The distance of a point of the surface is the length of the shortest path on the surface from the point to the nearest
source. The use has three steps: add the sources, call `build()`, which propagates the distances, and call the const member
functions. With floating point numbers the const member functions may be called from several threads at once. Points that no
path reaches are at `infinity()`. Lengths and distances are in the units of the mesh's points.

Adding or removing sources does not change the result of the last build; only `build()` and `update()` replace it.

\anchor Surface_mesh_geodesic_distance_callbacks
\cgalHeading{Callbacks, Copies, Moves}

The functions that are passed to a member function - visitors, callbacks that receive offset curves, output iterators, property
maps - may call all member functions of the object, also those that add or remove sources and those that build. A query
continues with the result with which it began, of which it holds a share; a build and an update continue with the sources that
there were when they began, and their result replaces the last one when they return: of two builds, one within the other, the
outer one remains. These functions must not assign to the object, move it or destroy it.

Copies share the result of the last build, which is immutable; the next build of one of them does not change that of the other.
An object that was moved from has no mesh and no result: `is_built()` is false, it can be destroyed and assigned to, and
functions that need the mesh or a result throw `std::logic_error`.

\anchor Surface_mesh_geodesic_distance_threads
\cgalHeading{Several Threads}

Functions that propagate take a concurrency tag as their first template parameter, as in `build<CGAL::Parallel_tag>()`:
- `Sequential_tag`, the default: the calling thread works alone.
- `Parallel_tag`: the threads work that TBB may use where the function is called, as limited by `tbb::global_control` and
  `tbb::task_arena`. \cgal must be linked with TBB (`CGAL_LINKED_WITH_TBB`), otherwise the call does not compile.
- `Parallel_if_available_tag`: `Parallel_tag` with TBB, `Sequential_tag` without.

Constructors, which set up the mesh, take such a tag as their last argument, as in
`geodesic(mesh, Traits(), CGAL::Parallel_tag())`; what they set up does not depend on the tag.

With `Parallel_tag` the results are the same to the last bit for any number of threads, one included, and in each run. They
differ from the results with `Sequential_tag` by rounding alone: distances by no more than a relative \f$10^{-13}\f$ in all
tests. The distance at which a build stops, at its targets or because the visitor cancels it, may differ, and so may the
counts of the statistics; memory is larger by some percent. The calling thread alone calls the visitor and the callbacks that
receive offset curves; TBB's threads remain occupied until the function returns.

Several threads call the functors of the traits concurrently, and, during construction, the functions and maps that read the
mesh. All this holds for `float`, `double` and `long double` only: with other number types, whose operations may share
memory, `Parallel_tag` does what `Sequential_tag` does.

The template parameters are those of `Surface_mesh_geodesic_sources`.
*/
template <class Traits, class VertexIndexMap = Default, class FaceIndexMap = Default, class VertexPointMap = Default>
class Surface_mesh_geodesic_distance
  : public Surface_mesh_geodesic_sources<Traits, VertexIndexMap, FaceIndexMap, VertexPointMap>
{
  typedef Surface_mesh_geodesic_sources<Traits, VertexIndexMap, FaceIndexMap, VertexPointMap> Base;

public:
  /// \name Types
  /// @{

#ifndef DOXYGEN_RUNNING // documented in the base class
  typedef typename Base::vertex_descriptor vertex_descriptor;
  typedef typename Base::halfedge_descriptor halfedge_descriptor;
  typedef typename Base::face_descriptor face_descriptor;
  typedef typename Base::FT FT;
  typedef typename Base::Point_3 Point_3;
  typedef typename Base::Vector_3 Vector_3;
  typedef typename Base::Face_location Face_location;
#endif

  /// the result of `nearest_source()`
  typedef Geodesic_nearest_source<FT, Face_location> Nearest_source;

  /// counts and times of a build
  typedef Geodesic_offset_statistics Statistics;
  /// @}

protected:
  typedef typename Base::Surface Surface;
  typedef typename Base::Surface_point Surface_point;
  typedef typename Base::Located_point Located_point;
  typedef typename Base::Index Index;
  typedef typename Base::Number Number;
  typedef Geodesic_offset::internal::Number_policy<Number> Policy;
  typedef Geodesic_offset::internal::Build_request<Number> Request;
  typedef Geodesic_offset::internal::Geodesic_build<typename Base::Computing_traits> Build;
  typedef Geodesic_offset::internal::Path_start<Number> Path_start;

  using Base::classified;
  using Base::m_sources;
  using Base::m_traits;
  using Base::surface;
  using Base::unfolded;

public:
#ifdef DOXYGEN_RUNNING
  /// \name Construction
  /// @{

  /// \copydoc CGAL::Surface_mesh_geodesic_sources::Surface_mesh_geodesic_sources(const Triangle_mesh&, const Traits&, const ConcurrencyTag&)
  template <class ConcurrencyTag = Sequential_tag>
  explicit Surface_mesh_geodesic_distance(const Triangle_mesh& tm, const Traits& traits = Traits(),
                                          const ConcurrencyTag& tag = ConcurrencyTag());

  /// \copydoc CGAL::Surface_mesh_geodesic_sources::Surface_mesh_geodesic_sources(const Triangle_mesh&, Vertex_point_map, const Traits&, const ConcurrencyTag&)
  template <class ConcurrencyTag = Sequential_tag>
  Surface_mesh_geodesic_distance(const Triangle_mesh& tm, Vertex_point_map vertex_point_map, const Traits& traits = Traits(),
                                 const ConcurrencyTag& tag = ConcurrencyTag());

  /// \copydoc CGAL::Surface_mesh_geodesic_sources::Surface_mesh_geodesic_sources(const Triangle_mesh&, Vertex_index_map, Face_index_map, Vertex_point_map, const Traits&, const ConcurrencyTag&)
  template <class ConcurrencyTag = Sequential_tag>
  Surface_mesh_geodesic_distance(const Triangle_mesh& tm, Vertex_index_map vertex_index_map, Face_index_map face_index_map,
                                 Vertex_point_map vertex_point_map, const Traits& traits = Traits(),
                                 const ConcurrencyTag& tag = ConcurrencyTag());
  /// @}
#else
  using Base::Base;
#endif

  /// \name Building
  /// @{

  /// propagates the distances from the sources over the surface. Without any source, all points are at infinity.
  ///
  /// On most meshes of n vertices the number of windows that are propagated grows like n^1.5; in the worst case the lower
  /// envelopes together have O(n^2) windows \cgalCite{MMP87}. A window takes constant time on average. All other work takes
  /// time linear in the size of the mesh, also with a distance limit. Memory is that of the front, and some 40 bytes per
  /// window if windows are kept.
  ///
  /// With a tolerance, distances may be smaller than the exact ones, within the bounds that `statistics()` reports, but not
  /// larger, and a few windows per vertex are propagated on smooth fine meshes, however fine; see \ref
  /// SurfaceMeshGeodesicOffsetTolerance. A point whose exact distance exceeds the distance limit by no more than the bound
  /// may then have a distance, too. Paths, nearest points, the farthest point and offset curves need an exact build, and
  /// throw `std::logic_error`.
  ///
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
  /// \param np optional named parameters, see `parameters::Geodesic_parameters`: `distance_limit(d)`, `keep_windows(b)`,
  ///        `compute_largest_distance(b)`, `targets(range)`, `visitor(f)`, `relative_tolerance(t)`, `merging_tolerance(t)`
  /// \throws std::invalid_argument if the distance limit is negative or not a number, or a target is not a valid location,
  ///         or the relative tolerance is not a number from 0 to 0.5, or the merging tolerance is negative or not a finite
  ///         number, or one of the tolerances is not 0 and the number type is exact.
  /// \throws std::runtime_error if thousands of windows reach one edge of a small mesh, as in needle faces thinner than some
  ///         1e-9, where windows differ by less than rounding and their number grows without a bound.
  ///         After all these exceptions, and those of the visitor, the last build is unchanged.
  template <class ConcurrencyTag = Sequential_tag, class NamedParameters = parameters::Default_named_parameters>
  void build(const NamedParameters& np = parameters::default_values())
  {
    const auto fresh = std::make_shared<Build>(unfolded(), m_sources, request(np));
    fresh->template propagate<ConcurrencyTag>(m_traits);
    m_built = fresh;
  }

  /// brings the last build up to date with the sources. Only the distances that the sources added since then improve are
  /// propagated. The result is that of `build()` with the parameters `distance_limit`, `keep_windows` and
  /// `compute_largest_distance` of the last build. If sources were removed since then, or if the last build was cancelled,
  /// stopped at its targets, had a tolerance, or computed the largest distance without kept windows, all distances are
  /// computed anew, with that tolerance. During the update there are two fields in memory; kept windows of the last build are
  /// copied, which takes time linear in their number. If the visitor cancels the update, the last build is unchanged.
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
  /// \param np an optional named parameter, `visitor(f)`
  /// \throws std::logic_error if `!is_built()`, and std::runtime_error as `build()`
  template <class ConcurrencyTag = Sequential_tag, class NamedParameters = parameters::Default_named_parameters>
  void update(const NamedParameters& np = parameters::default_values())
  {
    const std::shared_ptr<const Build> before = shared_build();
    const Build& b = *before;
    Request r = request(np);
    r.targets.clear();
    r.maximum = b.request().maximum;
    r.keeps_windows = b.kept;
    r.tolerance = b.request().tolerance;
    r.finds_farthest = b.request().finds_farthest;
    const bool can_grow = b.is_whole() && !b.is_approximate() && (b.kept || !r.finds_farthest);
    const bool grows = can_grow && m_sources.extends(b.sources);
    const auto fresh = grows ? std::make_shared<Build>(b, m_sources, r) : std::make_shared<Build>(unfolded(), m_sources, r);
    fresh->template propagate<ConcurrencyTag>(m_traits);
    if (!fresh->is_cancelled) m_built = fresh;
  }

  /// whether distances have been computed.
  bool is_built() const { return m_built != nullptr; }

  /// whether the visitor has cancelled the last build. Distances up to `covered_distance()` are valid nevertheless.
  /// \throws std::logic_error if `!is_built()`, like all queries.
  bool is_cancelled() const { return built().is_cancelled; }

  /// the distance up to which the distances were computed, inclusive: the distance limit, or less if the build was
  /// cancelled or has stopped at its targets; infinity if all distances were computed. All points farther away are at
  /// infinity.
  FT covered_distance() const { return Surface::exported(built().maximum); }

  /// counts and times of the last build.
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
    const Number d = near_path(b).distance(p, b.legs);
    return Surface::exported(d > b.maximum ? Policy::infinity() : d);
  }

  /// the amount by which the distance of a vertex may be smaller than the exact distance: 0 if the build had no tolerance.
  /// For all other points, `statistics()` has the largest such bound. Excludes rounding error.
  /// \throws std::invalid_argument if the vertex does not belong to the mesh.
  FT error_bound(vertex_descriptor v) const
  {
    const Build& b = built();
    const Located_point p = classified(v);
    return b.is_approximate() ? FT(Surface::exported(Number(b.field.error[p.element]))) : FT(0);
  }

  /// the distance, rounded to `double`, with a sign: negative on the left of polylines, which is the inside of
  /// counterclockwise ones, and positive on their right. Infinity if the point is unreachable or farther than
  /// `covered_distance()`. Not a number if the nearest source is a point or a set of edges, which have no sides, or if the
  /// nearest point is an end of an open polyline. The side is that of `nearest_source()`, and so is the time, unless the build had
  /// a tolerance.
  template <class Location>
  double signed_distance_to_sources(const Location& location) const
  {
    const Located_point p = classified(location);
    const Path_start start = start_at(p);
    const double d = CGAL::to_double(start.distance);
    if (d == 0 || !start.is_reached()) return d;
    switch (built().is_approximate() ? start.root.side() : end_of(p, start).root.side())
    {
    case Source_side::LEFT: return -d;
    case Source_side::RIGHT: return d;
    default: return std::numeric_limits<double>::quiet_NaN();
    }
  }

  /// the nearest source and the nearest point of it; empty if the point is unreachable or farther than
  /// `covered_distance()`. Takes, in addition, time linear in the number of edges that the shortest path crosses.
  template <class Location>
  std::optional<Nearest_source> nearest_source(const Location& location) const
  {
    built_exactly();
    const Located_point p = classified(location);
    const Path_start start = start_at(p);
    if (!start.is_reached()) return std::nullopt;
    const auto end = end_of(p, start);
    const auto& primitive = built().initial.primitives[end.root.primitive()];
    const bool is_there = CGAL::is_zero(start.distance);
    return Nearest_source{primitive.source,  primitive.part, primitive.is_segment,
                          end.root.side(), Surface::exported(start.distance),
                          is_there ? surface().location(p) : surface().location(end.point)};
  }

  /// the gradient of the distance: the unit vector opposite to the direction in which the shortest path to the nearest source
  /// starts, in the plane of the face in which the path starts. The null vector at sources and at points that have no
  /// distance, and where the distance is so small that rounding leaves no direction. If there are several shortest paths, the
  /// gradient is that of the path which `shortest_path_to_sources()` writes.
  template <class Location>
  Vector_3 gradient(const Location& location) const
  {
    const Path_start start = start_at(classified(location));
    if (!start.is_reached() || start.halfedge == Geodesic_offset::internal::no_index || CGAL::is_zero(start.distance))
      return CGAL::NULL_VECTOR;
    const Number size = length(start.direction);
    if (CGAL::is_zero(size)) return CGAL::NULL_VECTOR;
    return surface().vector(start.halfedge, (Number(-1) / size) * start.direction);
  }

  /// writes the distances of all vertices to a map.
  /// \tparam VertexDistanceMap a model of `WritablePropertyMap` with `vertex_descriptor` as key and `FT` as value
  template <class VertexDistanceMap>
  void vertex_distances(VertexDistanceMap map) const
  {
    const std::shared_ptr<const Build> b = shared_build();
    for (vertex_descriptor v : vertices(surface().tm))
      put(map, v, FT(Surface::exported(b->field.distance[surface().index_of(v)])));
  }

  /// writes the id of the nearest source of each vertex to a map: the geodesic Voronoi diagram of the sources.
  /// \tparam VertexLabelMap a model of `WritablePropertyMap` with `vertex_descriptor` as key and `std::size_t` as value
  template <class VertexLabelMap>
  void source_labels(VertexLabelMap map) const
  {
    const std::shared_ptr<const Build> b = shared_build();
    for (vertex_descriptor v : vertices(surface().tm))
    {
      const Index i = surface().index_of(v);
      const bool has_distance = Policy::is_finite(b->field.distance[i]);
      put(map, v, has_distance ? std::size_t(b->initial.source_of[b->field.root[i].primitive()]) : no_source());
    }
  }

  /// the largest distance of the vertices that have a distance. Points between vertices may be farther, see
  /// `largest_distance()`. Takes linear time.
  /// \throws std::logic_error if no vertex has a distance
  FT largest_vertex_distance() const
  {
    const Number* largest = nullptr;
    for (const Number& d : built().field.distance)
      if (Policy::is_finite(d) && (largest == nullptr || *largest < d)) largest = &d;
    if (largest == nullptr) throw std::logic_error("Surface_mesh_geodesic_offset: no vertex has a distance");
    return Surface::exported(*largest);
  }

  /// the largest distance of the points of the surface that have a distance, and a point at that distance, which may lie
  /// inside a face. After a build with `compute_largest_distance(true)` this takes constant time; from kept windows it takes
  /// time linear in the size of the mesh and little more, on most meshes.
  /// \throws std::logic_error if the build had neither of these parameters, or no point has a distance, or
  ///         `covered_distance()` is finite
  std::pair<Face_location, FT> farthest_point() const
  {
    built_exactly();
    if (Policy::is_finite(built().maximum))
      throw std::logic_error("Surface_mesh_geodesic_offset: there is no farthest point: distances were not computed "
                             "everywhere");
    const auto farthest = this->farthest();
    return {Face_location(surface().face_of[farthest.face], Surface::exported(farthest.weights)),
            Surface::exported(farthest.distance)};
  }

  /// the largest distance of the points of the surface that have a distance; `covered_distance()` if other points are farther
  /// away. With a tolerance it may be smaller than the exact one, as all distances. Takes time as `farthest_point()`.
  /// \throws std::logic_error if the build had none of the parameters that `farthest_point()` needs, or no point has a
  ///         distance
  FT largest_distance() const { return Surface::exported(farthest().distance); }
  /// @}

  /// \name Special Values
  /// @{

  /// the distance of points that no path reaches: `std::numeric_limits<FT>::infinity()`, or, for number types without an
  /// infinity, such as exact ones, a number that is larger than any distance on a mesh.
  static FT infinity() { return Surface::exported(Policy::infinity()); }

  /// the label that `source_labels()` gives to vertices that have no distance.
  static constexpr std::size_t no_source() { return (std::numeric_limits<std::size_t>::max)(); }
  /// @}

  /// \name Shortest Paths
  /// A path from a `Location`, a `vertex_descriptor` or a `Face_location`, to its nearest source consists of the point
  /// itself, a point on each edge that it crosses, the vertices through which it passes, and the source point. It is empty if
  /// the point has no distance, and only the point if the point lies on a source. Two consecutive points are different and have a
  /// face in common. The path ends at the nearest point of `nearest_source()`. The time is linear in the number of points, and the exceptions are those of the queries. The straight parts from
  /// vertex to vertex, which many paths have in common, are cached: in up to 264 bytes per vertex of the mesh for paths as
  /// points, and as many for the other forms.
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
    const std::shared_ptr<const Build> b = shared_exact_build();
    if constexpr (decltype(b->legs_in_space)::keeps)
    {
      Geodesic_offset::internal::Path_points<Surface, OutputIterator> points(surface(), out);
      const Located_point p = classified(location);
      tracing(*b)(p, start_at(p), b->legs_in_space, points);
      return points.out();
    }
    else
    {
      trace_from(location, [&](const auto& p) { *out++ = surface().point(p); });
      return out;
    }
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

protected:
  const Build& built() const
  {
    if (!m_built) throw std::logic_error("Surface_mesh_geodesic_offset: build() has not been called");
    return *m_built;
  }

  const Build& built_exactly() const
  {
    if (built().is_approximate())
      throw std::logic_error("Surface_mesh_geodesic_offset: this query needs a build without a tolerance");
    return *m_built;
  }

  // Shares for functions that call those of the user, which may replace the last build. All others borrow it.
  std::shared_ptr<const Build> shared_build() const
  {
    built();
    return m_built;
  }

  std::shared_ptr<const Build> shared_exact_build() const
  {
    built_exactly();
    return m_built;
  }

  const Build& built_with_windows() const
  {
    if (!built().kept)
      throw std::logic_error("Surface_mesh_geodesic_offset: this query needs build(parameters::keep_windows(true))");
    return *m_built;
  }

  Geodesic_offset::internal::Farthest<Number> farthest() const
  {
    const Build& b = built();
    std::optional<Geodesic_offset::internal::Farthest<Number>> result = b.farthest;
    if (!b.request().finds_farthest)
    {
      if (!b.kept)
        throw std::logic_error("Surface_mesh_geodesic_offset: this query needs "
                               "build(parameters::compute_largest_distance(true))");
      Geodesic_offset::internal::Farthest_point<Number> search(unfolded(), b.initial, b.field);
      search.add_all();
      result = search.result();
    }
    if (!result) throw std::logic_error("Surface_mesh_geodesic_offset: there is no farthest point: no point has a distance");
    return *result;
  }

  const Build& built_for(const Surface_point& p) const
  {
    return p.kind == Surface_point::VERTEX ? built() : built_with_windows();
  }

  Path_start start_at(const Located_point& p) const
  {
    const Build& b = built_for(p);
    Path_start start = near_path(b)(p, b.legs);
    if (start.distance > b.maximum) start = Path_start();
    return start;
  }

  auto near_path(const Build& b) const
  {
    return Geodesic_offset::internal::Near_path<Number>(unfolded(), b.initial, b.field, !b.is_approximate());
  }

  auto tracing(const Build& b) const
  {
    return Geodesic_offset::internal::Path_tracing<Number>(unfolded(), b.initial, b.field);
  }

  // Where the path from p ends, which starts as told.
  Geodesic_offset::internal::Leg_end<Number> end_of(const Located_point& p, const Path_start& start) const
  {
    const Build& b = built();
    Geodesic_offset::internal::No_path_output<Number> nothing;
    return tracing(b)(p, start, b.legs, nothing);
  }

  template <class P, class Function>
  void trace(const P& p, const Path_start& start, Function&& out) const
  {
    const Build& b = built();
    Geodesic_offset::internal::Path_elements<Number, Function> elements(out);
    tracing(b)(p, start, b.legs, elements);
  }

  template <class Location, class Function>
  void trace_from(const Location& location, const Function& out) const
  {
    const std::shared_ptr<const Build> b = shared_exact_build();
    const Located_point p = classified(location);
    trace(p, start_at(p), out);
  }

  template <class NamedParameters>
  Request request(const NamedParameters& np) const
  {
    return Request::template read<vertex_descriptor>(np, [this](const auto& t) { return this->classified(t); });
  }

  std::shared_ptr<const Build> m_built;
};

} // namespace CGAL

#endif
