// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A curve as a polyline with data of its points, for formats that have them.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_CURVE_LINE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_CURVE_LINE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/discretized_curves.h>

#include <CGAL/number_utils.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cstddef>
#include <ostream>
#include <type_traits>
#include <vector>

namespace CGAL::IO::Surface_mesh_geodesic_offset_internal {

struct Line_point
{
  Coordinates point, normal, tangent;
  std::size_t face;    // index of the face
  Coordinates weights; // barycentric coordinates in the order of vertices_around_face(), that in which the face was added
  std::size_t source;
  int side;
};

// The points of a closed curve are all different: the first one is not repeated.
struct Curve_line
{
  std::vector<Line_point> points;
  double distance = 0;
  bool is_closed = false;
  Point_options::Place place{-1, 0};

  std::size_t number_of_indices() const { return points.size() + (is_closed ? 1 : 0); }

  // The i-th point along the line; that of a closed line ends with its first point.
  std::size_t index(std::size_t i) const { return i < points.size() ? i : 0; }

  // The common value of all points, for instance of their sources; -1 if they differ.
  template <class Number>
  long long common(Number Line_point::*value) const
  {
    for (const Line_point& p : points)
      if (p.*value != points.front().*value) return -1;
    return points.empty() ? -1 : static_cast<long long>(points.front().*value);
  }
};

template <class Curve>
Line_point line_point(const Curve& curve, const typename Curve::Oriented_point& p, const Point_options& options)
{
  const auto piece = curve.piece(p.piece);
  const auto& w = p.location.second;
  return {coordinates(p.point),
          coordinates(options.has_smooth_normals ? curve.smooth_normal(p.location) : p.normal),
          coordinates(p.tangent),
          piece.face_index(),
          {CGAL::to_double(w[1]), CGAL::to_double(w[2]), CGAL::to_double(w[0])},
          piece.source(),
          int(piece.side())};
}

// Each segment belongs to one source and one side, unless the points have a spacing: points where these change are points of the
// line.
template <class Curve>
Curve_line curve_line(const Curve& curve, const Point_options& options)
{
  typedef typename Curve::FT FT;
  Curve_line line;
  line.distance = CGAL::to_double(curve.distance());
  if (options.spacing)
  {
    const auto add = [&](const auto& p) { line.points.push_back(line_point(curve, p, options)); };
    curve.points_at_spacing(FT(*options.spacing), boost::make_function_output_iterator(add));
  }
  else
  {
    const auto is_change = [&](std::size_t i) {
      const std::size_t next = i + 1 < curve.number_of_pieces() ? i + 1 : curve.is_closed() ? 0 : i;
      return curve.piece(i).source() != curve.piece(next).source() || curve.piece(i).side() != curve.piece(next).side();
    };
    const Discretized_curve discrete = discretized(curve, options.chord_tolerance, is_change);
    for (std::size_t i = 0; i < discrete.points.size(); ++i)
    {
      const auto p = curve.oriented_point(discrete.pieces[i], FT(discrete.parameters[i]));
      line.points.push_back(line_point(curve, p, options));
      line.points.back().point = discrete.points[i]; // of both pieces that it is between
    }
  }
  line.is_closed = curve.is_closed() && !line.points.empty();
  if (line.is_closed) line.points.pop_back();
  return line;
}

template <class CurveRange>
std::vector<Curve_line> curve_lines(const CurveRange& curves, const Point_options& options)
{
  std::vector<Curve_line> lines;
  for (const auto& curve : curves)
  {
    lines.push_back(curve_line(curve, options));
    if (!options.places.empty()) lines.back().place = options.places[lines.size() - 1];
  }
  return lines;
}

// Writes values of all points of lines, one point per row. value: a number or vector of Line_point
template <class Value>
void write_values(std::ostream& os, const std::vector<Curve_line>& lines, Value Line_point::*value)
{
  for (const Curve_line& line : lines)
    for (const Line_point& p : line.points)
    {
      if constexpr (std::is_same<Value, Coordinates>::value) write_coordinates(os, p.*value);
      else os << p.*value;
      os << '\n';
    }
}

} // namespace CGAL::IO::Surface_mesh_geodesic_offset_internal

#endif
