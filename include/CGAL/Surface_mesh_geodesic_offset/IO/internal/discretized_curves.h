// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Functions shared by the writers: points and numbers of curves of any number type.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_DISCRETIZED_CURVES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_DISCRETIZED_CURVES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Curve_thinning.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/chord_tolerance.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <array>
#include <cstddef>
#include <ios>
#include <iterator>
#include <limits>
#include <locale>
#include <optional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::IO::Surface_mesh_geodesic_offset_internal {

// Scope with enough digits for readers to restore the doubles, and a decimal point in every locale.
class Full_precision
{
public:
  explicit Full_precision(std::ostream& os)
    : m_os(os), m_precision(os.precision(std::numeric_limits<double>::max_digits10)), m_flags(os.flags()),
      m_locale(os.imbue(std::locale::classic()))
  {
    m_os.flags(std::ios_base::dec);
  }
  ~Full_precision()
  {
    m_os.precision(m_precision);
    m_os.flags(m_flags);
    m_os.imbue(m_locale);
  }
  Full_precision(const Full_precision&) = delete;
  Full_precision& operator=(const Full_precision&) = delete;

private:
  std::ostream& m_os;
  std::streamsize m_precision;
  std::ios_base::fmtflags m_flags;
  std::locale m_locale;
};

// Number in names of layers and groups: 0.3, not 0.29999999999999999.
inline std::string short_number(double x, int digits = std::numeric_limits<double>::digits10)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(digits);
  text << x;
  return text.str();
}

// Shortest number from which a reader restores the double.
inline std::string exact_number(double x)
{
  std::istringstream text(short_number(x));
  text.imbue(std::locale::classic());
  double read = 0;
  text >> read;
  return short_number(x, read == x ? std::numeric_limits<double>::digits10 : std::numeric_limits<double>::max_digits10);
}

typedef std::array<double, 3> Coordinates;

// The sum with 0 makes -0 positive.
template <class Point_3>
Coordinates coordinates(const Point_3& p)
{
  return {CGAL::to_double(p.x()) + 0., CGAL::to_double(p.y()) + 0., CGAL::to_double(p.z()) + 0.};
}

inline Bbox_3 bbox(const Coordinates& p) { return Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]); }

inline void write_coordinates(std::ostream& os, const Coordinates& p) { os << p[0] << ' ' << p[1] << ' ' << p[2]; }

// Which points of curves are written.
struct Point_options
{
  Point_options(double tolerance = 0) : chord_tolerance(tolerance) {}

  double chord_tolerance;
  std::optional<double> spacing; // instead of the tolerance
  bool has_smooth_normals = false;

  // In the tree of nesting: -1 without a parent; sides as in Source_side.
  struct Place
  {
    long long parent;
    int inner_side;
  };
  std::vector<Place> places; // by curve; empty if they are not written
};

// \throws std::invalid_argument unless the tolerance and the spacing are positive
inline void check_point_options(const Point_options& options)
{
  Geodesic_offset::internal::check_chord_tolerance(options.chord_tolerance);
  if (options.spacing) Geodesic_offset::internal::check_point_spacing(*options.spacing);
}

// Before any output.
// \throws std::invalid_argument as check_point_options()
// \throws std::length_error if a curve has too many points
template <class CurveRange>
void check_numbers_of_points(const CurveRange& curves, const Point_options& options)
{
  namespace internal = Geodesic_offset::internal;
  check_point_options(options);
  if (!options.places.empty() && options.places.size() != std::size_t(std::distance(std::begin(curves), std::end(curves))))
    throw std::invalid_argument("Surface_mesh_geodesic_offset: curve_nesting() must have as many places as there are curves");
  for (const auto& curve : curves)
  {
    typedef typename std::decay<decltype(curve)>::type::FT FT;
    if (options.spacing) internal::number_of_parts(curve, FT(*options.spacing));
    else internal::check_number_of_chords(curve, FT(options.chord_tolerance));
  }
}

// Points of a curve within a tolerance, with the index of the piece of each point; a point between two pieces belongs to
// the first of them. A closed curve repeats its first point.
struct Discretized_curve
{
  std::vector<Coordinates> points;
  std::vector<std::size_t> pieces;
  std::vector<double> parameters; // in the pieces
};

// is_kept(i): whether the end of piece i must be a point.
template <class Curve, class Condition>
Discretized_curve discretized(const Curve& curve, double chord_tolerance, const Condition& is_kept)
{
  Discretized_curve result;
  const Geodesic_offset::internal::Curve_thinning<Curve> thinning(curve, typename Curve::FT(chord_tolerance));
  for (const Geodesic_offset::internal::Curve_point& p : thinning.whole(is_kept))
  {
    result.points.push_back(coordinates(curve.point(p.location(curve))));
    result.pieces.push_back(p.piece);
    result.parameters.push_back(double(p.part) / double(p.parts));
  }
  return result;
}

// The points alone.
template <class Curve>
std::vector<Coordinates> points_of(const Curve& curve, const Point_options& options)
{
  if (!options.spacing) return discretized(curve, options.chord_tolerance, [](std::size_t) { return false; }).points;
  std::vector<Coordinates> points;
  const auto add = [&points](const auto& p) { points.push_back(coordinates(p.point)); };
  curve.points_at_spacing(typename Curve::FT(*options.spacing), boost::make_function_output_iterator(add));
  return points;
}

// Writes a whole file. Lines: the writer of a format for several ranges of curves.
template <class Lines, class CurveRange>
bool write_lines(std::ostream& os, const CurveRange& curves, const Point_options& options)
{
  check_numbers_of_points(curves, options); // before any output
  Lines lines;
  lines.begin(os, options);
  lines.add(os, curves, options);
  lines.end(os);
  return os.good();
}

} // namespace CGAL::IO::Surface_mesh_geodesic_offset_internal

#endif
