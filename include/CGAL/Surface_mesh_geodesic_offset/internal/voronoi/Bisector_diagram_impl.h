// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Definitions for Bisector_diagram.h: the bisectors of all faces. Each edge has one list of gates, found by the first of its faces.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_BISECTOR_DIAGRAM_IMPL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_BISECTOR_DIAGRAM_IMPL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_chains.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_diagram.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Face_bisectors.h>

#include <cstddef>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Labels the faces with cells: by their centers if a curve crosses them.
template <class NT>
void label_crossed_faces(Bisector_diagram<NT>& diagram)
{
  std::unordered_set<Index> crossed;
  for (const Bisector_chain<NT>& chain : diagram.chains)
    for (const Bisector_arc<NT>& a : chain.arcs) crossed.insert(a.face);
  for (auto& [face, cells] : diagram.cells)
  {
    cells.is_crossed = crossed.count(face) != 0;
    diagram.label_of_face[face] = cells.is_crossed ? cells.label_of_center() : cells.label_without_curves();
  }
}

template <class NT, class FT>
Bisector_diagram<NT> find_bisectors(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial,
                                    const Geodesic_field<FT>& field)
{
  struct Edge_gate // in the direction of the halfedge with the smaller index
  {
    NT t;
    Index from, to, node;
  };
  std::unordered_map<Index, std::vector<Edge_gate>> gates; // by this halfedge
  Face_bisectors<NT, FT> bisectors(mesh, initial, field);
  std::vector<Bisector_arc<NT>> arcs;
  Bisector_diagram<NT> diagram;
  diagram.label_of_face.assign(mesh.number_of_faces(), no_index);
  Index nodes = 0;
  const auto new_node = [&nodes] { return nodes++; };
  for (Index f = 0; f < mesh.number_of_faces(); ++f)
  {
    if (mesh.source(3 * f) == no_index) continue;
    const bool is_crossed = bisectors.set_face(f);
    diagram.label_of_face[f] = bisectors.label();
    bool has_gates = false;
    for (int k = 0; k < 3; ++k)
    {
      const Index h = 3 * f + Index(k), g = mesh.twin(h);
      if (g == no_index || h < g)
      { // the first face of the edge finds its gates
        if (!is_crossed) continue;
        bisectors.find_changes(k, [&](const Label_change<NT>& c) { gates[h].push_back({c.t, c.from, c.to, new_node()}); });
      }
      has_gates = has_gates || gates.count(g == no_index || h < g ? h : g) != 0;
    }
    if (!is_crossed && !has_gates) continue;
    for (int k = 0; k < 3; ++k)
    {
      const Index h = 3 * f + Index(k), g = mesh.twin(h);
      const bool is_first = g == no_index || h < g;
      const auto found = gates.find(is_first ? h : g);
      if (found == gates.end()) continue;
      const std::vector<Edge_gate>& of_edge = found->second;
      if (is_first)
        for (const Edge_gate& e : of_edge) bisectors.add_gate(k, e.t, e.from, e.to, e.node);
      else
      {
        const NT length = number_cast<NT>(mesh[h].length);
        for (auto e = of_edge.rbegin(); e != of_edge.rend(); ++e) bisectors.add_gate(k, length - e->t, e->to, e->from, e->node);
      }
    }
    const std::size_t known = arcs.size();
    bisectors.find_arcs(new_node, [&](const Bisector_arc<NT>& a) { arcs.push_back(a); });
    if (!is_crossed || arcs.size() == known) continue;
    Face_cells<NT> cells = bisectors.cells();
    diagram.cells.emplace(f, std::move(cells));
  }
  diagram.divisions = bisectors.number_of_divisions();
  diagram.forced_cells = bisectors.number_of_forced_cells();
  Bisector_chains(std::move(arcs), nodes).write(diagram);
  label_crossed_faces(diagram);
  return diagram;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
