// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reader of .off files: [ST][C][N][4][n]OFF, as text or binary. Skips texture coordinates, colours and normals. In text,
// each vertex is on a separate line, since colours have no fixed number of words; the vertex indices of a face may continue
// on further lines.

#ifndef GEODESIC_OFFSET_OFF_READER_H
#define GEODESIC_OFFSET_OFF_READER_H

#include "byte_scanner.h"
#include "soup.h"
#include "text_scanner.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace geodesic_offset::internal {

// For example "the file ends after 3 of 8 vertices".
inline std::string missing(const std::string& elements, std::size_t found, std::size_t announced)
{
  return "the file ends after " + std::to_string(found) + " of " + std::to_string(announced) + ' ' + elements;
}

class Off_reader
{
  Text_scanner m_text;
  std::string_view m_bytes;
  Soup& m_soup;

  bool m_has_textures = false, m_has_colors = false, m_has_normals = false;
  bool m_is_homogeneous = false, m_has_dimension = false, m_is_binary = false;
  std::size_t m_vertices = 0, m_faces = 0;
  std::size_t m_long_face = 0, m_long_line = 0; // first face whose indices continue on another line; line 0: none

public:
  Off_reader(const std::string& path, std::string_view bytes, Soup& soup)
    : m_text(path, bytes, Text_style::with_comments), m_bytes(bytes), m_soup(soup)
  {
  }

  // Throws Input_error.
  void operator()()
  {
    read_keyword();
    if(m_is_binary) return read_binary();
    read_sizes();
    // a coordinate or an index has at least a digit and a blank
    m_soup.points.reserve(std::min(m_vertices, m_text.remaining() / 6 + 1));
    for(std::size_t i = 0; i < m_vertices; ++i) read_vertex(i);
    m_soup.polygons.reserve(std::min(m_faces, m_text.remaining() / 6 + 1));
    for(std::size_t i = 0; i < m_faces; ++i) read_face(i);
  }

private:
  // Removes a prefix of the keyword; returns whether it was there.
  static bool takes(std::string_view& keyword, std::string_view part)
  {
    if(keyword.substr(0, part.size()) != part) return false;
    keyword.remove_prefix(part.size());
    return true;
  }

  void read_keyword()
  {
    if(!m_text.find_word()) m_text.fail("the file does not begin with OFF");
    std::string_view keyword = m_text.word();
    m_has_textures = takes(keyword, "ST");
    m_has_colors = takes(keyword, "C");
    m_has_normals = takes(keyword, "N");
    m_is_homogeneous = takes(keyword, "4");
    m_has_dimension = takes(keyword, "n");
    if(keyword != "OFF") m_text.fail("the file does not begin with OFF");
    if(m_text.is_at_line_end()) return;
    Text_scanner rest = m_text;
    m_is_binary = (rest.word() == "BINARY");
    if(m_is_binary) m_text = rest;
  }

  void require_dimension(std::size_t dimension) const
  {
    if(dimension != 3) m_text.fail("its points have " + counted(dimension, "coordinate") + "; three are expected");
  }

  void require_sizes() const
  {
    if(m_vertices == 0 || m_faces == 0) m_text.fail(std::string("the file has no ") + (m_vertices == 0 ? "vertices" : "faces"));
  }

  void read_sizes()
  {
    const auto size = [&] {
      std::size_t value = 0;
      if(!m_text.find_word()) m_text.fail("the file ends before the numbers of vertices and faces");
      if(!m_text.read(value))
        m_text.fail_here("the numbers of vertices and faces are expected here, not " + quoted_word(m_text.word()));
      return value;
    };
    if(m_has_dimension) require_dimension(size());
    m_vertices = size();
    m_faces = size();
    require_sizes();
    if(!m_text.is_at_line_end()) // number of edges, unused
      m_text.next_line();
  }

  void add_point(double x, double y, double z, double w)
  {
    if(m_is_homogeneous)
    {
      x /= w;
      y /= w;
      z /= w;
    }
    m_soup.points.emplace_back(x, y, z);
  }

  void read_vertex(std::size_t i)
  {
    if(!m_text.find_word()) m_text.fail(missing("vertices", i, m_vertices));
    const auto name = [&] { return "vertex " + std::to_string(i); };
    const auto [x, y, z] =
      m_text.coordinates(name, [&](const std::string& message) { m_soup.not_finite.emplace_back(i, message); });
    double w = 1;
    if(m_is_homogeneous)
    {
      Text_scanner fourth = m_text;
      if(!m_text.read(w) || w == 0)
        m_text.fail_here(name() + " has the fourth coordinate " + quoted_word(fourth.word()) + "; a number but 0 is expected");
    }
    add_point(x, y, z, w);
    m_text.next_line();
  }

  // If an earlier face continued on the next line, that face is probably the error.
  [[noreturn]] void fail_in_faces(const std::string& text) const
  {
    if(m_long_line != 0)
      m_text.fail_at(m_long_line, "face " + std::to_string(m_long_face) + " has fewer vertex indices than it announces");
    m_text.fail(text);
  }

  void read_face(std::size_t i)
  {
    if(!m_text.find_word()) fail_in_faces(missing("faces", i, m_faces));
    const auto fail = [&](const std::string& what) {
      fail_in_faces("line " + std::to_string(m_text.line()) + ": face " + std::to_string(i) + " has " + what);
    };
    std::size_t size = 0;
    if(!m_text.read(size)) fail(quoted_word(m_text.word()) + " vertices");
    if(size < 3) fail("only " + counted(size, "vertex", "vertices"));
    m_soup.polygons.emplace_back();
    Polygon& polygon = m_soup.polygons.back();
    polygon.reserve(std::min(size, m_text.remaining() / 2 + 1));
    for(std::size_t k = 0; k < size; ++k)
    {
      if(m_text.is_at_line_end())
      {
        if(m_long_line == 0)
        {
          m_long_line = m_text.line();
          m_long_face = i;
        }
        if(!m_text.find_word()) fail_in_faces(missing("faces", i, m_faces));
      }
      std::size_t index = 0;
      Text_scanner here = m_text;
      if(!m_text.read(index) || index >= m_vertices)
        fail("the vertex index " + quoted_word(here.word()) + ", but there are " + counted(m_vertices, "vertex", "vertices"));
      polygon.push_back(static_cast<std::uint32_t>(index));
    }
    m_text.next_line(); // colour
  }

  // Geomview's binary format: big endian, 32 bits per number.
  void read_binary()
  {
    m_text.next_line();
    Byte_scanner bytes(m_bytes.substr(m_text.position()), true);
    const auto size = [&](const char* what) {
      if(bytes.remaining() < 4) m_text.fail("the file ends before the numbers of vertices and faces");
      const std::int32_t value = bytes.read<std::int32_t>();
      if(value < 0) m_text.fail("the number of " + std::string(what) + " is " + std::to_string(value));
      return static_cast<std::size_t>(value);
    };
    if(m_has_dimension) require_dimension(size("coordinates"));
    m_vertices = size("vertices");
    m_faces = size("faces");
    size("edges");
    require_sizes();
    read_binary_vertices(bytes);
    read_binary_faces(bytes);
    if(bytes.remaining() != 0) m_soup.remarks.push_back(counted(bytes.remaining(), "byte") + " behind the last face left out");
  }

  void read_binary_vertices(Byte_scanner& bytes)
  {
    const std::size_t coordinates = m_is_homogeneous ? 4 : 3;
    const std::size_t others =
      (m_has_normals ? coordinates : 0) + (m_has_colors ? 4 : 0) + (m_has_textures ? coordinates - 1 : 0);
    const std::size_t row = 4 * (coordinates + others);
    if(bytes.remaining() / row < m_vertices) m_text.fail(missing("vertices", bytes.remaining() / row, m_vertices));
    m_soup.points.reserve(m_vertices);
    for(std::size_t i = 0; i < m_vertices; ++i)
    {
      double c[4] = {0, 0, 0, 1};
      for(std::size_t k = 0; k < coordinates; ++k) c[k] = bytes.read<float>();
      if(c[3] == 0) m_text.fail("vertex " + std::to_string(i) + " has the fourth coordinate 0");
      add_point(c[0], c[1], c[2], c[3]);
      bytes.skip(4 * others);
    }
  }

  void read_binary_faces(Byte_scanner& bytes)
  {
    m_soup.polygons.reserve(std::min(m_faces, bytes.remaining() / 20 + 1));
    for(std::size_t i = 0; i < m_faces; ++i)
    {
      const auto require = [&](std::size_t numbers) {
        if(bytes.remaining() / 4 < numbers) m_text.fail(missing("faces", i, m_faces));
      };
      const auto fail = [&](const std::string& what) { m_text.fail("face " + std::to_string(i) + " has " + what); };
      require(1);
      const std::int32_t size = bytes.read<std::int32_t>();
      if(size < 3) fail(std::to_string(size) + " vertices");
      require(static_cast<std::size_t>(size) + 1);
      m_soup.polygons.emplace_back();
      m_soup.polygons.back().reserve(static_cast<std::size_t>(size));
      for(std::int32_t k = 0; k < size; ++k)
      {
        const std::int32_t index = bytes.read<std::int32_t>();
        if(index < 0 || static_cast<std::size_t>(index) >= m_vertices)
          fail("the vertex index " + quoted(std::to_string(index)) + ", but there are " +
               counted(m_vertices, "vertex", "vertices"));
        m_soup.polygons.back().push_back(static_cast<std::uint32_t>(index));
      }
      const std::int32_t components = bytes.read<std::int32_t>();
      if(components < 0 || components > 4) fail("a colour of " + std::to_string(components) + " numbers; 0 to 4 are expected");
      require(static_cast<std::size_t>(components));
      bytes.skip(4 * static_cast<std::size_t>(components));
    }
  }
};

} // namespace geodesic_offset::internal

#endif // GEODESIC_OFFSET_OFF_READER_H
