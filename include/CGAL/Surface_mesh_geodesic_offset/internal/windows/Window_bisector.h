// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of equal distance of two windows on one halfedge, for floating-point numbers. (For exact numbers see
// Certain_overlap_split.h.)

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_BISECTOR_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_BISECTOR_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_number_pair.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Has_pairs.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

namespace CGAL::Geodesic_offset::internal {

// One point of equal distance of two windows a and b.
template <class Traits>
class Bisector_crossing
{
public:
  typedef typename Traits::FT FT;
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;

  Bisector_crossing(const Traits& traits, const Window& a, const Window& b)
    : m_a(a), m_b(b), m_compare(traits.compare_distance_2_object()), m_distance(traits.compute_distance_2_object()),
      m_scale(CGAL::abs(a.d1) + CGAL::abs(b.d0)) // on a source, rounding may make distances negative
  {
    // those of parallel rays are differences of numbers as large as the edge
    if ((a.bits | b.bits) & 1u) m_scale += a.b1 + b.b1;
  }

  FT at(const Window& w, const FT& t) const { return m_distance(w.x, w.y, w.sigma, w.is_parallel(), t, FT(0)); }

  // Distances of a at ta and of b at tb.
  BOOST_FORCEINLINE void at(const FT& ta, const FT& tb, FT& da, FT& db) const
  {
    if constexpr (Has_pair_distances<Traits>::value)
    {
      if (BOOST_LIKELY(!((m_a.bits | m_b.bits) & 1u)))
      {
        typedef Geodesic_number_pair<FT> Pair;
        const Pair d =
          m_distance(Pair(m_a.x, m_b.x), Pair(m_a.y, m_b.y), Pair(m_a.sigma, m_b.sigma), Pair(ta, tb), Pair(FT(0)));
        da = d.first();
        db = d.second();
        return;
      }
    }
    da = at(m_a, ta);
    db = at(m_b, tb);
  }

  Comparison_result compare(const FT& d, const FT& e) const { return m_compare(d, e, m_scale); }

  // The point of the halfedge's line that is collinear with both images.
  bool collinear_point(FT& c) const
  {
    const bool pa = m_a.is_parallel(), pb = m_b.is_parallel();
    if (pa && pb) return false;
    const FT den = (pa ? FT(0) : m_b.y) - (pb ? FT(0) : m_a.y);
    if (CGAL::is_zero(den)) return false;
    c = (m_a.x * m_b.y - m_b.x * m_a.y) / den;
    return true;
  }

  // True if the bisector is a straight line, as for two images with equal sigma, such that a is nearer before t and b behind
  // it. t is as precise as the images.
  BOOST_FORCEINLINE bool has_straight_bisector(FT& t) const
  {
    if (((m_a.bits | m_b.bits) & 1u) || m_a.sigma != m_b.sigma) return false;
    const FT x = m_b.x - m_a.x, y = m_b.y - m_a.y;
    if (!CGAL::is_positive(x)) return false;
    t = (x * (m_a.x + m_b.x) + y * (m_a.y + m_b.y)) / (2 * x);
    return true;
  }

  // True if the collinear point lies between u and v; only then may equal signs at u and v enclose two bisector points.
  bool may_cross_twice(const FT& u, const FT& v) const
  {
    FT c;
    return collinear_point(c) && u < c && c < v;
  }

  // The point t between u and v of equal distance, where the difference g has opposite signs at u and v, and its distance: by
  // the closed form, and by a bracketed iteration where the closed form lost digits.
  struct Place
  {
    FT t, d;
  };
  BOOST_FORCEINLINE Place find(const FT& u, const FT& gu, const FT& v, const FT& gv) const
  {
    CGAL_precondition(u <= v && (gu > 0) != (gv > 0));
    Place p;
    if (BOOST_UNLIKELY(!closed_form(u, v, p.t))) return Bisector_crossing(*this).iterate(u, gu, v, gv);
    FT other;
    at(p.t, p.t, p.d, other);
    if (BOOST_LIKELY(compare(p.d, other) == EQUAL)) return p;
    // The iteration uses a copy, so that this object may stay in registers.
    const FT g = p.d - other;
    return (g > 0) == (gu > 0) ? Bisector_crossing(*this).iterate(p.t, g, v, gv)
                               : Bisector_crossing(*this).iterate(u, gu, p.t, g);
  }

private:
  // Every third step halves the bracket, so the loop ends: at the latest when no number is between u and v.
  BOOST_NOINLINE Place iterate(FT u, FT gu, FT v, FT gv) const
  {
    Place p;
    for (int i = 0;; ++i)
    {
      FT& t = p.t;
      t = i % 3 == 2 ? FT(0.5) * (u + v) : FT(u + (v - u) * (gu / (gu - gv)));
      if (!(t > u && t < v)) t = FT(0.5) * (u + v);
      FT other;
      at(t, t, p.d, other);
      const FT g = p.d - other;
      if (compare(p.d, other) == EQUAL || !(t > u && t < v)) break;
      if ((g > 0) == (gu > 0))
      {
        u = t;
        gu = g;
      }
      else
      {
        v = t;
        gv = g;
      }
    }
    return p;
  }

  // With the origin of t below a point image (b of two), so that squares are of the size of the result:
  //   point / point, with k = sigma_b - sigma_a:   |t - A| - |t - B| = k
  //     k = 0: linear.  Otherwise (m t + n)^2 = 4 k^2 |t - B|^2 with m t + n = |t - A|^2 - |t - B|^2 - k^2.
  //   point / parallel, with c = sigma of the rays - sigma of the point:   (c - u t)^2 = |t - A|^2
  //   parallel / parallel: linear
  BOOST_FORCEINLINE bool closed_form(const FT& u, const FT& v, FT& t) const
  {
    const bool pa = m_a.is_parallel(), pb = m_b.is_parallel();
    FT qa(0), qb, qc, disc, origin(0); // qa t^2 + 2 qb t + qc = 0; a quarter of its discriminant
    if (pa && pb)
    {
      qb = (m_b.x - m_a.x) / 2;
      qc = m_a.sigma - m_b.sigma;
    }
    else if (pa || pb)
    {
      const Window& l = pa ? m_a : m_b;
      const Window& p = pa ? m_b : m_a;
      origin = p.x;
      const FT c = l.sigma - l.x * p.x - p.sigma;
      qa = l.y * l.y;
      qb = c * l.x;
      qc = (p.y - c) * (p.y + c);
      disc = (c - l.y * p.y) * (c + l.y * p.y);
    }
    else
    {
      origin = m_b.x;
      const FT k = m_b.sigma - m_a.sigma, x = m_a.x - m_b.x, m = -2 * x;
      const FT n0 = x * x + (m_a.y - m_b.y) * (m_a.y + m_b.y);
      if (CGAL::is_zero(k))
      {
        qb = m / 2;
        qc = n0;
      }
      else
      {
        const FT n = n0 - k * k, k2 = 2 * k;
        qa = (m - k2) * (m + k2);
        qb = m * n;
        qc = (n - k2 * m_b.y) * (n + k2 * m_b.y);
        disc = qb * qb - qa * qc;
      }
    }
    const auto is_between = [&](const FT& x) { return bool(int(u < x) & int(x < v)); };
    if (CGAL::is_zero(qa))
    {
      if (CGAL::is_zero(qb)) return false;
      t = origin - qc / (2 * qb);
      return is_between(t);
    }
    if (CGAL::is_negative(disc)) return false;
    // The sign of qb as a factor, without a branch.
    const FT q = -(qb + FT(1 - 2 * int(CGAL::is_negative(qb))) * square_root<FT>(disc));
    if (CGAL::is_zero(q)) return false;
    const FT t1 = origin + q / qa, t2 = origin + qc / q;
    const bool in1 = is_between(t1), in2 = is_between(t2);
    const FT roots[2] = {t2, t1}; // a choice by a load, as a branch would be unpredictable
    t = roots[in1];
    if (BOOST_UNLIKELY(int(in1) & int(in2)))
      t = CGAL::abs(FT(at(m_a, t1) - at(m_b, t1))) <= CGAL::abs(FT(at(m_a, t2) - at(m_b, t2))) ? t1 : t2;
    return in1 || in2;
  }

  const Window& m_a;
  const Window& m_b;
  const typename Traits::Compare_distance_2 m_compare;
  const typename Traits::Compute_distance_2 m_distance;
  FT m_scale;
};

// The points of equal distance of two windows a and b on the overlap [low, high] of their intervals, where b begins within a.
//
// The difference g of the distances is monotone along the halfedge except at the point collinear with both images, where the
// two rays coincide. So g has at most one root on either side of that point, two in all. The signs at low, at the collinear
// point and at high determine their number.
template <class Traits>
class Window_bisector
{
public:
  typedef typename Traits::FT FT;
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;

  Window_bisector(const Traits& traits, const Window& a, const Window& b) : m_tie(traits, a, b)
  {
    const bool a_ends_first = a.b1 < b.b1;
    m_low = b.b0;
    m_high = a_ends_first ? a.b1 : b.b1;
    CGAL_precondition(a.b0 <= m_low && m_low <= m_high);
    m_a_low = m_tie.at(a, m_low);
    m_b_low = b.d0;
    m_a_high = a_ends_first || m_high == a.b1 ? a.d1 : m_tie.at(a, m_high);
    m_b_high = a_ends_first ? m_tie.at(b, m_high) : b.d1;
    FT from = m_low, g_from = m_a_low - m_b_low, c;
    int previous = m_tie.compare(m_a_low, m_b_low);
    m_first_sign = previous;
    if (m_tie.collinear_point(c) && m_low < c && c < m_high)
    {
      const FT a_c = m_tie.at(a, c), b_c = m_tie.at(b, c);
      step(from, g_from, previous, c, a_c - b_c, m_tie.compare(a_c, b_c));
    }
    step(from, g_from, previous, m_high, m_a_high - m_b_high, m_tie.compare(m_a_high, m_b_high));
    // The window that contains the other one wins ties: the other one could not replace a part of it without opening a gap, since
    // their rays diverge at one end of the part.
    if (m_first_sign == 0 && a_ends_first) m_first_sign = a.b0 < b.b0 ? (a.is_parallel() || !b.is_parallel() ? -1 : 1) : 1;
  }

  const FT& low() const { return m_low; }
  const FT& high() const { return m_high; }
  const FT& distance_at_low(bool of_a) const { return of_a ? m_a_low : m_b_low; }
  const FT& distance_at_high(bool of_a) const { return of_a ? m_a_high : m_b_high; }

  bool first_is_nearer() const { return m_first_sign <= 0; } // the first also wins ties
  int number() const { return m_number; }
  const FT& operator[](int i) const
  {
    CGAL_precondition(0 <= i && i < m_number);
    return m_ties[i];
  }
  const FT& distance(int i) const { return m_distances[i]; } // equal for both windows

private:
  // s: sign of g_to.
  void step(FT& from, FT& g_from, int& previous, const FT& to, const FT& g_to, int s)
  {
    if (s != 0)
    {
      if (m_first_sign == 0) m_first_sign = s;
      if (previous * s < 0)
      {
        CGAL_assertion(m_number < 2); // the difference has one turning point
        const auto place = m_tie.find(from, g_from, to, g_to);
        m_ties[m_number] = place.t;
        m_distances[m_number++] = place.d;
      }
      previous = s;
    }
    if (s != 0 || previous == 0)
    {
      from = to;
      g_from = g_to;
    }
  }

  const Bisector_crossing<Traits> m_tie;
  FT m_low, m_high, m_a_low, m_a_high, m_b_low, m_b_high;
  int m_first_sign = 0;
  int m_number = 0;
  FT m_ties[2], m_distances[2];
};

} // namespace CGAL::Geodesic_offset::internal

#endif
