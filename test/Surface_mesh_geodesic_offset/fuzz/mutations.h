// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Random damage to files: bytes, numbers, words, lines, and parts of other files.

#ifndef GEODESIC_OFFSET_TEST_MUTATIONS_H
#define GEODESIC_OFFSET_TEST_MUTATIONS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

namespace test {

class File_mutator
{
  std::mt19937_64 m_random;

public:
  explicit File_mutator(std::uint64_t seed) : m_random(seed) {}

  /// Number from 0 to n - 1; 0 for n = 0.
  std::size_t below(std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(m_random() % n); }

  /// Applies one to eight changes; `other`: a file as a source of parts.
  std::string operator()(std::string bytes, const std::string& other)
  {
    constexpr std::size_t longest = 1 << 16;
    for (std::size_t n = below(3) == 0 ? 1 + below(8) : 1; n > 0; --n)
    {
      change(bytes, other);
      bytes.resize(std::min(bytes.size(), longest));
    }
    return bytes;
  }

private:
  static bool is_separator(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '/'; }

  void change(std::string& bytes, const std::string& other)
  {
    const std::size_t at = below(bytes.size() + 1);
    switch (below(13))
    {
    case 0:
      if (at < bytes.size()) bytes[at] = static_cast<char>(below(256));
      break;
    case 1:
      if (at < bytes.size()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
      break;
    case 2: bytes.insert(at, 1, static_cast<char>(below(256))); break;
    case 3: bytes.erase(at, 1 + below(below(2) == 0 ? 3 : 100)); break;
    case 4: bytes.resize(at); break;
    case 5:
    case 6:
    case 7: replace_word(bytes, at, below(2) == 0 ? number() : keyword()); break;
    case 8: replace_word(bytes, at, ""); break;
    case 9: copy_line(bytes, at); break;
    case 10: erase_line(bytes, at); break;
    case 11: overwrite(bytes, at); break;
    default: const std::size_t from = below(other.size()); bytes.replace(at, below(40), other, from, below(60));
    }
  }

  std::string number()
  {
    // clang-format off
    static const char* const numbers[] = {
      "-1", "0", "1", "2", "3", "4", "5", "6", "7", "100", "255", "256", "65535", "65536", "2147483647", "2147483648",
      "4294967295", "4294967296", "4294967297", "9223372036854775808", "18446744073709551615", "18446744073709551616",
      "99999999999999999999999999", "-2147483648", "-2147483649", "1e999", "-1e999", "1e-400", "1e308", "nan", "-nan", "inf",
      "-inf", "1.5", "0x10", "1e", "e5", ".", "-", "+", "+-1", "--1", "1,5", "1#2", "1/2/3", "/", "//", "5/", "-9", "1.#IND",
      "NAN(5)", "00000000000000000003", "3.0", "1_000"};
    // clang-format on
    return numbers[below(sizeof(numbers) / sizeof(numbers[0]))];
  }

  std::string keyword()
  {
    // clang-format off
    static const char* const words[] = {
      "OFF", "COFF", "NOFF", "STOFF", "4OFF", "nOFF", "STCN4nOFF", "SKEL", "BINARY", "v", "vt", "f", "l", "#", "\\\n", "ply",
      "format", "ascii", "binary_little_endian", "binary_big_endian", "1.0", "comment", "element", "vertex", "vertices", "face",
      "property", "list", "char", "uchar", "short", "ushort", "int", "uint", "float", "double", "int8", "float64", "half", "x",
      "y", "z", "vertex_indices", "vertex_index", "end_header", "solid", "facet", "normal", "outer", "loop", "endloop",
      "endfacet", "endsolid", "distance", "\n", "\r", "\r\n", "\t", "\xef\xbb\xbf", "property list uchar int x",
      "element nothing 1000000000", "property uchar a\nproperty list int int b"};
    // clang-format on
    return words[below(sizeof(words) / sizeof(words[0]))];
  }

  // Replaces the word at a position.
  static void replace_word(std::string& bytes, std::size_t at, const std::string& by)
  {
    std::size_t begin = at, end = at;
    while (begin > 0 && !is_separator(bytes[begin - 1])) --begin;
    while (end < bytes.size() && !is_separator(bytes[end])) ++end;
    bytes.replace(begin, end - begin, by);
  }

  static std::size_t line_begin(const std::string& bytes, std::size_t at)
  {
    while (at > 0 && bytes[at - 1] != '\n') --at;
    return at;
  }

  static std::size_t line_size(const std::string& bytes, std::size_t begin)
  {
    const std::size_t end = bytes.find('\n', begin);
    return end == std::string::npos ? bytes.size() - begin : end + 1 - begin;
  }

  void copy_line(std::string& bytes, std::size_t at)
  {
    const std::size_t begin = line_begin(bytes, at);
    const std::string line = bytes.substr(begin, line_size(bytes, begin));
    const std::size_t to = line_begin(bytes, below(bytes.size() + 1));
    for (std::size_t n = below(8) == 0 ? below(300) : 1; n > 0; --n) bytes.insert(to, line);
  }

  static void erase_line(std::string& bytes, std::size_t at)
  {
    const std::size_t begin = line_begin(bytes, at);
    bytes.erase(begin, line_size(bytes, begin));
  }

  // Writes a special number of a binary file.
  void overwrite(std::string& bytes, std::size_t at)
  {
    static const std::uint64_t patterns[] = {
      0,
      1,
      3,
      0xff,
      0x7f,
      0x80,
      0xffff,
      0x7fffffff,
      0x80000000,
      0xffffffff,
      0x7f800000,
      0x7fc00000,
      0x00000100,
      0x01000000,
      0xffffffffffffffff,
      0x7ff0000000000000};
    const std::uint64_t pattern = patterns[below(sizeof(patterns) / sizeof(patterns[0]))];
    const std::size_t size = std::size_t(1) << below(4);
    const bool is_reversed = below(2) == 0;
    for (std::size_t i = 0; i < size && at + i < bytes.size(); ++i)
      bytes[at + i] = static_cast<char>(pattern >> (8 * (is_reversed ? size - 1 - i : i)));
  }
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_MUTATIONS_H
