// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// An oracle for offsets from any program: the smallest tolerance for which it is proven that curves are the offset at a
// distance. --help lists the options. Exit codes: 0 there is a tolerance, and it is accepted; 3 there is none, or it is too
// large; 1 something that the command line names is wrong (one line on stderr says what); 2 the command line itself is wrong.

#include "common/common.h"
#include "common/mesh_input.h"
#include "common/program_main.h"
#include "common/sources.h"
#include "common/version.h"
#include "curves_on_surface.h"
#include "options.h"
#include "report.h"

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>

#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>

namespace geodesic_offset {
namespace {

using Enclosure = CGAL::Surface_mesh_geodesic_enclosure<Traits>;

constexpr int certified = 0, not_certified = 3;
constexpr double surface_tolerance = 1e-5; // part of the diagonal: what files with six digits need

Enclosure enclosure_on(const Mesh_input& input, const std::string& path)
{
  try
  {
    return Enclosure(input.mesh());
  }
  catch(const std::invalid_argument& error)
  {
    throw Input_error(quoted(path) + ": " + error.what());
  }
}

Certificate certificate_of(Enclosure& enclosure, const Offset_validation_options& options, const Curves_on_surface& curves)
{
  try
  {
    enclosure.build(CGAL::parameters::keep_windows(true));
    return enclosure.certify_offset(options.distance, curves.curves());
  }
  catch(const std::bad_alloc&)
  {
    throw;
  }
  catch(const std::exception& error) // from faces that are too thin, for example
  {
    throw Input_error(quoted(options.mesh) + ": " + error.what());
  }
}

void write_input(const Offset_validation_options& options, const Mesh_input& input, const Sources& sources,
                 const Curves_on_surface& curves, std::size_t number_of_sources)
{
  std::cout << "mesh: " << quoted(options.mesh) << ", " << counted(input.mesh().number_of_faces(), "face") << '\n';
  for(const std::string& remark : input.remarks()) std::cout << "mesh: " << remark << '\n';
  for(const std::string& remark : sources.remarks()) std::cout << "sources: " << remark << '\n';
  for(const std::string& warning : sources.warnings()) print_warning("validate_geodesic_offsets", warning);
  if(const std::string moved = sources.moved_points().remark(); !moved.empty()) std::cout << "sources: " << moved << '\n';
  std::cout << "sources: " << counted(number_of_sources, "source") << '\n'
            << "curves: " << counted(curves.curves().size(), "curve") << ", " << counted(curves.number_of_points(), "point")
            << ", moved by " << short_number(curves.moved()) << " at most to the surface\n"
            << "distance: " << short_number(options.distance) << '\n';
}

int validate(const Offset_validation_options& options)
{
  const Mesh_input input(options.mesh, options.borders);
  if(!input.warning().empty()) print_warning("validate_geodesic_offsets", input.warning());
  Enclosure enclosure = enclosure_on(input, options.mesh);
  const Curves_on_surface curves(enclosure.mesh(), options.curves); // before the long work
  const Sources sources(input, options, enclosure.mesh());
  sources.add_to(enclosure);
  const double diagonal = input.bounding_box_diagonal();
  if(const std::string far = sources.moved_points().warning(diagonal); !far.empty())
    print_warning("validate_geodesic_offsets", far);

  const double most = options.surface_tolerance.value_or(surface_tolerance * diagonal);
  if(curves.moved() > most)
  {
    write_input(options, input, sources, curves, enclosure.number_of_sources());
    std::cout << "surface: no (" << curves.farthest_point() << " is " << short_number(curves.moved())
              << " away from the surface; at most " << short_number(most) << " is accepted)\n";
    return not_certified;
  }
  const Certificate certificate = certificate_of(enclosure, options, curves);
  write_input(options, input, sources, curves, enclosure.number_of_sources()); // after all that may fail
  Certificate_writer(std::cout, input.mesh(), curves)(certificate, diagonal);
  const bool is_accepted =
    options.tolerance ? certificate.tolerance <= *options.tolerance : std::isfinite(certificate.tolerance);
  return certificate.bounds_region && is_accepted ? certified : not_certified;
}

} // namespace
} // namespace geodesic_offset

int main(int argc, char* argv[])
{
  using namespace geodesic_offset;
  return program_main("validate_geodesic_offsets", [&] {
    const Offset_validation_options options = parse_offset_validation_options(argc, argv);
    if(options.help)
    {
      print_offset_validation_help(std::cout);
      return 0;
    }
    if(options.version)
    {
      print_version(std::cout, "validate_geodesic_offsets");
      return 0;
    }
    return validate(options);
  });
}
