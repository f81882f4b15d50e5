// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cells of a Voronoi diagram in a face that bisectors cross: the nearest sources of its points.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_FACE_CELLS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_FACE_CELLS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_window.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

class Face_cells
{
public:
  typedef Point_in_face<double> Point;

  // `windows`: those that may be nearest in the face. Distances that differ by less than `tie` are equal.
  Face_cells(const Per_corner<Point>& corner, double tie, std::vector<Voronoi_window>&& windows)
    : m_corner(corner), m_tie(tie), m_windows(std::move(windows))
  {
  }

  // Labels of the sources of a point, given by its barycentric coordinates, that are not farther than the nearest one by more than
  // `within`, the nearest first: of those that tie, the smallest.
  std::vector<Index> labels(const std::array<double, 3>& weights, double within) const
  {
    Point p{0, 0};
    for (int k = 0; k < 3; ++k) p = p + weights[std::size_t(k)] * m_corner[k];
    std::map<Index, double> distance;
    double least = std::numeric_limits<double>::infinity();
    for (const Voronoi_window& w : m_windows)
    {
      const double d = w.rays.path_length(p);
      const auto known = distance.emplace(w.label, d).first;
      known->second = (std::min)(known->second, d);
      least = (std::min)(least, d);
    }
    std::vector<Index> result;
    for (const auto& entry : distance)
      if (entry.second <= least + (std::max)(within, m_tie)) result.push_back(entry.first);
    const auto nearest = std::find_if(result.begin(), result.end(), [&](Index l) { return distance[l] <= least + m_tie; });
    if (nearest != result.end()) std::rotate(result.begin(), nearest, nearest + 1);
    return result;
  }

private:
  Per_corner<Point> m_corner;
  double m_tie;
  std::vector<Voronoi_window> m_windows;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
