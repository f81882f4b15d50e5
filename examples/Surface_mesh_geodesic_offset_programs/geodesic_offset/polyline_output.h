// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Polylines as .polylines.txt and .vtk files. A polyline is an object with a member `points`.

#ifndef GEODESIC_OFFSET_POLYLINE_OUTPUT_H
#define GEODESIC_OFFSET_POLYLINE_OUTPUT_H

#include "common/common.h"
#include "common/sources.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <ostream>
#include <utility>
#include <vector>

namespace geodesic_offset {

template <class Polyline>
void write_polylines(std::ostream& out, const std::vector<Polyline>& polylines)
{
  for(const Polyline& polyline : polylines)
  {
    out << polyline.points.size();
    for(const Point& p : polyline.points) out << ' ' << p;
    out << '\n';
  }
}

inline void write_sources(std::ostream& out, const Sources& sources)
{
  struct Polyline
  {
    std::vector<Point> points;
  };
  out.precision(std::numeric_limits<double>::max_digits10);
  std::vector<Polyline> polylines;
  for(std::vector<Point>& points : sources.polylines()) polylines.push_back({std::move(points)});
  write_polylines(out, polylines);
}

// The cell data may follow. A closed polyline, which ends with its first point, has this point once. A polyline of one point is a
// line of no length: VTK has no lines of one point.
template <class Polyline>
void write_vtk_lines(std::ostream& out, const char* title, const std::vector<Polyline>& polylines)
{
  const auto number_of_points = [](const Polyline& polyline) {
    const std::vector<Point>& points = polyline.points;
    return points.size() - (points.size() > 1 && points.front() == points.back() ? 1 : 0);
  };
  const auto number_of_indices = [](const Polyline& polyline) { return std::max(polyline.points.size(), std::size_t(2)); };
  std::size_t points = 0, indices = 0;
  for(const Polyline& polyline : polylines)
  {
    points += number_of_points(polyline);
    indices += number_of_indices(polyline);
  }
  out << "# vtk DataFile Version 3.0\n" << title << "\nASCII\nDATASET POLYDATA\nPOINTS " << points << " double\n";
  for(const Polyline& polyline : polylines)
    for(std::size_t i = 0; i < number_of_points(polyline); ++i) out << polyline.points[i] << '\n';
  if(polylines.empty()) return;
  out << "LINES " << polylines.size() << ' ' << polylines.size() + indices << '\n';
  std::size_t first = 0;
  for(const Polyline& polyline : polylines)
  {
    const std::size_t n = number_of_points(polyline);
    out << number_of_indices(polyline);
    for(std::size_t i = 0; i < number_of_indices(polyline); ++i) out << ' ' << first + i % n;
    out << '\n';
    first += n;
  }
}

// An array of a FIELD of cell data.
template <class Polyline, class Value>
void write_vtk_integers(std::ostream& out, const char* name, const std::vector<Polyline>& polylines, const Value& value)
{
  out << name << " 1 " << polylines.size() << " int\n";
  for(const Polyline& polyline : polylines) out << value(polyline) << '\n';
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_POLYLINE_OUTPUT_H
