// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Buffer of windows for one halfedge, appended to its list at once.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_WINDOW_OUTPUT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_WINDOW_OUTPUT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Interval_filter.h>

#include <CGAL/assertions.h>

#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT, class Window>
class Window_output
{
public:
  // Write position, kept in registers while a batch is propagated.
  class Cursor
  {
  public:
    bool is_open() const { return m_next != nullptr; }

    // Place of the next window; keep() accepts it, with its smallest distance.
    Window& next() const { return *m_next; }
    void keep(const FT& nearest)
    {
      m_nearest = lesser(m_nearest, nearest);
      ++m_next;
    }

  private:
    friend class Window_output;
    Window* m_next = nullptr;
    FT m_nearest = Number_policy<FT>::infinity();
  };

  // Starts output of up to n windows for a halfedge; none is written if it is closed.
  Cursor start(Index halfedge, bool is_open, std::size_t n)
  {
    m_halfedge = halfedge;
    if (m_windows.size() < n) m_windows.resize(n);
    Cursor cursor;
    m_size = 0;
    if (is_open) cursor.m_next = m_windows.data();
    return cursor;
  }

  // Ends the output.
  void finish(const Cursor& cursor)
  {
    m_size = cursor.is_open() ? std::size_t(cursor.m_next - m_windows.data()) : 0;
    CGAL_postcondition(m_size <= m_windows.size());
    m_nearest = cursor.m_nearest;
  }

  void clear() { m_size = 0; } // the halfedge stays

  Index halfedge() const { return m_halfedge; }
  const FT& nearest() const { return m_nearest; }
  const Window* begin() const { return m_windows.data(); }
  std::size_t size() const { return m_size; }

private:
  Index m_halfedge = no_index;
  std::vector<Window> m_windows;
  std::size_t m_size = 0;
  FT m_nearest = FT(0);
};

} // namespace CGAL::Geodesic_offset::internal

#endif
