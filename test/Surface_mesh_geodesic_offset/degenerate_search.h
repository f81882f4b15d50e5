// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Files of good meshes to which clusters of degenerate faces are added, read by the reader of the programs: all must be read,
// and the distances must be those of the good mesh.

#ifndef GEODESIC_OFFSET_TEST_DEGENERATE_SEARCH_H
#define GEODESIC_OFFSET_TEST_DEGENERATE_SEARCH_H

#include "common/mesh_input.h"
#include "common/soup_reader.h"
#include "generated_curved_meshes.h"
#include "generated_flat_meshes.h"
#include "geodesic_types.h"
#include "search_cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// Faces, and added faces without area. Adjacent faces have an edge with the same vertices.
class Degenerate_clusters
{
public:
  typedef std::array<std::size_t, 3> Triangle;

  /// only_floats: new points are at dyadic parameters, and have coordinates in single precision, so that they are exactly on edges.
  Degenerate_clusters(const Soup& good, bool only_floats, Random& random)
    : points(good.points), random_(random), only_floats_(only_floats)
  {
    for (const auto& t : good.triangles) triangles.push_back({t[0], t[1], t[2]});
    is_flat.assign(triangles.size(), false);
    is_loose_.assign(triangles.size(), false);
    on_surface.assign(points.size(), true);
    is_displaced.assign(points.size(), false);
  }

  std::vector<Point_3> points;
  std::vector<Triangle> triangles;
  std::vector<bool> is_flat;      // faces that were added
  std::vector<bool> on_surface;   // vertices that are points of the surface, not only of loose faces
  std::vector<bool> is_displaced; // vertices beside the place of a vertex by rounding
  std::map<std::string, std::size_t> added;

  /// Adds a cluster of a random kind, near earlier ones in half of the cases; returns whether it was possible.
  bool add()
  {
    switch (uniform_index(random_, 9))
    {
    case 0:
    case 1: return count("cap", add_cap());
    case 2:
    case 3: return count("collapsed edge", split_vertex(false));
    case 4: return count("collapsed ring", split_vertex(true));
    case 5: return count("divided", divide_flat_face());
    case 6: return count("flipped", flip_flat_edge());
    case 7: return count("fin", add_fin());
    default: return count("stray", add_stray());
    }
  }

  /// The faces, some of the flat ones joined with a neighbour.
  std::vector<std::vector<std::size_t>> polygons()
  {
    std::vector<std::vector<std::size_t>> result;
    std::vector<bool> is_joined(triangles.size(), false);
    for (std::size_t f = 0; f < triangles.size(); ++f)
    {
      if (!is_flat[f] || is_joined[f] || uniform(random_) < 0.5) continue;
      const std::size_t k = uniform_index(random_, 3);
      const std::size_t a = triangles[f][k], c = triangles[f][(k + 1) % 3], b = triangles[f][(k + 2) % 3], g = face_with(c, a);
      if (g == triangles.size() || is_joined[g] || number_of_faces_at_edge(a, c) != 2 || vertex_after(g, a) == b) continue;
      // a fold has several triangulations, with different parts at the places of its points
      if (is_flat[g] && !is_without_fold({a, vertex_after(g, a), c, b})) continue;
      is_joined[f] = is_joined[g] = true;
      result.push_back({a, vertex_after(g, a), c, b});
    }
    for (std::size_t f = 0; f < triangles.size(); ++f)
      if (!is_joined[f]) result.emplace_back(triangles[f].begin(), triangles[f].end());
    return result;
  }

private:
  bool count(const char* kind, bool is_added)
  {
    if (is_added) ++added[kind];
    return is_added;
  }

  std::size_t draw_face()
  {
    const std::size_t f = uniform_index(random_, triangles.size());
    if (uniform(random_) < 0.5) return f;
    const std::size_t first = uniform_index(random_, triangles.size()); // a flat one, if there is any
    for (std::size_t i = 0; i < triangles.size(); ++i)
      if (is_flat[(first + i) % triangles.size()]) return (first + i) % triangles.size();
    return f;
  }

  std::size_t add_point(const Point_3& p, bool is_on_surface)
  {
    points.push_back(p);
    on_surface.push_back(is_on_surface);
    is_displaced.push_back(false);
    return points.size() - 1;
  }

  void add_triangle(const Triangle& t, bool flat, bool is_loose)
  {
    triangles.push_back(t);
    is_flat.push_back(flat);
    is_loose_.push_back(is_loose);
  }

  bool is_edge_on_surface(std::size_t v, std::size_t w) const
  {
    for (std::size_t f = 0; f < triangles.size(); ++f)
      if (!is_loose_[f] && has_edge(f, v, w)) return true;
    return false;
  }

  bool has_edge(std::size_t f, std::size_t v, std::size_t w) const
  {
    const Triangle& t = triangles[f];
    return std::count(t.begin(), t.end(), v) != 0 && std::count(t.begin(), t.end(), w) != 0;
  }

  /// The face with the directed edge; the number of faces if there is none, or several.
  std::size_t face_with(std::size_t from, std::size_t to) const
  {
    std::size_t found = triangles.size(), number = 0;
    for (std::size_t f = 0; f < triangles.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        if (triangles[f][k] == from && triangles[f][(k + 1) % 3] == to)
        {
          found = f;
          ++number;
        }
    return number == 1 ? found : triangles.size();
  }

  std::size_t number_of_faces_at_edge(std::size_t v, std::size_t w) const
  {
    std::size_t number = 0;
    for (std::size_t f = 0; f < triangles.size(); ++f) number += has_edge(f, v, w) ? 1 : 0;
    return number;
  }

  /// A point between two others, not too near to them; false if rounding to single precision would move it.
  bool point_between(std::size_t v, std::size_t w, Point_3& p)
  {
    static const double fractions[] = {0.5, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875};
    if (CGAL::squared_distance(points[v], points[w]) < 1e-20) return false;
    const double t = only_floats_ || uniform(random_) < 0.3 ? fractions[uniform_index(random_, 7)] : uniform(random_, 0.1, 0.9);
    p = points[v] + t * (points[w] - points[v]);
    return !only_floats_ || is_float(p);
  }

  static bool is_float(const Point_3& p)
  {
    for (int c = 0; c < 3; ++c)
      if (double(float(p[c])) != p[c]) return false;
    return true;
  }

  /// A flat face on an edge: one of the faces there keeps the edge, the other one is divided at a point of it.
  bool add_cap()
  {
    const std::size_t f = draw_face(), k = uniform_index(random_, 3);
    const std::size_t a = triangles[f][k], c = triangles[f][(k + 1) % 3], x = triangles[f][(k + 2) % 3];
    if (face_with(a, c) != f) return false;
    if (points[a] == points[c] || number_of_faces_at_edge(a, c) > 2) return false;
    Point_3 p;
    if (!point_between(a, c, p)) return false;
    const bool on_border = number_of_faces_at_edge(a, c) == 1;
    const bool is_on_surface = is_edge_on_surface(a, c);
    const std::size_t b = add_point(p, is_on_surface);
    if (on_border && uniform(random_) < 0.5) // outside f
    {
      add_triangle({c, a, b}, true, !is_on_surface);
      return true;
    }
    triangles[f] = {a, b, x};
    add_triangle({b, c, x}, is_flat[f], is_loose_[f]);
    add_triangle({a, c, b}, true, !is_on_surface);
    return true;
  }

  /// A vertex at the place of another one; in double precision sometimes beside it by rounding, or, at coordinates that are zero, by
  /// numbers whose squares underflow.
  std::size_t add_copy(std::size_t v)
  {
    const std::size_t copy = add_point(points[v], on_surface[v]);
    is_displaced[copy] = is_displaced[v];
    if (only_floats_ || uniform(random_) < 0.7) return copy;
    std::array<double, 3> c;
    for (int k = 0; k < 3; ++k)
    {
      const double x = points[v][k];
      c[std::size_t(k)] = x == 0 ? uniform(random_, -1, 1) * log_uniform(random_, -300, -150)
                                 : x * (1 + std::floor(uniform(random_, -2, 3)) * std::numeric_limits<double>::epsilon());
    }
    points[copy] = Point_3(c[0], c[1], c[2]);
    is_displaced[copy] = true;
    return copy;
  }

  /// Faces around a vertex, counterclockwise; empty if they are no fan.
  std::vector<std::size_t> fan(std::size_t v) const
  {
    std::map<std::size_t, std::pair<std::size_t, std::size_t>> from; // next vertex around v: the face and the vertex after it
    std::set<std::size_t> ends;
    for (std::size_t f = 0; f < triangles.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        if (triangles[f][k] == v)
        {
          if (!from.emplace(triangles[f][(k + 1) % 3], std::make_pair(f, triangles[f][(k + 2) % 3])).second) return {};
          if (!ends.insert(triangles[f][(k + 2) % 3]).second) return {};
        }
    if (from.empty()) return {};
    std::size_t first = from.begin()->first;
    for (const auto& entry : from)
      if (ends.count(entry.first) == 0) first = entry.first;
    std::vector<std::size_t> faces;
    for (std::size_t w = first; from.count(w) != 0 && faces.size() < from.size();)
    {
      faces.push_back(from[w].first);
      w = from[w].second;
    }
    return faces.size() == from.size() ? faces : std::vector<std::size_t>();
  }

  std::size_t vertex_after(std::size_t f, std::size_t v) const
  {
    return triangles[f][(std::size_t(std::find(triangles[f].begin(), triangles[f].end(), v) - triangles[f].begin()) + 1) % 3];
  }
  std::size_t vertex_before(std::size_t f, std::size_t v) const
  {
    return triangles[f][(std::size_t(std::find(triangles[f].begin(), triangles[f].end(), v) - triangles[f].begin()) + 2) % 3];
  }

  /// A second vertex at the same place for some of the faces around a vertex, and flat faces between; or a vertex for each face.
  bool split_vertex(bool is_ring)
  {
    const std::size_t v = triangles[draw_face()][uniform_index(random_, 3)];
    const std::vector<std::size_t> faces = fan(v);
    const std::size_t n = faces.size();
    if (n < 3) return false;
    const bool is_closed = vertex_after(faces.front(), v) == vertex_before(faces.back(), v);
    if (is_ring)
    {
      // the poles of spheres of longitudes and latitudes
      std::vector<std::size_t> copies{v};
      for (std::size_t i = 1; i < n; ++i) copies.push_back(add_copy(v));
      std::vector<Triangle> flat;
      std::vector<bool> is_loose;
      for (std::size_t i = is_closed ? 0 : 1; i < n; ++i)
      {
        const std::size_t x = vertex_after(faces[i], v);
        flat.push_back({copies[(i + n - 1) % n], x, copies[i]});
        is_loose.push_back(!is_edge_on_surface(v, x));
      }
      for (std::size_t i = 0; i < flat.size(); ++i) add_triangle(flat[i], true, is_loose[i]);
      for (std::size_t i = 1; i < n; ++i) std::replace(triangles[faces[i]].begin(), triangles[faces[i]].end(), v, copies[i]);
      return true;
    }
    const std::size_t begin = is_closed || uniform(random_) < 0.5 ? 0 : 1 + uniform_index(random_, n - 1);
    const std::size_t size = 1 + uniform_index(random_, n - 1);
    const std::size_t end = begin == 0 ? size : n; // on the border, the faces up to one of its ends
    const std::size_t copy = add_copy(v);
    const std::size_t x = vertex_after(faces[begin], v), y = vertex_before(faces[end - 1], v);
    const bool is_x_loose = !is_edge_on_surface(v, x), is_y_loose = !is_edge_on_surface(v, y);
    for (std::size_t i = begin; i < end; ++i) std::replace(triangles[faces[i]].begin(), triangles[faces[i]].end(), v, copy);
    if (is_closed || begin != 0) add_triangle({copy, v, x}, true, is_x_loose);
    if (is_closed || end != n) add_triangle({v, copy, y}, true, is_y_loose);
    return true;
  }

  /// A vertex on the line of a flat face, inside it.
  bool divide_flat_face()
  {
    const std::size_t f = draw_face();
    if (!is_flat[f]) return false;
    const Triangle t = triangles[f];
    const std::size_t k = uniform_index(random_, 3);
    Point_3 p;
    if (points[t[k]] == points[t[(k + 1) % 3]] || !point_between(t[k], t[(k + 1) % 3], p)) return false;
    const std::size_t b = add_point(p, !is_loose_[f]);
    triangles[f] = {t[0], t[1], b};
    add_triangle({t[1], t[2], b}, true, is_loose_[f]);
    add_triangle({t[2], t[0], b}, true, is_loose_[f]);
    return true;
  }

  /// Whether the points of a closed polygon are different points of a line, and the polygon goes forth and back once: then all its
  /// triangulations have the same connection.
  bool is_without_fold(const std::array<std::size_t, 4>& polygon) const
  {
    std::size_t turns = 0;
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Vector_3 u = points[polygon[(k + 1) % 4]] - points[polygon[k]],
                     v = points[polygon[(k + 2) % 4]] - points[polygon[(k + 1) % 4]];
      if (u.squared_length() < 1e-20 || (u + v).squared_length() < 1e-20) return false;
      if (CGAL::cross_product(u, v).squared_length() > 1e-20 * u.squared_length() * v.squared_length()) return false;
      turns += u * v < 0 ? 1 : 0;
    }
    return turns == 2;
  }

  /// Another diagonal of two flat faces on one line.
  bool flip_flat_edge()
  {
    const std::size_t f = draw_face(), k = uniform_index(random_, 3);
    if (!is_flat[f]) return false;
    const std::size_t a = triangles[f][k], c = triangles[f][(k + 1) % 3], b = triangles[f][(k + 2) % 3];
    const std::size_t g = face_with(c, a);
    if (g == triangles.size() || !is_flat[g] || number_of_faces_at_edge(a, c) != 2) return false;
    const std::size_t x = vertex_after(g, a);
    if (x == b || number_of_faces_at_edge(b, x) != 0 || !is_without_fold({a, x, c, b})) return false;
    triangles[f] = {a, x, b};
    triangles[g] = {b, x, c};
    is_loose_[f] = is_loose_[g] = is_loose_[f] || is_loose_[g];
    return true;
  }

  /// Flat faces beyond the surface: on a border edge, or two on an inner edge, which then has four faces.
  bool add_fin()
  {
    const std::size_t f = draw_face(), k = uniform_index(random_, 3);
    const std::size_t a = triangles[f][k], c = triangles[f][(k + 1) % 3];
    if (points[a] == points[c]) return false;
    const std::size_t faces = number_of_faces_at_edge(a, c);
    if (faces > 2) return false;
    Point_3 p;
    const bool is_on_edge = uniform(random_) < 0.5;
    if (is_on_edge)
    {
      if (!point_between(a, c, p)) return false;
    }
    else p = points[c] + (points[c] - points[a]);
    if (only_floats_ && !is_float(p)) return false;
    const bool is_loose = !is_on_edge || !is_edge_on_surface(a, c);
    const std::size_t b = add_point(p, !is_loose);
    add_triangle({c, a, b}, true, is_loose);
    if (faces == 2) add_triangle({a, c, b}, true, is_loose);
    return true;
  }

  /// A face without area that has no edge of another face: at one point, on a segment, or as a bridge between two vertices.
  bool add_stray()
  {
    const std::size_t v = uniform_index(random_, points.size()), w = uniform_index(random_, points.size());
    const std::size_t kind = uniform_index(random_, 3);
    Point_3 p;
    if (kind != 0 && (points[v] == points[w] || !point_between(v, w, p))) return false;
    if (kind == 2)
    {
      if (number_of_faces_at_edge(v, w) != 0) return false;
      add_triangle({v, w, add_point(p, false)}, true, true);
      return true;
    }
    Triangle t;
    t[0] = add_point(points[v], false);
    t[1] = add_point(kind == 0 ? points[v] : points[w], false);
    t[2] = add_point(kind == 0 ? points[v] : p, false);
    add_triangle(t, true, true);
    return true;
  }

  Random& random_;
  bool only_floats_;
  std::vector<bool> is_loose_; // flat faces that are nowhere between faces with an area: no part of the surface
};

/// A mesh file in memory, and the vertices of the file at each vertex of the soup, if the format has numbered vertices.
struct Degenerate_file
{
  std::string name, bytes;
};

/// Writes polygons in a format; soup: each polygon has its own vertices.
class Degenerate_writer
{
public:
  typedef std::vector<std::vector<std::size_t>> Polygons;

  /// number of formats; those from number_of_double_formats on have single precision
  static constexpr std::size_t number_of_formats = 9, number_of_double_formats = 5;

  Degenerate_writer(const std::vector<Point_3>& points, const Polygons& polygons, bool as_soup)
  {
    if (!as_soup)
    {
      points_ = points;
      polygons_ = polygons;
      return;
    }
    for (const auto& polygon : polygons)
    {
      polygons_.emplace_back();
      for (const std::size_t v : polygon)
      {
        polygons_.back().push_back(points_.size());
        points_.push_back(points[v]);
      }
    }
  }

  Degenerate_file file(std::size_t format) const
  {
    switch (format)
    {
    case 0: return {"file.off", off_text()};
    case 1: return {"file.obj", obj()};
    case 2: return {"file.ply", ply("ascii", true)};
    case 3: return {"file.ply", ply("binary_little_endian", true)};
    case 4: return {"file.stl", stl_text()};
    case 5: return {"file.off", off_binary()};
    case 6: return {"file.ply", ply("binary_big_endian", false)};
    case 7: return {"file.ply", ply("ascii", false)};
    default: return {"file.stl", stl_binary()};
    }
  }

private:
  template <class Number>
  static std::string bytes_of(Number number, bool is_big_endian = false)
  {
    char raw[sizeof(Number)];
    std::memcpy(raw, &number, sizeof(Number));
    if (is_big_endian) std::reverse(raw, raw + sizeof(Number));
    return std::string(raw, sizeof(Number));
  }

  static std::ostringstream stream()
  {
    std::ostringstream out;
    out.precision(17);
    return out;
  }

  std::string off_text() const
  {
    std::ostringstream out = stream();
    out << "OFF\n" << points_.size() << ' ' << polygons_.size() << " 0\n";
    for (const Point_3& p : points_) out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (const auto& polygon : polygons_)
    {
      out << polygon.size();
      for (const std::size_t v : polygon) out << ' ' << v;
      out << '\n';
    }
    return out.str();
  }

  std::string off_binary() const
  {
    std::string out = "OFF BINARY\n";
    for (const std::size_t n : {points_.size(), polygons_.size(), std::size_t(0)}) out += bytes_of(std::int32_t(n), true);
    for (const Point_3& p : points_)
      for (int c = 0; c < 3; ++c) out += bytes_of(float(p[c]), true);
    for (const auto& polygon : polygons_)
    {
      out += bytes_of(std::int32_t(polygon.size()), true);
      for (const std::size_t v : polygon) out += bytes_of(std::int32_t(v), true);
      out += bytes_of(std::int32_t(0), true);
    }
    return out;
  }

  std::string obj() const
  {
    std::ostringstream out = stream();
    for (const Point_3& p : points_) out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (const auto& polygon : polygons_)
    {
      out << 'f';
      for (const std::size_t v : polygon) out << ' ' << v + 1;
      out << '\n';
    }
    return out.str();
  }

  std::string ply(const std::string& format, bool is_double) const
  {
    const bool is_text = format == "ascii", is_big_endian = format == "binary_big_endian";
    const std::string type = is_double ? "double" : "float";
    std::ostringstream out = stream();
    out << "ply\nformat " << format << " 1.0\nelement vertex " << points_.size() << '\n';
    for (const char* c : {"x", "y", "z"}) out << "property " << type << ' ' << c << '\n';
    out << "element face " << polygons_.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Point_3& p : points_)
    {
      for (int c = 0; c < 3; ++c)
        if (is_text) out << p[c] << ' ';
        else if (is_double) out << bytes_of(p[c], is_big_endian);
        else out << bytes_of(float(p[c]), is_big_endian);
      if (is_text) out << '\n';
    }
    for (const auto& polygon : polygons_)
    {
      if (is_text) out << polygon.size();
      else out << char(polygon.size());
      for (const std::size_t v : polygon)
        if (is_text) out << ' ' << v;
        else out << bytes_of(std::int32_t(v), is_big_endian);
      if (is_text) out << '\n';
    }
    return out.str();
  }

  std::string stl_text() const
  {
    std::ostringstream out = stream();
    out << "solid a\n";
    for (const auto& polygon : polygons_)
    {
      out << "facet normal 0 0 0\nouter loop\n";
      for (const std::size_t v : polygon)
        out << "vertex " << points_[v].x() << ' ' << points_[v].y() << ' ' << points_[v].z() << '\n';
      out << "endloop\nendfacet\n";
    }
    out << "endsolid a\n";
    return out.str();
  }

  std::string stl_binary() const
  {
    std::string out(80, ' ');
    out += bytes_of(std::uint32_t(polygons_.size()));
    for (const auto& polygon : polygons_)
    {
      out += std::string(12, '\0');
      for (const std::size_t v : polygon)
        for (int c = 0; c < 3; ++c) out += bytes_of(float(points_[v][c]));
      out += std::string(2, '\0');
    }
    return out;
  }

  std::vector<Point_3> points_;
  Polygons polygons_;
};

/// Results of the files of one kind.
struct Degenerate_counts
{
  std::size_t files = 0, flat_faces = 0, refused = 0, wrong = 0, missing = 0;
  double worst = 0; // error of a distance, relative to the diagonal of the bounding box
};

class Degenerate_search
{
public:
  static constexpr double tolerance = 1e-12; // of a distance, relative to the diagonal of the bounding box

  /// Writes up to `printed` faults to `log`, with the file if `describes`.
  Degenerate_search(std::ostream& log, std::size_t printed, std::size_t clusters = 0, bool describes = false)
    : log_(log), printed_(printed), number_of_clusters_(clusters), describes_(describes)
  {
  }

  /// Runs the file of a seed.
  void run(unsigned seed)
  {
    random_.seed(seed);
    for (int i = 0; i < 8; ++i) random_();
    seed_ = seed;
    const std::size_t kind = uniform_index(random_, number_of_meshes);
    only_floats_ = uniform(random_) < 0.5;
    Soup soup = good_mesh(kind);
    if (only_floats_)
    {
      // few digits, so that points of edges at dyadic parameters have single precision
      for (Point_3& p : soup.points) p = Point_3(rounded(p.x()), rounded(p.y()), rounded(p.z()));
      if (!is_good(soup)) return run(seed + 0x10000000u);
    }
    else soup = rotated(std::move(soup), static_cast<unsigned>(random_()));
    const Generated_mesh<Surface_mesh> data(soup);
    diagonal_ = bounding_box_diagonal(soup.points);
    std::vector<std::size_t> sources{uniform_index(random_, soup.points.size())};
    if (uniform(random_) < 0.5) sources.push_back(uniform_index(random_, soup.points.size()));
    Geodesic geodesic(data.mesh);
    for (const std::size_t v : sources) geodesic.add_source_point(data.vertices[v]);
    geodesic.build(CGAL::parameters::keep_windows(true));

    Degenerate_clusters clusters(soup, only_floats_, random_);
    std::size_t most = uniform(random_) < 0.5 ? 1 + uniform_index(random_, 3) : 1 + uniform_index(random_, 40);
    if (uniform(random_) < 0.02) most *= 5;
    if (number_of_clusters_ != 0) most = (std::min)(most, number_of_clusters_);
    for (std::size_t i = 0, tries = 0; i < most && tries < 20 * most; ++tries) i += clusters.add() ? 1 : 0;
    check(kind, data, geodesic, sources, clusters);
  }

  const std::map<std::string, Degenerate_counts>& counts() const { return counts_; }
  const std::map<std::string, std::size_t>& added() const { return added_; }

private:
  static constexpr std::size_t number_of_meshes = 12;

  Soup good_mesh(std::size_t kind)
  {
    const std::size_t n = 1 + uniform_index(random_, 4);
    const unsigned seed = static_cast<unsigned>(random_());
    switch (kind)
    {
    case 0: return with_noise(planar_grid(n, n + 1, Diagonals::random, 1, 0.2, seed), 0.3, seed);
    case 1: return planar_grid(n, n, Diagonals::random, 1, 0.2, seed);
    case 2: return cube_grid(n);
    case 3: return torus(3 + n, 3 + n);
    case 4: return with_noise(icosphere(n % 2), 0.1, seed, 0.1);
    case 5: return tube(3 + n, n, 1, 0.7);
    case 6: return saddle_fan(3 + n);
    case 7: return l_shape(n, n, seed);
    case 8: return with_noise(cube_grid(2), 0.2, seed, 0.1);
    case 9: return two_parts(planar_grid(n, n), cube_grid(1));
    case 10: return single_face();
    default: return with_noise(planar_grid(6, 5, Diagonals::random, 1, 0.2, seed), 0.3, seed);
    }
  }

  static Soup single_face()
  {
    Soup soup;
    soup.points = {Point_3(0, 0, 0), Point_3(1, 0, 0.25), Point_3(0, 1, 0.5)};
    soup.add_triangle({0, 1, 2});
    return soup;
  }

  static Soup two_parts(Soup soup, const Soup& other)
  {
    const std::size_t n = soup.points.size();
    for (const Point_3& p : other.points) soup.points.push_back(p + Vector_3(0.25, 0.5, 8));
    for (const auto& t : other.triangles) soup.add_triangle({t[0] + n, t[1] + n, t[2] + n});
    return soup;
  }

  static double rounded(double x) { return std::round(x * 256) / 256; }

  static bool is_good(const Soup& soup)
  {
    for (const auto& t : soup.triangles)
    {
      const Point_3 &p = soup.points[t[0]], &q = soup.points[t[1]], &r = soup.points[t[2]];
      const double longest =
        (std::max)({CGAL::squared_distance(p, q), CGAL::squared_distance(q, r), CGAL::squared_distance(r, p)});
      if (!(CGAL::cross_product(q - p, r - p).squared_length() > 1e-4 * longest * longest)) return false;
    }
    return true;
  }

  static double bounding_box_diagonal(const std::vector<Point_3>& points)
  {
    CGAL::Bbox_3 box;
    for (const Point_3& p : points) box += p.bbox();
    return std::sqrt(CGAL::square(box.x_span()) + CGAL::square(box.y_span()) + CGAL::square(box.z_span()));
  }

  void check(std::size_t kind, const Generated_mesh<Surface_mesh>& data, const Geodesic& geodesic,
             const std::vector<std::size_t>& sources, Degenerate_clusters& clusters)
  {
    const bool as_soup = uniform(random_) < 0.4;
    const std::size_t formats =
      only_floats_ ? Degenerate_writer::number_of_formats : Degenerate_writer::number_of_double_formats;
    const std::size_t format = uniform_index(random_, formats);
    Degenerate_writer::Polygons polygons;
    const bool is_stl = format == 4 || format == 8;
    if (!is_stl && uniform(random_) < 0.3) polygons = clusters.polygons();
    else
      for (const auto& t : clusters.triangles) polygons.emplace_back(t.begin(), t.end());
    shuffle(polygons);
    const Degenerate_file file = Degenerate_writer(clusters.points, polygons, as_soup).file(format);
    const std::string extension = file.name.substr(4);
    const std::string name = std::string(only_floats_ ? "float" : "double") + (as_soup ? ", soup, " : ", glued, ") + extension;
    Degenerate_counts& counts = counts_[name];
    ++counts.files;
    for (const auto& entry : clusters.added) added_[entry.first] += entry.second;
    counts.flat_faces += std::size_t(std::count(clusters.is_flat.begin(), clusters.is_flat.end(), true));
    try
    {
      geodesic_offset::Soup read = geodesic_offset::parse_soup(geodesic_offset::mesh_format(file.name), file.name, file.bytes);
      const geodesic_offset::Mesh_input input(file.name, std::move(read), geodesic_offset::Border_joining{});
      compare(data, geodesic, sources, clusters, input, as_soup || is_stl, counts, file);
    }
    catch (const std::exception& e)
    {
      ++counts.refused;
      fault(file, std::string("refused: ") + e.what());
    }
    (void)kind;
  }

  void shuffle(Degenerate_writer::Polygons& polygons)
  {
    for (std::size_t i = polygons.size(); i > 1; --i) std::swap(polygons[i - 1], polygons[uniform_index(random_, i)]);
    for (auto& polygon : polygons)
      std::rotate(polygon.begin(), polygon.begin() + std::ptrdiff_t(uniform_index(random_, polygon.size())), polygon.end());
    if (uniform(random_) < 0.8) return;
    for (auto& polygon : polygons)
      if (uniform(random_) < 0.3) std::reverse(polygon.begin(), polygon.end());
  }

  /// Compares all vertices of the file at the place of a vertex of the clusters.
  void compare(const Generated_mesh<Surface_mesh>& data, const Geodesic& geodesic, const std::vector<std::size_t>& sources,
               const Degenerate_clusters& clusters, const geodesic_offset::Mesh_input& input, bool has_own_vertices,
               Degenerate_counts& counts, const Degenerate_file& file)
  {
    std::multimap<Point_3, std::size_t> at;
    for (std::size_t i = 0; i < input.soup().points.size(); ++i)
      if (input.has_vertex(i)) at.emplace(input.soup().points[i], i);
    Geodesic repaired(input.mesh());
    for (const std::size_t v : sources)
    {
      std::set<geodesic_offset::Vertex> added;
      const auto range = at.equal_range(clusters.points[v]);
      for (auto it = range.first; it != range.second; ++it)
        input.for_each_vertex_of(it->second, [&](geodesic_offset::Vertex w) {
          if (added.insert(w).second) repaired.add_source_point(w);
        });
    }
    if (repaired.number_of_sources() == 0)
    {
      ++counts.missing;
      return fault(file, "the source is not there");
    }
    repaired.build();
    bool is_wrong = false, is_missing = false;
    for (std::size_t v = 0; v < clusters.points.size(); ++v)
    {
      if (!clusters.on_surface[v]) continue;
      const auto range = at.equal_range(clusters.points[v]);
      if (range.first == range.second)
      {
        // among faces with vertices of their own, only the place connects degenerate faces with others
        if (clusters.is_displaced[v] && has_own_vertices) continue;
        is_missing = true;
        last_ = "vertex " + std::to_string(v) + " is missing";
        continue;
      }
      const double expected =
        v < data.vertices.size() ? geodesic.distance_to_sources(data.vertices[v])
                                 : geodesic.distance_to_sources(geodesic.mesh().locate(clusters.points[v]));
      for (auto it = range.first; it != range.second; ++it)
        input.for_each_vertex_of(it->second, [&](geodesic_offset::Vertex w) {
          const double d = repaired.distance_to_sources(w);
          if (d == expected) return; // both may be infinite
          const double error = std::abs(d - expected) / diagonal_;
          counts.worst = (std::max)(counts.worst, error);
          if (error <= tolerance) return;
          is_wrong = true;
          std::ostringstream text;
          text.precision(17);
          text << "vertex " << v << ": " << d << " instead of " << expected;
          last_ = text.str();
        });
    }
    counts.wrong += is_wrong ? 1 : 0;
    counts.missing += is_missing ? 1 : 0;
    if (is_wrong || is_missing) fault(file, last_);
  }

  void fault(const Degenerate_file& file, const std::string& text)
  {
    if (printed_ == 0) return;
    --printed_;
    log_ << "seed " << seed_ << ", " << file.name << ": " << text << '\n';
    if (describes_) log_ << file.bytes << '\n';
  }

  std::ostream& log_;
  std::size_t printed_, number_of_clusters_;
  bool describes_;
  Random random_;
  unsigned seed_ = 0;
  bool only_floats_ = false;
  double diagonal_ = 1;
  std::string last_;
  std::map<std::string, Degenerate_counts> counts_;
  std::map<std::string, std::size_t> added_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_DEGENERATE_SEARCH_H
