// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_DXF_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_DXF_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/Length_unit.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/discretized_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/Dxf_document.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/plane_pieces.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/writing_parameters.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Curve_thinning.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace IO {
namespace Surface_mesh_geodesic_offset_internal {

// Conversion of one curve to polylines of the document.
template <class Curve>
class Dxf_curve
{
public:
  Dxf_curve(const Curve& curve, const typename Curve::FT& chord_tolerance, std::size_t layer)
    : m_curve(curve), m_tolerance(chord_tolerance), m_layer(layer), m_n(curve.number_of_pieces())
  {
    for (std::size_t i = 0; i < m_n; ++i) m_heights.push_back(height(i));
  }

  void write_to(std::vector<Dxf_polyline>& out)
  {
    if (m_n == 0) return;
    if (!split_into_runs()) // all pieces are in one plane, or none are
    {
      m_runs.push_back({0, m_n});
      out.push_back(is_horizontal(0) ? flat(0, true) : spatial(0, true));
      return;
    }
    for (std::size_t r = 0; r < m_runs.size(); ++r)
      out.push_back(is_horizontal(m_runs[r].first) ? flat(r, false) : spatial(r, false));
  }

private:
  struct Run
  {
    std::size_t first, count;
  };

  // Height of a horizontal face; NaN for other faces.
  double height(std::size_t i) const
  {
    const std::array<Coordinates, 3> c = corners(m_curve, m_curve.piece(i));
    double size = 0;
    for (const Coordinates& p : c)
      for (double x : p) size = (std::max)(size, std::abs(x));
    const double low = (std::min)({c[0][2], c[1][2], c[2][2]}), high = (std::max)({c[0][2], c[1][2], c[2][2]});
    return high - low <= rounding * size ? (low + high) / 2 : std::nan("");
  }

  bool is_horizontal(std::size_t i) const { return !std::isnan(m_heights[i]); }

  bool is_same(std::size_t i, std::size_t j) const
  {
    if (!is_horizontal(i) || !is_horizontal(j)) return is_horizontal(i) == is_horizontal(j);
    const Coordinates p = coordinates(m_curve.point(m_curve.piece(i).start()));
    const double size = (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    return std::abs(m_heights[i] - m_heights[j]) <= 4 * rounding * size;
  }

  // Splits the curve at changes of plane. Only arcs require it, since segments are the same in both kinds of polyline.
  // Returns whether there are several runs.
  bool split_into_runs()
  {
    if (!divide()) return false;
    for (const Run& run : m_runs)
    {
      bool has_arc = false;
      for (std::size_t k = 0; k < run.count; ++k) has_arc = has_arc || m_curve.piece((run.first + k) % m_n).is_arc();
      if (!has_arc)
        for (std::size_t k = 0; k < run.count; ++k) m_heights[(run.first + k) % m_n] = std::nan("");
    }
    return divide();
  }

  bool divide()
  {
    m_runs.clear();
    std::size_t start = 0;
    if (m_curve.is_closed())
      while (start < m_n && is_same((start + m_n - 1) % m_n, start)) ++start;
    if (start == m_n) return false;
    for (std::size_t k = 0; k < m_n; ++k)
      if (k == 0 || !is_same(m_runs.back().first, (start + k) % m_n)) m_runs.push_back({(start + k) % m_n, 1});
      else ++m_runs.back().count;
    const bool several = m_runs.size() > 1;
    if (!several) m_runs.clear();
    return several;
  }

  Dxf_polyline polyline(bool is_whole, bool is_horizontal) const
  {
    Dxf_polyline p;
    p.layer = m_layer;
    p.is_horizontal = is_horizontal;
    p.is_closed = is_whole && m_curve.is_closed();
    return p;
  }

  Dxf_polyline flat(std::size_t r, bool is_whole) const
  {
    const Run& run = m_runs[r];
    const double z = m_heights[run.first];
    const auto from_above = [](const Coordinates& c) { return Plane_point{c[0], c[1]}; };
    const std::vector<Plane_piece> pieces =
      is_whole ? plane_pieces(m_curve, from_above) : plane_pieces(m_curve, run.first, run.count, from_above);
    Dxf_polyline p = polyline(is_whole, true);
    for (const Plane_piece& piece : pieces)
      for_each_part(piece, CGAL_PI * (1 + 1e-12), [&](const Plane_piece& part) {
        p.vertices.push_back({{part.start[0], part.start[1], z}, std::tan(part.sweep / 4)});
      });
    // every polyline has at least two vertices, however short the curve
    if (!p.is_closed || p.vertices.size() < 2) p.vertices.push_back({{pieces.back().end[0], pieces.back().end[1], z}, 0});
    return p;
  }

  Dxf_polyline spatial(std::size_t r, bool is_whole) const
  {
    const Run& run = m_runs[r];
    Dxf_polyline p = polyline(is_whole, false);
    const Geodesic_offset::internal::Curve_thinning<Curve> thinning(m_curve, m_tolerance);
    for (const Geodesic_offset::internal::Curve_point& point :
         is_whole ? thinning.whole([](std::size_t) { return false; }) : thinning.part(run.first, run.count))
      p.vertices.push_back({coordinates(m_curve.point(point.location(m_curve))), 0});
    if (p.is_closed) p.vertices.pop_back();
    if (is_whole) return p;
    // the end points are identical to those of the adjacent arcs
    const std::size_t before = (r + m_runs.size() - 1) % m_runs.size(), after = (r + 1) % m_runs.size();
    if (m_curve.is_closed() || r > 0) p.vertices.front().point[2] = m_heights[m_runs[before].first];
    if (m_curve.is_closed() || after > 0) p.vertices.back().point[2] = m_heights[m_runs[after].first];
    return p;
  }

  static constexpr double rounding = 1e-12;

  const Curve& m_curve;
  typename Curve::FT m_tolerance;
  std::size_t m_layer, m_n;
  std::vector<double> m_heights; // heights of the pieces; NaN: not in a horizontal plane
  std::vector<Run> m_runs;
};

} // namespace Surface_mesh_geodesic_offset_internal

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetIO

\brief writes offset curves as a DXF file (ASCII, AutoCAD 2000), in three dimensions.

- A curve that lies in a horizontal plane becomes one `LWPOLYLINE` at the elevation of the plane, with the true arcs as
  bulges; an arc is one bulge (or two, if it is longer than a half turn) however many faces it crosses.
- A curve that has no arc in a horizontal plane becomes one 3D `POLYLINE` with few points, see
  `Geodesic_offset_curve::points()`.
- Any other curve is split where its arcs enter and leave a horizontal plane, into polylines of both kinds. Each polyline
  ends at exactly the first point of the next one, so they can be rejoined.

A face is horizontal if the heights of its corners differ by no more than rounding (1e-12 of the largest coordinate),
whether its normal points up or down. Polylines of closed curves have the flag "closed". There is one layer per distance,
named `offset_` and the distance. One unit of the file is one unit of the mesh.

\tparam OffsetCurveRange a model of `ConstRange` with `Surface_mesh_geodesic_offset::Offset_curve` as value type
\param os the stream
\param curves the curves
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{chord_tolerance}
    \cgalParamDescription{the largest distance of a 3D polyline from its curve, in the units of the mesh's points}
    \cgalParamType{a number type, convertible to `double`; positive}
    \cgalParamDefault{that of `write_offset_curves()`}
  \cgalParamNEnd
  \cgalParamNBegin{length_unit}
    \cgalParamDescription{the unit of the mesh, for `$INSUNITS`; without one, the file is unitless}
    \cgalParamType{`IO::Length_unit`}
    \cgalParamDefault{`IO::Length_unit::NONE`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return whether the stream is still good.
\throws std::invalid_argument unless `chord_tolerance > 0`; then nothing has been written
\throws std::length_error as `Geodesic_offset_curve::points()`; then nothing has been written
*/
template <class OffsetCurveRange, class NamedParameters = parameters::Default_named_parameters>
bool write_offset_DXF(std::ostream& os, const OffsetCurveRange& curves,
                      const NamedParameters& np = parameters::default_values())
{
  namespace internal = Surface_mesh_geodesic_offset_internal;
  const double chord_tolerance = internal::chord_tolerance_of<Geodesic_offset::internal::Writing_parameters>(curves, np);
  const Length_unit unit = internal::length_unit_of<Geodesic_offset::internal::Writing_parameters>(np);
  Geodesic_offset::internal::check_all_numbers_of_chords(curves, chord_tolerance); // before any output
  std::vector<std::string> layers;
  std::map<std::string, std::size_t> layer_of;
  std::vector<internal::Dxf_polyline> polylines;
  for (const auto& curve : curves)
  {
    typedef typename std::decay<decltype(curve)>::type Curve;
    const std::string name = "offset_" + internal::short_number(CGAL::to_double(curve.distance()));
    const auto layer = layer_of.emplace(name, layers.size());
    if (layer.second) layers.push_back(name);
    internal::Dxf_curve<Curve>(curve, typename Curve::FT(chord_tolerance), layer.first->second).write_to(polylines);
  }

  Bbox_3 box;
  for (const auto& polyline : polylines)
    for (const auto& vertex : polyline.vertices) box += internal::bbox(vertex.point);
  if (polylines.empty()) box = Bbox_3(0, 0, 0, 0, 0, 0);

  const internal::Full_precision precision(os);
  internal::Dxf_document(os).write(layers, polylines, box, unit);
  return os.good();
}

} // namespace IO
} // namespace CGAL

#endif
