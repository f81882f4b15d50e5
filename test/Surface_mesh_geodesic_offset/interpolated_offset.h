// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offsets as most programs compute them: from distances of vertices, interpolated linearly in each face.

#ifndef TEST_INTERPOLATED_OFFSET_H
#define TEST_INTERPOLATED_OFFSET_H

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_plane_section.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

// The curves where the interpolated distances are `level`, with the smaller ones on the left. distance(v): that of a vertex.
template <class Mesh, class Distance>
auto interpolated_offset(const Mesh& mesh, const Distance& distance, double level)
{
  typedef boost::graph_traits<Mesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor Halfedge;
  typedef std::pair<typename Graph_traits::face_descriptor, std::array<double, 3>> Face_location;
  typedef CGAL::Geodesic_polyline<Face_location> Polyline;

  const auto is_near = [&](typename Graph_traits::vertex_descriptor v) { return distance(v) < level; };
  // In a face, from the halfedge where the curve comes in to that where it leaves. Seen from the face, the near end of the
  // first one is its source, and that of the second one its target.
  const auto enters = [&](Halfedge h) { return is_near(source(h, mesh)) && !is_near(target(h, mesh)); };
  const auto leaves = [&](Halfedge h) { return !is_near(source(h, mesh)) && is_near(target(h, mesh)); };
  const auto point_on = [&](Halfedge h) {
    const bool is_forward = is_near(source(h, mesh));
    const auto a = is_forward ? source(h, mesh) : target(h, mesh), b = is_forward ? target(h, mesh) : source(h, mesh);
    const double t = (level - distance(a)) / (distance(b) - distance(a)), along = is_forward ? t : 1 - t;
    Face_location l(face(h, mesh), {{0., 0., 0.}});
    Halfedge g = halfedge(face(h, mesh), mesh);
    for (std::size_t k = 0; k < 3; ++k, g = next(g, mesh))
      if (g == h)
      {
        l.second[k] = 1 - along;
        l.second[(k + 1) % 3] = along;
      }
    return l;
  };

  std::map<Halfedge, Halfedge> following; // across a face
  std::vector<Halfedge> starts;
  for (const auto f : faces(mesh))
  {
    Halfedge in = Graph_traits::null_halfedge(), out = in;
    for (const Halfedge h : halfedges_around_face(halfedge(f, mesh), mesh))
    {
      if (enters(h)) in = h;
      if (leaves(h)) out = h;
    }
    if (in == Graph_traits::null_halfedge()) continue;
    following[in] = out;
    if (is_border(opposite(in, mesh), mesh)) starts.push_back(in);
  }
  std::vector<Polyline> result;
  const auto trace = [&](Halfedge start) {
    Polyline polyline;
    for (Halfedge h = start;;)
    {
      polyline.locations.push_back(point_on(h));
      const auto i = following.find(h);
      const Halfedge out = i->second;
      following.erase(i);
      h = opposite(out, mesh);
      polyline.is_closed = h == start;
      if (polyline.is_closed) break;
      if (is_border(h, mesh))
      {
        polyline.locations.push_back(point_on(out));
        break;
      }
    }
    result.push_back(polyline);
  };
  for (const Halfedge h : starts) trace(h);
  while (!following.empty()) trace(following.begin()->first);
  return result;
}

#endif
