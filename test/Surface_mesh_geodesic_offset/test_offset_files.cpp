// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The functions that write offset curves: what they promise about their streams and about curves that cannot be drawn. The
// contents of the files are in the tests test_program_*.py.

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "test_check.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_dxf.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_obj.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_polylines.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_svg.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_vtk.h>

#include <functional>
#include <iterator>
#include <list>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_offset_files {

using namespace test;

// All writers, by name, for one range of curves.
template <class Curves>
std::vector<std::pair<std::string, std::function<bool(std::ostream&)>>> writers(const Curves& curves)
{
  return {{"polylines", [&](std::ostream& os) { return CGAL::IO::write_offset_polylines(os, curves, 0.01); }},
          {"vtk", [&](std::ostream& os) { return CGAL::IO::write_offset_VTK(os, curves, 0.01); }},
          {"obj", [&](std::ostream& os) { return CGAL::IO::write_offset_OBJ(os, curves, 0.01); }},
          {"dxf", [&](std::ostream& os) { return CGAL::IO::write_offset_DXF(os, curves, 0.01); }},
          {"svg", [&](std::ostream& os) { return CGAL::IO::write_offset_SVG(os, curves); }}};
}

template <class Mesh>
struct Example
{
  Mesh mesh;
  std::vector<typename Geodesic_on<Mesh>::Offset_curve> curves;

  Example(const Soup& soup, const Point_3& source, const std::vector<double>& distances)
  {
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
    Geodesic_on<Mesh> geodesic(mesh);
    for (auto v : vertices(mesh))
      if (get(CGAL::vertex_point, mesh, v) == source) geodesic.add_source_point(v);
    geodesic.build_with_offset_curves(distances, std::back_inserter(curves));
    CHECK(curves.size() >= distances.size());
  }
};

// The same files from any kind of mesh and any range.
void kinds_of_meshes_and_ranges()
{
  const Soup soup = jittered_grid(8, 8, 3);
  const Point_3 source = soup.points[4 * 9 + 4];
  const Example<Surface_mesh> a(soup, source, {1, 2.5, 5});
  const Example<CGAL::Polyhedron_3<Kernel>> b(soup, source, {1, 2.5, 5});
  const std::list<Geodesic::Offset_curve> list(a.curves.begin(), a.curves.end());
  const auto from_surface_mesh = writers(a.curves), from_polyhedron = writers(b.curves), from_list = writers(list);
  for (std::size_t i = 0; i < from_surface_mesh.size(); ++i)
  {
    Report::instance().set_context(from_surface_mesh[i].first);
    std::ostringstream first, second, third;
    CHECK(from_surface_mesh[i].second(first) && from_polyhedron[i].second(second) && from_list[i].second(third));
    CHECK(first.str().size() > 100);
    CHECK(first.str() == second.str());
    CHECK(first.str() == third.str());
  }
}

struct Comma : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

void streams()
{
  const Soup soup = jittered_grid(8, 8, 3);
  const Example<Surface_mesh> example(soup, soup.points[4 * 9 + 4], {1, 2.5});
  for (const auto& writer : writers(example.curves))
  {
    Report::instance().set_context(writer.first);
    std::ostringstream plain, other;
    CHECK(writer.second(plain));

    // The writer's settings are its own, and so are those of the stream.
    other.imbue(std::locale(std::locale::classic(), new Comma));
    other.precision(3);
    other.setf(std::ios_base::fixed, std::ios_base::floatfield);
    CHECK(writer.second(other));
    CHECK(plain.str() == other.str());
    CHECK(other.precision() == 3 && (other.flags() & std::ios_base::floatfield) == std::ios_base::fixed);
    other.str("");
    other << 1234.5;
    CHECK_DETAIL(other.str() == "1.234,500", other.str());
    std::ostringstream odd;
    odd << std::hex << std::showpos << std::scientific << std::uppercase;
    CHECK(writer.second(odd));
    CHECK(plain.str() == odd.str());

    std::ostringstream bad;
    bad.setstate(std::ios_base::badbit);
    CHECK(!writer.second(bad));
  }
}

void curves_that_are_not_in_a_plane()
{
  Report::instance().set_context("not in a plane");
  const Soup sphere = icosphere(2);
  const Example<Surface_mesh> on_sphere(sphere, sphere.points[0], {0.5});
  std::ostringstream os;
  CHECK_THROWS(CGAL::IO::write_offset_SVG(os, on_sphere.curves), std::invalid_argument);
  CHECK(os.str().empty());
  for (const double tolerance : {0., -1., std::nan("")})
  {
    CHECK_THROWS(CGAL::IO::write_offset_polylines(os, on_sphere.curves, tolerance), std::invalid_argument);
    CHECK_THROWS(CGAL::IO::write_offset_OBJ(os, on_sphere.curves, tolerance), std::invalid_argument);
    CHECK_THROWS(CGAL::IO::write_offset_VTK(os, on_sphere.curves, tolerance), std::invalid_argument);
    CHECK_THROWS(CGAL::IO::write_offset_DXF(os, on_sphere.curves, tolerance), std::invalid_argument);
    CHECK(os.str().empty());
  }
  os.str("");

  // Two curves, each in a plane: two levels round a corner of a cube stay on different sides of it
  // only if they do not reach its edges.
  const Soup cube = cube_grid(4);
  Surface_mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(cube.points, cube.triangles, mesh);
  const auto centers = [&](bool several)
  {
    Geodesic geodesic(mesh);
    CGAL::Bbox_3 box;
    for (const Point_3& p : cube.points) box += p.bbox();
    const double size = box.xmax() - box.xmin();
    for (auto v : mesh.vertices())
    {
      const Point_3 p = mesh.point(v);
      const double x = (p.x() - box.xmin()) / size, y = (p.y() - box.ymin()) / size, z = (p.z() - box.zmin()) / size;
      if ((x == 0.5 && y == 0.5 && z == 1) || (several && x == 1 && y == 0.5 && z == 0.5)) geodesic.add_source_point(v);
    }
    CHECK(geodesic.number_of_sources() == (several ? 2u : 1u));
    std::vector<Geodesic::Offset_curve> curves;
    geodesic.build_with_offset_curves(0.3 * size, std::back_inserter(curves));
    CHECK(curves.size() == geodesic.number_of_sources());
    return curves;
  };
  CHECK_THROWS(CGAL::IO::write_offset_SVG(os, centers(true)), std::invalid_argument);
  CHECK(os.str().empty());
  CHECK(CGAL::IO::write_offset_SVG(os, centers(false)));
  CHECK(os.str().find(" Z\"") != std::string::npos);

  Report::instance().set_context("no curves");
  const std::vector<Geodesic::Offset_curve> none;
  for (const auto& writer : writers(none))
  {
    std::ostringstream empty;
    CHECK_DETAIL(writer.second(empty), writer.first);
  }
}

} // namespace test_offset_files

GEODESIC_OFFSET_TEST(test_offset_files)
{
  kinds_of_meshes_and_ranges();
  streams();
  curves_that_are_not_in_a_plane();
  return Report::instance().finish("test_offset_files");
}
