// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sources of a build, as classified points and halfedges.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_SOURCE_SET_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_SOURCE_SET_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Initial_windows.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Source_set
{
public:
  enum Kind { POINT, OPEN_POLYLINE, CLOSED_POLYLINE, EDGES };

  struct Source
  {
    Kind kind;
    std::vector<Surface_point<FT>> points;
    std::vector<Index> halfedges;
    FT start_value = FT(0);
    std::vector<FT> start_values{}; // of the points of a polyline; empty: they are start_value
  };

  void insert(std::size_t id, Source source) { m_sources.emplace(id, std::move(source)); }

  // Calls f(id, source) for each source.
  template <class Function>
  void for_each(const Function& f) const
  {
    for (const auto& s : m_sources) f(s.first, s.second);
  }

  // \throws std::invalid_argument if rays cannot start from the source
  static void check(const Unfolded_mesh<FT>& mesh, const Source& source);

  // True if this set consists of `before` and sources with later ids.
  bool extends(const Source_set& before) const
  {
    auto i = m_sources.begin();
    for (auto j = before.m_sources.begin(); j != before.m_sources.end(); ++i, ++j)
      if (i == m_sources.end() || i->first != j->first) return false;
    return true;
  }

  Initial_windows<FT> initial_windows(const Unfolded_mesh<FT>& mesh) const;

private:
  static void start(const Unfolded_mesh<FT>& mesh, const Source& s, Index id, Initial_windows<FT>& initial);

  std::map<std::size_t, Source> m_sources;
};

} // namespace CGAL::Geodesic_offset::internal

#ifndef CGAL_GEODESIC_OFFSET_COMPILED
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Source_set_impl.h>
#endif

#endif
