// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Definitions for Certified_build.h.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_BUILD_IMPL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_BUILD_IMPL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_front.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_query.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Offset_certification.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/compilation/inline_function.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

struct Certified_build::Parts
{
  Parts(const std::shared_ptr<const Certified_mesh>& m, const Source_set<double>& s, bool keeps_windows)
    : mesh(m), sources(*m, s.initial_windows(m->unfolded()))
  {
    Certified_front(*mesh, keeps_windows, field).run(sources);
  }

  const std::shared_ptr<const Certified_mesh> mesh;
  Certified_sources sources;
  Certified_field field;
};

CGAL_GEODESIC_OFFSET_INLINE std::shared_ptr<const Certified_mesh> Certified_build::make_mesh(
  const Unfolded_mesh<double>& unfolded, const Surface_points<Exact_predicates_inexact_constructions_kernel>& points)
{
  return std::make_shared<Certified_mesh>(unfolded, [&](Index v) {
    const auto p = points.point_of_vertex(v);
    return Certified_mesh::Coordinates{p.x(), p.y(), p.z()};
  });
}

CGAL_GEODESIC_OFFSET_INLINE Certified_build::Certified_build(const std::shared_ptr<const Certified_mesh>& mesh,
                                                             const Source_set<double>& sources, bool keeps_windows)
  : m_parts(new Parts(mesh, sources, keeps_windows))
{
}

CGAL_GEODESIC_OFFSET_INLINE Certified_build::~Certified_build() = default;

CGAL_GEODESIC_OFFSET_INLINE bool Certified_build::has_windows() const { return m_parts->field.has_windows(); }

CGAL_GEODESIC_OFFSET_INLINE std::size_t Certified_build::number_of_windows() const { return m_parts->field.windows_propagated; }

CGAL_GEODESIC_OFFSET_INLINE Bounds Certified_build::distance_bounds(const Surface_point<double>& p) const
{
  const Bounds d = Certified_query(*m_parts->mesh, m_parts->sources, m_parts->field)(p);
  return {m_parts->mesh->from_unit(d.first), m_parts->mesh->from_unit(d.second)};
}

CGAL_GEODESIC_OFFSET_INLINE Offset_certification_result
Certified_build::certify_offset(double distance, const std::vector<Curve_to_certify>& curves) const
{
  const Certified_mesh& mesh = *m_parts->mesh;
  const auto point_to_unit = [&](const Point_in_face<double>& p) {
    return Point_in_face<double>{mesh.to_unit(p.x), mesh.to_unit(p.y)};
  };
  Offset_certification certification(mesh, m_parts->sources, m_parts->field, mesh.to_unit(distance));
  for (const Curve_to_certify& c : curves)
  {
    std::vector<Offset_curve_piece> pieces = c.pieces;
    for (Offset_curve_piece& p : pieces)
    {
      for (Point_in_face<double>* const q : {&p.start, &p.end, &p.center}) *q = point_to_unit(*q);
      p.radius = mesh.to_unit(p.radius);
    }
    const bool is_joined = c.points.empty() ? certification.curves().add_pieces(pieces, c.is_closed)
                                            : certification.curves().add_polyline(c.points, c.is_closed);
    if (!is_joined) break;
  }
  Offset_certification_result r = certification();
  r.tolerance = mesh.from_unit(r.tolerance);
  r.place = {mesh.from_unit(r.place.x), mesh.from_unit(r.place.y)};
  r.bounds = {mesh.from_unit(r.bounds.first), mesh.from_unit(r.bounds.second)};
  return r;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
