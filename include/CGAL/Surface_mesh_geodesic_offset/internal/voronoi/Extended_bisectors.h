// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bisectors of a build. Where rounding lets them contradict each other, or leaves some of them out, all are found again
// with twice the digits of double: distances that tie only up to rounding then differ by far more than their errors.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_EXTENDED_BISECTORS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_EXTENDED_BISECTORS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/graded/Extended_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/graded/Points_of_surface.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Extended_number.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/voronoi_extraction.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Function object that finds the bisectors with twice the digits of double.
template <class Number>
class Extended_bisectors
{
public:
  Extended_bisectors(const Unfolded_mesh<double>& mesh, const Point_of_vertex& point) : m_mesh(mesh), m_point(point) {}

  // Nothing if the rounding mode does not allow it, or there are too many windows or comparisons.
  std::optional<Bisector_diagram<double>> operator()(const Source_set<double>& sources)
  {
    if (!rounds_to_nearest() || !rounds_correctly()) return std::nullopt;
    m_faces.clear();
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f)
      if (m_mesh.source(3 * f) != no_index) m_faces.push_back(f);
    const Extended_mesh<Number> mesh(m_mesh, m_faces, m_point);
    if (!mesh.unfolded().is_laid_out()) return std::nullopt;
    try
    {
      Extended_field<Number> field;
      field.propagate(mesh, sources, std::numeric_limits<double>::infinity(), true);
      for (std::size_t i = 0; i < field.initial->primitives.size(); ++i)
        field.initial->source_of[i] = field.initial->primitives[i].source =
          field.source_of_part[field.initial->primitives[i].source];
      typedef Voronoi_tolerances<double> Tolerances;
      const std::size_t most_comparisons =
        Tolerances::most_repeated_comparisons + Tolerances::most_repeated_comparisons_of_face * m_faces.size();
      if (const auto d = find_bisectors<Number>(mesh.unfolded(), *field.initial, field.results, {most_comparisons, false}))
        return in_double(*d, mesh);
    }
    catch (const std::runtime_error&)
    { // see Window_lists
    }
    return std::nullopt;
  }

private:
  Bisector_diagram<double> in_double(const Bisector_diagram<Number>& d, const Extended_mesh<Number>& mesh) const
  {
    const double scale = mesh.from_unit(Number(1));
    const std::vector<Index> vertex_of = mesh.original_vertices();
    const auto original_halfedge = [this](Index h) { return h == no_index ? h : 3 * m_faces[h / 3] + h % 3; };
    Bisector_diagram<double> result;
    for (const auto& chain : d.chains)
    {
      result.chains.push_back({{}, chain.is_closed, chain.start_vertex, chain.end_vertex});
      for (const auto& arc : chain.arcs)
      {
        Bisector_arc<double> a = arc.in_double(scale);
        a.face = m_faces[a.face];
        a.edge = original_halfedge(a.edge);
        for (Bisector_side* const side : {&a.left, &a.right})
          if (side->pseudo_source != no_index) side->pseudo_source = vertex_of[side->pseudo_source];
        result.chains.back().arcs.push_back(a);
      }
    }
    for (const auto& v : d.vertices)
      result.vertices.push_back(
        {m_faces[v.face], {scale * CGAL::to_double(v.point.x), scale * CGAL::to_double(v.point.y)}, v.edge, v.curves});
    result.label_of_face.assign(m_mesh.number_of_faces(), no_index);
    for (std::size_t i = 0; i < m_faces.size(); ++i) result.label_of_face[m_faces[i]] = d.label_of_face[i];
    for (const auto& [face, cells] : d.cells) result.cells.emplace(m_faces[face], cells.in_double(scale));
    result.divisions = d.divisions;
    result.forced_cells = d.forced_cells;
    result.is_uncertain = d.is_uncertain;
    return result;
  }

  const Unfolded_mesh<double>& m_mesh;
  const Point_of_vertex& m_point;
  std::vector<Index> m_faces;
};

// As for extended_distances(), a function of its own may be compiled separately.
template <class Number>
std::optional<Bisector_diagram<double>> extended_bisectors(const Unfolded_mesh<double>& mesh, const Point_of_vertex& point,
                                                           const Source_set<double>& sources)
{
  return Extended_bisectors<Number>(mesh, point)(sources);
}

template <class Surface, class Build>
Bisector_diagram<double> find_bisectors_of_build(const Surface& surface, const Build& build)
{
  const auto find = [&](bool stops_if_uncertain) {
    Bisector_limits limits;
    limits.stops_if_uncertain = stops_if_uncertain;
    return find_bisectors<double>(surface.unfolded, build.initial, build.field, limits);
  };
  if constexpr (Has_extended_fields<typename Surface::Traits>::value)
  {
    auto diagram = find(true);
    if (diagram && !diagram->is_uncertain) return std::move(*diagram);
    auto extended = extended_bisectors<Extended_number>(surface.unfolded, Points_of_surface<Surface>(surface).point_of_vertex(),
                                                        build.sources);
    if (extended && extended->forced_cells == 0) return std::move(*extended);
    if (!diagram) diagram = find(false);
    return extended && extended->forced_cells <= diagram->forced_cells ? std::move(*extended) : std::move(*diagram);
  }
  else return *find(false);
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
