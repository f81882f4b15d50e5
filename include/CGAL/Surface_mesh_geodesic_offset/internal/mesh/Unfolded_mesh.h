// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 1 of the pipeline: the mesh as flat arrays, each face laid out in the plane.
//
// Halfedge 3f+k is the k-th halfedge of face f, starting at halfedge(f). Its frame has its origin at the source of the
// halfedge, its x axis along the halfedge, and the face above. Border halfedges have no index.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_UNFOLDED_MESH_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_UNFOLDED_MESH_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/memory/prefetch.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Layout_by_points.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_links.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <CGAL/assertions.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
struct Unfolded_halfedge
{
  FT length;
  FT apex_x, apex_y; // third vertex of the face, in the frame of this halfedge
  Index twin;        // no_index on the border
  Index origin;      // source vertex
};

// Direction at a vertex: a vector in the frame of an outgoing halfedge, inside the corner between this halfedge and the
// next one counterclockwise.
template <class FT>
struct Ray_at_vertex
{
  Index corner = no_index;
  FT x = FT(0), y = FT(0);
};

template <class FT_>
class Unfolded_mesh
{
public:
  typedef FT_ FT;
  typedef Unfolded_halfedge<FT> Halfedge;

  Unfolded_mesh() = default;

  // numbers: an Index_renumbering; links: by mesh index of the face; face_at: mesh index of each face, out of range for
  // unused indices; points: of the vertices.
  template <class Numbers, class Traits, class Team>
  Unfolded_mesh(const Numbers& numbers, const All_face_links& links, const std::vector<Index>& face_at,
                const std::vector<typename Traits::Point_3>& points, const Traits& traits, Team& team)
    : Unfolded_mesh(numbers, links, face_at, points.size(), Layout_by_points<Traits>(points, traits), team)
  {
  }

  // With another layout of faces, see Layout_by_lengths.h.
  template <class Numbers, class Layout, class Team>
  Unfolded_mesh(const Numbers& numbers, const All_face_links& links, const std::vector<Index>& face_at,
                std::size_t number_of_vertices, const Layout& layout, Team& team)
    : m_corner(number_of_vertices, no_index), m_can_bend(number_of_vertices, 0)
  {
    if constexpr (Number_policy<FT>::is_inexact) m_halfedges.resize(3 * face_at.size(), boost::container::default_init);
    else m_halfedges.resize(3 * face_at.size());
    if constexpr (std::is_same<Team, Single_worker>::value) set_up(numbers, links, face_at, layout, team, m_corner);
    else
    {
      std::vector<std::atomic<Index>> first_corners(number_of_vertices);
      for (auto& corner : first_corners) corner.store(no_index, std::memory_order_relaxed);
      set_up(numbers, links, face_at, layout, team, first_corners);
    }
  }

  // False if a face has no area (see has_area()); then the object must not be used.
  bool is_laid_out() const { return m_is_laid_out; }

  bool has_area(Index face) const
  {
    bool result = true;
    for (Index h = 3 * face; h < 3 * face + 3; ++h) result &= has_area(m_halfedges[h].length, m_halfedges[h].apex_y);
    return result;
  }

  // True if products of four lengths are within the range of the number type. Also true if the longest edge is zero or not
  // finite.
  bool has_usable_scale() const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return true;
    if (!(m_longest_edge > FT(0)) || !Number_policy<FT>::is_finite(m_longest_edge)) return true;
    return m_longest_edge > FT(small_size()) && m_longest_edge < FT(1 / small_size());
  }

  std::size_t number_of_faces() const { return m_halfedges.size() / 3; }
  std::size_t number_of_halfedges() const { return m_halfedges.size(); }
  std::size_t number_of_vertices() const { return m_corner.size(); }

  const Halfedge& operator[](Index h) const
  {
    CGAL_precondition(h < m_halfedges.size());
    return m_halfedges[h];
  }

  // Prefetches the face of h.
  void prefetch_face(Index h) const
  {
    const Halfedge* const first = &m_halfedges[3 * face(h)];
    prefetch(first, 3 * sizeof(Halfedge));
    prefetch(&first[2].origin); // possibly in a further cache line
  }

  // Without comparisons: compilers make branches of them, which are unpredictable.
  static Index next(Index h) { return h + 1 - 3 * ((h % 3) >> 1); }
  static Index previous(Index h) { return h - 1 + 3 * ((2 - h % 3) >> 1); }
  static Index face(Index h) { return h / 3; }

  Index twin(Index h) const { return m_halfedges[h].twin; }
  Index source(Index h) const { return m_halfedges[h].origin; }
  Index target(Index h) const { return m_halfedges[next(h)].origin; }
  Index apex(Index h) const { return m_halfedges[previous(h)].origin; }

  // The next corner around the source counterclockwise or clockwise; a corner is the halfedge that leaves the vertex.
  Index corner_ccw(Index h) const { return twin(previous(h)); }
  Index corner_cw(Index h) const { return twin(h) == no_index ? no_index : next(twin(h)); }

  // First corner of the vertex: the most clockwise one on the border; no_index if the vertex is isolated.
  Index corner(Index v) const { return m_corner[v]; }

  // The most clockwise corner of the fan of c if the border bounds it; no_index for a closed fan.
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

  // Calls f with the first corner of each fan; only a pinched vertex has several.
  template <class Function>
  void for_each_fan(Index v, const Function& f) const
  {
    if (m_corner[v] == no_index) return;
    f(m_corner[v]);
    auto it = std::lower_bound(m_more_fans.begin(), m_more_fans.end(), std::make_pair(v, Index(0)));
    for (; it != m_more_fans.end() && it->first == v; ++it) f(it->second);
  }

  // True if f(corner) is true for a corner of a fan; visits corners counterclockwise and stops at the first success.
  template <class Function>
  bool any_corner(Index first, const Function& f) const
  {
    Index c = first;
    do {
      if (f(c)) return true;
      c = corner_ccw(c);
    } while (c != no_index && c != first);
    return false;
  }

  // True if shortest paths can bend at the vertex: true for saddle vertices (total angle above 2 pi), border vertices with
  // an inner angle above pi, and pinched vertices.
  bool can_be_pseudo_source(Index v) const { return m_can_bend[v] != 0; }

  bool has_several_fans(Index v) const
  {
    auto it = std::lower_bound(m_more_fans.begin(), m_more_fans.end(), std::make_pair(v, Index(0)));
    return it != m_more_fans.end() && it->first == v;
  }

  const FT& longest_edge() const { return m_longest_edge; }

  double mean_edge_length() const { return m_mean_edge_length; }

  // Cosine and sine of the corner at the source of h.
  void corner_direction(Index h, FT& c, FT& s) const
  {
    const FT l = m_halfedges[previous(h)].length;
    c = m_halfedges[h].apex_x / l;
    s = m_halfedges[h].apex_y / l;
  }

private:
  static bool has_area(const FT& length, const FT& apex_y)
  {
    return length > FT(0) && Number_policy<FT>::is_finite(length) && apex_y > FT(0);
  }

  // Summary of a block of faces.
  struct Laid_out_faces
  {
    bool have_area = true;
    FT longest_edge = FT(0);
    std::size_t number = 0;
  };

  // first_corners: initially no_index; receives the lowest corner at each vertex.
  template <class Numbers, class Layout, class Team, class First_corners>
  void set_up(const Numbers& numbers, const All_face_links& links, const std::vector<Index>& face_at, const Layout& layout,
              Team& team, First_corners& first_corners)
  {
    const Blocks blocks(face_at.size(), team.size());
    std::vector<Laid_out_faces> laid_out(blocks.number());
    std::vector<double> lengths(face_at.size() / Blocks::step + 1, 0.); // sums per step, independent of the number of blocks
    blocks.for_each(team, [&](Index block, std::size_t begin, std::size_t end) {
      laid_out[block] = lay_out_faces(begin, end, numbers, links, face_at, layout, first_corners, lengths);
    });
    std::size_t number_of_faces = 0; // without unused indices
    for (const Laid_out_faces& l : laid_out)
    {
      m_is_laid_out &= l.have_area;
      m_longest_edge = (std::max)(m_longest_edge, l.longest_edge);
      number_of_faces += l.number;
    }
    if (number_of_faces > 0)
      m_mean_edge_length = std::accumulate(lengths.begin(), lengths.end(), 0.) / (3. * double(number_of_faces));
    CGAL_postcondition(!m_is_laid_out || has_consistent_twins());
    if (!m_is_laid_out) return;
    const std::size_t number_of_corners = find_corners(first_corners, team);
    CGAL_assertion(number_of_corners <= 3 * number_of_faces);
    if (number_of_corners != 3 * number_of_faces) find_more_fans();
  }

  // True if halfedges are paired consistently: twins have opposite ends and equal lengths.
  bool has_consistent_twins() const
  {
    for (Index h = 0; h < m_halfedges.size(); ++h)
    {
      const Index g = twin(h);
      if (source(h) == no_index || g == no_index) continue;
      if (g >= m_halfedges.size() || twin(g) != h || source(g) != target(h) || target(g) != source(h)) return false;
      const FT &length = m_halfedges[h].length, difference = length - m_halfedges[g].length;
      if (CGAL::abs(difference) > Number_policy<FT>::rounding(64) * length) return false;
    }
    return true;
  }

  template <class Numbers, class Layout, class First_corners>
  Laid_out_faces lay_out_faces(std::size_t begin, std::size_t end, const Numbers& numbers, const All_face_links& links,
                               const std::vector<Index>& face_at, const Layout& layout, First_corners& first_corners,
                               std::vector<double>& lengths)
  {
    constexpr std::size_t ahead = 32;
    const auto lay_out = layout.functor();
    Laid_out_faces result;
    for (std::size_t i = begin; i < end; ++i)
    {
      const Index f = face_at[i], h = Index(3 * i);
      if (i + ahead < end && face_at[i + ahead] < links.size()) prefetch(&links[face_at[i + ahead]], sizeof(Face_links));
      if (f >= links.size())
      {
        std::fill_n(m_halfedges.begin() + h, 3, Halfedge{FT(0), FT(0), FT(0), no_index, no_index});
        continue;
      }
      const Face_links& l = links[f];
      const Index v[3] = {numbers.of_vertex(l.source[0]), numbers.of_vertex(l.source[1]), numbers.of_vertex(l.source[2])};
      auto apices = lay_out(Index(i), v);
      for (std::size_t k = 0; k < 3; ++k)
      {
        auto& apex = apices[k];
        result.have_area &= has_area(apex.length, apex.y);
        result.longest_edge = (std::max)(result.longest_edge, apex.length);
        lower(first_corners[v[k]], h + Index(k));
        const Index b = l.beyond[k];
        Index twin = no_index;
        if (b != no_index)
        {
          twin = 3 * numbers.of_face(b) + links[b].halfedge_from(l.source[(k + 1) % 3]);
          // share one number between both sides of an edge: exact comparison of an expression with itself is immediate
          if constexpr (!Number_policy<FT>::is_inexact)
            if (twin < h) apex.length = m_halfedges[twin].length;
        }
        m_halfedges[h + Index(k)] = {apex.length, apex.x, apex.y, twin, v[k]};
      }
      lengths[i / Blocks::step] +=
        CGAL::to_double(apices[0].length) + CGAL::to_double(apices[1].length) + CGAL::to_double(apices[2].length);
      ++result.number;
    }
    return result;
  }

  // Atomic minimum.
  static void lower(Index& number, Index i) { number = (std::min)(number, i); }
  static void lower(std::atomic<Index>& number, Index i)
  {
    Index known = number.load(std::memory_order_relaxed);
    while (i < known && !number.compare_exchange_weak(known, i, std::memory_order_relaxed)) {}
  }

  // Corners around a vertex, from border to border or all around.
  struct Fan
  {
    Index first; // most clockwise corner if there is a border
    Index size;
    bool bends; // shortest paths can bend at the vertex
  };

  // Returns the number of corners in the first fans.
  template <class First_corners, class Team>
  std::size_t find_corners(const First_corners& first, Team& team)
  {
    const Blocks blocks(m_corner.size(), team.size());
    std::vector<std::size_t> corners(blocks.number(), 0);
    blocks.for_each(team, [&](Index block, std::size_t begin, std::size_t end) {
      std::size_t number = 0;
      for (std::size_t v = begin; v < end; ++v)
      {
        const Index corner = first[v];
        if (corner == no_index) continue;
        const Fan fan = fan_of(corner);
        m_corner[v] = fan.first;
        m_can_bend[v] = fan.bends;
        number += fan.size;
      }
      corners[block] = number;
    });
    return std::accumulate(corners.begin(), corners.end(), std::size_t(0));
  }

  void find_more_fans()
  {
    std::vector<char> seen(m_halfedges.size(), 0);
    const auto see = [&](const Fan& fan) {
      Index c = fan.first;
      for (Index i = 0; i < fan.size; ++i, c = corner_ccw(c)) seen[c] = 1;
    };
    for (const Index c : m_corner)
      if (c != no_index) see(fan_of(c));
    for (Index h = 0; h < m_halfedges.size(); ++h)
    {
      const Index v = m_halfedges[h].origin;
      if (seen[h] || v == no_index) continue;
      const Fan fan = fan_of(h);
      see(fan);
      m_more_fans.emplace_back(v, fan.first);
      m_can_bend[v] = 1;
    }
    std::sort(m_more_fans.begin(), m_more_fans.end());
  }

  // The product of the apices as complex numbers has the sum of the corner angles as its angle. Each corner angle is less
  // than pi, so each half turn changes the half-plane of the product. Its magnitude is irrelevant.
  Fan fan_of(Index first) const
  {
    FT x(1), y(0);
    int half_turns = 0;
    bool is_below = false; // angle in [pi, 2 pi)
    Fan fan{first, 0, false};
    Index c = first;
    do {
      const Halfedge& h = m_halfedges[c];
      const FT real = x * h.apex_x - y * h.apex_y;
      y = x * h.apex_y + y * h.apex_x;
      x = real;
      const Sign side = CGAL::sign(y);
      const bool was_below = is_below;
      is_below = side == ZERO ? CGAL::is_negative(x) : side == NEGATIVE;
      half_turns += int(is_below != was_below);
      keep_within_range(x, y);
      ++fan.size;
      c = corner_ccw(c);
    } while (c != no_index && c != first);
    const bool on_border = c == no_index;
    if (on_border && twin(first) != no_index) return fan_of(first_on_border(first));
    const int limit = on_border ? 1 : 2;
    if (half_turns != limit) fan.bends = half_turns > limit;
    else
    {
      if (on_border)
      {
        x = -x;
        y = -y;
      }
      const FT allowance = Number_policy<FT>::rounding(16. * fan.size);
      fan.bends = CGAL::is_negative(x) || y > allowance * (x + y);
    }
    return fan;
  }

  // Scales (x, y) such that its product with a length of usable scale does not overflow or underflow.
  static void keep_within_range(FT& x, FT& y)
  {
    if constexpr (Number_policy<FT>::is_inexact)
    {
      const FT size = CGAL::abs(x) + CGAL::abs(y);
      if (size > FT(small_size()) && size < FT(1 / small_size())) return;
      x /= size;
      y /= size;
    }
  }

  static constexpr double small_size() { return std::is_same<FT, float>::value ? 0x1p-32 : 0x1p-256; }

  boost::container::vector<Halfedge> m_halfedges;
  bool m_is_laid_out = true;
  FT m_longest_edge = FT(0);
  double m_mean_edge_length = 1;
  std::vector<Index> m_corner;
  std::vector<char> m_can_bend;
  std::vector<std::pair<Index, Index>> m_more_fans; // (vertex, first corner), sorted
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
