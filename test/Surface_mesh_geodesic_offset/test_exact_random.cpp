// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The exact level against the double level on about a hundred meshes of 20 to 200 faces: planar, symmetric, needle-faced,
// closed and open, also rotated, so that coplanarity and symmetry hold only up to rounding. Distances agree to 1e-13; paths
// cross the same edges and pass the same vertices if they are unique. Certified bounds contain the exact distances.

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "path_tools.h"
#include "test_check.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_geodesic_offset/Radical_numbers.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace test_exact_random {

using namespace test;

// The number type of computations with Exact_predicates_exact_constructions_kernel_with_sqrt.
typedef CGAL::Radical_number Radical_number;
typedef CGAL::Surface_mesh_geodesic_offset<
  CGAL::Surface_mesh_geodesic_offset_traits<CGAL::Simple_cartesian<Radical_number>, test::Surface_mesh>>
  Exact_geodesic;
typedef CGAL::Surface_mesh_geodesic_enclosure<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, test::Surface_mesh>> Enclosure;
typedef Generated_mesh<test::Surface_mesh> Data;

struct Totals
{
  std::size_t meshes = 0, distances = 0, paths = 0, unique_paths = 0, exact_windows = 0, windows = 0;
  std::size_t signs = 0, exact_signs = 0; // decided in builds
  double worst = 0, slowest = 0;
  std::string slowest_name;
  std::vector<double> widths; // of certified bounds, relative
};

// Edges and vertices on a path after its start, and the smallest parameter distance of its edge crossings from a vertex.
struct Sequence
{
  explicit Sequence(const test::Surface_mesh& mesh) : mesh(mesh) {}

  template <class Number>
  void operator()(Halfedge_index h, const Number& t)
  {
    const double x = CGAL::to_double(t);
    nearest = (std::min)({nearest, x, 1 - x});
    items.push_back(1 + 2 * static_cast<std::size_t>(mesh.edge(h)));
  }
  void operator()(Vertex_index v)
  {
    items.push_back(2 * static_cast<std::size_t>(v));
    vertices.push_back(v);
  }
  template <class Number>
  void operator()(Face_index, const std::array<Number, 3>&)
  {
  }

  const test::Surface_mesh& mesh;
  std::vector<std::size_t> items;
  std::vector<Vertex_index> vertices;
  double nearest = 1; // parameter
};

std::array<Radical_number, 3> exact(const std::array<double, 3>& w)
{
  return {{Radical_number(w[0]), Radical_number(w[1]), Radical_number(w[2])}};
}

class Comparison
{
public:
  Comparison(const std::string& name, const Soup& soup, unsigned seed, Totals& totals)
    : name_(name), data_(soup), locations_(data_.mesh), random_(seed), totals_(totals),
      scale_(bounding_box_diagonal(data_.mesh))
  {
  }

  void run()
  {
    Report::instance().set_context(name_);
    CHECK(num_faces(data_.mesh) >= 20 && num_faces(data_.mesh) <= 200);
    const auto start = std::chrono::steady_clock::now();
    Exact_geodesic exact_level(data_.mesh);
    Geodesic double_level(data_.mesh);
    Enclosure enclosure(data_.mesh);
    add_sources(exact_level, double_level, enclosure);
    exact_level.build();
    enclosure.build();
    check_bounds(exact_level, enclosure);
    double_level.build(CGAL::parameters::keep_windows(true));
    const auto& statistics = exact_level.statistics();
    totals_.exact_windows += statistics.windows_propagated;
    CHECK(statistics.sign_decisions > 0 && statistics.exact_decisions <= statistics.sign_decisions);
    totals_.signs += statistics.sign_decisions;
    totals_.exact_signs += statistics.exact_decisions;
    totals_.windows += double_level.statistics().windows_propagated;
    compare_distances(exact_level, double_level);
    compare_paths(exact_level, double_level);
    ++totals_.meshes;
    const double time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (time > totals_.slowest)
    {
      totals_.slowest = time;
      totals_.slowest_name = name_;
    }
  }

private:
  // Adds a vertex, a point on an edge or in a face, a segment in a face, an edge, or a vertex and a point.
  void add_sources(Exact_geodesic& exact_level, Geodesic& double_level, Enclosure& enclosure)
  {
    const std::size_t kind = uniform_index(random_, 6);
    const auto add_point = [&](std::size_t where) {
      const Face_location l = random_location(locations_, data_.mesh, random_, where);
      double_level.add_source_point(l);
      enclosure.add_source_point(l);
      exact_level.add_source_point({l.first, exact(l.second)});
    };
    if (kind == 3)
    {
      const Face_location a = random_location(locations_, data_.mesh, random_, 0);
      const Face_location b(a.first, random_barycentric(random_));
      double_level.add_source_polyline(std::vector<Face_location>{a, b});
      enclosure.add_source_polyline(std::vector<Face_location>{a, b});
      exact_level.add_source_polyline(std::vector<Exact_geodesic::Face_location>{{a.first, exact(a.second)},
                                                                                 {b.first, exact(b.second)}});
    }
    else if (kind == 4)
    {
      const Halfedge_index h = halfedge(random_face(data_.mesh, random_), data_.mesh);
      const std::vector<Surface_mesh::Edge_index> edge{data_.mesh.edge(h)};
      double_level.add_source_edges(edge);
      enclosure.add_source_edges(edge);
      exact_level.add_source_edges(edge);
    }
    else if (kind == 5)
      for (std::size_t where : {2, 0}) add_point(where);
    else add_point(2 - kind);
  }

  void check_bounds(const Exact_geodesic& exact_level, const Enclosure& enclosure)
  {
    for (Vertex_index v : data_.vertices)
    {
      const auto bounds = enclosure.distance_bounds(v);
      const Radical_number d = exact_level.distance_to_sources(v);
      CHECK(!(d < Radical_number(bounds.first)));
      CHECK(!(Radical_number(bounds.second) < d));
      if (bounds.second > 0) totals_.widths.push_back((bounds.second - bounds.first) / bounds.second);
    }
  }

  void compare_distances(const Exact_geodesic& exact_level, const Geodesic& double_level)
  {
    Worst_error worst(1e-13, scale_);
    for (Vertex_index v : data_.vertices)
    {
      CHECK_CLOSE(worst, double_level.distance_to_sources(v), CGAL::to_double(exact_level.distance_to_sources(v)));
      ++totals_.distances;
    }
    totals_.worst = (std::max)(totals_.worst, worst.error());
  }

  void compare_paths(const Exact_geodesic& exact_level, const Geodesic& double_level)
  {
    for (int i = 0; i < 12; ++i)
    {
      const Vertex_index v = data_.vertices[uniform_index(random_, data_.vertices.size())];
      Sequence by_double(data_.mesh), exactly(data_.mesh);
      double_level.shortest_path_sequence_to_sources(v, by_double);
      exact_level.shortest_path_sequence_to_sources(v, exactly);
      ++totals_.paths;
      // the side on which a path passes a vertex within rounding is not compared
      if ((std::min)(by_double.nearest, exactly.nearest) < 1e-7) continue;
      bool is_unique = true;
      for (Vertex_index w : by_double.vertices) is_unique = is_unique && has_one_path(w, double_level);
      if (!is_unique) continue;
      ++totals_.unique_paths;
      CHECK_DETAIL(by_double.items == exactly.items, "path from vertex " + std::to_string(std::size_t(v)));
    }
  }

  // Whether the distance from a vertex decreases at full rate in one direction only, tested at nearby points: then the
  // directions in which it decreases at nearly full rate form one angle, which is not too wide.
  bool has_one_path(Vertex_index v, const Geodesic& double_level)
  {
    const double d = double_level.distance_to_sources(v);
    if (d == 0) return true;
    const int n = 1024;
    const double rate = 0.99999, widest = 1.4 * 2 * std::acos(rate);
    double angle = 0;
    std::vector<char> descends;
    bool is_closed = true;
    // around the vertex, from the border if there is one
    Halfedge_index first = halfedge(v, data_.mesh);
    double shortest = scale_;
    for (Halfedge_index h : CGAL::halfedges_around_target(v, data_.mesh))
    {
      shortest = (std::min)(shortest, length_of(h));
      if (!is_border(h, data_.mesh)) continue;
      first = h;
      is_closed = false;
    }
    const double step = 1e-6 * (std::min)(shortest, d);
    Halfedge_index h = first;
    do {
      const Halfedge_index g = next(h, data_.mesh);
      if (!is_border(h, data_.mesh))
      {
        const Vector_3 a = unit(data_.mesh.point(source(h, data_.mesh)) - data_.mesh.point(v)),
                       b = unit(data_.mesh.point(target(g, data_.mesh)) - data_.mesh.point(v));
        const double cosine = a * b, sine = std::sqrt(CGAL::cross_product(a, b).squared_length()),
                     corner = std::atan2(sine, cosine);
        for (int k = 0; k <= n; ++k)
        {
          const double turn = corner * k / n, along_b = std::sin(turn) / sine;
          const double to_a = step * (std::cos(turn) - along_b * cosine) / length_of(h);
          const double to_b = step * along_b / length_of(g);
          if (!(to_a + to_b < 1e-3)) return false; // the corner is too flat
          Face_location near_v(face(h, data_.mesh), {{0, 0, 0}});
          const auto corners = locations_.corners(near_v.first);
          for (std::size_t i = 0; i < 3; ++i)
            near_v.second[i] = corners[i] == v ? 1 - to_a - to_b : corners[i] == source(h, data_.mesh) ? to_a : to_b;
          descends.push_back(double_level.distance_to_sources(near_v) < d - rate * step);
          if (descends.back()) angle += corner / n;
        }
      }
      h = opposite(g, data_.mesh);
    } while (h != first);
    std::size_t runs = 0;
    for (std::size_t i = 0; i < descends.size(); ++i)
      if (descends[i] && !(i > 0 ? descends[i - 1] : (is_closed && descends.back()))) ++runs;
    return runs == 1 && angle <= widest;
  }

  double length_of(Halfedge_index h) const
  {
    return distance(data_.mesh.point(source(h, data_.mesh)), data_.mesh.point(target(h, data_.mesh)));
  }

  std::string name_;
  Data data_;
  Mesh_locations locations_;
  Random random_;
  Totals& totals_;
  double scale_;
};

// A height field over random points of the unit square.
Soup terrain(std::size_t points_inside, unsigned seed, double height)
{
  Soup soup = random_rectangle(1, 1, points_inside, 3, seed);
  Random random(seed);
  for (Point_3& p : soup.points) p = Point_3(p.x(), p.y(), uniform(random, 0, height));
  return soup;
}

Soup subdivided_octahedron(std::size_t n)
{
  Soup soup = cube_grid(n);
  for (Point_3& p : soup.points)
  {
    const double x = 2 * p.x() - 1, y = 2 * p.y() - 1, z = 2 * p.z() - 1;
    const double sum = std::abs(x) + std::abs(y) + std::abs(z);
    p = Point_3(x / sum, y / sum, z / sum);
  }
  return soup;
}

} // namespace test_exact_random

GEODESIC_OFFSET_TEST(test_exact_random)
{
  const bool is_verbose = argc > 1;
  Totals totals;
  CGAL::Radical_numbers::internal::Radical_sign::counts().reset();
  const auto compare = [&](const std::string& name, const Soup& soup, unsigned seed) {
    for (bool is_rotated : {false, true})
    {
      if (is_verbose) std::cout << name << (is_rotated ? ", rotated" : "") << std::flush;
      const auto start = std::chrono::steady_clock::now();
      guarded([&] {
        Comparison(name + " " + std::to_string(seed) + (is_rotated ? ", rotated" : ""), is_rotated ? rotated(soup, seed) : soup,
                   seed, totals)
          .run();
      });
      if (is_verbose)
        std::cout << ": " << std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() << " s"
                  << std::endl;
    }
  };
  const unsigned step = number_of_cases(4u, 1u); // of the seeds, since meshes grow with them
  for (unsigned seed = 1; seed <= 8; seed += step)
  {
    compare("rectangle", random_rectangle(2, 1, 10 + 5 * seed, 3, seed), seed);
    compare("needles", random_rectangle(1, 1e-4, 12 + 2 * seed, 2, seed), seed);
    compare("finer needles", random_rectangle(1, 1e-6, 12, 2 + seed / 2, seed), seed);
    compare("jittered grid", jittered_grid(3 + seed / 3, 4 + seed / 2, seed), seed);
    compare("regular grid", planar_grid(3 + seed / 2, 4 + seed / 3), seed);
    compare("alternating grid", planar_grid(3 + seed / 2, 4, Diagonals::alternating, 0.1), seed);
    compare("needle fan", needle_fan(18 + 10 * seed), seed);
    compare("L", l_shape(2 + seed / 2, 2, seed), seed);
    compare("box", box_sides(1, 0.75, 0.5).triangulated(1 + seed / 3, 1 + seed / 4, seed), seed);
    compare("slab", box_sides(3, 2, 0.0625).triangulated(1 + seed / 3, 1, seed), seed);
    compare("cube", cube_grid(2 + seed % 3), seed);
    compare("octahedron", subdivided_octahedron(2 + seed % 2), seed);
    compare("tetrahedron", tetrahedron_sides().triangulated(2 + seed, 1, seed), seed);
    compare("prism", Prism(3 + seed, 0.5, 1.5).triangulated(1 + seed / 4, 1, seed), seed);
    compare("cone", Cone(8, 1.5 * CGAL_PI, 1).triangulated(1 + seed / 4, 1, seed), seed);
    compare("saddle cone", Cone(8, 2.5 * CGAL_PI, 1).triangulated(1 + seed / 4, 1, seed), seed);
    compare("saddle fan", saddle_fan(10 + seed), seed);
    compare("torus", torus(4 + seed, 4 + seed / 2), seed);
    compare("terrain", terrain(10 + 4 * seed, seed, 0.5), seed);
    compare("steep terrain", terrain(10 + 4 * seed, seed, 3), seed);
  }
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    compare("icosahedron", icosphere(0), seed);
    compare("icosphere", icosphere(1), seed);
    compare("marching sphere", marching_sphere(4), seed);
  }
  CHECK(totals.meshes >= 300 / step);
  CHECK(2 * totals.unique_paths > totals.paths);
  const auto& counts = CGAL::Radical_numbers::internal::Radical_sign::counts();
  std::cout << totals.meshes << " meshes, " << totals.distances << " distances, worst relative difference " << totals.worst
            << "; " << totals.paths << " paths, " << totals.unique_paths << " unique; windows " << totals.exact_windows
            << " exactly, " << totals.windows << " in doubles\nsigns in builds " << totals.signs << ", exactly decided "
            << totals.exact_signs << "; with paths and comparisons: signs by identity " << counts.by_identity << ", by doubles "
            << counts.by_doubles << ", by more bits " << counts.by_precision << ", exactly zero " << counts.exactly_zero
            << ", exactly not zero " << counts.exactly_not_zero << ", by high precision " << counts.by_high_precision
            << ", by root bound " << counts.by_root_bound << ", by CORE " << counts.by_core
            << "\nslowest: " << totals.slowest_name << ", " << totals.slowest << " s" << std::endl;
  std::sort(totals.widths.begin(), totals.widths.end());
  const double median = totals.widths[totals.widths.size() / 2];
  std::cout << "certified bounds: relative width " << median << " in the median, at most " << totals.widths.back() << std::endl;
  CHECK(median <= 1e-13);
  return Report::instance().finish("test_exact_random");
}
