// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Properties of every distance on every surface, on the meshes and sources of the search for wrong offsets:
//
// - the distance is 1-Lipschitz, and symmetric;
// - it depends on the surface, not on its faces: dividing faces and edges at exact points and flipping edges in planes
//   changes nothing; neither do rigid motions, beyond the rounding of coordinates; half turns about an axis change no bit;
// - scaling by a power of two scales distances by it, exact to the bit, and curves, which may be divided into other pieces;
// - the distance from several sources is the minimum of the distances from each.
//
// Two further properties have their own tests: renumbering changes nothing (test_element_order), and updates equal builds
// (test_updates).
//
//   test_properties [N [SEED]]     N cases (280) from a seed on (1)

#include "offset_tools.h"
#include "perturbed_meshes.h"
#include "search_cases.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace test_properties {

using namespace test;

// Relative to the distance plus the diagonal of the mesh: some thousand units in the last place.
constexpr double tolerance = 0x1p-40;

struct Totals
{
  std::size_t cases = 0, distances = 0, flips = 0, middles = 0, curves = 0;
  double lipschitz = 0, symmetry = 0, faces = 0, motion = 0, minimum = 0; // largest differences, relative as above
};

class Properties
{
public:
  Properties(unsigned seed, Totals& totals)
    : kind_(Search_meshes::kinds()[seed % Search_meshes::kinds().size()].first), random_(seed), soup_(drawn_soup(seed)),
      data_(soup_), diagonal_(bounding_box_diagonal(data_.mesh)), totals_(totals)
  {
    const Open_geodesic geodesic(data_.mesh);
    for (Search_sources& s : sources_) s = Source_drawing(data_.mesh, geodesic, random_)();
    Report::instance().set_context("seed " + std::to_string(seed) + ", " + kind_ + " of " +
                                   std::to_string(data_.mesh.number_of_faces()) + " faces, " + sources_[0].kind);
  }

  void check()
  {
    ++totals_.cases;
    const Geodesic built = build(data_.mesh, sources_[0]);
    const std::vector<double> distances = of_vertices(built, data_.mesh);
    lipschitz(built);
    symmetric();
    minimum(distances);
    other_faces();
    scaled(built, distances);
    moved(distances);
  }

private:
  // Coordinates with 24 digits, so that midpoints of edges are exact.
  Soup drawn_soup(unsigned seed)
  {
    Soup soup = Search_meshes::kinds()[seed % Search_meshes::kinds().size()].second(random_);
    Soup rounded = soup;
    round_to_float(rounded);
    const Generated_mesh<Surface_mesh> data(rounded);
    for (const auto f : data.mesh.faces())
      if (CGAL::Polygon_mesh_processing::is_degenerate_triangle_face(f, data.mesh)) return soup;
    has_exact_middles_ = true;
    return rounded;
  }

  static Geodesic build(const Surface_mesh& mesh, const Search_sources& sources)
  {
    Geodesic geodesic(mesh);
    sources.add_to(geodesic);
    geodesic.build(CGAL::parameters::keep_windows(true));
    return geodesic;
  }
  static std::vector<double> of_vertices(const Geodesic& geodesic, const Surface_mesh& mesh)
  {
    std::vector<double> result;
    for (const auto v : mesh.vertices()) result.push_back(geodesic.distance_to_sources(v));
    return result;
  }

  // Updates `worst` with the difference.
  bool same(double actual, double expected, double& worst)
  {
    ++totals_.distances;
    if (std::isinf(expected)) return actual == expected;
    const double difference = std::abs(actual - expected) / (expected + diagonal_);
    worst = (std::max)(worst, difference);
    return difference <= tolerance;
  }

  Surface_mesh::Face_index face()
  {
    return Surface_mesh::Face_index(Surface_mesh::size_type(uniform_index(random_, data_.mesh.number_of_faces())));
  }

  void lipschitz(const Geodesic& geodesic)
  {
    const Locations<Surface_mesh> locations(data_.mesh);
    for (int i = 0; i < 40; ++i)
    {
      // two points of a face, or of the edge that contains the first one
      Face_location p(face(), random_barycentric(random_)), q(p.first, random_barycentric(random_));
      if (i % 2 == 0) p.second[0] = q.second[0] = 0;
      for (Face_location* l : {&p, &q})
      {
        const double sum = l->second[0] + l->second[1] + l->second[2];
        for (double& w : l->second) w /= sum;
      }
      const double d = geodesic.distance_to_sources(p), e = geodesic.distance_to_sources(q);
      const double way = std::sqrt(CGAL::squared_distance(locations.point(p), locations.point(q)));
      ++totals_.distances;
      if (!CHECK(std::isfinite(d) == std::isfinite(e)) || !std::isfinite(d)) continue;
      const double excess = (std::abs(d - e) - way) / ((std::max)(d, e) + diagonal_);
      totals_.lipschitz = (std::max)(totals_.lipschitz, excess);
      CHECK_DETAIL(excess <= tolerance, values(std::abs(d - e), way));
    }
  }

  void symmetric()
  {
    const Face_location p(face(), random_barycentric(random_)), q(face(), random_barycentric(random_));
    double there = 0, back = 0;
    for (const bool is_there : {true, false})
    {
      Geodesic geodesic(data_.mesh);
      geodesic.add_source_point(is_there ? p : q);
      geodesic.build(CGAL::parameters::keep_windows(true));
      (is_there ? there : back) = geodesic.distance_to_sources(is_there ? q : p);
    }
    CHECK_DETAIL(same(there, back, totals_.symmetry), values(there, back));
  }

  void minimum(const std::vector<double>& from_first)
  {
    const std::vector<double> from_second = of_vertices(build(data_.mesh, sources_[1]), data_.mesh);
    Geodesic geodesic(data_.mesh);
    for (const Search_sources& s : sources_) s.add_to(geodesic);
    geodesic.build();
    const std::vector<double> from_both = of_vertices(geodesic, data_.mesh);
    for (std::size_t v = 0; v < from_both.size(); ++v)
    {
      const double expected = (std::min)(from_first[v], from_second[v]);
      CHECK_DETAIL(same(from_both[v], expected, totals_.minimum), values(from_both[v], expected));
    }
  }

  // Sources are vertices or the border, which other faces do not change. Compares distances of vertices, and of middles of
  // edges with those of the vertices that divide the edges.
  void other_faces()
  {
    if (!has_exact_middles_) return;
    const bool from_border = uniform(random_) < 0.2 && has_border(data_.mesh);
    std::vector<Surface_mesh::Vertex_index> vertices;
    for (int i = 0; i < 2; ++i) vertices.push_back(data_.mesh.source(data_.mesh.halfedge(face())));
    const auto built = [&](const Surface_mesh& mesh) {
      Geodesic geodesic(mesh);
      if (from_border)
      {
        std::vector<Surface_mesh::Edge_index> border;
        for (const auto e : mesh.edges())
          if (mesh.is_border(e)) border.push_back(e);
        geodesic.add_source_edges(border);
      }
      else
        for (const auto v : vertices) geodesic.add_source_point(v);
      geodesic.build(CGAL::parameters::keep_windows(true));
      return geodesic;
    };
    const Geodesic geodesic = built(data_.mesh);
    std::vector<double> expected = of_vertices(geodesic, data_.mesh);
    const std::size_t vertices_before = expected.size();
    const Locations<Surface_mesh> locations(data_.mesh);
    for (const double part : {0., 0.3}) // only flips; flips and divided edges
    {
      Surface_mesh mesh = data_.mesh;
      std::vector<Surface_mesh::Edge_index> divided;
      totals_.flips += retriangulate(mesh, random_, part, true, &divided);
      expected.resize(vertices_before);
      for (const auto e : divided)
      {
        const auto h = data_.mesh.halfedge(e), side = data_.mesh.is_border(h) ? data_.mesh.opposite(h) : h;
        expected.push_back(geodesic.distance_to_sources(locations.on_edge(side, 0.5)));
      }
      totals_.middles += divided.size();
      const std::vector<double> actual = of_vertices(built(mesh), mesh);
      if (!CHECK(actual.size() == expected.size())) continue;
      for (std::size_t v = 0; v < expected.size(); ++v)
        CHECK_DETAIL(same(actual[v], expected[v], totals_.faces), values(actual[v], expected[v]));
    }
  }

  static bool has_border(const Surface_mesh& mesh)
  {
    for (const auto e : mesh.edges())
      if (mesh.is_border(e)) return true;
    return false;
  }

  void scaled(const Geodesic& geodesic, const std::vector<double>& distances)
  {
    double largest = 0;
    for (const double d : distances)
      if (std::isfinite(d)) largest = (std::max)(largest, d);
    const double level = uniform(random_, 0.05, 0.95) * largest;
    const Offset_curves curves = level > 0 ? offsets(geodesic, level) : Offset_curves();
    for (const int exponent : {-32, 2, 40})
    {
      const double factor = std::ldexp(1, exponent);
      Soup soup = soup_;
      for (Point_3& p : soup.points) p = Point_3(factor * p.x(), factor * p.y(), factor * p.z());
      const Generated_mesh<Surface_mesh> data(soup);
      const Geodesic other = build(data.mesh, sources_[0]);
      const std::vector<double> actual = of_vertices(other, data.mesh);
      for (std::size_t v = 0; v < actual.size(); ++v)
        CHECK_DETAIL(actual[v] == factor * distances[v], values(actual[v], factor * distances[v]));
      if (!(level > 0)) continue;
      const Offset_curves other_curves = offsets(other, factor * level);
      totals_.curves += curves.size();
      CHECK_DETAIL(other_curves.size() == curves.size(), values(double(other_curves.size()), double(curves.size())));
      const double length = total_length(curves), other_length = total_length(other_curves) / factor;
      CHECK_DETAIL(std::abs(other_length - length) <= Search_tolerances::length * (length + diagonal_),
                   values(other_length, length));
    }
  }

  void moved(const std::vector<double>& distances)
  {
    Soup turned = soup_; // a half turn about an axis
    for (Point_3& p : turned.points) p = Point_3(-p.x(), p.y(), -p.z());
    const Generated_mesh<Surface_mesh> half_turn(turned);
    CHECK(of_vertices(build(half_turn.mesh, sources_[0]), half_turn.mesh) == distances);

    // Rounding displaces points by more than the height of a needle.
    if (kind_ == "needles" || kind_ == "strip" || kind_ == "tiny faces") return;
    const Generated_mesh<Surface_mesh> anywhere(rotated(soup_, unsigned(random_())));
    const std::vector<double> actual = of_vertices(build(anywhere.mesh, sources_[0]), anywhere.mesh);
    for (std::size_t v = 0; v < actual.size(); ++v)
      CHECK_DETAIL(same(actual[v], distances[v], totals_.motion), values(actual[v], distances[v]));
  }

  const std::string kind_;
  Random random_;
  bool has_exact_middles_ = false;
  const Soup soup_;
  const Generated_mesh<Surface_mesh> data_;
  const double diagonal_;
  Search_sources sources_[2];
  Totals& totals_;
};

// A saddle vertex on the opposite side of its face, as far as doubles can resolve: its rays through this side have no
// window, and points in the next face are reached around the ends of the two windows that meet at the vertex.
void flat_cap()
{
  Report::instance().set_context("a flat cap");
  const double c = std::cos(75 * CGAL_PI / 180), y = (c + c / 2) / std::sqrt(0.75);
  Soup soup;
  for (const Point_3& p : {Point_3(0, 0, 0), Point_3(-1, -1e-17, 0), Point_3(1, -1e-17, 0), Point_3(0, -1, 0),
                           Point_3(-0.5, std::sqrt(0.75), 0), Point_3(c, y, std::sqrt(1 - c * c - y * y))})
    soup.points.push_back(p);
  for (const auto& t : std::vector<std::array<std::size_t, 3>>{{1, 2, 0}, {1, 3, 2}, {0, 4, 1}, {0, 5, 4}, {0, 2, 5}})
    soup.add_triangle(t);
  const Generated_mesh<Surface_mesh> data(soup);
  Geodesic geodesic(data.mesh);
  geodesic.add_source_point(data.vertices[4]);
  geodesic.build(CGAL::parameters::keep_windows(true));
  // the shadow is between the directions of 300 and 330 degrees
  for (const double degrees : {295., 299., 301., 310., 315., 320., 329., 331., 340.})
  {
    const double x = 0.3 * std::cos(degrees * CGAL_PI / 180), y = 0.3 * std::sin(degrees * CGAL_PI / 180);
    Face_location p(data.faces[1], {{0, 0, 0}});
    const auto corners = Locations<Surface_mesh>(data.mesh).corners(p.first);
    for (std::size_t k = 0; k < 3; ++k) // of the points (-1, 0), (0, -1), (1, 0)
      p.second[k] = corners[k] == data.vertices[3] ? -y : (1 + y + (corners[k] == data.vertices[2] ? x : -x)) / 2;
    const double angle = degrees < 300 ? degrees - 120 : degrees > 330 ? 510 - degrees : 180; // seen from the vertex
    const double expected = std::sqrt(1 + 0.09 - 0.6 * std::cos(angle * CGAL_PI / 180));
    const double d = geodesic.distance_to_sources(p);
    CHECK_DETAIL(std::abs(d - expected) < 1e-14, std::to_string(degrees) + " degrees: " + values(d, expected));
  }
}

} // namespace test_properties

GEODESIC_OFFSET_TEST(test_properties)
{
  const unsigned cases = argc > 1 ? unsigned(std::stoul(argv[1])) : 280, first = argc > 2 ? unsigned(std::stoul(argv[2])) : 1;
  flat_cap();
  Totals totals;
  for (unsigned seed = first; seed < first + cases; ++seed) try
    {
      Properties(seed, totals).check();
    }
    catch (const std::exception& e)
    {
      CHECK_DETAIL(!"an exception was thrown", "seed " + std::to_string(seed) + ": " + e.what());
    }
  std::cout.precision(2);
  std::cout << totals.cases << " cases, " << totals.distances << " distances, " << totals.flips << " flips, " << totals.middles
            << " divided edges, " << totals.curves
            << " curves; largest differences, in distances plus diagonals: steeper than 1-Lipschitz " << totals.lipschitz
            << ", asymmetric " << totals.symmetry << ", other faces " << totals.faces << ", rigid motion " << totals.motion
            << ", minimum of sources " << totals.minimum << std::endl;
  CHECK(cases < 100 || (totals.flips > 1000 && totals.middles > 1000 && totals.curves > 100));
  return Report::instance().finish("test_properties");
}
