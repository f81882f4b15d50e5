// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A curve as a polyline with data of its points, for formats that have them.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_CURVE_LINE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_CURVE_LINE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/discretized_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Element_division.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::IO::Surface_mesh_geodesic_offset_internal {

// The points of a closed curve are all different: the first one is not repeated.
struct Curve_line
{
  std::vector<Coordinates> points;
  std::vector<Coordinates> normals; // outer unit normals of the faces of the points
  std::vector<std::size_t> sources;
  std::vector<int> sides;
  double distance = 0;
  bool is_closed = false;

  std::size_t number_of_indices() const { return points.size() + (is_closed ? 1 : 0); }

  // The i-th point along the line; that of a closed line ends with its first point.
  std::size_t index(std::size_t i) const { return i < points.size() ? i : 0; }
};

// Each segment belongs to one source and one side: points where these change are points of the line.
template <class Curve, class FT>
Curve_line curve_line(const Curve& curve, const FT& chord_tolerance)
{
  Curve_line line;
  const auto is_change = [&](std::size_t i) {
    const std::size_t next = i + 1 < curve.number_of_pieces() ? i + 1 : curve.is_closed() ? 0 : i;
    return curve.piece(i).source() != curve.piece(next).source() || curve.piece(i).side() != curve.piece(next).side();
  };
  Discretized_curve discrete = discretized(curve, chord_tolerance, is_change);
  line.points = std::move(discrete.points);
  line.is_closed = curve.is_closed() && !line.points.empty();
  if (line.is_closed) line.points.pop_back();
  for (std::size_t i = 0; i < line.points.size(); ++i)
  {
    const typename Curve::Piece piece = curve.piece(discrete.pieces[i]);
    line.normals.push_back(coordinates(Geodesic_offset::internal::Face_in_space(curve, piece).normal));
    line.sources.push_back(piece.source());
    line.sides.push_back(int(piece.side()));
  }
  line.distance = CGAL::to_double(curve.distance());
  return line;
}

template <class CurveRange, class FT>
std::vector<Curve_line> curve_lines(const CurveRange& curves, const FT& chord_tolerance)
{
  std::vector<Curve_line> lines;
  for (const auto& curve : curves) lines.push_back(curve_line(curve, chord_tolerance));
  return lines;
}

// The common value of all points; -1 if they differ.
template <class Number>
long long common_value(const std::vector<Number>& values)
{
  for (const Number& x : values)
    if (x != values.front()) return -1;
  return values.empty() ? -1 : static_cast<long long>(values.front());
}

} // namespace CGAL::IO::Surface_mesh_geodesic_offset_internal

#endif
