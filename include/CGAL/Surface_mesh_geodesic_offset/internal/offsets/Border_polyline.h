// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decides whether a polyline runs along the border of the surface everywhere, and so has one side only.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_BORDER_POLYLINE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_BORDER_POLYLINE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_tolerances.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Initial_windows.h>

#include <cstddef>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
class Border_polyline
{
public:
  typedef Point_in_face<FT> Point;

  // `polyline`: initial windows of a single polyline.
  Border_polyline(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& polyline) : m_mesh(mesh), m_polyline(polyline)
  {
    for_each_segment([this](const Face_frame<FT>&, Index, const Point& a, const Point& b) {
      m_length += CGAL::Geodesic_offset::internal::length(b - a);
      return true;
    });
  }

  bool operator()() const
  {
    const FT tolerance = Offset_tolerances<FT>::border_strip(m_length);
    return for_each_segment([&](const Face_frame<FT>& frame, Index face, const Point& a, const Point& b) {
      for (int k = 0; k < 3; ++k)
      {
        if (m_mesh.twin(3 * face + Index(k)) == no_index && frame.height(k, a) <= tolerance && frame.height(k, b) <= tolerance)
          return true;
        if (m_mesh.first_on_border(3 * face + Index(k)) != no_index && is_near(frame.corner(k), a, tolerance) &&
            is_near(frame.corner(k), b, tolerance))
          return true;
      }
      return false;
    });
  }

private:
  static bool is_near(const Point& p, const Point& q, const FT& tolerance) { return length(p - q) <= tolerance; }

  // Calls f(frame, face, a, b) for the segments of the polyline until it returns false. Returns true if it never did.
  template <class Function>
  bool for_each_segment(const Function& f) const
  {
    for (std::size_t i = 0; i < m_polyline.primitives.size(); ++i)
      if (m_polyline.primitives[i].is_segment && !call_in_face(m_polyline.places[i], f)) return false;
    return true;
  }

  // A segment along an edge has two faces; f needs to hold for one of them.
  template <class Function>
  bool call_in_face(const Source_place<FT>& segment, const Function& f) const
  {
    for (const Index face : faces_of(m_mesh, segment.first))
    {
      Point a, b;
      unsigned edges;
      if (position_in_face(m_mesh, segment.second, face, b, edges) && position_in_face(m_mesh, segment.first, face, a, edges))
        return f(Face_frame<FT>(m_mesh, face), face, a, b);
    }
    return false;
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Initial_windows<FT>& m_polyline;
  FT m_length = FT(0);
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
