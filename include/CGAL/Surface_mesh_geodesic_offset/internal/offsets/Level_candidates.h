// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The windows that matter for a level at a point of a face with many windows: those that may be nearest there, if the distance
// is near the level. The face is divided into a tree of parts, each in the middle of its longest side, until few windows are
// left per part; parts farther from the level than their size are not divided. So the number of parts grows with the number of
// pieces of the level.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_CANDIDATES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_CANDIDATES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Face_window.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Level_candidates
{
public:
  typedef Point_in_face<FT> Point;
  typedef Iterator_range<const Index*> Windows;

  // Call build() after the last window.
  void clear() { m_all.clear(); }
  void push_back(Index window) { m_all.push_back(window); }

  // `window(i)`: the window with index i. `slack`: distances up to this from the level, and from each other, count as equal.
  // With exact numbers the face has one part: its divisions would cost more than they save.
  template <class Window_of_index>
  void build(const Face_frame<FT>& frame, const FT& level, const FT& slack, const Window_of_index& window)
  {
    m_level = level;
    m_slack = slack;
    m_parts.assign(1, Part({frame.corner(0), frame.corner(1), frame.corner(2)}));
    m_of_parts.clear();
    m_waiting = m_all;
    divide(0, 0, most_vain_divisions, window);
  }

  bool is_whole() const { return m_parts.size() == 1; }

  // All windows.
  Windows all() const { return {m_all.data(), m_all.data() + m_all.size()}; }

  // The windows that matter at a point of the face, by index; none if its distance is known to differ from the level.
  Windows at(const Point& p) const { return windows(part_at(p)); }

  // True if the distance of p is known to be less than the level by more than the slack.
  bool is_near(const Point& p) const { return part_at(p).is_near; }

  // Size of the part with p.
  const FT& radius_at(const Point& p) const { return part_at(p).radius; }

  // Calls f(windows) for the parts whose circle meets a set: for which meets(center, radius) is true. The whole face meets all.
  template <class Meets, class Function>
  void for_each_part(const Meets& meets, const Function& f) const
  {
    for_each_part(m_parts.front(), meets, f);
  }

private:
  // Parts with more windows are divided. Fewer are read as fast as the tree.
  static constexpr std::size_t most_windows = 32;
  // Number of divisions in a row of which both halves may keep more than three quarters of the windows. A part much larger than the
  // distance between sources needs some before its halves differ; where the windows do not separate, division ends.
  static constexpr int most_vain_divisions = 16;
  static constexpr double full_part = 0.75;

  struct Part
  {
    Per_corner<Point> corner;   // counterclockwise
    Point center{FT(0), FT(0)}; // of a circle around the part; not set for the whole face
    FT radius = Number_policy<FT>::infinity();
    std::size_t child = 0;           // the first of two; 0 if none
    std::size_t first = 0, last = 0; // windows
    bool is_near = false;            // all distances are less than the level
    bool is_tied = false;            // the windows tie at the center, as those of coincident sources do everywhere

    explicit Part(const Per_corner<Point>& corners) : corner(corners) {}
    void set_circle()
    {
      center = (FT(1) / FT(3)) * (corner[0] + corner[1] + corner[2]);
      radius = (std::max)({length(corner[0] - center), length(corner[1] - center), length(corner[2] - center)});
    }
  };

  // Divides a part, whose windows are the last ones that wait, from index `first`.
  template <class Window_of_index>
  void divide(std::size_t part, std::size_t first, int divisions_left, const Window_of_index& window)
  {
    const std::size_t last = m_waiting.size(), number = last - first;
    if (!Number_policy<FT>::is_inexact || number <= most_windows || divisions_left == 0 || m_parts[part].is_tied ||
        m_parts[part].radius <= m_slack)
    {
      m_parts[part].first = m_of_parts.size();
      m_of_parts.insert(m_of_parts.end(), m_waiting.begin() + std::ptrdiff_t(first), m_waiting.end());
      m_parts[part].last = m_of_parts.size();
      return;
    }
    const Per_corner<Point> c = m_parts[part].corner;
    const auto side = [&](int k) { return length(c[(k + 1) % 3] - c[k]); };
    int k = side(1) > side(0) ? 1 : 0;
    if (side(2) > side(k)) k = 2;
    const Point &p = c[k], &q = c[(k + 1) % 3], &apex = c[(k + 2) % 3], middle = FT(0.5) * (p + q);
    const std::size_t child = m_parts.size();
    m_parts[part].child = child;
    m_parts.push_back(Part({p, middle, apex}));
    m_parts.push_back(Part({middle, q, apex}));
    const auto find = [&](std::size_t i, std::size_t begin) {
      m_parts[i].set_circle();
      add_windows(m_parts[i], first, last, window);
      return m_waiting.size() - begin;
    };
    const std::size_t in_first = find(child, last), in_second = find(child + 1, last + in_first);
    const bool is_full[2] = {double(in_first) > full_part * double(number), double(in_second) > full_part * double(number)};
    if (is_full[0] && is_full[1]) --divisions_left;
    else if (!is_full[0] && !is_full[1]) divisions_left = most_vain_divisions;
    divide(child + 1, last + in_first, divisions_left, window);
    m_waiting.resize(last + in_first);
    divide(child, last, divisions_left, window);
    m_waiting.resize(last);
  }

  // Appends those of the waiting windows from index `first` to `last` that matter in a part. Lengths of paths through a window
  // are 1-Lipschitz, so in the part they differ from those at its center by at most the radius.
  template <class Window_of_index>
  void add_windows(Part& part, std::size_t first, std::size_t last, const Window_of_index& window)
  {
    FT least = Number_policy<FT>::infinity();
    m_lengths.clear();
    for (std::size_t i = first; i < last; ++i)
    {
      const Face_window<FT>& w = window(m_waiting[i]);
      const FT d = w.path_length(part.center);
      least = (std::min)(least, d);
      m_lengths.push_back(!may_pass(w, part)                ? Number_policy<FT>::infinity()
                          : Number_policy<FT>::is_finite(d) ? d
                                                            : length_from_behind(w, part.center));
    }
    part.is_near = least + part.radius < m_level - m_slack;
    if (part.is_near) return;
    const FT most = (std::min)(m_level, FT(least + part.radius)) + part.radius + m_slack;
    part.is_tied = true;
    for (std::size_t i = first; i < last; ++i)
    {
      if (!(m_lengths[i - first] <= most)) continue;
      m_waiting.push_back(m_waiting[i]);
      part.is_tied = part.is_tied && m_lengths[i - first] <= least + m_slack;
    }
  }

  // True if rays of a window may pass a part. Gaps between cones are within the slack, or functions of corners close them.
  bool may_pass(const Face_window<FT>& w, const Part& part) const
  {
    const FT margin = part.radius + m_slack;
    return w.origin == STARTS_AT_CORNER || (w.left_side(part.center) <= margin * length(w.left_ray()) &&
                                            w.right_side(part.center) >= -margin * length(w.right_ray()));
  }

  // Length of a path to a point behind a source segment, where the window has no path.
  static FT length_from_behind(const Face_window<FT>& w, const Point& p)
  {
    if (w.left_side(p) > FT(0)) return w.start_value + length(p - w.left);
    if (w.right_side(p) < FT(0)) return w.start_value + length(p - w.right);
    return FT(2) * w.start_value - w.distance_at(p);
  }

  const Part& part_at(const Point& p) const
  {
    const Part* part = &m_parts.front();
    while (part->child != 0)
    {
      part = &m_parts[part->child];
      const Point &middle = part->corner[1], &apex = part->corner[2];
      if (!(cross(apex - middle, p - middle) > FT(0))) ++part;
    }
    return *part;
  }

  Windows windows(const Part& part) const { return {m_of_parts.data() + part.first, m_of_parts.data() + part.last}; }

  template <class Meets, class Function>
  void for_each_part(const Part& part, const Meets& meets, const Function& f) const
  {
    if (part.child == 0)
    {
      if (part.first != part.last) f(windows(part));
      return;
    }
    for (const std::size_t i : {part.child, part.child + 1})
      if (meets(m_parts[i].center, FT(m_parts[i].radius + m_slack))) for_each_part(m_parts[i], meets, f);
  }

  FT m_level, m_slack;
  std::vector<Index> m_all;
  std::vector<Part> m_parts;
  std::vector<Index> m_of_parts; // windows, per part without children
  std::vector<Index> m_waiting;  // windows of the parts that are divided
  std::vector<FT> m_lengths;     // to the center of a part
};

} // namespace CGAL::Geodesic_offset::internal

#endif
