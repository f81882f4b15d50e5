// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Classified point of the surface: at a vertex, inside an edge, or inside a face.

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
#include <variant>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
struct Surface_point
{
  enum Kind : unsigned char { VERTEX, EDGE, FACE };

  Kind kind = FACE;
  bool is_any_copy = false; // VERTEX: on a barrier, the nearest of all its copies
  Index element = no_index; // vertex, halfedge or face
  FT x = FT(0), y = FT(0);  // EDGE: x along the halfedge; FACE: in the face frame

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

// Point of a face in the frame of halfedge h, from its barycentric coordinates at the target of h and at the apex.
template <class FT>
inline Point_in_face<FT> position_in_frame(const Unfolded_mesh<FT>& mesh, Index h, const FT& target, const FT& apex)
{
  return {target * mesh[h].length + apex * mesh[h].apex_x, apex * mesh[h].apex_y};
}

// Surface point with the user's barycentric coordinates if it is inside a face. Each halfedge frame is computed from these,
// without the rounding error of another frame.
template <class FT>
struct Located_point : Surface_point<FT>
{
  std::array<FT, 3> weights; // FACE

  Located_point(const Surface_point<FT>& p) : Surface_point<FT>(p) {}
  Located_point(const Surface_point<FT>& p, const std::array<FT, 3>& w) : Surface_point<FT>(p), weights(w) {}
};

// Intersection of a path with an edge, as a parameter from the source of the halfedge to its target, or a vertex on the
// path.
template <class FT>
struct Path_crossing
{
  Index halfedge; // no_index: at the vertex `source`
  Index source, target;
  FT part;
};

// An element that a path meets: a crossing of an edge, or a vertex or the point at the end.
template <class FT>
using Path_element = std::variant<Path_crossing<FT>, Surface_point<FT>>;

// Barycentric coordinates below this fraction of the largest one are rounding errors of zero: the point is on the edge or
// at the vertex.
inline double snapping_tolerance() { return 1e-13; }

// Snaps to a vertex or an edge if possible. w: barycentric coordinates with sum 1.
template <class FT>
Located_point<FT> classify_on_boundary(const Unfolded_mesh<FT>& mesh, Index face, std::size_t name, bool valid,
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
    else other = k;
  }
  if (!valid)
    throw std::invalid_argument("Surface_mesh_geodesic_offset: a location in face " + std::to_string(name) +
                                " does not lie in the face");
  if (zeros == 2) return Surface_point<FT>::at_vertex(mesh.source(3 * face + Index(other)));
  // Halfedge k is opposite to corner `zero`. The point must be projected: on a needle, a coordinate of the order of
  // rounding corresponds to a long distance along the halfedge.
  const int k = (zero + 1) % 3;
  const Index h = 3 * face + Index(k);
  const FT length = mesh[h].length, t = position_in_frame(mesh, h, w[(k + 1) % 3], w[zero]).x;
  if (t <= eps * length) return Surface_point<FT>::at_vertex(mesh.source(h));
  if (length - t <= eps * length) return Surface_point<FT>::at_vertex(mesh.target(h));
  return Surface_point<FT>::on_edge(h, t);
}

// name: the index of the face for messages.
template <class FT>
BOOST_FORCEINLINE Located_point<FT> classify(const Unfolded_mesh<FT>& mesh, Index face, std::size_t name, std::array<FT, 3> w)
{
  const FT sum = w[0] + w[1] + w[2];
  const FT eps = Number_policy<FT>::is_inexact ? FT(snapping_tolerance()) : FT(0);
  const bool valid = face < mesh.number_of_faces() && mesh.source(3 * face) != no_index && CGAL::is_positive(sum);
  if (valid)
    for (FT& x : w) x /= sum;
  if (!(valid && w[0] > eps && w[1] > eps && w[2] > eps)) // with sum 1, also none exceeds 1
    return classify_on_boundary(mesh, face, name, valid && Number_policy<FT>::is_finite(sum), w, eps);
  return {Surface_point<FT>::in_face(face, position_in_frame(mesh, 3 * face, w[1], w[2])), w};
}

// Calls f with the point on each side of a barrier: on both sides of an edge, in each sector at a vertex; once for other points.
template <class FT, class Function>
void for_each_side(const Unfolded_mesh<FT>& mesh, const Surface_point<FT>& p, const Function& f)
{
  if (p.kind == Surface_point<FT>::VERTEX) return mesh.for_each_copy(p.element, [&](Index v) { f(p.at_vertex(v)); });
  f(p);
  const Index h = p.kind == Surface_point<FT>::EDGE ? mesh.across_barrier(p.element) : no_index;
  if (h != no_index) f(p.on_edge(h, mesh[h].length - p.x));
}

// Faces incident to a surface point.
template <class FT>
std::vector<Index> faces_of(const Unfolded_mesh<FT>& mesh, const Surface_point<FT>& p)
{
  std::vector<Index> result;
  if (p.kind == Surface_point<FT>::FACE) result.push_back(p.element);
  else if (p.kind == Surface_point<FT>::EDGE)
  {
    result.push_back(mesh.face(p.element));
    if (mesh.twin(p.element) != no_index) result.push_back(mesh.face(mesh.twin(p.element)));
  }
  else
    mesh.for_each_fan(p.element, [&](Index first) {
      Index c = first;
      do {
        result.push_back(mesh.face(c));
        c = mesh.corner_ccw(c);
      } while (c != no_index && c != first);
    });
  return result;
}

// Number of the halfedge of a bit in `edges` below.
inline int edge_of_bit(unsigned bit)
{
  CGAL_precondition(bit == 1 || bit == 2 || bit == 4);
  return bit == 1 ? 0 : bit == 2 ? 1 : 2;
}

// Computes the position of p in the face frame. Returns false if p does not lie in this closed face. `edges` receives one
// bit per halfedge of the face that contains p.
template <class FT>
bool position_in_face(const Unfolded_mesh<FT>& mesh, const Surface_point<FT>& p, Index face, Point_in_face<FT>& position,
                      unsigned& edges)
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

// A face that contains both points, and their positions in it; no_index if there is none. One where both points lie on the same edge is
// preferred, whose bit `edge` receives, or 0.
template <class FT>
Index face_of_both(const Unfolded_mesh<FT>& mesh, const Surface_point<FT>& p, const Surface_point<FT>& q,
                   Point_in_face<FT>& at_p, Point_in_face<FT>& at_q, unsigned& edge)
{
  Index found = no_index;
  for (Index f : faces_of(mesh, p))
  {
    Point_in_face<FT> a, b;
    unsigned ea, eb;
    if (!position_in_face(mesh, q, f, b, eb) || !position_in_face(mesh, p, f, a, ea)) continue;
    if (found == no_index || (ea & eb))
    {
      found = f;
      at_p = a;
      at_q = b;
      edge = ea & eb;
    }
    if (edge) break;
  }
  return found;
}

// Points of a face no farther apart than this are one point. Positions in a face have two products, and those of points on edges
// the rounding of the edge: 8 units of rounding of the edges of the face.
template <class FT>
FT size_of_point(const Unfolded_mesh<FT>& mesh, Index face)
{
  const Index h = 3 * face;
  return Number_policy<FT>::rounding(8) * (mesh[h].length + mesh[h + 1].length + mesh[h + 2].length);
}

// True if two points are inside the same face, inside the same edge, or at the same vertex.
template <class FT>
bool are_of_one_element(const Unfolded_mesh<FT>& mesh, const Surface_point<FT>& p, const Surface_point<FT>& q)
{
  if (p.kind != q.kind) return false;
  return p.element == q.element || (p.kind == Surface_point<FT>::EDGE && mesh.twin(p.element) == q.element);
}

// Transforms a vector from the face frame to the frame of p's face or halfedge. Precondition: p is inside a face or an
// edge.
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

} // namespace CGAL::Geodesic_offset::internal

#endif
