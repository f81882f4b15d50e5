// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Messages between the parts of the front. Each part writes into its own boxes in one round; in the next round, each recipient
// reads its boxes in the order of the parts. So the order does not depend on the assignment of parts to threads.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FRONT_SENDER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FRONT_SENDER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Front_partition.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Wavefront_state.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_arena.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Messages from one part to another in a round.
template <class FT>
struct Front_box
{
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef typename Wavefront_state<FT>::Output Output;

  // Windows for a halfedge, and the distance of their nearest point.
  struct Windows
  {
    Windows(typename Window_lists<FT>::Arena& arena, const Output& output)
      : halfedge(output.halfedge()), nearest(output.nearest()), block(arena.pending, output.begin(), output.size())
    {
    }

    Index halfedge;
    FT nearest;
    Window_block<Window> block;
  };
  struct Single_window
  {
    Index halfedge;
    Window window;
  };

  std::vector<std::pair<Index, Vertex_update<FT>>> updates;
  std::vector<Windows> windows;
  std::vector<Single_window> single_windows;
  std::vector<Index> faces; // reached by the front

  void clear()
  {
    updates.clear();
    windows.clear();
    single_windows.clear();
    faces.clear();
  }
};

// The boxes of one part, per recipient, of this round and of the previous round, which is read meanwhile. Updates of shared
// vertices go to all parts.
//
// Replaces the state when rays start behind a vertex: it reads distances of the previous round and its own updates.
template <class FT>
class Front_sender
{
public:
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef typename Wavefront_state<FT>::Output Output;
  typedef Front_box<FT> Box;
  typedef std::vector<std::pair<Index, Vertex_update<FT>>> Updates;

  Front_sender(Wavefront_state<FT>& state, Index part) : m_state(&state), m_part(part)
  {
    CGAL_assertion(state.parts.number() <= Front_partition::largest_number); // the bits of m_recipients
    for (auto& places : m_place) places.assign(state.parts.number(), none);
  }

  // Starts a round; its messages are read in the next round.
  void begin(unsigned round)
  {
    m_parity = round & 1u;
    m_recipients = 0;
    m_pending = 0;
    m_nearest = Number_policy<FT>::infinity();
  }

  // The recipients, as bits; the number of their pending halfedges in this bucket; the smallest distance.
  std::uint64_t recipients() const { return m_recipients; }
  std::size_t pending() const { return m_pending; }
  const FT& nearest() const { return m_nearest; }

  // The box of the previous round for a part.
  Box& box_for(Index part, unsigned round)
  {
    CGAL_precondition(m_place[round & 1u][part] != none);
    return m_box[round & 1u][m_place[round & 1u][part]];
  }

  // Updates of vertices where faces of several parts meet.
  Updates& shared_updates() { return m_shared_updates; }

  void update_vertex(Index v, const Vertex_update<FT>& a)
  {
    if (!m_state->parts.has_alone(v)) m_shared_updates.emplace_back(v, a);
    else box(m_state->parts.of_vertex(v), a.distance).updates.emplace_back(v, a);
    m_last[1] = m_last[0];
    m_last[0] = {v, a.distance};
  }

  // Overload for rounds in which only this part reads its unshared vertices: they change at once. Other parts receive only
  // updates that may change something.
  void update_apex(Index v, const Vertex_update<FT>& a)
  {
    if (m_state->parts.has_alone(v)) m_state->update_vertex(v, a);
    else if (m_state->may_change(v, a)) m_shared_updates.emplace_back(v, a);
  }

  void schedule(Index f)
  {
    const Index part = m_state->parts.of_face(f);
    if (part == m_part) m_state->schedule(f);
    else box(part, Number_policy<FT>::infinity()).faces.push_back(f);
  }

  // Precondition: the ends of g are the last two vertices that were updated.
  void add(Index g, Window& w)
  {
    CGAL_precondition(m_last[0].vertex == m_state->mesh.source(g) || m_last[1].vertex == m_state->mesh.source(g));
    CGAL_precondition(m_last[0].vertex == m_state->mesh.target(g) || m_last[1].vertex == m_state->mesh.target(g));
    add_apart(g, w);
  }

  // Variant for a halfedge apart from the vertex of the rays. Updates of its ends in this round may not trim the window.
  void add_apart(Index g, Window& w)
  {
    if (m_state->admits(g, distance(m_state->mesh.source(g)), distance(m_state->mesh.target(g)), w))
      box_for_windows(m_state->parts.of_halfedge(g), minimum(w)).single_windows.push_back({g, w});
  }

  // Windows for other parts go into a block of the arena.
  void append(const Output& output, typename Window_lists<FT>::Arena& arena)
  {
    if (output.size() == 0) return;
    const Index part = m_state->parts.of_halfedge(output.halfedge());
    if (part == m_part) m_state->append(output, arena);
    else box_for_windows(part, output.nearest()).windows.emplace_back(arena, output);
  }

private:
  static constexpr std::uint8_t none = 0xff;

  Box& box(Index part, const FT& nearest)
  {
    m_recipients |= std::uint64_t(1) << part;
    m_nearest = (std::min)(m_nearest, nearest);
    std::uint8_t& place = m_place[m_parity][part];
    if (place == none)
    {
      place = std::uint8_t(m_box[m_parity].size());
      m_box[m_parity].emplace_back();
    }
    return m_box[m_parity][place];
  }

  Box& box_for_windows(Index part, const FT& nearest)
  {
    if (m_state->part(m_part).queue.bucket_of(nearest) <= m_state->current()) ++m_pending;
    return box(part, nearest);
  }

  FT distance(Index v) const
  {
    FT d = m_state->field.distance[v];
    for (const Update& u : m_last)
      if (u.vertex == v) d = (std::min)(d, u.distance);
    return d;
  }

  struct Update
  {
    Index vertex = no_index;
    FT distance = FT(0);
  };

  Wavefront_state<FT>* m_state;
  Index m_part;
  unsigned m_parity = 0;                // of the round
  std::vector<Box> m_box[2];            // for all recipients so far
  std::vector<std::uint8_t> m_place[2]; // of the box for each part
  Updates m_shared_updates;
  std::uint64_t m_recipients = 0;
  std::size_t m_pending = 0;
  FT m_nearest = Number_policy<FT>::infinity();
  Update m_last[2];
};

} // namespace CGAL::Geodesic_offset::internal

#endif
