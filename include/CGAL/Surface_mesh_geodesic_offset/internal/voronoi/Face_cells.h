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
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

class Face_cells
{
public:
  typedef Point_in_face<double> Point;

  // `windows`: those that may be nearest in the face; not empty. Distances that differ by less than `tie` are equal.
  Face_cells(const Per_corner<Point>& corner, double tie, std::vector<Voronoi_window>&& windows)
    : m_corner(corner), m_tie(tie), m_windows(std::move(windows))
  {
  }

  // Labels of the sources of a point, given by its barycentric coordinates, that are not farther than the nearest one by more than
  // `within`, the nearest first.
  std::vector<Index> labels(const std::array<double, 3>& weights, double within) const
  {
    Point p{0, 0};
    for (int k = 0; k < 3; ++k) p = p + weights[std::size_t(k)] * m_corner[k];
    std::vector<double> distance;
    for (const Voronoi_window& w : m_windows) distance.push_back(w.rays.path_length(p));
    const double least = *std::min_element(distance.begin(), distance.end());
    const Voronoi_window* nearest = nullptr;
    std::set<Index> others;
    for (std::size_t i = 0; i < distance.size(); ++i)
    {
      if (distance[i] <= least + m_tie && (!nearest || m_windows[i].precedes(*nearest))) nearest = &m_windows[i];
      if (distance[i] <= least + within) others.insert(m_windows[i].label);
    }
    others.erase(nearest->label);
    std::vector<Index> result{nearest->label};
    result.insert(result.end(), others.begin(), others.end());
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
