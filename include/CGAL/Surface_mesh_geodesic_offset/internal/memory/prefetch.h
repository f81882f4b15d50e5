// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Software prefetch.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MEMORY_PREFETCH_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MEMORY_PREFETCH_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <boost/config.hpp>

#include <cstddef>
#include <cstdint>

namespace CGAL::Geodesic_offset::internal {

// Forced inline: the compiler would drop a call of a function without effects. The address may be invalid.
BOOST_FORCEINLINE void prefetch(const void* p)
{
#if defined(__GNUC__)
  __builtin_prefetch(p);
#else
  (void)p;
#endif
}

BOOST_FORCEINLINE void prefetch(const void* p, std::size_t bytes)
{
  for (std::size_t i = 0; i < bytes; i += 64) prefetch(static_cast<const char*>(p) + i);
}

// Index i may be out of range.
template <class T>
BOOST_FORCEINLINE void prefetch_element(const T* first, std::size_t i)
{
  prefetch(reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(first) + i * sizeof(T)));
}

} // namespace CGAL::Geodesic_offset::internal

#endif
