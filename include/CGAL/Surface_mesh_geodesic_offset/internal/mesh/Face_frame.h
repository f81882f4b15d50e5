// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Face frame: the frame of the first halfedge of a face, with transformations to and from the frames of its other
// halfedges.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_FACE_FRAME_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_FACE_FRAME_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
struct Point_in_face
{
  typedef FT Number;

  FT x, y;
};

template <class FT>
inline Point_in_face<FT> operator-(const Point_in_face<FT>& a, const Point_in_face<FT>& b)
{
  return {a.x - b.x, a.y - b.y};
}
template <class FT>
inline Point_in_face<FT> operator+(const Point_in_face<FT>& a, const Point_in_face<FT>& b)
{
  return {a.x + b.x, a.y + b.y};
}
// The factor may have a type that converts to FT.
template <class FT>
inline Point_in_face<FT> operator*(const typename Point_in_face<FT>::Number& s, const Point_in_face<FT>& a)
{
  return {s * a.x, s * a.y};
}
template <class FT>
inline FT cross(const Point_in_face<FT>& a, const Point_in_face<FT>& b)
{
  return a.x * b.y - a.y * b.x;
}
template <class FT>
inline FT dot(const Point_in_face<FT>& a, const Point_in_face<FT>& b)
{
  return a.x * b.x + a.y * b.y;
}
template <class FT>
inline FT length(const Point_in_face<FT>& a)
{
  return square_root<FT>(a.x * a.x + a.y * a.y);
}

template <class FT>
inline Point_in_face<FT> quarter_turn(const Point_in_face<FT>& u)
{
  return {-u.y, u.x};
}

template <class FT>
class Face_frame
{
public:
  typedef Point_in_face<FT> Point;

  Face_frame() = default;
  Face_frame(const Unfolded_mesh<FT>& mesh, Index face)
  {
    const Index h = 3 * face;
    CGAL_precondition(mesh.source(h) != no_index);
    m_corner[0] = {FT(0), FT(0)};
    m_corner[1] = {mesh[h].length, FT(0)};
    m_corner[2] = {mesh[h].apex_x, mesh[h].apex_y};
    for (int k = 0; k < 3; ++k) m_length[k] = mesh[h + Index(k)].length;
    m_direction[0] = {FT(1), FT(0)};
    // A short edge needs the vectors at the corners, since a difference of corners loses digits. If the other edge is
    // shorter, the difference is better: then the direction fits the corners within the rounding of the direction itself.
    if (m_length[1] < m_length[0]) m_direction[1] = {-mesh[h + 1].apex_x / m_length[0], mesh[h + 1].apex_y / m_length[0]};
    else m_direction[1] = (FT(1) / m_length[1]) * (m_corner[2] - m_corner[1]);
    m_direction[2] = {-mesh[h].apex_x / m_length[2], -mesh[h].apex_y / m_length[2]};
  }

  const Point& corner(int k) const { return m_corner[k]; }       // source of halfedge k
  const Point& direction(int k) const { return m_direction[k]; } // unit vector along halfedge k
  const FT& edge_length(int k) const { return m_length[k]; }
  FT longest_edge() const { return (std::max)({m_length[0], m_length[1], m_length[2]}); }

  // The point on halfedge k at distance t from its source.
  Point on_edge(int k, const FT& t) const { return m_corner[k] + t * m_direction[k]; }

  // Distance along halfedge k of the projection of p, and height of p over the halfedge (positive inside).
  FT along(int k, const Point& p) const { return dot(p - m_corner[k], m_direction[k]); }
  FT height(int k, const Point& p) const { return cross(m_direction[k], p - m_corner[k]); }

  Point vector_to_halfedge(int k, const Point& v) const { return {dot(m_direction[k], v), cross(m_direction[k], v)}; }

  // Transformation from the frame of halfedge k to the face frame.
  Point from_halfedge(int k, const Point& p) const { return m_corner[k] + vector_from_halfedge(k, p); }
  Point vector_from_halfedge(int k, const Point& v) const
  {
    return {m_direction[k].x * v.x - m_direction[k].y * v.y, m_direction[k].y * v.x + m_direction[k].x * v.y};
  }

  // Transformation from the face frame to the frame of the twin of halfedge k.
  Point to_twin(int k, const Point& p) const
  {
    const Point v = p - m_corner[(k + 1) % 3];
    return {-dot(m_direction[k], v), -cross(m_direction[k], v)};
  }

  // Barycentric coordinates with respect to the sources of the three halfedges, as in Polygon_mesh_processing.
  std::array<FT, 3> barycentric(const Point& p) const
  {
    const FT w2 = p.y / m_corner[2].y;
    const FT w1 = (p.x - w2 * m_corner[2].x) / m_corner[1].x;
    return {FT(1) - w1 - w2, w1, w2};
  }
  // Overload for a point on halfedge k: the third coordinate is exactly zero.
  std::array<FT, 3> barycentric_on_edge(int k, const Point& p) const
  {
    FT t = along(k, p) / m_length[k];
    if (t < FT(0)) t = FT(0);
    if (t > FT(1)) t = FT(1);
    Per_corner<FT> w;
    w[k] = FT(1) - t;
    w[(k + 1) % 3] = t;
    w[(k + 2) % 3] = FT(0);
    return w;
  }
  Point point(const std::array<FT, 3>& w) const { return {w[1] * m_corner[1].x + w[2] * m_corner[2].x, w[2] * m_corner[2].y}; }

private:
  Per_corner<Point> m_corner, m_direction;
  Per_corner<FT> m_length;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
