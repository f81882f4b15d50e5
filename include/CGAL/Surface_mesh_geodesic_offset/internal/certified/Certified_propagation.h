// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Unfolding of a window across a face without loss of a ray that may be shortest.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_PROPAGATION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_PROPAGATION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_window.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Rotation.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_offset::internal {

// Certified counterpart of Window_propagation: the face of a halfedge p -> q with apex r.
class Certified_propagation
{
public:
  Certified_propagation(const Certified_mesh& mesh, Index h)
    : Certified_propagation(mesh[h], mesh[mesh.unfolded().next(h)], mesh[mesh.unfolded().previous(h)], mesh.apex(h))
  {
  }

  // Side of the apex on which the rays of a window pass: -1 if all are to the left, 1 if all are to the right, 0 if the
  // window covers the apex. The test ignores the low digits and uses a large margin; `is_clear` is false if it does not
  // decide.
  int clear_side(const Certified_window& w, bool& is_clear) const
  {
    const double slope = w.is_parallel() ? -w.y : apex_y - w.y, r0 = w.x * apex_y, r1 = w.y * apex_x, r = r0 - r1;
    const double margin =
      0x1p-36 * (length * slope + std::abs(r0) + std::abs(r1)) + w.error_of_image() * (length + 2 * left_length);
    const double v0 = w.b0 * slope - r, v1 = w.b1 * slope - r;
    is_clear = true;
    if (v1 < -margin) return -1;
    if (v0 > margin) return 1;
    is_clear = v0 < -margin && v1 > margin;
    return 0;
  }

  Sign side_of_apex(const Certified_window& w, double b) const { return w.side_of(m_apex.x, apex_y, place(b)); }

  // Vector from the apex to the image.
  Point_in_face<double> from_apex(const Certified_window& w) const
  {
    if (w.is_parallel()) return {w.x, w.y};
    return {(w.x - apex_x) + (w.x_low - m_apex.x.low), (w.y - apex_y) + (w.y_low - m_apex.y.low)};
  }

  // Accurate up to the rounding of a length, however near the image is.
  double distance_at_apex(const Certified_window& w) const
  {
    if (w.is_parallel()) return w.distance_at(apex_x, apex_y);
    return w.sigma + internal::length(from_apex(w));
  }

  // If the apex is not certainly in the rays of a window, upper bound of the excess length of a path around an end of its
  // interval.
  double lateral_error(const Certified_window& w) const
  {
    return (std::max)(w.way_around(m_apex.x, apex_y, place(w.b0)), w.way_around(m_apex.x, apex_y, place(w.b1)));
  }

  // Error bound of a window's distance at the apex.
  double error_at_apex(const Certified_window& w, double distance, double lateral) const
  {
    const double rounding = side_error * (distance + (w.is_parallel() ? length + left_length : 0.));
    return w.radius + rounding + lateral + 4 * w.error_of_image();
  }

  // Entry of the ray to the apex, up to rounding of the length.
  double entry_of_apex(const Certified_window& w) const
  {
    if (w.is_parallel()) return apex_x - apex_y * (w.x / w.y);
    const double x = w.x + w.x_low;
    return x + (apex_x - x) * (w.y / (w.y - apex_y));
  }

  // Error bound of this entry, for a window with at least the given distance at the apex: rounding of the coordinates, and
  // the error of the image, which displaces the entry in proportion to the cotangent of the ray's angle.
  double error_of_entry(double distance, double entry) const
  {
    const double size = distance + length + left_length, slope = 1 + std::abs(apex_x - entry) / apex_y;
    return length_error * size + 4 * image_error * (2 * size + 1) * slope;
  }

  // Computes the child on p -> r of the rays that enter between b0 and `end`, or up to the apex if to_apex; then paths may
  // be longer by `lateral`. Returns false if the child is empty.
  BOOST_FORCEINLINE bool left_child(const Certified_window& w, double end, bool to_apex, double lateral,
                                    Certified_window& child) const
  {
    const double off = w.error_of_image();
    if (!turn(w, m_to_left, w.image(), child)) return false;
    double from, to = left_length, grazing = to_apex ? lateral : 0.;
    if (!near_exit(w, w.to_image(place(w.b0)), w.b0, cl, sl, off, from, grazing)) return false;
    if (!to_apex) far_exit(w, w.to_image(place(end)), end, cl, sl, off, to, grazing);
    if (!(from < to)) return false;
    child.sigma = w.sigma;
    child.sigma_low = w.sigma_low;
    child.set_interval(from, to);
    child.radius = w.b0 > 0 || !to_apex || grazing > 0 ? sum_of_radii(w.radius, detour(to, off) + grazing) : w.radius;
    return true;
  }

  // Computes the child on r -> q of the rays that enter between `begin` and b1.
  BOOST_FORCEINLINE bool right_child(const Certified_window& w, double begin, bool from_apex, double lateral,
                                     Certified_window& child) const
  {
    const double off = w.error_of_image();
    const Double_double_2 image = w.image();
    if (!turn(w, m_to_right, w.is_parallel() ? image : Double_double_2{image.x - m_length, image.y}, child)) return false;
    double from, to = right_length, grazing = from_apex ? lateral : 0.; // from q
    if (!near_exit(w, -w.to_image(place(w.b1)), from_target(w.b1, -corner_error), cr, sr, off, from, grazing)) return false;
    if (!from_apex) far_exit(w, -w.to_image(place(begin)), from_target(begin, corner_error), cr, sr, off, to, grazing);
    if (!(from < to)) return false;
    child.sigma = w.sigma;
    child.sigma_low = w.sigma_low;
    if (w.is_parallel())
    { // the distance at r: forward from p to q, then back
      const Double_double sigma = Double_double(w.sigma, w.sigma_low) - image.x * m_length + child.image().x * m_right_length;
      child.sigma = sigma.high;
      child.sigma_low = sigma.low;
    }
    else
    {
      const Double_double x = child.image().x + m_right_length;
      child.x = x.high;
      child.x_low = x.low;
    }
    const double rounding = 2 * unit_roundoff * right_length;
    child.set_interval(to < right_length ? (std::max)(0., right_length - to - rounding) : 0.,
                       from > 0 ? (std::min)(right_length, right_length - from + rounding) : right_length);
    child.radius =
      w.b1 < length || !from_apex || grazing > 0 ? sum_of_radii(w.radius, detour(to, off) + grazing + 4 * rounding) : w.radius;
    if (!(child.b0 < child.b1)) return false;
    return true;
  }

private:
  typedef Certified_mesh::Halfedge Halfedge;

  Certified_propagation(const Halfedge& entry, const Halfedge& right, const Halfedge& left, const Double_double_2& apex)
    : m_to_left(entry.corner), m_to_right({right.corner.x, -right.corner.y}), m_length(entry.length),
      m_right_length(right.length), m_apex(apex), length(m_length.high), left_length(left.length.high),
      right_length(m_right_length.high), apex_x(apex.x.high), apex_y(apex.y.high), cl(entry.corner.x.high),
      sl(entry.corner.y.high), cr(right.corner.x.high), sr(right.corner.y.high)
  {
  }

  // Rotates the image. The image of a window whose rays cross the edge is below the edge; otherwise, up to the error of the
  // image, the rays are along the edge.
  bool turn(const Certified_window& w, const Rotation& rotation, const Double_double_2& image, Certified_window& child) const
  {
    const Double_double_2 turned = rotation(image);
    if (turned.y.high >= -along_edge * (std::abs(turned.x.high) + length)) return false;
    child.set_image(turned);
    child.bits = w.bits_of_child();
    return true;
  }

  // Sum rounded up.
  static double sum_of_radii(double a, double b) { return (a + b) * (1 + 2 * unit_roundoff); }

  // Excess length of paths around an end of the interval for rays outside the parent's interval. Outward rounding displaces
  // the rays by at most 22 u of the distance of the exit from the corner, the error of the image by at most 8 sqrt(2) off,
  // and the image itself is displaced by off. The path via the end of the interval is longer by at most twice the sum.
  static double detour(double exit, double off) { return 48 * unit_roundoff * exit + 32 * off; }

  // Position of b on the halfedge; the end of the halfedge is the vertex itself.
  Double_double place(double b) const { return b < length ? Double_double(b) : m_length; }

  // Distance from b to q, up to its rounding, displaced by `aside` times the length to either side of the exact length.
  double from_target(double b, double aside) const
  {
    return b < length ? (std::max)(0., (length - b) + (m_length.low + aside * length)) : 0.;
  }

  // Exit of the ray from (b, 0) through the edge from the origin in direction (c, s), rounded towards the origin
  // (near_exit) or away from it (far_exit). `to_image`: from b to the image; `off`: the error of the image. near_exit()
  // returns false if the ray certainly does not meet the line of the edge.
  //
  // The exit is at t = b |y| / den, where den is r = |to_image| times the sine of the angle between ray and edge. If the
  // image moves by `off`, the exit moves by at most b s r off / (den den'), with the smallest den' on the way. The bound
  // off / |y| of t would be far too large for an edge much longer than r. A ray whose exit may move by more than a quarter of t,
  // or of its distance b s r / den from b, grazes the edge or the halfedge: way_around_grazed() is charged. If to_image is
  // certainly on one side of b, the ray leaves on the other one: an edge may run back along the halfedge, beyond b.
  bool near_exit(const Certified_window& w, double to_image, double b, double c, double s, double off, double& t,
                 double& grazing) const
  {
    double den, error;
    across(w, to_image, c, s, den, error);
    if (den <= -(error + off)) return false;
    const double least = den - error - off;
    double y = -w.y;
    const double aside = s * (std::abs(to_image) + y) * off;
    if (least > error + 12 * off && 8 * aside <= y * least)
    {
      if (8 * aside > unit_roundoff * (y * least)) y -= 2 * (aside / least);
      t = (std::max)(0., b * y) / (den + error) * (1 - exit_error);
      return true;
    }
    t = (std::max)(0., b * (y - off)) / (den + error + off) * (1 - exit_error);
    if (to_image < -off)
    {
      if (c <= -corner_error) return false;
      t = (std::max)(t, b / (c + corner_error) * (1 - exit_error));
    }
    grazing = (std::max)(grazing, way_around_grazed(w, to_image, off));
    return true;
  }
  void far_exit(const Certified_window& w, double to_image, double b, double c, double s, double off, double& t,
                double& grazing) const
  {
    double den, error;
    across(w, to_image, c, s, den, error);
    const double least = den - error - off;
    double y = -w.y;
    const double aside = s * (std::abs(to_image) + y) * off;
    if (least > error + 12 * off && 8 * aside <= y * least)
    {
      if (8 * aside > unit_roundoff * (y * least)) y += 2 * (aside / least);
      t = (std::min)(t, b * y / (den - error) * (1 + exit_error));
      return;
    }
    if (least > error + off) t = (std::min)(t, b * (y + off) / least * (1 + exit_error));
    if (to_image > off && c > corner_error) t = (std::min)(t, b / (c - corner_error) * (1 + exit_error));
    grazing = (std::max)(grazing, way_around_grazed(w, to_image, off));
  }

  // den: sine of the angle between ray and edge times the length |to_image|; error: its rounding error.
  static void across(const Certified_window& w, double to_image, double c, double s, double& den, double& error)
  {
    const double p = s * to_image, q = c * w.y;
    den = p - q;
    error = exit_error * (std::abs(p) + std::abs(q));
  }

  // Excess length of a path around an end b of the interval to a point of the child's edge beside the ray through b, if this
  // ray grazes the edge or the halfedge. Let the image be displaced, by at most `off`, and y', den', r' belong to it. The point
  // at t is at a distance h = |t den' - b y'| / r' from the ray. If it is not behind b, the path is longer by at most h.
  // - If den <= 2 error + 13 off, den' is at most 2 error + 14 off. For a point beyond the exit, h r' is at most den' times the
  //   edge. Before the exit, the rounded exit is on the edge only if b (y - off) is at most (den + error + off) times the edge. As
  //   edge and b are at most size / 2, h r' is at most (2 error + 9 off) size.
  // - Otherwise den - error - off is at least den / 2, and y (den - error - off) < 8 sqrt(2) s r off. The sum of the sines of
  //   both angles is at least s. If y >= s r / 2, then den < 46 off and, as before, h r' < 47 off size. If den >= s r / 2, then
  //   y < 46 off, and h r' < 48 off size.
  // The point is behind b by rounding at most if |to_image| > off. If not, it is by at most 2 off / r' times size / 2, unless
  // the image is nearer to b than 105 off: but no excess exceeds twice the distance of the point from b, at most `size`. Nor does
  // any exceed twice that of the image. The error is below r exit_error; r is the sum of the coordinates here, at most sqrt(2)
  // times the length, so that 105 > sqrt(2) (48 + 2) covers r' < r, too.
  double way_around_grazed(const Certified_window& w, double to_image, double off) const
  {
    const double size = length + left_length + right_length, r = w.is_parallel() ? 1. : std::abs(to_image) - w.y;
    const double turn = 105 * off * size / r;
    return 6 * exit_error * size + (w.is_parallel() ? turn : (std::min)(turn, 2 * (r + off)));
  }

  const Rotation m_to_left, m_to_right; // into the frames of p -> r and r -> q
  const Double_double m_length, m_right_length;
  const Double_double_2 m_apex;

public:
  const double length, left_length, right_length;
  const double apex_x, apex_y;
  const double cl, sl, cr, sr;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
