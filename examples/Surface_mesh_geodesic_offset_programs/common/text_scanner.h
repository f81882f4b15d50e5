// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Words of a text file, line by line. All text readers use this class, so that words, lines, comments, numbers and the form
// of errors are uniform.

#ifndef GEODESIC_OFFSET_TEXT_SCANNER_H
#define GEODESIC_OFFSET_TEXT_SCANNER_H

#include "messages.h"
#include "numbers.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

namespace geodesic_offset {

enum class Text_style {
  plain,
  with_comments, // '#' begins a comment
  with_comments_and_continuations // and '\' at the end of a line continues it
};

// Position in a text. Lines end with "\n", "\r\n" or "\r"; words are separated by blanks. All functions are safe at the end
// of the text.
class Text_scanner
{
  const std::string* m_path;
  const char* m_begin;
  const char* m_at;
  const char* m_end;
  std::size_t m_line = 1;
  Text_style m_style;

public:
  // `path` is for messages; both arguments must outlive the scanner. Skips a byte order mark.
  Text_scanner(const std::string& path, std::string_view text, Text_style style)
    : m_path(&path), m_begin(text.data()), m_at(text.data()), m_end(text.data() + text.size()), m_style(style)
  {
    if(text.substr(0, 3) == "\xef\xbb\xbf") m_at += 3;
  }

  const std::string& path() const { return *m_path; }

  // Number of the current line, from 1.
  std::size_t line() const { return m_line; }

  // Number of bytes before and after the current position.
  std::size_t position() const { return static_cast<std::size_t>(m_at - m_begin); }
  std::size_t remaining() const { return static_cast<std::size_t>(m_end - m_at); }

  // Whether no word follows on the current line.
  bool is_at_line_end()
  {
    skip_blanks();
    return m_at == m_end || is_newline(*m_at);
  }

  // Moves to the next line, if there is one.
  void next_line()
  {
    skip_line();
    if(m_at == m_end) return;
    m_at += (*m_at == '\r' && m_end - m_at > 1 && m_at[1] == '\n') ? 2 : 1;
    ++m_line;
  }

  // Moves to the next word of this line or a later one. Returns whether there is one.
  bool find_word()
  {
    while(is_at_line_end())
    {
      if(m_at == m_end) return false;
      next_line();
    }
    return true;
  }

  // Moves to the first word after the current line. Returns whether there is one.
  bool find_word_on_next_line()
  {
    next_line();
    return find_word();
  }

  // Reads the next word of this line; empty at the end of the line.
  std::string_view word()
  {
    skip_blanks();
    const std::string_view result = upcoming_word();
    m_at += result.size();
    return result;
  }

  // Reads the next word of this line if it is a finite number; otherwise the position is unchanged.
  bool read(double& value)
  {
    skip_blanks();
    double number = 0;
    const std::from_chars_result result = std::from_chars(m_at, m_end, number);
    if(result.ec == std::errc() && is_word_end(result.ptr) && std::isfinite(number))
    {
      m_at = result.ptr;
      value = number;
      return true;
    }
    // a sign, or a number too small for a double
    const std::string_view word = upcoming_word();
    if(!parse_number(word, value)) return false;
    m_at += word.size();
    return true;
  }

  // Reads the next word of this line if it is an integer from 0 on; otherwise the position is unchanged.
  bool read(std::size_t& value)
  {
    skip_blanks();
    const std::string_view word = upcoming_word();
    if(!parse_index(word, value)) return false;
    m_at += word.size();
    return true;
  }

  std::string message(const std::string& text) const { return "cannot read " + quoted(*m_path) + ": " + text; }

  [[noreturn]] void fail(const std::string& text) const { throw Input_error(message(text)); }

  [[noreturn]] void fail_at(std::size_t line, const std::string& text) const
  {
    fail("line " + std::to_string(line) + ": " + text);
  }

  [[noreturn]] void fail_here(const std::string& text) const { fail_at(m_line, text); }

  // Reads the three coordinates of an element, such as "vertex 3"; `name` returns the name. Calls not_finite(message) for the first
  // coordinate that is a number but not finite, which becomes NaN.
  template <class Name, class Not_finite>
  std::array<double, 3> coordinates(const Name& name, const Not_finite& not_finite)
  {
    std::array<double, 3> c{};
    bool is_finite = true;
    for(double& x : c)
    {
      if(read(x)) continue;
      const std::string_view word = this->word();
      const std::string text =
        "line " + std::to_string(m_line) + ": " + name() +
        (word.empty() ? " has fewer than three coordinates"
                      : " has the coordinate " + quoted_word(word) + ", which is not a finite number");
      if(!is_not_finite(word)) fail(text);
      if(is_finite) not_finite(message(text));
      is_finite = false;
      x = std::numeric_limits<double>::quiet_NaN();
    }
    return c;
  }

private:
  static bool is_newline(char c) { return c == '\n' || c == '\r'; }
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

  bool has_comments() const { return m_style != Text_style::plain; }

  bool is_word_end(const char* at) const
  {
    return at == m_end || is_blank(*at) || is_newline(*at) || (*at == '#' && has_comments());
  }

  std::string_view upcoming_word() const
  {
    const char* end = m_at;
    while(!is_word_end(end)) ++end;
    return {m_at, static_cast<std::size_t>(end - m_at)};
  }

  // Length of a backslash and the following end of line, or 0.
  std::size_t continuation() const
  {
    if(m_style != Text_style::with_comments_and_continuations || *m_at != '\\' || m_end - m_at < 2 || !is_newline(m_at[1]))
      return 0;
    return m_end - m_at > 2 && m_at[1] == '\r' && m_at[2] == '\n' ? 3 : 2;
  }

  // Moves to the next word of this line, or to its end.
  void skip_blanks()
  {
    while(m_at != m_end)
      if(is_blank(*m_at))
        ++m_at;
      else if(const std::size_t length = continuation())
      {
        m_at += length;
        ++m_line;
      }
      else
        break;
    if(m_at != m_end && *m_at == '#' && has_comments()) skip_line();
  }

  void skip_line()
  {
    while(m_at != m_end && !is_newline(*m_at)) ++m_at;
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_TEXT_SCANNER_H
