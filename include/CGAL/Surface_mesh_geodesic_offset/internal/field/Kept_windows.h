// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compact, lossless storage of the windows of finalized faces, for later queries. A window does not store values that the field
// has at its pseudo-source.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FIELD_KEPT_WINDOWS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FIELD_KEPT_WINDOWS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/memory/prefetch.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Start_values.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Rays_through_chord.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/window_allowance.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_lists.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>
#include <boost/container/vector.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// The nearest window for a point of a face, of those that enter the face.
template <class FT>
struct Nearest_kept_window
{
  FT straight = Number_policy<FT>::infinity(); // shortest path along a ray
  Index window = no_index;                     // of this path, for Kept_windows::rays_of_window()
  int halfedge = 0;                            // of the face, 0 to 2, through which it enters
};

template <class FT>
class Kept_windows
{
public:
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef Stored_window<FT> Rays;

  bool is_empty() const { return m_begin.empty(); }

  void set_start_values(const Start_values<FT>& starts) { m_start_values = starts; }

  // Removes all windows, which are those of `faces`.
  void clear(const std::vector<Index>& faces)
  {
    if (m_begin.empty()) return;
    for (const Index f : faces) std::fill_n(m_begin.begin() + 4 * std::ptrdiff_t(f), 4, Index(0));
    m_sigma.clear();
    m_size = m_live = 0;
  }

  // Stores the lists of the halfedges of `faces`; a halfedge without a list keeps its stored windows. A window is dropped if it
  // is outdated: the distance of its pseudo-source (`distance`, per vertex) is now less than when the window was made, so the
  // window is nowhere shortest. The layout in memory does not depend on the number of threads.
  template <class Team>
  void keep(const std::vector<Index>& faces, const Window_lists<FT>& lists, const std::vector<FT>& distance,
            const Unfolded_mesh<FT>& mesh, Team& team)
  {
    const std::size_t number_of_faces = mesh.number_of_faces();
    if (m_begin.empty()) m_begin.assign(4 * number_of_faces, 0);
    CGAL_assertion(m_begin.size() == 4 * number_of_faces);
    const std::size_t at_once = items_at_once(team.size());
    std::vector<Place> places((std::min)(at_once, faces.size()));
    for (std::size_t first = 0; first < faces.size(); first += at_once)
    {
      const Index* const face = faces.data() + first;
      const Index number = Index((std::min)(at_once, faces.size() - first));
      const auto weight = [](Index) { return std::size_t(1); };
      team.for_each(number, weight, number >= worthwhile,
                    [&](unsigned, Index i) { places[i] = this->count(face[i], lists, distance, mesh); });
      for (Index i = 0; i < number; ++i) make_room(face[i], places[i]);
      team.for_each(number, weight, number >= worthwhile,
                    [&](unsigned, Index i) { this->put(face[i], places[i], lists, distance, mesh); });
    }
  }

  // Calls f(window) for the windows of a halfedge of the given length, in order. `distance` and `source_ref` belong to the field,
  // per vertex.
  template <class Function>
  void for_each(Index h, const FT& length, const std::vector<FT>& distance, const std::vector<Source_ref>& source_ref,
                const Function& f) const
  {
    for_each_packed(h, [&](const Packed& p) { f(this->unpack(p, length, distance, source_ref)); });
  }

  // Software prefetch of the windows of a face.
  BOOST_FORCEINLINE void prefetch(Index face) const
  {
    if (m_begin.empty()) return;
    const Index begin = first(3 * face), n = last(3 * face + 2) - begin;
    if (n != 0) internal::prefetch(&at(begin), (std::min)(n, Index(page_size - begin % page_size)) * sizeof(Packed));
  }

  // Finds the nearest window for a point of a face; q[k] is the point in the frame of halfedge k. Rounding may move the point
  // out of all cones, so a window counts if the point is in its cone or at most `allowance` (a length) beside it.
  void find_nearest(Index face, const Per_corner<Point_in_face<FT>>& q, const FT& allowance, const std::vector<FT>& distance,
                    Nearest_kept_window<FT>& nearest) const
  {
    if (m_begin.empty()) return;
    const Index* begin = &m_begin[4 * face];
    Nearest_kept_window<FT> beside;
    enum { block = 64 };
    Index candidate[block]; // filled without branches, which are unpredictable here
    for (Index i = begin[0], n = begin[3]; i < n;)
    {
      const Index size = (std::min)({Index(n - i), Index(page_size - i % page_size), Index(block)});
      const Packed* const p = &at(i);
      Index count = 0;
      for (Index j = 0; j < size; ++j)
      {
        candidate[count] = i + j;
        count += Index(is_near(p[j], q[halfedge_of(begin, i + j)], allowance));
      }
      for (Index j = 0; j < count; ++j)
      {
        const int k = halfedge_of(begin, candidate[j]);
        const FT d = distance_at(at(candidate[j]), distance, q[k], allowance);
        Nearest_kept_window<FT>& n = is_near(at(candidate[j]), q[k], FT(0)) ? nearest : beside;
        if (d < n.straight) n = {d, candidate[j], k};
      }
      i += size;
    }
    // The rays of a window lead to the points between them. Those that pass beside it are for gaps by rounding.
    if (beside.straight + allowance < nearest.straight) nearest = beside;
  }

  // The rays of window i.
  Rays rays_of_window(Index i, const std::vector<FT>& distance, const std::vector<Source_ref>& source_ref) const
  {
    return unpack_rays(at(i), distance, source_ref);
  }

  // Calls f(window) for each window of a halfedge of the given length with a ray that passes q by at most
  // `allowance` and at a distance of at most `limit`.
  template <class Function>
  void for_each_within(Index h, const FT& length, const std::vector<FT>& distance, const std::vector<Source_ref>& source_ref,
                       const Point_in_face<FT>& q, const FT& allowance, const FT& limit, const Function& f) const
  {
    for_each_packed(h, [&](const Packed& p) {
      if (is_near(p, q, allowance) && this->distance_at(p, distance, q, allowance) <= limit)
        f(this->unpack(p, length, distance, source_ref));
    });
  }

  // Compacts the storage if it has more than 1.25 times as much room as the windows in use need.
  void tidy()
  {
    if (m_size <= m_live + m_live / 4) return;
    Kept_windows fresh;
    fresh.m_begin.assign(m_begin.size(), 0);
    fresh.m_sigma = m_sigma;
    fresh.m_start_values = m_start_values;
    fresh.make_room(m_live);
    Index place = 0;
    for (std::size_t f = 0; 4 * f < m_begin.size(); ++f)
      for (std::size_t k = 0; k < 4; ++k)
      {
        fresh.m_begin[4 * f + k] = place;
        if (k < 3)
          for (Index i = m_begin[4 * f + k]; i < m_begin[4 * f + k + 1]; ++i) fresh.at(place++) = at(i);
      }
    CGAL_assertion(place == m_live);
    fresh.m_live = fresh.m_size;
    *this = std::move(fresh);
  }

  std::size_t bytes() const
  {
    return m_pages.size() * page_size * sizeof(Packed) + m_sigma.capacity() * sizeof(FT) + m_begin.capacity() * sizeof(Index);
  }

private:
  // An interval window starts at a vertex of known distance and source, or at a source of known start value. The sigma of a
  // parallel-source window and of a merged window is stored in m_sigma.
  struct Packed
  {
    FT x, y, end[2];        // the bounding rays; with exact numbers, the interval
    Index source_ref_value; // not a Source_ref, so that new pages need no initialization
    Index bits; // bit 0: parallel; bit 31: merged; the others: index of sigma, or 1 + pseudo-source vertex, 0 if none

    Source_ref source_ref() const
    {
      Source_ref r;
      r.value = source_ref_value;
      return r;
    }
    bool is_merged() const { return bits & merged_flag; }
    Index value() const { return (bits & ~merged_flag) >> 1; }
  };
  static constexpr bool is_inexact = Number_policy<FT>::is_inexact;
  enum { page_size = 4096 };
  static constexpr std::size_t worthwhile = 8; // faces; for fewer faces, the wake-up of other threads costs more than it saves
  static constexpr Index merged_flag = 1u << 31; // sigma is followed by the error bound

  // Where the windows of a face are stored. count() sets the members to numbers of windows, make_room() replaces these by
  // indices.
  struct Place
  {
    Index windows[4] = {0, 0, 0, 0}; // first window per halfedge, and end
    Index sigma = 0;                 // in m_sigma
    bool has_outdated = false;       // the lists have windows that are not stored
  };

  // The numbers of windows to store: those of the lists, or the stored ones of halfedges without a list.
  Place count(Index face, const Window_lists<FT>& lists, const std::vector<FT>& distance, const Unfolded_mesh<FT>& mesh) const
  {
    Place p;
    for (int k = 0; k < 3; ++k)
    {
      const Index h = 3 * face + Index(k);
      if (!lists.has(h))
      {
        p.windows[k] = last(h) - first(h);
        continue;
      }
      const Window_list<FT>& list = lists.get(h);
      Index outdated = 0;
      for (const auto& w : list.propagated)
        if (stores_sigma(w)) p.sigma += 1 + Index(w.is_merged());
        else outdated += Index(is_outdated(w, distance, mesh[h].length));
      p.windows[k] = list.propagated.size - outdated;
      p.has_outdated = p.has_outdated || outdated != 0;
    }
    return p;
  }

  void make_room(Index face, Place& p)
  {
    const std::size_t number = std::size_t(p.windows[0]) + p.windows[1] + p.windows[2];
    Index place = Index(m_size), sigma = Index(m_sigma.size());
    make_room(number);
    if (m_sigma.size() + p.sigma >= std::size_t(no_index >> 2)) complain();
    m_sigma.resize(m_sigma.size() + p.sigma);
    std::swap(p.sigma, sigma);
    for (Index& w : p.windows)
    {
      std::swap(w, place);
      place += w;
    }
    m_live += number;
    m_live -= m_begin[4 * face + 3] - m_begin[4 * face];
    CGAL_assertion(m_live <= m_size);
  }

  void make_room(std::size_t windows)
  {
    m_size += windows;
    if (m_size >= std::size_t(no_index)) complain();
    if constexpr (std::is_trivially_default_constructible<Packed>::value)
      while (m_pages.size() * page_size < m_size) m_pages.emplace_back(page_size, boost::container::default_init);
    else // constructs no superfluous numbers
      for (std::size_t p = (m_size - windows) / page_size; p * page_size < m_size; ++p)
      {
        if (p == m_pages.size()) m_pages.emplace_back().reserve(page_size);
        m_pages[p].resize((std::min)(m_size - p * page_size, std::size_t(page_size)));
      }
  }

  static void complain() { throw std::length_error("Surface_mesh_geodesic_offset: too many windows to be kept"); }

  void put(Index face, const Place& p, const Window_lists<FT>& lists, const std::vector<FT>& distance,
           const Unfolded_mesh<FT>& mesh)
  {
    Index place = p.windows[0], sigma = p.sigma;
    Packed *out = nullptr, *page_end = nullptr;
    const auto next = [&]() -> Packed& {
      if (out == page_end)
      {
        out = &at(place);
        page_end = out + (page_size - place % page_size);
      }
      ++place;
      return *out++;
    };
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
      if (lists.has(h))
      {
        const Window_list<FT>& list = lists.get(h);
        for (const auto& w : list.propagated)
          if (!(p.has_outdated && is_outdated(w, distance, mesh[h].length))) pack(w, next(), sigma);
      }
      else
        for (Index i = first(h), n = last(h); i < n; ++i) next() = at(i);
    CGAL_assertion(place == p.windows[3]);
    std::copy(p.windows, p.windows + 4, m_begin.begin() + 4 * face);
  }

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
    const Index value = p.value();
    if (p.bits & 1u || p.is_merged()) return m_sigma[value];
    return value == 0 ? m_start_values.of(p.source_ref()) : distance[value - 1];
  }

  // Precondition: is_near(). Infinity if q lies behind the source of parallel rays, or before the point where the bounding ray
  // beside it enters the face, by more than `allowance`.
  FT distance_at(const Packed& p, const std::vector<FT>& distance, const Point_in_face<FT>& q, const FT& allowance) const
  {
    const Window_rays<FT> w{p.x, p.y, sigma(p, distance), p.end[0], p.end[1], Source_ref(), p.bits & 1u};
    const FT d = w.distance_at(q.x, q.y);
    if constexpr (is_inexact)
    {
      FT least = FT(0);
      if (w.is_parallel()) least = m_start_values.of(p.source_ref());
      else
      {
        const FT along = q.x - w.x, height = q.y - w.y;
        const bool is_left = along < w.t0 * height;
        if (BOOST_LIKELY(!is_left && along <= w.t1 * height)) return d;
        const FT& t = is_left ? w.t0 : w.t1;
        least = w.sigma - w.y * square_root<FT>(1 + t * t);
      }
      if (d < least - allowance) return Number_policy<FT>::infinity();
    }
    return d;
  }

  // True if a ray passes q, or passes it by at most `allowance`.
  static bool is_near(const Packed& w, const Point_in_face<FT>& q, const FT& allowance)
  {
    const bool is_parallel = w.bits & 1u;
    const FT height = is_parallel ? FT(-w.y) : FT(q.y - w.y);
    if constexpr (is_inexact)
    { // without branches, which are unpredictable here
      const FT along = is_parallel ? FT(w.x * q.y - w.y * q.x) : FT(q.x - w.x);
      const FT t0 = is_parallel ? FT(-w.end[0]) : FT(w.end[0] * height),
               t1 = is_parallel ? FT(-w.end[1]) : FT(w.end[1] * height);
      const FT slope0 = is_parallel ? FT(0) : CGAL::abs(w.end[0]), slope1 = is_parallel ? FT(0) : CGAL::abs(w.end[1]);
      return bool(int(along >= t0 - allowance * (1 + slope0)) & int(along <= t1 + allowance * (1 + slope1)));
    }
    // The ray to the point enters the face at entry / height; multiplication avoids the division.
    const FT entry = w.x * q.y - q.x * w.y;
    return !(entry < w.end[0] * height) && !(entry > w.end[1] * height);
  }

  static int halfedge_of(const Index* begin, Index i) { return int(i >= begin[1]) + int(i >= begin[2]); }

  template <class Any>
  static bool stores_sigma(const Any& w)
  {
    return w.is_parallel() || w.is_merged();
  }

  template <class Any>
  static bool is_outdated(const Any& rays, const std::vector<FT>& distance, const FT& length)
  {
    const Index v = stores_sigma(rays) ? no_index : rays.pseudo_source();
    if (v == no_index || BOOST_LIKELY(rays.sigma <= distance[v])) return false; // usually equal
    const Window w = restored(rays, length);
    return w.sigma > distance[v] + window_allowance<FT>((std::max)(w.d0, w.d1));
  }

  // `sigma`: next free index in m_sigma.
  template <class Any>
  void pack(const Any& w, Packed& p, Index& sigma)
  {
    p = {w.x, w.y, {end_of(w, 0), end_of(w, 1)}, w.source_ref.value, w.bits >> 2 << 1};
    if (BOOST_LIKELY(!stores_sigma(w))) return;
    p.bits = sigma << 1 | Index(w.is_parallel());
    m_sigma[sigma++] = w.sigma;
    if (!w.is_merged()) return;
    p.bits |= merged_flag;
    m_sigma[sigma++] = FT(Merge_error_code::error(w.pseudo_source()));
  }

  Window unpack(const Packed& p, const FT& length, const std::vector<FT>& distance,
                const std::vector<Source_ref>& source_ref) const
  {
    Window w = restored(unpack_rays(p, distance, source_ref), length);
    if constexpr (is_inexact)
    { // beside a source, an image that crossed large faces gives distances below zero by their rounding
      w.d0 = (std::max)(w.d0, FT(0));
      w.d1 = (std::max)(w.d1, FT(0));
    }
    else
    {
      w.d0 = w.distance_at(w.b0);
      w.d1 = w.distance_at(w.b1);
    }
    return w;
  }

  Rays unpack_rays(const Packed& p, const std::vector<FT>& distance, const std::vector<Source_ref>& source_ref) const
  {
    Rays w;
    static_cast<Window_rays<FT>&>(w) = {p.x, p.y, FT(0), FT(0), FT(0), p.source_ref(), 0};
    set_end_of(w, 0, p.end[0]);
    set_end_of(w, 1, p.end[1]);
    const Index value = p.value();
    if (p.bits & 1u || p.is_merged())
    {
      w.sigma = m_sigma[value];
      w.bits = Window::make_bits(p.bits & 1u, p.is_merged() ? merge_error_code(value) : no_index);
    }
    else if (value == 0) w.sigma = m_start_values.of(w.source_ref);
    else
    {
      w.sigma = distance[value - 1];
      w.source_ref = source_ref[value - 1];
      w.bits = Window::make_bits(false, value - 1);
    }
    return w;
  }

  // The rays of a stored window or, with exact numbers, the ends of its interval.
  static const FT& end_of(const Window_rays<FT>& w, int i) { return i == 0 ? w.t0 : w.t1; }
  static const FT& end_of(const Window& w, int i) { return i == 0 ? w.b0 : w.b1; }
  static void set_end_of(Window_rays<FT>& w, int i, const FT& end) { (i == 0 ? w.t0 : w.t1) = end; }
  static void set_end_of(Window& w, int i, const FT& end) { (i == 0 ? w.b0 : w.b1) = end; }

  Index merge_error_code(Index place) const { return Merge_error_code::with_error(CGAL::to_double(m_sigma[place + 1])); }

  Packed& at(Index i)
  {
    CGAL_precondition(i < m_size);
    return m_pages[i / page_size][i % page_size];
  }
  const Packed& at(Index i) const
  {
    CGAL_precondition(i < m_size);
    return m_pages[i / page_size][i % page_size];
  }
  Index first(Index h) const { return m_begin[4 * (h / 3) + h % 3]; }
  Index last(Index h) const { return m_begin[4 * (h / 3) + h % 3 + 1]; }

  std::vector<boost::container::vector<Packed>> m_pages;
  std::size_t m_size = 0, m_live = 0; // windows in the pages, and those in use
  Start_values<FT> m_start_values;
  std::vector<FT> m_sigma;    // of parallel-source and merged windows
  std::vector<Index> m_begin; // four per face: begin of the windows per halfedge, and end
};

} // namespace CGAL::Geodesic_offset::internal

#endif
