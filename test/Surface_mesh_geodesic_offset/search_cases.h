// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes, sources and levels for which cutting offsets is difficult: ties, noise far below the size of the faces, needles,
// levels within rounding of events. A seed determines each.

#ifndef GEODESIC_OFFSET_TEST_SEARCH_CASES_H
#define GEODESIC_OFFSET_TEST_SEARCH_CASES_H

#include "field_features.h"
#include "generated_meshes.h"
#include "locations.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// Log-uniform number, between two powers of 10.
inline double log_uniform(Random& random, double low, double high) { return std::pow(10, uniform(random, low, high)); }

/// Displaces all points by up to `noise` in each coordinate of which `along` is true.
inline void add_noise(Soup& soup, Random& random, double noise, std::array<bool, 3> along)
{
  for (Point_3& p : soup.points)
  {
    double x[3];
    for (int i = 0; i < 3; ++i) x[i] = p[i] + (along[std::size_t(i)] ? noise * uniform(random, -1, 1) : 0);
    p = Point_3(x[0], x[1], x[2]);
  }
}

/// Rounds coordinates to single precision, as in some files.
inline void round_to_float(Soup& soup)
{
  // volatile: g++ 12 with -O2 omits conversions to float and back when it vectorizes
  const auto rounded = [](double x) {
    const volatile float result = static_cast<float>(x);
    return double(result);
  };
  for (Point_3& p : soup.points) p = Point_3(rounded(p.x()), rounded(p.y()), rounded(p.z()));
}

/// Tube of n flat sides and m rows of height `height`, open at both ends.
inline Soup tube(std::size_t n, std::size_t m, double radius, double height)
{
  Soup soup;
  for (std::size_t j = 0; j <= m; ++j)
    for (std::size_t i = 0; i < n; ++i)
    {
      const double a = 2 * CGAL_PI * double(i) / double(n);
      soup.points.push_back(Point_3(radius * std::cos(a), radius * std::sin(a), height * double(j)));
    }
  for (std::size_t j = 0; j < m; ++j)
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::size_t a = j * n + i, b = j * n + (i + 1) % n, c = b + n, d = a + n;
      soup.add_triangle({{a, b, c}});
      soup.add_triangle({{a, c, d}});
    }
  return soup;
}

/// Multiplies each coordinate by a number within 1e-15 to 1e-7 of 1: edges of a grid then tie up to rounding.
inline void jitter(Soup& soup, Random& random)
{
  const double size = log_uniform(random, -15, -7);
  const auto moved = [&](double x) { return x * (1 + size * uniform(random, -1, 1)); };
  for (Point_3& p : soup.points)
  {
    const double x = moved(p.x()), y = moved(p.y());
    p = Point_3(x, y, moved(p.z()));
  }
}

/// Meshes of the search, by kind.
class Search_meshes
{
public:
  typedef std::function<Soup(Random&)> Maker;

  static const std::vector<std::pair<std::string, Maker>>& kinds()
  {
    static const std::vector<std::pair<std::string, Maker>> all = {
      {"noisy grid", noisy_grid},
      {"float grid", float_grid},
      {"near-flat grid", near_flat_grid},
      {"rectangle", rectangle},
      {"torus", a_torus},
      {"cylinder", cylinder},
      {"cube", cube},
      {"box", box},
      {"sphere", sphere},
      {"strip", strip},
      {"needles", needles},
      {"cone", cone},
      {"few faces", few_faces},
      {"tiny faces", tiny_faces}};
    return all;
  }

private:
  static std::size_t between(Random& random, std::size_t low, std::size_t high)
  {
    return low + uniform_index(random, high - low + 1);
  }
  static bool chance(Random& random, double p) { return uniform(random) < p; }
  static unsigned seed(Random& random) { return static_cast<unsigned>(random() % 1000000); }

  static Diagonals diagonals(Random& random)
  {
    static const Diagonals all[] = {Diagonals::forward, Diagonals::backward, Diagonals::alternating, Diagonals::random};
    return all[uniform_index(random, 4)];
  }

  static Soup grid(Random& random, double jitter = 0)
  {
    const std::size_t n = between(random, 2, 12), m = between(random, 2, 12);
    const double side = chance(random, 0.7) ? 1 : uniform(random, 0.2, 2);
    return planar_grid(n, m, diagonals(random), side, jitter, seed(random));
  }

  // Noise of 1e-9 to 1e-3 with probability p, in all directions.
  static Soup noisy(Random& random, Soup soup, double p)
  {
    if (chance(random, p)) add_noise(soup, random, log_uniform(random, -9, -3), {{true, true, true}});
    return soup;
  }
  static Soup turned(Random& random, Soup soup, double p)
  {
    if (chance(random, p)) soup = rotated(std::move(soup), seed(random));
    return soup;
  }
  static Soup as_float(Random& random, Soup soup, double p)
  {
    if (chance(random, p)) round_to_float(soup);
    return soup;
  }

  static Soup noisy_grid(Random& random)
  {
    Soup soup = grid(random);
    const bool in_plane = chance(random, 0.3);
    add_noise(soup, random, log_uniform(random, -9, -3), {{in_plane, in_plane, true}});
    return soup;
  }
  static Soup float_grid(Random& random)
  {
    Soup soup = rotated(grid(random), seed(random));
    round_to_float(soup);
    return soup;
  }
  static Soup near_flat_grid(Random& random)
  {
    Soup soup = grid(random, chance(random, 0.5) ? 0.24 : 0);
    // a bend along lines, or a paraboloid
    const double slope = log_uniform(random, -8, -1);
    const bool is_round = chance(random, 0.5);
    for (Point_3& p : soup.points)
      p = Point_3(p.x(), p.y(), slope * (is_round ? (p.x() * p.x() + p.y() * p.y()) / 10 : std::abs(p.x() - 3)));
    return turned(random, std::move(soup), 0.3);
  }
  static Soup rectangle(Random& random)
  {
    const Soup soup =
      random_rectangle(6, chance(random, 0.5) ? 4 : 6, between(random, 0, 80), between(random, 0, 4), seed(random));
    return as_float(random, turned(random, noisy(random, soup, 0.3), 0.5), 0.3);
  }
  static Soup a_torus(Random& random)
  {
    const Soup soup = torus(between(random, 3, 14), between(random, 3, 12), 1, uniform(random, 0.2, 0.6));
    return as_float(random, turned(random, noisy(random, soup, 0.3), 0.3), 0.3);
  }
  static Soup cylinder(Random& random)
  {
    const std::size_t n = between(random, 3, 14);
    const Soup soup = chance(random, 0.6)
                      ? tube(n, between(random, 1, 10), 1, chance(random, 0.5) ? 0.5 : 2)
                      : Prism(n, 1, 3).triangulated(between(random, 0, 10), between(random, 0, 3), seed(random));
    return as_float(random, turned(random, noisy(random, soup, 0.3), 0.3), 0.3);
  }
  static Soup cube(Random& random)
  {
    const Soup soup = cube_grid(between(random, 1, 5));
    return as_float(random, turned(random, noisy(random, soup, 0.3), 0.4), 0.3);
  }
  static Soup box(Random& random)
  {
    const Soup soup = box_sides(1, double(between(random, 1, 3)), double(between(random, 1, 4)) / 2)
                        .triangulated(between(random, 0, 10), between(random, 0, 3), seed(random));
    return as_float(random, turned(random, noisy(random, soup, 0.3), 0.4), 0.3);
  }
  static Soup sphere(Random& random)
  {
    const Soup soup = icosphere(between(random, 0, 2));
    return as_float(random, turned(random, noisy(random, soup, 0.3), 0.3), 0.3);
  }
  static Soup strip(Random& random)
  {
    const double width = log_uniform(random, -8, 0);
    Soup soup = chance(random, 0.5) ? random_rectangle(12, width, between(random, 0, 20), between(random, 0, 5), seed(random))
                                    : planar_grid(between(random, 2, 24), between(random, 1, 2), diagonals(random));
    if (soup.points.back().y() >= 1)
      for (Point_3& p : soup.points) p = Point_3(p.x(), width * p.y(), 0);
    if (chance(random, 0.3)) add_noise(soup, random, 0.1 * width, {{false, false, true}});
    return turned(random, std::move(soup), 0.4);
  }
  static Soup needles(Random& random)
  {
    switch (uniform_index(random, 3))
    {
    case 0: return turned(random, needle_fan(between(random, 3, 200)), 0.3);
    case 1:
      return crumpled_needles(log_uniform(random, -4, -1), log_uniform(random, -5, -1), between(random, 5, 40), seed(random));
    default:
      return turned(
        random, random_rectangle(1, log_uniform(random, -5, -1), between(random, 5, 60), between(random, 0, 5), seed(random)),
        0.5);
    }
  }
  static Soup cone(Random& random)
  {
    const std::size_t k = 2 * between(random, 3, 6);
    static const double turns[] = {0.25, 0.5, 0.75, 0.9, 1 - 1e-6, 1, 1 + 1e-6, 1.05, 1.25, 1.5, 2};
    const double angle = 2 * CGAL_PI * turns[uniform_index(random, 11)];
    return noisy(
      random, Cone(k, angle, 1, chance(random, 0.2)).triangulated(between(random, 0, 10), between(random, 0, 3), seed(random)),
      0.2);
  }
  static Soup few_faces(Random& random)
  {
    switch (uniform_index(random, 4))
    {
    case 0:
    {
      Soup soup = random_rectangle(1, 1, between(random, 0, 6), 0, seed(random));
      add_noise(soup, random, uniform(random, 0, 0.7), {{false, false, true}});
      return soup;
    }
    case 1: return graded_disc(between(random, 4, 20), uniform(random, 1, 6), 0.5, seed(random));
    case 2: return noisy(random, tetrahedron_sides().triangulated(between(random, 0, 3), 0, 1), 0.5);
    default:
    {
      Soup soup = planar_grid(between(random, 1, 3), between(random, 1, 3), diagonals(random));
      add_noise(soup, random, uniform(random, 0, 0.3), {{true, true, true}});
      return soup;
    }
    }
  }
  static Soup tiny_faces(Random& random)
  {
    return chance(random, 0.7) ? turned(random, marching_sphere(4 + 2 * uniform_index(random, 2)), 0.5)
                               : turned(random, random_mixture(random), 0.5);
  }
  // Points in two clusters, one smaller by a factor of a million.
  static Soup random_mixture(Random& random)
  {
    std::vector<Point_2> plane;
    Soup soup;
    const std::size_t n = between(random, 6, 40);
    const double size = log_uniform(random, -7, -2);
    for (std::size_t i = 0; i < n; ++i)
    {
      const double s = i % 2 == 0 ? 1 : size;
      plane.push_back(Point_2(s * uniform(random, -1, 1), s * uniform(random, -1, 1)));
      soup.points.push_back(Point_3(plane.back().x(), plane.back().y(), 0.3 * s * uniform(random)));
    }
    for (const std::array<std::size_t, 3>& triangle : delaunay_triangles(plane)) soup.add_triangle(triangle);
    return soup;
  }
};

/// Sources of a case, which can be added to several objects, and written.
struct Search_sources
{
  typedef Geodesic::Face_location Face_location;

  std::string kind;
  std::vector<Surface_mesh::Vertex_index> vertices;
  std::vector<Face_location> points;
  std::vector<Geodesic::Polyline> polylines;
  std::vector<Surface_mesh::Edge_index> edges;

  bool empty() const { return vertices.empty() && points.empty() && polylines.empty() && edges.empty(); }

  /// `Solver`: Geodesic, or another class with sources
  template <class Solver>
  void add_to(Solver& geodesic) const
  {
    for (const auto v : vertices) geodesic.add_source_point(v);
    for (const Face_location& p : points) geodesic.add_source_point(p);
    for (const auto& p : polylines) geodesic.add_source_polyline(p);
    if (!edges.empty()) geodesic.add_source_edges(edges);
  }

  /// One source per line: vertices and edges by index, locations as face and coordinates.
  void write(std::ostream& out) const
  {
    out.precision(17);
    for (const auto v : vertices) out << "vertex " << std::size_t(v) << '\n';
    const auto write_location = [&](const Face_location& l) {
      out << "  " << std::size_t(l.first) << ' ' << l.second[0] << ' ' << l.second[1] << ' ' << l.second[2] << '\n';
    };
    for (const Face_location& p : points)
    {
      out << "point\n";
      write_location(p);
    }
    for (const auto& p : polylines)
    {
      out << (p.is_closed ? "closed polyline\n" : "polyline\n");
      for (const Face_location& l : p.locations) write_location(l);
    }
    for (const auto e : edges) out << "edge " << std::size_t(e) << '\n';
  }
};

/// Random sources on a mesh.
class Source_drawing
{
public:
  typedef Search_sources::Face_location Face_location;

  Source_drawing(const Surface_mesh& mesh, const Open_geodesic& geodesic, Random& random)
    : mesh_(mesh), geodesic_(geodesic), random_(random), locations_(mesh)
  {
  }

  Search_sources operator()()
  {
    Search_sources sources;
    while (sources.empty())
    {
      sources.kind.clear();
      add(sources);
      if (uniform(random_) < 0.1) add(sources);
    }
    return sources;
  }

  /// Sources of up to `most` kinds, rings around vertices among them.
  Search_sources several(std::size_t most)
  {
    Search_sources sources;
    const std::size_t n = 1 + uniform_index(random_, most);
    for (std::size_t i = 0; i < n || sources.empty(); ++i)
      if (uniform(random_) < 0.2) add_ring(sources);
      else add(sources);
    return sources;
  }

private:
  void add(Search_sources& sources)
  {
    const char* kind = "";
    switch (uniform_index(random_, 12))
    {
    case 0:
    case 1:
      kind = "vertex";
      sources.vertices.push_back(vertex());
      break;
    case 2:
      kind = "vertices";
      for (std::size_t i = 0, n = 2 + uniform_index(random_, 4); i < n; ++i) sources.vertices.push_back(vertex());
      break;
    case 3:
      kind = "face point";
      sources.points.push_back(in_face());
      break;
    case 4:
      kind = "edge points";
      for (std::size_t i = 0, n = 1 + uniform_index(random_, 3); i < n; ++i) sources.points.push_back(on_edge());
      break;
    case 5:
      kind = "point beside an edge";
      sources.points.push_back(beside_edge());
      break;
    case 6:
      kind = "path of edges";
      sources.polylines.push_back(path_of_edges());
      break;
    case 7:
      kind = "polyline";
      sources.polylines.push_back(polyline(false));
      break;
    case 8:
      kind = "closed polyline";
      sources.polylines.push_back(polyline(true));
      break;
    case 9:
      kind = "plane section";
      add_section(random_plane(), sources);
      break;
    case 10:
      kind = "section along an axis";
      add_section(plane_along_axis(), sources);
      break;
    default:
      if (uniform(random_) < 0.6)
      {
        kind = "border";
        for (const auto e : mesh_.edges())
          if (mesh_.is_border(e)) sources.edges.push_back(e);
      }
      else
      {
        kind = "edges";
        for (std::size_t i = 0, n = 1 + uniform_index(random_, 4); i < n; ++i) sources.edges.push_back(mesh_.edge(halfedge()));
      }
    }
    sources.kind += (sources.kind.empty() ? "" : ", ") + std::string(kind);
  }

  // A closed polyline around a vertex: through its neighbours, or across its edges, all at one fraction or each at its own.
  void add_ring(Search_sources& sources)
  {
    const auto v = vertex();
    if (mesh_.is_border(v)) return;
    const std::size_t kind = uniform_index(random_, 3);
    const double fraction = kind == 0 ? 1 : uniform(random_) < 0.5 ? 0.5 : log_uniform(random_, -6, 0);
    Geodesic::Polyline ring;
    ring.is_closed = true;
    for (const auto h : CGAL::halfedges_around_source(v, mesh_))
      ring.locations.push_back(locations_.on_edge(h,
                                                  kind == 2 && uniform(random_) < 0.5 ? uniform(random_, 0.1, 0.9) : fraction));
    if (uniform(random_) < 0.5) std::reverse(ring.locations.begin(), ring.locations.end());
    sources.polylines.push_back(ring);
    sources.kind += sources.kind.empty() ? "ring" : ", ring";
  }

  Surface_mesh::Vertex_index vertex()
  {
    return mesh_.source(halfedge()); // not an isolated vertex
  }
  // Not a border halfedge.
  Surface_mesh::Halfedge_index halfedge() { return mesh_.next(mesh_.halfedge(face())); }
  Surface_mesh::Face_index face()
  {
    return Surface_mesh::Face_index(static_cast<Surface_mesh::size_type>(uniform_index(random_, mesh_.number_of_faces())));
  }
  Face_location in_face() { return Face_location(face(), random_barycentric(random_)); }
  Face_location on_edge()
  {
    return locations_.on_edge(halfedge(), uniform(random_) < 0.5 ? 0.5 : uniform(random_, 0.05, 0.95));
  }
  Face_location beside_edge()
  {
    const double off = log_uniform(random_, -12.5, -3), t = uniform(random_, 0, 1 - off);
    Face_location l(face(), {{1 - t - off, t, off}});
    std::rotate(l.second.begin(), l.second.begin() + int(uniform_index(random_, 3)), l.second.end());
    return l;
  }

  Face_location anywhere()
  {
    const double x = uniform(random_);
    return x < 0.4 ? locations_.at_vertex(vertex()) : x < 0.6 ? on_edge() : in_face();
  }

  Geodesic::Polyline path_of_edges()
  {
    Geodesic::Polyline result;
    auto h = halfedge();
    result.locations.push_back(locations_.at_vertex(mesh_.source(h)));
    for (std::size_t i = 0, n = 1 + uniform_index(random_, 5); i < n; ++i)
    {
      result.locations.push_back(locations_.at_vertex(mesh_.target(h)));
      h = mesh_.next(h);
      for (std::size_t turn = uniform_index(random_, 4); turn > 0; --turn) h = mesh_.next(mesh_.opposite(h));
    }
    return result;
  }

  Geodesic::Polyline polyline(bool closed)
  {
    std::vector<Face_location> corners;
    for (std::size_t i = 0, n = (closed ? 3 : 2) + uniform_index(random_, 3); i < n; ++i) corners.push_back(anywhere());
    return geodesic_.join_polyline(corners, CGAL::parameters::is_closed(closed));
  }

  Geodesic::Plane_3 random_plane()
  {
    const Vector_3 normal(uniform(random_, -1, 1), uniform(random_, -1, 1), uniform(random_, -1, 1));
    return Geodesic::Plane_3(locations_.point(in_face()), normal);
  }
  // Through a vertex; on regular meshes through many vertices.
  Geodesic::Plane_3 plane_along_axis()
  {
    const double axis = uniform(random_);
    const Vector_3 normal(axis < 0.4, axis >= 0.4 && axis < 0.8, axis >= 0.8);
    return Geodesic::Plane_3(mesh_.point(vertex()), normal);
  }

  void add_section(const Geodesic::Plane_3& plane, Search_sources& sources)
  {
    const auto section = geodesic_.plane_section(plane);
    sources.polylines.insert(sources.polylines.end(), section.polylines.begin(), section.polylines.end());
    sources.vertices.insert(sources.vertices.end(), section.touched_vertices.begin(), section.touched_vertices.end());
    sources.edges.insert(sources.edges.end(), section.touched_edges.begin(), section.touched_edges.end());
  }

  const Surface_mesh& mesh_;
  const Open_geodesic& geodesic_;
  Random& random_;
  Locations<Surface_mesh> locations_;
};

/// Random levels, at and near features of a field and elsewhere.
class Level_drawing
{
public:
  Level_drawing(const Field_features& features, double diagonal, Random& random)
    : features_(features), diagonal_(diagonal), random_(random)
  {
    for (const double d : features.vertices) largest_ = (std::max)(largest_, d);
    for (const double d : features.maxima) largest_ = (std::max)(largest_, d);
  }

  /// At most `count` levels, increasing and distinct.
  std::vector<double> operator()(std::size_t count)
  {
    std::vector<double> levels;
    for (std::size_t i = 0; i < count && largest_ > 0; ++i)
    {
      const double level = one();
      if (level > 1e-9 * diagonal_) levels.push_back(level);
    }
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    return levels;
  }

private:
  double one()
  {
    const std::vector<double>* const kinds[] = {
      &features_.vertices,
      &features_.vertices,
      &features_.vertices,
      &features_.tangents,
      &features_.tangents,
      &features_.joints,
      &features_.joints,
      &features_.edge_maxima,
      &features_.saddles,
      &features_.edge_maxima,
      &features_.maxima,
      &features_.maxima,
      nullptr};
    const std::size_t n = sizeof(kinds) / sizeof(kinds[0]);
    for (int i = 0; i < 8; ++i)
    {
      const std::size_t k = uniform_index(random_, n);
      if (kinds[k] == nullptr) break;
      if (kinds[k]->empty()) continue;
      const double d = (*kinds[k])[uniform_index(random_, kinds[k]->size())];
      if (!(d > 1e-9 * diagonal_)) continue; // the rounding of 0 is no feature
      return uniform(random_) < 0.2 ? below(d) : near(d);
    }
    return uniform(random_) < 0.2 ? log_uniform(random_, -8, -2) * diagonal_ : uniform(random_, 0.001, 1.01) * largest_;
  }

  // At it, cut at it, or within 1e-15 to 3e-11 of it.
  double near(double d)
  {
    const double kind = uniform(random_);
    if (kind < 0.15) return d;
    if (kind < 0.3) return level_cut_at(d);
    const double off = log_uniform(random_, -15, -10.5) * (uniform(random_) < 0.5 ? d : diagonal_);
    return uniform(random_) < 0.5 ? d - off : d + off;
  }

  // Small loops around maxima.
  double below(double d) { return d - log_uniform(random_, -11, -3) * diagonal_; }

  const Field_features& features_;
  double diagonal_;
  Random& random_;
  double largest_ = 0;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_SEARCH_CASES_H
