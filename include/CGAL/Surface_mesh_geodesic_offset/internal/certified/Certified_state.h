// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// State and results of the certified front.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_STATE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_STATE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_pruning.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Distance_bounds.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Bucket_queue.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_lists.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Window_output.h>

#include <algorithm>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

struct Certified_field
{
  Distance_bounds bounds;
  std::vector<Certified_window> windows; // kept windows by face, in the order of finalization
  std::vector<std::size_t> begin;        // four per face, as in Kept_windows, and one more: not empty for a mesh without faces
  std::size_t windows_created = 0, windows_propagated = 0;

  bool has_windows() const { return !begin.empty(); }

  template <class Function>
  void for_each_window(Index h, const Function& f) const
  {
    for (std::size_t i = begin[4 * (h / 3) + h % 3], n = begin[4 * (h / 3) + h % 3 + 1]; i < n; ++i) f(windows[i]);
  }
};

class Certified_state
{
public:
  typedef Certified_window Window;
  typedef Window_lists<double, Window, Window, Arrivals::longest_list> Lists;
  typedef Window_output<double, Window> Output;

  Certified_state(const Certified_mesh& m, bool keeps, Certified_field& f)
    : keeps_windows(keeps), mesh(m), unfolded(m.unfolded()), field(f), lists(unfolded.number_of_halfedges()),
      queue(0.25 * m.to_unit(unfolded.mean_edge_length())), m_arrivals(unfolded.number_of_vertices()),
      m_face_state(unfolded.number_of_faces(), 0)
  {
    field.bounds = Distance_bounds(unfolded.number_of_vertices());
    if (keeps_windows) field.begin.assign(4 * unfolded.number_of_faces() + 1, 0);
  }

  void set_number_of_primitives(std::size_t n)
  {
    lists.set_number_of_primitives(n);
    m_arrivals.set_number_of_primitives(n);
  }

  // Processes a path to v with an error of at most the radius; `back` is the direction to its start, known up to an angle.
  void arrive(Index v, double distance, double radius, const Ray_at_vertex<double>& back, double angle)
  {
    field.bounds.update(v, distance, radius);
    if (!mesh.can_be_pseudo_source(v) || distance - radius > field.bounds.upper(v)) return;
    if (m_arrivals.add(v, {back, angle, distance, radius, false, no_index}))
      queue.push_vertex((std::max)(queue.bucket_of(distance), queue.current()), v);
  }

  // Calls f(arrival) for each arrival at v that may be shortest and has not spread yet.
  template <class Function>
  void spread_arrivals(Index v, const Function& f)
  {
    m_arrivals.spread(v, [&](const Arrival& a) {
      if (a.lower() <= field.bounds.upper(v)) f(a);
    });
  }

  // Appends a window unless the ends of g prune it.
  void add(Index g, Window w)
  {
    auto output = m_single.start(g, accepts_windows(g), 1);
    if (!output.is_open() || !(w.b0 < w.b1)) return;
    output.next() = w;
    const double length = mesh.length(g);
    const double margin = pruning_margin(w.radius + 4 * w.error_of_image(), (std::max)(w.d0, w.d1), length);
    Certified_pruning pruning(length, field.bounds.upper(unfolded.source(g)), field.bounds.upper(unfolded.target(g)), margin);
    if (pruning.trim(output.next())) output.keep(output.next().minimum());
    m_single.finish(output);
    append(m_single);
  }

  // Prefetches the next halfedges of the queue.
  void prefetch_next() const
  {
    lists.prefetch_next(queue, [this](Index g) { prefetch_face(g); });
  }

  void prefetch_face(Index h) const
  {
    mesh.prefetch_face(h);
    unfolded.prefetch_face(h);
  }

  // False for border halfedges and finalized faces.
  bool accepts_windows(Index g) const { return g != no_index && m_face_state[g / 3] != FINISHED; }

  // Appends windows to the list of their halfedge, and inserts the halfedge into the queue.
  void append(const Output& output)
  {
    const std::size_t n = output.size();
    if (n == 0) return;
    auto& list = lists.get_or_create(output.halfedge());
    lists.append(output.halfedge(), list, output.begin(), n, lists.arena(0));
    field.windows_created += n;
    const std::size_t bucket = (std::max)(queue.bucket_of(output.nearest()), queue.current());
    if (bucket >= list.bucket) return;
    list.bucket = bucket;
    prefetch_face(output.halfedge());
    queue.push_halfedge(bucket, output.halfedge());
  }

  void schedule(Index f)
  {
    if (m_face_state[f]) return;
    m_face_state[f] = SCHEDULED;
    queue.push_face(queue.current() + 2, f);
  }

  // A face is final once the front has passed its largest distance by one bucket.
  void try_to_finish(Index f)
  {
    if (m_face_state[f] == FINISHED) return;
    double bound = Number_policy<double>::infinity();
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      bound = (std::min)(bound, field.bounds.upper(unfolded.source(h)) +
                                  (std::max)(mesh.length(h), mesh.length(unfolded.previous(h))));
    const std::size_t done = Number_policy<double>::is_finite(bound) ? queue.bucket_of(bound) + 2 : queue.current() + 2;
    if (done <= queue.current()) finish(f);
    else queue.push_face(done, f);
  }

  void finish_all()
  {
    for (Index f = 0; f < unfolded.number_of_faces(); ++f)
      if (m_face_state[f] == SCHEDULED) finish(f);
    release_finished();
  }

  // Releases the lists of finalized faces.
  void release_finished()
  {
    lists.release_faces(m_finished, lists.arena(0));
    m_finished.clear();
  }

  const bool keeps_windows;
  const Certified_mesh& mesh;
  const Unfolded_mesh<double>& unfolded;
  Certified_field& field;
  Lists lists;
  Bucket_queue queue;

private:
  enum Face_state : char { SCHEDULED = 1, FINISHED = 2 };

  void finish(Index f)
  {
    m_face_state[f] = FINISHED;
    m_finished.push_back(f);
    if (!keeps_windows) return;
    for (Index k = 0; k < 3; ++k)
    {
      const auto& list = lists.get(3 * f + k);
      field.begin[4 * f + k] = field.windows.size();
      field.windows.insert(field.windows.end(), list.propagated.begin(), list.propagated.end());
      field.begin[4 * f + k + 1] = field.windows.size();
    }
  }

  Output m_single;
  Arrivals m_arrivals;
  std::vector<char> m_face_state;
  std::vector<Index> m_finished; // faces with unreleased lists
};

} // namespace CGAL::Geodesic_offset::internal

#endif
