// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The program on bad input: exit code 2 for wrong usage and 1 for bad files, exactly one line of errors, no remaining file.
//
//   test_program_bad_input PROGRAM

#include "generated_meshes.h"
#include "program_runner.h"
#include "test_check.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <string>
#include <vector>

namespace test_program_bad_input {

using namespace test;

typedef std::vector<std::string> Arguments;

class Bad_input
{
public:
  explicit Bad_input(const std::string& program) : program_(program), good_((scratch_ / "good.off").string())
  {
    const Soup soup = icosphere(1);
    CGAL::IO::write_polygon_soup(good_, soup.points, soup.triangles);
    for (const char* format : {"off", "obj", "ply", "stl"})
    {
      const auto file = scratch_ / (std::string("whole.") + format);
      CGAL::IO::write_polygon_soup(file.string(), soup.points, soup.triangles);
      whole_.push_back(file);
    }
  }

  void run_all()
  {
    sanity();
    wrong_usage();
    bad_files();
    bad_values();
  }

private:
  static constexpr int usage = 2, input = 1;

  // Requests every kind of output, so that a partial file would be seen.
  Arguments with_outputs(Arguments arguments) const
  {
    const std::pair<const char*, const char*> outputs[] = {
      {"--output", "out.polylines.txt"}, {"--output", "out.vtk"},  {"--output", "out.obj"},  {"--output", "out.dxf"},
      {"--field", "field.ply"},          {"--picture", "out.png"}, {"--stats", "stats.json"}};
    for (const auto& output : outputs)
    {
      arguments.push_back(output.first);
      arguments.push_back((scratch_ / output.second).string());
    }
    return arguments;
  }

  // Expects an exit code, one line of errors with all the given words, and unchanged files.
  void expect(int exit_code, const std::string& what, const Arguments& arguments, bool add_outputs = true,
              const Arguments& words = {})
  {
    Report::instance().set_context(what);
    const std::set<std::string> before = scratch_.files();
    const Program_result result = run_program(program_, add_outputs ? with_outputs(arguments) : arguments);
    CHECK_DETAIL(result.exit_code == exit_code, "exit code " + std::to_string(result.exit_code));
    const std::size_t lines = static_cast<std::size_t>(std::count(result.errors.begin(), result.errors.end(), '\n'));
    CHECK_DETAIL(lines == 1 && result.errors.size() > 10 && result.errors.back() == '\n', result.errors);
    for (const std::string& word : words)
      CHECK_DETAIL(result.errors.find(word) != std::string::npos, word + " is not in: " + result.errors);
    CHECK(scratch_.files() == before);
    for (const std::string& file : scratch_.files())
      if (before.count(file) == 0) std::filesystem::remove(file);
    std::cout << what << ": " << result.errors << std::flush;
  }

  // Good input with the same arguments succeeds, so the failures below have the intended reasons.
  void sanity()
  {
    Report::instance().set_context("good input");
    const Program_result result =
      run_program(program_, with_outputs({good_, "--source-vertex", "0", "--distance", "0.5", "--quiet"}));
    CHECK_DETAIL(result.exit_code == 0, result.errors);
    CHECK(result.errors.empty());
    for (const char* file : {"out.polylines.txt", "out.vtk", "out.obj", "out.dxf", "field.ply", "out.png", "stats.json"})
    {
      CHECK_DETAIL(std::filesystem::exists(scratch_ / file) && std::filesystem::file_size(scratch_ / file) > 0, file);
      std::filesystem::remove(scratch_ / file);
    }
  }

  void wrong_usage()
  {
    expect(usage, "no arguments", {}, false);
    expect(usage, "no mesh", {"--source-vertex", "0", "--distance", "1"});
    expect(usage, "two meshes", {good_, good_, "--source-vertex", "0", "--distance", "1"});
    expect(usage, "no source", {good_, "--distance", "1"});
    expect(usage, "no levels for the output", {good_, "--source-vertex", "0"});
    expect(usage, "unknown option", {good_, "--source-vertex", "0", "--distance", "1", "--unknown", "3"});
    expect(usage, "unknown flag", {good_, "--source-vertex", "0", "--distance", "1", "--sources"});
    expect(usage, "abbreviated option", {good_, "--source-vert", "0", "--distance", "1"});
    expect(usage, "option without its value", {good_, "--source-vertex", "0", "--distance", "1", "--spacing"}, false);
    for (const char* distance : {"0", "-1", "+-1", "++1", "nan", "NaN", "inf", "abc", "", "1x", "1,", "1,x", "-0", "1e999"})
      for (const char* option : {"--distance", "--spacing", "--maximum-distance", "--tolerance"})
      {
        Arguments arguments = {good_, "--source-vertex", "0", std::string(option) + "=" + distance};
        if (std::string(option) == "--maximum-distance" || std::string(option) == "--tolerance")
          arguments.insert(arguments.end(), {"--distance", "0.5"});
        expect(usage, std::string(option) + " '" + distance + "'", arguments);
      }
    for (const char* count : {"0", "-1", "1.5", "x"})
      expect(usage, std::string("count '") + count + "'",
             {good_, "--source-vertex", "0", "--spacing", "0.1", std::string("--count=") + count});
    for (const char* number : {"0", "-1", "1.5", "many", ""})
      expect(usage, std::string("threads ") + number, {good_, "--source-vertex", "0", std::string("--threads=") + number});
    for (const char* index : {"-1", "x", "1.5", "nan", "", "99999999999999999999999"})
      expect(usage, std::string("source vertex '") + index + "'",
             {good_, std::string("--source-vertex=") + index, "--distance", "1"});
    for (const char* point : {"nan,0,0", "0,0", "0,0,0,0", "a,b,c", "inf,0,0", ""})
      expect(usage, std::string("source point '") + point + "'",
             {good_, std::string("--source-point=") + point, "--distance", "1"});
    for (const char* plane : {"nan,0,1,0", "0,0,0,1", "0,0,1", "0,0,1,0,0", "x,0,1,0"})
      expect(usage, std::string("source plane '") + plane + "'",
             {good_, std::string("--source-plane=") + plane, "--distance", "1"});
    for (const char* angle : {"nan", "-5", "270", "x"})
      expect(usage, std::string("sharp edges '") + angle + "'",
             {good_, std::string("--source-sharp-edges=") + angle, "--distance", "1"});
    for (const char* side : {"", "Left", "middle", "left,right", "1"})
      expect(usage, std::string("side '") + side + "'",
             {good_, "--source-vertex", "0", "--distance", "1", std::string("--side=") + side});
    for (const char* end : {"", "square", "BUTT", "0"})
      expect(usage, std::string("end '") + end + "'",
             {good_, "--source-vertex", "0", "--distance", "1", std::string("--end=") + end});
    const Arguments field = {"--field", (scratch_ / "field.ply").string()};
    for (const char* option : {"--side=left", "--end=butt"})
      expect(usage, std::string(option) + " without levels", {good_, "--source-vertex", "0", option, field[0], field[1]},
             false);
    expect(usage, "two sides", {good_, "--source-vertex", "0", "--distance", "1", "--side", "left", "--side", "right"});
    for (const char* output : {"out.xyz", "out", ".vtk.gz", "out.dxf.txt"})
      expect(usage, std::string("output '") + output + "'",
             {good_, "--source-vertex", "0", "--distance", "1", "--output", (scratch_ / output).string()});
    expect(usage, "field of a wrong type",
           {good_, "--source-vertex", "0", "--distance", "1", "--field", (scratch_ / "field.off").string()}, false);
    expect(usage, "picture of a wrong type",
           {good_, "--source-vertex", "0", "--distance", "1", "--picture", (scratch_ / "picture.jpg").string()}, false);
  }

  void expect_bad_mesh(const std::string& what, const std::string& file)
  {
    expect(input, what, {file, "--source-vertex", "0", "--distance", "0.5"});
  }

  void bad_files()
  {
    expect_bad_mesh("missing file", (scratch_ / "missing.off").string());
    std::filesystem::create_directory(scratch_ / "directory.off");
    expect_bad_mesh("a directory", (scratch_ / "directory.off").string());
    write_file(scratch_ / "mesh.xyz", read_file(good_));
    expect_bad_mesh("unknown format", (scratch_ / "mesh.xyz").string());

    Random random(1);
    for (const std::filesystem::path& whole : whole_)
    {
      const std::string format = whole.extension().string(), bytes = read_file(whole);
      CHECK(run_program(program_, {whole.string(), "--source-vertex", "0", "--distance", "0.5", "--stats",
                                   (scratch_ / "ignored.json").string(), "--quiet"})
              .exit_code == 0);
      std::filesystem::remove(scratch_ / "ignored.json");
      const auto bad = scratch_ / ("bad" + format);
      write_file(bad, "");
      expect_bad_mesh("empty" + format, bad.string());
      write_file(bad, "\n");
      expect_bad_mesh("an empty line in" + format, bad.string());
      for (double part : {0.003, 0.1, 0.5, 0.9})
      {
        // Cut within a line: an .obj file cut between lines is a complete file.
        std::size_t size = static_cast<std::size_t>(part * static_cast<double>(bytes.size()));
        while (size > 1 && (bytes[size - 1] == '\n' || bytes[size] == '\n' || bytes[size - 1] == ' ')) --size;
        write_file(bad, bytes.substr(0, size));
        if (format != ".obj") expect_bad_mesh("truncated after " + std::to_string(part) + format, bad.string());
      }
      for (std::size_t size : {7, 300, 20000})
      {
        std::string noise(size, ' ');
        for (char& c : noise) c = static_cast<char>(uniform_index(random, 256));
        write_file(bad, noise);
        expect_bad_mesh("random bytes" + format, bad.string());
      }
      std::string header = bytes.substr(0, bytes.find('\n') + 1);
      for (std::size_t i = 0; i < 1000; ++i) header += static_cast<char>(uniform_index(random, 256));
      write_file(bad, header);
      expect_bad_mesh("random bytes after the first line" + format, bad.string());
      std::filesystem::remove(bad);
    }

    const auto bad = scratch_ / "bad.off";
    const std::pair<const char*, const char*> off_files[] = {
      {"no faces", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"},
      {"no vertices", "OFF\n0 0 0\n"},
      {"NaN coordinate", "OFF\n3 1 0\n0 0 0\nnan 0 0\n0 1 0\n3 0 1 2\n"},
      {"infinite coordinate", "OFF\n3 1 0\n0 0 0\ninf 0 0\n0 1 0\n3 0 1 2\n"},
      {"face with a vertex out of range", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"},
      {"face with a negative vertex", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -2\n"},
      {"fewer vertices than announced", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n"},
      {"absurd counts", "OFF\n4000000000 4000000000 0\n0 0 0\n"},
      {"text for a coordinate", "OFF\n3 1 0\n0 0 0\none 0 0\n0 1 0\n3 0 1 2\n"},
      {"only collapsed faces", "OFF\n3 1 0\n0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n"},
      {"only collinear faces", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n"}};
    for (const auto& file : off_files)
    {
      write_file(bad, file.second);
      expect_bad_mesh(file.first, bad.string());
    }
    write_file(scratch_ / "bad.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n");
    expect_bad_mesh("NaN coordinate in .obj", (scratch_ / "bad.obj").string());
    write_file(scratch_ / "bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    expect_bad_mesh("vertex out of range in .obj", (scratch_ / "bad.obj").string());
  }

  void bad_values()
  {
    const Arguments level = {"--distance", "0.5"};
    const auto with_source = [&](const std::string& option, const std::string& value) {
      return Arguments{good_, option + "=" + value, "--distance", "0.5"};
    };
    expect(input, "vertex index out of range", with_source("--source-vertex", "42"));
    expect(input, "vertex index far out of range", with_source("--source-vertex", "4294967296"));
    expect(input, "plane that misses the mesh", with_source("--source-plane", "0,0,1,-5"));
    expect(input, "no boundary", {good_, "--source-boundary", "--distance", "0.5"});
    expect(input, "no sharp edges", with_source("--source-sharp-edges", "120"));

    expect(input, "source point beyond all numbers", with_source("--source-point", "1e300,0,0"), true,
           {"--source-point 1e+300,0,0", "too far"});
    const auto polyline = scratch_ / "curve.polylines.txt";
    write_file(polyline, "1 0 0 1\n3 0 0 1 1 0 0 0 1e200 0\n");
    expect(input, "polyline beyond all numbers", with_source("--source-polyline", polyline.string()), true,
           {polyline.string(), "line 2", "point 2", "too far"});
    std::filesystem::remove(polyline);
    expect(input, "missing polyline", with_source("--source-polyline", polyline.string()));
    const std::pair<const char*, const char*> polylines[] = {
      {"empty polyline file", ""},
      {"polyline of no points", "0\n"},
      {"truncated polyline", "3 0 0 1 0 1 0 1 0"},
      {"NaN in a polyline", "2 0 0 1 nan 1 0\n"},
      {"text in a polyline", "2 0 0 1 a b c\n"},
      {"polyline of -2 points", "-2 0 0 1 0 1 0\n"}};
    for (const auto& file : polylines)
    {
      write_file(polyline, file.second);
      expect(input, file.first, with_source("--source-polyline", polyline.string()));
    }
    std::string noise = "7";
    Random random(2);
    for (std::size_t i = 0; i < 500; ++i) noise += static_cast<char>(uniform_index(random, 256));
    write_file(polyline, noise);
    expect(input, "random bytes in a polyline", with_source("--source-polyline", polyline.string()));

    sides_and_planes();

    expect(input, "output in a missing directory",
           {good_, "--source-vertex", "0", "--distance", "0.5", "--output", (scratch_ / "missing/out.vtk").string()});
  }

  void sides_and_planes()
  {
    const std::string curve = (scratch_ / "side.polylines.txt").string();
    write_file(curve, "\n2 0 0 1 1 0 0\n");
    for (const char* side : {"inside", "outside"})
      expect(input, std::string("an open polyline and the side ") + side,
             {good_, "--source-polyline", curve, "--distance", "0.5", "--side", side}, true, {curve, "line 2", "open"});
    // around the hole of a torus there is no inside; the message says which curve is affected
    const Soup torus = test::torus(24, 12);
    const std::string ring = (scratch_ / "torus.off").string();
    CGAL::IO::write_polygon_soup(ring, torus.points, torus.triangles);
    std::string around = "49";
    for (int i = 0; i <= 48; ++i)
    {
      const double angle = (i % 48) * CGAL_PI / 24;
      around += " " + std::to_string(1.4 * std::cos(angle)) + " " + std::to_string(1.4 * std::sin(angle)) + " 0";
    }
    write_file(curve, "4 1.34 0 0.2 1.33 0.2 0.2 1.2 0.1 0.33 1.34 0 0.2\n" + around + "\n");
    expect(input, "a closed polyline without an inside",
           {ring, "--source-polyline", curve, "--distance", "0.1", "--side", "inside"}, true, {curve, "line 2", "inside"});
    std::filesystem::remove(curve);
    std::filesystem::remove(ring);

    const std::string drawing = (scratch_ / "out.svg").string();
    expect(input, "a drawing of a mesh that is not planar",
           {good_, "--source-vertex", "0", "--distance", "0.5", "--output", drawing}, true, {drawing, "plane"});
    expect(usage, "a drawing without levels", {good_, "--source-vertex", "0", "--output", drawing});
  }

  std::string program_;
  Scratch_directory scratch_;
  std::string good_;
  std::vector<std::filesystem::path> whole_;
};

} // namespace test_program_bad_input

GEODESIC_OFFSET_TEST(test_program_bad_input)
{
  if (argc != 2 || !std::filesystem::exists(argv[1]))
  {
    std::cerr << "usage: test_program_bad_input PROGRAM\n";
    return 2;
  }
  Bad_input(argv[1]).run_all();
  return Report::instance().finish("test_program_bad_input");
}
