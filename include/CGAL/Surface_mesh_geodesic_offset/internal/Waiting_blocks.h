// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Windows that were propagated onto a halfedge and wait, in the blocks into which they were written, until it is taken.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WAITING_BLOCKS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WAITING_BLOCKS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Window_lists.h>

#include <boost/config.hpp>

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
    void release(Window_arena<Window>& arena)
    {
      for (Index i = 0; i < number; ++i) arena.release(block[i].data, block[i].size_class);
      number = 0;
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

  // Says that those of a list will be asked for soon.
  BOOST_FORCEINLINE void prefetch(Index place) const
  {
    if (place < m_blocks.size()) internal::prefetch(&m_blocks[place]);
  }

private:
  std::vector<Blocks> m_blocks;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
