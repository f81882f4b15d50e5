// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Levels near distances where the topology changes: cases with former errors, and a bounded run of the search
// (benchmark/Surface_mesh_geodesic_offset/Robustness/offset_search.cpp is the long run). First the judge itself: it accepts
// correct curves and detects each kind of damage.

#include "offset_search.h"
#include "test_check.h"

#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_tolerances.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_offset_search {

using namespace test;

/// A piece of a curve as plain data that can be damaged.
struct Plain_piece
{
  explicit Plain_piece(const Offset_piece& p)
    : in_face(p.face()), straight(p.is_segment()), line(straight ? p.supporting_line() : Offset_piece::Line_2()),
      middle(straight ? Point_2() : p.center()), r(straight ? 0 : p.radius()), turn(p.angle()), extent(p.length()),
      from(p.start_2()), to(p.end_2()), at_start(p.start()), at_end(p.end())
  {
    for (int i = 1; i < parts; ++i)
    {
      inside.push_back(p.location(double(i) / parts));
      inside_2.push_back(p.point_2(double(i) / parts));
    }
  }

  Surface_mesh::Face_index face() const { return in_face; }
  bool is_segment() const { return straight; }
  Offset_piece::Line_2 supporting_line() const { return line; }
  Point_2 center() const { return middle; }
  double radius() const { return r; }
  double angle() const { return turn; }
  double length() const { return extent; }
  Point_2 start_2() const { return from; }
  Point_2 end_2() const { return to; }
  Face_location start() const { return at_start; }
  Face_location end() const { return at_end; }
  // The judge requests only quarters.
  Face_location location(double t) const { return t <= 0 ? at_start : t >= 1 ? at_end : inside[std::size_t(t * parts) - 1]; }
  Point_2 point_2(double t) const { return t <= 0 ? from : t >= 1 ? to : inside_2[std::size_t(t * parts) - 1]; }

  static constexpr int parts = 4;
  Surface_mesh::Face_index in_face;
  bool straight;
  Offset_piece::Line_2 line;
  Point_2 middle;
  double r, turn, extent;
  Point_2 from, to;
  Face_location at_start, at_end;
  std::vector<Face_location> inside;
  std::vector<Point_2> inside_2;
};

struct Plain_curve
{
  explicit Plain_curve(const Offset_curve& curve) : closed(curve.is_closed())
  {
    for (const Offset_piece& p : curve.pieces()) pieces.emplace_back(p);
  }
  bool is_closed() const { return closed; }
  std::size_t number_of_pieces() const { return pieces.size(); }
  const Plain_piece& piece(std::size_t i) const { return pieces[i]; }

  bool closed;
  std::vector<Plain_piece> pieces;
};

typedef std::vector<Plain_curve> Plain_curves;

std::string text_of(const Verdict& verdict)
{
  std::string text;
  for (const std::string& t : verdict.texts) text += "\n    " + t;
  return text;
}

/// A field with its judge.
struct Judged
{
  template <class AddSources>
  Judged(const Surface_mesh& mesh, const AddSources& add_sources)
    : geodesic(built(mesh, add_sources)), surface(geodesic, mesh), features(geodesic, mesh, surface, random),
      judge(surface, features)
  {
  }

  template <class Curves>
  Verdict operator()(double level, const Curves& curves)
  {
    std::vector<const typename Curves::value_type*> pointers;
    for (const auto& c : curves) pointers.push_back(&c);
    return judge.judge(level, pointers);
  }

  Random random;
  Open_geodesic geodesic;
  Judged_surface surface;
  Field_features features;
  Level_judge judge;

private:
  template <class AddSources>
  static Open_geodesic built(const Surface_mesh& mesh, const AddSources& add_sources)
  {
    Open_geodesic geodesic(mesh);
    add_sources(geodesic);
    geodesic.build(CGAL::parameters::keep_windows(true));
    return geodesic;
  }
};

template <class Damage>
void expect(Judged& judged, const std::string& name, double level, Plain_curves curves, const Damage& damage,
            std::initializer_list<Fault> faults)
{
  damage(curves);
  const Verdict verdict = judged(level, curves);
  CHECK_DETAIL(!verdict.is_right(), name + " is not found");
  for (const Fault f : faults) CHECK_DETAIL(verdict.faults[f] > 0, name + ": no " + name_of(f) + text_of(verdict));
}

// `Judged` detects each kind of damage of a curve that crosses at least five faces.
template <class AddSources>
void damages(const std::string& name, const Soup& soup, const AddSources& add_sources, double level)
{
  Report::instance().set_context(name);
  const Generated_mesh<Surface_mesh> data(soup);
  Judged judged(data.mesh, [&](Geodesic& g) { add_sources(g, data); });
  const Offset_curves curves = offsets(judged.geodesic, level);
  const Verdict right = judged(level, curves);
  CHECK_DETAIL(right.is_right(), text_of(right));
  CHECK(right.pieces > 4 && right.area > 0 && right.length > 0);

  Plain_curves plain;
  for (const Offset_curve& c : curves) plain.emplace_back(c);
  const Verdict same = judged(level, plain);
  CHECK_DETAIL(same.is_right() && same.area == right.area && same.length == right.length, text_of(same));
  // the longest curve first, its longest piece second
  std::sort(plain.begin(), plain.end(),
            [](const Plain_curve& a, const Plain_curve& b) { return a.pieces.size() > b.pieces.size(); });
  auto& pieces = plain[0].pieces;
  if (!CHECK(pieces.size() > 4 && plain[0].closed)) return;
  const auto longest = std::max_element(pieces.begin(), pieces.end(), [](const Plain_piece& a, const Plain_piece& b) {
    return a.extent < b.extent;
  });
  std::rotate(pieces.begin(), longest, pieces.end());
  std::rotate(pieces.begin(), pieces.end() - 1, pieces.end());

  const auto with = [&](const std::string& what, std::initializer_list<Fault> faults, const auto& damage) {
    expect(judged, what, level, plain, damage, faults);
  };
  with("a missing curve", {EDGE}, [](Plain_curves& c) { c.erase(c.begin()); });
  with("a curve that is there twice", {EDGE}, [](Plain_curves& c) { c.push_back(c[0]); });
  with("no curve", {EDGE, FACE}, [](Plain_curves& c) { c.clear(); });
  with("a missing piece", {GAP}, [](Plain_curves& c) { c[0].pieces.erase(c[0].pieces.begin() + 1); });
  with("a curve without pieces", {GAP}, [](Plain_curves& c) { c[0].pieces.clear(); });
  with("an open end in a face", {GAP}, [](Plain_curves& c) { c[0].closed = false; });
  with("another radius", {OFF}, [](Plain_curves& c) { c[0].pieces[1].r *= 1 + 1e-7; });
  with("a turn of nearly a whole circle", {TURN}, [](Plain_curves& c) { c[0].pieces[1].turn = 2 * CGAL_PI - 1e-3; });
  with("a negative length", {TURN}, [](Plain_curves& c) { c[0].pieces[1].extent *= -1; });
  with("a turn that does not fit the chord", {TURN}, [](Plain_curves& c) { c[0].pieces[1].turn += 1e-3; });
  with("a point off the level", {OFF}, [](Plain_curves& c) {
    auto& w = c[0].pieces[1].inside[1].second;
    w = {{w[0] * 0.9 + 0.1, w[1] * 0.9, w[2] * 0.9}};
  });
  with("a point outside", {OUTSIDE}, [](Plain_curves& c) {
    auto& w = c[0].pieces[1].inside[1].second;
    w = {{w[0] + 1, w[1] - 0.5, w[2] - 0.5}};
  });
  with("a moved end", {GAP}, [](Plain_curves& c) {
    auto& w = c[0].pieces[1].at_end.second;
    for (double& x : w)
      if (x != 0) x = x < 0.5 ? x + 1e-7 : x - 1e-7;
  });

  // the curves of a slightly larger level
  const double next = level * (1 + 1e-6);
  const Verdict wrong_level = judged(level, offsets(judged.geodesic, next));
  CHECK_DETAIL(wrong_level.faults[OFF] > 0, text_of(wrong_level));
}

// A segment that runs back and forth, a former fault of a tracer of rounded points.
void backward_segment()
{
  const Generated_mesh<Surface_mesh> data(planar_grid(4, 4));
  Judged judged(data.mesh, [&](Geodesic& g) { g.add_source_plane_section(Geodesic::Plane_3(0, 1, 0, -1)); });
  const Offset_curves curves = offsets(judged.geodesic, 1.25);
  Plain_curves plain;
  for (const Offset_curve& c : curves) plain.emplace_back(c);
  CHECK(judged(1.25, plain).is_right());
  if (!CHECK(plain.size() == 1 && plain[0].pieces.size() > 3)) return;
  expect(judged, "a segment that runs backwards", 1.25, plain,
         [](Plain_curves& c) {
           Plain_piece& p = c[0].pieces[1];
           std::swap(p.from, p.to);
         },
         {TURN});
}

void judge_finds_damage()
{
  damages(
    "sphere", icosphere(1), [](Geodesic& g, const auto& data) { g.add_source_point(data.vertices[3]); }, 1.1);
  damages(
    "jittered grid", jittered_grid(9, 9, 4),
    [](Geodesic& g, const auto& data) {
      g.add_source_point(data.vertices[44]);
      g.add_source_point(data.vertices[46]);
    },
    2.5);
  damages(
    "torus", torus(9, 7), [](Geodesic& g, const auto& data) { g.add_source_point(data.vertices[5]); }, 0.7);
  Report::instance().set_context("segment");
  backward_segment();
}

// search_tolerances.h repeats tolerances of the package; they must be equal.
void tolerances()
{
  typedef CGAL::Geodesic_offset::internal::Offset_tolerances<double> Package;
  const Package of_one(1.);
  CHECK(Package::level_shift(1.) == level_shift && Package::longest_shallow_loop(1.) == longest_unseen_curve);
  CHECK(of_one.error == distance_error && of_one.smallest_cell == smallest_cell && of_one.shortest_piece == smallest_cell);
  CHECK(4 * Package::interval_gap(1.) == Judge_tolerances::part_of_edge);
}

// A small loop around a maximum inside a face, without edge crossings.
void judge_finds_missing_loop()
{
  Report::instance().set_context("loop in a face");
  Soup soup;
  soup.points = {Point_3(0, 0, 0), Point_3(4, 0, 0), Point_3(1, 3, 0)};
  soup.add_triangle({{0, 1, 2}});
  const Generated_mesh<Surface_mesh> data(soup);
  Judged judged(data.mesh, [&](Geodesic& g) {
    g.add_source_edges(std::vector<Surface_mesh::Edge_index>(data.mesh.edges().begin(), data.mesh.edges().end()));
  });
  const double radius = judged.geodesic.largest_distance().value();
  for (const double below : {1e-2, 1e-6, 1e-10})
  {
    const Verdict verdict = judged(radius - below, Offset_curves());
    CHECK_DETAIL(verdict.faults[FACE] > 0, "no curve, below the maximum by " + std::to_string(below));
  }
  CHECK(judged(radius * (1 + 1e-11), Offset_curves()).is_right());
  const Verdict verdict = judged(radius - 0.01, offsets(judged.geodesic, radius - 0.01));
  CHECK_DETAIL(verdict.is_right(), text_of(verdict));
}

Surface_mesh data_mesh(const std::string& name)
{
  Surface_mesh mesh;
  const std::string file = std::string(GEODESIC_OFFSET_TEST_DIR) + "/data/" + name;
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) throw std::runtime_error("cannot read " + file);
  return mesh;
}

// Open curves of the given total length, from kept windows and in one pass.
void open_curves(const Surface_mesh& mesh, const std::function<void(Geodesic&)>& add_sources, double level, std::size_t number,
                 double length, double tolerance)
{
  Judged judged(mesh, add_sources);
  Geodesic again(judged.geodesic);
  Offset_curves in_one_pass;
  again.build_with_offset_curves(level, std::back_inserter(in_one_pass));
  CHECK(again.statistics().forced_joints == 0);
  for (const Offset_curves& curves : {offsets(judged.geodesic, level), in_one_pass})
  {
    const Verdict verdict = judged(level, curves);
    CHECK_DETAIL(verdict.is_right(), text_of(verdict));
    const auto is_closed = [](const Offset_curve& c) { return c.is_closed(); };
    CHECK_DETAIL(curves.size() == number && std::none_of(curves.begin(), curves.end(), is_closed) &&
                   std::abs(total_length(curves) - length) <= tolerance,
                 std::to_string(curves.size()) + " curves, length: " + values(total_length(curves), length));
  }
}

// A grid with noise of 1e-5 in the third coordinate; the level is the distance of a vertex up to 1e-10, and of its
// neighbours up to the square of the noise.
void noisy_grid()
{
  const Surface_mesh mesh = data_mesh("noisy_grid.off");
  const auto section = [](Geodesic& g) { g.add_source_plane_section(Geodesic::Plane_3(0, 1, 0, -6)); };
  open_curves(mesh, section, 4.000000000112058, 1, 6, 1e-6);
}

// A grid of 10 x 4 edges, rotated in space and rounded to single precision. The source runs along its middle line, the level along
// both of its borders, whose vertices are up to 2e-7 nearer or farther. By the distances of the vertices from the line in space,
// parts of 1.9409, 1.4429 and 1.5744 of the borders are not nearer than the level; the curves cut them off.
void float_grid()
{
  const Surface_mesh mesh = data_mesh("float_grid.off");
  const std::vector<Point_3> line = {Point_3(-2.8866896629333496, -3.258190393447876, -0.98153901100158691),
                                     Point_3(-0.82976323366165161, -3.1763045787811279, -4.4111671447753906)};
  const auto add = [&](Geodesic& g) { g.add_source_polyline(g.locate_polyline(line).locations); };
  open_curves(mesh, add, 5, 3, 4.9583, 1e-4);
}

// A strip of four faces with a segment 2e-18 beside an edge. In the face behind, the direction of its end's bounding ray is lost.
void segment_beside_edge()
{
  Soup soup;
  soup.points = {Point_3(0, 0, 0),
                 Point_3(1, 0, 0),
                 Point_3(0, 6.4805305388921464e-06, 0),
                 Point_3(1, 5.2487576626785136e-06, 0),
                 Point_3(0, 1.122224522664797e-05, 0),
                 Point_3(1, 1.122224522664797e-05, 0)};
  const std::vector<std::array<std::size_t, 3>> triangles = {{{2, 1, 3}}, {{1, 2, 0}}, {{5, 4, 2}}, {{5, 2, 3}}};
  for (const auto& t : triangles) soup.add_triangle(t);
  const Generated_mesh<Surface_mesh> data(soup);
  const Locations<Surface_mesh> locations(data.mesh);
  Geodesic geodesic(data.mesh);
  geodesic.add_source_polyline(std::vector<Face_location>{
    locations.in_triangle(data, soup, 3, {{0.73509718806044289, 0.26490281193916065, 3.9650925279781651e-13}}),
    locations.in_triangle(data, soup, 3, {{9.6641851401110045e-08, 0.99999990335775213, 3.9650925279781651e-13}})});
  geodesic.build(CGAL::parameters::keep_windows(true));
  const double level = 3.8977497754521197e-06;
  const Offset_curves curves = offsets(geodesic, level);
  CHECK(curves.size() == 2);
  for (const Offset_curve& c : curves)
    for (const Offset_piece& p : c.pieces())
      for (int i = 0; i <= 4; ++i) CHECK(std::abs(geodesic.distance_to_sources(p.location(i / 4.)) - level) <= 1e-13);
}

void check_search(const Search_options& options)
{
  Offset_search search(options);
  search.run();
  if (options.meshes > 1) search.print_table();
  const Search_counts total = search.total();
  CHECK_DETAIL(total.wrong == 0, std::to_string(total.wrong) + " levels with wrong curves");
  CHECK_DETAIL(total.forced_joints == 0, std::to_string(total.forced_joints) + " forced joints");
  CHECK_DETAIL(total.exceptions == 0, std::to_string(total.exceptions) + " exceptions");
  CHECK_DETAIL(total.invalid == 0, std::to_string(total.invalid) + " meshes rejected by the validator");
  CHECK(total.levels > 0 && total.pieces > 0 && total.validated > 0);
}

void search()
{
  Search_options options;
  options.meshes = number_of_cases(std::size_t(300), std::size_t(1000));
  options.seconds = 300; // in unoptimized builds
  options.validate = 25;
  options.printed = 20;
  check_search(options);
  options.seed = 1000;
  options.sources = 4;
  check_search(options);
}

void check_case(unsigned seed, std::size_t sources)
{
  Report::instance().set_context("seed " + std::to_string(seed));
  Search_options options;
  options.seed = seed;
  options.sources = sources;
  options.meshes = 1;
  options.validate = 1;
  options.printed = 20;
  check_search(options);
}

// Cases of the search that had wrong curves or forced joints.
void found_cases()
{
  for (const unsigned seed :
       {685u,     42415u,    53199u,    81069u,    83379u,    84901u,    92895u,   94191u,   305598u,  311999u,
        313220u,  402016u,   501193u,   501415u,   503432u,   504628u,   602188u,  602639u,  609499u,  612007u,
        613591u,  614000u,   701615u,   707841u,   709253u,   714755u,   805966u,  806458u,  810966u,  900332u,
        903804u,  904756u,   1003096u,  1005083u,  1102184u,  1109149u,  1202347u, 1214103u, 1214975u, 1308347u,
        1311193u, 1513758u,  1711018u,  2003022u,  2008893u,  2210632u,  2212989u, 2219517u, 2914345u, 3004703u,
        3407098u, 73007913u, 73012491u, 73013612u, 73013667u, 77006403u, 91000042u})
    check_case(seed, 0);
  for (const unsigned seed : {1133u, 1766u, 3775u, 79000781u, 79001299u, 79002831u, 79003385u}) check_case(seed, 4);
  check_case(6912663, 3); // a level along a needle, whose sides rounding does not tell apart: 22 forced joints before
}

} // namespace test_offset_search

GEODESIC_OFFSET_TEST(test_offset_search)
{
  const std::pair<const char*, void (*)()> tests[] = {
    {"tolerances", tolerances},
    {"the judge finds damage", judge_finds_damage},
    {"the judge finds a missing loop", judge_finds_missing_loop},
    {"noisy grid", noisy_grid},
    {"float grid", float_grid},
    {"segment beside an edge", segment_beside_edge},
    {"search", search},
    {"found cases", found_cases}};
  return run_tests("test_offset_search", tests);
}
