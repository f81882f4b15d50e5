// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sources as the user added them.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_SOURCE_SET_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_SOURCE_SET_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Source_start.h>

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
class Source_set
{
public:
  enum Kind { POINT, OPEN_POLYLINE, CLOSED_POLYLINE, EDGES };

  // Throws if the points do not make a source on this mesh; then nothing is added.
  std::size_t add(const Unfolded_mesh<FT>& mesh, std::vector<Surface_point<FT>> points, Kind kind)
  {
    if (points.empty()) throw std::invalid_argument("Surface_mesh_geodesic_offset: a polyline without points");
    return add(mesh, Source{kind, std::move(points), {}});
  }

  std::size_t add_edges(const Unfolded_mesh<FT>& mesh, std::vector<Index> halfedges)
  {
    if (halfedges.empty()) throw std::invalid_argument("Surface_mesh_geodesic_offset: an empty set of edges");
    return add(mesh, Source{EDGES, {}, std::move(halfedges)});
  }

  void remove(std::size_t id)
  {
    if (m_sources.erase(id) == 0)
      throw std::invalid_argument("Surface_mesh_geodesic_offset: there is no source " + std::to_string(id));
  }

  void clear() { m_sources.clear(); }
  std::size_t size() const { return m_sources.size(); }

  // Whether this is another set and some later sources.
  bool extends(const Source_set& before) const
  {
    auto i = m_sources.begin();
    for (auto j = before.m_sources.begin(); j != before.m_sources.end(); ++i, ++j)
      if (i == m_sources.end() || i->first != j->first) return false;
    return true;
  }

  Initial_windows<FT> initial_windows(const Unfolded_mesh<FT>& mesh) const
  {
    Initial_windows<FT> initial(mesh);
    for (const auto& s : m_sources) start(mesh, s.second, Index(s.first), initial);
    initial.finish();
    return initial;
  }

  // Calls f(id, closed, the set of this source alone) for each polyline.
  template <class Function>
  void for_each_polyline(const Function& f) const
  {
    for (const auto& s : m_sources)
    {
      if (s.second.kind != OPEN_POLYLINE && s.second.kind != CLOSED_POLYLINE) continue;
      Source_set alone;
      alone.m_sources.insert(s);
      f(Index(s.first), s.second.kind == CLOSED_POLYLINE, alone);
    }
  }

private:
  struct Source
  {
    Kind kind;
    std::vector<Surface_point<FT>> points;
    std::vector<Index> halfedges;
  };

  std::size_t add(const Unfolded_mesh<FT>& mesh, Source&& source)
  {
    Initial_windows<FT> trial(mesh);
    start(mesh, source, 0, trial);
    m_sources.emplace(m_next, std::move(source));
    return m_next++;
  }

  static void start(const Unfolded_mesh<FT>& mesh, const Source& s, Index id, Initial_windows<FT>& initial)
  {
    switch (s.kind)
    {
    case POINT: initial.add_point(id, s.points.front()); break;
    case OPEN_POLYLINE: Source_start<FT>(mesh, initial).add_polyline(id, s.points, false); break;
    case CLOSED_POLYLINE: Source_start<FT>(mesh, initial).add_polyline(id, s.points, true); break;
    case EDGES: Source_start<FT>(mesh, initial).add_edges(id, s.halfedges); break;
    }
  }

  std::map<std::size_t, Source> m_sources;
  std::size_t m_next = 0;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
