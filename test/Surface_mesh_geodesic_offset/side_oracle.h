// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Side on which a shortest path arrives at a polyline: by the angles at its end point between the path's last segment and
// the polyline.

#ifndef GEODESIC_OFFSET_TEST_SIDE_ORACLE_H
#define GEODESIC_OFFSET_TEST_SIDE_ORACLE_H

#include "locations.h"
#include "offset_tools.h"

#include <string>
#include <vector>

namespace test {

/// Polyline without repeated points, as added to the sources.
struct Oriented_polyline
{
  std::vector<Face_location> locations;
  bool closed;
};

class Side_oracle
{
public:
  typedef CGAL::Source_side Side;
  typedef test::Surface_mesh::Face_index Face_index;
  typedef test::Surface_mesh::Halfedge_index Halfedge_index;
  typedef Locations<test::Surface_mesh>::Barycentric_coordinates Barycentric_coordinates;

  /// `geodesic` was built with kept windows; source i is polyline i.
  Side_oracle(const test::Surface_mesh& mesh, const Geodesic& geodesic, const std::vector<Oriented_polyline>& polylines)
    : mesh_(mesh), locations_(mesh), geodesic_(geodesic), polylines_(polylines), diagonal_(bounding_box_diagonal(mesh))
  {
  }

  /// Side from which a shortest path from the middle of the piece arrives. Also checks that the path ends on the part of
  /// the source given by the piece, and makes no acute angle with the polyline there.
  Side side_of(const Offset_piece& piece)
  {
    std::vector<Face_location> path;
    geodesic_.shortest_path_to_sources(piece.location(0.5), std::back_inserter(path));
    if (!CHECK(path.size() >= 2)) return Side::NONE;
    for (Face_location& p : path)
      for (double& w : p.second)
        if (std::abs(w) <= 1e-13) w = 0;
    std::size_t last = path.size() - 1;
    const Face_location arrival = path[last];
    while (last > 1 && gap(path[last - 1], arrival) <= 1e-9 * diagonal_) --last;
    const Face_index face = locations_.common_face(path[last - 1], path[last]);
    if (!CHECK(face != test::Surface_mesh::null_face())) return Side::NONE;
    const Vector_3 away = locations_.point(path[last - 1]) - locations_.point(arrival);
    const Oriented_polyline& polyline = polylines_[piece.source()];
    return piece.is_nearest_to_segment() ? side_of_segment(polyline, piece.source_part(), arrival, face, away)
                                         : side_of_point(polyline, piece.source_part(), arrival, face, away);
  }

  /// Checks the sides of at most about `number` pieces of the curves; returns the number of checked pieces.
  std::size_t check(const Offset_curves& curves, std::size_t number)
  {
    std::size_t count = 0, pieces = 0, i = 0;
    for (const Offset_curve& curve : curves) pieces += curve.number_of_pieces();
    const std::size_t step = pieces / number + 1;
    for (const Offset_curve& curve : curves)
      for (const Offset_piece& piece : curve.pieces())
      {
        if (i++ % step != 0 || piece.length() <= 1e-8 * diagonal_) continue;
        const Side side = side_of(piece);
        CHECK_DETAIL(side == piece.side(), "found " + std::to_string(int(side)) + ", said " +
                                             std::to_string(int(piece.side())) + " at " + std::to_string(curve.distance()));
        ++count;
      }
    return count;
  }

private:
  static double length(const Vector_3& v) { return std::sqrt(v.squared_length()); }

  double gap(const Face_location& a, const Face_location& b) const { return length(locations_.point(a) - locations_.point(b)); }

  Vector_3 normal_of(Face_index f) const
  {
    const auto c = locations_.corners(f);
    return CGAL::cross_product(mesh_.point(c[1]) - mesh_.point(c[0]), mesh_.point(c[2]) - mesh_.point(c[0]));
  }

  const Face_location& vertex(const Oriented_polyline& polyline, std::size_t i) const
  {
    return polyline.locations[i % polyline.locations.size()];
  }

  // Distance of a point from segment i.
  double excess(const Oriented_polyline& polyline, std::size_t i, const Face_location& p) const
  {
    const Face_location &a = vertex(polyline, i), &b = vertex(polyline, i + 1);
    return gap(a, p) + gap(p, b) - gap(a, b);
  }

  // Whether the polyline is straight at its vertex i.
  bool is_straight(const Oriented_polyline& polyline, std::size_t i) const
  {
    const std::size_t n = polyline.locations.size();
    const Face_location& p = vertex(polyline, i);
    double total = 0;
    const double out = angle_of(p, vertex(polyline, i + 1), total);
    const double in = angle_of(p, vertex(polyline, i + n - 1), total);
    return std::abs(turn(out, in, total) - CGAL_PI) <= 1e-9 && std::abs(total - 2 * CGAL_PI) <= 1e-9;
  }

  Side side_of_segment(const Oriented_polyline& polyline, std::size_t part, const Face_location& arrival, Face_index face,
                       const Vector_3& away) const
  {
    // collinear consecutive segments may have one name
    const std::size_t n = polyline.locations.size();
    std::size_t i = part;
    const double tolerance = 1e-9 * diagonal_;
    while (excess(polyline, i, arrival) > tolerance && i < part + n && is_straight(polyline, i + 1)) ++i;
    if (excess(polyline, i, arrival) > tolerance)
      for (i = part + n; excess(polyline, i, arrival) > tolerance && i > part && is_straight(polyline, i);) --i;
    CHECK_DETAIL(excess(polyline, i, arrival) <= tolerance, values(excess(polyline, part, arrival), 0));
    const Vector_3 along = locations_.point(vertex(polyline, i + 1)) - locations_.point(vertex(polyline, i));
    const Vector_3 left = CGAL::cross_product(normal_of(face), along);
    const double sine = (away * left) / length(away) / length(left);
    CHECK_DETAIL(std::abs(sine) >= 1 - 1e-6, values(sine, 1));
    return sine > 0 ? Side::LEFT : Side::RIGHT;
  }

  Side side_of_point(const Oriented_polyline& polyline, std::size_t i, const Face_location& arrival, Face_index face,
                     const Vector_3& away) const
  {
    const std::size_t n = polyline.locations.size();
    const Face_location& p = vertex(polyline, i);
    CHECK_DETAIL(gap(arrival, p) <= 1e-9 * diagonal_, values(gap(arrival, p), 0));
    const bool is_first = !polyline.closed && i == 0, is_last = !polyline.closed && i + 1 == n;
    double total = 0;
    const double path_angle = angle_of(p, face, away, total);
    const double out = angle_of(p, vertex(polyline, is_last ? i - 1 : i + 1), total);
    const double in = angle_of(p, vertex(polyline, is_first ? 1 : i + n - 1), total);
    // the left of the direction of travel is counterclockwise between `out` and `in`
    const double after_out = turn(out, path_angle, total), before_in = turn(path_angle, in, total);
    const double before_out = turn(path_angle, out, total), after_in = turn(in, path_angle, total);
    const bool left = is_first || is_last || after_out < turn(out, in, total);
    const double smaller = left ? (std::min)(after_out, before_in) : (std::min)(after_in, before_out);
    if (!is_border_point(p)) // otherwise one of these is across the border
      CHECK_DETAIL(smaller >= 0.5 * CGAL_PI - 1e-6, values(smaller, 0.5 * CGAL_PI));
    if (is_first || is_last) return Side::CAP;
    return left ? Side::LEFT : Side::RIGHT;
  }

  bool is_border_point(const Face_location& p) const
  {
    const auto support = locations_.support(p);
    if (support.size() == 1) return mesh_.is_border(support[0].first);
    if (support.size() == 3) return false;
    return mesh_.is_border(mesh_.edge(mesh_.halfedge(support[0].first, support[1].first)));
  }

  // Counterclockwise angle from a to b.
  static double turn(double a, double b, double total)
  {
    double t = std::fmod(b - a, total);
    if (t < 0) t += total;
    return t;
  }

  static double angle_between(const Vector_3& a, const Vector_3& b)
  {
    return std::atan2(length(CGAL::cross_product(a, b)), a * b);
  }

  // Direction from p to q, which have a common face.
  double angle_of(const Face_location& p, const Face_location& q, double& total) const
  {
    return angle_of(p, locations_.common_face(p, q), locations_.point(q) - locations_.point(p), total);
  }

  // Angle of a direction at p, in the plane of a face at p, counterclockwise from a first direction; `total` is the sum of
  // all angles around p.
  double angle_of(const Face_location& p, Face_index face, const Vector_3& direction, double& total) const
  {
    const auto support = locations_.support(p);
    if (support.size() == 3)
    {
      total = 2 * CGAL_PI;
      const Halfedge_index h = halfedge(face, mesh_);
      return in_plane(face, mesh_.point(target(h, mesh_)) - mesh_.point(source(h, mesh_)), direction);
    }
    if (support.size() == 2)
    {
      total = 2 * CGAL_PI;
      const Halfedge_index h = mesh_.halfedge(support[0].first, support[1].first);
      const Vector_3 along = mesh_.point(target(h, mesh_)) - mesh_.point(source(h, mesh_));
      const double angle = angle_between(along, direction); // 0 to pi on either side
      return mesh_.face(h) == face ? angle : 2 * CGAL_PI - angle;
    }
    // around the vertex, from each outgoing halfedge to the next
    Halfedge_index first = mesh_.opposite(mesh_.halfedge(support[0].first));
    if (mesh_.is_border(support[0].first)) // the first in counterclockwise order
      while (!mesh_.is_border(mesh_.opposite(first))) first = mesh_.next(mesh_.opposite(first));
    double result = 0;
    total = 0;
    Halfedge_index h = first;
    do {
      const Halfedge_index next = mesh_.opposite(mesh_.prev(h));
      const Point_3 v = mesh_.point(source(h, mesh_));
      const Vector_3 right = mesh_.point(target(h, mesh_)) - v, left = mesh_.point(target(next, mesh_)) - v;
      if (mesh_.face(h) == face) result = total + angle_between(right, direction);
      total += angle_between(right, left);
      h = next;
    } while (h != first && !mesh_.is_border(h));
    return result;
  }

  double in_plane(Face_index face, const Vector_3& x, const Vector_3& v) const
  {
    const Vector_3 y = CGAL::cross_product(normal_of(face), x);
    return std::atan2((v * y) / length(y), (v * x) / length(x));
  }

  const test::Surface_mesh& mesh_;
  Locations<test::Surface_mesh> locations_;
  const Geodesic& geodesic_;
  std::vector<Oriented_polyline> polylines_;
  double diagonal_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_SIDE_ORACLE_H
