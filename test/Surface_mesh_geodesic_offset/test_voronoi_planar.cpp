// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi diagrams on triangulated rectangles: of points against the dual of CGAL's Delaunay triangulation, of segments against
// CGAL's segment Delaunay graph, and the points of all bisectors against distances in closed form, with and without start values.

#include "planar_polyline.h"
#include "test_check.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Segment_Delaunay_graph_2.h>
#include <CGAL/Segment_Delaunay_graph_filtered_traits_2.h>
#include <CGAL/Segment_Delaunay_graph_storage_traits_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <iostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_voronoi_planar {

using namespace test;

typedef Geodesic::Field::Voronoi_diagram Diagram;

constexpr double side = 8; // of the square
constexpr double tolerance = 1e-10;

struct Totals
{
  std::size_t diagrams = 0, vertices = 0, points = 0, labels = 0, curves = 0;
  double vertex = 0, tie = 0;
};
Totals totals;

// A source: a segment, or a point if both ends are equal.
struct Site
{
  Point_2 a, b;
  double start = 0;

  double distance(const Point_2& p) const
  {
    const Vector_2 u = b - a;
    const double size = u.squared_length();
    const double t = size > 0 ? (std::max)(0., (std::min)(1., ((p - a) * u) / size)) : 0;
    return start + std::sqrt((p - (a + t * u)).squared_length());
  }
};

bool is_inside(const Point_2& p, double margin = 0)
{
  return p.x() > margin && p.x() < side - margin && p.y() > margin && p.y() < side - margin;
}

double least_distance(const std::vector<Site>& sites, const Point_2& p)
{
  double least = 1e300;
  for (const Site& s : sites) least = (std::min)(least, s.distance(p));
  return least;
}

// The points of curves are equally far from the sources on both sides, and from no other one less far. Faces that no curve crosses
// have one label.
void check_distances(const Planar_mesh& mesh, const Diagram& diagram, const std::vector<Site>& sites, Random& random)
{
  std::set<Surface_mesh::Face_index> crossed;
  for (const auto& curve : diagram.curves())
  {
    ++totals.curves;
    CHECK(curve.source_on_left() != curve.source_on_right() && curve.number_of_pieces() > 0);
    CHECK(!curve.is_closed() || (!curve.start_vertex() && !curve.end_vertex()));
    for (std::size_t i = 0; i < curve.number_of_pieces(); ++i)
    {
      const auto piece = curve.piece(i);
      crossed.insert(piece.face());
      for (const double t : {0., 0.25, 0.5, 0.9, 1.})
      {
        const Point_2 p = mesh.uv(piece.location(t));
        const double l = sites[piece.source_on_left()].distance(p), r = sites[piece.source_on_right()].distance(p);
        const double error = (std::max)(std::abs(l - r), l - least_distance(sites, p));
        ++totals.points;
        totals.tie = (std::max)(totals.tie, error);
        CHECK_DETAIL(error <= tolerance, std::to_string(error));
      }
      // the sides are as the curve says, half a step beside it
      const Point_2 p = mesh.uv(piece.location(0.5)), q = mesh.uv(piece.location(0.5 + 1e-3));
      const Vector_2 n(p.y() - q.y(), q.x() - p.x());
      const double size = std::sqrt(n.squared_length());
      const Point_2 beside = p + (1e-5 / size) * n;
      if (size > 1e-9 && is_inside(beside))
        CHECK(sites[piece.source_on_left()].distance(beside) < sites[piece.source_on_right()].distance(beside) + tolerance);
      if (i + 1 < curve.number_of_pieces())
        CHECK(std::sqrt((mesh.uv(piece.end()) - mesh.uv(curve.piece(i + 1).start())).squared_length()) <= tolerance);
    }
  }
  for (int i = 0; i < 500; ++i)
  {
    const Point_2 p(uniform(random, 0, side), uniform(random, 0, side));
    const auto f = mesh.location(p).first;
    if (crossed.count(f) != 0) continue;
    ++totals.labels;
    CHECK(sites[diagram.source_at_face(f)].distance(p) <= least_distance(sites, p) + tolerance);
  }
}

// Each expected vertex is one of the diagram, and there are no others.
void check_vertices(const Planar_mesh& mesh, const Diagram& diagram, const std::vector<Point_2>& expected)
{
  CHECK_DETAIL(diagram.number_of_vertices() == expected.size(),
               std::to_string(diagram.number_of_vertices()) + " instead of " + std::to_string(expected.size()));
  for (const Point_2& p : expected)
  {
    double nearest = 1e300;
    for (std::size_t i = 0; i < diagram.number_of_vertices(); ++i)
      nearest = (std::min)(nearest, std::sqrt((mesh.uv(diagram.vertex(i)) - p).squared_length()));
    ++totals.vertices;
    totals.vertex = (std::max)(totals.vertex, nearest);
    CHECK_DETAIL(nearest <= tolerance, std::to_string(nearest));
  }
  for (std::size_t i = 0; i < diagram.number_of_vertices(); ++i) CHECK(diagram.curves_at_vertex(i).size() == 3);
}

Diagram diagram_of(const Planar_mesh& mesh, const std::vector<Site>& sites)
{
  Geodesic geodesic(mesh.data.mesh);
  for (const Site& s : sites)
    if (s.a == s.b) geodesic.add_source_point(mesh.location(s.a), CGAL::parameters::start_value(s.start));
    else geodesic.add_source_polyline(mesh.path({s.a, s.b}, false).locations, CGAL::parameters::start_value(s.start));
  ++totals.diagrams;
  return geodesic.build(CGAL::parameters::keep_windows(true)).voronoi_diagram();
}

std::vector<Soup> squares(unsigned seed)
{
  std::vector<Soup> result;
  for (const std::size_t n : {std::size_t(1), std::size_t(9)})
  {
    result.push_back(planar_grid(n, n, Diagonals::random, side / double(n), n == 1 ? 0 : 0.2, seed));
    result.push_back(random_rectangle(side, side, 40 * (n - 1), 5, seed));
  }
  return result;
}

void points()
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
  typedef CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<std::size_t, K>> Data_structure;
  typedef CGAL::Delaunay_triangulation_2<K, Data_structure> Delaunay;
  for (unsigned seed = 1; seed <= 3; ++seed)
    for (const Soup& soup : squares(seed))
    {
      Report::instance().set_context("points, seed " + std::to_string(seed));
      const Planar_mesh mesh(soup, seed);
      Random random(seed);
      std::vector<Site> sites;
      Delaunay delaunay;
      for (std::size_t i = 0; i < 20; ++i)
      {
        const Point_2 p(uniform(random, 0.1, side - 0.1), uniform(random, 0.1, side - 0.1));
        sites.push_back({p, p});
        delaunay.insert(p)->info() = i;
      }
      const Diagram diagram = diagram_of(mesh, sites);
      check_distances(mesh, diagram, sites, random);
      std::vector<Point_2> circumcenters;
      for (auto f = delaunay.finite_faces_begin(); f != delaunay.finite_faces_end(); ++f)
        if (is_inside(delaunay.dual(f))) circumcenters.push_back(delaunay.dual(f));
      check_vertices(mesh, diagram, circumcenters);
      // the edges of the dual that meet the square
      std::multiset<std::pair<std::size_t, std::size_t>> expected, found;
      const K::Iso_rectangle_2 square(0, 0, side, side);
      for (auto e = delaunay.finite_edges_begin(); e != delaunay.finite_edges_end(); ++e)
      {
        const CGAL::Object dual = delaunay.dual(e);
        const auto* const segment = CGAL::object_cast<K::Segment_2>(&dual);
        const auto* const ray = CGAL::object_cast<K::Ray_2>(&dual);
        if (!(segment ? CGAL::do_intersect(*segment, square) : CGAL::do_intersect(*ray, square))) continue;
        const std::size_t i = e->first->vertex(Delaunay::cw(e->second))->info();
        const std::size_t j = e->first->vertex(Delaunay::ccw(e->second))->info();
        expected.insert(std::minmax(i, j));
      }
      for (const auto& c : diagram.curves())
      {
        found.insert(std::minmax(c.source_on_left(), c.source_on_right()));
        for (const auto& p : c.pieces()) CHECK(p.is_segment());
      }
      CHECK(found == expected);
    }
}

void weighted_points()
{
  for (unsigned seed = 1; seed <= 3; ++seed)
    for (const Soup& soup : squares(seed))
    {
      Report::instance().set_context("points with start values, seed " + std::to_string(seed));
      const Planar_mesh mesh(soup, seed);
      Random random(seed);
      std::vector<Site> sites;
      for (std::size_t i = 0; i < 20; ++i)
      {
        const Point_2 p(uniform(random, 0.1, side - 0.1), uniform(random, 0.1, side - 0.1));
        sites.push_back({p, p, uniform(random, 0, 1)});
      }
      check_distances(mesh, diagram_of(mesh, sites), sites, random);
    }
}

// Segments that do not meet, in general position.
std::vector<Site> random_segments(std::size_t number, Random& random)
{
  std::vector<Site> sites;
  while (sites.size() < number)
  {
    const Point_2 p(uniform(random, 0.1, side - 0.1), uniform(random, 0.1, side - 0.1));
    const Point_2 q(p.x() + uniform(random, -1.5, 1.5), p.y() + uniform(random, -1.5, 1.5));
    if (!is_inside(q, 0.1)) continue;
    const CGAL::Segment_2<Kernel> s(p, q);
    bool is_free = true;
    for (const Site& t : sites)
      is_free = is_free && CGAL::to_double(CGAL::squared_distance(s, CGAL::Segment_2<Kernel>(t.a, t.b))) > 0.01;
    if (is_free) sites.push_back({p, q});
  }
  return sites;
}

void segments()
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
  typedef CGAL::Segment_Delaunay_graph_filtered_traits_without_intersections_2<K> Graph_traits;
  typedef CGAL::Segment_Delaunay_graph_2<Graph_traits> Graph;
  for (unsigned seed = 1; seed <= 3; ++seed)
    for (const Soup& soup : squares(seed))
    {
      Report::instance().set_context("segments, seed " + std::to_string(seed));
      const Planar_mesh mesh(soup, seed);
      Random random(seed);
      const std::vector<Site> sites = random_segments(10, random);
      Graph graph;
      for (const Site& s : sites) graph.insert(s.a, s.b);
      const auto source_of = [&](const Graph::Site_2& site) {
        const Point_2 p = site.is_point() ? site.point() : site.source();
        for (std::size_t i = 0; i < sites.size(); ++i)
          if (p == sites[i].a || p == sites[i].b) return i;
        throw std::logic_error("a site of the graph is no end of a segment");
      };
      std::vector<Point_2> expected;
      for (auto f = graph.finite_faces_begin(); f != graph.finite_faces_end(); ++f)
      {
        std::set<std::size_t> sources;
        for (int k = 0; k < 3; ++k) sources.insert(source_of(f->vertex(k)->site()));
        const Point_2 p = graph.primal(f);
        if (sources.size() == 3 && is_inside(p)) expected.push_back(p);
      }
      const Diagram diagram = diagram_of(mesh, sites);
      check_distances(mesh, diagram, sites, random);
      check_vertices(mesh, diagram, expected);
    }
}

void weighted_segments()
{
  for (unsigned seed = 1; seed <= 2; ++seed)
    for (const Soup& soup : squares(seed))
    {
      Report::instance().set_context("segments with start values, seed " + std::to_string(seed));
      const Planar_mesh mesh(soup, seed);
      Random random(seed + 10);
      std::vector<Site> sites = random_segments(10, random);
      for (Site& s : sites) s.start = uniform(random, 0, 0.3);
      const Diagram diagram = diagram_of(mesh, sites);
      check_distances(mesh, diagram, sites, random);
      bool has[3] = {};
      for (const auto& c : diagram.curves())
        for (const auto& p : c.pieces()) has[int(p.kind())] = true;
      CHECK(has[0] && has[1] && has[2]);
    }
}

} // namespace test_voronoi_planar

GEODESIC_OFFSET_TEST(test_voronoi_planar)
{
  const std::pair<const char*, void (*)()> tests[] = {{"points", points},
                                                      {"points with start values", weighted_points},
                                                      {"segments", segments},
                                                      {"segments with start values", weighted_segments}};
  const int result = run_tests("test_voronoi_planar", tests);
  std::cout.precision(3);
  std::cout << totals.diagrams << " diagrams, " << totals.vertices << " vertices, off by at most " << totals.vertex << "; "
            << totals.curves << " curves, " << totals.points << " points, distances differ by at most " << totals.tie << "; "
            << totals.labels << " points of uncrossed faces" << std::endl;
  return result;
}
