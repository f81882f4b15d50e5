// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fig. 12 of the paper: segmentation of a face by offsets of feature curves.
//
//   figure_12_segmentation FOLDER_FOR_PICTURES MODEL FEATURES
//
// Each line of the file with features is a polyline: the number of points, and their coordinates. The points are moved to the
// surface and joined by shortest paths; a polyline is closed if it repeats its first point. The model is split along the offsets
// at two distances: the segments are the parts within the first distance of a feature, those between the distances, and the rest.

#include "experiment.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_offset_curves.h>

#include <fstream>
#include <sstream>

namespace {

using namespace paper;
namespace PMP = CGAL::Polygon_mesh_processing;

constexpr double first_distance = 0.02; // of the diagonal; the second one is twice as large

// Largest distance of a new vertex from its level, in diagonals: points closer than 2^-33 are one point after the split.
constexpr double error_of_vertices = 1e-9;

// Largest relative difference of the sum of the segments from the area of the model: the sum has thousands of rounded terms.
constexpr double error_of_areas = 1e-10;

std::vector<Polyline> read_features(const std::string& file)
{
  std::vector<Polyline> result;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
  {
    std::istringstream words(line);
    std::size_t n = 0;
    words >> n;
    Polyline points;
    for (double x, y, z; points.size() < n && words >> x >> y >> z;) points.emplace_back(x, y, z);
    if (points.size() != n || n < 2) throw std::runtime_error(file + ": a line is not a polyline");
    result.push_back(points);
  }
  if (result.empty()) throw std::runtime_error(file + " has no polylines");
  return result;
}

// One colour per segment, for `Picture`.
struct Segment_colours
{
  std::vector<double> value; // by face

  double operator()(Face f, double, double) const { return value[f]; }
  double largest() const { return 1; }
};

void run(const Model& model, const std::vector<Polyline>& features, const std::string& picture)
{
  Geodesic geodesic(model.mesh);
  std::vector<Surface_polyline> curves;
  for (Polyline points : features)
  {
    const bool is_closed = points.front() == points.back();
    if (is_closed) points.pop_back();
    curves.push_back(geodesic.mesh().locate_polyline(points, CGAL::parameters::is_closed(is_closed)));
    geodesic.add_source_polyline(curves.back());
  }
  const double d = first_distance * model.diagonal();
  std::vector<Offset_curve> offsets;
  geodesic.build_with_offset_curves(Levels::equally_spaced(d, 2), std::back_inserter(offsets),
                                    CGAL::parameters::keep_windows(true));

  Mesh split = model.mesh;
  const auto is_on_offset = split.add_property_map<Edge, bool>("e:is_on_offset", false).first;
  const auto band = split.add_property_map<Face, std::size_t>("f:band", 0).first;
  const auto source = split.add_property_map<Face, std::size_t>("f:source", 0).first;
  CGAL::split_along_offset_curves(split, offsets,
                                  CGAL::parameters::edge_is_constrained_map(is_on_offset)
                                    .face_band_map(band)
                                    .face_source_map(source)
                                    .distance_field(geodesic.field()));
  const auto segment = split.add_property_map<Face, std::size_t>("f:segment", 0).first;
  const std::size_t number_of_segments =
    PMP::connected_components(split, segment, CGAL::parameters::edge_is_constrained_map(is_on_offset));

  std::vector<std::array<double, 2>> areas(features.size(), {0, 0});
  double rest = 0;
  Segment_colours colours{std::vector<double>(split.number_of_faces())};
  const double steps = static_cast<double>(features.size());
  for (Face f : split.faces())
  {
    (band[f] < 2 ? areas[source[f]][band[f]] : rest) += PMP::face_area(f, split);
    colours.value[f] = band[f] < 2 ? (static_cast<double>(source[f]) + (band[f] == 0 ? 0.55 : 0.85)) / steps : 0;
  }
  const double area = PMP::area(model.mesh);
  double sum = rest;
  for (std::size_t i = 0; i < features.size(); ++i)
  {
    print_row({text(i + 1), text(areas[i][0] / area, 4), text(areas[i][1] / area, 4)});
    sum += areas[i][0] + areas[i][1];
  }
  double error = 0;
  for (Edge e : split.edges())
    if (is_on_offset[e])
      for (int end : {0, 1})
      {
        const Face_location l = geodesic.mesh().locate(split.point(split.vertex(e, end)));
        const double distance = geodesic.distance_to_sources(l);
        error = (std::max)(error, (std::min)(std::abs(distance - d), std::abs(distance - 2 * d)));
      }
  error /= model.diagonal();
  std::cout << "\n"
            << model.name << ", " << model.number_of_vertices() << " vertices, is divided into " << number_of_segments
            << " segments with " << split.number_of_vertices()
            << " vertices. The areas add up to that of the model up to a relative " << text(std::abs(sum / area - 1), 2)
            << ", and the vertices on the offsets are off their level by at most " << text(error, 2) << " diagonals.\n";

  Drawing drawing;
  drawing.add_offsets(offsets, model.diagonal());
  drawing.sources = points_on(model.mesh, curves);
  std::vector<Point> visible;
  for (const Polyline& p : drawing.sources) visible.insert(visible.end(), p.begin(), p.end());
  const View view = geodesic_offset::choose_view(model.mesh, visible, Vector(0, 1, 0));
  const geodesic_offset::Extent extent(model.mesh, view);
  write_indexed_png(picture, joined_panels({panel(geodesic, model.mesh, view, extent, drawing, 400),
                                            panel(colours, split, view, extent, drawing, 400)}));
  print_picture(picture, "Offsets of features of a face, and the segments");
  expect(std::abs(sum / area - 1) <= error_of_areas, "areas of segments are wrong");
  expect(error <= error_of_vertices, "vertices are off their level");
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 4)
  {
    std::cerr << "usage: figure_12_segmentation FOLDER_FOR_PICTURES MODEL FEATURES\n";
    return 2;
  }
  std::cout << R"(
## Fig. 12: Segmentation of a Face

*The paper* takes eyes, forehead, nose and mouth of a scanned face, and shortest paths between their points, as generators. The
offsets lead "to a good segmentation"; there are no numbers.

*Here*, on a face with holes at the eyes: curves around both eyes, along the nose, the mouth and the forehead, each given by two to
four points that shortest paths join. The mesh is split along the offsets at 2 % and 4 % of the diagonal of the bounding box. The
table has the area nearest to each feature, as a part of the surface.

| feature | area within the first offset | between the offsets |
|---|---|---|
)";
  try
  {
    run(paper::read_model(argv[2]), read_features(argv[3]), std::string(argv[1]) + "/paper_figure_12_segmentation.png");
  }
  catch (const std::exception& e)
  {
    std::cerr << "figure_12_segmentation: " << e.what() << '\n';
    return 1;
  }
  return 0;
}
