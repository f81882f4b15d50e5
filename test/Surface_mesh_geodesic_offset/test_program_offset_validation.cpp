// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The program validate_geodesic_offsets: the offsets of geodesic_offset are certified within their chord tolerance, and curves
// with faults are found; exit codes 1 and 2 with one line for bad input.
//
//   test_program_offset_validation VALIDATE_GEODESIC_OFFSETS GEODESIC_OFFSET

#include "generated_meshes.h"
#include "program_runner.h"
#include "test_check.h"
#include "validation_files.h"

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace test_program_offset_validation {

using namespace test;

typedef std::vector<std::string> Arguments;

constexpr int certified = 0, not_certified = 3;

class Offset_file
{
public:
  Offset_file(const std::string& validate, const std::string& geodesic_offset)
    : program_(validate), mesh_((scratch_ / "mesh.off").string()), curves_((scratch_ / "curves.polylines.txt").string())
  {
    write_off(mesh_, torus(16, 12));
    const Program_result r =
      run_program(geodesic_offset,
                  {mesh_, "--source-vertex", "0", "--distance", "1.6", "--tolerance", "1e-4", "--output", curves_, "--quiet"});
    CHECK_DETAIL(r.exit_code == 0, r.errors);
    std::istringstream in(read_file(curves_));
    for (std::string line; std::getline(in, line);)
      if (!line.empty()) lines_.push_back(line);
    CHECK(lines_.size() > 1);
  }

  void run_all()
  {
    Report::instance().set_context("own curves");
    const std::string own = run(lines_, certified);
    CHECK_DETAIL(own.find("region: yes") != std::string::npos && number(own, "tolerance") <= 1.2e-4, own);
    CHECK(own.find("reversed") == std::string::npos);
    CHECK(own.find("curves: " + std::to_string(lines_.size()) + " curves") != std::string::npos);
    run(lines_, certified, {"--tolerance", "2e-4"});
    run(lines_, not_certified, {"--tolerance", "1e-7"});
    for (const char* distance : {"1.6", "1.61", "1.62", "1.63", "1.65", "1.67", "1.71"})
    { // the printed tolerance is rounded up, so that it is accepted
      const std::string text = run(lines_, certified, {"--distance", distance}, false);
      const std::size_t begin = text.find("\ntolerance: ") + 12;
      run(lines_, certified, {"--distance", distance, "--tolerance", text.substr(begin, text.find(',', begin) - begin)}, false);
    }
    // beyond the surface, no curve is the offset
    const std::string none = run({}, certified, {"--distance", "100", "--tolerance", "1e-9"}, false);
    CHECK_DETAIL(none.find("tolerance: 0 (") != std::string::npos, none);
    CHECK_DETAIL(number(run({}, certified), "tolerance") > 0.1, "no curves within the surface");
    const std::string other = run(lines_, certified, {"--distance", "1.7"}, false);
    CHECK_DETAIL(number(other, "tolerance") > 0.0999 && number(other, "tolerance") < 0.1002, other);
    CHECK(other.find("nearer to the sources") != std::string::npos);

    for (std::size_t i = 0; i < lines_.size(); ++i)
    {
      Report::instance().set_context("line " + std::to_string(i + 1));
      std::vector<std::string> bad = lines_;
      bad.erase(bad.begin() + std::ptrdiff_t(i));
      run(bad, not_certified, {"--tolerance", "1e-3"});

      bad = lines_;
      bad[i] = without_last_point(lines_[i]);
      const std::string open = run(bad, not_certified);
      CHECK_DETAIL(open.find("region: no (a curve ends inside the surface)\nat: ") != std::string::npos, open);
      CHECK(open.find("curve in line " + std::to_string(i + 1)) != std::string::npos);

      bad = lines_;
      bad[i] = reversed(lines_[i]);
      const std::string reverse = run(bad, certified);
      CHECK_DETAIL(reverse.find("\nreversed: 1 ") != std::string::npos &&
                     reverse.find("the first one in line " + std::to_string(i + 1) + ")") != std::string::npos,
                   reverse);

      bad = lines_;
      bad[i] = moved(lines_[i]);
      const std::string away = run(bad, not_certified);
      CHECK_DETAIL(away.find("\nsurface: no (") != std::string::npos &&
                     away.find("line " + std::to_string(i + 1) + ": point 0 is ") != std::string::npos,
                   away);
      run(bad, not_certified, {"--surface-tolerance", "100", "--tolerance", "1e-3"});
    }
  }

  void bad_input()
  {
    Report::instance().set_context("bad input");
    const std::string none = (scratch_ / "none").string();
    const Arguments good = {mesh_, "--source-vertex", "0", "--distance", "1.6", "--curves", curves_};
    refuse(2, {mesh_, "--source-vertex", "0", "--distance", "1.6"}, "no --curves given");
    refuse(2, {mesh_, "--source-vertex", "0", "--curves", curves_}, "no --distance given");
    refuse(2, {mesh_, "--distance", "1.6", "--curves", curves_}, "no source given");
    refuse(2, {mesh_, "--source-vertex", "0", "--distance", "-1", "--curves", curves_}, "--distance must be");
    for (const char* option : {"--tolerance", "--surface-tolerance"})
    {
      Arguments bad = good;
      bad.insert(bad.end(), {option, "0"});
      refuse(2, bad, std::string(option) + " must be a positive finite number, not '0'");
    }
    refuse(1, {mesh_, "--source-vertex", "0", "--distance", "1.6", "--curves", none}, "No such file");
    refuse(1, {none, "--source-vertex", "0", "--distance", "1.6", "--curves", curves_}, "none");
    CHECK(run_program(program_, {"--help"}).output.find("--curves") != std::string::npos);
    CHECK(run_program(program_, {"--version"}).output.find("validate_geodesic_offsets ") == 0);
  }

private:
  std::string run(const std::vector<std::string>& lines, int exit_code, const Arguments& more = {}, bool has_distance = true)
  {
    std::string text;
    for (const std::string& line : lines) text += line + '\n';
    const std::string file = (scratch_ / "tested.polylines.txt").string();
    write_file(file, text);
    Arguments arguments = {mesh_, "--source-vertex", "0", "--curves", file};
    if (has_distance) arguments.insert(arguments.end(), {"--distance", "1.6"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Program_result r = run_program(program_, arguments);
    CHECK_DETAIL(r.exit_code == exit_code && r.errors.empty(), std::to_string(r.exit_code) + ": " + r.output + r.errors);
    return r.output;
  }

  void refuse(int exit_code, const Arguments& arguments, const std::string& message)
  {
    const Program_result r = run_program(program_, arguments);
    CHECK_DETAIL(r.exit_code == exit_code && r.errors.find(message) != std::string::npos,
                 std::to_string(r.exit_code) + ": " + r.errors);
    CHECK(!r.errors.empty() && r.errors.find('\n') == r.errors.size() - 1);
  }

  static double number(const std::string& report, const std::string& label)
  {
    const std::size_t at = report.find('\n' + label + ": ");
    CHECK_DETAIL(at != std::string::npos, report);
    return at == std::string::npos ? -1 : std::strtod(report.c_str() + at + label.size() + 3, nullptr);
  }

  static std::vector<std::string> points(const std::string& line)
  {
    std::istringstream in(line);
    std::size_t n;
    in >> n;
    std::vector<std::string> result;
    for (std::string x, y, z; in >> x >> y >> z;) result.push_back(x + ' ' + y + ' ' + z);
    CHECK(result.size() == n && n > 4 && result.front() == result.back());
    return result;
  }

  static std::string line_of(const std::vector<std::string>& points)
  {
    std::string text = std::to_string(points.size());
    for (const std::string& p : points) text += ' ' + p;
    return text;
  }

  static std::string without_last_point(const std::string& line)
  {
    std::vector<std::string> p = points(line);
    p.pop_back();
    return line_of(p);
  }

  static std::string reversed(const std::string& line)
  {
    std::vector<std::string> p = points(line);
    return line_of({p.rbegin(), p.rend()});
  }

  static std::string moved(const std::string& line)
  {
    std::vector<std::string> p = points(line);
    p.front() = p.back() = "9 9 9";
    return line_of(p);
  }

  Scratch_directory scratch_;
  std::string program_, mesh_, curves_;
  std::vector<std::string> lines_;
};

} // namespace test_program_offset_validation

GEODESIC_OFFSET_TEST(test_program_offset_validation)
{
  CHECK(argc > 2);
  if (argc > 2)
  {
    Offset_file file(argv[1], argv[2]);
    file.run_all();
    file.bad_input();
  }
  return Report::instance().finish("test_program_offset_validation");
}
