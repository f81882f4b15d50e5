// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Polylines in the faces of planar grids against distances in the plane. test_properties compares polylines on other meshes with
// points on them.

#include "closed_forms.h"
#include "generated_meshes.h"
#include "geodesic_types.h"
#include "test_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace test_polyline_sources {

using namespace test;

typedef test::Locations<test::Surface_mesh> Locations;
typedef Geodesic::Face_location Face_location;

// A location of a face: a corner, on an edge, beside an edge, or inside.
Face_location random_location(test::Surface_mesh::Face_index f, Random& random)
{
  Face_location l(f, random_barycentric(random));
  const std::size_t k = uniform_index(random, 3), kind = uniform_index(random, 5);
  if (kind == 4) return l;
  const double off = kind == 3 ? std::pow(10, uniform(random, -12, -2)) : 0;
  const double t = kind == 0 ? 0 : uniform(random) < 0.2 ? 0.5 : uniform(random, 0, 1 - off);
  l.second[k] = 1 - t - off;
  l.second[(k + 1) % 3] = t;
  l.second[(k + 2) % 3] = off;
  return l;
}

// Polylines of up to five points in faces of a planar grid: their segments run along edges and back, and cross. Distances of
// vertices and of points in faces against those in the plane.
void run_in_faces_of_grid(unsigned seed)
{
  Random random(seed);
  const double jitter = uniform(random) < 0.5 ? 0 : 0.2;
  const Generated_mesh<test::Surface_mesh> data(planar_grid(1 + uniform_index(random, 4), 1 + uniform_index(random, 4),
                                                            Diagonals::random, 1, jitter, seed));
  const test::Surface_mesh& mesh = data.mesh;
  const Locations locations(mesh);
  const auto random_face = [&] {
    return test::Surface_mesh::Face_index(
      static_cast<test::Surface_mesh::size_type>(uniform_index(random, mesh.number_of_faces())));
  };

  std::vector<std::pair<Point_3, Point_3>> segments;
  Geodesic geodesic(mesh);
  const auto first = random_face();
  for (std::size_t i = 0, n = 1 + uniform_index(random, 3); i < n; ++i)
  {
    const auto f = uniform(random) < 0.7 ? first : random_face();
    std::vector<Face_location> polyline;
    for (std::size_t k = 0, m = 2 + uniform_index(random, 4); k < m; ++k) polyline.push_back(random_location(f, random));
    for (std::size_t k = 1; k < polyline.size(); ++k)
      segments.emplace_back(locations.point(polyline[k - 1]), locations.point(polyline[k]));
    geodesic.add_source_polyline(polyline);
  }
  const auto in_plane = [](const Point_3& p) { return Point_2(p.x(), p.y()); };
  const auto expected = [&](const Point_3& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& s : segments)
      least = (std::min)(least, segment_distance(in_plane(p), in_plane(s.first), in_plane(s.second)));
    return least;
  };
  geodesic.build(CGAL::parameters::keep_windows(true));
  double worst = 0;
  for (auto v : vertices(mesh)) worst = (std::max)(worst, std::abs(geodesic.distance_to_sources(v) - expected(mesh.point(v))));
  for (auto f : faces(mesh))
  {
    const Face_location l = random_location(f, random);
    worst = (std::max)(worst, std::abs(geodesic.distance_to_sources(l) - expected(locations.point(l))));
  }
  CHECK_DETAIL(worst <= 1e-12, "off by " + std::to_string(worst));
}

} // namespace test_polyline_sources

GEODESIC_OFFSET_TEST(test_polyline_sources)
{
  for (unsigned seed = 1; seed <= number_of_cases(3000u, 10000u); ++seed)
  {
    Report::instance().set_context("grid, seed " + std::to_string(seed));
    run_in_faces_of_grid(seed);
  }
  return Report::instance().finish("test_polyline_sources");
}
