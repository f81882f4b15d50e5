// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Debug mode of certified bounds, with CGAL_GEODESIC_OFFSET_CHECK_CERTIFICATES: images and frames with 200 bits, which all
// windows carry along. Without the macro, this header only defines an empty macro.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_PRECISE_MESH_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_PRECISE_MESH_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#ifndef CGAL_GEODESIC_OFFSET_CHECK_CERTIFICATES

#define CGAL_GEODESIC_OFFSET_CERTIFICATE(...)

#else

#define CGAL_GEODESIC_OFFSET_CERTIFICATE(...) __VA_ARGS__

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Double_double.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>

#include <boost/multiprecision/mpfr.hpp>

#include <array>
#include <deque>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// 61 decimal digits are 203 bits.
typedef boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<61, boost::multiprecision::allocate_stack>,
                                      boost::multiprecision::et_off>
  Precise;

inline Precise precise(const Double_double& x) { return Precise(x.high) + Precise(x.low); }

struct Precise_2
{
  Precise x, y;
};

inline Precise precise_length(const Precise& x, const Precise& y) { return boost::multiprecision::sqrt(x * x + y * y); }

// Image of a window without rounding, in the frame of the window's halfedge.
struct Precise_image
{
  Precise x, y, sigma;
  bool is_parallel;

  Precise distance(const Precise& px, const Precise& py) const
  {
    return is_parallel ? Precise(sigma - (x * px + y * py)) : Precise(sigma + precise_length(px - x, py - y));
  }
  Precise distance(double t) const { return distance(Precise(t), Precise(0)); }

  // x coordinate of the vector from (b, 0) to the image.
  Precise to_image(const Precise& b) const { return is_parallel ? x : Precise(x - b); }

  // Positive if (px, py) is to the left of the ray through (b, 0).
  Precise side(const Precise& px, const Precise& py, const Precise& b) const { return y * (px - b) - to_image(b) * py; }
};

struct Precise_halfedge
{
  Precise length;
  Precise_2 corner; // as in Certified_mesh
  Precise angle;    // of the corner
};

class Certificate_error : public std::logic_error
{
public:
  explicit Certificate_error(const std::string& what) : std::logic_error("certificate: " + what) {}
};

inline void check_certificate(bool holds, const char* what)
{
  if (!holds) throw Certificate_error(what);
}

// Frames of all faces, and all images.
class Precise_mesh
{
public:
  Precise_mesh(const Unfolded_mesh<double>& unfolded, const std::vector<std::array<double, 3>>& points)
    : m_unfolded(unfolded), m_halfedges(unfolded.number_of_halfedges())
  {
    for (Index h = 0; h < m_halfedges.size(); ++h)
    {
      if (unfolded.source(h) == no_index) continue;
      const auto &p = points[unfolded.source(h)], &q = points[unfolded.target(h)], &r = points[unfolded.apex(h)];
      Precise u[3], v[3], uu = 0, vv = 0, uv = 0;
      for (int k = 0; k < 3; ++k)
      {
        u[k] = Precise(q[k]) - Precise(p[k]);
        v[k] = Precise(r[k]) - Precise(p[k]);
        uu += u[k] * u[k];
        vv += v[k] * v[k];
        uv += u[k] * v[k];
      }
      Precise nn = 0;
      for (int k = 0; k < 3; ++k)
      {
        const Precise n = u[k] * v[(k + 1) % 3] - u[(k + 1) % 3] * v[k];
        nn += n * n;
      }
      m_halfedges[h].length = boost::multiprecision::sqrt(uu);
      const Precise scale = boost::multiprecision::sqrt(uu * vv);
      m_halfedges[h].corner = {uv / scale, boost::multiprecision::sqrt(nn) / scale};
      m_halfedges[h].angle = atan2(m_halfedges[h].corner.y, m_halfedges[h].corner.x);
    }
  }

  const Precise_halfedge& operator[](Index h) const { return m_halfedges[h]; }

  Precise_2 apex(Index h) const
  {
    const Precise& l = m_halfedges[m_unfolded.previous(h)].length;
    return {m_halfedges[h].corner.x * l, m_halfedges[h].corner.y * l};
  }

  // The address of the image remains valid.
  const Precise_image* add(const Precise_image& image) const
  {
    m_images.push_back(image);
    return &m_images.back();
  }

  // Exact version of Certified_sources::beyond_edge().
  Precise_2 beyond_edge(Index face, int k, Precise_2 p, bool is_direction) const
  {
    const Index h = 3 * face;
    for (int i = 0; i < k; ++i)
    {
      if (!is_direction) p.x -= m_halfedges[h + Index(i)].length;
      const Precise_2& c = m_halfedges[h + Index(i + 1)].corner;
      p = in_frame({-c.x, c.y}, p);
    }
    if (!is_direction) return {m_halfedges[h + Index(k)].length - p.x, -p.y};
    return {-p.x, -p.y};
  }

  static Precise_2 in_frame(const Precise_2& axis, const Precise_2& v)
  {
    return {axis.x * v.x + axis.y * v.y, axis.x * v.y - axis.y * v.x};
  }

private:
  const Unfolded_mesh<double>& m_unfolded;
  std::vector<Precise_halfedge> m_halfedges;
  mutable std::deque<Precise_image> m_images;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
#endif
