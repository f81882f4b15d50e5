// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Checks of offset curves by the validation oracle, and of their polylines.

#ifndef GEODESIC_OFFSET_TEST_CURVE_CHECKS_H
#define GEODESIC_OFFSET_TEST_CURVE_CHECKS_H

#include "geodesic_types.h"
#include "locations.h"
#include "test_check.h"
#include "thin_polylines.h"
#include "validation/Offset_validation.h"

#include <iostream>
#include <string>
#include <vector>

namespace test {

typedef CGAL::Geodesic_offset::internal::Validation_options Validation_options;
typedef CGAL::Geodesic_offset::internal::Validation_report Validation_report;
typedef CGAL::Geodesic_offset::internal::Validation_kind Validation_kind;

/// Checks the curves of a geodesic object that was built with kept windows.
class Curve_checker
{
public:
  typedef Geodesic::Offset_curve Offset_curve;
  typedef Geodesic::Face_location Face_location;

  Curve_checker(const test::Surface_mesh& mesh, const Geodesic& geodesic,
                const Validation_options& options = Validation_options())
    : geodesic_(geodesic), validation_(geodesic, mesh, options), locations_(mesh), diagonal_(bounding_box_diagonal(mesh)),
      tolerance_(1e-5 * diagonal_), size_(diagonal_)
  {
    for (auto v : vertices(mesh))
      for (int i = 0; i < 3; ++i) size_ = (std::max)(size_, std::abs(mesh.point(v)[i]));
  }

  /// `curves`: all curves of the levels; levels increase.
  Validation_report check(const std::vector<double>& levels, const std::vector<Offset_curve>& curves) const
  {
    const Validation_report report = validation_(levels, curves);
    std::string detail = std::to_string(report.failures()) + " of " + std::to_string(report.checks()) + " checks of curves";
    for (const std::string& text : report.texts()) detail += "\n  " + text;
    CHECK_DETAIL(report.is_valid(), detail);
    for (const Offset_curve& curve : curves) check_polyline(curve);
    return report;
  }

private:
  // Checks that locations are on the level, that consecutive ones share a face, and that the polyline through them has
  // nearly the length of the curve. The thin polyline through the points must be within the tolerance.
  void check_polyline(const Offset_curve& curve) const
  {
    check_thin_polyline(curve, tolerance_, size_);
    std::vector<Face_location> locations;
    std::vector<Point_3> points;
    curve.face_locations(tolerance_, std::back_inserter(locations));
    for (const Face_location& l : locations) points.push_back(curve.point(l));
    if (!CHECK(locations.size() >= 2)) return;
    if (curve.is_closed()) CHECK(points.front() == points.back());
    double length = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      locations[i] = on_simplex(locations[i]);
      const double off_point = std::sqrt(CGAL::squared_distance(points[i], locations_.point(locations[i])));
      CHECK_DETAIL(off_point <= 1e-9 * diagonal_, values(off_point, 0));
      const double distance = geodesic_.distance_to_sources(locations[i]);
      CHECK_DETAIL(std::abs(distance - curve.distance()) <= 1e-9 * diagonal_, values(distance, curve.distance()));
      if (i == 0) continue;
      length += std::sqrt(CGAL::squared_distance(points[i - 1], points[i]));
      CHECK(locations_.common_face(locations[i - 1], locations[i]) != test::Surface_mesh::null_face());
    }
    // the accuracy of small loops is that of the coordinates of their points
    CHECK_DETAIL(length <= curve.length() * (1 + 1e-9) + 1e-15 * diagonal_, values(length, curve.length()));
    CHECK_DETAIL(length >= 0.9 * curve.length() - 10 * tolerance_, values(length, curve.length()));
  }

  // As documented, coordinates below 1e-13 move a location to the edge or vertex.
  static Face_location on_simplex(Face_location location)
  {
    for (double& w : location.second)
      if (std::abs(w) <= 1e-13) w = 0;
    return location;
  }

  const Geodesic& geodesic_;
  CGAL::Geodesic_offset::internal::Offset_validation<Geodesic> validation_;
  Locations<test::Surface_mesh> locations_;
  double diagonal_, tolerance_, size_;
};

inline void print(std::ostream& out, const Validation_report& report)
{
  out << report.curves << " curves of " << report.pieces << " pieces, " << report.loops_in_faces << " loops in faces (at most "
      << report.most_loops_in_face << " in one); " << report.points << " points off their level by at most "
      << report.worst_off_level << " diagonals; " << report.separating_edges << " edges, " << report.separated_on_edges
      << " points on edges and " << report.separated_in_faces << " points in faces separated; " << report.oriented_pieces
      << " pieces oriented; " << report.compared_pairs << " pairs compared, crossing " << report.worst_crossing << " deep; "
      << report.areas << " areas, undecided " << report.undecided_share / double((std::max)(report.areas, std::size_t(1)))
      << " on average, " << report.worst_undecided_share << " at most; " << report.undecided_vertices
      << " vertices at the level; " << report.checks() << " checks, " << report.failures() << " failures";
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_CURVE_CHECKS_H
