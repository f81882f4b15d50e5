// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances of some vertices with twice the digits of double. A function of its own, so that it may be compiled separately.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GRADED_EXTENDED_DISTANCES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GRADED_EXTENDED_DISTANCES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/graded/Extended_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/graded/Extended_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Extended_number.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <limits>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Per element of `vertices`, its distance within `faces` from the sources, up to `reach`; infinite if there is none. No elements
// if the faces cannot be laid out, or there are too many windows.
template <class Number>
std::vector<double> extended_distances(const Unfolded_mesh<double>& mesh, const std::vector<Index>& faces,
                                       const Point_of_vertex& point, const Source_set<double>& sources, double reach,
                                       const std::vector<Index>& vertices)
{
  const Extended_mesh<Number> extended_mesh(mesh, faces, point);
  std::vector<double> result;
  if (!extended_mesh.unfolded().is_laid_out()) return result;
  Extended_field<Number> field;
  try
  {
    field.propagate(extended_mesh, sources, reach, false);
  }
  catch (const std::runtime_error&)
  { // too many windows, see Window_lists
    return result;
  }
  for (const Index v : vertices)
  {
    const Number& d = field.results.distance[extended_mesh.vertex(v)];
    result.push_back(Number_policy<Number>::is_finite(d) ? extended_mesh.from_scale(d)
                                                         : std::numeric_limits<double>::infinity());
  }
  return result;
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
