// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Definitions for Certified_build.h.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_BUILD_IMPL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_BUILD_IMPL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_front.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_sources.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_state.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Offset_certification.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Rotation.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/compilation/inline_function.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Bounds of the distance of any point, from the kept windows of the certified front.
class Certified_query
{
public:
  typedef Surface_point<double> Surface_point_;
  typedef Point_in_face<double> Point;

  Certified_query(const Certified_mesh& mesh, const Certified_sources& sources, const Certified_field& field)
    : m_mesh(mesh), m_sources(sources), m_field(field)
  {
  }

  // Precondition: windows are kept, or p is a vertex. The result is in units of the certified mesh.
  std::pair<double, double> operator()(const Surface_point_& p)
  {
    m_lower = m_upper = Number_policy<double>::infinity();
    if (p.kind == Surface_point_::VERTEX) add_bounds(m_field.bounds.lower(p.element), m_field.bounds.upper(p.element));
    else
      for (Index face : faces_of(m_mesh.unfolded(), p))
      {
        Double_double_2 place;
        unsigned edges;
        m_sources.place_in_face(p, face, place, edges);
        search(face, place);
      }
    // a path that passes a vertex within the error of an image may be shorter by this amount, see the error analysis
    return {(std::max)(m_lower * (1 - 2 * unit_roundoff) - m_sources.loss, 0.), m_upper};
  }

private:
  void add_bounds(double lower, double upper)
  {
    m_lower = (std::min)(m_lower, lower);
    m_upper = (std::min)(m_upper, upper);
  }

  // Bounds for position p in the face, which is the query point up to rounding.
  void search(Index face, Double_double_2 p)
  {
    const double size = m_mesh.length(3 * face) + m_mesh.length(3 * face + 1) + m_mesh.length(3 * face + 2);
    const double moved = 4 * length_error * size;
    m_sources.for_each_in_face(face, [&](const Certified_source& s) {
      double reach;
      const double d = s.start_value + length(s.way_from(p, reach)), error = 4 * s.moved + moved + length_error * s.start_value;
      add_bounds(d - error, d + error);
    });
    for (int k = 0; k < 3; ++k)
    {
      const Index h = 3 * face + Index(k), v = m_mesh.unfolded().source(h);
      const double height = (std::max)(p.y.high, 0.), way = length(Point{p.x.high, height});
      const double rounding = length_error * (m_field.bounds.upper(v) + way);
      add_bounds(m_field.bounds.lower(v) + way - moved - rounding, m_field.bounds.upper(v) + way + moved + rounding);
      const auto place = [&](double b) { return b < m_mesh.length(h) ? Double_double(b) : m_mesh[h].length; };
      m_field.for_each_window(h, [&](const Certified_window& w) {
        const Double_double b0 = place(w.b0), b1 = place(w.b1);
        const Sign from = w.side_of(p.x, height, b0), to = w.side_of(p.x, height, b1);
        if (from == POSITIVE || to == NEGATIVE) return;
        const double d = w.distance_at(p.x.high, height);
        const double around =
          (from == ZERO ? w.way_around(p.x, height, b0) : 0.) + (to == ZERO ? w.way_around(p.x, height, b1) : 0.);
        const double error = w.radius + length_error * d + moved + 4 * w.error_of_image() + around;
        if (d + error < m_sources.least_start_value) return; // p is behind the segment that the rays start from
        add_bounds(d - error, d + error);
      });
      // transformation to the frame of the next halfedge
      const Double_double_2& c = m_mesh[m_mesh.unfolded().next(h)].corner;
      p = in_frame({-c.x, c.y}, {p.x - m_mesh[h].length, p.y});
    }
  }

  const Certified_mesh& m_mesh;
  const Certified_sources& m_sources;
  const Certified_field& m_field;
  double m_lower = 0, m_upper = 0;
};

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
