// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers for points of the surface, the same one for points that coincide within a tolerance.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_COINCIDING_PLACES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_COINCIDING_PLACES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <map>
#include <tuple>

namespace CGAL::Geodesic_offset::internal {

// A point gets the number of the first known point within the tolerance in one of its faces, or else a new one: so points of
// one number are no farther apart than twice the tolerance, however many there are. The points of a face are found in a grid of
// squares.
template <class FT>
class Coinciding_places
{
public:
  Coinciding_places(const Unfolded_mesh<FT>& mesh, double tolerance) : m_mesh(mesh), m_tolerance(tolerance) {}

  Index number_of(const Surface_point<FT>& p)
  {
    for (const Index f : faces_of(m_mesh, p))
      if (const Index known = number_in_face(f, position(p, f)); known != no_index) return known;
    for (const Index f : faces_of(m_mesh, p)) m_at.emplace(square_of(f, position(p, f)), Place{position(p, f), m_size});
    return m_size++;
  }

private:
  typedef Point_in_face<double> Point;
  typedef std::tuple<Index, double, double> Square; // of a face; integers

  struct Place
  {
    Point point;
    Index number;
  };

  Point position(const Surface_point<FT>& p, Index face) const
  {
    Point_in_face<FT> result{FT(0), FT(0)};
    unsigned edges;
    position_in_face(m_mesh, p, face, result, edges);
    return {CGAL::to_double(result.x), CGAL::to_double(result.y)};
  }

  Square square_of(Index face, const Point& p) const
  {
    return {face, std::floor(p.x / m_tolerance), std::floor(p.y / m_tolerance)};
  }

  Index number_in_face(Index face, const Point& p) const
  {
    for (const double x : {-1., 0., 1.})
      for (const double y : {-1., 0., 1.})
      {
        const auto [first, last] = m_at.equal_range(square_of(face, p + m_tolerance * Point{x, y}));
        for (auto i = first; i != last; ++i)
          if (length(i->second.point - p) <= m_tolerance) return i->second.number;
      }
    return no_index;
  }

  const Unfolded_mesh<FT>& m_mesh;
  const double m_tolerance;
  std::multimap<Square, Place> m_at;
  Index m_size = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
