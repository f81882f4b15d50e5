// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Windows that were propagated onto a halfedge and wait, in the blocks into which they were written, until it is taken.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WAITING_BLOCKS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WAITING_BLOCKS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Window_lists.h>

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
  typedef Window_arena<Window> Arena;

public:
  // Puts a block behind the windows of the list at a place.
  void add(Window_list<FT>& list, Index place, const Block& block, Arena& arena)
  {
    if (!list.data)
    { // a block is as good as another
      list.data = block.data;
      list.size = block.size;
      list.size_class = block.size_class;
      return;
    }
    if (place >= m_blocks.size()) m_blocks.resize(std::size_t(place) + 1 + place / 2);
    Blocks& waiting = m_blocks[place];
    if (waiting.number < most) waiting.block[waiting.number++] = block;
    else append(list, block, arena);
  }

  // Puts those that wait into the list.
  void append_to(Window_list<FT>& list, Index place, Arena& arena)
  {
    if (place >= m_blocks.size()) return;
    Blocks& waiting = m_blocks[place];
    if (waiting.number == 0) return;
    std::size_t n = list.size;
    for (Index i = 0; i < waiting.number; ++i) n += waiting.block[i].size;
    Window_lists<FT>::reserve(list, n, arena);
    for (Index i = 0; i < waiting.number; ++i) append(list, waiting.block[i], arena);
    waiting.number = 0;
  }

  // Gives up those that wait; returns how many windows they were.
  std::ptrdiff_t release(Index place, Arena& arena)
  {
    if (place >= m_blocks.size()) return 0;
    Blocks& waiting = m_blocks[place];
    std::ptrdiff_t n = 0;
    for (; waiting.number > 0; --waiting.number)
    {
      const Block& block = waiting.block[waiting.number - 1];
      n += block.size;
      arena.release(block.data, block.size_class);
    }
    return n;
  }

private:
  // More are not often there at one time.
  static constexpr Index most = 3;
  struct Blocks
  {
    std::array<Block, most> block;
    Index number = 0;
  };

  static void append(Window_list<FT>& list, const Block& block, Arena& arena)
  {
    Window_lists<FT>::write(list, block.data, block.size, arena);
    arena.release(block.data, block.size_class);
  }

  std::vector<Blocks> m_blocks;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
