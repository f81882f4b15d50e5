// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Some faces of a mesh, laid out with twice the digits of double, and the parts of sources in these faces.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GRADED_EXTENDED_MESH_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GRADED_EXTENDED_MESH_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_offset_traits.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/graded/Points_of_surface.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Layout_by_lengths.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Source_set.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Lengths are scaled by a power of two such that the longest edge is between 1 and 2: products keep all digits.
template <class Number>
class Extended_mesh
{
public:
  typedef Number FT;
  typedef Surface_mesh_geodesic_offset_traits<Simple_cartesian<FT>, void> Traits;
  typedef Source_set<double> Sources;
  typedef Source_set<FT> Extended_sources;

  // `faces`: different faces of `mesh`.
  Extended_mesh(const Unfolded_mesh<double>& mesh, const std::vector<Index>& faces, const Point_of_vertex& point) : m_mesh(mesh)
  {
    double longest = 0;
    for (const Index f : faces)
    {
      m_face.emplace(f, Index(m_face.size()));
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        m_vertex.emplace(mesh.source(h), Index(m_vertex.size()));
        longest = (std::max)(longest, mesh[h].length);
      }
    }
    m_exponent = std::ilogb(longest);
    All_face_links links(faces.size(), boost::container::default_init);
    std::vector<Index> face_at;
    std::vector<FT> lengths;
    for (const Index f : faces)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Index h = 3 * f + Index(k), g = mesh.twin(h);
        links[face_at.size()].source[k] = m_vertex.at(mesh.source(h));
        links[face_at.size()].beyond[k] = g == no_index ? no_index : image(m_face, mesh.face(g));
        lengths.push_back(FT(scaled(mesh[h].length)));
      }
      face_at.push_back(Index(face_at.size()));
    }
    auto&& alone = Single_worker();
    if (!point)
    {
      m_extended = Unfolded_mesh<FT>(Own_numbers(), links, face_at, m_vertex.size(), Layout_by_lengths<FT>(lengths), alone);
      return;
    }
    std::vector<typename Traits::Point_3> positions(m_vertex.size());
    for (const auto& [v, i] : m_vertex)
    {
      const std::array<double, 3> p = point(v);
      positions[i] = typename Traits::Point_3(scaled(p[0]), scaled(p[1]), scaled(p[2]));
    }
    m_extended = Unfolded_mesh<FT>(Own_numbers(), links, face_at, positions, Traits(), alone);
  }

  const Unfolded_mesh<FT>& unfolded() const { return m_extended; }

  Index vertex(Index v) const { return m_vertex.at(v); }

  // Per vertex here, that of the mesh.
  std::vector<Index> original_vertices() const
  {
    std::vector<Index> result(m_vertex.size());
    for (const auto& [original, v] : m_vertex) result[v] = original;
    return result;
  }

  FT to_unit(double length) const { return scaled(length); }
  double from_unit(const FT& length) const { return std::ldexp(length.high(), m_exponent); }

  // The parts of sources in the faces, up to a start value. Polylines are divided where they leave the faces. The ids of parts are
  // consecutive; the ids of their sources are appended to `source_of_part`.
  Extended_sources sources(const Sources& all, double largest_start_value, std::vector<Index>& source_of_part) const
  {
    Extended_sources result;
    all.for_each([&](std::size_t id, const Sources::Source& s) {
      if (!(s.start_value <= largest_start_value)) return;
      add_parts(s,
                [&](typename Extended_sources::Kind kind, std::vector<Surface_point<FT>> points, std::vector<Index> halfedges) {
        result.insert(source_of_part.size(), {kind, std::move(points), std::move(halfedges), to_unit(s.start_value), {}});
        source_of_part.push_back(Index(id));
      });
    });
    return result;
  }

private:
  struct Own_numbers
  {
    static Index of_vertex(Index v) { return v; }
    static Index of_face(Index f) { return f; }
  };

  double scaled(double x) const { return std::ldexp(x, -m_exponent); }

  static Index image(const std::unordered_map<Index, Index>& map, Index i)
  {
    const auto found = map.find(i);
    return found == map.end() ? no_index : found->second;
  }

  // Calls add(kind, points, halfedges) for each part of a source in the faces.
  template <class Function>
  void add_parts(const Sources::Source& s, const Function& add) const
  {
    if (s.kind == Sources::EDGES)
    {
      std::vector<Index> halfedges;
      for (const Index h : s.halfedges)
        if (const Index g = halfedge(h); g != no_index) halfedges.push_back(g);
      if (!halfedges.empty()) add(Extended_sources::EDGES, {}, std::move(halfedges));
      return;
    }
    std::vector<Surface_point<FT>> part;
    const auto end_part = [&] {
      if (part.empty()) return;
      const auto kind = part.size() == 1 ? Extended_sources::POINT : Extended_sources::OPEN_POLYLINE;
      add(kind, std::exchange(part, {}), {});
    };
    const std::size_t n = s.points.size(), last = s.kind == Sources::CLOSED_POLYLINE ? n : n - 1;
    for (std::size_t i = 0; i <= last; ++i)
    {
      const auto p = point(s.points[i % n], s.weights[i % n]);
      if (!part.empty() && !(p && have_common_face(part.back(), *p))) end_part();
      if (p) part.push_back(*p);
    }
    if (last == n && part.size() == n + 1)
    {
      part.pop_back();
      return add(Extended_sources::CLOSED_POLYLINE, std::move(part), {});
    }
    end_part();
  }

  bool have_common_face(const Surface_point<FT>& p, const Surface_point<FT>& q) const
  {
    const std::vector<Index> at_p = faces_of(m_extended, p), at_q = faces_of(m_extended, q);
    return std::find_first_of(at_p.begin(), at_p.end(), at_q.begin(), at_q.end()) != at_p.end();
  }

  // A halfedge of the edge of h; no_index if no face at it is one of the mesh.
  Index halfedge(Index h) const
  {
    for (const Index g : {h, m_mesh.twin(h)})
      if (g != no_index)
        if (const Index f = image(m_face, m_mesh.face(g)); f != no_index) return 3 * f + g % 3;
    return no_index;
  }

  // The point of a source, unless it is outside. w: the user's barycentric coordinates, from which its position in double was
  // rounded.
  std::optional<Surface_point<FT>> point(const Surface_point<double>& p, const std::array<double, 3>& w) const
  {
    if (p.kind == Surface_point<double>::VERTEX)
    {
      const Index v = image(m_vertex, p.element);
      return v == no_index ? std::nullopt : std::make_optional(Surface_point<FT>::at_vertex(v));
    }
    const FT sum = FT(w[0]) + FT(w[1]) + FT(w[2]);
    if (p.kind == Surface_point<double>::FACE)
    {
      const Index f = image(m_face, p.element);
      if (f == no_index) return std::nullopt;
      return Surface_point<FT>::in_face(f, position_in_frame(m_extended, 3 * f, FT(w[1] / sum), FT(w[2] / sum)));
    }
    const Index h = halfedge(p.element);
    if (h == no_index) return std::nullopt;
    const std::size_t k = p.element % 3;
    if (image(m_face, m_mesh.face(p.element)) == m_extended.face(h))
      return Surface_point<FT>::on_edge(h,
                                        position_in_frame(m_extended, h, FT(w[(k + 1) % 3] / sum), FT(w[(k + 2) % 3] / sum)).x);
    // The third coordinate is zero, or next to it: then the position is no less accurate than the location.
    const FT part = w[(k + 2) % 3] == 0 ? w[(k + 1) % 3] / sum : to_unit(p.x) / to_unit(m_mesh[p.element].length);
    return Surface_point<FT>::on_edge(h, (FT(1) - part) * m_extended[h].length);
  }

  const Unfolded_mesh<double>& m_mesh;
  std::unordered_map<Index, Index> m_face, m_vertex; // of the mesh, to those here
  int m_exponent = 0;                                // lengths here are those of the mesh divided by two to this power
  Unfolded_mesh<FT> m_extended;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
