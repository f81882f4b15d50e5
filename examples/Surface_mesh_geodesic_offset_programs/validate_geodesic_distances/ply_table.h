// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances as a vertex property of a PLY file.
// Not CGAL::IO::read_PLY_with_properties() (5.5): it reads a missing property as zeros, crashes if the property has an integer
// type, and rejects text files with infinite distances, those of vertices that no path reaches.

#ifndef VALIDATE_GEODESIC_DISTANCES_PLY_TABLE_H
#define VALIDATE_GEODESIC_DISTANCES_PLY_TABLE_H

#include "common/messages.h"
#include "common/numbers.h"
#include "common/ply_file.h"
#include "distance_table.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace geodesic_offset {

class Ply_table_reader
{
  using Element = internal::Ply_element;
  using Property = internal::Ply_property;

  const std::string& m_path;
  const std::string& m_mesh;
  std::size_t m_vertices; // of the mesh
  std::string m_property;
  bool m_has_points = false;
  Distance_table m_table;

  // Reader of the vertex rows.
  class Rows
  {
    const internal::Ply_file& m_file;
    Ply_table_reader& m_reader;
    std::size_t m_distance;
    std::array<std::size_t, 3> m_xyz;
    std::size_t m_row = 0;
    std::size_t m_found = 0; // coordinates of the row
    double m_coordinates[3] = {0, 0, 0};

  public:
    Rows(const internal::Ply_file& file, Ply_table_reader& reader, const Element& vertices)
      : m_file(file), m_reader(reader),
        m_distance(vertices.find(reader.m_property)), m_xyz{vertices.find("x"), vertices.find("y"), vertices.find("z")}
    {
    }

    void begin_row(std::size_t row)
    {
      m_row = row;
      m_found = 0;
    }

    void begin_list(std::size_t, std::size_t) {}
    bool reads(std::size_t property) const { return property == m_distance || is_coordinate(property); }

    void number(std::size_t property, double value)
    {
      if(property == m_distance)
      {
        if(!(value >= 0))
          throw Input_error(where() + "vertex " + std::to_string(m_row) + " has the distance " + short_number(value) +
                            (value < 0 ? ", which is negative" : ", which is not a number"));
        m_reader.m_table.distances.push_back(value);
      }
      if(is_coordinate(property)) add_coordinate(property, value);
    }

    void word(std::size_t property, std::string_view word)
    {
      if(property == m_distance) m_reader.m_table.distances.push_back(internal::parsed_distance(where(), m_row, word));
      if(!is_coordinate(property)) return;
      double value = 0;
      if(!parse_number(word, value))
        throw Input_error(where() + "vertex " + std::to_string(m_row) + " has the coordinate " + quoted_word(word) +
                          ", which is not a finite number");
      add_coordinate(property, value);
    }

  private:
    bool is_coordinate(std::size_t property) const
    {
      return m_reader.m_has_points && (property == m_xyz[0] || property == m_xyz[1] || property == m_xyz[2]);
    }

    void add_coordinate(std::size_t property, double value)
    {
      for(std::size_t c = 0; c < 3; ++c)
        if(m_xyz[c] == property) m_coordinates[c] = value;
      if(++m_found == 3) m_reader.m_table.points.emplace_back(m_coordinates[0], m_coordinates[1], m_coordinates[2]);
    }

    std::string where() const { return quoted(m_reader.m_path) + ", " + m_file.where() + m_reader.named_property() + ": "; }
  };

public:
  Ply_table_reader(const std::string& path, const std::string& mesh, std::size_t vertices)
    : m_path(path), m_mesh(mesh), m_vertices(vertices)
  {
  }

  // property: empty for the first of the usual names. Throws Input_error.
  Distance_table operator()(std::string_view bytes, const std::string& property)
  {
    internal::Ply_file file(m_path, bytes);
    const Element& vertices = find_vertices(file);
    find_property(vertices, property);
    m_table.name = named_property() + " of " + quoted(m_path);
    for(const Element& element : file.elements())
    {
      if(&element == &vertices)
      {
        file.read_rows(element, Rows(file, *this, element));
        break;
      }
      file.skip_rows(element);
    }
    return std::move(m_table);
  }

private:
  std::string named_property() const { return "property " + quoted(m_property); }

  static bool has_real(const Element& vertices, const std::string& name)
  {
    return vertices.has(name) && is_real(vertices.properties[vertices.find(name)]);
  }

  static bool is_real(const Property& property) { return !property.is_list() && internal::is_real(property.type); }

  const Element& find_vertices(const internal::Ply_file& file)
  {
    for(const Element& element : file.elements())
      if(element.is_vertex())
      {
        if(element.number != m_vertices)
          throw Input_error(quoted(m_path) + " has " + counted(element.number, "vertex", "vertices") + ", but " +
                            quoted(m_mesh) + " has " + std::to_string(m_vertices));
        m_has_points = has_real(element, "x") && has_real(element, "y") && has_real(element, "z");
        return element;
      }
    file.fail("its header announces no vertices");
  }

  void find_property(const Element& vertices, const std::string& property)
  {
    m_property = property;
    if(property.empty())
      for(const char* name : {"value", "geodesic", "geodesic_distance", "scalar", "quality", "distance"})
        if(vertices.has(name)) m_property = name;
    if(!vertices.has(m_property))
    {
      constexpr std::size_t most_names = 10; // in one line
      std::string names;
      for(std::size_t p = 0; p < std::min(most_names, vertices.properties.size()); ++p)
        names += (p == 0 ? "" : ", ") + vertices.properties[p].name.substr(0, 40);
      if(vertices.properties.size() > most_names)
        names += " and " + std::to_string(vertices.properties.size() - most_names) + " more";
      throw Input_error(quoted(m_path) + ": its vertices have " +
                        (property.empty() ? "no property with a usual name for distances (--property names one)"
                                          : "no property " + quoted(property)) +
                        "; they have " + names);
    }
    if(!has_real(vertices, m_property))
      throw Input_error(quoted(m_path) + ": the " + named_property() + " of its vertices has the type " +
                        vertices.properties[vertices.find(m_property)].type_name + "; float or double is needed");
  }
};

} // namespace geodesic_offset

#endif // VALIDATE_GEODESIC_DISTANCES_PLY_TABLE_H
