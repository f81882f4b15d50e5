// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run of the pipeline: a copy of the sources, and their field.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GEODESIC_BUILD_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GEODESIC_BUILD_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_offset_statistics.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Build_request.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Geodesic_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Face_consumer.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Front_traits.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_points.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Computation_number.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_start.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_suffix_cache.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Source_set.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <CGAL/tags.h>

#include <optional>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Window_merging;
struct Merging_counts;

template <class Traits>
class Geodesic_build
{
public:
  typedef typename Traits::FT FT;
  template <class Concurrency_tag>
  using Consumer_of = Face_consumer<FT, typename Concurrency<Concurrency_tag, FT>::Team::Type>;

  // `memory`: the field of a build with Build_request::keeps_memory on the mesh; the time is that of what its front has reached.
  Geodesic_build(const Unfolded_mesh<FT>& mesh, const Source_set<FT>& source_set, const Build_request<FT>& request,
                 Geodesic_field<FT>&& memory = Geodesic_field<FT>());

  // Continues another build with additional sources: starts from its distances and windows. The other build must have kept all
  // windows up to the maximum distance.
  Geodesic_build(const Geodesic_build& before, const Source_set<FT>& source_set, const Build_request<FT>& request);

  ~Geodesic_build();

  // Adds a point as a source: the next propagation computes only the distances that it improves. Afterwards there are no queries of
  // paths, since the windows of the other sources are dropped. Precondition: whole, exact, keeps memory but no windows.
  void add_source(Index id, const Surface_point<FT>& p);

  // The parts to instantiate where these may be needed, see Build_part: all of them in the compiled library, which has one
  // propagation; only what the number type can have elsewhere.
  static constexpr unsigned parts_for(unsigned needed)
  {
#ifdef CGAL_GEODESIC_OFFSET_COMPILED
    if (is_compiled<Traits>) return ALL_PARTS;
#endif
    return Number_policy<FT>::is_inexact ? needed : needed & ~unsigned(MERGING);
  }

  // Propagates without a consumer of finalized faces. `parts`: of parts_for().
  template <class Concurrency_tag, unsigned parts>
  void propagate(const Traits& traits);

  // Propagates and hands faces to a consumer, see Wavefront::run().
  template <class Concurrency_tag, unsigned parts>
  void run(const Traits& traits, Consumer_of<Concurrency_tag>& consumer);

  const Build_request<FT>& request() const { return m_request; }

  bool is_approximate() const { return !m_request.tolerance.is_zero(); }

  // True if the propagation reached all points within the distance limit.
  bool is_whole() const { return !is_cancelled && !has_all_targets; }

  // Distance of a point, also beyond the maximum. Precondition: the point is a vertex, or windows are kept.
  FT distance(const Located_point<FT>& p) const;

  // Start of the path from a point, under the same precondition; not reached if the point is beyond the maximum.
  Path_start<FT> path_start(const Located_point<FT>& p) const;

  // End of the path from p with the given start.
  Suffix_end<FT> path_end(const Located_point<FT>& p, const Path_start<FT>& start) const;

  // Source and side at that end. If the path is not traced, the primitive is that of the window.
  Source_ref source_ref(const Located_point<FT>& p, const Path_start<FT>& start) const;

  // Appends the elements that the path meets after p. Returns the end.
  Suffix_end<FT> trace_path(const Located_point<FT>& p, const Path_start<FT>& start, std::vector<Path_element<FT>>& path) const;

  // Appends the points in space of the path, p included. For floating point numbers.
  template <class Kernel>
  void trace_path_in_space(const Located_point<FT>& p, const Path_start<FT>& start, const Surface_points<Kernel>& points,
                           std::vector<typename Kernel::Point_3>& path) const;

  // The farthest point by a search in all faces. Precondition: kept.
  std::optional<Farthest<FT>> find_farthest() const;

  Source_set<FT> sources;
  Initial_windows<FT> initial;
  FT maximum; // distances up to this value are final
  const bool kept;
  bool is_cancelled = false, has_all_targets = false;
  Geodesic_field<FT> field;
  std::optional<Farthest<FT>> farthest; // if requested and existing
  Geodesic_offset_statistics statistics;
  // caches for the paths of queries
  mutable Path_suffix_cache<FT, Path_crossing<FT>> suffixes;
  mutable Path_suffix_cache<FT, typename Traits::Point_3> suffixes_in_space;

private:
  template <class Concurrency_tag, unsigned parts>
  void run_front(const Traits& traits, Consumer_of<Concurrency_tag>& consumer);

  void take_errors(const Merging_counts& counts);

  bool are_of_one_side(const Surface_point<FT>& p, const Path_start<FT>& start) const;

  template <class Front>
  bool is_final(const Front& front, const Surface_point<FT>& p, const FT& distance) const;

  const Unfolded_mesh<FT>& m_mesh;
  Build_request<FT> m_request;
  Index m_first_new = 0; // primitive
};

} // namespace CGAL::Geodesic_offset::internal

#ifndef CGAL_GEODESIC_OFFSET_COMPILED
#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build_impl.h>
#endif

#endif
