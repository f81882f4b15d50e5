// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Comparison of distances with certified bounds: deviations and their statistics.

#ifndef VALIDATE_GEODESIC_DISTANCES_COMPARISON_H
#define VALIDATE_GEODESIC_DISTANCES_COMPARISON_H

#include "common/common.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace geodesic_offset {

// Statistics of absolute values of errors.
struct Error_figures
{
  std::size_t number = 0;
  double largest = 0, mean = 0, rms = 0;
  std::size_t at = 0; // first vertex with the largest error

  Error_figures() = default;
  Error_figures(const std::vector<double>& errors, const std::vector<std::size_t>& vertices) : number(errors.size())
  {
    for(std::size_t i = 0; i < number; ++i)
      if(std::abs(errors[i]) > largest || i == 0)
      {
        largest = std::abs(errors[i]);
        at = vertices[i];
      }
    if(largest == 0 || largest == infinity)
    {
      mean = rms = largest;
      return;
    }
    // in units of the largest one: squares cannot overflow
    for(double error : errors)
    {
      const double part = std::abs(error) / largest;
      mean += part;
      rms += part * part;
    }
    mean = largest * (mean / static_cast<double>(number));
    rms = largest * std::sqrt(rms / static_cast<double>(number));
  }
};

inline double mean_of(const std::vector<double>& values)
{
  double mean = 0;
  for(std::size_t i = 0; i < values.size(); ++i) mean += values[i] / static_cast<double>(values.size());
  return mean;
}

struct Width_figures
{
  double median = 0, largest = 0;

  Width_figures() = default;
  explicit Width_figures(std::vector<double> widths)
  {
    if(widths.empty()) return;
    const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
    std::nth_element(widths.begin(), middle, widths.end());
    median = *middle;
    largest = *std::max_element(widths.begin(), widths.end());
  }
};

struct Comparison
{
  using Bounds = std::pair<double, double>;

  // By vertex: 0 within bounds, negative if too short, infinite if only one of both is.
  std::vector<double> errors;

  std::size_t inside = 0, too_short = 0, too_long = 0;
  std::size_t infinite_in_table_only = 0, infinite_in_truth_only = 0;
  std::size_t beyond_tolerance = 0;
  std::size_t reached = 0; // both are finite: the following figures are for these, relative ones for `away`
  std::size_t away = 0; // those of them that are not at distance 0

  Error_figures outside, relative_outside; // distances from the bounds
  Error_figures off_middle, relative_off_middle;
  double bias = 0, relative_bias = 0;
  Width_figures width, relative_width;
  std::size_t worst = 0; // a vertex

  Comparison(const std::vector<Bounds>& bounds, const std::vector<double>& distances, double tolerance)
  {
    std::vector<double> outside_errors, middle_errors, widths, relative_outside_errors, relative_middle_errors, relative_widths;
    std::vector<std::size_t> reached_vertices, away_vertices;
    errors.reserve(distances.size());
    for(std::size_t i = 0; i < distances.size(); ++i)
    {
      const double lower = bounds[i].first, upper = bounds[i].second, d = distances[i];
      const double error = d < lower ? d - lower : d > upper ? d - upper : 0;
      errors.push_back(error);
      if(std::abs(error) > std::abs(errors[worst])) worst = i;
      if(d == infinity || upper == infinity)
      {
        (error == 0 ? inside : d == infinity ? infinite_in_table_only : infinite_in_truth_only) += 1;
        beyond_tolerance += error != 0 ? 1 : 0;
        continue;
      }
      (error == 0 ? inside : error < 0 ? too_short : too_long) += 1;
      if(error != 0 && (d < lower * (1 - tolerance) || d > upper * (1 + tolerance))) ++beyond_tolerance;

      const double middle = lower + (upper - lower) / 2;
      reached_vertices.push_back(i);
      outside_errors.push_back(error);
      middle_errors.push_back(d - middle);
      widths.push_back(upper - lower);
      if(middle == 0) continue;
      away_vertices.push_back(i);
      relative_outside_errors.push_back(error == 0 ? 0 : error / (error < 0 ? lower : upper));
      relative_middle_errors.push_back((d - middle) / middle);
      relative_widths.push_back((upper - lower) / middle);
    }
    reached = reached_vertices.size();
    away = away_vertices.size();
    outside = Error_figures(outside_errors, reached_vertices);
    relative_outside = Error_figures(relative_outside_errors, away_vertices);
    off_middle = Error_figures(middle_errors, reached_vertices);
    relative_off_middle = Error_figures(relative_middle_errors, away_vertices);
    bias = mean_of(middle_errors);
    relative_bias = mean_of(relative_middle_errors);
    width = Width_figures(std::move(widths));
    relative_width = Width_figures(std::move(relative_widths));
  }
};

} // namespace geodesic_offset

#endif // VALIDATE_GEODESIC_DISTANCES_COMPARISON_H
