// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes whose points belong to another kernel than the traits, side tests with and without exact predicates, and pairs of numbers.

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "path_tools.h"
#include "test_check.h"
#include "traits_archetype.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpfr.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/tags.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Simd_edge_exit.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_bisector.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test_kernels {

using namespace test;

typedef CGAL::Exact_predicates_exact_constructions_kernel Exact_kernel;
typedef CGAL::Simple_cartesian<double> Plain_kernel;
typedef CGAL::Simple_cartesian<CGAL::Gmpfr> Long_kernel;
typedef Generated_mesh<test::Surface_mesh> Data;

// Typical results on any mesh: distances, a path, a located point, and an offset, all as doubles for comparison.
template <class Mesh>
std::vector<double> results(const Mesh& mesh)
{
  typedef Geodesic_with<Kernel, Mesh> Geodesic_here;
  std::vector<double> out;
  Geodesic_here geodesic(mesh);
  geodesic.add_source_point(*vertices(mesh).begin());
  const auto anywhere = geodesic.locate(Point_3(0.2, 0.3, 0.4)); // somewhere on the surface
  geodesic.add_source_point(anywhere);
  geodesic.build(CGAL::parameters::keep_windows(true));
  for (auto v : vertices(mesh)) out.push_back(geodesic.distance_to_sources(v));
  std::vector<Point_3> path;
  for (auto v : vertices(mesh)) geodesic.shortest_path_points_to_sources(v, std::back_inserter(path));
  for (const Point_3& p : path) out.insert(out.end(), {p.x(), p.y(), p.z()});
  const auto farthest = geodesic.farthest_point().value();
  out.push_back(farthest.second);
  std::vector<typename Geodesic_here::Offset_curve> curves;
  geodesic.offset_curves(std::vector<double>{0.4 * farthest.second}, std::back_inserter(curves));
  for (const auto& curve : curves)
  {
    out.push_back(curve.length());
    out.push_back(static_cast<double>(curve.pieces().size()));
    for (const auto& element : curve.elements(0)) out.push_back(CGAL::to_double(element.sweep()));
    curve.points_at_spacing(0.1, boost::make_function_output_iterator([&](const auto& p) {
                              out.push_back(CGAL::to_double(p.tangent * curve.smooth_normal(p.location)));
                            }));
  }
  return out;
}

// The same vertices, faces and first halfedges.
template <class AnyKernel, class Mesh>
CGAL::Surface_mesh<typename AnyKernel::Point_3> same_mesh(const Mesh& mesh)
{
  typedef typename Mesh::Point::R::FT From;
  const CGAL::NT_converter<From, typename AnyKernel::FT> convert{};
  CGAL::Surface_mesh<typename AnyKernel::Point_3> result;
  for (Vertex_index v : vertices(mesh))
  {
    const auto& p = mesh.point(v);
    result.add_vertex(typename AnyKernel::Point_3(convert(p.x()), convert(p.y()), convert(p.z())));
  }
  for (Face_index f : faces(mesh))
  {
    const auto h = halfedge(f, mesh);
    const auto g = result.add_face(source(h, mesh), target(h, mesh), target(next(h, mesh), mesh));
    auto first = result.halfedge(g);
    while (result.source(first) != source(h, mesh)) first = result.next(first);
    result.set_halfedge(g, first);
  }
  return result;
}

// Equal coordinates in other kernels and other mesh types give equal results.
void meshes_of_other_kernels()
{
  for (const Soup& soup : {rotated(random_rectangle(2, 1, 60, 6, 1), 1), icosphere(2), torus(12, 8), saddle_fan()})
  {
    Soup rounded = soup; // to multiples of 2^-16, exact in float
    const auto round = [](double x) { return std::nearbyint(x * 65536) / 65536; };
    for (Point_3& p : rounded.points) p = Point_3(round(p.x()), round(p.y()), round(p.z()));
    const Data data(rounded);
    const std::vector<double> expected = results(data.mesh);

    CHECK(results(same_mesh<Exact_kernel>(data.mesh)) == expected);
    CHECK(results(same_mesh<CGAL::Simple_cartesian<float>>(data.mesh)) == expected);
    CHECK(results(same_mesh<Plain_kernel>(data.mesh)) == expected);

    typedef CGAL::Polyhedron_3<Exact_kernel> Polyhedron; // has another order of elements
    Polyhedron polyhedron;
    std::map<Vertex_index, boost::graph_traits<Polyhedron>::vertex_descriptor> copy_of;
    CGAL::copy_face_graph(data.mesh, polyhedron,
                          CGAL::parameters::vertex_to_vertex_map(boost::make_assoc_property_map(copy_of)));
    Geodesic geodesic(data.mesh);
    geodesic.add_source_point(data.vertices[0]);
    geodesic.build();
    Geodesic_with<Kernel, Polyhedron> other(polyhedron);
    other.add_source_point(copy_of.at(data.vertices[0]));
    other.build();
    Worst_error worst(1e-12, bounding_box_diagonal(data.mesh));
    for (auto v : vertices(data.mesh))
      CHECK_CLOSE(worst, other.distance_to_sources(copy_of.at(v)), geodesic.distance_to_sources(v));
  }
}

// Coordinates that are not doubles, as from a Boolean operation or a transformation with exact numbers.
void mesh_of_rational_coordinates()
{
  typedef Exact_kernel::FT Rational;
  typedef CGAL::Surface_mesh<Exact_kernel::Point_3> Exact_mesh;
  const Data data(rotated(icosphere(1), 3));
  Exact_mesh exact = same_mesh<Exact_kernel>(data.mesh);
  bool is_rounded = false;
  for (const auto v : vertices(exact))
  {
    const auto p = exact.point(v);
    exact.point(v) = Exact_kernel::Point_3(p.x() / 3, p.y() / 7 + Rational(1) / 9, p.z() / 11);
    is_rounded = is_rounded || exact.point(v).x() != Rational(CGAL::to_double(exact.point(v).x()));
  }
  CHECK(is_rounded);
  CHECK(num_faces(exact) == 80 && CGAL::is_valid_polygon_mesh(exact));
  CHECK(results(exact) == results(same_mesh<Kernel>(exact)));
}

// Flat convex meshes of needle faces, up to faces that are lines up to rounding: the straight line is correct. All paths to
// a point tie up to rounding, and no other window replaces one that is dropped for an apparently equal path.
void needles()
{
  for (double width : {1e-3, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-12})
    for (unsigned seed : {1u, 2u, 6u, 47u})
    {
      const Data data(random_rectangle(1, width, 40, 6, seed));
      for (std::size_t i = 0; i < data.vertices.size(); ++i)
      {
        const std::vector<double> distances = distances_from<Kernel>(data.mesh, data.vertices[i]);
        Worst_error worst(1e-12, 1);
        for (std::size_t j = 0; j < data.vertices.size(); ++j)
          CHECK_CLOSE(worst, distances[j], distance(data.mesh.point(data.vertices[i]), data.mesh.point(data.vertices[j])));
      }
    }
}

// Rays that pass an apex within rounding: the guarded side test is exact, the plain test is not.
void side_tests_near_zero()
{
  typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, test::Surface_mesh> Guarded;
  typedef CGAL::Surface_mesh_geodesic_offset_traits<Plain_kernel, test::Surface_mesh> Plain;
  const auto guarded = Guarded().compare_entry_with_apex_2_object();
  const auto plain = Plain().compare_entry_with_apex_2_object();
  std::size_t wrong = 0, zeros = 0;
  Random random(5);
  for (std::size_t i = 0; i < 200000; ++i)
  {
    // dyadic numbers, so that some rays meet the apex exactly
    const auto number = [&](double low, double high) { return std::nearbyint(uniform(random, low, high) * 1048576) / 1048576; };
    const bool parallel = i % 3 == 0;
    const double x = number(-2, 2), y = number(-2, -0.01);
    double ax = number(-1, 2), ay = number(0.01, 1), b;
    if (i % 7 == 0)
    { // the apex on the ray through b
      b = number(-1, 2);
      ax = b + 0.25 * (parallel ? -x : b - x);
      ay = -0.25 * y;
    }
    else // entry of the ray to the apex
      b = (x * ay - y * ax) / (parallel ? -y : ay - y);
    for (std::size_t k = uniform_index(random, 4); k > 0; --k) b = std::nextafter(b, i % 2 ? 9. : -9.);
    const CGAL::Exact_rational X(x), Y(y), B(b), AX(ax), AY(ay);
    const CGAL::Exact_rational slope = parallel ? CGAL::Exact_rational(-Y) : CGAL::Exact_rational(AY - Y);
    const CGAL::Sign exact = CGAL::sign(CGAL::Exact_rational(B * slope - (X * AY - Y * AX)));
    CHECK(guarded(x, y, parallel, b, ax, ay) == exact);
    if (plain(x, y, parallel, b, ax, ay) != exact) ++wrong;
    if (exact == CGAL::ZERO) ++zeros;
  }
  std::cout << "side tests: " << wrong << " of 200000 wrong without exact predicates, " << zeros << " rays hit the apex"
            << std::endl;
  CHECK(wrong > 1000 && zeros > 100);
}

// Side tests with floats, whose values are exact in double.
void side_tests_of_floats()
{
  typedef CGAL::Filtered_kernel<CGAL::Simple_cartesian<float>> Short_kernel;
  typedef CGAL::Surface_mesh_geodesic_offset_traits<Short_kernel, CGAL::Surface_mesh<Short_kernel::Point_3>> Short;
  const auto compare = Short().compare_entry_with_apex_2_object();
  Random random(6);
  std::size_t zeros = 0;
  for (std::size_t i = 0; i < 100000; ++i)
  {
    const auto number = [&](double low, double high) {
      return float(std::nearbyint(uniform(random, low, high) * 1024) / 1024);
    };
    const bool parallel = i % 3 == 0;
    const float x = number(-2, 2), y = number(-2, -0.01), ax = number(-1, 2), ay = number(0.01, 1);
    float b = (x * ay - y * ax) / (parallel ? -y : ay - y);
    for (std::size_t k = uniform_index(random, 4); k > 0; --k) b = std::nextafter(b, i % 2 ? 9.f : -9.f);
    typedef CGAL::Exact_rational Exact;
    const Exact X(x), Y(y), B(b), AX(ax), AY(ay), slope = parallel ? Exact(-Y) : Exact(AY - Y);
    const CGAL::Sign exact = CGAL::sign(Exact(B * slope - (X * AY - Y * AX)));
    CHECK(compare(x, y, parallel, b, ax, ay) == exact);
    if (exact == CGAL::ZERO) ++zeros;
  }
  CHECK_DETAIL(zeros > 10, std::to_string(zeros));
}

// Pairs round as single numbers do, and comparisons with NaN are false.
template <class FT>
void pairs_are_two_numbers()
{
  using CGAL::Geodesic_number_pair;
  typedef Geodesic_number_pair<FT> Pair;
  const FT nan = std::numeric_limits<FT>::quiet_NaN(), infinity = std::numeric_limits<FT>::infinity();
  const std::vector<FT> numbers{FT(0), FT(-0.), FT(1) / 3, FT(-7) / 11, FT(1e10) / 7, FT(-3e-20) / 7, infinity, -infinity, nan};
  const auto same = [](FT a, FT b) { return a != a ? b != b : a == b && std::signbit(a) == std::signbit(b); };
  const auto check = [&](const Pair& p, FT first, FT second) { CHECK(same(p.first(), first) && same(p.second(), second)); };
  for (const unsigned bits : {0u, 1u, 2u, 3u}) CHECK(typename Pair::Test((bits & 1) != 0, (bits & 2) != 0).bits() == bits);
  for (FT a : numbers)
    for (FT b : numbers)
      for (FT c : numbers)
      {
        const Pair p(a, b), q(c, a);
        check(p + q, a + c, b + a);
        check(p - q, a - c, b - a);
        check(p * q, a * c, b * a);
        check(p / q, a / c, b / a);
        if (a == a && b == b)
          check(square_root(p), CGAL::Geodesic_offset::internal::square_root<FT>(a),
                CGAL::Geodesic_offset::internal::square_root<FT>(b));
        CHECK((p < q).bits() == unsigned(a < c) + 2 * unsigned(b < a));
        CHECK((p <= q).bits() == unsigned(a <= c) + 2 * unsigned(b <= a));
        CHECK(((p < q) & (q < p)).bits() == 0);
        check(p.swapped(), b, a);
        check(p.both_first(), a, a);
        check(p.both_second(), b, b);
        CGAL::Geodesic_offset::internal::Window<FT> w;
        w.x = a;
        w.y = b;
        check(Pair::of(w.x, w.y), a, b);
        q.put(w.b0, w.b1);
        check(Pair(w.b0, w.b1), c, a);
      }
  const Pair negated = Pair(FT(1), FT(0)).with_second_negated();
  check(negated, FT(1), FT(-0.));
  CHECK(CGAL::Geodesic_offset::internal::square_root<FT>(FT(-1)) == 0);
}

typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, test::Surface_mesh> Package_traits;

// Derived traits whose changes of frames have no tag.
struct Without_pair_frames : Package_traits
{
  struct Change_frame_2
  {
    Image_2 operator()(double x, double y, double sigma, bool is_parallel, double ox, double oy, double c, double s) const
    {
      return Package_traits().change_frame_2_object()(x, y, sigma, is_parallel, ox, oy, c, s);
    }
  };
  Change_frame_2 change_frame_2_object() const { return Change_frame_2(); }
};

// Derived traits whose distances have the tag Tag_false.
struct Without_pair_distances : Package_traits
{
  struct Compute_distance_2 : Package_traits::Compute_distance_2
  {
    typedef CGAL::Tag_false Has_pairs;
  };
  Compute_distance_2 compute_distance_2_object() const { return Compute_distance_2(); }
};

// Our traits have operators for pairs of floating point numbers, as in SurfaceMeshGeodesicOffsetTraitsWithPairs. Each functor of
// derived traits has its own tag. With pairs that are not in one register, such as those of long double, and without pairs,
// the distances are the same.
void pairs()
{
  using namespace CGAL::Geodesic_offset::internal;
  typedef CGAL::Simple_cartesian<long double> Longer_kernel;
  typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, test::Surface_mesh> Traits;
  typedef CGAL::Surface_mesh_geodesic_offset_traits<Longer_kernel, test::Surface_mesh> Longer_traits;
  typedef CGAL::Surface_mesh_geodesic_offset_traits<Long_kernel, test::Surface_mesh> Long_traits;
  typedef Traits_archetype<test::Surface_mesh> Archetype;
  static_assert(Has_pair_children<Traits>::value && Has_pair_distances<Traits>::value, "of double");
  static_assert(Has_pair_children<Longer_traits>::value && Has_pair_distances<Longer_traits>::value, "of long double");
  static_assert(!Has_pair_children<Long_traits>::value && !Has_pair_distances<Long_traits>::value, "not of CGAL::Gmpfr");
  static_assert(!Has_pair_children<Archetype>::value && !Has_pair_distances<Archetype>::value, "no tag");
  static_assert(!Has_pair_children<Without_pair_frames>::value && Has_pair_distances<Without_pair_frames>::value,
                "no tag of frames");
  static_assert(Has_pair_children<Without_pair_distances>::value && !Has_pair_distances<Without_pair_distances>::value,
                "Tag_false");
  pairs_are_two_numbers<double>();
  pairs_are_two_numbers<float>();
  pairs_are_two_numbers<long double>();
  for (const Soup& soup : {rotated(random_rectangle(2, 1, 60, 6, 1), 1), icosphere(3), torus(12, 8), saddle_fan()})
  {
    const Data data(soup);
    const std::vector<double> expected = distances_from<Kernel>(data.mesh, data.vertices[0]);
    const std::vector<long double> distances = distances_from<Longer_kernel>(data.mesh, data.vertices[0]);
    Worst_error worst(1e-13, bounding_box_diagonal(data.mesh));
    for (std::size_t i = 0; i < expected.size(); ++i) CHECK_CLOSE(worst, static_cast<double>(distances[i]), expected[i]);
    const auto check_equal = [&](auto traits) {
      CGAL::Surface_mesh_geodesic_offset<decltype(traits)> geodesic(data.mesh);
      geodesic.add_source_point(data.vertices[0]);
      geodesic.build();
      for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK_CLOSE(worst, geodesic.distance_to_sources(data.vertices[i]), expected[i]);
    };
    check_equal(Without_pair_frames());
    check_equal(Without_pair_distances());
  }
}

} // namespace test_kernels

GEODESIC_OFFSET_TEST(test_kernels)
{
  const std::pair<const char*, void (*)()> tests[] = {
    {"meshes of other kernels", meshes_of_other_kernels},
    {"mesh of rational coordinates", mesh_of_rational_coordinates},
    {"needles", needles},
    {"side tests near zero", side_tests_near_zero},
    {"side tests of floats", side_tests_of_floats},
    {"pairs", pairs}};
  return run_tests("test_kernels", tests);
}
