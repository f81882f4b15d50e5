// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cache of the straight suffixes of shortest paths behind vertices, which the paths from many points share.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_SUFFIX_CACHE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_SUFFIX_CACHE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/memory/prefetch.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <atomic>
#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>

namespace CGAL::Geodesic_offset::internal {

// End of a straight suffix: a vertex on the path, or a source.
template <class FT>
struct Suffix_end
{
  Surface_point<FT> point;
  Source_ref source_ref; // source part and side at the end; invalid at a vertex

  bool is_at_source() const { return source_ref.is_valid(); }
};

// Items of a path up to the end of a suffix, in one block with the array.
template <class FT, class Item>
class Path_suffix
{
public:
  template <class Items>
  static Path_suffix* create(const Items& items, const Suffix_end<FT>& end)
  {
    static_assert(alignof(Item) <= alignof(Path_suffix) && std::is_trivially_destructible<Path_suffix>::value, "");
    Path_suffix* const suffix = new (::operator new(bytes(items.size()))) Path_suffix(end, Index(items.size()));
    std::uninitialized_copy(items.begin(), items.end(), reinterpret_cast<Item*>(suffix + 1));
    return suffix;
  }

  static void destroy(const Path_suffix* suffix) { ::operator delete(const_cast<Path_suffix*>(suffix)); }

  static std::size_t bytes(std::size_t size) { return sizeof(Path_suffix) + size * sizeof(Item); }

  const Suffix_end<FT>& end() const { return m_end; }
  const Item* first_item() const { return reinterpret_cast<const Item*>(this + 1); }
  const Item* last_item() const { return first_item() + m_size; } // behind the last item

private:
  Path_suffix(const Suffix_end<FT>& end, Index size) : m_end(end), m_size(size) {}

  Suffix_end<FT> m_end;
  Index m_size;
};

// Cache for the vertices of a mesh. Several threads may use it at the same time. It stores nothing more when its memory is used
// up.
template <class FT, class Item>
class Path_suffix_cache
{
public:
  typedef Path_suffix<FT, Item> Suffix;

  // Exact numbers and points with reference counts are not cached: they are not safe for threads, and long to store.
  static constexpr bool keeps = std::is_floating_point<FT>::value && std::is_trivially_copyable<Item>::value;

  explicit Path_suffix_cache(std::size_t number_of_vertices) : m_size(number_of_vertices) {}
  Path_suffix_cache(const Path_suffix_cache&) = delete;
  Path_suffix_cache& operator=(const Path_suffix_cache&) = delete;
  ~Path_suffix_cache()
  {
    const Place* const suffixes = m_suffixes.load(std::memory_order_relaxed);
    for (std::size_t v = 0; suffixes && v < m_size; ++v) destroy(suffixes[v].load(std::memory_order_relaxed));
    delete[] suffixes;
  }

  // The suffix behind a vertex; null if it is not cached.
  const Suffix* find(Index v) const
  {
    const Place* const suffixes = m_suffixes.load(std::memory_order_acquire);
    if (!suffixes) return nullptr;
    const Suffix* const suffix = suffixes[v].load(std::memory_order_acquire);
    return suffix == walked_once() ? nullptr : suffix;
  }

  // Software prefetch of the suffix behind a vertex.
  BOOST_FORCEINLINE void prefetch(Index v) const
  {
    if (const Suffix* const suffix = find(v)) internal::prefetch(suffix, Suffix::bytes(8));
  }

  // Stores a suffix. Many paths bend at the same vertices, but few start at the same vertex; the first part of a path is stored
  // only at its second use.
  template <class Items>
  void keep(Index v, const Items& items, const Suffix_end<FT>& end, bool starts_path)
  {
    CGAL_precondition(v < m_size);
    Place& place = places()[v];
    const Suffix* known = nullptr;
    if (!starts_path) known = place.load(std::memory_order_relaxed);
    else if (place.compare_exchange_strong(known, walked_once(), std::memory_order_relaxed)) return;
    if (known && known != walked_once()) return;
    const std::size_t bytes = Suffix::bytes(items.size()) + overhead;
    if (m_bytes.fetch_add(bytes, std::memory_order_relaxed) + bytes <= m_size * bytes_a_vertex)
    {
      const Suffix* const suffix = Suffix::create(items, end);
      if (place.compare_exchange_strong(known, suffix, std::memory_order_release, std::memory_order_relaxed)) return;
      destroy(suffix); // another thread stored it first
    }
    m_bytes.fetch_sub(bytes, std::memory_order_relaxed);
  }

private:
  typedef std::atomic<const Suffix*> Place;

  enum {
    bytes_a_vertex = 256, // limit of the average
    overhead = 16         // per block
  };

  // Stands for a suffix used once, which is not stored.
  static const Suffix* walked_once()
  {
    static const char place = 0;
    return reinterpret_cast<const Suffix*>(&place);
  }

  Place* places()
  {
    Place* places = m_suffixes.load(std::memory_order_acquire);
    if (places) return places;
    std::unique_ptr<Place[]> fresh(new Place[m_size]);
    for (std::size_t v = 0; v < m_size; ++v) fresh[v].store(nullptr, std::memory_order_relaxed);
    return m_suffixes.compare_exchange_strong(places, fresh.get(), std::memory_order_acq_rel) ? fresh.release() : places;
  }

  static void destroy(const Suffix* suffix)
  {
    if (suffix && suffix != walked_once()) Suffix::destroy(suffix);
  }

  const std::size_t m_size;
  std::atomic<Place*> m_suffixes{nullptr};
  std::atomic<std::size_t> m_bytes{0};
};

// In place of a cache, for few paths.
template <class FT>
struct No_suffix_cache
{
  typedef Path_suffix<FT, Path_crossing<FT>> Suffix;
  static constexpr bool keeps = false;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
