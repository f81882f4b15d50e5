// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The named parameters of the package, in the form of CGAL's list: tag, its enumerator, and name of the function.
//
// No include guard, see CGAL/STL_Extension/internal/parameters_interface.h.

#include <CGAL/version.h>

#ifndef CGAL_GEODESIC_OFFSET_NAMED_PARAMETERS_ARE_REGISTERED
#define CGAL_GEODESIC_OFFSET_NAMED_PARAMETERS_ARE_REGISTERED
#endif

// clang-format off
CGAL_add_named_parameter(geodesic_edge_length_map_t, geodesic_edge_length_map, edge_length_map)

CGAL_add_named_parameter(geodesic_start_value_t, geodesic_start_value, start_value)
CGAL_add_named_parameter(geodesic_start_values_t, geodesic_start_values, start_values)
CGAL_add_named_parameter(geodesic_is_closed_t, geodesic_is_closed, is_closed)

CGAL_add_named_parameter(geodesic_distance_limit_t, geodesic_distance_limit, distance_limit)
CGAL_add_named_parameter(geodesic_keep_windows_t, geodesic_keep_windows, keep_windows)
CGAL_add_named_parameter(geodesic_compute_largest_distance_t, geodesic_compute_largest_distance, compute_largest_distance)
CGAL_add_named_parameter(geodesic_targets_t, geodesic_targets, targets)
CGAL_add_named_parameter(geodesic_relative_tolerance_t, geodesic_relative_tolerance, relative_tolerance)
CGAL_add_named_parameter(geodesic_merging_tolerance_t, geodesic_merging_tolerance, merging_tolerance)

CGAL_add_named_parameter(geodesic_rows_in_order_t, geodesic_rows_in_order, rows_in_order)
CGAL_add_named_parameter(geodesic_upper_half_t, geodesic_upper_half, upper_half)
CGAL_add_named_parameter(geodesic_start_set_t, geodesic_start_set, start_set)
CGAL_add_named_parameter(geodesic_covering_radius_t, geodesic_covering_radius, covering_radius)
CGAL_add_named_parameter(geodesic_vertex_source_t, geodesic_vertex_source, vertex_source_map)

CGAL_add_named_parameter(geodesic_offset_side_t, geodesic_offset_side, offset_side)
CGAL_add_named_parameter(geodesic_end_style_t, geodesic_end_style, end_style)

CGAL_add_named_parameter(geodesic_chord_tolerance_t, geodesic_chord_tolerance, chord_tolerance)
CGAL_add_named_parameter(geodesic_length_unit_t, geodesic_length_unit, length_unit)
CGAL_add_named_parameter(geodesic_point_spacing_t, geodesic_point_spacing, point_spacing)
CGAL_add_named_parameter(geodesic_smooth_normals_t, geodesic_smooth_normals, smooth_normals)
CGAL_add_named_parameter(geodesic_curve_nesting_t, geodesic_curve_nesting, curve_nesting)

CGAL_add_named_parameter(geodesic_face_band_t, geodesic_face_band, face_band_map)
CGAL_add_named_parameter(geodesic_face_source_t, geodesic_face_source, face_source_map)
CGAL_add_named_parameter(geodesic_distance_field_t, geodesic_distance_field, distance_field)
CGAL_add_named_parameter(geodesic_vertex_distance_t, geodesic_vertex_distance, vertex_distance_map)

#if CGAL_VERSION_NR < 1060000000 // CGAL has this parameter since 6.0
CGAL_add_named_parameter(concurrency_tag_t, concurrency_tag, concurrency_tag)
#endif
  // clang-format on
