// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances of the offsets on this mesh, with limits on their number and size.

#ifndef GEODESIC_OFFSET_LEVELS_H
#define GEODESIC_OFFSET_LEVELS_H

#include "common/common.h"
#include "common/numbers.h"
#include "level_options.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace geodesic_offset {

// Minimum of lengths relative to the bounding-box diagonal: 13 of the 53 bits of a coordinate remain for the shape of a
// curve of this size.
constexpr double smallest_part_of_diagonal = 1.0 / (std::size_t(1) << 40);

// Throws Usage_error.
inline void check_length(const char* option, const std::optional<double>& length, double diagonal)
{
  const double smallest = smallest_part_of_diagonal * diagonal;
  if(length && *length < smallest)
    throw Usage_error("--" + std::string(option) + ' ' + short_number(*length) + " is less than " + short_number(smallest) +
                      ", the rounding of coordinates of this mesh");
}

class Levels
{
  // A typing error must not start hours of work or fill the disk. Without a count the limit is far above the number of
  // curves that people look at; with a count it is where the list of levels alone needs noticeable memory and time.
  static constexpr std::size_t most_without_count = 10000;
  static constexpr std::size_t most = 1000000;

  std::vector<double> m_distances;
  std::vector<double> m_named;
  bool m_is_open_ended;

public:
  // bound_of_reach(): upper bound of the largest distance of the surface. exact_reach(): the largest distance; slow, called
  // only if the bound gives too many levels. Throws Usage_error.
  template <class Bound, class Exact>
  Levels(const Level_options& options, double diagonal, const Bound& bound_of_reach, const Exact& exact_reach)
    : m_distances(options.distances), m_is_open_ended(options.is_open_ended())
  {
    for(double distance : options.distances) check_length("distance", distance, diagonal);
    check_length("spacing", options.spacing, diagonal);
    check_length("start", options.start, diagonal);
    if(options.spacing) add_spaced(options, bound_of_reach, exact_reach);
    m_named = m_is_open_ended ? options.distances : m_distances;
    if(m_is_open_ended) m_named.push_back(options.start.value_or(*options.spacing));
    for(std::vector<double>* levels : {&m_distances, &m_named})
    {
      std::sort(levels->begin(), levels->end());
      levels->erase(std::unique(levels->begin(), levels->end()), levels->end());
    }
  }

  bool empty() const { return m_distances.empty(); }
  std::size_t size() const { return m_distances.size(); }
  double largest() const { return m_distances.back(); }

  // In increasing order.
  const std::vector<double>& distances() const { return m_distances; }

  // Levels given one by one or by a count, in increasing order. For a spacing without a count, the first level.
  const std::vector<double>& named() const { return m_named; }

  // Whether the number of levels follows from the bound of the distances. Then the last levels may exceed the largest
  // distance.
  bool is_open_ended() const { return m_is_open_ended; }

private:
  template <class Bound, class Exact>
  void add_spaced(const Level_options& options, const Bound& bound_of_reach, const Exact& exact_reach)
  {
    const double spacing = *options.spacing;
    // number of levels up to a distance; at least one, so that a report is possible
    const auto number_up_to = [&](double reach) {
      const double farthest = std::min(reach, options.maximum_distance.value_or(infinity));
      return std::max(1.0, std::floor((farthest - options.start.value_or(spacing)) / spacing) + 1);
    };
    double number = 0;
    if(options.count)
    {
      number = static_cast<double>(*options.count);
      if(number > static_cast<double>(most))
        throw Usage_error("--count " + std::to_string(*options.count) + ": there can be no more than " + std::to_string(most) +
                          " offsets");
    }
    else
    {
      number = number_up_to(bound_of_reach());
      if(number > static_cast<double>(most_without_count)) number = number_up_to(exact_reach());
      if(number > static_cast<double>(most_without_count))
        throw Usage_error("--spacing " + short_number(spacing) + " would give " + short_number(number) +
                          " offsets of this mesh; more than " + std::to_string(most_without_count) + " need --count");
    }
    const double last = options.start ? *options.start + (number - 1) * spacing : number * spacing;
    if(options.count && !std::isfinite(last))
      throw Usage_error("--spacing " + short_number(spacing) + " with --count " + std::to_string(*options.count) +
                        " gives distances beyond the range of numbers");
    m_distances.reserve(m_distances.size() + static_cast<std::size_t>(number));
    for(std::size_t i = 0; i < static_cast<std::size_t>(number); ++i)
      m_distances.push_back(options.start ? *options.start + static_cast<double>(i) * spacing
                                          : static_cast<double>(i + 1) * spacing);
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_LEVELS_H
