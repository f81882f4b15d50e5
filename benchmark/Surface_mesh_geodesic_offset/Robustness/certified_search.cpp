// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Search for certified bounds that exclude the distance, on small meshes, by an independent reference with 113 bits; also
// the widths of the bounds.
//
//   certified_search [--seed N] [--meshes N] [--general | --segments] [--kind NAME] [--printed N] [--write PREFIX] [OFF_FILE
//   VERTEX]...
//
// Case i has seed N + i, which determines its mesh, sources and queries; so `--seed N --meshes 1` repeats a case. The
// meshes are adversarial, or general ones with --general; with --segments, the sources of adversarial meshes are segments with
// start values; --kind selects one kind. --write PREFIX writes the last case as
// PREFIX.off. Files are meshes with a source vertex each; without --meshes only they are run.
//
// Output: violations, then a table by kind: meshes, those with a face without area in doubles, builds rejected as
// documented, compared bounds, violations, meshes with violations, and the widths of the bounds relative to the distance.
// The exit code is 1 if there is a violation.

#include "certified_search.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

test::Certified_case read_off(const std::string& file, std::size_t source)
{
  std::ifstream in(file);
  std::string head;
  std::size_t points = 0, triangles = 0, edges = 0, corners = 0;
  if (!(in >> head >> points >> triangles >> edges) || head != "OFF") throw std::invalid_argument(file + ": not an OFF file");
  test::Certified_case c;
  c.kind = "files";
  c.points.resize(points);
  c.triangles.resize(triangles);
  for (auto& p : c.points) in >> p[0] >> p[1] >> p[2];
  for (auto& t : c.triangles)
  {
    in >> corners >> t[0] >> t[1] >> t[2];
    if (!in || corners != 3) throw std::invalid_argument(file + ": a face that is no triangle, or the file ends early");
    for (std::size_t v : t)
      if (v >= points) throw std::invalid_argument(file + ": a vertex that is not there");
  }
  if (!in || source >= points) throw std::invalid_argument(file + ": no such source vertex, or the file ends early");
  c.source_vertices.push_back(source);
  return c;
}

void write_off(const std::string& file, const test::Certified_case& c)
{
  std::ofstream out(file);
  out.precision(17);
  out << "OFF\n" << c.points.size() << ' ' << c.triangles.size() << " 0\n";
  for (const auto& p : c.points) out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const auto& t : c.triangles) out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  if (!out) throw std::invalid_argument(file + ": cannot be written");
}

unsigned long number(const std::string& text)
{
  std::size_t end = 0;
  unsigned long n = 0;
  try
  {
    n = std::stoul(text, &end);
  }
  catch (const std::exception&)
  {
  }
  if (end == 0 || end != text.size() || text[0] == '-') throw std::invalid_argument("not a number: " + text);
  return n;
}

int run(int argc, char** argv)
{
  unsigned seed = 1;
  std::size_t meshes = 1000, printed = 20;
  bool is_general = false, has_segments = false, has_meshes = false;
  std::string kind, write;
  std::vector<test::Certified_case> files;
  std::vector<std::string> names;
  for (int i = 1; i < argc; ++i)
  {
    const std::string name = argv[i];
    if (name == "--general")
    {
      is_general = true;
      continue;
    }
    if (name == "--segments")
    {
      has_segments = true;
      continue;
    }
    if (i + 1 == argc) throw std::invalid_argument(name + " needs a value, or is unknown");
    const std::string text = argv[++i];
    if (name == "--seed") seed = static_cast<unsigned>(number(text));
    else if (name == "--meshes")
    {
      meshes = number(text);
      has_meshes = true;
    }
    else if (name == "--printed") printed = number(text);
    else if (name == "--kind") kind = text;
    else if (name == "--write") write = text;
    else if (name.compare(0, 2, "--") == 0) throw std::invalid_argument("unknown option " + name);
    else
    {
      files.push_back(read_off(name, number(text)));
      names.push_back(name);
    }
  }
  test::Certified_search search(std::cout, printed);
  for (std::size_t i = 0; i < files.size(); ++i) search.run(files[i], names[i]);
  if (files.empty() || has_meshes)
    for (std::size_t i = 0; i < meshes; ++i)
    {
      const unsigned s = seed + static_cast<unsigned>(i);
      const test::Certified_case c =
        is_general ? test::Certified_cases::general(s) : test::Certified_cases::adversarial(s, has_segments);
      if (!kind.empty() && c.kind != kind) continue;
      if (!write.empty()) write_off(write + ".off", c);
      search.run(c, c.kind + ", seed " + std::to_string(s));
    }
  search.print_table(stdout);
  return search.total().violations == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    return run(argc, argv);
  }
  catch (const std::exception& e)
  {
    std::cerr << "certified_search: " << e.what() << '\n';
    return 2;
  }
}
