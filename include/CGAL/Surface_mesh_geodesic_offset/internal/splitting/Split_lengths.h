// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lengths of a split: the size of the mesh, and the chord tolerance.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_SPLIT_LENGTHS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_SPLIT_LENGTHS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/chord_tolerance.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL::Geodesic_offset::internal {

struct Split_lengths
{
  // Points closer than this part of the diagonal of the bounding box are one: 2^-33, about 1e-10. That is far above the rounding
  // and the level shift (2^-42), so that no thin triangles are left beside vertices and edges on a level, and a tenth of the
  // 1e-9 by which a vertex may be off its level. Binding test: test_splitting.
  static constexpr double snap_part = 1. / (1ull << 33);
  // Part of the diagonal by which levels differ at least. Points of curves move by at most the snap distance, so four times as
  // much keeps two curves apart. Binding test: test_splitting, close_levels.
  static constexpr double least_gap_part = 4 * snap_part;
  // Largest number of chords: their points, triangles and faces need some 500 bytes per chord, 10 GB.
  // Binding test: test_splitting.
  static constexpr std::size_t most_chords = 20000000;

  double diagonal; // of the bounding box
  double chord_tolerance;

  template <class TriangleMesh, class VertexPointMap>
  static double diagonal_of(const TriangleMesh& tm, const VertexPointMap& vpm)
  {
    Bbox_3 box; // of the surface: isolated vertices may be anywhere
    for (const auto v : vertices(tm))
      if (halfedge(v, tm) != boost::graph_traits<TriangleMesh>::null_halfedge()) box += get(vpm, v).bbox();
    return box.xmin() <= box.xmax() ? std::hypot(box.x_span(), box.y_span(), box.z_span()) : 0;
  }

  // Reads the parameter `chord_tolerance`, a number of type FT, and checks it with the curves.
  // \throws std::invalid_argument unless the tolerance is positive
  // \throws std::length_error if the curves have more than `most_chords`
  template <class FT, class TriangleMesh, class VertexPointMap, class Curves, class NamedParameters>
  static Split_lengths of(const TriangleMesh& tm, const VertexPointMap& vpm, const Curves& curves, const NamedParameters& np)
  {
    const double diagonal = diagonal_of(tm, vpm);
    const FT default_tolerance(diagonal > 0 ? default_chord_tolerance * diagonal : 1); // a mesh without a size has no chords
    const double tolerance = CGAL::to_double(
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::geodesic_chord_tolerance), default_tolerance));
    check_chord_tolerance(tolerance);
    std::size_t chords = 0;
    for (const auto& c : curves) chords += number_of_chords(c, FT(tolerance));
    if (chords > most_chords)
      throw std::length_error("Surface_mesh_geodesic_offset: the curves of a split have more than " +
                              std::to_string(most_chords) + " chords within the chord tolerance");
    return {diagonal, tolerance};
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
