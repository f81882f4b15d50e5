// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which side of a closed polyline is its inside: the one with the smaller area. Found from the polyline's own field: where
// it bounds, every shortest path to it stays on one side.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_INNER_SIDE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_INNER_SIDE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build.h>

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// `polyline`: the only source of its set. Takes one propagation over the whole surface.
// Throws if the polyline does not divide its part of the surface.
template <class Traits>
Source_side inner_side(const Unfolded_mesh<typename Traits::FT>& mesh, const Traits& traits,
                       const Source_set<typename Traits::FT>& polyline, Index id)
{
  typedef typename Traits::FT FT;
  Geodesic_build<Traits> build(mesh, polyline, Number_policy<FT>::infinity(), false);
  build.propagate(traits);

  std::vector<char> is_touched(mesh.number_of_faces(), 0);
  for (const auto& w : build.initial.local) is_touched[w.face] = 1;
  for (const auto& w : build.initial.edges) is_touched[mesh.face(w.halfedge)] = 1;

  FT area[4] = {FT(0), FT(0), FT(0), FT(0)}; // by side
  for (Index f = 0; f < mesh.number_of_faces(); ++f)
  {
    if (mesh.source(3 * f) == no_index) continue;
    const FT third = mesh[3 * f].length * mesh[3 * f].apex_y / FT(6);
    bool has_side[4] = {false, false, false, false};
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const Index v = mesh.source(h);
      if (!build.field.root[v].is_valid() || !(build.field.distance[v] > FT(0))) continue;
      const int side = int(build.field.root[v].side());
      area[side] += third;
      has_side[side] = true;
    }
    if (!is_touched[f] && has_side[int(Source_side::LEFT)] && has_side[int(Source_side::RIGHT)])
      throw std::invalid_argument("Surface_mesh_geodesic_offset: source " + std::to_string(id) +
                                  " does not divide the surface into an inside and an outside");
  }
  return area[int(Source_side::RIGHT)] < area[int(Source_side::LEFT)] ? Source_side::RIGHT : Source_side::LEFT;
}

// The inner sides of all closed polylines. Throws if there is a polyline without an inside.
template <class Traits>
std::map<Index, Source_side> inner_sides(const Unfolded_mesh<typename Traits::FT>& mesh, const Traits& traits,
                                         const Source_set<typename Traits::FT>& sources)
{
  std::map<Index, Source_side> sides;
  sources.for_each_polyline([&](Index id, bool closed, const Source_set<typename Traits::FT>& alone) {
    if (!closed)
      throw std::invalid_argument("Surface_mesh_geodesic_offset: source " + std::to_string(id) +
                                  " is an open polyline and has no inside");
    sides[id] = inner_side(mesh, traits, alone, id);
  });
  return sides;
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
