// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances of some vertices, computed with twice the digits of double. The function is listed in separate_functions.h.

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

// The distances of `vertices` from the parts of the sources in `faces`, along paths within these faces; infinite beyond
// `reach`. Empty if a face has no positive area when laid out, or if there are too many windows. `faces`: different, at least
// one; each of `vertices` is a corner of one of them. `point`: empty for a mesh by lengths. `Number`: Extended_number; a
// parameter, as functions that are compiled separately are templates. Precondition: rounds_to_nearest() and rounds_correctly().
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
  { // too many windows in a list or in all, see Extended_field::propagate()
    return result;
  }
  for (const Index v : vertices)
  {
    const Number& d = field.results.distance[extended_mesh.vertex(v)];
    result.push_back(Number_policy<Number>::is_finite(d) ? extended_mesh.from_unit(d) : std::numeric_limits<double>::infinity());
  }
  return result;
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
