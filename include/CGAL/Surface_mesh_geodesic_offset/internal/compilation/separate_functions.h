// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The instances of templates that may be compiled separately, see separate_compilation.h: those that take the compiler longest
// and do not depend on the type of the mesh, for double or the kernel Epick, and for one thread. All other instances are
// compiled where they are used.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_COMPILATION_SEPARATE_FUNCTIONS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_COMPILATION_SEPARATE_FUNCTIONS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#ifdef CGAL_GEODESIC_OFFSET_SEPARATE_COMPILATION

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_offset_traits.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Inner_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/cut_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Near_path.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Source_set.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/voronoi_extraction.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <map>

// List of explicit instantiations. Members in the list are defined outside of their classes, and no function is `inline` or
// returns `auto`: `extern template` does not suppress the instantiation of such functions.
// `instantiation`: `extern template`, which declares, or `template`, which defines.
#define CGAL_GEODESIC_OFFSET_SEPARATE_FUNCTIONS(instantiation)                                                                 \
  instantiation Initial_windows<double> Source_set<double>::initial_windows(const Unfolded_mesh<double>&) const;               \
  instantiation void Source_set<double>::check(const Unfolded_mesh<double>&, const Source_set<double>::Source&);               \
  instantiation void Geodesic_build<Epick_traits>::propagate<Sequential_tag, false>(const Epick_traits&);                      \
  instantiation void cut_finalized_faces<Sequential_tag, false>(                                                               \
    const Unfolded_mesh<double>&, Geodesic_build<Epick_traits>&, const Epick_traits&, const Offset_levels<double>&,            \
    const Level_output<double>&);                                                                                              \
  instantiation void cut_all_faces<Sequential_tag>(const Unfolded_mesh<double>&, const Geodesic_build<Epick_traits>&,          \
                                                   const Offset_levels<double>&, const Level_output<double>&);                 \
  instantiation double Near_path<double>::distance(const Located_point<double>&, Suffix_cache_on_mesh&) const;                 \
  instantiation Path_start<double> Near_path<double>::operator()(const Located_point<double>&, Suffix_cache_on_mesh&) const;   \
  instantiation Bisector_diagram<double> find_bisectors<double>(const Unfolded_mesh<double>&, const Initial_windows<double>&,  \
                                                                const Geodesic_field<double>&);                                \
  instantiation std::map<Index, Source_side> inner_sides(const Unfolded_mesh<double>&, const Epick_traits&,                    \
                                                         const Source_set<double>&);

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// The types in the list. For the functors of the package, Computation replaces the traits of any mesh by those with void.
typedef Surface_mesh_geodesic_offset_traits<Exact_predicates_inexact_constructions_kernel, void> Epick_traits;
typedef Path_suffix_cache<double, Path_crossing<double>> Suffix_cache_on_mesh;

CGAL_GEODESIC_OFFSET_SEPARATE_FUNCTIONS(extern template)

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif

#endif
