// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reader of .ply files as meshes: coordinates of every number type, and faces as lists of every integer type. Skips other
// elements and properties.

#ifndef GEODESIC_OFFSET_PLY_READER_H
#define GEODESIC_OFFSET_PLY_READER_H

#include "ply_file.h"
#include "soup.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace geodesic_offset::internal {

class Ply_reader
{
  Ply_file m_file;
  Soup& m_soup;
  std::size_t m_vertices = 0; // as announced

  // Reader of the vertex rows.
  class Vertex_rows
  {
    const Ply_reader& m_reader;
    Soup& m_soup;
    std::size_t m_columns[3];
    std::size_t m_row = 0;
    std::size_t m_found = 0;
    double m_coordinates[3] = {0, 0, 0};

  public:
    Vertex_rows(const Ply_reader& reader, Soup& soup, const Ply_element& vertices)
      : m_reader(reader), m_soup(soup), m_columns{vertices.find("x"), vertices.find("y"), vertices.find("z")}
    {
    }

    void begin_row(std::size_t row)
    {
      m_row = row;
      m_found = 0;
    }

    bool reads(std::size_t property) const
    {
      return property == m_columns[0] || property == m_columns[1] || property == m_columns[2];
    }

    void begin_list(std::size_t, std::size_t) {}

    void number(std::size_t property, double value)
    {
      if(!std::isfinite(value) && is_first_not_finite())
        m_soup.not_finite.emplace_back(m_row, m_reader.m_file.message(text(std::isnan(value) ? "nan" : "inf")));
      for(std::size_t c = 0; c < 3; ++c)
        if(m_columns[c] == property) m_coordinates[c] = value;
      if(++m_found == 3) m_soup.points.emplace_back(m_coordinates[0], m_coordinates[1], m_coordinates[2]);
    }

    void word(std::size_t property, std::string_view word)
    {
      double value = std::numeric_limits<double>::quiet_NaN();
      if(!parse_number(word, value))
      {
        if(!is_not_finite(word)) m_reader.m_file.fail(text(word));
        if(is_first_not_finite()) m_soup.not_finite.emplace_back(m_row, m_reader.m_file.message(text(word)));
      }
      number(property, value);
    }

  private:
    bool is_first_not_finite() const { return m_soup.not_finite.empty() || m_soup.not_finite.back().first != m_row; }

    std::string text(std::string_view word) const
    {
      return m_reader.m_file.where() + "vertex " + std::to_string(m_row) + " has the coordinate " + quoted_word(word) +
             ", which is not a finite number";
    }
  };

  // Reader of the face rows.
  class Face_rows
  {
    const Ply_reader& m_reader;
    Soup& m_soup;
    std::size_t m_column;

  public:
    Face_rows(const Ply_reader& reader, Soup& soup, std::size_t column) : m_reader(reader), m_soup(soup), m_column(column) {}

    void begin_row(std::size_t) {}
    bool reads(std::size_t property) const { return property == m_column; }

    void begin_list(std::size_t, std::size_t size)
    {
      m_soup.polygons.emplace_back();
      m_soup.polygons.back().reserve(size);
    }

    void number(std::size_t, double value)
    {
      if(!(value >= 0 && value < static_cast<double>(m_reader.m_vertices)))
        fail(std::to_string(static_cast<std::int64_t>(value)));
      m_soup.polygons.back().push_back(static_cast<std::uint32_t>(value));
    }

    void word(std::size_t, std::string_view word)
    {
      std::size_t index = 0;
      if(!parse_index(word, index) || index >= m_reader.m_vertices) fail(word);
      m_soup.polygons.back().push_back(static_cast<std::uint32_t>(index));
    }

  private:
    [[noreturn]] void fail(std::string_view word) const
    {
      m_reader.m_file.fail(m_reader.m_file.where() + "face " + std::to_string(m_soup.polygons.size() - 1) +
                           " has the vertex index " + quoted_word(word) + ", but there are " +
                           counted(m_reader.m_vertices, "vertex", "vertices"));
    }
  };

public:
  Ply_reader(const std::string& path, std::string_view bytes, Soup& soup) : m_file(path, bytes), m_soup(soup) {}

  // Throws Input_error.
  void operator()()
  {
    const Ply_element& vertices = element(&Ply_element::is_vertex, "vertices");
    const Ply_element& faces = element(&Ply_element::is_face, "faces");
    m_vertices = vertices.number;
    require_coordinates(vertices);
    const std::size_t indices = column_of_indices(faces);
    for(const Ply_element& e : m_file.elements())
      if(&e == &vertices)
      {
        m_soup.points.reserve(m_file.most_rows(e));
        m_file.read_rows(e, Vertex_rows(*this, m_soup, e));
      }
      else if(&e == &faces)
      {
        m_soup.polygons.reserve(m_file.most_rows(e));
        m_file.read_rows(e, Face_rows(*this, m_soup, indices));
      }
      else
        m_file.skip_rows(e);
    if(const std::size_t left = m_file.number_of_bytes_left(); left != 0)
      m_soup.remarks.push_back(counted(left, "byte") + " behind the last element left out");
  }

private:
  const Ply_element& element(bool (Ply_element::*is_it)() const, const std::string& name) const
  {
    for(const Ply_element& e : m_file.elements())
      if((e.*is_it)() && e.number != 0) return e;
    m_file.fail("its header announces no " + name);
  }

  void require_coordinates(const Ply_element& vertices) const
  {
    for(const char* coordinate : {"x", "y", "z"})
    {
      if(!vertices.has(coordinate)) m_file.fail("its vertices have no property " + std::string(coordinate));
      const Ply_property& property = vertices.properties[vertices.find(coordinate)];
      if(property.is_list())
        m_file.fail("the property " + quoted(coordinate) + " of its vertices has the type " + quoted(property.type_name) +
                    "; a number is expected");
    }
  }

  std::size_t column_of_indices(const Ply_element& faces) const
  {
    for(const char* name : {"vertex_indices", "vertex_index"})
    {
      if(!faces.has(name)) continue;
      const Ply_property& property = faces.properties[faces.find(name)];
      if(!property.is_list() || is_real(property.type))
        m_file.fail("the property " + quoted(name) + " of its faces has the type " + quoted(property.type_name) +
                    "; a list of whole numbers is expected");
      return faces.find(name);
    }
    m_file.fail("its faces have no property vertex_indices");
  }
};

} // namespace geodesic_offset::internal

#endif // GEODESIC_OFFSET_PLY_READER_H
