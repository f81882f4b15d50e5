// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Results do not depend on the order of vertices and faces: a well-ordered mesh is compared with the same mesh shuffled,
// which is large enough for internal renumbering.

#include "generated_meshes.h"
#include "path_tools.h"

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_element_order {

using namespace test;

typedef test::Surface_mesh Mesh;
typedef Mesh::Vertex_index Vertex_index;
typedef Mesh::Halfedge_index Halfedge_index;
typedef Mesh::Face_index Face_index;
typedef Geodesic::Face_location Face_location;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;

constexpr double tolerance = 1e-10; // of lengths; the torus has about the size 1

/// A torus without symmetries, and a point without faces.
Soup bumpy_torus(std::size_t n, std::size_t m)
{
  Soup soup = torus(n, m);
  Random random(5);
  for (Point_3& p : soup.points)
    p = p + Vector_3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)) * 0.004;
  soup.points.push_back(Point_3(3, 3, 3));
  return soup;
}

std::vector<std::size_t> random_order(std::size_t n, unsigned seed)
{
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  Random random(seed);
  for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[uniform_index(random, i)]);
  return order;
}

/// A mesh with its vertices and faces in the order of a soup, or in any order.
struct Ordered_mesh
{
  Ordered_mesh(const Soup& soup, bool shuffled) : vertices(soup.points.size()), faces(soup.triangles.size())
  {
    std::vector<std::size_t> points = random_order(vertices.size(), 1), triangles = random_order(faces.size(), 2);
    if (!shuffled)
      for (auto* order : {&points, &triangles}) std::sort(order->begin(), order->end());
    for (std::size_t i : points) vertices[i] = mesh.add_vertex(soup.points[i]);
    for (std::size_t i : triangles)
    {
      const auto& t = soup.triangles[i];
      faces[i] = mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    }
  }

  /// Location in the triangle by weights of its corners.
  Face_location location(std::size_t triangle, const std::array<double, 3>& weights, const Soup& soup) const
  {
    return Locations<Mesh>(mesh).in_triangle(*this, soup, triangle, weights);
  }

  Mesh mesh;
  std::vector<Vertex_index> vertices; // by the soup's points and triangles
  std::vector<Face_index> faces;
};

/// Access to the flat arrays.
struct Opened : CGAL::Surface_mesh_geodesic_offset<Traits>
{
  using CGAL::Surface_mesh_geodesic_offset<Traits>::Surface_mesh_geodesic_offset;

  const auto& surface() const { return CGAL::Geodesic_offset::internal::Mesh_access::data(this->mesh()).surface(); }

  bool is_renumbered(const ::test_element_order::Mesh& mesh) const
  {
    for (Vertex_index v : mesh.vertices())
      if (this->surface().index_of(v) != v.idx()) return true;
    return false;
  }

  double mean_step() const
  {
    double sum = 0, count = 0;
    for (unsigned h = 0; h < this->surface().unfolded.number_of_halfedges(); ++h)
      if (this->surface().unfolded.twin(h) < h) sum += h / 3 - this->surface().unfolded.twin(h) / 3, ++count;
    return sum / count;
  }
};

struct Queries
{
  Soup soup;
  std::vector<std::pair<std::size_t, std::array<double, 3>>> points; // triangles and weights

  explicit Queries(const Soup& soup) : soup(soup)
  {
    Random random(11);
    for (std::size_t i = 0; i < 300; ++i)
    {
      std::array<double, 3> w{{uniform(random), uniform(random), uniform(random)}};
      if (i % 10 == 0) w[i % 3] = 0;
      const double sum = w[0] + w[1] + w[2];
      for (double& x : w) x /= sum;
      points.push_back({uniform_index(random, soup.triangles.size()), w});
    }
  }
};

template <class Geodesic>
void add_sources(Geodesic& geodesic, const Ordered_mesh& data, const Soup& soup)
{
  geodesic.add_source_point(data.vertices[77]);
  geodesic.add_source_point(data.location(9000, {{0.2, 0.3, 0.5}}, soup));
  geodesic.add_source_polyline(std::vector<Face_location>{data.location(4001, {{0.1, 0.2, 0.7}}, soup),
                                                          data.location(4001, {{0.5, 0.3, 0.2}}, soup)});
  const auto& t = soup.triangles[14000];
  const Halfedge_index h = data.mesh.halfedge(data.vertices[t[0]], data.vertices[t[1]]);
  geodesic.add_source_edges(std::vector<Mesh::Edge_index>{data.mesh.edge(h)});
}

template <class G, class H>
void same_results(const Ordered_mesh& a, const G& g, const Ordered_mesh& b, const H& h, const Queries& queries)
{
  const Soup& soup = queries.soup;
  const auto near = [](double x, double y) { return x == y || std::abs(x - y) <= tolerance; };
  const auto near_points = [](const Point_3& p, const Point_3& q) { return CGAL::squared_distance(p, q) <= 1e-14; };
  std::vector<std::size_t> g_label(soup.points.size()), h_label(soup.points.size());
  g.source_labels(boost::make_iterator_property_map(g_label.begin(), get(boost::vertex_index, a.mesh)));
  h.source_labels(boost::make_iterator_property_map(h_label.begin(), get(boost::vertex_index, b.mesh)));
  for (std::size_t i = 0; i < soup.points.size(); ++i)
  {
    CHECK(near(g.distance_to_sources(a.vertices[i]), h.distance_to_sources(b.vertices[i])));
    CHECK(g_label[a.vertices[i].idx()] == h_label[b.vertices[i].idx()]);
  }

  Path_checker on_a(a.mesh), on_b(b.mesh);
  const auto points = [](const Path_checker& checker, const Path_locations& path) {
    std::vector<Point_3> result;
    for (const Face_location& l : path) result.push_back(checker.point(l));
    return result;
  };
  for (int pass = 0; pass < 3; ++pass) // paths have caches
    for (const auto& q : queries.points)
    {
      const Face_location p = a.location(q.first, q.second, soup), r = b.location(q.first, q.second, soup);
      CHECK(near(g.distance_to_sources(p), h.distance_to_sources(r)));
      CHECK(std::sqrt((g.gradient(p).value_or(CGAL::NULL_VECTOR) - h.gradient(r).value_or(CGAL::NULL_VECTOR)).squared_length()) <
            1e-6);
      const auto m = g.nearest_source(p), n = h.nearest_source(r);
      CHECK(m && n && m->source == n->source);
      const std::vector<Point_3> path = points(on_a, on_a(g, p)), other = points(on_b, on_b(h, r));
      CHECK(std::equal(path.begin(), path.end(), other.begin(), other.end(), near_points));
    }
  CHECK(near(g.largest_distance().value(), h.largest_distance().value()));

  const std::vector<double> levels = {0.05, 0.2, 0.4};
  std::vector<typename G::Offset_curve> g_curves;
  std::vector<typename H::Offset_curve> h_curves;
  g.offset_curves(levels, std::back_inserter(g_curves));
  h.offset_curves(levels, std::back_inserter(h_curves));
  const auto before = [](const auto& c, const auto& d) {
    return c.distance() < d.distance() || (c.distance() == d.distance() && c.length() < d.length());
  };
  std::sort(g_curves.begin(), g_curves.end(), before);
  std::sort(h_curves.begin(), h_curves.end(), before);
  CHECK(!g_curves.empty() && g_curves.size() == h_curves.size());
  for (std::size_t i = 0; i < (std::min)(g_curves.size(), h_curves.size()); ++i)
  {
    CHECK(near(g_curves[i].length(), h_curves[i].length()) && g_curves[i].is_closed() == h_curves[i].is_closed());
    CHECK(g_curves[i].number_of_pieces() == h_curves[i].number_of_pieces());
    for (const auto& piece : h_curves[i].pieces())
    {
      CHECK(piece.start().first == piece.face());
      CHECK(std::abs(h.distance_to_sources(piece.start()) - h_curves[i].distance()) < 1e-9);
    }
  }
}

const Soup& soup()
{
  static const Soup soup = bumpy_torus(140, 70);
  return soup;
}

void renumbered()
{
  const Ordered_mesh good(soup(), false), shuffled(soup(), true);
  const Opened as_it_is(good.mesh), anew(shuffled.mesh);
  CHECK(!as_it_is.is_renumbered(good.mesh));
  CHECK(anew.is_renumbered(shuffled.mesh));
  CHECK(anew.mean_step() < 4 * as_it_is.mean_step());
  const Ordered_mesh small(torus(20, 20), true);
  CHECK(!Opened(small.mesh).is_renumbered(small.mesh));
}

void shuffled_mesh()
{
  const Ordered_mesh good(soup(), false), shuffled(soup(), true);
  Geodesic g(good.mesh), h(shuffled.mesh);
  add_sources(g, good, soup());
  add_sources(h, shuffled, soup());
  g.build(CGAL::parameters::keep_windows(true));
  h.build(CGAL::parameters::keep_windows(true));
  same_results(good, g, shuffled, h, Queries(soup()));
  const Point_3 p(1.2, 0.3, 0.4);
  CHECK(std::abs(g.distance_to_sources(g.locate(p)) - h.distance_to_sources(h.locate(p))) <= tolerance);
}

template <class Function>
std::string message(const Function& f)
{
  try
  {
    f();
  }
  catch (const std::invalid_argument& e)
  {
    return e.what();
  }
  return "";
}

// An ordered mesh with shuffled user indices.
void shuffled_indices()
{
  Ordered_mesh good(soup(), false);
  auto vertex_index = good.mesh.add_property_map<Vertex_index, std::size_t>("v:order").first;
  auto face_index = good.mesh.add_property_map<Face_index, std::size_t>("f:order").first;
  const auto vertices = random_order(good.vertices.size(), 3), faces = random_order(good.faces.size(), 4);
  for (Vertex_index v : good.mesh.vertices()) vertex_index[v] = vertices[v.idx()];
  for (Face_index f : good.mesh.faces()) face_index[f] = faces[f.idx()];
  typedef CGAL::Surface_mesh_geodesic_offset<Traits, decltype(vertex_index), decltype(face_index)> By_user;
  Geodesic g(good.mesh);
  By_user h(good.mesh, CGAL::parameters::face_index_map(face_index).vertex_index_map(vertex_index));
  add_sources(g, good, soup());
  add_sources(h, good, soup());
  g.build(CGAL::parameters::keep_windows(true));
  h.build(CGAL::parameters::keep_windows(true));
  same_results(good, g, good, h, Queries(soup()));
  const std::string text = message([&] { h.distance_to_sources(Face_location(good.faces[123], {{2, -1, 0}})); });
  CHECK_DETAIL(text.find("face " + std::to_string(faces[123]) + " ") != std::string::npos, text);
}

void messages()
{
  const std::string start = "Surface_mesh_geodesic_offset: ";
  Ordered_mesh shuffled(soup(), true);
  const auto name = [&](std::size_t i) { return "face " + std::to_string(shuffled.faces[i].idx()) + " "; };
  {
    Geodesic g(shuffled.mesh);
    const auto text = [&](const Face_location& l) { return message([&] { g.add_source_point(l); }); };
    CHECK(text({shuffled.faces[5], {{2, -1, 0}}}) == start + "a location in " + name(5) + "does not lie in the face");
    const Face_index none(1000000);
    CHECK(text({none, {{0.2, 0.3, 0.5}}}).find("face 1000000 ") != std::string::npos);
    CHECK(message([&] { g.add_source_point(Vertex_index(1000000)); }) ==
          start + "vertex 1000000 is not of this mesh, or is removed");
  }
  // a removed face leaves a gap among the indices
  const Face_index removed = shuffled.faces[600];
  CGAL::Euler::remove_face(shuffled.mesh.halfedge(removed), shuffled.mesh);
  {
    Geodesic g(shuffled.mesh);
    CHECK(message([&] { g.add_source_point(Face_location(removed, {{0.2, 0.3, 0.5}})); }).find(name(600)) != std::string::npos);
    g.add_source_point(shuffled.vertices[77]);
    g.build();
    CHECK(g.distance_to_sources(shuffled.vertices[5000]) < 10);
    CHECK(g.distance_to_sources(shuffled.vertices.back()) == infinity); // without faces
  }
  Ordered_mesh degenerate(soup(), true);
  const auto corners = Locations<Mesh>(degenerate.mesh).corners(degenerate.faces[700]);
  degenerate.mesh.point(corners[0]) = Point_3(0, 0, std::numeric_limits<double>::infinity());
  const std::string text = message([&] { Geodesic g(degenerate.mesh); });
  const auto first = std::find_if(degenerate.mesh.faces().begin(), degenerate.mesh.faces().end(), [&](Face_index f) {
    const auto c = Locations<Mesh>(degenerate.mesh).corners(f);
    return std::find(c.begin(), c.end(), corners[0]) != c.end();
  });
  const std::string number = std::to_string((*first).idx());
  CHECK_DETAIL(text == start + "face " + number +
                         " is degenerate or has a coordinate that is not finite; "
                         "CGAL::remove_degenerate_faces_in_polygon_soup() removes degenerate faces",
               text);
}

void certified_bounds()
{
  const Ordered_mesh shuffled(soup(), true);
  CGAL::Surface_mesh_geodesic_enclosure<Traits> bounds(shuffled.mesh);
  Geodesic g(shuffled.mesh);
  bounds.add_source_point(shuffled.vertices[77]);
  g.add_source_point(shuffled.vertices[77]);
  bounds.build();
  g.build();
  for (Vertex_index v : shuffled.mesh.vertices())
  {
    const auto b = bounds.distance_bounds(v);
    const double d = g.distance_to_sources(v);
    CHECK(d == b.first || (b.first <= d + tolerance && d <= b.second + tolerance));
  }
}

} // namespace test_element_order

GEODESIC_OFFSET_TEST(test_element_order)
{
  const std::vector<std::pair<std::string, void (*)()>> tests = {
    {"renumbered", renumbered},
    {"shuffled mesh", shuffled_mesh},
    {"shuffled indices", shuffled_indices},
    {"messages", messages},
    {"certified bounds", certified_bounds}};
  return run_tests("test_element_order", tests);
}
