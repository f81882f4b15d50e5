// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Strip of the picture, with several samples per pixel in each direction, and depths. Pictures are drawn strip by strip:
// the samples of a whole picture would need more memory than the mesh.
// Not a library: CGAL draws on a display, with Qt and OpenGL; Boost.GIL has images and files, but no triangles with depths.

#ifndef GEODESIC_OFFSET_RASTER_H
#define GEODESIC_OFFSET_RASTER_H

#include "color_map.h"
#include "view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace geodesic_offset {

// Marks on top of the surface; larger values cover smaller ones.
enum class Mark : std::uint8_t { none, outline, box, offset, boundary, halo, barrier, path, source, ink };
constexpr std::size_t number_of_marks = 10;

struct Marking
{
  Color color;
  float opacity;
};

// Coordinates are pixels from the top left corner of the picture, z towards the viewer.
class Raster
{
public:
  static constexpr int samples = 4; // per pixel, in each direction
  static constexpr int margin = 36; // rows of samples above and below, for neighbourhoods, as half the width of a line

private:
  static constexpr float nothing = -3e38f; // depth without surface

  // Visible thing with its number, and position on it. Colours are computed after visibility; otherwise most of the work
  // would be wasted.
  struct Sample
  {
    float depth = nothing;
    std::uint32_t thing = 0;
    float u = 0, v = 0;
    Mark mark = Mark::none;

    bool is_nothing() const { return depth == nothing; }
    bool is_same_thing(const Sample& s) const { return is_nothing() ? s.is_nothing() : !s.is_nothing() && s.thing == thing; }
  };

  int m_width, m_first_row = 0, m_rows = 0;
  std::vector<Sample> m_samples;

public:
  explicit Raster(int width_in_pixels) : m_width(width_in_pixels * samples) {}

  // Begins with an empty strip of the pixel rows [first, first + rows).
  void begin(int first, int rows)
  {
    m_first_row = first * samples - margin;
    m_rows = rows * samples + 2 * margin;
    m_samples.assign(static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_rows), Sample());
  }

  // u and v are the barycentric coordinates of b and c.
  void triangle(const View_point& a, const View_point& b, const View_point& c, std::uint32_t thing)
  {
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if(!(std::abs(area) > 0)) return;
    const double scale = 1 / area;
    const int y0 = first_row(std::min({a[1], b[1], c[1]})), y1 = last_row(std::max({a[1], b[1], c[1]}));
    const int x0 = first_column(std::min({a[0], b[0], c[0]})), x1 = last_column(std::max({a[0], b[0], c[0]}));
    // rounding must not open seams between neighbours
    constexpr double epsilon = 1e-9;
    for(int y = y0; y <= y1; ++y)
    {
      const double py = position(y) - a[1];
      for(int x = x0; x <= x1; ++x)
      {
        const double px = position(x) - a[0];
        const double u = (px * (c[1] - a[1]) - py * (c[0] - a[0])) * scale;
        const double v = ((b[0] - a[0]) * py - (b[1] - a[1]) * px) * scale;
        if(u < -epsilon || v < -epsilon || u + v > 1 + epsilon) continue;
        const float depth = static_cast<float>(a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2]));
        Sample& s = at(x, y);
        if(depth > s.depth)
        {
          s.depth = depth;
          s.thing = thing;
          s.u = static_cast<float>(u);
          s.v = static_cast<float>(v);
        }
      }
    }
  }

  // Line with round ends. Hidden where the surface is more than `bias` in front of it, and where its middle is hidden: there the
  // surface is in front of it by more than the rounding of samples, which grows with slope(thing).
  template <class Slope>
  void line(const View_point& a, const View_point& b, double radius, Mark mark, double bias, const Slope& slope)
  {
    stroke(a, b, radius, [&](Sample& s, const View_point& middle) {
      if(mark <= s.mark || middle[2] < static_cast<double>(s.depth) - bias) return;
      const Sample& m = at(clamped(std::floor(middle[0] * samples), 0, m_width - 1),
                           clamped(std::floor(middle[1] * samples), m_first_row, m_first_row + m_rows - 1));
      if(m.is_nothing() || middle[2] >= static_cast<double>(m.depth) - 0.5 - slope(m.thing) / samples) s.mark = mark;
    });
  }

  // Rectangle in front of everything; v runs from 0 at the bottom to 1 at the top.
  void rectangle(double left, double top, double right, double bottom, std::uint32_t thing)
  {
    for(int y = first_row(top); y <= last_row(bottom); ++y)
      for(int x = first_column(left); x <= last_column(right); ++x)
      {
        Sample& s = at(x, y);
        s.mark = Mark::none;
        s.depth = -nothing;
        s.thing = thing;
        s.v = static_cast<float>((bottom - position(y)) / (bottom - top));
      }
  }

  // Line with round ends in front of everything.
  void ink(double x0, double y0, double x1, double y1, double radius, Mark mark = Mark::ink)
  {
    stroke({x0, y0, 0}, {x1, y1, 0}, radius, [&](Sample& s, const View_point&) { s.mark = std::max(s.mark, mark); });
  }

  // Marks the samples where the surface ends in front of something at least `jump` deeper.
  void outline(float jump)
  {
    constexpr int reach = 3;
    const auto is_front = [&](const Sample& s, int x, int y) {
      if(x < 0 || x >= m_width || y < m_first_row || y >= m_first_row + m_rows) return false;
      return s.depth - at(x, y).depth > jump;
    };
    for(int y = m_first_row + margin; y < m_first_row + m_rows - margin; ++y)
      for(int x = 0; x < m_width; ++x)
      {
        Sample& s = at(x, y);
        if(s.mark == Mark::none && s.depth > nothing && s.depth < -nothing &&
           (is_front(s, x - reach, y) || is_front(s, x + reach, y) || is_front(s, x, y - reach) || is_front(s, x, y + reach)))
          s.mark = Mark::outline;
      }
  }

  // Colour of a pixel: mean of its samples. shade(thing, u, v) returns the colour of a thing; it is called once per thing
  // in the pixel, with the mean of u and v over the samples of the thing.
  template <class Shade, class Markings>
  Color pixel(int column, int row, Color behind, const Shade& shade, const Markings& markings) const
  {
    struct Seen
    {
      const Sample* first;
      float number, u, v; // sums over the samples
      float own; // weight of the thing's colour, in samples
    };
    std::array<Seen, samples * samples> seen;
    std::size_t n = 0;
    Color sum;
    for(int y = row * samples; y < (row + 1) * samples; ++y)
      for(int x = column * samples; x < (column + 1) * samples; ++x)
      {
        const Sample& s = at(x, y);
        const Marking& marking = markings[static_cast<std::size_t>(s.mark)];
        const float own = s.mark == Mark::none ? 1.0f : 1 - marking.opacity;
        sum = sum + (1 - own) * marking.color;
        std::size_t i = 0;
        while(i < n && !seen[i].first->is_same_thing(s)) ++i;
        if(i == n) seen[n++] = {&s, 0, 0, 0, 0};
        seen[i].number += 1;
        seen[i].u += s.u;
        seen[i].v += s.v;
        seen[i].own += own;
      }
    for(std::size_t i = 0; i < n; ++i)
    {
      const Seen& s = seen[i];
      if(s.own > 0)
        sum = sum + s.own * (s.first->is_nothing() ? behind : shade(s.first->thing, s.u / s.number, s.v / s.number));
    }
    return (1.0f / (samples * samples)) * sum;
  }

private:
  template <class Draw>
  void stroke(const View_point& a, const View_point& b, double radius, const Draw& draw)
  {
    const double dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
    const int y0 = first_row(std::min(a[1], b[1]) - radius), y1 = last_row(std::max(a[1], b[1]) + radius);
    const int x0 = first_column(std::min(a[0], b[0]) - radius), x1 = last_column(std::max(a[0], b[0]) + radius);
    for(int y = y0; y <= y1; ++y)
      for(int x = x0; x <= x1; ++x)
      {
        const double px = position(x) - a[0], py = position(y) - a[1];
        const double t = square > 0 ? std::min(std::max((px * dx + py * dy) / square, 0.0), 1.0) : 0.0;
        const double ex = px - t * dx, ey = py - t * dy;
        if(ex * ex + ey * ey <= radius * radius)
          draw(at(x, y), View_point{a[0] + t * dx, a[1] + t * dy, a[2] + t * (b[2] - a[2])});
      }
  }

  static double position(int sample) { return (sample + 0.5) / samples; }

  // Compares before the conversion to integers, since lines may extend far beyond the picture.
  static int clamped(double value, int low, int high)
  {
    return static_cast<int>(std::min(std::max(value, static_cast<double>(low)), static_cast<double>(high)));
  }
  int first_row(double y) const { return clamped(std::ceil(y * samples - 0.5), m_first_row, m_first_row + m_rows); }
  int last_row(double y) const { return clamped(std::floor(y * samples - 0.5), m_first_row - 1, m_first_row + m_rows - 1); }
  int first_column(double x) const { return clamped(std::ceil(x * samples - 0.5), 0, m_width); }
  int last_column(double x) const { return clamped(std::floor(x * samples - 0.5), -1, m_width - 1); }

  std::size_t index(int x, int y) const
  {
    return static_cast<std::size_t>(y - m_first_row) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
  }
  Sample& at(int x, int y) { return m_samples[index(x, y)]; }
  const Sample& at(int x, int y) const { return m_samples[index(x, y)]; }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_RASTER_H
