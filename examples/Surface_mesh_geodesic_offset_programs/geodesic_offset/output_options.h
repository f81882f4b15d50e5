// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Options for the output files and their appearance.

#ifndef GEODESIC_OFFSET_OUTPUT_OPTIONS_H
#define GEODESIC_OFFSET_OUTPUT_OPTIONS_H

#include "common/command_line.h"
#include "common/common.h"
#include "common/picture.h"
#include "curve_order.h"

#include <CGAL/Surface_mesh_geodesic_offset/IO/write_offset_curves.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace geodesic_offset {

struct Output_options
{
  std::vector<std::string> outputs; // offsets
  std::vector<std::string> fields;
  bool field_details = false; // sources, sides and gradients in the field
  std::string split; // the mesh split along the offsets
  std::string bands; // the parts of this mesh: the prefix of their files
  bool has_bands_by_source = false;
  std::vector<std::string> voronoi; // curves between cells, or the mesh split along them
  std::string source_output; // polylines, sections and edges as they are on the surface
  std::string picture;
  std::string stats;
  std::optional<double> tolerance;
  std::optional<double> point_spacing; // instead of the tolerance
  bool smooth_normals = false;
  Curve_order order = Curve_order::as_cut;
  CGAL::IO::Length_unit unit = CGAL::IO::Length_unit::NONE;
  Picture_details picture_details;
  std::optional<std::array<double, 3>> view;
  std::optional<std::array<double, 3>> up;

  std::vector<std::string> files_written() const
  {
    std::vector<std::string> result = outputs;
    for(const std::vector<std::string>* files : {&fields, &voronoi}) result.insert(result.end(), files->begin(), files->end());
    for(const std::string& file : {split, source_output, picture, stats})
      if(!file.empty()) result.push_back(file);
    if(!bands.empty()) result.push_back(file_of_band("0")); // the others are not known yet
    return result;
  }

  std::string file_of_band(const std::string& name) const { return bands + name + ".ply"; }

  // Whether the mesh is split along the offsets.
  bool has_split_mesh() const { return !split.empty() || !bands.empty(); }

  // Whether an output contains the offsets.
  bool shows_offsets() const { return !outputs.empty() || has_split_mesh() || !picture.empty() || !stats.empty(); }

  // Whether an output contains the distances of the whole surface.
  bool shows_field() const { return !fields.empty() || has_split_mesh() || !voronoi.empty() || !picture.empty(); }
};

// Calls f with the named parameters for the points of files.
template <class Function>
auto with_point_parameters(const Output_options& options, double tolerance, const Function& f)
{
  const auto parameters = CGAL::parameters::chord_tolerance(tolerance).smooth_normals(options.smooth_normals);
  return options.point_spacing ? f(parameters.point_spacing(*options.point_spacing)) : f(parameters);
}

namespace internal {

inline po::options_description output_options_description()
{
  const auto words = [](const char* name) { return po::value<Words>()->value_name(name); };
  const auto word = [](const char* name) { return po::value<std::string>()->value_name(name); };
  po::options_description outputs("Outputs");
  outputs.add_options()("output", words("FILE"),
                        "offsets as .polylines.txt, .vtk, .vtp, .obj, .csv, .dxf or, if they lie in one "
                        "plane, .svg (repeatable)")(
    "tolerance", word("T"), "chord tolerance of the written polylines (default: 1e-4 of the bounding-box diagonal)")(
    "point-spacing", word("S"),
    "points of .polylines.txt, .vtk, .vtp, .obj and .csv evenly along the curves, at most S apart, instead of --tolerance")(
    "smooth-normals", po::bool_switch(), "in .vtk, .vtp and .csv: normals interpolated between vertices, not those of faces")(
    "order", word("ORDER"),
    "order of the offsets in files: distance, or nesting, from outer to inner ones; closed offsets then start near the start of the "
    "one around them, and .vtk, .vtp, .csv and --stats have parents and inner sides")(
    "unit", word("UNIT"), "unit of the mesh, for .dxf and .svg: mm, cm, m or in (default: none)")(
    "field", words("FILE"),
    "the input's vertices with their distances, signed ones too if there are polylines, as .ply or "
    ".vtk with its faces, or as .csv (repeatable)")("field-details", po::bool_switch(),
                                                    "with --field: nearest source, its side, and gradient, too")(
    "split", word("FILE.ply"),
    "the mesh split along the offsets, its faces with their band between the distances, the source "
    "nearest to their centroid, and the colour of the band")(
    "bands", word("PREFIX"), "the faces of this mesh in one file per band, PREFIX0.ply, PREFIX1.ply, ...")(
    "bands-by", word("KIND"), "with --bands: a file per band (default) or per source")(
    "voronoi", words("FILE"),
    "the curves between the cells of the sources as .polylines.txt or .vtk; or, as .ply, the mesh "
    "split along them, its faces with their source and its colour (repeatable)")(
    "source-output", word("FILE.polylines.txt"), "polylines, sections and edges of the sources as they are on the surface")(
    "picture", word("FILE.png"), "the mesh coloured by distance, with sources and offsets drawn on it")(
    "picture-with", words("ITEM,..."),
    "also in the picture: voronoi (the curves between the cells of the sources), labels (the distances of the offsets), axes, box "
    "(the bounding box of the mesh) (repeatable)")("view", word("X,Y,Z"),
                                                   "direction from the mesh to the viewer of the picture")(
    "up", word("X,Y,Z"), "direction that points up in the picture (default: 0,1,0)")("stats", word("FILE.json"),
                                                                                     "sizes, times, windows, memory, curves");
  return outputs;
}

inline CGAL::IO::Length_unit length_unit(const std::string& word)
{
  using CGAL::IO::Length_unit;
  if(word == "mm") return Length_unit::MILLIMETER;
  if(word == "cm") return Length_unit::CENTIMETER;
  if(word == "m") return Length_unit::METER;
  if(word == "in") return Length_unit::INCH;
  throw Usage_error("--unit must be mm, cm, m or in, not " + quoted(word));
}

inline Curve_order curve_order(const std::string& word)
{
  if(word == "distance") return Curve_order::by_distance;
  if(word == "nesting") return Curve_order::by_nesting;
  throw Usage_error("--order must be distance or nesting, not " + quoted(word));
}

inline Picture_details picture_details(const std::vector<std::string>& lists)
{
  Picture_details details;
  for(const std::string& list : lists)
    for(std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1)
    {
      end = list.find(',', begin);
      const std::string item = list.substr(begin, end - begin);
      bool* const detail =
        item == "voronoi"  ? &details.boundaries
        : item == "labels" ? &details.labels
        : item == "axes"   ? &details.axes
        : item == "box"    ? &details.box
                           : nullptr;
      if(!detail) throw Usage_error("--picture-with must be of voronoi, labels, axes and box, not " + quoted(item));
      *detail = true;
    }
  return details;
}

inline void check_offset_format(const std::string& file)
{
  try
  {
    CGAL::IO::offset_file_format(file);
  }
  catch(const std::invalid_argument&)
  {
    throw Usage_error("--output " + quoted(file) + " must end in .polylines.txt, .vtk, .vtp, .obj, .csv, .dxf or .svg");
  }
}

inline void check_extension(const char* option, const std::string& file, const char* extension)
{
  if(!file.empty() && !has_extension(file, extension))
    throw Usage_error("--" + std::string(option) + ' ' + quoted(file) + " must end in " + extension);
}

inline void check_outputs(const po::variables_map& map, const Output_options& options)
{
  for(const std::string& output : options.outputs) check_offset_format(output);
  for(const std::string& file : options.fields)
    if(!has_extension(file, ".ply") && !has_extension(file, ".vtk") && !has_extension(file, ".csv"))
      throw Usage_error("--field " + quoted(file) + " must end in .ply, .vtk or .csv");
  if(options.field_details && options.fields.empty()) throw Usage_error("--field-details needs --field");
  check_extension("split", options.split, ".ply");
  for(const std::string& file : options.voronoi)
    if(!has_extension(file, ".polylines.txt") && !has_extension(file, ".vtk") && !has_extension(file, ".ply"))
      throw Usage_error("--voronoi " + quoted(file) + " must end in .polylines.txt, .vtk or .ply");
  if(!options.voronoi.empty() && map.count("maximum-distance"))
    throw Usage_error("--voronoi needs all distances, without --maximum-distance");
  if(options.picture_details.boundaries && map.count("maximum-distance"))
    throw Usage_error("--picture-with voronoi needs all distances, without --maximum-distance");
  if(options.picture_details.labels && map.count("distance") == 0 && map.count("spacing") == 0)
    throw Usage_error("--picture-with labels needs --distance or --spacing");
  check_extension("source-output", options.source_output, ".polylines.txt");
  check_extension("picture", options.picture, ".png");
  check_extension("stats", options.stats, ".json");

  if(map.count("bands-by"))
  {
    const std::string& kind = map["bands-by"].as<std::string>();
    if(options.bands.empty()) throw Usage_error("--bands-by needs --bands");
    if(kind != "band" && kind != "source") throw Usage_error("--bands-by must be band or source, not " + quoted(kind));
  }
  for(const char* option : {"output", "split", "bands", "order"})
    if(map.count(option) && map.count("distance") == 0 && map.count("spacing") == 0)
      throw Usage_error("--" + std::string(option) + " needs --distance or --spacing");
  for(const char* option : {"picture-with", "view", "up"})
    if(map.count(option) && options.picture.empty()) throw Usage_error("--" + std::string(option) + " needs --picture");
  const auto has_output = [&](const std::vector<const char*>& extensions) {
    for(const std::string& output : options.outputs)
      for(const char* extension : extensions)
        if(has_extension(output, extension)) return true;
    return false;
  };
  if(map.count("order") && options.outputs.empty() && options.stats.empty())
    throw Usage_error("--order needs --output or --stats");
  if(map.count("unit") && !has_output({".dxf", ".svg"}))
    throw Usage_error("--unit needs an --output that ends in .dxf or .svg: other formats have no unit");
  if(options.point_spacing && !has_output({".polylines.txt", ".vtk", ".vtp", ".obj", ".csv"}))
    throw Usage_error("--point-spacing needs an --output that ends in .polylines.txt, .vtk, .vtp, .obj or .csv");
  if(options.smooth_normals && !has_output({".vtk", ".vtp", ".csv"}))
    throw Usage_error("--smooth-normals needs an --output that ends in .vtk, .vtp or .csv: other formats have no normals");
}

inline void read_output_options(const po::variables_map& map, Output_options& options)
{
  options.outputs = option_words(map, "output");
  options.fields = option_words(map, "field");
  options.field_details = map["field-details"].as<bool>();
  options.split = option_word(map, "split");
  options.bands = option_word(map, "bands");
  options.has_bands_by_source = option_word(map, "bands-by") == "source";
  options.voronoi = option_words(map, "voronoi");
  options.source_output = option_word(map, "source-output");
  options.picture = option_word(map, "picture");
  options.picture_details = picture_details(option_words(map, "picture-with"));
  options.stats = option_word(map, "stats");
  options.tolerance = optional_positive_number(map, "tolerance");
  options.point_spacing = optional_positive_number(map, "point-spacing");
  options.smooth_normals = map["smooth-normals"].as<bool>();
  if(map.count("order")) options.order = curve_order(map["order"].as<std::string>());
  if(map.count("unit")) options.unit = length_unit(map["unit"].as<std::string>());
  options.view = direction(map, "view");
  options.up = direction(map, "up");
  check_outputs(map, options);
}

} // namespace internal
} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_OUTPUT_OPTIONS_H
