// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The files of a run: all of them, or none.

#ifndef GEODESIC_OFFSET_OUTPUTS_H
#define GEODESIC_OFFSET_OUTPUTS_H

#include "common/common.h"
#include "common/mesh_input.h"
#include "common/output_file.h"
#include "common/sources.h"
#include "curve_files.h"
#include "field_output.h"
#include "options.h"
#include "paths.h"
#include "progress.h"
#include "stats_output.h"

namespace geodesic_offset {

// Results of the first build; the picture may need another one.
struct Solution
{
  Offsets offsets;
  Geodesic::Statistics statistics;
  File_field field;
};

// Of curves as polylines
inline double chord_tolerance(const Options& options, const Mesh_input& input)
{
  return options.tolerance.value_or(1e-4 * input.bounding_box_diagonal());
}

// Shows the progress of writing.
Output_files::Report writing_bar(Progress& progress);

// Writes what is requested and not yet in `files`. Throws Input_error.
void write_outputs(const Solution& solution, const Mesh_input& input, const Sources& sources, const Path_queries& queries,
                   Geodesic& geodesic, const Options& options, Output_files& files, const Run_figures& figures,
                   Progress& progress);

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_OUTPUTS_H
