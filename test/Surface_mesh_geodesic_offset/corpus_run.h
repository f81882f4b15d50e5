// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Corpus of meshes, unchanged and perturbed, with sources and levels of every kind, for the reader of the program
// geodesic_offset, the field and the offsets. Each run is a separate process, determined by its seed.

#ifndef GEODESIC_OFFSET_TEST_CORPUS_RUN_H
#define GEODESIC_OFFSET_TEST_CORPUS_RUN_H

#include "common/mesh_input.h"
#include "isolated_run.h"
#include "offset_tools.h"
#include "perturbed_meshes.h"
#include "scratch_directory.h"
#include "search_cases.h"
#include "search_tolerances.h"
#include "validation/Offset_validation.h"

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// Outcome of a run.
enum Corpus_outcome : unsigned char {
  RIGHT,        // distances are within the certified bounds, and curves are valid
  UNCERTIFIED,  // likewise, but certified bounds reject the mesh, as documented for needles
  MESH_REFUSED, // the reader rejects the file with one line
  NO_SOURCES,   // sources are rejected: no path on the surface joins the points of a polyline
  WRONG_FIELD,  // distances outside the certified bounds, or not 1-Lipschitz
  WRONG_CURVES, // invalid curves
  EXCEPTION,    // any other exception, or a message of several lines
  CRASHED,
  OVER_TIME,
  NUMBER_OF_OUTCOMES
};

inline const char* name_of(Corpus_outcome outcome)
{
  static const char* const names[] = {"right",        "no bounds", "mesh refused", "no sources", "wrong field",
                                      "wrong curves", "exception", "crashed",      "over time"};
  return names[outcome];
}

struct Corpus_options
{
  unsigned seed = 1; // of the first run; consecutive
  std::size_t runs = 1000;
  unsigned seconds = 60;                    // per run
  std::size_t printed = 50;                 // maximum number of printed failures
  bool verbose = false;                     // print each run
  std::string write;                        // prefix of the meshes and sources of failures
  std::vector<std::filesystem::path> files; // generated meshes if empty
};

/// One run in the child process.
class Corpus_case
{
public:
  /// Three lines: the outcome as a letter, the kind of the sources, and details.
  static std::string run(const Corpus_options& options, unsigned seed, const std::string& folder)
  {
    Corpus_case c(options, seed, folder);
    Corpus_outcome outcome = EXCEPTION;
    try
    {
      outcome = c.run();
    }
    catch (const geodesic_offset::Input_error& e)
    {
      c.text_ = e.what();
      outcome = c.text_.find('\n') == std::string::npos ? MESH_REFUSED : EXCEPTION;
    }
    catch (const std::exception& e)
    {
      c.text_ = e.what();
    }
    std::replace(c.text_.begin(), c.text_.end(), '\n', ' ');
    return char('0' + outcome) + ("\n" + c.sources_.kind) + "\n" + c.text_;
  }

  /// The mesh of a run, and its perturbation.
  static std::size_t number_of_meshes(const Corpus_options& options)
  {
    return options.files.empty() ? Search_meshes::kinds().size() : options.files.size();
  }
  static std::string mesh_name(const Corpus_options& options, unsigned seed)
  {
    const std::size_t i = seed % number_of_meshes(options);
    return options.files.empty() ? Search_meshes::kinds()[i].first : options.files[i].filename().string();
  }
  static std::size_t perturbation(const Corpus_options& options, unsigned seed)
  {
    return seed / number_of_meshes(options) % Perturbations::all().size();
  }

private:
  typedef CGAL::Surface_mesh_geodesic_enclosure<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Surface_mesh>> Enclosure;

  Corpus_case(const Corpus_options& options, unsigned seed, const std::string& folder)
    : options_(options), seed_(seed), folder_(folder), random_(seed)
  {
  }

  Corpus_outcome run()
  {
    const geodesic_offset::Mesh_input input = read();
    const Surface_mesh& mesh = input.mesh();
    if (!draw_sources(mesh)) return NO_SOURCES;
    Geodesic geodesic(mesh);
    sources_.add_to(geodesic);
    geodesic.build(CGAL::parameters::keep_windows(true));
    diagonal_ = bounding_box_diagonal(mesh);
    if (!is_lipschitz(geodesic, mesh)) return wrong(mesh, WRONG_FIELD);
    const std::vector<double> levels = draw_levels(geodesic, mesh);
    if (!has_valid_curves(geodesic, mesh, levels)) return wrong(mesh, WRONG_CURVES);
    return check_bounds(geodesic, mesh);
  }

  // Reads the mesh with the program's reader, perturbs it, and reads it again.
  geodesic_offset::Mesh_input read()
  {
    std::string path;
    if (options_.files.empty())
    {
      path = folder_ + "/generated.off";
      write_off(path, Search_meshes::kinds()[seed_ % number_of_meshes(options_)].second(random_));
    }
    else path = options_.files[seed_ % number_of_meshes(options_)].string();
    geodesic_offset::Mesh_input input(path, geodesic_offset::Border_joining{});
    const std::size_t k = perturbation(options_, seed_);
    if (k == 0) return input;
    Soup soup = soup_of(input.mesh());
    Perturbations::all()[k].second(soup, random_);
    path = folder_ + "/perturbed.off";
    write_off(path, soup);
    return geodesic_offset::Mesh_input(path, geodesic_offset::Border_joining{});
  }

  static void write_off(const std::string& path, const Soup& soup)
  {
    std::ofstream out(path);
    out.precision(17);
    out << "OFF\n" << soup.points.size() << ' ' << soup.triangles.size() << " 0\n";
    for (const Point_3& p : soup.points) out << p << '\n';
    for (const auto& t : soup.triangles) out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  }

  bool draw_sources(const Surface_mesh& mesh)
  {
    const Open_geodesic geodesic(mesh);
    try
    {
      sources_ = Source_drawing(mesh, geodesic, random_)();
    }
    catch (const std::invalid_argument& e)
    {
      text_ = e.what();
      return false;
    }
    return true;
  }

  bool is_lipschitz(const Geodesic& geodesic, const Surface_mesh& mesh)
  {
    for (const auto v : mesh.vertices())
    {
      const double d = geodesic.distance_to_sources(v);
      if (!(d >= 0)) return fail("vertex %zu: distance %.17g", std::size_t(v), d);
      if (std::isfinite(d)) largest_ = (std::max)(largest_, d);
    }
    for (const auto e : mesh.edges())
    {
      const auto u = mesh.vertex(e, 0), v = mesh.vertex(e, 1);
      const double d = geodesic.distance_to_sources(u), other = geodesic.distance_to_sources(v);
      const double l = std::sqrt(CGAL::squared_distance(mesh.point(u), mesh.point(v)));
      if (std::isfinite(d) != std::isfinite(other)) return fail("edge %zu: one end is reached, one is not", std::size_t(e));
      if (std::isfinite(d) && !(std::abs(d - other) <= l + tolerance(d)))
        return fail("edge %zu: distances differ by more than its length, %.3g", std::size_t(e), std::abs(d - other) - l);
    }
    return true;
  }

  // Fractions of the largest distance, distances of vertices, and nearby levels; increasing.
  std::vector<double> draw_levels(const Geodesic& geodesic, const Surface_mesh& mesh)
  {
    std::vector<double> levels;
    const std::size_t n = 1 + uniform_index(random_, 6);
    for (std::size_t i = 0; i < n; ++i)
    {
      const Surface_mesh::Vertex_index v(Surface_mesh::size_type(uniform_index(random_, mesh.number_of_vertices())));
      const double d = geodesic.distance_to_sources(v), kind = uniform(random_);
      const double level =
        kind < 0.5                        ? uniform(random_, 0, 1.01) * largest_
        : kind < 0.6 || !std::isfinite(d) ? log_uniform(random_, -8, -2) * diagonal_
        : kind < 0.8                      ? d
                                          : d * (1 + uniform(random_, -1, 1) * log_uniform(random_, -15, -9));
      if (level > 1e-9 * diagonal_) levels.push_back(level);
    }
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    return levels;
  }

  // Validates the curves of one pass with the kept field.
  bool has_valid_curves(const Geodesic& geodesic, const Surface_mesh& mesh, const std::vector<double>& levels)
  {
    if (levels.empty()) return true;
    Geodesic in_one_pass(geodesic);
    Offset_curves curves;
    in_one_pass.build_with_offset_curves(levels, std::back_inserter(curves));
    CGAL::Geodesic_offset::internal::Validation_options options;
    options.probes = Search_tolerances::validator_probes;
    options.quadrature_faces = Search_tolerances::validator_faces;
    const auto report = CGAL::Geodesic_offset::internal::Offset_validation<Geodesic>(geodesic, mesh, options)(levels, curves);
    if (!report.is_valid()) return fail("%s", report.texts().empty() ? "not valid" : report.texts().front().c_str());
    const std::size_t forced = in_one_pass.statistics().forced_joints;
    if (forced > 0) return fail("%zu forced joints", forced);
    return true;
  }

  Corpus_outcome check_bounds(const Geodesic& geodesic, const Surface_mesh& mesh)
  {
    Enclosure enclosure(mesh);
    sources_.add_to(enclosure);
    try
    {
      enclosure.build();
    }
    catch (const std::runtime_error& e)
    {
      text_ = e.what();
      return UNCERTIFIED;
    }
    double worst = 0;
    for (const auto v : mesh.vertices())
    {
      const double d = geodesic.distance_to_sources(v);
      const std::pair<double, double> bounds = enclosure.distance_bounds(v);
      if (std::isinf(d) && std::isinf(bounds.first) && std::isinf(bounds.second)) continue;
      const double excess = (std::max)(bounds.first - d, d - bounds.second);
      if (!(excess <= tolerance(d)))
      {
        fail("vertex %zu: distance %.17g, bounds [%.17g, %.17g]", std::size_t(v), d, bounds.first, bounds.second);
        return wrong(mesh, WRONG_FIELD);
      }
      worst = (std::max)(worst, excess / (d + diagonal_));
    }
    char text[40];
    std::snprintf(text, sizeof(text), "%.3g", worst);
    text_ = text;
    return RIGHT;
  }

  // Tolerance as for points of curves, in levels plus diagonals.
  double tolerance(double distance) const { return Judge_tolerances::position * (distance + diagonal_); }

  template <class... Values>
  bool fail(const char* format, Values... values)
  {
    char text[400];
    std::snprintf(text, sizeof(text), format, values...);
    text_ = text;
    return false;
  }

  Corpus_outcome wrong(const Surface_mesh& mesh, Corpus_outcome outcome)
  {
    if (!options_.write.empty())
    {
      const std::string name = options_.write + std::to_string(seed_);
      write_off(name + ".off", soup_of(mesh));
      std::ofstream text(name + ".sources.txt");
      sources_.write(text);
    }
    return outcome;
  }

  const Corpus_options& options_;
  const unsigned seed_;
  const std::string folder_;
  Random random_;
  Search_sources sources_;
  double diagonal_ = 0, largest_ = 0;
  std::string text_;
};

/// Runs the corpus and counts outcomes.
class Corpus_run
{
public:
  typedef std::array<std::size_t, NUMBER_OF_OUTCOMES> Counts;

  explicit Corpus_run(const Corpus_options& options) : options_(options) {}

  void run()
  {
    for (std::size_t i = 0; i < options_.runs; ++i) run_case(options_.seed + unsigned(i));
  }

  Counts total() const
  {
    Counts sum{};
    for (const auto& entry : by_perturbation_)
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += entry.second[k];
    return sum;
  }
  /// Number of runs with an inadmissible outcome.
  std::size_t failures() const
  {
    const Counts sum = total();
    return sum[WRONG_FIELD] + sum[WRONG_CURVES] + sum[EXCEPTION] + sum[CRASHED] + sum[OVER_TIME];
  }
  /// Largest deviation of a distance from its certified bounds, in distances plus diagonals.
  double worst_excess() const { return worst_excess_; }

  /// Prints Markdown tables by perturbation and by source.
  void print_tables() const
  {
    const auto print_head = [](const char* name) {
      std::printf("\n| %-22s |", name);
      for (int k = 0; k < NUMBER_OF_OUTCOMES; ++k) std::printf(" %12s |", name_of(Corpus_outcome(k)));
      std::printf("\n|---|");
      for (int k = 0; k < NUMBER_OF_OUTCOMES; ++k) std::printf("---|");
      std::printf("\n");
    };
    const auto print = [](const std::string& name, const Counts& counts) {
      std::printf("| %-22s |", name.c_str());
      for (const std::size_t n : counts) std::printf(" %12zu |", n);
      std::printf("\n");
    };
    print_head("perturbation");
    for (const auto& entry : by_perturbation_) print(entry.first, entry.second);
    print("all", total());
    print_head("sources");
    for (const auto& entry : by_source_) print(entry.first, entry.second);
    std::printf("\nslowest run: seed %u, %.1f s; largest distance from certified bounds: %.2g\n", slowest_seed_, slowest_,
                worst_excess_);
  }

private:
  void run_case(unsigned seed)
  {
    const std::string& perturbation = Perturbations::all()[Corpus_case::perturbation(options_, seed)].first;
    const Scratch_directory scratch;
    const std::string folder = (scratch / "").string();
    const Isolated_result result = run_isolated(options_.seconds, [&] { return Corpus_case::run(options_, seed, folder); });
    Corpus_outcome outcome = result.signal == SIGALRM ? OVER_TIME : CRASHED;
    std::string sources = "none", text = "signal " + std::to_string(result.signal);
    if (!result.text.empty())
    {
      outcome = Corpus_outcome(result.text[0] - '0');
      const std::size_t end = result.text.find('\n', 2);
      if (end > 2) sources = result.text.substr(2, end - 2);
      text = result.text.substr(end + 1);
    }
    ++by_perturbation_[perturbation][outcome];
    ++by_source_[sources.substr(0, sources.find(','))][outcome];
    if (outcome == RIGHT) worst_excess_ = (std::max)(worst_excess_, std::stod(text));
    if (result.seconds > slowest_)
    {
      slowest_ = result.seconds;
      slowest_seed_ = seed;
    }
    const bool is_failure = outcome >= WRONG_FIELD;
    if (!options_.verbose && (!is_failure || ++printed_ > options_.printed)) return;
    std::printf("seed %u, %s, %s, from %s, %.2f s: %s: %s\n", seed, Corpus_case::mesh_name(options_, seed).c_str(),
                perturbation.c_str(), sources.c_str(), result.seconds, name_of(outcome), text.c_str());
    std::fflush(stdout);
  }

  const Corpus_options options_;
  std::map<std::string, Counts> by_perturbation_, by_source_;
  std::size_t printed_ = 0;
  double slowest_ = 0, worst_excess_ = 0;
  unsigned slowest_seed_ = 0;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_CORPUS_RUN_H
