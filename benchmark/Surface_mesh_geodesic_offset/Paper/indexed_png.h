// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// PNG files with a palette: a third of the size of files with all colours.

#ifndef GEODESIC_OFFSET_BENCHMARK_INDEXED_PNG_H
#define GEODESIC_OFFSET_BENCHMARK_INDEXED_PNG_H

#include "common/picture.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace paper {

/// Palette by median cut: the group of colours with the largest weighted range is divided at the median of its widest channel
/// until there are enough groups.
class Palette
{
  typedef std::array<std::uint8_t, 3> Colour;
  typedef std::pair<Colour, std::size_t> Counted_colour;

  struct Group
  {
    std::vector<Counted_colour> colours;
    std::size_t pixels = 0, channel = 0;
    double weight = 0; // range of the widest channel times the root of the number of pixels

    explicit Group(std::vector<Counted_colour> c) : colours(std::move(c))
    {
      int widest = -1;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const auto ends = std::minmax_element(colours.begin(), colours.end(), [k](const auto& a, const auto& b) {
          return a.first[k] < b.first[k];
        });
        const int range = ends.second->first[k] - ends.first->first[k];
        if (range <= widest) continue;
        widest = range;
        channel = k;
      }
      for (const Counted_colour& x : colours) pixels += x.second;
      weight = widest * std::sqrt(static_cast<double>(pixels));
    }
  };

public:
  Palette(const std::vector<std::uint8_t>& bytes, std::size_t size)
  {
    std::map<Colour, std::size_t> counts;
    for (std::size_t i = 0; i + 2 < bytes.size(); i += 3) ++counts[{bytes[i], bytes[i + 1], bytes[i + 2]}];
    std::vector<Group> groups{Group({counts.begin(), counts.end()})};
    while (groups.size() < size)
    {
      const auto largest =
        std::max_element(groups.begin(), groups.end(), [](const Group& a, const Group& b) { return a.weight < b.weight; });
      if (!(largest->weight > 0)) break;
      std::vector<Counted_colour> lower = std::move(largest->colours);
      std::sort(lower.begin(), lower.end(),
                [k = largest->channel](const auto& a, const auto& b) { return a.first[k] < b.first[k]; });
      std::size_t cut = 0;
      for (std::size_t sum = 0; cut + 1 < lower.size() && 2 * (sum + lower[cut].second) <= largest->pixels; ++cut)
        sum += lower[cut].second;
      cut = (std::max)(cut, std::size_t(1));
      const std::vector<Counted_colour> upper(lower.begin() + static_cast<std::ptrdiff_t>(cut), lower.end());
      lower.resize(cut);
      *largest = Group(std::move(lower));
      groups.emplace_back(upper);
    }
    for (const Group& g : groups)
      for (std::size_t k = 0; k < 3; ++k)
      {
        std::size_t sum = g.pixels / 2;
        for (const Counted_colour& c : g.colours) sum += c.first[k] * c.second;
        m_entries.push_back(static_cast<std::uint8_t>(sum / g.pixels));
      }
    for (const auto& c : counts) m_index[c.first] = nearest(c.first);
  }

  /// three bytes per colour
  const std::vector<std::uint8_t>& entries() const { return m_entries; }

  std::uint8_t index(std::uint8_t r, std::uint8_t g, std::uint8_t b) const { return m_index.at({r, g, b}); }

private:
  std::uint8_t nearest(const Colour& c) const
  {
    std::size_t result = 0;
    int least = 3 * 256 * 256;
    for (std::size_t i = 0; i < m_entries.size() / 3; ++i)
    {
      int d = 0;
      for (std::size_t k = 0; k < 3; ++k) d += (c[k] - m_entries[3 * i + k]) * (c[k] - m_entries[3 * i + k]);
      if (d >= least) continue;
      least = d;
      result = i;
    }
    return static_cast<std::uint8_t>(result);
  }

  std::vector<std::uint8_t> m_entries;
  std::map<Colour, std::uint8_t> m_index;
};

inline void write_indexed_png(const std::string& file, const geodesic_offset::Image& image)
{
  constexpr std::size_t colours = 200;
  const Palette palette(image.bytes, colours);
  std::vector<std::uint8_t> indices;
  for (std::size_t i = 0; i < image.bytes.size(); i += 3)
    indices.push_back(palette.index(image.bytes[i], image.bytes[i + 1], image.bytes[i + 2]));
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB_COLORMAP;
  png.colormap_entries = static_cast<png_uint_32>(palette.entries().size() / 3);
  if (!png_image_write_to_file(&png, file.c_str(), 0, indices.data(), 0, palette.entries().data()))
    throw std::runtime_error("cannot write " + file + ": " + png.message);
}

} // namespace paper

#endif // GEODESIC_OFFSET_BENCHMARK_INDEXED_PNG_H
