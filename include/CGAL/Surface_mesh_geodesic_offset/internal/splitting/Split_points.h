// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The points that a split inserts into a mesh: at vertices, on edges and in faces. Points closer than the snap distance are one.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_SPLIT_POINTS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_SPLIT_POINTS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Split_lengths.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// A face in the plane, with its corners in the order of its halfedges from halfedge(f) on: the first at the origin, the second on
// the x axis, the third above.
struct Flat_face
{
  typedef std::array<double, 3> Weights; // barycentric coordinates

  double length, apex_x, apex_y;

  double x(int corner) const { return corner == 0 ? 0 : corner == 1 ? length : apex_x; }
  double y(int corner) const { return corner == 2 ? apex_y : 0; }

  // of the edge from a corner to the next one
  double edge_length(int corner) const
  {
    const int next = (corner + 1) % 3;
    return std::hypot(x(next) - x(corner), y(next) - y(corner));
  }

  // Distance of a point from the edge opposite to a corner.
  double distance_from_opposite_edge(int corner, const Weights& w) const
  {
    return w[std::size_t(corner)] * (length * apex_y) / edge_length((corner + 1) % 3);
  }

  // Parameter on the edge from a corner to the next one of the point of the edge nearest to another point.
  double projected(int corner, const Weights& w) const
  {
    const int next = (corner + 1) % 3;
    const double dx = x(next) - x(corner), dy = y(next) - y(corner);
    double px = -x(corner), py = -y(corner);
    for (int k = 0; k < 3; ++k)
    {
      px += w[std::size_t(k)] * x(k);
      py += w[std::size_t(k)] * y(k);
    }
    return (std::max)(0., (std::min)(1., (px * dx + py * dy) / (dx * dx + dy * dy)));
  }
};

template <class TriangleMesh, class VertexPointMap>
class Split_points
{
public:
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename boost::property_traits<VertexPointMap>::value_type Point_3;
  typedef Flat_face::Weights Weights;
  typedef std::size_t Id;

  enum Place : char { AT_VERTEX, ON_EDGE, IN_FACE };
  struct Split_point
  {
    Place place;
    Point_3 point;
    vertex_descriptor vertex;     // AT_VERTEX; of other points the split sets it
    halfedge_descriptor halfedge; // ON_EDGE: that of Edge_points, and the parameter on it. IN_FACE: the first of the face
    double part;
    Weights weights; // IN_FACE
  };

  // Points of one edge, by increasing parameter on one of its halfedges, the same for all of them.
  struct Edge_points
  {
    halfedge_descriptor halfedge;
    std::vector<Id> ids;
  };

  // `diagonal`: of the bounding box.
  Split_points(TriangleMesh& tm, const VertexPointMap& vpm, double diagonal)
    : m_mesh(tm), m_vpm(vpm), m_snap(Split_lengths::snap_part * diagonal), m_id_at(get(Vertex_tag(), tm)),
      m_number_at(get(Edge_tag(), tm))
  {
    for (const vertex_descriptor v : vertices(tm)) put(m_id_at, v, 0);
    for (const auto e : edges(tm)) put(m_number_at, e, 0);
  }

  double snap_distance() const { return m_snap; }

  Flat_face flat(face_descriptor f) const
  {
    const auto c = corners(f);
    std::array<std::array<double, 3>, 3> p;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Point_3& q = get(m_vpm, c[k]);
      p[k] = {CGAL::to_double(q.x()), CGAL::to_double(q.y()), CGAL::to_double(q.z())};
    }
    std::array<double, 3> u, v;
    double uu = 0, uv = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      u[k] = p[1][k] - p[0][k];
      v[k] = p[2][k] - p[0][k];
      uu += u[k] * u[k];
      uv += u[k] * v[k];
    }
    const double length = std::sqrt(uu);
    const double n = std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
    return {length, uv / length, n / length};
  }

  std::array<vertex_descriptor, 3> corners(face_descriptor f) const
  {
    const halfedge_descriptor h = halfedge(f, m_mesh);
    return {source(h, m_mesh), target(h, m_mesh), target(next(h, m_mesh), m_mesh)};
  }

  Id at_vertex(vertex_descriptor v)
  {
    const std::size_t known = get(m_id_at, v);
    if (known != 0) return known - 1;
    put(m_id_at, v, m_points.size() + 1);
    return add({AT_VERTEX, get(m_vpm, v), v, Graph_traits::null_halfedge(), 0, {}});
  }

  // A point of a face that other faces may share: a point near a vertex or an edge is there.
  Id add(face_descriptor f, const Weights& w)
  {
    const Flat_face flat_face = flat(f);
    int nearest = 0;
    double least = flat_face.distance_from_opposite_edge(0, w);
    for (int k = 1; k < 3; ++k)
    {
      const double d = flat_face.distance_from_opposite_edge(k, w);
      if (d < least) nearest = k;
      least = (std::min)(least, d);
    }
    if (least > m_snap) return add_inside(f, w);
    const int corner = (nearest + 1) % 3;
    return add_on_edge(halfedge_at(f, corner), flat_face.projected(corner, w), flat_face.edge_length(corner));
  }

  // A point of a face for this face alone.
  Id add_inside(face_descriptor f, const Weights& w)
  {
    const auto c = corners(f);
    const Point_3 &p = get(m_vpm, c[0]), &q = get(m_vpm, c[1]), &r = get(m_vpm, c[2]);
    const FT a(w[0]), b(w[1]), g(w[2]);
    const Point_3 point(FT(a * p.x() + b * q.x() + g * r.x()), FT(a * p.y() + b * q.y() + g * r.y()),
                        FT(a * p.z() + b * q.z() + g * r.z()));
    return add({IN_FACE, point, Graph_traits::null_vertex(), halfedge(f, m_mesh), 0, w});
  }

  // True if a point is in a face or on its boundary.
  bool is_on(face_descriptor f, Id id) const
  {
    const Split_point& p = m_points[id];
    if (p.place == AT_VERTEX)
    {
      const auto c = corners(f);
      return std::find(c.begin(), c.end(), p.vertex) != c.end();
    }
    return face(p.halfedge, m_mesh) == f || (p.place == ON_EDGE && face(opposite(p.halfedge, m_mesh), m_mesh) == f);
  }

  // A face that has both points, or the null face.
  face_descriptor common_face(Id a, Id b) const
  {
    const auto has_both = [&](face_descriptor f) { return f != Graph_traits::null_face() && is_on(f, a) && is_on(f, b); };
    for (const Id id : {a, b})
    {
      const Split_point& p = m_points[id];
      const halfedge_descriptor h = p.place == AT_VERTEX ? halfedge(p.vertex, m_mesh) : p.halfedge;
      for (const halfedge_descriptor g : halfedges_around_target(h, m_mesh))
        if (has_both(face(g, m_mesh))) return face(g, m_mesh);
      if (has_both(face(opposite(h, m_mesh), m_mesh))) return face(opposite(h, m_mesh), m_mesh);
    }
    return Graph_traits::null_face();
  }

  // True if a point is farther than the snap distance from all edges of its face.
  bool is_inside(const Flat_face& f, const Weights& w) const
  {
    for (int k = 0; k < 3; ++k)
      if (!(f.distance_from_opposite_edge(k, w) > m_snap)) return false;
    return true;
  }

  // Makes one point of points inside a face that are closer than the snap distance. `ids`: of points of the face.
  void merge_inside(face_descriptor f, std::vector<Id> ids)
  {
    const auto is_inner = [this](Id id) { return m_points[id].place == IN_FACE; };
    ids.erase(std::partition(ids.begin(), ids.end(), is_inner), ids.end());
    if (ids.size() < 2) return;
    const Flat_face flat_face = flat(f);
    const auto x = [&](Id id) {
      return m_points[id].weights[1] * flat_face.length + m_points[id].weights[2] * flat_face.apex_x;
    };
    const auto y = [&](Id id) { return m_points[id].weights[2] * flat_face.apex_y; };
    std::sort(ids.begin(), ids.end(), [&](Id a, Id b) { return x(a) < x(b); });
    std::vector<Id> kept;
    for (const Id id : ids)
    {
      const auto may_be_near = [&](Id other) { return x(id) - x(other) <= m_snap; };
      auto near = kept.rbegin();
      while (near != kept.rend() && may_be_near(*near) && !(std::hypot(x(id) - x(*near), y(id) - y(*near)) <= m_snap)) ++near;
      if (near != kept.rend() && may_be_near(*near)) m_same_as[id] = *near;
      else kept.push_back(id);
    }
  }

  // Makes one point of points on an edge that are closer than the snap distance. To be called once, when all points on edges are
  // known.
  void merge_on_edges()
  {
    for (Edge_points& e : m_edges)
    {
      std::sort(e.ids.begin(), e.ids.end(), [this](Id a, Id b) { return m_points[a].part < m_points[b].part; });
      const double length = length_of(e.halfedge);
      std::vector<Id> kept;
      for (const Id id : e.ids)
        if (kept.empty() || (m_points[id].part - m_points[kept.back()].part) * length > m_snap) kept.push_back(id);
        else m_same_as[id] = kept.back();
      e.ids.swap(kept);
    }
  }

  // The point that stands for a point after it was merged.
  Id merged(Id id) const { return m_same_as[id]; }

  const Split_point& operator[](Id id) const { return m_points[id]; }
  void set_vertex(Id id, vertex_descriptor v) { m_points[id].vertex = v; }
  const std::vector<Edge_points>& edges_with_points() const { return m_edges; }

  // The points of the boundary of a face, counterclockwise from its first corner on.
  std::vector<Id> boundary(face_descriptor f)
  {
    std::vector<Id> result;
    for (int k = 0; k < 3; ++k)
    {
      const halfedge_descriptor h = halfedge_at(f, k);
      result.push_back(at_vertex(source(h, m_mesh)));
      const std::size_t number = get(m_number_at, edge(h, m_mesh));
      if (number == 0) continue;
      const Edge_points& e = m_edges[number - 1];
      if (e.halfedge == h) result.insert(result.end(), e.ids.begin(), e.ids.end());
      else result.insert(result.end(), e.ids.rbegin(), e.ids.rend());
    }
    return result;
  }

  // Corner of the face at the start of the edge with the point, and whether the halfedge of the point is that of the face.
  std::pair<int, bool> side_with(face_descriptor f, Id id) const
  {
    const Split_point& p = m_points[id];
    CGAL_precondition(p.place == ON_EDGE);
    int k = 0;
    while (k < 2 && edge(halfedge_at(f, k), m_mesh) != edge(p.halfedge, m_mesh)) ++k;
    return {k, halfedge_at(f, k) == p.halfedge};
  }

  // Barycentric coordinates in a face of a point in it or on its boundary.
  Weights weights(face_descriptor f, Id id) const
  {
    const Split_point& p = m_points[id];
    if (p.place == IN_FACE) return p.weights;
    Weights w = {0, 0, 0};
    if (p.place == AT_VERTEX) w[std::size_t(corner_of(f, p.vertex))] = 1;
    else
    {
      const std::pair<int, bool> side = side_with(f, id);
      const double part = side.second ? p.part : 1 - p.part;
      w[std::size_t(side.first)] = 1 - part;
      w[std::size_t((side.first + 1) % 3)] = part;
    }
    return w;
  }

  // Corner of the face at a vertex.
  int corner_of(face_descriptor f, vertex_descriptor v) const
  {
    const auto c = corners(f);
    CGAL_assertion(v == c[0] || v == c[1] || v == c[2]);
    return v == c[0] ? 0 : v == c[1] ? 1 : 2;
  }

private:
  typedef typename Kernel_traits<Point_3>::Kernel::FT FT;
  typedef CGAL::dynamic_vertex_property_t<std::size_t> Vertex_tag;
  typedef CGAL::dynamic_edge_property_t<std::size_t> Edge_tag;

  halfedge_descriptor halfedge_at(face_descriptor f, int corner) const
  {
    const halfedge_descriptor h = halfedge(f, m_mesh);
    return corner == 0 ? h : corner == 1 ? next(h, m_mesh) : prev(h, m_mesh);
  }

  double length_of(halfedge_descriptor h) const
  {
    const Point_3 &p = get(m_vpm, source(h, m_mesh)), &q = get(m_vpm, target(h, m_mesh));
    return std::hypot(CGAL::to_double(p.x()) - CGAL::to_double(q.x()), CGAL::to_double(p.y()) - CGAL::to_double(q.y()),
                      CGAL::to_double(p.z()) - CGAL::to_double(q.z()));
  }

  Id add_on_edge(halfedge_descriptor h, double t, double length)
  {
    if ((std::min)(t, 1 - t) * length <= m_snap) return at_vertex(t < 0.5 ? source(h, m_mesh) : target(h, m_mesh));
    std::size_t number = get(m_number_at, edge(h, m_mesh));
    if (number == 0)
    {
      m_edges.push_back({h, {}});
      number = m_edges.size();
      put(m_number_at, edge(h, m_mesh), number);
    }
    const halfedge_descriptor first = m_edges[number - 1].halfedge;
    if (first != h) t = 1 - t;
    m_edges[number - 1].ids.push_back(m_points.size());
    const Point_3 &p = get(m_vpm, source(first, m_mesh)), &q = get(m_vpm, target(first, m_mesh));
    const FT a(1 - t), b(t);
    const Point_3 point(FT(a * p.x() + b * q.x()), FT(a * p.y() + b * q.y()), FT(a * p.z() + b * q.z()));
    return add({ON_EDGE, point, Graph_traits::null_vertex(), first, t, {}});
  }

  Id add(const Split_point& p)
  {
    m_points.push_back(p);
    m_same_as.push_back(m_same_as.size());
    return m_points.size() - 1;
  }

  TriangleMesh& m_mesh;
  const VertexPointMap m_vpm;
  const double m_snap;
  std::vector<Split_point> m_points; // by id
  std::vector<Id> m_same_as;
  std::vector<Edge_points> m_edges;
  typename boost::property_map<TriangleMesh, Vertex_tag>::type m_id_at;   // 1 + id; 0 if none
  typename boost::property_map<TriangleMesh, Edge_tag>::type m_number_at; // 1 + index in m_edges; 0 if none
};

} // namespace CGAL::Geodesic_offset::internal

#endif
