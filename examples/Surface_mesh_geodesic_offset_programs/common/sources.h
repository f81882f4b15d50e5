// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Sources of the command line, located on the mesh.

#ifndef GEODESIC_OFFSET_SOURCES_H
#define GEODESIC_OFFSET_SOURCES_H

#include "common.h"
#include "mesh_input.h"
#include "polyline_file.h"
#include "source_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace geodesic_offset {

using Surface_polyline = CGAL::Geodesic_polyline<Face_location>;

// Distances by which points were moved to the surface.
class Moved_points
{
  // fraction of the bounding-box diagonal: larger distances are neither rounding nor due to a coarse mesh
  static constexpr double most = 0.01;

  std::size_t m_number = 0;
  double m_largest = 0;
  std::string m_farthest; // the point with the largest distance

public:
  // name(): name of the point for messages.
  template <class Name>
  void add(double distance, const Name& name)
  {
    ++m_number;
    if(!(distance > m_largest)) return;
    m_largest = distance;
    m_farthest = name();
  }

  // Empty if there are no such points.
  std::string remark() const
  {
    return m_number == 0 ? std::string()
                         : counted(m_number, "point") + " moved to the surface, by at most " + short_number(m_largest);
  }

  // Empty if all points were near the surface.
  std::string warning(double diagonal) const
  {
    if(!(m_largest > most * diagonal)) return std::string();
    const double part = m_largest / diagonal;
    const std::string compared =
      part < 1 ? short_number(std::round(1000 * part) / 10) + " % of" : short_number(part) + " times";
    return m_farthest + " is " + short_number(m_largest) + " away from the surface, " + compared +
           " the diagonal of its bounding box; does it have the unit of the mesh?";
  }
};

// Paths on the surface between consecutive points of a polyline that are much longer than the distance of the points in space.
class Detours
{
  // Times the distance in space. A path over an edge of 60 degrees is as long as this; one around a half circle is 1.57 times as long.
  static constexpr double factor = 2;
  // The same if the normals at both ends are opposite, as on both sides of a thin part near its rim: more than a path on one
  // side bends. Binding test: test_program_sides, skins.
  static constexpr double factor_across = 1.1;
  // Fraction of the length of the polyline: shorter detours are due to points that are nearly the same.
  static constexpr double least = 1e-4;

  const std::vector<Point>& m_points;
  double m_length = 0;
  std::size_t m_number = 0, m_worst = 0;
  double m_worst_path = 0, m_worst_distance = 0;

public:
  explicit Detours(const std::vector<Point>& points) : m_points(points)
  {
    for(std::size_t i = 1; i < points.size(); ++i) m_length += distance(i - 1);
  }

  // The length of the path from a point to the next one, and whether the normals there are opposite.
  void add(std::size_t i, double path, bool has_opposite_normals)
  {
    const double direct = distance(i);
    if(!(path > (has_opposite_normals ? factor_across : factor) * direct && path > least * m_length)) return;
    ++m_number;
    if(!(path - direct > m_worst_path - m_worst_distance)) return;
    m_worst = i;
    m_worst_path = path;
    m_worst_distance = direct;
  }

  // Empty if there are none.
  std::string warning() const
  {
    if(m_number == 0) return std::string();
    const Point& p = m_points[m_worst];
    return "from point " + std::to_string(m_worst) + " at " + short_number(p.x()) + ',' + short_number(p.y()) + ',' +
           short_number(p.z()) + " to the next one the path on the surface has length " + short_number(m_worst_path) +
           ", their distance in space is " + short_number(m_worst_distance) +
           (m_number == 1 ? std::string() : "; so have " + std::to_string(m_number - 1) + " more") +
           "; are they on different sides of a thin part or of an edge? --project puts them on one side";
  }

private:
  double distance(std::size_t i) const { return std::sqrt(CGAL::squared_distance(m_points[i], m_points[i + 1])); }
};

// Nearest point of the surface, on vertices and edges up to a snapping distance (0: up to rounding), or that along the
// projection of the options. name(): name of the point for messages. Throws Input_error.
Face_location put_on_surface(const Geodesic_mesh& mesh, const Point& point, const Source_options& options, Moved_points& moved,
                             const std::function<std::string()>& name, double snapping = 0);

// The points of a polyline, as above. With a projection all are put on faces whose normals lead to the same side of its direction, that
// where they are nearer in all; points whose lines meet no such face are put where the surface is met first.
std::vector<Face_location> put_on_surface(const Geodesic_mesh& mesh, const std::vector<Point>& points,
                                          const Source_options& options, Moved_points& moved,
                                          const std::function<std::string(std::size_t)>& name, double snapping);

// Vertices of the mesh at a vertex of the file, at least one. `option`: for messages. Throws Input_error.
std::vector<Vertex> vertices_at(const Mesh_input& input, std::size_t i, const std::string& option,
                                const std::string& mesh_file);

class Sources
{
  const Mesh_input& m_input;
  const Mesh& m_mesh;
  const Geodesic_mesh& m_geodesic; // for locating points

  std::vector<Vertex> m_vertices;
  std::vector<Face_location> m_points;
  std::vector<Surface_polyline> m_polylines;
  std::vector<std::string> m_polyline_names;
  std::vector<std::optional<CGAL::Offset_side>> m_polyline_sides; // where given
  std::vector<std::vector<Edge>> m_boundary_cycles; // empty: not a source
  std::vector<std::vector<Edge>> m_edges;
  std::vector<std::string> m_remarks;
  std::vector<std::string> m_warnings;
  std::vector<double> m_start_values; // of all sources
  Moved_points m_moved;
  // A point in a file whose digits mean a vertex or an edge is there: beside it, a segment of the curve as short as the
  // rounding of the digits would have an arbitrary direction. In mean edges; about the rounding of eight digits, from which on
  // arcs with an arbitrary side are too short to divide a curve. Binding test: test_program_sides, digits.
  static constexpr double snapping_of_edge = 1. / (1 << 26);

public:
  Sources(const Mesh_input& input, const Source_options& options, const Geodesic_mesh& geodesic);

  // Adds the sources to a Geodesic object, or to one for certified bounds.
  template <class Target>
  void add_to(Target& geodesic) const
  {
    std::size_t number = 0;
    const auto start = [&] { return CGAL::parameters::start_value(m_start_values[number++]); };
    for(Vertex v : m_vertices) geodesic.add_source_point(v, start());
    for(const Face_location& location : m_points) geodesic.add_source_point(location, start());
    for(const Surface_polyline& polyline : m_polylines)
      if(const auto value = start(); polyline.start_values.empty())
        geodesic.add_source_polyline(polyline, value);
      else
        geodesic.add_source_polyline(polyline);
    for(const std::vector<Edge>& cycle : m_boundary_cycles) geodesic.add_source_edges(cycle, start());
    for(const std::vector<Edge>& edges : m_edges) geodesic.add_source_edges(edges, start());
  }

  // Only polylines have sides.
  bool has_polylines() const { return !m_polylines.empty(); }

  double smallest_start_value() const
  {
    double least = infinity;
    for_each_start_value([&](double start) { least = std::min(least, start); });
    return least;
  }

  double largest_start_value() const
  {
    double largest = 0;
    for_each_start_value([&](double start) { largest = std::max(largest, start); });
    return largest;
  }

  // Whether all sources are single points, away from the vertices of the mesh.
  bool are_points() const { return m_vertices.empty() && m_polylines.empty() && m_boundary_cycles.empty() && m_edges.empty(); }

  // Calls f(vertex, length) for straight paths in a face from a source to a vertex, at least one per source. To the lengths the
  // largest start value is added.
  template <class Function>
  void for_each_start(const Function& f) const
  {
    const double start = largest_start_value();
    for(Vertex v : m_vertices) f(v, start);
    for(const Face_location& location : m_points) for_each_corner(location, start, f);
    for(const Surface_polyline& polyline : m_polylines)
      for(const Face_location& location : polyline.locations) for_each_corner(location, start, f);
    for_each_edge([&](Edge e) {
      f(m_mesh.vertex(e, 0), start);
      f(m_mesh.vertex(e, 1), start);
    });
  }

  // Sides of all polylines by their source ids. `side`: of those without their own. Inside and outside are left or right where
  // `insides` has the polyline.
  std::map<std::size_t, CGAL::Offset_side> sides(CGAL::Offset_side side,
                                                 const std::map<std::size_t, CGAL::Geodesic_inner_side>& insides = {}) const
  {
    using CGAL::Offset_side;
    std::map<std::size_t, Offset_side> result;
    for(std::size_t i = 0; i < m_polylines.size(); ++i) result[first_polyline() + i] = m_polyline_sides[i].value_or(side);
    for(const auto& [id, inner] : insides)
      result[id] =
        (inner.side == CGAL::Source_side::LEFT) == (result[id] == Offset_side::INSIDE) ? Offset_side::LEFT : Offset_side::RIGHT;
    return result;
  }

  // Source id of the first polyline.
  std::size_t first_polyline() const { return m_vertices.size() + m_points.size(); }

  const Mesh& mesh() const { return m_mesh; }

  const std::vector<Surface_polyline>& surface_polylines() const { return m_polylines; }

  // File and line, or plane, of a polyline, for messages.
  const std::string& name_of_polyline(std::size_t i) const { return m_polyline_names[i]; }

  const std::vector<std::string>& remarks() const { return m_remarks; }
  const std::vector<std::string>& warnings() const { return m_warnings; }
  const Moved_points& moved_points() const { return m_moved; }

  Point point_of(const Face_location& location) const;

  std::vector<Point> points() const;

  // Closed polylines repeat their first point.
  std::vector<std::vector<Point>> polylines() const;

private:
  template <class Function>
  void for_each_start_value(const Function& f) const
  {
    for(std::size_t i = 0; i < m_start_values.size(); ++i)
    {
      const std::size_t first = first_polyline();
      const bool varies = i >= first && i - first < m_polylines.size() && !m_polylines[i - first].start_values.empty();
      if(!varies) f(m_start_values[i]);
    }
    for(const Surface_polyline& polyline : m_polylines)
      for(const double start : polyline.start_values) f(start);
  }

  double length_of(const Surface_polyline& polyline) const;

  template <class Function>
  void for_each_edge(const Function& f) const
  {
    for(const auto* sets : {&m_boundary_cycles, &m_edges})
      for(const std::vector<Edge>& edges : *sets)
        for(Edge e : edges) f(e);
  }

  template <class Function>
  void for_each_corner(const Face_location& location, double start, const Function& f) const
  {
    const Point point = point_of(location);
    for(Vertex v : m_mesh.vertices_around_face(m_mesh.halfedge(location.first)))
      f(v, start + std::sqrt(CGAL::squared_distance(point, m_mesh.point(v))));
  }

  void add_polyline(const File_polyline& from, const std::string& file, const std::optional<CGAL::Offset_side>& side,
                    const Source_options& options);

  void add(Surface_polyline polyline, const std::string& name, const std::optional<CGAL::Offset_side>& side = std::nullopt);

  void add_plane(const std::array<double, 4>& plane, const Source_options& options);

  void add_boundary(const Source_options& options);

  void add_sharp_edges(double degrees, const Source_options& options);

  void set_start_values(const Source_options& options);
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_SOURCES_H
