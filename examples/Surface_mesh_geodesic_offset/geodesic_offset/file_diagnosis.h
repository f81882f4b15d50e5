// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds out what is wrong with a mesh file that could not be read. CGAL's readers only say that they failed.
// These functions are called after a failure, so they may be slow and need not understand all of a format.

#ifndef GEODESIC_OFFSET_FILE_DIAGNOSIS_H
#define GEODESIC_OFFSET_FILE_DIAGNOSIS_H

#include "numbers.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <istream>
#include <sstream>
#include <string>
#include <vector>

namespace geodesic_offset {
namespace internal {

// The lines of a text file, without comments and empty lines
class Line_reader
{
  std::istream& m_in;
  std::size_t   m_number = 0;

public:
  explicit Line_reader(std::istream& in) : m_in(in) {}

  std::size_t number() const { return m_number; }

  bool next(std::vector<std::string>& words)
  {
    for(std::string line; std::getline(m_in, line);)
    {
      ++m_number;
      words = words_of(line.substr(0, line.find('#')));
      if(!words.empty())
        return true;
    }
    return false;
  }
};

// All of these return what is wrong, or an empty text.
inline std::string wrong_coordinates(const std::vector<std::string>& words, std::size_t first,
                                     const std::string& element, std::size_t line)
{
  const std::string where = "line " + std::to_string(line) + ": " + element;
  for(std::size_t i = first; i < first + 3; ++i)
  {
    double value;
    if(i >= words.size())
      return where + " has fewer than three coordinates";
    if(spells_non_finite_number(words[i]))
      return where + " has the coordinate '" + words[i] + "', which is not finite";
    if(!parse_number(words[i], value))
      return where + " has the coordinate '" + words[i] + "', which is not a finite number";
  }
  return std::string();
}

inline std::string wrong_face(const std::vector<std::string>& words, std::size_t number_of_vertices,
                              const std::string& element, std::size_t line)
{
  const std::string where = "line " + std::to_string(line) + ": " + element;
  std::size_t size, index;
  if(!parse_index(words[0], size) || size < 3)
    return where + " has '" + words[0] + "' vertices";
  for(std::size_t i = 1; i <= size; ++i)
  {
    if(i >= words.size())
      return where + " has fewer than " + words[0] + " vertex indices";
    if(!parse_index(words[i], index) || index >= number_of_vertices)
      return where + " has the vertex index '" + words[i] + "', but there are " + std::to_string(number_of_vertices) +
             " vertices";
  }
  return std::string();
}

inline std::string missing(const std::string& what, std::size_t found, std::size_t announced)
{
  return "the file ends after " + std::to_string(found) + " of " + std::to_string(announced) + ' ' + what;
}

inline std::string diagnose_off(std::istream& in)
{
  Line_reader lines(in);
  std::vector<std::string> words;
  if(!lines.next(words))
    return "the file is empty";
  if(words[0].find("OFF") == std::string::npos || words[0].size() > 8)
    return "the file does not begin with OFF";
  if(words.size() > 1 && words[1] == "BINARY")
    return std::string();
  words.erase(words.begin());
  if(words.empty() && !lines.next(words))
    return "the file ends after its first word";
  std::size_t vertices = 0, faces = 0;
  if(words.size() < 2 || !parse_index(words[0], vertices) || !parse_index(words[1], faces))
    return "line " + std::to_string(lines.number()) + ": the numbers of vertices and faces are expected here";
  if(vertices == 0 || faces == 0)
    return std::string("the file has no ") + (vertices == 0 ? "vertices" : "faces");
  for(std::size_t i = 0; i < vertices; ++i)
  {
    if(!lines.next(words))
      return missing("vertices", i, vertices);
    const std::string wrong = wrong_coordinates(words, 0, "vertex " + std::to_string(i), lines.number());
    if(!wrong.empty())
      return wrong;
  }
  for(std::size_t i = 0; i < faces; ++i)
  {
    if(!lines.next(words))
      return missing("faces", i, faces);
    const std::string wrong = wrong_face(words, vertices, "face " + std::to_string(i), lines.number());
    if(!wrong.empty())
      return wrong;
  }
  return std::string();
}

inline std::string diagnose_obj(std::istream& in)
{
  Line_reader lines(in);
  std::vector<std::string> words;
  std::size_t vertices = 0, faces = 0;
  // vertices may follow the faces that use them
  std::size_t largest = 0, line_of_largest = 0, face_of_largest = 0;
  while(lines.next(words))
  {
    if(words[0] == "v")
    {
      const std::string wrong = wrong_coordinates(words, 1, "vertex " + std::to_string(vertices), lines.number());
      if(!wrong.empty())
        return wrong;
      ++vertices;
    }
    else if(words[0] == "f")
    {
      for(std::size_t i = 1; i < words.size(); ++i)
      {
        // "7", "7/1", "7//3", "7/1/3", or counted back from here: "-2"
        const std::string word = words[i].substr(0, words[i].find('/'));
        const bool backwards = (word[0] == '-');
        std::size_t index = 0;
        if(!parse_index(word.substr(backwards ? 1 : 0), index) || index == 0 || (backwards && index > vertices))
          return "line " + std::to_string(lines.number()) + ": face " + std::to_string(faces) +
                 " has the vertex index '" + words[i] + "'";
        if(!backwards && index > largest)
        {
          largest = index;
          line_of_largest = lines.number();
          face_of_largest = faces;
        }
      }
      if(words.size() < 4)
        return "line " + std::to_string(lines.number()) + ": face " + std::to_string(faces) +
               " has fewer than three vertices";
      ++faces;
    }
    else if(std::any_of(words[0].begin(), words[0].end(), [](unsigned char c) { return !std::isgraph(c); }))
      return "line " + std::to_string(lines.number()) + " is not text";
  }
  if(vertices == 0)
    return "the file has no vertices";
  if(faces == 0)
    return "the file has no faces";
  if(largest > vertices)
    return "line " + std::to_string(line_of_largest) + ": face " + std::to_string(face_of_largest) +
           " has the vertex index '" + std::to_string(largest) + "', but there are " + std::to_string(vertices) +
           " vertices";
  return std::string();
}

struct Ply_element
{
  std::string              name;
  std::size_t              number = 0;
  std::vector<std::string> properties;
  std::vector<std::string> types; // of the properties, like "float" or "list uchar int"

  bool is_vertex() const { return name == "vertex" || name == "vertices"; }
  bool is_face() const { return name == "face" || name == "faces"; }
};

// Reads up to end_header. Returns what is wrong with it.
inline std::string read_ply_header(Line_reader& lines, bool& ascii, std::vector<Ply_element>& elements)
{
  std::vector<std::string> words;
  if(!lines.next(words) || words[0] != "ply")
    return "the file does not begin with ply";
  for(;;)
  {
    if(!lines.next(words))
      return "the file ends within its header";
    const std::string where = "line " + std::to_string(lines.number()) + ": ";
    if(words[0] == "end_header")
      break;
    if(words[0] == "format" && words.size() > 1)
      ascii = (words[1] == "ascii");
    if(words[0] == "element")
    {
      elements.emplace_back();
      if(words.size() < 3 || !parse_index(words[2], elements.back().number))
        return where + "the number of elements is expected here";
      elements.back().name = words[1];
    }
    if(words[0] == "property")
    {
      if(elements.empty() || words.size() < 3)
        return where + "misplaced property";
      elements.back().properties.push_back(words.back());
      elements.back().types.push_back(words[1]);
      for(std::size_t i = 2; i + 1 < words.size(); ++i)
        elements.back().types.back() += ' ' + words[i];
    }
  }
  return std::string();
}

// What is wrong with the header of a mesh
inline std::string wrong_ply_elements(const std::vector<Ply_element>& elements)
{
  const auto has_element = [&](const std::string& name, const std::string& plural) {
    return std::any_of(elements.begin(), elements.end(), [&](const Ply_element& e) {
      return e.name == name || e.name == plural;
    });
  };
  if(!has_element("vertex", "vertices"))
    return "its header announces no vertices";
  if(!has_element("face", "faces"))
    return "its header announces no faces";
  for(const Ply_element& e : elements)
    if(e.number == 0 && (e.name == "vertex" || e.name == "vertices" || e.name == "face" || e.name == "faces"))
      return "its header announces no " + std::string(e.name[0] == 'v' ? "vertices" : "faces");
  for(const Ply_element& e : elements)
    for(const char* coordinate : {"x", "y", "z"})
      if(e.is_vertex() && std::find(e.properties.begin(), e.properties.end(), coordinate) == e.properties.end())
        return "its vertices have no property " + std::string(coordinate);
  return std::string();
}

// CGAL's reader takes missing coordinates for zero, so this is called before it.
inline std::string diagnose_ply_header(std::istream& in)
{
  Line_reader lines(in);
  bool ascii = false;
  std::vector<Ply_element> elements;
  const std::string wrong_header = read_ply_header(lines, ascii, elements);
  return wrong_header.empty() ? wrong_ply_elements(elements) : wrong_header;
}

inline std::string diagnose_ply(std::istream& in)
{
  Line_reader lines(in);
  bool ascii = false;
  std::vector<Ply_element> elements;
  std::string wrong_header = read_ply_header(lines, ascii, elements);
  if(wrong_header.empty())
    wrong_header = wrong_ply_elements(elements);
  if(!wrong_header.empty() || !ascii)
    return wrong_header;

  std::vector<std::string> words;
  std::size_t vertices = 0;
  for(const Ply_element& e : elements)
  {
    const bool is_vertex = e.is_vertex();
    if(is_vertex)
      vertices = e.number;
    const std::size_t x = static_cast<std::size_t>(
      std::find(e.properties.begin(), e.properties.end(), "x") - e.properties.begin());
    for(std::size_t i = 0; i < e.number; ++i)
    {
      if(!lines.next(words))
        return missing("elements '" + e.name + "'", i, e.number);
      const std::string element = e.name + ' ' + std::to_string(i);
      const std::string wrong = is_vertex               ? wrong_coordinates(words, x, element, lines.number())
                              : e.properties.size() > 1 ? std::string()
                              : e.is_face() ? wrong_face(words, vertices, element, lines.number())
                                            : std::string();
      if(!wrong.empty())
        return wrong;
    }
  }
  return std::string();
}

inline std::string diagnose_stl(std::istream& in)
{
  Line_reader lines(in);
  std::vector<std::string> words;
  if(!lines.next(words))
    return "the file is empty";
  if(words[0] != "solid")
    return std::string();
  std::size_t facets = 0;
  bool ended = false;
  while(lines.next(words))
  {
    ended = ended || words[0] == "endsolid";
    if(words[0] == "facet")
      ++facets;
    if(words[0] == "vertex")
    {
      const std::string wrong =
        wrong_coordinates(words, 1, "a vertex of facet " + std::to_string(facets - 1), lines.number());
      if(!wrong.empty())
        return wrong;
    }
  }
  if(facets == 0)
    return "the file has no facets";
  return ended ? std::string() : "the file ends without endsolid, after " + std::to_string(facets) + " facets";
}

} // namespace internal
} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_FILE_DIAGNOSIS_H
