// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs of the oracle of `offset_oracle.h` on random windows, and on faces of generated meshes.

#ifndef GEODESIC_OFFSET_TEST_ORACLE_RUN_H
#define GEODESIC_OFFSET_TEST_ORACLE_RUN_H

#include "offset_oracle.h"
#include "random_windows.h"
#include "search_cases.h"

#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace test {

struct Oracle_options
{
  unsigned seed = 1; // of the first case; consecutive
  std::size_t faces = 1000;
  std::size_t each = 20;    // maximum number of faces per mesh
  std::size_t windows = 80; // maximum number of windows per face; others are skipped
  std::size_t printed = 20; // maximum number of printed differences
  double seconds = 1e9;     // no case starts later
};

class Oracle_run
{
public:
  explicit Oracle_run(const Oracle_options& options) : options_(options) { oracle_.most_windows = options.windows; }

  void random_windows()
  {
    for (unsigned seed = options_.seed; goes_on(); ++seed)
    {
      name_ = "random windows, seed " + std::to_string(seed);
      with_exceptions([&] {
        Random random(seed);
        Random_windows windows(random);
        Face_tracing tracing(windows.mesh(), windows.initial(), windows.field());
        compare(tracing, windows.face(), windows.level());
      });
    }
  }

  void real_faces()
  {
    const auto& kinds = Search_meshes::kinds();
    for (unsigned seed = options_.seed; goes_on(); ++seed)
    {
      const auto& kind = kinds[seed % kinds.size()];
      name_ = "real faces, seed " + std::to_string(seed) + ", " + kind.first;
      with_exceptions([&] {
        Random random(seed);
        const Generated_mesh<Surface_mesh> data(kind.second(random));
        of_mesh(data.mesh, random);
      });
    }
  }

  const Oracle_counts& counts() const { return oracle_.counts; }

  static void print_head()
  {
    std::printf("%-15s %8s %7s %8s %6s %9s %9s %7s %7s %7s %7s %6s %9s %6s %6s %6s %9s\n", "kind", "faces", "empty", "chains",
                "loops", "pieces", "windows", "points", "event", "band", "ill", "left", "topology", "apart", "forced", "thrown",
                "distance");
  }
  void print(const char* name) const
  {
    const Oracle_counts& c = counts();
    std::printf("%-15s %8zu %7zu %8zu %6zu %9zu %9zu %7zu %7zu %7zu %7zu %6zu %9zu %6zu %6zu %6zu %9.1e\n", name, c.faces,
                c.empty, c.chains, c.loops, c.arcs, c.windows, c.with_points, c.near_event, c.within_band, c.ill_conditioned,
                c.left_out, c.topology, c.apart, c.forced, c.thrown, c.worst_distance);
    std::fflush(stdout);
  }

private:
  bool goes_on() const
  {
    return counts().faces < options_.faces &&
           std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() <= options_.seconds;
  }

  template <class Function>
  void with_exceptions(const Function& f)
  {
    try
    {
      f();
    }
    catch (const std::exception& e)
    {
      ++oracle_.counts.thrown;
      print_difference(std::string("exception: ") + e.what());
    }
  }

  void of_mesh(const Surface_mesh& mesh, Random& random)
  {
    Cut_geodesic geodesic(mesh);
    const Search_sources sources = Source_drawing(mesh, geodesic, random)();
    sources.add_to(geodesic);
    name_ += " of " + std::to_string(mesh.number_of_faces()) + " faces, " + sources.kind;
    geodesic.build(CGAL::parameters::keep_windows(true));
    const Judged_surface surface(geodesic, mesh);
    const double largest = geodesic.largest_distance().value();
    const Field_features features(geodesic, mesh, surface, random);
    std::vector<double> levels = Level_drawing(features, surface.diagonal(), random)(4);
    for (int i = 0; i < 4; ++i) levels.push_back(uniform(random, 0.001, 1) * largest);

    Face_tracing tracing(geodesic.mesh(), geodesic.initial(), geodesic.field());
    for (const double level : levels)
    {
      // faces crossed by the level, according to the distances of their corners
      std::vector<Surface_mesh::Face_index> crossed;
      for (const auto f : mesh.faces())
      {
        double low, high;
        surface.range_of(surface.face_at(surface.index_of(f)), low, high);
        if (level > 0 && low < level && level <= high) crossed.push_back(f);
      }
      const std::size_t number = (std::min)(crossed.size(), options_.each / levels.size() + 1);
      for (std::size_t i = 0; i < number && goes_on(); ++i)
      {
        std::swap(crossed[i], crossed[i + uniform_index(random, crossed.size() - i)]);
        compare(tracing, geodesic.field_index(crossed[i]), level);
      }
    }
  }

  void compare(Face_tracing& tracing, Face_tracing::Index face, double level)
  {
    oracle_.compare(tracing, face, level, [this](const std::string& text) { print_difference(text); });
  }

  void print_difference(const std::string& text)
  {
    if (++printed_ <= options_.printed) std::printf("%s, %s\n", name_.c_str(), text.c_str());
    std::fflush(stdout);
  }

  const Oracle_options options_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  Offset_oracle oracle_;
  std::string name_; // of the case
  std::size_t printed_ = 0;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_ORACLE_RUN_H
