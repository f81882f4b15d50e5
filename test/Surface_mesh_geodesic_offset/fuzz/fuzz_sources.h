// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The mesh of a Fuzz_case, and curves on it as sources from bytes.

#ifndef GEODESIC_OFFSET_TEST_FUZZ_SOURCES_H
#define GEODESIC_OFFSET_TEST_FUZZ_SOURCES_H

#include "../generated_meshes.h"
#include "../locations.h"
#include "fuzz_case.h"

#include <cstddef>
#include <vector>

namespace test {

class Fuzz_curves
{
public:
  Fuzz_curves(Fuzz_bytes& bytes, const Generated_mesh<Surface_mesh>& data) : bytes_(bytes), data_(data), locations_(data.mesh)
  {
  }

  /// The start value is not for a section, which may be several sources.
  void add_to(Geodesic& geodesic, double start_value = 0)
  {
    const auto start = CGAL::parameters::start_value(start_value);
    switch (bytes_.index(6))
    {
    case 0: geodesic.add_source_polyline(path_of_edges(), start); break;
    case 1: geodesic.add_source_edges(std::vector<Surface_mesh::Edge_index>{data_.mesh.edge(draw_halfedge())}, start); break;
    case 2:
    { // around a face
      Path path;
      for (const auto h : data_.mesh.halfedges_around_face(draw_halfedge()))
        path.push_back(locations_.at_vertex(data_.mesh.source(h)));
      geodesic.add_source_polyline(path, start.is_closed(true));
      break;
    }
    case 3:
    { // through a vertex
      const Point_3 p = data_.mesh.point(data_.vertices[bytes_.index(data_.vertices.size())]);
      const double a = bytes_.coordinate(), b = bytes_.coordinate(), c = bytes_.coordinate();
      if (a * a + b * b + c * c > 0) geodesic.add_source_plane_section({p, CGAL::Vector_3<Kernel>(a, b, c)});
      break;
    }
    default: geodesic.add_source_polyline(polyline_across_faces(), start);
    }
  }

private:
  typedef std::vector<Geodesic::Face_location> Path;

  Surface_mesh::Halfedge_index draw_halfedge() { return data_.mesh.halfedge(data_.faces[bytes_.index(data_.faces.size())]); }

  Path path_of_edges()
  {
    auto h = draw_halfedge();
    Path path = {locations_.at_vertex(data_.mesh.source(h))};
    for (std::size_t n = 1 + bytes_.index(3); n > 0; --n, h = data_.mesh.next(h))
      path.push_back(locations_.at_vertex(data_.mesh.target(h)));
    return path;
  }

  // From edge to edge of up to four faces; consecutive points may coincide.
  Path polyline_across_faces()
  {
    auto h = draw_halfedge();
    Path path = {locations_.on_edge(h, bytes_.weight())};
    for (std::size_t n = 1 + bytes_.index(4); n > 0; --n)
    {
      h = bytes_.flag() ? data_.mesh.next(h) : data_.mesh.prev(h);
      path.push_back(locations_.on_edge(h, bytes_.weight()));
      if (data_.mesh.is_border(data_.mesh.opposite(h))) break;
      h = data_.mesh.opposite(h);
    }
    return path;
  }

  Fuzz_bytes& bytes_;
  const Generated_mesh<Surface_mesh>& data_;
  const Locations<Surface_mesh> locations_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_FUZZ_SOURCES_H
