// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The windows of one halfedge as the sweep writes them.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_SEQUENCE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_SEQUENCE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// A vector whose push_back() is inlined: compilers call that of std::vector, which costs as much as the copy of a window.
template <class FT>
class Window_sequence
{
public:
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;

  Window_sequence() { grow(); }
  Window_sequence(const Window_sequence&) = delete;
  Window_sequence& operator=(const Window_sequence&) = delete;

  bool empty() const { return m_end == data(); }
  std::size_t size() const { return std::size_t(m_end - data()); }
  const Window* data() const { return m_storage.data(); }
  const Window* begin() const { return data(); }
  const Window* end() const { return m_end; }

  Window& operator[](std::size_t i)
  {
    CGAL_precondition(i < size());
    return m_storage[i];
  }
  const Window& operator[](std::size_t i) const
  {
    CGAL_precondition(i < size());
    return m_storage[i];
  }
  Window& front() { return (*this)[0]; }
  Window& back()
  {
    CGAL_precondition(!empty());
    return m_end[-1];
  }

  void clear() { m_end = m_storage.data(); }

  // `w` is not of this sequence.
  BOOST_FORCEINLINE void push_back(const Window& w)
  {
    if (BOOST_UNLIKELY(m_end == m_last)) grow();
    *m_end++ = w;
  }

  void pop_back()
  {
    CGAL_precondition(!empty());
    --m_end;
  }

  void push_front(const Window& w)
  {
    push_back(w);
    std::rotate(m_storage.data(), m_end - 1, m_end);
  }

  void erase(std::size_t i)
  {
    CGAL_precondition(i < size());
    std::move(m_storage.data() + i + 1, m_end, m_storage.data() + i);
    --m_end;
  }

private:
  // When the storage is full.
  BOOST_NOINLINE void grow()
  {
    const std::size_t size = m_storage.size();
    m_storage.resize(size == 0 ? 8 : 2 * size);
    m_end = m_storage.data() + size;
    m_last = m_storage.data() + m_storage.size();
  }

  std::vector<Window> m_storage;
  Window *m_end, *m_last; // end of the sequence and of the storage
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
