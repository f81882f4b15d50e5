// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Barrier edges: against the mesh cut open by hand, where each sector of a vertex between barriers is a vertex; and on a plate with
// slits against paths in the visibility graph of the slits, computed with integers.

#include "generated_meshes.h"
#include "path_tools.h"
#include "query_cases.h"
#include "test_check.h"

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_polylines.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_barriers {

using namespace test;

typedef CGAL::Surface_mesh_geodesic_enclosure<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Surface_mesh>> Enclosure;
typedef std::pair<std::size_t, std::size_t> Edge; // numbers of two vertices of a soup, the smaller one first
typedef std::set<Edge> Barrier_edges;

Edge edge_of(std::size_t a, std::size_t b) { return std::minmax(a, b); }

std::map<Edge, std::vector<std::size_t>> triangles_of_edges(const Soup& soup)
{
  std::map<Edge, std::vector<std::size_t>> result;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) result[edge_of(soup.triangles[t][k], soup.triangles[t][(k + 1) % 3])].push_back(t);
  return result;
}

// Walks along edges: slits, corners, junctions and loops. Some start at the border.
Barrier_edges random_barriers(const Soup& soup, Random& random, std::size_t most_steps = 9)
{
  std::map<std::size_t, std::vector<std::size_t>> neighbours;
  for (const auto& e : triangles_of_edges(soup))
  {
    neighbours[e.first.first].push_back(e.first.second);
    neighbours[e.first.second].push_back(e.first.first);
  }
  Barrier_edges result;
  for (std::size_t walks = 1 + uniform_index(random, 5); walks > 0; --walks)
  {
    std::size_t v = uniform_index(random, soup.points.size());
    for (std::size_t steps = 1 + uniform_index(random, most_steps); steps > 0 && neighbours.count(v); --steps)
    {
      const auto& next = neighbours[v];
      const std::size_t w = next[uniform_index(random, next.size())];
      result.insert(edge_of(v, w));
      v = w;
    }
  }
  return result;
}

// The mesh cut along barriers: the corners of triangles that edges without barriers connect around a vertex are one vertex.
struct Cut_soup
{
  Cut_soup(const Soup& whole, const Barrier_edges& barriers) : soup(whole), copies(whole.points.size())
  {
    const auto of_edge = triangles_of_edges(whole);
    std::map<std::pair<std::size_t, std::size_t>, std::pair<std::size_t, std::size_t>> parent; // (triangle, vertex)
    const auto root = [&](std::pair<std::size_t, std::size_t> c) {
      while (parent.count(c)) c = parent[c];
      return c;
    };
    for (const auto& e : of_edge)
      if (e.second.size() == 2 && !barriers.count(e.first))
        for (const std::size_t v : {e.first.first, e.first.second})
        {
          const auto a = root({e.second[0], v}), b = root({e.second[1], v});
          if (a != b) parent[a] = b;
        }
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> number;
    soup.points.clear();
    for (std::size_t t = 0; t < whole.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t v = whole.triangles[t][k];
        const auto known = number.emplace(root({t, v}), soup.points.size());
        if (known.second)
        {
          copies[v].push_back(soup.points.size());
          soup.points.push_back(whole.points[v]);
        }
        soup.triangles[t][k] = known.first->second;
      }
  }

  Soup soup;
  std::vector<std::vector<std::size_t>> copies; // of each vertex
};

// Without the barriers of a single edge, along which vertices alone cannot cut a mesh.
Barrier_edges longer_ones(const Soup& soup, const Barrier_edges& barriers)
{
  const Cut_soup cut(soup, barriers);
  Barrier_edges result;
  for (const Edge& e : barriers)
    if (cut.copies[e.first].size() > 1 || cut.copies[e.second].size() > 1) result.insert(e);
  return result.size() == barriers.size() ? result : longer_ones(soup, result);
}

struct Barrier_map
{
  typedef Surface_mesh::Edge_index key_type;
  typedef bool value_type;
  typedef bool reference;
  typedef boost::readable_property_map_tag category;

  const Surface_mesh* mesh;
  const std::map<Vertex_index, std::size_t>* number;
  const Barrier_edges* barriers;

  friend bool get(const Barrier_map& m, Surface_mesh::Edge_index e)
  {
    return m.barriers->count(edge_of(m.number->at(m.mesh->vertex(e, 0)), m.number->at(m.mesh->vertex(e, 1)))) > 0;
  }
};

// A mesh with barriers, and the same mesh cut open.
struct Two_meshes
{
  Two_meshes(const Soup& soup, const Barrier_edges& barrier_edges)
    : soup(soup), barriers(barrier_edges), cut(soup, barriers), whole_data(soup), cut_data(cut.soup),
      of_edge(triangles_of_edges(soup))
  {
    for (std::size_t v = 0; v < whole_data.vertices.size(); ++v) number[whole_data.vertices[v]] = v;
  }

  Geodesic with_barriers() const
  {
    return Geodesic(whole_data.mesh,
                    CGAL::parameters::edge_is_constrained_map(Barrier_map{&whole_data.mesh, &number, &barriers}));
  }

  const Soup soup;
  const Barrier_edges barriers;
  const Cut_soup cut;
  const Generated_mesh<Surface_mesh> whole_data, cut_data;
  const std::map<Edge, std::vector<std::size_t>> of_edge;
  std::map<Vertex_index, std::size_t> number;
};

// A point given by weights in a triangle of the soup.
struct Place
{
  std::size_t triangle;
  std::array<double, 3> weights;
};

Face_location location(const Generated_mesh<Surface_mesh>& data, const Soup& soup, const Place& p)
{
  return Mesh_locations(data.mesh).in_triangle(data, soup, p.triangle, p.weights);
}

// The same point in all triangles that contain it.
std::vector<Place> everywhere(const Two_meshes& meshes, const Place& p)
{
  std::map<std::size_t, double> weight;
  for (std::size_t k = 0; k < 3; ++k)
    if (p.weights[k] != 0) weight[meshes.soup.triangles[p.triangle][k]] = p.weights[k];
  std::vector<Place> result;
  for (std::size_t t = 0; t < meshes.soup.triangles.size(); ++t)
  {
    Place q{t, {{0, 0, 0}}};
    std::size_t found = 0;
    for (std::size_t k = 0; k < 3; ++k)
      if (const auto w = weight.find(meshes.soup.triangles[t][k]); w != weight.end())
      {
        q.weights[k] = w->second;
        ++found;
      }
    if (found == weight.size()) result.push_back(q);
  }
  return result;
}

Place random_place(const Soup& soup, Random& random, std::size_t kind)
{
  const std::size_t t = uniform_index(random, soup.triangles.size()), k = uniform_index(random, 3);
  Place p{t, {{0, 0, 0}}};
  if (kind == 0) p.weights = {{0.25, 0.25 + 0.25 * uniform(random), 0}}, p.weights[2] = 1 - p.weights[0] - p.weights[1];
  else if (kind == 1) p.weights[k] = uniform(random, 0.1, 0.9), p.weights[(k + 1) % 3] = 1 - p.weights[k];
  else p.weights[k] = 1;
  return p;
}

class Comparison
{
public:
  Comparison(const Two_meshes& meshes, Random& random)
    : meshes_(meshes), random_(random), with_barriers_(meshes.with_barriers()), cut_open_(meshes.cut_data.mesh)
  {
  }

  void add_point(const Place& p)
  {
    with_barriers_.add_source_point(location(meshes_.whole_data, meshes_.soup, p));
    add_to_cut(p);
  }

  void add_edge(std::size_t triangle, std::size_t k)
  {
    const Soup& soup = meshes_.soup;
    const Edge e = edge_of(soup.triangles[triangle][k], soup.triangles[triangle][(k + 1) % 3]);
    with_barriers_.add_source_edges(std::vector<Surface_mesh::Edge_index>{
      edge(meshes_.whole_data.mesh.halfedge(meshes_.whole_data.vertices[e.first], meshes_.whole_data.vertices[e.second]),
           meshes_.whole_data.mesh)});
    Place p{triangle, {{0, 0, 0}}}, q = p;
    p.weights[k] = q.weights[(k + 1) % 3] = 1;
    add_segment_to_cut(p, q);
  }

  // A polyline from face to face, whose points may be anywhere.
  void add_polyline()
  {
    std::vector<Place> places{random_place(meshes_.soup, random_, uniform_index(random_, 3))};
    for (std::size_t steps = 1 + uniform_index(random_, 5); steps > 0; --steps)
    {
      const auto around = everywhere(meshes_, places.back());
      Place next = random_place(meshes_.soup, random_, uniform_index(random_, 3));
      next.triangle = around[uniform_index(random_, around.size())].triangle;
      places.push_back(next);
    }
    std::vector<Face_location> locations;
    for (const Place& p : places) locations.push_back(location(meshes_.whole_data, meshes_.soup, p));
    with_barriers_.add_source_polyline(locations, CGAL::parameters::is_closed(false));
    for (std::size_t i = 0; i + 1 < places.size(); ++i) add_segment_to_cut(places[i], places[i + 1]);
  }

  void compare()
  {
    with_barriers_.build(CGAL::parameters::keep_windows(true));
    cut_open_.build(CGAL::parameters::keep_windows(true));
    const double size = 10;
    double largest = 0;
    for (std::size_t v = 0; v < meshes_.whole_data.vertices.size(); ++v)
    {
      double least = std::numeric_limits<double>::infinity();
      for (const std::size_t c : meshes_.cut.copies[v])
        least = (std::min)(least, cut_open_.distance_to_sources(meshes_.cut_data.vertices[c]));
      check(with_barriers_.distance_to_sources(meshes_.whole_data.vertices[v]), least, size);
      if (std::isfinite(least)) largest = (std::max)(largest, least);
    }
    Enclosure bounds(with_barriers_.mesh());
    bounds.add_sources(with_barriers_.sources());
    bounds.build();
    for (const Vertex_index v : meshes_.whole_data.vertices)
    {
      const double d = with_barriers_.distance_to_sources(v);
      const auto b = bounds.distance_bounds(v);
      CHECK_DETAIL(b.first <= d * (1 + 1e-13) + 1e-14 && d <= b.second * (1 + 1e-13) + 1e-14, values(b.first, b.second));
      CHECK(!(std::isfinite(d) && b.second - b.first > 1e-11 * size));
    }
    for (std::size_t i = 0; i < 60; ++i)
    {
      const Place p = random_place(meshes_.soup, random_, i % 3);
      check(with_barriers_.distance_to_sources(location(meshes_.whole_data, meshes_.soup, p)),
            cut_open_.distance_to_sources(location(meshes_.cut_data, meshes_.cut.soup, p)), size);
      check_path(location(meshes_.whole_data, meshes_.soup, p));
    }
    for (const double part : {0.31, 0.57, 0.83})
    {
      const double d = part * largest;
      if (!(d > 0)) continue;
      const double a = total_length(offsets(with_barriers_, d)), b = total_length(offsets(cut_open_, d));
      CHECK_DETAIL(std::abs(a - b) <= 1e-9 * (size + b), values(a, b));
    }
  }

private:
  void check(double d, double expected, double size)
  {
    CHECK_DETAIL(d == expected || std::abs(d - expected) <= 1e-13 * (size + expected), values(d, expected));
  }

  // The path has the length of the distance, and crosses no barrier.
  void check_path(const Face_location& from)
  {
    const double d = with_barriers_.distance_to_sources(from);
    Path_locations path;
    with_barriers_.shortest_path_to_sources(from, std::back_inserter(path));
    CHECK(path.empty() == std::isinf(d));
    const double sum = length_of(Mesh_locations(meshes_.whole_data.mesh), path);
    if (std::isfinite(d)) CHECK_DETAIL(std::abs(sum - d) <= 1e-12 * (10 + d), values(sum, d));
  }

  void add_to_cut(const Place& p)
  {
    for (const Place& q : everywhere(meshes_, p)) cut_open_.add_source_point(location(meshes_.cut_data, meshes_.cut.soup, q));
  }

  // In all triangles that contain both ends.
  void add_segment_to_cut(const Place& p, const Place& q)
  {
    for (const Place& a : everywhere(meshes_, p))
      for (const Place& b : everywhere(meshes_, q))
        if (a.triangle == b.triangle)
          cut_open_.add_source_polyline(std::vector<Face_location>{location(meshes_.cut_data, meshes_.cut.soup, a),
                                                                   location(meshes_.cut_data, meshes_.cut.soup, b)},
                                        CGAL::parameters::is_closed(false));
    add_to_cut(p);
    add_to_cut(q);
  }

  const Two_meshes& meshes_;
  Random& random_;
  Geodesic with_barriers_, cut_open_;
};

void cut_open()
{
  for (unsigned seed = 1; seed <= number_of_cases(300u, 3000u); ++seed)
  {
    Random random(seed);
    Report::instance().set_context("cut open, seed " + std::to_string(seed));
    const Soup soup = seed % 3 == 0 ? icosphere(2) : seed % 3 == 1 ? with_noise(planar_grid(7, 7), 0.05, seed) : torus(10, 7);
    const Barrier_edges barriers = longer_ones(soup, random_barriers(soup, random));
    if (barriers.empty()) continue;
    const Two_meshes meshes(soup, barriers);
    Comparison comparison(meshes, random);
    for (std::size_t n = 1 + uniform_index(random, 3); n > 0; --n) switch (uniform_index(random, 4))
      {
      case 0: comparison.add_point(random_place(soup, random, uniform_index(random, 3))); break;
      case 1:
      { // at a barrier
        auto b = meshes.barriers.begin();
        std::advance(b, uniform_index(random, meshes.barriers.size()));
        const std::size_t t = meshes.of_edge.at(*b).front();
        for (std::size_t k = 0; k < 3; ++k)
          if (edge_of(soup.triangles[t][k], soup.triangles[t][(k + 1) % 3]) == *b)
          {
            Place p{t, {{0, 0, 0}}};
            const double w = uniform_index(random, 2) == 0 ? 1 : uniform(random, 0.1, 0.9);
            p.weights[k] = w;
            p.weights[(k + 1) % 3] = 1 - w;
            if (uniform_index(random, 2) == 0) comparison.add_point(p);
            else comparison.add_edge(t, k);
          }
        break;
      }
      case 2: comparison.add_edge(uniform_index(random, soup.triangles.size()), uniform_index(random, 3)); break;
      default: comparison.add_polyline();
      }
    comparison.compare();
  }
}

// The curves between the cells of sources.
template <class Diagram>
double bisector_length(const Diagram& diagram)
{
  double sum = 0;
  for (const auto& curve : diagram.curves())
  {
    std::vector<Point_3> points;
    curve.points(1e-6, std::back_inserter(points));
    for (std::size_t i = 1; i < points.size(); ++i) sum += test::distance(points[i - 1], points[i]);
  }
  return sum;
}

// Voronoi diagrams of points in faces, which are one source each on both meshes. Returns the length of the curves.
double compare_diagrams(const Two_meshes& meshes, Random& random)
{
  Geodesic with_barriers = meshes.with_barriers(), cut_open(meshes.cut_data.mesh), without(meshes.whole_data.mesh);
  for (std::size_t i = 0; i < 5; ++i)
  {
    const Place p = random_place(meshes.soup, random, 0);
    with_barriers.add_source_point(location(meshes.whole_data, meshes.soup, p));
    without.add_source_point(location(meshes.whole_data, meshes.soup, p));
    cut_open.add_source_point(location(meshes.cut_data, meshes.cut.soup, p));
  }
  for (Geodesic* g : {&with_barriers, &cut_open, &without}) g->build(CGAL::parameters::keep_windows(true));
  const double a = bisector_length(with_barriers.field().voronoi_diagram()),
               b = bisector_length(cut_open.field().voronoi_diagram()), c = bisector_length(without.field().voronoi_diagram());
  CHECK_DETAIL(std::abs(a - b) <= 1e-8 * (10 + b), values(a, b));
  return std::abs(a - c);
}

void diagrams()
{
  double difference = 0;
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    Random random(seed);
    Report::instance().set_context("diagrams, seed " + std::to_string(seed));
    const Soup soup = seed % 3 == 0 ? icosphere(2) : seed % 3 == 1 ? with_noise(planar_grid(7, 7), 0.05, seed) : torus(10, 7);
    const Barrier_edges barriers = longer_ones(soup, random_barriers(soup, random));
    if (!barriers.empty()) difference += compare_diagrams(Two_meshes(soup, barriers), random);
  }
  CHECK(difference > 10); // barriers count
}

// Scaled to a diagonal of 10.
Soup soup_of(const Surface_mesh& mesh)
{
  CGAL::Bbox_3 box;
  for (const Vertex_index v : vertices(mesh)) box += mesh.point(v).bbox();
  const double scale = 10 / std::hypot(box.x_span(), box.y_span(), box.z_span());
  Soup soup;
  std::map<Vertex_index, std::size_t> number;
  for (const auto f : faces(mesh))
  {
    std::array<std::size_t, 3> corners;
    std::size_t k = 0;
    for (const Vertex_index v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
    {
      const auto known = number.emplace(v, soup.points.size());
      if (known.second) soup.points.push_back(CGAL::ORIGIN + scale * (mesh.point(v) - CGAL::ORIGIN));
      corners[k++] = known.first->second;
    }
    soup.add_triangle(corners);
  }
  return soup;
}

// Barriers on meshes of the data directory.
void data_meshes()
{
  const std::size_t most_meshes = 20, most_faces = 3000;
  std::size_t used = 0;
  for_each_data_mesh(data_mesh_names(), most_faces, [&](const std::string& name, const Surface_mesh& mesh) {
    if (used == most_meshes || faces(mesh).size() < 200) return;
    const Soup soup = soup_of(mesh);
    if (Cut_soup(soup, {}).soup.points.size() != soup.points.size()) return; // paths pass through pinched vertices
    ++used;
    for (unsigned seed = 1; seed <= 3; ++seed)
    {
      Report::instance().set_context(name + ", seed " + std::to_string(seed));
      Random random(seed);
      const Two_meshes meshes(soup, longer_ones(soup, random_barriers(soup, random, 60)));
      CHECK(!meshes.barriers.empty());
      Comparison comparison(meshes, random);
      comparison.add_point(random_place(soup, random, uniform_index(random, 3)));
      if (seed == 2) comparison.add_polyline();
      comparison.compare();
      compare_diagrams(meshes, random);
    }
  });
  if (!data_mesh_names().empty()) CHECK_DETAIL(used == most_meshes, std::to_string(used));
}

// A shortest path between points of a plate, by the visibility graph: nodes are the sectors of the ends of barrier edges.
class Visibility
{
public:
  struct Point
  {
    int x, y;
    bool operator==(const Point& p) const { return x == p.x && y == p.y; }
  };

  // The border of the plate, a square of side n, is among the slits.
  Visibility(const std::vector<std::pair<Point, Point>>& slits, int n) : slits_(slits), size_(n)
  {
    for (const auto& s : slits)
      for (const Point& p : {s.first, s.second})
        if (std::find(ends_.begin(), ends_.end(), p) == ends_.end()) ends_.push_back(p);
    for (const Point& p : ends_)
    {
      std::vector<Point> rays;
      for (const auto& s : slits)
      {
        if (s.first == p) rays.push_back(minus(s.second, p));
        if (s.second == p) rays.push_back(minus(s.first, p));
        if (cross(minus(s.first, p), minus(s.second, p)) == 0 && dot(minus(s.first, p), minus(s.second, p)) < 0)
          for (const Point& q : {s.first, s.second}) rays.push_back(minus(q, p));
      }
      std::sort(rays.begin(), rays.end(),
                [](const Point& a, const Point& b) { return half(a) != half(b) ? half(a) < half(b) : cross(a, b) > 0; });
      const auto is_same = [](const Point& a, const Point& b) { return cross(a, b) == 0 && dot(a, b) > 0; };
      rays.erase(std::unique(rays.begin(), rays.end(), is_same), rays.end());
      rays_.push_back(rays);
    }
  }

  double distance(const Point& from, const Point& to) const
  {
    const std::vector<Node> nodes = nodes_of(from, to);
    std::vector<double> d(nodes.size(), std::numeric_limits<double>::infinity());
    std::vector<char> done(nodes.size(), 0);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (nodes[i].point == from) d[i] = 0;
    for (;;)
    {
      std::size_t best = nodes.size();
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (!done[i] && std::isfinite(d[i]) && (best == nodes.size() || d[i] < d[best])) best = i;
      if (best == nodes.size()) break;
      done[best] = 1;
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (!done[i] && sees(nodes[best], nodes[i]))
          d[i] = (std::min)(d[i], d[best] +
                                    std::hypot(nodes[best].point.x - nodes[i].point.x, nodes[best].point.y - nodes[i].point.y));
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (nodes[i].point == to) least = (std::min)(least, d[i]);
    return least;
  }

private:
  struct Node
  {
    Point point;
    std::size_t end, sector; // end: number, or none
  };
  static constexpr std::size_t none = std::size_t(-1);

  static Point minus(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }
  static long cross(const Point& a, const Point& b) { return long(a.x) * b.y - long(a.y) * b.x; }
  static long dot(const Point& a, const Point& b) { return long(a.x) * b.x + long(a.y) * b.y; }
  static int half(const Point& a) { return a.y < 0 || (a.y == 0 && a.x < 0); }
  static int sign(long x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

  std::vector<Node> nodes_of(const Point& from, const Point& to) const
  {
    std::vector<Node> nodes;
    for (std::size_t e = 0; e < ends_.size(); ++e)
      for (std::size_t s = 0; s < rays_[e].size(); ++s)
        if (is_on_plate(e, s)) nodes.push_back({ends_[e], e, s});
    for (const Point& p : {from, to})
      if (std::find(ends_.begin(), ends_.end(), p) == ends_.end()) nodes.push_back({p, none, 0});
    return nodes;
  }

  // False for the sector beyond the border.
  bool is_on_plate(std::size_t end, std::size_t s) const
  {
    const Point &p = ends_[end], &ray = rays_[end][s], q{p.x - ray.y, p.y + ray.x}, r{p.x + ray.x, p.y + ray.y};
    const bool is_along_border = (p.x == r.x && (p.x == 0 || p.x == size_)) || (p.y == r.y && (p.y == 0 || p.y == size_));
    return !is_along_border || (q.x >= 0 && q.x <= size_ && q.y >= 0 && q.y <= size_);
  }

  // True if a direction is in the closed sector s of an end, from ray s counterclockwise to the next one.
  bool is_in_sector(std::size_t end, std::size_t s, const Point& u) const
  {
    const auto& rays = rays_[end];
    if (rays.size() == 1) return true;
    const Point &a = rays[s], &b = rays[(s + 1) % rays.size()];
    const auto is_along = [](const Point& r, const Point& v) { return cross(r, v) == 0 && dot(r, v) > 0; };
    if (is_along(a, u) || is_along(b, u)) return true;
    if (cross(a, b) > 0 || (cross(a, b) == 0 && dot(a, b) < 0)) return cross(a, u) > 0 && (cross(u, b) > 0 || cross(a, b) == 0);
    return !(cross(b, u) > 0 && cross(u, a) > 0);
  }

  // On which sides of a path, 1 left and 2 right, the sector of a node is: one if the path runs along a slit, which bounds the
  // sector, and both otherwise. u: direction from the node; `back`: opposite to the path.
  int sides(const Node& n, const Point& u, bool back) const
  {
    const auto& rays = rays_[n.end];
    const auto is_along = [&](const Point& r) { return cross(r, u) == 0 && dot(r, u) > 0; };
    const bool is_first = is_along(rays[n.sector]), is_last = is_along(rays[(n.sector + 1) % rays.size()]);
    if (is_first == is_last) return 3;
    return is_first != back ? 1 : 2;
  }

  bool sees(const Node& n, const Node& m) const
  {
    const Point &p = n.point, &q = m.point, u = minus(q, p), back = minus(p, q);
    if (p == q) return false;
    if (n.end != none && !is_in_sector(n.end, n.sector, u)) return false;
    if (m.end != none && !is_in_sector(m.end, m.sector, back)) return false;
    for (const auto& s : slits_)
      if (sign(cross(u, minus(s.first, p))) * sign(cross(u, minus(s.second, p))) < 0)
      {
        const Point v = minus(s.second, s.first);
        const int a = sign(cross(v, minus(p, s.first))), b = sign(cross(v, minus(q, s.first)));
        if (a * b < 0) return false;
      }
    // Through an end of slits, a path is one of two parts.
    for (const Point& e : ends_)
    {
      const Point w = minus(e, p);
      if (cross(u, w) == 0 && dot(u, w) > 0 && dot(minus(e, q), back) > 0) return false;
    }
    return n.end == none || m.end == none || (sides(n, u, false) & sides(m, back, true)) != 0;
  }

  const std::vector<std::pair<Point, Point>> slits_;
  const int size_;
  std::vector<Point> ends_;
  std::vector<std::vector<Point>> rays_; // of each end, counterclockwise
};

void plates()
{
  const std::size_t n = 6;
  for (unsigned seed = 1; seed <= number_of_cases(400u, 4000u); ++seed)
  {
    Random random(1000 + seed);
    Report::instance().set_context("plate, seed " + std::to_string(seed));
    const Soup soup = planar_grid(n, n, seed % 2 ? Diagonals::forward : Diagonals::random, 1, 0, seed);
    const Barrier_edges barriers = random_barriers(soup, random);
    const Two_meshes meshes(soup, barriers);
    Geodesic geodesic = meshes.with_barriers();
    const auto point = [&](std::size_t v) { return Visibility::Point{int(soup.points[v].x()), int(soup.points[v].y())}; };
    std::vector<std::pair<Visibility::Point, Visibility::Point>> slits;
    for (const Edge& e : barriers)
      if (meshes.of_edge.at(e).size() == 2) slits.emplace_back(point(e.first), point(e.second));
    // the border bounds sectors, too
    for (const auto& e : meshes.of_edge)
      if (e.second.size() == 1) slits.emplace_back(point(e.first.first), point(e.first.second));
    const Visibility visibility(slits, int(n));
    const std::size_t source = uniform_index(random, soup.points.size());
    geodesic.add_source_point(meshes.whole_data.vertices[source]);
    geodesic.build();
    const std::vector<Vertex_index> row_sources = {meshes.whole_data.vertices[source]};
    CGAL::geodesic_distance_matrix(geodesic.mesh(), row_sources, meshes.whole_data.vertices,
                                   [&](std::size_t, const std::vector<double>& row) {
                                     for (std::size_t v = 0; v < row.size(); ++v)
                                     {
                                       const double d = geodesic.distance_to_sources(meshes.whole_data.vertices[v]);
                                       CHECK_DETAIL(row[v] == d || std::abs(row[v] - d) <= 1e-13 * (1 + d), values(row[v], d));
                                     }
                                   });
    for (std::size_t i = 0; i < 20; ++i)
    {
      const std::size_t v = uniform_index(random, soup.points.size());
      const double d = geodesic.distance_to_sources(meshes.whole_data.vertices[v]),
                   e = visibility.distance(point(source), point(v));
      CHECK_DETAIL(d == e || std::abs(d - e) <= 1e-12 * (1 + e), values(d, e));
    }
  }
}

// The halfedges of each open polyline lead from its first point to its last one, and have the length of all in sum.
void check_chains(const Surface_mesh& mesh, const std::vector<std::pair<std::size_t, Surface_mesh::Halfedge_index>>& edges,
                  std::size_t polylines, double length)
{
  double sum = 0;
  std::vector<std::map<Vertex_index, int>> leaving(polylines);
  for (const auto& e : edges)
  {
    sum += test::distance(mesh.point(mesh.source(e.second)), mesh.point(mesh.target(e.second)));
    ++leaving[e.first][mesh.source(e.second)];
    --leaving[e.first][mesh.target(e.second)];
  }
  CHECK_DETAIL(std::abs(sum - length) <= 1e-12 * length, values(sum, length));
  for (const auto& at : leaving)
  {
    const auto is_end = [](const auto& v) { return v.second != 0; };
    const auto ends = std::count_if(at.begin(), at.end(), is_end);
    CHECK(ends == 2 || ends == 0); // none if the polyline returns
  }
}

// Slits anywhere on a plate: the mesh is split along them first.
void slits_in_faces()
{
  const int n = 5, side = 3, size = n * side;
  for (unsigned seed = 1; seed <= number_of_cases(200u, 2000u); ++seed)
  {
    Random random(2000 + seed);
    Report::instance().set_context("slits, seed " + std::to_string(seed));
    const Soup soup = planar_grid(n, n, Diagonals::random, side, 0, seed);
    Generated_mesh<Surface_mesh> data(soup);
    std::vector<std::pair<Visibility::Point, Visibility::Point>> slits;
    std::vector<Geodesic::Polyline> polylines;
    {
      const Geodesic geodesic(data.mesh);
      for (std::size_t chains = 1 + uniform_index(random, 4); chains > 0; --chains)
      {
        std::vector<Visibility::Point> ends;
        std::vector<Point_3> points;
        for (std::size_t k = 2 + uniform_index(random, 3); k > 0; --k)
        {
          const int x = int(uniform_index(random, std::size_t(size + 1))),
                    y = int(uniform_index(random, std::size_t(size + 1)));
          const Visibility::Point p{x, y};
          if (!ends.empty() && ends.back() == p) continue;
          ends.push_back(p);
          points.emplace_back(x, y, 0);
        }
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) slits.emplace_back(ends[i], ends[i + 1]);
        polylines.push_back(geodesic.locate_polyline(points, CGAL::parameters::is_closed(false)));
      }
    }
    double length = 0; // of all slits, also of parts that they have in common
    for (const auto& s : slits) length += std::hypot(s.first.x - s.second.x, s.first.y - s.second.y);
    auto is_barrier = data.mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:barrier", false).first;
    std::vector<std::pair<std::size_t, Surface_mesh::Halfedge_index>> of_polylines;
    CGAL::split_along_polylines(
      data.mesh, polylines,
      CGAL::parameters::edge_is_constrained_map(is_barrier).output_iterator(std::back_inserter(of_polylines)));
    CHECK(CGAL::is_valid_polygon_mesh(data.mesh) && CGAL::is_triangle_mesh(data.mesh));
    check_chains(data.mesh, of_polylines, polylines.size(), length);
    double sum = 0;
    for (const auto e : data.mesh.edges())
      if (is_barrier[e])
        sum += test::distance(data.mesh.point(data.mesh.vertex(e, 0)), data.mesh.point(data.mesh.vertex(e, 1)));
    CHECK_DETAIL(sum <= length * (1 + 1e-12) && (sum > 0 || length == 0),
                 values(sum, length)); // slits may have parts in common
    const Visibility::Point corners[] = {{0, 0}, {size, 0}, {size, size}, {0, size}};
    for (std::size_t k = 0; k < 4; ++k) slits.emplace_back(corners[k], corners[(k + 1) % 4]);
    const Visibility visibility(slits, size);
    Geodesic geodesic(data.mesh, CGAL::parameters::edge_is_constrained_map(is_barrier));
    const auto vertex = [&] { return data.vertices[uniform_index(random, data.vertices.size())]; };
    const auto point = [&](Vertex_index v) {
      return Visibility::Point{int(data.mesh.point(v).x()), int(data.mesh.point(v).y())};
    };
    const Vertex_index source = vertex();
    geodesic.add_source_point(source);
    geodesic.build();
    for (std::size_t i = 0; i < 20; ++i)
    {
      const Vertex_index v = vertex();
      const double d = geodesic.distance_to_sources(v), e = visibility.distance(point(source), point(v));
      CHECK_DETAIL(d == e || std::abs(d - e) <= 1e-12 * (1 + e), values(d, e));
    }
  }
}

// A closed polyline that is source and barrier: its sides, and the bands of offsets on both sides.
void wall()
{
  const Soup soup = planar_grid(8, 8);
  Generated_mesh<Surface_mesh> data(soup);
  std::vector<Geodesic::Polyline> walls;
  {
    const Geodesic geodesic(data.mesh);
    walls.push_back(geodesic.locate_polyline(
      std::vector<Point_3>{Point_3(2, 2, 0), Point_3(6, 2, 0), Point_3(6, 6, 0), Point_3(2, 6, 0)},
      CGAL::parameters::is_closed(true)));
  }
  auto is_barrier = data.mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:barrier", false).first;
  CGAL::split_along_polylines(data.mesh, walls, CGAL::parameters::edge_is_constrained_map(is_barrier));
  CHECK(data.mesh.number_of_vertices() == soup.points.size()); // along edges
  Geodesic geodesic(data.mesh, CGAL::parameters::edge_is_constrained_map(is_barrier));
  const std::size_t id = geodesic.add_source_polyline(walls[0]);
  CHECK(geodesic.inner_sides().at(id).side == CGAL::Source_side::LEFT);
  geodesic.build(CGAL::parameters::keep_windows(true));
  for (const Vertex_index v : data.vertices)
  {
    const Point_3& p = data.mesh.point(v);
    const double inside = (std::min)({p.x() - 2, 6 - p.x(), p.y() - 2, 6 - p.y()}), d = geodesic.distance_to_sources(v);
    const auto s = geodesic.signed_distance_to_sources(v);
    if (inside > 0) CHECK_DETAIL(s && std::abs(*s + inside) <= 1e-13 && std::abs(d - inside) <= 1e-13, values(d, inside));
    if (inside < 0)
      CHECK(s && *s > 0 &&
            std::abs(*s - std::hypot((std::max)({2 - p.x(), p.x() - 6, 0.}), (std::max)({2 - p.y(), p.y() - 6, 0.}))) <= 1e-12);
  }
  CHECK(std::abs(total_length(offsets(geodesic, 0.5)) - (4 * 3 + 4 * 4 + CGAL_PI)) <= 1e-12);
  CHECK(std::abs(total_length(offsets(geodesic, 0.5, CGAL::Offset_side::INSIDE)) - 4 * 3) <= 1e-12);
  CHECK(std::abs(total_length(offsets(geodesic, 0.5, CGAL::Offset_side::OUTSIDE)) - (4 * 4 + CGAL_PI)) <= 1e-12);

  // bands from a point inside: those outside are not reached
  geodesic.clear_sources();
  geodesic.add_source_point(data.vertices[4 * 9 + 4]);
  geodesic.build(CGAL::parameters::keep_windows(true));
  const Offset_curves curves = offsets(geodesic, std::vector<double>{1.1, 1.9});
  const double reached = CGAL_PI * 1.9 * 1.9;
  std::vector<double> distance(data.mesh.number_of_vertices());
  geodesic.vertex_distances(CGAL::make_property_map(distance));
  const auto distance_map = data.mesh.add_property_map<Vertex_index, double>("v:distance").first;
  for (const Vertex_index v : data.vertices) distance_map[v] = distance[v.idx()];
  const auto band = data.mesh.add_property_map<Surface_mesh::Face_index, std::size_t>("f:band").first;
  CGAL::split_along_offset_curves(data.mesh, curves, CGAL::parameters::face_band_map(band).vertex_distance_map(distance_map));
  double area[3] = {0, 0, 0};
  for (const auto f : data.mesh.faces())
  {
    const auto h = data.mesh.halfedge(f);
    const Point_3 p = data.mesh.point(data.mesh.source(h)), q = data.mesh.point(data.mesh.target(h)),
                  r = data.mesh.point(data.mesh.target(data.mesh.next(h)));
    area[band[f]] += std::sqrt(CGAL::squared_area(p, q, r));
  }
  CHECK_DETAIL(std::abs(area[0] - CGAL_PI * 1.1 * 1.1) <= 1e-2 && std::abs(area[0] + area[1] - reached) <= 1e-2,
               values(area[0], area[1]));
}

// A target in the far sector of a vertex on a slit, and a barrier that ends at a pinched vertex.
void sectors()
{
  const std::size_t n = 4;
  const Generated_mesh<Surface_mesh> data(planar_grid(n, n));
  const auto vertex = [&](std::size_t x, std::size_t y) { return data.vertices[y * (n + 1) + x]; };
  std::vector<char> is_barrier(data.mesh.number_of_edges(), 0);
  for (std::size_t y = 0; y < 3; ++y) is_barrier[data.mesh.edge(data.mesh.halfedge(vertex(2, y), vertex(2, y + 1))).idx()] = 1;
  const auto barriers = boost::make_function_property_map<Surface_mesh::Edge_index>([&](Surface_mesh::Edge_index e) {
    return is_barrier[e.idx()] != 0;
  });
  Geodesic geodesic(data.mesh, CGAL::parameters::edge_is_constrained_map(barriers));
  geodesic.add_source_point(vertex(1, 1));
  const Mesh_locations locations(data.mesh);
  const std::vector<Face_location> far = {locations.on_edge(data.mesh.halfedge(vertex(2, 2), vertex(3, 2)), 0)};
  const double around = std::sqrt(5.) + 1, near = std::sqrt(2.);
  geodesic.build(CGAL::parameters::targets(far).keep_windows(true));
  CHECK(std::abs(geodesic.distance_to_sources(far[0]) - around) <= 1e-12);
  CHECK(std::abs(geodesic.distance_to_sources(vertex(2, 2)) - near) <= 1e-12);
  geodesic.build(CGAL::parameters::targets(std::vector<Vertex_index>{vertex(2, 2)}));
  CHECK(std::abs(geodesic.distance_to_sources(vertex(2, 2)) - near) <= 1e-12 && geodesic.field().covered_distance() < around);
  const std::vector<Vertex_index> sources = {vertex(1, 1)};
  CGAL::geodesic_distance_matrix(geodesic.mesh(), sources, far, [&](std::size_t, const std::vector<double>& row) {
    CHECK(std::abs(row[0] - around) <= 1e-12);
  });

  Surface_mesh fans;
  const Vertex_index center = fans.add_vertex(Point_3(0, 0, 0));
  std::vector<Vertex_index> rim[2];
  for (const int k : {0, 1})
  {
    const Vertex_index own = fans.add_vertex(Point_3(0, 0, 0));
    for (int i = 0; i < 6; ++i)
      rim[k].push_back(fans.add_vertex(Point_3(std::cos(i * CGAL_PI / 3), std::sin(i * CGAL_PI / 3), k == 0 ? 1 : -1)));
    for (std::size_t i = 0; i < 6; ++i) fans.add_face(own, rim[k][i], rim[k][(i + 1) % 6]);
    for (const auto h : CGAL::halfedges_around_target(fans.halfedge(own), fans)) fans.set_target(h, center);
    fans.set_halfedge(center, fans.halfedge(own));
    fans.remove_vertex(own);
  }
  const auto spoke = [&](std::size_t i) {
    return fans.edge(fans.halfedge(center, rim[0][i])); // looked up around the rim: around the center, there are two fans
  };
  for (const std::size_t number : {0, 1, 2})
  {
    const auto walls = boost::make_function_property_map<Surface_mesh::Edge_index>([&](Surface_mesh::Edge_index e) {
      return (number > 0 && e == spoke(0)) || (number > 1 && e == spoke(3));
    });
    Geodesic pinched(fans, CGAL::parameters::edge_is_constrained_map(walls));
    pinched.add_source_point(rim[1][1]);
    pinched.build();
    const double through = 2 * std::sqrt(2.);
    CHECK(std::abs(pinched.distance_to_sources(rim[1][4]) - through) < 1); // in its own fan
    for (const std::size_t i : {1, 4})
      CHECK(number == 2 ? std::isinf(pinched.distance_to_sources(rim[0][i]))
                        : std::abs(pinched.distance_to_sources(rim[0][i]) - through) <= 1e-12);
  }
}

} // namespace test_barriers

GEODESIC_OFFSET_TEST(test_barriers)
{
  const std::pair<const char*, void (*)()> tests[] = {
    {"cut open", test_barriers::cut_open},  {"diagrams", test_barriers::diagrams},
    {"plates", test_barriers::plates},      {"slits in faces", test_barriers::slits_in_faces},
    {"wall", test_barriers::wall},          {"sectors", test_barriers::sectors},
    {data_case, test_barriers::data_meshes}};
  return run_tests("test_barriers", tests);
}
