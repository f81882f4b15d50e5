// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the parts of the front tell each other: each writes into its own boxes first, and then each reads those that are for
// it, in the order of the parts. So the order does not depend on which thread works on which part.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FRONT_MAIL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FRONT_MAIL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Wavefront_state.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Window_arena.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// What one part tells another.
template <class FT>
struct alignas(64) Front_box
{
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef typename Wavefront_state<FT>::Output Output;

  // Windows for a halfedge, and the distance of their nearest point.
  struct Windows
  {
    Windows(Window_arena<Window>& arena, const Output& output)
      : halfedge(output.halfedge()), nearest(output.nearest()), block(arena, output.begin(), output.size())
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

  std::vector<std::pair<Index, Vertex_arrival<FT>>> arrivals;
  std::vector<Windows> windows;
  std::vector<Single_window> single_windows;
  std::vector<Index> faces; // that the front has reached

  void clear()
  {
    arrivals.clear();
    windows.clear();
    single_windows.clear();
    faces.clear();
  }
};

// The boxes of one part, by the part for which they are. Can take the place of the state where rays are spread behind a
// vertex: of the distances in there it sees those of before, and what it was told itself.
template <class FT>
class Front_sender
{
public:
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef typename Wavefront_state<FT>::Output Output;
  typedef Front_box<FT> Box;

  explicit Front_sender(const Wavefront_state<FT>& state) : m_state(state), m_box(state.parts.number())
  {
    CGAL_assertion(state.parts.number() <= 32); // the bits of m_told
  }

  void update_vertex(Index v, const Vertex_arrival<FT>& a)
  {
    box(m_state.parts.of_vertex(v)).arrivals.emplace_back(v, a);
    m_last[1] = m_last[0];
    m_last[0] = {v, a.distance};
  }

  void schedule(Index f)
  {
    if (!m_state.face_state[f]) box(m_state.parts.of_face(f)).faces.push_back(f);
  }

  // The ends of g must be the last two vertices that were updated.
  void add(Index g, Window& w)
  {
    if (m_state.admits(g, distance(m_state.mesh.source(g)), distance(m_state.mesh.target(g)), w))
      box(m_state.parts.of_halfedge(g)).single_windows.push_back({g, w});
  }

  // Windows go into a block of the arena.
  void append(const Output& output, Window_arena<Window>& arena)
  {
    if (output.size() == 0) return;
    box(m_state.parts.of_halfedge(output.halfedge())).windows.emplace_back(arena, output);
  }

  Box& box_for(Index part) { return m_box[part]; }

  // The parts that were told something, by bits, since it was last asked.
  Index take_told()
  {
    const Index told = m_told;
    m_told = 0;
    return told;
  }

private:
  Box& box(Index part)
  {
    m_told |= Index(1) << part;
    return m_box[part];
  }

  FT distance(Index v) const
  {
    FT d = m_state.field.distance[v];
    for (const Update& u : m_last)
      if (u.vertex == v) d = (std::min)(d, u.distance);
    return d;
  }

  struct Update
  {
    Index vertex = no_index;
    FT distance = FT(0);
  };

  const Wavefront_state<FT>& m_state;
  std::vector<Box> m_box;
  Index m_told = 0;
  Update m_last[2];
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
