// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The curves of a file, put on the surface.

#ifndef VALIDATE_GEODESIC_OFFSETS_CURVES_ON_SURFACE_H
#define VALIDATE_GEODESIC_OFFSETS_CURVES_ON_SURFACE_H

#include "common/common.h"
#include "common/polyline_file.h"
#include "common/sources.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace geodesic_offset {

class Curves_on_surface
{
  const Geodesic_mesh& m_geodesic;
  std::vector<Surface_polyline> m_curves;
  std::vector<std::size_t> m_lines; // of the file
  std::size_t m_points = 0;
  double m_moved = 0;
  std::string m_farthest;

public:
  Curves_on_surface(const Geodesic_mesh& geodesic, const std::string& file) : m_geodesic(geodesic)
  {
    for(const File_polyline& polyline : read_polylines(file, true))
      add(polyline, quoted(file) + ", line " + std::to_string(polyline.line));
  }

  const std::vector<Surface_polyline>& curves() const { return m_curves; }
  std::size_t line(std::size_t curve) const { return m_lines[curve]; }
  std::size_t number_of_points() const { return m_points; }

  // The largest distance of a point from the surface, and the point
  double moved() const { return m_moved; }
  const std::string& farthest_point() const { return m_farthest; }

private:
  void add(const File_polyline& from, const std::string& name)
  {
    std::vector<Point> points = from.points;
    const bool closed = points.size() > 3 && points.front() == points.back();
    if(closed) points.pop_back();
    m_points += points.size();
    std::vector<Face_location> locations;
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      // squares of lengths must stay within the range of double
      if(!std::isfinite((points[i] - CGAL::ORIGIN).squared_length()))
        throw Input_error(name + ": point " + std::to_string(i) + " is too far away from the surface");
      const std::pair<Face_location, double> located = m_geodesic.locate_with_distance(points[i]);
      locations.push_back(located.first);
      if(located.second > m_moved)
      {
        m_moved = located.second;
        m_farthest = name + ": point " + std::to_string(i);
      }
    }
    try
    {
      m_curves.push_back(m_geodesic.join_polyline(locations, CGAL::parameters::is_closed(closed)));
    }
    catch(const std::invalid_argument&)
    {
      throw Input_error(name + ": two consecutive points are in different parts of the surface");
    }
    m_lines.push_back(from.line);
  }
};

} // namespace geodesic_offset

#endif // VALIDATE_GEODESIC_OFFSETS_CURVES_ON_SURFACE_H
