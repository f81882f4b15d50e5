// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Light colours, and the colour scale of distances.

#ifndef GEODESIC_OFFSET_COLOR_MAP_H
#define GEODESIC_OFFSET_COLOR_MAP_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace geodesic_offset {

// Intensities of light, which can be added and averaged, unlike the numbers in an image file.
struct Color
{
  float r = 0, g = 0, b = 0;
};

inline Color operator+(Color x, Color y) { return {x.r + y.r, x.g + y.g, x.b + y.b}; }
inline Color operator*(float s, Color x) { return {s * x.r, s * x.g, s * x.b}; }
inline Color mix(Color x, Color y, float t) { return (1 - t) * x + t * y; }

inline float linear_from_srgb(double v)
{
  return static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
}

inline Color srgb(int r, int g, int b)
{
  return {linear_from_srgb(r / 255.0), linear_from_srgb(g / 255.0), linear_from_srgb(b / 255.0)};
}

// Number for an image file, from a table: the formula would take most of the time per pixel.
class Srgb_encoder
{
  std::vector<std::uint8_t> m_table;

public:
  Srgb_encoder() : m_table(16384)
  {
    for(std::size_t i = 0; i < m_table.size(); ++i)
    {
      const double v = static_cast<double>(i) / static_cast<double>(m_table.size() - 1);
      const double encoded = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
      m_table[i] = static_cast<std::uint8_t>(std::lround(255 * encoded));
    }
  }

  std::uint8_t operator()(float linear) const
  {
    const float clamped = std::min(std::max(linear, 0.0f), 1.0f);
    return m_table[static_cast<std::size_t>(clamped * static_cast<float>(m_table.size() - 1) + 0.5f)];
  }
};

// The Oklab colour space (Ottosson 2020), in which equal steps look equal.
inline Color color_from_oklab(double lightness, double a, double b)
{
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  const auto clamp = [](double v) { return static_cast<float>(std::min(std::max(v, 0.0), 1.0)); };
  return {clamp(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          clamp(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          clamp(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

// Light and warm near the sources, darker and cooler far away. Lightness decreases evenly, so that the order of distances
// is visible without colours, and stays high enough for dark lines to be visible everywhere.
class Color_map
{
  std::vector<Color> m_table;

public:
  Color_map() : m_table(1024)
  {
    struct Stop
    {
      double t, lightness, chroma, hue;
    };
    constexpr std::array<Stop, 6> stops = {
      {{0.00, 0.945, 0.085, 98},
       {0.20, 0.860, 0.145, 78},
       {0.42, 0.765, 0.110, 165},
       {0.62, 0.665, 0.105, 215},
       {0.82, 0.555, 0.135, 262},
       {1.00, 0.450, 0.155, 292}}};
    constexpr double degree = 3.14159265358979323846 / 180;
    for(std::size_t i = 0; i < m_table.size(); ++i)
    {
      const double t = static_cast<double>(i) / static_cast<double>(m_table.size() - 1);
      std::size_t k = 1;
      while(k + 1 < stops.size() && t > stops[k].t) ++k;
      const Stop &p = stops[k - 1], &q = stops[k];
      const double s = (t - p.t) / (q.t - p.t), smooth = s * s * (3 - 2 * s);
      const auto between = [&](double x, double y, double w) { return x + w * (y - x); };
      // straight lines through the colour plane; the hue circle would add unrelated colours
      const double a = between(p.chroma * std::cos(p.hue * degree), q.chroma * std::cos(q.hue * degree), smooth);
      const double b = between(p.chroma * std::sin(p.hue * degree), q.chroma * std::sin(q.hue * degree), smooth);
      m_table[i] = color_from_oklab(between(p.lightness, q.lightness, s), a, b);
    }
  }

  // t from 0 to 1.
  Color operator()(double t) const
  {
    const double clamped = std::min(std::max(t, 0.0), 1.0);
    return m_table[static_cast<std::size_t>(clamped * static_cast<double>(m_table.size() - 1) + 0.5)];
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_COLOR_MAP_H
