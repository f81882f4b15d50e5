// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// What must hold for the offset curves of one level, checked against the field itself.

#ifndef GEODESIC_OFFSET_TEST_CURVE_CHECKS_H
#define GEODESIC_OFFSET_TEST_CURVE_CHECKS_H

#include "geodesic_types.h"
#include "locations.h"
#include "test_check.h"

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace test {

/// Checks the curves of a geodesic object that was built with kept windows.
class Curve_checker
{
public:
  typedef Geodesic::Offset_curve Offset_curve;
  typedef Geodesic::Face_location Face_location;
  typedef test::Surface_mesh::Vertex_index Vertex_index;
  typedef test::Surface_mesh::Face_index Face_index;
  typedef test::Surface_mesh::Edge_index Edge_index;

  Curve_checker(const test::Surface_mesh& mesh, const Geodesic& geodesic, unsigned seed)
    : mesh_(mesh), geodesic_(geodesic), locations_(mesh), diagonal_(bounding_box_diagonal(mesh)),
      tolerance_(1e-5 * diagonal_)
  {
    Random random(seed);
    for (std::size_t i = 0; i < 4000; ++i)
    {
      const Face_index f(
        static_cast<Face_index::size_type>(uniform_index(random, num_faces(mesh))));
      Probe probe{f, random_barycentric(random), random_barycentric(random), 0, 0};
      probe.distance_p = geodesic.distance_to_sources(Face_location(f, probe.p));
      probe.distance_q = geodesic.distance_to_sources(Face_location(f, probe.q));
      probes_.push_back(probe);
    }
  }

  /// All checks for the curves of one level.
  void check(double level, const std::vector<Offset_curve>& curves)
  {
    crossings_.clear();
    touched_vertices_.clear();
    chords_.clear();
    for (const Offset_curve& curve : curves)
    {
      CHECK(curve.distance() == level);
      check_curve(level, curve);
    }
    check_edges(level);
    check_probes(level);
    number_of_curves_ += curves.size();
  }

  double worst_off_level() const { return worst_off_level_ / diagonal_; }
  std::size_t number_of_points() const { return number_of_points_; }
  std::size_t number_of_curves() const { return number_of_curves_; }
  std::size_t number_of_crossed_edges() const { return number_of_crossed_edges_; }
  std::size_t number_of_crossed_probes() const { return number_of_crossed_probes_; }

private:
  typedef std::array<double, 3> Barycentric_coordinates;
  struct Probe // a segment inside a face
  {
    Face_index face;
    Barycentric_coordinates p, q;
    double distance_p, distance_q;
  };

  void check_curve(double level, const Offset_curve& curve)
  {
    std::vector<Face_location> locations;
    std::vector<Point_3> points;
    curve.face_locations(tolerance_, std::back_inserter(locations));
    curve.points(tolerance_, std::back_inserter(points));
    if (!CHECK(locations.size() >= 2 && points.size() == locations.size() &&
               curve.number_of_pieces() > 0))
      return;
    number_of_points_ += points.size();
    for (Face_location& location : locations) location = on_simplex(location);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double off_point =
        std::sqrt(CGAL::squared_distance(points[i], locations_.point(locations[i])));
      CHECK_DETAIL(off_point <= 1e-9 * diagonal_, values(off_point, 0));
      const double distance = geodesic_.distance_to_sources(locations[i]);
      CHECK_DETAIL(std::abs(distance - level) <= 1e-9 * diagonal_, values(distance, level));
      worst_off_level_ = (std::max)(worst_off_level_, std::abs(distance - level));
    }
    check_ends(curve, points, locations);

    double length = 0, left_smaller = 0, right_smaller = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      const double chord = std::sqrt(CGAL::squared_distance(points[i], points[i + 1]));
      length += chord;
      const Face_index f = locations_.common_face(locations[i], locations[i + 1]);
      if (!CHECK(f != test::Surface_mesh::null_face())) continue;
      Barycentric_coordinates a, b;
      locations_.express(locations[i], f, a);
      locations_.express(locations[i + 1], f, b);
      chords_[f].push_back({a, b});
      if (chord > 0) compare_sides(f, a, b, chord, left_smaller, right_smaller);
    }
    CHECK_DETAIL(length <= curve.length() * (1 + 1e-9), values(length, curve.length()));
    CHECK_DETAIL(length >= 0.9 * curve.length() - 10 * tolerance_, values(length, curve.length()));
    CHECK_DETAIL(left_smaller >= right_smaller, values(left_smaller, right_smaller));
    for (std::size_t i = 0; i < locations.size(); ++i)
      if (i + 1 < locations.size() || !curve.is_closed()) // a closed curve repeats its first point
        if (i == 0 ||
            CGAL::squared_distance(points[i - 1], points[i]) > CGAL::square(1e-13 * diagonal_))
          record_crossing(locations[i]);
  }

  // As the documentation says, coordinates below 1e-13 put a location on the edge or at the vertex.
  static Face_location on_simplex(Face_location location)
  {
    for (double& w : location.second)
      if (std::abs(w) <= 1e-13) w = 0;
    return location;
  }

  void check_ends(const Offset_curve& curve, const std::vector<Point_3>& points,
                  const std::vector<Face_location>& locations)
  {
    if (curve.is_closed()) CHECK(points.front() == points.back());
    else CHECK(is_on_boundary(locations.front()) && is_on_boundary(locations.back()));
  }

  bool is_on_boundary(const Face_location& location) const
  {
    const auto support = locations_.support(location);
    if (support.size() == 1) return mesh_.is_border(support[0].first);
    if (support.size() == 2)
    {
      const auto h = CGAL::halfedge(support[0].first, support[1].first, mesh_);
      return h.second && mesh_.is_border(mesh_.edge(h.first));
    }
    return false;
  }

  // Adds the chord's length to the side where the distances are smaller, beside the middle of the
  // chord.
  void compare_sides(Face_index f, const Barycentric_coordinates& a,
                     const Barycentric_coordinates& b, double chord, double& left_smaller,
                     double& right_smaller) const
  {
    const auto corners = locations_.corners(f);
    const Point_3 p = mesh_.point(corners[0]), q = mesh_.point(corners[1]),
                  r = mesh_.point(corners[2]);
    const Vector_3 u = q - p, v = r - p;
    const Vector_3 along = locations_.point({f, b}) - locations_.point({f, a});
    const Vector_3 normal = CGAL::cross_product(u, v);
    if (normal.squared_length() == 0) return;
    Vector_3 left = CGAL::cross_product(normal, along);
    left = left * ((std::min)(4 * tolerance_, chord) / std::sqrt(left.squared_length()));
    // left = s u + t v in the plane of the face.
    const double uu = u * u, uv = u * v, vv = v * v, determinant = uu * vv - uv * uv;
    const double s = ((left * u) * vv - (left * v) * uv) / determinant;
    const double t = ((left * v) * uu - (left * u) * uv) / determinant;
    Barycentric_coordinates on_left, on_right;
    const double step[3] = {-s - t, s, t};
    for (std::size_t k = 0; k < 3; ++k)
    {
      on_left[k] = (a[k] + b[k]) / 2 + step[k];
      on_right[k] = (a[k] + b[k]) / 2 - step[k];
      if (on_left[k] < 0 || on_right[k] < 0) return;
    }
    const double difference = geodesic_.distance_to_sources(Face_location(f, on_left)) -
                              geodesic_.distance_to_sources(Face_location(f, on_right));
    if (difference < 0) left_smaller += chord;
    if (difference > 0) right_smaller += chord;
  }

  void record_crossing(const Face_location& location)
  {
    const auto support = locations_.support(location);
    // A level through a vertex is cut within rounding of the vertex, through some of its edges.
    for (const auto& s : support)
      if (CGAL::squared_distance(mesh_.point(s.first), locations_.point(location)) <=
          CGAL::square(1e-11 * diagonal_))
        touched_vertices_.insert(s.first);
    if (support.size() == 2)
    {
      const auto h = CGAL::halfedge(support[0].first, support[1].first, mesh_);
      if (CHECK(h.second)) ++crossings_[mesh_.edge(h.first)];
    }
  }

  // An edge with ends on different sides is crossed, an odd number of times; any other an even
  // number of times.
  void check_edges(double level)
  {
    const double rounding = 1e-12 * diagonal_;
    for (Edge_index e : edges(mesh_))
    {
      const Vertex_index u = source(halfedge(e, mesh_), mesh_),
                         v = target(halfedge(e, mesh_), mesh_);
      const double distance_u = geodesic_.distance_to_sources(u),
                   distance_v = geodesic_.distance_to_sources(v);
      const bool touched = touched_vertices_.count(u) + touched_vertices_.count(v) > 0;
      const bool is_separating = (distance_u < level) != (distance_v < level);
      const std::size_t crossings = crossings_.count(e) ? crossings_[e] : 0;
      if (is_separating)
      {
        ++number_of_crossed_edges_;
        CHECK_DETAIL(crossings > 0 || touched, values(distance_u, distance_v));
      }
      const bool is_clear =
        std::abs(distance_u - level) > rounding && std::abs(distance_v - level) > rounding;
      if (is_clear && !touched)
        CHECK_DETAIL(crossings % 2 == (is_separating ? 1u : 0u),
                     std::to_string(crossings) + " crossings");
    }
  }

  // The same for segments inside faces: this sees loops that meet no edge, and pieces that are
  // missing.
  void check_probes(double level)
  {
    for (const Probe& probe : probes_)
    {
      if (std::abs(probe.distance_p - level) < 2 * tolerance_ ||
          std::abs(probe.distance_q - level) < 2 * tolerance_)
        continue; // a chord may be on the other side than its arc
      const bool is_separating = (probe.distance_p < level) != (probe.distance_q < level);
      number_of_crossed_probes_ += is_separating ? 1 : 0;
      const Point_2 p = in_plane(probe.p), q = in_plane(probe.q);
      std::size_t crossings = 0;
      const auto chords = chords_.find(probe.face);
      if (chords != chords_.end())
        for (const auto& chord : chords->second)
        {
          const Point_2 a = in_plane(chord.first), b = in_plane(chord.second);
          if ((CGAL::orientation(p, q, a) == CGAL::LEFT_TURN) !=
                (CGAL::orientation(p, q, b) == CGAL::LEFT_TURN) &&
              (CGAL::orientation(a, b, p) == CGAL::LEFT_TURN) !=
                (CGAL::orientation(a, b, q) == CGAL::LEFT_TURN))
            ++crossings;
        }
      CHECK_DETAIL(crossings % 2 == (is_separating ? 1u : 0u),
                   std::to_string(crossings) + " crossings, " +
                     values(probe.distance_p, probe.distance_q));
    }
  }

  static Point_2 in_plane(const Barycentric_coordinates& b) { return Point_2(b[1], b[2]); }

  const test::Surface_mesh& mesh_;
  const Geodesic& geodesic_;
  Locations<test::Surface_mesh> locations_;
  double diagonal_, tolerance_;
  std::vector<Probe> probes_;
  std::map<Edge_index, std::size_t> crossings_;
  std::set<Vertex_index> touched_vertices_;
  std::map<Face_index, std::vector<std::pair<Barycentric_coordinates, Barycentric_coordinates>>>
    chords_;
  double worst_off_level_ = 0;
  std::size_t number_of_points_ = 0, number_of_curves_ = 0, number_of_crossed_edges_ = 0,
              number_of_crossed_probes_ = 0;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_CURVE_CHECKS_H
