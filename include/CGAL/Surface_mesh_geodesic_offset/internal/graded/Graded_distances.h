// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances of graded vertices (Graded_places.h): a second propagation, with twice the digits of double, in the faces around them.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GRADED_GRADED_DISTANCES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GRADED_GRADED_DISTANCES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/graded/Extended_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/graded/Graded_places.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/graded/Points_of_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Function object for Build_request::refined.
template <class Surface>
class Graded_distances
{
  typedef typename Extended_mesh::FT Extended;

public:
  explicit Graded_distances(const Surface& surface) : m_surface(surface) {}

  // The distances of all graded vertices up to `maximum`, up to which those of the field are final. They improve those of the
  // field by no more than the rounding of these.
  std::map<Index, double> operator()(const Source_set<double>& sources, const Geodesic_field<double>& field,
                                     double maximum) const
  {
    std::map<Index, double> result;
    const Points_of_surface<Surface> points(m_surface);
    const Graded_places<Points_of_surface<Surface>> places(m_surface.unfolded, field, maximum, points);
    if (places.vertices().empty() || !rounds_to_nearest() || !rounds_correctly()) return result;
    double farthest = 0;
    for (const Index v : places.vertices()) farthest = (std::max)(farthest, field.distance[v]);
    const Extended_mesh mesh(m_surface.unfolded, places.faces(), points);
    if (!mesh.unfolded().is_laid_out()) return result;
    const double rounding = rounding_of_reach * m_surface.unfolded.longest_edge(), reach = farthest + 2 * rounding;
    Extended_field extended;
    try
    {
      extended.propagate(mesh, sources, reach, false);
    }
    catch (const std::runtime_error&)
    { // too many windows, see Window_lists
      return result;
    }
    for (const Index v : places.vertices())
      if (const Extended& d = extended.results.distance[mesh.vertex(v)];
          Number_policy<Extended>::is_finite(d) && std::abs(mesh.from_scale(d) - field.distance[v]) <= rounding)
        result.emplace(v, (std::min)(maximum, mesh.from_scale(d)));
    return result;
  }

private:
  const Surface& m_surface;
};

// A Build_request with graded distances, if the number type has them. `surface` must remain until the end of the propagation.
template <class Surface, class Request>
Request with_graded_distances(const Surface& surface, Request request)
{
  if constexpr (Has_extended_fields<typename Surface::Traits>::value) request.refined = Graded_distances<Surface>(surface);
  else (void)surface;
  return request;
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
