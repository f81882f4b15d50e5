// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Search for wrong offset curves: random cases of `search_cases.h`, judged by `level_judge.h`.

#ifndef GEODESIC_OFFSET_TEST_OFFSET_SEARCH_H
#define GEODESIC_OFFSET_TEST_OFFSET_SEARCH_H

#include "level_judge.h"
#include "offset_tools.h"
#include "search_cases.h"
#include "validation/Offset_validation.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <vector>

namespace test {

struct Search_options
{
  unsigned seed = 1;         // of the first case; consecutive
  std::size_t meshes = 1000; // cases
  double seconds = 1e9;      // no case starts later
  std::size_t levels = 16;   // per mesh
  std::string kind;          // of meshes; all if empty
  std::size_t sources = 0;   // if not 0: sources of up to so many kinds, and some meshes jittered
  double level = 0;          // if nonzero, the only level
  std::size_t validate = 10; // period of validations by Offset_validation; 0: none
  std::size_t printed = 100; // maximum number of printed failures
  bool verbose = false;      // print each case
  std::string write;         // prefix of the files of wrong cases
};

/// Results for a kind of meshes or in total.
struct Search_counts
{
  std::size_t meshes = 0, levels = 0, pieces = 0;
  std::size_t wrong = 0;                     // levels whose curves are wrong
  std::size_t faults[NUMBER_OF_FAULTS] = {}; // levels with this fault
  std::size_t critical = 0;                  // levels whose topology differs in one pass, within rounding of an event
  std::size_t forced_joints = 0, exceptions = 0;
  std::size_t validated = 0, invalid = 0; // meshes, by Offset_validation
  double worst_gap = 0, worst_outside = 0, worst_off = 0;

  void add(const Search_counts& other)
  {
    meshes += other.meshes;
    levels += other.levels;
    pieces += other.pieces;
    wrong += other.wrong;
    critical += other.critical;
    for (int k = 0; k < NUMBER_OF_FAULTS; ++k) faults[k] += other.faults[k];
    forced_joints += other.forced_joints;
    exceptions += other.exceptions;
    validated += other.validated;
    invalid += other.invalid;
    worst_gap = (std::max)(worst_gap, other.worst_gap);
    worst_outside = (std::max)(worst_outside, other.worst_outside);
    worst_off = (std::max)(worst_off, other.worst_off);
  }
};

class Offset_search
{
public:
  explicit Offset_search(const Search_options& options) : options_(options) {}

  /// Runs all cases; prints the wrong ones.
  void run()
  {
    const double start = now();
    for (std::size_t i = 0; i < options_.meshes && now() - start <= options_.seconds; ++i)
      run_case(options_.seed + static_cast<unsigned>(i));
  }

  /// Seed and start time of the current case, for watchdogs in other threads.
  unsigned running_seed() const { return running_seed_; }
  double seconds_of_running_case() const { return now() - started_; }

  Search_counts total() const
  {
    Search_counts sum;
    for (const auto& c : counts_) sum.add(c.second);
    return sum;
  }

  void print_table() const
  {
    std::printf("%-16s %7s %8s %9s %8s %6s %6s %6s", "kind", "meshes", "levels", "pieces", "critical", "wrong", "forced",
                "thrown");
    for (int k = 0; k < NUMBER_OF_FAULTS; ++k) std::printf(" %8s", name_of(Fault(k)));
    std::printf(" %13s %8s %8s %8s\n", "invalid", "gap", "outside", "off");
    for (const auto& c : counts_) print_row(c.first, c.second);
    print_row("all", total());
  }

private:
  static void print_row(const std::string& name, const Search_counts& c)
  {
    std::printf("%-16s %7zu %8zu %9zu %8zu %6zu %6zu %6zu", name.c_str(), c.meshes, c.levels, c.pieces, c.critical, c.wrong,
                c.forced_joints, c.exceptions);
    for (int k = 0; k < NUMBER_OF_FAULTS; ++k) std::printf(" %8zu", c.faults[k]);
    std::printf(" %5zu of %4zu %8.1e %8.1e %8.1e\n", c.invalid, c.validated, c.worst_gap, c.worst_outside, c.worst_off);
  }

  static double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

  void run_case(unsigned seed)
  {
    running_seed_ = seed;
    started_ = now();
    Random random(seed);
    const auto& kinds = Search_meshes::kinds();
    std::size_t kind = seed % kinds.size();
    for (std::size_t k = 0; k < kinds.size(); ++k)
      if (kinds[k].first == options_.kind) kind = k;
    Search_counts& counts = counts_[kinds[kind].first];
    name_ = "seed " + std::to_string(seed) + ", " + kinds[kind].first;
    ++counts.meshes;
    try
    {
      Soup soup = kinds[kind].second(random);
      if (options_.sources > 0 && uniform(random) < 0.3) jitter(soup, random);
      const Generated_mesh<Surface_mesh> data(soup);
      run_mesh(data.mesh, seed, random, counts);
    }
    catch (const std::exception& e)
    {
      ++counts.exceptions;
      print(std::string("exception: ") + e.what());
    }
  }

  void run_mesh(const Surface_mesh& mesh, unsigned seed, Random& random, Search_counts& counts)
  {
    Open_geodesic geodesic(mesh);
    Source_drawing drawing(mesh, geodesic, random);
    const Search_sources sources = options_.sources > 0 ? drawing.several(options_.sources) : drawing();
    name_ += " of " + std::to_string(mesh.number_of_faces()) + " faces, " + sources.kind;
    sources.add_to(geodesic);
    geodesic.build(CGAL::parameters::keep_windows(true));
    const Judged_surface surface(geodesic, mesh);
    const Field_features features(geodesic, mesh, surface, random);
    std::vector<double> levels = Level_drawing(features, surface.diagonal(), random)(options_.levels);
    if (options_.level > 0) levels = {options_.level};
    if (levels.empty()) return;
    if (options_.verbose) print(std::to_string(levels.size()) + " levels");

    Offset_curves kept, in_one_pass;
    geodesic.offset_curves(levels, std::back_inserter(kept));
    Geodesic again(geodesic);
    again.build_with_offset_curves(levels, std::back_inserter(in_one_pass));
    counts.forced_joints += again.statistics().forced_joints;
    if (again.statistics().forced_joints > 0)
    {
      print("forced joints: " + std::to_string(again.statistics().forced_joints));
      if (!options_.write.empty()) write(seed, mesh, sources);
    }

    Level_judge judge(surface, features);
    std::vector<Verdict> verdicts;
    for (const double level : levels)
    {
      const auto curves = of_level(kept, level), other_curves = of_level(in_one_pass, level);
      verdicts.push_back(judge.judge(level, curves));
      if (!same_pieces(curves, other_curves))
        compare(geodesic, level, surface.diagonal(), judge.judge(level, other_curves), verdicts.back(), counts);
    }
    if (!sources.polylines.empty()) check_sides(geodesic, levels, kept, surface.diagonal(), verdicts);
    check_growth(levels, surface.diagonal(), verdicts);
    bool is_right = true;
    for (std::size_t i = 0; i < levels.size(); ++i)
    {
      count(levels[i], verdicts[i], counts);
      is_right = is_right && verdicts[i].is_right();
    }
    if (!is_right && !options_.write.empty()) write(seed, mesh, sources);
    if (is_right && options_.validate > 0 && ++unvalidated_ >= options_.validate)
      validate(geodesic, mesh, levels, kept, counts);
  }

  static std::vector<const Offset_curve*> of_level(const Offset_curves& curves, double level)
  {
    std::vector<const Offset_curve*> result;
    for (const Offset_curve& c : curves)
      if (c.distance() == level) result.push_back(&c);
    return result;
  }

  static bool same_pieces(const std::vector<const Offset_curve*>& a, const std::vector<const Offset_curve*>& b)
  {
    const auto keys = [](const std::vector<const Offset_curve*>& curves) {
      std::vector<Piece_key> result;
      for (const Offset_curve* c : curves)
        for (const Offset_piece& p : c->pieces()) result.push_back(key_of(p));
      std::sort(result.begin(), result.end());
      return result;
    };
    return a.size() == b.size() && keys(a) == keys(b);
  }

  static void compare(const Geodesic& geodesic, double level, double diagonal, const Verdict& one_pass, Verdict& verdict,
                      Search_counts& counts)
  {
    for (const std::string& text : one_pass.texts) verdict.add(ONE_PASS, "%s", text.c_str());
    const double tolerance = Search_tolerances::length * (verdict.length + level + diagonal);
    if (std::abs(one_pass.length - verdict.length) <= tolerance) return;
    // At changes of topology rounding decides: compare with the lengths of neighbouring levels.
    double shortest = verdict.length, longest = verdict.length;
    for (const double step : Search_tolerances::level_steps)
      for (const double off : {-step, step})
      {
        const double length = total_length(offsets(geodesic, level + off * (level + diagonal)));
        shortest = (std::min)(shortest, length);
        longest = (std::max)(longest, length);
      }
    if (shortest - tolerance <= one_pass.length && one_pass.length <= longest + tolerance) ++counts.critical;
    else verdict.add(ONE_PASS, "length %.17g, from kept windows %.17g", one_pass.length, verdict.length);
  }

  // The pieces of both sides together are those of the whole, and so are their lengths.
  static void check_sides(const Geodesic& geodesic, const std::vector<double>& levels, const Offset_curves& whole,
                          double diagonal, std::vector<Verdict>& verdicts)
  {
    for (const CGAL::Offset_side side : {CGAL::Offset_side::LEFT, CGAL::Offset_side::RIGHT})
    {
      const CGAL::Source_side of_piece = side == CGAL::Offset_side::LEFT ? CGAL::Source_side::LEFT : CGAL::Source_side::RIGHT;
      const Offset_curves part = offsets(geodesic, levels, Offset_selection(side, CGAL::Offset_end::BUTT));
      for (std::size_t i = 0; i < levels.size(); ++i)
      {
        double expected = 0, actual = 0, in_short_parts = 0;
        for (const Offset_curve* c : of_level(whole, levels[i]))
        {
          std::vector<std::pair<bool, double>> parts; // whether they are of this side, and their lengths
          for (const Offset_piece& p : c->pieces())
          {
            const bool is_of_side = p.side() == of_piece || p.side() == CGAL::Source_side::NONE;
            if (is_of_side) expected += p.length();
            if (parts.empty() || parts.back().first != is_of_side) parts.emplace_back(is_of_side, 0);
            parts.back().second += p.length();
          }
          if (c->is_closed() && parts.size() > 1 && parts.front().first == parts.back().first)
          {
            parts.front().second += parts.back().second;
            parts.pop_back();
          }
          for (const auto& p : parts)
            if (p.second <= Search_tolerances::part_of_rounded_side * levels[i]) in_short_parts += p.second;
        }
        for (const Offset_curve* c : of_level(part, levels[i])) actual += c->length();
        if (!(std::abs(actual - expected) <= in_short_parts + Search_tolerances::length * (expected + levels[i] + diagonal)))
          verdicts[i].add(SIDES, "length %.17g, pieces of this side in the whole %.17g", actual, expected);
      }
    }
  }

  // The area grows with the level, at the rate of the length of the curves.
  static void check_growth(const std::vector<double>& levels, double diagonal, std::vector<Verdict>& verdicts)
  {
    for (std::size_t i = 1; i < levels.size(); ++i)
    {
      const Verdict &a = verdicts[i - 1], &b = verdicts[i];
      if (!a.is_right() || !b.is_right()) continue;
      const double scale = levels[i] + diagonal, step = levels[i] - levels[i - 1];
      const double longest = Search_tolerances::longest_between * (a.length + b.length + diagonal);
      const double growth = b.area - a.area, rounding = Search_tolerances::area * scale;
      const bool is_short = step < Search_tolerances::longest_step * scale;
      if (!(growth >= -rounding * longest) || (is_short && !(growth <= (step + rounding) * longest)))
        verdicts[i].add(AREA, "grows by %.6g from %.17g to %.17g", growth, levels[i - 1], levels[i]);
    }
  }

  void count(double level, const Verdict& verdict, Search_counts& counts)
  {
    ++counts.levels;
    counts.pieces += verdict.pieces;
    counts.worst_gap = (std::max)(counts.worst_gap, verdict.worst_gap);
    counts.worst_outside = (std::max)(counts.worst_outside, verdict.worst_outside);
    counts.worst_off = (std::max)(counts.worst_off, verdict.worst_off);
    if (verdict.is_right()) return;
    ++counts.wrong;
    for (int k = 0; k < NUMBER_OF_FAULTS; ++k) counts.faults[k] += verdict.faults[k] > 0 ? 1 : 0;
    char buffer[80];
    std::snprintf(buffer, sizeof(buffer), "level %.17g, length %.9g", level, verdict.length);
    std::string text = buffer;
    for (const std::string& t : verdict.texts) text += "\n    " + t;
    print(text);
  }

  void validate(const Open_geodesic& geodesic, const Surface_mesh& mesh, const std::vector<double>& levels,
                const Offset_curves& curves, Search_counts& counts)
  {
    CGAL::Geodesic_offset::internal::Validation_options options;
    options.probes = Search_tolerances::validator_probes;
    options.quadrature_faces = Search_tolerances::validator_faces;
    const Geodesic& base = geodesic;
    const auto report = CGAL::Geodesic_offset::internal::Offset_validation<Geodesic>(base, mesh, options)(levels, curves);
    ++counts.validated;
    unvalidated_ = 0;
    if (report.is_valid()) return;
    ++counts.invalid;
    std::string text = "not valid:";
    for (const std::string& t : report.texts()) text += "\n    " + t;
    print(text);
  }

  void write(unsigned seed, const Surface_mesh& mesh, const Search_sources& sources) const
  {
    const std::string name = options_.write + std::to_string(seed);
    std::ofstream off(name + ".off"), text(name + ".sources.txt");
    off.precision(17);
    CGAL::IO::write_OFF(off, mesh);
    sources.write(text);
  }

  void print(const std::string& text)
  {
    if (++printed_ > options_.printed && !options_.verbose) return;
    std::printf("%s: %s\n", name_.c_str(), text.c_str());
    std::fflush(stdout);
  }

  const Search_options options_;
  std::map<std::string, Search_counts> counts_;
  std::string name_;
  std::size_t printed_ = 0, unvalidated_ = 0;
  std::atomic<unsigned> running_seed_{0};
  std::atomic<double> started_{0};
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_OFFSET_SEARCH_H
