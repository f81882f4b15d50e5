// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sources.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Surface_mesh_geodesic_offset/Polyline_closing.h>

#include <iterator>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace geodesic_offset {

namespace {

// Removes all curves except for the one nearest to a point. for_each_segment(curve, f) calls f(start, end).
template <class Curve, class Segments>
void keep_nearest(std::vector<Curve>& curves, const std::array<double, 3>& near, const Segments& for_each_segment)
{
  const Point point(near[0], near[1], near[2]);
  std::size_t nearest = 0;
  double least = infinity;
  for(std::size_t i = 0; i < curves.size(); ++i)
    for_each_segment(curves[i], [&](const Point& start, const Point& end) {
      const double distance = CGAL::squared_distance(point, Kernel::Segment_3(start, end));
      if(distance < least) nearest = i;
      least = std::min(least, distance);
    });
  curves = std::vector<Curve>{curves[nearest]};
}

// The chains of given edges: closed, or up to vertices where other than two of the edges meet.
std::vector<std::vector<Halfedge>> chains_of(const Mesh& mesh, const std::vector<Edge>& edges)
{
  std::unordered_map<Vertex, std::vector<Edge>> edges_at;
  for(Edge e : edges)
    for(unsigned i : {0u, 1u}) edges_at[mesh.vertex(e, i)].push_back(e);
  std::unordered_set<Edge> chained;
  std::vector<std::vector<Halfedge>> chains;
  const auto add_chain = [&](Halfedge h) {
    chains.emplace_back();
    while(chained.insert(mesh.edge(h)).second)
    {
      chains.back().push_back(h);
      const Vertex end = mesh.target(h);
      const std::vector<Edge>& at_end = edges_at[end];
      if(at_end.size() != 2) break;
      h = mesh.halfedge(at_end[at_end[0] == mesh.edge(h) ? 1 : 0]);
      if(mesh.source(h) != end) h = mesh.opposite(h);
    }
  };
  for(Edge e : edges)
    for(unsigned i : {0u, 1u})
      if(const Halfedge h = mesh.halfedge(e, i); edges_at[mesh.source(h)].size() != 2 && chained.count(e) == 0) add_chain(h);
  for(Edge e : edges)
    if(chained.count(e) == 0) add_chain(mesh.halfedge(e));
  return chains;
}

// Where a line meets the surface.
struct Hit
{
  Face_location location;
  double distance; // from the point of the line
  bool is_forward; // the normal of the face leads along the direction of the line
};

// The first hits forwards and backwards by increasing distance; all hits if `all`, of which there are few: a ray begins anew behind
// each of them.
std::vector<Hit> hits_of_line(const Geodesic_mesh& mesh, const Point& point, const std::array<double, 3>& projection, bool all)
{
  constexpr std::size_t most_hits = 64; // per ray; the skins of a part are far fewer
  const double largest = std::max({std::abs(projection[0]), std::abs(projection[1]), std::abs(projection[2])});
  const Vector direction(projection[0] / largest, projection[1] / largest, projection[2] / largest);
  std::vector<Hit> hits;
  for(const Vector& d : {direction, -direction})
  {
    Point start = point;
    for(std::size_t i = 0; i < most_hits; ++i)
    {
      const std::optional<Face_location> hit = mesh.locate(Kernel::Ray_3(start, d));
      if(!hit) break;
      const Mesh& tm = mesh.triangle_mesh();
      const Point on_surface = CGAL::Polygon_mesh_processing::construct_point(*hit, tm);
      const Vector normal = CGAL::Polygon_mesh_processing::compute_face_normal(hit->first, tm);
      hits.push_back({*hit, std::sqrt(CGAL::squared_distance(point, on_surface)), normal * direction > 0});
      if(!all) break;
      // behind the rounding of coordinates
      const double size = std::abs(on_surface.x()) + std::abs(on_surface.y()) + std::abs(on_surface.z());
      start = on_surface + (0x1p-40 * (size + hits.back().distance)) * d;
    }
  }
  std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.distance < b.distance; });
  return hits;
}

// Whether the normals of two faces differ by more than 135 degrees.
bool have_opposite_normals(const Mesh& mesh, Face f, Face g)
{
  if(f == g) return false;
  const Vector n = CGAL::Polygon_mesh_processing::compute_face_normal(f, mesh),
               m = CGAL::Polygon_mesh_processing::compute_face_normal(g, mesh); // unit vectors
  return n * m < -std::sqrt(0.5);
}

} // namespace

Face_location put_on_surface(const Geodesic_mesh& mesh, const Point& point, const Source_options& options, Moved_points& moved,
                             const std::function<std::string()>& name, double snapping)
{
  // squares of lengths must be within the range of double
  if(!std::isfinite((point - CGAL::ORIGIN).squared_length())) throw Input_error(name() + " is too far away from the surface");
  if(!options.projection)
  {
    const std::pair<Face_location, double> located =
      snapping > 0 ? mesh.locate_with_distance(point, CGAL::parameters::snapping_tolerance(snapping))
                   : mesh.locate_with_distance(point);
    moved.add(located.second, name);
    return located.first;
  }
  const std::vector<Hit> hits = hits_of_line(mesh, point, *options.projection, false);
  if(hits.empty()) throw Input_error(name() + ": the line along --project through this point misses the surface");
  return hits.front().location;
}

std::vector<Face_location> put_on_surface(const Geodesic_mesh& mesh, const std::vector<Point>& points,
                                          const Source_options& options, Moved_points& moved,
                                          const std::function<std::string(std::size_t)>& name, double snapping)
{
  std::vector<Face_location> result;
  for(std::size_t i = 0; i < points.size(); ++i)
    result.push_back(put_on_surface(
      mesh, points[i], options, moved, [&] { return name(i); }, snapping));
  if(!options.projection) return result;
  std::vector<std::array<std::optional<Hit>, 2>> nearest; // of each side, by point
  double sum[2] = {0, 0};
  std::size_t number[2] = {0, 0};
  for(const Point& point : points)
  {
    nearest.emplace_back();
    for(const Hit& hit : hits_of_line(mesh, point, *options.projection, true))
      if(std::optional<Hit>& known = nearest.back()[hit.is_forward ? 1 : 0]; !known) known = hit;
    for(const std::size_t k : {0, 1})
      if(nearest.back()[k])
      {
        ++number[k];
        sum[k] += nearest.back()[k]->distance;
      }
  }
  const std::size_t side = std::make_pair(number[0], -sum[0]) < std::make_pair(number[1], -sum[1]) ? 1 : 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    if(nearest[i][side]) result[i] = nearest[i][side]->location;
  return result;
}

std::vector<Vertex> vertices_at(const Mesh_input& input, std::size_t i, const std::string& option, const std::string& mesh_file)
{
  const std::size_t n = input.soup().points.size();
  if(i >= n)
    throw Input_error(option + ' ' + std::to_string(i) + ": " + quoted(mesh_file) + " has only the vertices 0 to " +
                      std::to_string(n - 1));
  std::vector<Vertex> vertices;
  input.for_each_vertex_of(i, [&](Vertex v) { vertices.push_back(v); });
  if(vertices.empty())
    throw Input_error(option + ' ' + std::to_string(i) + ": no face of " + quoted(mesh_file) +
                      (input.is_region() ? " inside of --region has this vertex" : " has this vertex"));
  return vertices;
}

Sources::Sources(const Mesh_input& input, const Source_options& options, const Geodesic_mesh& geodesic)
  : m_input(input), m_mesh(input.mesh()), m_geodesic(geodesic)
{
  for(std::size_t i : options.source_vertices)
  {
    const std::vector<Vertex> vertices = vertices_at(input, i, "--source-vertex", options.mesh);
    m_vertices.insert(m_vertices.end(), vertices.begin(), vertices.end());
  }
  for(const std::array<double, 3>& p : options.source_points)
    m_points.push_back(put_on_surface(geodesic, Point(p[0], p[1], p[2]), options, m_moved, [&] {
      return "--source-point " + short_number(p[0]) + ',' + short_number(p[1]) + ',' + short_number(p[2]);
    }));
  for(std::size_t i = 0; i < options.source_polylines.size(); ++i)
    for(const File_polyline& polyline : read_polylines(options.source_polylines[i], false, options.have_start_values))
      add_polyline(polyline, options.source_polylines[i],
                   options.polyline_sides.empty() ? std::nullopt : options.polyline_sides[i], options);
  for(const std::array<double, 4>& plane : options.source_planes) add_plane(plane, options);
  if(options.source_boundary) add_boundary(options);
  for(double degrees : options.source_sharp_edges) add_sharp_edges(degrees, options);
  set_start_values(options);
}

std::vector<Point> Sources::points() const
{
  std::vector<Point> points;
  for(Vertex v : m_vertices) points.push_back(m_mesh.point(v));
  for(const Face_location& location : m_points) points.push_back(point_of(location));
  return points;
}

std::vector<std::vector<Point>> Sources::polylines() const
{
  std::vector<std::vector<Point>> polylines;
  for(const Surface_polyline& polyline : m_polylines)
  {
    polylines.emplace_back();
    for(const Face_location& location : polyline.locations) polylines.back().push_back(point_of(location));
    if(polyline.is_closed) polylines.back().push_back(polylines.back().front());
  }
  for(const auto* sets : {&m_boundary_cycles, &m_edges})
    for(const std::vector<Edge>& edges : *sets)
      for(const std::vector<Halfedge>& chain : chains_of(m_mesh, edges))
      {
        polylines.push_back({m_mesh.point(m_mesh.source(chain.front()))});
        for(Halfedge h : chain) polylines.back().push_back(m_mesh.point(m_mesh.target(h)));
      }
  return polylines;
}

double Sources::length_of(const Surface_polyline& polyline) const
{
  double length = 0;
  for(std::size_t i = 1; i < polyline.locations.size(); ++i)
    length += std::sqrt(CGAL::squared_distance(point_of(polyline.locations[i - 1]), point_of(polyline.locations[i])));
  return length;
}

Point Sources::point_of(const Face_location& location) const
{
  return CGAL::Polygon_mesh_processing::construct_point(location, m_mesh);
}

void Sources::add_polyline(const File_polyline& from, const std::string& file, const std::optional<CGAL::Offset_side>& side,
                           const Source_options& options)
{
  const auto name = [&](std::size_t i) { return "point " + std::to_string(i); };
  const std::string line = quoted(file) + ", line " + std::to_string(from.line);
  const std::size_t n = from.points.size();
  const double gap = std::sqrt(CGAL::squared_distance(from.points.front(), from.points.back()));
  const CGAL::Polyline_closing closing = CGAL::polyline_closing(from.points);
  const bool is_small = n >= 3 && gap <= options.close_gap; // the gap
  // whether the last point stands for the first one; otherwise a segment joins them
  const bool repeats_first =
    closing == CGAL::Polyline_closing::CLOSED || (closing == CGAL::Polyline_closing::NEARLY_CLOSED && is_small);
  Surface_polyline polyline;
  polyline.is_closed = repeats_first || is_small;
  if(polyline.is_closed && gap > 0)
    m_remarks.push_back(line + (repeats_first ? ": closed, its ends are " + short_number(gap) + " apart"
                                              : ": closed by a segment of length " + short_number(gap)));
  if(closing == CGAL::Polyline_closing::NEARLY_CLOSED && !is_small)
    m_warnings.push_back(line + ": open, although its ends are only " + short_number(gap) + " apart; --close-gap " +
                         short_number(gap * (1 + 1e-5)) /* not less after rounding to 6 digits */ + " closes it");
  std::vector<Point> points = from.points;
  if(repeats_first) points.pop_back();
  std::vector<Face_location> located = put_on_surface(
    m_geodesic, points, options, m_moved, [&](std::size_t i) { return line + ": " + name(i); },
    snapping_of_edge * m_geodesic.mean_edge_length());
  std::vector<double> starts = from.start_values;
  if(polyline.is_closed)
  {
    points.push_back(points.front());
    located.push_back(located.front());
    if(!starts.empty())
    {
      starts.resize(points.size());
      starts.back() = starts.front();
    }
  }
  Detours detours(points);
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    if(polyline.locations.empty())
    {
      polyline.locations.push_back(located[i]);
      if(!starts.empty()) polyline.start_values.push_back(starts[i]);
      continue;
    }
    try
    {
      const std::array<Face_location, 2> ends = {polyline.locations.back(), located[i]};
      const std::array<double, 2> starts_of_ends =
        starts.empty() ? std::array<double, 2>{{0, 0}} : std::array<double, 2>{{starts[i - 1], starts[i]}};
      const Surface_polyline path =
        m_geodesic.join_polyline(ends, CGAL::parameters::is_closed(false).start_values(starts_of_ends));
      if(!starts.empty())
        polyline.start_values.insert(polyline.start_values.end(), path.start_values.begin() + 1, path.start_values.end());
      detours.add(i - 1, length_of(path), have_opposite_normals(m_mesh, ends[0].first, ends[1].first));
      polyline.locations.insert(polyline.locations.end(), path.locations.begin() + 1, path.locations.end());
    }
    catch(const std::invalid_argument&)
    {
      throw Input_error(line + ": there is no path on the surface from " + name(i - 1) + " to " + name(i) +
                        ": they are on different parts of the surface" +
                        (m_input.has_barriers() ? ", or barriers separate them" : ""));
    }
  }
  if(const std::string detour = detours.warning(); !detour.empty()) m_warnings.push_back(line + ": " + detour);
  // in closed polylines the first location is not repeated
  if(polyline.is_closed && polyline.locations.size() > 1) polyline.locations.pop_back();
  if(polyline.locations.size() < 3) polyline.is_closed = false;
  if(!starts.empty()) polyline.start_values.resize(polyline.locations.size());
  if(polyline.locations.size() == 1)
    m_points.push_back(polyline.locations.front());
  else
    add(std::move(polyline), line, side);
}

void Sources::add(Surface_polyline polyline, const std::string& name, const std::optional<CGAL::Offset_side>& side)
{
  m_polylines.push_back(std::move(polyline));
  m_polyline_names.push_back(name);
  m_polyline_sides.push_back(side);
}

void Sources::add_plane(const std::array<double, 4>& plane, const Source_options& options)
{
  const std::string& mesh_file = options.mesh;
  auto section = m_geodesic.plane_section(Kernel::Plane_3(plane[0], plane[1], plane[2], plane[3]));
  const std::string name = "--source-plane " + short_number(plane[0]) + ',' + short_number(plane[1]) + ',' +
                           short_number(plane[2]) + ',' + short_number(plane[3]);
  if(section.polylines.empty() && section.touched_edges.empty() && section.touched_vertices.empty())
    throw Input_error(name + (section.number_of_faces_in_plane == 0 ? " misses " + quoted(mesh_file)
                                                                    : " contains all of " + quoted(mesh_file)));
  if(section.number_of_faces_in_plane != 0)
    m_remarks.push_back(counted(section.number_of_faces_in_plane, "face") +
                        " in the plane of a section: the border of this part of the surface is the source");
  if(options.section_near)
  {
    if(section.polylines.empty())
      throw Input_error(name + " only touches " + quoted(mesh_file) + ": there is no curve for --section-near");
    keep_nearest(section.polylines, *options.section_near, [&](const Surface_polyline& polyline, const auto& f) {
      const std::size_t n = polyline.locations.size();
      for(std::size_t i = polyline.is_closed ? 0 : 1; i < n; ++i)
        f(point_of(polyline.locations[(i + n - 1) % n]), point_of(polyline.locations[i]));
    });
    section.touched_edges.clear();
    section.touched_vertices.clear();
  }
  for(Surface_polyline& polyline : section.polylines) add(std::move(polyline), name + " on " + quoted(mesh_file));
  if(!section.touched_edges.empty()) m_edges.push_back(std::move(section.touched_edges));
  m_vertices.insert(m_vertices.end(), section.touched_vertices.begin(), section.touched_vertices.end());
}

void Sources::add_boundary(const Source_options& options)
{
  m_boundary_cycles = m_geodesic.boundary_edges();
  if(m_boundary_cycles.empty()) throw Input_error("--source-boundary: " + quoted(options.mesh) + " has no boundary");
  if(options.boundary_near)
    keep_nearest(m_boundary_cycles, *options.boundary_near, [&](const std::vector<Edge>& cycle, const auto& f) {
      for(Edge e : cycle) f(m_mesh.point(m_mesh.vertex(e, 0)), m_mesh.point(m_mesh.vertex(e, 1)));
    });
}

void Sources::add_sharp_edges(double degrees, const Source_options& options)
{
  std::vector<Edge> edges;
  m_geodesic.sharp_edges(degrees, std::back_inserter(edges));
  if(edges.empty())
    throw Input_error("--source-sharp-edges " + short_number(degrees) + ": " + quoted(options.mesh) +
                      " has no edge with a larger angle");
  if(options.sharp_edges_near)
  {
    std::vector<std::vector<Halfedge>> chains = chains_of(m_mesh, edges);
    keep_nearest(chains, *options.sharp_edges_near, [&](const std::vector<Halfedge>& chain, const auto& f) {
      for(Halfedge h : chain) f(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h)));
    });
    edges.clear();
    for(Halfedge h : chains.front()) edges.push_back(m_mesh.edge(h));
  }
  m_edges.push_back(std::move(edges));
}

void Sources::set_start_values(const Source_options& options)
{
  const std::size_t n = m_vertices.size() + m_points.size() + m_polylines.size() + m_boundary_cycles.size() + m_edges.size();
  m_start_values.assign(n, 0);
  for(const auto& [source, value] : options.start_values)
  {
    if(source >= n)
      throw Input_error("--start-value " + std::to_string(source) + ',' + short_number(value) +
                        ": there are only the sources 0 to " + std::to_string(n - 1));
    if(const std::size_t first = first_polyline();
       source >= first && source - first < m_polylines.size() && !m_polylines[source - first].start_values.empty())
      throw Input_error("--start-value " + std::to_string(source) + ',' + short_number(value) + ": " +
                        m_polyline_names[source - first] + " has start values of its own");
    m_start_values[source] = value;
  }
}

} // namespace geodesic_offset
