// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The functions of the compiled library, in parts that are compiled by themselves. They are those of the core for `double` with the
// predicates of Epick. `instantiation`: `template`, which defines them, or `extern template`, if the definitions are visible, too.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_COMPILATION_COMPILED_FUNCTIONS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_COMPILATION_COMPILED_FUNCTIONS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

// What depends on the team of threads. `Team`: Single_worker or Worker_team.
#define CGAL_GEODESIC_OFFSET_MESH_FUNCTIONS_OF(instantiation, Team)                                                            \
  instantiation Unfolded_mesh<double>::Unfolded_mesh(const Index_renumbering&, const All_face_links&,                          \
                                                     const std::vector<Index>&, const std::vector<Epick_traits::Point_3>&,     \
                                                     const Epick_traits&, Team&);                                              \
  instantiation Unfolded_mesh<double>::Unfolded_mesh(const Index_renumbering&, const All_face_links&,                          \
                                                     const std::vector<Index>&, std::size_t, const std::vector<double>&,       \
                                                     Team&);                                                                   \
  instantiation void Index_renumbering::renumber_if_scattered(const All_face_links&, const std::vector<Index>&,                \
                                                              const Index_renumbering::Coordinates&, Team&);

#define CGAL_GEODESIC_OFFSET_FRONT_FUNCTIONS_OF(instantiation, Tag)                                                            \
  instantiation void Geodesic_build<Epick_traits>::propagate<Tag, ALL_PARTS>(const Epick_traits&);                             \
  instantiation void Geodesic_build<Epick_traits>::run<Tag, ALL_PARTS>(const Epick_traits&,                                    \
                                                                       Geodesic_build<Epick_traits>::Consumer_of<Tag>&);

#define CGAL_GEODESIC_OFFSET_CUTTING_FUNCTIONS_OF(instantiation, Tag)                                                          \
  instantiation void cut_all_faces<Tag>(const Unfolded_mesh<double>&, const Geodesic_build<Epick_traits>&,                     \
                                        const Level_request<double>&, const Level_output<double>&);                            \
  instantiation void cut_finalized_faces<Tag, ALL_PARTS>(const Unfolded_mesh<double>&, Geodesic_build<Epick_traits>&,          \
                                                         const Epick_traits&, const Level_request<double>&,                    \
                                                         const Level_output<double>&);

#ifdef CGAL_LINKED_WITH_TBB
#define CGAL_GEODESIC_OFFSET_PARALLEL(functions) functions
#else
#define CGAL_GEODESIC_OFFSET_PARALLEL(functions)
#endif

#define CGAL_GEODESIC_OFFSET_MESH_FUNCTIONS(instantiation)                                                                     \
  instantiation class Unfolded_mesh<double>;                                                                                   \
  CGAL_GEODESIC_OFFSET_MESH_FUNCTIONS_OF(instantiation, Single_worker)                                                         \
  CGAL_GEODESIC_OFFSET_PARALLEL(CGAL_GEODESIC_OFFSET_MESH_FUNCTIONS_OF(instantiation, Worker_team))

#define CGAL_GEODESIC_OFFSET_LOCATOR_FUNCTIONS(instantiation)                                                                  \
  instantiation class Surface_locator<Epick, double>;                                                                          \
  instantiation class Polyline_joining<Epick_traits, Epick>;

#define CGAL_GEODESIC_OFFSET_SOURCE_FUNCTIONS(instantiation)                                                                   \
  instantiation class Source_set<double>;                                                                                      \
  instantiation class Inner_sides<double>;

#define CGAL_GEODESIC_OFFSET_FRONT_FUNCTIONS(instantiation)                                                                    \
  CGAL_GEODESIC_OFFSET_FRONT_FUNCTIONS_OF(instantiation, Sequential_tag)

#define CGAL_GEODESIC_OFFSET_PARALLEL_FRONT_FUNCTIONS(instantiation)                                                           \
  CGAL_GEODESIC_OFFSET_PARALLEL(CGAL_GEODESIC_OFFSET_FRONT_FUNCTIONS_OF(instantiation, Parallel_tag))

#define CGAL_GEODESIC_OFFSET_PATH_FUNCTIONS(instantiation)                                                                     \
  instantiation class Geodesic_build<Epick_traits>;                                                                            \
  instantiation void Geodesic_build<Epick_traits>::trace_path_in_space(                                                        \
    const Located_point<double>&, const Path_start<double>&, const Surface_points<Epick>&, std::vector<Epick::Point_3>&)       \
    const;

#define CGAL_GEODESIC_OFFSET_CUTTING_FUNCTIONS(instantiation)                                                                  \
  CGAL_GEODESIC_OFFSET_CUTTING_FUNCTIONS_OF(instantiation, Sequential_tag)                                                     \
  CGAL_GEODESIC_OFFSET_PARALLEL(CGAL_GEODESIC_OFFSET_CUTTING_FUNCTIONS_OF(instantiation, Parallel_tag))

#define CGAL_GEODESIC_OFFSET_CERTIFIED_FUNCTIONS(instantiation) // no templates

#define CGAL_GEODESIC_OFFSET_VORONOI_FUNCTIONS(instantiation)                                                                  \
  instantiation Bisector_diagram<double> find_bisectors<double>(const Unfolded_mesh<double>&, const Initial_windows<double>&,  \
                                                                const Geodesic_field<double>&);

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_offset_traits.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_locator.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Inner_sides.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/level_cutting.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Polyline_joining.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_diagram.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// The traits of the computation on `double`, see Computation.
typedef Surface_mesh_geodesic_offset_traits<Epick, void> Epick_traits;

} // namespace CGAL::Geodesic_offset::internal

#endif
