// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// All public headers, and a use of each class and function template of the package: compiled with the headers of another release
// of CGAL, without its deprecated code.

#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_mesh_type.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/Offset_level_writer.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/Radical_numbers.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>
#include <CGAL/Surface_mesh_geodesic_offset/construct_geodesic_voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_farthest_points.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_voronoi_labels.h>
#include <CGAL/Surface_mesh_geodesic_offset/nest_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/shortest_path_to_sources.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_geodesic_voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_polylines.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Surface_mesh.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cstddef>
#include <iostream>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;

namespace parameters = CGAL::parameters;

template <class Mesh>
void use_class(const Mesh& mesh)
{
  typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
  typedef CGAL::Surface_mesh_geodesic_offset<Traits> Geodesic;
  Geodesic geodesic(mesh, parameters::geom_traits(Traits()).concurrency_tag(CGAL::Sequential_tag()));
  const auto v = *vertices(mesh).begin();
  geodesic.add_source_point(v, parameters::start_value(0.5));
  const auto line = geodesic.locate_polyline(std::vector<Point_3>{Point_3(0, 0, 0), Point_3(1, 0, 0)});
  geodesic.add_source_polyline(line);
  geodesic.add_source_plane_section(Kernel::Plane_3(0, 0, 1, 0));
  geodesic.add_source_boundary();
  geodesic.add_source_sharp_edges(30);
  geodesic.build(parameters::keep_windows(true).visitor([](double) { return true; }));
  geodesic.update(parameters::verbose(true));
  const auto field = geodesic.field();
  std::vector<typename Geodesic::Face_location> path;
  field.shortest_path_to_sources(v, std::back_inserter(path));
  (void)field.nearest_source(path.front());
  (void)field.gradient(v);
  (void)field.signed_distance_to_sources(v);
  (void)field.farthest_point();
  std::vector<typename Geodesic::Offset_curve> curves;
  field.offset_curves(std::vector<double>{0.1, 0.2}, std::back_inserter(curves),
                      parameters::end_style(CGAL::Offset_end::BUTT).offset_side(CGAL::Offset_side::LEFT));
  for (const char* const name : {"a.vtk", "a.dxf", "a.svg"})
    CGAL::IO::write_offset_curves(name, curves, parameters::chord_tolerance(0.1));
  CGAL::IO::Offset_level_writer writer(std::cout, CGAL::IO::Offset_file_format::VTP, parameters::chord_tolerance(0.1));
  writer.write(curves);
  writer.finish();

  CGAL::Surface_mesh_geodesic_enclosure<Traits> enclosure(mesh);
  enclosure.add_sources(geodesic.sources());
  enclosure.build(parameters::keep_windows(true));
  (void)enclosure.distance_bounds(v);
  (void)enclosure.certify_offset(0.1, curves);
}

template <class Mesh>
void use_functions(const Mesh& mesh)
{
  const auto v = *vertices(mesh).begin();
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, double> distance;
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, std::size_t> label;
  CGAL::geodesic_distances(mesh, v, boost::make_assoc_property_map(distance), parameters::relative_tolerance(1e-3));
  CGAL::geodesic_voronoi_labels(mesh, v, boost::make_assoc_property_map(label));
  CGAL::geodesic_farthest_points(mesh, 3, boost::make_function_output_iterator([&](auto u) { label[u] = 0; }),
                                 parameters::start_set(v));
  CGAL::geodesic_distance_matrix(mesh, vertices(mesh), vertices(mesh), [](std::size_t, const auto&) {});
  distance[v] = CGAL::to_double(CGAL::geodesic_distance(mesh, v, get(CGAL::vertex_point, mesh, v)));
  std::vector<CGAL::Geodesic_offset_curve_type<Mesh>> curves;
  CGAL::geodesic_offset_curves(mesh, v, 0.1, std::back_inserter(curves), parameters::distance_limit(1));
  std::vector<Point_3> path;
  CGAL::shortest_path_to_sources(mesh, v, v, std::back_inserter(path));
  Mesh split = mesh;
  CGAL::split_along_offset_curves(split, curves,
                                  parameters::chord_tolerance(0.1).visitor(CGAL::Default_offset_splitting_visitor<Mesh>()));
  CGAL::split_along_polylines(split, std::vector<typename CGAL::Geodesic_mesh_type<Mesh>::Polyline>());
}

template <class Mesh>
void use_diagram(const Mesh& mesh)
{
  const auto diagram = CGAL::construct_geodesic_voronoi_diagram(mesh, vertices(mesh));
  Mesh split = mesh;
  CGAL::split_along_geodesic_voronoi_diagram(split, diagram, parameters::chord_tolerance(0.1));
}

// with lengths of edges in place of points
template <class Mesh, class Edge_length_map>
void use_lengths(const Mesh& mesh, Edge_length_map lengths)
{
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, double> distance;
  CGAL::geodesic_distances(mesh, *vertices(mesh).begin(), boost::make_assoc_property_map(distance),
                           parameters::edge_length_map(lengths));
}

// with a kernel that has exact square roots
template <class Mesh>
void use_exact_kernel(const Mesh& mesh)
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt Exact_kernel;
  typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Exact_kernel, Mesh>> Geodesic;
  Geodesic geodesic(mesh);
  geodesic.add_source_point(*vertices(mesh).begin());
  geodesic.build(parameters::keep_windows(true));
  std::vector<typename Geodesic::Offset_curve> curves;
  geodesic.offset_curves(Exact_kernel::FT(1), std::back_inserter(curves));
  std::vector<Exact_kernel::Point_3> path;
  geodesic.shortest_path_points_to_sources(geodesic.farthest_point()->first, std::back_inserter(path));
}

#ifdef CGAL_LINKED_WITH_TBB
template <class Mesh>
void use_threads(const Mesh& mesh)
{
  typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
  CGAL::Surface_mesh_geodesic_offset<Traits> geodesic(mesh, parameters::concurrency_tag(CGAL::Parallel_tag()));
  geodesic.add_source_point(*vertices(mesh).begin());
  geodesic.build(parameters::concurrency_tag(CGAL::Parallel_tag()));
}
#endif

typedef CGAL::Surface_mesh<Point_3> Surface_mesh;
typedef CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3> Polyhedron;
typedef CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3> Exact_mesh;

template void use_class(const Surface_mesh&);
template void use_class(const Polyhedron&);
template void use_functions(const Surface_mesh&);
template void use_functions(const Exact_mesh&);
template void use_diagram(const Surface_mesh&);
template void use_diagram(const Polyhedron&);
template void use_lengths(const Surface_mesh&, Surface_mesh::Property_map<Surface_mesh::Edge_index, double>);
template void use_exact_kernel(const Surface_mesh&);
#ifdef CGAL_LINKED_WITH_TBB
template void use_threads(const Surface_mesh&);
#endif
