// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mesh and field for the validation: the layout comes from the points of the mesh, and distances from public queries, so
// that the pipeline is not used to judge itself.

#ifndef GEODESIC_OFFSET_TEST_VALIDATION_VALIDATION_SURFACE_H
#define GEODESIC_OFFSET_TEST_VALIDATION_VALIDATION_SURFACE_H

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Face in its public frame: origin at the source of `halfedge(f, tm)`, x axis along it.
struct Validation_face
{
  typedef Point_in_face<double> Point;
  typedef Per_corner<double> Weights; // barycentric coordinates

  Index face;
  Per_corner<Point> corner;

  double area() const { return corner[1].x * corner[2].y / 2; }
  double edge_length(int k) const { return length(corner[(k + 1) % 3] - corner[k]); }
  double height(int k) const { return 2 * area() / edge_length((k + 1) % 3); } // of corner k
  double longest_edge() const { return (std::max)({edge_length(0), edge_length(1), edge_length(2)}); }

  Point point(const Weights& w) const { return w[0] * corner[0] + (w[1] * corner[1] + w[2] * corner[2]); }
  Point on_edge(int k, double t) const { return (1 - t) * corner[k] + t * corner[(k + 1) % 3]; }

  Weights weights(const Point& p) const
  {
    const double w2 = p.y / corner[2].y, w1 = (p.x - w2 * corner[2].x) / corner[1].x;
    return {{1 - w1 - w2, w1, w2}};
  }

  // Distance of p beyond the line of an edge; negative inside.
  double outside(const Point& p) const
  {
    const Weights w = weights(p);
    return (std::max)({-w[0] * height(0), -w[1] * height(1), -w[2] * height(2)});
  }

  // Projects weights of a point that rounding moved outside to an edge.
  Weights projected(const Weights& w) const
  {
    const int k = int(std::min_element(w.begin(), w.end()) - w.begin());
    if (!(w[k] < 0)) return w;
    const int from = (k + 1) % 3, to = (k + 2) % 3;
    const Point edge = corner[to] - corner[from];
    const double t = dot(edge, point(w) - corner[from]) / dot(edge, edge);
    Weights result;
    result[k] = 0;
    result[to] = (std::min)((std::max)(t, 0.), 1.);
    result[from] = 1 - result[to];
    return result;
  }

  // Distance from a point inside, along a unit direction, to the boundary of the face.
  double exit_distance(const Point& p, const Point& direction) const
  {
    double way = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k)
    {
      const Point u = (1 / edge_length(k)) * (corner[(k + 1) % 3] - corner[k]);
      const double speed = -cross(u, direction);
      if (speed > 0) way = (std::min)(way, (std::max)(cross(u, p - corner[k]), 0.) / speed);
    }
    return way;
  }
};

// `Geodesic`: a Surface_mesh_geodesic_offset built with kept windows.
template <class Geodesic>
class Validation_surface
{
public:
  typedef typename Geodesic::Triangle_mesh Triangle_mesh;
  typedef typename Geodesic::FT FT;
  typedef typename Geodesic::Face_location Face_location;
  typedef typename Geodesic::face_descriptor face_descriptor;
  typedef Validation_face Face;
  typedef Face::Point Point;
  typedef Face::Weights Weights;
  typedef Per_corner<double> Point_in_space;

  Validation_surface(const Geodesic& geodesic, const Triangle_mesh& tm)
    : m_geodesic(geodesic), m_face_index(get_initialized_face_index_map(tm))
  {
    const auto vim = get_initialized_vertex_index_map(tm);
    const auto points = get(boost::vertex_point, tm);
    Bbox_3 box;
    for (auto v : vertices(tm))
    {
      const std::size_t i = get(vim, v);
      if (i >= m_distance.size())
      {
        m_distance.resize(i + 1, std::numeric_limits<double>::infinity());
        m_point.resize(i + 1);
      }
      m_distance[i] = CGAL::to_double(geodesic.distance_to_sources(v));
      const auto& p = get(points, v);
      m_point[i] = {{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}};
      box += p.bbox();
    }
    // Points on edges far from the origin would lose digits. The difference of two numbers is exact if neither exceeds
    // twice the other.
    for (int i = 0; i < 3; ++i)
    {
      const double least = (box.min)(i), largest = (box.max)(i);
      if (!(least > 0 ? largest <= 2 * least : least >= 2 * largest)) continue;
      for (Point_in_space& p : m_point) p[i] -= least;
    }
    m_diagonal = std::sqrt(square(box.x_span()) + square(box.y_span()) + square(box.z_span()));
    for (auto f : faces(tm))
    {
      const std::size_t i = get(m_face_index, f);
      if (i >= m_faces.size())
      {
        m_faces.resize(i + 1);
        m_origin.resize(3 * (i + 1), no_index);
        m_twin.resize(3 * (i + 1), no_index);
      }
      m_faces[i] = f;
    }
    for (auto f : faces(tm))
    {
      const Index i = index_of(f);
      auto h = halfedge(f, tm);
      for (Index k = 0; k < 3; ++k, h = next(h, tm))
      {
        m_origin[3 * i + k] = Index(get(vim, source(h, tm)));
        const auto o = opposite(h, tm);
        if (is_border(o, tm)) continue;
        Index j = 0;
        for (auto g = halfedge(face(o, tm), tm); g != o; g = next(g, tm)) ++j;
        m_twin[3 * i + k] = 3 * index_of(face(o, tm)) + j;
      }
    }
    find_shared_vertices();
  }

  std::size_t number_of_faces() const { return m_faces.size(); } // including unused indices
  std::size_t number_of_vertices() const { return m_distance.size(); }
  bool is_used(Index face) const { return m_origin[3 * face] != no_index; }
  double diagonal() const { return m_diagonal; }

  Index index_of(face_descriptor f) const { return Index(get(m_face_index, f)); }

  // Halfedge 3f + k starts at corner k of face f. no_index on the border.
  Index twin(Index halfedge) const { return m_twin[halfedge]; }
  Index origin(Index halfedge) const { return m_origin[halfedge]; }
  Index target(Index halfedge) const { return m_origin[after(halfedge)]; }

  double vertex_distance(Index v) const { return m_distance[v]; }

  // Whether several fans of faces meet at a vertex without a common edge.
  bool is_shared(Index v) const { return m_is_shared[v]; }

  Point_in_space point(Index face, const Weights& w) const
  {
    Point_in_space p{{0, 0, 0}};
    for (Index k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i) p[i] += w[k] * m_point[m_origin[3 * face + k]][i];
    return p;
  }

  static double distance(const Point_in_space& a, const Point_in_space& b)
  {
    return std::sqrt(square(a[0] - b[0]) + square(a[1] - b[1]) + square(a[2] - b[2]));
  }

  double edge_length(Index halfedge) const { return distance(m_point[origin(halfedge)], m_point[target(halfedge)]); }

  // Twice the area from the two shorter sides: the difference of long ones would lose digits.
  Face face_at(Index f) const
  {
    const Point_in_space &a = m_point[m_origin[3 * f]], &b = m_point[m_origin[3 * f + 1]], &c = m_point[m_origin[3 * f + 2]];
    const Point_in_space u[3] = {difference(b, a), difference(c, b), difference(a, c)};
    int longest = 0;
    for (int k : {1, 2})
      if (dot(u[k], u[k]) > dot(u[longest], u[longest])) longest = k;
    const Point_in_space &v = u[(longest + 1) % 3], &w = u[(longest + 2) % 3];
    const Point_in_space n = {{v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]}};
    const double base = std::sqrt(dot(u[0], u[0]));
    return Face{f, {{0, 0}, {base, 0}, {-dot(u[0], u[2]) / base, std::sqrt(dot(n, n)) / base}}};
  }

  // Distance of a point of the face that rounding may have moved outside.
  double distance_at(Index face, Weights w) const
  {
    typename Geodesic::Barycentric_coordinates exact;
    w = face_at(face).projected(w);
    for (std::size_t k = 0; k < 3; ++k) exact[k] = FT(w[k]);
    return CGAL::to_double(m_geodesic.distance_to_sources(Face_location(m_faces[face], exact)));
  }
  double distance_at(const Face& face, const Point& p) const { return distance_at(face.face, face.weights(p)); }

  // Bounds of the distance in a face from its corners: the distance is 1-Lipschitz.
  void range_of(const Face& face, double& low, double& high) const
  {
    low = 0;
    high = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k)
    {
      const double d = m_distance[m_origin[3 * face.face + Index(k)]];
      const double reach = (std::max)(face.edge_length(k), face.edge_length((k + 2) % 3));
      low = (std::max)(low, d - reach);
      high = (std::min)(high, d + reach);
    }
  }

private:
  // A second traversal around a vertex belongs to another fan.
  void find_shared_vertices()
  {
    m_is_shared.assign(number_of_vertices(), false);
    std::vector<bool> has_fan(number_of_vertices(), false), is_seen(m_origin.size(), false);
    for (Index h = 0; h < m_origin.size(); ++h)
    {
      if (m_origin[h] == no_index || is_seen[h]) continue;
      const Index v = m_origin[h];
      m_is_shared[v] = m_is_shared[v] || has_fan[v];
      has_fan[v] = true;
      for (Index g = h; g != no_index && !is_seen[g]; g = m_twin[before(g)]) is_seen[g] = true;
      for (Index g = m_twin[h]; g != no_index && !is_seen[after(g)]; g = m_twin[after(g)]) is_seen[after(g)] = true;
    }
  }
  static Point_in_space difference(const Point_in_space& p, const Point_in_space& q)
  {
    return {{p[0] - q[0], p[1] - q[1], p[2] - q[2]}};
  }
  static double dot(const Point_in_space& u, const Point_in_space& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

  static Index after(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index before(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  const Geodesic& m_geodesic;
  typename GetInitializedFaceIndexMap<Triangle_mesh>::const_type m_face_index;
  std::vector<face_descriptor> m_faces;
  std::vector<Index> m_origin, m_twin;
  std::vector<double> m_distance;
  std::vector<bool> m_is_shared;
  std::vector<Point_in_space> m_point;
  double m_diagonal = 0;
};

// Uniform in (0, 1), the same on all platforms.
inline double validation_random(std::mt19937& random) { return (double(random()) + 0.5) / 4294967296.; }

// Uniform in a triangle, at least a hundredth of the heights away from its sides.
inline Validation_face::Weights validation_random_weights(std::mt19937& random)
{
  double s = validation_random(random), t = validation_random(random);
  if (s + t > 1)
  {
    s = 1 - s;
    t = 1 - t;
  }
  const auto inwards = [](double w) { return 0.01 + 0.97 * w; };
  return {{inwards(1 - s - t), inwards(s), inwards(t)}};
}

} // namespace CGAL::Geodesic_offset::internal

#endif // GEODESIC_OFFSET_TEST_VALIDATION_VALIDATION_SURFACE_H
