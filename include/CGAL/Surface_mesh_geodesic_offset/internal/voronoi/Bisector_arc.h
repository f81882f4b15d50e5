// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An arc of a bisector inside one face, between two nodes of the diagram.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_BISECTOR_ARC_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_BISECTOR_ARC_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_conic.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_window.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Merge_error_code.h>

#include <cmath>
#include <utility>

namespace CGAL::Geodesic_offset::internal {

// The paths to the points of an arc on one side of it.
struct Bisector_side
{
  Index label = no_index;  // of the source
  Index window = no_index; // in the face; no_index for a link
  Index pseudo_source = no_index;

  // `number`: of the window in the face.
  template <class NT>
  static Bisector_side of(const Voronoi_window<NT>& w, Index number)
  {
    Bisector_side s;
    s.label = w.label;
    s.window = number;
    const Index v = w.rays.pseudo_source();
    if (!Merge_error_code::is_merged(v)) s.pseudo_source = v;
    return s;
  }
};

template <class NT>
struct Bisector_arc
{
  typedef Point_in_face<NT> Point;

  Index face = no_index;
  Index start_node = no_index, end_node = no_index;
  Bisector_side left, right;
  Point start, end;
  unsigned char start_edge = 3, end_edge = 3; // halfedge of the face that has the point; 3: none
  Bisector_conic<NT> conic;                   // unless is_link
  NT from = 0, to = 0;                        // its parameters at start and end
  NT negligible = 0, smallest_loop = 0;       // lengths of arcs and closed chains that rounding does not tell from a point
  Index edge = no_index;                      // smaller halfedge of the edge on which the whole arc lies
  NT along_edge = 0;                          // length in the direction of this halfedge
  bool is_link = false; // straight between two nodes that rounding does not tell apart, or leaves without an arc

  // A straight arc without windows.
  static Bisector_arc<NT> link(const Point& from, const Point& to, Index left, Index right)
  {
    Bisector_arc<NT> arc;
    arc.start = from;
    arc.end = to;
    arc.left.label = left;
    arc.right.label = right;
    arc.is_link = true;
    return arc;
  }

  // True if the ends and the middle are on a line.
  bool is_on(const Half_plane<NT>& line, NT tolerance) const
  {
    const auto is_near = [&](const Point& p) { return CGAL::abs(line.value(p)) <= tolerance; };
    return is_near(start) && is_near(middle()) && is_near(end);
  }

  bool is_straight() const { return is_link || conic.kind() == Bisector_conic<NT>::SEGMENT; }

  Point middle() const { return at(0.5); }

  // The point between the start (0) and the end (1).
  Point at(NT part) const { return is_link ? start + part * (end - start) : conic.at(conic.between(from, to, part)).point(); }

  NT chord_length() const { return length(middle() - start) + length(end - middle()); }

  // True if rounding does not tell the arc from a point.
  bool is_negligible() const { return length(end - start) <= negligible && length(middle() - start) <= negligible; }

  // True if `a` is the next part of this arc: of the same windows, and with the same parameter of the common end.
  bool continues_in(const Bisector_arc<NT>& a) const
  {
    return !is_link && !a.is_link && face == a.face && left.window == a.left.window && right.window == a.right.window &&
           (from < to) == (a.from < a.to) && length(conic.at(a.from).point() - a.conic.at(a.from).point()) == 0 &&
           length(end - a.start) <= negligible;
  }

  void append(const Bisector_arc<NT>& a)
  {
    end_node = a.end_node;
    end = a.end;
    end_edge = a.end_edge;
    to = a.to;
  }

  void reverse()
  {
    std::swap(start_node, end_node);
    std::swap(left, right);
    std::swap(start, end);
    std::swap(start_edge, end_edge);
    std::swap(from, to);
    along_edge = -along_edge;
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
