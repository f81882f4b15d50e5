// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs the programs of the examples in a scratch directory (POSIX).

#ifndef GEODESIC_OFFSET_TEST_PROGRAM_RUNNER_H
#define GEODESIC_OFFSET_TEST_PROGRAM_RUNNER_H

#include <fcntl.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace test {

inline std::string read_file(const std::filesystem::path& path)
{
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

inline void write_file(const std::filesystem::path& path, const std::string& bytes)
{
  std::ofstream out(path, std::ios::binary);
  out << bytes;
}

/// A temporary directory, removed with all it contains at the end.
class Scratch_directory
{
public:
  Scratch_directory()
  {
    std::string name =
      (std::filesystem::temp_directory_path() / "geodesic_offset_test.XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
    path_ = name;
  }
  ~Scratch_directory()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Scratch_directory(const Scratch_directory&) = delete;
  Scratch_directory& operator=(const Scratch_directory&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  std::set<std::string> files() const
  {
    std::set<std::string> result;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path_))
      result.insert(entry.path().string());
    return result;
  }

private:
  std::filesystem::path path_;
};

struct Program_result
{
  int exit_code; // -1 if a signal ended it
  std::string output, errors;
};

/// Runs the program and waits for it. Its output and errors go through files outside of the scratch
/// directory.
inline Program_result run_program(const std::string& program,
                                  const std::vector<std::string>& arguments)
{
  const Scratch_directory streams;
  const std::string output = (streams / "output").string(), errors = (streams / "errors").string();
  std::vector<char*> argv;
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0)
  {
    const int out = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int err = open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int in = open("/dev/null", O_RDONLY);
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    alarm(120); // a run that hangs ends with a signal
    execv(program.c_str(), argv.data());
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(output), read_file(errors)};
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_PROGRAM_RUNNER_H
