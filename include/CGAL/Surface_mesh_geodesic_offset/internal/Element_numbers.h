// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers of vertices and faces in the flat arrays: the indices of the mesh, or, where these scatter neighbours over
// the memory, numbers along a space-filling curve.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_ELEMENT_NUMBERS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_ELEMENT_NUMBERS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Number_policy.h>

#include <CGAL/Hilbert_sort_median_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class TriangleMesh, class VertexIndexMap, class FaceIndexMap>
class Element_numbers
{
public:
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  template <class VertexPointMap>
  Element_numbers(const TriangleMesh& tm, const VertexIndexMap& vim, const FaceIndexMap& fim, const VertexPointMap& vpm)
    : m_tm(tm), m_vim(vim), m_fim(fim)
  {
    for (const vertex_descriptor v : vertices(tm))
      m_vertices_end = (std::max)(m_vertices_end, std::size_t(get(vim, v)) + 1);
    for (const face_descriptor f : faces(tm)) m_faces_end = (std::max)(m_faces_end, std::size_t(get(fim, f)) + 1);
    if (m_vertices_end >= (std::size_t(1) << 29) || 3 * m_faces_end >= std::size_t(no_index))
      throw std::length_error("Surface_mesh_geodesic_offset: the mesh has too many elements for 32-bit indices");
    if (is_scattered()) renumber(vpm);
  }

  // Above all numbers; not all below need be in use.
  std::size_t vertices_end() const { return m_vertices_end; }
  std::size_t faces_end() const { return m_faces_end; }

  // no_index, or another number that is not in use, for what is not of the mesh.
  Index of(vertex_descriptor v) const { return number(m_vertex, get(m_vim, v)); }
  Index of(face_descriptor f) const { return number(m_face, get(m_fim, f)); }
  Index of_halfedge(halfedge_descriptor h) const // not on the border
  {
    const face_descriptor f = face(h, m_tm);
    const halfedge_descriptor first = halfedge(f, m_tm);
    return 3 * of(f) + (h == first ? 0 : next(first, m_tm) == h ? 1 : 2);
  }

  // The number by which the user knows a face.
  std::size_t index_in_mesh(face_descriptor f) const { return std::size_t(get(m_fim, f)); }

private:
  enum
  {
    worthwhile = 1 << 14, // faces: fewer stay in the caches anyway
    near = 1 << 10,       // numbers apart: then neighbours are likely to be in the caches together
    sample = 1 << 12,     // faces
    cell = 16             // vertices that are left in any order: sorting them costs more than it gives
  };

  template <class I>
  static Index number(const std::vector<Index>& renumbered, const I& i)
  {
    return renumbered.empty() ? Index(i) : std::size_t(i) < renumbered.size() ? renumbered[std::size_t(i)] : no_index;
  }

  // Whether the numbers of neighbours are often far apart, judged by some of the faces.
  bool is_scattered() const
  {
    if (m_faces_end < worthwhile) return false;
    const auto are_near = [](std::size_t i, std::size_t j) { return (i < j ? j - i : i - j) < near; };
    const std::size_t step = (std::max)(std::size_t(1), m_faces_end / sample);
    std::size_t pairs = 0, far = 0, skip = 0;
    for (const face_descriptor f : faces(m_tm))
    {
      if (skip-- != 0) continue;
      skip = step - 1;
      for (const halfedge_descriptor h : halfedges_around_face(halfedge(f, m_tm), m_tm))
      {
        const halfedge_descriptor o = opposite(h, m_tm);
        if (!is_border(o, m_tm)) far += !are_near(get(m_fim, f), get(m_fim, face(o, m_tm)));
        far += !are_near(get(m_vim, source(h, m_tm)), get(m_vim, target(h, m_tm)));
        pairs += 2;
      }
    }
    return 4 * far > pairs;
  }

  template <class VertexPointMap>
  void renumber(const VertexPointMap& vpm)
  {
    typedef Simple_cartesian<double> Kernel;
    typedef std::pair<Kernel::Point_3, Index> Numbered_point;
    typedef First_of_pair_property_map<Numbered_point> Point_map;
    std::vector<Numbered_point> points;
    points.reserve(m_vertices_end);
    const auto coordinate = [](const auto& x) {
      const double d = CGAL::to_double(x);
      return std::isfinite(d) ? d : 0.; // it is complained of later
    };
    for (const vertex_descriptor v : vertices(m_tm))
    {
      const auto& p = get(vpm, v);
      points.emplace_back(Kernel::Point_3(coordinate(p.x()), coordinate(p.y()), coordinate(p.z())), Index(get(m_vim, v)));
    }
    typedef Spatial_sort_traits_adapter_3<Kernel, Point_map> Sort_traits;
    Hilbert_sort_median_3<Sort_traits, Sequential_tag>(Sort_traits(), cell)(points.begin(), points.end());
    m_vertex.assign(m_vertices_end, no_index);
    for (std::size_t i = 0; i < points.size(); ++i) m_vertex[points[i].second] = Index(i);
    m_vertices_end = points.size();

    // faces by the lowest number of their vertices
    std::vector<Index> first(m_vertices_end + 1, 0);
    const auto lowest = [&](face_descriptor f) {
      Index low = no_index;
      for (const vertex_descriptor v : vertices_around_face(halfedge(f, m_tm), m_tm)) low = (std::min)(low, of(v));
      return low;
    };
    for (const face_descriptor f : faces(m_tm)) ++first[lowest(f) + 1];
    for (std::size_t i = 1; i <= m_vertices_end; ++i) first[i] += first[i - 1];
    m_face.assign(m_faces_end, no_index);
    m_faces_end = first.back();
    for (const face_descriptor f : faces(m_tm)) m_face[std::size_t(get(m_fim, f))] = first[lowest(f)]++;
  }

  const TriangleMesh& m_tm;
  VertexIndexMap m_vim;
  FaceIndexMap m_fim;
  std::size_t m_vertices_end = 0, m_faces_end = 0;
  std::vector<Index> m_vertex, m_face; // by the index of the mesh; empty: as that
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
