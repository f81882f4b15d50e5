// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Area of the near part { D < d } of a face, computed from the curves and from the field.
//
// From the curves, by Green's theorem: the boundary of the near part consists of the pieces and, from each exit of a curve
// counterclockwise to the next entry, parts of the boundary of the face. From the field, by bounds: D is 1-Lipschitz in a
// face (it changes by at most l along a path of length l), so a triangle whose points are all within r of a point c is near
// if D(c) + r < d and far if D(c) - r >= d; otherwise its longest edge is bisected. The area of undecided triangles is the
// difference of the bounds.

#ifndef GEODESIC_OFFSET_TEST_VALIDATION_AREA_VALIDATION_H
#define GEODESIC_OFFSET_TEST_VALIDATION_AREA_VALIDATION_H

#include "Validation_level.h"
#include "Validation_report.h"

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class Geodesic>
class Area_validation
{
public:
  typedef Validation_surface<Geodesic> Surface;
  typedef Validation_face::Point Point;
  typedef std::unordered_map<Index, double> Areas; // by face

  Area_validation(const Surface& surface, const Validation_options& options, Validation_report& report)
    : m_surface(surface), m_options(options), m_report(report)
  {
  }

  // Near areas of `faces`, which must include all faces that the level may pass through. Time linear in faces and pieces.
  Areas from_curves(const Validation_level& level, const std::vector<Index>& faces) const
  {
    Areas areas;
    for (const Index f : faces)
    {
      const Validation_face face = m_surface.face_at(f);
      double area = 0;
      if (!m_report.check(AREA, twice_area(level, face, area),
                          [&] { return "curves do not enter and leave by turns face " + std::to_string(f); }))
        continue;
      area /= 2;
      m_report.check(AREA, area >= -tolerance(face) && area <= face.area() + tolerance(face), [&] {
        return "the near part is " + validation_text(area / face.area()) + " of face " + std::to_string(f);
      });
      areas[f] = area;
    }
    return areas;
  }

  // Compares some areas with bounds from the field: at most 2^(depth + 1) queries per face, typically a small multiple of
  // 2^(depth / 2).
  void check_against_field(const Validation_level& level, const Areas& areas, std::vector<Index> faces,
                           std::mt19937& random) const
  {
    for (std::size_t i = 0; i < m_options.quadrature_faces && i < faces.size(); ++i)
    {
      const std::size_t j = i + std::size_t(validation_random(random) * double(faces.size() - i));
      std::swap(faces[i], faces[j]);
      const auto found = areas.find(faces[i]);
      if (found == areas.end()) continue;
      const Validation_face face = m_surface.face_at(faces[i]);
      double low = 0, high = 0;
      add_bounds(face, face.corner, level.cut, m_options.quadrature_depth, low, high);
      const double share = (high - low) / face.area();
      ++m_report.areas;
      m_report.undecided_share += share;
      m_report.worst_undecided_share = (std::max)(m_report.worst_undecided_share, share);
      m_report.check(AREA, found->second >= low - tolerance(face) && found->second <= high + tolerance(face), [&] {
        return "the near part of face " + std::to_string(faces[i]) + " is " + validation_text(found->second / face.area()) +
               " by the curves, " + validation_text(low / face.area()) + " to " + validation_text(high / face.area()) +
               " by the field";
      });
    }
  }

  // Checks that the near part of a face does not shrink from a level to the next one.
  void check_growth(const Validation_level& smaller, const Areas& areas_of_smaller, const Validation_level& larger,
                    const Areas& areas_of_larger) const
  {
    const auto check = [&](Index f, double before, double after) {
      const Validation_face face = m_surface.face_at(f);
      m_report.check(NESTING, before <= after + 2 * tolerance(face), [&] {
        return "the near part of face " + std::to_string(f) + " shrinks from " + validation_text(before / face.area()) +
               " to " + validation_text(after / face.area());
      });
    };
    for (const auto& a : areas_of_smaller)
    {
      const auto b = areas_of_larger.find(a.first);
      check(a.first, a.second, b != areas_of_larger.end() ? b->second : uncrossed_area(larger, a.first));
    }
    for (const auto& b : areas_of_larger)
      if (areas_of_smaller.count(b.first) == 0) check(b.first, uncrossed_area(smaller, b.first), b.second);
  }

private:
  // Upper bound of the distance of points of curves from their level.
  double tolerance(const Validation_face& face) const
  {
    return m_options.level_tolerance * m_surface.diagonal() * (face.edge_length(0) + face.edge_length(1) + face.edge_length(2));
  }

  // Returns false if entries and exits do not alternate.
  bool twice_area(const Validation_level& level, const Validation_face& face, double& area) const
  {
    const Point o = (1. / 3) * (face.corner[0] + (face.corner[1] + face.corner[2]));
    area = 0;
    const auto pieces = level.pieces_in(face.face);
    for (auto p = pieces.first; p != pieces.second; ++p) area += p->twice_area_from(o);
    const auto gates = level.gates_of(face.face);
    if (gates.first == gates.second)
    {
      if (boundary_is_near(level, face.face)) area += 2 * face.area();
      return true;
    }
    for (auto g = gates.first; g != gates.second; ++g)
    {
      const auto next = g + 1 == gates.second ? gates.first : g + 1;
      if (g->is_start == next->is_start) return false;
      if (!g->is_start) area += twice_area_along_boundary(face, *g, *next, o);
    }
    return true;
  }

  static double twice_area_along_boundary(const Validation_face& face, const Validation_gate& from, const Validation_gate& to,
                                          const Point& o)
  {
    double area = 0;
    int k = int(from.halfedge % 3);
    Point p = face.on_edge(k, from.t);
    bool at_end = from.halfedge == to.halfedge && from.t <= to.t;
    while (!at_end)
    {
      k = (k + 1) % 3;
      area += cross(p - o, face.corner[k] - o);
      p = face.corner[k];
      at_end = k == int(to.halfedge % 3);
    }
    return area + cross(p - o, face.on_edge(k, to.t) - o);
  }

  // Whether the boundary of a face without gates is near: all corners that are not too close to the level are on one side.
  bool boundary_is_near(const Validation_level& level, Index f) const
  {
    Index best = m_surface.origin(3 * f);
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      if (std::abs(m_surface.vertex_distance(m_surface.origin(h)) - level.cut) >
          std::abs(m_surface.vertex_distance(best) - level.cut))
        best = m_surface.origin(h);
    return level.is_near[best] == 1;
  }

  double uncrossed_area(const Validation_level& level, Index f) const
  {
    return boundary_is_near(level, f) ? m_surface.face_at(f).area() : 0;
  }

  void add_bounds(const Validation_face& face, const Per_corner<Point>& corner, double cut, std::size_t depth, double& low,
                  double& high) const
  {
    const Point middle = (1. / 3) * (corner[0] + (corner[1] + corner[2]));
    const double radius = (std::max)({length(corner[0] - middle), length(corner[1] - middle), length(corner[2] - middle)});
    const double area = cross(corner[1] - corner[0], corner[2] - corner[0]) / 2;
    const double d = m_surface.distance_at(face, middle);
    if (d - radius >= cut) return;
    const bool is_near = d + radius < cut;
    if (is_near || depth == 0)
    {
      high += area;
      if (is_near) low += area;
      return;
    }
    int k = 0; // the longest edge
    double longest = 0;
    for (int i = 0; i < 3; ++i)
    {
      const double l = length(corner[(i + 1) % 3] - corner[i]);
      if (!(l > longest)) continue;
      longest = l;
      k = i;
    }
    const Point &a = corner[k], &b = corner[(k + 1) % 3], &c = corner[(k + 2) % 3];
    const Point half = 0.5 * (a + b);
    add_bounds(face, {{a, half, c}}, cut, depth - 1, low, high);
    add_bounds(face, {{half, b, c}}, cut, depth - 1, low, high);
  }

  const Surface& m_surface;
  const Validation_options& m_options;
  Validation_report& m_report;
};

} // namespace CGAL::Geodesic_offset::internal

#endif // GEODESIC_OFFSET_TEST_VALIDATION_AREA_VALIDATION_H
