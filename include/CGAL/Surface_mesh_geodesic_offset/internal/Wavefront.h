// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 3 of the pipeline: the wavefront. A halfedge is taken with its whole list of windows, the list is reduced to its
// lower envelope and propagated across the face at once; vertices where shortest paths bend become pseudo-sources; faces
// that the front has passed are handed to the consumer and released.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WAVEFRONT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WAVEFRONT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Bucket_queue.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Initial_windows.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Lower_envelope.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Vertex_sector.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Window_lists.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Window_propagation.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Window_pruning.h>

#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// What is known of the distance field: at the vertices always, on the edges as far as the lists were kept.
template <class FT>
struct Geodesic_field
{
  std::vector<FT> distance;              // per vertex
  std::vector<Ray_at_vertex<FT>> back;   // per vertex, the direction back to the source
  std::vector<Root> root;                // per vertex
  Window_lists<FT> lists;                // per halfedge

  void release_lists() { lists = Window_lists<FT>(); }
};

struct Wavefront_counts
{
  std::size_t windows_created = 0, windows_propagated = 0;
};

template <class Traits>
class Wavefront
{
public:
  typedef typename Traits::FT FT;
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef Ray_at_vertex<FT> Ray;

  Wavefront(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Traits& traits,
            const FT& maximum_distance, bool keep_lists, Geodesic_field<FT>& field)
    : m_mesh(mesh), m_initial(initial), m_traits(traits), m_maximum(maximum_distance), m_keep(keep_lists),
      m_field(field), m_sector(mesh), m_envelope(initial.source_of),
      m_queue(0.5 * CGAL::to_double(mesh.mean_edge_length())), m_vertex_state(mesh.number_of_vertices(), 0),
      m_face_state(mesh.number_of_faces(), 0)
  {
    field.distance.assign(mesh.number_of_vertices(), Number_policy<FT>::infinity());
    field.back.assign(mesh.number_of_vertices(), Ray());
    field.root.assign(mesh.number_of_vertices(), Root());
    field.lists = Window_lists<FT>(mesh.number_of_halfedges());
  }

  // consumer(face) is called once for each face that the front has passed, while the lists of its halfedges, and the
  // distances at its corners, are final and still there.
  template <class Consumer>
  void run(Consumer& consumer)
  {
    start();
    while (m_queue.advance())
    {
      Index i;
      if (m_queue.pop_face(i))
        try_to_finish(i, consumer);
      else if (m_queue.pop_halfedge(i))
        take(i);
      else if (m_queue.pop_vertex(i))
        spread_from_pseudo_source(i);
    }
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f)
      if (!(m_face_state[f] & FINISHED) && is_reached(f)) finish(f, consumer);
    for (FT& d : m_field.distance)
      if (d > m_maximum) d = Number_policy<FT>::infinity();
  }

  const Wavefront_counts& counts() const { return m_counts; }

private:
  enum Vertex_state : char { WAITS = 1, HAS_SPREAD = 2 };
  enum Face_state : char { SCHEDULED = 1, FINISHED = 2 };

  void start()
  {
    for (const auto& s : m_initial.seeds) update_vertex(s.vertex, s.distance, s.back, s.root);
    for (const auto& f : m_initial.fans) spread(f.vertex, f.from, f.to, f.first, f.root, no_index);
    for (const auto& e : m_initial.edges)
    {
      Window w{FT(0), FT(-1), FT(0), e.b0, e.b1, FT(0), FT(0), e.root, Window::make_bits(true, no_index)};
      append(e.halfedge, w);
    }
    for (const auto& l : m_initial.local)
    {
      schedule(l.face);
      const Face_frame<FT> frame(m_mesh, l.face);
      for (int k = 0; k < 3; ++k)
        if (l.window.edge == 3 || l.window.edge == k) leave_face(l.face, frame, k, l.window);
    }
  }

  // The part of a window that starts in a face and leaves it through halfedge k.
  void leave_face(Index face, const Face_frame<FT>& frame, int k, const Face_window<FT>& local)
  {
    const Index g = m_mesh.twin(3 * face + k);
    if (g == no_index) return;
    Window w{local.x, local.y, local.sigma, FT(0), m_mesh[g].length, FT(0), FT(0), local.root, local.bits};
    frame.window_to_twin(k, w);
    if (!CGAL::is_negative(w.y)) return;
    const Point_in_face<FT> left = frame.to_twin(k, local.left), right = frame.to_twin(k, local.right);
    const auto towards = [&](const Point_in_face<FT>& c) {
      return w.is_parallel() ? Point_in_face<FT>{-w.x, -w.y} : Point_in_face<FT>{c.x - w.x, c.y - w.y};
    };
    if (local.edge == k)
    {
      w.b0 = left.x;
      w.b1 = right.x;
    }
    else if (!clip(left, towards(left), FT(-1), w) || !clip(right, towards(right), FT(1), w))
      return;
    if (w.b0 < FT(0)) w.b0 = FT(0);
    if (w.b1 > m_mesh[g].length) w.b1 = m_mesh[g].length;
    if (!(w.b0 < w.b1)) return;
    w.d0 = w.distance_at(w.b0);
    w.d1 = w.distance_at(w.b1);
    add(g, w);
  }

  // Clips the interval to the side of the ray from c with direction u where the cross product has the given sign.
  static bool clip(const Point_in_face<FT>& c, const Point_in_face<FT>& u, const FT& sign, Window& w)
  {
    const FT g0 = sign * (u.x * (FT(0) - c.y) - u.y * (w.b0 - c.x));
    const FT g1 = sign * (u.x * (FT(0) - c.y) - u.y * (w.b1 - c.x));
    if (!CGAL::is_positive(g0) && !CGAL::is_positive(g1)) return false;
    const FT b0 = w.b0, b1 = w.b1;
    if (CGAL::is_negative(g0)) w.b0 = b0 + (g0 / (g0 - g1)) * (b1 - b0);
    if (CGAL::is_negative(g1)) w.b1 = b1 + (g1 / (g1 - g0)) * (b0 - b1);
    return true;
  }

  // --- vertices ---------------------------------------------------------------------------------------------------

  void update_vertex(Index v, const FT& d, const Ray& back, Root root)
  {
    FT& known = m_field.distance[v];
    if (!(d < known)) return;
    // what rounding improves is no reason to spread again
    if ((m_vertex_state[v] & HAS_SPREAD) && d >= known - known * Number_policy<FT>::rounding(64)) return;
    known = d;
    m_field.back[v] = back;
    m_field.root[v] = root;
    if (back.corner == no_index || !m_mesh.can_be_pseudo_source(v) || d > m_maximum) return;
    m_vertex_state[v] |= WAITS;
    m_queue.push_vertex(m_queue.bucket_of(d), v);
  }

  // Behind a vertex reached along a direction, shortest paths go on only at angles of at least pi to it on either side.
  void spread_from_pseudo_source(Index v)
  {
    if (!(m_vertex_state[v] & WAITS)) return;
    m_vertex_state[v] = HAS_SPREAD;
    const Ray back = m_field.back[v];
    const Root root = m_field.root[v];
    const Ray from = m_sector.turn_ccw(back, 2), to = m_sector.turn_cw(back, 2);
    if (from.corner != no_index && to.corner != no_index)
    {
      // With a total angle of 2 pi up to rounding the two limits may come in the wrong order: then there is no sector.
      if (!comes_first(back.corner, from.corner, to.corner)) spread(v, from, to, from.corner, root, v);
    }
    else
    {
      Index first = back.corner;
      for (Index c = first; c != no_index; c = m_mesh.corner_cw(c)) first = c;
      if (from.corner != no_index) spread(v, from, Ray(), first, root, v);
      if (to.corner != no_index) spread(v, Ray(), to, first, root, v);
    }
    if (m_mesh.has_several_fans(v))
      m_mesh.for_each_fan(v, [&](Index first) {
        if (!in_fan(back.corner, first)) spread(v, Ray(), Ray(), first, root, v);
      });
  }

  bool comes_first(Index c, Index from, Index to) const
  {
    for (Index i = from; i != no_index && i != to; i = m_mesh.corner_ccw(i))
      if (i == c) return true;
    return false;
  }

  bool in_fan(Index c, Index first) const
  {
    Index i = first;
    do
    {
      if (i == c) return true;
      i = m_mesh.corner_ccw(i);
    } while (i != no_index && i != first);
    return false;
  }

  // The rays from v in a sector: windows on the edges opposite to v, and distances along the edges.
  void spread(Index v, const Ray& from, const Ray& to, Index first, Root root, Index pseudo_source)
  {
    const FT sigma = m_field.distance[v];
    m_sector.for_each_corner(from, to, first, [&](Index h, const Ray* lower, const Ray* upper) {
      const Index e = m_mesh.next(h), p = m_mesh.previous(h);
      schedule(m_mesh.face(h));
      update_vertex(m_mesh.source(e), sigma + m_mesh[h].length, Ray{e, m_mesh[e].apex_x, m_mesh[e].apex_y}, root);
      update_vertex(m_mesh.source(p), sigma + m_mesh[p].length, Ray{p, FT(1), FT(0)}, root);
      const Index g = m_mesh.twin(e);
      if (g == no_index) return;
      const FT length = m_mesh[e].length;
      Window w{length - m_mesh[e].apex_x, -m_mesh[e].apex_y, sigma, FT(0), length, FT(0), FT(0), root,
               Window::make_bits(false, pseudo_source)};
      if (lower) w.b1 = exit_of_ray(h, *lower, length);
      if (upper) w.b0 = exit_of_ray(h, *upper, length);
      if (!(w.b0 < w.b1)) return;
      w.d0 = w.distance_at(w.b0);
      w.d1 = w.distance_at(w.b1);
      add(g, w);
    });
  }

  // Where a ray from the source of h leaves the face, in the frame of the twin of the opposite edge.
  FT exit_of_ray(Index h, const Ray& r, const FT& length) const
  {
    const FT b = cross(r.x, r.y, m_mesh[h].apex_x, m_mesh[h].apex_y), a = cross(r.x, r.y, m_mesh[h].length, FT(0));
    if (!CGAL::is_positive(b)) return FT(0);
    if (!CGAL::is_negative(a)) return length;
    return (b / (b - a)) * length;
  }

  // --- windows ----------------------------------------------------------------------------------------------------

  // Adds a window to the list of g, trimmed by the distances of the ends of g.
  void add(Index g, Window& w)
  {
    const FT length = m_mesh[g].length;
    if (trim_by_ends<FT>(w, length, m_field.distance[m_mesh.source(g)], m_field.distance[m_mesh.target(g)],
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
    Output(Wavefront& front, Index g, std::size_t n) : m_front(front), m_halfedge(g)
    {
      if (g == no_index || (front.m_face_state[front.m_mesh.face(g)] & FINISHED)) return;
      m_next = m_first = front.m_field.lists.room(front.m_field.lists.get_or_create(g), n);
    }

    bool is_open() const { return m_first != nullptr; }

    // A place for one more window, and taking it.
    Window& next() { return *m_next; }
    void keep()
    {
      const FT nearest = m_next->minimum();
      if (nearest > m_front.m_maximum) return;
      if (nearest < m_nearest) m_nearest = nearest;
      ++m_next;
    }

    void close()
    {
      if (!m_first) return;
      auto& lists = m_front.m_field.lists;
      auto& list = lists.get(m_halfedge);
      const std::size_t n = std::size_t(m_next - m_first);
      if (n == 0)
      {
        if (list.size == 0) lists.release(m_halfedge);
        return;
      }
      lists.extend(list, n);
      m_front.m_counts.windows_created += n;
      const std::size_t bucket = (std::max)(m_front.m_queue.bucket_of(m_nearest), m_front.m_queue.current());
      if (bucket < list.bucket)
      {
        list.bucket = bucket;
        m_front.m_queue.push_halfedge(bucket, m_halfedge);
      }
    }

  private:
    Wavefront& m_front;
    Index m_halfedge;
    Window *m_first = nullptr, *m_next = nullptr;
    FT m_nearest = Number_policy<FT>::infinity();
  };

  // Takes the list of a halfedge: reduces it to its lower envelope and propagates what is new.
  void take(Index h)
  {
    if (!m_field.lists.has(h)) return;
    auto& list = m_field.lists.get(h);
    if (list.bucket != m_queue.current() || list.taken == list.size) return;
    list.bucket = List::not_queued;
    const std::vector<Window>& envelope =
      m_envelope(list.data, list.data + list.taken, list.data + list.size, m_mesh[h].length);
    m_field.lists.assign(list, envelope);
    list.taken = list.size;
    for (Window* w = list.data; w != list.data + list.size; ++w) w->set_propagated();
    schedule(m_mesh.face(h));
    propagate(h, envelope);
  }

  enum Exit : char { NONE, LEFT, BOTH, RIGHT };

  void propagate(Index h, const std::vector<Window>& windows)
  {
    const Window_propagation<FT> face(m_mesh, h);
    const std::size_t n = windows.size();
    FT best, entry;
    sort_by_exit(h, face, windows, best, entry);

    const Index apex = m_mesh.apex(h), p = m_mesh.source(h), q = m_mesh.target(h);
    const FT dp = m_field.distance[p], dq = m_field.distance[q], dr = m_field.distance[apex];
    const Index left = m_mesh.twin(m_mesh.previous(h)), right = m_mesh.twin(m_mesh.next(h));
    // the far vertices in the frames of the exits: q seen from p -> r, p seen from r -> q
    const FT qx = face.cl * face.length, qy = -face.sl * face.length;
    const FT px = face.right_length - face.cr * face.length, py = -face.sr * face.length;
    const FT left_width = Number_policy<FT>::rounding(8) * face.left_length;
    const FT right_width = Number_policy<FT>::rounding(8) * face.right_length;
    Output to_left(*this, left, n), to_right(*this, right, n);
    for (std::size_t i = 0; i < n; ++i)
    {
      const Exit exit = m_exit[i];
      if (exit == NONE) continue;
      const Window& w = windows[i];
      ++m_counts.windows_propagated;
      FT split, d_apex, left_end, right_begin;
      FT d_left = w.d1, d_right = w.d0;
      bool left_to_apex = false, right_from_apex = false, goes_left = exit != RIGHT, goes_right = exit != LEFT;
      left_end = w.b1;
      right_begin = w.b0;
      if (exit == BOTH)
      {
        // One angle, one split: only the window that is best at the apex keeps all its rays. Another one keeps, on the
        // side of the best ray's entry, the rays that enter before it.
        split = face.entry_of_apex(w);
        d_apex = face.distance_at_apex(w);
        left_to_apex = d_apex <= best || split <= entry;
        right_from_apex = d_apex <= best || split >= entry;
        left_end = left_to_apex ? split : entry;
        right_begin = right_from_apex ? split : entry;
        goes_left = left_end > w.b0;
        goes_right = right_begin < w.b1;
        if (!left_to_apex && goes_left) d_left = w.distance_at(left_end);
        if (!right_from_apex && goes_right) d_right = w.distance_at(right_begin);
      }
      if (goes_left && to_left.is_open())
      {
        Window& child = to_left.next();
        if (face.left_child(w, left_end, d_left, left_to_apex, d_apex, child) &&
            !filtered_by_far_vertex<FT>(child.b0, child.d0, dq, qx, qy) &&
            trim_by_ends<FT>(child, face.left_length, dp, dr, left_width))
          to_left.keep();
      }
      if (goes_right && to_right.is_open())
      {
        Window& child = to_right.next();
        if (face.right_child(w, right_begin, d_right, right_from_apex, d_apex, child) &&
            !filtered_by_far_vertex<FT>(child.b1, child.d1, dp, px, py) &&
            trim_by_ends<FT>(child, face.right_length, dr, dq, right_width))
          to_right.keep();
      }
    }
    to_left.close();
    to_right.close();
  }

  // Tells through which edges the windows leave the face, and updates the distance of the apex: by the best of the
  // windows that cover it, or, where rounding has left it between two windows, by paths round their ends, which are
  // always valid. Returns the best distance given to the apex through h so far, and where its ray enters.
  void sort_by_exit(Index h, const Window_propagation<FT>& face, const std::vector<Window>& windows, FT& best, FT& entry)
  {
    const auto compare = m_traits.compare_entry_with_apex_2_object();
    auto& list = m_field.lists.get(h);
    best = list.split_distance;
    entry = list.split_entry;
    m_exit.resize(windows.size());
    const Window *nearest = nullptr, *last_left = nullptr, *first_right = nullptr;
    bool covered = false;
    for (std::size_t i = 0; i < windows.size(); ++i)
    {
      const Window& w = windows[i];
      if (w.is_propagated())
      {
        m_exit[i] = NONE;
        continue;
      }
      if (compare(w.x, w.y, w.is_parallel(), w.b0, face.apex_x, face.apex_y) == POSITIVE)
      {
        m_exit[i] = RIGHT;
        if (!first_right) first_right = &w;
      }
      else if (compare(w.x, w.y, w.is_parallel(), w.b1, face.apex_x, face.apex_y) == NEGATIVE)
      {
        m_exit[i] = LEFT;
        last_left = &w;
      }
      else
      {
        m_exit[i] = BOTH;
        covered = true;
        const FT d = face.distance_at_apex(w);
        if (d < best)
        {
          best = d;
          nearest = &w;
        }
      }
    }
    if (nearest)
    {
      const Window& w = *nearest;
      entry = face.entry_of_apex(w);
      list.split_distance = best;
      list.split_entry = entry;
      const FT bx = w.is_parallel() ? w.x : FT(w.x - face.apex_x), by = w.is_parallel() ? w.y : FT(w.y - face.apex_y);
      update_apex(h, face, best, bx, by, w.root);
    }
    if (!covered)
    {
      if (last_left) round_the_end(h, face, last_left->b1, last_left->d1, last_left->root);
      if (first_right) round_the_end(h, face, first_right->b0, first_right->d0, first_right->root);
    }
  }

  void round_the_end(Index h, const Window_propagation<FT>& face, const FT& b, const FT& d, Root root)
  {
    if (!(d < m_field.distance[m_mesh.apex(h)])) return;
    const FT bx = b - face.apex_x;
    update_apex(h, face, d + square_root<FT>(bx * bx + face.apex_y * face.apex_y), bx, -face.apex_y, root);
  }

  // (bx, by): from the apex back towards the source, in the frame of h.
  void update_apex(Index h, const Window_propagation<FT>& face, const FT& d, const FT& bx, const FT& by, Root root)
  {
    const Ray back{m_mesh.previous(h), -(face.cl * bx + face.sl * by), face.sl * bx - face.cl * by};
    update_vertex(m_mesh.apex(h), d, back, root);
  }

  // --- faces ------------------------------------------------------------------------------------------------------

  void schedule(Index f)
  {
    if (m_face_state[f]) return;
    m_face_state[f] = SCHEDULED;
    m_queue.push_face(m_queue.current() + 2, f);
  }

  bool is_reached(Index f) const
  {
    if (m_mesh.source(3 * f) == no_index) return false;
    if (m_face_state[f]) return true;
    for (Index k = 0; k < 3; ++k)
      if (m_field.distance[m_mesh.source(3 * f + k)] <= m_maximum) return true;
    return false;
  }

  // No point of the face is farther than this: a corner's distance and the way from there.
  FT largest_distance(Index f) const
  {
    FT bound = Number_policy<FT>::infinity();
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const FT way = (std::max)(m_mesh[h].length, m_mesh[m_mesh.previous(h)].length);
      bound = (std::min)(bound, FT(m_field.distance[m_mesh.source(h)] + way));
    }
    return bound;
  }

  template <class Consumer>
  void try_to_finish(Index f, Consumer& consumer)
  {
    if (m_face_state[f] & FINISHED) return;
    const FT bound = largest_distance(f);
    const std::size_t done = Number_policy<FT>::is_finite(bound) ? m_queue.bucket_of(bound) + 1 : m_queue.current() + 2;
    if (done <= m_queue.current())
      finish(f, consumer);
    else
      m_queue.push_face(done, f);
  }

  template <class Consumer>
  void finish(Index f, Consumer& consumer)
  {
    m_face_state[f] |= FINISHED;
    consumer(f);
    if (m_keep) return;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) m_field.lists.release(h);
  }

  typedef typename Window_lists<FT>::List List;

  const Unfolded_mesh<FT>& m_mesh;
  const Initial_windows<FT>& m_initial;
  const Traits& m_traits;
  const FT m_maximum;
  const bool m_keep;
  Geodesic_field<FT>& m_field;
  Vertex_sector<FT> m_sector;
  Lower_envelope<FT> m_envelope;
  Bucket_queue m_queue;
  std::vector<char> m_vertex_state, m_face_state;
  std::vector<Exit> m_exit;
  Wavefront_counts m_counts;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
