// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the parts of the wavefront share: the field so far, the queue, and the ways to add to them.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WAVEFRONT_STATE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WAVEFRONT_STATE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Bucket_queue.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Unfinished_faces.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Window_pruning.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

struct Wavefront_counts
{
  std::size_t windows_created = 0, windows_propagated = 0;
};

template <class FT>
class Wavefront_state
{
public:
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef Ray_at_vertex<FT> Ray;

  enum Vertex_state : char { WAITS = 1, HAS_SPREAD = 2, IS_BENT = 4 };
  enum Face_state : char { SCHEDULED = 1, FINISHED = 2 };

  // The field says what is known already.
  Wavefront_state(const Unfolded_mesh<FT>& mesh, const FT& maximum_distance, Geodesic_field<FT>& field)
    : mesh(mesh), maximum(maximum_distance), field(field), queue(0.25 * CGAL::to_double(mesh.mean_edge_length())),
      vertex_state(mesh.number_of_vertices(), 0), face_state(mesh.number_of_faces(), 0),
      unfinished(mesh.number_of_faces())
  {
    field.lists = Window_lists<FT>(mesh.number_of_halfedges());
  }

  // A path to v of length d, that leaves v along `back`, straight to a pseudo-source or to the source. A vertex where
  // shortest paths bend becomes a pseudo-source once the front is there. A bent path has gone round the end of a window that
  // misses v by rounding: a straight one that is as long tells the direction better.
  void update_vertex(Index v, const FT& d, const Ray& back, Root root, Index pseudo_source, bool is_bent = false)
  {
    FT& known = field.distance[v];
    const FT rounding = known * Number_policy<FT>::rounding(64);
    if (!is_bent && (vertex_state[v] & IS_BENT) && !(vertex_state[v] & HAS_SPREAD) && root == field.root[v] &&
        CGAL::abs(FT(d - known)) <= rounding)
    {
      field.back[v] = Way_back<FT>(back, pseudo_source);
      vertex_state[v] &= char(~IS_BENT);
    }
    if (!(d < known)) return;
    // what rounding improves comes from no other root, and is no reason to spread again
    const bool ties = Number_policy<FT>::is_inexact && d >= known - rounding;
    if (ties && (vertex_state[v] & HAS_SPREAD)) return;
    known = d;
    if (ties) return;
    field.back[v] = Way_back<FT>(back, pseudo_source);
    field.root[v] = root;
    vertex_state[v] &= char(~(WAITS | IS_BENT));
    if (is_bent) vertex_state[v] |= IS_BENT;
    has_bent_paths |= is_bent;
    if (back.corner == no_index || !mesh.can_be_pseudo_source(v) || d > maximum) return; // a source spreads by itself
    vertex_state[v] |= WAITS;
    queue.push_vertex(queue.bucket_of(d), v);
  }

  // A face that the front has reached is looked at again when the front may have passed it.
  void schedule(Index f)
  {
    if (face_state[f]) return;
    face_state[f] = SCHEDULED;
    unfinished.add(f, queue.current());
    queue.push_face(queue.current() + 2, f);
  }

  // Adds a window to the list of g, trimmed by the distances of the ends of g.
  void add(Index g, Window& w)
  {
    const FT length = mesh[g].length;
    if (trim_by_ends<FT>(w, length, field.distance[mesh.source(g)], field.distance[mesh.target(g)],
                         Number_policy<FT>::rounding(8) * length))
      append(g, w);
  }

  void append(Index g, const Window& w)
  {
    Output output(*this, g, 1);
    output.next() = w;
    output.keep();
    output.close();
  }

  // Writes windows behind the list of a halfedge, and puts the halfedge into the queue.
  class Output
  {
  public:
    // For up to n windows. A border or a face that the front has passed takes none.
    Output(Wavefront_state& front, Index g, std::size_t n) : m_front(front), m_halfedge(g)
    {
      if (g == no_index || (front.face_state[front.mesh.face(g)] & FINISHED)) return;
      m_next = m_first = front.field.lists.room(front.field.list(g), n);
    }

    bool is_open() const { return m_first != nullptr; }

    // A place for one more window, and taking it.
    Window& next() { return *m_next; }
    void keep()
    {
      const FT nearest = minimum(*m_next);
      if (certainly_less(m_front.maximum, nearest)) return;
      m_nearest = lesser(m_nearest, nearest);
      ++m_next;
    }

    void close()
    {
      if (!m_first) return;
      auto& lists = m_front.field.lists;
      auto& list = lists.get(m_halfedge);
      const std::size_t n = std::size_t(m_next - m_first);
      if (n == 0)
      {
        if (list.size == 0) lists.release(m_halfedge);
        return;
      }
      lists.extend(list, n);
      m_front.counts.windows_created += n;
      const std::size_t bucket = (std::max)(m_front.queue.bucket_of(m_nearest), m_front.queue.current());
      if (bucket < list.bucket)
      {
        list.bucket = bucket;
        m_front.queue.push_halfedge(bucket, m_halfedge);
      }
    }

  private:
    Wavefront_state& m_front;
    Index m_halfedge;
    Window *m_first = nullptr, *m_next = nullptr;
    FT m_nearest = Number_policy<FT>::infinity();
  };

  const Unfolded_mesh<FT>& mesh;
  FT maximum;
  Geodesic_field<FT>& field;
  Bucket_queue queue;
  std::vector<char> vertex_state, face_state;
  bool has_bent_paths = false;
  Unfinished_faces unfinished;
  Wavefront_counts counts;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
