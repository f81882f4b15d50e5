// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Files of the program: no file name causes a loss of data, signals and full disks leave no partial files, and all programs
// treat vertices shared by several fans of faces alike.
//
//   test_program_files GEODESIC_OFFSET VALIDATE_GEODESIC_DISTANCES

#include "common/output_file.h"
#include "fuzz/mutation_run.h"
#include "generated_meshes.h"
#include "program_runner.h"
#include "test_check.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace test_program_files {

using namespace test;
namespace fs = std::filesystem;

typedef std::vector<std::string> Words;

class Files
{
public:
  Files(const std::string& program, const std::string& validator) : program_(program), validator_(validator)
  {
    const Soup soup = icosphere(1);
    mesh_ = path("mesh.off");
    CGAL::IO::write_polygon_soup(mesh_, soup.points, soup.triangles);
  }

  void run_all()
  {
    aliases();
    names_and_links();
    targets_are_kept();
    signals();
    full_disk();
    numbers_and_memory();
    shared_vertices();
    crowded_vertices();
  }

private:
  std::string path(const std::string& name) const { return (scratch_ / name).string(); }

  Words on_mesh(const Words& more) const
  {
    Words arguments = {mesh_, "--source-vertex", "0", "--distance", "0.5", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  Program_result in_shell(const std::string& setting, const Words& arguments, const std::string& redirection = "")
  {
    Words words = {"-c", setting + " exec \"$@\" " + redirection, "sh", program_};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return run_program("/bin/sh", words);
  }

  // Expects one line with the words, and no additional file.
  void expect_error(int exit_code, const std::string& what, const Program_result& result, const Words& words,
                    const std::set<std::string>& files_before)
  {
    Report::instance().set_context(what);
    CHECK_DETAIL(result.exit_code == exit_code, std::to_string(result.exit_code) + ": " + result.errors);
    CHECK_DETAIL(std::count(result.errors.begin(), result.errors.end(), '\n') == 1, result.errors);
    for (const std::string& word : words)
      CHECK_DETAIL(result.errors.find(word) != std::string::npos, word + " is not in: " + result.errors);
    CHECK(scratch_.files() == files_before);
    std::cout << what << ": " << result.errors;
  }

  void expect_named_twice(const std::string& what, const Words& arguments, const Words& words)
  {
    const std::set<std::string> before = scratch_.files();
    expect_error(2, what, run_program(program_, arguments), words, before);
  }

  // An output that is an input or another output, under any name.
  void aliases()
  {
    const std::string obj = path("in.obj"), curve = path("curve.polylines.txt");
    write_file(obj, "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n");
    write_file(curve, "2 0 0 0 1 1 0\n");
    const std::string obj_bytes = read_file(obj), curve_bytes = read_file(curve);
    fs::create_hard_link(obj, path("hard.obj"));
    fs::create_symlink("in.obj", path("soft.obj"));
    fs::create_symlink(scratch_ / "", path("folder"));
    fs::create_hard_link(curve, path("other.polylines.txt"));
    for (const char* alias :
         {"in.obj", "./in.obj", "folder/in.obj", "folder/folder/in.obj", "hard.obj", "soft.obj", "folder/soft.obj"})
      expect_named_twice(std::string("the mesh as ") + alias,
                         {obj, "--source-vertex", "0", "--distance", "1", "--output", path(alias)}, {"'" + obj + "'", "twice"});
    expect_named_twice("a polyline by another name",
                       {obj, "--source-polyline", curve, "--distance", "1", "--output", path("other.polylines.txt")},
                       {"'" + curve + "'", path("other.polylines.txt")});
    write_file(path("keep.vtk"), "old");
    for (const char* name : {"keep.vtk", "new.vtk"})
      for (const std::string prefix : {"./", "folder/", "folder/./"})
        expect_named_twice(name + (" also as " + prefix) + name,
                           {obj, "--source-vertex", "0", "--distance", "1", "--output", path(name), "--output",
                            path(prefix + name)},
                           {path(name), path(prefix + name)});
    Report::instance().set_context("nothing is lost");
    CHECK(read_file(obj) == obj_bytes && read_file(curve) == curve_bytes && read_file(path("keep.vtk")) == "old");

    // the other program
    const std::string table = path("table.txt");
    write_file(table, "0\n1\n1\n");
    fs::create_hard_link(table, path("rows.txt"));
    Report::instance().set_context("the table as output");
    const Program_result result =
      run_program(validator_, {obj, "--source-vertex", "0", "--distances", table, "--per-vertex", path("rows.txt")});
    CHECK_DETAIL(result.exit_code == 2 && result.errors.find("twice") != std::string::npos, result.errors);
    CHECK(read_file(table) == "0\n1\n1\n");
    for (const char* name : {"in.obj", "hard.obj", "soft.obj", "folder", "curve.polylines.txt", "other.polylines.txt",
                             "keep.vtk", "table.txt", "rows.txt"})
      fs::remove(scratch_ / name);
  }

  void names_and_links()
  {
    for (std::size_t size : {std::size_t(252), std::size_t(255)})
    {
      Report::instance().set_context("a name of " + std::to_string(size) + " bytes");
      const std::string name = path(std::string(size - 4, 'n') + ".vtk");
      const Program_result result = run_program(program_, on_mesh({"--output", name}));
      CHECK_DETAIL(result.exit_code == 0 && result.errors.empty(), result.errors);
      CHECK(fs::exists(name) && read_file(name).find("LINES") != std::string::npos);
      fs::remove(name);
    }
    // a symbolic link remains; its target receives the offsets, with the permissions of a new file
    Report::instance().set_context("a symbolic link");
    fs::create_directory(scratch_ / "there");
    write_file(path("there/real.vtk"), "old");
    fs::create_symlink("there/real.vtk", path("link.vtk"));
    CHECK(run_program(program_, on_mesh({"--output", path("link.vtk")})).exit_code == 0);
    CHECK(fs::is_symlink(path("link.vtk")) && read_file(path("there/real.vtk")).find("LINES") != std::string::npos);
    CHECK((fs::status(path("there/real.vtk")).permissions() & fs::perms::owner_all) ==
          (fs::perms::owner_read | fs::perms::owner_write));
    CHECK(std::distance(fs::directory_iterator(scratch_ / "there"), fs::directory_iterator()) == 1);
    // also if the target does not exist yet
    Report::instance().set_context("symbolic links without a file");
    fs::create_symlink("there/new.vtk", path("dangling.vtk"));
    fs::create_symlink("dangling.vtk", path("second.vtk"));
    expect_named_twice("two links to a new file", on_mesh({"--output", path("dangling.vtk"), "--output", path("second.vtk")}),
                       {path("dangling.vtk"), path("second.vtk")});
    CHECK(run_program(program_, on_mesh({"--output", path("second.vtk")})).exit_code == 0);
    CHECK(fs::is_symlink(path("second.vtk")) && read_file(path("there/new.vtk")).find("LINES") != std::string::npos);
    fs::create_symlink("circle.vtk", path("circle.vtk"));
    expect_error(1, "a link to itself", run_program(program_, on_mesh({"--output", path("circle.vtk")})),
                 {path("circle.vtk"), std::strerror(ELOOP)}, scratch_.files());
    for (const char* name : {"link.vtk", "dangling.vtk", "second.vtk", "circle.vtk"}) fs::remove(path(name));
    fs::remove_all(path("there"));
  }

  // Reading takes no quadratic time where many faces share a vertex, or an edge.
  void crowded_vertices()
  {
    constexpr int n = 60000;
    constexpr double most_seconds = 5; // a search around the vertex for each face takes 10 and more
    std::string cone, fans, book;
    for (int i = 0; i < n; ++i)
    {
      const double angle = 6.28 * i / n;
      const std::string place = std::to_string(std::cos(angle)) + ' ' + std::to_string(std::sin(angle)) + ' ';
      for (const char* z : {"0\n", "1\n"}) fans += place + z;
      cone += place + "0\n";
    }
    book = cone;
    for (int i = 0; i < n; ++i)
    {
      const std::string face = "3 0 ";
      cone += face + std::to_string(i + 1) + ' ' + std::to_string((i + 1) % n + 1) + '\n';
      fans += face + std::to_string(2 * i + 1) + ' ' + std::to_string(2 * i + 2) + '\n';
      if (i > 0) book += face + "1 " + std::to_string(i + 1) + '\n'; // around one edge
    }
    const auto check = [&](const char* name, int vertices, int faces, const std::string& rows) {
      Report::instance().set_context(name);
      const std::string file = path("crowded.off");
      write_file(file, "OFF\n" + std::to_string(vertices) + ' ' + std::to_string(faces) + " 0\n0 0 1\n" + rows);
      const double start = processor_seconds();
      const Program_result result =
        run_program(program_, {file, "--source-vertex", "2", "--maximum-distance", "1e-9", "--quiet"});
      CHECK_DETAIL(result.exit_code == 0, result.errors);
      const double seconds = processor_seconds() - start;
      CHECK_DETAIL(seconds < most_seconds, std::to_string(seconds));
      fs::remove(file);
    };
    check("a cone", n + 1, n, cone);
    check("fans", 2 * n + 1, n, fans);
    check("faces around an edge", n + 1, n - 1, book);
  }

  // All outputs or none: the second target cannot be replaced.
  void targets_are_kept()
  {
    using geodesic_offset::Output_files;
    const auto write = [](const std::string& text) { return [text](std::ostream& out) { out << text; }; };
    const std::string first = path("first.txt"), second = path("second.txt"), third = path("third.txt");
    for (bool exists : {true, false})
    {
      Report::instance().set_context(exists ? "old targets" : "new targets");
      if (exists) write_file(first, "old");
      bool failed = false;
      {
        Output_files files;
        files.add(first, write("new"));
        files.add(second, write("new"));
        files.add(third, write("new"));
        fs::create_directory(second);
        write_file(second + "/inside", "in a folder");
        try
        {
          files.commit();
        }
        catch (const geodesic_offset::Input_error& error)
        {
          failed = std::string(error.what()).find("'" + second + "'") != std::string::npos;
        }
      }
      CHECK(failed);
      CHECK(exists ? read_file(first) == "old" : !fs::exists(first));
      CHECK(!fs::exists(third) && read_file(second + "/inside") == "in a folder");
      fs::remove_all(second);
      fs::remove(first);
      CHECK(scratch_.files() == std::set<std::string>{mesh_});
    }
    Report::instance().set_context("replaced targets");
    write_file(first, "old");
    {
      Output_files files;
      files.add(first, write("new"));
      files.add(second, write("new"));
      CHECK(read_file(first) == "old" && !fs::exists(second));
      files.commit();
    }
    CHECK(read_file(first) == "new" && read_file(second) == "new");
    CHECK((scratch_.files() == std::set<std::string>{mesh_, first, second}));
    fs::remove(first);
    fs::remove(second);
  }

  bool wait_for_files(std::size_t number) const
  {
    for (int i = 0; i < 1000 && scratch_.files().size() != number; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return scratch_.files().size() == number;
  }

  void signals()
  {
    const std::pair<const char*, int> numbers[] = {{"SIGINT", SIGINT}, {"SIGTERM", SIGTERM}, {"SIGHUP", SIGHUP}};
    const Soup soup = jittered_grid(150, 150, 5);
    const std::string grid = path("grid.off"), output = path("output");
    CGAL::IO::write_polygon_soup(grid, soup.points, soup.triangles);
    const std::set<std::string> before = scratch_.files();
    for (const auto& number : numbers)
    {
      std::signal(number.second, SIG_DFL); // the caller of the tests may ignore it

      // during the output of a large file
      Report::instance().set_context(std::string(number.first) + " while files are written");
      write_file(path("old.txt"), "old");
      const pid_t child = fork();
      if (child == 0)
      {
        geodesic_offset::end_cleanly_on_signals();
        geodesic_offset::Output_files files;
        files.add(path("old.txt"), [](std::ostream& out) { out << "new"; });
        files.add(path("new.txt"), [](std::ostream& out) {
          out << "new" << std::flush;
          ::sleep(60);
        });
        _exit(99);
      }
      CHECK(wait_for_files(before.size() + 3));
      kill(child, number.second);
      CHECK(test::internal::exit_code_of(child) == 128 + number.second);
      CHECK(read_file(path("old.txt")) == "old");
      fs::remove(path("old.txt"));
      CHECK(scratch_.files() == before);

      // at any time: while files are created, written, and removed
      Report::instance().set_context(std::string(number.first) + " while files are created");
      for (int i = 0; i < 50; ++i)
      {
        const pid_t creator = fork();
        if (creator == 0)
        {
          geodesic_offset::end_cleanly_on_signals();
          alarm(60); // ends a run without the signal
          write_file(path("ready"), "");
          for (;;)
          {
            geodesic_offset::Output_files files;
            files.add(path("new.txt"), [](std::ostream& out) { out << "new"; });
          }
        }
        while (!fs::exists(path("ready"))) std::this_thread::yield();
        std::this_thread::sleep_for(std::chrono::microseconds(20 * i));
        kill(creator, number.second);
        CHECK(test::internal::exit_code_of(creator) == 128 + number.second);
        fs::remove(path("ready"));
        CHECK(scratch_.files() == before);
      }

      // during the computation
      Report::instance().set_context(std::string(number.first) + " in the program");
      const pid_t program = test::internal::start_program(
        program_, {grid, "--source-vertex", "0", "--spacing", "0.02", "--output", path("out.vtk"), "--output", path("out.dxf")},
        output, STDERR_FILENO);
      for (int i = 0; i < 1000 && read_file(output).find("sources: 1") == std::string::npos; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      kill(program, number.second);
      const int exit_code = test::internal::exit_code_of(program);
      CHECK_DETAIL(exit_code == 128 + number.second, std::to_string(exit_code));
      fs::remove(output);
      CHECK(scratch_.files() == before);
    }
    fs::remove(grid);
    // as nohup does
    Report::instance().set_context("an ignored signal");
    CHECK(in_shell("trap '' HUP INT; (sleep 0.1; kill -HUP $$; kill -INT $$) &", on_mesh({"--spacing", "0.01"})).exit_code ==
          0);
  }

  void full_disk()
  {
    const std::set<std::string> before = scratch_.files();
    const Words arguments = {mesh_, "--source-vertex", "0", "--spacing", "0.02"};
    for (const char* name : {"out.vtk", "out.dxf", "out.obj", "out.polylines.txt"})
    {
      Words with_output = arguments;
      with_output.insert(with_output.end(), {"--output", path(name)});
      expect_error(1, std::string("no room for ") + name, in_shell("ulimit -f 4;", with_output), {path(name), "large"}, before);
    }
    expect_error(1, "no room for a field", in_shell("ulimit -f 1;", on_mesh({"--field", path("f.ply")})),
                 {path("f.ply"), "large"}, before);
    expect_error(1, "no room for a split mesh",
                 in_shell("ulimit -f 4;", on_mesh({"--spacing", "0.1", "--split", path("s.ply")})), {path("s.ply"), "large"},
                 before);
    if (!fs::exists("/dev/full")) return;
    Words with_output = arguments;
    with_output.insert(with_output.end(), {"--output", path("out.vtk")});
    expect_error(1, "no room for messages", in_shell("", with_output, "> /dev/full"), {"standard output", "space"}, before);
    expect_error(1, "no room for the help", in_shell("", {"--help"}, "> /dev/full"), {"standard output", "space"}, before);
    expect_error(1, "a closed pipe", in_shell("", with_output, "| true; exit 1"), {"standard output"}, before);
    fs::create_symlink("/dev/full", path("full.json"));
    std::set<std::string> with_link = before;
    with_link.insert(path("full.json"));
    expect_error(1, "a device as output", run_program(program_, on_mesh({"--stats", path("full.json")})),
                 {path("full.json"), "regular"}, with_link);
    fs::remove(path("full.json"));
  }

  void numbers_and_memory()
  {
    const std::set<std::string> before = scratch_.files();
    const auto with = [&](const Words& more) {
      Words arguments = {mesh_, "--source-vertex", "0", "--output", path("out.vtk")};
      arguments.insert(arguments.end(), more.begin(), more.end());
      return run_program(program_, arguments);
    };
    expect_error(2, "levels beyond the range", with({"--spacing", "1e308", "--count", "5"}), {"--spacing 1e+308", "--count 5"},
                 before);
    expect_error(2, "levels below rounding", with({"--spacing", "1e-300", "--count", "5"}), {"--spacing 1e-300"}, before);
    expect_error(2, "a count beyond the range", with({"--spacing", "1", "--count", "18446744073709551616"}),
                 {"--count", "18446744073709551616"}, before);
#if defined(GEODESIC_OFFSET_TEST_ADDRESS_SANITIZER)
    std::cout << "limits of the address space: left out, AddressSanitizer does not run with them" << std::endl;
#elif defined(__linux__)
    // a sparse file larger than the memory limit
    const std::string large = path("large.off");
    write_file(large, "OFF\n");
    fs::resize_file(large, std::uintmax_t(3) << 30);
    std::set<std::string> with_large = before;
    with_large.insert(large);
    expect_error(1, "a file larger than the memory", in_shell("ulimit -v 2000000;", {large, "--source-vertex", "0"}),
                 {large, "needs at least 3.2 GB"}, with_large);
    fs::remove(large);
    // a small file of a large mesh
    std::string fan = "OFF\n3 1000000 0\n0 0 0\n1 0 0\n0 1 0\n";
    for (int i = 0; i < 1000000; ++i) fan += "3 0 1 2\n";
    const std::string many = path("many.off");
    write_file(many, fan);
    std::set<std::string> with_many = before;
    with_many.insert(many);
    expect_error(1, "a mesh larger than the memory", in_shell("ulimit -v 220000;", {many, "--source-vertex", "0"}),
                 {many, "1000000 triangles", "needs at least"}, with_many);
    fs::remove(many);
#endif
  }

  static std::vector<double> field(const std::string& file, std::size_t vertices)
  {
    const std::string bytes = read_file(file);
    const std::size_t begin = bytes.find("end_header\n") + 11;
    std::vector<double> distances(vertices, -1);
    for (std::size_t i = 0; i < vertices && CHECK(begin + 32 * (i + 1) <= bytes.size()); ++i)
      std::memcpy(&distances[i], bytes.data() + begin + 32 * i + 24, sizeof(double));
    return distances;
  }

  // Paths pass through, whether fans are open or closed. The field does not depend on the file of the surface, and is
  // 1-Lipschitz; --quiet does not hide the warning; the certified bounds of the other program hold.
  void shared_vertices()
  {
    struct Case
    {
      const char* name;
      std::string mesh;
      int source, shared;
      std::vector<double> distances;
    };
    const double s = std::sqrt(2.);
    const std::string open_points = "0 0 0\n1 0 0\n1 1 0\n2 1 0\n2 2 0\n",
                      closed_points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n-1 0 0\n0 -1 0\n0 0 -1\n",
                      first = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n", second = "3 0 4 5\n3 0 6 4\n3 0 5 6\n3 4 6 5\n";
    const std::vector<Case> cases = {
      {"two open fans", "OFF\n5 2 0\n" + open_points + "3 0 1 2\n3 2 3 4\n", 1, 2, {1, 0, 1, 2, 1 + s}},
      {"two open fans, one of them reversed", "OFF\n5 2 0\n" + open_points + "3 0 1 2\n3 2 4 3\n", 1, 2, {1, 0, 1, 2, 1 + s}},
      {"two closed fans", "OFF\n7 8 0\n" + closed_points + first + second, 1, 0, {1, 0, s, s, 2, 2, 2}},
      {"two closed fans, faces mixed",
       "OFF\n7 8 0\n" + closed_points + "3 0 4 5\n3 0 2 1\n3 4 6 5\n3 0 1 3\n3 0 6 4\n3 0 3 2\n3 1 2 3\n3 0 5 6\n",
       1,
       0,
       {1, 0, s, s, 2, 2, 2}},
      {"an open and a closed fan",
       "OFF\n6 5 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n-1 0 0\n0 -1 0\n" + first + "3 0 4 5\n",
       4,
       0,
       {1, 2, 2, 2, 0, s}},
      {"the source is shared", "OFF\n7 8 0\n" + closed_points + first + second, 0, 0, {0, 1, 1, 1, 1, 1, 1}},
      {"an edge of three faces beside two fans",
       "OFF\n7 4 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 2 0\n1 2 0\n3 0 1 2\n3 1 0 3\n3 0 1 4\n3 2 6 5\n",
       6,
       2,
       {}}};
    for (const Case& c : cases)
    {
      Report::instance().set_context(c.name);
      const std::string mesh = path("shared.off"), ply = path("field.ply");
      write_file(mesh, c.mesh);
      const Words arguments = {mesh,  "--source-vertex", std::to_string(c.source), "--field", ply, "--spacing",
                               "0.3", "--output",        path("out.vtk"),          "--quiet"};
      const Program_result result = run_program(program_, arguments);
      CHECK_DETAIL(result.exit_code == 0 && result.output.empty(), result.errors);
      CHECK_DETAIL(std::count(result.errors.begin(), result.errors.end(), '\n') ==
                       (c.distances.empty() ? 2 : 1) && // or parts, too

                     result.errors.find("warning: '" + mesh + "': 1 vertex is shared by fans") != std::string::npos &&
                     result.errors.find("vertex " + std::to_string(c.shared) + ")") != std::string::npos,
                   result.errors);
      if (c.distances.empty())
      {
        // both fans at vertex 2 are connected, and the surface is cut between vertices 0 and 1
        const std::vector<double> d = field(ply, 7);
        CHECK(std::isfinite(d[2]) && std::isfinite(d[0]) && std::isinf(d[3] + d[4]));
        continue;
      }
      const std::vector<double> distances = field(ply, c.distances.size());
      for (std::size_t i = 0; i < distances.size(); ++i)
        CHECK_DETAIL(std::abs(distances[i] - c.distances[i]) < 1e-14, std::to_string(i) + ": " + std::to_string(distances[i]));
      const Program_result certified =
        run_program(validator_, {mesh, "--source-vertex", std::to_string(c.source), "--distances", ply});
      CHECK_DETAIL(certified.exit_code == 0 && certified.errors.find("shared by fans") != std::string::npos, certified.errors);
    }
    for (const char* name : {"shared.off", "field.ply", "out.vtk"}) fs::remove(scratch_ / name);
  }

  std::string program_, validator_;
  Scratch_directory scratch_;
  std::string mesh_;
};

} // namespace test_program_files

GEODESIC_OFFSET_TEST(test_program_files)
{
  if (argc != 3 || !std::filesystem::exists(argv[1]) || !std::filesystem::exists(argv[2]))
  {
    std::cerr << "usage: test_program_files GEODESIC_OFFSET VALIDATE_GEODESIC_DISTANCES\n";
    return 2;
  }
  Files(argv[1], argv[2]).run_all();
  return Report::instance().finish("test_program_files");
}
