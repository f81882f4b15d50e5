// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces of an unfolded mesh with twice the digits, from the coordinates of the vertices, which count as exact.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_MESH_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_MESH_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/memory/prefetch.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Double_double.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_window.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Lengths are in units of a power of two near the longest edge. Components of unit vectors have errors of at most 2^-98,
// lengths have relative errors of at most 2^-98.
class Certified_mesh
{
public:
  typedef std::array<double, 3> Coordinates;

  struct Halfedge
  {
    Double_double length;
    Double_double_2 corner; // unit vector to the apex, in the frame of the halfedge
  };

  // position(v): coordinates of vertex v.
  template <class Position>
  Certified_mesh(const Unfolded_mesh<double>& unfolded, const Position& position)
    : m_unfolded(unfolded), m_halfedges(unfolded.number_of_halfedges()), m_can_bend(unfolded.number_of_vertices(), 0)
  {
    double longest = 1;
    for (Index h = 0; h < m_halfedges.size(); ++h)
      longest = h == 0 ? unfolded[h].length : (std::max)(longest, unfolded[h].length);
    if (!(0x1p-200 < longest && longest < 0x1p200))
      throw std::invalid_argument("Surface_mesh_geodesic_enclosure: the longest edge must be between 1e-60 and 1e60");
    m_unit = std::ldexp(1., std::ilogb(longest));
    const double scale = 1 / m_unit; // powers of two: exact
    std::vector<Coordinates> points(unfolded.number_of_vertices());
    for (Index v = 0; v < points.size(); ++v)
    {
      if (unfolded.corner(v) == no_index) continue; // vertices that are not in the mesh have no position
      points[v] = position(v);
      for (double& x : points[v]) x *= scale;
    }
    for (Index h = 0; h < m_halfedges.size(); ++h)
    { // one length for both sides
      const Index t = unfolded.twin(h);
      if (unfolded.source(h) == no_index) continue;
      m_halfedges[h].length =
        t < h ? m_halfedges[t].length : edge_length(points[unfolded.source(h)], points[unfolded.target(h)]);
    }
    for (Index h = 0; h < m_halfedges.size(); ++h)
      if (unfolded.source(h) != no_index && !(length(h) > 0x1p-200)) // squares of areas of longer edges have all their digits
        throw std::invalid_argument("Surface_mesh_geodesic_enclosure: an edge is shorter than 1e-60 times the longest one");
    for (Index f = 0; f < unfolded.number_of_faces(); ++f)
      if (unfolded.source(3 * f) != no_index) find_corners(f, points);
    for (Index h = 0; h < m_halfedges.size(); ++h) // a vertex is at least as far from another one as from the opposite edges
      if (unfolded.source(h) != no_index)
        m_loss = (std::max)({m_loss, loss_beside_vertex(length(h)), loss_beside_vertex(apex(h).y.high)});
    for (Index v = 0; v < unfolded.number_of_vertices(); ++v) m_can_bend[v] = bends(v);
  }

  const Unfolded_mesh<double>& unfolded() const { return m_unfolded; }
  const Halfedge& operator[](Index h) const { return m_halfedges[h]; }
  double length(Index h) const { return m_halfedges[h].length.high; }

  // Prefetches the face of h.
  void prefetch_face(Index h) const { prefetch(&m_halfedges[3 * Unfolded_mesh<double>::face(h)], 3 * sizeof(Halfedge)); }

  // The third vertex of the face, in the frame of h.
  Double_double_2 apex(Index h) const
  {
    const Double_double_2& c = m_halfedges[h].corner;
    const Double_double& l = m_halfedges[m_unfolded.previous(h)].length;
    return {c.x * l, c.y * l};
  }

  // Of paths that pass a vertex beside another one, see loss_beside_vertex().
  double loss_beside_vertices() const { return m_loss; }

  // True if shortest paths bend at a vertex. False if the excess of its angle is below `flat`, see the error analysis.
  bool can_be_pseudo_source(Index v) const { return m_can_bend[v] != 0; }
  static constexpr double flat = 0x1p-80;

  double to_unit(double x) const { return x / m_unit; }
  double from_unit(double x) const { return x * m_unit; }

private:
  typedef std::array<Double_double, 3> Vector;

  static Vector difference(const Coordinates& p, const Coordinates& q)
  {
    return {two_sum(q[0], -p[0]), two_sum(q[1], -p[1]), two_sum(q[2], -p[2])};
  }

  static Double_double dot(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

  static Double_double edge_length(const Coordinates& p, const Coordinates& q)
  {
    const Vector u = difference(p, q);
    return square_root(dot(u, u));
  }

  void find_corners(Index f, const std::vector<Coordinates>& points)
  {
    const Index h = 3 * f;
    const Coordinates &p = points[m_unfolded.source(h)], &q = points[m_unfolded.source(h + 1)],
                      &r = points[m_unfolded.source(h + 2)];
    const Vector u[3] = {difference(p, q), difference(q, r), difference(r, p)};
    // twice the area from the two shorter edges: the difference of long edges would lose digits
    int longest = 0;
    for (int k : {1, 2})
      if (length(h + Index(k)) > length(h + Index(longest))) longest = k;
    const Vector &a = u[(longest + 1) % 3], &b = u[(longest + 2) % 3];
    const Vector n = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const Double_double area = square_root(dot(n, n));
    for (Index k = 0; k < 3; ++k)
    {
      const Double_double scale = Double_double(1) / (m_halfedges[h + k].length * m_halfedges[h + (k + 2) % 3].length);
      m_halfedges[h + k].corner = {-dot(u[k], u[(k + 2) % 3]) * scale, area * scale};
    }
  }

  // Uses doubles first, and twice the digits if the angle is flat within the rounding of doubles.
  bool bends(Index v) const
  {
    if (m_unfolded.corner(v) == no_index) return false;
    if (m_unfolded.has_several_fans(v)) return true;
    bool result;
    if (bends<double>(v, 0x1p-48, result) || bends<Double_double>(v, flat, result)) return result;
    return false;
  }

  static double high(double x) { return x; }
  static double high(const Double_double& x) { return x.high; }
  static void get(const Double_double& x, double& y) { y = x.high; }
  static void get(const Double_double& x, Double_double& y) { y = x; }

  // Product of the corners as unit complex numbers, as in Unfolded_mesh::fan_of(). Returns false if the errors leave the
  // result undecided.
  template <class Number>
  bool bends(Index v, double error_of_corner, bool& result) const
  {
    Number x(1.), y(0.);
    int half_turns = 0, degree = 0;
    bool is_certain = true;
    const Index first = m_unfolded.corner(v);
    Index c = first;
    do {
      Number cx, cy;
      get(m_halfedges[c].corner.x, cx);
      get(m_halfedges[c].corner.y, cy);
      const Number t = x * cx - y * cy;
      y = x * cy + y * cx;
      x = t;
      ++degree;
      if (high(x) > 0 && high(y) < 0 && high(y) >= -error_of_corner * degree) is_certain = false; // a very narrow corner
      if (high(y) < 0 || (high(y) == 0 && high(x) < 0))
      {
        x = -x;
        y = -y;
        ++half_turns;
      }
      c = m_unfolded.corner_ccw(c);
    } while (c != no_index && c != first);
    const int limit = c == no_index ? 1 : 2; // half turns of a flat vertex
    const bool is_near = std::abs(high(y)) <= error_of_corner * degree;
    if (is_near && high(x) < 0) ++half_turns;
    result = is_near ? half_turns > limit : half_turns >= limit;
    if (!is_certain && std::is_same<Number, Double_double>::value) return result = true; // additional rays are harmless
    return is_certain && (!is_near || half_turns != limit);
  }

  const Unfolded_mesh<double>& m_unfolded;
  double m_unit = 1;
  std::vector<Halfedge> m_halfedges;
  std::vector<char> m_can_bend;
  double m_loss = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
