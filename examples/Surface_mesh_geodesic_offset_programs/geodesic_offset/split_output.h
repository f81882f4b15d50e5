// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Output of the mesh split along its offsets, or along the curves of its Voronoi diagram.

#ifndef GEODESIC_OFFSET_SPLIT_OUTPUT_H
#define GEODESIC_OFFSET_SPLIT_OUTPUT_H

#include "common/color_map.h"
#include "common/common.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace geodesic_offset {

// A mesh whose edges include the offsets, or the curves between the cells of the sources.
class Split_mesh
{
  struct Property
  {
    const char* name;
    Mesh::Property_map<Face, std::size_t> map; // Geodesic::no_source(): none
  };

  Mesh m_mesh;
  std::vector<Property> m_properties;
  std::vector<Color> m_colors; // per value of the first property

  Property& add_property(const char* name);
  void write(std::ostream& out, const std::vector<Vertex>& vertices, const std::vector<Face>& faces) const;

public:
  // Faces have their band, the number of distances with offsets that they are not nearer than, and the source nearest to their
  // centroid. Precondition: the last build has kept windows, and the curves are all offsets of their distances.
  Split_mesh(const Mesh& mesh, const Geodesic& geodesic, const std::vector<Offset_curve>& curves, double chord_tolerance);

  // Faces have the source in whose cell they lie.
  Split_mesh(const Mesh& mesh, const Geodesic::Field::Voronoi_diagram& diagram, std::size_t number_of_sources,
             double chord_tolerance);

  // As binary PLY: faces with their properties (-1: none) and the colour of the first one.
  void write(std::ostream& out) const;

  // The same with some faces and their vertices only.
  void write(std::ostream& out, const std::vector<Face>& faces) const;

  // Faces by the value of a property.
  std::map<std::size_t, std::vector<Face>> parts(const std::string& property) const;

  // Size without the header.
  std::uintmax_t number_of_bytes() const;
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_SPLIT_OUTPUT_H
