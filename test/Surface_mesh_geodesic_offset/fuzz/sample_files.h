// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// A small surface in all variants of all formats of meshes, polylines and distances that the programs read: tests of the
// readers expect the same surface from all mesh files, and the fuzzers start with these files.

#ifndef GEODESIC_OFFSET_TEST_SAMPLE_FILES_H
#define GEODESIC_OFFSET_TEST_SAMPLE_FILES_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace test {

struct Sample_file
{
  std::string name;
  std::string extension; // determines the format, for example ".off"
  std::string bytes;
};

/// Pyramid over a quadrilateral. All coordinates are integers from 0 to 9, which every number type represents.
struct Sample_surface
{
  std::vector<std::vector<int>> points = {{0, 0, 0}, {4, 0, 0}, {4, 5, 0}, {0, 5, 0}, {2, 2, 9}};
  std::vector<std::vector<int>> polygons = {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
};

namespace internal {

/// Bytes of a number in either byte order.
template <class Number>
std::string number_bytes(Number number, bool is_big_endian)
{
  char raw[sizeof(Number)];
  std::memcpy(raw, &number, sizeof(Number));
  const std::uint16_t one = 1;
  char first;
  std::memcpy(&first, &one, 1);
  if ((first == 1) == is_big_endian) std::reverse(raw, raw + sizeof(Number));
  return std::string(raw, sizeof(Number));
}

inline std::string ply_number(const std::string& type, int value, bool is_ascii, bool is_big_endian)
{
  if (is_ascii) return std::to_string(value) + ' ';
  const auto bytes = [&](auto number) { return number_bytes(number, is_big_endian); };
  if (type == "char" || type == "int8") return bytes(static_cast<std::int8_t>(value));
  if (type == "uchar" || type == "uint8") return bytes(static_cast<std::uint8_t>(value));
  if (type == "short" || type == "int16") return bytes(static_cast<std::int16_t>(value));
  if (type == "ushort" || type == "uint16") return bytes(static_cast<std::uint16_t>(value));
  if (type == "int" || type == "int32") return bytes(static_cast<std::int32_t>(value));
  if (type == "uint" || type == "uint32") return bytes(static_cast<std::uint32_t>(value));
  if (type == "float" || type == "float32") return bytes(static_cast<float>(value));
  return bytes(static_cast<double>(value));
}

struct Ply_variant
{
  int format; // 0 ASCII, 1 little endian, 2 big endian
  std::string coordinate, count, index;
  bool has_others = false; // other elements and properties, also lists
  bool faces_first = false;
};

inline std::string ply_file(const Ply_variant& variant)
{
  const Sample_surface surface;
  const char* formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  const bool ascii = variant.format == 0, big = variant.format == 2;
  const bool others = variant.has_others;
  const auto number = [&](const std::string& type, int value) { return ply_number(type, value, ascii, big); };
  const std::string end = ascii ? "\n" : "";

  std::string vertex_header = "element vertex 5\n", face_header = "element face 5\n", vertices, faces;
  if (others) vertex_header += "property list uchar short weights\n";
  for (const char* c : {"x", "y", "z"})
    vertex_header +=
      "property " + variant.coordinate + ' ' + c + "\n" + (others ? std::string("property float n") + c + "\n" : "");
  if (others) face_header += "property uchar red\n";
  face_header += "property list " + variant.count + ' ' + variant.index + " vertex_indices\n";
  if (others) face_header += "property list int double weights\n";
  for (std::size_t i = 0; i < surface.points.size(); ++i)
  {
    if (others)
    {
      vertices += number("uchar", static_cast<int>(i));
      for (std::size_t k = 0; k < i; ++k) vertices += number("short", -7);
    }
    for (int c : surface.points[i]) vertices += number(variant.coordinate, c) + (others ? number("float", 1) : "");
    vertices += end;
  }
  for (const auto& polygon : surface.polygons)
  {
    if (others) faces += number("uchar", 200);
    faces += number(variant.count, static_cast<int>(polygon.size()));
    for (int v : polygon) faces += number(variant.index, v);
    if (others) faces += number("int", 1) + number("double", 5);
    faces += end;
  }
  std::string text = std::string("ply\nformat ") + formats[variant.format] + " 1.0\ncomment a pyramid\nobj_info none\n";
  if (others) text += "element camera 1\nproperty double zoom\n";
  text += variant.faces_first ? face_header + vertex_header : vertex_header + face_header;
  if (others) text += "element edge 1\nproperty int from\nproperty int to\n";
  text += "end_header\n";
  if (others) text += number("double", 3) + end;
  text += variant.faces_first ? faces + vertices : vertices + faces;
  if (others) text += number("int", 0) + number("int", 1) + end;
  return text;
}

/// [ST][C][N][4][n]OFF as text.
inline std::string off_text(const std::string& keyword, const std::string& line_end = "\n")
{
  const Sample_surface surface;
  const auto has = [&](char c) { return keyword.find(c) != std::string::npos; };
  const bool has_textures = keyword.compare(0, 2, "ST") == 0;
  const std::string prefix = keyword.substr(0, keyword.size() - 3);
  const bool has_normals = prefix.find('N') != std::string::npos, has_dimension = has('n'), is_homogeneous = has('4');
  std::string text = keyword + line_end + "# a pyramid" + line_end + (has_dimension ? "3" + line_end : "") + "5 5 8" + line_end;
  for (const auto& p : surface.points)
  {
    for (int c : p) text += std::to_string(is_homogeneous ? 2 * c : c) + ' ';
    if (is_homogeneous) text += "2 ";
    if (has_normals) text += is_homogeneous ? "0 0 1 1 " : "0 0 1 ";
    if (prefix.find('C') != std::string::npos) text += "255 128 0 255 ";
    if (has_textures) text += is_homogeneous ? "0.5 0.5 1 " : "0.5 0.5 ";
    text += line_end;
  }
  for (const auto& polygon : surface.polygons)
  {
    text += std::to_string(polygon.size()) + ' ';
    for (int v : polygon) text += ' ' + std::to_string(v);
    text += (has('C') ? " 0.1 0.2 0.3" : "") + line_end;
  }
  return text;
}

inline std::string off_binary(const std::string& keyword)
{
  const Sample_surface surface;
  const auto number = [](auto value) { return number_bytes(value, true); };
  const std::string prefix = keyword.substr(0, keyword.size() - 3);
  const auto has = [&](char c) { return prefix.find(c) != std::string::npos; };
  std::string text = keyword + " BINARY\n";
  if (has('n')) text += number(std::int32_t(3));
  for (std::int32_t n : {5, 5, 8}) text += number(n);
  for (const auto& p : surface.points)
  {
    for (int c : p) text += number(static_cast<float>(has('4') ? 4 * c : c));
    if (has('4')) text += number(4.f);
    for (int i = 0; i < (has('N') ? has('4') ? 4 : 3 : 0); ++i) text += number(1.f);
    for (int i = 0; i < (has('C') ? 4 : 0); ++i) text += number(0.5f);
    for (int i = 0; i < (has('S') ? has('4') ? 3 : 2 : 0); ++i) text += number(0.25f);
  }
  for (const auto& polygon : surface.polygons)
  {
    text += number(static_cast<std::int32_t>(polygon.size()));
    for (int v : polygon) text += number(static_cast<std::int32_t>(v));
    text += number(std::int32_t(has('C') ? 3 : 0));
    for (int i = 0; i < (has('C') ? 3 : 0); ++i) text += number(0.5f);
  }
  return text;
}

/// Triangles of the surface: the quadrilateral is divided.
inline std::vector<std::vector<int>> sample_triangles()
{
  std::vector<std::vector<int>> triangles;
  for (const auto& polygon : Sample_surface().polygons)
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) triangles.push_back({polygon[0], polygon[k], polygon[k + 1]});
  return triangles;
}

inline std::string stl_text(const std::string& line_end = "\n")
{
  const Sample_surface surface;
  std::string text = "solid a pyramid" + line_end;
  for (const auto& triangle : sample_triangles())
  {
    text += "facet normal 0 0 nan" + line_end + "outer loop" + line_end;
    for (int v : triangle)
    {
      text += "vertex";
      for (int c : surface.points[static_cast<std::size_t>(v)]) text += ' ' + std::to_string(c) + ".0e+00";
      text += line_end;
    }
    text += "endloop" + line_end + "endfacet" + line_end;
  }
  return text + "endsolid a pyramid" + line_end;
}

inline std::string stl_binary(std::string header)
{
  const Sample_surface surface;
  header.resize(80, ' ');
  const auto triangles = sample_triangles();
  std::string text = header + number_bytes(static_cast<std::uint32_t>(triangles.size()), false);
  for (const auto& triangle : triangles)
  {
    for (float n : {0.f, 0.f, 1.f}) text += number_bytes(n, false);
    for (int v : triangle)
      for (int c : surface.points[static_cast<std::size_t>(v)])
        text += number_bytes(c == 0 ? -0.f : static_cast<float>(c), false);
    text += number_bytes(std::uint16_t(7), false);
  }
  return text;
}

} // namespace internal

/// The pyramid in all variants of mesh formats.
inline std::vector<Sample_file> sample_meshes()
{
  using namespace internal;
  std::vector<Sample_file> files;
  for (const char* textures : {"", "ST"})
    for (const char* colors : {"", "C"})
      for (const char* normals : {"", "N"})
        for (const char* homogeneous : {"", "4"})
          for (const char* dimension : {"", "n"})
          {
            const std::string keyword = std::string(textures) + colors + normals + homogeneous + dimension + "OFF";
            files.push_back({keyword, ".off", off_text(keyword)});
            files.push_back({keyword + " BINARY", ".off", off_binary(keyword)});
          }
  files.push_back({"OFF on one line", ".off",
                   "OFF 5 5 0 # sizes\n\n0 0 0\n4 0 0\n4 5 0 255 0 0\n+0 .5e1 -0\n2. 20E-1 9 # apex\n"
                   "4 0 3 2 1 0.5 0.5 0.5\n3 0 1 4\n3 1 2 4 # side\n3 2 3\n 4\n3 3 0 4"});
  files.push_back({"OFF with a byte order mark", ".off", "\xef\xbb\xbf" + off_text("OFF")});

  files.push_back({"OBJ", ".obj",
                   "# a pyramid\nmtllib none\no pyramid\nv 0 0 0\nv 4 0 0\nv 4 5 0\nv 0 5 0\nv 2 2 9\n"
                   "vn 0 0 1\nvt 0 0\ng sides\nusemtl none\nf 1 4 3 2\ns off\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n"});
  files.push_back({"OBJ with all kinds of indices", ".obj",
                   "v 0 0 0 1\nv 4 0 0 1 0 0\nf 1/1 4/2 3 2\nv 4 5 0\nv 0 5 0\nvt 0 0\nv 2 2 9\n\tf 1//1 2//1 5//1\n"
                   "f 2/1/1 3/1/1 5/1/1\nf -3 -2 -1\nf -2/1/-1 -5 -1 # closed\nl 1 2\np 1\n"});
  files.push_back({"OBJ with continued lines", ".obj",
                   "v 0 0 \\\n0\nv 4 0 0\nv 4 5 0\nv 0 5 0\nv 2 2 9\nf 1 4 3 \\\r\n2\n"
                   "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 \\\n1 \\\n5"});

  const char* types[] = {"char", "uchar", "short", "ushort", "int",   "uint",   "float",   "double",
                         "int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"};
  for (int format = 0; format < 3; ++format)
  {
    const std::string name = format == 0 ? "ASCII PLY, " : format == 1 ? "little endian PLY, " : "big endian PLY, ";
    for (const char* type : types)
      files.push_back({name + "coordinates of type " + type, ".ply", ply_file({format, type, "uchar", "int"})});
    for (int i = 0; i < 14; ++i)
      if (i != 6 && i != 7) // integers
      {
        files.push_back({name + "counts of type " + types[i], ".ply", ply_file({format, "float", types[i], "int"})});
        files.push_back({name + "indices of type " + types[i], ".ply", ply_file({format, "float", "uchar", types[i]})});
      }
    files.push_back({name + "other elements and properties", ".ply", ply_file({format, "double", "uchar", "uint", true})});
    files.push_back({name + "faces first", ".ply", ply_file({format, "double", "uchar", "uint", true, true})});
  }
  for (const char* line_end : {"\r\n", "\r"})
  {
    const std::string name = std::string(line_end).size() == 2 ? " with CR LF" : " with CR";
    const auto with = [&](std::string text) {
      for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += std::string(line_end).size())
        text.replace(at, 1, line_end);
      return text;
    };
    files.push_back({"OFF" + name, ".off", with(off_text("COFF"))});
    files.push_back({"STL" + name, ".stl", with(stl_text())});
    files.push_back({"ASCII PLY" + name, ".ply", with(ply_file({0, "float", "uchar", "int", true}))});
    // only the header lines
    const std::string binary = ply_file({1, "float", "uchar", "int"});
    const std::size_t header = binary.find("end_header\n") + 11;
    files.push_back({"binary PLY" + name, ".ply", with(binary.substr(0, header)) + binary.substr(header)});
  }
  files.push_back({"STL", ".stl", stl_text()});
  std::string upper = stl_text();
  for (char& c : upper) c = c >= 'a' && c <= 'z' && c != 'e' ? static_cast<char>(c - 'a' + 'A') : c;
  files.push_back({"STL in capitals", ".stl", upper});
  files.push_back({"STL of two solids", ".stl", "solid\nendsolid\n" + stl_text()});
  files.push_back({"binary STL", ".stl", stl_binary("a pyramid")});
  files.push_back({"binary STL that begins with solid", ".stl", stl_binary("solid pyramid")});
  return files;
}

/// Curve round vertex 0 of the pyramid, near its offset at distance 3: through the points of its edges at this distance.
inline Sample_file sample_curves()
{
  return {"curves", ".polylines.txt", "4  3 0 0  0.635999 0.635999 2.861994  0 3 0  3 0 0 # closed\n"};
}

/// Polylines, and distances of the pyramid's vertices, as text and PLY files.
inline std::vector<Sample_file> other_samples()
{
  std::vector<Sample_file> files;
  files.push_back({"polylines", ".polylines.txt", "# two\n2  0 0 0  1 0 0.5\n4  0 0 0  1 0 0  0 1e-1 0  0 0 0 # closed\n"});
  files.push_back({"a column of distances", ".txt", "# distances\n0\n4\n6.4\ninf\n1e1\n"});
  files.push_back({"pairs of vertices and distances", ".txt", "4 1e1\n1 4\n\n2 6.4 # far\r\n3 +inf\n0 0\n"});
  for (int format = 0; format < 3; ++format)
  {
    internal::Ply_variant variant{format, "double", "uchar", "uint", true};
    std::string text = internal::ply_file(variant);
    const std::string property = "float nx";
    text.replace(text.find(property), property.size(), "float distance");
    files.push_back({"a table", ".table.ply", text});
  }
  return files;
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_SAMPLE_FILES_H
