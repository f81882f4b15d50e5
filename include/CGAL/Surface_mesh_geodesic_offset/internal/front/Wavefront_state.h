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
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

struct Wavefront_counts
{
  std::size_t windows_created = 0, windows_propagated = 0;
};

// Candidate distance update for a vertex: the length of a path that leaves the vertex along `back`, straight to a pseudo-source
// or a source.
template <class FT>
struct Vertex_update
{
  FT distance;
  Ray_at_vertex<FT> back;
  Source_ref source_ref;
  Index pseudo_source;
  bool is_beside = false; // true if the bounding ray of the window misses the vertex by rounding
};

template <class FT>
class Wavefront_state : public Front_marks
{
public:
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef Vertex_update<FT> Update;
  typedef Window_output<FT, Window> Output;

  enum Vertex_state : char {
    IS_PENDING = 1, // rays have to be started from it, usually because it is a pseudo-source
    HAS_SPREAD = 2, // these rays have been started
    IS_BESIDE = 4,  // see Vertex_update
    WAS_HIDDEN = 8, // every window missed it through rounding, see reveal_vertex()
    REACHED = 32,   // the distance may have changed
    IS_TIED = 16    // Part::tied has other directions from which the rays of a path have to be started
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
    Output single;
    // Other paths to pseudo-sources, equal to the shortest one up to rounding. Each of them may have removed the rays of the others
    // before the vertex, so none may be left out behind it.
    std::multimap<Index, Ray_at_vertex<FT>> tied;
  };

  // `field` has the known distances. `needs_all_envelopes`: true if the lists of a finalized face must be lower envelopes, not
  // supersets of them.
  Wavefront_state(const Unfolded_mesh<FT>& unfolded, const FT& maximum_distance, bool needs_all_envelopes,
                  Geodesic_field<FT>& geodesic_field, const Front_parts& front_parts = Front_parts())
    : Front_marks(std::exchange(geodesic_field.marks, Front_marks())), mesh(unfolded), maximum(maximum_distance),
      needs_envelopes(needs_all_envelopes), field(geodesic_field), parts(front_parts),
      pending_faces(needs_envelopes ? mesh.number_of_faces() : 0, parts, reached_in),
      m_part(parts.number(), Part(bucket_edges(parts) * mesh.mean_edge_length())),
      m_most_listed(parts.number() == 1 ? most_listed(mesh.number_of_faces()) : 0)
  {
    Front_marks::clear(mesh.number_of_vertices(), mesh.number_of_faces());
    field.lists.reset(mesh.number_of_halfedges(), parts);
  }

  // Also after an exception.
  ~Wavefront_state()
  {
    are_listed = has_marked_few();
    if (field.keeps_memory) field.marks = static_cast<Front_marks&&>(*this);
  }

  // True if all elements with marks are listed.
  bool has_marked_few() const { return (std::max)(vertices.size(), faces.size()) < m_most_listed; }

  // Lists an element that gets its first mark.
  void list_marked(Index i, std::vector<Index>& items) const
  {
    if (items.size() < m_most_listed) items.push_back(i);
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

  // Removes a halfedge from the queue, and prefetches the data of the next ones.
  BOOST_FORCEINLINE bool pop_halfedge(Bucket_queue& queue, Index& h) const
  {
    if (!queue.pop_halfedge(h)) return false;
    field.lists.prefetch_next(queue, [this](Index g) { this->mesh.prefetch_face(g); });
    return true;
  }

  // Applies a candidate update. A vertex where shortest paths bend becomes a pending pseudo-source. Of equal distances, that of a
  // ray through the vertex has the more precise direction.
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
    if (!(vertex_state[v] & REACHED)) list_marked(v, vertices);
    vertex_state[v] |= REACHED;
    // An improvement within rounding needs no second spreading, and none where rays were or are started by the source at v.
    const bool ties = Number_policy<FT>::is_inexact && !is_shorter(d, known), has_source = field.back[v].corner == no_index;
    const bool may_replace = !a.is_beside && !(vertex_state[v] & HAS_SPREAD) &&
                             !(field.source_ref[v].is_lateral() && a.source_ref.side() == Source_side::CAP);
    const bool replaces_beside = may_replace && (vertex_state[v] & IS_BESIDE),
               is_shorter_tie = may_replace && ties && d < known;
    const bool is_better_direction = replaces_beside || is_shorter_tie;
    if (ties && has_source) return;
    if (!replaces_beside && may_tie(v, d))
    {
      if (mesh.can_be_pseudo_source(v)) add_tied(v, a.back, ties && !is_shorter_tie);
      else if (ties && !is_shorter(known, d) && gives_side(v, a))
      { // a path from a side is preferred to one from an end
        field.back[v] = Backtrace<FT>(a.back, a.pseudo_source);
        field.source_ref[v] = a.source_ref;
        if (d < known) known = d;
        return;
      }
    }
    else if (!ties && (vertex_state[v] & IS_TIED)) take_tied(v);
    if (ties && (is_shorter(known, d) || (vertex_state[v] & HAS_SPREAD))) return;
    if (d < known ? !a.is_beside || !ties : is_better_direction) known = d;
    if (ties && !is_better_direction) return;
    field.back[v] = Backtrace<FT>(a.back, a.pseudo_source);
    field.source_ref[v] = a.source_ref;
    vertex_state[v] &= char(~IS_BESIDE);
    if (ties) return;
    vertex_state[v] &= char(~(IS_PENDING | WAS_HIDDEN));
    if (a.is_beside) vertex_state[v] |= IS_BESIDE;
    if (a.back.corner == no_index || d > maximum) return; // fans of sources start elsewhere
    if (!mesh.can_be_pseudo_source(v)) return;
    vertex_state[v] |= IS_PENDING;
    Bucket_queue& queue = awake_part(parts.of_vertex(v)).queue;
    queue.push_vertex(queue.bucket_of(d), v);
  }

  // Apex update; the parallel sender has its own overload.
  void update_apex(Index v, const Update& a) { update_vertex(v, a); }

  // False if update_vertex() would change nothing.
  BOOST_FORCEINLINE bool may_change(Index v, const Update& a) const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return a.distance < field.distance[v];
    return a.distance < field.distance[v] || (!a.is_beside && (vertex_state[v] & IS_BESIDE)) || may_tie(v, a.distance);
  }

  // True if a path of length d to v may count that is equal to the known one up to rounding: v may be a pseudo-source, or its path
  // leads to the end of a polyline.
  BOOST_FORCEINLINE bool may_tie(Index v, const FT& d) const
  {
    return Number_policy<FT>::is_inexact && (mesh.can_be_pseudo_source(v) || field.source_ref[v].side() == Source_side::CAP) &&
           tie(d, field.distance[v]);
  }

  // True if a path leads to a side of a polyline, and the known one to the end of one.
  bool gives_side(Index v, const Update& a) const
  {
    return a.source_ref.is_lateral() && field.source_ref[v].side() == Source_side::CAP && !(vertex_state[v] & HAS_SPREAD);
  }

  // True if two distances of a vertex, at least one by a window, are equal up to rounding.
  bool tie(const FT& d, const FT& e) const
  {
    return CGAL::abs(FT(d - e)) <= rounding_at_vertex(d) + error_of_image(mesh.longest_edge());
  }

  // Difference of distances within which two paths to a vertex count as equally long.
  static FT rounding_at_vertex(const FT& d) { return Number_policy<FT>::rounding(roundings_at_vertex) * d; }

  // Of two directions, adds that which is not stored with the vertex: `back` or the known one.
  void add_tied(Index v, const Ray_at_vertex<FT>& back, bool keeps_known)
  {
    const Ray_at_vertex<FT> known = field.back[v].ray();
    if (!starts_ties || known.corner == no_index || back.corner == no_index) return;
    if (known.corner == back.corner &&
        CGAL::abs(FT(known.x * back.y - known.y * back.x)) <=
          Number_policy<FT>::rounding(roundings_of_equal_directions) * (known.x * back.x + known.y * back.y))
      return;
    Part& part = awake_part(parts.of_vertex(v));
    part.tied.emplace(v, keeps_known ? back : known);
    vertex_state[v] |= IS_TIED;
    part.queue.push_vertex(part.queue.bucket_of(field.distance[v]), v);
  }

  // Takes the tied directions of v out.
  std::vector<Ray_at_vertex<FT>> take_tied(Index v)
  {
    auto& tied = m_part[parts.of_vertex(v)].tied;
    const auto range = tied.equal_range(v);
    std::vector<Ray_at_vertex<FT>> result;
    std::transform(range.first, range.second, std::back_inserter(result), [](const auto& t) { return t.second; });
    tied.erase(range.first, range.second);
    vertex_state[v] &= char(~IS_TIED);
    return result;
  }

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

  // Update of v by the shortest path along an edge.
  Update along_edges(Index v, Source_ref source_ref) const
  {
    Update best;
    best.distance = Number_policy<FT>::infinity();
    mesh.for_each_fan(v, [&](Index first) {
      mesh.any_corner(first, [&](Index corner) {
        const Update a = along_edge(corner, source_ref);
        if (a.distance < best.distance) best = a;
        return false;
      });
    });
    return best;
  }

  // True if a distance is shorter than the known one by more than rounding.
  static bool is_shorter(const FT& distance, const FT& known)
  {
    return distance < known && !(known - rounding_at_vertex(known) <= distance); // known may be infinite
  }

  // Updates the source of h, a hidden vertex, by a path along an edge. The windows that missed it are lost to
  // the faces behind it too, so rays start from it in all directions.
  void reveal_vertex(Index h)
  {
    const Index v = mesh.source(h);
    const Update a = along_edges(v, field.source_ref[v]);
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
    list_marked(f, faces);
    Bucket_queue& queue = m_part[parts.of_face(f)].queue;
    pending_faces.add(f, queue.current());
    if (!may_read_distances || !postpone(f)) queue.push_face(queue.current() + 2, f);
  }

  // Puts a scheduled face into a later bucket if the front has not passed it, and returns true. The front has passed the face
  // two buckets after that of the largest distance: rounding may put a distance into the next bucket.
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

  // Trims a window of new rays by the distances ds and dt at the ends of g, and takes its positions from its rays: rounding on the
  // chord of a source may exceed that of the rays. Returns true if a part of it remains within the maximum.
  bool admits(Index g, const FT& ds, const FT& dt, Window& w) const
  {
    if (!takes_windows(g)) return false;
    const FT& length = mesh[g].length;
    const auto allowance = pruning_allowance<FT>(estimate(w.d1) + estimate(length), mesh.longest_edge());
    if (!Window_pruning<FT>(length, ds, dt, allowance).trim(w)) return false;
    if constexpr (Number_policy<FT>::is_inexact) w = restored<FT>(Stored_window<FT>(w), length);
    return !certainly_less(maximum, minimum(w));
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
  BOOST_FORCEINLINE void append(const Output& output, typename Window_lists<FT>::Arena& arena)
  {
    if (output.size() != 0) append_windows(output, arena);
  }

  BOOST_NOINLINE void append_windows(const Output& output, typename Window_lists<FT>::Arena& arena)
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

  const Unfolded_mesh<FT>& mesh;
  FT maximum;
  const bool needs_envelopes;
  bool starts_ties = true; // within a tolerance, merging closes the gaps that rays of directions that tie would fill
  Geodesic_field<FT>& field;
  const Front_parts parts;
  Pending_faces pending_faces;

private:
  // Units of rounding of a distance within which two paths to a vertex count as equally long.
  static constexpr double roundings_at_vertex = 64;

  // Units of rounding, an angle, within which two directions at a vertex are one: two products and a difference for each.
  static constexpr double roundings_of_equal_directions = 4;

  // Largest number of buckets by which a face is postponed, so that the number of buckets stays bounded. A face with a very
  // long edge is postponed several times.
  static constexpr std::size_t most_buckets_ahead = 1 << 12;

  // Width of a bucket, in mean edges. The parallel front has wider buckets for larger rounds, as each round ends with a
  // barrier.
  static double bucket_edges(const Front_parts& parts) { return parts.number() > 1 ? 0.35 : 0.25; }

  std::vector<Part> m_part;
  const std::size_t m_most_listed; // 0 with several parts
  std::size_t m_current = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
