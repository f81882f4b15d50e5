// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Output files of the programs: all or none are replaced, and signals at any time leave no partial files. The tests in
// test_program_files.py run the program.

#include "common/output_file.h"
#include "scratch_directory.h"
#include "test_check.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <string>
#include <thread>
#include <utility>

namespace test_output_files {

using namespace test;
using geodesic_offset::Output_files;
namespace fs = std::filesystem;

std::string read_file(const fs::path& path)
{
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

void write_new(std::ostream& out) { out << "new"; }

class Files
{
public:
  void run_all()
  {
    for (const bool exists : {true, false}) second_target_fails(exists);
    targets_are_replaced();
    for (const auto& signal :
         {std::make_pair("SIGINT", SIGINT), std::make_pair("SIGTERM", SIGTERM), std::make_pair("SIGHUP", SIGHUP)})
    {
      std::signal(signal.second, SIG_DFL); // the caller of the tests may ignore it
      Report::instance().set_context(signal.first);
      while_files_are_written(signal.second);
      for (int i = 0; i < 50; ++i) while_files_are_created(signal.second, std::chrono::microseconds(20 * i));
    }
  }

private:
  std::string path(const std::string& name) const { return (scratch_ / name).string(); }
  void write_old(const std::string& name) const { std::ofstream(path(name)) << "old"; }

  std::set<std::string> files() const
  {
    std::set<std::string> result;
    for (const auto& entry : fs::recursive_directory_iterator(scratch_ / "")) result.insert(entry.path().filename().string());
    return result;
  }

  void second_target_fails(bool exists)
  {
    Report::instance().set_context(exists ? "old targets" : "new targets");
    if (exists) write_old("first");
    bool failed = false;
    {
      Output_files outputs;
      for (const char* name : {"first", "second", "third"}) outputs.add(path(name), write_new);
      fs::create_directory(path("second"));
      write_old("second/inside");
      try
      {
        outputs.commit();
      }
      catch (const geodesic_offset::Input_error& error)
      {
        failed = std::string(error.what()).find("'" + path("second") + "'") != std::string::npos;
      }
    }
    CHECK(failed);
    CHECK(exists ? read_file(path("first")) == "old" : !fs::exists(path("first")));
    CHECK(!fs::exists(path("third")) && read_file(path("second/inside")) == "old");
    fs::remove_all(path("second"));
    fs::remove(path("first"));
    CHECK(files().empty());
  }

  void targets_are_replaced()
  {
    Report::instance().set_context("replaced targets");
    write_old("first");
    {
      Output_files outputs;
      outputs.add(path("first"), write_new);
      outputs.add(path("second"), write_new);
      CHECK(read_file(path("first")) == "old" && !fs::exists(path("second")));
      outputs.commit();
    }
    CHECK(read_file(path("first")) == "new" && read_file(path("second")) == "new");
    CHECK((files() == std::set<std::string>{"first", "second"}));
    fs::remove(path("first"));
    fs::remove(path("second"));
  }

  // Calls f in a child process, sends the signal when is_ready(), and checks that only the given files remain.
  void end_by_signal(int signal, const std::function<void()>& f, const std::function<bool()>& is_ready,
                     std::chrono::microseconds delay, const std::set<std::string>& remaining) const
  {
    const pid_t child = fork();
    if (child == 0)
    {
      geodesic_offset::end_cleanly_on_signals();
      alarm(60); // ends a run without the signal
      f();
      _exit(99);
    }
    for (int i = 0; i < 100000 && !is_ready(); ++i) std::this_thread::sleep_for(std::chrono::microseconds(50));
    CHECK(is_ready());
    std::this_thread::sleep_for(delay);
    kill(child, signal);
    int status = 0;
    waitpid(child, &status, 0);
    CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 128 + signal);
    CHECK(files() == remaining);
  }

  void while_files_are_written(int signal) const
  {
    write_old("old");
    const auto write = [&] {
      Output_files outputs;
      outputs.add(path("old"), write_new);
      outputs.add(path("other"), [](std::ostream& out) {
        out << "new" << std::flush;
        ::sleep(60);
      });
    };
    end_by_signal(signal, write, [&] { return files().size() == 3; }, {}, {"old"});
    CHECK(read_file(path("old")) == "old");
    fs::remove(path("old"));
  }

  // At any time: while files are created, written, and removed
  void while_files_are_created(int signal, std::chrono::microseconds delay) const
  {
    const auto write = [&] {
      write_old("ready");
      for (;;)
      {
        Output_files outputs;
        outputs.add(path("other"), write_new);
      }
    };
    end_by_signal(signal, write, [&] { return fs::exists(path("ready")); }, delay, {"ready"});
    fs::remove(path("ready"));
  }

  Scratch_directory scratch_;
};

} // namespace test_output_files

GEODESIC_OFFSET_TEST(test_output_files)
{
  test_output_files::Files().run_all();
  return test::Report::instance().finish("test_output_files");
}
