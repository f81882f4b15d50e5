// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Output of numbers as bytes, for binary files.

#ifndef GEODESIC_OFFSET_BYTE_WRITER_H
#define GEODESIC_OFFSET_BYTE_WRITER_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <vector>

namespace geodesic_offset {

enum class Byte_order { little, big };

// Writes blocks: one call of the stream per number would take long.
class Byte_writer
{
  static constexpr std::size_t block = 1 << 16;

  std::ostream& m_out;
  Byte_order m_order;
  std::vector<char> m_bytes;

public:
  Byte_writer(std::ostream& out, Byte_order order) : m_out(out), m_order(order) {}
  Byte_writer(const Byte_writer&) = delete;
  Byte_writer& operator=(const Byte_writer&) = delete;
  ~Byte_writer() { flush(); }

  template <class Unsigned>
  void write(Unsigned value)
  {
    for(std::size_t i = 0; i < sizeof(Unsigned); ++i)
    {
      const std::size_t place = m_order == Byte_order::little ? i : sizeof(Unsigned) - 1 - i;
      m_bytes.push_back(static_cast<char>(static_cast<unsigned char>(value >> (8 * place))));
    }
    if(m_bytes.size() >= block) flush();
  }

  void write(double value)
  {
    std::uint64_t bits;
    static_assert(sizeof(bits) == sizeof(value), "doubles of 64 bits");
    std::memcpy(&bits, &value, sizeof(bits));
    write(bits);
  }

private:
  void flush()
  {
    m_out.write(m_bytes.data(), static_cast<std::streamsize>(m_bytes.size()));
    m_bytes.clear();
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_BYTE_WRITER_H
