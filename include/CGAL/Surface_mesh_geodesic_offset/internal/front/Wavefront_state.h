// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The state of the wavefront: the field so far, the queues of the parts, and the operations that add to them.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_WAVEFRONT_STATE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_WAVEFRONT_STATE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Geodesic_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Bucket_queue.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Pending_faces.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Window_output.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_pruning.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

struct Wavefront_counts
{
  std::size_t windows_created = 0, windows_propagated = 0;
};

// Candidate distance update for a vertex: the length of a path that leaves the vertex along `back`, straight to a pseudo-source
// or a source. A bent path goes around the end of a window that misses the vertex through rounding.
template <class FT>
struct Vertex_update
{
  FT distance;
  Ray_at_vertex<FT> back;
  Source_ref source_ref;
  Index pseudo_source;
  bool is_bent = false;
  bool is_beside_end = false; // of the window; see Vertex_sector::for_each_margin_behind()
};

template <class FT>
class Wavefront_state
{
public:
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef Vertex_update<FT> Update;
  typedef Window_output<FT, Window> Output;

  enum Vertex_state : char {
    IS_PENDING = 1,  // rays have to be started from it, usually because it is a pseudo-source
    HAS_SPREAD = 2,  // these rays have been started
    IS_BENT = 4,     // its path is bent, see Vertex_update
    WAS_HIDDEN = 8,  // every window missed it through rounding, see reveal_vertex()
    TIES = 16,       // paths from several images may tie there
    HAS_MARGINS = 32 // rays of its margins have been started, see Vertex_sector
  };
  enum Face_state : char {
    SCHEDULED = 1, // the front has reached the face
    BOUNDED = 2    // the face is in the bucket in which it will be finalized, see Face_finalizer
  };

  // Data of a part of the front. An operation on an element changes only the data of its part and of the element.
  struct alignas(64) Part
  {
    explicit Part(double bucket_width) : queue(bucket_width) {}

    Bucket_queue queue;
    Wavefront_counts counts;
    bool has_bent_paths = false;
    Output single;
  };

  // `field` has the known distances. `needs_all_envelopes`: true if the lists of a finalized face must be lower envelopes, not
  // supersets of them.
  Wavefront_state(const Unfolded_mesh<FT>& unfolded, const FT& maximum_distance, bool needs_all_envelopes,
                  Geodesic_field<FT>& geodesic_field, const Front_parts& front_parts = Front_parts())
    : mesh(unfolded), maximum(maximum_distance), needs_envelopes(needs_all_envelopes), field(geodesic_field),
      parts(front_parts), vertex_state(mesh.number_of_vertices(), 0), face_state(mesh.number_of_faces(), 0),
      is_finalized(mesh.number_of_faces(), 0), pending_faces(needs_envelopes ? mesh.number_of_faces() : 0, parts),
      m_part(parts.number(), Part(bucket_edges(parts) * mesh.mean_edge_length()))
  {
    field.lists = Window_lists<FT>(mesh.number_of_halfedges(), parts);
  }

  Part& part(Index i) { return m_part[i]; }

  // The current bucket of the front. The queue of a part advances to it when the part has work.
  std::size_t current() const { return m_current; }
  void move_to(std::size_t bucket)
  {
    CGAL_precondition(bucket >= m_current);
    m_current = bucket;
  }
  std::size_t bucket_of(const FT& distance) const { return m_part.front().queue.bucket_of(distance); }

  // Moves to a later bucket when no event is left in the queues, which puts pending faces there.
  void jump_to(std::size_t bucket)
  {
    for (Part& p : m_part) p.queue.jump_to(bucket);
    m_current = bucket;
  }

  double bucket_width() const { return m_part.front().queue.bucket_width(); }
  FT passed() const { return FT(double(m_current) * bucket_width()); } // distance passed by the front

  Part& awake_part(Index i)
  {
    m_part[i].queue.move_to(m_current);
    return m_part[i];
  }

  bool is_awake(Index part) const { return m_part[part].queue.current() == m_current; }

  Wavefront_counts counts() const
  {
    Wavefront_counts sum;
    for (const Part& p : m_part)
    {
      sum.windows_created += p.counts.windows_created;
      sum.windows_propagated += p.counts.windows_propagated;
    }
    return sum;
  }

  // True if rounding has hidden a vertex from the window that gives its distance, as in needles.
  bool has_bent_paths() const
  {
    return std::any_of(m_part.begin(), m_part.end(), [](const Part& p) { return p.has_bent_paths; });
  }

  // Removes a halfedge from the queue, and prefetches the data of the next ones.
  BOOST_FORCEINLINE bool pop_halfedge(Bucket_queue& queue, Index& h) const
  {
    if (!queue.pop_halfedge(h)) return false;
    field.lists.prefetch_next(queue, [this](Index g) { this->mesh.prefetch_face(g); });
    return true;
  }

  // Applies a candidate update. A vertex where shortest paths bend becomes a pending pseudo-source. The direction of a straight
  // path is more precise than that of a bent path of equal length.
  BOOST_FORCEINLINE void update_vertex(Index v, const Update& a)
  {
    CGAL_precondition(CGAL::possibly(estimate(a.distance) >= 0));
    CGAL_precondition(a.back.corner == no_index || mesh.source(a.back.corner) == v);
    if (BOOST_UNLIKELY(may_change(v, a))) change_vertex(v, a);
  }

  BOOST_NOINLINE void change_vertex(Index v, const Update& a)
  {
    const FT& d = a.distance;
    FT& known = field.distance[v];
    FT rounding = known * Number_policy<FT>::rounding(64);
    if (a.is_bent != bool(vertex_state[v] & IS_BENT) && a.back.corner != no_index) // rarely
      rounding += Number_policy<FT>::rounding(64) * (mesh[a.back.corner].length + mesh[mesh.previous(a.back.corner)].length);
    if (!a.is_bent && (vertex_state[v] & IS_BENT) && !(vertex_state[v] & HAS_SPREAD) && CGAL::abs(FT(d - known)) <= rounding)
    {
      field.back[v] = Backtrace<FT>(a.back, a.pseudo_source);
      field.source_ref[v] = a.source_ref;
      vertex_state[v] &= char(~IS_BENT);
    }
    if constexpr (Number_policy<FT>::is_inexact)
    {
      if (BOOST_UNLIKELY(d <= known + rounding && (a.is_beside_end || d >= known - rounding)))
      {
        add_tie(v);
        if (d >= known - rounding && hides_more(v, a)) return take_direction(v, a);
      }
    }
    if (!(d < known)) return;
    // An improvement within rounding needs no second spreading, and none where rays were or are started by the source at v.
    const bool ties = Number_policy<FT>::is_inexact && d >= known - rounding;
    if (ties && ((vertex_state[v] & HAS_SPREAD) || field.back[v].corner == no_index)) return;
    known = d;
    if (ties) return;
    field.back[v] = Backtrace<FT>(a.back, a.pseudo_source);
    field.source_ref[v] = a.source_ref;
    vertex_state[v] &= char(~(IS_PENDING | IS_BENT | WAS_HIDDEN | TIES | HAS_MARGINS));
    if (a.is_bent) vertex_state[v] |= IS_BENT;
    if (a.is_beside_end) vertex_state[v] |= TIES;
    Part& p = awake_part(parts.of_vertex(v));
    if (a.is_bent) p.has_bent_paths = true;
    if (a.back.corner == no_index || d > maximum) return; // fans of sources start elsewhere
    if (!mesh.can_be_pseudo_source(v) && !is_beside_image(v, a.pseudo_source, least_hiding_distance<FT>())) return;
    vertex_state[v] |= IS_PENDING;
    p.queue.push_vertex(p.queue.bucket_of(d), v);
  }

  // Queues a vertex that the front may have passed.
  void push_again(Index v)
  {
    Bucket_queue& queue = awake_part(parts.of_vertex(v)).queue;
    queue.push_vertex((std::max)(queue.bucket_of(field.distance[v]), queue.current()), v);
  }

  // Records that paths of several images may tie at v.
  BOOST_NOINLINE void add_tie(Index v)
  {
    if (vertex_state[v] & TIES) return;
    vertex_state[v] |= TIES;
    if (!lacks_margins(v) || field.back[v].corner == no_index || !mesh.can_be_pseudo_source(v)) return;
    push_again(v);
  }

  // True if an update ties at v, and its image is so near that rays behind v may be hidden, and far nearer than the known one. The
  // directions of v from both images have the same uncertainty, but only the nearer image determines the gap behind v, see
  // hidden_angle(). Binding test: test_field_regressions, tie with a near image.
  bool hides_more(Index v, const Update& a) const
  {
    const Backtrace<FT>& known = field.back[v];
    if (a.is_bent || a.back.corner == no_index || known.corner == no_index || a.pseudo_source == known.pseudo_source)
      return false;
    const FT far = distance_of_image(a.distance, a.pseudo_source, a.source_ref);
    return 2 * far < distance_of_image(v, known.pseudo_source) && is_beside_image(v, far, least_hiding_distance<FT>());
  }

  // Replaces the direction of v by that of an update that ties, and starts the rays behind v from it, too.
  void take_direction(Index v, const Update& a)
  {
    field.distance[v] = (std::min)(field.distance[v], a.distance);
    field.back[v] = Backtrace<FT>(a.back, a.pseudo_source);
    field.source_ref[v] = a.source_ref;
    vertex_state[v] &= char(~(IS_BENT | HAS_MARGINS));
    if (a.distance > maximum) return;
    vertex_state[v] |= IS_PENDING;
    push_again(v);
  }

  // True if a vertex is so near to the image of its window that rounding loses directions behind it (least_clear_distance).
  // Paths through the vertex in all directions replace the lost ones; they are at most 8 u L too long.
  bool is_beside_image(Index v, Index pseudo_source, const FT& least = least_clear_distance<FT>()) const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return false;
    else return is_beside_image(v, distance_of_image(v, pseudo_source), least);
  }

  // `distance`: of the image.
  bool is_beside_image(Index v, const FT& distance, const FT& least) const
  {
    const FT far = distance / least;
    if (far >= mesh.longest_edge()) return false;
    bool result = false;
    const auto is_long = [&](Index h) { return far < mesh[h].length || far < mesh[mesh.next(h)].length; };
    mesh.for_each_fan(v, [&](Index first) { result = result || mesh.any_corner(first, is_long); });
    return result;
  }

  // Twice the angle of the gap that a vertex next to its image leaves behind it; zero for other vertices. Directions of paths
  // that tie up to the rounding of an edge differ by at most the square root of this rounding over the distance.
  FT hidden_angle(Index v) const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return FT(0);
    else
    {
      const Index pseudo_source = field.back[v].pseudo_source;
      if (!is_beside_image(v, pseudo_source, least_hiding_distance<FT>())) return FT(0);
      const FT gap = Number_policy<FT>::rounding(16) * mesh.longest_edge() / distance_of_image(v, pseudo_source);
      return (std::max)(gap, square_root<FT>(gap));
    }
  }

  FT distance_of_image(Index v, Index pseudo_source) const
  {
    return distance_of_image(field.distance[v], pseudo_source, field.source_ref[v]);
  }

  FT distance_of_image(const FT& distance, Index pseudo_source, Source_ref source_ref) const
  {
    const bool is_source = pseudo_source == no_index || Merge_error_code::is_merged(pseudo_source);
    return distance - (is_source ? field.start_values.of(source_ref) : field.distance[pseudo_source]);
  }

  // Apex update; the parallel sender has its own overload.
  void update_apex(Index v, const Update& a) { update_vertex(v, a); }

  // False if update_vertex() would change nothing.
  BOOST_FORCEINLINE bool may_change(Index v, const Update& a) const
  {
    const FT& known = field.distance[v];
    if constexpr (!Number_policy<FT>::is_inexact) return a.distance < known;
    return a.distance <= known + known * Number_policy<FT>::rounding(64) || (!a.is_bent && (vertex_state[v] & IS_BENT));
  }

  // True if a vertex has spread its sectors but must still spread its margins.
  bool lacks_margins(Index v) const { return (vertex_state[v] & (HAS_SPREAD | TIES | HAS_MARGINS)) == (HAS_SPREAD | TIES); }

  // Update of the source of h by the shorter path along an edge of the face of h, in place of a path with the given source.
  Update along_edge(Index h, Source_ref source_ref) const
  {
    const Index p = mesh.previous(h), v = mesh.target(h), u = mesh.source(p);
    const FT by_v = field.distance[v] + mesh[h].length, by_u = field.distance[u] + mesh[p].length;
    const bool is_by_v = by_v <= by_u;
    const Ray_at_vertex<FT> back =
      is_by_v ? Ray_at_vertex<FT>{h, FT(1), FT(0)} : Ray_at_vertex<FT>{h, mesh[h].apex_x, mesh[h].apex_y};
    const Index corner = is_by_v ? v : u;
    const Index pseudo_source = field.back[corner].corner == no_index ? no_index : corner;
    return {is_by_v ? by_v : by_u, back, field.source_ref_via(corner, source_ref), pseudo_source};
  }

  // True if a distance is shorter than the known one by more than rounding.
  static bool is_shorter(const FT& distance, const FT& known)
  {
    return distance < known && !(known - known * Number_policy<FT>::rounding(64) <= distance); // known may be infinite
  }

  // Updates the source of h, a hidden vertex, by a path along an edge of the face of h. The windows that missed it are lost to
  // the faces behind it too, so rays start from it in all directions.
  void reveal_vertex(Index h)
  {
    const Index v = mesh.source(h);
    const Update a = along_edge(h, field.source_ref[v]);
    if (!is_shorter(a.distance, field.distance[v])) return;
    vertex_state[v] &= char(~HAS_SPREAD);
    update_vertex(v, a);
    vertex_state[v] |= IS_PENDING | WAS_HIDDEN;
    Bucket_queue& queue = awake_part(parts.of_vertex(v)).queue;
    queue.push_vertex(queue.bucket_of(a.distance), v);
  }

  // Records a face reached by the front for examination when the front may have passed it. Its part must be awake. If the
  // distances at its corners may be read, they usually give the bucket.
  void schedule(Index f, bool may_read_distances = false)
  {
    if (face_state[f]) return;
    CGAL_precondition(is_awake(parts.of_face(f)) && !is_finalized[f]);
    face_state[f] = SCHEDULED;
    Bucket_queue& queue = m_part[parts.of_face(f)].queue;
    pending_faces.add(f, queue.current());
    if (!may_read_distances || !postpone(f)) queue.push_face(queue.current() + 2, f);
  }

  // Puts a scheduled face into a later bucket if the front has not passed it, and returns true. The front has passed the face
  // two buckets after that of the largest distance: one bucket later, gaps at that distance are closed (await_gap()).
  bool postpone(Index f)
  {
    char& state = face_state[f];
    if (state & BOUNDED) return false; // this is the bucket of a bound, which does not grow
    Bucket_queue& queue = m_part[parts.of_face(f)].queue;
    const FT bound = largest_distance(f);
    const bool is_bounded = Number_policy<FT>::is_finite(bound);
    const std::size_t done = (is_bounded ? queue.bucket_of(bound) : queue.current()) + 2;
    if (done <= queue.current()) return false;
    const std::size_t next = (std::min)(done, queue.current() + most_buckets_ahead);
    if (is_bounded && next == done) state |= BOUNDED;
    queue.push_face(next, f);
    return true;
  }

  // Upper bound of the distances in a face: the distance of a corner plus the longer of its two edges; the least of the three.
  FT largest_distance(Index f) const
  {
    const auto* const edge = &mesh[3 * f];
    const auto by_corner = [&](Index k, Index previous) {
      const FT &a = edge[k].length, &b = edge[previous].length;
      return FT(field.distance[edge[k].origin] + (certainly_less(a, b) ? b : a));
    };
    return lesser(lesser(by_corner(0, 2), by_corner(1, 0)), by_corner(2, 1));
  }

  // Adds a window to the list of g, trimmed by the distances at the ends of g.
  void add(Index g, Window& w)
  {
    if (admits(g, field.distance[mesh.source(g)], field.distance[mesh.target(g)], w)) append(g, w);
  }

  // Adds a window to the list of a halfedge that is not incident to the vertex of the rays. Front_sender distinguishes this case
  // from add(); here, both are equal.
  void add_apart(Index g, Window& w) { add(g, w); }

  // Trims a window by the distances ds and dt at the ends of g. Returns true if a part of it remains within the maximum.
  bool admits(Index g, const FT& ds, const FT& dt, Window& w) const
  {
    if (!takes_windows(g)) return false;
    const FT& length = mesh[g].length;
    const auto allowance = pruning_allowance<FT>(estimate(w.d1) + estimate(length));
    return Window_pruning<FT>(length, ds, dt, allowance).trim(w) && !certainly_less(maximum, minimum(w));
  }

  void append(Index g, const Window& w)
  {
    if (!takes_windows(g)) return;
    Output& output = m_part[parts.of_halfedge(g)].single;
    auto cursor = output.start(g, true, 1);
    cursor.next() = w;
    keep(cursor, maximum);
    output.finish(cursor);
    append(output);
  }

  // False for a border and for a finalized face.
  bool takes_windows(Index g) const { return g != no_index && !is_finalized[mesh.face(g)]; }

  // Accepts the next window unless it is beyond the maximum.
  static BOOST_FORCEINLINE void keep(typename Output::Cursor& output, const FT& maximum)
  {
    const FT nearest = minimum(output.next());
    if (!certainly_less(maximum, nearest)) output.keep(nearest);
  }

  // Appends windows to the list of their halfedge, and enqueues the halfedge.
  void append(const Output& output) { append(output, field.lists.arena(0)); }
  BOOST_FORCEINLINE void append(const Output& output, Window_arena<Window>& arena)
  {
    if (output.size() != 0) append_windows(output, arena);
  }

  BOOST_NOINLINE void append_windows(const Output& output, Window_arena<Window>& arena)
  {
    const std::size_t n = output.size();
    const Index h = output.halfedge();
    auto& list = field.list(h, arena);
    field.lists.append(h, list, output.begin(), n, arena);
    enqueue(h, list, n, output.nearest());
  }

  // Puts a halfedge with n new windows into the bucket of the nearest one, at least the current bucket, unless it is pending in
  // an earlier one. Its part must be awake.
  void enqueue(Index h, Window_list<FT>& list, std::size_t n, const FT& nearest)
  {
    CGAL_precondition(is_awake(parts.of_halfedge(h)) && list.has_new());
    Part& p = m_part[parts.of_halfedge(h)];
    p.counts.windows_created += n;
    const std::size_t bucket = (std::max)(p.queue.bucket_of(nearest), p.queue.current());
    if (bucket >= list.bucket) return;
    list.bucket = bucket;
    mesh.prefetch_face(h); // at least into the outer caches
    p.queue.push_halfedge(bucket, h);
  }

  // Puts a halfedge into the bucket in which the front has passed a gap in its list, at distance d.
  void await_gap(Index h, Window_list<FT>& list, const FT& d)
  {
    if (!(d <= maximum) || !Number_policy<FT>::is_finite(d)) return;
    Bucket_queue& queue = m_part[parts.of_halfedge(h)].queue;
    list.has_gap = true;
    list.bucket = (std::max)(queue.bucket_of(d), queue.current()) + 1;
    queue.push_halfedge(list.bucket, h);
  }

  const Unfolded_mesh<FT>& mesh;
  FT maximum;
  const bool needs_envelopes;
  Geodesic_field<FT>& field;
  const Front_parts parts;
  std::vector<char> vertex_state, face_state; // bits
  std::vector<char> is_finalized;             // true for finalized faces; read by all parts
  Pending_faces pending_faces;

private:
  // Largest number of buckets by which a face is postponed, so that the number of buckets stays bounded. A face with a very
  // long edge is postponed several times.
  static constexpr std::size_t most_buckets_ahead = 1 << 12;

  // Width of a bucket, in mean edges. The parallel front has wider buckets for larger rounds, as each round ends with a
  // barrier.
  static double bucket_edges(const Front_parts& parts) { return parts.number() > 1 ? 0.35 : 0.25; }

  std::vector<Part> m_part;
  std::size_t m_current = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
