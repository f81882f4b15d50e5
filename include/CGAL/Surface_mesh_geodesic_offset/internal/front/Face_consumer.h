// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Receives the faces that the wavefront finalizes.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FACE_CONSUMER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FACE_CONSUMER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// This class ignores the faces. `Team`: the threads that may help. An interface, so that there is one front for all consumers;
// its functions are called once per bucket or less often.
template <class FT, class Team>
class Face_consumer
{
public:
  virtual ~Face_consumer() = default;

  // True if the lists of the halfedges of a face are read. The functions below process_finalized() are called only then.
  virtual bool reads_lists() const { return false; }

  // True if nothing beyond the settled distance is needed.
  virtual bool is_done() const { return false; }

  // Receives finalized faces, each face once. The distances of their corners are final, and so are the lists of their halfedges
  // if they are read.
  virtual void process_finalized(const std::vector<Index>&, Team&) {}

  // All faces with points nearer than the distance have been passed to process_finalized().
  virtual void settled_up_to(const FT&) {}

  // Returns whether faces with points up to the settled distance are needed before they are finalized. `number`: of the pending
  // and the finalized faces together; `finalized`: those of the next process_finalized().
  virtual bool needs_pending_faces(const FT& settled, std::size_t number, const std::vector<Index>& finalized)
  {
    return (void)settled, (void)number, (void)finalized, false;
  }

  // Receives all faces with points nearer than the settled distance that have not been passed to process_finalized(); distances
  // and windows nearer than it are final.
  virtual void process_pending(const std::vector<Index>& faces, const FT& settled, Team&) { (void)faces, (void)settled; }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
