// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 2 of the pipeline: the windows that start at sources. They are windows inside faces, windows on source edges, fans of
// rays from vertices, and first distances of vertices. Segment_seeding selects their directions.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_INITIAL_WINDOWS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_INITIAL_WINDOWS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Face_window.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Start_values.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Vertex_sector.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// A point or segment of a source.
struct Source_primitive
{
  Index source; // id of the source
  Index part;   // number of the point, or of the segment, within the source
  bool is_segment;
  bool is_short = false; // a segment so short that paths to both ends may be one path up to rounding, or an end of it
  bool varies = false;   // a segment along which the start value varies
};

// Position of a primitive: the segment from `first` to `second` in a common face; a point is `first` alone.
template <class FT>
struct Source_place
{
  Surface_point<FT> first, second;
};

template <class FT>
class Initial_windows
{
public:
  typedef Surface_point<FT> Surface_point_;
  typedef Point_in_face<FT> Point;
  typedef Ray_at_vertex<FT> Ray;

  struct Local_window
  {
    Index face;
    Face_window<FT> window;
  };
  struct Edge_window // interval of an edge that is source
  {
    Index halfedge;
    FT b0, b1;
    Source_ref source_ref;
    FT start, slope = FT(0); // the distance at b0, and its increase along the halfedge
  };
  struct Vertex_fan // rays from a source vertex; see Vertex_sector::for_each_corner()
  {
    Index vertex;
    Ray from, to;
    Index first;
    Source_ref source_ref;
  };
  struct Vertex_seed // first distance of a vertex, and the direction to the source
  {
    Index vertex;
    FT distance;
    Ray back;
    Source_ref source_ref;
  };

  explicit Initial_windows(const Unfolded_mesh<FT>& mesh) : m_mesh(mesh) {}

  // Sets the start value of the sources that are added next.
  void set_start_value(const FT& s) { m_start_value = s; }

  // A point on a barrier is a point on each side.
  void add_point(Index source, const Surface_point_& point)
  {
    for_each_side(m_mesh, point, [&](const Surface_point_& p) {
      add_all_directions({source, 0, false}, p, Source_side::NONE);
    });
  }

  void add_all_directions(const Source_primitive& primitive, const Surface_point_& p, Source_side side)
  {
    const Source_ref source_ref(add_primitive(primitive, {p, p}), side);
    if (p.kind == Surface_point_::VERTEX)
    {
      add_seed_at_source(p.element, source_ref);
      m_mesh.for_each_fan(p.element, [&](Index first) { fans.push_back({p.element, Ray(), Ray(), first, source_ref}); });
    }
    else
    {
      add_seeds_of_point(p, [source_ref](const Point&) { return source_ref; });
      add_flat_sector(p, nullptr, nullptr, source_ref);
    }
  }

  // Call finish() after the last addition: it adds the fans as windows of the faces around their vertices, and sorts local
  // windows by face and edge windows by halfedge.
  void finish()
  {
    for (const Vertex_fan& f : fans)
      Vertex_sector<FT>(m_mesh).for_each_corner(f.from, f.to, f.first, [&](Index h, const Ray* lower, const Ray* upper) {
        add_corner(h, lower, upper, f.source_ref);
      });
    sort_stably(local, [](const Local_window& w) { return w.face; });
    sort_stably(edges, [](const Edge_window& w) { return w.halfedge; });
    remove_overlaps();
  }

  // Calls f(window) for the source intervals of a halfedge. Call finish() first.
  template <class Function>
  void for_each_edge_window(Index h, const Function& f) const
  {
    auto i = std::lower_bound(edges.begin(), edges.end(), h, [](const Edge_window& w, Index g) { return w.halfedge < g; });
    for (; i != edges.end() && i->halfedge == h; ++i) f(*i);
  }

  std::vector<Source_primitive> primitives;
  std::vector<Source_place<FT>> places; // per primitive
  std::vector<Index> source_of;         // per primitive, its source
  Start_values<FT> start_values;        // of the primitives
  std::vector<Local_window> local;
  std::vector<Edge_window> edges;
  std::vector<Vertex_fan> fans;
  std::vector<Vertex_seed> seeds;

  Index add_primitive(const Source_primitive& primitive, const Source_place<FT>& place)
  {
    primitives.push_back(primitive);
    places.push_back(place);
    source_of.push_back(primitive.source);
    start_values.push_back(m_start_value);
    CGAL_postcondition(primitives.size() == places.size() && primitives.size() == source_of.size());
    return Index(primitives.size() - 1);
  }

  // Adds the rays from a segment inside a face to the side of the unit normal n. `left` and `right` are seen along the rays.
  void add_strip(Index face, const Point& left, const Point& right, const Point& n, Source_ref source_ref)
  {
    local.push_back({face, Face_window<FT>{-n.x, -n.y, m_start_value - dot(n, left), left, right, source_ref,
                                           Window<FT>::make_bits(true, no_index), STARTS_IN_FACE, 3, m_start_value}});
  }

  void add_edge_windows(Index h, const FT& b0, const FT& b1, Source_ref on_left, Source_ref on_right)
  {
    add_edge_windows(h, b0, b1, on_left, on_right, m_start_value, m_start_value);
  }

  // With start values that vary linearly from s0 at b0 to s1 at b1. Rays leave the edge at the angle whose cosine is the slope.
  void add_edge_windows(Index h, const FT& b0, const FT& b1, Source_ref on_left, Source_ref on_right, const FT& s0,
                        const FT& s1)
  {
    CGAL_precondition(b0 <= b1);
    const FT slope = s0 == s1 ? FT(0) : FT((s1 - s0) / (b1 - b0));
    edges.push_back({h, b0, b1, on_left, s0, slope});
    if (m_mesh.twin(h) != no_index)
      edges.push_back({m_mesh.twin(h), m_mesh[h].length - b1, m_mesh[h].length - b0, on_right, s1, FT(-slope)});
  }

  // First distance of a source vertex.
  void add_seed_at_source(Index v, Source_ref source_ref) { seeds.push_back({v, m_start_value, Ray(), source_ref}); }

  // `distance`: from the source.
  void seed_corner(Index face, const Face_frame<FT>& frame, int k, const FT& distance, const Point& back, Source_ref source_ref)
  {
    const Point u = frame.vector_to_halfedge(k, back);
    seeds.push_back({m_mesh.source(3 * face + Index(k)), m_start_value + distance, Ray{3 * face + Index(k), u.x, u.y},
                     source_ref});
  }

  // Adds the rays from a point inside a face or an edge. The sector, at most a half turn, reaches counterclockwise from `from`
  // to `to`, in the frame of the point's face or halfedge. Null pointers mean all directions.
  void add_flat_sector(const Surface_point_& p, const Point* from, const Point* to, Source_ref source_ref)
  {
    if (p.kind == Surface_point_::FACE)
    {
      const Face_frame<FT> frame(m_mesh, p.element);
      const int k = edge_of_point(frame, {p.x, p.y});
      if (k == -1) return add_sector_in_face(p, p.element, {p.x, p.y}, from, to, -1, source_ref);
      const Point f = from ? frame.vector_to_halfedge(k, *from) : Point(), t = to ? frame.vector_to_halfedge(k, *to) : Point();
      return add_flat_sector(at_edge(p, frame, k), from ? &f : nullptr, to ? &t : nullptr, source_ref);
    }
    for (const Index h : {p.element, m_mesh.twin(p.element)})
    {
      if (h == no_index) continue;
      const int k = int(h % 3);
      const Face_frame<FT> frame(m_mesh, m_mesh.face(h));
      const bool turned = h != p.element;
      const Point position = frame.on_edge(k, turned ? FT(m_mesh[h].length - p.x) : p.x);
      Point f, t;
      if (from) f = frame.vector_from_halfedge(k, turned ? FT(-1) * *from : *from);
      if (to) t = frame.vector_from_halfedge(k, turned ? FT(-1) * *to : *to);
      add_sector_in_face(p, m_mesh.face(h), position, from ? &f : nullptr, to ? &t : nullptr, k, source_ref);
    }
  }

  // Uncertainty of the direction of a segment of the given length, an angle, from the rounding of its ends in a face. Zero if
  // not significant().
  FT direction_uncertainty(Index face, const FT& segment) const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return FT(0);
    else return direction_uncertainty(Face_frame<FT>(m_mesh, face).longest_edge(), segment);
  }

  // Adds seeds at the corners of the faces of a point inside a face or an edge. source_ref_of(v): source reference for a corner
  // at v, relative to p, in the frame of the point's face or halfedge.
  template <class Function>
  void add_seeds_of_point(const Surface_point_& p, const Function& source_ref_of)
  {
    if (p.kind == Surface_point_::FACE)
    {
      const Face_frame<FT> frame(m_mesh, p.element);
      if (const int k = edge_of_point(frame, {p.x, p.y}); k != -1)
        return add_seeds(at_edge(p, frame, k), [&](const Point& v) { return source_ref_of(frame.vector_from_halfedge(k, v)); });
    }
    add_seeds(p, source_ref_of);
  }

private:
  template <class Function>
  void add_seeds(const Surface_point_& p, const Function& source_ref_of)
  {
    for (Index f : faces_of(m_mesh, p))
    {
      Point position;
      unsigned edges_of_p;
      position_in_face(m_mesh, p, f, position, edges_of_p);
      const Face_frame<FT> frame(m_mesh, f);
      const Per_corner<Point> to_corner = vectors_to_corners(p, frame, f, position);
      for (int k = 0; k < 3; ++k)
      {
        const Point back = FT(-1) * to_corner[k];
        seed_corner(f, frame, k, length(back), back, source_ref_of(vector_at_point(m_mesh, p, f, to_corner[k])));
      }
    }
  }

  // Sorts by a key; items with the same key keep their order. Sorts numbers: std::stable_sort() compiles to 90 functions per type.
  template <class Item, class Key>
  static void sort_stably(std::vector<Item>& items, const Key& key)
  {
    std::vector<std::pair<Index, Index>> order;
    for (const Item& i : items) order.emplace_back(key(i), Index(order.size()));
    std::sort(order.begin(), order.end());
    std::vector<Item> sorted;
    sorted.reserve(items.size());
    for (const auto& o : order) sorted.push_back(items[o.second]);
    items.swap(sorted);
  }

  // Where sources with the same start value overlap along an edge, only that with the smallest id keeps its window, on both
  // sides of the edge: ties of windows in one face and in the other could be decided differently.
  void remove_overlaps()
  {
    std::vector<Edge_window> kept;
    std::map<std::pair<FT, FT>, FT> covered; // ends of the kept intervals of a halfedge, by start value and begin
    for (const Edge_window& e : edges)
    {
      if (kept.empty() || kept.back().halfedge != e.halfedge) covered.clear();
      if (!(e.b0 < e.b1) || !CGAL::is_zero(e.slope))
      { // without extent by rounding, or as of no other source
        kept.push_back(e);
        continue;
      }
      const FT start = start_values.of(e.source_ref);
      auto next = covered.upper_bound({start, e.b0});
      FT at = e.b0;
      if (next != covered.begin())
        if (const auto before = std::prev(next); before->first.first == start) at = (std::max)(at, before->second);
      while (at < e.b1)
      {
        const bool is_last = next == covered.end() || next->first.first != start || !(next->first.second < e.b1);
        const FT end = is_last ? e.b1 : next->first.second;
        if (at < end)
        {
          kept.push_back({e.halfedge, at, end, e.source_ref, start});
          covered.emplace_hint(next, std::make_pair(start, at), end);
        }
        at = is_last ? end : (next++)->second;
      }
    }
    edges.swap(kept);
  }

  // The vectors from a point to the corners of a face. A point of an edge may be so near to its end that only the direction of the
  // edge determines that of the vector.
  Per_corner<Point> vectors_to_corners(const Surface_point_& point, const Face_frame<FT>& frame, Index face,
                                       const Point& p) const
  {
    Per_corner<Point> result = {frame.corner(0) - p, frame.corner(1) - p, frame.corner(2) - p};
    if (point.kind != Surface_point_::EDGE) return result;
    const bool turned = m_mesh.face(point.element) != face;
    const Index h = turned ? m_mesh.twin(point.element) : point.element;
    const int k = int(h % 3);
    const FT rest = m_mesh[h].length - point.x;
    result[k] = (turned ? FT(-rest) : FT(-point.x)) * frame.direction(k);
    result[(k + 1) % 3] = (turned ? point.x : rest) * frame.direction(k);
    return result;
  }

  // Adds the rays of a sector in a face from a point, p in the frame of the face, inside the face (entry -1) or on its halfedge
  // `entry`, counterclockwise from `from` to `to`; null: in all directions.
  void add_sector_in_face(const Surface_point_& point, Index face, const Point& p, const Point* from, const Point* to,
                          int entry, Source_ref source_ref)
  {
    const Face_frame<FT> frame(m_mesh, face);
    const Per_corner<Point> to_corner = vectors_to_corners(point, frame, face, p);
    for (int k = 0; k < 3; ++k)
    {
      if (k == entry) continue;
      // Seen from p, the right end of the edge is its source.
      const Point source = frame.corner(k), target = frame.corner((k + 1) % 3);
      const Point &to_source = to_corner[k], &to_target = to_corner[(k + 1) % 3];
      if (!CGAL::is_positive(cross(to_source, to_target))) continue;
      const auto is_between = [](const Point& first, const Point& u, const Point& last) {
        return !CGAL::is_negative(cross(first, u)) && !CGAL::is_negative(cross(u, last));
      };
      // The common rays of the sector and of the corner at p over the edge.
      const bool from_is_inside = from && is_between(to_source, *from, to_target);
      const bool to_is_inside = to && is_between(to_source, *to, to_target);
      if ((from && !(from_is_inside || is_between(*from, to_source, *to))) ||
          (to && !(to_is_inside || is_between(*from, to_target, *to))))
        continue;
      const Point &right_ray = from_is_inside ? *from : to_source, &left_ray = to_is_inside ? *to : to_target;
      // With p on the edge, the corner is a half turn up to rounding.
      if (!CGAL::is_positive(cross(right_ray, left_ray)) && !CGAL::is_negative(dot(right_ray, left_ray))) continue;
      const auto crossing = [&](const Point& u) {
        const FT r = CGAL::abs(cross(u, to_source)), l = CGAL::abs(cross(u, to_target));
        return CGAL::is_zero(FT(r + l)) ? source : Point(source + (r / (r + l)) * (target - source));
      };
      Point left = to_is_inside ? crossing(*to) : target;
      const Point right = from_is_inside ? crossing(*from) : source;
      // A cone that is narrower on the edge than rounding is empty for points of the face, but not for the faces beyond.
      if (dot(left - right, frame.direction(k)) <= Number_policy<FT>::rounding(roundings_of_interval) * frame.edge_length(k))
        left = right;
      local.push_back({face,
                       Face_window<FT>{p.x, p.y, m_start_value, left, right, source_ref, Window<FT>::make_bits(false, no_index),
                                       STARTS_IN_FACE, (unsigned char)(k), m_start_value, right_ray, left_ray}});
    }
  }

  // Number of the edge on which p lies up to rounding, the nearest one, or -1. The directions from p to its ends are those of the
  // edge: those of rounded coordinates may point out of the face.
  static int edge_of_point(const Face_frame<FT>& frame, const Point& p)
  {
    int result = -1;
    if constexpr (Number_policy<FT>::is_inexact)
    {
      FT least = Number_policy<FT>::rounding(roundings_of_height) * frame.longest_edge();
      for (int k = 0; k < 3; ++k)
        if (const FT height = frame.height(k, p); height <= least)
        {
          result = k;
          least = height;
        }
    }
    return result;
  }

  // Units of rounding of an edge that an interval on it is wider than if points of the face can be in its cone: as for rays that
  // have crossed many faces (roundings_of_ray).
  static constexpr double roundings_of_interval = 64;

  // Rounding error of the height of a point over an edge, in units of rounding of the longest edge: one for the point, and one for
  // each of the two terms of the height.
  static constexpr double roundings_of_height = 3;

  static Surface_point_ at_edge(const Surface_point_& p, const Face_frame<FT>& frame, int k)
  {
    const FT t = frame.along(k, {p.x, p.y});
    return Surface_point_::on_edge(3 * p.element + Index(k), (std::max)(FT(0), (std::min)(t, frame.edge_length(k))));
  }

  // Overload for the longest edge of the face.
  static FT direction_uncertainty(const FT& longest_edge, const FT& segment)
  {
    return significant(Number_policy<FT>::rounding(128) * longest_edge, segment);
  }

  // Angle of an arc of the given length at a distance, at most 1. Zero up to 2^-30: a path that bends by this angle is longer
  // by 2^-63 of its length.
  static FT significant(const FT& arc, const FT& distance)
  {
    const FT angle = distance > arc ? FT(arc / distance) : FT(1);
    return angle > FT(1. / (1 << 30)) ? angle : FT(0);
  }

  // Adds the rays of a fan in the face of h, from the source of h, counterclockwise from `lower` to `upper`.
  void add_corner(Index h, const Ray* lower, const Ray* upper, Source_ref source_ref)
  {
    const Vertex_sector<FT> sector(m_mesh);
    const int k = int(h % 3), opposite = (k + 1) % 3;
    const FT length = m_mesh[m_mesh.next(h)].length;
    const FT right = lower ? FT(length - sector.exit_of_ray(h, *lower)) : FT(0);
    const FT left = upper ? FT(length - sector.exit_of_ray(h, *upper)) : length;
    if (!(right + Number_policy<FT>::rounding(roundings_of_interval) * length < left)) return;
    const Face_frame<FT> frame(m_mesh, m_mesh.face(h));
    const Point& c = frame.corner(k);
    const FT& s = start_values.of(source_ref);
    local.push_back({m_mesh.face(h),
                     Face_window<FT>{c.x, c.y, s, frame.on_edge(opposite, left), frame.on_edge(opposite, right), source_ref,
                                     Window<FT>::make_bits(false, no_index), STARTS_AT_CORNER, (unsigned char)(k), s}});
  }

  const Unfolded_mesh<FT>& m_mesh;
  FT m_start_value = FT(0);
};

} // namespace CGAL::Geodesic_offset::internal

#endif
