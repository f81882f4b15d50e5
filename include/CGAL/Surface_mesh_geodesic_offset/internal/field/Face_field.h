// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 4 of the pipeline: the distance inside a face, as the minimum over the windows that enter the face, the sources inside
// it, and the functions d(v) + |p - v| of its corners.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FIELD_FACE_FIELD_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FIELD_FACE_FIELD_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Face_window.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Geodesic_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Vertex_sector.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Initial_windows.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Interval_filter.h>

#include <CGAL/Iterator_range.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// The range of windows that start inside a face.
template <class FT>
inline auto local_windows(const Initial_windows<FT>& initial, Index face)
{
  typedef typename Initial_windows<FT>::Local_window Local_window;
  struct By_face
  {
    bool operator()(const Local_window& a, Index f) const { return a.face < f; }
    bool operator()(Index f, const Local_window& a) const { return f < a.face; }
  };
  return std::equal_range(initial.local.begin(), initial.local.end(), face, By_face());
}

template <class FT>
class Face_field
{
public:
  typedef Point_in_face<FT> Point;
  typedef Face_window<FT> Window_in_face;

  // Call set_face() before any query; one object serves many faces.
  Face_field(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field)
    : m_mesh(mesh), m_initial(initial), m_field(field)
  {
  }

  Face_field(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field, Index face)
    : Face_field(mesh, initial, field)
  {
    set_face(face);
  }

  // `limit`: windows that enter the face or start at a corner are left out if they have no smaller distance.
  void set_face(Index face, const FT& limit = Number_policy<FT>::infinity())
  {
    set_frame(face);
    for (int k = 0; k < 3; ++k)
      m_field.for_each_window(m_mesh, 3 * face + Index(k), [&](const Window<FT>& w) {
        if (const FT lowest = minimum(w); may_be_less(lowest, limit)) add_window(w, k, lowest);
      });
    add_local_windows();
    for (int k = 0; k < 3; ++k)
      if (may_be_less(m_field.distance[m_mesh.source(3 * face + Index(k))], limit)) add_corner(k);
  }

  // Overload for one point: of the kept windows, only windows whose distance at p is the given one up to rounding.
  void set_face_at(Index face, const Point& p, const FT& distance)
  {
    set_frame(face);
    const FT limit = distance + rounding_of(distance);
    add_local_windows();
    for (int k = 0; k < 3; ++k)
    {
      const Point q = m_frame.vector_to_halfedge(k, p - m_frame.corner(k));
      m_field.kept.for_each_within(3 * face + Index(k), m_mesh[3 * face + Index(k)].length, m_field.distance,
                                   m_field.source_ref, q, error_of_rays(m_mesh, FT(distance + m_size)), limit,
                                   [&](const Window<FT>& w) { add_window(w, k, minimum(w)); });
      if (m_field.distance[m_mesh.source(3 * face + Index(k))] + length(p - m_frame.corner(k)) <= limit) add_corner(k);
    }
  }

  // Sets a face without windows.
  void set_frame(Index face)
  {
    m_face = face;
    m_frame = Face_frame<FT>(m_mesh, face);
    m_size = m_frame.longest_edge();
    m_windows.clear();
    m_lowest.clear();
    m_windows.reserve(16);
    m_lowest.reserve(16);
  }

  Index face() const { return m_face; }
  const Face_frame<FT>& frame() const { return m_frame; }
  const FT& size() const { return m_size; } // length of the longest edge
  const std::vector<Window_in_face>& windows() const { return m_windows; }
  const FT& lowest(std::size_t i) const { return m_lowest[i]; } // smallest distance on the window's chord
  bool has_local_sources() const { return m_has_local_sources; }

  // Distance of p, and a window that attains it. Of windows equal up to rounding, one whose rays reach p comes first, then one
  // of a side of a segment before one of a cap. A path around a chord is valid too, so a point between two cones has a finite
  // distance.
  FT distance(const Point& p, std::size_t& nearest) const
  {
    return distance(p, nearest,
                    CGAL::make_range(boost::counting_iterator<std::size_t>(0),
                                     boost::counting_iterator<std::size_t>(m_windows.size())));
  }

  // Overload for some windows, given by their indices in ascending order; indices behind the last window are ignored.
  template <class Indices>
  FT distance(const Point& p, std::size_t& nearest, const Indices& indices) const
  {
    FT best = Number_policy<FT>::infinity();
    nearest = m_windows.size();
    for (const std::size_t i : indices)
    {
      if (!(i < m_windows.size())) break;
      if (!(m_lowest[i] <= best)) continue;
      const FT d = m_windows[i].path_length(p);
      if (!Number_policy<FT>::is_finite(d)) continue;
      const bool ties = Number_policy<FT>::is_finite(best) && tie(d, best);
      if (ties ? preference(i, p) > preference(nearest, p) : d < best) nearest = i;
      best = (std::min)(best, d);
    }
    return best;
  }

  // True for two finite distances that are equal up to rounding.
  bool tie(const FT& d, const FT& e) const { return CGAL::abs(d - e) <= rounding_of((std::min)(d, e)); }

  bool is_cap(std::size_t i) const { return m_windows[i].source_ref.side() == Source_side::CAP; }

  bool contains(std::size_t i, const Point& p) const { return m_windows[i].contains(p, rounding_of(FT(0))); }

  int preference(std::size_t i, const Point& p) const { return 2 * int(contains(i, p)) + int(!is_cap(i)); }

private:
  void add_local_windows()
  {
    const auto range = local_windows(m_initial, m_face);
    for (auto it = range.first; it != range.second; ++it)
      if (!is_dominated(it->window)) add(it->window, it->window.start_value);
    m_has_local_sources = range.first != range.second;
  }

  static bool may_be_less(const FT& a, const FT& b) { return CGAL::possibly(estimate(a) < estimate(b)); }

  // True for a fan of a source vertex with a shorter path to another source.
  bool is_dominated(const Window_in_face& w) const
  {
    if (w.origin != STARTS_AT_CORNER || CGAL::is_zero(w.start_value)) return false;
    const FT& d = m_field.distance[m_mesh.source(3 * m_face + Index(w.edge))];
    return d < w.start_value && !tie(d, w.start_value);
  }

  FT rounding_of(const FT& distance) const { return Number_policy<FT>::rounding(64) * (distance + m_size); }

  void add(const Window_in_face& w, const FT& lowest)
  {
    m_windows.push_back(w);
    m_lowest.push_back(lowest);
  }

  // Adds the function d(v) + |p - v| of a corner. Its cone is the part of the corner where shortest paths continue behind the
  // vertex. Without such a part the cone is empty, and the function is an upper bound only.
  void add_corner(int k)
  {
    const Index h = 3 * m_face + Index(k), v = m_mesh.source(h);
    const FT& d = m_field.distance[v];
    if (CGAL::is_zero(d) || !Number_policy<FT>::is_finite(d)) return;
    const bool has_direction = m_field.back[v].corner != no_index;
    if (!has_direction && d == m_field.start_values.of(m_field.source_ref[v])) return; // rays from sources are local windows
    if (!m_mesh.can_be_pseudo_source(v)) return add_cone(k, d, FT(0), FT(0));
    if (m_mesh.has_several_fans(v) || !has_direction) return add_cone(k, d, FT(0), m_frame.edge_length((k + 1) % 3));
    const Vertex_sector<FT> sector(m_mesh);
    FT left(0), right(0);
    sector.for_each_sector_behind(m_field.back[v].ray(), [&](const auto& from, const auto& to, Index first) {
      const FT length = m_frame.edge_length((k + 1) % 3);
      const Ray_at_vertex<FT>*lower, *upper;
      if (!sector.part_in_corner(from, to, first, h, lower, upper)) return;
      const FT r = lower ? FT(length - sector.exit_of_ray(h, *lower)) : FT(0);
      const FT l = upper ? FT(length - sector.exit_of_ray(h, *upper)) : length;
      if (!(r < l)) return;
      // At a border vertex both sectors may lie in one corner; one cone then covers both.
      right = left > FT(0) ? (std::min)(right, r) : r;
      left = (std::max)(left, l);
    });
    add_cone(k, d, right, left);
  }

  // Adds the rays from corner k between two points of the opposite edge. d is the distance of the corner.
  void add_cone(int k, const FT& d, const FT& right, const FT& left)
  {
    const Point& c = m_frame.corner(k);
    const int opposite = (k + 1) % 3;
    const Index v = m_mesh.source(3 * m_face + Index(k));
    add(Window_in_face{c.x, c.y, d, m_frame.on_edge(opposite, left), m_frame.on_edge(opposite, right), m_field.source_ref[v],
                       Window<FT>::make_bits(false, v), STARTS_AT_CORNER, (unsigned char)(k)},
        d);
  }

  void add_window(const Window<FT>& w, int k, const FT& lowest)
  {
    Window_in_face f;
    const Point s = w.is_parallel() ? m_frame.vector_from_halfedge(k, {w.x, w.y}) : m_frame.from_halfedge(k, {w.x, w.y});
    f.x = s.x;
    f.y = s.y;
    f.sigma = w.is_parallel() ? FT(w.sigma + dot(s, m_frame.corner(k))) : w.sigma;
    f.left = m_frame.on_edge(k, w.b0);
    f.right = m_frame.on_edge(k, w.b1);
    if constexpr (Number_policy<FT>::is_inexact)
      if (!w.is_parallel())
      {
        f.to = m_frame.vector_from_halfedge(k, {w.t0, FT(1)});
        f.from = m_frame.vector_from_halfedge(k, {w.t1, FT(1)});
      }
    f.source_ref = w.source_ref;
    f.bits = w.bits & ~2u;
    f.origin = Face_window_origin(k);
    f.edge = (unsigned char)(k);
    add(f, lowest);
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Initial_windows<FT>& m_initial;
  const Geodesic_field<FT>& m_field;
  Index m_face = no_index;
  Face_frame<FT> m_frame;
  FT m_size = FT(0);
  std::vector<Window_in_face> m_windows;
  std::vector<FT> m_lowest;
  bool m_has_local_sources = false;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
