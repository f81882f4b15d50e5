// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the queries at one point must have in common: distance, nearest source, signed distance, gradient and path describe one
// shortest path. The checker measures the path and its end with its own geometry, in extended precision, and knows the sources as
// they were added; in the plane it also computes the distance from all sources.

#ifndef GEODESIC_OFFSET_TEST_ANSWER_CHECKER_H
#define GEODESIC_OFFSET_TEST_ANSWER_CHECKER_H

#include "geodesic_types.h"
#include "locations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// Kinds of faults. Each query counts once per kind.
enum Answer_fault {
  WRONG_LENGTH,   // the path is not as long as the distance
  WRONG_START,    // the path does not start at the point, or leaves the surface
  WRONG_END,      // the path does not end at the nearest point, or this is not on the part of the source
  REPEATED_POINT, // two consecutive points of a path are equal
  WRONG_SIDE,     // the side is not one of the part, or not where the path arrives
  WRONG_SIGN,     // the sign of the signed distance is not that of the side
  WRONG_GRADIENT, // not a unit vector against the path
  WRONG_DISTANCE, // in the plane
  WRONG_LABEL,    // of a vertex
  WRONG_FORM,     // the forms of the path differ
  NUMBER_OF_ANSWER_FAULTS
};

inline const char* name_of(Answer_fault fault)
{
  static const char* const names[NUMBER_OF_ANSWER_FAULTS] = {"length", "start",    "end",      "repeated", "side",
                                                             "sign",   "gradient", "distance", "label",    "form"};
  return names[fault];
}

class Answer_checker
{
public:
  typedef Geodesic::Face_location Face_location;
  typedef Surface_mesh::Vertex_index Vertex_index;
  typedef Surface_mesh::Face_index Face_index;
  typedef long double Number;
  typedef std::array<Number, 3> Point;

  /// `is_flat`: the mesh is a convex part of the plane z = 0. `is_close`: sources and points may be nearer to vertices and
  /// edges than coordinates tell, and than points in space do: two coordinates of a source of up to 1e-13 are taken for zero,
  /// and consecutive locations of a path may be one point in space.
  Answer_checker(const Surface_mesh& mesh, bool is_flat, bool is_close = false)
    : mesh_(mesh), is_flat_(is_flat), is_close_(is_close), locations_(mesh)
  {
    if (num_vertices(mesh) > 0) origin_ = mesh.point(*vertices(mesh).begin());
    for (Vertex_index v : vertices(mesh))
      for (int i = 0; i < 3; ++i) scale_ = (std::max)(scale_, std::abs(mesh.point(v)[i]));
    for (auto e : edges(mesh))
      longest_edge_ =
        (std::max)(longest_edge_, double(distance(vertex_point(mesh.vertex(e, 0)), vertex_point(mesh.vertex(e, 1)))));
    scale_ = (std::max)(scale_, longest_edge_);
  }

  /// A path is as long as the distance up to this part of the distance. Distances in the plane are right up to this part of the
  /// distance plus the longest edge.
  static constexpr double tolerance = 1e-12;
  /// Nearer than this part of the scale, the rounding of the points of a path exceeds the tolerance. Its length then has in
  /// addition an error of some roundings of the scale, which is the largest coordinate, or the longest edge if it is larger;
  /// and where it passes many edges, of some for each point.
  static constexpr double near_part = 1e-3, near_roundings = 8, roundings_per_point = 0.25, unit_roundoff = 1. / (1ull << 53);

  double longest_edge() const { return longest_edge_; }
  const Locations<Surface_mesh>& locations() const { return locations_; }

  /// The worst errors: of path lengths, relative to the distance; of those of near points, in roundings of the scale; of
  /// distances in the plane, relative to the distance plus the longest edge.
  double worst_length = 0, worst_near_length = 0, worst_distance = 0;
  std::size_t number_of_points = 0;

  /// What is wrong at a point: a bit per Answer_fault.
  unsigned check(const Geodesic& geodesic, const Face_location& query)
  {
    faults_ = 0;
    detail_.clear();
    const double d = geodesic.distance_to_sources(query);
    const auto nearest = geodesic.nearest_source(query);
    const double signed_d = or_nan(geodesic.signed_distance_to_sources(query));
    const Vector_3 gradient = geodesic.gradient(query).value_or(CGAL::NULL_VECTOR);
    std::vector<Face_location> path;
    geodesic.shortest_path_to_sources(query, std::back_inserter(path));
    const auto& sources = geodesic.sources().sources();
    if (is_flat_) check_distance(sources, query, d);
    expect(path.empty() == std::isinf(d) && nearest.has_value() == std::isfinite(d), WRONG_FORM, "reachable");
    if (path.empty() || !nearest) return faults_;
    number_of_points += path.size();
    expect(nearest->distance == d, WRONG_LENGTH, "two distances");
    check_forms(geodesic, query, path);
    check_path(query, path, d);
    check_gradient(gradient, path, d);
    const auto known = sources.find(nearest->source);
    if (known == sources.end()) return expect(false, WRONG_END, "no such source"), faults_;
    expect(distance(point(path.back()), point(nearest->location)) <= 1e-15 * scale_, WRONG_END, "path and nearest point");
    check_part(known->second, *nearest);
    check_side(known->second, *nearest, path);
    check_sign(nearest->side, d, signed_d);
    expect(geodesic.field().nearest_source_and_side(query) == std::make_pair(nearest->source, nearest->side), WRONG_SIDE,
           "two sides");
    return faults_;
  }

  /// At a vertex: also the functions for vertices.
  unsigned check_vertex(const Geodesic& geodesic, Vertex_index v, std::size_t label)
  {
    check(geodesic, locations_.at_vertex(v, 1));
    const auto nearest = geodesic.nearest_source(v);
    expect(label == (nearest ? nearest->source : Geodesic::no_source()), WRONG_LABEL, "label of a vertex");
    return faults_;
  }

  /// Two consecutive points of a polyline that are equal.
  bool repeats_points(const std::vector<Face_location>& polyline, bool is_closed = false) const
  {
    return repeats_points(polyline, is_closed, is_close_);
  }

  /// `may_be_one`: different locations may be one point in space.
  bool repeats_points(const std::vector<Face_location>& polyline, bool is_closed, bool may_be_one) const
  {
    for (std::size_t i = 0; i + (is_closed ? 0 : 1) < polyline.size(); ++i)
      if (is_one_point(polyline[i], polyline[(i + 1) % polyline.size()], may_be_one)) return true;
    return false;
  }

  bool is_connected(const std::vector<Face_location>& polyline) const
  {
    for (std::size_t i = 0; i + 1 < polyline.size(); ++i)
      if (locations_.common_face(polyline[i], polyline[i + 1]) == Surface_mesh::null_face()) return false;
    return true;
  }

  Number length(const std::vector<Face_location>& polyline) const
  {
    Number sum = 0;
    for (std::size_t i = 0; i + 1 < polyline.size(); ++i) sum += distance(point(polyline[i]), point(polyline[i + 1]));
    return sum;
  }

  /// The first fault of the last check.
  const std::string& detail() const { return detail_; }

private:
  void expect(bool condition, Answer_fault fault, const std::string& detail)
  {
    if (condition) return;
    faults_ |= 1u << fault;
    if (detail_.empty()) detail_ = detail;
  }

  static std::string number(double x)
  {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", x);
    return text;
  }

  /// Relative to the first vertex: differences of coordinates are exact, or nearly so, and far from the origin even the digits of
  /// `long double` would not do for the points of locations.
  Point vertex_point(Vertex_index v) const { return from_origin(mesh_.point(v)); }
  Point from_origin(const Point_3& p) const
  {
    return {Number(p.x()) - origin_.x(), Number(p.y()) - origin_.y(), Number(p.z()) - origin_.z()};
  }
  Point point(const Face_location& l) const
  {
    const auto c = locations_.corners(l.first);
    const Number sum = Number(l.second[0]) + l.second[1] + l.second[2];
    Point p{0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) p[i] += l.second[k] / sum * vertex_point(c[k])[i];
    return p;
  }
  Point_3 rounded(const Face_location& l) const { return locations_.point(l); }
  bool is_one_point(const Face_location& l, const Face_location& m, bool may_be_one) const
  {
    return may_be_one ? locations_.support(l) == locations_.support(m) : rounded(l) == rounded(m);
  }

  static Point difference(const Point& p, const Point& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }
  static Number dot(const Point& u, const Point& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
  static Point cross(const Point& u, const Point& v)
  {
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }
  static Number norm(const Point& u) { return std::sqrt(dot(u, u)); }
  static Number distance(const Point& p, const Point& q) { return norm(difference(p, q)); }
  static Number distance_to_segment(const Point& p, const Point& a, const Point& b)
  {
    const Point u = difference(b, a), v = difference(p, a);
    const Number uu = dot(u, u);
    const Number t = uu == 0 ? 0 : (std::min)(Number(1), (std::max)(Number(0), dot(u, v) / uu));
    return distance(v, {t * u[0], t * u[1], t * u[2]});
  }

  void check_distance(const std::map<std::size_t, Source>& sources, const Face_location& query, double d)
  {
    const Point p = point(query);
    Number expected = std::numeric_limits<Number>::infinity();
    for (const auto& entry : sources)
    {
      const Source& s = entry.second;
      if (s.kind == Source_kind::VERTEX) expected = (std::min)(expected, distance(p, vertex_point(s.vertex)));
      if (s.kind == Source_kind::EDGES)
        for (auto e : s.edges)
          expected =
            (std::min)(expected, distance_to_segment(p, vertex_point(mesh_.vertex(e, 0)), vertex_point(mesh_.vertex(e, 1))));
      else
        for (std::size_t i = 0; i < s.locations.size(); ++i)
          expected = (std::min)(
            expected,
            distance_to_segment(p, point(s.locations[i]),
                                point(s.locations[is_closed(s) ? after(s, i) : (std::min)(i + 1, s.locations.size() - 1)])));
    }
    const double error = double(std::abs(d - expected) / (expected + longest_edge_));
    worst_distance = (std::max)(worst_distance, error);
    expect(error <= tolerance, WRONG_DISTANCE, "distance " + number(d) + " instead of " + number(double(expected)));
  }

  void check_forms(const Geodesic& geodesic, const Face_location& query, const std::vector<Face_location>& path)
  {
    std::vector<Point_3> points;
    geodesic.shortest_path_points_to_sources(query, std::back_inserter(points));
    // a path that is shorter than the rounding of coordinates may be one point in space
    const bool may_be_one = is_close_ || double(length(path)) <= near_roundings * unit_roundoff * scale_;
    expect(are_same(points, path, may_be_one), WRONG_FORM, "points and locations");
    for (std::size_t i = 0; i + 1 < points.size(); ++i) expect(points[i] != points[i + 1], REPEATED_POINT, "a point in space");
    expect(!repeats_points(path, false, may_be_one), REPEATED_POINT, "a location");
  }

  // Whether the points are those of the locations, of which some may be one point in space.
  bool are_same(const std::vector<Point_3>& points, const std::vector<Face_location>& path, bool may_be_one) const
  {
    if (points.size() > path.size() || (points.size() < path.size() && !may_be_one)) return false;
    const auto is_at = [&](std::size_t i, std::size_t k) {
      return distance(from_origin(points[i]), point(path[k])) <= near_roundings * unit_roundoff * scale_;
    };
    // whether location k may be point i: the locations are points in order, each point one location or several
    std::vector<char> may_be(points.size(), 0);
    for (std::size_t k = 0; k < path.size(); ++k)
      for (std::size_t i = points.size(); i-- > 0;)
        may_be[i] = (k == 0 ? i == 0 : may_be[i] || (i > 0 && may_be[i - 1])) && is_at(i, k);
    return may_be.back();
  }

  void check_path(const Face_location& query, const std::vector<Face_location>& path, double d)
  {
    // two coordinates of up to 1e-13 are taken for zero
    expect(distance(point(query), point(path.front())) <= 2.1e-13 * longest_edge_, WRONG_START, "start");
    expect(is_connected(path), WRONG_START, "connected");
    for (const Face_location& l : path)
      for (double w : l.second) expect(w >= -1e-13 && w <= 1 + 1e-13, WRONG_START, "coordinates");
    const double l = double(length(path)), error = std::abs(l - d);
    const bool is_near = d < near_part * scale_;
    if (is_near) worst_near_length = (std::max)(worst_near_length, error / (unit_roundoff * scale_));
    else worst_length = (std::max)(worst_length, error / d);
    const double roundings = near_roundings + roundings_per_point * double(path.size());
    expect(error <= tolerance * d + (is_near ? roundings * unit_roundoff * scale_ : 0), WRONG_LENGTH,
           "length " + number(l) + " instead of " + number(d));
  }

  void check_gradient(const Vector_3& gradient, const std::vector<Face_location>& path, double d)
  {
    if (d == 0 || path.size() == 1)
    {
      expect(gradient == CGAL::NULL_VECTOR && (d == 0) == (path.size() == 1), WRONG_GRADIENT, "gradient at a source");
      return;
    }
    expect(std::abs(gradient.squared_length() - 1) <= 1e-12, WRONG_GRADIENT, "gradient " + number(gradient.squared_length()));
    const Point start = difference(point(path[1]), point(path[0]));
    const double l = double(norm(start));
    if (l < 1e-5 * scale_) return;
    const Point sum = {gradient.x() + start[0] / l, gradient.y() + start[1] / l, gradient.z() + start[2] / l};
    // a path that passes a vertex within some 1e-9 of an edge may go by way of it
    expect(norm(sum) <= 1e-9 + 4e-9 * longest_edge_ / l, WRONG_GRADIENT, "gradient off by " + number(double(norm(sum))));
  }

  void check_part(const Source& source, const Geodesic::Nearest_source& nearest)
  {
    const Point p = point(nearest.location);
    // a point on a source up to rounding has distance 0
    const double rounding = is_close_ ? (std::max)(5e-14 * scale_, 2.1e-13 * longest_edge_) : 5e-14 * scale_;
    if (source.kind == Source_kind::VERTEX)
      return expect(!nearest.is_segment && nearest.part == 0 && distance(p, vertex_point(source.vertex)) <= rounding, WRONG_END,
                    "vertex");
    if (source.kind == Source_kind::EDGES)
    {
      if (!nearest.is_segment)
      {
        const bool is_one = nearest.part < num_vertices(mesh_);
        expect(is_one && distance(p, vertex_point(Vertex_index(std::uint32_t(nearest.part)))) <= rounding, WRONG_END,
               "vertex of edges");
        return;
      }
      if (nearest.part >= source.edges.size()) return expect(false, WRONG_END, "no such edge");
      const auto e = source.edges[nearest.part];
      const Number off = distance_to_segment(p, vertex_point(mesh_.vertex(e, 0)), vertex_point(mesh_.vertex(e, 1)));
      expect(off <= rounding, WRONG_END, "off the edge by " + number(double(off)));
      return;
    }
    const std::size_t n = source.locations.size();
    const std::size_t parts = nearest.is_segment ? number_of_segments(source) : n;
    if (nearest.part >= parts) return expect(false, WRONG_END, "no such part");
    const Point a = point(source.locations[nearest.part]);
    const Number off =
      nearest.is_segment ? distance_to_segment(p, a, point(source.locations[after(source, nearest.part)])) : distance(p, a);
    expect(off <= rounding, WRONG_END,
           (nearest.is_segment ? "off the segment by " : "off the point by ") + number(double(off)));
  }

  static bool is_closed(const Source& s) { return s.kind == Source_kind::CLOSED_POLYLINE; }
  static std::size_t number_of_segments(const Source& s) { return s.locations.size() - (is_closed(s) ? 0 : 1); }
  static std::size_t after(const Source& s, std::size_t i) { return (i + 1) % s.locations.size(); }

  enum Extent { IS_POINT, HAS_SIDES, IS_OPEN };

  /// Points inside one face, inside one edge or at one vertex are one point, and have no sides, up to a length of 16 u of the edges
  /// of the face. Between half and twice of it, and beside the limit of coordinates that count as zero, it is open.
  Extent extent(const Source& source) const
  {
    const auto& l = source.locations;
    Number size = 0;
    for (std::size_t i = 0; i < number_of_segments(source); ++i)
    {
      const Face_location &p = l[i], &q = l[after(source, i)];
      const std::vector<Vertex_index> elements[] = {element(p, 0.9e-13), element(p, 1.1e-13), element(q, 0.9e-13),
                                                    element(q, 1.1e-13)};
      if (elements[0] != elements[1] || elements[2] != elements[3]) return IS_OPEN;
      if (elements[0] != elements[2]) return HAS_SIDES;
      if (elements[0].size() > 1) size += distance(point(p), point(q));
    }
    Number least = perimeter(l.front().first), most = least;
    if (const auto e = element(l.front(), 1e-13); e.size() == 2)
    {
      const auto h = mesh_.halfedge(e[0], e[1]);
      for (const Face_index f : {mesh_.face(h), mesh_.face(mesh_.opposite(h))})
        if (f != Surface_mesh::null_face()) least = (std::min)(least, perimeter(f)), most = (std::max)(most, perimeter(f));
    }
    const Number limit = 16 * unit_roundoff;
    return size <= limit * least / 2 ? IS_POINT : size >= limit * most * 2 ? HAS_SIDES : IS_OPEN;
  }

  Number perimeter(Face_index f) const
  {
    const auto c = locations_.corners(f);
    Number sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += distance(vertex_point(c[i]), vertex_point(c[(i + 1) % 3]));
    return sum;
  }

  /// The vertices at which a location has more than a part of its weight.
  std::vector<Vertex_index> element(const Face_location& l, double least) const
  {
    const auto c = locations_.corners(l.first);
    std::vector<Vertex_index> result;
    for (std::size_t k = 0; k < 3; ++k)
      if (l.second[k] > least * (l.second[0] + l.second[1] + l.second[2])) result.push_back(c[k]);
    std::sort(result.begin(), result.end());
    return result;
  }

  void check_side(const Source& source, const Geodesic::Nearest_source& nearest, const std::vector<Face_location>& path)
  {
    using Side = CGAL::Source_side;
    const Extent sides = source.kind != Source_kind::OPEN_POLYLINE && !is_closed(source) ? IS_POINT : extent(source);
    if (sides == IS_POINT || (sides == IS_OPEN && nearest.side == Side::NONE))
    {
      expect(nearest.side == Side::NONE, WRONG_SIDE, "a side of a source without sides");
      expect(nearest.is_segment <= (source.kind == Source_kind::EDGES), WRONG_SIDE, "a segment of a point");
      return;
    }
    const bool is_end = !nearest.is_segment && !is_closed(source) && is_at_end(source, nearest.part);
    if (is_end) return expect(nearest.side == Side::CAP, WRONG_SIDE, "an end without a cap");
    if (!expect_lateral(nearest.side) || path.size() < 2) return;
    const Point foot = point(path.back()), away = difference(point(path[path.size() - 2]), foot);
    if (norm(away) <= 1e-6 * longest_edge_) return;
    if (nearest.is_segment)
    {
      const Face_location &a = source.locations[nearest.part], &b = source.locations[after(source, nearest.part)];
      const Face_index f = locations_.common_face(path[path.size() - 2], path.back());
      Geodesic::Barycentric_coordinates unused;
      if (f == Surface_mesh::null_face()) return;
      if (!is_flat_ && !(locations_.express(a, f, unused) && locations_.express(b, f, unused))) return;
      const Point along = difference(point(b), point(a));
      if (norm(along) <= 1e-6 * longest_edge_) return;
      const Number sine = dot(cross(along, away), normal(f)) / (norm(along) * norm(away));
      expect(std::abs(sine) >= 1 - 1e-9, WRONG_SIDE, "sine " + number(double(sine)));
      expect((sine > 0) == (nearest.side == Side::LEFT), WRONG_SIDE, "side of a segment");
    }
    else if (is_flat_)
    {
      Point in, out;
      if (!directions_at(source, nearest.part, in, out)) return;
      const Number turn = (in[0] * out[1] - in[1] * out[0]) / (norm(in) * norm(out));
      if (std::abs(turn) < 1e-9) return; // straight on, or back
      expect((turn < 0) == (nearest.side == Side::LEFT), WRONG_SIDE, "side of a corner");
    }
  }

  // An end of an open polyline, which may be repeated.
  bool is_at_end(const Source& source, std::size_t part) const
  {
    const auto& l = source.locations;
    bool first = true, last = true;
    for (std::size_t i = 0; i <= part; ++i) first = first && distance(point(l[i]), point(l[part])) == 0;
    for (std::size_t i = part; i < l.size(); ++i) last = last && distance(point(l[i]), point(l[part])) == 0;
    return first || last;
  }

  // Of the segments before and behind a point of a polyline.
  bool directions_at(const Source& source, std::size_t part, Point& in, Point& out) const
  {
    const auto& l = source.locations;
    const std::size_t n = l.size();
    std::size_t before = (part + n - 1) % n, behind = (part + 1) % n;
    while (before != part && rounded(l[before]) == rounded(l[part])) before = (before + n - 1) % n;
    while (behind != part && rounded(l[behind]) == rounded(l[part])) behind = (behind + 1) % n;
    in = difference(point(l[part]), point(l[before]));
    out = difference(point(l[behind]), point(l[part]));
    return norm(in) > 1e-6 * longest_edge_ && norm(out) > 1e-6 * longest_edge_;
  }

  bool expect_lateral(CGAL::Source_side side)
  {
    const bool is_lateral = side == CGAL::Source_side::LEFT || side == CGAL::Source_side::RIGHT;
    expect(is_lateral, WRONG_SIDE, "no side of a polyline");
    return is_lateral;
  }

  void check_sign(CGAL::Source_side side, double d, double signed_d)
  {
    const bool is_lateral = side == CGAL::Source_side::LEFT || side == CGAL::Source_side::RIGHT;
    const bool is_right = d == 0      ? signed_d == 0
                        : !is_lateral ? std::isnan(signed_d)
                                      : signed_d == (side == CGAL::Source_side::LEFT ? -d : d);
    expect(is_right, WRONG_SIGN, "signed distance " + number(signed_d) + ", side " + std::to_string(int(side)));
  }

  Point normal(Face_index f) const
  {
    const auto c = locations_.corners(f);
    const Point a = vertex_point(c[0]), n = cross(difference(vertex_point(c[1]), a), difference(vertex_point(c[2]), a));
    const Number l = norm(n);
    return {n[0] / l, n[1] / l, n[2] / l};
  }

  const Surface_mesh& mesh_;
  const bool is_flat_, is_close_;
  const Locations<Surface_mesh> locations_;
  Point_3 origin_ = CGAL::ORIGIN; // of points
  double scale_ = 0, longest_edge_ = 0;
  unsigned faults_ = 0;
  std::string detail_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_ANSWER_CHECKER_H
