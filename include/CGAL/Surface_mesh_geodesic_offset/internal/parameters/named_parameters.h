// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PARAMETERS_NAMED_PARAMETERS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PARAMETERS_NAMED_PARAMETERS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Named_function_parameters.h>

#ifndef CGAL_GEODESIC_OFFSET_NAMED_PARAMETERS_ARE_REGISTERED
#error "The include path must have the folder of Surface_mesh_geodesic_offset before that of CGAL."
#endif

#include <CGAL/NT_converter.h>

#include <type_traits>

namespace CGAL::Geodesic_offset::internal {

// List of the tags of named parameters.
template <class... Tags>
struct Parameter_tags
{
  template <class... More>
  static Parameter_tags<Tags..., More...> joined_with(Parameter_tags<More...>);

  template <class Tag>
  static constexpr bool contains = std::is_same<Tag, internal_np::all_default_t>::value ||
                                   (std::is_same<Tag, Tags>::value || ...);
};

template <class First, class Second>
using Joined_tags = decltype(First::joined_with(Second()));

typedef Parameter_tags<internal_np::vertex_point_t, internal_np::geom_traits_t, internal_np::vertex_index_t,
                       internal_np::face_index_t, internal_np::concurrency_tag_t, internal_np::edge_is_constrained_t>
  Mesh_with_points_parameters;
typedef Joined_tags<Mesh_with_points_parameters, Parameter_tags<internal_np::geodesic_edge_length_map_t>> Mesh_parameters;
typedef Parameter_tags<internal_np::point_t, internal_np::geom_traits_t> Polygon_soup_parameters;
typedef Parameter_tags<internal_np::snapping_tolerance_t> Location_parameters;
typedef Parameter_tags<internal_np::geodesic_is_closed_t, internal_np::geodesic_start_values_t> Joining_parameters;
typedef Parameter_tags<internal_np::geodesic_start_value_t> Source_parameters;
typedef Joined_tags<Source_parameters, Joining_parameters> Polyline_source_parameters;
typedef Parameter_tags<internal_np::visitor_t, internal_np::verbose_t, internal_np::concurrency_tag_t> Update_parameters;
typedef Joined_tags<Update_parameters,
                    Parameter_tags<internal_np::geodesic_distance_limit_t, internal_np::geodesic_keep_windows_t,
                                   internal_np::geodesic_compute_largest_distance_t, internal_np::geodesic_targets_t,
                                   internal_np::geodesic_relative_tolerance_t, internal_np::geodesic_merging_tolerance_t>>
  Build_parameters;
typedef Parameter_tags<internal_np::geodesic_offset_side_t, internal_np::geodesic_end_style_t> Selection_parameters;
typedef Joined_tags<Selection_parameters, Parameter_tags<internal_np::concurrency_tag_t>> Offset_parameters;
typedef Joined_tags<Selection_parameters, Build_parameters> Build_and_offset_parameters;
typedef Joined_tags<Joined_tags<Mesh_parameters, Update_parameters>, Parameter_tags<internal_np::geodesic_distance_limit_t>>
  Path_call_parameters;
typedef Joined_tags<Mesh_parameters, Update_parameters> Voronoi_call_parameters;
typedef Joined_tags<Path_call_parameters,
                    Parameter_tags<internal_np::geodesic_relative_tolerance_t, internal_np::geodesic_merging_tolerance_t>>
  Approximate_call_parameters;
typedef Joined_tags<Selection_parameters, Approximate_call_parameters> Offset_call_parameters;
typedef Joined_tags<Approximate_call_parameters, Parameter_tags<internal_np::geodesic_targets_t>> Distance_call_parameters;
// With a Geodesic_mesh, the parameters of the mesh are not read.
template <bool is_set_up, class... Tags>
using Call_parameters = Joined_tags<std::conditional_t<is_set_up, Parameter_tags<>, Mesh_parameters>, Parameter_tags<Tags...>>;
template <bool is_set_up>
using Pair_call_parameters = Call_parameters<is_set_up, internal_np::geodesic_distance_limit_t>;
template <bool is_set_up>
using Matrix_call_parameters =
  Call_parameters<is_set_up, internal_np::geodesic_distance_limit_t, internal_np::geodesic_rows_in_order_t,
                  internal_np::geodesic_upper_half_t, internal_np::visitor_t, internal_np::concurrency_tag_t>;
template <bool is_set_up>
using Farthest_call_parameters =
  Call_parameters<is_set_up, internal_np::geodesic_start_set_t, internal_np::geodesic_covering_radius_t, internal_np::visitor_t,
                  internal_np::geodesic_vertex_distance_t, internal_np::geodesic_vertex_source_t>;
typedef Parameter_tags<internal_np::geodesic_chord_tolerance_t> Chord_parameters;
typedef Parameter_tags<internal_np::geodesic_length_unit_t> Unit_parameters;
typedef Joined_tags<Chord_parameters, Unit_parameters> Drawing_parameters;
typedef Joined_tags<Chord_parameters, Parameter_tags<internal_np::geodesic_point_spacing_t>> Line_parameters;
typedef Joined_tags<Line_parameters, Parameter_tags<internal_np::geodesic_smooth_normals_t>> Point_parameters;
typedef Joined_tags<Point_parameters, Parameter_tags<internal_np::geodesic_curve_nesting_t>> Table_parameters;
typedef Joined_tags<Table_parameters, Unit_parameters> Writing_parameters;
typedef Parameter_tags<internal_np::geodesic_chord_tolerance_t, internal_np::edge_is_constrained_t, internal_np::vertex_point_t,
                       internal_np::visitor_t, internal_np::geodesic_face_band_t, internal_np::geodesic_face_source_t,
                       internal_np::geodesic_distance_field_t, internal_np::geodesic_vertex_distance_t>
  Splitting_parameters;
typedef Parameter_tags<internal_np::geodesic_chord_tolerance_t, internal_np::edge_is_constrained_t, internal_np::vertex_point_t,
                       internal_np::visitor_t, internal_np::geodesic_face_source_t>
  Voronoi_splitting_parameters;
typedef Parameter_tags<internal_np::edge_is_constrained_t, internal_np::output_iterator_t, internal_np::vertex_point_t,
                       internal_np::visitor_t>
  Polyline_splitting_parameters;

// True if all parameters of a sequence are in a list of tags; false for a type that is no sequence of parameters.
template <class>
constexpr bool are_read(const void*)
{
  return false;
}
template <class Tags, class T, class Tag>
constexpr bool are_read(const Named_function_parameters<T, Tag>*)
{
  return Tags::template contains<Tag>;
}
template <class Tags, class T, class Tag, class Base>
constexpr bool are_read(const Named_function_parameters<T, Tag, Base>*)
{
  return Tags::template contains<Tag> && are_read<Tags>(static_cast<const Base*>(nullptr));
}

// Stops the compilation if a function does not read a parameter that it is given.
template <class Tags, class NamedParameters>
constexpr void check_named_parameters()
{
  static_assert(are_read<Tags>(static_cast<const NamedParameters*>(nullptr)),
                "Surface_mesh_geodesic_offset: this function does not read one of the named parameters that it is given, or the "
                "argument is not a sequence of named parameters");
}

// The type of the value of a parameter; D if the parameter is missing.
template <class Tag, class NamedParameters, class D>
using Parameter_type = typename internal_np::Lookup_named_param_def<Tag, NamedParameters, D>::type;

template <class Tag, class NamedParameters>
constexpr bool has_parameter = !parameters::is_default_parameter<NamedParameters, Tag>::value;

// The start value of a source. Tags: the parameters that the caller reads.
template <class FT, class Tags = Source_parameters, class NamedParameters>
FT start_value_of(const NamedParameters& np)
{
  check_named_parameters<Tags, NamedParameters>();
  const auto value = parameters::choose_parameter(parameters::get_parameter(np, internal_np::geodesic_start_value), FT(0));
  return NT_converter<std::decay_t<decltype(value)>, FT>()(value);
}

// The start values of the points of a polyline; empty without the parameter.
// \throws std::invalid_argument if there are not as many as points
template <class FT, class NamedParameters>
std::vector<FT> start_values_of([[maybe_unused]] const NamedParameters& np, [[maybe_unused]] std::size_t number_of_points)
{
  std::vector<FT> values;
  if constexpr (has_parameter<internal_np::geodesic_start_values_t, NamedParameters>)
  {
    const auto& given = parameters::get_parameter(np, internal_np::geodesic_start_values);
    for (const auto& s : internal_np::get_reference(given)) values.push_back(NT_converter<std::decay_t<decltype(s)>, FT>()(s));
    if (values.size() != number_of_points)
      throw std::invalid_argument("Surface_mesh_geodesic_offset: a polyline has not as many start values as points");
  }
  return values;
}

// Drops the start value of a last point that repeats the first one, if there is one more than points.
// \throws std::invalid_argument if it differs from the first one
template <class FT>
void drop_repeated_start_value(std::vector<FT>& values, std::size_t number_of_points)
{
  if (values.size() != number_of_points + 1) return;
  if (values.back() != values.front())
    throw std::invalid_argument("Surface_mesh_geodesic_offset: the ends of a closed polyline have different start values");
  values.pop_back();
}

// True if the last point of a polyline is joined to the first one. `otherwise`: without the parameter.
template <class NamedParameters>
bool is_closed_of(const NamedParameters& np, bool otherwise)
{
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::geodesic_is_closed), otherwise);
}

// The concurrency tag of a sequence of parameters.
template <class NamedParameters>
using Concurrency_tag_of = Parameter_type<internal_np::concurrency_tag_t, NamedParameters, Sequential_tag>;

} // namespace CGAL::Geodesic_offset::internal

#endif
