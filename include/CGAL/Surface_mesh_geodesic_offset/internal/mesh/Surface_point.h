// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A point of the surface, classified: at a vertex, inside an edge, or inside a face.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_SURFACE_POINT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_SURFACE_POINT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
struct Surface_point
{
  enum Kind : unsigned char { VERTEX, EDGE, FACE };

  Kind kind = FACE;
  Index element = no_index; // a vertex, a halfedge, or a face
  FT x = FT(0), y = FT(0);  // EDGE: x along the halfedge; FACE: in the face's frame

  static Surface_point at_vertex(Index v)
  {
    Surface_point p;
    p.kind = VERTEX;
    p.element = v;
    return p;
  }
  static Surface_point on_edge(Index h, const FT& t)
  {
    Surface_point p;
    p.kind = EDGE;
    p.element = h;
    p.x = t;
    return p;
  }
  static Surface_point in_face(Index face, const Point_in_face<FT>& q)
  {
    Surface_point p;
    p.element = face;
    p.x = q.x;
    p.y = q.y;
    return p;
  }
};

// A point of a face in the frame of halfedge h, from its barycentric coordinates with respect to the target of h and the
// apex.
template <class FT>
inline Point_in_face<FT> position_in_frame(const Unfolded_mesh<FT>& mesh, Index h, const FT& target, const FT& apex)
{
  return {target * mesh[h].length + apex * mesh[h].apex_x, apex * mesh[h].apex_y};
}

// A point as it was asked for: inside a face, with its barycentric coordinates, from which each halfedge's frame gets it
// without the rounding of another's.
template <class FT>
struct Located_point : Surface_point<FT>
{
  std::array<FT, 3> weights; // FACE

  Located_point(const Surface_point<FT>& p) : Surface_point<FT>(p) {}
  Located_point(const Surface_point<FT>& p, const std::array<FT, 3>& w) : Surface_point<FT>(p), weights(w) {}
};

// Where a path crosses an edge, as a part of the way from the source of the halfedge to its target; or passes a vertex.
template <class FT>
struct Path_crossing
{
  Index halfedge; // no_index: at the vertex `source`
  Index source, target;
  FT part;
};

// Barycentric coordinates below this part of the largest are round-off of zero: the point is on the edge, or at the
// vertex.
inline double snapping_tolerance() { return 1e-13; }

// At a vertex, or on an edge, if it is one; w: coordinates of which the sum is 1.
template <class FT, class Name>
Located_point<FT> classify_on_boundary(const Unfolded_mesh<FT>& mesh, Index face, const Name& name, bool valid,
                                       const std::array<FT, 3>& coordinates, const FT& eps)
{
  const Per_corner<FT> w = coordinates;
  const FT slack = Number_policy<FT>::is_inexact ? FT(1e-9) : FT(0);
  int zeros = 0, zero = -1, other = -1;
  for (int k = 0; valid && k < 3; ++k)
  {
    valid = w[k] >= -slack && w[k] <= FT(1) + slack;
    if (w[k] <= eps)
    {
      ++zeros;
      zero = k;
    }
    else
      other = k;
  }
  if (!valid)
    throw std::invalid_argument("Surface_mesh_geodesic_offset: a location in face " + std::to_string(name()) +
                                " does not lie in the face, or the face is not of this mesh");
  if (zeros == 2) return Surface_point<FT>::at_vertex(mesh.source(3 * face + Index(other)));
  // Halfedge k is opposite to corner `zero`. The point is projected on it: on a needle, a coordinate of the size of rounding
  // stands for a long way along the halfedge.
  const int k = (zero + 1) % 3;
  const Index h = 3 * face + Index(k);
  const FT length = mesh[h].length, t = position_in_frame(mesh, h, w[(k + 1) % 3], w[zero]).x;
  if (t <= eps * length) return Surface_point<FT>::at_vertex(mesh.source(h));
  if (length - t <= eps * length) return Surface_point<FT>::at_vertex(mesh.target(h));
  return Surface_point<FT>::on_edge(h, t);
}

// name(): the number by which the user knows the face, which need not be one of the mesh.
template <class FT, class Name>
BOOST_FORCEINLINE Located_point<FT> classify(const Unfolded_mesh<FT>& mesh, Index face, const Name& name,
                                             std::array<FT, 3> w)
{
  const FT sum = w[0] + w[1] + w[2];
  const FT eps = Number_policy<FT>::is_inexact ? FT(snapping_tolerance()) : FT(0);
  const bool valid = face < mesh.number_of_faces() && mesh.source(3 * face) != no_index && CGAL::is_positive(sum);
  if (valid)
    for (FT& x : w) x /= sum;
  if (!(valid && w[0] > eps && w[1] > eps && w[2] > eps)) // if so, none is above 1
    return classify_on_boundary(mesh, face, name, valid && Number_policy<FT>::is_finite(sum), w, eps);
  return {Surface_point<FT>::in_face(face, position_in_frame(mesh, 3 * face, w[1], w[2])), w};
}

// The faces around a surface point.
template <class FT>
std::vector<Index> faces_of(const Unfolded_mesh<FT>& mesh, const Surface_point<FT>& p)
{
  std::vector<Index> result;
  if (p.kind == Surface_point<FT>::FACE)
    result.push_back(p.element);
  else if (p.kind == Surface_point<FT>::EDGE)
  {
    result.push_back(mesh.face(p.element));
    if (mesh.twin(p.element) != no_index) result.push_back(mesh.face(mesh.twin(p.element)));
  }
  else
    mesh.for_each_fan(p.element, [&](Index first) {
      Index c = first;
      do
      {
        result.push_back(mesh.face(c));
        c = mesh.corner_ccw(c);
      } while (c != no_index && c != first);
    });
  return result;
}

// The number of the halfedge that one of the bits below stands for.
inline int edge_of_bit(unsigned bit)
{
  CGAL_precondition(bit == 1 || bit == 2 || bit == 4);
  return bit == 1 ? 0 : bit == 2 ? 1 : 2;
}

// Position of p in the frame of the face; returns false if p does not lie in this (closed) face.
// `edges` receives a bit for each halfedge of the face on which p lies.
template <class FT>
bool position_in_face(const Unfolded_mesh<FT>& mesh, const Surface_point<FT>& p, Index face,
                      Point_in_face<FT>& position, unsigned& edges)
{
  edges = 0;
  if (p.kind == Surface_point<FT>::FACE)
  {
    position = {p.x, p.y};
    return p.element == face;
  }
  const Face_frame<FT> frame(mesh, face);
  for (int k = 0; k < 3; ++k)
  {
    const Index h = 3 * face + Index(k);
    if (p.kind == Surface_point<FT>::VERTEX && mesh.source(h) == p.element)
    {
      position = frame.corner(k);
      edges = 1u << k | 1u << (k + 2) % 3;
      return true;
    }
    if (p.kind == Surface_point<FT>::EDGE && (p.element == h || mesh.twin(p.element) == h))
    {
      position = frame.on_edge(k, p.element == h ? p.x : FT(mesh[h].length - p.x));
      edges = 1u << k;
      return true;
    }
  }
  return false;
}

// A vector in the frame of a face around p, a point inside a face or an edge, in that of the point's face or halfedge.
template <class FT>
Point_in_face<FT> vector_at_point(const Unfolded_mesh<FT>& mesh, const Surface_point<FT>& p, Index face,
                                  const Point_in_face<FT>& v)
{
  if (p.kind == Surface_point<FT>::FACE) return v;
  const Face_frame<FT> frame(mesh, face);
  if (mesh.face(p.element) == face) return frame.vector_to_halfedge(int(p.element % 3), v);
  return FT(-1) * frame.vector_to_halfedge(int(mesh.twin(p.element) % 3), v);
}

// Inverse of vector_at_point().
template <class FT>
Point_in_face<FT> vector_in_face(const Unfolded_mesh<FT>& mesh, const Surface_point<FT>& p, Index face,
                                 const Point_in_face<FT>& v)
{
  if (p.kind == Surface_point<FT>::FACE) return v;
  const Face_frame<FT> frame(mesh, face);
  if (mesh.face(p.element) == face) return frame.vector_from_halfedge(int(p.element % 3), v);
  return FT(-1) * frame.vector_from_halfedge(int(mesh.twin(p.element) % 3), v);
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
