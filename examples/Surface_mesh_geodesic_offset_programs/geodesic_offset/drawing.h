// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Early detection of offsets that do not lie in one plane, as .svg files require.

#ifndef GEODESIC_OFFSET_DRAWING_H
#define GEODESIC_OFFSET_DRAWING_H

#include "common/common.h"
#include "common/sources.h"

#include <CGAL/Surface_mesh_geodesic_offset/IO/write_svg.h>

#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace geodesic_offset {
namespace internal {

// Whether no two adjacent faces are coplanar, within a tolerance for coordinates of six digits.
inline bool is_curved_everywhere(const Mesh& mesh, double diagonal)
{
  const double tolerance = 1e-6 * diagonal;
  const auto is_flat = [&](Halfedge h) {
    const Point &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h));
    const Vector normal = CGAL::cross_product(b - a, mesh.point(mesh.target(mesh.next(h))) - a);
    const Point& beyond = mesh.point(mesh.target(mesh.next(mesh.opposite(h))));
    return std::abs(normal * (beyond - a)) <= tolerance * std::sqrt(normal.squared_length());
  };
  for(Edge e : mesh.edges())
    if(!mesh.is_border(e) && (is_flat(mesh.halfedge(e)) || is_flat(mesh.opposite(mesh.halfedge(e))))) return false;
  return true;
}

} // namespace internal

class Drawing_check
{
  std::string m_file; // empty: no .svg file, or the mesh is planar
  std::string m_problem;

public:
  // Throws Input_error if the mesh is curved everywhere: then only a circle around a source point within its face is
  // planar.
  Drawing_check(const std::vector<std::string>& outputs, const Mesh& mesh, double diagonal, const Sources& sources)
  {
    for(const std::string& output : outputs)
      if(has_extension(output, ".svg") && m_file.empty()) m_file = output;
    if(m_file.empty()) return;
    if(CGAL::IO::can_write_offset_SVG(mesh))
      m_file.clear();
    else if(!sources.are_points() && internal::is_curved_everywhere(mesh, diagonal))
      throw Input_error(failure("no two faces of the mesh lie in one plane, so no offset does"));
  }

  // Checks the offsets of one distance.
  void look_at(const std::vector<Offset_curve>& curves)
  {
    if(m_file.empty() || !m_problem.empty()) return;
    std::ostream nowhere(nullptr);
    try
    {
      CGAL::IO::write_offset_SVG(nowhere, curves);
    }
    catch(const std::invalid_argument& error)
    {
      m_problem = failure(error.what());
    }
  }

  // Message about the first distance whose offsets do not lie in one plane; empty if there is none so far.
  const std::string& problem() const { return m_problem; }

private:
  std::string failure(const std::string& why) const { return "cannot write " + quoted(m_file) + ": " + why; }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_DRAWING_H
