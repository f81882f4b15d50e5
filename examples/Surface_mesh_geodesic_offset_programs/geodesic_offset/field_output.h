// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Output of the field at the vertices of the file, with the vertices and faces of the file: as a binary PLY file, a binary
// legacy VTK file, or a table of comma-separated values.

#ifndef GEODESIC_OFFSET_FIELD_OUTPUT_H
#define GEODESIC_OFFSET_FIELD_OUTPUT_H

#include "byte_writer.h"
#include "common/common.h"
#include "common/mesh_input.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace geodesic_offset {

// Values at the vertices of the file.
struct Field_column
{
  std::string name;
  std::size_t components; // 1 or 3
  bool is_integer; // of 32 bits
  std::vector<double> values;
};

// The first column is the distance: infinite for unreachable vertices and vertices without faces.
struct File_field
{
  std::vector<Field_column> columns;

  // with_sides: with signed distances. with_details: with nearest sources (-1: none), their sides and gradients.
  // with_error_bounds: with the amounts by which distances may be smaller than the exact ones.
  File_field(const Mesh_input& input, const Geodesic& geodesic, bool with_sides, bool with_details, bool with_error_bounds)
  {
    const std::size_t n = input.soup().points.size();
    const auto add = [&](const char* name, std::size_t components, bool is_integer, double unreached) {
      columns.push_back({name, components, is_integer, std::vector<double>(components * n, unreached)});
    };
    add("distance", 1, false, infinity);
    if(with_sides) add("signed_distance", 1, false, infinity);
    if(with_details)
    {
      add("source", 1, true, -1);
      add("side", 1, true, 0);
      add("gradient", 3, false, 0);
    }
    if(with_error_bounds) add("error_bound", 1, false, 0);
    for(std::size_t i = 0; i < n; ++i)
    {
      Vertex nearest = Mesh::null_vertex();
      input.for_each_vertex_of(i, [&](Vertex v) {
        const double distance = geodesic.distance_to_sources(v);
        if(!(distance < columns[0].values[i])) return;
        columns[0].values[i] = distance;
        nearest = v;
      });
      if(nearest == Mesh::null_vertex()) continue;
      std::size_t k = 1;
      if(with_sides)
        columns[k++].values[i] =
          geodesic.signed_distance_to_sources(nearest).value_or(std::numeric_limits<double>::quiet_NaN());
      if(with_details)
      {
        if(const auto source = geodesic.field().nearest_source_and_side(nearest))
        {
          columns[k].values[i] = static_cast<double>(source->first);
          columns[k + 1].values[i] = static_cast<double>(source->second);
        }
        k += 2;
        const Vector gradient = geodesic.gradient(nearest).value_or(CGAL::NULL_VECTOR);
        for(int c = 0; c < 3; ++c) columns[k].values[3 * i + static_cast<std::size_t>(c)] = gradient[c];
        ++k;
      }
      if(with_error_bounds) columns[k].values[i] = geodesic.error_bound(nearest);
    }
  }
};

namespace internal {

// Names of the numbers of a column.
inline std::vector<std::string> names_of_components(const Field_column& column)
{
  if(column.components == 1) return {column.name};
  return {column.name + "_x", column.name + "_y", column.name + "_z"};
}

inline void write_values(Byte_writer& bytes, const Field_column& column, std::size_t i)
{
  for(std::size_t k = column.components * i; k < column.components * (i + 1); ++k)
    if(column.is_integer)
      bytes.write(static_cast<std::uint32_t>(static_cast<std::int32_t>(column.values[k])));
    else
      bytes.write(column.values[k]);
}

inline void write_field_ply(std::ostream& out, const Soup& soup, const File_field& field)
{
  std::size_t largest = 0;
  for(const Polygon& polygon : soup.polygons) largest = std::max(largest, polygon.size());
  const bool small = (largest < 256);

  out << "ply\nformat binary_little_endian 1.0\ncomment geodesic distances\n"
      << "element vertex " << soup.points.size() << "\n"
      << "property double x\nproperty double y\nproperty double z\n";
  for(const Field_column& column : field.columns)
    for(const std::string& name : names_of_components(column))
      out << "property " << (column.is_integer ? "int " : "double ") << name << '\n';
  out << "element face " << soup.polygons.size() << "\n"
      << "property list " << (small ? "uchar" : "uint") << " int vertex_indices\nend_header\n";

  Byte_writer bytes(out, Byte_order::little);
  for(std::size_t i = 0; i < soup.points.size(); ++i)
  {
    for(int c = 0; c < 3; ++c) bytes.write(soup.points[i][c]);
    for(const Field_column& column : field.columns) write_values(bytes, column, i);
  }
  for(const Polygon& polygon : soup.polygons)
  {
    if(small)
      bytes.write(static_cast<std::uint8_t>(polygon.size()));
    else
      bytes.write(static_cast<std::uint32_t>(polygon.size()));
    for(std::uint32_t v : polygon) bytes.write(v);
  }
}

// In binary form, since VTK does not read infinite numbers as text.
inline void write_field_vtk(std::ostream& out, const Soup& soup, const File_field& field)
{
  const std::size_t n = soup.points.size();
  const auto write = [&](const auto& write_numbers) {
    {
      Byte_writer bytes(out, Byte_order::big);
      write_numbers(bytes);
    }
    out << '\n';
  };
  out << "# vtk DataFile Version 3.0\ngeodesic distances\nBINARY\nDATASET POLYDATA\nPOINTS " << n << " double\n";
  write([&](Byte_writer& bytes) {
    for(const Point& p : soup.points)
      for(int c = 0; c < 3; ++c) bytes.write(p[c]);
  });
  std::size_t numbers = 0;
  for(const Polygon& polygon : soup.polygons) numbers += 1 + polygon.size();
  out << "POLYGONS " << soup.polygons.size() << ' ' << numbers << '\n';
  write([&](Byte_writer& bytes) {
    for(const Polygon& polygon : soup.polygons)
    {
      bytes.write(static_cast<std::uint32_t>(polygon.size()));
      for(std::uint32_t v : polygon) bytes.write(v);
    }
  });
  out << "POINT_DATA " << n << '\n';
  for(std::size_t k = 0; k < field.columns.size(); ++k)
  {
    const Field_column& column = field.columns[k];
    const char* type = column.is_integer ? "int" : "double";
    if(k == 0)
      out << "SCALARS " << column.name << ' ' << type << " 1\nLOOKUP_TABLE default\n";
    else if(k == 1)
      out << "FIELD field " << field.columns.size() - 1 << '\n';
    if(k != 0) out << column.name << ' ' << column.components << ' ' << n << ' ' << type << '\n';
    write([&](Byte_writer& bytes) {
      for(std::size_t i = 0; i < n; ++i) write_values(bytes, column, i);
    });
  }
}

inline void write_field_csv(std::ostream& out, const Soup& soup, const File_field& field)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "x,y,z";
  for(const Field_column& column : field.columns)
    for(const std::string& name : names_of_components(column)) out << ',' << name;
  out << '\n';
  for(std::size_t i = 0; i < soup.points.size(); ++i)
  {
    const Point& p = soup.points[i];
    out << p.x() + 0. << ',' << p.y() + 0. << ',' << p.z() + 0.; // no -0
    for(const Field_column& column : field.columns)
      for(std::size_t k = column.components * i; k < column.components * (i + 1); ++k)
      {
        out << ',';
        if(std::isnan(column.values[k])) // without a sign
          out << "nan";
        else
          out << column.values[k] + 0;
      }
    out << '\n';
  }
}

} // namespace internal

// Size without headers; 0, which means unknown, for text.
inline std::uintmax_t bytes_of_field(const std::string& file, const Soup& soup, const File_field& field)
{
  if(has_extension(file, ".csv")) return 0;
  std::uintmax_t row = 3 * sizeof(double);
  for(const Field_column& column : field.columns)
    row += column.components * (column.is_integer ? sizeof(std::uint32_t) : sizeof(double));
  std::uintmax_t bytes = row * soup.points.size();
  for(const Polygon& polygon : soup.polygons)
    bytes += sizeof(std::uint32_t) * polygon.size() + (has_extension(file, ".vtk") ? sizeof(std::uint32_t) : 1);
  return bytes;
}

// In the format of the extension.
inline void write_field(std::ostream& out, const std::string& file, const Soup& soup, const File_field& field)
{
  if(has_extension(file, ".csv"))
    internal::write_field_csv(out, soup, field);
  else if(has_extension(file, ".vtk"))
    internal::write_field_vtk(out, soup, field);
  else
    internal::write_field_ply(out, soup, field);
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_FIELD_OUTPUT_H
