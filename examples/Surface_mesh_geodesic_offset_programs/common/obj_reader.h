// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reader of .obj files: lines "v" and "f"; skips all others. Vertices may follow the faces that use them.

#ifndef GEODESIC_OFFSET_OBJ_READER_H
#define GEODESIC_OFFSET_OBJ_READER_H

#include "soup.h"
#include "text_scanner.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace geodesic_offset::internal {

class Obj_reader
{
  Text_scanner m_text;
  Soup& m_soup;

  // The largest vertex index, from 1, with its line and face.
  std::size_t m_largest = 0, m_line_of_largest = 0, m_face_of_largest = 0;

public:
  Obj_reader(const std::string& path, std::string_view bytes, Soup& soup)
    : m_text(path, bytes, Text_style::with_comments_and_continuations), m_soup(soup)
  {
  }

  // Throws Input_error.
  void operator()()
  {
    for(bool is_word = m_text.find_word(); is_word; is_word = m_text.find_word_on_next_line())
    {
      const std::string_view keyword = m_text.word();
      if(keyword == "v")
        read_vertex();
      else if(keyword == "f")
        read_face();
      else if(std::any_of(keyword.begin(), keyword.end(), [](unsigned char c) { return !std::isgraph(c); }))
        m_text.fail("line " + std::to_string(m_text.line()) + " is not text");
    }
    const std::size_t vertices = m_soup.points.size();
    if(vertices == 0) m_text.fail("the file has no vertices");
    if(m_soup.polygons.empty()) m_text.fail("the file has no faces");
    if(m_largest > vertices)
      m_text.fail_at(m_line_of_largest, face(m_face_of_largest) + " has the vertex index " + quoted(std::to_string(m_largest)) +
                                          ", but there are " + counted(vertices, "vertex", "vertices"));
  }

private:
  static std::string face(std::size_t i) { return "face " + std::to_string(i); }

  void read_vertex()
  {
    const std::size_t i = m_soup.points.size();
    const auto name = [&] { return "vertex " + std::to_string(i); };
    const auto [x, y, z] =
      m_text.coordinates(name, [&](const std::string& message) { m_soup.not_finite.emplace_back(i, message); });
    m_soup.points.emplace_back(x, y, z); // a weight or a colour may follow
  }

  void read_face()
  {
    m_soup.polygons.emplace_back();
    Polygon& polygon = m_soup.polygons.back();
    polygon.reserve(3);
    while(!m_text.is_at_line_end()) polygon.push_back(read_index());
    if(polygon.size() < 3)
      m_text.fail_here(face(m_soup.polygons.size() - 1) + " has only " + counted(polygon.size(), "vertex", "vertices"));
  }

  // "7", "7/1", "7//3", "7/1/3", or counted backwards: "-2". Returns the index from 0.
  std::uint32_t read_index()
  {
    const std::string_view word = m_text.word();
    const bool is_backwards = word.front() == '-';
    const std::size_t vertices = m_soup.points.size();
    std::size_t index = 0;
    const std::string_view digits = word.substr(is_backwards ? 1 : 0, word.find('/') - (is_backwards ? 1 : 0));
    const bool is_index = parse_index(digits, index);
    if(!is_index || index == 0 || (is_backwards && index > vertices))
      m_text.fail_here(face(m_soup.polygons.size() - 1) + " has the vertex index " + quoted_word(word) +
                       (is_index && index != 0 ? ", beyond the " + counted(vertices, "vertex", "vertices") + " in front of it"
                                               : "; a whole number from 1, or from -1 downwards, is expected"));
    if(is_backwards) return static_cast<std::uint32_t>(vertices - index);
    if(index > m_largest)
    {
      m_largest = index;
      m_line_of_largest = m_text.line();
      m_face_of_largest = m_soup.polygons.size() - 1;
    }
    return static_cast<std::uint32_t>(index - 1);
  }
};

} // namespace geodesic_offset::internal

#endif // GEODESIC_OFFSET_OBJ_READER_H
