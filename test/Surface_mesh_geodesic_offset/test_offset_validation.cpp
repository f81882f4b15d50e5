// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The validation oracle itself: it accepts correct curves, and detects each kind of damage by the corresponding check.

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "locations.h"
#include "plane_section.h"
#include "test_check.h"
#include "validation/Offset_validation.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace test_offset_validation {

using namespace test;
namespace internal = CGAL::Geodesic_offset::internal;

typedef Geodesic::Offset_curve Offset_curve;
typedef internal::Validation_report Validation_report;
typedef internal::Validation_kind Validation_kind;

// Parts of a curve, which can be changed and reassembled.
struct Parts
{
  double distance;
  bool closed;
  std::vector<internal::Level_piece<double>> pieces;
};

template <class Surface>
std::shared_ptr<const Surface> new_surface(const test::Surface_mesh& mesh)
{
  CGAL::Geodesic_offset::internal::Single_worker alone;
  return std::make_shared<Surface>(mesh, CGAL::get_initialized_vertex_index_map(mesh),
                                   CGAL::get_initialized_face_index_map(mesh), get(CGAL::vertex_point, mesh),
                                   CGAL::Geodesic_offset::internal::No_lengths(),
                                   CGAL::Geodesic_offset::internal::No_barriers(), typename Surface::Traits(), alone);
}

template <class Curve>
class Workshop;

template <class Surface>
class Workshop<CGAL::Geodesic_offset_curve<Surface>>
{
public:
  typedef CGAL::Geodesic_offset_curve<Surface> Curve;
  typedef internal::Curve_context<Surface> Context;

  explicit Workshop(const test::Surface_mesh& mesh)
    : context_(std::make_shared<Context>(Context{new_surface<Surface>(mesh), std::vector<internal::Source_primitive>(1)}))
  {
  }

  static Parts take_apart(const Curve& curve)
  {
    Parts result{curve.distance(), curve.is_closed(), {}};
    for (const auto& p : curve.pieces())
    {
      internal::Level_piece<double> piece{};
      piece.face = internal::Index(p.face());
      piece.is_straight = p.is_segment();
      if (piece.is_straight)
      {
        const auto line = p.supporting_line();
        piece.center = {-line.a(), -line.b()};
        piece.radius = line.c();
      }
      else
      {
        piece.center = {p.center().x(), p.center().y()};
        piece.radius = p.radius();
      }
      piece.start = {p.start_2().x(), p.start_2().y()};
      piece.end = {p.end_2().x(), p.end_2().y()};
      piece.pseudo_source = internal::no_index;
      piece.start_edge = edge_of(p.start());
      piece.end_edge = edge_of(p.end());
      result.pieces.push_back(piece);
    }
    return result;
  }

  Curve put_together(const Parts& parts) const
  {
    return Context::make_curve(context_, parts.distance, typename Curve::FT(0), parts.closed, parts.pieces);
  }

private:
  static unsigned char edge_of(const typename Curve::Face_location& location)
  {
    for (unsigned char k = 0; k < 3; ++k)
      if (location.second[(k + 2u) % 3] == 0) return k;
    return 3;
  }

  std::shared_ptr<const Context> context_;
};

struct Case
{
  std::string name;
  test::Surface_mesh mesh;
  Geodesic geodesic;
  std::vector<double> levels;
  std::vector<Offset_curve> curves;

  template <class AddSources>
  Case(const std::string& name, const Soup& soup, const AddSources& add_sources, const std::vector<double>& levels)
    : name(name), mesh(Generated_mesh<test::Surface_mesh>(soup).mesh), geodesic(mesh), levels(levels)
  {
    add_sources(mesh, geodesic);
    geodesic.build(CGAL::parameters::keep_windows(true));
    geodesic.offset_curves(levels, std::back_inserter(curves));
  }

  Validation_report validate(const std::vector<Offset_curve>& changed) const
  {
    return internal::Offset_validation<Geodesic>(geodesic, mesh)(levels, changed);
  }
};

std::string summary(const Validation_report& report)
{
  std::string text;
  for (int k = 0; k < internal::NUMBER_OF_VALIDATION_KINDS; ++k)
    text += std::string(name_of(Validation_kind(k))) + " " + std::to_string(report.failures(Validation_kind(k))) + "/" +
            std::to_string(report.checks(Validation_kind(k))) + " ";
  for (const std::string& t : report.texts()) text += "\n  " + t;
  return text;
}

void expect(const Case& c, const std::string& damage, const std::vector<Offset_curve>& changed,
            std::initializer_list<Validation_kind> kinds)
{
  Report::instance().set_context(c.name + ", " + damage);
  const Validation_report report = c.validate(changed);
  CHECK(!report.is_valid());
  CHECK(!report.texts().empty());
  for (const Validation_kind kind : kinds)
    CHECK_DETAIL(report.failures(kind) > 0, name_of(kind) + (" is silent: " + summary(report)));
}

// Pieces of one level need not be close to each other; they are in some of the cases.
std::size_t& checks_of_crossings()
{
  static std::size_t count = 0;
  return count;
}

void damage_curves(const Case& c)
{
  using namespace internal;
  typedef Workshop<Offset_curve> Workshop_;
  const Workshop_ workshop(c.mesh);

  Report::instance().set_context(c.name);
  const Validation_report good = c.validate(c.curves);
  CHECK_DETAIL(good.is_valid(), summary(good));
  for (int k = 0; k < NUMBER_OF_VALIDATION_KINDS; ++k)
    CHECK_DETAIL(good.checks(Validation_kind(k)) > 0 || k == NO_CROSSING, name_of(Validation_kind(k)));
  checks_of_crossings() += good.checks(NO_CROSSING);
  CHECK(good.curves == c.curves.size() && good.separating_edges > 0);
  CHECK(good.separated_on_edges > 0 && good.separated_in_faces > 0 && good.areas > 0);
  CHECK(good.oriented_pieces > 0);

  // disassembling and reassembling curves is no damage
  std::vector<Offset_curve> same;
  for (const Offset_curve& curve : c.curves) same.push_back(workshop.put_together(Workshop_::take_apart(curve)));
  const Validation_report again = c.validate(same);
  CHECK_DETAIL(again.is_valid() && again.checks() == good.checks(), summary(again));

  // the longest curve, and its longest piece away from the ends
  const auto longest = std::max_element(c.curves.begin(), c.curves.end(), [](const Offset_curve& a, const Offset_curve& b) {
    return a.length() < b.length();
  });
  const std::size_t which = std::size_t(longest - c.curves.begin());
  const Parts original = Workshop_::take_apart(*longest);
  if (!CHECK(original.pieces.size() > 4)) return;
  std::size_t piece = 1;
  for (std::size_t i = 1; i + 1 < original.pieces.size(); ++i)
    if (longest->piece(i).length() > longest->piece(piece).length()) piece = i;
  const auto with = [&](const Parts& parts) {
    std::vector<Offset_curve> changed = c.curves;
    changed[which] = workshop.put_together(parts);
    return changed;
  };

  std::vector<Offset_curve> changed = c.curves;
  changed.erase(changed.begin() + std::ptrdiff_t(which));
  expect(c, "a curve is missing", changed, {EDGE_PARITY, SEPARATION});
  expect(c, "all curves are missing", {}, {EDGE_PARITY, SEPARATION, AREA});

  changed = c.curves;
  changed.push_back(*longest);
  expect(c, "a curve is there twice", changed, {EDGE_PARITY, SEPARATION});

  Parts parts = original;
  parts.pieces.erase(parts.pieces.begin() + std::ptrdiff_t(piece));
  expect(c, "a piece is missing", with(parts), {CLOSEDNESS});

  parts = original;
  parts.pieces[piece].start.x += 1e-7 * parts.distance;
  expect(c, "an end has moved", with(parts), {CLOSEDNESS, ON_LEVEL});

  parts = original;
  parts.closed = !parts.closed;
  expect(c, "closed for open", with(parts), {CLOSEDNESS});

  parts = original;
  std::reverse(parts.pieces.begin(), parts.pieces.end());
  for (auto& p : parts.pieces)
  {
    std::swap(p.start, p.end);
    std::swap(p.start_edge, p.end_edge);
  }
  expect(c, "reversed", with(parts), {ORIENTATION});

  parts = original;
  for (auto& p : parts.pieces) p.radius *= 1 + 1e-6;
  expect(c, "other radii", with(parts), {ON_LEVEL});

  parts = original;
  parts.distance = c.levels[parts.distance == c.levels[0] ? 1 : 0];
  expect(c, "another level's label", with(parts), {ON_LEVEL, EDGE_PARITY, NESTING});

  parts = original;
  parts.distance *= 1 + 1e-3;
  expect(c, "a label that was not requested", with(parts), {ON_LEVEL, EDGE_PARITY});

  // a triangle of segments inside a face that the curve crosses
  parts = original;
  const auto& passed = original.pieces[piece];
  const auto middle = 0.5 * (passed.start + passed.end);
  const auto face = Validation_surface<Geodesic>(c.geodesic, c.mesh).face_at(passed.face);
  Parts loop{parts.distance, true, {}};
  Point_in_face<double> corner[3];
  for (int k = 0; k < 3; ++k) corner[k] = middle + 0.3 * (face.corner[k] - middle);
  for (int k = 0; k < 3; ++k)
  {
    auto p = passed;
    p.start = corner[k];
    p.end = corner[(k + 1) % 3];
    p.start_edge = p.end_edge = 3;
    p.is_straight = true;
    const auto u = (1 / length(p.end - p.start)) * (p.end - p.start);
    p.center = {u.y, -u.x};
    p.radius = dot(p.center, p.start);
    loop.pieces.push_back(p);
  }
  changed = c.curves;
  changed.push_back(workshop.put_together(loop));
  expect(c, "a loop too many", changed, {ON_LEVEL, NO_CROSSING});
}

} // namespace test_offset_validation

GEODESIC_OFFSET_TEST(test_offset_validation)
{
  const auto border = [](const test::Surface_mesh& mesh, Geodesic& geodesic) {
    std::vector<test::Surface_mesh::Edge_index> edges_of_border;
    for (auto e : edges(mesh))
      if (mesh.is_border(e)) edges_of_border.push_back(e);
    geodesic.add_source_edges(edges_of_border);
  };
  const auto vertex = [](const test::Surface_mesh& mesh, Geodesic& geodesic) {
    geodesic.add_source_point(*std::next(vertices(mesh).begin(), 3));
  };
  const auto section = [](const test::Surface_mesh& mesh, Geodesic& geodesic) {
    for (const auto& s : random_plane_section(mesh, 5))
      geodesic.add_source_polyline(s.locations, CGAL::parameters::is_closed(s.closed));
  };
  damage_curves(Case("icosphere, vertex", icosphere(2), vertex, {0.3, 0.9, 1.4, 2.2}));
  damage_curves(Case("torus, section", torus(20, 14), section, {0.1, 0.2, 0.4}));
  damage_curves(Case("grid, boundary", planar_grid(10, 10, Diagonals::alternating), border, {0.7, 1.5, 3}));
  damage_curves(Case("jittered grid, vertex", jittered_grid(14, 10, 7), vertex, {2., 5., 9.}));
  Report::instance().set_context("");
  CHECK(checks_of_crossings() > 0);

  // levels through vertices and along edges
  const Case grid("grid, side", planar_grid(8, 8, Diagonals::alternating), border, {1, 2, 3});
  Report::instance().set_context(grid.name);
  const Validation_report report = grid.validate(grid.curves);
  CHECK_DETAIL(report.is_valid() && report.undecided_vertices > 0, summary(report));
  return Report::instance().finish("test_offset_validation");
}
