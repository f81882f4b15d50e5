// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The bytes of a file with a matrix. All rows have the same size, so each has its place. At first all numbers are NaN, which no
// distance is: a row with a NaN is not complete, also if only a part of it was written.

#ifndef GEODESIC_DISTANCE_MATRIX_MATRIX_LAYOUT_H
#define GEODESIC_DISTANCE_MATRIX_MATRIX_LAYOUT_H

#include "common/common.h"
#include "common/file_bytes.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace geodesic_offset {

class Matrix_layout
{
  // The longest number is "-2.2250738585072014e-308": a cell of .csv has its size and the separator.
  static constexpr std::size_t cell = 25;

  std::size_t m_rows, m_columns;
  bool m_is_csv;
  std::string m_header;

public:
  Matrix_layout(std::size_t rows, std::size_t columns, bool is_csv) : m_rows(rows), m_columns(columns), m_is_csv(is_csv)
  {
    if(!is_csv) m_header = npy_header();
  }

  std::size_t row_size() const { return m_columns * (m_is_csv ? cell : sizeof(double)); }
  std::size_t place(std::size_t row) const { return m_header.size() + row * row_size(); }
  std::size_t file_size() const { return place(m_rows); }

  std::string bytes(const std::vector<double>& row) const
  {
    if(!m_is_csv) return std::string(reinterpret_cast<const char*>(row.data()), row_size());
    std::string text(row_size(), ' ');
    for(std::size_t i = 0; i < m_columns; ++i)
    {
      char* const at = text.data() + i * cell;
      std::to_chars(at, at + cell - 1, row[i]); // shortest text with the same number; "inf" and "nan"
      at[cell - 1] = i + 1 == m_columns ? '\n' : ',';
    }
    return text;
  }

  // Writes a file without complete rows. Throws Input_error.
  void create(const std::string& path) const
  {
    errno = 0;
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    const std::string row = bytes(std::vector<double>(m_columns, std::numeric_limits<double>::quiet_NaN()));
    out << m_header;
    for(std::size_t i = 0; i < m_rows && out; ++i) out << row;
    out.close();
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    const bool is_on_disk = file >= 0 && ::fsync(file) == 0; // a machine that breaks down must not leave zeros
    if(file >= 0) ::close(file);
    if(!out || !is_on_disk)
    {
      const std::string reason = errno == 0 ? "unknown error" : std::strerror(errno);
      std::remove(path.c_str());
      throw Input_error("cannot write " + quoted(path) + ": " + reason);
    }
  }

  // The complete rows of a file; `found(row, bytes)` is called for each. Throws Input_error if the file is not that of such a matrix.
  template <class Function>
  void read(const std::string& path, const Function& found) const
  {
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if(!in) throw Input_error("cannot read " + quoted(path) + ": " + std::strerror(errno));
    std::string bytes(m_header.size(), '\0');
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    in.seekg(0, std::ios::end);
    if(bytes != m_header || static_cast<std::size_t>(in.tellg()) != file_size())
      throw Input_error("cannot resume " + quoted(path) + ": it has no matrix of " + counted(m_rows, "row") + " and " +
                        counted(m_columns, "column"));
    in.seekg(static_cast<std::streamoff>(m_header.size()));
    bytes.resize(row_size());
    for(std::size_t i = 0; i < m_rows; ++i)
    {
      if(!in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
        throw Input_error("cannot read " + quoted(path) + ": row " + std::to_string(i));
      if(is_complete(bytes)) found(i, bytes);
    }
  }

private:
  bool is_complete(const std::string& row) const
  {
    if(m_is_csv) return row.find("nan") == std::string::npos && row.back() == '\n';
    for(std::size_t at = 0; at < row.size(); at += sizeof(double))
    {
      double x;
      std::memcpy(&x, row.data() + at, sizeof(x));
      if(x != x) return false;
    }
    return true;
  }

  // Version 1.0 of the format of NumPy: a dictionary of Python, filled up to a multiple of 64 bytes.
  std::string npy_header() const
  {
    std::string text = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(m_rows) + ", " +
                       std::to_string(m_columns) + "), }";
    constexpr std::size_t before = 10, block = 64; // magic string, version and length; and the alignment of the numbers
    text.resize((before + text.size() + block) / block * block - before, ' ');
    text.back() = '\n';
    const std::string length{static_cast<char>(text.size() & 255), static_cast<char>(text.size() >> 8)};
    return std::string("\x93NUMPY\x01\0", 8) + length + text;
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_DISTANCE_MATRIX_MATRIX_LAYOUT_H
