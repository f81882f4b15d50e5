// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances in a text file: one per line in the order of the vertices, or lines with a vertex and its distance. The first
// line decides.

#ifndef VALIDATE_GEODESIC_DISTANCES_TEXT_TABLE_H
#define VALIDATE_GEODESIC_DISTANCES_TEXT_TABLE_H

#include "common/messages.h"
#include "common/numbers.h"
#include "common/text_scanner.h"
#include "distance_table.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace geodesic_offset {

class Text_table_reader
{
  const std::string& m_path;
  const std::string& m_mesh;
  std::vector<double> m_distances;
  std::vector<std::size_t> m_lines; // lines of the vertices, 0 if not yet listed

public:
  Text_table_reader(const std::string& path, const std::string& mesh, std::size_t vertices)
    : m_path(path), m_mesh(mesh), m_distances(vertices, 0), m_lines(vertices, 0)
  {
  }

  // Throws Input_error.
  Distance_table operator()(std::string_view bytes)
  {
    Text_scanner text(m_path, bytes, Text_style::with_comments);
    std::size_t columns = 0, rows = 0;
    for(; text.find_word(); text.next_line(), ++rows)
    {
      std::vector<std::string_view> words;
      while(!text.is_at_line_end()) words.push_back(text.word());
      if(columns == 0) columns = words.size();
      if(columns > 2)
        throw Input_error(where(text) + "a distance, or a vertex and its distance, is expected here, not " +
                          counted(columns, "word"));
      if(words.size() != columns)
        throw Input_error(where(text) + counted(words.size(), "word") + ", but the first line has " + std::to_string(columns));
      add(where(text), columns == 1 ? rows : vertex(where(text), words[0]), words.back(), text.line());
    }
    if(rows == 0) throw Input_error(quoted(m_path) + " has no distances");
    check_complete(columns, rows);
    return {quoted(m_path), std::move(m_distances), {}};
  }

private:
  std::string where(const Text_scanner& text) const { return quoted(m_path) + ", line " + std::to_string(text.line()) + ": "; }

  std::string vertices_of_mesh() const { return quoted(m_mesh) + " has " + counted(m_lines.size(), "vertex", "vertices"); }

  std::size_t vertex(const std::string& where, std::string_view word) const
  {
    std::size_t index = 0;
    if(!parse_index(word, index)) throw Input_error(where + quoted_word(word) + " is not the index of a vertex");
    if(index >= m_lines.size())
      throw Input_error(where + "there is no vertex " + std::to_string(index) + ", as " + vertices_of_mesh() + ", from 0");
    return index;
  }

  void add(const std::string& where, std::size_t vertex, std::string_view word, std::size_t line)
  {
    if(vertex >= m_lines.size())
      throw Input_error(where + "this is distance number " + std::to_string(vertex + 1) + ", but " + vertices_of_mesh());
    if(m_lines[vertex] != 0)
      throw Input_error(where + "vertex " + std::to_string(vertex) + " has a distance already, on line " +
                        std::to_string(m_lines[vertex]));
    m_distances[vertex] = internal::parsed_distance(where, vertex, word);
    m_lines[vertex] = line;
  }

  void check_complete(std::size_t columns, std::size_t rows) const
  {
    const auto missing = std::find(m_lines.begin(), m_lines.end(), std::size_t(0));
    if(missing == m_lines.end()) return;
    const std::string count = quoted(m_path) + " has only " + counted(rows, "distance") + ", but " + vertices_of_mesh();
    throw Input_error(columns == 1
                        ? count
                        : count + ": the first without a distance is vertex " + std::to_string(missing - m_lines.begin()));
  }
};

} // namespace geodesic_offset

#endif // VALIDATE_GEODESIC_DISTANCES_TEXT_TABLE_H
