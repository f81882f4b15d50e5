// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fig. 11 of the paper: families of offsets with two spacings.
//
//   figure_11_spacings FOLDER_FOR_PICTURES MODEL...
//
// The models are scaled so that the longest side of the bounding box is 1, and the spacings are those of the paper.

#include "experiment.h"

#include <map>

namespace {

using namespace paper;

constexpr double spacings[] = {0.06, 0.025};
constexpr int levels_per_common_level[] = {5, 12}; // 0.3 is the least distance of both families

// Largest relative difference of the lengths at a common distance, which is rounded in two ways, to 1e-16.
constexpr double difference_of_lengths = 1e-9;

struct Level
{
  std::size_t curves = 0;
  double length = 0;
};

typedef std::map<long, Level> Family; // by the number of the distance

void run(Model model, const std::string& picture)
{
  const CGAL::Bbox_3 box = model.box();
  const double scale = 1 / (std::max)({box.x_span(), box.y_span(), box.z_span()});
  for (Vertex v : model.mesh.vertices()) model.mesh.point(v) = CGAL::ORIGIN + scale * (model.mesh.point(v) - CGAL::ORIGIN);

  Geodesic geodesic(model.mesh);
  const auto sections = add_section(geodesic, middle_plane(model.box()));
  std::vector<Family> families;
  std::vector<Image> panels;
  for (double spacing : spacings)
  {
    std::vector<Offset_curve> curves;
    geodesic.build_with_offset_curves(Levels::equally_spaced(spacing), std::back_inserter(curves));
    Family family;
    Level all;
    for (const Offset_curve& c : curves)
      for (Level* level : {&family[std::lround(c.distance() / spacing)], &all})
      {
        ++level->curves;
        level->length += c.length();
      }
    print_row({model.name, text(model.number_of_vertices()), text(spacing), text(family.size()), text(all.curves),
               text(all.length, 6), text(geodesic.field().largest_vertex_distance().value(), 4)});
    families.push_back(family);

    Drawing drawing;
    drawing.add_offsets(curves, 1);
    drawing.sources = points_on(model.mesh, sections);
    std::vector<Point> points;
    for (const Polyline& p : drawing.sources) points.insert(points.end(), p.begin(), p.end());
    const View view = geodesic_offset::choose_view(model.mesh, points, Vector(0, 1, 0));
    panels.push_back(panel(geodesic, model.mesh, view, geodesic_offset::Extent(model.mesh, view), drawing, 480));
  }
  write_indexed_png(picture, joined_panels(panels));

  for (long i = 1;; ++i)
  {
    const auto a = families[0].find(i * levels_per_common_level[0]), b = families[1].find(i * levels_per_common_level[1]);
    if (a == families[0].end() || b == families[1].end()) break;
    expect(a->second.curves == b->second.curves &&
             std::abs(a->second.length - b->second.length) <= difference_of_lengths * a->second.length,
           "the offsets of the two families at " + text(0.3 * static_cast<double>(i)) + " differ");
  }
}

} // namespace

int main(int argc, char* argv[])
{
  std::vector<std::string> pictures;
  const int result =
    paper::run_on_models(argc, argv, "figure_11_spacings",
                         R"(
## Fig. 11: Spacings

*The paper* shows "Lucy" (263K vertices, not at hand), scaled to the unit cube, with offsets of a curve around the waist at spacings
of 0.06 and 0.025. It has no other numbers.

*Here*, the same spacings on models whose longest side is 1, from the section by a plane across this side. At 0.3, 0.6, ..., the
distances of both families, the numbers of curves are equal, and the lengths up to a relative 1e-9.

| model | vertices | spacing | distances | curves | length | largest distance of a vertex |
|---|---|---|---|---|---|---|
)",
                         [&](const paper::Model& model, const std::string& prefix) {
                           pictures.push_back(prefix + ".png");
                           run(model, pictures.back());
                         });
  for (const std::string& p : pictures) paper::print_picture(p, "Offsets at spacings of 0.06 and 0.025");
  return result;
}
