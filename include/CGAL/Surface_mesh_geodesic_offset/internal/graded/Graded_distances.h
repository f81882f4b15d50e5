// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances of graded vertices (Graded_places.h): a second propagation, with twice the digits of double, in the faces around them.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GRADED_GRADED_DISTANCES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GRADED_GRADED_DISTANCES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Wavefront.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/graded/Extended_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/graded/Graded_places.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Computation.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Double_arithmetic.h>

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

// The points of a surface for Graded_places and Extended_mesh.
template <class Surface>
class Points_of_surface
{
public:
  explicit Points_of_surface(const Surface& surface) : m_surface(surface) {}

  bool has_points() const { return m_surface.has_points; }

  std::array<double, 3> operator()(Index v) const
  {
    const auto p = m_surface.position(m_surface.vertex_of[v]);
    return {p.x(), p.y(), p.z()};
  }

  // The distance in space of vertex v from the edge of a and b, a lower bound of that on the surface. Zero without points.
  double between(Index v, Index a, Index b) const
  {
    if (!has_points()) return 0;
    const std::array<double, 3> p = (*this)(v), q = (*this)(a);
    const std::array<double, 3> to_p = difference(p, q), along = difference(a == b ? q : (*this)(b), q);
    const double square = dot(along, along);
    const double t = square > 0 ? (std::max)(0., (std::min)(1., dot(to_p, along) / square)) : 0.;
    return std::hypot(to_p[0] - t * along[0], to_p[1] - t * along[1], to_p[2] - t * along[2]);
  }

private:
  static std::array<double, 3> difference(const std::array<double, 3>& p, const std::array<double, 3>& q)
  {
    return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
  }
  static double dot(const std::array<double, 3>& u, const std::array<double, 3>& v)
  {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  }

  const Surface& m_surface;
};

// True if the computation is in double, with the functors of the package: others may have another metric. False with options of
// the compiler that spoil extended numbers.
template <class Traits, class Package = Package_traits<Traits>>
struct Has_graded_distances
{
  static constexpr bool value = may_round_correctly() && std::is_same<typename Package::FT, double>::value &&
                                std::is_same<Functors_of<Traits>, Functors_of<Package>>::value;
};

template <class Traits>
struct Has_graded_distances<Traits, void>
{
  static constexpr bool value = false;
};

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
    Geodesic_field<Extended> extended;
    try
    {
      propagate(mesh, mesh.sources(sources, reach), mesh.to_scale(reach), extended);
    }
    catch (const std::runtime_error&)
    { // too many windows, see Window_lists
      return result;
    }
    for (const Index v : places.vertices())
      if (const Extended& d = extended.distance[mesh.vertex(v)];
          Number_policy<Extended>::is_finite(d) && std::abs(mesh.from_scale(d) - field.distance[v]) <= rounding)
        result.emplace(v, (std::min)(maximum, mesh.from_scale(d)));
    return result;
  }

private:
  struct Nothing
  {
    static constexpr bool reads_lists = false;
    template <class Team>
    void take(const std::vector<Index>&, Team&)
    {
    }
    void settle(const Extended&) {}
  };

  static void propagate(const Extended_mesh& mesh, const Source_set<Extended>& sources, const Extended& maximum,
                        Geodesic_field<Extended>& field)
  {
    const Initial_windows<Extended> initial = sources.initial_windows(mesh.unfolded());
    field.clear(mesh.unfolded(), initial.start_values);
    const Extended_mesh::Traits traits;
    Wavefront<Extended_mesh::Traits> front(mesh.unfolded(), initial, traits, maximum, false, false, field);
    Nothing nothing;
    front.run(nothing, [](const Extended&, std::size_t) { return true; });
  }

  const Surface& m_surface;
};

// A Build_request with graded distances, if the number type has them. `surface` must remain until the end of the propagation.
template <class Surface, class Request>
Request with_graded_distances(const Surface& surface, Request request)
{
  if constexpr (Has_graded_distances<typename Surface::Traits>::value) request.refined = Graded_distances<Surface>(surface);
  else (void)surface;
  return request;
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
