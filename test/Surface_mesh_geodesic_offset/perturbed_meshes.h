// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Damaged meshes: perturbed coordinates, other faces of the same surface, missing faces.

#ifndef GEODESIC_OFFSET_TEST_PERTURBED_MESHES_H
#define GEODESIC_OFFSET_TEST_PERTURBED_MESHES_H

#include "geodesic_types.h"
#include "search_cases.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// Points and triangles of a mesh. A mesh to which these triangles are added in their order has the same first halfedges.
inline Soup soup_of(const Surface_mesh& mesh)
{
  Soup soup;
  std::vector<std::size_t> number(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  for (const auto v : mesh.vertices())
  {
    number[v] = soup.points.size();
    soup.points.push_back(mesh.point(v));
  }
  for (const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    soup.add_triangle({{number[mesh.target(h)], number[mesh.target(mesh.next(h))], number[mesh.source(h)]}});
  }
  return soup;
}

/// Mesh of a soup; non-manifold vertices are duplicated.
inline Surface_mesh manifold_of(Soup soup)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  PMP::orient_polygon_soup(soup.points, soup.triangles);
  Surface_mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
  return mesh;
}

/// Whether the sine of an angle of a triangle is below 2^-20: flips with such triangles turn rounding errors into needles.
inline bool is_thin(const Point_3& p, const Point_3& q, const Point_3& r)
{
  const Vector_3 u = q - p, v = r - q, w = p - r;
  const double longest = (std::max)({u.squared_length(), v.squared_length(), w.squared_length()});
  return !(CGAL::cross_product(u, v).squared_length() > 0x1p-40 * longest * longest);
}

/// Other triangulation of the same surface: faces and edges are divided at random points, and edges between coplanar faces
/// are flipped. Exact except for the rounding of new points. With `only_middles`, new points are exactly on edges, and none
/// is inside a face. `part`: fraction of faces and edges to divide. `divided`, if given, receives the divided edges in the
/// order of their new vertices. Returns the number of flips.
inline std::size_t retriangulate(Surface_mesh& mesh, Random& random, double part, bool only_middles,
                                 std::vector<Surface_mesh::Edge_index>* divided = nullptr)
{
  const std::vector<Surface_mesh::Edge_index> edges(mesh.edges().begin(), mesh.edges().end());
  const std::vector<Surface_mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  if (!only_middles)
    for (const auto f : faces)
    {
      if (uniform(random) >= part) continue;
      const auto h = mesh.halfedge(f);
      const std::array<double, 3> w = random_barycentric(random);
      const Point_3 p = CGAL::barycenter(mesh.point(mesh.source(h)), w[0], mesh.point(mesh.target(h)), w[1],
                                         mesh.point(mesh.target(mesh.next(h))), w[2]);
      mesh.point(mesh.target(CGAL::Euler::add_center_vertex(h, mesh))) = p;
    }
  for (const auto e : edges)
  {
    if (uniform(random) >= part) continue;
    const auto h = mesh.halfedge(e);
    const double t = only_middles ? 0.5 : uniform(random, 0.05, 0.95);
    const Point_3 &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h));
    const Point_3 between((1 - t) * p.x() + t * q.x(), (1 - t) * p.y() + t * q.y(), (1 - t) * p.z() + t * q.z());
    const auto n = CGAL::Euler::split_edge(h, mesh); // ends at the new vertex
    mesh.point(mesh.target(n)) = between;
    if (divided != nullptr) divided->push_back(e);
    for (const auto side : {n, mesh.prev(mesh.opposite(n))})
      if (!mesh.is_border(side)) CGAL::Euler::split_face(side, mesh.next(mesh.next(side)), mesh);
  }
  // where two faces form a convex quadrangle in a plane
  std::size_t flips = 0;
  for (const auto e : std::vector<Surface_mesh::Edge_index>(mesh.edges().begin(), mesh.edges().end()))
  {
    if (mesh.is_border(e) || uniform(random) < 0.5) continue;
    const auto h = mesh.halfedge(e), o = mesh.opposite(h);
    const auto a = mesh.source(h), b = mesh.target(h), c = mesh.target(mesh.next(h)), d = mesh.target(mesh.next(o));
    if (c == d || mesh.halfedge(c, d) != Surface_mesh::null_halfedge()) continue;
    const Point_3 &pa = mesh.point(a), &pb = mesh.point(b), &pc = mesh.point(c), &pd = mesh.point(d);
    if (!CGAL::coplanar(pa, pb, pc, pd) || is_thin(pa, pb, pc) || is_thin(pa, pb, pd) || is_thin(pa, pc, pd) ||
        is_thin(pb, pc, pd))
      continue;
    if (CGAL::coplanar_orientation(pc, pd, pa, pb) == CGAL::NEGATIVE &&
        CGAL::coplanar_orientation(pa, pb, pc, pd) == CGAL::NEGATIVE)
    {
      CGAL::Euler::flip_edge(h, mesh);
      ++flips;
    }
  }
  return flips;
}

/// Named perturbations of the corpus. Each changes a triangle soup.
class Perturbations
{
public:
  typedef void (*Function)(Soup&, Random&);

  static const std::vector<std::pair<std::string, Function>>& all()
  {
    static const std::vector<std::pair<std::string, Function>> functions = {
      {"as it is", [](Soup&, Random&) {}},
      {"snapped", snap},
      {"jitter", jitter},
      {"axis x 1000", stretch},
      {"float", round},
      {"decimated", decimate},
      {"ragged", ragged},
      {"other faces", divide},
      {"moved by 1e7", move}};
    return functions;
  }

private:
  // The longest side of the bounding box.
  static double size_of(const Soup& soup)
  {
    const CGAL::Bbox_3 box = CGAL::bbox_3(soup.points.begin(), soup.points.end());
    return (std::max)({box.x_span(), box.y_span(), box.z_span()});
  }

  // Rounds coordinates on some of the axes to multiples of a step, so that faces become coplanar, or have no area.
  static void snap(Soup& soup, Random& random)
  {
    const double step = size_of(soup) / uniform(random, 10, 200);
    const std::size_t axes = 1 + uniform_index(random, 7); // one bit per axis
    for (Point_3& p : soup.points)
    {
      double x[3] = {p.x(), p.y(), p.z()};
      for (std::size_t i = 0; i < 3; ++i)
        if (axes >> i & 1) x[i] = step * std::round(x[i] / step);
      p = Point_3(x[0], x[1], x[2]);
    }
  }

  static void jitter(Soup& soup, Random& random)
  {
    add_noise(soup, random, log_uniform(random, -12, -3) * size_of(soup), {{true, true, true}});
  }

  static void stretch(Soup& soup, Random& random)
  {
    double factor[3] = {1, 1, 1};
    factor[uniform_index(random, 3)] = uniform(random) < 0.5 ? 1000 : 0.001;
    for (Point_3& p : soup.points) p = Point_3(factor[0] * p.x(), factor[1] * p.y(), factor[2] * p.z());
  }

  static void round(Soup& soup, Random&) { round_to_float(soup); }

  static void decimate(Soup& soup, Random& random)
  {
    namespace SMS = CGAL::Surface_mesh_simplification;
    Surface_mesh mesh = manifold_of(soup);
    const double part = uniform(random, 0.05, 0.8); // fraction of edges to collapse
    SMS::edge_collapse(mesh, [part](const auto&, const auto&, std::size_t before, std::size_t now) {
      return double(now) < part * double(before);
    });
    soup = soup_of(mesh);
  }

  // Removes some faces.
  static void ragged(Soup& soup, Random& random)
  {
    const double part = uniform(random, 0.01, 0.5);
    Soup rest;
    rest.points = soup.points;
    for (const auto& t : soup.triangles)
      if (uniform(random) >= part) rest.add_triangle(t);
    if (!rest.triangles.empty()) soup = std::move(rest);
  }

  static void divide(Soup& soup, Random& random)
  {
    Surface_mesh mesh = manifold_of(soup);
    retriangulate(mesh, random, uniform(random, 0.01, 0.3), false);
    soup = soup_of(mesh);
  }

  // Translates so far that coordinates have 9 digits left.
  static void move(Soup& soup, Random& random)
  {
    double shift[3];
    for (double& s : shift) s = (uniform(random) < 0.5 ? -1e7 : 1e7) * size_of(soup);
    for (Point_3& p : soup.points) p = Point_3(p.x() + shift[0], p.y() + shift[1], p.z() + shift[2]);
  }
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_PERTURBED_MESHES_H
