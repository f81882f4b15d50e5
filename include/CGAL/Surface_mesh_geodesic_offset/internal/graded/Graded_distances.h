// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances of graded vertices (Graded_places.h): a second propagation, with twice the digits of double, in the faces around them.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GRADED_GRADED_DISTANCES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GRADED_GRADED_DISTANCES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/graded/extended_distances.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/graded/Graded_places.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/graded/Points_of_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Function object for Build_request::refined.
template <class Surface>
class Graded_distances
{
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
    const double rounding = rounding_of_reach * m_surface.unfolded.longest_edge(), reach = farthest + 2 * rounding;
    const std::vector<double> extended =
      extended_distances<Extended_number>(m_surface.unfolded, places.faces(), points.point_of_vertex(), sources, reach,
                                          places.vertices());
    for (std::size_t i = 0; i < extended.size(); ++i)
      if (const Index v = places.vertices()[i]; std::abs(extended[i] - field.distance[v]) <= rounding)
        result.emplace(v, (std::min)(maximum, extended[i]));
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
