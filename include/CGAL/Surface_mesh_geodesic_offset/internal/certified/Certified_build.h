// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Certified bounds of the distances from sources, and certificates of offsets.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_BUILD_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_BUILD_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_offset_certificate.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_points.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Source_set.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

class Certified_mesh;

typedef std::pair<double, double> Bounds; // lower, upper

constexpr std::size_t no_curve = std::size_t(-1);

// A piece of an offset curve. `from`, `to`: its ends on the surface. The end of the piece before becomes the joint, and the gap
// between both counts as uncertainty of the points of this piece.
struct Offset_curve_piece
{
  Index face;
  Surface_point<double> from, to;
  Point_in_face<double> start, end, center; // in the frame of the face
  double radius;                            // 0 for a segment. An arc runs counterclockwise, by less than a half turn
};

// A curve to certify: a polyline, or pieces.
struct Curve_to_certify
{
  bool is_closed;
  std::vector<Surface_point<double>> points;
  std::vector<Offset_curve_piece> pieces; // if there are no points
};

struct Offset_certification_result
{
  bool bounds_region = false;
  double tolerance = 0;
  Offset_certificate_limit limit = Offset_certificate_limit::NONE;
  Index face = no_index;
  Point_in_face<double> place{0, 0};
  Bounds bounds{0, 0};
  std::size_t curve = no_curve;
  std::vector<std::size_t> reversed; // curves, increasing
};

// The lengths of arguments and results are those of the user's mesh. Precondition of all functions: the rounding mode is to
// nearest.
class Certified_build
{
public:
  // The mesh as certified computations have it; several builds share it. `unfolded` must outlive it.
  static std::shared_ptr<const Certified_mesh> make_mesh(
    const Unfolded_mesh<double>& unfolded, const Surface_points<Exact_predicates_inexact_constructions_kernel>& points);

  Certified_build(const std::shared_ptr<const Certified_mesh>& mesh, const Source_set<double>& sources, bool keeps_windows);
  ~Certified_build();

  bool has_windows() const;
  std::size_t number_of_windows() const;

  // Precondition: windows are kept, or p is a vertex.
  Bounds distance_bounds(const Surface_point<double>& p) const;

  // Precondition: windows are kept. `distance`: not negative.
  Offset_certification_result certify_offset(double distance, const std::vector<Curve_to_certify>& curves) const;

private:
  struct Parts;

  const std::unique_ptr<const Parts> m_parts;
};

} // namespace CGAL::Geodesic_offset::internal

#ifndef CGAL_GEODESIC_OFFSET_COMPILED
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_build_impl.h>
#endif

#endif
