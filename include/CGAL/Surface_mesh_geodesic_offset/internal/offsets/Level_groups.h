// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Groups of levels that are cut together in faces which are not finalized, so that few pieces wait for other faces.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_GROUPS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_GROUPS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Face_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Geodesic_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_range.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Initial_windows.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Pieces to expect, and the faces that levels may cross, each counted once per level.
struct Expected_pieces
{
  double pieces = 0;
  std::size_t crossings = 0;
};

// Levels that are cut together, from `first` to before `end`.
struct Level_group
{
  std::size_t first, end;
  Expected_pieces expected;
};

// The number of pieces in a face at a level is known only after the cut. What to expect is the number in the last groups, or,
// for faces with many windows, a part of these.
template <class FT>
class Level_groups
{
public:
  struct Face_levels
  {
    Index face;
    Level_range levels; // those that may cross it
  };

  // `next_level`: per face, the first level at which it is not cut; read when groups are formed.
  Level_groups(const Initial_windows<FT>& initial, const Geodesic_field<FT>& field, const std::vector<Index>& next_level)
    : m_initial(initial), m_field(field), m_next_level(next_level)
  {
  }

  // Faces to cut, with the levels that are left of them.
  void clear() { m_faces.clear(); }
  void add(Index face, const Level_range& levels) { m_faces.push_back({face, levels}); }
  const std::vector<Face_levels>& faces() const { return m_faces; }

  // To expect in a face at a level that may cross it.
  double pieces_per_crossing() const { return m_pieces_per_crossing; }

  // True if the faces may have more pieces than this, by the numbers of their windows. Then the next groups expect as many.
  bool expects_more_than(std::size_t number)
  {
    Expected_pieces expected;
    for (const Face_levels& f : m_faces)
    {
      if (f.levels.is_empty()) continue;
      expected.pieces += pieces_by_windows(f.face) * double(f.levels.size());
      expected.crossings += f.levels.size();
    }
    if (expected.pieces <= double(number)) return false;
    m_pieces_per_crossing = (std::max)(m_pieces_per_crossing, expected.pieces / double(expected.crossings));
    return true;
  }

  // Finds the faces that count by their windows.
  void find_dense_faces()
  {
    m_dense.clear();
    for (const Face_levels& f : m_faces)
    {
      const double pieces = f.levels.is_empty() ? 0. : pieces_by_windows(f.face);
      if (pieces > many_pieces) m_dense.push_back({f, pieces});
    }
  }

  // The next group of levels from `first` on, before `last`. It has at least one level that may cross faces, and further ones as
  // long as no more than `most_pieces` are to be expected. It ends at `last` if no level crosses a face.
  Level_group next(std::size_t first, std::size_t last, std::size_t most_pieces) const
  {
    std::size_t lowest = last;
    const auto levels_within = [&](const Face_levels& f) {
      return Level_range{(std::max)({f.levels.first, first, std::size_t(this->m_next_level[f.face])}),
                         (std::min)(f.levels.last, last)};
    };
    for (const Face_levels& f : m_faces)
      if (const Level_range levels = levels_within(f); !levels.is_empty()) lowest = (std::min)(lowest, levels.first);
    if (lowest == last) return {last, last, Expected_pieces{}};
    std::array<std::ptrdiff_t, most_levels_together + 1> change{};  // of the number of faces, from level to level
    std::array<double, most_levels_together + 1> change_of_extra{}; // pieces to expect in dense faces
    const std::size_t end = (std::min)(last, lowest + most_levels_together);
    for (const Face_levels& f : m_faces)
    {
      const Level_range levels = levels_within(f);
      if (levels.is_empty() || levels.first >= end) continue;
      ++change[levels.first - lowest];
      --change[(std::min)(levels.last, end) - lowest];
    }
    for (const auto& [f, pieces] : m_dense)
    {
      const Level_range levels = levels_within(f);
      if (levels.is_empty() || levels.first >= end || pieces <= m_pieces_per_crossing) continue;
      change_of_extra[levels.first - lowest] += pieces - m_pieces_per_crossing;
      change_of_extra[(std::min)(levels.last, end) - lowest] -= pieces - m_pieces_per_crossing;
    }
    const double most = double(most_pieces);
    std::size_t crossed = std::size_t(change[0]), i = lowest + 1;
    double extra = change_of_extra[0];
    Expected_pieces expected{m_pieces_per_crossing * double(crossed) + extra, crossed};
    for (; i < end; ++i)
    {
      crossed += std::size_t(change[i - lowest]);
      extra += change_of_extra[i - lowest];
      const double pieces = m_pieces_per_crossing * double(crossed) + extra;
      if (expected.pieces + pieces > most) break;
      expected.pieces += pieces;
      expected.crossings += crossed;
    }
    return {lowest, i, expected};
  }

  // Notes the number of pieces of a group; if it was not cut as a whole, since there were too many, the next one expects twice as
  // many as this did.
  void count(const Level_group& group, std::size_t number_of_pieces, bool is_complete)
  {
    const double pieces = double(number_of_pieces), crossings = double(group.expected.crossings);
    if (!is_complete) m_pieces_per_crossing *= 2;
    else if (crossings > 0)
      m_pieces_per_crossing = (std::max)({pieces / crossings, m_pieces_per_crossing / 2, least_pieces_per_crossing});
  }

private:
  // In a group. A face may have a hundred pieces at each level, so that one face alone adds a few thousand pieces.
  static constexpr std::size_t most_levels_together = 1 << 5;
  // Pieces to expect in a face at a level that may cross it, before any group is cut; and at least. Bounds of the levels of a
  // face are loose in long faces along the front: most levels within them may have no piece.
  static constexpr double first_pieces_per_crossing = 4, least_pieces_per_crossing = 1. / 64;
  // Pieces in a face at a level that may cross it, per window of the face: one of four to ten has a piece on fine meshes, one of
  // two to four in faces with many sources. Binding test of these limits: test_offset_families.
  static constexpr double pieces_per_window = 1. / 4;
  // Pieces in such a face per window of a source inside the face: near crossing segments, each of these windows has two pieces on
  // average.
  static constexpr double pieces_per_local_window = 2;
  // A face with more of them at a level may have more pieces than all others that are cut before it, so it counts by its windows.
  static constexpr double many_pieces = 16;

  struct Dense_face
  {
    Face_levels face;
    double pieces; // to expect at a level
  };

  // Pieces to expect in a face at a level that may cross it, by the number of its windows.
  double pieces_by_windows(Index f) const
  {
    const auto local = local_windows(m_initial, f);
    std::size_t windows = 3; // the corners have cones, too
    for (Index h = 3 * f; h < 3 * f + 3; ++h) windows += m_field.lists.get(h).propagated.size;
    return pieces_per_window * double(windows) + pieces_per_local_window * double(local.second - local.first);
  }

  const Initial_windows<FT>& m_initial;
  const Geodesic_field<FT>& m_field;
  const std::vector<Index>& m_next_level;
  std::vector<Face_levels> m_faces;
  std::vector<Dense_face> m_dense; // those of the faces with many pieces at a level
  double m_pieces_per_crossing = first_pieces_per_crossing;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
