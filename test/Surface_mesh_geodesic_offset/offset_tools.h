// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offsets at a level, and comparisons of two sets of offset curves.

#ifndef GEODESIC_OFFSET_TEST_OFFSET_TOOLS_H
#define GEODESIC_OFFSET_TEST_OFFSET_TOOLS_H

#include "geodesic_types.h"
#include "test_check.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test {

typedef Geodesic::Offset_curve Offset_curve;
typedef Offset_curve::Piece Offset_piece;
typedef Geodesic::Face_location Face_location;
typedef std::vector<Offset_curve> Offset_curves;

/// The part of an offset that is requested.
struct Offset_selection
{
  CGAL::Offset_side side = CGAL::Offset_side::BOTH;
  CGAL::Offset_end end = CGAL::Offset_end::ROUND;

  Offset_selection() = default;
  Offset_selection(CGAL::Offset_side which_side, CGAL::Offset_end which_end = CGAL::Offset_end::ROUND)
    : side(which_side), end(which_end)
  {
  }

  auto parameters() const { return CGAL::parameters::offset_side(side).end_style(end); }
};

/// Offset curves at one or several distances.
template <class Levels>
Offset_curves offsets(const Geodesic& geodesic, const Levels& levels, const Offset_selection& selection = Offset_selection())
{
  Offset_curves result;
  geodesic.offset_curves(levels, std::back_inserter(result), selection.parameters());
  return result;
}

inline Surface_mesh mesh_of(const Soup& soup)
{
  Surface_mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
  return mesh;
}

/// The largest coordinate.
inline double size_of(const Surface_mesh& mesh)
{
  double size = 0;
  for (const auto v : mesh.vertices())
    for (int i = 0; i < 3; ++i) size = (std::max)(size, std::abs(mesh.point(v)[i]));
  return size;
}

inline double total_length(const Offset_curves& curves)
{
  double sum = 0;
  for (const Offset_curve& curve : curves) sum += curve.length();
  return sum;
}

inline std::size_t number_of_closed(const Offset_curves& curves)
{
  return static_cast<std::size_t>(std::count_if(curves.begin(), curves.end(), [](const Offset_curve& c) {
    return c.is_closed();
  }));
}

/// Key of a piece: its face, ends, circle or line, and source.
typedef std::tuple<std::size_t, double, double, double, double, double, bool, std::size_t, std::size_t, int> Piece_key;

inline Piece_key key_of(const Offset_piece& p)
{
  return Piece_key(std::size_t(p.face()), p.start_2().x(), p.start_2().y(), p.end_2().x(), p.end_2().y(),
                   p.is_arc() ? p.radius() : 0, p.is_arc(), p.source(), p.source_part(), int(p.side()));
}

/// Pieces of all curves, in a canonical order.
inline std::vector<Piece_key> sorted_pieces(const Offset_curves& curves)
{
  std::vector<Piece_key> result;
  for (const Offset_curve& curve : curves)
    for (const Offset_piece& p : curve.pieces()) result.push_back(key_of(p));
  std::sort(result.begin(), result.end());
  return result;
}

/// Distance, closedness and length of each curve, in a canonical order.
inline std::vector<std::tuple<double, bool, double>> sorted_curves(const Offset_curves& curves)
{
  std::vector<std::tuple<double, bool, double>> result;
  for (const Offset_curve& curve : curves) result.emplace_back(curve.distance(), curve.is_closed(), curve.length());
  std::sort(result.begin(), result.end());
  return result;
}

/// Whether two sets of curves agree in all distances, in closedness, and in length to 1e-12 of the sum of the length and
/// `scale`. `worst` receives the largest difference.
inline bool same_curves(const Offset_curves& a, const Offset_curves& b, double scale, double& worst)
{
  const auto p = sorted_curves(a), q = sorted_curves(b);
  if (p.size() != q.size()) return false;
  bool same = true;
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    const double difference = std::abs(std::get<2>(p[i]) - std::get<2>(q[i])) / (std::get<2>(q[i]) + scale);
    worst = (std::max)(worst, difference);
    same = same && std::get<0>(p[i]) == std::get<0>(q[i]) && std::get<1>(p[i]) == std::get<1>(q[i]) && difference <= 1e-12;
  }
  return same;
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_OFFSET_TOOLS_H
