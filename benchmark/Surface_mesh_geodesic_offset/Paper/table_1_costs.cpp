// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Table 1 of the paper: time and memory.
//
//   table_1_costs FOLDER_FOR_PICTURES MODEL...
//
// The sources are the sections by a plane. Offsets at 20 distances are dropped on arrival, so the memory is that of the solver
// alone. Times, of set-up and propagation, are the least processor times of three runs, per vertex, and relative to the first
// model: absolute ones depend on the machine. There are no pictures.

#include "../Performance/counted_heap.h"
#include "experiment.h"

#include <ctime>
#include <optional>

namespace {

using namespace paper;

constexpr std::size_t number_of_levels = 20;
constexpr double megabyte = 1024 * 1024;
constexpr double bytes_per_window = 64; // one cache line
constexpr double bytes_of_paper = 32;   // per vertex: what the memory of each row of its table amounts to

struct Row_of_paper
{
  const char* model;
  double vertices, seconds, megabytes;
};

constexpr Row_of_paper rows_of_paper[] = {
  {"Armadillo", 173e3, 13.385, 5.29}, {"Buddha", 100e3, 3.224, 3.06},    {"Bunny", 75e3, 8.537, 2.23},
  {"Dragon", 750e3, 77.173, 22.90},   {"Gargoyle", 352e3, 31.84, 10.76}, {"Laurana", 10e3, 0.733, 0.33},
  {"Lucy", 263e3, 26.114, 8.04},      {"Moai", 11e3, 0.655, 0.34},       {"Moai", 3e3, 0.06, 0.08},
  {"Two kids", 42e3, 3.931, 1.29}};

void print_paper()
{
  const double first = rows_of_paper[0].seconds / rows_of_paper[0].vertices;
  for (const Row_of_paper& r : rows_of_paper)
    print_row({r.model, text(r.vertices, 6), text(r.seconds / r.vertices / first, 2), text(r.megabytes, 4),
               text(r.megabytes * megabyte / r.vertices, 3)});
}

double spacing_of(const Model& model)
{
  Geodesic geodesic(model.mesh);
  add_section(geodesic, middle_plane(model.box()));
  geodesic.build(CGAL::parameters::compute_largest_distance(true));
  return geodesic.largest_distance().value() / static_cast<double>(number_of_levels + 1);
}

void run(const Model& model, std::optional<double>& first)
{
  const double spacing = spacing_of(model);
  double seconds = geodesic_offset::infinity;
  std::size_t heap_bytes = 0, windows = 0, windows_peak = 0;
  for (int i = 0; i < 3; ++i)
  {
    const benchmark::Counted_heap heap;
    const std::clock_t start = std::clock();
    Geodesic geodesic(model.mesh);
    add_section(geodesic, middle_plane(model.box()));
    geodesic.build_with_offset_curves_by_distance(Levels::equally_spaced(spacing, number_of_levels),
                                                  [](double, const std::vector<Offset_curve>&) {});
    seconds = (std::min)(seconds, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    heap_bytes = heap.peak_bytes();
    windows = geodesic.statistics().windows_propagated;
    windows_peak = geodesic.statistics().windows_peak;
  }
  const double n = static_cast<double>(model.number_of_vertices());
  if (!first) first = seconds / n;
  const double front = bytes_per_window * static_cast<double>(windows_peak);
  print_row({model.name, text(model.number_of_vertices()), text(seconds / n / *first, 2),
             text(static_cast<double>(windows) / n, 3), text(windows_peak), text(front / megabyte, 3),
             text(static_cast<double>(heap_bytes) / megabyte, 3), text(bytes_of_paper * n / megabyte, 3)});
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc > 2)
  {
    std::cout << R"(
## Table 1: Time and Memory

*The paper* has seconds and megabytes, of a Xeon with 2.66 GHz. Times are given here per vertex, and relative to the first row: the
first row has 13.4 seconds for 173K vertices. The paper does not say what the memory consists of. It is about 32 bytes per
vertex in each row, whatever the model and its sources:

)";
    paper::print_header({"model", "vertices", "time per vertex", "MB", "bytes per vertex"});
    print_paper();
    std::cout << R"(
*Here*, offsets at 20 distances of a section by a plane, on the models at hand, in one run. Times include the construction of the
unfolded mesh; they are processor times of one thread, with the first row as unit. The windows at the front are the most at one
time, with 64 bytes each. The peak of the heap includes the unfolded copy of the mesh and excludes the mesh itself. The number of
windows does not depend on the machine.

)";
    paper::print_header({"model", "vertices", "time per vertex", "windows per vertex", "windows at the front",
                         "MB of the front", "MB of the heap", "MB with the paper's 32 bytes per vertex"});
  }
  std::optional<double> first;
  return paper::run_on_models(argc, argv, "table_1_costs", "", [&](const paper::Model& model, const std::string&) {
    run(model, first);
  });
}
