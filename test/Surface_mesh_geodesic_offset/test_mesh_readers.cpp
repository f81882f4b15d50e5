// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Readers of the programs: all variants of all formats give the same surface; bad files give one line that names the line
// or element and the expected input; mutated files cause no fault.

#include "fuzz/mutation_run.h"
#include "fuzz/read_input.h"
#include "fuzz/sample_files.h"
#include "test_check.h"
#include "test_registry.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace test_mesh_readers {

using namespace test;

typedef std::vector<std::string> Words;

geodesic_offset::Soup read(const std::string& extension, const std::string& bytes)
{
  const std::string path = "file" + extension;
  const std::vector<char> copy(bytes.begin(), bytes.end()); // sanitizers detect reads beyond its end
  const std::string_view view(copy.data(), copy.size());
  return geodesic_offset::parse_soup(geodesic_offset::mesh_format(path), path, view);
}

// Coordinates of the corners of all polygons.
std::vector<std::vector<std::array<double, 3>>> corners(const geodesic_offset::Soup& soup)
{
  std::vector<std::vector<std::array<double, 3>>> result;
  for (const auto& polygon : soup.polygons)
  {
    result.emplace_back();
    for (std::uint32_t v : polygon) result.back().push_back({soup.points[v].x(), soup.points[v].y(), soup.points[v].z()});
  }
  return result;
}

void good_files()
{
  const Sample_surface surface;
  for (const Sample_file& file : sample_meshes())
  {
    Report::instance().set_context(file.name);
    geodesic_offset::Soup soup;
    try
    {
      soup = read(file.extension, file.bytes);
    }
    catch (const geodesic_offset::Input_error& error)
    {
      CHECK_DETAIL(false, error.what());
      continue;
    }
    CHECK(soup.remarks.empty());
    const bool is_stl = file.extension == ".stl";
    std::vector<std::vector<std::array<double, 3>>> expected;
    for (const auto& polygon : is_stl ? internal::sample_triangles() : surface.polygons)
    {
      expected.emplace_back();
      for (int v : polygon)
      {
        const std::vector<int>& p = surface.points[std::size_t(v)];
        expected.back().push_back({double(p[0]), double(p[1]), double(p[2])});
      }
    }
    CHECK(corners(soup) == expected);
    CHECK(soup.points.size() == 5);
    for (std::size_t i = 0; i < soup.points.size() && !is_stl; ++i)
      for (int c = 0; c < 3; ++c) CHECK(soup.points[i][c] == surface.points[i][std::size_t(c)]);
  }
}

// Expects one line with all the words and the name of the file.
void expect_bad(const std::string& what, const std::string& extension, const std::string& bytes, const Words& words)
{
  Report::instance().set_context(what);
  try
  {
    read(extension, bytes);
    CHECK_DETAIL(false, "was read");
  }
  catch (const geodesic_offset::Input_error& error)
  {
    const std::string text = error.what();
    CHECK_DETAIL(text.find('\n') == std::string::npos && text.find("'file" + extension + "'") != std::string::npos, text);
    for (const std::string& word : words) CHECK_DETAIL(text.find(word) != std::string::npos, word + " is not in: " + text);
    if (!words.empty()) std::cout << what << ": " << text << '\n';
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  CHECK_DETAIL(at != std::string::npos, from);
  return text.replace(at, from.size(), to);
}

void bad_off()
{
  const auto off = [](const std::string& vertices, const std::string& faces) { return "OFF\n3 1 0\n" + vertices + faces; };
  const std::string good = "0 0 0\n1 0 0\n0 1 0\n";
  expect_bad("an unknown variant", ".off", "QOFF\n3 1 0\n" + good + "3 0 1 2\n", {"does not begin with OFF"});
  expect_bad("variants in another order", ".off", "NCOFF\n3 1 0\n" + good + "3 0 1 2\n", {"does not begin with OFF"});
  expect_bad("four dimensions", ".off", "nOFF\n4\n3 1 0\n" + good + "3 0 1 2\n", {"4 coordinates", "three"});
  for (const char* sizes : {"x 1 0", "3 -1 0", "3 1.5 0", "99999999999999999999 1 0"})
    expect_bad(std::string("sizes ") + sizes, ".off", "OFF\n" + std::string(sizes) + "\n" + good + "3 0 1 2\n",
               {"line 2", "numbers of vertices and faces"});
  expect_bad("one size", ".off", "OFF\n3", {"ends", "numbers of vertices and faces"});
  expect_bad("absurd sizes", ".off", "OFF\n4000000000 4000000000 0\n0 0 0\n", {"ends after 1 of 4000000000 vertices"});
  expect_bad("no faces", ".off", "OFF\n3 0 0\n" + good, {"no faces"});
  expect_bad("a word in a COFF", ".off", "COFF\n3 1 0\n0 0 0 255 0 0\n1 red 0 255 0 0\n0 1 0\n3 0 1 2\n",
             {"line 4", "vertex 1", "'red'"});
  expect_bad("a truncated COFF", ".off", "COFF\n3 1 0\n0 0 0 255 0 0\n1 0", {"line 4", "vertex 1", "three coordinates"});
  for (const char* number : {"nan", "inf", "-inf", "1e999", "0x10", "1e", "1,5", "--1", "1.5.5"})
    expect_bad(std::string("the coordinate ") + number, ".off",
               off("0 0 0\n1 0 0\n0 1 " + std::string(number) + "\n", "3 0 1 2\n"),
               {"line 5", "vertex 2", "'" + std::string(number) + "'", "finite number"});
  expect_bad("two coordinates", ".off", off("0 0 0\n1 0\n0 1 0\n", "3 0 1 2\n"), {"line 4", "vertex 1", "three coordinates"});
  for (const char* index : {"3", "-1", "4294967296", "1.0", "x", "99999999999999999999"})
    expect_bad(std::string("the index ") + index, ".off", off(good, "3 0 1 " + std::string(index) + "\n"),
               {"line 6", "face 0", "'" + std::string(index) + "'", "3 vertices"});
  for (const char* size : {"2 0 1", "0", "-3 0 1 2", "x 0 1 2"})
    expect_bad(std::string("a face ") + size, ".off", off(good, std::string(size) + "\n"), {"line 6", "face 0"});
  expect_bad("a face of 4 billion vertices", ".off", off(good, "4000000000 0 1 2\n"), {"line 6", "face 0", "fewer"});
  expect_bad("an index too few", ".off", "OFF\n3 2 0\n" + good + "3 0 1\n3 0 1 2\n", {"line 6", "face 0", "fewer"});
  expect_bad("w = 0", ".off", "4OFF\n3 1 0\n0 0 0 1\n1 0 0 0\n0 1 0 1\n3 0 1 2\n",
             {"line 4", "vertex 1", "fourth coordinate '0'"});

  for (const char* keyword : {"OFF", "STCN4nOFF"})
  {
    const std::string whole = internal::off_binary(keyword);
    for (std::size_t size = 0; size < whole.size(); ++size)
      expect_bad("a binary OFF of " + std::to_string(size) + " bytes", ".off", whole.substr(0, size), {});
    const auto with = [&](std::size_t at, std::int32_t number) {
      return whole.substr(0, at) + internal::number_bytes(number, true) + whole.substr(at + 4);
    };
    const std::size_t header = whole.find('\n') + 1 + (whole[0] == 'S' ? 4 : 0);
    expect_bad("-1 vertices", ".off", with(header, -1), {"vertices", "-1"});
    expect_bad("2147483647 vertices", ".off", with(header, 2147483647), {"of 2147483647 vertices"});
    expect_bad("2147483647 faces", ".off", with(header + 4, 2147483647), {"of 2147483647 faces"});
    const std::size_t faces = whole.size() - (whole[0] == 'S' ? 5 * 20 + 64 : 5 * 8 + 64);
    expect_bad("a face of 2147483647 vertices", ".off", with(faces, 2147483647), {"faces"});
    expect_bad("a face of -3 vertices", ".off", with(faces, -3), {"face 0", "-3"});
    expect_bad("index 5", ".off", with(faces + 4, 5), {"face 0", "'5'", "5 vertices"});
    expect_bad("index -1", ".off", with(faces + 4, -1), {"face 0", "'-1'"});
  }
}

void bad_obj()
{
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const char* index : {"0", "-4", "-0", "x", "1.5", "+1", "4294967297x", "/1", "//", "99999999999999999999", "-"})
    expect_bad(std::string("the index ") + index, ".obj", vertices + "f 1 2 " + index + "\n",
               {"line 4", "face 0", "'" + std::string(index) + "'"});
  for (const char* index : {"4", "4294967297"})
    expect_bad(std::string("the index ") + index, ".obj", "f 1 2 " + std::string(index) + "/7\n" + vertices + "f 1 2 3\n",
               {"line 1", "face 0", "'" + std::string(index) + "'", "3 vertices"});
  expect_bad("an index of vertices that follow", ".obj", "v 0 0 0\nf -1 -2 -3\nv 1 0 0\nv 0 1 0\n",
             {"line 2", "'-2'", "1 vertex"});
  expect_bad("two vertices", ".obj", vertices + "f 1 2 3\nf 1 2\n", {"line 5", "face 1", "2 vertices"});
  expect_bad("two coordinates", ".obj", "v 0 0\n", {"line 1", "vertex 0", "three coordinates"});
  expect_bad("a continued line that ends", ".obj", "v 0 0 \\\n", {"line 2", "vertex 0", "three coordinates"});
  expect_bad("no faces", ".obj", vertices, {"no faces"});
  expect_bad("no vertices", ".obj", "# nothing\n", {"no vertices"});
}

void bad_ply()
{
  const auto ply = [](const std::string& x, const std::string& list, const std::string& rows) {
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty " + x +
           "\nproperty float y\nproperty float z\n"
           "element face 1\nproperty " +
           list + "\nend_header\n" + rows;
  };
  const std::string x = "float x", list = "list uchar int vertex_indices", rows = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  CHECK(read(".ply", ply(x, list, rows)).polygons.size() == 1);
  expect_bad("a list as coordinate", ".ply", ply("list uchar float x", list, rows), {"'x'", "'list uchar float'", "number"});
  expect_bad("an unknown type", ".ply", ply("half x", list, rows), {"line 4", "'x'", "unknown type 'half'"});
  expect_bad("a count of type float", ".ply", ply(x, "list float int vertex_indices", rows), {"line 8", "unknown type"});
  expect_bad("indices of type float", ".ply", ply(x, "list uchar float vertex_indices", rows), {"whole numbers"});
  expect_bad("an index that is no list", ".ply", ply(x, "int vertex_indices", rows), {"list of whole numbers"});
  expect_bad("no z", ".ply", replaced(ply(x, list, rows), "float z", "float w"), {"no property z"});
  expect_bad("no indices", ".ply", ply(x, "list uchar int corners", rows), {"no property vertex_indices"});
  expect_bad("two elements of vertices", ".ply", replaced(ply(x, list, rows), "element face 1", "element vertex 1"),
             {"line 7", "'vertex' twice"});
  expect_bad("no number of elements", ".ply", replaced(ply(x, list, rows), "vertex 3", "vertex many"), {"line 3", "number"});
  expect_bad("no format", ".ply", replaced(ply(x, list, rows), "format ascii 1.0\n", ""), {"no format"});
  expect_bad("another version", ".ply", replaced(ply(x, list, rows), "1.0", "2.0"), {"line 2", "'2.0'"});
  expect_bad("an unknown word", ".ply", replaced(ply(x, list, rows), "format", "formal"), {"line 2", "'formal'"});
  expect_bad("a property of nothing", ".ply", "ply\nformat ascii 1.0\nproperty float x\n", {"line 3", "misplaced"});
  expect_bad("a coordinate too few", ".ply", ply(x, list, "0 0 0\n1 0\n0 1 0\n3 0 1 2\n"), {"line 11", "vertex 1", "'z'"});
  expect_bad("a coordinate too many", ".ply", ply(x, list, "0 0 0\n1 0 0 0\n0 1 0\n3 0 1 2\n"),
             {"line 11", "vertex 1", "more"});
  expect_bad("a word", ".ply", ply(x, list, "0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n"), {"line 11", "vertex 1", "'zero'"});
  for (const char* face : {"3 0 1 3", "3 0 1 -1", "3 0 1 1.5"})
    expect_bad(std::string("the face ") + face, ".ply", ply(x, list, "0 0 0\n1 0 0\n0 1 0\n" + std::string(face) + "\n"),
               {"line 13", "face 0", "3 vertices"});
  for (const char* face : {"3 0 1", "4000000000 0 1 2", "-1", "x 0 1 2"})
    expect_bad(std::string("the face ") + face, ".ply", ply(x, list, "0 0 0\n1 0 0\n0 1 0\n" + std::string(face) + "\n"),
               {"line 13", "face 0", "vertex_indices"});
  expect_bad("a face of two vertices", ".ply", ply(x, list, "0 0 0\n1 0 0\n0 1 0\n2 0 1\n"), {"face 0", "2 vertices"});

  for (int format : {0, 1, 2})
  {
    const std::string whole = internal::ply_file({format, "float", "int", "int", true});
    // the last element is redundant, but announced
    for (std::size_t size = 0; size + 4 < whole.size(); ++size)
      expect_bad("a PLY of " + std::to_string(size) + " bytes", ".ply", whole.substr(0, size), {});
    expect_bad("absurd number of vertices", ".ply", replaced(whole, "element vertex 5", "element vertex 99999999999"), {});
    expect_bad("absurd number of other elements", ".ply", replaced(whole, "camera 1\n", "camera 18446744073709551615\n"), {});
  }
  // -1 and 2147483647 as number of vertices of a face
  const std::string whole = internal::ply_file({2, "float", "int", "int"});
  const std::size_t faces = whole.find("end_header\n") + 11 + 5 * 12;
  for (std::int32_t size : {-1, 2147483647})
    expect_bad("a face of " + std::to_string(size) + " vertices", ".ply",
               whole.substr(0, faces) + internal::number_bytes(size, true) + whole.substr(faces + 4), {"face"});
  for (std::int32_t index : {-1, 5})
    expect_bad("the index " + std::to_string(index), ".ply",
               whole.substr(0, faces + 4) + internal::number_bytes(index, true) + whole.substr(faces + 8),
               {"face 0", "'" + std::to_string(index) + "'", "5 vertices"});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  expect_bad("NaN", ".ply", whole.substr(0, faces - 4) + internal::number_bytes(nan, true) + whole.substr(faces),
             {"vertex 4", "nan"});
}

void bad_stl()
{
  const std::string text = internal::stl_text(), binary = internal::stl_binary("a pyramid");
  expect_bad("a word as coordinate", ".stl", replaced(text, "vertex 4.0e+00", "vertex four"), {"line 6", "facet 0", "'four'"});
  expect_bad("two coordinates", ".stl", replaced(text, "vertex 0.0e+00 0.0e+00 0.0e+00", "vertex 0 0"),
             {"line 4", "facet 0", "three coordinates"});
  expect_bad("four vertices", ".stl", replaced(text, "endloop", "vertex 0 0 0\nendloop"), {"line 7", "facet 0", "'endloop'"});
  expect_bad("two vertices", ".stl", replaced(text, "vertex 4.0e+00 5.0e+00 0.0e+00\n", ""), {"facet 0", "'vertex'"});
  expect_bad("no facets", ".stl", "solid\nendsolid\n", {"no facets"});
  expect_bad("no endsolid", ".stl", text.substr(0, text.find("endsolid")), {"without endsolid", "6 facets"});
  expect_bad("something else", ".stl", replaced(text, "facet", "faced"), {"line 2", "'facet' or 'endsolid'", "'faced'"});
  for (std::size_t size = 0; size < binary.size(); ++size)
    expect_bad("a binary STL of " + std::to_string(size) + " bytes", ".stl", binary.substr(0, size), {});
  expect_bad("4294967295 facets", ".stl", binary.substr(0, 80) + "\xff\xff\xff\xff" + binary.substr(84),
             {"6 of 4294967295 facets"});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  expect_bad("NaN", ".stl", binary.substr(0, 96) + internal::number_bytes(nan, false) + binary.substr(100),
             {"facet 0", "finite"});
}

// Bytes after the announced elements cause a remark.
void remarks()
{
  for (const Sample_file& file : sample_meshes())
    if (file.name == "OFF BINARY" || file.name == "binary STL" || file.name.find("PLY, faces first") != std::string::npos)
    {
      Report::instance().set_context(file.name + " and more");
      const geodesic_offset::Soup soup = read(file.extension, file.bytes + "0 0 0\n");
      CHECK(soup.remarks.size() == 1 && soup.remarks[0].find(" bytes behind the last ") != std::string::npos);
      CHECK(soup.points.size() == 5);
    }
}

void others()
{
  for (const Sample_file& file : other_samples())
  {
    Report::instance().set_context(file.name);
    CHECK(read_input("file" + file.extension, file.bytes));
  }
  // found by mutated_files: a message with all names of a long header
  Report::instance().set_context("a table with 1000 properties and no distances");
  std::string text = "ply\nformat ascii 1.0\nelement vertex 5\n";
  for (int i = 0; i < 1000; ++i) text += "property float p" + std::to_string(i) + "\n";
  CHECK(!read_input("file.table.ply", text + "end_header\n"));
}

void mutated_files()
{
  Report::instance().set_context("mutated files");
  const auto result = run_mutations(30000, 1);
  CHECK(result.second == 0);
  CHECK(result.first.size() == 7);
  for (const auto& entry : result.first) // the mutations reach all parts of the readers
    CHECK_DETAIL(entry.second.accepted > 100 && entry.second.rejected > 1000, entry.first);
}

} // namespace test_mesh_readers

GEODESIC_OFFSET_TEST(test_mesh_readers)
{
  good_files();
  bad_off();
  bad_obj();
  bad_ply();
  bad_stl();
  remarks();
  others();
  mutated_files();
  return Report::instance().finish("test_mesh_readers");
}
