// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The program validate_geodesic_distances on good input: exact distances are within the certified bounds, and errors in
// others are detected, located and summarized correctly.
//
//   test_program_validation VALIDATE_GEODESIC_DISTANCES GEODESIC_OFFSET

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "program_runner.h"
#include "test_check.h"
#include "validation_files.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_program_validation {

using namespace test;

typedef std::vector<std::string> Arguments;

constexpr int all_inside = 0, some_outside = 3;

/// Lines "label: value (meaning)" of a report.
class Validation_report
{
public:
  explicit Validation_report(const std::string& text) : text_(text) {}

  std::string value(const std::string& label) const
  {
    const std::size_t at = ('\n' + text_).find('\n' + label + ": ");
    CHECK_DETAIL(at != std::string::npos, label);
    if (at == std::string::npos) return std::string();
    const std::size_t begin = at + label.size() + 2;
    return text_.substr(begin, text_.find('\n', begin) - begin);
  }

  double number(const std::string& label) const { return std::strtod(value(label).c_str(), nullptr); }
  std::size_t count(const std::string& label) const { return static_cast<std::size_t>(number(label)); }

  /// The number after a word.
  double number(const std::string& label, const std::string& word) const
  {
    const std::string line = value(label);
    const std::size_t at = line.find(word + ' ');
    CHECK_DETAIL(at != std::string::npos, line);
    return at == std::string::npos ? -1 : std::strtod(line.c_str() + at + word.size(), nullptr);
  }

private:
  std::string text_;
};

struct Row
{
  double lower, upper, distance, error;
};

/// A mesh in a file, and the known distances from some of its vertices.
class Case
{
public:
  Case(const std::string& validate, const std::string& name, const Soup& soup, std::size_t source = 0, bool is_flat = false)
    : soup(soup), source(source), is_flat(is_flat), program_(validate), name_(name), mesh_file_((scratch / "mesh.off").string())
  {
    write_off(mesh_file_, soup);
    CHECK(CGAL::IO::read_polygon_mesh(mesh_file_, mesh));
    CHECK(mesh.number_of_vertices() == soup.points.size());
    Geodesic geodesic(mesh);
    geodesic.add_source_point(Surface_mesh::Vertex_index(static_cast<Surface_mesh::size_type>(source)));
    geodesic.build();
    for (const auto v : mesh.vertices()) exact.push_back(geodesic.distance_to_sources(v));
  }

  const std::string& mesh_file() const { return mesh_file_; }
  std::size_t size() const { return exact.size(); }

  /// Report on a table, and rows of the output table.
  Validation_report run(int exit_code, const std::string& table_name, const std::string& table, const Arguments& more = {})
  {
    Report::instance().set_context(name_ + ", " + table_name);
    const std::string table_file = (scratch / table_name).string(), rows_file = (scratch / "rows.txt").string();
    write_file(table_file, table);
    Arguments arguments = {mesh_file_,     "--source-vertex", std::to_string(source), "--distances", table_file,
                           "--per-vertex", rows_file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Program_result result = run_program(program_, arguments);
    CHECK_DETAIL(result.exit_code == exit_code, std::to_string(result.exit_code) + ": " + result.output + result.errors);
    CHECK_DETAIL(result.errors.empty(), result.errors);
    read_rows(rows_file);
    const Validation_report report(result.output);
    CHECK(report.count("vertices") == size());
    CHECK(report.count("inside") + report.count("too short") + report.count("too long") +
            report.count("infinite in the table only") + report.count("finite in the table only") ==
          size());
    return report;
  }

  const Soup soup;
  const std::size_t source;
  const bool is_flat;
  Scratch_directory scratch;
  Surface_mesh mesh;
  std::vector<double> exact;
  std::vector<Row> rows;

private:
  void read_rows(const std::string& file)
  {
    rows.clear();
    std::istringstream in(read_file(file));
    std::filesystem::remove(file);
    std::string line;
    CHECK(std::getline(in, line) && line == "# vertex lower upper distance error");
    while (std::getline(in, line))
    {
      char* at = line.data();
      CHECK(std::strtoul(at, &at, 10) == rows.size());
      Row row;
      for (double* x : {&row.lower, &row.upper, &row.distance, &row.error}) *x = std::strtod(at, &at);
      CHECK(*at == '\0');
      rows.push_back(row);
    }
    CHECK(rows.size() == size());
  }

  std::string program_, name_, mesh_file_;
};

bool is_close(double a, double b) { return a == b || std::abs(a - b) <= 2e-5 * std::abs(b); } // output has six digits

void exact_distances_pass(Case& c)
{
  const auto expect_all = [&](const std::string& name, const std::string& table) {
    const Validation_report report = c.run(all_inside, name, table);
    CHECK(report.count("inside") == c.size());
    CHECK(report.count("beyond the tolerance") == 0);
    CHECK(report.value("worst vertex").compare(0, 4, "none") == 0);
    CHECK(report.number("outside, absolute", "largest") == 0);
    for (std::size_t v = 0; v < c.size(); ++v)
    {
      CHECK(c.rows[v].distance == c.exact[v]); // all digits were transferred
      CHECK(c.rows[v].error == 0 && c.rows[v].lower <= c.exact[v] && c.exact[v] <= c.rows[v].upper);
    }
  };
  expect_all("column.txt", column_table(c.exact));
  expect_all("pairs.txt", pair_table(c.exact, 7));
  for (Ply_format format : {Ply_format::ascii, Ply_format::little_endian, Ply_format::big_endian})
    for (const char* name : {"distance", "quality", "scalar", "geodesic_distance", "geodesic", "value"})
      expect_all("table.ply", Ply_table(format, name)(c.soup, c.exact, name[0] == 'd'));
}

// A single error of 1e-9 is detected, and nothing else.
void disturbed_distances_are_found(Case& c)
{
  Random random(3);
  for (double error : {1e-9, -1e-9})
    for (int i = 0; i < 4; ++i)
    {
      std::size_t v = c.source;
      while (c.exact[v] < 1e-3 || c.exact[v] == infinity) v = uniform_index(random, c.size());
      std::vector<double> distances = c.exact;
      distances[v] += error;
      const std::pair<std::string, std::string> tables[] = {
        {"column.txt", column_table(distances)},
        {"pairs.txt", pair_table(distances, 5)},
        {"ascii.ply", Ply_table(Ply_format::ascii, "quality")(c.soup, distances)},
        {"binary.ply", Ply_table(Ply_format::little_endian, "quality")(c.soup, distances)}};
      const auto& table = tables[i];
      const Validation_report report = c.run(some_outside, table.first, table.second);
      CHECK(report.count("inside") == c.size() - 1);
      CHECK(report.count("beyond the tolerance") == 1);
      CHECK(report.count("too long") == (error > 0 ? 1u : 0u));
      CHECK(report.count("too short") == (error > 0 ? 0u : 1u));
      CHECK(report.count("worst vertex") == v);
      for (const char* kind : {"absolute", "relative"})
        CHECK(report.number(std::string("outside, ") + kind, "at vertex") == static_cast<double>(v));
      CHECK(std::abs(report.number("outside, absolute", "largest") - 1e-9) < 1e-12);
      for (std::size_t u = 0; u < c.size(); ++u)
        if (u == v) CHECK(std::abs(c.rows[u].error - error) < 1e-12);
        else CHECK(c.rows[u].error == 0);

      // the tolerance is relative to the bound
      const double part = std::abs(error) / c.exact[v];
      c.run(all_inside, table.first, table.second, {"--tolerance", number_text(1.01 * part)});
      CHECK(c.run(some_outside, table.first, table.second, {"--tolerance", number_text(0.99 * part)})
              .count("beyond the tolerance") == 1);
    }
}

std::vector<double> lengths_along_edges(const Case& c)
{
  std::vector<double> length(c.size(), infinity);
  std::vector<std::vector<std::size_t>> neighbours(c.size());
  for (const auto& t : c.soup.triangles)
    for (std::size_t k = 0; k < 3; ++k)
    {
      neighbours[t[k]].push_back(t[(k + 1) % 3]);
      neighbours[t[(k + 1) % 3]].push_back(t[k]);
    }
  typedef std::pair<double, std::size_t> Entry;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  length[c.source] = 0;
  queue.emplace(0, c.source);
  while (!queue.empty())
  {
    const Entry top = queue.top();
    queue.pop();
    if (top.first > length[top.second]) continue;
    for (std::size_t u : neighbours[top.second])
    {
      const double l = top.first + std::sqrt(CGAL::squared_distance(c.soup.points[top.second], c.soup.points[u]));
      if (l < length[u])
      {
        length[u] = l;
        queue.emplace(l, u);
      }
    }
  }
  return length;
}

// Recomputes all figures from the rows of the table.
void check_figures(const Case& c, const Validation_report& report)
{
  std::vector<double> widths, relative_widths;
  double sums[2][4] = {}; // absolute and relative: outside, its square, off the middle, its square
  double largest[2][2] = {}, bias[2] = {};
  std::size_t short_ones = 0, long_ones = 0, inside = 0, table_only = 0, truth_only = 0;
  for (const Row& r : c.rows)
  {
    if (std::isinf(r.upper) || std::isinf(r.distance))
    {
      ++(r.upper == r.distance ? inside : std::isinf(r.distance) ? table_only : truth_only);
      CHECK(r.error == (r.upper == r.distance ? 0 : std::isinf(r.distance) ? infinity : -infinity));
      continue;
    }
    const double bound = r.distance < r.lower ? r.lower : r.upper, middle = 0.5 * (r.lower + r.upper);
    CHECK(r.error == (r.distance < r.lower || r.distance > r.upper ? r.distance - bound : 0));
    ++(r.error == 0 ? inside : r.error < 0 ? short_ones : long_ones);
    widths.push_back(r.upper - r.lower);
    if (middle > 0) relative_widths.push_back((r.upper - r.lower) / middle);
    for (int k = 0; k < (middle > 0 ? 2 : 1); ++k)
    {
      const double outside = std::abs(r.error) / (k ? bound : 1), off = (r.distance - middle) / (k ? middle : 1);
      sums[k][0] += outside;
      sums[k][1] += outside * outside;
      sums[k][2] += std::abs(off);
      sums[k][3] += off * off;
      bias[k] += off;
      largest[k][0] = (std::max)(largest[k][0], outside);
      largest[k][1] = (std::max)(largest[k][1], std::abs(off));
    }
  }
  CHECK(report.count("inside") == inside);
  CHECK(report.count("too short") == short_ones);
  CHECK(report.count("too long") == long_ones);
  CHECK(report.count("infinite in the table only") == table_only);
  CHECK(report.count("finite in the table only") == truth_only);
  CHECK(report.count("compared") == widths.size());
  CHECK(report.count("compared relatively") == relative_widths.size());
  for (int k = 0; k < 2; ++k)
  {
    const std::string kind = k ? "relative" : "absolute";
    std::vector<double>& w = k ? relative_widths : widths;
    const double n = static_cast<double>(w.size());
    for (int what = 0; what < 2; ++what)
    {
      const std::string label = (what ? "off the middle, " : "outside, ") + kind;
      CHECK(is_close(report.number(label, "largest"), largest[k][what]));
      CHECK(is_close(report.number(label, "mean"), sums[k][2 * what] / n));
      CHECK(is_close(report.number(label, "rms"), std::sqrt(sums[k][2 * what + 1] / n)));
    }
    CHECK(is_close(report.number("bias, " + kind), bias[k] / n));
    std::sort(w.begin(), w.end());
    CHECK(is_close(report.number("width, " + kind, "median"), w[w.size() / 2]));
    CHECK(is_close(report.number("width, " + kind, "largest"), w.back()));
    CHECK(w.back() < 1e-11);
  }
}

void other_methods_are_judged(Case& c)
{
  // paths along edges are paths on the surface
  const std::vector<double> edges = lengths_along_edges(c);
  const Validation_report too_long = c.run(some_outside, "edges.txt", column_table(edges));
  CHECK(too_long.count("too short") == 0);
  CHECK(too_long.count("too long") > c.size() / 4);
  CHECK(too_long.number("bias, absolute") > 0 && too_long.number("bias, relative") > 0);
  check_figures(c, too_long);
  const std::size_t worst = too_long.count("worst vertex");
  for (std::size_t v = 0; v < c.size(); ++v)
  {
    CHECK(c.rows[v].error >= 0);
    CHECK(c.rows[v].error <= c.rows[worst].error);
  }

  // straight lines in space are never longer than paths on the surface; on a flat convex surface they are the paths
  std::vector<double> straight;
  for (std::size_t v = 0; v < c.size(); ++v)
  {
    const double length = std::sqrt(CGAL::squared_distance(c.soup.points[c.source], c.soup.points[v]));
    straight.push_back(c.exact[v] == infinity ? infinity : length * (1 - 1e-15));
  }
  const Validation_report too_short = c.run(c.is_flat ? all_inside : some_outside, "straight.txt", column_table(straight),
                                            {"--tolerance", c.is_flat ? "1e-14" : "0"});
  CHECK(too_short.count("too long") == 0);
  CHECK(c.is_flat || too_short.count("too short") > c.size() / 4);
  CHECK(c.is_flat || too_short.number("bias, absolute") < 0);
  check_figures(c, too_short);

  // errors with both signs
  Random random(4);
  std::vector<double> noisy = c.exact;
  for (double& d : noisy) d *= uniform(random, 0.9, 1.2);
  check_figures(c, c.run(some_outside, "noisy.txt", column_table(noisy)));

  // numbers of single precision
  const std::string rounded = Ply_table(Ply_format::little_endian, "distance", "float")(c.soup, c.exact);
  c.run(some_outside, "float.ply", rounded);
  CHECK(c.run(all_inside, "float.ply", rounded, {"--tolerance", "1e-7"}).count("inside") < c.size());
}

void infinities(const std::string& program)
{
  Soup soup = icosphere(1);
  const Soup other = icosphere(0);
  const std::size_t n = soup.points.size();
  for (const Point_3& p : other.points) soup.points.push_back(p + Vector_3(5, 0, 0));
  for (const auto& t : other.triangles) soup.add_triangle({t[0] + n, t[1] + n, t[2] + n});
  soup.points.push_back(Point_3(9, 9, 9)); // a vertex without faces
  Case c(program, "two parts", soup, 3);
  CHECK(static_cast<std::size_t>(std::count(c.exact.begin(), c.exact.end(), infinity)) == other.points.size() + 1);
  exact_distances_pass(c);
  disturbed_distances_are_found(c);
  other_methods_are_judged(c);

  for (Ply_format format : {Ply_format::ascii, Ply_format::little_endian})
  {
    std::vector<double> distances = c.exact;
    distances[4] = infinity;
    distances[n + 2] = 7;
    distances[n + 3] = 8;
    const Validation_report report =
      c.run(some_outside, "some.ply", Ply_table(format, "d")(soup, distances), {"--property", "d", "--tolerance", "1e100"});
    CHECK(report.count("infinite in the table only") == 1);
    CHECK(report.count("finite in the table only") == 2);
    CHECK(report.count("beyond the tolerance") == 3);
    CHECK(report.count("inside") == c.size() - 3);
    CHECK(report.count("worst vertex") == 4);
    check_figures(c, report);
  }
  const Validation_report none = c.run(some_outside, "none.txt", column_table(std::vector<double>(c.size(), infinity)));
  CHECK(none.count("compared") == 0 && none.count("infinite in the table only") == n);
}

// Sources of all kinds, with the field of the other program.
void fields_of_the_other_program(const std::string& validate, const std::string& geodesic_offset)
{
  const Scratch_directory scratch;
  const std::string mesh = (scratch / "mesh.off").string(), field = (scratch / "field.ply").string(),
                    rows = (scratch / "rows.txt").string(), curve = (scratch / "curve.polylines.txt").string();
  write_file(curve, "3 -1 -1 0.2 1 -0.5 0.3 1.2 1 0.2\n");
  const Soup round = torus(18, 12), flat = random_rectangle(2, 1, 150, 6, 3),
             box = rotated(box_sides(1, 0.7, 0.4).triangulated(25, 3, 2), 2);
  const std::pair<const Soup*, Arguments> cases[] = {
    {&round, {"--source-vertex", "5"}},
    {&round, {"--source-point", "0.3,0.2,0.1"}},
    {&round, {"--source-polyline", curve}},
    {&round, {"--source-plane", "0.3,1,0.2,-0.1"}},
    {&round, {"--source-vertex", "5", "--source-point", "1,1,1", "--source-polyline", curve}},
    {&round, {"--source-vertex", "5", "--source-plane", "0.3,1,0.2,-0.1", "--start-value", "0,0.1"}},
    {&flat, {"--source-boundary"}},
    {&flat, {"--source-plane", "1,0.2,0,-0.7", "--source-point", "1.7,0.6,0"}},
    {&flat, {"--source-polyline", curve}},
    {&box, {"--source-sharp-edges", "60"}},
    {&box, {"--source-point", "0.3,0.2,0.1"}}};
  for (const auto& entry : cases)
  {
    write_off(mesh, *entry.first);
    Report::instance().set_context("field from " + entry.second[0]);
    Arguments first = {mesh, "--field", field, "--quiet"}, second = {mesh, "--distances", field, "--per-vertex", rows};
    first.insert(first.end(), entry.second.begin(), entry.second.end());
    second.insert(second.end(), entry.second.begin(), entry.second.end());
    const Program_result written = run_program(geodesic_offset, first);
    CHECK_DETAIL(written.exit_code == 0, written.errors);
    const Program_result result = run_program(validate, second);
    CHECK_DETAIL(result.exit_code == all_inside, result.output + result.errors);
    CHECK(Validation_report(result.output).count("inside") == entry.first->points.size());

    // without the additional source the distances are larger there, and nowhere too short
    std::istringstream in(read_file(rows));
    std::string line, farthest;
    std::getline(in, line);
    double largest = 0, lower;
    for (std::string vertex; in >> vertex >> lower && std::getline(in, line);)
      if (lower > largest)
      {
        largest = lower;
        farthest = vertex;
      }
    second.insert(second.end(), {"--source-vertex", farthest});
    const Program_result other = run_program(validate, second);
    CHECK_DETAIL(other.exit_code == some_outside, other.output + other.errors);
    const Validation_report report(other.output);
    CHECK(report.value("worst vertex").compare(0, farthest.size() + 1, farthest + ":") == 0);
    CHECK(report.count("too long") > 0 && report.count("too short") == 0);
  }
}

void borders_stay_apart(const std::string& program)
{
  // two triangles that share no vertex, along an edge at the same place
  Soup soup;
  for (const Point_3& p :
       {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0)})
    soup.points.push_back(p);
  soup.add_triangle({0, 1, 2});
  soup.add_triangle({3, 4, 5});
  Case c(program, "two borders", soup);
  CHECK(c.run(all_inside, "apart.txt", "0\n1\n1\ninf\ninf\ninf\n").value("mesh").size() > 0);
  c.run(some_outside, "joined.txt", "0\n1\n1\n1\n1.4142135623730951\n1\n");
}

void help(const std::string& program)
{
  Report::instance().set_context("help");
  const Program_result result = run_program(program, {"--help"});
  CHECK(result.exit_code == 0 && result.errors.empty());
  for (const char* word : {"--source-vertex", "--distances", "--property", "--tolerance", "--per-vertex", "Exit code", " 3 "})
    CHECK_DETAIL(result.output.find(word) != std::string::npos, word);
}

} // namespace test_program_validation

GEODESIC_OFFSET_TEST(test_program_validation)
{
  if (argc != 3 || !std::filesystem::exists(argv[1]) || !std::filesystem::exists(argv[2]))
  {
    std::cerr << "usage: test_program_validation VALIDATE_GEODESIC_DISTANCES GEODESIC_OFFSET\n";
    return 2;
  }
  const std::string program = argv[1];
  const std::pair<const char*, Soup> meshes[] = {{"sphere", icosphere(2)},
                                                 {"torus", torus(14, 9)},
                                                 {"box", rotated(box_sides(1, 0.7, 0.1).triangulated(25, 3, 2), 2)},
                                                 {"rectangle", rotated(random_rectangle(2, 1, 200, 6, 9), 9)}};
  for (const auto& mesh : meshes)
  {
    Case c(program, mesh.first, mesh.second, mesh.second.points.size() / 2, mesh.first == std::string("rectangle"));
    exact_distances_pass(c);
    disturbed_distances_are_found(c);
    other_methods_are_judged(c);
  }
  infinities(program);
  fields_of_the_other_program(program, argv[2]);
  borders_stay_apart(program);
  help(program);
  return Report::instance().finish("test_program_validation");
}
