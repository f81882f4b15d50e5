// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Writers of offset curves: guarantees about streams and curves that cannot be drawn. The tests test_program_*.py check the
// contents of the files.

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "test_check.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/Offset_level_writer.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_csv.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_dxf.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_obj.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_polylines.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_svg.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_vtk.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_vtp.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <list>
#include <locale>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_offset_files {

using namespace test;

// All writers by name, for one range of curves.
template <class Curves>
std::vector<std::pair<std::string, std::function<bool(std::ostream&)>>> writers(const Curves& curves)
{
  return {
    {"polylines",
     [&](std::ostream& os) { return CGAL::IO::write_offset_polylines(os, curves, CGAL::parameters::chord_tolerance(0.01)); }},
    {"vtk", [&](std::ostream& os) { return CGAL::IO::write_offset_VTK(os, curves, CGAL::parameters::chord_tolerance(0.01)); }},
    {"vtp", [&](std::ostream& os) { return CGAL::IO::write_offset_VTP(os, curves, CGAL::parameters::chord_tolerance(0.01)); }},
    {"obj", [&](std::ostream& os) { return CGAL::IO::write_offset_OBJ(os, curves, CGAL::parameters::chord_tolerance(0.01)); }},
    {"csv", [&](std::ostream& os) { return CGAL::IO::write_offset_CSV(os, curves, CGAL::parameters::chord_tolerance(0.01)); }},
    {"dxf", [&](std::ostream& os) { return CGAL::IO::write_offset_DXF(os, curves, CGAL::parameters::chord_tolerance(0.01)); }},
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

// Files do not depend on the type of mesh and range.
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

    // Settings of the writer and those of the stream are independent.
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
    CHECK_THROWS(CGAL::IO::write_offset_polylines(os, on_sphere.curves, CGAL::parameters::chord_tolerance(tolerance)),
                 std::invalid_argument);
    CHECK_THROWS(CGAL::IO::write_offset_OBJ(os, on_sphere.curves, CGAL::parameters::chord_tolerance(tolerance)),
                 std::invalid_argument);
    CHECK_THROWS(CGAL::IO::write_offset_VTK(os, on_sphere.curves, CGAL::parameters::chord_tolerance(tolerance)),
                 std::invalid_argument);
    CHECK_THROWS(CGAL::IO::write_offset_VTP(os, on_sphere.curves, CGAL::parameters::chord_tolerance(tolerance)),
                 std::invalid_argument);
    CHECK_THROWS(CGAL::IO::write_offset_CSV(os, on_sphere.curves, CGAL::parameters::chord_tolerance(tolerance)),
                 std::invalid_argument);
    CHECK_THROWS(CGAL::IO::write_offset_DXF(os, on_sphere.curves, CGAL::parameters::chord_tolerance(tolerance)),
                 std::invalid_argument);
    CHECK(os.str().empty());
  }
  os.str("");

  // Two curves, each in a plane: two levels around a corner of a cube stay on different sides only if they do not reach its
  // edges.
  const Soup cube = cube_grid(4);
  Surface_mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(cube.points, cube.triangles, mesh);
  const auto centers = [&](bool several) {
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

// Folder for files, removed at the end.
class Folder
{
public:
  Folder() : m_path(std::filesystem::temp_directory_path() / ("test_offset_files_" + std::to_string(std::random_device()())))
  {
    std::filesystem::create_directory(m_path);
  }
  ~Folder() { std::filesystem::remove_all(m_path); }
  std::string operator()(const std::string& name) const { return (m_path / name).string(); }

private:
  std::filesystem::path m_path;
};

std::string contents(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

void files()
{
  namespace parameters = CGAL::parameters;
  const Folder folder;
  const Soup soup = jittered_grid(8, 8, 3);
  const Example<Surface_mesh> example(soup, soup.points[4 * 9 + 4], {1, 2.5});
  const auto& curves = example.curves;
  const std::pair<std::string, std::string> names[] = {
    {"polylines", "a.polylines.txt"},
    {"vtk", "a.VTK"},
    {"vtp", "a.vtp"},
    {"obj", "a.b.obj"},
    {"csv", "a.CSV"},
    {"dxf", "a.Dxf"},
    {"svg", "a.svg"}};
  for (const auto& [writer_name, function] : writers(curves))
    for (const auto& [name, file_name] : names)
    {
      if (name != writer_name) continue;
      Report::instance().set_context(file_name);
      std::ostringstream expected, os;
      CHECK(function(expected));
      const std::string file = folder(file_name);
      CHECK(CGAL::IO::write_offset_curves(file, curves, parameters::chord_tolerance(0.01)));
      CHECK(contents(file) == expected.str());
      CHECK(CGAL::IO::write_offset_curves(os, CGAL::IO::offset_file_format(file), curves, parameters::chord_tolerance(0.01)));
      CHECK(os.str() == expected.str());
      CHECK(CGAL::IO::write_offset_curves(file, curves)); // the default tolerance is finer
      if (name == "dxf" || name == "svg") CHECK(contents(file) == expected.str());
      else CHECK(contents(file).size() > expected.str().size());

      CHECK(!CGAL::IO::write_offset_curves(folder("there is no such folder/" + file_name), curves));
      CHECK_THROWS(CGAL::IO::write_offset_curves(file, curves, parameters::chord_tolerance(0.)), std::invalid_argument);
      CHECK_DETAIL(!contents(file).empty(), "has not been touched");
      os.setstate(std::ios_base::badbit);
      CHECK(!CGAL::IO::write_offset_curves(os, CGAL::IO::offset_file_format(file), curves));
    }
  Report::instance().set_context("the default tolerance");
  double box = 0; // of circles with radius 2.5
  std::vector<Point_3> points;
  CHECK(CGAL::IO::write_offset_curves(folder("a.polylines.txt"), curves));
  std::ifstream in(folder("a.polylines.txt"));
  for (std::size_t count; in >> count;)
    for (double x, y, z; count > 0 && in >> x >> y >> z; --count) points.push_back(Point_3(x, y, z));
  for (const Point_3& p : points) box = (std::max)(box, 2 * std::abs(p.y() - soup.points[4 * 9 + 4].y()));
  CHECK(std::abs(box - 5) < 1e-2);
  CHECK_DETAIL(points.size() > 200 && points.size() < 2000, std::to_string(points.size()));

  Report::instance().set_context("names");
  for (const char* name : {"a", "a.txt", "polylines.txt", ".svg", "a.svg.gz", "svg", ""})
  {
    CHECK_THROWS(CGAL::IO::offset_file_format(name), std::invalid_argument);
    CHECK_THROWS(CGAL::IO::write_offset_curves(name, curves), std::invalid_argument);
  }
  CHECK_THROWS(CGAL::IO::write_offset_curves(folder("a.txt"), curves), std::invalid_argument);
  CHECK(!std::filesystem::exists(folder("a.txt")));

  Report::instance().set_context("no curves");
  for (const auto& name : names)
    CHECK(CGAL::IO::write_offset_curves(folder(name.second), std::vector<Geodesic::Offset_curve>()));

  Report::instance().set_context("not in a plane");
  const Soup sphere = icosphere(2);
  const Example<Surface_mesh> on_sphere(sphere, sphere.points[0], {0.5});
  std::ofstream(folder("old.svg")) << "old";
  CHECK_THROWS(CGAL::IO::write_offset_curves(folder("old.svg"), on_sphere.curves), std::invalid_argument);
  CHECK(contents(folder("old.svg")) == "old");
}

// Parts of a file together are the file of all curves.
void levels()
{
  using CGAL::IO::Offset_file_format;
  using CGAL::IO::Offset_level_writer;
  const Soup soup = jittered_grid(8, 8, 3);
  const Example<Surface_mesh> example(soup, soup.points[4 * 9 + 4], {1, 2.5, 3.5, 5});
  const std::string names[] = {"a.polylines.txt", "a.vtk", "a.vtp", "a.obj", "a.csv", "a.dxf", "a.svg"};
  for (const std::string& name : names)
  {
    Report::instance().set_context("parts of " + name);
    const Offset_file_format format = CGAL::IO::offset_file_format(name);
    std::ostringstream parts, whole;
    const bool is_written_by_level = name != "a.vtk" && name != "a.dxf" && name != "a.svg";
    CHECK(Offset_level_writer::supports(format) == is_written_by_level);
    if (!is_written_by_level)
    {
      CHECK_THROWS(Offset_level_writer(parts, format, CGAL::parameters::chord_tolerance(0.01)), std::invalid_argument);
      continue;
    }
    for (const double tolerance : {0., -1., std::nan("")})
      CHECK_THROWS(Offset_level_writer(parts, format, CGAL::parameters::chord_tolerance(tolerance)), std::invalid_argument);
    CHECK(parts.str().empty());
    Offset_level_writer writer(parts, format, CGAL::parameters::chord_tolerance(0.01));
    const auto& curves = example.curves;
    CHECK(writer.write(std::vector<Geodesic::Offset_curve>(curves.begin(), curves.begin() + 2)));
    CHECK(writer.write(std::vector<Geodesic::Offset_curve>()));
    CHECK(writer.write(std::vector<Geodesic::Offset_curve>(curves.begin() + 2, curves.end())));
    {
      std::ostringstream none;
      Offset_level_writer fine(none, format, CGAL::parameters::chord_tolerance(1e-300));
      const std::string begin = none.str();
      CHECK_THROWS(fine.write(curves), std::length_error);
      CHECK(none.str() == begin);
    }
    CHECK(writer.finish());
    CHECK(CGAL::IO::write_offset_curves(whole, format, curves, CGAL::parameters::chord_tolerance(0.01)));
    if (format == Offset_file_format::VTP) // test_program_reads_vtp reads such files
    {
      const std::string text = parts.str();
      std::size_t pieces = 0;
      for (std::size_t at = 0; (at = text.find("<Piece", at)) != std::string::npos; ++at) ++pieces;
      CHECK(pieces == 3);
    }
    else CHECK(parts.str() == whole.str());

    parts.setstate(std::ios_base::badbit);
    Offset_level_writer other(parts, format, CGAL::parameters::chord_tolerance(0.01));
    CHECK(!other.write(curves));
    CHECK(!other.finish());
  }
}

void units()
{
  namespace IO = CGAL::IO;
  const Soup soup = jittered_grid(8, 8, 3);
  const Example<Surface_mesh> example(soup, soup.points[4 * 9 + 4], {1, 2.5});
  const auto text_after = [](const std::string& text, const std::string& key, std::size_t length) {
    const std::size_t at = text.find(key);
    return at == std::string::npos ? std::string() : text.substr(at + key.size(), length);
  };
  struct Unit
  {
    IO::Length_unit unit;
    std::string number, name;
    double factor;
  };
  // without a chord tolerance: the default of write_offset_curves()
  std::ostringstream csv, csv_by_name;
  CHECK(IO::write_offset_CSV(csv, example.curves) &&
        IO::write_offset_curves(csv_by_name, IO::Offset_file_format::CSV, example.curves));
  CHECK(csv.str() == csv_by_name.str() && csv.str().size() > 1000);
  for (const Unit& u : {Unit{IO::Length_unit::NONE, "0", "", 1}, Unit{IO::Length_unit::MILLIMETER, "4", "mm", 1},
                        Unit{IO::Length_unit::CENTIMETER, "5", "cm", 1}, Unit{IO::Length_unit::METER, "6", "mm", 1000},
                        Unit{IO::Length_unit::INCH, "1", "in", 1}})
  {
    Report::instance().set_context("unit " + u.number);
    std::ostringstream dxf, svg, plain_dxf, plain_svg, by_name;
    CHECK(IO::write_offset_DXF(dxf, example.curves, CGAL::parameters::chord_tolerance(0.01).length_unit(u.unit)));
    CHECK(IO::write_offset_SVG(svg, example.curves, CGAL::parameters::length_unit(u.unit)));
    CHECK(text_after(dxf.str(), "$INSUNITS\n70\n", 2) == u.number + "\n");
    CHECK(IO::write_offset_curves(by_name, IO::Offset_file_format::SVG, example.curves,
                                  CGAL::parameters::chord_tolerance(1.).length_unit(u.unit)));
    CHECK(by_name.str() == svg.str());
    by_name.str("");
    CHECK(IO::write_offset_curves(by_name, IO::Offset_file_format::DXF, example.curves, CGAL::parameters::length_unit(u.unit)));
    CHECK(by_name.str() == dxf.str());
    CHECK(IO::write_offset_DXF(plain_dxf, example.curves, CGAL::parameters::chord_tolerance(0.01)) &&
          IO::write_offset_SVG(plain_svg, example.curves));
    CHECK((dxf.str() == plain_dxf.str()) == u.name.empty());
    CHECK((svg.str() == plain_svg.str()) == u.name.empty());

    std::istringstream box(text_after(svg.str(), "viewBox=\"", 200));
    double x, y, width, height;
    CHECK(box >> x >> y >> width >> height);
    for (const auto& [attribute, size] : {std::make_pair(std::string(" width=\""), width), {" height=\"", height}})
    {
      std::istringstream length(text_after(svg.str(), attribute, 40));
      double number = 0;
      std::string name;
      if (u.name.empty()) CHECK(svg.str().find(attribute) == std::string::npos);
      else
      {
        length >> number >> name;
        CHECK(std::abs(number - u.factor * size) <= 1e-14 * number && name.substr(0, 3) == u.name + '"');
      }
    }
  }
}

// Rounds each coordinate to seven digits.
Soup rounded(Soup soup)
{
  for (Point_3& p : soup.points)
  {
    double c[3];
    for (int i = 0; i < 3; ++i)
    {
      std::ostringstream text;
      text.precision(7);
      text << p[i];
      c[i] = std::stod(text.str());
    }
    p = Point_3(c[0], c[1], c[2]);
  }
  return soup;
}

void planar_meshes()
{
  Report::instance().set_context("planar meshes");
  const auto can_write = [](const Soup& soup) {
    Surface_mesh mesh;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
    const bool result = CGAL::IO::can_write_offset_SVG(mesh);
    Geodesic geodesic(mesh);
    geodesic.add_source_point(*vertices(mesh).begin());
    geodesic.build();
    std::vector<Geodesic::Offset_curve> curves;
    const double largest = geodesic.largest_vertex_distance().value();
    geodesic.offset_curves(std::vector<double>{0.3 * largest, 0.6 * largest}, std::back_inserter(curves));
    std::ostringstream os;
    if (result) CHECK(CGAL::IO::write_offset_SVG(os, curves));
    else CHECK_THROWS(CGAL::IO::write_offset_SVG(os, curves), std::invalid_argument);
    return result;
  };
  for (unsigned seed = 1; seed <= 4; ++seed)
  {
    CHECK(can_write(jittered_grid(8, 8, seed)));
    CHECK(can_write(rotated(jittered_grid(8, 8, seed), seed)));
    CHECK(can_write(rounded(rotated(jittered_grid(90, 90, seed), seed)))); // small faces with rounded normals
    CHECK(!can_write(rotated(cube_grid(3), seed)));
  }
  CHECK(!can_write(icosphere(2)));
  CHECK(!can_write(saddle_fan()));

  const Surface_mesh empty;
  CHECK(CGAL::IO::can_write_offset_SVG(empty));
  Surface_mesh cube;
  const Soup soup = cube_grid(2);
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, cube);
  auto flat = cube.add_property_map<Surface_mesh::Vertex_index, Point_3>("v:flat").first;
  for (auto v : cube.vertices()) flat[v] = Point_3(cube.point(v).x(), cube.point(v).y(), 7);
  CHECK(CGAL::IO::can_write_offset_SVG(cube, CGAL::parameters::vertex_point_map(flat)));
}

} // namespace test_offset_files

GEODESIC_OFFSET_TEST(test_offset_files)
{
  kinds_of_meshes_and_ranges();
  streams();
  curves_that_are_not_in_a_plane();
  files();
  levels();
  units();
  planar_meshes();
  return Report::instance().finish("test_offset_files");
}
