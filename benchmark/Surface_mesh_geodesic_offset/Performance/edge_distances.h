// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Lengths of shortest paths along edges, by Boost's Dijkstra algorithm.

#ifndef GEODESIC_OFFSET_BENCHMARK_EDGE_DISTANCES_H
#define GEODESIC_OFFSET_BENCHMARK_EDGE_DISTANCES_H

#include "initial_distances.h"

#include <CGAL/boost/graph/graph_traits_Surface_mesh.h>
#include <CGAL/boost/graph/properties_Surface_mesh.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/property_map.hpp>

#include <functional>
#include <limits>
#include <vector>

namespace benchmark {

/// Unreachable vertices are at infinity.
template <class Mesh>
std::vector<double> edge_distances(const Mesh& mesh, const Initial_distances<Mesh>& start)
{
  typedef typename Mesh::Vertex_index Vertex_index;
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> distances(mesh.number_of_vertices(), infinity), lengths(mesh.number_of_edges());
  for (auto e : mesh.edges()) lengths[e.idx()] = get(get(boost::edge_weight, mesh), e);
  std::vector<Vertex_index> vertices;
  for (const auto& s : start)
  {
    vertices.push_back(s.first);
    distances[s.first] = s.second;
  }
  const auto vertex_index = get(boost::vertex_index, mesh);
  boost::dijkstra_shortest_paths_no_init(
    mesh, vertices.begin(), vertices.end(), boost::dummy_property_map(),
    boost::make_iterator_property_map(distances.begin(), vertex_index),
    boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh)), vertex_index, std::less<double>(),
    boost::closed_plus<double>(infinity), 0., boost::dijkstra_visitor<>());
  return distances;
}

} // namespace benchmark

#endif // GEODESIC_OFFSET_BENCHMARK_EDGE_DISTANCES_H
