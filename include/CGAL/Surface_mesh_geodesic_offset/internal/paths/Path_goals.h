// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Goals of straight parts of shortest paths. A path is traced from the query point to the source; a straight part ends at its
// goal, a pseudo-source or a source. Tests whether the path has reached its goal, and finds the part of the source on which it
// ends.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_GOALS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_GOALS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Vertex_sector.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_suffix_cache.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_start.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Straight_walk.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Interval_filter.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/window_allowance.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Path_goals
{
public:
  typedef Point_in_face<FT> Point;
  typedef Surface_point<FT> Surface_point_;
  typedef Suffix_end<FT> End;

  // Error of the position of a point on an edge, in units of rounding of the edge. A position is a quotient of two cross
  // products, with two roundings in each, times the length.
  static constexpr double roundings_of_position = 8;

  // Largest distance by which a straight part of a path misses its goal through rounding, in units of rounding of the distance
  // plus the longest edge. Each change of the frame adds a rounding error to the direction of the path.
  static constexpr double roundings_of_miss = 1 << 12;

  // Relative distance, as a fraction of the length of an edge or of a straight part. A path this close to a vertex may pass
  // through the vertex.
  static constexpr double nearby = 1. / (1 << 30);

  // Largest distance by which a straight part of the given length misses its goal. `extent`: longest edge of the faces that it
  // crosses.
  static FT miss(const FT& length_of_part, const Path_start<FT>& start, const FT& extent)
  {
    return FT(nearby) * length_of_part + Number_policy<FT>::rounding(roundings_of_miss) * (start.distance + extent);
  }

  // The goal of a straight part: a vertex, a point in a face or on the edge of two faces, or a source segment. `end` has the
  // point, and the source reference of a source.
  struct Goal
  {
    Index vertex = no_index, face = no_index, other_face = no_index;
    End end;

    bool is_segment() const { return vertex == no_index && face == no_index; }
  };

  Path_goals(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field)
    : m_mesh(mesh), m_initial(initial), m_field(field)
  {
  }

  Goal of(const Path_start<FT>& start) const
  {
    Goal goal;
    goal.vertex = start.pseudo_source;
    const Index primitive = start.source_ref.primitive();
    const Surface_point_& place = m_initial.places[primitive].first;
    if (goal.vertex == no_index)
    {
      goal.end = {place, start.source_ref};
      if (m_initial.primitives[primitive].is_segment) return goal;
      if (place.kind == Surface_point_::VERTEX) goal.vertex = place.element;
      else if (place.kind == Surface_point_::FACE) goal.face = goal.other_face = place.element;
      else
      {
        goal.face = m_mesh.face(place.element);
        goal.other_face = m_mesh.twin(place.element) == no_index ? goal.face : m_mesh.face(m_mesh.twin(place.element));
      }
    }
    else goal.end = {Surface_point_::at_vertex(goal.vertex), Source_ref()};
    return goal;
  }

  // True if a path to the given source may pass through a vertex or end there: the shortest path of the vertex has the same
  // source and side, or the vertex is a point of the source. A vertex with another source is excluded even if the two sources
  // tie there, so that the path keeps its source.
  bool may_pass_through(Index v, Source_ref source_ref) const
  {
    if (is_source(v) && is_at_vertex(source_ref, v)) return true;
    const Source_ref other = m_field.source_ref[v];
    return other.is_valid() && source_of(other) == source_of(source_ref) && (is_source(v) || other.side() == source_ref.side());
  }

  bool is_source(Index v) const { return m_field.is_source(v); }

  // True if the goal is a point of the closed face.
  bool is_in_face(const Goal& goal, Index face) const
  {
    if (goal.vertex != no_index) return has_corner(face, goal.vertex);
    return goal.face != no_index && (face == goal.face || face == goal.other_face);
  }

  // True if the goal is a point of the closed face of the walk. Then the straight segment to the goal is the shortest path,
  // since it is the shortest in space; `distance` receives its length. Always false for source segments. `is_first`: in the
  // first face of the path, all three corners are tested; in later faces, only the corner opposite to the entered halfedge.
  bool is_in_sight(const Goal& goal, const Straight_walk<FT>& walk, bool is_first, FT& distance) const
  {
    if (goal.vertex != no_index)
    {
      for (int k = 2; k >= (is_first ? 0 : 2); --k)
        if (walk.vertex(k) == goal.vertex)
        {
          distance = length(walk.corner(k) - walk.position());
          return true;
        }
      return false;
    }
    if (goal.face == no_index || (walk.face() != goal.face && walk.face() != goal.other_face)) return false;
    Point place;
    unsigned edges;
    CGAL_assertion_code(const bool is_there =) position_in_face(m_mesh, goal.end.point, walk.face(), place, edges);
    CGAL_assertion(is_there);
    const Face_frame<FT> frame(m_mesh, walk.face());
    distance = length(place - frame.from_halfedge(int(walk.halfedge() % 3), walk.position()));
    return true;
  }

  // True for a window of a segment along which the start value varies. Its rays have one virtual start, beyond the segment: a line at
  // a right angle to them through the end with the smaller value. Paths by it end where they cross the segment.
  bool has_virtual_start(const Path_start<FT>& start) const
  {
    return start.pseudo_source == no_index && m_initial.primitives[start.source_ref.primitive()].varies;
  }

  // True if position t of halfedge h is on a segment of the same source, where the path has `left` before it to its virtual start;
  // `end` receives the end of the path. Segments that are reached earlier than their start value are crossed.
  bool ends_on_varying_segment(Index h, const FT& t, const FT& left, const Path_start<FT>& start, const FT& extent,
                               End& end) const
  {
    const FT allowance = miss(left, start, extent);
    bool result = false;
    m_initial.for_each_edge_window(h, [&](const auto& w) {
      if (result || source_of(w.source_ref) != source_of(start.source_ref) || t < w.b0 - allowance || t > w.b1 + allowance)
        return;
      const FT value = w.start + w.slope * (t - w.b0);
      if (CGAL::abs(FT(value - (start.start_value + left))) > allowance) return;
      result = true;
      end = {Surface_point_::on_edge(h, (std::max)(w.b0, (std::min)(t, w.b1))), w.source_ref};
    });
    return result;
  }

  FT distance_of(const Goal& goal) const
  {
    return goal.end.is_at_source() ? m_field.start_values.of(goal.end.source_ref) : m_field.distance[goal.vertex];
  }

  // True if a point is at a vertex, up to the rounding of positions on edges.
  bool is_at(const Surface_point_& p, Index v) const
  {
    if (p.kind == Surface_point_::VERTEX) return p.element == v;
    const FT part = Number_policy<FT>::rounding(roundings_of_position);
    if (p.kind == Surface_point_::EDGE)
    {
      const FT& size = m_mesh[p.element].length;
      return (p.x <= part * size && m_mesh.source(p.element) == v) ||
             (size - p.x <= part * size && m_mesh.target(p.element) == v);
    }
    const Face_frame<FT> frame(m_mesh, p.element);
    for (int k = 0; k < 3; ++k)
      if (m_mesh.source(3 * p.element + Index(k)) == v)
        return length(Point{p.x, p.y} - frame.corner(k)) <= part * frame.edge_length(k);
    return false;
  }

  // Overload for a point on a halfedge: true if p, on the edge or in the face of h, is at the distance t from the source of h,
  // up to the rounding of positions.
  bool is_at(const Surface_point_& p, Index h, const FT& t) const
  {
    const FT& size = m_mesh[h].length;
    const FT allowance = Number_policy<FT>::rounding(roundings_of_position) * size;
    if (p.kind == Surface_point_::EDGE && (p.element == h || m_mesh.twin(p.element) == h))
      return CGAL::abs(FT((p.element == h ? p.x : FT(size - p.x)) - t)) <= allowance;
    if (p.kind != Surface_point_::FACE || p.element != m_mesh.face(h)) return false;
    return length(Point{p.x, p.y} - Face_frame<FT>(m_mesh, p.element).on_edge(int(h % 3), t)) <= allowance;
  }

  // End of a straight part that has reached its goal in the face of h. p: the point where the part enters the face or starts in
  // it. p and `direction` are in the frame of h.
  End end_at_goal(const Goal& goal, Index h, const Point& p, const Point& direction, const Path_start<FT>& start) const
  {
    return goal.vertex == no_index || goal.end.is_at_source() ? goal.end : end_at_vertex(goal.vertex, h, p, direction, start);
  }

  // Overload for a straight part that reaches the vertex v of the face of h. If v is a source, the path ends there, and the
  // source windows in the face determine the side of the source.
  End end_at_vertex(Index v, Index h, const Point& p, const Point& direction, const Path_start<FT>& start) const
  {
    const Surface_point_ at_v = Surface_point_::at_vertex(v);
    if (!is_source(v)) return {at_v, Source_ref()};
    const FT everywhere = Number_policy<FT>::infinity();
    End_search arrival{start.source_ref, everywhere, FT(0), false};
    const auto search_at_corner = [&](Index face, const auto& way_to, End_search& search) {
      const Face_frame<FT> frame(m_mesh, face);
      search.nearest = miss(FT(0), start, frame.longest_edge());
      find_end(frame, face, way_to(frame, frame.corner(int(corner_at(v, face) % 3))), search);
    };
    const int edge = int(h % 3);
    search_at_corner(
      m_mesh.face(h),
      [&](const Face_frame<FT>& frame, const Point& corner) {
        return way_in(frame, frame.from_halfedge(edge, p), corner, frame.vector_from_halfedge(edge, direction), start.length());
      },
      arrival);
    if (arrival.is_of_known_source()) return {at_v, arrival.end.source_ref};
    if (is_at_vertex(start.source_ref, v)) return end_at_source_vertex(v, start);
    // Another part of the known source may contain the vertex; look for it in all faces of the vertex.
    End_search around{start.source_ref, everywhere, FT(0), true};
    const Index from = corner_at(v, m_mesh.face(h));
    const Face_frame<FT> frame(m_mesh, m_mesh.face(h));
    const Point back = FT(-1) * frame.vector_to_halfedge(int(from % 3), frame.vector_from_halfedge(edge, direction));
    for (const Index face : faces_of(m_mesh, at_v))
      for (const bool ccw : {true, false})
        search_at_corner(
          face,
          [&](const Face_frame<FT>& f, const Point& corner) {
            const Index to = corner_at(v, face);
            Point u = back;
            if (!Number_policy<FT>::is_inexact || !turn_to_corner(m_mesh, from, to, ccw, u)) return way_at(corner);
            return way_in(f, corner, corner, FT(-1) * f.vector_from_halfedge(int(to % 3), u), start.length());
          },
          around);
    if (around.is_found()) return {at_v, around.end.source_ref};
    if (arrival.is_found()) return {at_v, arrival.end.source_ref};
    return end_at_source_vertex(v, start);
  }

  // Halfedge of the face with the source v, a corner of the face.
  Index corner_at(Index v, Index face) const
  {
    Index h = 3 * face;
    while (m_mesh.source(h) != v) ++h;
    CGAL_postcondition(m_mesh.face(h) == face);
    return h;
  }

  // End at a source vertex if the face of arrival has no window of the source. The corner of a polyline is on both sides of the
  // polyline; the path keeps the side from its start.
  End end_at_source_vertex(Index v, const Path_start<FT>& start) const
  {
    End end{Surface_point_::at_vertex(v), m_field.source_ref[v]};
    if (is_at_vertex(start.source_ref, v)) end.source_ref = start.source_ref;
    else if (end.source_ref.is_lateral() && start.source_ref.is_lateral() &&
             source_of(end.source_ref) == source_of(start.source_ref))
      end.source_ref = Source_ref(end.source_ref.primitive(), start.source_ref.side());
    return end;
  }

  // Part of the source that contains p, up to rounding; invalid if there is none.
  Source_ref source_ref_at(const Surface_point_& p, const Path_start<FT>& start) const
  {
    if (p.kind == Surface_point_::VERTEX) return m_field.source_ref[p.element];
    const Source_ref source_ref = source_ref_within(p, start, 64);
    // Distances of windows that were extended over gaps are too small by up to window_allowance().
    return source_ref.is_valid() ? source_ref : source_ref_within(p, start, 512);
  }

  // True if a path to a source segment ends in the face that the walk has entered; `end` receives the end. `extent`: longest
  // edge of the crossed faces. The direction of the path has a rounding error, so the path may end on the source segment
  // adjacent to its goal, in the next face. `has_missed`: a first walk found no end within this error. Then the nearest point
  // of any source is accepted: where coincident sources overlap in part, rounding may exchange their windows. `reach`: length
  // of the straight part of the path.
  bool ends_on_segment(const Straight_walk<FT>& walk, const Path_start<FT>& start, const FT& reach, const FT& extent,
                       bool has_missed, End& end) const
  {
    const Index face = walk.face();
    const Face_frame<FT> frame(m_mesh, face);
    const int edge = int(walk.halfedge() % 3);
    const Point p = frame.from_halfedge(edge, walk.position()), q = frame.from_halfedge(edge, walk.goal());
    const Point direction = frame.vector_from_halfedge(edge, walk.direction());
    const FT length_of_way = length(q - p), rounding = window_allowance<FT>(start.distance + extent);
    Way way = way_in(frame, p, q, direction, start.length());
    FT longest = length_of_way + rounding,
       nearest = has_missed ? FT(length_of_way + longest) : miss(length_of_way, start, extent);
    if (Number_policy<FT>::is_inexact && has_missed && CGAL::is_positive(length(direction)))
    { // the straight part will be aimed at the end, and may turn by as much as rounding of its length allows
      way.start = q - (reach / length(direction)) * direction;
      longest = reach + rounding;
      nearest += square_root<FT>(FT(2) * longest * rounding);
    }
    End_search search{start.source_ref, longest, nearest, !has_missed};
    find_end(frame, face, way, search);
    end = search.end;
    return search.is_found();
  }

private:
  // Part of the source that is nearest to p, at most `roundings` units of rounding of the edges away; invalid if there is none.
  // The search visits all faces within this distance, starting with the faces of p.
  Source_ref source_ref_within(const Surface_point_& p, const Path_start<FT>& start, double roundings) const
  {
    struct Visit
    {
      Index face;
      Point position;
    };
    std::vector<Visit> ring, next;
    std::vector<Index> seen = faces_of(m_mesh, p);
    FT nearest(0);
    for (const Index face : seen)
    {
      ring.push_back({face, {}});
      unsigned edges;
      position_in_face(m_mesh, p, face, ring.back().position, edges);
      nearest = (std::max)(nearest, FT(Number_policy<FT>::rounding(roundings) * Face_frame<FT>(m_mesh, face).longest_edge()));
    }
    for (; !ring.empty(); ring.swap(next), next.clear())
    {
      End_search search{start.source_ref, nearest, nearest, false};
      for (const Visit& v : ring) find_end(Face_frame<FT>(m_mesh, v.face), v.face, way_at(v.position), search);
      if (search.is_found()) return search.end.source_ref;
      for (const Visit& v : ring)
      {
        const Face_frame<FT> frame(m_mesh, v.face);
        for (int k = 0; k < 3; ++k)
        {
          const Index h = 3 * v.face + Index(k), g = m_mesh.twin(h);
          if (is_source(m_mesh.source(h)) && length(v.position - frame.corner(k)) <= nearest)
            return m_field.source_ref[m_mesh.source(h)];
          if (g == no_index || std::find(seen.begin(), seen.end(), m_mesh.face(g)) != seen.end()) continue;
          const FT along = (std::max)(FT(0), (std::min)(frame.along(k, v.position), m_mesh[h].length));
          if (!(length(v.position - frame.on_edge(k, along)) <= nearest)) continue;
          seen.push_back(m_mesh.face(g));
          const Face_frame<FT> beyond(m_mesh, m_mesh.face(g));
          next.push_back({m_mesh.face(g), beyond.from_halfedge(int(g % 3), frame.to_twin(k, v.position))});
        }
      }
    }
    return Source_ref();
  }

  // Segment of the path in a face, from `first` to `last`. `before` determines the side of a source segment from which the path
  // comes: the first point, or a point farther back on the path if the first point is on the source segment up to rounding.
  // The length of the path counts from `start`.
  struct Way
  {
    Point first, last, before, start;
  };

  static Way way_at(const Point& p) { return {p, p, p, p}; }

  // Makes the segment from p to q, of a path with the given direction and length.
  static Way way_in(const Face_frame<FT>& frame, const Point& p, const Point& q, const Point& direction, const FT& distance)
  {
    Way way{p, q, p, p};
    if constexpr (Number_policy<FT>::is_inexact)
    {
      const FT clear = (std::min)(distance, FT(Number_policy<FT>::rounding(clear_roundings) * frame.longest_edge()));
      const FT size = length(direction);
      if (CGAL::is_positive(size) && length(q - p) < clear) way.before = q - (clear / size) * direction;
    }
    return way;
  }

  // A point counts as inside a cone up to this distance, in units of rounding of the longest edge.
  static constexpr double reach_roundings = 64;

  // Distance of `before` from a source segment, along the path, in the same units. Unless the path meets the segment at an
  // angle of less than 2^-10, a point this far away is in the cones of one side only.
  static constexpr double clear_roundings = 1024 * reach_roundings;

  // Search for the end of a path, for its segment to q in a face: the source point nearest to q, at most `nearest` from q and at
  // most `longest` from Way::start. `known`: the source reference of the window at the start of the path. Several parts of
  // sources may tie, since windows of collinear segments merge and sources may coincide; End_preference gives the order among
  // them. `only_known_source`: parts of other sources are not accepted.
  struct End_search
  {
    const Source_ref known;
    const FT longest;
    FT nearest;
    const bool only_known_source;
    int preference = -1;
    End end{};

    bool is_found() const { return preference >= 0; }
    bool is_of_known_source() const { return preference >= CONE_HAS_START + KNOWN_SOURCE; }
  };
  // Properties of a part of a source, by their weight. The part with the largest sum is the end.
  enum End_preference {
    IS_POINT = 1, // a point, if its cone does not contain p
    KNOWN_PRIMITIVE = 2,
    KNOWN_SIDE = 4,
    SIDE_OF_ARRIVAL = 8, // the path arrives on the side of the part
    KNOWN_SOURCE = 16,
    CONE_HAS_START = 32 // the cone of the part contains p
  };

  void find_end(const Face_frame<FT>& frame, Index face, const Way& way_to_end, End_search& search) const
  {
    const Point &q = way_to_end.last, &before = way_to_end.before;
    typedef typename Interval_filter<FT>::Bound Bound;
    const Bound limit = Interval_filter<FT>::upper_bound(estimate(search.nearest));
    const FT allowance = Number_policy<FT>::rounding(reach_roundings) * frame.longest_edge();
    // Calls f(source reference, foot, distance of the foot from q, true if the path arrives on this side, true if the rays
    // reach p).
    const auto for_each_candidate = [&](const auto& f) {
      const auto consider = [&](Source_ref source_ref, const Face_window<FT>* window) {
        const Source_place<FT>& place = m_initial.places[source_ref.primitive()];
        if ((search.only_known_source && source_of(source_ref) != source_of(search.known)) ||
            m_field.start_values.of(source_ref) != m_field.start_values.of(search.known) || !is_in_face(place.first, face) ||
            !is_in_face(place.second, face))
          return;
        const Foot foot = foot_in(face, frame, way_to_end, source_ref.primitive());
        const Point way = foot.position - way_to_end.start, miss = foot.position - q;
        if (CGAL::certainly(estimate(dot(way, way)) > CGAL::square(estimate(search.longest)))) return;
        const Bound off = Interval_filter<FT>::upper_bound(CGAL::sqrt(estimate(dot(miss, miss))));
        if (!(off <= limit)) return;
        const bool is_on_its_side =
          source_ref.side() == Source_side::LEFT ? foot.is_left
          : source_ref.side() == Source_side::RIGHT
            ? foot.is_right
            : true;
        const bool reaches =
          window ? may_reach(*window, before, allowance) : is_on_its_side && (foot.is_beside || !source_ref.is_lateral());
        f(source_ref, foot.point, off, is_on_its_side, reaches);
      };
      const auto local = local_windows(m_initial, face);
      for (auto i = local.first; i != local.second; ++i) consider(i->window.source_ref, &i->window);
      for (Index h = 3 * face; h < 3 * face + 3; ++h)
        m_initial.for_each_edge_window(h, [&](const auto& w) { consider(w.source_ref, nullptr); });
    };
    Bound least = limit;
    for_each_candidate([&](Source_ref, const Surface_point_&, const Bound& off, bool, bool) {
      least = (std::min)(least, off);
    });
    const Bound tied = least + Interval_filter<FT>::upper_bound(estimate(allowance));
    for_each_candidate([&](Source_ref source_ref, const Surface_point_& point, const Bound& off, bool is_on_its_side,
                           bool reaches) {
      const int preference =
        (reaches ? CONE_HAS_START : 0) + (is_on_its_side ? SIDE_OF_ARRIVAL : 0) +
        (source_of(source_ref) == source_of(search.known) ? KNOWN_SOURCE : 0) +
        (source_ref.side() == search.known.side() ? KNOWN_SIDE : 0) +
        (source_ref.primitive() == search.known.primitive() ? KNOWN_PRIMITIVE : 0) +
        (!reaches && !m_initial.primitives[source_ref.primitive()].is_segment ? IS_POINT : 0);
      if (!(off <= tied) || preference <= search.preference) return;
      search.preference = preference;
      search.end = {point, source_ref};
    });
  }

  // True if the cone of a window contains p, up to the allowance. With exact numbers, estimates decide, and the undecided case
  // counts as true.
  static bool may_reach(const Face_window<FT>& w, const Point& p, const FT& allowance)
  {
    if constexpr (Interval_filter<FT>::leaves_open)
      return CGAL::possibly(estimate(w.left_side(p)) <= 0) && CGAL::possibly(estimate(w.right_side(p)) >= 0) &&
             (!w.is_parallel() || CGAL::possibly(estimate(w.distance_at(p)) >= estimate(w.start_value)));
    else return w.contains(p, allowance);
  }

  Index source_of(Source_ref source_ref) const { return m_initial.source_of[source_ref.primitive()]; }

  // True for a point source at a vertex, and for a segment with an end there.
  bool is_at_vertex(Source_ref source_ref, Index v) const
  {
    const Source_place<FT>& place = m_initial.places[source_ref.primitive()];
    const auto is_there = [v](const Surface_point_& p) { return p.kind == Surface_point_::VERTEX && p.element == v; };
    return is_there(place.first) || is_there(place.second);
  }

  bool is_in_face(const Surface_point_& p, Index face) const
  {
    if (p.kind == Surface_point_::FACE) return p.element == face;
    if (p.kind == Surface_point_::EDGE)
      return m_mesh.face(p.element) == face ||
             (m_mesh.twin(p.element) != no_index && m_mesh.face(m_mesh.twin(p.element)) == face);
    return has_corner(face, p.element);
  }

  bool has_corner(Index face, Index v) const
  {
    const Index h = 3 * face;
    return m_mesh.source(h) == v || m_mesh.source(h + 1) == v || m_mesh.source(h + 2) == v;
  }

  // Foot of the path on a part of a source: the point of the part nearest to p, the first point of a segment of the path. The
  // foot on a short source segment has a large error, as the direction of the segment has the error of its ends divided by its
  // length. Within this error, the foot is the point nearest to q, the last point of the segment of the path.
  struct Foot
  {
    Surface_point_ point;
    Point position;
    bool is_left = true, is_right = true; // true if the path may arrive on this side, seen along the segment
    bool is_beside = true;                // true if p may lie between the normals at the ends of the segment
  };

  Foot foot_in(Index face, const Face_frame<FT>& frame, const Way& way, Index primitive) const
  {
    const Point &p = way.first, &q = way.last;
    const Source_place<FT>& place = m_initial.places[primitive];
    Foot foot;
    Point b;
    unsigned edges_of_a, edges_of_b;
    position_in_face(m_mesh, place.first, face, foot.position, edges_of_a);
    foot.point = place.first;
    if (!m_initial.primitives[primitive].is_segment) return foot;
    position_in_face(m_mesh, place.second, face, b, edges_of_b);
    const Point a = foot.position, u = b - a;
    const auto side = estimate(cross(u, way.before - a));
    foot.is_left = CGAL::possibly(side >= 0);
    foot.is_right = CGAL::possibly(side <= 0);
    FT along = dot(p - a, u), slack(0);
    const FT square = dot(u, u);
    if constexpr (Number_policy<FT>::is_inexact)
    {
      const FT rounding = Number_policy<FT>::rounding(8) * frame.longest_edge(), size = length(u);
      const FT uncertainty = rounding * (length(p - a) + FT(8) * size); // of `along`
      slack = uncertainty;
      along += (std::max)(FT(-uncertainty), (std::min)(uncertainty, FT(dot(q - a, u) - along)));
    }
    foot.is_beside = CGAL::possibly(estimate(along) >= estimate(FT(-slack))) &&
                     CGAL::possibly(estimate(along) <= estimate(FT(square + slack)));
    if (!CGAL::is_positive(along)) return foot;
    const FT t = along / square;
    if (!(t < FT(1)))
    {
      foot.point = place.second;
      foot.position = b;
      return foot;
    }
    foot.position = a + t * u;
    if (const unsigned edge = edges_of_a & edges_of_b)
    {
      const int k = edge_of_bit(edge);
      foot.point = Surface_point_::on_edge(3 * face + Index(k), frame.along(k, foot.position));
    }
    else foot.point = Surface_point_::in_face(face, foot.position);
    return foot;
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Initial_windows<FT>& m_initial;
  const Geodesic_field<FT>& m_field;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
