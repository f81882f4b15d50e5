// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Barriers and regions of the command line: the mesh is split along their curves, and the faces outside of regions are removed. It is
// also split along source polylines with start values.

#ifndef GEODESIC_OFFSET_BARRIERS_H
#define GEODESIC_OFFSET_BARRIERS_H

#include "common/common.h"
#include "common/mesh_input.h"
#include "common/numbers.h"
#include "common/sources.h"
#include "offset_report.h"
#include "options.h"
#include "progress.h"

#include <CGAL/Surface_mesh_geodesic_offset/split_along_polylines.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace geodesic_offset {
namespace internal {

using Edge_flags = Mesh::Property_map<Edge, bool>;

// Edges of polylines: the number of the polyline, and the halfedge in its direction.
using Polyline_edges = std::vector<std::pair<std::size_t, Halfedge>>;

// Hands the flag of an edge to its parts, and counts the divided faces.
struct Barrier_splitting_visitor : CGAL::Default_offset_splitting_visitor<Mesh>
{
  Edge_flags is_barrier;
  std::size_t* divided_faces;
  Halfedge divided = Mesh::null_halfedge();

  void before_edge_split(Halfedge h, Mesh&) { divided = h; }
  void edge_split(Halfedge h, Mesh& mesh) { is_barrier[mesh.edge(h)] = is_barrier[mesh.edge(divided)]; }
  void before_subface_creations(Face, Mesh&) { ++*divided_faces; }
};

// The components of the surface between closed polylines, each with the parity of the number of polylines that contain it.
class Region_parts
{
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  // Spanning forest of the components: an edge to the parent, and the parity of the passes of polylines on the way to the root.
  struct Component
  {
    std::size_t parent = none, root = none;
    Edge edge;
    bool is_odd = false;
    bool is_inside = false; // of roots
  };

  using Neighbours = std::vector<std::vector<std::pair<std::size_t, Edge>>>; // by component, with an edge in between

  const Mesh& m_mesh;
  std::vector<std::pair<Edge, std::size_t>> m_passes; // with the number of the polyline, sorted
  std::vector<std::size_t> m_component; // by face
  std::vector<Component> m_components;

public:
  // is_left_inside: by polyline.
  Region_parts(const Mesh& mesh, const Polyline_edges& edges, const std::vector<bool>& is_left_inside)
    : m_mesh(mesh), m_component(mesh.number_of_faces(), none)
  {
    for(const auto& [polyline, h] : edges) m_passes.emplace_back(mesh.edge(h), polyline);
    std::sort(m_passes.begin(), m_passes.end());
    find_components();
    join_components();
    std::vector<bool> is_done(is_left_inside.size(), false);
    for(const auto& [polyline, h] : edges)
    {
      if(is_done[polyline]) continue;
      is_done[polyline] = true;
      const bool has_left = !mesh.is_border(h);
      add_polyline(polyline, m_component[mesh.face(has_left ? h : mesh.opposite(h))], is_left_inside[polyline] == has_left);
    }
  }

  // By face, whether it is inside of an odd number of polylines.
  std::vector<bool> faces_inside() const
  {
    std::vector<bool> result;
    for(const std::size_t c : m_component)
      result.push_back(m_components[m_components[c].root].is_inside != m_components[c].is_odd);
    return result;
  }

private:
  std::size_t number_of_passes(Edge e, std::size_t first_polyline, std::size_t last_polyline) const
  {
    const auto first = std::lower_bound(m_passes.begin(), m_passes.end(), std::make_pair(e, first_polyline));
    return static_cast<std::size_t>(std::upper_bound(first, m_passes.end(), std::make_pair(e, last_polyline)) - first);
  }

  void find_components()
  {
    std::vector<Face> pending;
    for(Face first : m_mesh.faces())
    {
      if(m_component[first] != none) continue;
      const std::size_t number = m_components.size();
      m_components.emplace_back();
      m_component[first] = number;
      for(pending.push_back(first); !pending.empty();)
      {
        const Face f = pending.back();
        pending.pop_back();
        for(Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(f)))
        {
          const Face g = m_mesh.face(m_mesh.opposite(h));
          if(g == Mesh::null_face() || m_component[g] != none || number_of_passes(m_mesh.edge(h), 0, none) != 0) continue;
          m_component[g] = number;
          pending.push_back(g);
        }
      }
    }
  }

  // Fans of faces that share a vertex away from the polylines: on the same sides of all. No polyline passes the null edge.
  void join_at_vertices(Neighbours& neighbours) const
  {
    std::vector<bool> is_on_polyline(m_mesh.number_of_vertices(), false);
    for(const auto& pass : m_passes)
      is_on_polyline[m_mesh.vertex(pass.first, 0)] = is_on_polyline[m_mesh.vertex(pass.first, 1)] = true;
    std::vector<std::size_t> component_at(m_mesh.number_of_vertices(), none);
    for(Halfedge h : m_mesh.halfedges())
    {
      const Vertex v = m_mesh.target(h);
      if(m_mesh.is_border(h) || is_on_polyline[v]) continue;
      const std::size_t a = component_at[v], b = m_component[m_mesh.face(h)];
      component_at[v] = b;
      if(a == none || a == b) continue;
      neighbours[a].emplace_back(b, Edge());
      neighbours[b].emplace_back(a, Edge());
    }
  }

  void join_components()
  {
    Neighbours neighbours(m_components.size());
    join_at_vertices(neighbours);
    for(const auto& pass : m_passes)
    {
      const Edge e = pass.first;
      if(m_mesh.is_border(e)) continue;
      const std::size_t a = m_component[m_mesh.face(m_mesh.halfedge(e, 0))],
                        b = m_component[m_mesh.face(m_mesh.halfedge(e, 1))];
      neighbours[a].emplace_back(b, e);
      neighbours[b].emplace_back(a, e);
    }
    std::vector<std::size_t> pending;
    for(std::size_t first = 0; first < m_components.size(); ++first)
    {
      if(m_components[first].root != none) continue;
      m_components[first].root = first;
      for(pending.push_back(first); !pending.empty();)
      {
        const std::size_t a = pending.back();
        pending.pop_back();
        for(const auto& [b, e] : neighbours[a])
        {
          if(m_components[b].root != none) continue;
          m_components[b] = {a, first, e, m_components[a].is_odd != (number_of_passes(e, 0, none) % 2 == 1), false};
          pending.push_back(b);
        }
      }
    }
  }

  // is_inside: whether the component is inside of the polyline.
  void add_polyline(std::size_t polyline, std::size_t component, bool is_inside)
  {
    const Component* c = &m_components[component];
    for(; c->parent != none; c = &m_components[c->parent])
      is_inside = is_inside != (number_of_passes(c->edge, polyline, polyline) % 2 == 1);
    Component& root = m_components[c->root];
    root.is_inside = root.is_inside != is_inside;
  }
};

// The polylines of some files, located on the mesh; reported as `kind`.
inline Sources located_polylines(const Mesh_input& input, const Options& options, const std::vector<std::string>& files,
                                 const Geodesic_mesh& mesh, const std::string& kind, Progress& progress)
{
  Source_options wanted;
  wanted.mesh = options.mesh;
  wanted.source_polylines = files;
  wanted.close_gap = options.close_gap;
  wanted.projection = options.projection;
  Sources polylines(input, wanted, mesh);
  for(const std::string& remark : polylines.remarks()) progress.line(kind + ": " + remark);
  for(const std::string& warning : polylines.warnings()) progress.warning(warning);
  report(polylines.moved_points(), input, kind, progress);
  if(const std::size_t n = polylines.points().size(); n != 0)
    progress.warning(counted(n, "polyline") + " of --" + kind + " without effect, as short as a point");
  return polylines;
}

// Whether a source polyline has start values.
inline bool have_start_values(const Options& options)
{
  for(const std::string& file : options.source_polylines)
    for(const File_polyline& polyline : read_polylines(file, false, true))
      if(!polyline.start_values.empty()) return true;
  return false;
}

// The source polylines with start values, located on the mesh. Messages on them come later, with the sources.
inline std::vector<Surface_polyline> polylines_with_start_values(const Mesh_input& input, const Options& options,
                                                                 const Geodesic_mesh& mesh)
{
  std::vector<Surface_polyline> result;
  if(!have_start_values(options)) return result;
  Source_options wanted;
  wanted.mesh = options.mesh;
  wanted.source_polylines = options.source_polylines;
  wanted.have_start_values = true;
  wanted.close_gap = options.close_gap;
  wanted.projection = options.projection;
  const Sources sources(input, wanted, mesh);
  for(const Surface_polyline& p : sources.surface_polylines())
    if(!p.start_values.empty()) result.push_back(p);
  return result;
}

// Whether the left side of each region's polyline is inside.
inline std::vector<bool> left_insides(const Sources& regions, Geodesic& geodesic, Progress& progress)
{
  std::vector<std::size_t> ids;
  for(std::size_t i = 0; i < regions.surface_polylines().size(); ++i)
  {
    require_closed(regions, i);
    ids.push_back(regions.first_polyline() + i);
  }
  regions.add_to(geodesic);
  const auto insides = report_insides(regions, ids, geodesic.inner_sides(), "", progress);
  std::vector<bool> result;
  for(const std::size_t id : ids)
  {
    const auto it = insides.find(id);
    result.push_back(it != insides.end() && it->second.side == CGAL::Source_side::LEFT);
  }
  return result;
}

// Those of the smallest angle of --barrier-sharp-edges.
inline std::vector<Edge> sharp_edges(const Options& options, const Geodesic_mesh& mesh)
{
  std::vector<Edge> result;
  for(const double degrees : options.barriers.barrier_sharp_edges)
  {
    std::vector<Edge> edges;
    mesh.sharp_edges(degrees, std::back_inserter(edges));
    if(edges.empty())
      throw Input_error("--barrier-sharp-edges " + short_number(degrees) + ": " + quoted(options.mesh) +
                        " has no edge with a larger angle");
    if(edges.size() > result.size()) result = std::move(edges);
  }
  return result;
}

inline double length_of(const Mesh& mesh, const std::vector<bool>& edges)
{
  double length = 0;
  for(Edge e : mesh.edges())
    if(edges[e]) length += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return length;
}

} // namespace internal

// Puts the barriers and regions of the options on the mesh. Throws Input_error.
inline void add_barriers(Mesh_input& input, const Options& options, Progress& progress)
{
  using namespace internal;
  Geodesic geodesic(input.mesh());
  const Sources barriers = located_polylines(input, options, options.barriers.barriers, geodesic.mesh(), "barrier", progress);
  const Sources regions = located_polylines(input, options, options.barriers.regions, geodesic.mesh(), "region", progress);
  const std::vector<bool> is_left_inside = left_insides(regions, geodesic, progress);
  const std::vector<Edge> sharp = sharp_edges(options, geodesic.mesh());
  std::vector<Surface_polyline> polylines = regions.surface_polylines();
  const std::size_t number_of_regions = polylines.size();
  polylines.insert(polylines.end(), barriers.surface_polylines().begin(), barriers.surface_polylines().end());
  const std::size_t number_of_curves = polylines.size();
  for(const Surface_polyline& p : polylines_with_start_values(input, options, geodesic.mesh())) polylines.push_back(p);
  Polyline_edges edges;
  std::size_t divided_faces = 0;
  input.split([&](Mesh& mesh) {
    Edge_flags flags = mesh.add_property_map<Edge, bool>("e:barrier", false).first;
    for(Edge e : sharp) flags[e] = true;
    Barrier_splitting_visitor visitor;
    visitor.is_barrier = flags;
    visitor.divided_faces = &divided_faces;
    CGAL::split_along_polylines(mesh, polylines, CGAL::parameters::output_iterator(std::back_inserter(edges)).visitor(visitor));
    for(const auto& [polyline, h] : edges)
      if(polyline >= number_of_regions && polyline < number_of_curves) flags[mesh.edge(h)] = true;
    std::vector<bool> is_barrier;
    for(Edge e : mesh.edges()) is_barrier.push_back(flags[e] && !mesh.is_border(e));
    const double length = length_of(mesh, is_barrier);
    if(options.barriers.have_effect() && (options.barriers.regions.empty() || length > 0))
      progress.line("barriers: " + counted(number_of_curves - number_of_regions, "polyline") + " and " +
                    counted(sharp.size(), "sharp edge") + ", of length " + short_number(length));
    mesh.remove_property_map(flags);
    // with faces of regions on both sides, an edge remains as a barrier
    for(const auto& [polyline, h] : edges)
      if(polyline < number_of_curves) is_barrier[mesh.edge(h)] = !mesh.is_border(mesh.edge(h));
    return is_barrier;
  });
  progress.line("mesh: " + counted(divided_faces, "face") + " divided along curves");
  if(options.barriers.regions.empty()) return;
  edges.erase(std::remove_if(edges.begin(), edges.end(), [&](const auto& e) { return e.first >= number_of_regions; }),
              edges.end());
  const std::vector<bool> is_kept = Region_parts(input.mesh(), edges, is_left_inside).faces_inside();
  const auto kept = static_cast<std::size_t>(std::count(is_kept.begin(), is_kept.end(), true));
  if(kept == 0)
    throw Input_error("--region: nothing of " + quoted(options.mesh) + " is inside of an odd number of the polylines");
  input.keep_faces(is_kept);
  progress.line("region: " + counted(is_kept.size() - kept, "face") + " removed, " + std::to_string(kept) + " left");
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_BARRIERS_H
