// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Initial windows of the sources: from every point in all directions, and from every segment to both sides.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_SOURCES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_SOURCES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_window.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Rotation.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Initial_windows.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Source in a closed face: a point, or a segment from `first` to `second`, in the face frame and in units of the certified
// mesh. The rounded position counts as exact; `moved` is an upper bound of its distance from the given position.
struct Certified_source
{
  Index face;
  Double_double_2 first, second;
  bool is_segment;
  int on_edge; // halfedge that contains the source, or -1
  double moved;
  double start_value;

  // Vector from p to the nearest point of the source, with an error of `length_error` times the sum of its length and, for
  // a segment, the distances of p from both ends. `reach`: the distance of p from `first`, plus that from `second` for a
  // segment.
  Point_in_face<double> way_from(const Double_double_2& p, double& reach) const
  {
    const Point_in_face<double> a = difference(p, first);
    reach = length(a);
    if (!is_segment) return a;
    const Point_in_face<double> b = difference(p, second), u = difference(first, second);
    reach += length(b);
    const double t = -dot(u, a) / dot(u, u);
    return t <= 0 ? a : t >= 1 ? b : a + t * u;
  }

private:
  static Point_in_face<double> difference(const Double_double_2& p, const Double_double_2& q)
  {
    return {(q.x - p.x).high, (q.y - p.y).high};
  }
};

struct Certified_source_vertex
{
  Index vertex;
  double start_value; // the smallest one of its sources
};

class Certified_sources
{
public:
  typedef Point_in_face<double> Point;
  typedef Surface_point<double> Surface_point_;

  Certified_sources(const Certified_mesh& mesh, const Initial_windows<double>& initial) : m_mesh(mesh)
  {
    for (std::size_t i = 0; i < initial.primitives.size(); ++i)
    {
      const auto& place = initial.places[i];
      if (initial.primitives[i].varies)
        throw std::invalid_argument(
          "Surface_mesh_geodesic_enclosure: there are no bounds for start values that vary along a segment");
      const double s = m_mesh.to_unit(initial.start_values.of(Source_ref(Index(i), Source_side::NONE)));
      if (!Number_policy<double>::is_finite(s))
        throw std::runtime_error("Surface_mesh_geodesic_enclosure: a start value divided by the longest edge is not finite");
      least_start_value = (std::min)(least_start_value, s);
      add_point(place.first, s);
      if (!initial.primitives[i].is_segment) continue;
      add_point(place.second, s);
      add_segment(place.first, place.second, s);
    }
    typedef Certified_source_vertex Vertex;
    std::sort(vertices.begin(), vertices.end(), [](const Vertex& a, const Vertex& b) {
      return a.vertex < b.vertex || (a.vertex == b.vertex && a.start_value < b.start_value);
    });
    const auto is_same = [](const Vertex& a, const Vertex& b) { return a.vertex == b.vertex; };
    vertices.erase(std::unique(vertices.begin(), vertices.end(), is_same), vertices.end());
    std::stable_sort(in_faces.begin(), in_faces.end(),
                     [](const Certified_source& a, const Certified_source& b) { return a.face < b.face; });
    find_loss();
  }

  // Computes the position of a point in the face frame, moved back into the closed face if rounding placed it outside.
  // Returns false if the point is not in the face. `edges` as in position_in_face().
  bool place_in_face(const Surface_point_& p, Index face, Double_double_2& place, unsigned& edges) const
  {
    Point position;
    if (!position_in_face(m_mesh.unfolded(), p, face, position, edges)) return false;
    const int k = p.kind == Surface_point_::EDGE ? edge_of_bit(edges) : -1;
    if (p.kind == Surface_point_::VERTEX)
      for (int i = 0; i < 3; ++i)
      {
        if (m_mesh.unfolded().source(3 * face + Index(i)) == p.element) place = corner(face, i);
      }
    else if (p.kind == Surface_point_::EDGE)
    {
      const Double_double t = m_mesh.to_unit(p.x);
      place = on_edge(face, k, p.element == 3 * face + Index(k) ? t : m_mesh[p.element].length - t);
    }
    else
    {
      // The nearest point of the closed face. Beside an obtuse corner, the line of another edge may be nearer than the face.
      const Double_double_2 given = {m_mesh.to_unit(position.x), m_mesh.to_unit(position.y)};
      place = given;
      double least = Number_policy<double>::infinity();
      bool is_outside = false;
      for (int i = 0; i < 3; ++i)
      {
        const Double_double_2 c = corner(face, i), v = in_frame(direction(face, i), {given.x - c.x, given.y - c.y});
        const Double_double_2 q = on_edge(face, i, v.x);
        is_outside = is_outside || v.y.high < 0;
        const double d = internal::length(Point{(q.x - given.x).high, (q.y - given.y).high});
        if (d >= least) continue;
        least = d;
        place = q;
      }
      if (!is_outside) place = given;
    }
    return true;
  }

  // Source of halfedge k, in the face frame.
  Double_double_2 corner(Index face, int k) const
  {
    if (k == 2) return m_mesh.apex(3 * face);
    return {k == 0 ? Double_double(0.) : m_mesh[3 * face].length, 0.};
  }

  // Direction of halfedge k, in the face frame.
  Double_double_2 direction(Index face, int k) const
  {
    if (k == 0) return {1., 0.};
    const Double_double_2& c = m_mesh[k == 1 ? 3 * face + 1 : 3 * face].corner;
    return {-c.x, k == 1 ? c.y : -c.y};
  }

  std::vector<Certified_source_vertex> vertices; // by their indices
  std::vector<Certified_source> in_faces;        // sorted by face
  double least_start_value = Number_policy<double>::infinity();
  // By which a distance may be shorter than all windows and vertices tell: see loss_beside_vertex(), and by half the longest
  // segment that has no windows.
  double loss = 0;

  // Calls f(source) for the sources in a face.
  template <class Function>
  void for_each_in_face(Index face, const Function& f) const
  {
    auto i = std::lower_bound(in_faces.begin(), in_faces.end(), face, [](const Certified_source& s, Index number) {
      return s.face < number;
    });
    for (; i != in_faces.end() && i->face == face; ++i) f(*i);
  }

  // Calls f(halfedge, window) for the initial windows of a source in the adjacent faces.
  template <class Function>
  void for_each_window(const Certified_source& s, const Function& f) const
  {
    if (s.is_segment && s.on_edge >= 0)
    { // into its own face; the adjacent face has its own copy of the segment
      const Certified_window w = edge_window(s);
      if (w.b0 < w.b1) f(3 * s.face + Index(s.on_edge), w);
      return;
    }
    for (int k = 0; k < 3; ++k)
    {
      const Index g = m_mesh.unfolded().twin(3 * s.face + Index(k));
      if (g == no_index) continue;
      Certified_window w{};
      w.radius = s.moved;
      w.sigma = s.start_value;
      if (!s.is_segment)
      {
        if (k == s.on_edge) continue;
        w.set_image(beyond_edge(s.face, k, s.first, false));
        // a point that rounding moved onto the edge is displaced inward
        const double inward = -4 * along_edge * (std::abs(w.x) + m_mesh.length(g));
        if (w.y > inward) w.set_image({w.image().x, inward});
        w.set_interval(0., m_mesh.length(g));
        f(g, w);
        continue;
      }
      w.bits = 1u;
      for (const bool to_left : {true, false})
        if (strip_window(s, k, g, to_left, w)) f(g, w);
    }
  }

private:
  void find_loss()
  {
    double beside = m_mesh.loss_beside_vertices();
    for (const Certified_source& s : in_faces)
      for (int k = 0; k < 3 && !s.is_segment; ++k)
      {
        const Double_double_2 c = corner(s.face, k);
        beside =
          (std::max)(beside, loss_beside_vertex(internal::length(Point{(s.first.x - c.x).high, (s.first.y - c.y).high})));
      }
    loss += beside;
  }

  double moved_in(Index face) const
  {
    return length_error * (m_mesh.length(3 * face) + m_mesh.length(3 * face + 1) + m_mesh.length(3 * face + 2));
  }

  Double_double_2 on_edge(Index face, int k, Double_double t) const
  {
    const Double_double& length = m_mesh[3 * face + Index(k)].length;
    if (t.high < 0) t = 0.;
    if ((length - t).high < 0) t = length;
    const Double_double_2 c = corner(face, k), d = direction(face, k);
    return {c.x + t * d.x, c.y + t * d.y};
  }

  void add_point(const Surface_point_& p, double start_value)
  {
    if (p.kind == Surface_point_::VERTEX)
    {
      vertices.push_back({p.element, start_value});
      return;
    }
    for (Index face : faces_of(m_mesh.unfolded(), p))
    {
      Double_double_2 place;
      unsigned edges;
      place_in_face(p, face, place, edges);
      in_faces.push_back({face, place, place, false, edges ? edge_of_bit(edges) : -1, moved_in(face), start_value});
    }
  }

  void add_segment(const Surface_point_& p, const Surface_point_& q, double start_value)
  {
    if (p.kind == Surface_point_::VERTEX && q.kind == Surface_point_::VERTEX && p.element == q.element)
      return; // a repeated point
    for (Index face : faces_of(m_mesh.unfolded(), p))
    {
      Double_double_2 a, b;
      unsigned ea, eb;
      if (!place_in_face(p, face, a, ea) || !place_in_face(q, face, b, eb)) continue;
      const Certified_source s{face, a, b, true, (ea & eb) ? edge_of_bit(ea & eb) : -1, moved_in(face), start_value};
      const Double_double x = b.x - a.x, y = b.y - a.y;
      const double size = std::abs(x.high) + std::abs(y.high);
      if (size > s.moved) in_faces.push_back(s);
      else loss = (std::max)(loss, size);
    }
  }

  // Transforms a point or a direction from the face frame to the frame of the twin of halfedge k.
  Double_double_2 beyond_edge(Index face, int k, Double_double_2 p, bool is_direction) const
  {
    const Index h = 3 * face;
    for (int i = 0; i < k; ++i)
    { // to the frame of the next halfedge
      if (!is_direction) p.x = p.x - m_mesh[h + Index(i)].length;
      const Double_double_2& c = m_mesh[h + Index(i + 1)].corner;
      p = in_frame({-c.x, c.y}, p);
    }
    if (!is_direction) p.x = m_mesh[h + Index(k)].length - p.x;
    else p.x = -p.x;
    p.y = -p.y;
    return p;
  }

  // Window of the rays from one side of a segment, orthogonal to it, through halfedge k of its face.
  bool strip_window(const Certified_source& s, int k, Index g, bool to_left, Certified_window& w) const
  {
    Double_double_2 along{s.second.x - s.first.x, s.second.y - s.first.y};
    const Double_double size = square_root(along.x * along.x + along.y * along.y);
    along = {along.x / size, along.y / size};
    // the rays have direction n; the image is in the opposite direction
    const Double_double_2 n = to_left ? Double_double_2{-along.y, along.x} : Double_double_2{along.y, -along.x};
    w.set_image(beyond_edge(s.face, k, {-n.x, -n.y}, true));
    if (w.y >= -along_edge) return false;
    const Double_double_2 a = beyond_edge(s.face, k, s.first, false);
    const Double_double_2 axis = beyond_edge(s.face, k, along, true);
    const Double_double to_origin = w.image().x * a.x + w.image().y * a.y; // length of the ray to the origin
    const Double_double sigma = to_origin + s.start_value;
    w.sigma = sigma.high;
    w.sigma_low = sigma.low;
    // part of the edge in front of the segment, between the rays from both ends
    const double length = m_mesh.length(g), allowance = 4 * s.moved;
    double from = 0, to = length;
    const auto clip = [&](double at_0, double at_length) {
      if (at_0 <= 0 && at_length <= 0) return false;
      const double t = at_0 / (at_0 - at_length) * length;
      if (at_0 < 0) from = (std::max)(from, t);
      if (at_length < 0) to = (std::min)(to, t);
      return true;
    };
    const double ex = axis.x.high, ey = axis.y.high;
    const double first_0 = -(ex * a.x.high + ey * a.y.high), first_1 = first_0 + ex * length;
    if (!clip(first_0 + allowance, first_1 + allowance)) return false;
    if (!clip(size.high - first_0 + allowance, size.high - first_1 + allowance)) return false;
    // without the start value, whose rounding may be larger than the face
    if (!clip(to_origin.high + allowance, to_origin.high - w.x * length + allowance)) return false;
    const double rounding = length_error * length;
    from = (std::max)(0., from - rounding);
    to = (std::min)(length, to + rounding);
    if (!(from < to)) return false;
    w.set_interval(from, to);
    w.radius = s.moved + 4 * (allowance + rounding);
    return true;
  }

  Certified_window edge_window(const Certified_source& s) const
  {
    const double length = m_mesh.length(3 * s.face + Index(s.on_edge));
    const double a = length - beyond_edge(s.face, s.on_edge, s.first, false).x.high;
    const double b = length - beyond_edge(s.face, s.on_edge, s.second, false).x.high;
    Certified_window w{};
    w.bits = 1u;
    w.y = -1;
    w.sigma = s.start_value;
    w.radius = 4 * s.moved;
    w.set_interval((std::max)(0., (std::min)(a, b) - s.moved), (std::min)(length, (std::max)(a, b) + s.moved));
    return w;
  }

  const Certified_mesh& m_mesh;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
