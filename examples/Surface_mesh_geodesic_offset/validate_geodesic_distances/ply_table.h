// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances as a property of the vertices in a PLY file. CGAL reads the binary formats; it does not take inf in text, so
// the lines of an ASCII file are read here.

#ifndef VALIDATE_GEODESIC_DISTANCES_PLY_TABLE_H
#define VALIDATE_GEODESIC_DISTANCES_PLY_TABLE_H

#include "../geodesic_offset/common.h"
#include "../geodesic_offset/file_diagnosis.h"
#include "../geodesic_offset/memory_guard.h"
#include "../geodesic_offset/numbers.h"
#include "../geodesic_offset/soup_reader.h"
#include "distance_table.h"

#include <CGAL/IO/read_ply_points.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <new>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <system_error>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace geodesic_offset {

class Ply_table_reader
{
  using Element = internal::Ply_element;
  using Row     = std::tuple<double, Point>;

  const std::string& m_path;
  const std::string& m_mesh;
  std::size_t        m_vertices; // of the mesh

  bool                 m_is_ascii = false;
  std::vector<Element> m_elements;
  std::size_t          m_element = 0; // the one of the vertices
  std::string          m_property;
  bool                 m_has_points = false;
  Distance_table       m_table;

public:
  Ply_table_reader(const std::string& path, const std::string& mesh, std::size_t vertices)
    : m_path(path), m_mesh(mesh), m_vertices(vertices)
  {
  }

  // property: empty for the first of the usual names. Throws Input_error.
  Distance_table operator()(const std::string& property)
  {
    std::ifstream stream = internal::open_input(m_path);
    internal::Line_reader lines(stream);
    const std::string wrong = internal::read_ply_header(lines, m_is_ascii, m_elements);
    if(!wrong.empty())
      fail(wrong);
    find_vertices();
    find_property(property);
    m_table.name = named_property() + " of " + quoted(m_path);
    if(m_is_ascii)
      read_ascii(lines);
    else
      read_binary();
    return std::move(m_table);
  }

private:
  [[noreturn]] void fail(const std::string& reason) const
  {
    throw Input_error("cannot read " + quoted(m_path) + ": " + reason);
  }

  std::string named_property() const { return "property " + quoted(m_property); }

  static bool is_real(const std::string& type)
  {
    return type == "float" || type == "double" || type == "float32" || type == "float64";
  }

  static bool is_integer(const std::string& type)
  {
    const auto types = {"char", "uchar", "short", "ushort", "int", "uint", "int8", "uint8", "int16", "uint16", "int32",
                        "uint32"};
    return std::find(types.begin(), types.end(), type) != types.end();
  }

  static bool is_list(const std::string& type) { return type.compare(0, 5, "list ") == 0; }

  // CGAL leaves out properties of other types, and takes their bytes for those of the next one.
  static bool is_known(const std::string& type)
  {
    if(!is_list(type))
      return is_real(type) || is_integer(type);
    const std::vector<std::string> words = words_of(type);
    return words.size() == 3 && is_integer(words[1]) && (is_real(words[2]) || is_integer(words[2]));
  }

  // The number of the property, or that of all properties if there is none
  std::size_t column(const std::string& name) const
  {
    const std::vector<std::string>& names = m_elements[m_element].properties;
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  }

  bool has_real(const std::string& name) const
  {
    const std::vector<std::string>& types = m_elements[m_element].types;
    return column(name) < types.size() && is_real(types[column(name)]);
  }

  void find_vertices()
  {
    while(m_element < m_elements.size() && !m_elements[m_element].is_vertex())
      ++m_element;
    if(m_element == m_elements.size())
      fail("its header announces no vertices");
    for(const Element& e : m_elements)
    {
      if(e.properties.empty() && e.number != 0)
        fail("the element '" + e.name + "' has no properties");
      for(std::size_t i = 0; i < e.types.size(); ++i)
        if(!is_known(e.types[i]))
          fail("the property '" + e.properties[i] + "' has the unknown type '" + e.types[i] + "'");
    }
    if(m_elements[m_element].number != m_vertices)
      throw Input_error(quoted(m_path) + " has " + counted(m_elements[m_element].number, "vertex", "vertices") + ", but " +
                        quoted(m_mesh) + " has " + std::to_string(m_vertices));
    m_has_points = has_real("x") && has_real("y") && has_real("z");
  }

  void find_property(const std::string& property)
  {
    const Element& vertices = m_elements[m_element];
    m_property = property;
    if(property.empty())
      for(const char* name : {"value", "geodesic", "geodesic_distance", "scalar", "quality", "distance"})
        if(column(name) < vertices.properties.size())
          m_property = name;
    if(column(m_property) == vertices.properties.size())
    {
      std::string names;
      for(const std::string& name : vertices.properties)
        names += (names.empty() ? "" : ", ") + name;
      throw Input_error(quoted(m_path) + ": its vertices have " +
                        (property.empty() ? "no property with a usual name for distances (--property names one)"
                                          : "no property " + quoted(property)) +
                        "; they have " + names);
    }
    if(!has_real(m_property))
      throw Input_error(quoted(m_path) + ": the " + named_property() + " of its vertices has the type " +
                        vertices.types[column(m_property)] + "; float or double is needed");
  }

  void read_ascii(internal::Line_reader& lines)
  {
    std::vector<std::string> words;
    for(std::size_t e = 0; e < m_element; ++e)
      for(std::size_t i = 0; i < m_elements[e].number; ++i)
        if(!lines.next(words))
          fail(internal::missing("elements '" + m_elements[e].name + "'", i, m_elements[e].number));

    const std::vector<std::string>& types = m_elements[m_element].types;
    const std::size_t distance = column(m_property);
    const std::array<std::size_t, 3> xyz = {column("x"), column("y"), column("z")};
    const std::size_t last = m_has_points ? std::max({distance, xyz[0], xyz[1], xyz[2]}) : distance;
    if(std::any_of(types.begin(), types.begin() + static_cast<std::ptrdiff_t>(last), is_list))
      fail("lists in front of the " + named_property() + " can be read in binary files only");
    for(std::size_t i = 0; i < m_vertices; ++i)
    {
      if(!lines.next(words))
        fail(internal::missing("vertices", i, m_vertices));
      const std::string where = quoted(m_path) + ", line " + std::to_string(lines.number()) + ", ";
      if(words.size() <= last)
        throw Input_error(where + "vertex " + std::to_string(i) + " has only " + counted(words.size(), "word") + " of " +
                          std::to_string(types.size()));
      m_table.distances.push_back(internal::parsed_distance(where + named_property() + ": ", i, words[distance]));
      if(m_has_points)
        m_table.points.push_back(point(where, i, words, xyz));
    }
  }

  static Point point(const std::string& where, std::size_t vertex, const std::vector<std::string>& words,
                     const std::array<std::size_t, 3>& xyz)
  {
    double c[3] = {0, 0, 0};
    for(std::size_t k = 0; k < 3; ++k)
      if(!parse_number(words[xyz[k]], c[k]))
        throw Input_error(where + "vertex " + std::to_string(vertex) + " has the coordinate " +
                          quoted(words[xyz[k]].substr(0, 40)) + ", which is not a finite number");
    return Point(c[0], c[1], c[2]);
  }

  // The reader says on the stream of errors what is wrong with a header, and here there is one line for that.
  class Silent_errors
  {
    std::streambuf* m_buffer = std::cerr.rdbuf(nullptr);

  public:
    Silent_errors() = default;
    ~Silent_errors() { std::cerr.rdbuf(m_buffer); }
    Silent_errors(const Silent_errors&) = delete;
    Silent_errors& operator=(const Silent_errors&) = delete;
  };

  bool read_rows(std::istream& stream, std::vector<Row>& rows) const
  {
    const Silent_errors silent;
    const auto distance = std::make_pair(CGAL::Nth_of_tuple_property_map<0, Row>(),
                                         CGAL::IO::PLY_property<double>(m_property.c_str()));
    // copies, as the reader may move from what it is given
    if(m_has_points)
      return CGAL::IO::read_PLY_with_properties<Row>(
        stream, std::back_inserter(rows), std::decay_t<decltype(distance)>(distance),
        CGAL::IO::make_ply_point_reader(CGAL::Nth_of_tuple_property_map<1, Row>()));
    return CGAL::IO::read_PLY_with_properties<Row>(stream, std::back_inserter(rows),
                                                   std::decay_t<decltype(distance)>(distance));
  }

  void read_binary()
  {
    std::vector<Row> rows;
    bool read = false;
    try
    {
      std::ifstream stream = internal::open_input(m_path);
      std::error_code error;
      const std::uintmax_t size = std::filesystem::file_size(m_path, error);
      const Memory_guard guard(error ? 0 : size);
      read = read_rows(stream, rows);
    }
    catch(const std::bad_alloc&) { read = false; }
    catch(const std::length_error&) { read = false; }
    if(!read || rows.size() != m_vertices)
      fail("the file is truncated or malformed");
    for(std::size_t i = 0; i < rows.size(); ++i)
    {
      const double d = std::get<0>(rows[i]);
      if(!(d >= 0))
        throw Input_error(quoted(m_path) + ", " + named_property() + ": vertex " + std::to_string(i) +
                          " has the distance " + short_number(d) +
                          (d < 0 ? ", which is negative" : ", which is not a number"));
      m_table.distances.push_back(d);
      if(m_has_points)
        m_table.points.push_back(std::get<1>(rows[i]));
    }
  }
};

} // namespace geodesic_offset

#endif // VALIDATE_GEODESIC_DISTANCES_PLY_TABLE_H
