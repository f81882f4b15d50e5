// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_SURFACE_MESH_GEODESIC_ENCLOSURE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_SURFACE_MESH_GEODESIC_ENCLOSURE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_sources.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Arithmetic_check.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_front.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_query.h>
#include <CGAL/Surface_mesh_geodesic_offset/named_parameters.h>

#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief computes certified bounds of the geodesic distances from points, polylines and edges: for every vertex, and for every
point of the surface if the windows are kept, a proven lower and a proven upper bound of the distance. An oracle for other
methods.

The bounds are those of the mesh whose vertices have exactly the given coordinates, rounded to `double` if they are of another
type. The location of a source or of a query is classified first: barycentric coordinates that are zero up to round-off
(1e-13) put it on the edge, or at the vertex. \ref SurfaceMeshGeodesicOffsetErrorAnalysis says how the bounds are computed
and why they are certain. On most meshes they differ by a few 1e-14 of the distance. They are proven for paths that cross
fewer than 2^16 faces without a bend; if there may be others, the build ends with an exception.

The computation takes about twice the time of `Surface_mesh_geodesic_distance` for the same sources. It relies on IEEE 754
arithmetic with round to nearest, where every operation rounds to `double`: the header does not compile with `-ffast-math`,
nor with `-ffinite-math-only`, `-freciprocal-math` or `-fassociative-math` alone, nor where x87 registers are used, be it for
some operations only (`-mfpmath=both`). Builds check the arithmetic, too, as not all compilers tell their options, and builds
and queries check the rounding mode.

The template parameters are those of `Surface_mesh_geodesic_sources`; the `FT` of the traits must be `double`.
*/
template <class Traits, class VertexIndexMap = Default, class FaceIndexMap = Default, class VertexPointMap = Default>
class Surface_mesh_geodesic_enclosure
  : public Surface_mesh_geodesic_sources<Traits, VertexIndexMap, FaceIndexMap, VertexPointMap>
{
  typedef Surface_mesh_geodesic_sources<Traits, VertexIndexMap, FaceIndexMap, VertexPointMap> Base;
  static_assert(std::is_same<typename Traits::FT, double>::value,
                "Surface_mesh_geodesic_enclosure: the FT of the traits must be double, the type of the bounds");

public:
#ifdef DOXYGEN_RUNNING
  /// \name Construction
  /// @{

  /// \copydoc CGAL::Surface_mesh_geodesic_sources::Surface_mesh_geodesic_sources(const Triangle_mesh&, const Traits&, const ConcurrencyTag&)
  template <class ConcurrencyTag = Sequential_tag>
  explicit Surface_mesh_geodesic_enclosure(const Triangle_mesh& tm, const Traits& traits = Traits(),
                                           const ConcurrencyTag& tag = ConcurrencyTag());

  /// \copydoc CGAL::Surface_mesh_geodesic_sources::Surface_mesh_geodesic_sources(const Triangle_mesh&, Vertex_point_map, const Traits&, const ConcurrencyTag&)
  template <class ConcurrencyTag = Sequential_tag>
  Surface_mesh_geodesic_enclosure(const Triangle_mesh& tm, Vertex_point_map vertex_point_map,
                                  const Traits& traits = Traits(), const ConcurrencyTag& tag = ConcurrencyTag());

  /// \copydoc CGAL::Surface_mesh_geodesic_sources::Surface_mesh_geodesic_sources(const Triangle_mesh&, Vertex_index_map, Face_index_map, Vertex_point_map, const Traits&, const ConcurrencyTag&)
  template <class ConcurrencyTag = Sequential_tag>
  Surface_mesh_geodesic_enclosure(const Triangle_mesh& tm, Vertex_index_map vertex_index_map, Face_index_map face_index_map,
                                  Vertex_point_map vertex_point_map, const Traits& traits = Traits(),
                                  const ConcurrencyTag& tag = ConcurrencyTag());
  /// @}
#else
  typedef typename Base::vertex_descriptor vertex_descriptor;
  typedef typename Base::Face_location Face_location;

  using Base::Base;
#endif

  /// \name Building
  /// @{

  /// computes the bounds for the sources added so far. Without any source, all points are at infinity. In the worst case
  /// O(n^2) windows are propagated; on most meshes their number grows like n^1.5. Runs on the calling thread.
  /// \param np an optional named parameter, `keep_windows(b)`: whether the windows are kept for queries at points other than
  ///        vertices; some 100 bytes per window stay in memory then. The bounds are always those of the whole surface, as
  ///        tight as the algorithm gives them: other parameters, such as a distance limit or a tolerance, are ignored.
  /// \throws std::logic_error if the rounding mode is not to nearest, or the compiler has rearranged floating point
  ///         operations
  /// \throws std::runtime_error if thousands of windows reach one edge of a small mesh: in needle faces thinner than some
  ///         1e-4, no window may be certainly nearer than another one, so that the number of windows doubles in each face;
  ///         or if a path may cross 2^16 faces without a bend, or a distance is uncertain by more than a quarter of the mean
  ///         edge, beyond what is proven
  /// \throws std::invalid_argument if the longest edge is not between 1e-60 and 1e60, or an edge is shorter than 1e-60 times the
  ///         longest one
  template <class NamedParameters = parameters::Default_named_parameters>
  void build(const NamedParameters& np = parameters::default_values())
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    Geodesic_offset::internal::check_rounding_mode();
    Geodesic_offset::internal::check_arithmetic();
    const bool keeps = choose_parameter(get_parameter(np, internal_np::geodesic_keep_windows), false);
    if (!m_mesh) m_mesh = std::make_shared<Mesh>(this->unfolded(), [&](auto v) { return coordinates(v); });
    m_built = std::make_shared<Build>(*m_mesh, this->m_sources.initial_windows(this->unfolded()), keeps);
  }

  /// whether bounds have been computed.
  bool is_built() const { return m_built != nullptr; }

  /// the number of windows that were propagated.
  std::size_t number_of_windows() const { return built().field.windows_propagated; }
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
    const Surface_point p = this->classified(location);
    const Build& b = built();
    if (p.kind != Surface_point::VERTEX && !b.field.has_windows())
      throw std::logic_error("Surface_mesh_geodesic_enclosure: this query needs build(parameters::keep_windows(true))");
    const std::pair<double, double> d = Geodesic_offset::internal::Certified_query(*m_mesh, b.sources, b.field)(p);
    return {m_mesh->from_unit(d.first), m_mesh->from_unit(d.second)};
  }
  /// @}

private:
  typedef typename Base::Surface_point Surface_point;
  typedef Geodesic_offset::internal::Certified_mesh Mesh;

  struct Build
  {
    Build(const Mesh& mesh, const Geodesic_offset::internal::Initial_windows<double>& initial, bool keeps)
      : sources(mesh, initial)
    {
      Geodesic_offset::internal::Certified_front(mesh, keeps, field).run(sources);
    }

    Geodesic_offset::internal::Certified_sources sources;
    Geodesic_offset::internal::Certified_field field;
  };

  const Build& built() const
  {
    if (!m_built) throw std::logic_error("Surface_mesh_geodesic_enclosure: build() has not been called");
    return *m_built;
  }

  typename Mesh::Coordinates coordinates(Geodesic_offset::internal::Index v) const
  {
    const auto p = this->surface().position(this->surface().vertex_of[v]);
    return {p.x(), p.y(), p.z()};
  }

  std::shared_ptr<const Mesh> m_mesh;
  std::shared_ptr<const Build> m_built;
};

} // namespace CGAL

#endif
