// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The straight ways behind vertices, which the shortest paths from many points have in common: they are remembered.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_LEGS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_LEGS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Prefetch.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <atomic>
#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Where a straight way leads: to a vertex on the way, or to a source.
template <class FT>
struct Leg_end
{
  Surface_point<FT> point;
  Source_ref source_ref; // the part of the source that is reached, and the side on which it is; not valid at a vertex on the way

  bool is_at_source() const { return source_ref.is_valid(); }
};

// What a way meets up to its end, as items that a path is made of. In one block with the array.
template <class FT, class Item>
class Path_leg
{
public:
  template <class Items>
  static Path_leg* create(const Items& items, const Leg_end<FT>& end)
  {
    static_assert(alignof(Item) <= alignof(Path_leg) && std::is_trivially_destructible<Path_leg>::value, "");
    Path_leg* const leg = new (::operator new(bytes(items.size()))) Path_leg(end, Index(items.size()));
    std::uninitialized_copy(items.begin(), items.end(), reinterpret_cast<Item*>(leg + 1));
    return leg;
  }

  static void destroy(const Path_leg* leg) { ::operator delete(const_cast<Path_leg*>(leg)); }

  static std::size_t bytes(std::size_t size) { return sizeof(Path_leg) + size * sizeof(Item); }

  const Leg_end<FT>& end() const { return m_end; }
  const Item* first_item() const { return reinterpret_cast<const Item*>(this + 1); }
  const Item* last_item() const { return first_item() + m_size; } // beyond the last one

private:
  Path_leg(const Leg_end<FT>& end, Index size) : m_end(end), m_size(size) {}

  Leg_end<FT> m_end;
  Index m_size;
};

// Of the vertices of a mesh. May be used by several threads at once. Nothing is kept any more once the memory is used up.
template <class FT, class Item>
class Path_legs
{
public:
  typedef Path_leg<FT, Item> Leg;

  // Exact numbers need not know about threads, and their ways are long to write down. Nor need points that have a count.
  static constexpr bool keeps = std::is_floating_point<FT>::value && std::is_trivially_copyable<Item>::value;

  explicit Path_legs(std::size_t number_of_vertices) : m_size(number_of_vertices) {}
  Path_legs(const Path_legs&) = delete;
  Path_legs& operator=(const Path_legs&) = delete;
  ~Path_legs()
  {
    const Place* const legs = m_legs.load(std::memory_order_relaxed);
    for (std::size_t v = 0; legs && v < m_size; ++v) destroy(legs[v].load(std::memory_order_relaxed));
    delete[] legs;
  }

  // What is known of the way behind a vertex; null if nothing.
  const Leg* find(Index v) const
  {
    const Place* const legs = m_legs.load(std::memory_order_acquire);
    if (!legs) return nullptr;
    const Leg* const leg = legs[v].load(std::memory_order_acquire);
    return leg == walked_once() ? nullptr : leg;
  }

  // Says that the way behind a vertex will be asked for soon.
  BOOST_FORCEINLINE void prefetch(Index v) const
  {
    if (const Leg* const leg = find(v)) internal::prefetch(leg, Leg::bytes(8));
  }

  // Tells what way has been walked. Many paths bend at the same vertices, few start at the same one: the way with which a
  // path starts is kept the second time only.
  template <class Items>
  void keep(Index v, const Items& items, const Leg_end<FT>& end, bool starts_path)
  {
    CGAL_precondition(v < m_size);
    Place& place = places()[v];
    const Leg* known = nullptr;
    if (!starts_path) known = place.load(std::memory_order_relaxed);
    else if (place.compare_exchange_strong(known, walked_once(), std::memory_order_relaxed)) return;
    if (known && known != walked_once()) return;
    const std::size_t bytes = Leg::bytes(items.size()) + overhead;
    if (m_bytes.fetch_add(bytes, std::memory_order_relaxed) + bytes <= m_size * bytes_a_vertex)
    {
      const Leg* const leg = Leg::create(items, end);
      if (place.compare_exchange_strong(known, leg, std::memory_order_release, std::memory_order_relaxed)) return;
      destroy(leg); // another thread was faster
    }
    m_bytes.fetch_sub(bytes, std::memory_order_relaxed);
  }

private:
  typedef std::atomic<const Leg*> Place;

  enum
  {
    bytes_a_vertex = 256, // on average, at most
    overhead = 16         // of a block
  };

  // Stands for a way that is not kept.
  static const Leg* walked_once()
  {
    static const char place = 0;
    return reinterpret_cast<const Leg*>(&place);
  }

  Place* places()
  {
    Place* places = m_legs.load(std::memory_order_acquire);
    if (places) return places;
    std::unique_ptr<Place[]> fresh(new Place[m_size]);
    for (std::size_t v = 0; v < m_size; ++v) fresh[v].store(nullptr, std::memory_order_relaxed);
    return m_legs.compare_exchange_strong(places, fresh.get(), std::memory_order_acq_rel) ? fresh.release() : places;
  }

  static void destroy(const Leg* leg)
  {
    if (leg && leg != walked_once()) Leg::destroy(leg);
  }

  const std::size_t m_size;
  std::atomic<Place*> m_legs{nullptr};
  std::atomic<std::size_t> m_bytes{0};
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
