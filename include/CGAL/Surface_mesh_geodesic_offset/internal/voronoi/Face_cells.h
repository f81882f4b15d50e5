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
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class NT>
class Face_cells
{
public:
  typedef Point_in_face<NT> Point;

  bool is_crossed = true; // by a curve

  // `windows`: those that may be nearest in the face; not empty. Distances that differ by less than `tie` are equal.
  Face_cells(const Per_corner<Point>& corner, NT tie, std::vector<Voronoi_window<NT>>&& windows)
    : m_corner(corner), m_tie(tie), m_windows(std::move(windows))
  {
  }

  // Labels of the sources of a point, given by its barycentric coordinates, that are not farther than the nearest one by more than
  // `within`, the nearest first.
  std::vector<Index> labels(const std::array<NT, 3>& weights, NT within) const
  {
    const Point p = at(weights);
    std::vector<NT> distance;
    for (const Voronoi_window<NT>& w : m_windows) distance.push_back(w.rays.path_length(p));
    const NT least = *std::min_element(distance.begin(), distance.end());
    const Voronoi_window<NT>* nearest = nullptr;
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

  Index label_of_center() const { return labels({1. / 3, 1. / 3, 1. / 3}, 0).front(); }

  // The label of a face that no curve crosses: the source whose largest excess over the nearest one, at points in the middle
  // and towards the corners, is smallest. One point does not suffice: several sources may tie there, or a loop that is too
  // small to be kept may surround it.
  Index label_without_curves() const
  {
    std::map<Index, NT> excess;
    for (const Voronoi_window<NT>& w : m_windows) excess[w.label] = 0;
    for (const std::array<NT, 3>& weights :
         {std::array<NT, 3>{0.37, 0.32, 0.31}, {0.9, 0.06, 0.04}, {0.04, 0.9, 0.06}, {0.06, 0.04, 0.9}})
    {
      std::map<Index, NT> distance;
      NT least = std::numeric_limits<NT>::infinity();
      for (const Voronoi_window<NT>& w : m_windows)
      {
        const NT d = w.rays.path_length(at(weights));
        NT& own = distance.emplace(w.label, d).first->second;
        own = (std::min)(own, d);
        least = (std::min)(least, d);
      }
      for (auto& [label, most] : excess) most = (std::max)(most, distance[label] - least);
    }
    const auto best =
      std::min_element(excess.begin(), excess.end(), [&](const auto& a, const auto& b) { return a.second < b.second - m_tie; });
    return best->first;
  }

  // By how much source `a` is nearer than source `b`, at most, at a corner.
  NT largest_lead(Index a, Index b) const
  {
    NT result = 0;
    for (const Point& corner : m_corner)
    {
      NT of_a = std::numeric_limits<NT>::infinity(), of_b = of_a;
      for (const Voronoi_window<NT>& w : m_windows)
        for (auto [label, least] : {std::make_pair(a, &of_a), std::make_pair(b, &of_b)})
          if (w.label == label) *least = (std::min)(*least, w.rays.path_length(corner));
      if (of_a < of_b) result = (std::max)(result, of_b - of_a);
    }
    return result;
  }

private:
  Point at(const std::array<NT, 3>& weights) const
  {
    return weights[0] * m_corner[0] + weights[1] * m_corner[1] + weights[2] * m_corner[2];
  }

  Per_corner<Point> m_corner;
  NT m_tie;
  std::vector<Voronoi_window<NT>> m_windows;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
