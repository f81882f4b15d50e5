// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Windows that were propagated onto a halfedge and wait, in the blocks into which they were written, until it is taken.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WAITING_BLOCKS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WAITING_BLOCKS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Window_lists.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
class Waiting_blocks
{
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef Window_block<Window> Block;

public:
  // More are not often there at one time.
  static constexpr Index most = 3;
  struct Blocks
  {
    std::array<Block, most> block;
    Index number = 0;

    std::size_t number_of_windows() const
    {
      std::size_t n = 0;
      for (Index i = 0; i < number; ++i) n += block[i].size;
      return n;
    }
    Window* copy_to(Window* out) const
    {
      for (Index i = 0; i < number; ++i) out = std::copy(block[i].data, block[i].data + block[i].size, out);
      return out;
    }
  };

  // Those of the list at a place; null if there were never any.
  Blocks* find(Index place) { return place < m_blocks.size() ? &m_blocks[place] : nullptr; }

  // Puts a block behind the windows of a list.
  void add(Window_lists<FT>& lists, Window_list<FT>& list, Index place, const Block& block)
  {
    if (place >= m_blocks.size()) m_blocks.resize(std::size_t(place) + 1 + place / 2);
    Blocks& waiting = m_blocks[place];
    if (waiting.number < most)
    {
      lists.count(block.size);
      if (!lists.adopt(list, block)) waiting.block[waiting.number++] = block;
      return;
    }
    lists.append(list, block.data, block.size);
    lists.release(block);
  }

  // Gives all of a list up.
  void release(Window_lists<FT>& lists, Index place)
  {
    if (place >= m_blocks.size()) return;
    Blocks& waiting = m_blocks[place];
    lists.count(-std::ptrdiff_t(waiting.number_of_windows()));
    for (Index i = 0; i < waiting.number; ++i) lists.release(waiting.block[i]);
    waiting.number = 0;
  }

private:
  std::vector<Blocks> m_blocks;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
