// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Characters of numbers as strokes, for the legend of the picture.
// Not a library: Boost.GIL and libpng have no text, and FreeType would need a font file for these 14 characters.

#ifndef GEODESIC_OFFSET_STROKE_FONT_H
#define GEODESIC_OFFSET_STROKE_FONT_H

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace geodesic_offset {

using Stroke_point = std::array<double, 2>; // x to the right, y down; digits have height 1

namespace internal {

struct Stroke
{
  bool round; // corners are cut until they look round
  std::vector<Stroke_point> points;
};

// clang-format off
inline std::vector<Stroke> strokes_of(char c)
{
  switch(c)
  {
  case '0': return {{true, {{.3, 0}, {.05, 0}, {0, .2}, {0, .8}, {.05, 1}, {.3, 1}, {.55, 1}, {.6, .8}, {.6, .2}, {.55, 0}, {.3, 0}}}};
  case '1': return {{false, {{.1, .2}, {.35, 0}, {.35, 1}}}};
  case '2': return {{true, {{.02, .25}, {.05, 0}, {.3, 0}, {.6, 0}, {.6, .3}, {.5, .5}, {.0, 1}}}, {false, {{.0, 1}, {.6, 1}}}};
  case '3': return {{true, {{.02, .15}, {.1, 0}, {.3, 0}, {.56, 0}, {.56, .25}, {.56, .47}, {.24, .47}}},
                    {true, {{.24, .47}, {.6, .47}, {.6, .75}, {.6, 1}, {.3, 1}, {.08, 1}, {0, .85}}}};
  case '4': return {{false, {{.45, 1}, {.45, 0}, {0, .7}, {.6, .7}}}};
  case '5': return {{false, {{.55, 0}, {.08, 0}, {.04, .45}}},
                    {true, {{.04, .45}, {.12, .36}, {.3, .36}, {.6, .36}, {.6, .68}, {.6, 1}, {.3, 1}, {.08, 1}, {0, .87}}}};
  case '6': return {{true, {{.54, .1}, {.45, 0}, {.3, 0}, {0, 0}, {0, .4}, {0, .68}, {0, 1}, {.3, 1}, {.6, 1}, {.6, .68}, {.6, .4}, {.3, .4}, {.06, .4}, {.0, .62}}}};
  case '7': return {{false, {{0, 0}, {.6, 0}, {.2, 1}}}};
  case '8': return {{true, {{.3, 0}, {.04, 0}, {.04, .23}, {.04, .46}, {.3, .46}, {.6, .46}, {.6, .73}, {.6, 1}, {.3, 1}, {0, 1}, {0, .73}, {0, .46}, {.3, .46}, {.56, .46}, {.56, .23}, {.56, 0}, {.3, 0}}}};
  case '9': return {{true, {{.06, .9}, {.15, 1}, {.3, 1}, {.6, 1}, {.6, .6}, {.6, .32}, {.6, 0}, {.3, 0}, {0, 0}, {0, .32}, {0, .6}, {.3, .6}, {.54, .6}, {.6, .38}}}};
  case '-': return {{false, {{.05, .55}, {.5, .55}}}};
  case '+': return {{false, {{.05, .55}, {.55, .55}}}, {false, {{.3, .3}, {.3, .8}}}};
  case '.': return {{false, {{.0, .99}, {.0, 1}}}};
  case 'e': return {{true, {{.02, .66}, {.54, .66}}}, {true, {{.54, .66}, {.54, .34}, {.28, .34}, {0, .34}, {0, .67}, {0, 1}, {.3, 1}, {.48, 1}, {.52, .88}}}};
  case 'x': return {{false, {{.02, .35}, {.55, 1}}}, {false, {{.55, .35}, {.02, 1}}}};
  case 'y': return {{false, {{.02, .35}, {.3, 1}}}, {false, {{.57, .35}, {.2, 1.25}}}};
  case 'z': return {{false, {{.02, .35}, {.55, .35}, {.02, 1}, {.57, 1}}}};
  default: return {};
  }
}
// clang-format on

inline double width_of(char c) { return c == '.' ? 0.3 : 0.9; }

} // namespace internal

// Relative to the height.
inline double text_width(const std::string& text)
{
  double width = 0;
  for(char c : text) width += internal::width_of(c);
  return width;
}

// Lines of a text, as pairs of points.
inline std::vector<std::pair<Stroke_point, Stroke_point>> text_lines(const std::string& text)
{
  std::vector<std::pair<Stroke_point, Stroke_point>> lines;
  double left = 0;
  for(char c : text)
  {
    for(internal::Stroke& stroke : internal::strokes_of(c))
    {
      for(int i = 0; stroke.round && i < 3; ++i)
      {
        const std::vector<Stroke_point>& p = stroke.points;
        std::vector<Stroke_point> cut{p.front()};
        for(std::size_t k = 0; k + 1 < p.size(); ++k)
          for(double t : {0.25, 0.75})
            cut.push_back({(1 - t) * p[k][0] + t * p[k + 1][0], (1 - t) * p[k][1] + t * p[k + 1][1]});
        cut.push_back(p.back());
        stroke.points = std::move(cut);
      }
      for(std::size_t k = 0; k + 1 < stroke.points.size(); ++k)
      {
        const Stroke_point &p = stroke.points[k], &q = stroke.points[k + 1];
        lines.push_back({{p[0] + left, p[1]}, {q[0] + left, q[1]}});
      }
    }
    left += internal::width_of(c);
  }
  return lines;
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_STROKE_FONT_H
