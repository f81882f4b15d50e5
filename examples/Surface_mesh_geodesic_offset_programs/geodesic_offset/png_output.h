// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Writer of PNG files, by Boost.GIL and libpng.

#ifndef GEODESIC_OFFSET_PNG_OUTPUT_H
#define GEODESIC_OFFSET_PNG_OUTPUT_H

#include "common/picture.h"

#include <boost/gil.hpp>
#include <boost/gil/extension/io/png.hpp>

#include <cstddef>
#include <ostream>

namespace geodesic_offset {

inline void write_png(std::ostream& out, const Image& image)
{
  namespace gil = boost::gil;
  const auto view = gil::interleaved_view(static_cast<std::size_t>(image.width), static_cast<std::size_t>(image.height),
                                          reinterpret_cast<const gil::rgb8_pixel_t*>(image.bytes.data()),
                                          static_cast<std::ptrdiff_t>(3) * image.width);
  gil::write_view(out, view, gil::png_tag());
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_PNG_OUTPUT_H
