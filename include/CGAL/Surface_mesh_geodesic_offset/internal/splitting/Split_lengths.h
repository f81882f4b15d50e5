// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lengths of a split: the size of the mesh, and the chord tolerance.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_SPLIT_LENGTHS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_SPLIT_LENGTHS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Chord_tolerance.h>
#include <CGAL/Surface_mesh_geodesic_offset/named_parameters.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/number_utils.h>

#include <cmath>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

struct Split_lengths
{
  double diagonal; // of the bounding box
  double chord_tolerance;

  // Reads the parameter `chord_tolerance`, a number of type FT, and checks it with the curves.
  // \throws std::invalid_argument unless the tolerance is positive
  // \throws std::length_error if there are too many chords
  template <class FT, class TriangleMesh, class VertexPointMap, class Curves, class NamedParameters>
  static Split_lengths of(const TriangleMesh& tm, const VertexPointMap& vpm, const Curves& curves, const NamedParameters& np)
  {
    const Bbox_3 box = Polygon_mesh_processing::bbox(tm, parameters::vertex_point_map(vpm));
    const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
    const FT default_tolerance(default_chord_tolerance * diagonal);
    const double tolerance = CGAL::to_double(
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::geodesic_chord_tolerance), default_tolerance));
    check_all_numbers_of_chords(curves, tolerance);
    return {diagonal, tolerance};
  }
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
