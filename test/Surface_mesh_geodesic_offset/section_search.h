// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// A search for wrong plane sections: planes through vertices, edges and faces, and planes in general position. The oracle decides
// with rational numbers on which side of the plane each vertex lies, and derives each segment of the section and its direction
// from the signs of the vertices beside it. It shares no code with the package.

#ifndef GEODESIC_OFFSET_TEST_SECTION_SEARCH_H
#define GEODESIC_OFFSET_TEST_SECTION_SEARCH_H

#include "generated_curved_meshes.h"
#include "generated_flat_meshes.h"
#include "geodesic_types.h"
#include "locations.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// Results for the meshes of one kind.
struct Section_counts
{
  std::size_t meshes = 0, planes = 0, segments = 0, touched_edges = 0, faces_in_plane = 0, signs = 0;
  std::size_t wrong = 0; // planes
};

class Section_search
{
public:
  typedef Geodesic::Plane_3 Plane_3;
  typedef Geodesic::Face_location Face_location;
  typedef Surface_mesh::Vertex_index Vertex_index;
  typedef Surface_mesh::Halfedge_index Halfedge_index;
  typedef Surface_mesh::Face_index Face_index;

  /// Up to `printed` wrong planes are written to `log`.
  Section_search(std::ostream& log, std::size_t printed, std::size_t planes) : log_(log), printed_(printed), planes_(planes) {}

  /// Runs the case that a seed determines: a mesh and its planes.
  void run(unsigned seed)
  {
    random_.seed(seed);
    for (int i = 0; i < 8; ++i) random_();
    std::string kind;
    const Soup soup = make_mesh(seed, kind);
    Section_counts& counts = counts_[kind];
    ++counts.meshes;
    const Generated_mesh<Surface_mesh> data(soup);
    mesh_ = &data.mesh;
    const Locations<Surface_mesh> locations(data.mesh);
    locations_ = &locations;
    const Geodesic geodesic(data.mesh);
    for (std::size_t i = 0; i < planes_; ++i)
    {
      const Plane_3 plane = make_plane();
      fault_.clear();
      check(geodesic, plane, counts);
      ++counts.planes;
      if (fault_.empty()) continue;
      ++counts.wrong;
      if (printed_ == 0) continue;
      --printed_;
      log_ << kind << ", seed " << seed << ", plane " << i << ": " << fault_ << std::endl;
    }
  }

  const std::map<std::string, Section_counts>& counts() const { return counts_; }

private:
  // A point of a section as it is in the mesh: the ends of the edge that it is inside of, or twice a vertex.
  typedef std::array<Vertex_index, 2> Place;
  typedef std::pair<Place, Place> Directed_segment;
  typedef std::multiset<Directed_segment> Segments;

  // What a section must be.
  struct Expected
  {
    Segments segments;
    std::set<Surface_mesh::Edge_index> touched_edges;
    std::set<Vertex_index> touched_vertices;
    std::size_t faces = 0;
  };

  Soup make_mesh(unsigned seed, std::string& kind)
  {
    switch (uniform_index(random_, 8))
    {
    case 0: return kind = "terraces", terraces(2 + uniform_index(random_, 5), 1, seed);
    case 1: return kind = "ridges", terraces(2 + uniform_index(random_, 5), 2, seed);
    case 2: return kind = "cubes", cube_grid(1 + uniform_index(random_, 3));
    case 3: return kind = "closed terraces", closed_terraces(2 + uniform_index(random_, 4), seed);
    case 4: return kind = "spheres", icosphere(uniform_index(random_, 3));
    case 5: return kind = "genus 5", marching_genus_5(6);
    case 6: return kind = "fans", fan();
    default: return kind = "turned terraces", rotated(terraces(2 + uniform_index(random_, 5), 1, seed), seed);
    }
  }

  // A grid with heights that are small integers: planes contain many of its vertices, edges and faces.
  Soup terraces(std::size_t n, int height, unsigned seed)
  {
    Soup soup = planar_grid(n, 1 + uniform_index(random_, 5), Diagonals::random, 1, 0, seed);
    for (Point_3& p : soup.points) p = Point_3(p.x(), p.y(), integer(height));
    return soup;
  }

  // Two such grids, one above the other, joined along their border.
  Soup closed_terraces(std::size_t n, unsigned seed)
  {
    const std::size_t m = 2 + uniform_index(random_, 3);
    const Soup grid = planar_grid(n, m, Diagonals::forward, 1, 0, seed);
    const auto is_border = [&](const Point_3& p) {
      return p.x() == 0 || p.y() == 0 || p.x() == double(n) || p.y() == double(m);
    };
    Soup soup;
    std::vector<std::size_t> below(grid.points.size());
    for (const Point_3& p : grid.points)
      soup.points.push_back(Point_3(p.x(), p.y(), is_border(p) ? integer(1) : 3 + integer(1)));
    for (std::size_t v = 0; v < grid.points.size(); ++v)
    {
      below[v] = v;
      const Point_3& p = grid.points[v];
      if (is_border(p)) continue;
      below[v] = soup.points.size();
      soup.points.push_back(Point_3(p.x(), p.y(), -3 + integer(1)));
    }
    // without triangles that have three corners on the border: they would be there twice
    const auto has_inner = [&](const std::array<std::size_t, 3>& t) {
      return std::any_of(t.begin(), t.end(), [&](std::size_t v) { return below[v] != v; });
    };
    for (const auto& t : grid.triangles)
    {
      if (!has_inner(t)) continue;
      soup.add_triangle(t);
      soup.add_triangle({{below[t[1]], below[t[0]], below[t[2]]}});
    }
    return soup;
  }

  // A vertex with faces around it, at heights that are small integers.
  Soup fan()
  {
    Soup soup;
    const std::size_t n = 3 + uniform_index(random_, 10);
    const bool is_closed = uniform(random_) < 0.7;
    soup.points.push_back(Point_3(0, 0, 0));
    for (std::size_t i = 0; i < n; ++i)
    {
      const double angle = (is_closed ? 2 : 1.5) * CGAL_PI * double(i) / double(n);
      soup.points.push_back(Point_3(std::cos(angle), std::sin(angle), integer(1)));
    }
    for (std::size_t i = 0; i + (is_closed ? 0 : 1) < n; ++i) soup.add_triangle({{0, 1 + i, 1 + (i + 1) % n}});
    return soup;
  }

  int integer(int largest) { return int(uniform_index(random_, std::size_t(2 * largest + 1))) - largest; }

  Vertex_index vertex() { return Vertex_index(std::uint32_t(uniform_index(random_, num_vertices(*mesh_)))); }

  Plane_3 make_plane()
  {
    const Point_3 p = mesh_->point(vertex());
    const double choice = uniform(random_);
    if (choice < 0.45)
    { // horizontal, through a vertex or half a step above it
      const double up = uniform(random_) < 0.5 ? 1 : -1;
      return Plane_3(0, 0, up, -up * (p.z() + (uniform(random_) < 0.3 ? 0.5 : 0)));
    }
    if (choice < 0.75)
    {
      Vector_3 normal(integer(1), integer(1), integer(1));
      if (normal == CGAL::NULL_VECTOR) normal = Vector_3(0, 1, 0);
      return Plane_3(p, normal);
    }
    if (choice < 0.9)
    { // through three vertices; rounding may leave no normal
      const Point_3 q = mesh_->point(vertex()), r = mesh_->point(vertex());
      const Plane_3 plane(p, q, r);
      if (!CGAL::collinear(p, q, r) && !plane.is_degenerate()) return plane;
    }
    return Plane_3(p + Vector_3(uniform(random_, -0.5, 0.5), uniform(random_, -0.5, 0.5), uniform(random_, -0.5, 0.5)),
                   Vector_3(uniform(random_, -1, 1), uniform(random_, -1, 1), uniform(random_, 0.1, 1)));
  }

  void fail(const std::string& what)
  {
    if (fault_.empty()) fault_ = what;
  }

  void decide_signs(const Plane_3& plane)
  {
    typedef CGAL::Exact_rational Rational;
    sign_.clear();
    least_height_ = 1;
    for (Vertex_index v : vertices(*mesh_))
    {
      const Point_3& p = mesh_->point(v);
      const Rational h = Rational(plane.a()) * Rational(p.x()) + Rational(plane.b()) * Rational(p.y()) +
                         Rational(plane.c()) * Rational(p.z()) + Rational(plane.d());
      sign_.push_back(h > 0 ? 1 : h < 0 ? -1 : 0);
      if (h != 0) least_height_ = (std::min)(least_height_, std::abs(CGAL::to_double(h)));
    }
  }
  int sign(Vertex_index v) const { return sign_[std::size_t(v)]; }

  std::array<Vertex_index, 3> corners(Face_index f) const { return locations_->corners(f); }

  static Place at(Vertex_index v) { return {v, v}; }
  static Place between(Vertex_index v, Vertex_index w) { return {(std::min)(v, w), (std::max)(v, w)}; }

  // The sign of the face beside an edge in the plane; 0 if it is in the plane, or missing.
  int sign_beside(Halfedge_index h) const { return mesh_->is_border(h) ? 0 : sign(target(next(h, *mesh_), *mesh_)); }

  Expected expected() const
  {
    Expected result;
    std::vector<char> has_more(num_vertices(*mesh_), 0);
    for (Face_index f : faces(*mesh_))
    {
      const auto c = corners(f);
      std::array<int, 3> s;
      for (std::size_t k = 0; k < 3; ++k) s[k] = sign(c[k]);
      if (s[0] == 0 && s[1] == 0 && s[2] == 0)
      {
        ++result.faces;
        for (Vertex_index v : c) has_more[v] = 1;
      }
      const auto [low, high] = std::minmax_element(s.begin(), s.end());
      if (*low >= 0 || *high <= 0) continue;
      // Counterclockwise round the face, the section starts where positive corners end, and ends where they start: between
      // these two points the negative corners are on its right.
      Place from{}, to{};
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
        if (s[k] > 0 && s[l] < 0) from = between(c[k], c[l]);
        if (s[k] < 0 && s[l] > 0) to = between(c[k], c[l]);
        if (s[l] != 0) continue;
        has_more[c[l]] = 1;
        if (s[k] > 0 && s[m] < 0) from = at(c[l]);
        if (s[k] < 0 && s[m] > 0) to = at(c[l]);
      }
      result.segments.insert({from, to});
    }
    for (auto e : edges(*mesh_))
    {
      const Halfedge_index h = halfedge(e, *mesh_);
      const Vertex_index v = source(h, *mesh_), w = target(h, *mesh_);
      if (sign(v) != 0 || sign(w) != 0) continue;
      const int left = sign_beside(h), right = sign_beside(opposite(h, *mesh_));
      const bool is_inside = left == 0 && right == 0 && !mesh_->is_border(e);
      if (is_inside) continue;
      has_more[v] = has_more[w] = 1;
      if (left == right) result.touched_edges.insert(e);
      else result.segments.insert(left > right ? Directed_segment(at(v), at(w)) : Directed_segment(at(w), at(v)));
    }
    for (Vertex_index v : vertices(*mesh_))
      if (sign(v) == 0 && !has_more[v] && !mesh_->is_isolated(v)) result.touched_vertices.insert(v);
    return result;
  }

  Place place(const Face_location& l) const
  {
    const auto support = locations_->support(l);
    return support.size() == 1 ? at(support[0].first) : between(support[0].first, support[1].first);
  }

  Segments segments_of(const Geodesic::Plane_section& section)
  {
    Segments result;
    for (const auto& polyline : section.polylines)
    {
      const auto& l = polyline.locations;
      for (const Face_location& p : l)
        if (locations_->support(p).size() > 2) fail("a point inside a face");
      if (l.size() < 2) fail("a polyline of less than two points");
      for (std::size_t i = 0; i + (polyline.is_closed ? 0 : 1) < l.size(); ++i)
        result.insert({place(l[i]), place(l[(i + 1) % l.size()])});
    }
    return result;
  }

  // Polylines end where they must, and nowhere else.
  void check_ends(const Geodesic::Plane_section& section, const Segments& segments)
  {
    std::map<Place, std::pair<std::size_t, std::size_t>> degree; // segments that end there, and that start there
    for (const Directed_segment& s : segments)
    {
      ++degree[s.first].second;
      ++degree[s.second].first;
    }
    const auto is_passed = [&](const Face_location& l) {
      return degree[place(l)] == std::make_pair(std::size_t(1), std::size_t(1));
    };
    for (const auto& polyline : section.polylines)
    {
      const auto& l = polyline.locations;
      for (std::size_t i = 0; i < l.size(); ++i)
      {
        const bool is_end = i == 0 || (i + 1 == l.size() && !polyline.is_closed);
        if (!is_end && !is_passed(l[i])) fail("a polyline goes on where several meet");
        if (is_end && !polyline.is_closed && is_passed(l[i])) fail("a polyline ends where it goes on");
      }
    }
  }

  void check(const Geodesic& geodesic, const Plane_3& plane, Section_counts& counts)
  {
    decide_signs(plane);
    const Expected expect = expected();
    const Geodesic::Plane_section section = geodesic.plane_section(plane);
    const Segments segments = segments_of(section);
    counts.segments += segments.size();
    counts.touched_edges += expect.touched_edges.size();
    counts.faces_in_plane += expect.faces;
    if (segments != expect.segments) fail("the segments, or their directions, are not as expected");
    if (section.number_of_faces_in_plane != expect.faces) fail("faces in the plane");
    if (section.touched_edges.size() != expect.touched_edges.size() ||
        !std::all_of(section.touched_edges.begin(), section.touched_edges.end(),
                     [&](auto e) { return expect.touched_edges.count(e) == 1; }))
      fail("touched edges");
    if (section.touched_vertices.size() != expect.touched_vertices.size() ||
        !std::all_of(section.touched_vertices.begin(), section.touched_vertices.end(),
                     [&](auto v) { return expect.touched_vertices.count(v) == 1; }))
      fail("touched vertices");
    check_ends(section, segments);
    // the other way round from the other side
    Segments reversed;
    for (const Directed_segment& s : segments_of(geodesic.plane_section(plane.opposite())))
      reversed.insert({s.second, s.first});
    if (reversed != segments) fail("the opposite plane has another section");
    check_signed_distances(plane, section.polylines, counts);
  }

  // Where the shortest path from a vertex stays in a face, the sign of the distance is that of the vertex. Not where vertices are
  // beside the plane by rounding: there two lines of the section may coincide up to rounding, with the same side between them.
  void check_signed_distances(const Plane_3& plane, const std::vector<Geodesic::Polyline>& polylines, Section_counts& counts)
  {
    if (least_height_ < 1e-9) return;
    Geodesic alone(*mesh_); // the ids are the numbers of the polylines
    alone.add_source_plane_section(plane);
    if (alone.number_of_sources() == 0) return;
    alone.build();
    for (Vertex_index v : vertices(*mesh_))
    {
      if (sign(v) == 0) continue;
      const double d = or_nan(alone.signed_distance_to_sources(v));
      std::vector<Face_location> path;
      alone.shortest_path_to_sources(v, std::back_inserter(path));
      if (path.size() != 2 || std::isnan(d)) continue;
      const Face_index f = locations_->common_face(path[0], path[1]);
      if (f == Surface_mesh::null_face() || locations_->support(path[1]).size() == 1) continue;
      const auto nearest = alone.nearest_source(v);
      if (!nearest || !nearest->is_segment || nearest->source >= polylines.size()) continue;
      ++counts.signs;
      if ((d < 0) != (sign(v) > 0)) fail("the sign of the distance of vertex " + std::to_string(std::size_t(v)));
    }
  }

  std::ostream& log_;
  std::size_t printed_, planes_;
  Random random_;
  const Surface_mesh* mesh_ = nullptr;
  const Locations<Surface_mesh>* locations_ = nullptr;
  std::vector<int> sign_;   // of the vertices
  double least_height_ = 1; // of vertices that are not in the plane, in the length of its normal
  std::string fault_;
  std::map<std::string, Section_counts> counts_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_SECTION_SEARCH_H
