// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the user gets to read about a certificate: one line per finding.

#ifndef VALIDATE_GEODESIC_OFFSETS_REPORT_H
#define VALIDATE_GEODESIC_OFFSETS_REPORT_H

#include "common/common.h"
#include "common/messages.h"
#include "common/numbers.h"
#include "curves_on_surface.h"

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_offset_certificate.h>

#include <ostream>
#include <string>

namespace geodesic_offset {

using Certificate = CGAL::Geodesic_offset_certificate<Face_location>;

class Certificate_writer
{
  std::ostream& m_out;
  const Mesh& m_mesh;
  const Curves_on_surface& m_curves;

public:
  Certificate_writer(std::ostream& out, const Mesh& mesh, const Curves_on_surface& curves)
    : m_out(out), m_mesh(mesh), m_curves(curves)
  {
  }

  void operator()(const Certificate& c, double diagonal) const
  {
    line("region", c.bounds_region ? "yes" : "no",
         c.bounds_region ? "the curves bound a region of the surface" : reason(c.limit));
    if(!c.bounds_region)
      line("at", place(c), "one place of those where it fails");
    else if(c.limit == CGAL::Offset_certificate_limit::NONE)
      line("tolerance", "0", "the region is the surface, which is nowhere farther away than the distance");
    else
    {
      line(
        "tolerance", short_upper_bound(c.tolerance) + ", " + short_upper_bound(c.tolerance / diagonal) + " of the diagonal",
        "the smallest EPS that is proven: all that is nearer than D - EPS is in the region, and nothing farther than D + EPS");
      line("at",
           place(c) + ", distance from " + full_number(c.distance_bounds.first) + " to " +
             full_number(c.distance_bounds.second),
           reason(c.limit));
    }
    if(c.number_of_reversed_curves != 0)
      line("reversed", std::to_string(c.number_of_reversed_curves),
           "curves with the region on their right, the first one in line " +
             std::to_string(m_curves.line(*c.first_reversed_curve)));
  }

private:
  void line(const std::string& label, const std::string& value, const std::string& meaning) const
  {
    m_out << label << ": " << value << " (" << meaning << ")\n";
  }

  std::string place(const Certificate& c) const
  {
    std::string text;
    if(c.location)
    {
      const Point p = CGAL::Polygon_mesh_processing::construct_point(*c.location, m_mesh);
      text = short_number(p.x()) + ' ' + short_number(p.y()) + ' ' + short_number(p.z());
    }
    if(c.curve) text += ", curve in line " + std::to_string(m_curves.line(*c.curve));
    return text;
  }

  static std::string reason(CGAL::Offset_certificate_limit limit)
  {
    using Limit = CGAL::Offset_certificate_limit;
    switch(limit)
    {
    case Limit::CURVE_TOO_NEAR: return "a curve is nearer to the sources there, by as much";
    case Limit::CURVE_TOO_FAR: return "a curve is farther from the sources there, by as much";
    case Limit::REGION_TOO_FAR: return "the region reaches farther from the sources there, by as much: a curve may be missing";
    case Limit::SOURCE_OUTSIDE: return "a source is outside of the region: a curve may be missing, or be there twice";
    case Limit::OPEN_END: return "a curve ends inside the surface";
    case Limit::NOT_JOINED: return "two consecutive points are in no common face";
    case Limit::NO_REGION: return "the curves do not separate the surface: a curve may be missing, or be there twice";
    case Limit::NONE: break;
    }
    return "nothing is uncertain";
  }
};

} // namespace geodesic_offset

#endif // VALIDATE_GEODESIC_OFFSETS_REPORT_H
