// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The gradient is a unit vector in the plane of the face, orthogonal to the offset through the point (1e-9), and agrees
// with finite differences. Paths leave offsets at right angles.

#include "query_cases.h"

#include <string>
#include <vector>

namespace test_gradient {

using namespace test;

struct Totals
{
  std::size_t pieces = 0, differences = 0, kinks = 0;
  double orthogonality = 0, difference = 0;
};

// Vectors in the frame of a face as vectors in space.
struct Face_axes
{
  Face_axes(const test::Surface_mesh& mesh, Face_index f)
  {
    const auto h = halfedge(f, mesh);
    x = unit(mesh.point(target(h, mesh)) - mesh.point(source(h, mesh)));
    const Vector_3 w = mesh.point(target(next(h, mesh), mesh)) - mesh.point(source(h, mesh));
    y = unit(w - (w * x) * x);
  }
  Vector_3 operator()(const Vector_2& v) const { return v.x() * x + v.y() * y; }

  Vector_3 x, y;
};

// At the midpoint of a long piece, which is far from ties, the gradient is orthogonal to the piece, and so is the start of
// the path.
void check_piece(const Geodesic& geodesic, Path_checker& checker, const test::Surface_mesh& mesh, const Offset_piece& piece,
                 Totals& totals)
{
  const Face_location middle = piece.location(0.5);
  const Point_2 p = piece.point_2(0.5);
  const Vector_2 along =
    piece.is_arc() ? Vector_2(-(p - piece.center()).y(), (p - piece.center()).x()) : piece.end_2() - piece.start_2();
  const Vector_3 tangent = unit(Face_axes(mesh, piece.face())(along));
  const Vector_3 outwards = unit(Face_axes(mesh, piece.face())(Vector_2(along.y(), -along.x()))); // source on the left
  const Vector_3 gradient = geodesic.gradient(middle).value_or(CGAL::NULL_VECTOR);
  CHECK_DETAIL(std::abs(gradient.squared_length() - 1) <= 1e-12, values(gradient.squared_length(), 1));
  CHECK(gradient * outwards > 0.5);
  CHECK(checker.out_of_plane(gradient, piece.face()) <= 1e-12);
  totals.orthogonality = (std::max)(totals.orthogonality, std::abs(gradient * tangent));
  CHECK_DETAIL(std::abs(gradient * tangent) <= 1e-9, values(gradient * tangent, 0));
  const auto nearest = geodesic.nearest_source(middle);
  CHECK(nearest && nearest->source == piece.source() && nearest->is_segment == piece.is_nearest_to_segment() &&
        nearest->side == piece.side());
  const Path_locations path = checker(geodesic, middle);
  ++totals.pieces;
  const Vector_3 start = checker.point(path.at(1)) - checker.point(path[0]);
  if (start.squared_length() > CGAL::square(1e-5 * checker.scale))
    CHECK_DETAIL(std::abs(unit(start) * tangent) <= 1e-9, values(unit(start) * tangent, 0));
}

// Inside a face, away from ties, where it is not differentiable, the distance has derivative 1 along the gradient and 0
// orthogonal to it.
void check_differences(const Geodesic& geodesic, const Mesh_locations& locations, const test::Surface_mesh& mesh,
                       const Face_location& l, Totals& totals)
{
  const Face_axes axes(mesh, l.first);
  const auto corners = locations.corners(l.first);
  const Point_3 o = mesh.point(corners[0]);
  const Vector_3 e = mesh.point(corners[1]) - o, g = mesh.point(corners[2]) - o;
  const double ex = e * axes.x, gx = g * axes.x, gy = g * axes.y, h = 1e-4 * gy;
  const Vector_3 gradient = geodesic.gradient(l).value_or(CGAL::NULL_VECTOR);
  const auto moved = [&](const Vector_3& v, double by) {
    const double x = by * (v * axes.x), y = by * (v * axes.y);
    const double w2 = y / gy, w1 = (x - w2 * gx) / ex;
    return Face_location(l.first, {{l.second[0] - w1 - w2, l.second[1] + w1, l.second[2] + w2}});
  };
  const double d = geodesic.distance_to_sources(l);
  if (h > 1e-3 * d) return; // close to the source
  ++totals.differences;
  const Vector_3 across = CGAL::cross_product(CGAL::cross_product(axes.x, axes.y), gradient);
  double error = 0;
  for (const auto& direction : {std::make_pair(gradient, 1.), std::make_pair(across, 0.)})
  {
    const double after = geodesic.distance_to_sources(moved(direction.first, h)) - d;
    const double before = d - geodesic.distance_to_sources(moved(direction.first, -h));
    // second differences are at most h^2 / d, except near a tie or a bend at a vertex
    if (std::abs(after - before) > 1e-4 * h + 2 * h * h / d)
    {
      ++totals.kinks;
      return;
    }
    error = (std::max)(error, std::abs((after + before) / (2 * h) - direction.second));
  }
  totals.difference = (std::max)(totals.difference, error);
  CHECK_DETAIL(error <= 1e-4, values(error, 0));
}

// From plane sections, or from a few points.
void run(Query_case& c, unsigned seed, bool polylines, Totals& totals)
{
  c.set_context((polylines ? "sections, seed " : "points, seed ") + std::to_string(seed));
  Random random(seed);
  Path_checker& checker = c.checker;
  const Mesh_locations& locations = checker.locations;
  const test::Surface_mesh& mesh = c.mesh;
  std::vector<Source> points;
  for (const Face_location& l : c.random_points(random, 3)) points.push_back(point_source(l));
  const Geodesic geodesic = built(mesh, polylines ? c.section(seed) : source_set(points));

  double largest = 0;
  for (Vertex_index v : used_vertices(mesh))
  {
    const double d = geodesic.distance_to_sources(v);
    if (std::isinf(d)) continue;
    largest = (std::max)(largest, d);
    const Vector_3 gradient = geodesic.gradient(v).value_or(CGAL::NULL_VECTOR);
    const auto nearest = geodesic.nearest_source(v);
    CHECK(nearest && (gradient == CGAL::NULL_VECTOR) == (d == 0));
    if (d == 0) continue;
    CHECK_DETAIL(std::abs(gradient.squared_length() - 1) <= 1e-12, values(gradient.squared_length(), 1));
    double off = infinity; // in the plane of one of the faces
    for (Face_index f : locations.incident_faces(locations.at_vertex(v)))
      off = (std::min)(off, checker.out_of_plane(gradient, f));
    CHECK_DETAIL(off <= 1e-12, values(off, 0));
  }
  for (int i = 0; i < 100; ++i)
    check_differences(geodesic, locations, mesh, random_location(locations, mesh, random, 0), totals);
  for (double part : {0.05, 0.31, 0.77})
    for (const Offset_curve& curve : offsets(geodesic, part * largest))
      for (std::size_t i = 0; i < curve.number_of_pieces(); i += 1 + uniform_index(random, 1 + curve.number_of_pieces() / 30))
        if (curve.piece(i).length() > 1e-3 * checker.mean_edge) check_piece(geodesic, checker, mesh, curve.piece(i), totals);
}

} // namespace test_gradient

GEODESIC_OFFSET_TEST(test_gradient)
{
  std::cout.precision(3);
  Totals totals;
  for_each_mesh(all_mesh_names("tiny faces"), {"anchor.off", "elephant.off", "mesh_with_border.off"}, [&](Query_case& c) {
    for (unsigned seed : {1u, 2u, 3u}) guarded([&] { run(c, seed, seed != 3, totals); });
  });
  // Only a few points may be near ties.
  if (totals.differences > 0) CHECK(totals.kinks * 20 <= totals.differences);
  std::cout << totals.pieces << " pieces, worst cosine " << totals.orthogonality << "; finite differences at "
            << totals.differences << " points, worst error " << totals.difference << ", and " << totals.kinks << " near kinks"
            << std::endl;
  return Report::instance().finish("test_gradient");
}
