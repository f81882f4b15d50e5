// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 2 of the pipeline: what starts from the sources, as windows inside faces, windows on source edges, fans of rays
// from vertices, and first distances of vertices. See Source_start for where they start.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_INITIAL_WINDOWS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_INITIAL_WINDOWS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Face_window.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Vertex_sector.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// A point or segment of a source.
struct Source_primitive
{
  Index source; // id of the source
  Index part;   // number of the point, or of the segment, within the source
  bool is_segment;
};

// Where it is: from `first` straight to `second`, in a face that both lie in; a point is `first` alone.
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
  struct Edge_window // a part of an edge is source: distance 0 on it
  {
    Index halfedge;
    FT b0, b1;
    Root root;
  };
  struct Vertex_fan // rays from a source vertex, see Vertex_sector::for_each_corner
  {
    Index vertex;
    Ray from, to;
    Index first;
    Root root;
  };
  struct Vertex_seed // a first distance of a vertex, with the direction back to the source
  {
    Index vertex;
    FT distance;
    Ray back;
    Root root;
  };

  explicit Initial_windows(const Unfolded_mesh<FT>& mesh) : m_mesh(mesh) {}

  void add_point(Index source, const Surface_point_& p)
  {
    const Root root(add_primitive({source, 0, false}, {p, p}), Source_side::NONE);
    if (p.kind == Surface_point_::VERTEX)
    {
      seeds.push_back({p.element, FT(0), Ray(), root});
      m_mesh.for_each_fan(p.element, [&](Index first) { fans.push_back({p.element, Ray(), Ray(), first, root}); });
    }
    else
    {
      add_seeds_of_point(p, [root](const Point&) { return root; });
      add_flat_sector(p, nullptr, nullptr, root);
    }
  }

  // Call once everything is added: shows the fans in the faces round their vertices, and orders the local windows by
  // face, those on edges by halfedge.
  void finish()
  {
    for (const Vertex_fan& f : fans)
      Vertex_sector<FT>(m_mesh).for_each_corner(f.from, f.to, f.first, [&](Index h, const Ray* lower, const Ray* upper) {
        add_corner(h, lower, upper, f.root);
      });
    std::stable_sort(local.begin(), local.end(),
                     [](const Local_window& a, const Local_window& b) { return a.face < b.face; });
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Edge_window& a, const Edge_window& b) { return a.halfedge < b.halfedge; });
  }

  // Calls f(window) for the parts of a halfedge that are source. Call finish() first.
  template <class Function>
  void for_each_edge_window(Index h, const Function& f) const
  {
    auto i = std::lower_bound(edges.begin(), edges.end(), h, [](const Edge_window& w, Index g) { return w.halfedge < g; });
    for (; i != edges.end() && i->halfedge == h; ++i) f(*i);
  }

  std::vector<Source_primitive> primitives;
  std::vector<Source_place<FT>> places; // per primitive
  std::vector<Index> source_of;         // per primitive, its source
  std::vector<Local_window> local;
  std::vector<Edge_window> edges;
  std::vector<Vertex_fan> fans;
  std::vector<Vertex_seed> seeds;

  Index add_primitive(const Source_primitive& primitive, const Source_place<FT>& place)
  {
    primitives.push_back(primitive);
    places.push_back(place);
    source_of.push_back(primitive.source);
    CGAL_postcondition(primitives.size() == places.size() && primitives.size() == source_of.size());
    return Index(primitives.size() - 1);
  }

  // The rays from a segment inside a face to one side, with unit normal n; `left` and `right` seen along the rays.
  void add_strip(Index face, const Point& left, const Point& right, const Point& n, Root root)
  {
    local.push_back({face, Face_window<FT>{-n.x, -n.y, -dot(n, left), left, right, root,
                                           Window<FT>::make_bits(true, no_index), STARTS_IN_FACE, 3}});
  }

  void add_edge_windows(Index h, const FT& b0, const FT& b1, Root on_left, Root on_right)
  {
    CGAL_precondition(b0 <= b1);
    edges.push_back({h, b0, b1, on_left});
    if (m_mesh.twin(h) != no_index)
      edges.push_back({m_mesh.twin(h), m_mesh[h].length - b1, m_mesh[h].length - b0, on_right});
  }

  void seed_corner(Index face, const Face_frame<FT>& frame, int k, const FT& distance, const Point& back, Root root)
  {
    const Point u = frame.vector_to_halfedge(k, back);
    seeds.push_back({m_mesh.source(3 * face + Index(k)), distance, Ray{3 * face + Index(k), u.x, u.y}, root});
  }

  // The rays from a point inside a face or an edge. The sector reaches counterclockwise from `from` to `to` (at most
  // a half turn), in the frame of the point's face or halfedge; without them, all directions. `lost`: the angle up to which
  // `from` and `to` are known.
  //
  // Rounding may turn rays from a point beside an edge, too. Then a wider sector closes the gaps beside its bounding rays. The
  // sector itself is narrower, so that what is left of the wider one on an edge is longer than windows that are left out.
  void add_flat_sector(const Surface_point_& p, const Point* from, const Point* to, Root root, const FT& lost = FT(0))
  {
    const FT angle = from && to ? (std::max)(lost, lost_angle(p)) : FT(0);
    if (!CGAL::is_positive(angle)) return add_sector(p, from, to, root, FT(0));
    if (p.kind == Surface_point_::FACE) add_sector_beyond_edges(p, *from, *to, root);
    add_wider_sector(p, *from, *to, angle, root);
    const FT cut = FT(8) * angle;
    if (!(cut < FT(0.5)) || !is_wider(*from, *to, FT(2) * cut)) return;
    const Point first = *from + cut * quarter_turn(*from), last = *to - cut * quarter_turn(*to);
    add_sector(p, &first, &last, root, FT(0));
  }

  // The angle up to which the direction of a segment of the given length is known, from the coordinates of its ends in a face;
  // zero if that is not significant().
  FT lost_angle(Index face, const FT& segment) const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return FT(0);
    else return significant(Number_policy<FT>::rounding(128) * Face_frame<FT>(m_mesh, face).longest_edge(), segment);
  }

  // The rays of a sector from a point inside a face that cross an edge beside the point. They start in the face beyond, where
  // windows on its other edges are as wide as their rays; on the edge itself rounding would turn them.
  void add_sector_beyond_edges(const Surface_point_& p, const Point& from, const Point& to, Root root)
  {
    const Face_frame<FT> frame(m_mesh, p.element);
    const Point position{p.x, p.y};
    for (int k = 0; k < 3; ++k)
    {
      const Index g = m_mesh.twin(3 * p.element + Index(k));
      if (g == no_index || CGAL::is_zero(lost_angle(p.element, frame.height(k, position)))) continue;
      Point right = frame.corner(k), left = frame.corner((k + 1) % 3); // of the edge
      if (!clip(position, from, FT(1), right, left) || !clip(position, to, FT(-1), right, left)) continue;
      const int k_beyond = int(g % 3);
      const Face_frame<FT> beyond(m_mesh, m_mesh.face(g));
      const auto direction = [&](const Point& u, int corner, bool is_bounding) {
        const Point v = is_bounding ? u : frame.corner(corner) - position;
        return beyond.vector_from_halfedge(k_beyond, FT(-1) * frame.vector_to_halfedge(k, v));
      };
      // a sector within a half turn is bounded by the edge's ends where these are inside it
      const bool from_is_inside = CGAL::is_positive(cross(frame.corner(k) - position, from));
      const bool to_is_inside = CGAL::is_positive(cross(to, frame.corner((k + 1) % 3) - position));
      const Point first = direction(from, k, from_is_inside), last = direction(to, (k + 1) % 3, to_is_inside);
      const Point image = beyond.from_halfedge(k_beyond, frame.to_twin(k, position));
      add_sector_in_face(m_mesh.face(g), image, &first, &last, root, FT(0), k_beyond);
    }
  }

  // `sigma`: the distance at p.
  void add_sector(const Surface_point_& p, const Point* from, const Point* to, Root root, const FT& sigma)
  {
    if (p.kind == Surface_point_::FACE) return add_sector_in_face(p.element, {p.x, p.y}, from, to, root, sigma);
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
      add_sector_in_face(m_mesh.face(h), position, from ? &f : nullptr, to ? &t : nullptr, root, sigma, k);
    }
  }

  void add_sector_in_face(Index face, const Point& p, const Point* from, const Point* to, Root root, const FT& sigma,
                          int on_edge = -1)
  {
    const Face_frame<FT> frame(m_mesh, face);
    for (int k = 0; k < 3; ++k)
    {
      if (k == on_edge || !CGAL::is_positive(frame.height(k, p))) continue;
      // seen from p, the right end of the edge is its source
      Point right = frame.corner(k), left = frame.corner((k + 1) % 3);
      if (from && !clip(p, *from, FT(1), right, left)) continue;
      if (to && !clip(p, *to, FT(-1), right, left)) continue;
      // where a polyline goes straight on up to rounding, its strips meet and nothing is between them
      if (dot(left - right, frame.direction(k)) <= Number_policy<FT>::rounding(64) * frame.edge_length(k)) continue;
      local.push_back({face, Face_window<FT>{p.x, p.y, sigma, left, right, root,
                                             Window<FT>::make_bits(false, no_index), STARTS_IN_FACE,
                                             (unsigned char)(k)}});
    }
  }

  // What a point inside a face or an edge tells the corners of its faces. root_of(v): the root for a corner at v, seen from
  // p, in the frame of the point's face or halfedge.
  template <class Function>
  void add_seeds_of_point(const Surface_point_& p, const Function& root_of)
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
        seed_corner(f, frame, k, length(back), back, root_of(vector_at_point(m_mesh, p, f, FT(-1) * back)));
      }
    }
  }

private:
  // The angle by which rounding may turn rays from p where they leave the faces of p. Chords shorter than 64 u L are left out,
  // an angle of 64 u L / r seen from p at distance r. Twice that, since two rays may be turned. Zero above
  // r = least_clear_distance * L.
  FT lost_angle(const Surface_point_& p) const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return FT(0);
    else
    {
      FT result(0);
      for (const Index f : faces_of(m_mesh, p))
      {
        Point position;
        unsigned edges_of_p;
        position_in_face(m_mesh, p, f, position, edges_of_p);
        const Face_frame<FT> frame(m_mesh, f);
        for (int k = 0; k < 3; ++k)
        {
          if (edges_of_p & 1u << k) continue;
          const FT lost = Number_policy<FT>::rounding(128) * frame.longest_edge();
          result = (std::max)(result, significant(lost, frame.height(k, position)));
        }
      }
      return result;
    }
  }

  // The angle of an arc of the given length at a distance, at most 1; zero up to 2^-30: a path that bends by it is longer by
  // 2^-63 of its length.
  static FT significant(const FT& arc, const FT& distance)
  {
    const FT angle = distance > arc ? FT(arc / distance) : FT(1);
    return angle > FT(1. / (1 << 30)) ? angle : FT(0);
  }

  // Whether the sector from one direction counterclockwise to another is wider than an angle below a quarter turn, by its tangent.
  static bool is_wider(const Point& from, const Point& to, const FT& angle)
  {
    const FT c = dot(from, to);
    return !CGAL::is_positive(c) || cross(from, to) > angle * c;
  }

  // The sector, wider by an angle at both ends: rays behind the strips beside it are as long as those of the strips, or
  // longer. Its distances are larger by a rounding, so that it loses against the strips and only closes gaps. In two parts,
  // since it may be more than a half turn.
  void add_wider_sector(const Surface_point_& p, const Point& from, const Point& to, const FT& angle, Root root)
  {
    FT longest(0);
    for (const Index f : faces_of(m_mesh, p)) longest = (std::max)(longest, Face_frame<FT>(m_mesh, f).longest_edge());
    const FT surcharge = FT(4) * Vertex_sector<FT>::margin_surcharge(longest);
    const Point first = (FT(1) / length(from)) * from, last = (FT(1) / length(to)) * to, difference = last - first;
    const Point middle = {first.x + last.x + difference.y, first.y + last.y - difference.x};
    const Point before = {first.x + angle * first.y, first.y - angle * first.x};
    const Point behind = {last.x - angle * last.y, last.y + angle * last.x};
    add_sector(p, &before, &middle, root, surcharge);
    add_sector(p, &middle, &behind, root, surcharge);
  }

  // What a fan sends into one face, at its corner at the source of h; the rays are counterclockwise from `lower` to `upper`.
  void add_corner(Index h, const Ray* lower, const Ray* upper, Root root)
  {
    const Vertex_sector<FT> sector(m_mesh);
    const int k = int(h % 3), opposite = (k + 1) % 3;
    const FT length = m_mesh[m_mesh.next(h)].length;
    const FT right = lower ? FT(length - sector.exit_of_ray(h, *lower)) : FT(0);
    const FT left = upper ? FT(length - sector.exit_of_ray(h, *upper)) : length;
    if (!(right + Number_policy<FT>::rounding(64) * length < left)) return;
    const Face_frame<FT> frame(m_mesh, m_mesh.face(h));
    const Point& c = frame.corner(k);
    local.push_back({m_mesh.face(h), Face_window<FT>{c.x, c.y, FT(0), frame.on_edge(opposite, left),
                                                     frame.on_edge(opposite, right), root,
                                                     Window<FT>::make_bits(false, no_index), STARTS_AT_CORNER,
                                                     (unsigned char)(k)}});
  }

  // Clips the chord to the side of the line through p with direction u where cross(u, . - p) has the given sign.
  static bool clip(const Point& p, const Point& u, const FT& sign, Point& right, Point& left)
  {
    const FT r = sign * cross(u, right - p), l = sign * cross(u, left - p);
    if (!CGAL::is_positive(r) && !CGAL::is_positive(l)) return false;
    if (CGAL::is_negative(r)) right = right + (r / (r - l)) * (left - right);
    if (CGAL::is_negative(l)) left = left + (l / (l - r)) * (right - left);
    return true;
  }

  const Unfolded_mesh<FT>& m_mesh;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
