// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The program validate_geodesic_distances on bad input: exit code 2 for wrong usage and 1 for bad files, exactly one line
// of errors that names the fault, and no remaining file.
//
//   test_program_validation_bad_input VALIDATE_GEODESIC_DISTANCES GEODESIC_OFFSET

#include "generated_meshes.h"
#include "program_runner.h"
#include "test_check.h"
#include "validation_files.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_program_validation_bad_input {

using namespace test;

typedef std::vector<std::string> Arguments;

class Bad_input
{
public:
  Bad_input(const std::string& program, const std::string& geodesic_offset)
    : program_(program), soup_(icosphere(1)), mesh_((scratch_ / "good.off").string()), table_((scratch_ / "good.txt").string()),
      rows_((scratch_ / "rows.txt").string())
  {
    write_off(mesh_, soup_);
    // true distances, so that only the intended errors are wrong
    const std::string field = (scratch_ / "field.ply").string();
    CHECK(run_program(geodesic_offset, {mesh_, "--source-vertex", "0", "--field", field, "--quiet"}).exit_code == 0);
    CHECK(run_program(program_, on(field)).exit_code == 0);
    std::istringstream in(read_file(rows_));
    std::string line;
    std::getline(in, line);
    for (std::string vertex, lower, upper, distance, error; in >> vertex >> lower >> upper >> distance >> error;)
      distances_.push_back(std::strtod(distance.c_str(), nullptr));
    CHECK(distances_.size() == soup_.points.size());
    std::filesystem::remove(rows_);
    write_file(table_, column_table(distances_));
  }

  void run_all()
  {
    sanity();
    wrong_usage();
    bad_meshes_and_sources();
    bad_text();
    bad_ply();
    truncated_ply();
    bad_output();
    messages();
  }

private:
  static constexpr int usage = 2, input = 1;

  // Expects an exit code, one line of errors with all the given words, and unchanged files.
  void expect(int exit_code, const std::string& what, const Arguments& arguments, const Arguments& words = {})
  {
    Report::instance().set_context(what);
    const std::set<std::string> before = scratch_.files();
    const Program_result result = run_program(program_, arguments);
    CHECK_DETAIL(result.exit_code == exit_code, "exit code " + std::to_string(result.exit_code));
    CHECK_DETAIL(std::count(result.errors.begin(), result.errors.end(), '\n') == 1 && result.errors.back() == '\n',
                 result.errors);
    CHECK_DETAIL(result.errors.compare(0, 29, "validate_geodesic_distances: ") == 0, result.errors);
    CHECK_DETAIL(result.output.empty(), result.output);
    for (const std::string& word : words)
      CHECK_DETAIL(result.errors.find(word) != std::string::npos, word + " is not in: " + result.errors);
    CHECK(scratch_.files() == before);
    for (const std::string& file : scratch_.files())
      if (before.count(file) == 0) std::filesystem::remove(file);
    std::cout << what << ": " << result.errors << std::flush;
  }

  Arguments on(const std::string& table, const Arguments& more = {}) const
  {
    Arguments arguments = {mesh_, "--source-vertex", "0", "--distances", table, "--per-vertex", rows_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  // Expects that the message for this table names the file and has the words.
  void expect_bad_table(const std::string& what, const std::string& extension, const std::string& bytes, Arguments words,
                        const Arguments& more = {})
  {
    const std::string file = (scratch_ / ("bad" + extension)).string();
    write_file(file, bytes);
    words.push_back("'" + file + "'");
    expect(input, what, on(file, more), words);
    std::filesystem::remove(file);
  }

  void expect_bad_mesh(const std::string& what, const std::string& extension, const std::string& bytes, Arguments words)
  {
    const std::string file = (scratch_ / ("mesh" + extension)).string();
    write_file(file, bytes);
    words.push_back("'" + file + "'");
    expect(input, what, {file, "--source-vertex", "0", "--distances", table_, "--per-vertex", rows_}, words);
    std::filesystem::remove(file);
  }

  // Good input with the same arguments succeeds, so the failures below have the intended reasons.
  void sanity()
  {
    Report::instance().set_context("good input");
    const Program_result result = run_program(program_, on(table_));
    CHECK_DETAIL(result.exit_code == 0, result.errors);
    CHECK(result.errors.empty() && !result.output.empty());
    CHECK(std::filesystem::exists(rows_) && std::filesystem::file_size(rows_) > 0);
    std::filesystem::remove(rows_);
  }

  void wrong_usage()
  {
    expect(usage, "no arguments", {});
    expect(usage, "no mesh", {"--source-vertex", "0", "--distances", table_}, {"MESH"});
    expect(usage, "two meshes", on(table_, {mesh_}), {"more than one MESH"});
    expect(usage, "no source", {mesh_, "--distances", table_, "--per-vertex", rows_}, {"no source"});
    expect(usage, "no table", {mesh_, "--source-vertex", "0", "--per-vertex", rows_}, {"--distances"});
    expect(usage, "an empty name of a table", {mesh_, "--source-vertex", "0", "--distances="}, {"--distances"});
    expect(usage, "two tables", on(table_, {"--distances", table_}), {"distances"});
    expect(usage, "unknown option", on(table_, {"--unknown", "3"}), {"unknown"});
    expect(usage, "an option of the other program", on(table_, {"--spacing", "3"}), {"spacing"});
    expect(usage, "abbreviated option", on(table_, {"--tol", "3"}), {"tol"});
    expect(usage, "option without its value", on(table_, {"--tolerance"}), {"tolerance"});
    for (const char* tolerance : {"-1", "nan", "inf", "abc", "", "1x", "1e999"})
      expect(usage, std::string("tolerance '") + tolerance + "'", on(table_, {std::string("--tolerance=") + tolerance}),
             {"--tolerance"});
    for (const char* index : {"-1", "x", "1.5", "nan", "", "99999999999999999999999"})
      expect(usage, std::string("source vertex '") + index + "'", on(table_, {std::string("--source-vertex=") + index}),
             {"--source-vertex"});
    expect(usage, "a source point that is none", on(table_, {"--source-point=1,2"}), {"--source-point"});
    expect(usage, "a property of a text file", on(table_, {"--property", "distance"}), {"--property", table_});
    for (const std::string& file : {mesh_, table_})
      expect(usage, "output over an input", {mesh_, "--source-vertex", "0", "--distances", table_, "--per-vertex", file},
             {file, "twice"});
  }

  void bad_meshes_and_sources()
  {
    const std::string missing = (scratch_ / "missing.off").string();
    expect(input, "missing mesh", {missing, "--source-vertex", "0", "--distances", table_, "--per-vertex", rows_}, {missing});
    expect_bad_mesh("unknown format", ".xyz", read_file(mesh_), {"must end in"});
    expect_bad_mesh("truncated mesh", ".off", read_file(mesh_).substr(0, 300), {"ends"});
    expect_bad_mesh("quadrilateral", ".off", "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0.1\n2 0 0\n3 1 4 2\n4 0 1 2 3\n",
                    {"face 1 ", "4 vertices", "triangles"});
    const auto stl = scratch_ / "soup.stl";
    CGAL::IO::write_polygon_soup(stl.string(), soup_.points, soup_.triangles);
    expect_bad_mesh("no numbers of vertices", ".stl", read_file(stl), {"numbered"});
    expect_bad_mesh("three faces at an edge", ".off",
                    "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n3 1 0 3\n3 0 1 4\n", {"vertex 0", "manifold"});
    expect_bad_mesh("two vertices at the ends of an edge of no length", ".off",
                    "OFF\n5 3 0\n0 0 0\n1 0 0\n1 0 0\n2 1 0\n0 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n",
                    {"vertices 1 and 2", "same place"});

    expect(input, "source vertex out of range", on(table_, {"--source-vertex", "42"}),
           {"--source-vertex 42", mesh_, "0 to 41"});
    expect(input, "plane that misses the mesh", on(table_, {"--source-plane", "0,0,1,-5"}), {"--source-plane", mesh_});
    expect(input, "no boundary", on(table_, {"--source-boundary"}), {"--source-boundary", mesh_});
    expect(input, "no sharp edges", on(table_, {"--source-sharp-edges", "120"}), {"--source-sharp-edges", mesh_});
    const std::string curve = (scratch_ / "curve.polylines.txt").string();
    expect(input, "missing polyline", on(table_, {"--source-polyline", curve}), {curve});
    write_file(curve, "2 0 0 1 nan 1 0\n");
    expect(input, "NaN in a polyline", on(table_, {"--source-polyline", curve}), {curve, "line 1", "nan"});
    std::filesystem::remove(curve);
  }

  // Words that are no distances, and their messages.
  static std::vector<std::pair<std::string, std::string>> bad_words()
  {
    std::vector<std::pair<std::string, std::string>> words = {{"-1", "negative"}, {"-1e-300", "negative"}};
    for (const char* word : {"x", "1.5x", "1,5", "0x10", "1e999", "nan", "-nan", "NaN", "-inf"})
      words.emplace_back(word, "neither a finite number nor inf");
    return words;
  }

  void bad_text()
  {
    const std::string missing = (scratch_ / "missing.txt").string();
    expect(input, "missing table", on(missing), {missing});
    expect(input, "a directory", on(std::filesystem::path(mesh_).parent_path().string()), {"directory"});
    expect_bad_table("empty table", ".txt", "", {"empty"});
    expect_bad_table("only comments", ".txt", "# nothing\n\n# at all\n", {"no distances"});

    const std::size_t n = distances_.size(); // 42
    std::vector<double> fewer = distances_, more = distances_;
    fewer.pop_back();
    more.push_back(1);
    expect_bad_table("one distance too few", ".txt", column_table(fewer), {"only 41 distances", mesh_, "42 vertices"});
    expect_bad_table("one distance too many", ".txt", column_table(more), {"line 44", "number 43", mesh_, "42 vertices"});

    const auto with_line = [&](bool is_pairs, std::size_t at, const std::string& line) {
      std::string text;
      for (std::size_t v = 0; v < n; ++v)
        text += (v == at ? line : (is_pairs ? std::to_string(v) + ' ' : "") + number_text(distances_[v])) + '\n';
      return text;
    };
    for (const auto& word : bad_words())
    {
      expect_bad_table("a column with " + word.first, ".txt", with_line(false, 6, word.first),
                       {"line 7", "vertex 6", "'" + word.first + "'", word.second});
      expect_bad_table("pairs with " + word.first, ".txt", with_line(true, 40, "40 " + word.first),
                       {"line 41", "vertex 40", "'" + word.first + "'", word.second});
    }
    expect_bad_table("two words in a column", ".txt", with_line(false, 9, "9 1"), {"line 10", "2 words"});
    expect_bad_table("one word among pairs", ".txt", with_line(true, 9, "1"), {"line 10", "1 word"});
    expect_bad_table("three words", ".txt", "0 1 2\n" + column_table(distances_), {"line 1", "3 words"});
    expect_bad_table("index out of range", ".txt", with_line(true, 9, "42 1"), {"line 10", "no vertex 42", mesh_});
    expect_bad_table("index far out of range", ".txt", with_line(true, 9, "99999999999999999999999 1"), {"line 10", "index"});
    for (const char* index : {"-1", "1.5", "x", "nan"})
      expect_bad_table(std::string("index ") + index, ".txt", with_line(true, 9, std::string(index) + " 1"),
                       {"line 10", std::string("'") + index + "'", "index"});
    expect_bad_table("a vertex twice", ".txt", with_line(true, 9, "3 1"), {"line 10", "vertex 3", "line 4"});
    expect_bad_table("a vertex once more", ".txt", with_line(true, n, "") + "17 1\n", {"line 43", "vertex 17", "line 18"});
    expect_bad_table("a vertex without a distance", ".txt", with_line(true, 9, ""), {"41 distances", "vertex 9"});

    Random random(8);
    std::string noise;
    for (int i = 0; i < 3000; ++i) noise += static_cast<char>(uniform_index(random, 256));
    expect_bad_table("random bytes", ".txt", noise, {"line"});
    expect_bad_table("a PLY file under another name", ".txt", ply(Ply_format::ascii), {"line 1", "ply"});
  }

  std::string ply(Ply_format format, const std::string& type = "double") const
  {
    return Ply_table(format, "distance", type)(soup_, distances_);
  }

  static std::string replaced(std::string text, const std::string& from, const std::string& to)
  {
    const std::size_t at = text.find(from);
    CHECK_DETAIL(at != std::string::npos, from);
    return text.replace(at, from.size(), to);
  }

  void bad_ply()
  {
    const std::string missing = (scratch_ / "missing.ply").string();
    expect(input, "missing PLY table", on(missing), {missing});
    expect_bad_table("a text under the name of a PLY file", ".ply", column_table(distances_), {"ply"});
    const std::pair<const char*, Ply_format> formats[] = {
      {"ASCII, ", Ply_format::ascii}, {"little endian, ", Ply_format::little_endian}, {"big endian, ", Ply_format::big_endian}};
    for (const auto& format : formats)
    {
      const std::string name = format.first, whole = ply(format.second);
      const std::string file = (scratch_ / "whole.ply").string();
      write_file(file, whole);
      Report::instance().set_context(name + "whole");
      CHECK(run_program(program_, on(file)).exit_code == 0);
      std::filesystem::remove(rows_);
      std::filesystem::remove(file);

      expect_bad_table(name + "unknown property", ".ply", whole, {"no property 'heat'", "distance"}, {"--property", "heat"});
      expect_bad_table(name + "no usual property", ".ply", Ply_table(format.second, "heat")(soup_, distances_),
                       {"--property", "heat"});
      expect_bad_table(name + "a property that is no distance", ".ply", whole, {"'weight'", "negative"},
                       {"--property", "weight"});
      expect_bad_table(name + "a property of bytes", ".ply", whole, {"'mark'", "uchar"}, {"--property", "mark"});
      expect_bad_table(name + "a property of lists", ".ply",
                       replaced(whole, "property double distance", "property list uchar double distance"),
                       {"'distance'", "list"});
      for (const char* type : {"half", "list", "list uchar", "list float int", "list uchar half"})
        expect_bad_table(name + "the unknown type " + type, ".ply",
                         replaced(whole, "property uchar mark", std::string("property ") + type + " mark"),
                         {"'mark'", "unknown type '" + std::string(type) + "'"});
      expect_bad_table(name + "a vertex too few", ".ply",
                       Ply_table(format.second, "distance")(soup_, {distances_.begin(), distances_.end() - 1}),
                       {"41 vertices", mesh_, "42"});
      expect_bad_table(name + "a vertex too many", ".ply", replaced(whole, "vertex 42", "vertex 43"),
                       {"43 vertices", mesh_, "42"});
      expect_bad_table(name + "absurd number of vertices", ".ply", replaced(whole, "vertex 42", "vertex 4000000000"),
                       {"4000000000 vertices", mesh_});
      expect_bad_table(name + "no vertices", ".ply", replaced(whole, "element vertex 42", "element point 42"), {"no vertices"});
      expect_bad_table(name + "an element without properties", ".ply",
                       replaced(whole, "element vertex", "element nothing 99999999999\nelement vertex"), {"'nothing'"});
      expect_bad_table(name + "an unknown format", ".ply",
                       replaced(whole, name[0] == 'A' ? "format ascii" : "format binary", "format other"), {"malformed"});

      Soup other = soup_;
      std::swap(other.points[7], other.points[30]);
      expect_bad_table(name + "another order", ".ply", Ply_table(format.second, "distance")(other, distances_),
                       {"vertex 7 ", mesh_, "order"});

      std::vector<double> distances = distances_;
      distances[11] = -0.25;
      expect_bad_table(name + "negative distance", ".ply", Ply_table(format.second, "distance")(soup_, distances),
                       {"vertex 11", "-0.25", "negative"});
      distances[11] = std::numeric_limits<double>::quiet_NaN();
      for (const char* type : {"float", "double"})
        expect_bad_table(name + "NaN of type " + type, ".ply", Ply_table(format.second, "distance", type)(soup_, distances),
                         {"vertex 11", "nan"});
    }
    const std::string text = ply(Ply_format::ascii);
    for (const auto& word : bad_words())
      expect_bad_table("ASCII PLY with " + word.first, ".ply", replaced(text, " 0 -1 \n", " " + word.first + " -1 \n"),
                       {"line", "vertex 0", "'" + word.first + "'", word.second});
  }

  // Files that end within the vertices, or within the part that CGAL reads.
  void truncated_ply()
  {
    for (Ply_format format : {Ply_format::ascii, Ply_format::little_endian, Ply_format::big_endian})
    {
      const std::string whole = ply(format);
      const std::size_t header = whole.find("end_header\n") + 11, row = format == Ply_format::ascii ? 60 : 29;
      std::vector<std::size_t> sizes = {2, 20, header / 2, header - 4};
      for (std::size_t i = 1; i < 40; i += 7) sizes.push_back(header + i * row);
      for (std::size_t size : sizes)
        expect_bad_table("PLY cut after " + std::to_string(size) + " bytes", ".ply", whole.substr(0, size), {});
    }
    Random random(9);
    for (Ply_format format : {Ply_format::little_endian, Ply_format::big_endian})
    {
      const std::string whole = ply(format);
      std::string noise = whole.substr(0, whole.find("end_header\n") + 11);
      for (int i = 0; i < 5000; ++i) noise += static_cast<char>(uniform_index(random, 256));
      expect_bad_table("random bytes after a header", ".ply", noise, {});
    }
  }

  void bad_output()
  {
    const std::string folder = (scratch_ / "missing/rows.txt").string();
    expect(input, "output in a missing directory",
           {mesh_, "--source-vertex", "0", "--distances", table_, "--per-vertex", folder}, {folder});
    const std::string directory = std::filesystem::path(mesh_).parent_path().string();
    expect(input, "a directory as output", {mesh_, "--source-vertex", "0", "--distances", table_, "--per-vertex", directory},
           {directory});
    if (!std::filesystem::exists("/dev/full")) return;
    Report::instance().set_context("no room for the report");
    Arguments arguments = {"-c", "exec \"$@\" > /dev/full", "sh", program_};
    const Arguments good = on(table_);
    arguments.insert(arguments.end(), good.begin(), good.end());
    const Program_result result = run_program("/bin/sh", arguments);
    CHECK(result.exit_code == input);
    CHECK_DETAIL(std::count(result.errors.begin(), result.errors.end(), '\n') == 1, result.errors);
    CHECK(!std::filesystem::exists(rows_));
  }

  static bool contains(const std::string& text, const std::string& word) { return text.find(word) != std::string::npos; }

  // Conditions that do not stop the program, and hints.
  void messages()
  {
    Report::instance().set_context("points that are moved to the surface");
    const auto from_point = [&](const std::string& point) {
      return run_program(program_, {mesh_, "--source-point", point, "--distances", table_});
    };
    const Program_result near = from_point("0.9,0.1,0.2"), far = from_point("900,100,200");
    for (const Program_result* result : {&near, &far})
    {
      CHECK(result->exit_code == 0 || result->exit_code == 3);
      CHECK_DETAIL(contains(result->output, "1 point moved to the surface, by at most "), result->output);
    }
    CHECK_DETAIL(near.errors.empty(), near.errors);
    CHECK_DETAIL(far.errors.rfind("validate_geodesic_distances: warning: --source-point 900,100,200 is 9", 0) == 0 &&
                   std::count(far.errors.begin(), far.errors.end(), '\n') == 1,
                 far.errors);

    expect(usage, "blanks for commas", {mesh_, "--source-plane", "0", "0", "1", "0", "--distances", table_},
           {"--source-plane 0,0,1,0", "commas"});
    const std::string curve = (scratch_ / "curve.polylines.txt").string();
    write_file(curve, "0 0 1\n1 0 0\n");
    expect(input, "one point per line", {mesh_, "--source-polyline", curve, "--distances", table_},
           {curve, "line 1", "2  0 0 0  1 0 0.5"});
    std::filesystem::remove(curve);

    Report::instance().set_context("version and help");
    const Program_result version = run_program(program_, {"--version"}), help = run_program(program_, {"--help"});
    CHECK(version.exit_code == 0 && version.errors.empty() && version.output.rfind("validate_geodesic_distances ", 0) == 0);
    CHECK(help.exit_code == 0 && contains(help.output, "--version") && contains(help.output, "2  0 0 0  1 0 0.5"));
  }

  std::string program_;
  Scratch_directory scratch_;
  Soup soup_;
  std::string mesh_, table_, rows_;
  std::vector<double> distances_;
};

} // namespace test_program_validation_bad_input

GEODESIC_OFFSET_TEST(test_program_validation_bad_input)
{
  if (argc != 3 || !std::filesystem::exists(argv[1]) || !std::filesystem::exists(argv[2]))
  {
    std::cerr << "usage: test_program_validation_bad_input VALIDATE_GEODESIC_DISTANCES GEODESIC_OFFSET\n";
    return 2;
  }
  Bad_input(argv[1], argv[2]).run_all();
  return Report::instance().finish("test_program_validation_bad_input");
}
