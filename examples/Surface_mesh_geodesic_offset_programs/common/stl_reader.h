// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reader of .stl files, as text or binary. Corners of triangles with equal coordinates are one vertex; vertices are
// numbered by their first corner. Skips normals.

#ifndef GEODESIC_OFFSET_STL_READER_H
#define GEODESIC_OFFSET_STL_READER_H

#include "byte_scanner.h"
#include "off_reader.h"
#include "soup.h"
#include "text_scanner.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace geodesic_offset::internal {

// Point indices by coordinates: a hash table with open addressing, at most half full.
class Point_indices
{
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::vector<Point>& m_points;
  std::vector<std::uint32_t> m_slots;

public:
  explicit Point_indices(std::vector<Point>& points) : m_points(points), m_slots(1024, none) {}

  // Returns the index of a point; adds new points.
  std::uint32_t operator()(std::array<double, 3> c)
  {
    for(double& x : c) x += 0.0; // -0 and 0 are the same coordinate
    const Point point(c[0], c[1], c[2]);
    std::size_t slot = slot_of(point);
    if(m_slots[slot] != none) return m_slots[slot];
    if(2 * (m_points.size() + 1) > m_slots.size())
    {
      m_slots.assign(2 * m_slots.size(), none);
      for(std::size_t i = 0; i < m_points.size(); ++i) m_slots[slot_of(m_points[i])] = static_cast<std::uint32_t>(i);
      slot = slot_of(point);
    }
    m_slots[slot] = static_cast<std::uint32_t>(m_points.size());
    m_points.push_back(point);
    return m_slots[slot];
  }

private:
  // Slot of a point, or the free slot for it.
  std::size_t slot_of(const Point& point) const
  {
    std::uint64_t hash = 0;
    for(int i = 0; i < 3; ++i)
    {
      const double x = point[i];
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof(bits));
      // two multiplications by the golden ratio of 2^64, which move low bits up, each with a shift that moves them down
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    std::size_t slot = hash & (m_slots.size() - 1);
    while(m_slots[slot] != none && m_points[m_slots[slot]] != point) slot = (slot + 1) & (m_slots.size() - 1);
    return slot;
  }
};

class Stl_reader
{
  static constexpr std::size_t header_size = 84, triangle_size = 50; // bytes of a binary file

  Text_scanner m_text;
  std::string_view m_bytes;
  Soup& m_soup;
  Point_indices m_indices;

public:
  Stl_reader(const std::string& path, std::string_view bytes, Soup& soup)
    : m_text(path, bytes, Text_style::plain), m_bytes(bytes), m_soup(soup), m_indices(soup.points)
  {
  }

  // Throws Input_error.
  void operator()()
  {
    // the header of a binary file may also begin with "solid"
    if(has_binary_size() || !begins_with_solid())
      read_binary();
    else
      read_text();
    if(m_soup.polygons.empty()) m_text.fail("the file has no facets");
  }

private:
  std::size_t announced_triangles() const
  {
    return Byte_scanner(m_bytes.substr(header_size - 4, 4), false).read<std::uint32_t>();
  }

  bool has_binary_size() const
  {
    return m_bytes.size() >= header_size && m_bytes.size() == header_size + triangle_size * announced_triangles();
  }

  bool begins_with_solid() const
  {
    Text_scanner text = m_text;
    return text.find_word() && is(text.word(), "solid");
  }

  static bool is(std::string_view word, std::string_view keyword)
  {
    return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                      [](unsigned char a, char b) { return std::tolower(a) == b; });
  }

  void read_binary()
  {
    if(m_bytes.size() < header_size)
      m_text.fail("the file is neither text that begins with solid nor as long as the header of a binary file");
    const std::size_t triangles = announced_triangles();
    Byte_scanner bytes(m_bytes.substr(header_size), false);
    if(bytes.remaining() / triangle_size < triangles)
      m_text.fail(missing("facets", bytes.remaining() / triangle_size, triangles));
    m_soup.polygons.reserve(triangles);
    for(std::size_t i = 0; i < triangles; ++i)
    {
      bytes.skip(12); // the normal
      Polygon polygon(3);
      for(std::uint32_t& v : polygon)
      {
        std::array<double, 3> c;
        for(double& x : c)
        {
          x = static_cast<double>(bytes.read<float>());
          if(!std::isfinite(x)) m_text.fail("facet " + std::to_string(i) + " has a coordinate that is not finite");
        }
        v = m_indices(c);
      }
      m_soup.polygons.push_back(std::move(polygon));
      bytes.skip(2); // attributes
    }
    if(bytes.remaining() != 0) m_soup.remarks.push_back(counted(bytes.remaining(), "byte") + " behind the last facet left out");
  }

  std::string facet() const { return "facet " + std::to_string(m_soup.polygons.size()); }

  void expect(std::string_view keyword)
  {
    if(!m_text.find_word()) m_text.fail("the file ends within " + facet());
    const std::string_view word = m_text.word();
    if(!is(word, keyword))
      m_text.fail_here(quoted(std::string(keyword)) + " of " + facet() + " is expected here, not " + quoted_word(word));
  }

  void read_text()
  {
    bool is_in_solid = false;
    for(bool is_word = m_text.find_word(); is_word; is_word = m_text.find_word())
    {
      const std::string_view word = m_text.word();
      if(is(word, is_in_solid ? "endsolid" : "solid"))
      {
        is_in_solid = !is_in_solid;
        m_text.next_line(); // the name
      }
      else if(is_in_solid && is(word, "facet"))
        read_facet();
      else
        m_text.fail_here(std::string(is_in_solid ? "'facet' or 'endsolid'" : "'solid'") + " is expected here, not " +
                         quoted_word(word));
    }
    if(is_in_solid) m_text.fail("the file ends without endsolid, after " + counted(m_soup.polygons.size(), "facet"));
  }

  void read_facet()
  {
    m_text.next_line(); // the normal
    expect("outer");
    expect("loop");
    Polygon polygon(3);
    const auto name = [&] { return "a vertex of " + facet(); };
    for(std::uint32_t& v : polygon)
    {
      expect("vertex");
      v = m_indices(m_text.coordinates(name, [](const std::string& message) { throw Input_error(message); }));
    }
    expect("endloop");
    expect("endfacet");
    m_soup.polygons.push_back(std::move(polygon));
  }
};

} // namespace geodesic_offset::internal

#endif // GEODESIC_OFFSET_STL_READER_H
