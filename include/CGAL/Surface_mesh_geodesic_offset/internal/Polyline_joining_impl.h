// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Definitions for Polyline_joining.h.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_POLYLINE_JOINING_IMPL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_POLYLINE_JOINING_IMPL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/point_conversion.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_elements.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_start_query.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_tracing.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Polyline_joining.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Some faces as a mesh. The halfedges of a face have the order of the whole mesh.
template <class Traits, class Kernel>
class Polyline_joining<Traits, Kernel>::Patch
{
  typedef CGAL::Geodesic_offset::internal::Surface_point<Number> Surface_point;
  typedef CGAL::Geodesic_offset::internal::Located_point<Number> Located_point;

public:
  Patch(const Polyline_joining& whole, std::vector<Index> faces) : m_whole(whole), m_faces(std::move(faces))
  {
    for (Index i = 0; i < m_faces.size(); ++i) m_number_of_face[m_faces[i]] = i;
    All_face_links links;
    std::vector<Index> face_at;
    std::vector<typename Traits::Point_3> points;
    for (Index f : m_faces)
    {
      Face_links l;
      for (Index k = 0; k < 3; ++k)
      {
        l.source[k] = number(whole.m_mesh.source(3 * f + k), points);
        const Index twin = whole.m_mesh.twin(3 * f + k);
        const auto beyond = twin == no_index ? m_number_of_face.end() : m_number_of_face.find(twin / 3);
        l.beyond[k] = beyond == m_number_of_face.end() ? no_index : beyond->second;
      }
      face_at.push_back(Index(links.size()));
      links.push_back(l);
    }
    Single_worker alone;
    m_mesh =
      Unfolded_mesh<Number>(Index_renumbering(points.size(), links.size()), links, face_at, points, whole.m_traits, alone);
  }

  // Appends the elements of the path, in terms of the whole mesh.
  void trace(const Located_point& from, const Located_point& to, std::vector<Path_crossing<Number>>& path) const
  {
    Source_set<Number> sources;
    sources.insert(0, {Source_set<Number>::POINT, {here(to)}, {}, Number(0), {}});
    Build_request<Number> request;
    request.keeps_windows = true;
    const Located_point start = here(from);
    request.targets.push_back(start);
    Geodesic_build<Traits> build(m_mesh, sources, request);
    build.template propagate<Sequential_tag, Geodesic_build<Traits>::parts_for(KEPT_WINDOWS)>(m_whole.m_traits);
    const Path_start<Number> way = Path_start_query<Number>(m_mesh, build.initial, build.field)(start);
    std::vector<Path_element<Number>> elements;
    const Surface_point end = build.trace_path(start, way, elements).point;
    std::vector<Path_crossing<Number>> passed;
    for (const auto& e : elements) std::visit([&](const auto& p) { this->add(p, passed); }, e);
    // a path to a point inside a face that is at an edge up to rounding ends on the edge
    if (end.kind == Surface_point::EDGE && to.kind == Surface_point::FACE)
    {
      const Index h = end.element;
      add(Path_crossing<Number>{h, m_mesh.source(h), m_mesh.target(h), end.x / m_mesh[h].length}, passed);
    }
    for (const Path_crossing<Number>& c : passed)
      if (c.halfedge != no_index || (!is_at(c.source, from) && !is_at(c.source, to))) path.push_back(c);
  }

private:
  Index number(Index vertex, std::vector<typename Traits::Point_3>& points)
  {
    const auto [it, is_new] = m_number_of_vertex.emplace(vertex, Index(m_vertices.size()));
    if (is_new)
    {
      m_vertices.push_back(vertex);
      points.push_back(converted_point<typename Traits::Point_3, Number>(m_whole.m_points.point_of_vertex(vertex)));
    }
    return it->second;
  }

  // The point in the patch, which contains all faces around it.
  Located_point here(Located_point p) const
  {
    if (p.kind == Surface_point::VERTEX) p.element = m_number_of_vertex.at(p.element);
    else if (p.kind == Surface_point::FACE) p.element = m_number_of_face.at(p.element);
    else p.element = 3 * m_number_of_face.at(p.element / 3) + p.element % 3;
    return p;
  }

  // Converts a crossing to the whole mesh.
  void add(const Path_crossing<Number>& c, std::vector<Path_crossing<Number>>& passed) const
  {
    const Index h = 3 * m_faces[c.halfedge / 3] + c.halfedge % 3;
    passed.push_back({h, m_vertices[c.source], m_vertices[c.target], c.part});
  }
  void add(const Surface_point& p, std::vector<Path_crossing<Number>>& passed) const
  {
    if (p.kind == Surface_point::VERTEX) passed.push_back({no_index, m_vertices[p.element], m_vertices[p.element], Number(0)});
  }

  static bool is_at(Index vertex, const Surface_point& p) { return p.kind == Surface_point::VERTEX && p.element == vertex; }

  const Polyline_joining& m_whole;
  const std::vector<Index> m_faces; // in the whole mesh
  std::vector<Index> m_vertices;
  std::unordered_map<Index, Index> m_number_of_face, m_number_of_vertex;
  Unfolded_mesh<Number> m_mesh;
};

// Which faces a path may pass, by bounds in double.
template <class Traits, class Kernel>
class Polyline_joining<Traits, Kernel>::Bound
{
  typedef CGAL::Geodesic_offset::internal::Surface_point<Number> Surface_point;
  typedef CGAL::Geodesic_offset::internal::Located_point<Number> Located_point;
  typedef CGAL::Simple_cartesian<double> Plain_kernel;
  typedef Plain_kernel::Point_3 Plain_point;

public:
  explicit Bound(const Polyline_joining& whole) : m_mesh(whole.m_mesh), m_points(whole.m_points) {}

  static constexpr double slack = 1 + 1e-9; // for rounding

  bool have_common_face(const Surface_point& p, const Surface_point& q) const
  {
    Point_in_face<Number> unused;
    unsigned edges;
    const std::vector<Index> faces = faces_of(m_mesh, p);
    return std::any_of(faces.begin(), faces.end(), [&](Index f) { return position_in_face(m_mesh, q, f, unused, edges); });
  }

  // Upper bound of the distance: the length of a path along edges that is straight in the first and the last face.
  double length_along_edges(const Located_point& from, const Located_point& to) const
  {
    const Plain_point p = plain_point(from), q = plain_point(to);
    std::unordered_set<Index> goals;
    for (Index f : faces_of(m_mesh, to))
      for (Index k = 0; k < 3; ++k) goals.insert(m_mesh.source(3 * f + k));
    typedef std::pair<double, Index> Entry; // lower bound of the length of a path through the vertex
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    std::unordered_map<Index, double> length;
    std::unordered_set<Index> is_done;
    const auto reach = [&](Index v, double l) {
      const auto [it, is_new] = length.emplace(v, l);
      if (!is_new && it->second <= l) return;
      it->second = l;
      queue.emplace(l + distance(plain_point(v), q), v);
    };
    for (Index f : faces_of(m_mesh, from))
      for (Index k = 0; k < 3; ++k) reach(m_mesh.source(3 * f + k), distance(p, plain_point(m_mesh.source(3 * f + k))));
    while (!queue.empty())
    {
      const auto [total, v] = queue.top();
      queue.pop();
      if (goals.count(v) > 0) return total;
      if (!is_done.insert(v).second) continue;
      const double so_far = length[v];
      for (Index f : faces_of(m_mesh, Surface_point::at_vertex(v)))
        for (Index h = 3 * f; h < 3 * f + 3; ++h)
          if (m_mesh.source(h) == v) reach(m_mesh.target(h), so_far + CGAL::to_double(m_mesh[h].length));
          else if (m_mesh.target(h) == v) reach(m_mesh.source(h), so_far + CGAL::to_double(m_mesh[h].length));
    }
    return std::numeric_limits<double>::infinity();
  }

  // The connected set of faces that a path of this length can pass: those that meet the ellipsoid around its ends.
  std::vector<Index> faces_within(const Located_point& from, const Located_point& to, double bound) const
  {
    const Plain_point p = plain_point(from), q = plain_point(to);
    const auto can_pass = [&](Index f) {
      const Plain_kernel::Triangle_3 t(plain_point(m_mesh.source(3 * f)), plain_point(m_mesh.source(3 * f + 1)),
                                       plain_point(m_mesh.source(3 * f + 2)));
      return std::sqrt(CGAL::squared_distance(p, t)) + std::sqrt(CGAL::squared_distance(q, t)) <= bound * slack;
    };
    std::vector<Index> faces;
    std::unordered_set<Index> seen;
    for (const Located_point* end : {&from, &to})
      for (Index f : faces_of(m_mesh, *end))
        if (seen.insert(f).second) faces.push_back(f);
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (Index k = 0; k < 3; ++k)
      {
        const Index around = m_mesh.source(3 * faces[i] + k); // a path may pass a vertex
        for (Index f : faces_of(m_mesh, Surface_point::at_vertex(around)))
          if (seen.insert(f).second && can_pass(f)) faces.push_back(f);
      }
    return faces;
  }

  Plain_point plain_point(Index v) const { return plain(m_points.point_of_vertex(v)); }
  Plain_point plain_point(const Located_point& p) const
  {
    if (p.kind == Surface_point::VERTEX) return plain_point(p.element);
    const Index h = p.kind == Surface_point::FACE ? 3 * p.element : p.element, g = m_mesh.next(h);
    const double t = p.kind == Surface_point::EDGE ? CGAL::to_double(p.x) / CGAL::to_double(m_mesh[h].length) : 0;
    const double w[3] = {p.kind == Surface_point::EDGE ? 1 - t : CGAL::to_double(p.weights[0]),
                         p.kind == Surface_point::EDGE ? t : CGAL::to_double(p.weights[1]),
                         p.kind == Surface_point::EDGE ? 0 : CGAL::to_double(p.weights[2])};
    const Plain_point corner[3] = {plain_point(m_mesh.source(h)), plain_point(m_mesh.source(g)), plain_point(m_mesh.target(g))};
    return CGAL::ORIGIN +
           (w[0] * (corner[0] - CGAL::ORIGIN) + w[1] * (corner[1] - CGAL::ORIGIN) + w[2] * (corner[2] - CGAL::ORIGIN));
  }

  static Plain_point plain(const typename Kernel::Point_3& p)
  {
    return Plain_point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }

private:
  static double distance(const Plain_point& p, const Plain_point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

  const Unfolded_mesh<Number>& m_mesh;
  const Surface_points<Kernel>& m_points;
};

template <class Traits, class Kernel>
bool Polyline_joining<Traits, Kernel>::join(const Located_point<Number>& from, const Located_point<Number>& to,
                                            std::vector<Path_crossing<Number>>& path) const
{
  const Bound bound(*this);
  if (bound.have_common_face(from, to)) return true;
  const double length = bound.length_along_edges(from, to) * Bound::slack;
  if (!(length < std::numeric_limits<double>::infinity())) return false;
  const Patch patch(*this, bound.faces_within(from, to, length));
  patch.trace(from, to, path);
  return true;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
