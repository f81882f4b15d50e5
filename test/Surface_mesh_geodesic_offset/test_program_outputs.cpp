// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Every output of the program, read back and compared with closed forms on a planar mesh and a box; every kind of source
// and every mesh format. The tests test_program_*.py read outputs with other software.
//
//   test_program_outputs PROGRAM

#include "closed_forms.h"
#include "generated_meshes.h"
#include "program_runner.h"
#include "test_check.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace test_program_outputs {

using namespace test;

typedef std::vector<std::string> Arguments;

struct Polyline
{
  std::vector<Point_3> points;
  double distance = 0;
  bool closed = false;
};

std::vector<Polyline> read_polylines(const std::filesystem::path& file)
{
  std::vector<Polyline> result;
  std::ifstream in(file);
  for (std::size_t count; in >> count;)
  {
    Polyline polyline;
    for (std::size_t i = 0; i < count; ++i)
    {
      double x, y, z;
      CHECK(static_cast<bool>(in >> x >> y >> z));
      polyline.points.push_back(Point_3(x, y, z));
    }
    CHECK(count >= 2);
    polyline.closed = count > 2 && polyline.points.front() == polyline.points.back();
    result.push_back(polyline);
  }
  CHECK(in.eof());
  return result;
}

// Legacy VTK polydata with one cell per curve.
std::vector<Polyline> read_vtk(const std::filesystem::path& file)
{
  std::vector<Polyline> result;
  std::vector<Point_3> points;
  std::istringstream in(read_file(file));
  std::string word;
  std::getline(in, word);
  CHECK(word.rfind("# vtk DataFile", 0) == 0);
  bool has_distance = false, has_closed = false;
  while (in >> word)
  {
    std::size_t count = 0, size = 0;
    if (word == "POINTS")
    {
      in >> count >> word;
      for (double x, y, z; points.size() < count && in >> x >> y >> z;) points.push_back(Point_3(x, y, z));
      CHECK(points.size() == count);
    }
    else if (word == "LINES")
    {
      in >> count >> size;
      std::size_t numbers = 0;
      for (std::size_t i = 0; i < count; ++i)
      {
        Polyline polyline;
        std::size_t length = 0;
        in >> length;
        numbers += length + 1;
        for (std::size_t k = 0, index = 0; k < length && in >> index; ++k)
          if (CHECK(index < points.size())) polyline.points.push_back(points[index]);
        result.push_back(polyline);
      }
      CHECK(numbers == size);
    }
    else if (word == "CELL_DATA")
    {
      in >> count;
      CHECK(count == result.size());
    }
    else if (word == "POINT_DATA")
    {
      in >> count;
      CHECK(count == points.size());
    }
    else if (word == "distance") // the name of scalars
    {
      std::getline(in, word);
      std::getline(in, word); // LOOKUP_TABLE default
      for (Polyline& polyline : result) CHECK(static_cast<bool>(in >> polyline.distance));
      has_distance = true;
    }
    else if (word == "closed" || word == "source" || word == "side") // the name of a field
    {
      const bool is_closed = word == "closed";
      in >> size >> count >> word;
      CHECK(size == 1 && (count == result.size() || count == points.size()) && word == "int");
      for (std::size_t i = 0; i < count; ++i)
      {
        int value = -2;
        CHECK(static_cast<bool>(in >> value) && value >= -1 && value <= 3);
        if (is_closed && CHECK(i < result.size())) result[i].closed = (value == 1);
      }
      has_closed = has_closed || is_closed;
    }
  }
  CHECK(result.empty() || (has_distance && has_closed));
  return result;
}

std::vector<Polyline> read_obj(const std::filesystem::path& file)
{
  std::vector<Polyline> result;
  std::vector<Point_3> points;
  std::istringstream in(read_file(file));
  for (std::string line; std::getline(in, line);)
  {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "v")
    {
      double x, y, z;
      CHECK(static_cast<bool>(words >> x >> y >> z));
      points.push_back(Point_3(x, y, z));
    }
    else if (key == "l")
    {
      Polyline polyline;
      for (std::size_t index; words >> index;)
        if (CHECK(index >= 1 && index <= points.size())) polyline.points.push_back(points[index - 1]);
      CHECK(polyline.points.size() >= 2);
      polyline.closed = polyline.points.front() == polyline.points.back();
      result.push_back(polyline);
    }
  }
  return result;
}

struct Field
{
  std::vector<Point_3> points;
  std::vector<double> distances;
  std::vector<double> signed_distances; // empty if the file has none
  std::vector<std::vector<std::size_t>> faces;
};

// Binary little-endian PLY with double x, y, z, distance, optionally signed_distance, and a list of int per face.
Field read_field(const std::filesystem::path& file)
{
  Field field;
  const std::string bytes = read_file(file);
  const std::size_t end = bytes.find("end_header\n");
  if (!CHECK(end != std::string::npos)) return field;
  std::istringstream header(bytes.substr(0, end));
  std::size_t number_of_vertices = 0, number_of_faces = 0;
  bool has_distance = false, has_signed_distance = false, is_binary = false;
  for (std::string line; std::getline(header, line);)
  {
    std::istringstream words(line);
    std::string key, name;
    words >> key >> name;
    if (key == "element" && name == "vertex") words >> number_of_vertices;
    if (key == "element" && name == "face") words >> number_of_faces;
    has_distance = has_distance || line == "property double distance";
    has_signed_distance = has_signed_distance || line == "property double signed_distance";
    is_binary = is_binary || line == "format binary_little_endian 1.0";
  }
  CHECK(has_distance && is_binary);
  const char* at = bytes.data() + end + std::strlen("end_header\n");
  const char* const last = bytes.data() + bytes.size();
  const auto read = [&](auto& value) {
    if (at + sizeof(value) <= last) std::memcpy(&value, at, sizeof(value));
    at += sizeof(value);
  };
  for (std::size_t i = 0; i < number_of_vertices; ++i)
  {
    double values[4] = {};
    for (double& value : values) read(value);
    field.points.push_back(Point_3(values[0], values[1], values[2]));
    field.distances.push_back(values[3]);
    if (has_signed_distance)
    {
      field.signed_distances.emplace_back();
      read(field.signed_distances.back());
    }
  }
  for (std::size_t i = 0; i < number_of_faces && at < last; ++i)
  {
    std::uint8_t size = 0;
    read(size);
    field.faces.emplace_back();
    for (std::uint8_t k = 0; k < size; ++k)
    {
      std::int32_t index = -1;
      read(index);
      field.faces.back().push_back(static_cast<std::size_t>(index));
    }
  }
  CHECK(at == last);
  return field;
}

// Width and height, after the signature; 0 for other files than PNG.
std::pair<std::uint32_t, std::uint32_t> png_size(const std::string& bytes)
{
  if (bytes.size() < 57 || bytes.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0 || bytes.compare(12, 4, "IHDR") != 0 ||
      bytes.compare(bytes.size() - 8, 4, "IEND") != 0)
    return {0, 0};
  const auto number = [&](std::size_t at) {
    std::uint32_t result = 0;
    for (std::size_t i = 0; i < 4; ++i) result = (result << 8) | static_cast<unsigned char>(bytes[at + i]);
    return result;
  };
  return {number(16), number(20)};
}

double json_number(const std::string& json, const std::string& key)
{
  const std::size_t at = json.find("\"" + key + "\":");
  if (at == std::string::npos) return std::numeric_limits<double>::quiet_NaN();
  return std::strtod(json.c_str() + at + key.size() + 3, nullptr);
}

class Outputs
{
public:
  explicit Outputs(const std::string& program) : program_(program) {}

  void run_all()
  {
    all_outputs();
    sources();
    sides();
    formats();
    unreachable_vertices();
  }

private:
  std::string path(const std::string& name) const { return (scratch_ / name).string(); }

  void run(const Arguments& arguments)
  {
    const Program_result result = run_program(program_, arguments);
    CHECK_DETAIL(result.exit_code == 0, std::to_string(result.exit_code) + ": " + result.errors);
  }

  // Writes the planar mesh for which `distance_from` is correct.
  void write_planar(const std::string& name) const
  {
    const Soup soup = jittered_grid(12, 12, 5);
    CGAL::IO::write_polygon_soup(path(name), soup.points, soup.triangles, CGAL::parameters::stream_precision(17));
  }

  template <class Distance>
  void check_curves(const std::vector<Polyline>& curves, const std::vector<double>& levels, std::size_t expected_curves,
                    std::size_t expected_closed, const Distance& distance)
  {
    CHECK_DETAIL(curves.size() == expected_curves, std::to_string(curves.size()) + " curves");
    std::size_t closed = 0;
    std::set<double> seen;
    for (const Polyline& curve : curves)
    {
      closed += curve.closed ? 1 : 0;
      CHECK(curve.points.size() >= 2);
      double level = infinity_;
      for (double l : levels)
        if (!curve.points.empty() && std::abs(distance(curve.points[0]) - l) < 1e-9) level = l;
      CHECK(level != infinity_ && (curve.distance == 0 || curve.distance == level));
      seen.insert(level);
      for (const Point_3& p : curve.points) CHECK_DETAIL(std::abs(distance(p) - level) < 1e-9, values(distance(p), level));
    }
    CHECK_DETAIL(closed == expected_closed, std::to_string(closed) + " closed");
    CHECK(seen.size() == levels.size());
  }

  // Reads and checks the field; the source is given by its distance function.
  template <class Distance>
  void check_field(const std::string& name, const Soup& soup, const Distance& distance)
  {
    const Field field = read_field(scratch_ / name);
    CHECK(field.points.size() == soup.points.size() && field.faces.size() == soup.triangles.size());
    Worst_error worst(1e-12, 12);
    for (std::size_t i = 0; i < field.points.size() && i < soup.points.size(); ++i)
    {
      CHECK(field.points[i] == soup.points[i]);
      CHECK_CLOSE(worst, field.distances[i], distance(soup.points[i]));
    }
    for (std::size_t i = 0; i < field.faces.size() && i < soup.triangles.size(); ++i)
      CHECK(field.faces[i] == std::vector<std::size_t>(soup.triangles[i].begin(), soup.triangles[i].end()));
  }

  void all_outputs()
  {
    Report::instance().set_context("all outputs");
    const Soup soup = jittered_grid(12, 12, 5);
    write_planar("plane.off");
    const std::size_t source = 6 * 13 + 6;
    run({path("plane.off"),
         "--source-vertex",
         std::to_string(source),
         "--distance",
         "1.25",
         "--distance",
         "3",
         "--distance",
         "7.5",
         "--output",
         path("curves.polylines.txt"),
         "--output",
         path("curves.vtk"),
         "--output",
         path("curves.obj"),
         "--field",
         path("field.ply"),
         "--picture",
         path("picture.png"),
         "--stats",
         path("stats.json"),
         "--tolerance",
         "0.001"});
    const auto distance = [&](const Point_3& p) { return std::sqrt(CGAL::squared_distance(p, soup.points[source])); };
    // The circle of radius 7.5 crosses all four sides of the square of side 12.
    const std::vector<double> levels = {1.25, 3, 7.5};
    check_curves(read_polylines(scratch_ / "curves.polylines.txt"), levels, 6, 2, distance);
    check_curves(read_vtk(scratch_ / "curves.vtk"), levels, 6, 2, distance);
    check_curves(read_obj(scratch_ / "curves.obj"), levels, 6, 2, distance);
    check_field("field.ply", soup, distance);

    const std::pair<std::uint32_t, std::uint32_t> size = png_size(read_file(scratch_ / "picture.png"));
    CHECK(size.first >= 100 && size.second >= 100);
    const std::string stats = read_file(scratch_ / "stats.json");
    CHECK(json_number(stats, "vertices") == static_cast<double>(soup.points.size()));
    CHECK(json_number(stats, "faces") == static_cast<double>(soup.triangles.size()));
    CHECK(json_number(stats, "threads") >= 1);
    for (const char* key : {"setup_seconds", "solve_seconds", "offset_seconds"})
      CHECK_DETAIL(json_number(stats, key) >= 0, key);
    for (const char* key : {"windows_created", "windows_propagated", "windows_peak", "pieces_peak", "peak_rss_bytes"})
      CHECK_DETAIL(json_number(stats, key) > 0, key);
    const std::string curves = stats.substr((std::min)(stats.find("\"curves\""), stats.size()));
    CHECK(json_number(curves, "distance") == 1.25 && json_number(curves, "number") == 1 && json_number(curves, "closed") == 1);
    const double length = json_number(curves, "length");
    CHECK_DETAIL(std::abs(length - 2.5 * CGAL_PI) < 1e-10, values(length, 2.5 * CGAL_PI));

    Report::instance().set_context("spacing until the surface is covered");
    double largest = 0;
    for (const Point_3& p : soup.points) largest = (std::max)(largest, distance(p));
    run({path("plane.off"), "--source-vertex", std::to_string(source), "--spacing", "1.5", "--output", path("spaced.vtk"),
         "--quiet"});
    std::set<double> spaced;
    for (const Polyline& curve : read_vtk(scratch_ / "spaced.vtk")) spaced.insert(curve.distance);
    CHECK(spaced.size() == static_cast<std::size_t>(largest / 1.5));
    run({path("plane.off"), "--source-vertex", std::to_string(source), "--spacing", "1.5", "--count", "2", "--output",
         path("counted.vtk"), "--quiet"});
    check_curves(read_vtk(scratch_ / "counted.vtk"), {1.5, 3}, 2, 2, distance);

    Report::instance().set_context("threads");
    for (const char* threads : {"1", "2"})
    {
      const Program_result result =
        run_program(program_, {path("plane.off"), "--source-vertex", std::to_string(source), "--spacing", "1.5", "--count", "2",
                               "--threads", threads, "--output", path("threads.vtk"), "--quiet"});
      if (result.exit_code == 2 && std::string(threads) != "1")
        CHECK_DETAIL(result.errors.find("without TBB") != std::string::npos, result.errors);
      else check_curves(read_vtk(scratch_ / "threads.vtk"), {1.5, 3}, 2, 2, distance);
    }

    Report::instance().set_context("maximum distance");
    run({path("plane.off"), "--source-vertex", std::to_string(source), "--maximum-distance", "4", "--field", path("near.ply"),
         "--quiet"});
    check_field("near.ply", soup, [&](const Point_3& p) { return distance(p) <= 4 ? distance(p) : infinity_; });
  }

  void sources()
  {
    const Soup soup = jittered_grid(12, 12, 5);
    write_planar("plane.off");
    const auto run_source = [&](const std::string& option, const std::string& value) {
      Report::instance().set_context(option);
      Arguments arguments = {path("plane.off"), option};
      if (!value.empty()) arguments = {path("plane.off"), option + "=" + value};
      arguments.insert(arguments.end(),
                       {"--distance=1.5", "--output", path("source.vtk"), "--field", path("source.ply"), "--quiet"});
      run(arguments);
    };
    const auto from_point = [](double x, double y) {
      return [=](const Point_3& p) { return std::hypot(p.x() - x, p.y() - y); };
    };
    run_source("--source-point", "5.3,6.1,4"); // above the surface: nearest point of the surface
    check_field("source.ply", soup, from_point(5.3, 6.1));
    check_curves(read_vtk(scratch_ / "source.vtk"), {1.5}, 1, 1, from_point(5.3, 6.1));

    const Point_2 a(3.1, 4.2), b(8.3, 7.7), c(8.9, 3.3);
    write_file(scratch_ / "curve.polylines.txt", "3 3.1 4.2 0 8.3 7.7 0 8.9 3.3 0\n");
    const auto from_polyline = [&](const Point_3& p) {
      const Point_2 q(p.x(), p.y());
      return (std::min)(segment_distance(q, a, b), segment_distance(q, b, c));
    };
    run_source("--source-polyline", path("curve.polylines.txt"));
    check_field("source.ply", soup, from_polyline);
    check_curves(read_vtk(scratch_ / "source.vtk"), {1.5}, 1, 1, from_polyline);

    const auto from_line = [](const Point_3& p) { return std::abs(3 * p.x() + 4 * p.y() - 41.3) / 5; };
    run_source("--source-plane", "3,4,0,-41.3"); // two offsets, from boundary to boundary
    const std::vector<Polyline> beside_line = read_vtk(scratch_ / "source.vtk");
    CHECK(beside_line.size() == 2);
    for (const Polyline& curve : beside_line) CHECK(!curve.closed);
    const Field field = read_field(scratch_ / "source.ply");
    for (std::size_t i = 0; i < field.points.size(); ++i)
    {
      // Equal if the foot on the line is inside the square, and never smaller.
      const Point_3 p = field.points[i];
      const double t = (3 * p.x() + 4 * p.y() - 41.3) / 25, x = p.x() - 3 * t, y = p.y() - 4 * t;
      CHECK(field.distances[i] >= from_line(p) - 1e-12);
      if (x > 0 && x < 12 && y > 0 && y < 12)
        CHECK_DETAIL(std::abs(field.distances[i] - from_line(p)) < 1e-11, values(field.distances[i], from_line(p)));
    }

    const auto from_boundary = [](const Point_3& p) {
      return (std::min)((std::min)(p.x(), 12 - p.x()), (std::min)(p.y(), 12 - p.y()));
    };
    run_source("--source-boundary", "");
    check_field("source.ply", soup, from_boundary);
    check_curves(read_vtk(scratch_ / "source.vtk"), {1.5}, 1, 1, from_boundary);

    Report::instance().set_context("--source-sharp-edges");
    const Soup cube = box_sides(1, 1, 1).triangulated(25, 3, 4);
    CGAL::IO::write_polygon_soup(path("cube.off"), cube.points, cube.triangles, CGAL::parameters::stream_precision(17));
    run({path("cube.off"), "--source-sharp-edges", "60", "--distance", "0.3", "--output", path("sharp.vtk"), "--field",
         path("sharp.ply"), "--quiet"});
    const auto from_cube_edges = [](const Point_3& p) { // second smallest distance from the plane of a side
      std::vector<double> d;
      for (int i = 0; i < 3; ++i) d.push_back((std::min)(p[i], 1 - p[i]));
      std::sort(d.begin(), d.end());
      return (std::max)(0., d[1]);
    };
    check_field("sharp.ply", cube, from_cube_edges);
    check_curves(read_vtk(scratch_ / "sharp.vtk"), {0.3}, 6, 6, from_cube_edges);

    Report::instance().set_context("a mix of sources");
    run({path("plane.off"), "--source-vertex", "0", "--source-vertex", "168", "--source-point", "5.3,6.1,0",
         "--source-polyline", path("curve.polylines.txt"), "--field", path("mix.ply"), "--quiet"});
    check_field("mix.ply", soup, [&](const Point_3& p) {
      return (std::min)((std::min)(from_polyline(p), from_point(5.3, 6.1)(p)),
                        (std::min)(from_point(0, 0)(p), from_point(12, 12)(p)));
    });
  }

  // One side of a polyline across the whole square, with the signed distance, and of a closed polyline.
  void sides()
  {
    write_planar("plane.off");
    write_file(scratch_ / "across.polylines.txt", "2 -1 6.1 0 13 6.1 0\n"); // the upper part is on the left
    write_file(scratch_ / "square.polylines.txt", "5 4 4 0 8 4 0 8 8 0 4 8 0 4 4 0\n");
    const auto run_side = [&](const std::string& curve, const Arguments& more) {
      Report::instance().set_context(curve + (more.empty() ? "" : " " + more.back()));
      Arguments arguments = {
        path("plane.off"), "--source-polyline", path(curve), "--distance",      "1.5",    "--output", path("side.vtk"),
        "--field",         path("side.ply"),    "--stats",   path("side.json"), "--quiet"};
      arguments.insert(arguments.end(), more.begin(), more.end());
      run(arguments);
    };
    const auto length = [&](double expected) {
      const std::string stats = read_file(scratch_ / "side.json");
      const double actual = json_number(stats.substr((std::min)(stats.find("\"curves\""), stats.size())), "length");
      CHECK_DETAIL(std::abs(actual - expected) < 1e-9, values(actual, expected));
    };
    for (int side : {0, 1, -1}) // both, left, right
    {
      run_side("across.polylines.txt", side == 0 ? Arguments() : Arguments{"--side", side > 0 ? "left" : "right"});
      const auto expected = [&](const Point_3& p) { return side == 0 ? std::abs(p.y() - 6.1) : side * (p.y() - 6.1); };
      check_curves(read_vtk(scratch_ / "side.vtk"), {1.5}, side == 0 ? 2 : 1, 0, expected);
      length(side == 0 ? 24 : 12);
      const Field field = read_field(scratch_ / "side.ply");
      CHECK(field.signed_distances.size() == field.points.size());
      for (std::size_t i = 0; i < field.signed_distances.size(); ++i)
        CHECK_DETAIL(std::abs(field.signed_distances[i] - (6.1 - field.points[i].y())) < 1e-12,
                     values(field.signed_distances[i], 6.1 - field.points[i].y()));
    }
    run_side("square.polylines.txt", {});
    length(4 + 16 + 3 * CGAL_PI);
    for (const char* side : {"inside", "left"})
    {
      run_side("square.polylines.txt", {"--side", side});
      length(4);
    }
    for (const char* side : {"outside", "right"})
    {
      run_side("square.polylines.txt", {"--side", side});
      length(16 + 3 * CGAL_PI);
    }
    run_side("square.polylines.txt", {"--side", "both", "--end", "butt"});
    length(4 + 16 + 3 * CGAL_PI); // a closed curve has no ends
  }

  // Equal distances from each format, from polygons other than triangles, and from a soup that needs repair.
  void formats()
  {
    const Soup soup = planar_grid(6, 5, Diagonals::alternating); // coordinates are exact in every format
    const auto distance = [](const Point_3& p) { return std::hypot(p.x() - 3, p.y() - 2); };
    for (const char* name : {"grid.off", "grid.obj", "grid.ply"})
    {
      Report::instance().set_context(name);
      CGAL::IO::write_polygon_soup(path(name), soup.points, soup.triangles);
      run({path(name), "--source-vertex", "17", "--field", path("grid_field.ply"), "--quiet"});
      check_field("grid_field.ply", soup, distance);
    }
    Report::instance().set_context("grid.stl"); // a soup of separate triangles
    CGAL::IO::write_polygon_soup(path("grid.stl"), soup.points, soup.triangles);
    run({path("grid.stl"), "--source-point", "3,2,0", "--distance", "1.5", "--output", path("stl.vtk"), "--quiet"});
    check_curves(read_vtk(scratch_ / "stl.vtk"), {1.5}, 1, 1, distance);

    Report::instance().set_context("quads");
    std::string quads = "OFF\n42 30 0\n";
    for (const Point_3& p : soup.points) quads += std::to_string(p.x()) + " " + std::to_string(p.y()) + " 0\n";
    for (std::size_t j = 0; j < 5; ++j)
      for (std::size_t i = 0; i < 6; ++i)
      {
        quads += "4";
        for (std::size_t v : {7 * j + i, 7 * j + i + 1, 7 * j + i + 8, 7 * j + i + 7}) quads += " " + std::to_string(v);
        quads += "\n";
      }
    write_file(scratch_ / "quads.off", quads);
    run({path("quads.off"), "--source-vertex", "17", "--distance", "1.5", "--output", path("quads.vtk"), "--field",
         path("quads.ply"), "--quiet"});
    check_curves(read_vtk(scratch_ / "quads.vtk"), {1.5}, 1, 1, distance);
    const Field field = read_field(scratch_ / "quads.ply");
    CHECK(field.points.size() == 42);
    Worst_error worst(1e-12, 6);
    for (std::size_t i = 0; i < field.points.size(); ++i) CHECK_CLOSE(worst, field.distances[i], distance(field.points[i]));

    Report::instance().set_context("inconsistent orientation");
    std::vector<std::array<std::size_t, 3>> turned = soup.triangles;
    for (std::size_t i = 0; i < turned.size(); i += 3) std::swap(turned[i][0], turned[i][1]);
    CGAL::IO::write_polygon_soup(path("turned.off"), soup.points, turned);
    const Program_result result =
      run_program(program_, {path("turned.off"), "--source-vertex", "17", "--distance", "1.5", "--output", path("turned.vtk")});
    CHECK_DETAIL(result.exit_code == 0 && !(result.output + result.errors).empty(),
                 result.errors); // the repair is reported
    check_curves(read_vtk(scratch_ / "turned.vtk"), {1.5}, 1, 1, distance);
  }

  void unreachable_vertices()
  {
    Report::instance().set_context("two components and an isolated vertex");
    write_file(scratch_ / "parts.off", "OFF\n7 2 0\n0 0 0\n1 0 0\n0 1 0\n9 9 9\n5 0 0\n6 0 0\n5 1 0\n3 0 1 2\n3 4 5 6\n");
    run({path("parts.off"), "--source-vertex", "1", "--field", path("parts.ply"), "--quiet"});
    const Field field = read_field(scratch_ / "parts.ply");
    const double expected[] = {1, 0, std::sqrt(2.), infinity_, infinity_, infinity_, infinity_};
    if (CHECK(field.distances.size() == 7))
      for (std::size_t i = 0; i < 7; ++i)
        CHECK_DETAIL(field.distances[i] == expected[i] || std::abs(field.distances[i] - expected[i]) < 1e-14,
                     values(field.distances[i], expected[i]));
  }

  static constexpr double infinity_ = std::numeric_limits<double>::infinity();
  std::string program_;
  Scratch_directory scratch_;
};

} // namespace test_program_outputs

GEODESIC_OFFSET_TEST(test_program_outputs)
{
  if (argc != 2 || !std::filesystem::exists(argv[1]))
  {
    std::cerr << "usage: test_program_outputs PROGRAM\n";
    return 2;
  }
  Outputs(argv[1]).run_all();
  return Report::instance().finish("test_program_outputs");
}
