// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_DISCRETIZED_CURVES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_DISCRETIZED_CURVES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/number_utils.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <array>
#include <ios>
#include <limits>
#include <ostream>
#include <vector>

namespace CGAL {
namespace IO {
namespace Surface_mesh_geodesic_offset_internal {

// Enough digits for a reader to get the same doubles, as long as this object lives.
class Full_precision
{
  std::ostream&           m_os;
  std::streamsize         m_precision;
  std::ios_base::fmtflags m_flags;

public:
  explicit Full_precision(std::ostream& os)
    : m_os(os), m_precision(os.precision(std::numeric_limits<double>::max_digits10)), m_flags(os.flags())
  {
    m_os.unsetf(std::ios_base::floatfield);
  }
  ~Full_precision()
  {
    m_os.precision(m_precision);
    m_os.flags(m_flags);
  }
  Full_precision(const Full_precision&) = delete;
  Full_precision& operator=(const Full_precision&) = delete;
};

using Coordinates = std::array<double, 3>;

// The points of a curve, whatever their type. A closed curve repeats its first point.
template <class Curve, class FT>
std::vector<Coordinates> discretized(const Curve& curve, const FT& chord_tolerance)
{
  std::vector<Coordinates> points;
  curve.points(chord_tolerance, boost::make_function_output_iterator([&](const auto& p) {
                 points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
               }));
  return points;
}

inline void write_coordinates(std::ostream& os, const Coordinates& p)
{
  os << p[0] << ' ' << p[1] << ' ' << p[2];
}

} // namespace Surface_mesh_geodesic_offset_internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_DISCRETIZED_CURVES_H
