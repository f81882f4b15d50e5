// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers as they stand on the command line and in text files: the whole word must be one finite decimal number.
// The readers of the standard library stop silently at the first character that they do not understand.

#ifndef GEODESIC_OFFSET_NUMBERS_H
#define GEODESIC_OFFSET_NUMBERS_H

#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace geodesic_offset {

inline bool parse_number(const std::string& word, double& value)
{
  // strtod also accepts blanks in front, hexadecimal numbers, "nan" and "inf"
  if(word.empty() || word.find_first_not_of("0123456789+-.eE") != std::string::npos)
    return false;
  char* end = nullptr;
  value = std::strtod(word.c_str(), &end);
  return end == word.c_str() + word.size() && std::isfinite(value);
}

inline bool parse_index(const std::string& word, std::size_t& value)
{
  if(word.empty() || word.find_first_not_of("0123456789") != std::string::npos)
    return false;
  value = 0;
  for(char c : word)
  {
    const std::size_t digit = static_cast<std::size_t>(c - '0');
    if(value > (std::numeric_limits<std::size_t>::max() - digit) / 10)
      return false;
    value = 10 * value + digit;
  }
  return true;
}

// N numbers separated by commas
template <class Array>
bool parse_numbers(const std::string& word, Array& values)
{
  std::size_t begin = 0;
  for(std::size_t i = 0; i < values.size(); ++i)
  {
    const std::size_t end = word.find(',', begin);
    const bool last = (i + 1 == values.size());
    if(last != (end == std::string::npos))
      return false;
    if(!parse_number(word.substr(begin, last ? end : end - begin), values[i]))
      return false;
    begin = end + 1;
  }
  return true;
}

// Whether a word spells NaN or an infinity, in one of the ways of the usual run-time libraries.
inline bool spells_non_finite_number(std::string word)
{
  for(char& c : word)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::size_t begin = word.find_first_not_of("+-");
  if(begin == std::string::npos)
    return false;
  word.erase(0, begin);
  return word == "inf" || word == "infinity" || word.compare(0, 3, "nan") == 0 || word.compare(0, 3, "1.#") == 0;
}

inline std::vector<std::string> words_of(const std::string& line)
{
  std::vector<std::string> words;
  std::istringstream stream(line);
  for(std::string word; stream >> word;)
    words.push_back(word);
  return words;
}

// As short as it can be said without losing anything that a person would want to know.
inline std::string short_number(double value)
{
  std::ostringstream stream;
  stream.precision(6);
  stream << value;
  return stream.str();
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_NUMBERS_H
