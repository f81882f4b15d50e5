// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One call of a free function: its mesh, sources and build.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FUNCTIONS_ONE_CALL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FUNCTIONS_ONE_CALL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_mesh_type.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/statistics_report.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/build_parameters.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/Source_argument.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/source_classification.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <memory>

namespace CGAL::Geodesic_offset::internal {

// A vertex, a location or a point in space, classified on the mesh.
template <class Mesh, class From>
auto classified_start(const Mesh& mesh, const From& from)
{
  if constexpr (is_point_in_space<From>)
    return Mesh_access::data(mesh).classified(mesh.locate(converted_point<typename Mesh::Point_3, typename Mesh::FT>(from)));
  else return Mesh_access::data(mesh).classified(from);
}

template <class TriangleMesh, class Sources, class NamedParameters>
class One_call
{
public:
  typedef Geodesic_mesh_type<TriangleMesh, NamedParameters> Mesh;
  typedef Surface_of<Mesh> Surface;
  typedef typename Surface::Number Number;
  typedef typename Surface::vertex_descriptor vertex_descriptor;
  typedef Geodesic_build<typename Surface::Computing_traits> Build;
  typedef Build_request<Number> Request;
  typedef Concurrency_tag_of<NamedParameters> Concurrency_tag;

  // Points in space are joined by paths, which need kept windows; so there is one propagation for both.
  static constexpr unsigned parts = build_parts_of<NamedParameters> | (has_points_in_space<Sources> ? KEPT_WINDOWS : NO_PARTS);

  One_call(const TriangleMesh& tm, const Sources& sources, const NamedParameters& np)
    : m_mesh(Mesh_access::make<Mesh>(tm, np)), m_np(np)
  {
    Source_argument<Mesh>(m_mesh, m_sources).read(sources);
  }

  const Mesh& mesh() const { return m_mesh; }
  const auto& data() const { return Mesh_access::data(m_mesh); }

  Request request() const
  {
    return read_build_request<Number>(m_np, [this](const auto& t) { return data().classified(t); });
  }

  // The build before its propagation.
  Build build(const Request& request) const { return Build(data().unfolded(), classified_sources(data(), m_sources), request); }

  // The build after its propagation, without offset curves. `more_parts`: those that the request needs beyond its
  // parameters, see Build_part.
  template <unsigned more_parts = NO_PARTS>
  std::unique_ptr<const Build> propagated(const Request& request) const
  {
    std::unique_ptr<Build> result(new Build(build(request)));
    result->template propagate<Concurrency_tag, Build::parts_for(parts | more_parts)>(data().traits);
    report(result->statistics, m_np);
    return result;
  }

private:
  Mesh m_mesh;
  typename Mesh::Source_set m_sources;
  const NamedParameters& m_np;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
