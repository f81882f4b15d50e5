// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The two kinds of failure of the programs, and words of messages.

#ifndef GEODESIC_OFFSET_MESSAGES_H
#define GEODESIC_OFFSET_MESSAGES_H

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace geodesic_offset {

// Error in the command line: exit code 2.
struct Usage_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// Error in something that the command line names: exit code 1.
struct Input_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

inline bool has_extension(const std::string& path, const std::string& extension)
{
  return path.size() > extension.size() && std::equal(extension.rbegin(), extension.rend(), path.rbegin(), [](char a, char b) {
           return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
         });
}

// Messages may contain parts of damaged files.
inline std::string one_line(std::string text)
{
  for(char& c : text)
    if(static_cast<unsigned char>(c) < 32 || c == 127) c = ' ';
  constexpr std::size_t longest = 500;
  return text.size() > longest ? text.substr(0, longest) + "..." : text;
}

// With blanks for null characters, which damaged files contain: the text of an exception ends at the first one.
inline std::string quoted(std::string s)
{
  std::replace(s.begin(), s.end(), '\0', ' ');
  return "'" + s + "'";
}

// A word of a file for messages, at most its first 40 characters.
inline std::string quoted_word(std::string_view word) { return quoted(std::string(word.substr(0, 40))); }

// "1 face", "2 faces".
inline std::string counted(std::size_t n, const std::string& singular, const std::string& plural = "")
{
  return std::to_string(n) + ' ' + (n == 1 ? singular : plural.empty() ? singular + 's' : plural);
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_MESSAGES_H
