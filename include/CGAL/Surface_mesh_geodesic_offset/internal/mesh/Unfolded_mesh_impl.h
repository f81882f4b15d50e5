// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Definitions for Unfolded_mesh.h.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_UNFOLDED_MESH_IMPL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_UNFOLDED_MESH_IMPL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Lays faces out in the plane, from the points of their vertices. A layout has a function functor(), whose result is called with a face and its vertices, and returns an array of lengths and
// apices; see SurfaceMeshGeodesicOffsetTraits::Construct_apices_2.
template <class Traits>
class Layout_by_points
{
public:
  typedef typename Traits::FT FT;

  // points: of the vertices
  Layout_by_points(const std::vector<typename Traits::Point_3>& points, const Traits& traits)
    : m_points(points), m_traits(traits)
  {
  }

  auto functor() const
  {
    return [&points = m_points, construct_apices = m_traits.construct_apices_2_object()](Index, const Index(&v)[3]) {
      return construct_apices(points[v[0]], points[v[1]], points[v[2]]);
    };
  }

private:
  const std::vector<typename Traits::Point_3>& m_points;
  const Traits& m_traits;
};

// Lays faces out from the lengths of their edges. Has a function functor(), as Layout_by_points.
template <class FT_>
class Layout_by_lengths
{
public:
  typedef FT_ FT;

  // lengths: of the halfedges
  explicit Layout_by_lengths(const std::vector<FT>& lengths) : m_lengths(lengths) {}

  auto functor() const
  {
    return [&lengths = m_lengths](Index f, const Index(&)[3]) {
      std::array<Apex, 3> result;
      for (std::size_t k = 0; k < 3; ++k)
      {
        result[k].length = lengths[3 * f + k];
        if (!CGAL::is_positive(result[k].length)) return result;
      }
      const FT area = twice_the_area(result[0].length, result[1].length, result[2].length);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const FT &a = result[k].length, &b = result[(k + 1) % 3].length, &c = result[(k + 2) % 3].length;
        // (a^2 - b^2 + c^2) / 2a. With c much shorter than a, the second form would cancel and lose the direction of the apex; with
        // a much shorter than c, the first one. Binding test: test_distance_errors, lengths.
        if (c < a) result[k].x = FT(FT(FT(a - b) * FT(a + b)) + FT(c * c)) / FT(a + a);
        else result[k].x = FT(FT(FT(c - b) * FT(c + b)) / a + a) / FT(2);
        result[k].y = area / a;
      }
      return result;
    };
  }

private:
  struct Apex
  {
    FT length = FT(0), x = FT(0), y = FT(0);
  };

  // Heron's formula in the form of Kahan, whose differences are exact or harmless. 0 if the strict triangle inequality fails.
  static FT twice_the_area(FT a, FT b, FT c)
  {
    if (a < b) std::swap(a, b);
    if (b < c) std::swap(b, c);
    if (a < b) std::swap(a, b);
    const FT least = c - FT(a - b);
    if (!CGAL::is_positive(least)) return FT(0);
    return square_root<FT>(FT(FT(a + FT(b + c)) * least) * FT(FT(c + FT(a - b)) * FT(a + FT(b - c)))) / FT(2);
  }

  const std::vector<FT>& m_lengths;
};

// Atomic minimum.
inline void lower_to(Index& number, Index i) { number = (std::min)(number, i); }
inline void lower_to(std::atomic<Index>& number, Index i)
{
  Index known = number.load(std::memory_order_relaxed);
  while (i < known && !number.compare_exchange_weak(known, i, std::memory_order_relaxed)) {}
}

template <class FT>
template <class Traits, class Team>
Unfolded_mesh<FT>::Unfolded_mesh(const Index_renumbering& numbers, const All_face_links& links,
                                 const std::vector<Index>& face_at, const std::vector<typename Traits::Point_3>& points,
                                 const Traits& traits, Team& team)
  : m_corner(points.size(), no_index), m_can_bend(points.size(), 0)
{
  lay_out(numbers, links, face_at, Layout_by_points<Traits>(points, traits), team);
}

template <class FT>
template <class Team>
Unfolded_mesh<FT>::Unfolded_mesh(const Index_renumbering& numbers, const All_face_links& links,
                                 const std::vector<Index>& face_at, std::size_t number_of_vertices,
                                 const std::vector<FT>& lengths, Team& team)
  : m_corner(number_of_vertices, no_index), m_can_bend(number_of_vertices, 0)
{
  lay_out(numbers, links, face_at, Layout_by_lengths<FT>(lengths), team);
}

template <class FT>
template <class Layout, class Team>
void Unfolded_mesh<FT>::lay_out(const Index_renumbering& numbers, const All_face_links& links,
                                const std::vector<Index>& face_at, const Layout& layout, Team& team)
{
  if constexpr (Number_policy<FT>::is_inexact) m_halfedges.resize(3 * face_at.size(), boost::container::default_init);
  else m_halfedges.resize(3 * face_at.size());
  if constexpr (std::is_same<Team, Single_worker>::value) set_up(numbers, links, face_at, layout, team, m_corner);
  else
  {
    std::vector<std::atomic<Index>> first_corners(m_corner.size());
    for (auto& corner : first_corners) corner.store(no_index, std::memory_order_relaxed);
    set_up(numbers, links, face_at, layout, team, first_corners);
  }
}

template <class FT>
bool Unfolded_mesh<FT>::has_area(Index face) const
{
  bool result = true;
  for (Index h = 3 * face; h < 3 * face + 3; ++h) result &= has_area(m_halfedges[h].length, m_halfedges[h].apex_y);
  return result;
}

template <class FT>
bool Unfolded_mesh<FT>::has_usable_scale() const
{
  if constexpr (!Number_policy<FT>::is_inexact) return true;
  if (!(m_longest_edge > FT(0)) || !Number_policy<FT>::is_finite(m_longest_edge)) return true;
  return m_longest_edge > FT(small_size()) && m_longest_edge < FT(1 / small_size());
}

template <class FT>
template <class Layout, class Team, class First_corners>
void Unfolded_mesh<FT>::set_up(const Index_renumbering& numbers, const All_face_links& links, const std::vector<Index>& face_at,
                               const Layout& layout, Team& team, First_corners& first_corners)
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

template <class FT>
bool Unfolded_mesh<FT>::has_consistent_twins() const
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

template <class FT>
template <class Layout, class First_corners>
typename Unfolded_mesh<FT>::Laid_out_faces Unfolded_mesh<FT>::lay_out_faces(
  std::size_t begin, std::size_t end, const Index_renumbering& numbers, const All_face_links& links,
  const std::vector<Index>& face_at, const Layout& layout, First_corners& first_corners, std::vector<double>& lengths)
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
      lower_to(first_corners[v[k]], h + Index(k));
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

template <class FT>
template <class First_corners, class Team>
std::size_t Unfolded_mesh<FT>::find_corners(const First_corners& first, Team& team)
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

template <class FT>
void Unfolded_mesh<FT>::find_more_fans()
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

template <class FT>
typename Unfolded_mesh<FT>::Fan Unfolded_mesh<FT>::fan_of(Index first) const
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

template <class FT>
void Unfolded_mesh<FT>::keep_within_range(FT& x, FT& y)
{
  if constexpr (Number_policy<FT>::is_inexact)
  {
    const FT size = CGAL::abs(x) + CGAL::abs(y);
    if (size > FT(small_size()) && size < FT(1 / small_size())) return;
    x /= size;
    y /= size;
  }
}

} // namespace CGAL::Geodesic_offset::internal

#endif
