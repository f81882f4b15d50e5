// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Messages of the program: warnings about useless input, limits on computation and output, errors with hints, and the
// progress bar on a terminal.
//
//   test_program_messages PROGRAM

#include "generated_meshes.h"
#include "program_runner.h"
#include "test_check.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace test_program_messages {

using namespace test;

typedef std::vector<std::string> Words;

bool contains(const std::string& text, const std::string& word) { return text.find(word) != std::string::npos; }

double json_number(const std::string& json, const std::string& key)
{
  const std::size_t at = json.find("\"" + key + "\":");
  if (at == std::string::npos) return std::numeric_limits<double>::quiet_NaN();
  return std::strtod(json.c_str() + at + key.size() + 3, nullptr);
}

class Messages
{
public:
  explicit Messages(const std::string& program) : program_(program)
  {
    // 100 x 60 with a hole of 30 x 20 in the middle: all vertices are on the boundary
    write_file(scratch_ / "plate.off", "OFF\n8 8 0\n0 0 0\n100 0 0\n100 60 0\n0 60 0\n"
                                       "35 20 0\n65 20 0\n65 40 0\n35 40 0\n"
                                       "3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n");
    write_file(scratch_ / "plain.off", "OFF\n4 2 0\n0 0 0\n100 0 0\n100 60 0\n0 60 0\n3 0 1 2\n3 0 2 3\n");
    write_file(scratch_ / "square.polylines.txt", "5 10 5 0 30 5 0 30 15 0 10 15 0 10 5 0\n");
    const Soup sphere = icosphere(1), cube = box_sides(2, 2, 2).triangulated(0, 0, 1);
    CGAL::IO::write_polygon_soup(path("sphere.off"), sphere.points, sphere.triangles);
    CGAL::IO::write_polygon_soup(path("cube.off"), cube.points, cube.triangles);
  }

  void run_all()
  {
    moved_points();
    beyond_the_surface();
    sides();
    largest_distance();
    nothing_beyond_the_largest_level();
    levels();
    limits();
    drawings();
    units();
    helpful_errors();
    polygons();
    help_and_version();
    progress_bar();
  }

private:
  static constexpr int usage = 2, input = 1;

  // Largest distance on the plate from its boundary: d from the left side, from the lower side, and from the corner (35,
  // 20) of the hole, so (35 - d)^2 + (20 - d)^2 = d^2.
  static double reach_of_plate() { return 55 - std::sqrt(1400.); }

  std::string path(const std::string& name) const { return (scratch_ / name).string(); }

  static Words lines_of(const std::string& text)
  {
    Words lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  }

  // Checks that a line of the text has all the words.
  static void check_line(const std::string& text, const Words& words)
  {
    const Words lines = lines_of(text);
    CHECK_DETAIL(std::any_of(lines.begin(), lines.end(),
                             [&](const std::string& line) {
                               return std::all_of(words.begin(), words.end(),
                                                  [&](const std::string& w) { return contains(line, w); });
                             }),
                 (words.empty() ? "" : words.front() + " ... ") + "is no line of: " + text);
  }

  Program_result run(const std::string& what, Words arguments)
  {
    Report::instance().set_context(what);
    return run_program(program_, arguments);
  }

  // Expects success without output on standard error.
  Program_result expect_good(const std::string& what, const Words& arguments)
  {
    const Program_result result = run(what, arguments);
    CHECK_DETAIL(result.exit_code == 0 && result.errors.empty(), result.errors);
    return result;
  }

  // Expects success with one warning that has all the words, also with --quiet, which suppresses all else.
  Program_result expect_warning(const std::string& what, Words arguments, const Words& words)
  {
    const Program_result result = run(what, arguments);
    CHECK_DETAIL(result.exit_code == 0, std::to_string(result.exit_code));
    CHECK_DETAIL(lines_of(result.errors).size() == 1 && result.errors.rfind("geodesic_offset: warning: ", 0) == 0,
                 result.errors);
    check_line(result.errors, words);
    arguments.push_back("--quiet");
    const Program_result quiet = run(what + ", quiet", arguments);
    CHECK(quiet.exit_code == 0 && quiet.output.empty() && quiet.errors == result.errors);
    Report::instance().set_context(what);
    return result;
  }

  // Expects one line of errors that has all the words, and no additional file.
  void expect_error(int exit_code, const std::string& what, const Words& arguments, const Words& words)
  {
    const std::set<std::string> before = scratch_.files();
    const Program_result result = run(what, arguments);
    CHECK_DETAIL(result.exit_code == exit_code, "exit code " + std::to_string(result.exit_code));
    CHECK_DETAIL(lines_of(result.errors).size() == 1, result.errors);
    CHECK(!contains(result.errors, "warning"));
    check_line(result.errors, words);
    CHECK(scratch_.files() == before);
  }

  Words on_plate(const Words& more) const
  {
    Words arguments = {path("plate.off")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  Words with_stats(Words arguments)
  {
    arguments.insert(arguments.end(), {"--stats", path("stats.json")});
    return arguments;
  }

  std::string stats() { return read_file(scratch_ / "stats.json"); }

  // Distances with curves, and the sum of the lengths of all curves, from the statistics.
  std::vector<double> levels_of_stats()
  {
    std::vector<double> levels;
    const std::string text = stats();
    const Words parts = lines_of(text.substr((std::min)(text.find("\"curves\""), text.size())));
    for (const std::string& line : parts)
      if (json_number(line, "number") > 0) levels.push_back(json_number(line, "distance"));
    return levels;
  }

  double length_of_stats()
  {
    double length = 0;
    for (const std::string& line : lines_of(stats()))
      if (json_number(line, "number") > 0) length += json_number(line, "length");
    return length;
  }

  void moved_points()
  {
    // the diagonal is 116.6
    const Words level = {"--distance", "5"};
    const auto at_height = [&](const std::string& z) { return on_plate({"--source-point", "20,30," + z, "--distance", "5"}); };
    check_line(expect_good("a point on the surface", at_height("0")).output,
               {"sources", "1 point", "moved to the surface, by at most 0"});
    check_line(expect_good("a point nearly on the surface", at_height("0.5")).output,
               {"sources", "moved to the surface, by at most 0.5"});
    check_line(expect_good("a point 1 % off", at_height("-1.16")).output, {"moved to the surface, by at most 1.16"});
    expect_warning("a point more than 1 % off", at_height("1.17"), {"--source-point 20,30,1.17", "1.17 away", "1 % of"});
    expect_warning("a point far off", at_height("50"), {"--source-point 20,30,50", "50 away", "42.9 % of"});
    expect_warning("a point in a national grid", on_plate({"--source-point", "482453.25,5459623.75,0", "--distance", "5"}),
                   {"--source-point 482453,5459624,0 is"});

    const std::string curve = path("moved.polylines.txt");
    write_file(curve, "# in another unit\n2 10 10 0 20 10 0\n2 10000 10000 0 20000 50000 0\n");
    const Program_result result =
      expect_warning("a curve 1000 times too large", on_plate({"--source-polyline", curve, "--distance", "5"}),
                     {curve, "line 3", "point 1", "times the diagonal", "unit"});
    check_line(result.output, {"sources", "4 points", "moved to the surface, by at most "});
    CHECK(!contains(expect_good("no point to be moved", on_plate({"--source-vertex", "0", "--distance", "5"})).output,
                    "moved"));
  }

  void beyond_the_surface()
  {
    const std::string file = path("out.polylines.txt");
    const auto at = [&](const Words& levels) {
      Words arguments = on_plate({"--source-boundary", "--output", file});
      arguments.insert(arguments.end(), levels.begin(), levels.end());
      return arguments;
    };
    const Program_result nothing =
      expect_warning("a level beyond the surface", at({"--distance", "20"}), {"no offset at distance 20", "17.58"});
    check_line(nothing.output, {"offsets: 0 curves"});
    CHECK(std::filesystem::exists(file) && std::filesystem::file_size(file) == 0);
    expect_warning("one of several levels", at({"--distance", "20", "--distance", "5"}), {"at distance 20", "17.58"});
    expect_warning("several levels", at({"--distance", "5", "--distance", "18", "--distance", "20"}),
                   {"2 distances from 18 on", "17.58"});
    expect_warning("more than there are", at({"--spacing", "5", "--count", "10"}), {"7 distances from 20 on", "17.58"});
    expect_warning("a spacing larger than the surface", at({"--spacing", "20"}), {"at distance 20", "17.58"});
    expect_warning("a start beyond the surface", at({"--spacing", "1", "--start", "18"}), {"at distance 18", "17.58"});
    expect_warning("a level beyond the maximum", at({"--distance", "10", "--maximum-distance", "6"}),
                   {"at distance 10", "--maximum-distance is 6"});
    expect_good("as many as there are", at({"--spacing", "5", "--count", "3"}));
    expect_good("until the surface is covered", at({"--spacing", "5"}));
    // a level within rounding of the largest distance
    char level[64];
    std::snprintf(level, sizeof(level), "%.15g", reach_of_plate() * (1 + 1e-12));
    expect_warning("a level just beyond the surface", at({"--distance", level}), {"no offset", "17.58"});
    std::filesystem::remove(file);
  }

  void sides()
  {
    for (const char* side : {"left", "right", "inside", "outside"})
    {
      const Words effect = {"--side", side, "no effect"};
      const auto with = [&](Words arguments) {
        arguments.insert(arguments.end(), {"--distance", "0.5", "--side", side});
        return arguments;
      };
      expect_warning("boundary", with(on_plate({"--source-boundary"})), effect);
      expect_warning("vertex", with(on_plate({"--source-vertex", "0"})), effect);
      expect_warning("point", with(on_plate({"--source-point", "20,30,0"})), effect);
      expect_warning("sharp edges", with({path("cube.off"), "--source-sharp-edges", "60"}), effect);
      expect_good("closed polyline", with(on_plate({"--source-polyline", path("square.polylines.txt")})));
      expect_good("closed polyline and a point",
                  with(on_plate({"--source-polyline", path("square.polylines.txt"), "--source-vertex", "2"})));
    }
    expect_good("both sides of a point", on_plate({"--source-vertex", "0", "--distance", "0.5", "--side", "both"}));

    // a square of 20 x 10
    const auto square = [&](const std::string& side, const std::string& distance) {
      return on_plate({"--source-polyline", path("square.polylines.txt"), "--side", side, "--distance", distance});
    };
    expect_good("inside", square("inside", "4"));
    expect_warning("inside is empty", square("inside", "6"), {"no offset at distance 6", "--side inside"});

    for (const char* border : {"5 0 0 0 100 0 0 100 60 0 0 60 0 0 0 0\n", "5 0 0 0 0 60 0 100 60 0 100 0 0 0 0 0\n",
                               "5 -1e-5 0 0 100 1e-5 0 99.99999 60 0 1e-5 60.00001 0 -1e-5 0 0\n"})
    {
      write_file(scratch_ / "border.polylines.txt", border);
      const auto offset = [&](const std::string& side) {
        return with_stats({path("plain.off"), "--source-polyline", path("border.polylines.txt"), "--side", side, "--distance",
                           "5"});
      };
      expect_good("inside of the border", offset("inside"));
      CHECK_DETAIL(std::abs(length_of_stats() - 280) < 1e-3, std::to_string(length_of_stats()));
      expect_warning("outside of the border", offset("outside"), {"no offset at distance 5", "--side outside"});
    }
    std::filesystem::remove(scratch_ / "stats.json");
  }

  void largest_distance()
  {
    const Program_result result = expect_good("largest distance", with_stats(on_plate({"--source-boundary"})));
    check_line(result.output, {"distances: up to 17.5834"});
    const double largest = json_number(stats(), "largest_distance");
    CHECK_DETAIL(std::abs(largest - reach_of_plate()) < 1e-12, values(largest, reach_of_plate()));
    CHECK(contains(stats(), "\"covered_distance\": null"));

    write_file(scratch_ / "parts.off", "OFF\n7 2 0\n0 0 0\n1 0 0\n0 1 0\n9 9 9\n5 0 0\n6 0 0\n5 1 0\n3 0 1 2\n3 4 5 6\n");
    const Words unreached = {"1 of 2 parts of the surface has no source", "its 3 vertices are not reached"};
    const Program_result parts = expect_warning("parts", with_stats({path("parts.off"), "--source-vertex", "0"}), unreached);
    check_line(parts.output, {"mesh: 2 parts, 2 border cycles, bounding box from 0,0,0 to 6,1,0"});
    CHECK(json_number(stats(), "parts") == 2 && json_number(stats(), "border_cycles") == 2);
    CHECK(json_number(stats(), "unreached_parts") == 1 && json_number(stats(), "unreached_vertices") == 3);
    CHECK(contains(stats(), "\"bounding_box\": [[0, 0, 0], [6, 1, 0]]"));
    expect_warning("sources on both parts",
                   {path("parts.off"), "--source-vertex", "0", "--source-point", "5.2,0.1,0", "--distance", "5"},
                   {"no offset at distance 5", "no point of the surface is farther"});
    const Program_result beyond =
      run("beyond a part", {path("parts.off"), "--source-vertex", "0", "--distance", "5", "--quiet"});
    check_line(beyond.errors, unreached);
    check_line(beyond.errors,
               {"no offset at distance 5: on the parts of the surface with sources, no point is farther from them than 1"});
    const Program_result path_there =
      run("a path on another part", {path("parts.off"), "--source-vertex", "0", "--path-from", "5.2,0.1,0", "--path-output",
                                     path("paths.vtk"), "--quiet"});
    check_line(path_there.errors, {"no path for --path-from 5.2,0.1,0: it is on another part of the surface than the sources"});
    std::filesystem::remove(scratch_ / "paths.vtk");
    std::filesystem::remove(scratch_ / "stats.json");
    check_line(expect_good("maximum distance", on_plate({"--source-vertex", "0", "--maximum-distance", "30"})).output,
               {"distances: computed up to 30"});
  }

  void nothing_beyond_the_largest_level()
  {
    const Soup soup = jittered_grid(40, 40, 5);
    CGAL::IO::write_polygon_soup(path("grid.off"), soup.points, soup.triangles);
    const auto windows = [&](const std::string& what, Words more) {
      Words arguments = {path("grid.off"), "--source-vertex", "0", "--distance", "2", "--distance", "4"};
      arguments.insert(arguments.end(), more.begin(), more.end());
      const Program_result result = expect_good(what, with_stats(arguments));
      check_line(result.output, {"offsets: 2 curves at 2 distances"});
      return json_number(stats(), "windows_propagated");
    };
    const double all = windows("with a field", {"--field", path("grid.ply")});
    CHECK(json_number(stats(), "largest_distance") > 56 && contains(stats(), "\"covered_distance\": null"));
    CHECK(windows("with a picture", {"--picture", path("grid.png")}) == all);
    const double few = windows("with curves alone", {"--output", path("grid.vtk")});
    CHECK_DETAIL(few < all / 20, values(few, all));
    CHECK(json_number(stats(), "largest_distance") == 4 && json_number(stats(), "covered_distance") == 4);

    // the right side of a segment ends at the border, far before the left one
    write_file(scratch_ / "segment.polylines.txt", "2 5 2 0 35 2 0\n");
    const Words right = {path("grid.off"), "--source-polyline", path("segment.polylines.txt"), "--side", "right"};
    const auto family = [&](const std::string& what, Words more) {
      more.insert(more.begin(), right.begin(), right.end());
      check_line(expect_good(what, with_stats(more)).output, {"offsets: 3 curves at 3 distances"});
      return json_number(stats(), "windows_propagated");
    };
    const double both = family("one side and a field", {"--spacing", "0.6", "--field", path("grid.ply")});
    const double one = family("one side", {"--spacing", "0.6"});
    CHECK_DETAIL(one < both / 5, values(one, both));
    Words far = right;
    far.insert(far.end(), {"--distance", "1.2,30"});
    expect_warning("one side, too far", with_stats(far), {"no offset at distance 30 with --side right"});
    for (const char* name : {"grid.ply", "grid.png", "grid.vtk", "stats.json"}) std::filesystem::remove(scratch_ / name);
  }

  void levels()
  {
    const auto levels = [&](const std::string& what, Words options, const std::vector<double>& expected) {
      Words arguments = on_plate({"--source-boundary"});
      arguments.insert(arguments.end(), options.begin(), options.end());
      const Program_result result = expect_good(what, with_stats(arguments));
      const std::vector<double> actual = levels_of_stats();
      bool is_same = actual.size() == expected.size();
      for (std::size_t i = 0; is_same && i < actual.size(); ++i) is_same = std::abs(actual[i] - expected[i]) < 1e-12;
      CHECK_DETAIL(is_same, std::to_string(actual.size()) + " levels");
      return result.output;
    };
    levels("a spacing", {"--spacing", "5"}, {5, 10, 15});
    levels("a spacing and a start", {"--spacing", "5", "--start", "2"}, {2, 7, 12, 17});
    levels("a start and a count", {"--spacing", "5", "--start", "2", "--count", "2"}, {2, 7});
    levels("distances and a spacing", {"--distance", "2.5", "--spacing", "5", "--distance", "1", "--distance", "10"},
           {1, 2.5, 5, 10, 15});
    levels("distances in one word", {"--distance", "1,2.5", "--distance", "4"}, {1, 2.5, 4});
    check_line(expect_good("offsets without a file", on_plate({"--source-boundary", "--spacing", "5"})).output,
               {"offsets: in no file"});
    levels("distances and a count", {"--distance", "16", "--spacing", "5", "--count", "1"}, {5, 16});
    check_line(levels("a number of distances", {"--distance", "1", "--distance", "2"}, {1, 2}), {"offsets: at 2 distances"});
    check_line(levels("a largest number", {"--spacing", "5"}, {5, 10, 15}), {"offsets: at no more than", "distances"});
    // more than ten thousand levels up to a bound that is three times too large, but not up to the largest distance
    const std::string output =
      levels("a spacing that is small enough", {"--spacing", "0.005", "--maximum-distance", "0.0125"}, {0.005, 0.01});
    check_line(output, {"no more than 2 distances"});
    const Program_result many = expect_good("thousands", on_plate({"--source-boundary", "--spacing", "0.005"}));
    check_line(many.output, {"offsets: at no more than 3516 distances"});
    std::filesystem::remove(scratch_ / "stats.json");
  }

  void limits()
  {
    const std::string file = path("out.vtk");
    const auto expect_limit = [&](const std::string& what, Words options, const Words& words) {
      Words arguments = on_plate({"--source-boundary", "--output", file, "--picture", path("out.png")});
      arguments.insert(arguments.end(), options.begin(), options.end());
      expect_error(usage, what, arguments, words);
    };
    expect_limit("too many distances", {"--spacing", "1e-5"}, {"--spacing 1e-05", "1758342 offsets", "--count"});
    expect_limit("too many distances by a count", {"--spacing", "1e-5", "--count", "1000000000000"},
                 {"--count 1000000000000", "1000000"});
    for (const char* count : {"5", "1"})
      expect_limit("spacing below rounding", {"--spacing", "1e-300", "--count", count}, {"--spacing 1e-300", "rounding"});
    expect_limit("start below rounding", {"--spacing", "1", "--start", "1e-300"}, {"--start 1e-300", "rounding"});
    expect_limit("distance below rounding", {"--distance", "1e-300"}, {"--distance 1e-300", "rounding"});
    expect_limit("tolerance below rounding", {"--distance", "5", "--tolerance", "1e-300"}, {"--tolerance 1e-300", "rounding"});
    const Words fine = {"--tolerance", "1.1e-10", "--spacing", "0.05"};
    expect_limit("too many points", fine, {"20000000 points", "--tolerance"});
    Words figures = with_stats(on_plate({"--source-boundary"}));
    figures.insert(figures.end(), fine.begin(), fine.end());
    expect_good("as many points, which no output needs", figures);
    for (const char* threads : {"1000000000", "1025", "18446744073709551615"})
    {
      const Program_result result =
        run("threads", on_plate({"--source-boundary", "--distance", "5", "--threads", threads, "--output", file}));
      CHECK(result.exit_code == usage && lines_of(result.errors).size() == 1 && !std::filesystem::exists(file));
      CHECK_DETAIL(contains(result.errors, threads) &&
                     (contains(result.errors, "1024") || contains(result.errors, "without TBB")),
                   result.errors);
    }
    expect_limit("a start alone", {"--distance", "1", "--start", "2"}, {"--start needs --spacing"});
    expect_limit("a count alone", {"--distance", "1", "--count", "2"}, {"--count needs --spacing"});
  }

  void drawings()
  {
    const std::string drawing = path("out.svg"), curves = path("out.vtk"), figures = path("stats.json");
    const auto clean = [&] {
      for (const std::string& file : {drawing, curves, figures}) std::filesystem::remove(file);
    };
    expect_error(input, "a curved mesh, before the work",
                 {path("sphere.off"), "--source-vertex", "0", "--distance", "0.5", "--output", drawing, "--output", curves},
                 {drawing, "plane"});
    const Program_result early =
      run("a curved mesh", {path("sphere.off"), "--source-vertex", "0", "--distance", "0.5", "--output", drawing});
    CHECK(!contains(early.output, "distances"));

    const Words on_cube = {path("cube.off"), "--source-point", "1,1,2"}; // in the middle of the upper side
    const auto with = [](Words arguments, const Words& more) {
      arguments.insert(arguments.end(), more.begin(), more.end());
      return arguments;
    };
    expect_good("curves in one plane of a cube", with(on_cube, {"--distance", "0.5", "--output", drawing}));
    CHECK(contains(read_file(drawing), "</svg>"));
    clean();
    // the second distance leaves the upper side
    const Words leaving = with(on_cube, {"--distance", "0.5", "--distance", "1.25", "--output", drawing});
    expect_error(input, "curves in two planes, nothing else to write", leaving, {drawing, "plane", "distance 1.25"});
    const Program_result others = run("curves in two planes", with(leaving, {"--output", curves, "--stats", figures}));
    CHECK(others.exit_code == input && lines_of(others.errors).size() == 1);
    check_line(others.errors, {drawing, "plane"});
    check_line(others.output, {"wrote " + curves});
    CHECK(!contains(others.output, "wrote " + drawing));
    CHECK(!std::filesystem::exists(drawing) && contains(read_file(curves), "LINES 2 ") &&
          json_number(read_file(figures), "vertices") == 8);
    for (const std::string& file : scratch_.files()) CHECK_DETAIL(!contains(file, ".part"), file);
    clean();
  }

  void units()
  {
    const std::string dxf = path("out.dxf"), svg = path("out.svg");
    const auto with_unit = [&](const Words& unit) {
      Words arguments = on_plate({"--source-boundary", "--distance", "5", "--output", dxf, "--output", svg});
      arguments.insert(arguments.end(), unit.begin(), unit.end());
      expect_good(unit.empty() ? "no unit" : unit.back(), arguments);
    };
    const auto insunits = [&] {
      const std::string text = read_file(dxf);
      const std::size_t at = text.find("$INSUNITS\n70\n");
      return at == std::string::npos ? -1 : std::atoi(text.c_str() + at + 13);
    };
    // the offset at 5 is 90 wide and 50 high; the margin is 2 % of the diagonal
    const double margin = 0.02 * std::hypot(90, 50);
    const std::pair<const char*, int> units[] = {{"in", 1}, {"mm", 4}, {"cm", 5}, {"m", 6}};
    for (const auto& unit : units)
    {
      with_unit({"--unit", unit.first});
      CHECK_DETAIL(insunits() == unit.second, std::to_string(insunits()));
      const std::string text = read_file(svg);
      const bool meters = std::string(unit.first) == "m"; // not in the format
      for (const auto& attribute : {std::make_pair(" width=\"", 90), std::make_pair(" height=\"", 50)})
      {
        const std::size_t at = text.find(attribute.first);
        if (!CHECK(at != std::string::npos)) continue;
        char* end = nullptr;
        const double value = std::strtod(text.c_str() + at + std::strlen(attribute.first), &end);
        const double expected = (attribute.second + 2 * margin) * (meters ? 1000 : 1);
        CHECK_DETAIL(std::abs(value - expected) < 1e-9 * expected, values(value, expected));
        const std::string suffix = std::string(meters ? "mm" : unit.first) + "\"";
        CHECK_DETAIL(std::string(end).compare(0, suffix.size(), suffix) == 0, std::string(end).substr(0, 10));
      }
    }
    with_unit({});
    CHECK(insunits() == 0 && !contains(read_file(svg), " width="));
    std::filesystem::remove(dxf);
    std::filesystem::remove(svg);
    for (const char* unit : {"", "MM", "km", "mm,cm", "1"})
      expect_error(usage, std::string("unit ") + unit,
                   on_plate({"--source-boundary", "--distance", "5", "--output", dxf, std::string("--unit=") + unit}),
                   {"--unit"});
    expect_error(usage, "a unit for a file without one",
                 on_plate({"--source-boundary", "--distance", "5", "--output", path("out.vtk"), "--unit", "mm"}),
                 {"--unit", ".dxf", ".svg"});
  }

  void helpful_errors()
  {
    const std::string curve = path("curve.polylines.txt");
    const Words source = on_plate({"--source-polyline", curve, "--distance", "5"});
    for (const char* points :
         {"0 10 0\n50 30 0\n100 50 0\n", "1 2 3\n4 5 6\n", "0.5 0.25 0.125\n1 1 1\n", "10,10,0\n20,10,0\n"})
    {
      write_file(curve, points);
      expect_error(input, "one point per line", source, {curve, "line 1", "number of its points", "'2  0 0 0  1 0 0.5'"});
    }
    write_file(curve, "2  0 10 0  1 0 0.5\n");
    CHECK(run("the example of the message", source).exit_code == 0);
    std::filesystem::remove(curve);

    const std::string hint = "--source-plane 0,0,1,0";
    expect_error(usage, "blanks for commas", on_plate({"--source-plane", "0", "0", "1", "0", "--distance", "5"}),
                 {"commas", hint});
    expect_error(usage, "blanks for commas and a minus", on_plate({"--source-plane", "0", "0", "1", "-5", "--distance", "5"}),
                 {"commas", hint});
    expect_error(usage, "blanks after commas", on_plate({"--source-point", "1,", "2,", "3", "--distance", "5"}), {"commas"});
    expect_error(usage, "one number", on_plate({"--source-plane", "1", "--distance", "5"}),
                 {"--source-plane", "4 finite numbers", "commas"});
  }

  void polygons()
  {
    const auto distances = [&](const std::string& what, const std::string& mesh, const Words& note, const Words& warning = {}) {
      write_file(scratch_ / "polygons.off", mesh);
      const std::string field = path("field.ply");
      const Words arguments = {path("polygons.off"), "--source-vertex", "0", "--distance", "0.25", "--field", field};
      const Program_result result = warning.empty() ? expect_good(what, arguments) : expect_warning(what, arguments, warning);
      if (note.empty()) CHECK_DETAIL(!contains(result.output, "not planar"), result.output);
      else check_line(result.output, note);
      const std::string bytes = read_file(field);
      std::filesystem::remove(field);
      const std::size_t begin = bytes.find("end_header\n") + 11;
      std::vector<double> result_distances;
      const std::size_t n = static_cast<std::size_t>(std::atoi(mesh.c_str() + 4));
      for (std::size_t i = 0; i < n && CHECK(begin + 32 * (i + 1) <= bytes.size()); ++i)
      {
        double d = 0;
        std::memcpy(&d, bytes.data() + begin + 32 * i + 24, sizeof(d));
        result_distances.push_back(d);
      }
      return result_distances;
    };
    const auto all_reached = [](const std::vector<double>& distances) {
      for (const double d : distances) CHECK(std::isfinite(d));
    };
    const Words note = {"not planar or not simple", "face 0"};
    all_reached(distances("a star", "OFF\n5 1 0\n0 3 0\n3 1 0\n2 -3 0\n-2 -3 0\n-3 1 0\n5 0 2 4 1 3\n", note));
    all_reached(distances("far from planar", "OFF\n6 1 0\n0 0 0\n1 0 0\n0 0 1\n1 1 1\n0 1 0\n1 1 0\n6 0 1 2 3 4 5\n", note));
    all_reached(distances("a bow tie", "OFF\n4 1 0\n0 0 0\n2 0 0\n2 1 0\n0 1 0\n4 0 2 1 3\n", note));
    // two triangles that meet in the corner
    all_reached(distances("an edge through a corner", "OFF\n5 1 0\n0 0 0\n4 0 0\n4 2 0\n2 0 0\n0 2 0\n5 0 1 2 3 4\n", note,
                          {"1 vertex is shared by fans of faces", "the first is vertex 3"}));
    // around the hole, by (2, 1) or by (1, 2)
    const std::vector<double> around =
      distances("a square with a hole, as one polygon",
                "OFF\n8 1 0\n0 0 0\n3 0 0\n3 3 0\n0 3 0\n1 1 0\n1 2 0\n2 2 0\n2 1 0\n10 0 1 2 3 0 4 5 6 7 4\n", note);
    all_reached(around);
    if (CHECK(around.size() == 8))
      CHECK_DETAIL(std::abs(around[6] - (std::sqrt(5.) + 1)) < 1e-14, values(around[6], std::sqrt(5.) + 1));
    // below and above the size limit of the best triangulation
    for (const int n : {299, 401, 2001})
    {
      std::string star = "OFF\n" + std::to_string(n) + " 1 0\n", order = std::to_string(n);
      for (int i = 0; i < n; ++i)
      {
        const double angle = 2 * CGAL_PI * i / n;
        star += std::to_string(100 * std::cos(angle)) + " " + std::to_string(100 * std::sin(angle)) + " 0\n";
        order += " " + std::to_string(2LL * i % n);
      }
      all_reached(distances("a star with " + std::to_string(n) + " points", star + order + "\n", note));
    }
    // valid polygons: concave, with a straight angle, slightly bent
    all_reached(distances("an arrow", "OFF\n4 1 0\n0 0 0\n2 1 0\n0 2 0\n1 1 0\n4 0 1 2 3\n", {}));
    all_reached(distances("a straight angle", "OFF\n5 1 0\n0 0 0\n1 0 0\n2 0 0\n2 1 0\n0 1 0\n5 0 1 2 3 4\n", {}));
    all_reached(distances("a little bent", "OFF\n5 1 0\n0 0 0\n1 0 0.1\n2 0 0\n2 1 0.1\n0 1 0\n5 0 1 2 3 4\n", {}));
    std::filesystem::remove(scratch_ / "polygons.off");
  }

  void help_and_version()
  {
    const Program_result help = expect_good("help", {"--help"});
    for (const char* option :
         {"--source-vertex",
          "--source-point",
          "--source-polyline",
          "--source-plane",
          "--source-boundary",
          "--source-sharp-edges",
          "--section-near",
          "--boundary-near",
          "--sharp-edges-near",
          "--start-value",
          "--project",
          "--distance",
          "--spacing",
          "--start",
          "--count",
          "--maximum-distance",
          "--relative-tolerance",
          "--merging-tolerance",
          "--side",
          "--end",
          "--path-from",
          "--path-from-vertex",
          "--path-output",
          "--farthest-point",
          "--tolerance",
          "--output",
          "--unit",
          "--field",
          "--field-details",
          "--split",
          "--voronoi",
          "--picture",
          "--view",
          "--up",
          "--stats",
          "--no-stitch",
          "--threads",
          "--quiet",
          "--version"})
      CHECK_DETAIL(contains(help.output, option), option);
    check_line(help.output, {"2  0 0 0  1 0 0.5"}); // format of polylines
    CHECK(contains(help.output, "one polyline per line"));
    const Program_result version = expect_good("version", {"--version"});
    const Words lines = lines_of(version.output);
    CHECK(lines.size() == 1 && lines[0].rfind("geodesic_offset ", 0) == 0 && std::isdigit(lines[0][16]) &&
          contains(lines[0], "CGAL"));
  }

  void progress_bar()
  {
    const Soup soup = jittered_grid(60, 60, 5);
    CGAL::IO::write_polygon_soup(path("grid.off"), soup.points, soup.triangles);
    const Words arguments = {path("grid.off"), "--source-vertex", "0",       "--spacing",     "10",
                             "--output",       path("out.vtk"),   "--field", path("out.ply"), "--picture",
                             path("out.png")};
    Report::instance().set_context("on a terminal");
    const Program_result shown = run_program_on_terminal(program_, arguments);
    CHECK(shown.exit_code == 0);
    for (const char* step : {"\rreading '", "\rdistances and offsets [", "#", " % ", "cut", "\rwriting '", "\rpicture ["})
      CHECK_DETAIL(contains(shown.errors, step), step);
    // the bar is erased at the end
    const std::string last = shown.errors.substr(shown.errors.rfind('\r', shown.errors.size() - 2));
    CHECK_DETAIL(last.find_first_not_of("\r ") == std::string::npos, last);
    Words quiet = arguments;
    quiet.push_back("--quiet");
    const Program_result silent = run_program_on_terminal(program_, quiet);
    CHECK_DETAIL(silent.exit_code == 0 && silent.errors.empty() && silent.output.empty(), silent.errors);
    const Program_result piped = expect_good("in a pipe", arguments);
    CHECK(!contains(piped.output, "\r") && piped.output.size() > 100);
    CHECK(contains(shown.output, "offsets: ") && !contains(shown.output, "\r"));
    for (const char* name : {"grid.off", "out.vtk", "out.ply", "out.png"}) std::filesystem::remove(scratch_ / name);
  }

  std::string program_;
  Scratch_directory scratch_;
};

} // namespace test_program_messages

GEODESIC_OFFSET_TEST(test_program_messages)
{
  if (argc != 2 || !std::filesystem::exists(argv[1]))
  {
    std::cerr << "usage: test_program_messages PROGRAM\n";
    return 2;
  }
  Messages(argv[1]).run_all();
  return Report::instance().finish("test_program_messages");
}
