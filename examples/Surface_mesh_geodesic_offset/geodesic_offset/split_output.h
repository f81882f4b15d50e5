// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Output of the mesh split along its offsets.

#ifndef GEODESIC_OFFSET_SPLIT_OUTPUT_H
#define GEODESIC_OFFSET_SPLIT_OUTPUT_H

#include "common.h"

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <vector>

namespace geodesic_offset {

// A mesh whose edges include the offsets.
class Split_mesh
{
  Mesh m_mesh;
  Mesh::Property_map<Face, std::size_t> m_band; // number of distances with offsets that the face is not nearer than
  Mesh::Property_map<Face, std::size_t> m_source; // nearest to the centroid; Geodesic::no_source() if none reaches it

public:
  // Precondition: the last build has kept windows, and the curves are all offsets of their distances.
  Split_mesh(const Mesh& mesh, const Geodesic& geodesic, const std::vector<Offset_curve>& curves, double chord_tolerance);

  // As binary PLY: faces with properties `band`, `source` (-1: none) and the colour of their band.
  void write(std::ostream& out) const;

  // Size without the header.
  std::uintmax_t number_of_bytes() const;
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_SPLIT_OUTPUT_H
