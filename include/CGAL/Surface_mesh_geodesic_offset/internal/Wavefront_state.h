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
#include <CGAL/Surface_mesh_geodesic_offset/internal/Window_output.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Window_pruning.h>

#include <boost/config.hpp>

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
  typedef Window_output<FT, Window> Output;

  enum Vertex_state : char { WAITS = 1, HAS_SPREAD = 2, IS_BENT = 4 };
  enum Face_state : char { SCHEDULED = 1, FINISHED = 2, BOUNDED = 4 };

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
    typedef typename Estimation<FT>::Estimate Estimate;
    const FT& length = mesh[g].length;
    const Estimate allowance = pruning_allowance<FT>(estimate(w.d1) + estimate(length));
    const Window_pruning<FT> pruning(length, field.distance[mesh.source(g)], field.distance[mesh.target(g)], allowance);
    if (pruning.trim(w)) append(g, w);
  }

  void append(Index g, const Window& w)
  {
    auto cursor = m_single.start(g, takes_windows(g), 1);
    if (!cursor.is_open()) return;
    cursor.next() = w;
    keep(cursor, maximum);
    m_single.finish(cursor);
    append(m_single);
  }

  // A border or a face that the front has passed takes none.
  bool takes_windows(Index g) const { return g != no_index && !(face_state[mesh.face(g)] & FINISHED); }

  // Takes the next window, unless it is farther than the maximum.
  static BOOST_FORCEINLINE void keep(typename Output::Cursor& output, const FT& maximum)
  {
    const FT nearest = minimum(output.next());
    if (!certainly_less(maximum, nearest)) output.keep(nearest);
  }

  // Writes windows behind the list of their halfedge, and puts the halfedge into the queue.
  void append(const Output& output)
  {
    const std::size_t n = output.size();
    if (n == 0) return;
    auto& list = field.list(output.halfedge());
    field.lists.append(list, output.begin(), n);
    counts.windows_created += n;
    enqueue(output.halfedge(), list, queue.bucket_of(output.nearest()));
  }

  // Puts a halfedge into a bucket, or into the current one if that is later, unless it waits in an earlier one.
  void enqueue(Index h, Window_list<FT>& list, std::size_t bucket)
  {
    bucket = (std::max)(bucket, queue.current());
    if (bucket >= list.bucket) return;
    list.bucket = bucket;
    queue.push_halfedge(bucket, h);
  }

  const Unfolded_mesh<FT>& mesh;
  FT maximum;
  Geodesic_field<FT>& field;
  Bucket_queue queue;
  std::vector<char> vertex_state, face_state;
  bool has_bent_paths = false;
  Unfinished_faces unfinished;
  Wavefront_counts counts;

private:
  Output m_single;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
