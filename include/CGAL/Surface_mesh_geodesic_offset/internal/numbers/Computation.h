// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers that computations run on, which may be others than those of the user's kernel, and the way between the two.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_NUMBERS_COMPUTATION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_NUMBERS_COMPUTATION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Simple_cartesian.h>

#include <type_traits>

namespace CORE {
class Expr;
}

namespace CGAL {

template <class K, class TriangleMesh>
class Surface_mesh_geodesic_offset_traits;

namespace Geodesic_offset {
namespace internal {

// Exact_square_roots.h says what stands for CORE::Expr.
template <class FT>
struct Computation_number
{
  static_assert(!std::is_same<FT, CORE::Expr>::value,
                "Surface_mesh_geodesic_offset: for a kernel with exact square roots, include "
                "<CGAL/Surface_mesh_geodesic_offset/Exact_square_roots.h>");
  typedef FT type;
};

// The traits that compute: the user's, unless these are the package's own with numbers that others stand for.
template <class Traits>
struct Computation
{
  typedef Traits Computing_traits;
  static const Traits& computing_traits(const Traits& traits) { return traits; }
};

template <class K, class TriangleMesh>
struct Computation<Surface_mesh_geodesic_offset_traits<K, TriangleMesh>>
{
  typedef Surface_mesh_geodesic_offset_traits<K, TriangleMesh> Traits;
  typedef typename Computation_number<typename K::FT>::type Number;
  static constexpr bool is_own = std::is_same<Number, typename K::FT>::value;
  typedef std::conditional_t<is_own, Traits, Surface_mesh_geodesic_offset_traits<Simple_cartesian<Number>, TriangleMesh>>
    Computing_traits;

  static Computing_traits computing_traits(const Traits& traits)
  {
    if constexpr (is_own) return traits;
    else return (void)traits, Computing_traits();
  }
};

template <class To, class From>
struct Number_conversion
{
  static To convert(const From& x) { return To(x); }
};

template <class FT>
struct Number_conversion<FT, FT>
{
  static const FT& convert(const FT& x) { return x; }
};

template <class To, class From>
inline decltype(auto) converted_number(const From& x)
{
  return Number_conversion<To, From>::convert(x);
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
