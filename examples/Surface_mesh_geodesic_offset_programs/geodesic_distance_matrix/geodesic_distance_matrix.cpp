// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Program for distance matrices, on one machine or, under mpirun, on several. --help lists the options. Exit codes: 0 all rows are
// written; 1 an error in something that the command line names (one line on stderr); 2 an error in the command line itself.

#include "common/common.h"
#include "common/file_bytes.h"
#include "common/mesh_input.h"
#include "common/output_file.h"
#include "common/program_main.h"
#include "common/text_scanner.h"
#include "common/version.h"
#include "geodesic_offset/progress.h"
#include "geodesic_offset/threads.h"
#include "matrix_layout.h"
#include "options.h"
#include "processes.h"
#include "validate_geodesic_distances/file_vertices.h"

#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_farthest_points.h>

#include <cstddef>
#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace geodesic_offset {
namespace {

// What the first process reads and decides, for all.
struct Task
{
  std::string error; // of the first process
  std::vector<double> coordinates;
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> sources, targets; // vertices of the file
  std::vector<std::size_t> rows; // to compute

  void broadcast(const Processes& processes)
  {
    processes.broadcast(error);
    processes.broadcast(coordinates);
    processes.broadcast(corners);
    processes.broadcast(sources);
    processes.broadcast(targets);
    processes.broadcast(rows);
  }
};

// The mesh, with a vertex for each vertex of the file.
class Matrix_mesh
{
  Mesh_input m_input;
  Geodesic_mesh m_prepared;

public:
  Matrix_mesh(const std::string& path, Mesh_input input) : m_input(std::move(input)), m_prepared(prepared(m_input, path)) {}

  const Mesh_input& input() const { return m_input; }
  const Geodesic_mesh& prepared() const { return m_prepared; }

  std::vector<Vertex> vertices(const std::vector<std::size_t>& file_vertices) const
  {
    std::vector<Vertex> result;
    for(std::size_t i : file_vertices) m_input.for_each_vertex_of(i, [&](Vertex v) { result.push_back(v); });
    return result;
  }

private:
  static Geodesic_mesh prepared(const Mesh_input& input, const std::string& path)
  {
    try
    {
      return Geodesic_mesh(input.mesh());
    }
    catch(const std::invalid_argument& error)
    {
      throw Input_error(quoted(path) + ": " + error.what());
    }
  }
};

std::vector<std::size_t> read_vertices(const std::string& path)
{
  const File_bytes bytes(path);
  Text_scanner text(path, bytes.view(), Text_style::with_comments);
  std::vector<std::size_t> vertices;
  while(text.find_word())
    if(std::size_t v = 0; text.read(v))
      vertices.push_back(v);
    else
      text.fail_here("a vertex index is needed, not " + quoted_word(text.word()));
  if(vertices.empty()) text.fail("it has no vertices");
  return vertices;
}

std::vector<std::size_t> chosen_vertices(const Vertex_choice& choice, const Matrix_mesh& mesh, const std::string& mesh_path)
{
  const Mesh_input& input = mesh.input();
  const std::size_t n = input.soup().points.size();
  std::vector<std::size_t> vertices;
  if(choice.farthest)
  {
    std::vector<std::size_t> file_vertex(n);
    for(std::size_t i = 0; i < n; ++i) input.for_each_vertex_of(i, [&](Vertex v) { file_vertex[v] = i; });
    std::vector<Vertex> selected;
    CGAL::geodesic_farthest_points(mesh.prepared(), *choice.farthest, std::back_inserter(selected));
    for(Vertex v : selected) vertices.push_back(file_vertex[v]);
    return vertices;
  }
  if(choice.file.empty())
    for(std::size_t i = 0; i < n; ++i) vertices.push_back(i);
  else
    vertices = read_vertices(choice.file);
  const std::string from = choice.file.empty() ? quoted(mesh_path) : quoted(choice.file);
  for(std::size_t i : vertices)
    if(i >= n)
      throw Input_error(from + ": vertex " + std::to_string(i) + ": " + quoted(mesh_path) + " has only the vertices 0 to " +
                        std::to_string(n - 1));
    else if(!input.has_vertex(i))
      throw Input_error(from + ": vertex " + std::to_string(i) + " has no face");
  return vertices;
}

class Matrix_computation
{
  const Matrix_options& m_options;
  const Processes& m_processes;
  const Matrix_mesh& m_mesh;
  const Task& m_task;
  Matrix_layout m_layout;
  std::vector<Vertex> m_sources, m_targets;

public:
  Matrix_computation(const Matrix_options& options, const Processes& processes, const Matrix_mesh& mesh, const Task& task)
    : m_options(options), m_processes(processes), m_mesh(mesh), m_task(task),
      m_layout(task.sources.size(), task.targets.size(), options.is_csv()), m_sources(mesh.vertices(task.sources)),
      m_targets(mesh.vertices(task.targets))
  {
  }

  const Matrix_layout& layout() const { return m_layout; }

  // The rows that the output does not have. Throws Input_error if a complete row is that of other input: the first and the last
  // one are computed again.
  std::vector<std::size_t> missing_rows() const
  {
    std::vector<char> is_complete(m_sources.size(), false);
    std::pair<std::size_t, std::string> first, last;
    m_layout.read(m_options.output, [&](std::size_t row, const std::string& bytes) {
      if(first.second.empty()) first = {row, bytes};
      last = {row, bytes};
      is_complete[row] = true;
    });
    for(const auto& [row, bytes] : {first, last})
      if(!bytes.empty())
        compute({row}, CGAL::Sequential_tag(), [&, &bytes = bytes](std::size_t i, const std::vector<double>& distances) {
          if(m_layout.bytes(distances) != bytes)
            throw Input_error("cannot resume " + quoted(m_options.output) + ": row " + std::to_string(i) +
                              " is not that of this mesh, these sources and targets and this cutoff");
        });
    std::vector<std::size_t> missing;
    for(std::size_t i = 0; i < is_complete.size(); ++i)
      if(!is_complete[i]) missing.push_back(i);
    return missing;
  }

  // Computes and writes the rows of the task, with all processes.
  void run(std::optional<std::size_t> threads, Progress* progress) const
  {
    const Working_threads working(threads);
    Shared_file file(m_processes, m_options.output);
    Work_ranges ranges(m_processes, m_task.rows.size(), working.number());
    std::size_t done = 0; // by this process, for the progress of a single one
    for(auto range = ranges.next(); range.first != range.second; range = ranges.next())
    {
      const std::vector<std::size_t> rows(m_task.rows.begin() + static_cast<std::ptrdiff_t>(range.first),
                                          m_task.rows.begin() + static_cast<std::ptrdiff_t>(range.second));
      with_concurrency_tag(threads, [&](auto tag) {
        compute(rows, tag, [&](std::size_t row, const std::vector<double>& distances) {
          const std::string bytes = m_layout.bytes(distances);
          file.write(m_layout.place(row), bytes.data(), bytes.size());
          ++done;
          if(progress == nullptr) return;
          const std::size_t shown = m_processes.number() == 1 ? done : ranges.begun();
          progress->show("rows", double(shown) / double(m_task.rows.size()),
                         std::to_string(shown) + " of " + std::to_string(m_task.rows.size()));
        });
      });
    }
    file.close();
  }

private:
  template <class Tag, class Write>
  void compute(const std::vector<std::size_t>& rows, Tag tag, const Write& write) const
  {
    std::vector<Vertex> sources;
    for(std::size_t row : rows) sources.push_back(m_sources[row]);
    const auto np =
      CGAL::parameters::distance_limit(m_options.cutoff.value_or(infinity)).rows_in_order(false).concurrency_tag(tag);
    CGAL::geodesic_distance_matrix(
      m_mesh.prepared(), sources, m_targets,
      [&](std::size_t i, const std::vector<double>& distances) { write(rows[i], distances); }, np);
  }
};

// Ranges of numbers, such as "0-3, 5"; at most some.
std::string ranges_text(const std::vector<char>& is_in)
{
  constexpr int most = 8;
  std::string text;
  int number = 0;
  for(std::size_t i = 0, end = 0; i < is_in.size(); i = end + 1)
  {
    for(end = i; end < is_in.size() && is_in[end]; ++end) {}
    if(end == i) continue;
    if(++number > most) return text + ", ...";
    text += (text.empty() ? "" : ", ") + std::to_string(i) + (end - i > 1 ? "-" + std::to_string(end - 1) : "");
  }
  return text;
}

// Reads and checks everything, in the first process. The mesh for this process is the result.
std::unique_ptr<Matrix_mesh> prepare(const Matrix_options& options, const Processes& processes, Task& task, Progress& progress)
{
  Output_files::check(options.output);
  require_numbered_vertices(options.mesh);
  Mesh_input input(options.mesh, Border_joining{false, 0});
  require_unchanged_vertices(input, options.mesh);
  if(!input.warning().empty()) print_warning("geodesic_distance_matrix", input.warning());
  auto mesh = std::make_unique<Matrix_mesh>(options.mesh, std::move(input));
  const Soup& soup = mesh->input().soup();
  task.sources = chosen_vertices(options.sources, *mesh, options.mesh);
  task.targets = chosen_vertices(options.targets, *mesh, options.mesh);
  if(processes.number() > 1)
  {
    for(const Point& p : soup.points) task.coordinates.insert(task.coordinates.end(), {p.x(), p.y(), p.z()});
    for(const Polygon& polygon : soup.polygons) task.corners.insert(task.corners.end(), polygon.begin(), polygon.end());
  }
  const Matrix_computation computation(options, processes, *mesh, task);
  std::vector<char> is_complete(task.sources.size(), options.resume);
  if(options.resume)
    task.rows = computation.missing_rows();
  else
    for(std::size_t i = 0; i < task.sources.size(); ++i) task.rows.push_back(i);
  for(std::size_t row : task.rows) is_complete[row] = false;
  if(!options.resume) computation.layout().create(options.output);
  progress.line("mesh: " + quoted(options.mesh) + ", " + counted(soup.points.size(), "vertex", "vertices") + ", " +
                counted(soup.polygons.size(), "face"));
  if(options.resume)
    progress.line("resumed: " + counted(task.sources.size() - task.rows.size(), "row") + " of " +
                  std::to_string(task.sources.size()) +
                  (task.rows.size() == task.sources.size() ? "" : " complete: " + ranges_text(is_complete)));
  return mesh;
}

// The mesh of another process than the first one: from the same points and faces, so that all distances are the same to the bit.
std::unique_ptr<Matrix_mesh> received_mesh(const Matrix_options& options, const Task& task)
{
  Soup soup;
  for(std::size_t i = 0; i < task.coordinates.size(); i += 3)
    soup.points.emplace_back(task.coordinates[i], task.coordinates[i + 1], task.coordinates[i + 2]);
  for(std::size_t i = 0; i < task.corners.size(); i += 3)
    soup.polygons.push_back({task.corners[i], task.corners[i + 1], task.corners[i + 2]});
  return std::make_unique<Matrix_mesh>(options.mesh, Mesh_input(options.mesh, std::move(soup), Border_joining{false, 0}));
}

int compute_matrix(const Matrix_options& options, const Processes& processes)
{
  const Stopwatch stopwatch;
  Progress progress(options.quiet || !processes.is_first());
  Task task;
  std::unique_ptr<Matrix_mesh> mesh;
  try
  {
    if(processes.is_first()) mesh = prepare(options, processes, task, progress);
  }
  catch(const std::exception& error)
  {
    task.error = error.what();
  }
  task.broadcast(processes);
  if(!task.error.empty())
  {
    if(processes.is_first()) throw Input_error(task.error);
    return 1;
  }
  try
  {
    if(!mesh) mesh = received_mesh(options, task);
    const Matrix_computation computation(options, processes, *mesh, task);
    const std::optional<std::size_t> threads = !options.threads && processes.number() > 1 ? 1 : options.threads;
    computation.run(threads, processes.is_first() ? &progress : nullptr);
    processes.wait_for_all();
    progress.line("matrix: " + quoted(options.output) + ", " + counted(task.sources.size(), "row") + " and " +
                  counted(task.targets.size(), "column") + ", " + memory_size(computation.layout().file_size()));
    progress.line(counted(task.rows.size(), "row") + " computed by " +
                    counted(static_cast<std::size_t>(processes.number()), "process", "processes") + " with " +
                    counted(Working_threads(threads).number(), "thread"),
                  stopwatch.seconds());
  }
  catch(const std::exception& error)
  {
    if(processes.number() == 1) throw;
    std::cerr << "geodesic_distance_matrix: " << one_line(error.what()) << std::endl;
    processes.abort();
  }
  return 0;
}

} // namespace
} // namespace geodesic_offset

int main(int argc, char* argv[])
{
  using namespace geodesic_offset;
#ifdef GEODESIC_OFFSET_HAS_MPI
  const char* const more = ", Boost.MPI";
#else
  const char* const more = "";
#endif
  return program_main("geodesic_distance_matrix", [&] {
    const Processes processes;
    try
    {
      const Matrix_options options = parse_matrix_options(argc, argv);
      if(!options.help && !options.version) return compute_matrix(options, processes);
      if(processes.is_first() && options.help) print_matrix_help(std::cout);
      if(processes.is_first() && options.version) print_version(std::cout, "geodesic_distance_matrix", more);
      return 0;
    }
    catch(const Usage_error&)
    {
      if(processes.is_first()) throw;
      return 2;
    }
  });
}
