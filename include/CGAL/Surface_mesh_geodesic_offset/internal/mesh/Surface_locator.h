// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Location of points and rays on the surface. The first queries search all faces, later ones an AABB tree; the results are
// the same.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_SURFACE_LOCATOR_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_SURFACE_LOCATOR_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_points.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

namespace CGAL::Geodesic_offset::internal {

// Concurrent queries are safe. On a mesh without faces, all functions throw std::invalid_argument. Isolated vertices are
// ignored. `Number`: that of the unfolded mesh.
template <class Kernel, class Number>
class Surface_locator
{
public:
  typedef typename Kernel::FT FT;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;
  typedef typename Kernel::Ray_3 Ray_3;
  typedef std::pair<Index, std::array<FT, 3>> Face_location; // face of the unfolded mesh, barycentric coordinates

  // Both must outlive this object.
  Surface_locator(const Unfolded_mesh<Number>& mesh, const Surface_points<Kernel>& points);
  ~Surface_locator();

  // Announces the number of further queries: builds the tree at once if it pays.
  void expect(std::size_t queries) const;

  // The location nearest to p, snapped: if the location or p is within the tolerance (a length) of a vertex, the result is
  // exactly at the nearest vertex; otherwise, if of an edge, exactly on the nearest edge. The search covers adjacent faces
  // within the tolerance.
  Face_location locate(const Point_3& p, const FT& tolerance) const;

  // The first point of a ray on the surface, snapped likewise; nothing if the ray misses the surface.
  std::optional<Face_location> locate(const Ray_3& r, const FT& tolerance) const;

  // Bound of the rounding error of points with the coordinates of the mesh; zero for exact numbers.
  FT default_tolerance() const;

private:
  class Search;

  const std::unique_ptr<Search> m_search;
};

} // namespace CGAL::Geodesic_offset::internal

#ifndef CGAL_GEODESIC_OFFSET_COMPILED
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_locator_impl.h>
#endif

#endif
