// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where levels cross an edge. Found once an edge, so that the two faces beside it agree.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_EDGE_CROSSINGS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_EDGE_CROSSINGS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Face_field.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
class Edge_crossings
{
public:
  typedef Point_in_face<FT> Point;

  Edge_crossings(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field)
    : m_mesh(mesh), m_initial(initial), m_field(field)
  {
  }

  // The ends, between 0 and the length of the halfedge h, of the intervals on which the distance is less than the
  // level: sorted, alternately from far to near (`falling`) and from near to far. The source of h is near exactly if its
  // vertex is, and so is the target; so the number of crossings is odd exactly if the vertices differ.
  // `field` is that of the face of h.
  template <class OutputFunction>
  void operator()(Index h, const Face_field<FT>& field, const FT& level, const OutputFunction& out)
  {
    m_near.clear();
    m_length = m_mesh[h].length;
    const Index g = m_mesh.twin(h);
    const FT d0 = m_field.distance[m_mesh.source(h)], d1 = m_field.distance[m_mesh.target(h)];
    if (d0 < level) m_near.emplace_back(FT(0), level - d0);
    if (d1 < level) m_near.emplace_back(m_length - (level - d1), m_length);
    add_list(h, level, false);
    add_local(h, level, false);
    if (g != no_index)
    {
      add_list(g, level, true);
      add_local(g, level, true);
    }
    else
    { // no list beyond the border: what leaves the face here
      for (const Face_window<FT>& w : field.windows())
        if (w.origin != STARTS_IN_FACE && w.origin != Face_window_origin(h % 3))
          add_window(w, field.frame(), int(h % 3), level, false);
    }
    std::sort(m_near.begin(), m_near.end());
    const FT gap = Number_policy<FT>::rounding(64) * m_length;
    // near intervals, united
    std::size_t n = 0;
    for (const Interval& i : m_near)
    {
      if (n > 0 && i.first <= m_near[n - 1].second + gap)
        m_near[n - 1].second = (std::max)(m_near[n - 1].second, i.second);
      else
        m_near[n++] = i;
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      const bool at_source = i == 0 && d0 < level;
      const bool at_target = i + 1 == n && d1 < level;
      if (!at_source) out((std::max)(m_near[i].first, FT(0)), true);
      if (!at_target) out((std::min)(m_near[i].second, m_length), false);
    }
  }

private:
  typedef std::pair<FT, FT> Interval;

  // The distance is less than the level from lo to hi, d_lo and d_hi at the ends, and so it is as far beyond each end as
  // the distance there falls short of the level. This closes the gaps that rounding leaves between neighbouring windows.
  void add(FT lo, FT hi, const FT& level, const FT& d_lo, const FT& d_hi, bool reversed)
  {
    if (!(lo < hi)) return;
    if (d_lo < level) lo -= level - d_lo;
    if (d_hi < level) hi += level - d_hi;
    if (reversed)
      m_near.emplace_back(m_length - hi, m_length - lo);
    else
      m_near.emplace_back(lo, hi);
  }

  void add_list(Index h, const FT& level, bool reversed)
  {
    m_field.for_each_window(h, [&](const Window<FT>& w) {
      FT lo = w.b0, hi = w.b1;
      if (near_part(w.is_parallel(), w.x, w.y, FT(level - w.sigma), lo, hi))
        add(lo, hi, level, lo == w.b0 ? w.d0 : level, hi == w.b1 ? w.d1 : level, reversed);
    });
  }

  // Cuts [lo, hi] down to where the distance of an image (x : y : w), in the frame of the halfedge, is less than r.
  static bool near_part(bool parallel, const FT& x, const FT& y, const FT& r, FT& lo, FT& hi)
  {
    if (parallel)
    { // -x t < r
      if (CGAL::is_zero(x)) return CGAL::is_positive(r);
      const FT t = -r / x;
      if (CGAL::is_positive(x)) lo = (std::max)(lo, t);
      else hi = (std::min)(hi, t);
      return lo < hi;
    }
    const FT height = CGAL::abs(y);
    if (r <= height) return false;
    const FT half = square_root<FT>((r - height) * (r + height));
    lo = (std::max)(lo, FT(x - half));
    hi = (std::min)(hi, FT(x + half));
    return lo < hi;
  }

  // What starts inside the face of h, seen on h.
  void add_local(Index h, const FT& level, bool reversed)
  {
    const auto range = local_windows(m_initial, m_mesh.face(h));
    if (range.first == range.second) return;
    const Face_frame<FT> frame(m_mesh, m_mesh.face(h));
    for (auto it = range.first; it != range.second; ++it) add_window(it->window, frame, int(h % 3), level, reversed);
  }

  // A window in a face, seen on the face's halfedge k.
  void add_window(const Face_window<FT>& w, const Face_frame<FT>& frame, int k, const FT& level, bool reversed)
  {
    const Point o = frame.corner(k), u = frame.direction(k);
    FT lo(0), hi = m_length;
    const Point l = w.ray_direction(w.left), r = w.ray_direction(w.right);
    if (!clip(-cross(l, o - w.left), -cross(l, u), length(l), lo, hi)) return;
    if (!clip(cross(r, o - w.right), cross(r, u), length(r), lo, hi)) return;
    if (w.is_parallel())
    {
      const FT start = w.distance_at(o), slope = -dot(w.image(), u);
      if (w.origin == STARTS_IN_FACE && !clip(start, slope, FT(1), lo, hi)) return; // in front of the source
      if (!near_part(true, FT(-slope), FT(0), FT(level - start), lo, hi)) return;
    }
    else if (!near_part(false, frame.along(k, w.image()), frame.height(k, w.image()), FT(level - w.sigma), lo, hi))
      return;
    add(lo, hi, level, w.distance_at(o + lo * u), w.distance_at(o + hi * u), reversed);
  }

  // Cuts [lo, hi] down to where a + b t >= 0, up to rounding of the given magnitude: a source may lie on the edge.
  bool clip(const FT& a, const FT& b, const FT& magnitude, FT& lo, FT& hi) const
  {
    const FT allowance = Number_policy<FT>::rounding(256) * magnitude * m_length;
    const FT g0 = a + b * lo + allowance, g1 = a + b * hi + allowance;
    if (CGAL::is_negative(g0) && CGAL::is_negative(g1)) return false;
    const FT old = lo;
    if (CGAL::is_negative(g0)) lo = old + (g0 / (g0 - g1)) * (hi - old);
    else if (CGAL::is_negative(g1)) hi = old + (g0 / (g0 - g1)) * (hi - old);
    return true;
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Initial_windows<FT>& m_initial;
  const Geodesic_field<FT>& m_field;
  std::vector<Interval> m_near;
  FT m_length;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
