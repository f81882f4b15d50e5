// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Generates the mesh of the example: a vase with two handles, about 50,000 faces, with saddles at the ends of the handles,
// genus two, and sharp edges at the rim and around the foot.
//
//   generate_example_mesh MESH.off [CURVE.polylines.txt]
//
// CURVE is a closed wave around the belly of the vase.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <unordered_map>
#include <utility>
#include <vector>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;

constexpr double pi = 3.14159265358979323846;
constexpr double foot = 0.0;
constexpr double rim = 2.42;
constexpr double cell = 0.025; // of the grid
constexpr double edge_length = 0.0288;

double bump(double x, double center, double width) { return std::exp(-(x - center) * (x - center) / (width * width)); }

double outer_radius(double y)
{
  return 0.30 + 0.62 * bump(y, 0.92, 0.60) + 0.24 * bump(y, 2.58, 0.32) + 0.20 * bump(y, -0.12, 0.26);
}
double inner_radius(double y) { return outer_radius(y) - 0.085; }

// Divides by the length of the gradient, so that values approximate distances.
double revolved(const Point& p, double (*radius)(double))
{
  const double h = 1e-4, slope = (radius(p.y() + h) - radius(p.y() - h)) / (2 * h);
  return (std::hypot(p.x(), p.z()) - radius(p.y())) / std::sqrt(1 + slope * slope);
}

double smooth_minimum(double a, double b, double width)
{
  const double t = std::max(width - std::abs(a - b), 0.0) / width;
  return std::min(a, b) - 0.25 * width * t * t;
}

double handle(const Point& p)
{
  // a ring that leans outwards, in the plane z = 0
  const double x = std::abs(p.x()) - 0.60, y = p.y() - 1.66;
  const double u = 0.94 * x + 0.34 * y, v = 0.94 * y - 0.34 * x;
  const double ring = std::hypot(u / 1.02, v / 1.12) - 0.44;
  return std::hypot(ring, p.z() / 1.15) - 0.085;
}

// Negative inside the clay. The vase extends slightly beyond foot and rim, where it is cut off later.
double vase(const Point& p)
{
  const double outside = smooth_minimum(revolved(p, outer_radius), handle(p), 0.17);
  // negative in the cavity: inside its wall and above its floor, with a rounded transition
  const double cavity = -smooth_minimum(-revolved(p, inner_radius), p.y() - 1.45, 0.25);
  const double solid = std::max(outside, -cavity);
  return std::max(solid, std::max(foot - 0.06 - p.y(), p.y() - rim - 0.06));
}

// Intersections with the planes of the cuts are rounded.
bool is_on_cut(const Point& p) { return std::abs(p.y() - foot) < 1e-7 || std::abs(p.y() - rim) < 1e-7; }

Vector gradient(const Point& p)
{
  const double h = 1e-5;
  const auto difference = [&](const Vector& d) { return (vase(p + h * d) - vase(p - h * d)) / (2 * h); };
  return Vector(difference(Vector(1, 0, 0)), difference(Vector(0, 1, 0)), difference(Vector(0, 0, 1)));
}

// Marching tetrahedra: six per cell, all along the same diagonal, so that neighbouring cells fit.
class Marching_tetrahedra
{
  static constexpr int nx = 112, ny = 106, nz = 84;

  std::vector<double> m_values;
  std::vector<Point> m_points;
  std::vector<std::array<std::size_t, 3>> m_triangles;
  std::unordered_map<std::uint64_t, std::size_t> m_point_of_edge;

  static std::size_t index(int i, int j, int k)
  {
    return (static_cast<std::size_t>(k) * (ny + 1) + static_cast<std::size_t>(j)) * (nx + 1) + static_cast<std::size_t>(i);
  }
  static Point position(std::size_t n)
  {
    const double i = static_cast<double>(n % (nx + 1)), j = static_cast<double>(n / (nx + 1) % (ny + 1)),
                 k = static_cast<double>(n / (nx + 1) / (ny + 1));
    return Point((i - 0.5 * nx) * cell, foot - 0.11 + j * cell, (k - 0.5 * nz) * cell);
  }

  std::size_t crossing(std::size_t a, std::size_t b)
  {
    if(a > b) std::swap(a, b);
    const auto inserted = m_point_of_edge.emplace(static_cast<std::uint64_t>(a) * m_values.size() + b, m_points.size());
    if(inserted.second)
    {
      // bisection; away from the ends, so that no triangle degenerates
      const Point p = position(a);
      const Vector d = position(b) - p;
      double low = 0, high = 1;
      for(int i = 0; i < 30; ++i)
      {
        const double middle = 0.5 * (low + high);
        ((vase(p + middle * d) < 0) == (m_values[a] < 0) ? low : high) = middle;
      }
      m_points.push_back(p + std::min(std::max(low, 0.02), 0.98) * d);
    }
    return inserted.first->second;
  }

  void add_tetrahedron(const std::array<std::size_t, 4>& t)
  {
    std::vector<std::size_t> in, out;
    for(std::size_t v : t) (m_values[v] < 0 ? in : out).push_back(v);
    if(in.size() == 1)
      m_triangles.push_back({crossing(in[0], out[0]), crossing(in[0], out[1]), crossing(in[0], out[2])});
    else if(in.size() == 3)
      m_triangles.push_back({crossing(out[0], in[0]), crossing(out[0], in[1]), crossing(out[0], in[2])});
    else if(in.size() == 2)
    {
      const std::size_t a = crossing(in[0], out[0]), b = crossing(in[0], out[1]), c = crossing(in[1], out[1]),
                        d = crossing(in[1], out[0]);
      m_triangles.push_back({a, b, c});
      m_triangles.push_back({a, c, d});
    }
  }

public:
  Mesh operator()()
  {
    m_values.resize(index(nx, ny, nz) + 1);
    for(std::size_t n = 0; n < m_values.size(); ++n) m_values[n] = vase(position(n));
    for(int k = 0; k < nz; ++k)
      for(int j = 0; j < ny; ++j)
        for(int i = 0; i < nx; ++i)
        {
          // paths from one corner to the opposite one, one axis at a time
          for(const std::array<int, 3>& order :
              {std::array<int, 3>{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}})
          {
            std::array<int, 3> c{i, j, k};
            std::array<std::size_t, 4> tetrahedron{index(i, j, k), 0, 0, 0};
            for(std::size_t s = 0; s < 3; ++s)
            {
              ++c[static_cast<std::size_t>(order[s])];
              tetrahedron[s + 1] = index(c[0], c[1], c[2]);
            }
            add_tetrahedron(tetrahedron);
          }
        }
    PMP::orient_polygon_soup(m_points, m_triangles);
    Mesh mesh;
    PMP::polygon_soup_to_polygon_mesh(m_points, m_triangles, mesh);
    if(!PMP::is_outward_oriented(mesh)) PMP::reverse_face_orientations(mesh);
    return mesh;
  }
};

// Projects the smooth parts back to the surface, and the sharp edges to the intersections with the planes of foot and rim.
void project(Mesh& mesh)
{
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    Point p = mesh.point(v);
    const bool on_cut = is_on_cut(p);
    if(on_cut)
    {
      p = Point(p.x(), std::abs(p.y() - foot) < 1e-7 ? foot : rim, p.z());
      bool at_edge = false;
      for(Mesh::Vertex_index w : CGAL::vertices_around_target(v, mesh)) at_edge = at_edge || !is_on_cut(mesh.point(w));
      if(!at_edge)
      {
        mesh.point(v) = p;
        continue;
      }
    }
    for(int i = 0; i < 8; ++i)
    {
      Vector g = gradient(p);
      if(on_cut) g = Vector(g.x(), 0, g.z());
      p = p - (vase(p) / g.squared_length()) * g;
    }
    mesh.point(v) = p;
  }
}

Mesh make_vase()
{
  Mesh mesh = Marching_tetrahedra()();
  PMP::clip(mesh, Kernel::Plane_3(0, -1, 0, foot), CGAL::parameters::clip_volume(true));
  PMP::clip(mesh, Kernel::Plane_3(0, 1, 0, -rim), CGAL::parameters::clip_volume(true));
  auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  for(Mesh::Edge_index e : mesh.edges())
  {
    // between a face on a cut and one across it
    const auto is_cut = [&](Mesh::Halfedge_index h) {
      const auto around = mesh.vertices_around_face(h);
      return std::all_of(around.begin(), around.end(), [&](Mesh::Vertex_index v) { return is_on_cut(mesh.point(v)); });
    };
    const Mesh::Halfedge_index h = mesh.halfedge(e);
    sharp[e] = is_cut(h) != is_cut(mesh.opposite(h));
  }
  PMP::isotropic_remeshing(faces(mesh), edge_length, mesh,
                           CGAL::parameters::number_of_iterations(8)
                             .number_of_relaxation_steps(2)
                             .edge_is_constrained_map(sharp)
                             .collapse_constraints(true)
                             .relax_constraints(true));
  mesh.collect_garbage();
  project(mesh);
  return mesh;
}

void write_curve(std::ostream& out)
{
  constexpr int n = 240;
  out << n + 1;
  for(int i = 0; i <= n; ++i)
  {
    const double angle = 2 * pi * (i % n) / n, y = 0.80 + 0.2 * std::cos(5 * angle + 0.5 * pi);
    out << ' ' << outer_radius(y) * std::cos(angle) << ' ' << y << ' ' << outer_radius(y) * std::sin(angle);
  }
  out << '\n';
}

} // namespace

int main(int argc, char* argv[])
{
  if(argc < 2 || argc > 3)
  {
    std::cerr << "usage: generate_example_mesh MESH.off [CURVE.polylines.txt]" << std::endl;
    return 2;
  }
  try
  {
    const Mesh mesh = make_vase();
    std::ofstream mesh_file(argv[1]);
    mesh_file.precision(17);
    mesh_file << mesh;
    mesh_file.close();
    if(!mesh_file)
    {
      std::cerr << "generate_example_mesh: cannot write '" << argv[1] << "'" << std::endl;
      return 1;
    }
    if(argc == 3)
    {
      std::ofstream curve_file(argv[2]);
      curve_file.precision(17);
      write_curve(curve_file);
      curve_file.close();
      if(!curve_file)
      {
        std::cerr << "generate_example_mesh: cannot write '" << argv[2] << "'" << std::endl;
        return 1;
      }
    }
    std::cout << "generated " << mesh.number_of_vertices() << " vertices, " << mesh.number_of_faces() << " faces" << std::endl;
  }
  catch(const std::exception& error)
  {
    std::cerr << "generate_example_mesh: " << error.what() << std::endl;
    return 1;
  }
  return 0;
}
