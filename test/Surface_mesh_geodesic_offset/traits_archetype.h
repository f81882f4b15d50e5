// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Model of SurfaceMeshGeodesicOffsetTraits with exactly the requirements of the concept: code that compiles with it has no
// other requirements.

#ifndef GEODESIC_OFFSET_TEST_TRAITS_ARCHETYPE_H
#define GEODESIC_OFFSET_TEST_TRAITS_ARCHETYPE_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/enum.h>

#include <cmath>

namespace test {

/// Functors with a state that counts calls, to test that the object's own functors are used.
template <class TriangleMesh>
class Traits_archetype
{
public:
  typedef CGAL::Simple_cartesian<double> Kernel;
  typedef TriangleMesh Triangle_mesh;
  typedef double FT;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;

  struct Calls
  {
    std::size_t apices = 0, frames = 0, entries = 0, exits = 0, distances = 0, comparisons = 0;
  };

  explicit Traits_archetype(Calls& calls) : calls_(&calls) {}

  class Construct_apices_2
  {
  public:
    void operator()(const Point_3& p, const Point_3& q, const Point_3& r, double (&length)[3], double (&x)[3],
                    double (&y)[3]) const
    {
      ++calls_->apices;
      const Point_3 points[] = {p, q, r, p, q};
      for (int k = 0; k < 3; ++k)
      {
        const Vector_3 u = points[k + 1] - points[k], v = points[k + 2] - points[k];
        length[k] = std::sqrt(u.squared_length());
        if (!(length[k] > 0)) return;
        x[k] = u * v / length[k];
        y[k] = std::sqrt(CGAL::cross_product(u, v).squared_length()) / length[k];
      }
    }

  private:
    friend class Traits_archetype;
    explicit Construct_apices_2(Calls* calls) : calls_(calls) {}
    Calls* calls_;
  };

  class Change_frame_2
  {
  public:
    void operator()(double& x, double& y, double& sigma, bool is_parallel, double ox, double oy, double c, double s) const
    {
      ++calls_->frames;
      if (is_parallel) sigma -= x * ox + y * oy;
      const double u = is_parallel ? x : x - ox, v = is_parallel ? y : y - oy;
      x = c * u + s * v;
      y = c * v - s * u;
    }

  private:
    friend class Traits_archetype;
    explicit Change_frame_2(Calls* calls) : calls_(calls) {}
    Calls* calls_;
  };

  class Compare_entry_with_apex_2
  {
  public:
    CGAL::Sign operator()(double x, double y, bool is_parallel, double b, double ax, double ay) const
    {
      ++calls_->entries;
      const double value = b * (is_parallel ? -y : ay - y) - (x * ay - y * ax);
      return value > 0 ? CGAL::POSITIVE : value < 0 ? CGAL::NEGATIVE : CGAL::ZERO;
    }

  private:
    friend class Traits_archetype;
    explicit Compare_entry_with_apex_2(Calls* calls) : calls_(calls) {}
    Calls* calls_;
  };

  class Construct_exit_2
  {
  public:
    bool operator()(double x, double y, double sigma, bool is_parallel, double b, double d, double c, double s, double length,
                    double& t, double& distance, bool& is_rough) const
    {
      ++calls_->exits;
      const double den = s * (is_parallel ? x : x - b) - c * y;
      if (!(den > 0)) return false;
      t = std::fmin(-b * y / den, length);
      distance = d + (is_parallel ? 1 : d - sigma) * (s * b / den);
      is_rough = true;
      return true;
    }

  private:
    friend class Traits_archetype;
    explicit Construct_exit_2(Calls* calls) : calls_(calls) {}
    Calls* calls_;
  };

  class Compute_distance_2
  {
  public:
    double operator()(double x, double y, double sigma, bool is_parallel, double px, double py) const
    {
      ++calls_->distances;
      return is_parallel ? sigma - (x * px + y * py) : sigma + std::hypot(px - x, py - y);
    }

  private:
    friend class Traits_archetype;
    explicit Compute_distance_2(Calls* calls) : calls_(calls) {}
    Calls* calls_;
  };

  class Compare_distance_2
  {
  public:
    CGAL::Comparison_result operator()(double d, double e, double scale) const
    {
      ++calls_->comparisons;
      return d > e + 1e-15 * scale ? CGAL::LARGER : d < e - 1e-15 * scale ? CGAL::SMALLER : CGAL::EQUAL;
    }

  private:
    friend class Traits_archetype;
    explicit Compare_distance_2(Calls* calls) : calls_(calls) {}
    Calls* calls_;
  };

  Construct_apices_2 construct_apices_2_object() const { return Construct_apices_2(calls_); }
  Change_frame_2 change_frame_2_object() const { return Change_frame_2(calls_); }
  Compare_entry_with_apex_2 compare_entry_with_apex_2_object() const { return Compare_entry_with_apex_2(calls_); }
  Construct_exit_2 construct_exit_2_object() const { return Construct_exit_2(calls_); }
  Compute_distance_2 compute_distance_2_object() const { return Compute_distance_2(calls_); }
  Compare_distance_2 compare_distance_2_object() const { return Compare_distance_2(calls_); }

private:
  Calls* calls_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_TRAITS_ARCHETYPE_H
