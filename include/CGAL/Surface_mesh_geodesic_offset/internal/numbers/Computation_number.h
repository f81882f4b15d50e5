// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The number type of the computation, which may differ from that of the user's kernel, and conversions between the two.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_NUMBERS_COMPUTATION_NUMBER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_NUMBERS_COMPUTATION_NUMBER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <tuple>
#include <type_traits>
#include <utility>

namespace CORE {
class Expr;
}

namespace CGAL {

template <class K, class TriangleMesh>
class Surface_mesh_geodesic_offset_traits;

namespace Geodesic_offset {
namespace internal {

// The number type of the computation for a kernel's FT. Radical_numbers.h specializes it for CORE::Expr.
template <class FT>
struct Computation_number
{
  static_assert(!std::is_same<FT, CORE::Expr>::value,
                "Surface_mesh_geodesic_offset: for a kernel with exact square roots, include "
                "<CGAL/Surface_mesh_geodesic_offset/Radical_numbers.h>");
  typedef FT type;
};

// The kernel of points in space in the core: one kernel for all kernels on doubles.
template <class K>
using Space_kernel =
  std::conditional_t<std::is_same<typename K::FT, double>::value, Exact_predicates_inexact_constructions_kernel, K>;

// The package's traits class that a class is or derives from; void for other classes.
template <class K, class TriangleMesh>
Surface_mesh_geodesic_offset_traits<K, TriangleMesh> package_traits_of(
  const Surface_mesh_geodesic_offset_traits<K, TriangleMesh>*);
void package_traits_of(const void*);

template <class Traits>
using Package_traits = decltype(internal::package_traits_of(static_cast<const Traits*>(nullptr)));

// Functor types of a traits class.
template <class Traits, class T = const Traits&>
using Functors_of =
  std::tuple<decltype(std::declval<T>().construct_apices_2_object()), decltype(std::declval<T>().change_frame_2_object()),
             decltype(std::declval<T>().compare_entry_with_apex_2_object()),
             decltype(std::declval<T>().compute_distance_2_object()), decltype(std::declval<T>().compare_distance_2_object())>;

// The traits of the computation: the user's, unless these have the functors of the package's traits. Then the traits are those of
// the package for the number type of the computation, without the type of the mesh: the front is the same for all meshes.
template <class Traits, class Package = Package_traits<Traits>>
struct Computation;

template <class Traits>
struct Computation<Traits, void>
{
  static_assert(!std::is_same<typename Traits::FT, CORE::Expr>::value,
                "Surface_mesh_geodesic_offset: with exact square roots, the traits must be Surface_mesh_geodesic_offset_traits "
                "or derived from it; on numbers of CORE, computations do not end");
  typedef Traits Computing_traits;
  static const Traits& computing_traits(const Traits& traits) { return traits; }
};

template <class Traits, class K, class TriangleMesh>
struct Computation<Traits, Surface_mesh_geodesic_offset_traits<K, TriangleMesh>>
{
  typedef Surface_mesh_geodesic_offset_traits<K, TriangleMesh> Package;
  typedef typename Computation_number<typename K::FT>::type Number;
  static constexpr bool is_own_number = std::is_same<Number, typename K::FT>::value,
                        has_functors_of_package = std::is_same<Functors_of<Traits>, Functors_of<Package>>::value;
  static_assert(is_own_number || has_functors_of_package,
                "Surface_mesh_geodesic_offset: with exact square roots, traits that are derived from "
                "Surface_mesh_geodesic_offset_traits must have its functors: the computation is on other numbers");
  typedef std::conditional_t<is_own_number, Space_kernel<K>, Simple_cartesian<Number>> Computing_kernel;
  typedef std::conditional_t<has_functors_of_package, Surface_mesh_geodesic_offset_traits<Computing_kernel, void>, Traits>
    Computing_traits;

  static Computing_traits computing_traits(const Traits& traits)
  {
    if constexpr (has_functors_of_package) return (void)traits, Computing_traits();
    else return traits;
  }
};

template <class Traits>
struct Core_definitions; // complete in core_definitions.h

// True if the compiled library has the functions of the core for the traits of a computation.
template <class Computing_traits>
constexpr bool is_compiled =
  std::is_same<Computing_traits,
               Surface_mesh_geodesic_offset_traits<Exact_predicates_inexact_constructions_kernel, void>>::value;

// True if the functions of the core are in the compiled library, or their definitions are visible.
template <class Computing_traits, class = void>
constexpr bool has_core_functions =
#ifdef CGAL_GEODESIC_OFFSET_COMPILED
  is_compiled<Computing_traits>;
#else
  true;
#endif
template <class Computing_traits>
constexpr bool has_core_functions<Computing_traits, std::void_t<decltype(sizeof(Core_definitions<Computing_traits>))>> = true;

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
