// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Points and rays are located on the surface: exactly at a vertex or on an edge if they are there up to round-off, whatever
// face the tree returns, otherwise within round-off. The tree and the search of all faces give the same locations.

#include "data_meshes.h"
#include "generated_meshes.h"
#include "geodesic_types.h"
#include "locations.h"
#include "test_check.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polyhedron_3.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace test_locate {

using namespace test;
typedef Kernel::Ray_3 Ray_3;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
double worst = 0; // distance of located points, relative to the tolerance of the check
std::size_t number_of_queries = 0;

double distance(const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

// Displaces each coordinate by up to 2 units in the last place.
Point_3 perturbed(const Point_3& p, Random& random)
{
  double c[3];
  for (int i = 0; i < 3; ++i)
  {
    c[i] = p[i];
    const int moves = static_cast<int>(uniform_index(random, 5)) - 2;
    for (int k = 0; k < std::abs(moves); ++k) c[i] = std::nextafter(c[i], moves * infinity);
  }
  return Point_3(c[0], c[1], c[2]);
}

template <class TriangleMesh>
class Locate_checker
{
public:
  typedef Geodesic_on<TriangleMesh> Geodesic;
  typedef test::Locations<TriangleMesh> Locations;
  typedef typename Locations::vertex_descriptor vertex_descriptor;
  typedef typename Locations::halfedge_descriptor halfedge_descriptor;
  typedef typename Locations::Face_location Face_location;

  Locate_checker(const std::string& name, const TriangleMesh& mesh, unsigned seed = 1)
    : mesh(mesh), geodesic(mesh), locations(mesh), random_(seed)
  {
    Report::instance().set_context(name);
    for (auto v : vertices(mesh))
    {
      const CGAL::Bbox_3 box = point(v).bbox();
      for (int i = 0; i < 3; ++i) scale_ = (std::max)(scale_, std::abs((box.min)(i)));
    }
    round_off = 1e-12 * bounding_box_diagonal(mesh) + 4 * epsilon * scale_;
  }

  void check_all()
  {
    check_vertices();
    check_edges();
    check_faces();
    check_sources();
  }

  Point_3 point(vertex_descriptor v) const { return get(CGAL::vertex_point, mesh, v); }

  bool is_at(const Face_location& l, vertex_descriptor v) const
  {
    const auto support = locations.support(l);
    return support.size() == 1 && support[0].first == v && support[0].second == 1;
  }
  bool is_on(const Face_location& l, halfedge_descriptor h) const
  {
    const auto s = locations.support(l);
    const vertex_descriptor a = source(h, mesh), b = target(h, mesh);
    return s.size() == 2 && ((s[0].first == a && s[1].first == b) || (s[0].first == b && s[1].first == a));
  }

  // Checks a location of a point.
  void check_near(const Face_location& l, const Point_3& p)
  {
    ++number_of_queries;
    if (!CHECK(l.first != Locations::Graph_traits::null_face())) return;
    double sum = 0;
    for (double w : l.second)
    {
      CHECK(w >= 0 && w <= 1);
      sum += w;
    }
    CHECK_DETAIL(std::abs(sum - 1) <= 2 * epsilon, values(sum, 1));
    const double d = distance(locations.point(l), p);
    worst = (std::max)(worst, d / round_off);
    CHECK_DETAIL(d <= round_off, values(d, 0));
  }

  void check_vertices()
  {
    for (auto v : vertices(mesh))
      for (int i = 0; i < 4; ++i)
      {
        const Point_3 p = i == 0 ? point(v) : perturbed(point(v), random_);
        const Face_location l = geodesic.locate(p);
        check_near(l, p);
        CHECK(is_at(l, v));
      }
  }

  void check_edges()
  {
    for (auto e : edges(mesh))
      for (int i = 0; i < 3; ++i)
      {
        const halfedge_descriptor h = halfedge(e, mesh);
        const double t = i == 0 ? 0.5 : uniform(random_, 0.01, 0.99);
        const Point_3 p = perturbed(CGAL::barycenter(point(source(h, mesh)), 1 - t, point(target(h, mesh)), t), random_);
        const Face_location l = geodesic.locate(p);
        check_near(l, p);
        CHECK(is_on(l, h));
      }
  }

  void check_faces()
  {
    for (auto f : faces(mesh))
    {
      const Point_3 p = locations.point(Face_location(f, random_barycentric(random_, 0.1)));
      check_near(geodesic.locate(p), p);
    }
  }

  // A source at a located vertex is that vertex.
  void check_sources()
  {
    const std::vector<vertex_descriptor> all(vertices(mesh).begin(), vertices(mesh).end());
    for (int i = 0; i < 3; ++i)
    {
      const vertex_descriptor v = all[uniform_index(random_, all.size())];
      geodesic.clear_sources();
      geodesic.add_source_point(geodesic.locate(perturbed(point(v), random_)));
      geodesic.build(CGAL::parameters::distance_limit(1e5 * round_off));
      CHECK(geodesic.distance_to_sources(v) == 0);
      std::size_t zeros = 0;
      for (auto w : all) zeros += geodesic.distance_to_sources(w) == 0 ? 1 : 0;
      CHECK_DETAIL(zeros == 1, std::to_string(zeros) + " zeros");
    }
  }

  const TriangleMesh& mesh;
  Geodesic geodesic;
  Locations locations;
  double round_off;

private:
  double scale_ = 0;
  Random random_;
};

typedef Locate_checker<test::Surface_mesh> Checker;
typedef Generated_mesh<test::Surface_mesh> Mesh_data;
typedef Checker::Face_location Face_location;

Soup moved(Soup soup, double factor, const Vector_3& shift)
{
  for (Point_3& p : soup.points) p = CGAL::ORIGIN + (factor * (p - CGAL::ORIGIN) + shift);
  return soup;
}

// Needles with their long sides in all directions: with the given height over the side, and with a corner over one end.
Soup needles(double height)
{
  Soup soup;
  for (double x : {0., 1.})
    for (double y : {0., height, 1., 1 + height}) soup.points.push_back(Point_3(x, y, 0.3 * x * y));
  soup.points.push_back(Point_3(0.37, height / 2, 0));
  soup.add_triangle({{0, 4, 8}});
  soup.add_triangle({{4, 5, 8}});
  soup.add_triangle({{5, 1, 8}});
  soup.add_triangle({{1, 0, 8}});
  soup.add_triangle({{1, 5, 6}});
  soup.add_triangle({{1, 6, 2}});
  soup.add_triangle({{2, 6, 7}});
  soup.add_triangle({{2, 7, 3}});
  return soup;
}

void generated_meshes()
{
  const std::pair<const char*, Soup> soups[] = {
    {"genus 5", marching_genus_5(12)},
    {"sphere", marching_sphere(12)},
    {"torus", rotated(torus(30, 12), 1)},
    {"saddle", Cone(8, 3 * CGAL_PI, 1).triangulated(30, 4, 2)},
    {"prism", Prism(7, 1, 3).triangulated(30, 4, 1)},
    {"cube", rotated(cube_grid(6), 2)},
    {"jittered grid", jittered_grid(15, 12, 3)},
    {"needle fan", rotated(needle_fan(1000), 3)},
    {"needles 1e-6", rotated(needles(1e-6), 4)},
    {"needles 1e-11", rotated(needles(1e-11), 5)},
    {"far away", moved(marching_genus_5(12), 1, Vector_3(1e6, -1e6, 1e6))},
    {"far away in one direction", moved(icosphere(2), 1, Vector_3(0, 1e6, 0))},
    {"large", moved(rotated(torus(30, 12), 1), 1e9, Vector_3(0, 0, 0))},
    {"tiny", moved(rotated(torus(30, 12), 1), 1e-30, Vector_3(0, 0, 0))}};
  for (const auto& soup : soups)
  {
    const Mesh_data surface_mesh(soup.second);
    Checker(std::string(soup.first) + ", Surface_mesh", surface_mesh.mesh).check_all();
    typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
    const Generated_mesh<Polyhedron> polyhedron(soup.second);
    Locate_checker<Polyhedron>(std::string(soup.first) + ", Polyhedron_3", polyhedron.mesh, 2).check_all();
  }
}

// Meshes without vertices at the same place.
void data_meshes()
{
  std::size_t count = 0;
  for (const char* name :
       {"ALSTOM_TEST4.off", "anchor_dense.off", "eight.off", "elephant.off", "fold.off", "joint.off", "mesh_with_border.off",
        "mpi_triang.off", "oblong.off", "pinion.off", "translated-cube.off", "triceratops.off", "u.off"})
  {
    test::Surface_mesh mesh;
    const std::filesystem::path file = std::filesystem::path(data_directory()) / name;
    if (data_directory().empty() || !std::filesystem::exists(file) || !read_data_mesh(file, 20000, mesh).empty()) continue;
    Checker(name, mesh).check_all();
    ++count;
  }
  std::cout << count << " meshes of the data directory" << std::endl;
}

// All faces are in the plane z = 0, so the nearest element follows from plane distances.
void larger_tolerance()
{
  const Mesh_data data(jittered_grid(9, 7, 2));
  Checker checker("larger tolerance", data.mesh);
  Random random(1);
  const double margin = 1e-9;
  std::size_t kinds[3] = {0, 0, 0};
  for (int i = 0; i < 3000; ++i)
  {
    const double tolerance = uniform(random, 0.01, 0.4), z = i % 2 == 0 ? 0 : uniform(random, -2, 2);
    const Point_3 q(uniform(random, 0, 9), uniform(random, 0, 7), 0), p(q.x(), q.y(), z);
    double to_vertex = infinity, to_edge = infinity, second_edge = infinity;
    test::Surface_mesh::Vertex_index vertex;
    test::Surface_mesh::Edge_index edge;
    for (auto v : vertices(data.mesh))
      if (distance(data.mesh.point(v), q) < to_vertex)
      {
        to_vertex = distance(data.mesh.point(v), q);
        vertex = v;
      }
    for (auto e : edges(data.mesh))
    {
      const Kernel::Segment_3 s(data.mesh.point(data.mesh.vertex(e, 0)), data.mesh.point(data.mesh.vertex(e, 1)));
      const double d = std::sqrt(CGAL::squared_distance(s, q));
      second_edge = (std::min)(second_edge, (std::max)(d, to_edge));
      if (d < to_edge)
      {
        to_edge = d;
        edge = e;
      }
    }
    if (std::abs(to_vertex - tolerance) < margin || std::abs(to_edge - tolerance) < margin || second_edge - to_edge < margin)
      continue;
    const Face_location l = checker.geodesic.locate(p, CGAL::parameters::snapping_tolerance(tolerance));
    const double moved_by = to_vertex < tolerance ? to_vertex : to_edge < tolerance ? to_edge : 0;
    CHECK(std::abs(distance(checker.locations.point(l), q) - moved_by) <= 1e-13);
    if (to_vertex < tolerance) CHECK(checker.is_at(l, vertex));
    else if (to_edge < tolerance) CHECK(checker.is_on(l, data.mesh.halfedge(edge)));
    else CHECK(checker.locations.support(l).size() == 3);
    ++kinds[checker.locations.support(l).size() - 1];
  }
  std::cout << "larger tolerance: " << kinds[0] << " at vertices, " << kinds[1] << " on edges, " << kinds[2] << " in faces"
            << std::endl;
}

// Flat cap, thinner than the round-off of coordinates: a point at its apex is nearest to any of the adjacent faces.
void thin_cap()
{
  Soup soup;
  soup.points = {Point_3(0, 3, 0), Point_3(2, 3, 0), Point_3(1, 3, 1e-17), Point_3(1, 2, 0), Point_3(1, 3, 1)};
  soup.add_triangle({{1, 0, 3}});
  soup.add_triangle({{0, 1, 2}});
  soup.add_triangle({{2, 1, 4}});
  soup.add_triangle({{0, 2, 4}});
  const Mesh_data data(soup);
  const Checker checker("thin cap", data.mesh);
  Random random(1);
  for (int i = 0; i < 100; ++i)
  {
    const Point_3 p = perturbed(Point_3(1, 3, uniform(random, -4, 4) * epsilon), random);
    CHECK(checker.is_at(checker.geodesic.locate(p), data.vertices[2]));
    const double x = uniform(random, 0.1, 0.9);
    const auto support =
      checker.locations.support(checker.geodesic.locate(perturbed(Point_3(x, 3, uniform(random, -4, 4) * epsilon), random)));
    CHECK(support.size() == 2);
  }
}

// Rays at a convex surface, from outside and from its center.
void rays_at_a_sphere()
{
  const Mesh_data data(icosphere(3));
  Checker checker("rays at a sphere", data.mesh);
  const Checker::Geodesic& g = checker.geodesic;
  Random random(1);
  const Point_3 center(0, 0, 0);
  const auto check = [&](const Face_location& l, const Point_3& p, std::size_t support) {
    checker.check_near(l, p);
    CHECK(checker.locations.support(l).size() == support);
  };
  for (auto f : faces(data.mesh))
    for (std::size_t corners = 1; corners <= 3; ++corners) // at a vertex, on an edge, in the face
    {
      Face_location target(f, random_barycentric(random, 0.1));
      if (corners < 3) target.second = {{0.5, 0.5, 0}};
      if (corners < 2) target.second = {{0, 1, 0}};
      const Point_3 p = checker.locations.point(target);
      const Vector_3 outwards = p - center, aside(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
      const double tolerance = 1e-13;
      const Point_3 outside = p + (2 * outwards + aside);
      check(g.locate(Ray_3(center, p), CGAL::parameters::snapping_tolerance(tolerance)).value(), p, corners);
      check(g.locate(Ray_3(outside, p), CGAL::parameters::snapping_tolerance(tolerance)).value(), p, corners);
      CHECK(!g.locate(Ray_3(outside, outwards)));
      if (corners == 3) CHECK(g.locate(Ray_3(outside, p)).value().first == f);
    }
}

// Rays at a plane: crossing it, in it, starting on it.
void rays_at_a_plane()
{
  const Mesh_data data(planar_grid(6, 5, Diagonals::alternating));
  Checker checker("rays at a plane", data.mesh);
  const Checker::Geodesic& g = checker.geodesic;
  Random random(1);
  for (int i = 0; i < 500; ++i)
  {
    const Point_3 p(uniform(random, 0, 6), uniform(random, 0, 5), 0), above = p + Vector_3(0, 0, 2);
    checker.check_near(g.locate(Ray_3(above, Vector_3(0, 0, -1e-3))).value(), p);
    checker.check_near(g.locate(Ray_3(p + Vector_3(10, -20, 100), Vector_3(-1, 2, -10))).value(), p);
    CHECK(!g.locate(Ray_3(above, Vector_3(0, 0, 1))));
    CHECK(!g.locate(Ray_3(above, Vector_3(1, 0, 0))));
    CHECK(!g.locate(Ray_3(Point_3(6.5, p.y(), 1), Vector_3(0, 0, -1))));
    // on it
    for (const Vector_3& d : {Vector_3(0, 0, 1), Vector_3(0.3, -2, -1), Vector_3(1, 0.2, 0)})
      checker.check_near(g.locate(Ray_3(p, d)).value(), p);
    // in it
    checker.check_near(g.locate(Ray_3(Point_3(-2, p.y(), 0), Vector_3(1, 0, 0))).value(), Point_3(0, p.y(), 0));
    checker.check_near(g.locate(Ray_3(Point_3(p.x(), 9, 0), Vector_3(0, -1, 0))).value(), Point_3(p.x(), 5, 0));
    CHECK(!g.locate(Ray_3(Point_3(-2, p.y(), 0), Vector_3(-1, 0, 0))));
  }
  CHECK(checker.is_at(g.locate(Ray_3(Point_3(-2, 0, 0), Vector_3(1, 0, 0))).value(), data.vertices[0]));
  CHECK(checker.is_at(
    g.locate(Ray_3(Point_3(2.01, 3.01, 1), Vector_3(0, 0, -1)), CGAL::parameters::snapping_tolerance(0.02)).value(),
    data.vertices[23]));
}

// Point map with other points. Can be neither default constructed nor assigned.
struct Other_points
{
  typedef test::Surface_mesh::Vertex_index key_type;
  typedef Point_3 value_type;
  typedef const Point_3& reference;
  typedef boost::readable_property_map_tag category;

  explicit Other_points(const std::vector<Point_3>& points) : points(points) {}
  friend const Point_3& get(const Other_points& map, key_type v) { return map.points[v]; }

  const std::vector<Point_3>& points;
};

void custom_point_map()
{
  const Mesh_data data(torus(20, 10)), other(moved(torus(20, 10), 3, Vector_3(5, 6, 7)));
  Checker checker("custom point map", other.mesh);
  std::vector<Point_3> points;
  for (auto v : vertices(other.mesh)) points.push_back(other.mesh.point(v));
  typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, test::Surface_mesh>,
                                             CGAL::Default, CGAL::Default, Other_points>
    With_map;
  const With_map with_map(data.mesh, CGAL::parameters::vertex_point_map(Other_points(points)));
  Random random(1);
  for (auto f : faces(data.mesh))
  {
    const Face_location l(f, random_barycentric(random));
    const Point_3 p = checker.locations.point(l);
    checker.check_near(with_map.locate(p), p);
    CHECK(with_map.locate(p) == checker.geodesic.locate(p));
    const Ray_3 ray(p + Vector_3(0.1, 0.2, 20), p);
    CHECK(with_map.locate(ray) == checker.geodesic.locate(ray));
  }
  for (auto v : vertices(data.mesh)) CHECK(checker.is_at(with_map.locate(perturbed(points[v], random)), v));
}

void isolated_vertex()
{
  const Mesh_data grid(planar_grid(4, 4));
  test::Surface_mesh mesh = grid.mesh;
  mesh.add_vertex(Point_3(1.5, 1.25, 1e-3));
  mesh.add_vertex(Point_3(1e15, 0, 0)); // must not affect the tolerance
  Checker checker("isolated vertex", mesh);
  checker.round_off = 1e-15;
  checker.check_near(checker.geodesic.locate(Point_3(1.5, 1.25, 1e-3)), Point_3(1.5, 1.25, 0));
  checker.check_near(checker.geodesic.locate(Point_3(2.5, 1.5 + 1e-9, 0)), Point_3(2.5, 1.5 + 1e-9, 0));
}

// The locator of the class, once with searches of all faces only, once with the tree only.
template <class TriangleMesh>
class Locators
{
  typedef CGAL::Geodesic_mesh<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, TriangleMesh>> Base;
  typedef CGAL::Geodesic_offset::internal::Mesh_access Access;
  typedef CGAL::Geodesic_offset::internal::Surface_locator<Kernel, double> Locator;

public:
  explicit Locators(const TriangleMesh& mesh)
    : mesh_(mesh), tree_(Access::data(mesh_).unfolded(), Access::data(mesh_).surface())
  {
    tree_.expect(1000000);
  }

  // The location by the tree, which must be that by a search.
  template <class Query>
  auto operator()(const Query& q, double tolerance)
  {
    if (number_of_searches_++ % 50 == 0)
      search_ = std::make_unique<Locator>(Access::data(mesh_).unfolded(), Access::data(mesh_).surface());
    const auto result = tree_.locate(q, tolerance);
    CHECK(search_->locate(q, tolerance) == result);
    return on_mesh(result);
  }
  double default_tolerance() const { return tree_.default_tolerance(); }

private:
  auto on_mesh(const typename Locator::Face_location& l) const { return Access::data(mesh_).surface().location(l); }
  auto on_mesh(const std::optional<typename Locator::Face_location>& l) const
  {
    return l ? std::make_optional(on_mesh(*l)) : std::nullopt;
  }

  Base mesh_;
  Locator tree_;
  std::unique_ptr<Locator> search_; // replaced before it builds a tree
  std::size_t number_of_searches_ = 0;
};

// Many faces are equally near to most of these points.
template <class TriangleMesh>
void check_search_and_tree(const TriangleMesh& mesh, unsigned seed)
{
  Locators<TriangleMesh> locate(mesh);
  const Locations<TriangleMesh> locations(mesh);
  Random random(seed);
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const auto in_box = [&] {
    double c[3];
    for (int i = 0; i < 3; ++i)
      c[i] = uniform(random, 1.5 * (box.min)(i)-0.5 * (box.max)(i), 1.5 * (box.max)(i)-0.5 * (box.min)(i));
    return Point_3(c[0], c[1], c[2]);
  };
  const Point_3 center((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2);
  std::vector<Point_3> points = {center, CGAL::ORIGIN};
  for (auto v : vertices(mesh)) points.push_back(get(CGAL::vertex_point, mesh, v));
  for (auto e : edges(mesh))
  {
    const Point_3 a = get(CGAL::vertex_point, mesh, source(e, mesh)), b = get(CGAL::vertex_point, mesh, target(e, mesh));
    const double t = uniform(random);
    points.push_back(CGAL::midpoint(a, b));
    points.push_back(CGAL::barycenter(a, t, b, 1 - t));
  }
  std::shuffle(points.begin(), points.end(), random);
  points.resize((std::min)(points.size(), std::size_t(300)));
  for (std::size_t i = 0, n = points.size(); i < n; ++i)
  {
    points.push_back(perturbed(points[i], random));
    points.push_back(points[i] + 0.3 * (points[i] - center)); // above a vertex or an edge
  }
  for (int i = 0; i < 100; ++i) points.push_back(in_box());
  for (const Point_3& p : points)
  {
    locate(p, locate.default_tolerance());
    locate(p, 0);
    locate(p, uniform(random) * CGAL::Polygon_mesh_processing::bbox(mesh).x_span());
    locate(Ray_3(center, p + Vector_3(1e-3, 0, 0)), locate.default_tolerance());
    locate(Ray_3(in_box(), p), locate.default_tolerance());
  }
  number_of_queries += 5 * points.size();
}

void search_and_tree()
{
  const Soup once = icosphere(1);
  Soup twice = once; // two sheets in the same place
  const std::size_t n = once.points.size();
  for (const auto& t : once.triangles) twice.add_triangle({{t[0] + n, t[1] + n, t[2] + n}});
  twice.points.insert(twice.points.end(), once.points.begin(), once.points.end());
  const std::pair<const char*, Soup> soups[] = {
    {"genus 5", marching_genus_5(12)},
    {"cube", moved(cube_grid(6), 1, Vector_3(-0.5, -0.5, -0.5))},
    {"turned cube", rotated(cube_grid(6), 2)},
    {"plane", planar_grid(12, 9, Diagonals::alternating)},
    {"two spheres", twice},
    {"needle fan", rotated(needle_fan(300), 3)},
    {"needles 1e-11", rotated(needles(1e-11), 5)},
    {"far away", moved(marching_genus_5(8), 1, Vector_3(1e6, -1e6, 1e6))},
    {"large", moved(rotated(torus(30, 12), 1), 1e9, Vector_3(0, 0, 0))},
    {"tiny", moved(rotated(torus(30, 12), 1), 1e-30, Vector_3(0, 0, 0))}};
  for (const auto& soup : soups)
  {
    Report::instance().set_context(std::string(soup.first) + ", search and tree");
    check_search_and_tree(Mesh_data(soup.second).mesh, 1);
    check_search_and_tree(Generated_mesh<CGAL::Polyhedron_3<Kernel>>(soup.second).mesh, 2);
  }
}

// Distances of points from the surface.
void distances()
{
  Report::instance().set_context("distances");
  const Mesh_data data(planar_grid(6, 5));
  const Geodesic geodesic(data.mesh);
  Random random(1);
  std::vector<Point_3> polyline;
  double largest = 0;
  for (int i = 0; i < 200; ++i)
  {
    const double height = uniform(random, -2, 2);
    const Point_3 p(uniform(random, 0, 6), uniform(random, 0, 5), height);
    const auto located = geodesic.locate_with_distance(p);
    CHECK(located.first == geodesic.locate(p));
    CHECK(std::abs(located.second - std::abs(height)) <= 1e-14);
    polyline.push_back(p);
    largest = (std::max)(largest, std::abs(height));
  }
  CHECK(geodesic.locate_with_distance(Point_3(9, 9, 12)).second == 13);
  CHECK(geodesic.locate_with_distance(Point_3(3, 2, 0)).second == 0);
  CHECK(geodesic.locate_with_distance(Point_3(3.25, 2, 0), CGAL::parameters::snapping_tolerance(0.5)).second == 0.25);
  const auto joined = geodesic.locate_polyline_with_distance(polyline);
  CHECK(joined.first.locations == geodesic.locate_polyline(polyline).locations);
  CHECK(std::abs(joined.second - largest) <= 1e-14);
  CHECK(geodesic.locate_polyline_with_distance(std::vector<Point_3>{Point_3(1, 2, 0)}).second == 0);
  CHECK_THROWS(geodesic.locate_polyline_with_distance(std::vector<Point_3>()), std::invalid_argument);
}

void mean_edge()
{
  for (const Soup& soup : {icosphere(1), planar_grid(3, 2)})
  {
    const Mesh_data data(soup);
    double sum = 0;
    for (const auto h : halfedges(data.mesh))
      if (!is_border(h, data.mesh))
        sum += distance(data.mesh.point(source(h, data.mesh)), data.mesh.point(target(h, data.mesh)));
    const double expected = sum / (3. * double(data.mesh.number_of_faces())),
                 mean = Geodesic(data.mesh).mesh().mean_edge_length();
    CHECK_DETAIL(std::abs(mean - expected) <= 1e-14, values(mean, expected));
  }
  const test::Surface_mesh empty;
  CHECK(Geodesic(empty).mesh().mean_edge_length() == 1);
}

void bad_input()
{
  Report::instance().set_context("bad input");
  const Mesh_data data(icosphere(1));
  const Geodesic geodesic(data.mesh);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Point_3 good(1, 2, 3);
  for (double bad : {nan, infinity, -infinity, 1e300})
    for (int i = 0; i < 3; ++i)
    {
      const Point_3 p(i == 0 ? bad : 0, i == 1 ? bad : 0, i == 2 ? bad : 0);
      CHECK_THROWS(geodesic.locate(p), std::invalid_argument);
      CHECK_THROWS(geodesic.locate(p, CGAL::parameters::snapping_tolerance(1e-3)), std::invalid_argument);
      CHECK_THROWS(geodesic.locate(Ray_3(p, good)), std::invalid_argument);
      CHECK_THROWS(geodesic.locate(Ray_3(good, p - CGAL::ORIGIN)), std::invalid_argument);
    }
  CHECK_THROWS(geodesic.locate(Ray_3(good, good)), std::invalid_argument);
  for (double tolerance : {-1e-30, nan, -infinity})
  {
    CHECK_THROWS(geodesic.locate(good, CGAL::parameters::snapping_tolerance(tolerance)), std::invalid_argument);
    CHECK_THROWS(geodesic.locate(Ray_3(good, Vector_3(1, 0, 0)), CGAL::parameters::snapping_tolerance(tolerance)),
                 std::invalid_argument);
  }

  test::Surface_mesh empty;
  for (int i = 0; i < 2; ++i)
  {
    const Geodesic on_empty(empty);
    for (int k = 0; k < 2; ++k) // again after an exception
    {
      CHECK_THROWS(on_empty.locate(good), std::invalid_argument);
      CHECK_THROWS(on_empty.locate(good, CGAL::parameters::snapping_tolerance(1e-3)), std::invalid_argument);
      CHECK_THROWS(on_empty.locate(Ray_3(good, Vector_3(1, 0, 0))), std::invalid_argument);
    }
    empty.add_vertex(good);
  }
}

} // namespace test_locate

GEODESIC_OFFSET_TEST(test_locate)
{
  std::cout.precision(3);
  const std::pair<const char*, void (*)()> tests[] = {
    {"generated meshes", generated_meshes},
    {data_case, data_meshes},
    {"larger tolerance", larger_tolerance},
    {"thin cap", thin_cap},
    {"rays at a sphere", rays_at_a_sphere},
    {"rays at a plane", rays_at_a_plane},
    {"custom point map", custom_point_map},
    {"isolated vertex", isolated_vertex},
    {"search and tree", search_and_tree},
    {"distances", distances},
    {"mean edge", mean_edge},
    {"bad input", bad_input}};
  const int result = run_tests("test_locate", tests);
  std::cout << number_of_queries << " points located, the worst off by " << worst << " of what is allowed" << std::endl;
  return result;
}
