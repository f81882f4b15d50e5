// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers of binary files, in either byte order.

#ifndef GEODESIC_OFFSET_BYTE_SCANNER_H
#define GEODESIC_OFFSET_BYTE_SCANNER_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace geodesic_offset {

class Byte_scanner
{
  const unsigned char* m_at;
  const unsigned char* m_end;
  bool m_is_big_endian;

public:
  Byte_scanner(std::string_view bytes, bool is_big_endian)
    : m_at(reinterpret_cast<const unsigned char*>(bytes.data())), m_end(m_at + bytes.size()), m_is_big_endian(is_big_endian)
  {
  }

  std::size_t remaining() const { return static_cast<std::size_t>(m_end - m_at); }

  // Precondition: at least `bytes` bytes remain.
  void skip(std::size_t bytes) { m_at += bytes; }

  // Reads an integer or a floating point number. Precondition: sizeof(Number) bytes remain.
  template <class Number>
  Number read()
  {
    std::uint64_t bits = 0;
    for(std::size_t i = 0; i < sizeof(Number); ++i)
      bits |= static_cast<std::uint64_t>(m_at[m_is_big_endian ? sizeof(Number) - 1 - i : i]) << (8 * i);
    m_at += sizeof(Number);
    return number_of_bits<Number>(bits);
  }

private:
  // The lowest bytes of `bits` as a number.
  template <class Number>
  static Number number_of_bits(std::uint64_t bits)
  {
    static_assert(sizeof(float) == 4 && sizeof(double) == 8, "floating point numbers of IEEE 754");
    if constexpr(sizeof(Number) == 1)
      return bits_as<Number>(static_cast<std::uint8_t>(bits));
    else if constexpr(sizeof(Number) == 2)
      return bits_as<Number>(static_cast<std::uint16_t>(bits));
    else if constexpr(sizeof(Number) == 4)
      return bits_as<Number>(static_cast<std::uint32_t>(bits));
    else
      return bits_as<Number>(bits);
  }

  template <class Number, class Bits>
  static Number bits_as(Bits bits)
  {
    static_assert(sizeof(Number) == sizeof(Bits), "the same size");
    Number number;
    std::memcpy(&number, &bits, sizeof(number));
    return number;
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_BYTE_SCANNER_H
