// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers on the command line and in text files: the whole word must be one finite decimal number. Streams of the standard
// library would silently stop at the first invalid character.

#ifndef GEODESIC_OFFSET_NUMBERS_H
#define GEODESIC_OFFSET_NUMBERS_H

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace geodesic_offset {

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Returns false, and leaves `value` unchanged, if the whole word is not a number. The format does not depend on the locale.
// Numbers too small for a double become 0.
inline bool parse_number(std::string_view word, double& value)
{
  const bool has_plus = !word.empty() && word.front() == '+';
  if(has_plus) word.remove_prefix(1);
  // std::from_chars also accepts "nan" and "inf", and "-1" after the plus
  if(word.empty() || !((word.front() == '-' && !has_plus) || word.front() == '.' || is_digit(word.front()))) return false;
  double number = 0;
  const std::from_chars_result result = std::from_chars(word.data(), word.data() + word.size(), number);
  if(result.ptr != word.data() + word.size()) return false;
  if(result.ec == std::errc::result_out_of_range) // too large or too small; `number` is unchanged
    number = std::strtod(std::string(word).c_str(), nullptr);
  else if(result.ec != std::errc())
    return false;
  if(!std::isfinite(number)) return false;
  value = number;
  return true;
}

// Whether a word is a number that is not finite, as "nan", "-inf", or "1e999".
inline bool is_not_finite(std::string_view word)
{
  const std::string text(word);
  char* end = nullptr;
  return !std::isfinite(std::strtod(text.c_str(), &end)) && end == text.c_str() + text.size();
}

inline bool parse_index(std::string_view word, std::size_t& value)
{
  if(word.empty() || !is_digit(word.front())) return false;
  std::size_t number = 0;
  const std::from_chars_result result = std::from_chars(word.data(), word.data() + word.size(), number);
  if(result.ec != std::errc() || result.ptr != word.data() + word.size()) return false;
  value = number;
  return true;
}

// N numbers separated by commas.
template <class Array>
bool parse_numbers(const std::string& word, Array& values)
{
  std::size_t begin = 0;
  for(std::size_t i = 0; i < values.size(); ++i)
  {
    const std::size_t end = word.find(',', begin);
    const bool last = (i + 1 == values.size());
    if(last != (end == std::string::npos)) return false;
    if(!parse_number(std::string_view(word).substr(begin, last ? end : end - begin), values[i])) return false;
    begin = end + 1;
  }
  return true;
}

// Short form of a number for people: six digits, or more for all digits before the point, as of coordinates in a national grid.
inline std::string short_number(double value)
{
  constexpr int few = 6, most = std::numeric_limits<double>::digits10;
  std::ostringstream stream;
  stream.precision(few);
  for(double limit = 1e6; std::abs(value) >= limit && stream.precision() < most; limit *= 10)
    stream.precision(stream.precision() + 1);
  stream << value;
  return stream.str();
}

// The same, rounded up.
inline std::string short_upper_bound(double value)
{
  std::string text = short_number(value);
  for(double larger = value; std::strtod(text.c_str(), nullptr) < value; text = short_number(larger))
    larger += std::max(1e-7 * std::abs(value), std::numeric_limits<double>::denorm_min());
  return text;
}

// With as many digits as a reader needs to get the same double
inline std::string full_number(double value)
{
  std::ostringstream stream;
  stream.precision(std::numeric_limits<double>::max_digits10);
  stream << value;
  return stream.str();
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_NUMBERS_H
