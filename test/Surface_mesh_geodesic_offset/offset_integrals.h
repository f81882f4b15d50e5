// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Integral checks of offset curves. The gradient of a distance has length 1, so by the coarea formula the area of {a <= D <
// b} is the integral of the lengths of the offsets between a and b, and the derivative of the area of {D < d} is the length
// of the offset at d. Areas come from the curves by Green's theorem.

#ifndef GEODESIC_OFFSET_TEST_OFFSET_INTEGRALS_H
#define GEODESIC_OFFSET_TEST_OFFSET_INTEGRALS_H

#include "level_layout.h"
#include "offset_tools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace test {

/// Offset at one level.
struct Level_measure
{
  double cut = 0;            // distance at which the level is cut
  double length = 0;         // of all curves
  bool fits = true;          // all pieces are joined, and all curves are closed or end on the border
  std::vector<double> areas; // of the near part of each face

  // Numbers that are constant between events: those of curves, of joints inside faces, and of changes of the source along
  // curves.
  std::size_t curves = 0, joints = 0, source_changes = 0;

  bool has_topology_of(const Level_measure& other) const
  {
    return curves == other.curves && joints == other.joints && source_changes == other.source_changes;
  }

  double area() const
  {
    double sum = 0;
    for (const double a : areas) sum += a;
    return sum;
  }
};

/// An area and the corresponding integral of lengths.
struct Coarea
{
  double area = 0, integral = 0;
  double difference() const { return std::abs(area - integral); }
  double relative_difference() const { return difference() / (std::max)(std::abs(area), std::abs(integral)); }
};

/// Measures the offsets of a geodesic object that was built with kept windows. Ignores faces that no source reaches.
class Offset_integrals
{
public:
  typedef CGAL::Geodesic_offset::internal::Index Index;
  typedef Integral_tolerances Tolerances;

  Offset_integrals(const Geodesic& geodesic, const Surface_mesh& mesh)
    : geodesic_(geodesic), surface_(geodesic, mesh), layout_(surface_)
  {
    for (Index f = 0; f < surface_.number_of_faces(); ++f)
    {
      const bool is_reached = surface_.is_used(f) && std::isfinite(surface_.vertex_distance(surface_.origin(3 * f)));
      face_areas_.push_back(is_reached ? surface_.face_at(f).area() : 0);
      total_area_ += face_areas_.back();
    }
    for (std::size_t v = 0; v < surface_.number_of_vertices(); ++v)
    {
      const double d = surface_.vertex_distance(Index(v));
      if (std::isfinite(d)) vertex_distances_.push_back(d);
    }
    std::sort(vertex_distances_.begin(), vertex_distances_.end());
    largest_distance_ = geodesic.largest_distance().value();
    for (const auto h : mesh.halfedges())
      if (!mesh.is_border(h))
        mean_edge_length_ += std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)))) /
                             (3. * double(mesh.number_of_faces()));
  }

  double total_area() const { return total_area_; }
  double largest_distance() const { return largest_distance_; }
  const std::vector<double>& vertex_distances() const { return vertex_distances_; }
  std::size_t number_of_levels() const { return levels_; } // measured so far

  /// Time linear in the size of the mesh and the number of pieces.
  Level_measure measure(double level)
  {
    ++levels_;
    Level_measure result;
    result.cut = cut_of(level);
    const Offset_curves curves = offsets(geodesic_, level);
    layout_.clear();
    result.curves = curves.size();
    for (const Offset_curve& c : curves)
    {
      result.fits = layout_.add(c) && result.fits;
      result.length += c.length();
      count_joints(c, result);
    }
    const auto is_near = [&](Index v) { return surface_.vertex_distance(v) < result.cut; };
    result.areas.resize(face_areas_.size());
    for (Index f = 0; f < face_areas_.size(); ++f)
      result.areas[f] = surface_.is_used(f) && is_near(surface_.origin(3 * f)) ? face_areas_[f] : 0;
    for (const Index f : layout_.crossed_faces()) result.areas[f] = layout_.near_area(surface_.face_at(f), is_near);
    return result;
  }

  /// Compares the area between two levels with the integral of the lengths, by Gauss-Legendre quadrature with `nodes` nodes
  /// (3 or 5). The area nearer than `from` cancels face by face.
  Coarea between(const Level_measure& from, const Level_measure& to, int nodes = 5)
  {
    Coarea result;
    for (std::size_t f = 0; f < from.areas.size(); ++f) result.area += to.areas[f] - from.areas[f];
    static const double x3[] = {0, 0.7745966692414834, -0.7745966692414834};
    static const double w3[] = {8. / 9, 5. / 9, 5. / 9};
    static const double x5[] = {0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640, -0.9061798459386640};
    static const double w5[] = {0.5688888888888889, 0.4786286704993665, 0.4786286704993665, 0.2369268850561891,
                                0.2369268850561891};
    const double *x = nodes == 3 ? x3 : x5, *w = nodes == 3 ? w3 : w5;
    const double middle = (from.cut + to.cut) / 2, half = (to.cut - from.cut) / 2;
    for (int i = 0; i < nodes; ++i)
    {
      const Level_measure at = measure(level_cut_at(middle + half * x[i]));
      smooth_ = (i == 0 || smooth_) && at.has_topology_of(from) && at.has_topology_of(to);
      result.integral += half * w[i] * at.length;
    }
    return result;
  }

  /// Derivative and length at a distance, both over a window around it that is narrow enough for constant topology and a
  /// smooth length. Returns false if no such window is wider than rounding.
  bool derivative_at(double distance, Coarea& result)
  {
    const auto vertex = std::lower_bound(vertex_distances_.begin(), vertex_distances_.end(), distance);
    double half = Tolerances::shrink * (std::min)(distance, largest_distance_ - distance);
    if (vertex != vertex_distances_.end()) half = (std::min)(half, Tolerances::part_to_vertex * (*vertex - distance));
    if (vertex != vertex_distances_.begin()) half = (std::min)(half, Tolerances::part_to_vertex * (distance - *(vertex - 1)));
    for (; half > Tolerances::narrowest_window * surface_.diagonal(); half *= Tolerances::shrink)
    {
      const Level_measure from = measure(level_cut_at(distance - half)), to = measure(level_cut_at(distance + half));
      if (!from.has_topology_of(to)) continue;
      result = between(from, to, 5);
      if (!smooth_) continue;
      // two events may leave the numbers unchanged, but not the lengths smooth: then Simpson's rule differs
      const double simpson = half / 3 * (from.length + 4 * measure(level_cut_at(distance)).length + to.length);
      if (std::abs(simpson - result.integral) <= Tolerances::smooth * result.integral) return true;
    }
    return false;
  }

  /// Sum over all levels. Intervals of levels are halved until both sides agree within rounding plus `tolerance` times the
  /// interval's share of the area, or until they are shorter than `shortest_interval`, as at jumps of the length.
  /// `left_over`: sum of all differences.
  Coarea over_all_levels(double tolerance, double& left_over)
  {
    Coarea sum;
    left_over = 0;
    std::vector<double> ends = {Tolerances::shortest_interval * largest_distance_};
    // not at vertices, where a curve may be left out, so the side of the vertex may not agree with its distance
    const double beside = Tolerances::beside_vertex * (largest_distance_ + mean_edge_length_);
    for (const double d : vertex_distances_)
    {
      if (d - beside > ends.back()) ends.push_back(d - beside);
      else if (ends.size() > 1) ends.pop_back();
      if (d + beside > ends.back()) ends.push_back(d + beside);
    }
    while (ends.size() > 1 && ends.back() > largest_distance_) ends.pop_back();
    ends.push_back(largest_distance_ * (1 + Tolerances::above_largest));
    Level_measure from = measure(level_cut_at(ends[0]));
    sum.area = from.area();
    sum.integral = from.length * from.cut / 2; // the length grows from 0 or is constant: below the tolerance
    for (std::size_t i = 1; i < ends.size(); ++i)
    {
      Level_measure to = measure(level_cut_at(ends[i]));
      add_interval(from, to, tolerance, sum, left_over);
      from = std::move(to);
    }
    return sum;
  }

private:
  static void count_joints(const Offset_curve& curve, Level_measure& result)
  {
    const std::size_t n = curve.number_of_pieces();
    for (std::size_t i = 0; i + (curve.is_closed() ? 0 : 1) < n; ++i)
    {
      const Offset_piece a = curve.piece(i), b = curve.piece((i + 1) % n);
      result.joints += a.face() == b.face() ? 1 : 0;
      result.source_changes +=
        a.source() != b.source() || a.source_part() != b.source_part() || a.pseudo_source() != b.pseudo_source() ? 1 : 0;
    }
  }

  void add_interval(const Level_measure& from, const Level_measure& to, double tolerance, Coarea& sum, double& left_over)
  {
    const Coarea here = between(from, to, 3);
    const double share = (to.cut - from.cut) / largest_distance_;
    const double allowed = (tolerance * share + Tolerances::area_error) * total_area_;
    if (here.difference() > allowed && share > Tolerances::shortest_interval)
    {
      const Level_measure middle = measure(level_cut_at((from.cut + to.cut) / 2));
      add_interval(from, middle, tolerance, sum, left_over);
      return add_interval(middle, to, tolerance, sum, left_over);
    }
    sum.area += here.area;
    sum.integral += here.integral;
    left_over += here.difference();
  }

  const Geodesic& geodesic_;
  Judged_surface surface_;
  Level_layout layout_;
  std::vector<double> face_areas_, vertex_distances_;
  double total_area_ = 0, largest_distance_ = 0, mean_edge_length_ = 0;
  std::size_t levels_ = 0;
  bool smooth_ = false;
};

/// Length of an offset, and of its parts: left, right, and beyond the ends of polylines.
struct Lengths_by_side
{
  // beyond: round ends, and sources without sides.
  double whole = 0, left = 0, right = 0, beyond = 0;

  double relative_difference() const { return std::abs(whole - (left + right + beyond)) / whole; }
};

/// The library cuts the sides separately; curves without side are those that both sides with round ends have in common.
inline Lengths_by_side lengths_by_side(const Geodesic& geodesic, double level)
{
  using CGAL::Offset_end;
  using CGAL::Offset_side;
  Lengths_by_side result;
  const auto length = [&](Offset_side side, Offset_end end) {
    return total_length(offsets(geodesic, level, Offset_selection(side, end)));
  };
  result.whole = length(Offset_side::BOTH, Offset_end::ROUND);
  result.left = length(Offset_side::LEFT, Offset_end::BUTT);
  result.right = length(Offset_side::RIGHT, Offset_end::BUTT);
  result.beyond = length(Offset_side::LEFT, Offset_end::ROUND) - result.left;
  return result;
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_OFFSET_INTEGRALS_H
