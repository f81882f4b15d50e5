// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// libFuzzer test of Voronoi diagrams, and of meshes split along them or along offsets, on small meshes, from sources of all
// kinds with start values: points of curves, and of faces of the split meshes, against the distances from each source alone.
// Faces flatter than 2^-10 are skipped.

#include "../offset_tools.h"
#include "fuzz_sources.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_geodesic_voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_offset_curves.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <map>
#include <string>
#include <vector>

namespace {

using test::Geodesic;
using test::Surface_mesh;

typedef Geodesic::Field Field;
typedef Geodesic::Face_location Location;
typedef Surface_mesh::Face_index Face_index;

// The face of the original mesh, of each face of a split mesh that is a part of one
struct Parents : CGAL::Default_offset_splitting_visitor<Surface_mesh>
{
  std::map<Face_index, Face_index>* of;
  Face_index current;

  explicit Parents(std::map<Face_index, Face_index>& map) : of(&map) {}
  void before_subface_creations(Face_index f, Surface_mesh&) { (*of)[current = f] = f; }
  void after_subface_created(Face_index f, Surface_mesh&) { (*of)[f] = current; }
};

class Diagrams
{
public:
  Diagrams(test::Fuzz_bytes& bytes, const test::Fuzz_case& fuzz_case)
    : bytes_(bytes), size_(fuzz_case.size()), data_(test::soup_of(fuzz_case.certified_case())), geodesic_(data_.mesh)
  {
    const test::Certified_case& c = fuzz_case.certified_case();
    const auto location = [&](const test::Certified_case::Location& l) {
      return test::Locations<Surface_mesh>(data_.mesh).in_triangle(data_, test::soup_of(c), l.triangle, l.weights);
    };
    const auto start = [&] { return CGAL::parameters::start_value(start_value()); };
    for (std::size_t v : c.source_vertices) geodesic_.add_source_point(data_.vertices[v], start());
    for (const auto& s : c.sources) geodesic_.add_source_point(location(s), start());
    for (std::size_t n = bytes_.index(3); n > 0; --n) test::Fuzz_curves(bytes_, data_).add_to(geodesic_, start_value());
    field_ = geodesic_.build(CGAL::parameters::keep_windows(true));
    for (const auto& source : geodesic_.sources().sources()) alone(source.first);
  }

  void compare()
  {
    const Field::Voronoi_diagram diagram = field_.voronoi_diagram();
    // documented: some curves of a cell that does not fit together may be wrong
    if (diagram.number_of_forced_cells() == 0)
      for (const auto& c : diagram.curves())
        for (const auto& p : c.pieces())
          for (const double t : {0., 0.3, 0.5, 1.}) check_curve(p.location(t), c.source_on_left(), c.source_on_right());

    const double chord_tolerance = size_ * std::pow(10, -2. - double(bytes_.index(5)));
    split_along(diagram, chord_tolerance);
    split_along_offsets(chord_tolerance);
  }

private:
  // Of distances on curves; also of cells that the manual leaves open, narrower than that
  double tie() const { return 1e-6 * size_; }

  double start_value()
  {
    switch (bytes_.index(4))
    {
    case 0: return size_ * bytes_.weight();
    case 1: return size_ * double(bytes_.index(9)) / 8;
    default: return 0;
    }
  }

  void alone(std::size_t id)
  {
    Geodesic geodesic(geodesic_);
    for (const auto& other : geodesic_.sources().sources())
      if (other.first != id) geodesic.remove_source(other.first);
    alone_[id] = geodesic.build(CGAL::parameters::keep_windows(true));
  }

  void check_curve(const Location& l, std::size_t left, std::size_t right) const
  {
    const double least = field_.distance_to_sources(l);
    for (const std::size_t s : {left, right})
      if (!(std::abs(alone_.at(s).distance_to_sources(l) - least) <= tie()))
        test::fail_fuzzing("a curve between " + std::to_string(left) + " and " + std::to_string(right) +
                           " is not equally far from both");
  }

  void split_along(const Field::Voronoi_diagram& diagram, double chord_tolerance)
  {
    Surface_mesh split = data_.mesh;
    auto source = split.add_property_map<Face_index, std::size_t>("f:source", Field::no_source()).first;
    std::map<Face_index, Face_index> parents;
    CGAL::split_along_geodesic_voronoi_diagram(
      split, diagram, CGAL::parameters::face_source_map(source).chord_tolerance(chord_tolerance).visitor(Parents(parents)));
    check_mesh(split);
    const double allowed = 4 * chord_tolerance + tie();
    for_each_point(split, parents, [&](Face_index f, const Location& l) {
      const double least = field_.distance_to_sources(l);
      if (!std::isfinite(least)
            ? source[f] != Field::no_source()
            : alone_.count(source[f]) == 0 || !(alone_.at(source[f]).distance_to_sources(l) <= least + allowed))
        test::fail_fuzzing("a point of a split mesh is nearer to another source than " + std::to_string(source[f]));
    });
  }

  void split_along_offsets(double chord_tolerance)
  {
    const double largest = geodesic_.largest_distance().value();
    std::vector<double> levels;
    for (std::size_t n = 1 + bytes_.index(3); n > 0; --n) levels.push_back(draw_level(largest));
    levels.erase(std::remove_if(levels.begin(), levels.end(), [&](double d) { return !(d > 1e-9 * size_); }), levels.end());
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    if (levels.empty()) return;
    const test::Offset_curves curves = test::offsets(geodesic_, levels);
    std::vector<double> crossed; // levels that have curves
    for (const auto& c : curves) crossed.push_back(c.distance());
    std::sort(crossed.begin(), crossed.end());
    crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());

    Surface_mesh split = data_.mesh;
    auto band = split.add_property_map<Face_index, std::size_t>("f:band", 0).first;
    auto distance = split.add_property_map<Surface_mesh::Vertex_index, double>("v:distance", 0).first;
    for (const auto v : split.vertices()) distance[v] = field_.distance_to_sources(v);
    std::map<Face_index, Face_index> parents;
    CGAL::split_along_offset_curves(split, curves,
                                    CGAL::parameters::face_band_map(band)
                                      .vertex_distance_map(distance)
                                      .chord_tolerance(chord_tolerance)
                                      .visitor(Parents(parents)));
    check_mesh(split);
    const double allowed = 2 * chord_tolerance + tie();
    for_each_point(split, parents, [&](Face_index f, const Location& l) {
      const double d = field_.distance_to_sources(l);
      const std::size_t b = band[f];
      if (b > crossed.size() || (b > 0 && !(d >= crossed[b - 1] - allowed)) ||
          (b < crossed.size() && !(d <= crossed[b] + allowed)))
        test::fail_fuzzing("a point at the distance " + std::to_string(d) + " is in the band " + std::to_string(b) + ", from " +
                           std::to_string(b == 0 ? 0 : crossed[b - 1]) + " to " +
                           std::to_string(b < crossed.size() ? crossed[b] : largest));
    });
  }

  double draw_level(double largest)
  {
    const double d = field_.distance_to_sources(data_.vertices[bytes_.index(data_.vertices.size())]);
    switch (bytes_.index(4))
    {
    case 0: return std::isfinite(d) ? d : 0;
    case 1: return std::isfinite(d) ? d * (1 + (bytes_.flag() ? 1 : -1) * std::pow(10, -double(bytes_.index(16)))) : 0;
    default: return largest * bytes_.weight();
    }
  }

  void check_mesh(const Surface_mesh& split) const
  {
    if (!CGAL::is_valid_polygon_mesh(split) || !CGAL::is_triangle_mesh(split) ||
        CGAL::is_closed(split) != CGAL::is_closed(data_.mesh))
      test::fail_fuzzing("the split mesh is not valid");
    const double before = CGAL::Polygon_mesh_processing::area(data_.mesh), after = CGAL::Polygon_mesh_processing::area(split);
    if (!(std::abs(after - before) <= 1e-9 * size_ * size_)) test::fail_fuzzing("the area of the split mesh is another one");
  }

  // Calls f(face, location) for four points of each face of a split mesh, as points of the original mesh.
  template <class Function>
  void for_each_point(const Surface_mesh& split, const std::map<Face_index, Face_index>& parents, const Function& f) const
  {
    const test::Locations<Surface_mesh> original(data_.mesh), parts(split);
    for (const Face_index face : split.faces())
    {
      const auto parent = parents.find(face);
      const Face_index of = parent == parents.end() ? face : parent->second;
      const auto p = parts.corners(face);
      const auto c = original.corners(of);
      for (std::size_t k = 0; k < 4; ++k)
      {
        std::array<double, 3> w = {0.1, 0.1, 0.1};
        if (k < 3) w[k] = 0.8;
        else w = {1. / 3, 1. / 3, 1. / 3};
        const test::Point_3 q = CGAL::barycenter(split.point(p[0]), w[0], split.point(p[1]), w[1], split.point(p[2]), w[2]);
        f(face, Location(of, weights(q, data_.mesh.point(c[0]), data_.mesh.point(c[1]), data_.mesh.point(c[2]))));
      }
    }
  }

  // Barycentric coordinates in a triangle; those that rounding makes negative are 0.
  static std::array<double, 3> weights(const test::Point_3& q, const test::Point_3& a, const test::Point_3& b,
                                       const test::Point_3& c)
  {
    const auto normal = CGAL::cross_product(b - a, c - a);
    const auto part = [&](const test::Point_3& r, const test::Point_3& s) {
      return (std::max)(0., CGAL::cross_product(r - q, s - q) * normal);
    };
    return {part(b, c), part(c, a), part(a, b)};
  }

  test::Fuzz_bytes& bytes_;
  const double size_;
  const test::Generated_mesh<Surface_mesh> data_;
  Geodesic geodesic_;
  Field field_;
  std::map<std::size_t, Field> alone_;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  test::Fuzz_bytes bytes(data, size);
  const test::Fuzz_case fuzz_case(bytes);
  if (!(fuzz_case.flatness() > 0x1p-10)) return 0;
  try
  {
    Diagrams(bytes, fuzz_case).compare();
  }
  catch (const std::exception& error)
  {
    test::fail_fuzzing(error.what());
  }
  return 0;
}
