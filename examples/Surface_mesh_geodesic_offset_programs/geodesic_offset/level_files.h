// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Files of offsets that are written level by level during the computation.

#ifndef GEODESIC_OFFSET_LEVEL_FILES_H
#define GEODESIC_OFFSET_LEVEL_FILES_H

#include "common/common.h"
#include "common/output_file.h"
#include "output_options.h"

#include <CGAL/Surface_mesh_geodesic_offset/IO/Offset_level_writer.h>

#include <memory>
#include <string>
#include <vector>

namespace geodesic_offset {

class Level_files
{
  struct File
  {
    std::string target;
    std::unique_ptr<CGAL::IO::Offset_level_writer> writer;
  };

  Output_files& m_files;
  std::vector<File> m_open;

public:
  static bool supports(const std::string& file)
  {
    return CGAL::IO::Offset_level_writer::supports(CGAL::IO::offset_file_format(file));
  }

  // Whether a file is written here.
  static bool is_written_by_level(const Output_options& options, const std::string& file)
  {
    return supports(file) && options.order == Curve_order::as_cut;
  }

  // Throws Input_error, here and below, if a file cannot be written.
  Level_files(Output_files& files, const Output_options& options, double tolerance) : m_files(files)
  {
    using CGAL::IO::Offset_level_writer;
    for(const std::string& file : options.outputs)
      if(is_written_by_level(options, file))
        m_open.push_back({file, with_point_parameters(options, tolerance, [&](const auto& parameters) {
                            return std::make_unique<Offset_level_writer>(files.open(file), CGAL::IO::offset_file_format(file),
                                                                         parameters);
                          })});
  }

  // Writes the offsets of one distance.
  void write(const std::vector<Offset_curve>& curves)
  {
    for(File& file : m_open)
      if(!file.writer->write(curves)) m_files.check_stream(file.target);
  }

  void finish()
  {
    for(File& file : m_open)
    {
      file.writer->finish();
      m_files.close(file.target);
    }
    m_open.clear();
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_LEVEL_FILES_H
