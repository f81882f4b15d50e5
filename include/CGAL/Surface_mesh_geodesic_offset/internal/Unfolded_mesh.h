// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 1 of the pipeline: the mesh as flat arrays, each face laid out in the plane.
//
// Halfedge 3f+k is the k-th halfedge of the face with the number f, starting at halfedge(f). Its frame has its origin at the
// source of the halfedge, its x axis along the halfedge and the face above. Border halfedges have no index.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_UNFOLDED_MESH_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_UNFOLDED_MESH_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Number_policy.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Point_conversion.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
struct Unfolded_halfedge
{
  FT length;
  FT apex_x, apex_y; // the third vertex of the face, in the frame of this halfedge
  Index twin;        // no_index on the border
  Index origin;      // vertex
};

// A direction at a vertex: a vector in the frame of a halfedge that leaves the vertex, inside the corner
// between this halfedge and the next one counterclockwise.
template <class FT>
struct Ray_at_vertex
{
  Index corner = no_index;
  FT x = FT(0), y = FT(0);
};

// Fills origins and twins. Numbers: Element_numbers of the mesh.
template <class FT, class TriangleMesh, class Numbers>
void read_topology(const TriangleMesh& tm, const Numbers& numbers, std::vector<Unfolded_halfedge<FT>>& halfedges)
{
  halfedges.assign(3 * numbers.faces_end(), Unfolded_halfedge<FT>{FT(0), FT(0), FT(0), no_index, no_index});
  for (auto f : faces(tm))
  {
    const Index fi = numbers.of(f);
    auto h = halfedge(f, tm);
    if (next(h, tm) == h || next(next(next(h, tm), tm), tm) != h)
      throw std::invalid_argument("Surface_mesh_geodesic_offset: face " + std::to_string(numbers.index_in_mesh(f)) +
                                  " is not a triangle");
    for (Index k = 0; k < 3; ++k, h = next(h, tm))
    {
      Unfolded_halfedge<FT>& u = halfedges[3 * fi + k];
      u.origin = numbers.of(source(h, tm));
      const auto o = opposite(h, tm);
      u.twin = is_border(o, tm) ? no_index : numbers.of_halfedge(o);
    }
  }
}

// Fills lengths and apices.
template <class Traits, class TriangleMesh, class Numbers, class VPM>
void lay_out_faces(const TriangleMesh& tm, const Numbers& numbers, const VPM& vpm, const Traits& traits,
                   std::vector<Unfolded_halfedge<typename Traits::FT>>& halfedges)
{
  typedef typename Traits::FT FT;
  typedef typename Traits::Point_3 Point_3;
  const auto construct_apex = traits.construct_apex_2_object();
  for (auto f : faces(tm))
  {
    const Index fi = numbers.of(f);
    std::array<Point_3, 3> p;
    auto h = halfedge(f, tm);
    for (int k = 0; k < 3; ++k, h = next(h, tm)) p[k] = converted_point<Point_3, FT>(get(vpm, source(h, tm)));
    for (int k = 0; k < 3; ++k)
    {
      Unfolded_halfedge<FT>& e = halfedges[3 * fi + k];
      construct_apex(p[k], p[(k + 1) % 3], p[(k + 2) % 3], e.length, e.apex_x, e.apex_y);
      if (!(e.length > FT(0)) || !Number_policy<FT>::is_finite(e.length) || !(e.apex_y > FT(0)))
        throw std::invalid_argument("Surface_mesh_geodesic_offset: face " + std::to_string(numbers.index_in_mesh(f)) +
                                    " is degenerate or has a coordinate that is not finite");
    }
  }
  // one number for both sides of an edge: an exact number knows itself at once
  for (std::size_t h = 0; h < halfedges.size(); ++h)
    if (halfedges[h].twin < h) halfedges[h].length = halfedges[halfedges[h].twin].length;
}

template <class FT_>
class Unfolded_mesh
{
public:
  typedef FT_ FT;
  typedef Unfolded_halfedge<FT> Halfedge;

  Unfolded_mesh() = default;

  template <class TriangleMesh, class Numbers, class VPM, class Traits>
  Unfolded_mesh(const TriangleMesh& tm, const Numbers& numbers, const VPM& vpm, const Traits& traits)
  {
    read_topology(tm, numbers, m_halfedges);
    lay_out_faces(tm, numbers, vpm, traits, m_halfedges);
    m_corner.assign(numbers.vertices_end(), no_index);
    m_can_bend.assign(numbers.vertices_end(), 0);
    find_corners();
    for (const Halfedge& h : m_halfedges) m_longest_edge = (std::max)(m_longest_edge, h.length);
  }

  std::size_t number_of_faces() const { return m_halfedges.size() / 3; }
  std::size_t number_of_halfedges() const { return m_halfedges.size(); }
  std::size_t number_of_vertices() const { return m_corner.size(); }

  const Halfedge& operator[](Index h) const { return m_halfedges[h]; }

  // without comparisons, of which compilers make branches that could not be foreseen
  static Index next(Index h) { return h + 1 - 3 * (h % 3 >> 1); }
  static Index previous(Index h) { return h + 2 - 3 * ((h % 3 + 1) >> 1); }
  static Index face(Index h) { return h / 3; }

  Index twin(Index h) const { return m_halfedges[h].twin; }
  Index source(Index h) const { return m_halfedges[h].origin; }
  Index target(Index h) const { return m_halfedges[next(h)].origin; }
  Index apex(Index h) const { return m_halfedges[previous(h)].origin; }

  // The corner, that is the halfedge leaving the same vertex, that follows counterclockwise / clockwise.
  Index corner_ccw(Index h) const { return twin(previous(h)); }
  Index corner_cw(Index h) const { return twin(h) == no_index ? no_index : next(twin(h)); }

  // A first corner of the vertex: the most clockwise one if the vertex is on the border; none if isolated.
  Index corner(Index v) const { return m_corner[v]; }

  // The most clockwise corner of the fan of c, if it is bounded by the border; no_index if it closes.
  Index first_on_border(Index c) const
  {
    Index first = c;
    for (Index d = corner_cw(c); d != no_index; d = corner_cw(d))
    {
      if (d == c) return no_index;
      first = d;
    }
    return first;
  }

  // First corners of the further fans of a vertex in which several fans meet (a pinched vertex).
  template <class Function>
  void for_each_fan(Index v, const Function& f) const
  {
    if (m_corner[v] == no_index) return;
    f(m_corner[v]);
    auto it = std::lower_bound(m_more_fans.begin(), m_more_fans.end(), std::make_pair(v, Index(0)));
    for (; it != m_more_fans.end() && it->first == v; ++it) f(it->second);
  }

  // Can shortest paths bend here? True for saddle vertices (total angle above 2 pi), border vertices with an
  // inner angle above pi, and pinched vertices.
  bool can_be_pseudo_source(Index v) const { return m_can_bend[v] != 0; }

  bool has_several_fans(Index v) const
  {
    auto it = std::lower_bound(m_more_fans.begin(), m_more_fans.end(), std::make_pair(v, Index(0)));
    return it != m_more_fans.end() && it->first == v;
  }

  const FT& longest_edge() const { return m_longest_edge; }

  FT mean_edge_length() const
  {
    FT sum(0);
    for (const Halfedge& h : m_halfedges) sum += h.length;
    return m_halfedges.empty() ? FT(1) : FT(sum / FT(double(m_halfedges.size())));
  }

  // Cosine and sine of the corner at the source of h.
  void corner_direction(Index h, FT& c, FT& s) const
  {
    const FT l = m_halfedges[previous(h)].length;
    c = m_halfedges[h].apex_x / l;
    s = m_halfedges[h].apex_y / l;
  }

private:
  void find_corners()
  {
    std::vector<char> seen(m_halfedges.size(), 0);
    for (Index h = 0; h < m_halfedges.size(); ++h)
    {
      if (seen[h] || m_halfedges[h].origin == no_index) continue;
      const Index v = m_halfedges[h].origin;
      Index first = h;
      for (Index c = corner_cw(h); c != no_index && c != h; c = corner_cw(c)) first = c;
      const bool on_border = corner_cw(first) == no_index;
      if (!on_border) first = h;
      const bool bends = visit_fan(first, on_border, seen);
      if (m_corner[v] == no_index)
      {
        m_corner[v] = first;
        m_can_bend[v] = bends;
      }
      else
      {
        m_more_fans.emplace_back(v, first);
        m_can_bend[v] = 1;
      }
    }
    std::sort(m_more_fans.begin(), m_more_fans.end());
  }

  // Adds the corner angles as unit complex numbers: `residual` has an angle in [0, pi), and every half turn
  // passed is counted. Returns whether shortest paths can bend at the fan's vertex.
  bool visit_fan(Index first, bool on_border, std::vector<char>& seen) const
  {
    FT rc(1), rs(0);
    int half_turns = 0, degree = 0;
    Index c = first;
    do
    {
      seen[c] = 1;
      ++degree;
      FT cc, cs;
      corner_direction(c, cc, cs);
      const FT x = rc * cc - rs * cs, y = rc * cs + rs * cc;
      rc = x;
      rs = y;
      if (CGAL::is_negative(rs) || (CGAL::is_zero(rs) && CGAL::is_negative(rc)))
      {
        rc = -rc;
        rs = -rs;
        ++half_turns;
      }
      c = corner_ccw(c);
    } while (c != no_index && c != first);
    const FT allowance = Number_policy<FT>::rounding(16. * degree);
    const int limit = on_border ? 1 : 2;
    if (half_turns != limit) return half_turns > limit;
    return rs > allowance || CGAL::is_negative(rc);
  }

  std::vector<Halfedge> m_halfedges;
  FT m_longest_edge = FT(0);
  std::vector<Index> m_corner;
  std::vector<char> m_can_bend;
  std::vector<std::pair<Index, Index>> m_more_fans; // (vertex, first corner), sorted
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
