// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Files of meshes and distance tables for the tests of validate_geodesic_distances.

#ifndef GEODESIC_OFFSET_TEST_VALIDATION_FILES_H
#define GEODESIC_OFFSET_TEST_VALIDATION_FILES_H

#include "generated_soup.h"
#include "program_runner.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace test {

inline std::string number_text(double x)
{
  std::ostringstream text;
  text.precision(17);
  text << x; // an infinity is "inf"
  return text.str();
}

inline std::string point_text(const Point_3& p)
{
  return number_text(p.x()) + ' ' + number_text(p.y()) + ' ' + number_text(p.z());
}

inline void write_off(const std::filesystem::path& path, const Soup& soup)
{
  std::string text = "OFF\n" + std::to_string(soup.points.size()) + ' ' + std::to_string(soup.triangles.size()) + " 0\n";
  for (const Point_3& p : soup.points) text += point_text(p) + '\n';
  for (const auto& t : soup.triangles)
    text += "3 " + std::to_string(t[0]) + ' ' + std::to_string(t[1]) + ' ' + std::to_string(t[2]) + '\n';
  write_file(path, text);
}

/// One distance per line, in the order of the vertices.
inline std::string column_table(const std::vector<double>& distances)
{
  std::string text = "# distances\n";
  for (double d : distances) text += number_text(d) + '\n';
  return text;
}

/// Lines with a vertex and its distance, in any order.
inline std::string pair_table(const std::vector<double>& distances, unsigned seed)
{
  std::vector<std::size_t> order(distances.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), Random(seed));
  std::string text;
  for (std::size_t v : order) text += "\n  " + std::to_string(v) + '\t' + number_text(distances[v]) + " # a vertex\r\n";
  return text;
}

enum class Ply_format { ascii, little_endian, big_endian };

/// A PLY file of the soup with a vertex property of type float or double between other properties.
class Ply_table
{
public:
  Ply_table(Ply_format format, const std::string& property, const std::string& type = "double")
    : format_(format), property_(property), type_(type)
  {
  }

  std::string operator()(const Soup& soup, const std::vector<double>& distances, bool with_faces = true)
  {
    const char* names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    bytes_ = std::string("ply\nformat ") + names[static_cast<int>(format_)] + " 1.0\ncomment a table\n";
    bytes_ += "element camera 2\nproperty float zoom\nelement vertex " + std::to_string(distances.size());
    bytes_ += "\nproperty float x\nproperty float y\nproperty uchar mark\nproperty float z\nproperty " + type_ + ' ';
    bytes_ += property_ + "\nproperty double weight\n";
    if (with_faces)
      bytes_ += "element face " + std::to_string(soup.triangles.size()) + "\nproperty list uchar int vertex_indices\n";
    bytes_ += "end_header\n";
    for (int i = 0; i < 2; ++i)
    {
      add(float(i));
      end_row();
    }
    for (std::size_t i = 0; i < distances.size(); ++i)
    {
      const Point_3& p = soup.points[i];
      add(float(p.x()));
      add(float(p.y()));
      add(std::uint8_t(i % 256));
      add(float(p.z()));
      if (type_ == "float") add(float(distances[i]));
      else add(distances[i]);
      add(-1.0);
      end_row();
    }
    if (with_faces)
      for (const auto& t : soup.triangles)
      {
        add(std::uint8_t(3));
        for (std::size_t v : t) add(std::int32_t(v));
        end_row();
      }
    return bytes_;
  }

private:
  template <class Number>
  void add(Number x)
  {
    if (format_ == Ply_format::ascii)
    {
      bytes_ += number_text(static_cast<double>(x)) + ' ';
      return;
    }
    char raw[sizeof(Number)];
    std::memcpy(raw, &x, sizeof(Number));
    const std::uint16_t one = 1;
    char first;
    std::memcpy(&first, &one, 1);
    if ((first == 1) != (format_ == Ply_format::little_endian)) std::reverse(raw, raw + sizeof(Number));
    bytes_.append(raw, sizeof(Number));
  }

  void end_row()
  {
    if (format_ == Ply_format::ascii) bytes_ += '\n';
  }

  Ply_format format_;
  std::string property_, type_, bytes_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_VALIDATION_FILES_H
