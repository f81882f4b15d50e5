// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Section of a mesh by a plane in general position, as polylines of face locations.

#ifndef GEODESIC_OFFSET_TEST_PLANE_SECTION_H
#define GEODESIC_OFFSET_TEST_PLANE_SECTION_H

#include "locations.h"

#include <set>
#include <vector>

namespace test {

template <class TriangleMesh>
struct Section
{
  typedef test::Locations<TriangleMesh> Locations;
  typedef typename Locations::Face_location Face_location;

  bool closed;                                            // closed sections do not repeat their first location
  std::vector<Face_location> locations;                   // one on each crossed edge
  std::vector<typename Locations::face_descriptor> faces; // face of each segment

  std::size_t number_of_segments() const { return faces.size(); }

  /// Point at parameter `t` of segment i, in the face of the segment.
  Face_location between(const Locations& on_mesh, std::size_t i, double t) const
  {
    typename Locations::Barycentric_coordinates a, b;
    on_mesh.express(locations[i], faces[i], a);
    on_mesh.express(locations[(i + 1) % locations.size()], faces[i], b);
    for (std::size_t k = 0; k < 3; ++k) a[k] = (1 - t) * a[k] + t * b[k];
    return Face_location(faces[i], a);
  }
};

/// All curves of the section by the plane through `p` with the given normal. Vertices on the plane count as above it, so
/// every curve crosses edges at inner points (possibly at distance zero from an end).
template <class TriangleMesh>
std::vector<Section<TriangleMesh>> plane_section(const TriangleMesh& mesh, const Point_3& p, const Vector_3& normal)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  const test::Locations<TriangleMesh> on_mesh(mesh);
  const auto points = get(CGAL::vertex_point, mesh);
  const auto height = [&](typename Graph_traits::vertex_descriptor v) { return (get(points, v) - p) * normal; };
  const auto is_upward = [&](halfedge_descriptor h) { return height(source(h, mesh)) < 0 && height(target(h, mesh)) >= 0; };
  // With the upper side on its left, a curve enters each face over an edge that goes down in that face, and leaves it over
  // the one that goes up.
  const auto location = [&](halfedge_descriptor h) {
    const double a = std::abs(height(source(h, mesh))), b = std::abs(height(target(h, mesh)));
    const halfedge_descriptor inner = is_border(h, mesh) ? opposite(h, mesh) : h;
    return on_mesh.on_edge(inner, (inner == h ? a : b) / (a + b));
  };
  std::vector<Section<TriangleMesh>> result;
  std::set<halfedge_descriptor> done; // downward halfedges through which faces were entered
  const auto follow = [&](halfedge_descriptor entry) {
    Section<TriangleMesh> section;
    section.closed = false;
    section.locations.push_back(location(entry));
    for (halfedge_descriptor h = entry; !is_border(h, mesh);)
    {
      done.insert(h);
      section.faces.push_back(face(h, mesh));
      halfedge_descriptor exit = next(h, mesh);
      if (!is_upward(exit)) exit = next(exit, mesh);
      h = opposite(exit, mesh);
      if (h == entry)
      {
        section.closed = true;
        break;
      }
      section.locations.push_back(location(exit));
    }
    result.push_back(section);
  };
  for (halfedge_descriptor h : halfedges(mesh)) // open curves start at the boundary
    if (!is_border(h, mesh) && is_border(opposite(h, mesh), mesh) && is_upward(opposite(h, mesh))) follow(h);
  for (halfedge_descriptor h : halfedges(mesh))
    if (!is_border(h, mesh) && is_upward(opposite(h, mesh)) && done.count(h) == 0) follow(h);
  return result;
}

/// Plane in general position through a point near the center of the mesh.
template <class TriangleMesh>
std::vector<Section<TriangleMesh>> random_plane_section(const TriangleMesh& mesh, unsigned seed)
{
  Random random(seed);
  CGAL::Bbox_3 box;
  const auto points = get(CGAL::vertex_point, mesh);
  for (auto v : vertices(mesh)) box += get(points, v).bbox();
  const Point_3 middle(box.xmin() + uniform(random, 0.4, 0.6) * box.x_span(),
                       box.ymin() + uniform(random, 0.4, 0.6) * box.y_span(),
                       box.zmin() + uniform(random, 0.4, 0.6) * box.z_span());
  const Vector_3 normal(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, 0.2, 1));
  return plane_section(mesh, middle, normal);
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_PLANE_SECTION_H
