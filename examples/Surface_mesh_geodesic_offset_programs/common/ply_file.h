// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Grammar of .ply files: header, and rows of elements, as text or in either binary format.
// Not CGAL's reader (5.5): it crashes if coordinates have an integer type, and does not check the indices of faces.

#ifndef GEODESIC_OFFSET_PLY_FILE_H
#define GEODESIC_OFFSET_PLY_FILE_H

#include "byte_scanner.h"
#include "off_reader.h"
#include "text_scanner.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace geodesic_offset::internal {

enum class Ply_type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

inline std::optional<Ply_type> ply_type(std::string_view name)
{
  constexpr std::pair<std::string_view, Ply_type> names[] = {
    {"char", Ply_type::int8},      {"int8", Ply_type::int8},       {"uchar", Ply_type::uint8},
    {"uint8", Ply_type::uint8},    {"short", Ply_type::int16},     {"int16", Ply_type::int16},
    {"ushort", Ply_type::uint16},  {"uint16", Ply_type::uint16},   {"int", Ply_type::int32},
    {"int32", Ply_type::int32},    {"uint", Ply_type::uint32},     {"uint32", Ply_type::uint32},
    {"float", Ply_type::float32},  {"float32", Ply_type::float32}, {"double", Ply_type::float64},
    {"float64", Ply_type::float64}};
  for(const auto& entry : names)
    if(entry.first == name) return entry.second;
  return std::nullopt;
}

inline bool is_real(Ply_type type) { return type == Ply_type::float32 || type == Ply_type::float64; }

inline std::size_t size_of(Ply_type type)
{
  switch(type)
  {
  case Ply_type::int8:
  case Ply_type::uint8: return 1;
  case Ply_type::int16:
  case Ply_type::uint16: return 2;
  case Ply_type::float64: return 8;
  default: return 4;
  }
}

// All numbers of these types are exact in double.
inline double read_number(Byte_scanner& bytes, Ply_type type)
{
  switch(type)
  {
  case Ply_type::int8: return bytes.read<std::int8_t>();
  case Ply_type::uint8: return bytes.read<std::uint8_t>();
  case Ply_type::int16: return bytes.read<std::int16_t>();
  case Ply_type::uint16: return bytes.read<std::uint16_t>();
  case Ply_type::int32: return bytes.read<std::int32_t>();
  case Ply_type::uint32: return bytes.read<std::uint32_t>();
  case Ply_type::float32: return static_cast<double>(bytes.read<float>());
  case Ply_type::float64: return bytes.read<double>();
  }
  return 0;
}

struct Ply_property
{
  std::string name;
  std::string type_name; // as in the header, like "list uchar int"
  Ply_type type = Ply_type::float32; // for a list: type of its items
  std::optional<Ply_type> count_type; // for a list

  bool is_list() const { return count_type.has_value(); }
};

struct Ply_element
{
  std::string name;
  std::size_t number = 0;
  std::vector<Ply_property> properties;

  bool is_vertex() const { return name == "vertex" || name == "vertices"; }
  bool is_face() const { return name == "face" || name == "faces"; }

  // Index of a property, or the number of properties if the name does not exist.
  std::size_t find(std::string_view property) const
  {
    return static_cast<std::size_t>(std::find_if(properties.begin(), properties.end(),
                                                 [&](const Ply_property& p) { return p.name == property; }) -
                                    properties.begin());
  }

  bool has(std::string_view property) const { return find(property) < properties.size(); }
};

// Rows must be read in the order of the elements. A reader of rows has the functions
//   void begin_row(std::size_t row)
//   void number(std::size_t property, double value)            for binary files
//   void word(std::size_t property, std::string_view word)     for text files; may not be a number
//   void begin_list(std::size_t property, std::size_t size)    followed by number() or word() for its items
//   bool reads(std::size_t property)                           whether it uses a property
class Ply_file
{
  std::string_view m_bytes;
  Text_scanner m_text;
  bool m_is_ascii = false, m_is_big_endian = false;
  bool m_has_vertices = false, m_has_faces = false;
  std::vector<Ply_element> m_elements;
  std::optional<Byte_scanner> m_data; // for binary files

public:
  // Reads the header. Throws Input_error.
  Ply_file(const std::string& path, std::string_view bytes) : m_bytes(bytes), m_text(path, bytes, Text_style::plain)
  {
    if(!m_text.find_word() || m_text.word() != "ply" || !m_text.is_at_line_end()) fail("the file does not begin with ply");
    bool has_format = false;
    for(;;)
    {
      if(!m_text.find_word_on_next_line()) fail("the file ends within its header");
      const std::string_view keyword = m_text.word();
      if(keyword == "end_header") break;
      if(keyword == "format")
      {
        read_format();
        has_format = true;
      }
      else if(keyword == "element")
        read_element();
      else if(keyword == "property")
        read_property();
      else if(keyword != "comment" && keyword != "obj_info")
        m_text.fail_here(quoted_word(keyword) + " is none of the words of a header: format, element, property, comment, "
                                                "obj_info and end_header");
    }
    if(!has_format) fail("the header has no format");
    for(const Ply_element& element : m_elements)
      if(element.properties.empty() && element.number != 0)
        fail("the element " + quoted_word(element.name) + " has no properties");
    m_text.next_line();
    if(!m_is_ascii) m_data.emplace(m_bytes.substr(m_text.position()), m_is_big_endian);
  }

  const std::vector<Ply_element>& elements() const { return m_elements; }

  // Position for messages: "line 7: " in a text, empty in a binary file.
  std::string where() const { return m_is_ascii ? "line " + std::to_string(m_text.line()) + ": " : std::string(); }

  std::string message(const std::string& text) const { return m_text.message(text); }
  [[noreturn]] void fail(const std::string& text) const { m_text.fail(text); }

  // Number of bytes after the last row; trailing blanks of a text do not count.
  std::size_t number_of_bytes_left()
  {
    if(m_data) return m_data->remaining();
    return m_text.find_word() ? m_text.remaining() : 0;
  }

  // Upper bound of the number of rows in the rest of the file, for reserve().
  std::size_t most_rows(const Ply_element& element) const
  {
    const std::size_t row = std::max(std::size_t(1), m_data ? smallest_row(element) : 2 * element.properties.size());
    return std::min(element.number, (m_data ? m_data->remaining() : m_text.remaining()) / row + 1);
  }

  template <class Row_reader>
  void read_rows(const Ply_element& element, Row_reader&& reader)
  {
    for(std::size_t row = 0; row < element.number; ++row)
      if(m_data)
        read_binary_row(element, row, reader);
      else
        read_text_row(element, row, reader);
  }

  // Skips an element.
  void skip_rows(const Ply_element& element)
  {
    struct Nothing
    {
      void begin_row(std::size_t) {}
      void number(std::size_t, double) {}
      void word(std::size_t, std::string_view) {}
      void begin_list(std::size_t, std::size_t) {}
      bool reads(std::size_t) const { return false; }
    };
    read_rows(element, Nothing());
  }

private:
  void read_format()
  {
    const std::string_view format = m_text.word();
    m_is_ascii = (format == "ascii");
    m_is_big_endian = (format == "binary_big_endian");
    if(!m_is_ascii && !m_is_big_endian && format != "binary_little_endian")
      m_text.fail_here("malformed header: the format is ascii, binary_little_endian or binary_big_endian, not " +
                       quoted_word(format));
    if(const std::string_view version = m_text.word(); version != "1.0")
      m_text.fail_here("malformed header: the version of the format is 1.0, not " + quoted_word(version));
  }

  void read_element()
  {
    Ply_element element;
    element.name = m_text.word();
    if(element.name.empty() || !m_text.read(element.number) || !m_text.is_at_line_end())
      m_text.fail_here("the name and the number of elements are expected behind 'element'");
    if((element.is_vertex() && m_has_vertices) || (element.is_face() && m_has_faces))
      m_text.fail_here("the header has the element " + quoted_word(element.name) + " twice");
    m_has_vertices = m_has_vertices || element.is_vertex();
    m_has_faces = m_has_faces || element.is_face();
    m_elements.push_back(std::move(element));
  }

  void read_property()
  {
    if(m_elements.empty()) m_text.fail_here("misplaced property: no element stands in front of it");
    std::vector<std::string> words;
    while(!m_text.is_at_line_end() && words.size() < 5) // a list has four
      words.emplace_back(m_text.word());
    if(words.size() < 2) m_text.fail_here("the type and the name of a property are expected behind 'property'");
    Ply_property property;
    property.name = words.back();
    words.pop_back();
    for(const std::string& word : words) property.type_name += (property.type_name.empty() ? "" : " ") + word;
    const bool is_list = words[0] == "list";
    const std::optional<Ply_type> type = words.size() == (is_list ? 3 : 1) ? ply_type(words.back()) : std::optional<Ply_type>();
    if(is_list && type) property.count_type = ply_type(words[1]);
    if(!type || (is_list && (!property.count_type || is_real(*property.count_type))))
      m_text.fail_here("the property " + quoted_word(property.name) + " has the unknown type " +
                       quoted_word(property.type_name));
    property.type = *type;
    m_elements.back().properties.push_back(std::move(property));
  }

  static std::size_t smallest_row(const Ply_element& element)
  {
    std::size_t size = 0;
    for(const Ply_property& property : element.properties) size += size_of(property.count_type.value_or(property.type));
    return size;
  }

  [[noreturn]] void fail_missing(const Ply_element& element, std::size_t row) const
  {
    fail(missing(element.is_vertex() ? "vertices"
                 : element.is_face() ? "faces"
                                     : "elements '" + element.name + "'",
                 row, element.number));
  }

  [[noreturn]] void fail_in_row(const Ply_element& element, std::size_t row, const std::string& text) const
  {
    fail(where() + element.name + ' ' + std::to_string(row) + ' ' + text);
  }

  template <class Row_reader>
  void read_binary_row(const Ply_element& element, std::size_t row, Row_reader& reader)
  {
    Byte_scanner& bytes = *m_data;
    reader.begin_row(row);
    for(std::size_t p = 0; p < element.properties.size(); ++p)
    {
      const Ply_property& property = element.properties[p];
      const std::size_t item_size = size_of(property.type);
      std::size_t items = 1;
      if(property.is_list())
      {
        if(bytes.remaining() < size_of(*property.count_type)) fail_missing(element, row);
        const double size = read_number(bytes, *property.count_type);
        if(size < 0)
          fail_in_row(element, row,
                      "has a list " + quoted_word(property.name) + " of " + std::to_string(static_cast<std::int64_t>(size)) +
                        " numbers");
        items = static_cast<std::size_t>(size);
      }
      if(bytes.remaining() / item_size < items) fail_missing(element, row);
      if(!reader.reads(p))
      {
        bytes.skip(items * item_size);
        continue;
      }
      if(property.is_list()) reader.begin_list(p, items);
      for(std::size_t i = 0; i < items; ++i) reader.number(p, read_number(bytes, property.type));
    }
  }

  // Each row is a line.
  template <class Row_reader>
  void read_text_row(const Ply_element& element, std::size_t row, Row_reader& reader)
  {
    if(!m_text.find_word()) fail_missing(element, row);
    reader.begin_row(row);
    for(std::size_t p = 0; p < element.properties.size(); ++p)
    {
      const Ply_property& property = element.properties[p];
      const auto require_word = [&] {
        if(m_text.is_at_line_end())
          fail_in_row(element, row, "ends before its property " + quoted_word(property.name) + " is complete");
      };
      require_word();
      std::size_t items = 1;
      if(property.is_list())
      {
        if(!m_text.read(items))
          fail_in_row(element, row,
                      "has a list " + quoted_word(property.name) + " of " + quoted_word(m_text.word()) + " numbers");
        if(reader.reads(p)) reader.begin_list(p, std::min(items, m_text.remaining() / 2 + 1));
      }
      for(std::size_t i = 0; i < items; ++i)
      {
        require_word();
        const std::string_view word = m_text.word();
        if(reader.reads(p)) reader.word(p, word);
      }
    }
    if(!m_text.is_at_line_end()) fail_in_row(element, row, "has more numbers than the header announces");
    m_text.next_line();
  }
};

} // namespace geodesic_offset::internal

#endif // GEODESIC_OFFSET_PLY_FILE_H
