// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Barrier edges: no path crosses them. The mesh is cut along them: the halfedges on both sides have no twin, as on the border, and
// a vertex on a barrier is as many vertices as it has sectors between barrier edges, its copies. The first copy has the number of
// the vertex.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_BARRIERS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_BARRIERS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_links.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Index_renumbering.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Pairs of numbers, sorted.
class Index_pairs
{
public:
  void add(Index a, Index b) { m_pairs.emplace_back(a, b); }
  void sort() { std::sort(m_pairs.begin(), m_pairs.end()); }
  auto begin() const { return m_pairs.begin(); }
  auto end() const { return m_pairs.end(); }

  // The first partner of a; `otherwise` if there is none.
  Index partner(Index a, Index otherwise) const
  {
    const auto p = first(a);
    return p != end() && p->first == a ? p->second : otherwise;
  }

  template <class Function>
  void for_each_partner(Index a, const Function& f) const
  {
    for (auto p = first(a); p != end() && p->first == a; ++p) f(p->second);
  }

private:
  std::vector<std::pair<Index, Index>>::const_iterator first(Index a) const
  {
    return std::lower_bound(begin(), end(), std::make_pair(a, Index(0)));
  }

  std::vector<std::pair<Index, Index>> m_pairs;
};

class Barriers
{
public:
  Barriers() = default;

  // Cuts the links along the edges for which is_barrier(face, number of the halfedge) is true on both sides. Copies get the numbers
  // from `vertices_end` on. Takes time linear in the number of faces.
  template <class Function>
  Barriers(All_face_links& links, std::size_t vertices_end, const Function& is_barrier) : m_vertices_end(vertices_end)
  {
    std::vector<char> is_on_barrier(vertices_end, 0);
    for (Index f = 0; f < links.size(); ++f)
      for (Index k = 0; k < 3 && links[f].is_face(); ++k)
      {
        const Index g = links[f].beyond[k];
        if (g == no_index || !is_barrier(f, k)) continue;
        const Index end = links[f].source[(k + 1) % 3];
        m_across.add(3 * f + k, 3 * g + links[g].halfedge_from(end));
        is_on_barrier[links[f].source[k]] = is_on_barrier[end] = 1;
      }
    for (const auto& a : m_across) links[a.first / 3].beyond[a.first % 3] = no_index;
    m_across.sort();
    Index_pairs corners; // by vertex: halfedges
    for (Index f = 0; f < links.size(); ++f)
      for (Index k = 0; k < 3 && links[f].is_face(); ++k)
        if (is_on_barrier[links[f].source[k]]) corners.add(links[f].source[k], 3 * f + k);
    corners.sort();
    separate_sectors(links, corners);
  }

  // The vertices of which the copies are, but for the first ones, in the order of their numbers.
  const std::vector<Index>& copied() const { return m_copied; }

  // Replaces the numbers of the mesh by those after a renumbering.
  void renumber(const Index_renumbering& numbers)
  {
    Index_pairs across;
    for (const auto& a : m_across)
      across.add(3 * numbers.of_face(a.first / 3) + a.first % 3, 3 * numbers.of_face(a.second / 3) + a.second % 3);
    across.sort();
    m_across = across;
    for (std::size_t i = 0; i < m_copied.size(); ++i)
    {
      const Index first = numbers.of_vertex(m_copied[i]), copy = numbers.of_vertex(Index(m_vertices_end + i));
      m_first.add(copy, first);
      m_copies.add(first, copy);
    }
    m_first.sort();
    m_copies.sort();
  }

  bool empty() const { return m_across.begin() == m_across.end(); }

  // The halfedge on the other side of a barrier; no_index for a halfedge that is on none.
  Index across(Index h) const { return m_across.partner(h, no_index); }

  // Calls f with one halfedge of each barrier.
  template <class Function>
  void for_each_edge(const Function& f) const
  {
    for (const auto& a : m_across)
      if (a.first < a.second) f(a.first);
  }

  // The first copy of a vertex.
  Index first_copy(Index v) const { return m_first.partner(v, v); }

  // Calls f for all copies of a vertex.
  template <class Function>
  void for_each_copy(Index v, const Function& f) const
  {
    const Index first = first_copy(v);
    f(first);
    m_copies.for_each_partner(first, f);
  }

private:
  // Gives the corners of each sector of a vertex to a copy, but the first one. Fans of a pinched vertex that no barrier divides, or
  // that a barrier only enters, remain one point.
  void separate_sectors(All_face_links& links, const Index_pairs& corners)
  {
    std::vector<std::pair<Index, Index>> copy_of;   // of a corner
    std::vector<char> is_seen(3 * links.size(), 0); // by corner
    for (auto i = corners.begin(); i != corners.end();)
    {
      const Index v = i->first;
      std::vector<std::vector<Index>> sectors; // corners
      bool has_whole_fan = false;
      for (; i != corners.end() && i->first == v; ++i)
      {
        if (is_seen[i->second]) continue;
        const std::vector<Index> sector = sector_of(links, v, i->second, is_seen);
        if (is_whole_fan(sector)) has_whole_fan = true;
        else sectors.push_back(sector);
      }
      for (std::size_t k = has_whole_fan ? 0 : 1; k < sectors.size(); ++k)
      {
        const Index copy = Index(m_vertices_end + m_copied.size());
        m_copied.push_back(v);
        for (const Index c : sectors[k]) copy_of.emplace_back(c, copy);
      }
    }
    for (const auto& c : copy_of) links[c.first / 3].source[c.first % 3] = c.second;
  }

  // The corners of the vertex v that links connect with a corner. Marks them.
  static std::vector<Index> sector_of(const All_face_links& links, Index v, Index corner, std::vector<char>& is_seen)
  {
    is_seen[corner] = 1;
    std::vector<Index> sector{corner};
    for (std::size_t next = 0; next < sector.size(); ++next)
    {
      const Face_links& l = links[sector[next] / 3];
      const Index k = sector[next] % 3;
      for (const Index g : {l.beyond[k], l.beyond[(k + 2) % 3]})
      {
        if (g == no_index) continue;
        const Index c = 3 * g + links[g].halfedge_from(v);
        if (!std::exchange(is_seen[c], char(1))) sector.push_back(c);
      }
    }
    return sector;
  }

  // True if no barrier bounds a sector, or the same one on both sides.
  bool is_whole_fan(const std::vector<Index>& sector) const
  {
    std::vector<Index> barriers;
    for (const Index c : sector)
      for (const Index h : {c, c - c % 3 + (c % 3 + 2) % 3})
        if (across(h) != no_index) barriers.push_back((std::min)(h, across(h)));
    return barriers.empty() || (barriers.size() == 2 && barriers[0] == barriers[1]);
  }

  std::size_t m_vertices_end = 0;
  std::vector<Index> m_copied;
  Index_pairs m_across, m_first, m_copies; // m_first: from further copies to the first one; m_copies: the inverse
};

} // namespace CGAL::Geodesic_offset::internal

#endif
