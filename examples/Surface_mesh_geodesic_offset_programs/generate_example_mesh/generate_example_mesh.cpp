// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Generates the mesh of the example: a vase with two handles, about 50,000 faces, with saddles at the ends of the handles,
// genus two, and sharp edges at the rim and around the foot.
//
//   generate_example_mesh MESH.off [CURVE.polylines.txt]
//
// CURVE is a closed wave around the belly of the vase.
//
// Does without CGAL, whose functions for clipping and remeshing take a compiler two minutes.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double foot = 0.0;
constexpr double rim = 2.42;

struct Vector
{
  double x, y, z;
};
Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator*(double s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
double operator*(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double twice_area(const Vector& a, const Vector& b)
{
  return std::hypot(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

double bump(double x, double center, double width) { return std::exp(-(x - center) * (x - center) / (width * width)); }

double outer_radius(double y)
{
  return 0.30 + 0.62 * bump(y, 0.92, 0.60) + 0.24 * bump(y, 2.58, 0.32) + 0.20 * bump(y, -0.12, 0.26);
}

double smooth_minimum(double a, double b, double width)
{
  const double t = std::max(width - std::abs(a - b), 0.0) / width;
  return std::min(a, b) - 0.25 * width * t * t;
}

double handle(const Vector& p)
{
  // a ring that leans outwards, in the plane z = 0
  const double x = std::abs(p.x) - 0.60, y = p.y - 1.66;
  const double u = 0.94 * x + 0.34 * y, v = 0.94 * y - 0.34 * x;
  const double ring = std::hypot(u / 1.02, v / 1.12) - 0.44;
  return std::hypot(ring, p.z / 1.15) - 0.085;
}

// Negative inside the clay. The vase extends beyond foot and rim, where it is cut off.
double clay(const Vector& p)
{
  const double h = 1e-4, slope = (outer_radius(p.y + h) - outer_radius(p.y - h)) / (2 * h);
  const double scale = 1 / std::sqrt(1 + slope * slope); // so that values approximate distances
  const double outer = scale * (std::hypot(p.x, p.z) - outer_radius(p.y)), inner = outer + scale * 0.085;
  // positive in the cavity: inside its wall and above its floor, with a rounded transition
  const double cavity = smooth_minimum(-inner, p.y - 1.45, 0.25);
  return std::max(smooth_minimum(outer, handle(p), 0.17), cavity);
}

// The mesh. The halfedges of face f are 3 f, 3 f + 1 and 3 f + 2, in their order around the face.
class Vase
{
  enum class Part { wall, cut, sharp_edge };

  static constexpr std::size_t nx = 78, ny = 80, nz = 64; // cells of the grid
  static constexpr double cell = (rim - foot) / (ny - 1); // foot and rim are in the middle of the first and the last layer
  static constexpr std::array<std::size_t, 3> step{1, nx + 1, (nx + 1) * (ny + 1)}; // from corner to corner, along each axis

  std::vector<bool> m_is_inside; // per corner of the grid
  std::unordered_map<std::size_t, std::size_t> m_vertex; // of a cell, which has the number of its first corner
  std::vector<Vector> m_points; // per vertex
  std::vector<Part> m_parts; // per vertex: the part of the surface that it is on
  std::vector<std::size_t> m_source, m_opposite; // per halfedge

public:
  Vase()
  {
    make_faces();
    find_opposite_halfedges();
    for(int i = 0; i < 20; ++i)
    {
      flip_edges();
      relax();
    }
    flip_edges();
  }

  std::size_t number_of_vertices() const { return m_points.size(); }
  std::size_t number_of_faces() const { return m_source.size() / 3; }

  void write(std::ostream& out) const
  {
    out << "OFF\n" << number_of_vertices() << ' ' << number_of_faces() << " 0\n";
    for(const Vector& p : m_points) out << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for(std::size_t h = 0; h < m_source.size(); h += 3)
      out << "3 " << m_source[h] << ' ' << m_source[h + 1] << ' ' << m_source[h + 2] << '\n';
  }

private:
  // Surface net: a vertex in each cell that the surface crosses, two faces around each edge of the grid that it crosses.
  void make_faces()
  {
    for(std::size_t n = 0; n < step[2] * (nz + 1); ++n)
    {
      const Vector p = position(n, 0);
      m_is_inside.push_back(p.y > foot && p.y < rim && clay(p) < 0);
    }
    for(std::size_t n = 0; n + step[2] < m_is_inside.size(); ++n)
      for(std::size_t axis = 0; axis < 3; ++axis)
      {
        if(m_is_inside[n] == m_is_inside[n + step[axis]]) continue;
        std::size_t u = step[(axis + 1) % 3], v = step[(axis + 2) % 3];
        if(m_is_inside[n + step[axis]]) std::swap(u, v);
        const std::size_t a = vertex(n), b = vertex(n - u), c = vertex(n - u - v), d = vertex(n - v);
        m_source.insert(m_source.end(), {a, b, c, a, c, d});
      }
  }

  static Vector position(std::size_t n, double shift)
  {
    const auto coordinate = [&](std::size_t i, double middle) { return (static_cast<double>(i) + shift - middle) * cell; };
    return {coordinate(n % step[1], 0.5 * nx), foot + coordinate(n % step[2] / step[1], 0.5),
            coordinate(n / step[2], 0.5 * nz)};
  }

  std::size_t vertex(std::size_t n)
  {
    const auto inserted = m_vertex.emplace(n, m_points.size());
    if(!inserted.second) return inserted.first->second;
    const std::size_t layer = n % step[2] / step[1], i = layer == 0 ? n + step[1] : n; // a corner between foot and rim
    const bool all =
      m_is_inside[i] && m_is_inside[i + step[0]] && m_is_inside[i + step[2]] && m_is_inside[i + step[0] + step[2]];
    m_parts.push_back(layer > 0 && layer < ny - 1 ? Part::wall : all ? Part::cut : Part::sharp_edge);
    m_points.push_back(position(n, 0.5));
    project(m_points.size() - 1);
    return m_points.size() - 1;
  }

  void find_opposite_halfedges()
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> halfedges;
    for(std::size_t h = 0; h < m_source.size(); ++h) halfedges.emplace(std::make_pair(m_source[h], target(h)), h);
    for(std::size_t h = 0; h < m_source.size(); ++h)
    {
      const auto opposite = halfedges.find({target(h), m_source[h]});
      if(opposite == halfedges.end() || halfedges.size() < m_source.size()) throw std::logic_error("the mesh is not closed");
      m_opposite.push_back(opposite->second);
    }
    // vertices - edges + faces = 2 - 2 genus
    if(number_of_vertices() + 2 != number_of_faces() / 2) throw std::logic_error("the genus of the mesh is not two");
  }

  static std::size_t previous(std::size_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  std::size_t target(std::size_t h) const { return m_source[previous(previous(h))]; }
  std::size_t apex(std::size_t h) const { return m_source[previous(h)]; }

  // Whether an edge is between a face on a cut and one of the wall.
  bool is_sharp(std::size_t h) const
  {
    const auto is_wall = [&](std::size_t v) { return m_parts[v] == Part::wall; };
    return !is_wall(m_source[h]) && !is_wall(target(h)) && is_wall(apex(h)) != is_wall(apex(m_opposite[h]));
  }

  double cotangent_at_apex(std::size_t h) const
  {
    const Vector p = m_points[apex(h)], a = m_points[m_source[h]] - p, b = m_points[target(h)] - p;
    return a * b / twice_area(a, b);
  }

  // Flips edges whose opposite angles have a sum of more than 180 degrees, but no sharp edges, and none into a chord of these.
  void flip_edges()
  {
    const auto link = [&](std::size_t g, std::size_t h) {
      m_opposite[g] = h;
      m_opposite[h] = g;
    };
    for(std::size_t h = 0; h < m_source.size(); ++h)
    {
      const std::size_t g = m_opposite[h], a = apex(g), b = apex(h);
      if(is_sharp(h) || (m_parts[a] == Part::sharp_edge && m_parts[b] == Part::sharp_edge)) continue;
      if(cotangent_at_apex(g) + cotangent_at_apex(h) > -1e-9) continue;
      m_source[g] = b;
      m_source[h] = a;
      link(g, m_opposite[previous(h)]);
      link(h, m_opposite[previous(g)]);
      link(previous(g), previous(h));
    }
  }

  // Moves vertices to the centroid of the faces around them, those on sharp edges to the middle of their neighbours there.
  void relax()
  {
    std::vector<Vector> sums(m_points.size(), Vector{0, 0, 0});
    std::vector<double> weights(m_points.size(), 0);
    for(std::size_t h = 0; h < m_source.size(); ++h)
    {
      const std::size_t v = m_source[h];
      const Vector a = m_points[v], b = m_points[target(h)], c = m_points[apex(h)];
      const bool at_edge = m_parts[v] == Part::sharp_edge;
      const double weight = at_edge ? is_sharp(h) : twice_area(b - a, c - a);
      sums[v] = sums[v] + weight * (at_edge ? b : (1.0 / 3) * (a + b + c));
      weights[v] += weight;
    }
    for(std::size_t v = 0; v < m_points.size(); ++v)
    {
      m_points[v] = (1 / weights[v]) * sums[v];
      project(v);
    }
  }

  // Moves a vertex onto its part of the surface, by Newton steps.
  void project(std::size_t v)
  {
    Vector& p = m_points[v];
    if(m_parts[v] != Part::wall) p.y = p.y < 0.5 * (foot + rim) ? foot : rim;
    for(int i = 0; i < 8 && m_parts[v] != Part::cut; ++i)
    {
      const double h = 1e-6, value = clay(p);
      if(std::abs(value) < 1e-12) return;
      const auto derivative = [&](const Vector& d) { return (clay(p + h * d) - value) / h; };
      const Vector g{derivative({1, 0, 0}), m_parts[v] == Part::wall ? derivative({0, 1, 0}) : 0, derivative({0, 0, 1})};
      p = p - (value / (g * g)) * g;
    }
  }
};

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

template <class Write>
void write_file(const std::string& name, const Write& write)
{
  std::ofstream file(name);
  file.precision(17);
  write(file);
  file.close();
  if(!file) throw std::runtime_error("cannot write '" + name + "'");
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
    const Vase vase;
    write_file(argv[1], [&](std::ostream& out) { vase.write(out); });
    if(argc == 3) write_file(argv[2], write_curve);
    std::cout << "generated " << vase.number_of_vertices() << " vertices, " << vase.number_of_faces() << " faces" << std::endl;
  }
  catch(const std::exception& error)
  {
    std::cerr << "generate_example_mesh: " << error.what() << std::endl;
    return 1;
  }
  return 0;
}
