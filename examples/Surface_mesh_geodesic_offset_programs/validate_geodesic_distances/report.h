// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Report for the user, and table of all vertices.

#ifndef VALIDATE_GEODESIC_DISTANCES_REPORT_H
#define VALIDATE_GEODESIC_DISTANCES_REPORT_H

#include "common/common.h"
#include "common/numbers.h"
#include "comparison.h"

#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace geodesic_offset {

class Report_writer
{
  std::ostream& m_out;
  const Comparison& m_comparison;

public:
  Report_writer(std::ostream& out, const Comparison& comparison) : m_out(out), m_comparison(comparison) {}

  void operator()(const std::vector<Comparison::Bounds>& bounds, const std::vector<double>& distances, double tolerance) const
  {
    const Comparison& c = m_comparison;
    count("vertices", c.errors.size(), "in the mesh and in the table");
    count("inside", c.inside, "between their certified bounds, or infinite for unreachable vertices");
    count("too short", c.too_short, "below the lower bound: no path on the surface is as short");
    count("too long", c.too_long, "above the upper bound: there is a shorter path on the surface");
    count("infinite in the table only", c.infinite_in_table_only, "there is a path to a source");
    count("finite in the table only", c.infinite_in_truth_only, "there is no path to any source");
    count("beyond the tolerance", c.beyond_tolerance,
          tolerance == 0 ? "all that are not inside" : "outside by more than " + short_number(tolerance) + " of the bound");

    count("compared", c.reached, "finite in both: the following figures are for these vertices");
    count("compared relatively", c.away, "of these, not at distance 0: the relative figures are for these");
    errors("outside, absolute", c.outside, "distance from the certified bounds, 0 inside");
    errors("outside, relative", c.relative_outside, "the same, divided by the bound");
    errors("off the middle, absolute", c.off_middle, "difference from the middle of the bounds");
    errors("off the middle, relative", c.relative_off_middle, "the same, divided by the middle");
    number("bias, absolute", c.bias, "mean of distance minus middle: negative if too short on average");
    number("bias, relative", c.relative_bias, "the same, divided by the middle");
    widths("width, absolute", c.width, "difference of the bounds: smaller errors cannot be detected");
    widths("width, relative", c.relative_width, "the same, divided by the middle");

    if(c.inside == c.errors.size())
      line("worst vertex", "none", "all are inside");
    else
    {
      const std::size_t v = c.worst;
      line("worst vertex",
           std::to_string(v) + ": distance " + full_number(distances[v]) + ", bounds " + full_number(bounds[v].first) +
             " and " + full_number(bounds[v].second) + ", outside by " + short_number(c.errors[v]),
           "farthest outside; negative if too short");
    }
  }

private:
  void line(const std::string& label, const std::string& value, const std::string& meaning) const
  {
    m_out << label << ": " << value << " (" << meaning << ")\n";
  }

  void count(const std::string& label, std::size_t n, const std::string& meaning) const
  {
    line(label, std::to_string(n), meaning);
  }

  void number(const std::string& label, double value, const std::string& meaning) const
  {
    line(label, short_number(value), meaning);
  }

  void errors(const std::string& label, const Error_figures& f, const std::string& meaning) const
  {
    const std::string at = f.largest == 0 ? "" : " at vertex " + std::to_string(f.at);
    line(label, "largest " + short_number(f.largest) + at + ", mean " + short_number(f.mean) + ", rms " + short_number(f.rms),
         meaning);
  }

  void widths(const std::string& label, const Width_figures& f, const std::string& meaning) const
  {
    line(label, "median " + short_number(f.median) + ", largest " + short_number(f.largest), meaning);
  }
};

// One line per vertex.
inline void write_per_vertex(std::ostream& out, const std::vector<Comparison::Bounds>& bounds,
                             const std::vector<double>& distances, const std::vector<double>& errors)
{
  out << "# vertex lower upper distance error\n";
  out.precision(std::numeric_limits<double>::max_digits10);
  for(std::size_t i = 0; i < distances.size(); ++i)
    out << i << ' ' << bounds[i].first << ' ' << bounds[i].second << ' ' << distances[i] << ' ' << errors[i] << '\n';
}

} // namespace geodesic_offset

#endif // VALIDATE_GEODESIC_DISTANCES_REPORT_H
