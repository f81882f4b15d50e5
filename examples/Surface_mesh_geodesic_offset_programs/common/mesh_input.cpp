// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_input.h"
#include "memory_budget.h"
#include "numbers.h"
#include "polygon_links.h"
#include "polygon_triangles.h"
#include "soup_reader.h"
#include "vertex_fans.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh_geodesic_offset/remove_degenerate_faces_in_polygon_soup.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <set>

namespace geodesic_offset {

Mesh_input::Mesh_input(const std::string& path, const Border_joining& joining) : Mesh_input(path, read_soup(path), joining) {}

Mesh_input::Mesh_input(const std::string& path, Soup soup, const Border_joining& joining)
  : m_soup(std::move(soup)), m_remarks(m_soup.remarks)
{
  require_memory_for_faces(path);
  measure(path, joining.tolerance);
  Faces faces;
  clean_polygons(path, faces);
  build(path, faces, joining);
  map_vertices(faces);
  triangulate(path, faces);
  const Vertex_pairs copies = pairs_of_vertices(faces);
  join(path, copies);
  m_parts = Surface_parts(m_mesh);
}

bool Mesh_input::has_coinciding_border_edges() const
{
  std::vector<Point> points;
  for(Vertex v : m_mesh.vertices()) points.push_back(m_mesh.point(v));
  std::vector<std::array<std::uint32_t, 2>> border_edges;
  for(Edge e : m_mesh.edges())
    if(m_mesh.is_border(e)) border_edges.push_back({m_mesh.vertex(e, 0), m_mesh.vertex(e, 1)});
  return Border_stitching(points, std::move(border_edges), 0, nullptr).is_needed();
}

Mesh_input::Kept_corners Mesh_input::kept_corners(const std::vector<bool>& is_kept) const
{
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  const auto has_face = [&](Halfedge h) { return !m_mesh.is_border(h) && is_kept[m_mesh.face(h)]; };
  std::vector<std::uint32_t> fan_at(m_mesh.number_of_halfedges(), none);
  std::vector<std::uint32_t> unbounded(m_mesh.number_of_vertices(), none); // fans without removed faces beside them
  std::vector<std::pair<Vertex, std::uint32_t>> fans;
  for(Halfedge first : m_mesh.halfedges())
  {
    if(!has_face(first) || fan_at[first] != none) continue;
    const Vertex v = m_mesh.target(first);
    std::vector<Halfedge> corners{first};
    bool is_bounded = false;
    const auto turn = [&](const auto& beside, const auto& next) {
      for(Halfedge h = first;;)
      {
        const Halfedge beyond = m_mesh.opposite(beside(h));
        if(!has_face(beyond)) is_bounded = is_bounded || !m_mesh.is_border(beyond);
        if(!has_face(beyond) || next(beyond) == first) return has_face(beyond);
        corners.push_back(h = next(beyond));
      }
    };
    const bool is_closed = turn([&](Halfedge h) { return m_mesh.next(h); }, [](Halfedge h) { return h; });
    if(!is_closed) turn([](Halfedge h) { return h; }, [&](Halfedge h) { return m_mesh.prev(h); });
    std::uint32_t fan = static_cast<std::uint32_t>(fans.size());
    if(!is_bounded && unbounded[v] != none)
      fan = unbounded[v];
    else
      fans.emplace_back(v, fan);
    if(!is_bounded) unbounded[v] = fan;
    for(Halfedge h : corners) fan_at[h] = fan;
  }
  std::sort(fans.begin(), fans.end()); // vertices keep their order
  std::vector<std::uint32_t> number_of(fans.size());
  Kept_corners result;
  for(const auto& [v, fan] : fans)
  {
    number_of[fan] = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.push_back(v);
  }
  for(std::uint32_t fan : fan_at) result.number_at.push_back(fan == none ? none : number_of[fan]);
  return result;
}

void Mesh_input::keep_faces(const std::vector<bool>& is_kept)
{
  const Kept_corners corners = kept_corners(is_kept);
  std::vector<Face> faces;
  std::vector<Polygon> polygons; // the first halfedge of a face remains the first
  for(Face f : m_mesh.faces())
  {
    if(!is_kept[f]) continue;
    faces.push_back(f);
    polygons.emplace_back();
    for(Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(f))) polygons.back().push_back(corners.number_at[h]);
  }
  Mesh mesh;
  std::vector<Vertex> at;
  for(Vertex v : corners.vertices) at.push_back(mesh.add_vertex(m_mesh.point(v)));
  Polygon_links(polygons, at.size()).link(mesh, polygons, at);

  std::vector<bool> is_barrier(has_barriers() ? mesh.number_of_edges() : 0, false);
  for(std::size_t i = 0; i < faces.size() && has_barriers(); ++i)
  {
    Halfedge h = m_mesh.halfedge(faces[i]);
    for(Halfedge g : mesh.halfedges_around_face(mesh.halfedge(Face(static_cast<Mesh::size_type>(i)))))
    {
      is_barrier[mesh.edge(g)] = m_is_barrier[m_mesh.edge(h)] && !mesh.is_border(mesh.edge(g));
      h = m_mesh.next(h);
    }
  }
  std::vector<std::pair<std::size_t, Vertex>> of_file;
  for(std::size_t i = 0; i < m_first_vertex.size(); ++i)
    for_each_vertex_of(i, [&](Vertex v) {
      const auto [first, last] = std::equal_range(corners.vertices.begin(), corners.vertices.end(), v);
      for(auto it = first; it != last; ++it)
        of_file.emplace_back(i, at[static_cast<std::size_t>(it - corners.vertices.begin())]);
    });
  m_first_vertex.assign(m_first_vertex.size(), Mesh::null_vertex());
  m_further_vertices.clear();
  for(const auto& [i, v] : of_file)
    if(has_vertex(i))
      m_further_vertices.emplace(i, v);
    else
      m_first_vertex[i] = v;
  m_mesh = std::move(mesh);
  m_is_barrier = std::move(is_barrier);
  m_is_region = true;
  drop_missing_barriers();
  m_parts = Surface_parts(m_mesh);
  m_box = CGAL::Bbox_3();
  for(Vertex v : m_mesh.vertices()) m_box += m_mesh.point(v).bbox();
  set_diagonal();
}

void Mesh_input::drop_missing_barriers()
{
  if(std::find(m_is_barrier.begin(), m_is_barrier.end(), true) == m_is_barrier.end()) m_is_barrier.clear();
}

void Mesh_input::set_diagonal()
{
  double square = 0;
  for(int c = 0; c < 3; ++c) square += (m_box.max(c) - m_box.min(c)) * (m_box.max(c) - m_box.min(c));
  m_diagonal = std::sqrt(square);
}

void Mesh_input::require_memory_for_faces(const std::string& path) const
{
  // Soup, mesh and unfolded mesh, without windows: measured 320 bytes on a grid with 2 million faces. The limit is lower,
  // since allocators differ, and part of the memory is already in use.
  constexpr std::uintmax_t smallest_bytes_per_triangle = 200;
  std::uintmax_t triangles = 0;
  for(const Polygon& polygon : m_soup.polygons) triangles += polygon.size() - 2;
  require_memory(quoted(path) + ", with " + counted(static_cast<std::size_t>(triangles), "triangle") + ',',
                 smallest_bytes_per_triangle * triangles);
}

void Mesh_input::measure(const std::string& path, double tolerance)
{
  for(const Polygon& polygon : m_soup.polygons)
    for(std::uint32_t v : polygon) m_box += m_soup.points[v].bbox();
  set_diagonal();
  // squares of lengths, and products of two of these, must be within the range of double
  if(!(m_diagonal < 1e70) || (m_diagonal > 0 && m_diagonal < 1e-70))
    throw Input_error(quoted(path) + ": the coordinates are too " + (m_diagonal > 1 ? "large" : "small"));
  if(m_diagonal == 0) throw Input_error(quoted(path) + ": all vertices are at the same place");
  // larger holes are no rounding, and the search for near points would compare nearly all
  if(const double most = m_diagonal / 100; tolerance > most)
    throw Input_error("--stitch-tolerance " + short_number(tolerance) + " is more than " + short_number(most) +
                      ", a hundredth of the diagonal of the bounding box of " + quoted(path));
}

bool Mesh_input::clean(Polygon& polygon)
{
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while(polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
  return polygon.size() >= 3;
}

bool Mesh_input::has_repetition(const Polygon& polygon)
{
  if(polygon.size() == 3) return polygon[0] == polygon[1] || polygon[1] == polygon[2] || polygon[2] == polygon[0];
  Polygon sorted = polygon;
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

void Mesh_input::clean_polygons(const std::string& path, Faces& faces)
{
  std::size_t repetitions = 0, first_repetition = 0, divided = 0, first_divided = 0;
  faces.names.reserve(m_soup.polygons.size());
  faces.positions.reserve(m_soup.polygons.size());
  faces.is_reversed.reserve(m_soup.polygons.size());
  for(std::size_t i = 0; i < m_soup.polygons.size(); ++i)
  {
    Polygon polygon = m_soup.polygons[i];
    const bool is_polygon = clean(polygon);
    if(polygon.size() != m_soup.polygons[i].size() && repetitions++ == 0) first_repetition = i;
    if(!is_polygon) continue;
    if(!has_repetition(polygon) && is_simple(polygon, m_soup.points))
    {
      faces.add(i, std::move(polygon));
      continue;
    }
    if(divided++ == 0) first_divided = i;
    for(Polygon& triangle : triangles_of(polygon, m_soup.points))
      if(!has_repetition(triangle)) faces.add(i, std::move(triangle));
  }
  if(repetitions != 0)
    m_remarks.push_back(counted(repetitions, "face") + " with repeated vertices cleaned (the first is face " +
                        std::to_string(first_repetition) + ")");
  if(divided != 0)
    m_remarks.push_back(counted(divided, "face") +
                        " not planar or not simple, divided into triangles all the same (the "
                        "first is face " +
                        std::to_string(first_divided) + ")");
  if(faces.names.empty()) throw Input_error(quoted(path) + ": no face has three different vertices");
}

void Mesh_input::build(const std::string& path, Faces& faces, const Border_joining& joining)
{
  faces.points = m_soup.points;
  faces.polygons = faces.names;
  std::optional<Polygon_links> links(std::in_place, faces.polygons, faces.points.size());
  const bool is_stitched = joining.is_on && stitch(*links, joining.tolerance, faces);
  const bool is_repaired = remove_degenerate_faces(path, faces);
  if(is_stitched || is_repaired) links.emplace(faces.polygons, faces.points.size());
  const std::size_t polygons_before = faces.names.size();
  const std::size_t added = make_manifold(path, faces, *links);
  if(faces.names.size() != polygons_before)
    m_remarks.push_back(counted(polygons_before - faces.names.size(), "repeated face") + " left out");
  const auto reversed = std::count(faces.is_reversed.begin(), faces.is_reversed.end(), true);
  if(reversed != 0)
    m_remarks.push_back(counted(static_cast<std::size_t>(reversed), "face") + " reversed to orient the surface");
  if(added != 0)
    m_remarks.push_back("cut where it is not an orientable manifold: " + counted(added, "vertex", "vertices") + " added");
}

bool Mesh_input::stitch(const Polygon_links& links, double tolerance, Faces& faces)
{
  Border_stitching stitching(faces.points, links.border_edges(), tolerance, [&](std::uint32_t i, std::uint32_t j) {
    return links.has_edge(i, j);
  });
  if(!stitching.is_needed()) return false;
  faces.merged.resize(faces.points.size());
  for(std::uint32_t i = 0; i < faces.merged.size(); ++i) faces.merged[i] = stitching(i);
  for(Polygon& polygon : faces.polygons)
    for(std::uint32_t& v : polygon) v = faces.merged[v];
  std::string remark = counted(stitching.number_of_pairs(), "pair") + " of border edges stitched";
  if(stitching.largest_gap() > 0) remark += ", with gaps of at most " + short_number(stitching.largest_gap());
  m_remarks.push_back(remark);
  return true;
}

bool Mesh_input::remove_degenerate_faces(const std::string& path, Faces& faces)
{
  const CGAL::Polygon_soup_repair repair = CGAL::remove_degenerate_faces_in_polygon_soup(faces.points, faces.polygons);
  if(repair.point_indices.empty()) return false;
  if(faces.polygons.empty()) throw Input_error(quoted(path) + ": no face has an area");

  if(faces.merged.empty())
  {
    faces.merged.resize(faces.points.size());
    std::iota(faces.merged.begin(), faces.merged.end(), std::uint32_t(0));
  }
  for(std::uint32_t& v : faces.merged) v = static_cast<std::uint32_t>(repair.point_indices[v]);
  Faces repaired; // with the corners of the polygons before, where these are corners of a polygon
  std::vector<bool> is_removed(faces.names.size(), true);
  for(std::size_t i = 0; i < faces.polygons.size(); ++i)
  {
    const std::size_t origin = repair.polygon_indices[i];
    is_removed[origin] = false;
    Polygon name = faces.polygons[i];
    for(std::uint32_t& v : name)
      for(std::uint32_t corner : faces.names[origin])
        if(faces.merged[corner] == v)
        {
          v = corner;
          break;
        }
    repaired.add(faces.positions[origin], std::move(name));
  }
  const auto first = std::find(is_removed.begin(), is_removed.end(), true);
  const auto removed = static_cast<std::size_t>(std::count(first, is_removed.end(), true));
  std::vector<std::string> changes;
  if(removed != 0)
    changes.push_back(counted(removed, "face") + " without area removed (the first is face " +
                      std::to_string(faces.positions[static_cast<std::size_t>(first - is_removed.begin())]) + ")");
  if(repair.merged_points != 0) changes.push_back(counted(repair.merged_points, "vertex", "vertices") + " merged");
  if(repair.shortened_faces != 0) changes.push_back(counted(repair.shortened_faces, "face") + " without spikes");
  if(repair.flipped_faces != 0)
    changes.push_back(counted(repair.flipped_faces, "vertex", "vertices") + " inserted into edges of neighbours");
  if(repair.dropped_faces != 0) changes.push_back(counted(repair.dropped_faces, "face") + " at the border dropped");
  std::string remark;
  for(const std::string& change : changes) remark += (remark.empty() ? "" : ", ") + change;
  if(!remark.empty()) m_remarks.push_back(remark);
  faces.positions = std::move(repaired.positions);
  faces.names = std::move(repaired.names);
  faces.is_reversed = std::move(repaired.is_reversed);
  return true;
}

std::size_t Mesh_input::make_manifold(const std::string& path, Faces& faces, const Polygon_links& links)
{
  if(make_mesh(faces, links)) return 0;
  drop_repeated_faces(faces);
  const std::vector<Polygon> before = faces.polygons;
  const std::size_t number_of_points = faces.points.size();
  CGAL::Polygon_mesh_processing::orient_polygon_soup(faces.points, faces.polygons);
  for(std::size_t i = 0; i < before.size(); ++i)
  {
    if(is_same(before[i], faces.polygons[i], faces.points, number_of_points)) continue;
    std::reverse(faces.names[i].begin(), faces.names[i].end());
    faces.is_reversed[i] = !faces.is_reversed[i];
  }
  if(!make_mesh(faces, Polygon_links(faces.polygons, faces.points.size())))
    throw Input_error(quoted(path) + ": the faces cannot be made a manifold");
  return faces.points.size() - number_of_points - find_copies(faces, before, number_of_points);
}

std::size_t Mesh_input::find_copies(Faces& faces, const std::vector<Polygon>& before, std::size_t number_of_points)
{
  using Directed_edge = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<std::uint32_t> original(faces.points.size());
  for(std::uint32_t i = 0; i < original.size(); ++i) original[i] = i;
  std::vector<Directed_edge> edges;
  for(std::size_t i = 0; i < before.size(); ++i)
  {
    Polygon polygon = before[i]; // with the corners of the new one, as they were called
    const bool is_reversed = !is_same(polygon, faces.polygons[i], faces.points, number_of_points);
    if(is_reversed) std::reverse(polygon.begin(), polygon.end());
    for(std::size_t k = 0; k < polygon.size(); ++k)
    {
      original[faces.polygons[i][k]] = polygon[k];
      edges.emplace_back(polygon[k], polygon[(k + 1) % polygon.size()]);
    }
  }
  // two faces with the same direction along an edge: the edge is cut
  std::sort(edges.begin(), edges.end());
  std::vector<bool> is_cut(number_of_points, false);
  for(std::size_t i = 1; i < edges.size(); ++i)
    if(edges[i] == edges[i - 1]) is_cut[edges[i].first] = is_cut[edges[i].second] = true;
  const std::size_t old_copies = faces.copies.size();
  for(std::size_t i = number_of_points; i < original.size(); ++i)
    if(original[i] != i && !is_cut[original[i]]) faces.copies.emplace_back(original[i], static_cast<std::uint32_t>(i));
  return faces.copies.size() - old_copies;
}

bool Mesh_input::is_same(const Polygon& before, const Polygon& after, const std::vector<Point>& points,
                         std::size_t number_of_points)
{
  for(std::size_t k = 0; k < before.size(); ++k)
    if(after[k] != before[k] && !(after[k] >= number_of_points && points[after[k]] == points[before[k]])) return false;
  return true;
}

bool Mesh_input::make_mesh(Faces& faces, const Polygon_links& links)
{
  std::vector<bool> used(faces.points.size(), false);
  std::size_t corners = 0;
  for(const Polygon& polygon : faces.polygons)
  {
    for(std::uint32_t v : polygon) used[v] = true;
    corners += polygon.size();
  }
  if(!links.is_manifold()) return false;
  m_mesh = Mesh();
  m_mesh.reserve(static_cast<Mesh::size_type>(faces.points.size()), static_cast<Mesh::size_type>(corners / 2 + 16),
                 static_cast<Mesh::size_type>(faces.polygons.size()));
  faces.vertices.assign(faces.points.size(), Mesh::null_vertex());
  for(std::size_t i = 0; i < faces.points.size(); ++i)
    if(used[i]) faces.vertices[i] = m_mesh.add_vertex(faces.points[i]);
  links.link(m_mesh, faces.polygons, faces.vertices);
  return !has_shared_vertex(m_mesh);
}

void Mesh_input::drop_repeated_faces(Faces& faces)
{
  std::set<Polygon> seen;
  std::size_t kept = 0;
  for(std::size_t i = 0; i < faces.polygons.size(); ++i)
  {
    Polygon sorted = faces.polygons[i];
    std::sort(sorted.begin(), sorted.end());
    if(!seen.insert(std::move(sorted)).second) continue;
    std::swap(faces.polygons[kept], faces.polygons[i]);
    std::swap(faces.names[kept], faces.names[i]);
    faces.is_reversed[kept] = faces.is_reversed[i];
    faces.positions[kept++] = faces.positions[i];
  }
  faces.polygons.resize(kept);
  faces.names.resize(kept);
  faces.is_reversed.resize(kept);
  faces.positions.resize(kept);
}

void Mesh_input::map_vertices(const Faces& faces)
{
  std::set<std::pair<std::size_t, Vertex>> known;
  m_first_vertex.assign(m_soup.points.size(), Mesh::null_vertex());
  for(std::size_t i = 0; i < faces.names.size(); ++i)
    for(std::size_t k = 0; k < faces.names[i].size(); ++k)
    {
      const std::size_t file_vertex = faces.names[i][k];
      const Vertex vertex = faces.vertices[faces.polygons[i][k]];
      Vertex& first = m_first_vertex[file_vertex];
      if(first == Mesh::null_vertex())
        first = vertex;
      else if(first != vertex && known.emplace(file_vertex, vertex).second)
        m_further_vertices.emplace(file_vertex, vertex);
    }
  if(faces.merged.empty()) return;
  // vertices that only removed faces have, merged with others
  std::multimap<std::uint32_t, std::size_t> alone; // by the point with which they were merged
  for(std::size_t i = 0; i < faces.merged.size(); ++i)
    if(!has_vertex(i)) alone.emplace(faces.merged[i], i);
  std::vector<std::pair<std::size_t, Vertex>> found;
  for(std::size_t i = 0; i < faces.merged.size(); ++i)
    for(auto [it, end] = alone.equal_range(faces.merged[i]); it != end; ++it)
      for_each_vertex_of(i, [&, file_vertex = it->second](Vertex v) {
        if(known.emplace(file_vertex, v).second) found.emplace_back(file_vertex, v);
      });
  for(const auto& [file_vertex, v] : found)
    if(has_vertex(file_vertex))
      m_further_vertices.emplace(file_vertex, v);
    else
      m_first_vertex[file_vertex] = v;
}

void Mesh_input::divide(const std::vector<Halfedge>& corners)
{
  std::vector<Point> points;
  for(Halfedge h : corners) points.push_back(m_mesh.point(m_mesh.target(h)));
  const Polygon_division division(points);
  // the part of the polygon from corner i to corner j, and its halfedge that ends at i
  struct Part
  {
    std::size_t i, j;
    Halfedge at_i;
  };
  std::vector<Part> parts{{0, corners.size() - 1, corners[0]}};
  while(!parts.empty())
  {
    const Part part = parts.back();
    parts.pop_back();
    const std::size_t k = division.third(part.i, part.j);
    Halfedge at_k = corners[k];
    if(k - part.i >= 2)
    {
      at_k = CGAL::Euler::split_face(part.at_i, corners[k], m_mesh);
      parts.push_back({part.i, k, m_mesh.opposite(at_k)});
    }
    if(part.j - k >= 2) parts.push_back({k, part.j, m_mesh.opposite(CGAL::Euler::split_face(at_k, corners[part.j], m_mesh))});
  }
}

void Mesh_input::triangulate(const std::string& path, const Faces& faces)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<Face> others;
  for(Face f : m_mesh.faces())
    if(!CGAL::is_triangle(m_mesh.halfedge(f), m_mesh)) others.push_back(f);
  if(others.empty()) return;
  for(Face f : others)
  {
    std::vector<Halfedge> corners;
    for(Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(f))) corners.push_back(h);
    if(corners.size() <= largest_divided_polygon)
      divide(corners);
    else if(!PMP::triangulate_face(f, m_mesh))
      throw Input_error(quoted(path) + ": face " + std::to_string(faces.positions[f]) + " cannot be triangulated");
  }
  m_remarks.push_back(counted(others.size(), "face") + " with more than three vertices triangulated");
}

Mesh_input::Vertex_pairs Mesh_input::pairs_of_vertices(const Faces& faces)
{
  Vertex_pairs pairs;
  for(const auto& copy : faces.copies)
    if(faces.vertices[copy.first] != Mesh::null_vertex() && faces.vertices[copy.second] != Mesh::null_vertex())
      pairs.emplace_back(faces.vertices[copy.first], faces.vertices[copy.second]);
  return pairs;
}

void Mesh_input::renumber_vertices(const std::vector<Vertex>& new_vertex)
{
  for(Vertex& v : m_first_vertex)
    if(v != Mesh::null_vertex()) v = new_vertex[v];
  for(auto& entry : m_further_vertices) entry.second = new_vertex[entry.second];
}

void Mesh_input::join(const std::string& path, const Vertex_pairs& copies)
{
  if(copies.empty()) return;
  std::vector<Vertex> new_vertex;
  const std::vector<Vertex> shared = join_vertices(m_mesh, copies, new_vertex);
  renumber_vertices(new_vertex);
  // a vertex of the file may now have the same vertex of the mesh several times
  std::set<std::pair<std::size_t, Vertex>> known;
  for(auto it = m_further_vertices.begin(); it != m_further_vertices.end();)
  {
    const bool is_known = m_first_vertex[it->first] == it->second || !known.emplace(it->first, it->second).second;
    it = is_known ? m_further_vertices.erase(it) : std::next(it);
  }
  if(shared.empty()) return;
  std::size_t first = m_soup.points.size();
  for(std::size_t i = m_soup.points.size(); i-- > 0;)
    for_each_vertex_of(i, [&](Vertex v) { first = std::binary_search(shared.begin(), shared.end(), v) ? i : first; });
  m_warning = quoted(path) + ": " + counted(shared.size(), "vertex is", "vertices are") +
              " shared by fans of faces that have no edge in common there (the first is vertex " + std::to_string(first) +
              "): paths pass through such a vertex from one fan into the others";
}

} // namespace geodesic_offset
