// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Code that must not compile: certified bounds with flags that change the arithmetic, user traits with numbers of CORE,
// functors with the tag of operators that they lack, named parameters that a function does not read, and arguments of the wrong
// kind. ctest checks the messages.

#ifdef REFUSED_TRAITS

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/Radical_numbers.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_offset_traits.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Computation_number.h>

typedef CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Package_traits;

struct Derived_traits : Package_traits // with another functor
{
  struct Compare_distance_2 : Package_traits::Compare_distance_2
  {
  };
  Compare_distance_2 compare_distance_2_object() const { return Compare_distance_2(); }
};

struct Own_traits // not derived
{
  typedef Package_traits::Kernel Kernel;
  typedef Package_traits::FT FT;
};

template <class Traits>
using Computing_traits_of = typename CGAL::Geodesic_offset::internal::Computation<Traits>::Computing_traits;

typedef Computing_traits_of<Derived_traits> Computing_traits_1;
typedef Computing_traits_of<Own_traits> Computing_traits_2;

#elif defined REFUSED_PAIRS

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_offset_traits.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Has_pairs.h>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, CGAL::Surface_mesh<Kernel::Point_3>> Package_traits;

// Functors with the tag of the base, but without its operators for pairs, which theirs hide.
struct Traits : Package_traits
{
  struct Change_frame_2 : Package_traits::Change_frame_2
  {
    Image_2 operator()(double x, double y, double sigma, bool, double, double, double, double) const { return {x, y, sigma}; }
  };
  struct Compute_distance_2 : Package_traits::Compute_distance_2
  {
    double operator()(double, double, double, bool, double, double) const { return 0; }
  };
};

static_assert(CGAL::Geodesic_offset::internal::Has_pair_children<Traits>::value, "");
static_assert(CGAL::Geodesic_offset::internal::Has_pair_distances<Traits>::value, "");

#elif defined REFUSED_PARAMETERS

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>

#include <iostream>
#include <iterator>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>> Geodesic;

namespace parameters = CGAL::parameters;

// Each call has a message of its own.
void refused(const Mesh& mesh, Geodesic& geodesic, std::vector<Geodesic::Offset_curve>& curves,
             Mesh::Property_map<Mesh::Edge_index, double> lengths)
{
  // of another function of CGAL, at the end of a chain
  geodesic.build(parameters::keep_windows(true).number_of_iterations(3));
  // of a mesh, at the start
  geodesic.build(parameters::vertex_point_map(mesh.points()).keep_windows(true));
  // of a source
  geodesic.build(parameters::start_value(1.));
  geodesic.add_source_point(Mesh::Vertex_index(0), parameters::start_value(1.).keep_windows(true));
  // of a build
  Geodesic refused(mesh, parameters::keep_windows(true));
  geodesic.update(parameters::visitor([](double) { return true; }).distance_limit(1.));
  geodesic.offset_curves(1., std::back_inserter(curves), parameters::distance_limit(1.));
  // of a mesh without points, for an enclosure; of a build with a limit
  CGAL::Surface_mesh_geodesic_enclosure<Geodesic::Traits> enclosure(mesh, parameters::edge_length_map(lengths));
  enclosure.build(parameters::distance_limit(1.));
  // of a polyline that is closed or open itself; of a point in space; what was positional
  geodesic.add_source_polyline(Geodesic::Polyline(), parameters::start_value(1.).is_closed(true));
  geodesic.locate(Kernel::Point_3(0, 0, 0), parameters::is_closed(true));
  geodesic.locate_polyline(std::vector<Kernel::Point_3>(), true);
  // of files with a unit, and of files with chords
  CGAL::IO::write_offset_CSV(std::cout, curves, parameters::length_unit(CGAL::IO::Length_unit::METER));
  CGAL::IO::write_offset_SVG(std::cout, curves, parameters::chord_tolerance(0.1));
}

#elif defined REFUSED_ARGUMENTS

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_geodesic_voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_polylines.h>

#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits> Geodesic;
typedef CGAL::Surface_mesh_geodesic_enclosure<Traits> Enclosure;

// Each mistake has one message of its own, and no other.
void refused(Mesh& mesh, const Mesh& constant, Geodesic& geodesic, Enclosure& enclosure, const Kernel::Point_3& point)
{
  const std::vector<Kernel::Point_3> points{point};
  // a temporary mesh, to which the object would refer
  Geodesic of_temporary{Mesh()};
  CGAL::Geodesic_mesh<Traits> mesh_of_temporary{Mesh()};
  Enclosure enclosure_of_temporary{Mesh(), CGAL::parameters::vertex_index_map(get(boost::vertex_index, mesh))};
  // a kernel instead of traits
  CGAL::Surface_mesh_geodesic_offset<Kernel> without_traits(mesh);
  without_traits.add_source_point(Mesh::Vertex_index(0));
  without_traits.build();
  // a mesh that cannot be split
  CGAL::split_along_offset_curves(constant, std::vector<Geodesic::Offset_curve>());
  CGAL::split_along_geodesic_voronoi_diagram(constant, geodesic.field().voronoi_diagram());
  CGAL::split_along_polylines(constant, std::vector<Geodesic::Mesh::Polyline>());
  // a point in space instead of a location
  geodesic.add_source_point(point);
  geodesic.add_source_points(points);
  geodesic.add_source_polyline(points, CGAL::parameters::is_closed(true));
  geodesic.distance_to_sources(point);
  geodesic.join_polyline(points);
  enclosure.add_source_point(point);
}

#else

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>

#endif
