// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Oracle for offset curves: whether they are the complete boundary of { D < d } for a given field D.
//
// Checks for families of levels:
// - pieces are joined in faces and over edges; closed curves are closed, open ones begin and end on the border;
// - all points are on their level;
// - an edge is crossed an odd number of times if and only if its ends are on different sides of the level;
// - points of edges and faces are on different sides if and only if curves separate them;
// - the smaller distances are on the left;
// - curves do not cross, and the near region of a level is contained in those of larger levels;
// - the near area of faces, by Green's theorem, agrees with bounds from the field.
//
// With inexact numbers, levels are cut at a distance smaller by a fraction of 2^-42, so the checks use this distance.

#ifndef GEODESIC_OFFSET_TEST_VALIDATION_OFFSET_VALIDATION_H
#define GEODESIC_OFFSET_TEST_VALIDATION_OFFSET_VALIDATION_H

#include "Area_validation.h"
#include "Crossing_validation.h"
#include "Curve_validation.h"
#include "Side_validation.h"

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Validates offset curves of one build. `Geodesic`: a Surface_mesh_geodesic_offset on a mesh with its own points (no custom
// point map), built with kept windows and without a distance limit below the levels. It must not be rebuilt during the
// validation.
template <class Geodesic>
class Offset_validation
{
public:
  typedef typename Geodesic::FT FT;
  typedef typename Geodesic::Triangle_mesh Triangle_mesh;
  typedef typename Geodesic::Offset_curve Offset_curve;

  Offset_validation(const Geodesic& geodesic, const Triangle_mesh& tm, const Validation_options& options = Validation_options())
    : m_options(options), m_surface(geodesic, tm)
  {
  }

  // `levels`: increasing. `curves`: all curves of these levels on all sides, in any order.
  //
  // Time per level: linear in the size of the mesh, plus, for each piece and each face that the level may pass through, the
  // number of windows of the face.
  Validation_report operator()(const std::vector<FT>& levels, const std::vector<Offset_curve>& curves) const
  {
    Validation_report report(m_options.largest_number_of_texts);
    std::mt19937 random(m_options.seed);
    std::vector<Validation_level> all;
    for (const FT& l : levels)
    {
      all.emplace_back();
      all.back().level = CGAL::to_double(l);
      all.back().cut = CGAL::to_double(FT(l - Number_policy<FT>::rounding(1024) * l));
      all.back().number = all.size() - 1;
    }
    sort_in(curves, levels, all, report);
    const Area_validation<Geodesic> areas(m_surface, m_options, report);
    typename Area_validation<Geodesic>::Areas last;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      auto next = check_level(all[i], areas, random, report);
      if (i > 0) areas.check_growth(all[i - 1], last, all[i], next);
      last = std::move(next);
    }
    report.set_context("");
    Crossing_validation(m_surface.diagonal(), m_options, report)(all);
    return report;
  }

private:
  static std::string name_of(const Validation_level& level)
  {
    return "level " + std::to_string(level.number) + ", " + validation_text(level.level) + ": ";
  }

  void sort_in(const std::vector<Offset_curve>& curves, const std::vector<FT>& levels, std::vector<Validation_level>& all,
               Validation_report& report) const
  {
    const Curve_validation<Geodesic> walk(m_surface, m_options, report);
    for (const Offset_curve& curve : curves)
    {
      const auto found = std::lower_bound(levels.begin(), levels.end(), curve.distance());
      const bool is_known = found != levels.end() && *found == curve.distance();
      report.set_context("");
      if (!report.check(ON_LEVEL, is_known, [&] {
            return "a curve at the distance " + validation_text(CGAL::to_double(curve.distance())) +
                   ", which was not requested";
          }))
        continue;
      Validation_level& level = all[std::size_t(found - levels.begin())];
      report.set_context(name_of(level));
      walk(curve, level);
    }
  }

  typename Area_validation<Geodesic>::Areas check_level(Validation_level& level, const Area_validation<Geodesic>& areas,
                                                        std::mt19937& random, Validation_report& report) const
  {
    report.set_context(name_of(level));
    level.sort();
    report.undecided_vertices += level.find_sides(m_surface);
    std::vector<Index> faces;
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
      if (m_surface.is_used(f) && level.may_cross(m_surface, m_surface.face_at(f))) faces.push_back(f);
    report.loops_in_faces += level.loops.size();
    report.most_loops_in_face = (std::max)(report.most_loops_in_face, level.most_loops_in_face());
    const Side_validation<Geodesic> sides(m_surface, m_options, report);
    sides.check_edges(level, random);
    sides.check_faces(level, faces, random);
    auto result = areas.from_curves(level, faces);
    areas.check_against_field(level, result, faces, random);
    return result;
  }

  Validation_options m_options;
  Validation_surface<Geodesic> m_surface;
};

} // namespace CGAL::Geodesic_offset::internal

#endif // GEODESIC_OFFSET_TEST_VALIDATION_OFFSET_VALIDATION_H
