// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A growing sequence for the inner loops of the front.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MEMORY_INLINE_SEQUENCE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MEMORY_INLINE_SEQUENCE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// A vector whose push_back() is inlined: compilers call that of std::vector, which costs as much as the copy of a window. clear()
// has no branch, unlike that of std::vector, and does not destroy elements.
template <class T>
class Inline_sequence
{
public:
  Inline_sequence() { grow(); }
  Inline_sequence(const Inline_sequence&) = delete;
  Inline_sequence& operator=(const Inline_sequence&) = delete;

  bool empty() const { return m_end == data(); }
  std::size_t size() const { return std::size_t(m_end - data()); }
  const T* data() const { return m_storage.data(); }
  const T* begin() const { return data(); }
  const T* end() const { return m_end; }

  T& operator[](std::size_t i)
  {
    CGAL_precondition(i < size());
    return m_storage[i];
  }
  const T& operator[](std::size_t i) const
  {
    CGAL_precondition(i < size());
    return m_storage[i];
  }
  T& front() { return (*this)[0]; }
  T& back()
  {
    CGAL_precondition(!empty());
    return m_end[-1];
  }

  void clear() { m_end = m_storage.data(); }

  // `w` is not of this sequence.
  BOOST_FORCEINLINE void push_back(const T& w)
  {
    if (BOOST_UNLIKELY(m_end == m_last)) grow();
    *m_end++ = w;
  }

  void pop_back()
  {
    CGAL_precondition(!empty());
    --m_end;
  }

  void push_front(const T& w)
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

  std::vector<T> m_storage;
  T *m_end, *m_last; // end of the sequence and of the storage
};

} // namespace CGAL::Geodesic_offset::internal

#endif
