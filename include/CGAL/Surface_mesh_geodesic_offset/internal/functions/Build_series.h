// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Builds one after the other on a mesh, and the rows of a distance matrix that they compute. Each build has the memory of the one
// before, so that it takes the time of what its front reaches.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FUNCTIONS_BUILD_SERIES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FUNCTIONS_BUILD_SERIES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/functions/One_call.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class>
constexpr bool is_geodesic_mesh = false;
template <class... Arguments>
constexpr bool is_geodesic_mesh<Geodesic_mesh<Arguments...>> = true;

// True for points that may be inside faces.
template <class T>
constexpr bool needs_windows = is_point_in_space<T>;
template <class Face, class Coordinates>
constexpr bool needs_windows<std::pair<Face, Coordinates>> = true;

// The mesh of a call: the argument, or one that is set up for a FaceListGraph.
template <class Given_mesh, class NamedParameters>
decltype(auto) mesh_of_call(const Given_mesh& mesh, const NamedParameters& np)
{
  if constexpr (is_geodesic_mesh<Given_mesh>) return (void)np, (mesh);
  else return Mesh_access::make<Geodesic_mesh_type<Given_mesh, NamedParameters>>(mesh, np);
}

template <class Surface>
class Build_series
{
public:
  typedef typename Surface::Number Number;
  typedef Geodesic_build<typename Surface::Computing_traits> Build;

  explicit Build_series(const Geodesic_mesh_data<Surface>& mesh) : m_mesh(mesh), m_memory(mesh.take_memory()) {}
  Build_series(const Build_series&) = delete;
  ~Build_series() { m_mesh.give_back_memory(m_memory); }

  // Replaces the build. It may follow a call that has thrown.
  void build(const Source_set<Number>& sources, Build_request<Number> request)
  {
    request.keeps_memory = true;
    Geodesic_field<Number> memory;
    if (m_memory.front()) memory = std::move(last().field);
    m_memory.front() = nullptr;
    m_memory.front() = std::make_shared<Build>(m_mesh.unfolded(), sources, request, std::move(memory));
    propagate();
  }

  void add_source(Index id, const Surface_point<Number>& p)
  {
    last().add_source(id, p);
    propagate();
  }

  Build& last() const { return *static_cast<Build*>(m_memory.front().get()); }

private:
  void propagate() { last().template propagate<Sequential_tag, Build::parts_for(KEPT_WINDOWS)>(m_mesh.traits); }

  const Geodesic_mesh_data<Surface>& m_mesh;
  std::list<std::shared_ptr<void>> m_memory;
};

// A matrix whose rows are the distances of all targets from one source each.
template <class Surface>
class Distance_matrix
{
public:
  typedef typename Surface::Number Number;
  typedef typename Surface::FT FT;
  typedef std::function<bool(double)> Visitor;
  struct Row
  {
    std::vector<FT> distances;        // per target; infinity where it is not reached
    std::vector<std::size_t> reached; // the other targets, in increasing order
  };

  Distance_matrix(const Geodesic_mesh_data<Surface>& mesh, std::vector<Located_point<Number>> targets)
    : m_mesh(mesh), m_targets(std::move(targets))
  {
    for (std::size_t k = 0; k < m_targets.size(); ++k)
      if (m_targets[k].kind == Surface_point<Number>::VERTEX)
      {
        if (m_targets[k].is_any_copy)
          mesh.unfolded().for_each_copy(m_targets[k].element, [&](Index v) { m_at_vertices.emplace_back(v, k); });
        else m_at_vertices.emplace_back(m_targets[k].element, k);
      }
      else m_elsewhere.push_back(k);
    std::sort(m_at_vertices.begin(), m_at_vertices.end());
  }

  std::size_t number_of_targets() const { return m_targets.size(); }

  std::vector<Source_set<Number>> sources; // per row
  Number maximum = Number_policy<Number>::infinity();
  bool is_half = false;    // row i has the targets from i on
  bool is_in_order = true; // the rows are written in their order
  Visitor visitor;

  // Computes row i into `row`: a new one, or the result of an earlier call. Returns false if the visitor stops it.
  bool compute(std::size_t i, Build_series<Surface>& series, Row& row, const Visitor& goes_on) const
  {
    const FT infinity = Surface::exported(Number_policy<Number>::infinity());
    row.distances.resize(m_targets.size(), infinity);
    for (const std::size_t k : row.reached) row.distances[k] = infinity;
    row.reached.clear();
    Build_request<Number> request;
    request.maximum = maximum;
    request.shared_targets = &m_targets;
    request.first_target = is_half ? i : 0;
    request.keeps_windows = !m_elsewhere.empty() && m_elsewhere.back() >= request.first_target;
    request.goes_on = goes_on;
    if (request.first_target == m_targets.size()) return true;
    series.build(sources[i], request);
    fill(series.last(), request.first_target, row);
    return !series.last().is_cancelled;
  }

  // Writes the rows, one at a time: write(i, row). Returns their number; it is less than that of the sources if the visitor stops.
  template <class Team, class Write>
  std::size_t compute_all(Team& team, const Write& write) const
  {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> is_stopped{false};
    std::mutex mutex; // for the following, and for calls of `write` and of the visitor
    std::size_t number = 0;
    std::map<std::size_t, Row> waiting; // for the rows before them
    const auto goes_on = [&](double) {
      if (is_stopped || !visitor) return !is_stopped;
      const std::lock_guard<std::mutex> lock(mutex);
      const double done = double(number + waiting.size()) / double(sources.size());
      if (!is_stopped && done < 1 && !visitor(done)) is_stopped = true;
      return !is_stopped;
    };
    const auto finish = [&](std::size_t i, Row& row) {
      const std::lock_guard<std::mutex> lock(mutex);
      if (is_stopped) return;
      if (!is_in_order || i == number) write((++number, i), row);
      else waiting.emplace(i, std::exchange(row, Row()));
      for (auto w = waiting.begin(); w != waiting.end() && w->first == number; w = waiting.erase(w)) write(number++, w->second);
    };
    const auto work = [&](unsigned, Index) {
      try
      {
        Build_series<Surface> series(m_mesh);
        Row row;
        for (std::size_t i; !is_stopped && (i = next++) < sources.size();)
          if (compute(i, series, row, goes_on)) finish(i, row);
      }
      catch (...)
      {
        is_stopped = true; // also the other threads
        throw;
      }
    };
    team.for_each(
      Index(team.size()), [](Index) { return std::size_t(1); }, true, work);
    if (!is_stopped && visitor) visitor(1.);
    return number;
  }

private:
  // Takes time in the number of targets that are reached or no vertices.
  template <class Build>
  void fill(const Build& build, std::size_t first, Row& row) const
  {
    const FT infinity = Surface::exported(Number_policy<Number>::infinity());
    const auto set = [&](std::size_t k, const Number& d) {
      if (k < first || d > build.maximum || !Number_policy<Number>::is_finite(d)) return;
      const FT distance = Surface::exported(d);
      if (row.distances[k] < infinity) row.distances[k] = (std::min)(row.distances[k], distance); // another sector at a barrier
      else
      {
        row.distances[k] = distance;
        row.reached.push_back(k);
      }
    };
    const auto& marks = build.field.marks;
    if (marks.are_listed && marks.vertices.size() < m_at_vertices.size())
      for (const Index v : marks.vertices)
        for (auto t = std::lower_bound(m_at_vertices.begin(), m_at_vertices.end(), std::make_pair(v, first));
             t != m_at_vertices.end() && t->first == v; ++t)
          set(t->second, build.field.distance_of_path(v));
    else
      for (const auto& [v, k] : m_at_vertices) set(k, build.field.distance_of_path(v));
    for (const std::size_t k : m_elsewhere)
      if (k >= first) set(k, build.distance(m_targets[k]));
    std::sort(row.reached.begin(), row.reached.end());
  }

  const Geodesic_mesh_data<Surface>& m_mesh;
  const std::vector<Located_point<Number>> m_targets;
  std::vector<std::pair<Index, std::size_t>> m_at_vertices; // vertices, copies included, and targets there, sorted
  std::vector<std::size_t> m_elsewhere;                     // targets that are no vertices
};

} // namespace CGAL::Geodesic_offset::internal

#endif
