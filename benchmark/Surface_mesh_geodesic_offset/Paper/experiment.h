// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the programs for the figures of the paper share: arguments, models, tables in Markdown, and pictures.

#ifndef GEODESIC_OFFSET_BENCHMARK_EXPERIMENT_H
#define GEODESIC_OFFSET_BENCHMARK_EXPERIMENT_H

#include "../Performance/initial_distances.h"
#include "../Performance/wavy_torus.h"
#include "common/face_distances.h"
#include "common/picture.h"
#include "indexed_png.h"
#include "locations.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace paper {

using geodesic_offset::Edge;
using geodesic_offset::Face;
using geodesic_offset::Face_location;
using geodesic_offset::Geodesic;
using geodesic_offset::Halfedge;
using geodesic_offset::Image;
using geodesic_offset::Kernel;
using geodesic_offset::Mesh;
using geodesic_offset::Offset_curve;
using geodesic_offset::Point;
using geodesic_offset::Polyline;
using geodesic_offset::Vector;
using geodesic_offset::Vertex;
using geodesic_offset::View;

typedef CGAL::Geodesic_polyline<Face_location> Surface_polyline;
typedef CGAL::Offset_levels<double> Levels;

/// A mesh with its name for tables.
struct Model
{
  std::string name;
  Mesh mesh;

  std::size_t number_of_vertices() const { return mesh.number_of_vertices(); }
  CGAL::Bbox_3 box() const { return CGAL::Polygon_mesh_processing::bbox(mesh); }
  double diagonal() const
  {
    const CGAL::Bbox_3 b = box();
    return std::hypot(b.x_span(), b.y_span(), b.z_span());
  }
};

/// Reads a file, or generates a torus with waves: `torus:2000` has 2000 vertices.
inline Model read_model(const std::string& file)
{
  const std::string torus = "torus:";
  if (file.compare(0, torus.size(), torus) == 0)
    return {"wavy torus", benchmark::Wavy_torus<Mesh>(std::stoul(file.substr(torus.size()))).mesh};
  Model model{std::filesystem::path(file).stem().string(), {}};
  if (!CGAL::IO::read_polygon_mesh(file, model.mesh) || !CGAL::is_triangle_mesh(model.mesh) ||
      model.mesh.number_of_faces() == 0)
    throw std::runtime_error(file + " is not a manifold triangle mesh");
  return model;
}

/// Prints `introduction` and calls `experiment(model, prefix)` for each model of the command line, `PICTURES MODEL...`, where
/// `prefix` begins the names of pictures of the model. Returns the exit code: 1 if a model cannot be read or does not pass.
template <class Experiment>
int run_on_models(int argc, char* argv[], const std::string& name, const char* introduction, const Experiment& experiment)
{
  if (argc < 3)
  {
    std::cerr << "usage: " << name << " FOLDER_FOR_PICTURES MODEL...\n";
    return 2;
  }
  std::cout << introduction;
  int result = 0;
  for (int i = 2; i < argc; ++i) try
    {
      const Model model = read_model(argv[i]);
      std::string file = model.name;
      std::replace(file.begin(), file.end(), ' ', '_');
      experiment(model, std::string(argv[1]) + "/paper_" + name + "_" + file);
    }
    catch (const std::exception& e)
    {
      std::cerr << name << ": " << argv[i] << ": " << e.what() << '\n';
      result = 1;
    }
  return result;
}

/// What an experiment must show.
inline void expect(bool holds, const std::string& otherwise)
{
  if (!holds) throw std::runtime_error(otherwise);
}

/// A row of a table in Markdown.
inline void print_row(const std::vector<std::string>& cells)
{
  for (const std::string& cell : cells) std::cout << "| " << cell << ' ';
  std::cout << "|" << std::endl;
}

inline void print_header(const std::vector<std::string>& cells)
{
  print_row(cells);
  for (std::size_t i = 0; i < cells.size(); ++i) std::cout << "|---";
  std::cout << "|" << std::endl;
}

/// A number with some significant digits.
inline std::string text(double value, int digits = 3)
{
  char buffer[32];
  std::snprintf(buffer, sizeof(buffer), "%.*g", digits, value);
  return buffer;
}

inline std::string text(std::size_t value) { return std::to_string(value); }

/// The plane through the centre of the bounding box across its longest side, tilted so that it is not parallel to an axis.
inline Kernel::Plane_3 middle_plane(const CGAL::Bbox_3& box)
{
  const double size[3] = {box.x_span(), box.y_span(), box.z_span()};
  double normal[3] = {0.07, 0.13, 0.1};
  normal[std::max_element(size, size + 3) - size] = 1;
  return Kernel::Plane_3(Point(box.xmin() + box.x_span() / 2, box.ymin() + box.y_span() / 2, box.zmin() + box.z_span() / 2),
                         Vector(normal[0], normal[1], normal[2]));
}

/// Adds the curves of the section to the sources.
inline std::vector<Surface_polyline> add_section(Geodesic& geodesic, const Kernel::Plane_3& plane)
{
  const std::vector<Surface_polyline> curves = geodesic.mesh().plane_section(plane).polylines;
  if (curves.empty()) throw std::runtime_error("the plane does not cut the mesh");
  for (const Surface_polyline& c : curves) geodesic.add_source_polyline(c);
  return curves;
}

/// The exact distances of all corners of the faces that the curves cross, for methods that begin with such distances.
inline benchmark::Initial_distances<Mesh> distances_at(const Geodesic& geodesic, const Mesh& mesh,
                                                       const std::vector<Surface_polyline>& curves)
{
  const test::Locations<Mesh> on_mesh(mesh);
  std::map<Vertex, double> corners;
  for (const Surface_polyline& s : curves)
    for (std::size_t i = 0; i + (s.is_closed ? 0 : 1) < s.locations.size(); ++i)
      for (Vertex v : on_mesh.corners(on_mesh.common_face(s.locations[i], s.locations[(i + 1) % s.locations.size()])))
        corners[v] = geodesic.distance_to_sources(v);
  return {corners.begin(), corners.end()};
}

/// The curves on one panel of a picture.
struct Drawing
{
  static constexpr double chord_tolerance = 1e-4; // of the size of the mesh: less than a pixel

  std::vector<Polyline> offsets, paths, sources;
  std::vector<Point> points; // sources, too

  /// `size`: that of the mesh.
  void add_offsets(const std::vector<Offset_curve>& curves, double size)
  {
    for (const Offset_curve& c : curves)
    {
      offsets.emplace_back();
      c.points(chord_tolerance * size, std::back_inserter(offsets.back()));
    }
  }
};

inline Point point_on(const Mesh& mesh, const Face_location& l)
{
  const Halfedge h = mesh.halfedge(l.first);
  const Point &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)), &c = mesh.point(mesh.target(mesh.next(h)));
  return CGAL::barycenter(a, l.second[0], b, l.second[1], c, l.second[2]);
}

/// A closed polyline repeats its first point.
inline Polyline points_on(const Mesh& mesh, const Surface_polyline& polyline)
{
  Polyline result;
  for (const Face_location& l : polyline.locations) result.push_back(point_on(mesh, l));
  if (polyline.is_closed) result.push_back(result.front());
  return result;
}

inline std::vector<Polyline> points_on(const Mesh& mesh, const std::vector<Surface_polyline>& polylines)
{
  std::vector<Polyline> result;
  for (const Surface_polyline& p : polylines) result.push_back(points_on(mesh, p));
  return result;
}

/// Draws a part of the mesh, coloured by distances or other values, and curves. `width` is in pixels.
template <class Distances>
Image panel(const Distances& distances, const Mesh& mesh, const View& view, const geodesic_offset::Extent& extent,
            const Drawing& drawing, int width)
{
  geodesic_offset::Picture_size size;
  size.width = width;
  size.minimum_height = 100;
  size.maximum_height = width * 5 / 4;
  size.margin = 6;
  size.has_legend = false;
  geodesic_offset::Picture picture(mesh, distances, view, extent, size);
  for (const Polyline& p : drawing.offsets) picture.add_offset(p);
  for (const Polyline& p : drawing.paths) picture.add_path(p);
  for (const Polyline& p : drawing.sources) picture.add_source(p);
  for (const Point& p : drawing.points) picture.add_source(p);
  return picture.render([](double) {});
}

/// Colours by the distances of the last build.
inline Image panel(const Geodesic& geodesic, const Mesh& mesh, const View& view, const geodesic_offset::Extent& extent,
                   const Drawing& drawing, int width)
{
  geodesic_offset::Face_distances distances(mesh, geodesic, geodesic.field().largest_vertex_distance().value());
  distances.interpolate_everywhere();
  return panel(distances, mesh, view, extent, drawing, width);
}

/// Panels of one height side by side, with white stripes between them.
inline Image joined_panels(std::vector<Image> panels)
{
  constexpr int stripe = 6;
  for (Image& p : panels)
    for (int row = 0; &p != &panels.back() && row < p.height; ++row)
      std::fill_n(p.bytes.begin() + 3 * ((row + 1) * p.width - stripe), 3 * stripe, std::uint8_t(255));
  Image all;
  all.height = panels.front().height;
  for (const Image& p : panels)
  {
    all.width += p.width;
    all.height = (std::min)(all.height, p.height);
  }
  for (int row = 0; row < all.height; ++row)
    for (const Image& p : panels)
    {
      const auto begin = p.bytes.begin() + 3 * row * p.width;
      all.bytes.insert(all.bytes.end(), begin, begin + 3 * p.width);
    }
  return all;
}

/// The reference to a picture in the folder `fig` beside the page.
inline void print_picture(const std::string& file, const std::string& caption)
{
  std::cout << "\n![" << caption << "](fig/" << std::filesystem::path(file).filename().string() << ")\n\n";
}

} // namespace paper

#endif // GEODESIC_OFFSET_BENCHMARK_EXPERIMENT_H
