// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Picture of the mesh coloured by distance, with sources, barriers, offsets and paths.

#ifndef GEODESIC_OFFSET_PICTURE_H
#define GEODESIC_OFFSET_PICTURE_H

#include "color_map.h"
#include "common.h"
#include "numbers.h"
#include "raster.h"
#include "stroke_font.h"
#include "view.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace geodesic_offset {

using Polyline = std::vector<Point>;

// Pixels from left to right and from top to bottom, three bytes each.
struct Image
{
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;
};

// Limits of a picture, in pixels. Lines and text have the same size in all pictures.
struct Picture_size
{
  int width = 1600;
  int minimum_height = 700;
  int maximum_height = 1600;
  double margin = 60;
  bool has_legend = true;
};

// Parts of a picture on request.
struct Picture_details
{
  bool boundaries = false; // curves between the cells of sources
  bool labels = false; // distances of the offsets
  bool axes = false; // directions of the coordinate axes, in the lower left corner
  bool box = false; // bounding box
};

// Distances: a function of a face and barycentric coordinates, as `Face_distances`, with the largest value.
template <class Distances>
class Picture
{
  static constexpr int strip_rows = 64;
  static constexpr double legend_width = 170; // including its distance from the mesh
  static constexpr double offset_radius = 1.0;
  static constexpr double boundary_radius = 1.5;
  static constexpr double box_radius = 0.8;
  static constexpr double path_radius = 1.7;
  static constexpr double barrier_radius = 2.2;
  static constexpr double source_radius = 2.7;
  static constexpr double point_radius = 7;
  static constexpr double halo = 1.3;
  static constexpr double text_size = 17, text_radius = 1.05;

  struct Corner_normals
  {
    std::array<std::array<float, 3>, 3> n;
  };

  const Mesh& m_mesh;
  const Distances& m_distances;
  View m_view;
  Color_map m_colors;
  Picture_size m_size;
  double m_scale = 1, m_left = 0, m_top = 0, m_depth = 0, m_largest;
  int m_height;

  std::vector<View_point> m_points;
  std::vector<Corner_normals> m_normals;
  std::vector<std::vector<View_point>> m_offsets, m_boundaries, m_barriers, m_paths, m_sources, m_box;

  struct Label
  {
    double x, y; // middle of its left side
    std::string text;

    double right() const { return x + text_size * text_width(text); }
  };
  std::vector<Label> m_labels;
  bool m_has_axes = false;
  std::vector<View_point> m_source_points;

public:
  Picture(const Mesh& mesh, const Distances& distances, const View& view)
    : Picture(mesh, distances, view, Extent(mesh, view), Picture_size())
  {
  }

  // extent: the part of the mesh in the picture.
  Picture(const Mesh& mesh, const Distances& distances, const View& view, const Extent& extent, const Picture_size& size)
    : m_mesh(mesh), m_distances(distances), m_view(view), m_size(size), m_largest(distances.largest()),
      m_height(size.minimum_height)
  {
    fit(extent);
    m_points.reserve(mesh.number_of_vertices());
    for(Vertex v : mesh.vertices()) m_points.push_back(place(mesh.point(v)));
    compute_normals();
  }

  // Below the visible resolution.
  double chord_tolerance() const { return 0.05 / m_scale; }

  void add_offset(const Polyline& polyline) { m_offsets.push_back(place(polyline)); }
  void add_barrier(const Polyline& polyline) { m_barriers.push_back(place(polyline)); }
  void add_boundary(const Polyline& polyline) { m_boundaries.push_back(place(polyline)); }
  void add_axes() { m_has_axes = true; }

  // The edges of a bounding box. Precondition: the extent has its corners.
  void add_box(const CGAL::Bbox_3& box)
  {
    const auto corner = [&](int i) { return place(corner_of(box, i)); };
    for(int i = 0; i < 8; ++i)
      for(int bit : {1, 2, 4})
        if((i & bit) == 0) m_box.push_back({corner(i), corner(i | bit)});
  }

  // Labels a distance at one of the points, if there is room: the nearest to the viewer, and further up and right.
  // is_visible(point): whether the surface does not hide the point.
  template <class Visible>
  void add_label(double distance, const std::vector<Point>& points, const Visible& is_visible)
  {
    constexpr double gap = 6;
    constexpr std::size_t most_places = 500;
    std::vector<std::pair<double, Label>> places;
    for(std::size_t i = 0; i < points.size(); i += points.size() / most_places + 1)
    {
      const View_point p = place(points[i]);
      if(is_visible(points[i])) places.push_back({0.3 * (p[1] - p[0]) - p[2], {p[0] + gap, p[1], label(distance, 4)}});
    }
    std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for(const auto& [rank, l] : places)
      if(std::none_of(m_labels.begin(), m_labels.end(), [&, &l = l](const Label& other) {
           return std::abs(other.y - l.y) < text_size + gap && other.x < l.right() + gap && l.x < other.right() + gap;
         }))
        return m_labels.push_back(l);
  }

  void add_path(const Polyline& polyline) { m_paths.push_back(place(polyline)); }
  void add_source(const Polyline& polyline) { m_sources.push_back(place(polyline)); }
  void add_source(const Point& point) { m_source_points.push_back(place(point)); }

  // Calls report(fraction) with the completed fraction of the picture.
  template <class Report>
  Image render(const Report& report) const
  {
    Image image;
    image.width = m_size.width;
    image.height = m_height;
    image.bytes.reserve(3 * static_cast<std::size_t>(m_size.width) * static_cast<std::size_t>(m_height));
    const Srgb_encoder encode;
    const auto shade = [this](std::uint32_t thing, float u, float v) { return color_of(thing, u, v); };
    // none, outline of the surface, bounding box, offset, boundary of cells, white margin of lines, barrier, path, source, text
    const std::array<Marking, number_of_marks> markings = {
      {{Color(), 0},
       {srgb(40, 44, 58), 0.75f},
       {srgb(110, 116, 130), 0.8f},
       {srgb(24, 22, 40), 0.8f},
       {srgb(0, 92, 60), 1},
       {srgb(255, 255, 255), 1},
       {srgb(0, 0, 0), 1},
       {srgb(24, 60, 190), 1},
       {srgb(226, 24, 54), 1},
       {ink(), 1}}};
    Raster raster(m_size.width);
    for(int first = 0; first < m_height; first += strip_rows)
    {
      const int rows = std::min(strip_rows, m_height - first);
      raster.begin(first, rows);
      draw_mesh(raster, first, rows);
      draw_curves(raster, first, rows);
      raster.outline(static_cast<float>(0.012 * m_depth));
      if(m_largest > 0 && m_size.has_legend) draw_legend(raster);
      for(const Label& l : m_labels) draw_text(raster, l.text, l.x, l.y, true);
      if(m_has_axes) draw_axes(raster);
      for(int row = first; row < first + rows; ++row)
      {
        const Color behind =
          mix(srgb(252, 252, 253), srgb(228, 232, 238), static_cast<float>(row) / static_cast<float>(m_height));
        for(int column = 0; column < m_size.width; ++column)
        {
          const Color c = raster.pixel(column, row, behind, shade, markings);
          for(float channel : {c.r, c.g, c.b}) image.bytes.push_back(encode(channel));
        }
      }
      report(static_cast<double>(first + rows) / static_cast<double>(m_height));
    }
    return image;
  }

private:
  // Numbers of things other than faces.
  static constexpr std::uint32_t legend_bar = 0xffffffff, legend_frame = 0xfffffffe;

  static Color ink() { return srgb(48, 52, 66); }

  Color color_of(std::uint32_t thing, double u, double v) const
  {
    if(thing == legend_bar) return m_colors(v);
    if(thing == legend_frame) return ink();
    const double distance = m_distances(Face(thing), u, v), t = 1 - u - v;
    const Color color = distance < infinity ? m_colors(m_largest > 0 ? distance / m_largest : 0) : srgb(176, 178, 184);
    const auto& n = m_normals[thing].n;
    return lit(color, t * n[0][0] + u * n[1][0] + v * n[2][0], t * n[0][1] + u * n[1][1] + v * n[2][1],
               t * n[0][2] + u * n[1][2] + v * n[2][2]);
  }

  void fit(const Extent& extent)
  {
    const double w = extent.max[0] - extent.min[0], h = extent.max[1] - extent.min[1];
    const double margin = m_size.margin;
    const double room = m_size.width - 2 * margin - (m_size.has_legend ? legend_width : 0);
    const double tiny = 1e-9 * std::max(w, h);
    m_scale = std::min(room / std::max(w, tiny), (m_size.maximum_height - 2 * margin) / std::max(h, tiny));
    m_height = std::max(m_size.minimum_height, static_cast<int>(std::ceil(h * m_scale + 2 * margin)));
    m_left = margin + (room - w * m_scale) / 2 - extent.min[0] * m_scale;
    m_top = (m_height + h * m_scale) / 2 + extent.min[1] * m_scale;
    m_depth = std::hypot(w, h) * m_scale;
  }

  View_point place(const Point& p) const
  {
    const View_point v = m_view(p);
    return {m_left + m_scale * v[0], m_top - m_scale * v[1], m_scale * v[2]};
  }

  std::vector<View_point> place(const Polyline& polyline) const
  {
    std::vector<View_point> points;
    points.reserve(polyline.size());
    for(const Point& p : polyline) points.push_back(place(p));
    return points;
  }

  // Smooth normals, except at edges that are sharper than the crease angle.
  void compute_normals()
  {
    constexpr double cosine_of_crease = 0.8; // 37 degrees
    std::vector<std::array<double, 3>> normal(m_mesh.number_of_faces()); // in view coordinates, weighted by area
    std::vector<double> length(normal.size());
    for(Face f : m_mesh.faces())
    {
      const std::array<std::size_t, 3> v = corners(f);
      const View_point &a = m_points[v[0]], &b = m_points[v[1]], &c = m_points[v[2]];
      const double p[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, q[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
      // the y axis of the picture points down, that of the normal up
      normal[f] = {p[2] * q[1] - p[1] * q[2], p[2] * q[0] - p[0] * q[2], p[1] * q[0] - p[0] * q[1]};
      length[f] = std::sqrt(normal[f][0] * normal[f][0] + normal[f][1] * normal[f][1] + normal[f][2] * normal[f][2]);
    }
    m_normals.resize(m_mesh.number_of_faces());
    for(Face f : m_mesh.faces())
    {
      const std::array<double, 3>& n = normal[f];
      Halfedge h = m_mesh.prev(m_mesh.halfedge(f)); // its target is the first corner
      for(int corner = 0; corner < 3; ++corner, h = m_mesh.next(h))
      {
        std::array<double, 3> sum{0, 0, 0};
        for(Face g : m_mesh.faces_around_target(h))
        {
          if(g == Mesh::null_face()) continue;
          const std::array<double, 3>& m = normal[g];
          if(g == f || n[0] * m[0] + n[1] * m[1] + n[2] * m[2] > cosine_of_crease * length[f] * length[g])
            for(std::size_t c = 0; c < 3; ++c) sum[c] += m[c];
        }
        for(std::size_t c = 0; c < 3; ++c)
        {
          const double norm = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
          m_normals[f].n[static_cast<std::size_t>(corner)][c] = static_cast<float>(norm > 0 ? sum[c] / norm : 0);
        }
      }
    }
  }

  // Change of the depth of a face, in pixels per pixel.
  double slope_of(Face f) const
  {
    const std::array<std::size_t, 3> v = corners(f);
    const View_point &a = m_points[v[0]], &b = m_points[v[1]], &c = m_points[v[2]];
    const double p[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, q[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const double area = std::abs(p[0] * q[1] - p[1] * q[0]);
    return area > 0 ? std::hypot(p[2] * q[1] - p[1] * q[2], p[0] * q[2] - p[2] * q[0]) / area : infinity;
  }

  std::array<std::size_t, 3> corners(Face f) const
  {
    const Halfedge h = m_mesh.halfedge(f);
    return {m_mesh.source(h), m_mesh.target(h), m_mesh.target(m_mesh.next(h))};
  }

  static double power_of_64(double x)
  {
    // avoid very slow arithmetic with denormal numbers
    if(x < 0.7) return 0;
    for(int i = 0; i < 6; ++i) x *= x;
    return x;
  }

  // Light from the left above the viewer, and some ambient light.
  static Color lit(Color color, double nx, double ny, double nz)
  {
    const double norm = std::sqrt(nx * nx + ny * ny + nz * nz);
    const bool inside = nz < 0;
    const double s = (inside ? -1 : 1) / (norm > 0 ? norm : 1);
    nx *= s, ny *= s, nz *= s;
    const double key = std::max(0.0, -0.37 * nx + 0.45 * ny + 0.81 * nz);
    const double head = std::max(0.0, nz);
    const double sky = 0.5 + 0.5 * ny;
    const double diffuse = 0.20 + 0.14 * sky + 0.46 * key + 0.26 * head;
    // halfway between light and viewer
    const double half = std::max(0.0, -0.195 * nx + 0.237 * ny + 0.952 * nz);
    const float shine = static_cast<float>(0.10 * power_of_64(half));
    if(inside) color = mix(color, Color{0.25f, 0.25f, 0.27f}, 0.45f);
    return static_cast<float>(diffuse) * color + Color{shine, shine, shine};
  }

  void draw_mesh(Raster& raster, int first, int rows) const
  {
    for(Face f : m_mesh.faces())
    {
      const std::array<std::size_t, 3> v = corners(f);
      const View_point &a = m_points[v[0]], &b = m_points[v[1]], &c = m_points[v[2]];
      if(std::max({a[1], b[1], c[1]}) >= first - 2 && std::min({a[1], b[1], c[1]}) <= first + rows + 2)
        raster.triangle(a, b, c, f);
    }
  }

  void draw_curves(Raster& raster, int first, int rows) const
  {
    // beside a line on a slope, the surface is nearer to the viewer than the line
    const auto bias = [](double radius) { return 3 * radius + 1; };
    const auto slope = [this](std::uint32_t face) { return slope_of(Face(face)); };
    const auto draw = [&](const std::vector<View_point>& line, double radius, Mark mark) {
      for(std::size_t i = 0; i + 1 < line.size(); ++i)
        if(std::min(line[i][1], line[i + 1][1]) < first + rows + 12 && std::max(line[i][1], line[i + 1][1]) > first - 12)
          raster.line(line[i], line[i + 1], radius, mark, bias(radius), slope);
    };
    for(const std::vector<View_point>& line : m_box) draw(line, box_radius, Mark::box);
    for(const std::vector<View_point>& line : m_offsets) draw(line, offset_radius, Mark::offset);
    for(const std::vector<View_point>& line : m_boundaries) draw(line, boundary_radius, Mark::boundary);
    for(const std::vector<View_point>& line : m_barriers)
    {
      draw(line, barrier_radius + halo, Mark::halo);
      draw(line, barrier_radius, Mark::barrier);
    }
    for(const std::vector<View_point>& line : m_paths)
    {
      draw(line, path_radius + halo, Mark::halo);
      draw(line, path_radius, Mark::path);
    }
    for(const std::vector<View_point>& line : m_sources)
    {
      draw(line, source_radius + halo, Mark::halo);
      draw(line, source_radius, Mark::source);
    }
    for(const View_point& p : m_source_points)
    {
      draw({p, p}, point_radius + halo, Mark::halo);
      draw({p, p}, point_radius, Mark::source);
    }
  }

  void draw_legend(Raster& raster) const
  {
    const double left = m_size.width - legend_width + 20, right = left + 26;
    const double length = std::min(520.0, 0.6 * m_height);
    const double top = (m_height - length) / 2, bottom = top + length;
    raster.rectangle(left - 1.5, top - 1.5, right + 1.5, bottom + 1.5, legend_frame);
    raster.rectangle(left, top, right, bottom, legend_bar);
    const double step = tick_step(m_largest);
    std::vector<double> ticks;
    for(int i = 0; i * step < m_largest; ++i)
      if(m_largest - i * step > 0.6 * step) ticks.push_back(i * step);
    ticks.push_back(m_largest);
    for(double tick : ticks)
    {
      const double y = bottom - length * tick / m_largest;
      raster.rectangle(right, y - 0.75, right + 9, y + 0.75, legend_frame);
      draw_text(raster, tick == m_largest ? label(tick, 3) : label(tick, 6), right + 17, y, false);
    }
  }

  // x, y: the middle of the left side of the text
  static void draw_text(Raster& raster, const std::string& text, double x, double y, bool has_halo)
  {
    const auto lines = text_lines(text);
    for(const Mark mark : {Mark::halo, Mark::ink})
      for(const auto& [from, to] : lines)
        if(mark == Mark::ink || has_halo)
          raster.ink(x + text_size * from[0], y + text_size * (from[1] - 0.5), x + text_size * to[0],
                     y + text_size * (to[1] - 0.5), text_radius + (mark == Mark::halo ? 2 * halo : 0), mark);
  }

  void draw_axes(Raster& raster) const
  {
    constexpr double length = 62, from_corner = 95;
    const double x = from_corner, y = m_height - from_corner;
    const char* const names[] = {"x", "y", "z"};
    for(int axis = 0; axis < 3; ++axis)
    {
      const View_point v = m_view(Vector(axis == 0, axis == 1, axis == 2));
      const double size = std::hypot(v[0], v[1]);
      if(size < 0.05) continue; // towards the viewer
      raster.ink(x, y, x + length * v[0], y - length * v[1], 1.4);
      const double at = length + 16 / size;
      draw_text(raster, names[axis], x + at * v[0] - text_size * 0.3, y - at * v[1], false);
    }
  }

  // A round number; the largest distance has four to eight of it.
  static double tick_step(double largest)
  {
    const double power = std::pow(10.0, std::floor(std::log10(largest)));
    for(double step : {0.1, 0.2, 0.25, 0.5})
      if(largest / (step * power) <= 7) return step * power;
    return power;
  }

  static std::string label(double value, int digits)
  {
    std::ostringstream stream;
    stream.precision(digits);
    stream << value;
    return stream.str();
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_PICTURE_H
