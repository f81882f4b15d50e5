// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Orthographic views of a mesh, and the choice of a view that shows the sources.

#ifndef GEODESIC_OFFSET_VIEW_H
#define GEODESIC_OFFSET_VIEW_H

#include "common.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace geodesic_offset {

// Position in the picture: x to the right, y up, z towards the viewer.
using View_point = std::array<double, 3>;

class View
{
  Vector m_right, m_up, m_towards;

public:
  View(const Vector& towards_viewer, const Vector& up)
  {
    m_towards = normalized(towards_viewer);
    Vector right = CGAL::cross_product(up, m_towards);
    // from straight above, any other axis may point up
    if(right.squared_length() < 1e-12 * up.squared_length())
      right = CGAL::cross_product(std::abs(m_towards.z()) < 0.9 ? Vector(0, 0, 1) : Vector(0, 1, 0), m_towards);
    m_right = normalized(right);
    m_up = CGAL::cross_product(m_towards, m_right);
  }

  View_point operator()(const Vector& v) const { return {v * m_right, v * m_up, v * m_towards}; }
  View_point operator()(const Point& p) const { return (*this)(p - CGAL::ORIGIN); }

  static Vector normalized(const Vector& v) { return v / std::sqrt(v.squared_length()); }
};

// One of the eight corners, by the bits of i.
inline Point corner_of(const CGAL::Bbox_3& box, int i)
{
  return Point(i & 1 ? box.xmax() : box.xmin(), i & 2 ? box.ymax() : box.ymin(), i & 4 ? box.zmax() : box.zmin());
}

// Rectangle of the picture, in units of the mesh.
struct Extent
{
  double min[2] = {infinity, infinity};
  double max[2] = {-infinity, -infinity};

  // A square, for a detail.
  Extent(const View_point& center, double half)
    : min{center[0] - half, center[1] - half}, max{center[0] + half, center[1] + half}
  {
  }

  // Adds the corners of a box.
  void add(const CGAL::Bbox_3& box, const View& view)
  {
    for(int i = 0; i < 8; ++i) add(view(corner_of(box, i)));
  }

  // What the mesh covers.
  Extent(const Mesh& mesh, const View& view)
  {
    for(Vertex v : mesh.vertices()) add(view(mesh.point(v)));
  }

private:
  void add(const View_point& p)
  {
    for(int c = 0; c < 2; ++c)
    {
      min[c] = std::min(min[c], p[c]);
      max[c] = std::max(max[c], p[c]);
    }
  }
};

namespace internal {

// Small depth image for visibility tests of a direction.
class Depth_probe
{
  static constexpr int size = 240;
  struct Pixel
  {
    double depth = -infinity;
    bool is_front = false; // the outside of the surface is visible
  };
  std::vector<Pixel> m_pixels;
  double m_x, m_y, m_scale;

public:
  Depth_probe(const Mesh& mesh, const View& view) : m_pixels(static_cast<std::size_t>(size * size))
  {
    const Extent extent(mesh, view);
    m_x = extent.min[0];
    m_y = extent.min[1];
    m_scale = (size - 1) / std::max({extent.max[0] - m_x, extent.max[1] - m_y, std::numeric_limits<double>::min()});
    for(Face f : mesh.faces())
    {
      const Halfedge h = mesh.halfedge(f);
      draw(view(mesh.point(mesh.source(h))), view(mesh.point(mesh.target(h))), view(mesh.point(mesh.target(mesh.next(h)))));
    }
  }

  bool is_visible(const View_point& p) const { return p[2] >= m_pixels[pixel(column(p[0]), row(p[1]))].depth - 3 / m_scale; }

  // Visible area of the outside, in units of the mesh.
  double visible_area() const
  {
    const auto n = std::count_if(m_pixels.begin(), m_pixels.end(), [](const Pixel& p) { return p.is_front; });
    return static_cast<double>(n) / (m_scale * m_scale);
  }

private:
  int column(double x) const { return std::min(std::max(static_cast<int>((x - m_x) * m_scale + 0.5), 0), size - 1); }
  int row(double y) const { return std::min(std::max(static_cast<int>((y - m_y) * m_scale + 0.5), 0), size - 1); }
  static std::size_t pixel(int c, int r) { return static_cast<std::size_t>(r) * size + static_cast<std::size_t>(c); }

  void draw(const View_point& a, const View_point& b, const View_point& c)
  {
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    const auto set = [&](std::size_t i, double depth) {
      if(depth > m_pixels[i].depth) m_pixels[i] = {depth, area > 0};
    };
    // at least the corners, so that faces smaller than a pixel count
    for(const View_point& p : {a, b, c}) set(pixel(column(p[0]), row(p[1])), p[2]);
    if(area == 0) return;
    const int c0 = column(std::min({a[0], b[0], c[0]})), c1 = column(std::max({a[0], b[0], c[0]}));
    const int r0 = row(std::min({a[1], b[1], c[1]})), r1 = row(std::max({a[1], b[1], c[1]}));
    for(int r = r0; r <= r1; ++r)
      for(int k = c0; k <= c1; ++k)
      {
        const double x = m_x + k / m_scale, y = m_y + r / m_scale;
        const double v = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area;
        const double w = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area;
        if(v < 0 || w < 0 || v + w > 1) continue;
        set(pixel(k, r), a[2] + v * (b[2] - a[2]) + w * (c[2] - a[2]));
      }
  }
};

} // namespace internal

// Three-quarter view that shows the most of these points.
inline View choose_view(const Mesh& mesh, const std::vector<Point>& points, const Vector& up)
{
  const Vector top = View::normalized(up);
  const Vector front =
    View::normalized(std::abs(top.z()) < 0.9 ? Vector(0, 0, 1) - top.z() * top : Vector(0, -1, 0) + top.y() * top);
  const Vector side = CGAL::cross_product(top, front);

  struct Candidate
  {
    View view;
    double visible, area, preference;
  };
  std::vector<Candidate> candidates;
  constexpr double degree = 3.14159265358979323846 / 180;
  for(int elevation : {22, 48, -18})
    for(int azimuth : {35, -35, 145, -145, 80, -80})
    {
      const double e = elevation * degree, a = azimuth * degree;
      const View view(std::sin(e) * top + std::cos(e) * (std::cos(a) * front + std::sin(a) * side), top);
      const internal::Depth_probe probe(mesh, view);
      std::size_t visible = 0;
      for(const Point& p : points) visible += probe.is_visible(view(p)) ? 1 : 0;
      candidates.push_back({view, points.empty() ? 0 : static_cast<double>(visible) / static_cast<double>(points.size()),
                            probe.visible_area(), (azimuth == 35 ? 0.04 : 0) - (elevation < 0 ? 0.15 : 0)});
    }
  double largest = 0;
  for(const Candidate& c : candidates) largest = std::max(largest, c.area);
  const auto score = [&](const Candidate& c) { return c.visible + (largest > 0 ? 0.4 * c.area / largest : 0) + c.preference; };
  return std::max_element(candidates.begin(), candidates.end(),
                          [&](const Candidate& x, const Candidate& y) { return score(x) < score(y); })
    ->view;
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_VIEW_H
