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

  void add_point(Index source, const Surface_point_& p)
  {
    const Source_ref source_ref(add_primitive({source, 0, false}, {p, p}), Source_side::NONE);
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
  std::vector<Local_window> beyond_edges; // rays that start in the face beyond an edge next to their image; for the front only
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
    CGAL_precondition(b0 <= b1);
    edges.push_back({h, b0, b1, on_left});
    if (m_mesh.twin(h) != no_index) edges.push_back({m_mesh.twin(h), m_mesh[h].length - b1, m_mesh[h].length - b0, on_right});
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
      add_sector_in_face(Sector(p.element, {p.x, p.y}, from, to, -1), source_ref, local);
      return add_sectors_beyond(source_ref);
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
      add_sector_in_face(Sector(m_mesh.face(h), position, from ? &f : nullptr, to ? &t : nullptr, k), source_ref, local);
    }
    add_sectors_beyond(source_ref);
  }

  // Uncertainty of the direction of a segment of the given length, an angle, from the rounding of its ends in a face. Zero if
  // not significant().
  FT direction_uncertainty(Index face, const FT& segment) const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return FT(0);
    else return direction_uncertainty(Face_frame<FT>(m_mesh, face).longest_edge(), segment);
  }

  // Rounding error of the height of a point of a face over an edge: half a unit of the longest edge for the product, and for the
  // sum, of a coordinate. A point inside the face that is nearer to an edge may seem to lie on or behind it.
  static FT rounding_of_height(const Face_frame<FT>& frame) { return Number_policy<FT>::rounding(1) * frame.longest_edge(); }

  // Adds seeds at the corners of the faces of a point inside a face or an edge. source_ref_of(v): source reference for a corner
  // at v, relative to p, in the frame of the point's face or halfedge.
  template <class Function>
  void add_seeds_of_point(const Surface_point_& p, const Function& source_ref_of)
  {
    for (Index f : faces_of(m_mesh, p))
    {
      Point position;
      unsigned edges_of_p;
      position_in_face(m_mesh, p, f, position, edges_of_p);
      const Face_frame<FT> frame(m_mesh, f);
      for (int k = 0; k < 3; ++k)
      {
        const Point back = position - frame.corner(k);
        seed_corner(f, frame, k, length(back), back, source_ref_of(vector_at_point(m_mesh, p, f, FT(-1) * back)));
      }
    }
  }

  // For a vertex next to the opposite edge of a face: adds the rays from the source of h in the face of h, counterclockwise from
  // `lower` to `upper` (null: the edge of the corner), to `beyond_edges` and `seeds`.
  void add_rays_beyond(Index h, const Ray* lower, const Ray* upper, Source_ref source_ref)
  {
    const int k = int(h % 3);
    const Face_frame<FT> frame(m_mesh, m_mesh.face(h));
    const Point p = frame.corner(k);
    const auto direction = [&](const Ray* r, const Point& end) {
      return r ? frame.vector_from_halfedge(k, Point{r->x, r->y}) : end - p;
    };
    const Point from = direction(lower, frame.corner((k + 1) % 3)), to = direction(upper, frame.corner((k + 2) % 3));
    cross_edge(Sector(m_mesh.face(h), p, &from, &to, k), frame, (k + 1) % 3, source_ref);
    add_sectors_beyond(source_ref);
  }

private:
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
      if (!(e.b0 < e.b1))
      { // without extent by rounding
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
          kept.push_back({e.halfedge, at, end, e.source_ref});
          covered.emplace_hint(next, std::make_pair(start, at), end);
        }
        at = is_last ? end : (next++)->second;
      }
    }
    edges.swap(kept);
  }

  // Rays from a point inside a face (entry -1), on its halfedge `entry`, or behind that halfedge, counterclockwise from `from`
  // to `to`.
  struct Sector
  {
    Index face;
    Point p, from, to;
    bool has_from, has_to; // otherwise in all directions
    int entry;
    Index known;                        // a face that the rays have crossed
    unsigned steps = 0, next_known = 1; // edges crossed; when `known` becomes the face

    Sector(Index face_, const Point& p_, const Point* from_, const Point* to_, int entry_)
      : face(face_), p(p_), from(from_ ? *from_ : p_), to(to_ ? *to_ : p_), has_from(from_), has_to(to_), entry(entry_),
        known(face_)
    {
    }
  };

  // Appends the rays of a sector in a face to `out`.
  //
  // Near the image, the ends of a window on an edge are too coarse for the directions of its bounding rays. So rays that cross
  // an edge near the image start a second time, in the face beyond the edge. A sector narrower on the edge than rounding starts
  // only there.
  void add_sector_in_face(const Sector& sector, Source_ref source_ref, std::vector<Local_window>& out)
  {
    const Index face = sector.face;
    const Point& p = sector.p;
    const Point *const from = sector.has_from ? &sector.from : nullptr, *const to = sector.has_to ? &sector.to : nullptr;
    const int entry = sector.entry;
    const Face_frame<FT> frame(m_mesh, face);
    for (int k = 0; k < 3; ++k)
    {
      if (k == entry || !is_before(frame, k, p)) continue;
      // Seen from p, the right end of the edge is its source.
      const Point source = frame.corner(k), target = frame.corner((k + 1) % 3);
      Point right = source, left = target;
      const bool is_clipped = (!from || clip(p, *from, FT(1), right, left)) && (!to || clip(p, *to, FT(-1), right, left));
      const bool is_narrow =
        !is_clipped || dot(left - right, frame.direction(k)) <= Number_policy<FT>::rounding(64) * frame.edge_length(k);
      // A sector within a half turn is bounded by the ends of the edge that lie inside it.
      const bool from_is_inside = from && CGAL::is_positive(cross(source - p, *from));
      const bool to_is_inside = to && CGAL::is_positive(cross(*to, target - p));
      // A narrow sector at an end of the edge belongs to the next edge, unless that is a border edge.
      const bool is_fan =
        is_narrow && (from_is_inside ? CGAL::is_positive(cross(*from, target - p)) : is_border_edge(face, (k + 2) % 3)) &&
        (to_is_inside ? CGAL::is_positive(cross(source - p, *to)) : is_border_edge(face, (k + 1) % 3));
      // Rounding may reverse the ends of a narrow sector on the edge.
      if (!is_clipped && !(is_fan && from_is_inside && to_is_inside)) continue;
      if (is_fan ||
          loses_rays_beyond(frame, k, p, from_is_inside ? &right : nullptr, to_is_inside ? &left : nullptr, right, left))
      {
        Sector part(sector);
        part.from = from_is_inside ? *from : source - p;
        part.to = to_is_inside ? *to : target - p;
        cross_edge(part, frame, k, source_ref);
      }
      if (is_narrow) continue;
      out.push_back({face,
                     Face_window<FT>{p.x, p.y, m_start_value, left, right, source_ref, Window<FT>::make_bits(false, no_index),
                                     STARTS_IN_FACE, (unsigned char)(k), m_start_value}});
    }
  }

  bool is_border_edge(Index face, int k) const { return m_mesh.twin(3 * face + Index(k)) == no_index; }

  // False if p lies on or behind halfedge k by more than rounding.
  static bool is_before(const Face_frame<FT>& frame, int k, const Point& p)
  {
    const FT height = frame.height(k, p);
    if constexpr (!Number_policy<FT>::is_inexact) return CGAL::is_positive(height);
    else return height > -rounding_of_height(frame);
  }

  // Adds the sector beyond halfedge k of its face to the pending ones, and a seed at the vertex behind the edge if the rays
  // reach it. Rays that come to a face again, as around the tip of a narrow cone, are no shortest paths there: ends them, after
  // one round or two.
  void cross_edge(const Sector& sector, const Face_frame<FT>& frame, int k, Source_ref source_ref)
  {
    const Index g = m_mesh.twin(3 * sector.face + Index(k));
    const Point &from = sector.from, &to = sector.to;
    const bool is_narrow = // not of half a turn, up to rounding
      CGAL::is_positive(dot(from, to)) && !(cross(from, to) > FT(least_angle_of_sector) * (length(from) * length(to)));
    if (g == no_index || is_narrow) return;
    const int entry = int(g % 3);
    const Face_frame<FT> beyond(m_mesh, m_mesh.face(g));
    const auto turned = [&](const Point& u) {
      return beyond.vector_from_halfedge(entry, FT(-1) * frame.vector_to_halfedge(k, u));
    };
    const Point first = turned(from), last = turned(to), image = beyond.from_halfedge(entry, frame.to_twin(k, sector.p));
    Sector next(m_mesh.face(g), image, &first, &last, entry);
    if (next.face == sector.known) return;
    next.known = sector.known;
    next.steps = sector.steps + 1;
    next.next_known = sector.next_known;
    if (next.steps == next.next_known)
    {
      next.known = next.face;
      next.next_known *= 2;
    }
    const int apex = (entry + 2) % 3;
    const Point back = image - beyond.corner(apex);
    if (!CGAL::is_positive(cross(first, back)) && !CGAL::is_negative(cross(last, back)))
      seed_corner(next.face, beyond, apex, length(back), back, source_ref);
    m_sectors.push_back(next);
  }

  void add_sectors_beyond(Source_ref source_ref)
  {
    while (!m_sectors.empty())
    {
      const Sector sector = m_sectors.back();
      m_sectors.pop_back();
      add_sector_in_face(sector, source_ref, beyond_edges);
    }
  }

  // True if rays from p that cross edge k between `right` and `left` must start beyond the edge, since Lower_envelope may not
  // close the gaps that rounding of their directions leaves. `first` and `last`: the crossings of bounding rays, or null.
  static bool loses_rays_beyond(const Face_frame<FT>& frame, int k, const Point& p, const Point* first, const Point* last,
                                const Point& right, const Point& left)
  {
    if constexpr (!Number_policy<FT>::is_inexact) return false;
    const FT r = distance_to_chord(frame, k, p, right, left), size = frame.longest_edge();
    if (direction_uncertainty(size, r) > FT(least_angle_beyond_edges)) return true;
    FT nearest = size;
    for (const Point* const crossing : {first, last})
      if (crossing != nullptr)
        for (const int end : {k, (k + 1) % 3}) nearest = (std::min)(nearest, length(*crossing - frame.corner(end)));
    return r * nearest < FT(grazing_beyond_edges) * size * size;
  }

  // 2^-16 radians. The lower envelope closes the gaps that smaller angles leave on the edges behind, unless rays graze them.
  static constexpr double least_angle_beyond_edges = 1. / (1 << 16);

  // 2^-44. The directions of bounding rays are off by 2 u L / r behind an edge at the distance r from the image. Such a ray may
  // graze an edge at the end of the crossed one, from which it has the distance a at the beginning, at the angle a / L. The gap
  // there is 2 u L^3 / (r a) wide: 2^-8 L, the widest that Lower_envelope closes, for r a = 2^-44 L^2.
  static constexpr double grazing_beyond_edges = 1. / (1ull << 44);

  // 2^-32 radians. Where a polyline bends by less, Lower_envelope closes the gap between its strips, and no rays start between
  // them.
  static constexpr double least_angle_of_sector = 1. / (1ull << 32);

  static FT distance_to_chord(const Face_frame<FT>& frame, int k, const Point& p, const Point& right, const Point& left)
  {
    const FT along = frame.along(k, p), height = frame.height(k, p);
    const FT beyond = (std::max)({FT(frame.along(k, right) - along), FT(along - frame.along(k, left)), FT(0)});
    return square_root<FT>(height * height + beyond * beyond);
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
    if (!(right + Number_policy<FT>::rounding(64) * length < left)) return;
    const Face_frame<FT> frame(m_mesh, m_mesh.face(h));
    const Point& c = frame.corner(k);
    const FT& s = start_values.of(source_ref);
    local.push_back({m_mesh.face(h),
                     Face_window<FT>{c.x, c.y, s, frame.on_edge(opposite, left), frame.on_edge(opposite, right), source_ref,
                                     Window<FT>::make_bits(false, no_index), STARTS_AT_CORNER, (unsigned char)(k), s}});
  }

  // Clips the chord to the side of the line through p with direction u where cross(u, . - p) has the given sign. Returns false
  // if nothing remains.
  static bool clip(const Point& p, const Point& u, const FT& sign, Point& right, Point& left)
  {
    const FT r = sign * cross(u, right - p), l = sign * cross(u, left - p);
    if (!CGAL::is_positive(r) && !CGAL::is_positive(l)) return false;
    if (CGAL::is_negative(r)) right = right + (r / (r - l)) * (left - right);
    if (CGAL::is_negative(l)) left = left + (l / (l - r)) * (right - left);
    return true;
  }

  const Unfolded_mesh<FT>& m_mesh;
  FT m_start_value = FT(0);
  std::vector<Sector> m_sectors; // beyond edges, pending
};

} // namespace CGAL::Geodesic_offset::internal

#endif
