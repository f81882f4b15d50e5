// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The windows of one halfedge, reduced to the lower envelope of their distances: one sweep over the windows in
// the order of their intervals merges neighbours with the same image and cuts overlapping ones where their
// distances tie.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_LOWER_ENVELOPE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_LOWER_ENVELOPE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Window.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Window_ties.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
class Lower_envelope
{
public:
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;

  // `source_of[primitive]` tells which windows may merge: those of one source.
  explicit Lower_envelope(const std::vector<Index>& source_of) : m_source_of(&source_of) {}

  // The windows [first, taken) are sorted and disjoint, those in [taken, last) are in any order, on a halfedge of
  // the given length. The result is sorted and disjoint, valid until the next call.
  const std::vector<Window>& operator()(const Window* first, const Window* taken, const Window* last, const FT& length)
  {
    m_envelope.clear();
    m_later.clear();
    m_min_width = Number_policy<FT>::rounding(8) * length;
    m_max_gap = Number_policy<FT>::rounding(4096) * length;
    sort(first, taken, last);
    for (Index i : m_order)
    {
      const Window& w = first[i];
      while (!m_later.empty() && m_later.front().b0 < w.b0) add(pop_later());
      add(w);
    }
    while (!m_later.empty()) add(pop_later());
    return m_envelope;
  }

private:
  // The fresh windows come in a few sorted runs, so an insertion sort is nearly linear; the taken ones are merged in.
  void sort(const Window* first, const Window* taken, const Window* last)
  {
    const Index n = Index(last - first), t = Index(taken - first);
    m_order.resize(n);
    for (Index i = 0; i < n; ++i) m_order[i] = i;
    const auto less = [first](Index i, Index j) { return first[i].b0 < first[j].b0; };
    if (!std::is_sorted(m_order.begin() + t, m_order.end(), less))
      std::stable_sort(m_order.begin() + t, m_order.end(), less);
    if (t != 0) std::inplace_merge(m_order.begin(), m_order.begin() + t, m_order.end(), less);
  }

  struct Begins_later
  {
    bool operator()(const Window& a, const Window& b) const { return a.b0 > b.b0; }
  };

  void push_later(const Window& w)
  {
    m_later.push_back(w);
    std::push_heap(m_later.begin(), m_later.end(), Begins_later());
  }

  Window pop_later()
  {
    std::pop_heap(m_later.begin(), m_later.end(), Begins_later());
    const Window w = m_later.back();
    m_later.pop_back();
    return w;
  }

  bool same_image(const Window& a, const Window& b) const
  {
    if ((a.bits ^ b.bits) & ~2u) return false; // parallel or not, pseudo-source
    const FT scale = a.d0 + b.d1 + CGAL::abs(a.x) + CGAL::abs(a.y);
    const FT allowance = Number_policy<FT>::rounding(256) * scale;
    return CGAL::abs(a.x - b.x) <= allowance && CGAL::abs(a.y - b.y) <= allowance &&
           CGAL::abs(a.sigma - b.sigma) <= allowance && a.root.side() == b.root.side() &&
           (*m_source_of)[a.root.primitive()] == (*m_source_of)[b.root.primitive()];
  }

  void add(const Window& w)
  {
    if (m_envelope.empty())
    {
      m_envelope.push_back(w);
      return;
    }
    Window& a = m_envelope.back();
    if (w.b0 >= a.b1)
    {
      if (w.b0 - a.b1 <= m_max_gap && a.is_propagated() == w.is_propagated() && same_image(a, w))
      {
        a.b1 = w.b1;
        a.d1 = w.d1;
      }
      else
        m_envelope.push_back(w);
    }
    else if (same_image(a, w))
      unite(a, w);
    else
      resolve(a, w);
  }

  // Two overlapping windows with one image are one window. If just one of them was propagated before, the other
  // keeps only what is new.
  void unite(Window& a, const Window& w)
  {
    if (a.is_propagated() == w.is_propagated())
    {
      if (w.b1 > a.b1)
      {
        a.b1 = w.b1;
        a.d1 = w.d1;
      }
    }
    else if (a.is_propagated())
      keep_later(w, a.b1, w.b1);
    else
    {
      const Window fresh = a;
      cut_back(w.b0);
      push_later(w);
      keep_later(fresh, w.b1, fresh.b1);
    }
  }

  // Overlapping windows with different images: the overlap goes to the nearer one, piece by piece.
  void resolve(const Window a, const Window& w)
  {
    const FT lo = w.b0, hi = (std::min)(a.b1, w.b1);
    Window_ties<FT> ties(a, w, lo, hi);
    // pieces: alternating owners between lo, the ties, and hi
    bool owner_is_a = ties.first_is_nearer();
    FT from = lo;
    bool first = true;
    const int n = ties.number();
    for (int i = 0; i <= n; ++i)
    {
      FT to = i < n ? ties[i] : hi;
      if (i == n) to = owner_is_a ? a.b1 : w.b1; // the last owner keeps its tail ...
      if (owner_is_a)
      {
        if (first)
        {
          if (to < a.b1) cut_back(to);
        }
        else
          keep_later(a, from, to);
      }
      else
      {
        if (first)
        {
          cut_back(from);
          Window piece = w;
          restrict(piece, from, to);
          if (piece.b1 - piece.b0 > m_min_width) m_envelope.push_back(piece);
        }
        else
          keep_later(w, from, to);
      }
      first = false;
      from = i < n ? ties[i] : hi;
      if (i < n) owner_is_a = !owner_is_a;
    }
    // ... and so does the other one, beyond the overlap
    if (owner_is_a)
      keep_later(w, hi, w.b1);
    else
      keep_later(a, hi, a.b1);
  }

  // Shortens the last window of the envelope to end at t; removes it if nothing is left.
  void cut_back(const FT& t)
  {
    Window& a = m_envelope.back();
    if (t - a.b0 <= m_min_width)
      m_envelope.pop_back();
    else
      restrict(a, a.b0, t);
  }

  void keep_later(Window w, const FT& from, const FT& to)
  {
    if (to - from <= m_min_width) return;
    restrict(w, from, to);
    push_later(w);
  }

  static void restrict(Window& w, const FT& from, const FT& to)
  {
    if (from != w.b0)
    {
      w.b0 = from;
      w.d0 = w.distance_at(from);
    }
    if (to != w.b1)
    {
      w.b1 = to;
      w.d1 = w.distance_at(to);
    }
  }

  const std::vector<Index>* m_source_of;
  std::vector<Window> m_envelope, m_later;
  std::vector<Index> m_order;
  FT m_min_width, m_max_gap;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
