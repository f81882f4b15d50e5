// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_SURFACE_MESH_GEODESIC_ENCLOSURE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_SURFACE_MESH_GEODESIC_ENCLOSURE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

// first, so that compilation with refused options ends before the other headers
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/arithmetic_check.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_offset_certificate.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/source_classification.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief computes certified bounds of the geodesic distances from points, polylines and edges: for every vertex, and for every
point of the surface if the windows are kept, a proven lower and a proven upper bound of the distance. An oracle for other
methods.

The bounds are those of the mesh whose vertices have exactly the given coordinates, rounded to `double` if they are of another
type. The location of a source or of a query is classified first: barycentric coordinates that are zero up to round-off
(1e-13) put it at the nearest point of the edge, or at the vertex. \ref SurfaceMeshGeodesicOffsetErrorAnalysis says how
the bounds are computed and why they are certain. On most meshes they differ by a few 1e-14 of the distance. They are proven for
paths that cross fewer than 2^16 faces without a bend; if there may be others, the build ends with an exception.

The computation takes about twice the time of `Surface_mesh_geodesic_offset` for the same sources. It relies on IEEE 754
arithmetic with round to nearest, where every operation rounds to `double`: the header does not compile with `-ffast-math`,
nor with `-ffinite-math-only`, `-freciprocal-math` or `-fassociative-math` alone, nor if x87 registers are used for any operation
(`-mfpmath=both`). Builds check the arithmetic at run time, as not all compilers define macros for their options. Builds and queries
check the rounding mode.

The template parameters are those of `Surface_mesh_geodesic_offset`; the `FT` of the traits must be `double`.
*/
template <class Traits_, class VertexIndexMap = Default, class FaceIndexMap = Default, class VertexPointMap = Default>
class Surface_mesh_geodesic_enclosure
{
  static_assert(std::is_same<typename Traits_::FT, double>::value,
                "Surface_mesh_geodesic_enclosure: the FT of the traits must be double, the type of the bounds");

public:
  /// \name Types
  /// @{

  /// the traits
  typedef Traits_ Traits;
  /// the prepared mesh: plane coordinates of its faces, traits and point locator
  typedef Geodesic_mesh<Traits, VertexIndexMap, FaceIndexMap, VertexPointMap> Mesh;
  /// a set of sources
  typedef typename Mesh::Source_set Source_set;
  /// the mesh
  typedef typename Mesh::Triangle_mesh Triangle_mesh;
  /// a vertex of the mesh
  typedef typename Mesh::vertex_descriptor vertex_descriptor;
  /// an edge of the mesh
  typedef typename Mesh::edge_descriptor edge_descriptor;
  /// a face of the mesh
  typedef typename Mesh::face_descriptor face_descriptor;
  /// a point of the surface
  typedef typename Mesh::Face_location Face_location;
  /// a polyline on the surface
  typedef typename Mesh::Polyline Polyline;
  /// @}

private:
  typedef Geodesic_offset::internal::Geodesic_mesh_data<Geodesic_offset::internal::Surface_of<Mesh>> Data;
  typedef typename Data::Surface_point Surface_point;
  typedef Geodesic_offset::internal::Certified_build Build;
  typedef Geodesic_offset::internal::Curve_to_certify Curve_to_certify;

public:
  /// \name Construction
  /// @{

  /// sets up the mesh.
  /// \param tm the mesh
  /// \param np an optional sequence of named parameters, those of `Geodesic_mesh::Geodesic_mesh()` except for `edge_length_map`,
  ///        with which the call does not compile: the bounds need points
  /// \throws std::invalid_argument and std::length_error as `Geodesic_mesh::Geodesic_mesh()`
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Surface_mesh_geodesic_enclosure(const Triangle_mesh& tm, const NamedParameters& np = parameters::default_values())
    : m_mesh(tm, np)
  {
    namespace internal = Geodesic_offset::internal;
    internal::check_named_parameters<internal::Mesh_with_points_parameters, NamedParameters>();
  }

  /// Deleted: the object refers to the mesh, which must not be temporary.
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Surface_mesh_geodesic_enclosure(const Triangle_mesh&& tm,
                                           const NamedParameters& np = parameters::default_values()) = delete;

  /// shares a mesh that is set up.
  explicit Surface_mesh_geodesic_enclosure(const Mesh& mesh) : m_mesh(mesh) {}
  /// @}

  /// \name Mesh and Sources
  /// The functions that add a source are those of `Surface_mesh_geodesic_offset`, with the same parameters and exceptions.
  /// @{

  /// the prepared mesh: plane coordinates of its faces, traits and point locator.
  const Mesh& mesh() const { return m_mesh; }

  /// the sources of the next build.
  const Source_set& sources() const { return m_sources; }

  /// adds a vertex.
  template <class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_source_point(vertex_descriptor v, const NamedParameters& np = parameters::default_values())
  {
    Source_set set;
    set.add_vertex(v, np);
    return add_sources(set).front();
  }

  /// adds a point anywhere on the surface.
  template <class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_source_point(const Face_location& location, const NamedParameters& np = parameters::default_values())
  {
    Source_set set;
    set.add_location(location, np);
    return add_sources(set).front();
  }

  /// Overload for a location with the coordinates of another kernel, which are converted.
  template <class Coordinate, class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_source_point(const std::pair<face_descriptor, std::array<Coordinate, 3>>& location,
                               const NamedParameters& np = parameters::default_values())
  {
    return add_source_point(Geodesic_offset::internal::converted_location<double>(location), np);
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
  template <class LocationRange, class NamedParameters = parameters::Default_named_parameters>
  std::vector<std::size_t> add_source_points(const LocationRange& locations,
                                             const NamedParameters& np = parameters::default_values())
  {
    Source_set set;
    for (const auto& l : locations) Geodesic_offset::internal::add_point(set, l, np);
    return add_sources(set);
  }

  /// adds a polyline.
  template <class FaceLocationRange, class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_source_polyline(const FaceLocationRange& locations, const NamedParameters& np = parameters::default_values())
  {
    Source_set set;
    set.add_polyline(locations, np);
    return add_sources(set).front();
  }

  /// Overload for a polyline that is open or closed itself.
  template <class Location, class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_source_polyline(const Geodesic_polyline<Location>& polyline,
                                  const NamedParameters& np = parameters::default_values())
  {
    Source_set set;
    set.add_polyline(polyline, np);
    return add_sources(set).front();
  }

  /// adds a set of edges.
  template <class EdgeRange, class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_source_edges(const EdgeRange& edges, const NamedParameters& np = parameters::default_values())
  {
    Source_set set;
    set.add_edges(edges, np);
    return add_sources(set).front();
  }

  /// adds the sources of a set, in the order of their ids in the set.
  /// \return the ids of the sources in this object
  std::vector<std::size_t> add_sources(const Source_set& set)
  {
    return Geodesic_offset::internal::add_checked(data(), m_sources, set);
  }

  /// removes a source.
  /// \throws std::invalid_argument if there is no source with this id.
  void remove_source(std::size_t id) { m_sources.remove(id); }

  /// removes all sources.
  void clear_sources() { m_sources.clear(); }

  /// the number of sources.
  std::size_t number_of_sources() const { return m_sources.size(); }
  /// @}

  /// \name Building
  /// @{

  /// computes the bounds for the sources added so far. Without any source, all points are at infinity. In the worst case O(n^2)
  /// windows are propagated; on most meshes their number grows like n^1.5. Runs on the calling thread. Other parameters, such
  /// as a distance limit or a tolerance, do not compile: the bounds are always those of the whole surface, as tight as the
  /// algorithm gives them.
  /// \param np an optional named parameter
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{keep_windows}
  ///     \cgalParamDescription{whether the windows are kept for queries at points other than vertices; some 100 bytes per window stay
  ///                           in memory then}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`false`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \throws std::logic_error if the rounding mode is not to nearest, if the compiler has rearranged floating point
  ///         operations, or if the mesh was set up with lengths instead of points
  /// \throws std::runtime_error if thousands of windows reach one edge of a small mesh: in needle faces thinner than about
  ///         1e-4, bounds may not decide which of two windows is nearer, so that the number of windows doubles in each face;
  ///         or if a path may cross 2^16 faces without a bend, or a distance is uncertain by more than a quarter of the mean
  ///         edge: the error analysis does not cover these cases; or if a start value divided by the longest edge is not finite
  /// \throws std::invalid_argument if the longest edge is not between 1e-60 and 1e60, or an edge is shorter than 1e-60 times the
  ///         longest one
  template <class NamedParameters = parameters::Default_named_parameters>
  void build(const NamedParameters& np = parameters::default_values())
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    Geodesic_offset::internal::check_named_parameters<
      Geodesic_offset::internal::Parameter_tags<internal_np::geodesic_keep_windows_t>, NamedParameters>();
    Geodesic_offset::internal::check_rounding_mode();
    Geodesic_offset::internal::check_arithmetic();
    const bool keeps = choose_parameter(get_parameter(np, internal_np::geodesic_keep_windows), false);
    data().surface_with_points();
    const auto sources = Geodesic_offset::internal::classified_sources(data(), m_sources);
    if (!m_certified_mesh) m_certified_mesh = Build::make_mesh(data().unfolded(), data().surface());
    m_built = std::make_shared<Build>(m_certified_mesh, sources, keeps);
  }

  /// whether bounds have been computed.
  bool is_built() const { return m_built != nullptr; }

  /// the number of windows that were propagated.
  std::size_t number_of_windows() const { return built()->number_of_windows(); }
  /// @}

  /// \name Queries
  /// @{

  /// a lower and an upper bound of the distance from a `vertex_descriptor` or a `Face_location` to the nearest source; both
  /// are infinite if the point is unreachable. Takes constant time at vertices; elsewhere time linear in the number of
  /// windows of a face.
  /// \throws std::logic_error if `!is_built()`, if the location is not a vertex and the windows were not kept, or if the
  ///         rounding mode is not to nearest
  /// \throws std::invalid_argument if the location is not valid
  template <class Location>
  std::pair<double, double> distance_bounds(const Location& location) const
  {
    Geodesic_offset::internal::check_rounding_mode();
    const Surface_point p = data().classified(location);
    const Build& b = *built();
    if (p.kind != Surface_point::VERTEX && !b.has_windows())
      throw std::logic_error("Surface_mesh_geodesic_enclosure: this query needs build(parameters::keep_windows(true))");
    std::pair<double, double> bounds = b.distance_bounds(p);
    if constexpr (std::is_convertible<const Location&, vertex_descriptor>::value) // the nearest copy on a barrier
      data().unfolded().for_each_copy(p.element, [&](auto v) {
        const std::pair<double, double> c = b.distance_bounds(Surface_point::at_vertex(v));
        bounds = {(std::min)(bounds.first, c.first), (std::min)(bounds.second, c.second)};
      });
    return bounds;
  }
  /// @}

  /// \name Offsets
  /// @{

  /// checks whether curves are an offset: finds the smallest tolerance for which it is proven that they bound a region of the
  /// surface that contains all points that are nearer than `distance` minus the tolerance, and no point that is farther than
  /// `distance` plus the tolerance. If they bound no region, the result says why and where. The curves may come from any program
  /// (see `locate_polyline()`). \ref SurfaceMeshGeodesicOffsetErrorOffsets has the proof.
  ///
  /// All curves together bound the region: a point is inside if an even number of curves separates it from the sources. An open
  /// curve must end at the border, or exactly where another open curve ends; if these ends are on an edge, their locations must
  /// be in the same face. A vertex at `distance`, up to rounding, that several fans share counts as a point of the curves:
  /// where an offset touches it, the offset is this point, and has no curve there.
  ///
  /// Points of polylines are classified as sources are, and joined by straight segments in their faces. Offset curves are taken
  /// as arcs; where pieces are a rounding apart, the tolerance includes it.
  ///
  /// A face is divided into at most \f$ 2^{16} \f$ triangles, which bound the part of the region in it. So in a region that is a
  /// strip thinner than \f$ 2^{-12} \f$ of its face, as at a tiny distance from a long source, the tolerance may be as large as
  /// \f$ 2^{-12} \f$ of the face.
  ///
  /// Takes time linear in the size of the mesh, plus, for each piece of a curve, time linear in the number of windows of its
  /// face, and more near the ends of pieces and where a local maximum of the distance is close to the offset.
  ///
  /// \tparam CurveRange a model of `ConstRange` with `Polyline` as value type, or `Surface_mesh_geodesic_offset::Offset_curve`
  ///         of an object with the same mesh
  /// \param distance the requested distance
  /// \param curves the curves
  /// \throws std::logic_error if `!is_built()`, if the windows were not kept, or if the rounding mode is not to nearest
  /// \throws std::invalid_argument if the distance is negative or not finite, or if a location is not valid
  template <class CurveRange>
  Geodesic_offset_certificate<Face_location> certify_offset(double distance, const CurveRange& curves) const
  {
    Geodesic_offset::internal::check_rounding_mode();
    const std::shared_ptr<const Build> build = built(); // a share: the range of curves may build anew
    const Build& b = *build;
    if (!b.has_windows())
      throw std::logic_error("Surface_mesh_geodesic_enclosure: certify_offset() needs build(parameters::keep_windows(true))");
    if (!(distance >= 0) || !Geodesic_offset::internal::Number_policy<double>::is_finite(distance))
      throw std::invalid_argument("Surface_mesh_geodesic_enclosure: the distance of an offset is negative or not finite");
    std::vector<Curve_to_certify> given;
    for (const auto& curve : curves) given.push_back(to_certify(curve, 0));
    return exported(b.certify_offset(distance, given));
  }
  /// @}

private:
  // Of an offset curve.
  template <class Offset_curve>
  auto to_certify(const Offset_curve& curve, int) const -> decltype(curve.pieces(), Curve_to_certify())
  {
    const auto point = [](const auto& p) { return Geodesic_offset::internal::Point_in_face<double>{p.x(), p.y()}; };
    Curve_to_certify result{curve.is_closed(), {}, {}};
    for (const auto& piece : curve.pieces())
      result.pieces.push_back({data().surface().index_of(piece.face()), data().classified(piece.start()),
                               data().classified(piece.end()), point(piece.start_2()), point(piece.end_2()),
                               point(piece.is_arc() ? piece.center() : piece.start_2()), piece.is_arc() ? piece.radius() : 0.});
    return result;
  }

  // Of a polyline.
  template <class Curve>
  Curve_to_certify to_certify(const Curve& polyline, long) const
  {
    Curve_to_certify result{polyline.is_closed, {}, {}};
    for (const auto& l : polyline.locations) result.points.push_back(data().classified(l));
    return result;
  }

  Geodesic_offset_certificate<Face_location> exported(const Geodesic_offset::internal::Offset_certification_result& r) const
  {
    Geodesic_offset_certificate<Face_location> c;
    c.bounds_region = r.bounds_region;
    c.tolerance = r.tolerance;
    c.limit = r.limit;
    if (r.face != Geodesic_offset::internal::no_index) c.location = data().surface().location(r.face, r.place);
    c.distance_bounds = r.bounds;
    if (r.curve != Geodesic_offset::internal::no_curve) c.curve = r.curve;
    c.number_of_reversed_curves = r.reversed.size();
    if (!r.reversed.empty()) c.first_reversed_curve = r.reversed.front();
    return c;
  }

  const std::shared_ptr<const Build>& built() const
  {
    if (!m_built) throw std::logic_error("Surface_mesh_geodesic_enclosure: build() has not been called");
    return m_built;
  }

  const Data& data() const { return Geodesic_offset::internal::Mesh_access::data(m_mesh); }

  Mesh m_mesh;
  Source_set m_sources;
  std::shared_ptr<const Geodesic_offset::internal::Certified_mesh> m_certified_mesh;
  std::shared_ptr<const Build> m_built;
};

} // namespace CGAL

#endif
