// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The windows of the faces that the front has passed, for queries at any later time, as compactly as they come without loss:
// what the vertices know already is not stored again.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_KEPT_WINDOWS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_KEPT_WINDOWS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Window_lists.h>

#include <boost/config.hpp>

#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
class Kept_windows
{
public:
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;

  bool is_empty() const { return m_begin.empty(); }

  // Keeps the lists of the halfedges of a face; of those that have none, what was kept before stays. Windows of
  // pseudo-sources that have come nearer since (`distance`: per vertex) are nowhere the best ones any more.
  void keep(Index face, const Window_lists<FT>& lists, const std::vector<FT>& distance, std::size_t number_of_faces)
  {
    if (m_begin.empty()) m_begin.assign(4 * number_of_faces, 0);
    Index begin[4];
    for (Index k = 0; k < 3; ++k)
    {
      begin[k] = Index(m_size);
      const Index h = 3 * face + k;
      if (lists.has(h))
      {
        const Window_list<FT>& list = lists.get(h);
        for (Index i = 0; i < list.taken; ++i)
          if (!is_outdated(list.data[i], distance)) push(pack(list.data[i]));
      }
      else
        for (Index i = first(h), n = last(h); i < n; ++i) push(at(i));
    }
    begin[3] = Index(m_size);
    m_live += (begin[3] - begin[0]);
    m_live -= m_begin[4 * face + 3] - m_begin[4 * face];
    std::copy(begin, begin + 4, m_begin.begin() + 4 * face);
  }

  // Calls f(window) for the windows of a halfedge, in order. `distance` and `root`, per vertex, are those of the field.
  template <class Function>
  void for_each(Index h, const std::vector<FT>& distance, const std::vector<Root>& root, const Function& f) const
  {
    for_each_packed(h, [&](const Packed& p) { f(unpack(p, distance, root)); });
  }

  // Says that the windows of a face will be asked for at once: otherwise each line of memory is waited for.
  BOOST_FORCEINLINE void prefetch(Index face) const // a call of a function without effects would be dropped
  {
#if defined(__GNUC__)
    if (m_begin.empty()) return;
    for (Index i = first(3 * face), n = last(3 * face + 2); i < n; ++i) __builtin_prefetch(&at(i));
#else
    (void)face;
#endif
  }

  // The length of the shortest path through a window of the halfedge to the point (x, y) of its frame, which lies in the
  // face: straight if there is a ray to the point, else round the nearer end of the interval. No more than `best`.
  FT nearest(Index h, const std::vector<FT>& distance, const FT& x, const FT& y, FT best) const
  {
    for_each_packed(h, [&](const Packed& p) { best = (std::min)(best, path_length(p, sigma(p, distance), x, y, best)); });
    return best;
  }

  // Calls f(window) for the windows through which a path to (x, y) is not longer than the limit.
  template <class Function>
  void for_each_within(Index h, const std::vector<FT>& distance, const std::vector<Root>& root, const FT& x, const FT& y,
                       const FT& limit, const Function& f) const
  {
    for_each_packed(h, [&](const Packed& p) {
      if (path_length(p, sigma(p, distance), x, y, limit) <= limit) f(unpack(p, distance, root));
    });
  }

  // Gives the places back that were left behind when faces were kept anew, once they are many.
  void tidy()
  {
    if (m_size <= m_live + m_live / 4) return;
    Kept_windows fresh;
    fresh.m_begin.assign(m_begin.size(), 0);
    fresh.m_sigma = m_sigma;
    for (std::size_t f = 0; 4 * f < m_begin.size(); ++f)
      for (std::size_t k = 0; k < 4; ++k)
      {
        fresh.m_begin[4 * f + k] = Index(fresh.m_size);
        if (k < 3)
          for (Index i = m_begin[4 * f + k]; i < m_begin[4 * f + k + 1]; ++i) fresh.push(at(i));
      }
    fresh.m_live = fresh.m_size;
    *this = std::move(fresh);
  }

  std::size_t bytes() const
  {
    return m_pages.size() * page_size * sizeof(Packed) + m_sigma.capacity() * sizeof(FT) +
           m_begin.capacity() * sizeof(Index);
  }

private:
  // An interval window starts at a vertex whose distance and root are known, or at a source at no distance. A
  // parallel-source window has its sigma elsewhere.
  struct Packed
  {
    FT x, y, b0, b1;
    Root root;
    Index bits; // bit 0: parallel; above: the place of sigma, or 1 + pseudo-source vertex, 0 if none
  };
  enum { page_size = 4096 };

  template <class Function>
  void for_each_packed(Index h, const Function& f) const
  {
    if (m_begin.empty()) return;
    for (Index i = first(h), n = last(h); i < n;)
    {
      const Packed* p = &at(i);
      const Packed* const end = p + (std::min)(n - i, Index(page_size - i % page_size));
      i += Index(end - p);
      for (; p != end; ++p) f(*p);
    }
  }

  FT sigma(const Packed& p, const std::vector<FT>& distance) const
  {
    const Index value = p.bits >> 1;
    return p.bits & 1u ? m_sigma[value] : value == 0 ? FT(0) : distance[value - 1];
  }

  // Some number above the limit if the path is longer than that.
  static FT path_length(const Packed& p, const FT& sigma, const FT& x, const FT& y, const FT& limit)
  {
    const bool is_parallel = p.bits & 1u;
    const FT u = x - p.x, v = y - p.y, height = is_parallel ? FT(-p.y) : v;
    const FT squared = u * u + v * v, room = limit - sigma;
    // no path is shorter than the straight one, whether that is there or not
    if (is_parallel ? -(p.x * x + p.y * y) > room : CGAL::is_negative(room) || squared > room * room)
      return Number_policy<FT>::infinity();
    const FT entry = p.x * y - x * p.y; // times the height
    const auto round = [&](const FT& b) {
      const FT w = b - p.x;
      const FT to_end = is_parallel ? FT(-p.x * b) : square_root<FT>(w * w + p.y * p.y);
      return FT(sigma + to_end + square_root<FT>((x - b) * (x - b) + y * y));
    };
    if (entry < p.b0 * height) return round(p.b0);
    if (entry > p.b1 * height) return round(p.b1);
    return is_parallel ? FT(sigma - (p.x * x + p.y * y)) : FT(sigma + square_root<FT>(squared));
  }

  static bool is_outdated(const Window& w, const std::vector<FT>& distance)
  {
    const Index v = w.is_parallel() ? no_index : w.pseudo_source();
    return v != no_index && w.sigma > distance[v] + Number_policy<FT>::rounding(256) * distance[v];
  }

  Packed pack(const Window& w)
  {
    Packed p{w.x, w.y, w.b0, w.b1, w.root, w.bits >> 2 << 1};
    if (w.is_parallel())
    {
      p.bits = Index(m_sigma.size()) << 1 | 1u;
      m_sigma.push_back(w.sigma);
    }
    return p;
  }

  Window unpack(const Packed& p, const std::vector<FT>& distance, const std::vector<Root>& root) const
  {
    Window w{p.x, p.y, FT(0), p.b0, p.b1, FT(0), FT(0), p.root, 0};
    const Index value = p.bits >> 1;
    if (p.bits & 1u)
    {
      w.sigma = m_sigma[value];
      w.bits = Window::make_bits(true, no_index);
    }
    else if (value != 0)
    {
      w.sigma = distance[value - 1];
      w.root = root[value - 1];
      w.bits = Window::make_bits(false, value - 1);
    }
    w.d0 = w.distance_at(w.b0);
    w.d1 = w.distance_at(w.b1);
    return w;
  }

  void push(const Packed& p)
  {
    if (m_size >= std::size_t(no_index) || m_sigma.size() >= std::size_t(no_index >> 1))
      throw std::length_error("Surface_mesh_geodesic_offset: too many windows to be kept");
    if (m_size == m_pages.size() * page_size)
    {
      m_pages.emplace_back();
      m_pages.back().reserve(page_size);
    }
    m_pages.back().push_back(p);
    ++m_size;
  }

  const Packed& at(Index i) const { return m_pages[i / page_size][i % page_size]; }
  Index first(Index h) const { return m_begin[4 * (h / 3) + h % 3]; }
  Index last(Index h) const { return m_begin[4 * (h / 3) + h % 3 + 1]; }

  std::vector<std::vector<Packed>> m_pages;
  std::size_t m_size = 0, m_live = 0; // windows in the pages, and those of them that belong to a face
  std::vector<FT> m_sigma;            // of parallel-source windows
  std::vector<Index> m_begin;         // four for each face: where the windows of its halfedges begin, and where they end
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
