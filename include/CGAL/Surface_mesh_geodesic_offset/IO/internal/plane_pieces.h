// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Elements of offset curves in a common plane, as arcs and segments in its coordinates.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_PLANE_PIECES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_PLANE_PIECES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Element_division.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL::IO::Surface_mesh_geodesic_offset_internal {

using Geodesic_offset::internal::Space_vector;
using Geodesic_offset::internal::space_vector;

typedef std::array<double, 2> Plane_point;

inline Plane_point moved(const Plane_point& p, double s, const Plane_point& v) { return {p[0] + s * v[0], p[1] + s * v[1]}; }

// A segment, or an arc with a center.
struct Plane_piece
{
  Plane_point start{}, end{};
  Plane_point center{}; // of an arc
  double radius = 0;
  double sweep = 0; // angle of an arc, positive if counterclockwise; 0: a segment

  bool is_arc() const { return sweep != 0; }

  // Point of an arc at parameter `part`, from 0 to 1.
  Plane_point at(double part) const
  {
    const double c = std::cos(part * sweep), s = std::sin(part * sweep);
    const double x = start[0] - center[0], y = start[1] - center[1];
    return {center[0] + c * x - s * y, center[1] + s * x + c * y};
  }
};

// Orthogonal unit vectors: a plane with axes.
struct Plane_axes
{
  Space_vector x = NULL_VECTOR, y = NULL_VECTOR, normal = NULL_VECTOR;

  Plane_point operator()(const Space_vector& p) const { return {x * p, y * p}; }

  // The elements of a curve. Arcs of faces that are seen from behind are clockwise.
  template <class Curve>
  std::vector<Plane_piece> pieces(const Curve& curve, double tolerance) const
  {
    std::vector<Plane_piece> result;
    for (const auto& e : curve.elements(typename Curve::FT(tolerance)))
    {
      Plane_piece p;
      p.start = (*this)(space_vector(e.start()));
      p.end = (*this)(space_vector(e.end()));
      if (e.is_arc())
      {
        p.center = (*this)(space_vector(e.center()));
        p.radius = CGAL::to_double(e.radius());
        p.sweep = (space_vector(e.normal()) * normal < 0 ? -1 : 1) * CGAL::to_double(e.sweep());
      }
      result.push_back(p);
    }
    return result;
  }
};

// Divides an arc into equal parts of at most the given angle; calls f(piece) for each part, or for a segment.
template <class Function>
void for_each_part(const Plane_piece& piece, double largest_sweep, const Function& f)
{
  const int n = (std::max)(1, int(std::ceil(std::abs(piece.sweep) / largest_sweep)));
  Plane_piece part = piece;
  part.sweep = piece.sweep / n;
  for (int i = 1; i <= n; ++i)
  {
    part.end = i == n ? piece.end : piece.at(double(i) / n);
    f(part);
    part.start = part.end;
  }
}

} // namespace CGAL::IO::Surface_mesh_geodesic_offset_internal

#endif
