// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offset curves in the planes of the patches of a generated mesh, and locations of points of a patch.

#ifndef GEODESIC_OFFSET_TEST_UNFOLDED_CURVES_H
#define GEODESIC_OFFSET_TEST_UNFOLDED_CURVES_H

#include "flat_paths.h"
#include "planar_pieces.h"
#include "test_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace test {

/// As documented for `offset_curves()`: levels are cut below themselves by a fraction of 2^-42.
inline double cut_level(double level) { return level - std::ldexp(level, -42); }

template <class TriangleMesh>
class Unfolding_of_patches
{
public:
  typedef Generated_mesh<TriangleMesh> Mesh_data;
  typedef typename Mesh_data::face_descriptor face_descriptor;
  typedef typename Mesh_data::Face_location Face_location;

  explicit Unfolding_of_patches(const Mesh_data& data) : data_(data) {}

  std::size_t patch_of(face_descriptor f) const { return data_.patches[data_.face_number(f)]; }

  Point_2 uv(const Face_location& location) const
  {
    const auto& c = data_.uv[data_.face_number(location.first)];
    const auto& w = location.second;
    return Point_2(w[0] * c[0].x() + w[1] * c[1].x() + w[2] * c[2].x(), w[0] * c[0].y() + w[1] * c[1].y() + w[2] * c[2].y());
  }

  /// Patch coordinates of a point in the face frame that the library documents.
  Point_2 uv(face_descriptor f, const Point_2& p) const
  {
    const auto& c = data_.uv[data_.face_number(f)];
    return c[0] + p.x() * x_axis(f) + p.y() * quarter_turn(x_axis(f));
  }

  /// Inverse of uv().
  Point_2 in_frame(face_descriptor f, const Point_2& p) const
  {
    const Vector_2 v = p - data_.uv[data_.face_number(f)][0];
    return Point_2(x_axis(f) * v, cross(x_axis(f), v));
  }

  /// A piece of an offset curve, from its ends and its angle, whose rounding does not grow with the distance of the center
  /// from the face.
  template <class Piece>
  Planar_piece operator()(const Piece& piece) const
  {
    const Point_2 start = uv(piece.start()), end = uv(piece.end());
    const double half = std::tan(piece.angle() / 2);
    if (piece.is_segment() || start == end || !(half > 0)) return Planar_piece::segment(start, end);
    const Point_2 center = CGAL::midpoint(start, end) + quarter_turn(end - start) / (2 * half);
    return Planar_piece::arc(center, piece.radius(), piece.angle(), start, end);
  }

  /// Location of a point of a patch; on an edge or at a vertex if the point is there up to rounding.
  Face_location locate(std::size_t patch, const Point_2& p) const
  {
    Face_location best;
    double best_smallest = -1e-12;
    for (std::size_t i = 0; i < data_.faces.size(); ++i)
    {
      if (data_.patches[i] != patch) continue;
      const auto& c = data_.uv[i];
      const double area = cross(c[1] - c[0], c[2] - c[0]);
      std::array<double, 3> w{
        {cross(c[1] - p, c[2] - p) / area, cross(c[2] - p, c[0] - p) / area, cross(c[0] - p, c[1] - p) / area}};
      const double smallest = *std::min_element(w.begin(), w.end());
      if (!(smallest > best_smallest)) continue;
      best_smallest = smallest;
      best = Face_location(data_.faces[i], w);
    }
    if (best_smallest == -1e-12) throw std::logic_error("the point is not in the patch");
    double sum = 0;
    for (double& w : best.second)
    {
      if (std::abs(w) <= 1e-12) w = 0;
      sum += w;
    }
    for (double& w : best.second) w /= sum;
    return best;
  }

private:
  Vector_2 x_axis(face_descriptor f) const
  {
    const auto& c = data_.uv[data_.face_number(f)];
    return (c[1] - c[0]) / distance(c[0], c[1]);
  }

  const Mesh_data& data_;
};

/// Checks of every curve, up to `tolerance`: pieces are joined; the points of arcs are at their radius from the center,
/// those of segments on their line; radius plus distance of the bending vertex is the level. Pieces shorter than the
/// tolerance, at a vertex on the level, must only be joined.
template <class Geodesic>
class Piece_checker
{
public:
  typedef typename Geodesic::Offset_curve Offset_curve;

  Piece_checker(const Geodesic& geodesic, double tolerance) : geodesic_(geodesic), tolerance_(tolerance) {}

  void check(const Offset_curve& curve)
  {
    const std::size_t n = curve.number_of_pieces();
    CHECK(n > 0);
    double length = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
      const auto piece = curve.piece(i);
      length += piece.length();
      if (i + 1 < n || curve.is_closed())
      {
        const auto next = curve.piece((i + 1) % n);
        const double gap = std::sqrt(CGAL::squared_distance(curve.point(piece.end()), curve.point(next.start())));
        worst_gap_ = (std::max)(worst_gap_, gap);
        CHECK_DETAIL(gap <= tolerance_, values(gap, 0));
      }
      if (piece.length() <= tolerance_)
      {
        ++number_of_specks_;
        continue;
      }
      double way_to_center = 0;
      if (const auto pseudo_source = piece.pseudo_source())
      {
        CHECK(piece.is_arc());
        way_to_center = geodesic_.distance_to_sources(*pseudo_source);
      }
      if (piece.is_arc())
      {
        const double level = piece.radius() + way_to_center;
        CHECK_DETAIL(std::abs(level - cut_level(curve.distance())) <= tolerance_, values(level, cut_level(curve.distance())));
      }
      else ++number_of_segments_;
      for (int k = 0; k <= 4; ++k)
      {
        const Point_2 p = piece.point_2(k / 4.);
        const double off = piece.is_arc() ? distance(p, piece.center()) - piece.radius()
                                          : std::sqrt(CGAL::squared_distance(p, piece.supporting_line()));
        worst_off_ = (std::max)(worst_off_, std::abs(off));
        CHECK_DETAIL(std::abs(off) <= tolerance_, values(off, 0));
      }
    }
    CHECK_DETAIL(std::abs(length - curve.length()) <= tolerance_, values(length, curve.length()));
  }

  double worst_gap() const { return worst_gap_; }
  double worst_off() const { return worst_off_; }
  std::size_t number_of_specks() const { return number_of_specks_; }
  std::size_t number_of_segments() const { return number_of_segments_; }

private:
  const Geodesic& geodesic_;
  double tolerance_;
  double worst_gap_ = 0, worst_off_ = 0;
  std::size_t number_of_segments_ = 0, number_of_specks_ = 0;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_UNFOLDED_CURVES_H
