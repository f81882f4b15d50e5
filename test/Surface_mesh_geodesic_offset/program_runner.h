// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs the example programs in a scratch directory (POSIX).

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

// AddressSanitizer needs terabytes of address space, so no limit is set. The programs have the same build options as the
// tests.
#if defined(__SANITIZE_ADDRESS__)
#define GEODESIC_OFFSET_TEST_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define GEODESIC_OFFSET_TEST_ADDRESS_SANITIZER
#endif
#endif

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

/// Temporary directory, removed with its contents at the end.
class Scratch_directory
{
public:
  Scratch_directory()
  {
    std::string name = (std::filesystem::temp_directory_path() / "geodesic_offset_test.XXXXXX").string();
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
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path_)) result.insert(entry.path().string());
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

namespace internal {

/// Starts the program in a child process with a given error stream, and its output in a file.
inline pid_t start_program(const std::string& program, const std::vector<std::string>& arguments, const std::string& output,
                           int errors)
{
  std::vector<char*> argv;
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child > 0) return child;
  const int out = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int in = open("/dev/null", O_RDONLY);
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  alarm(120); // ends a hanging run
  execv(program.c_str(), argv.data());
  _exit(127);
}

inline int exit_code_of(pid_t child)
{
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace internal

/// Runs the program and waits for it. Its output and errors are in files outside of the scratch directory.
inline Program_result run_program(const std::string& program, const std::vector<std::string>& arguments)
{
  const Scratch_directory streams;
  const std::string output = (streams / "output").string(), errors = (streams / "errors").string();
  const int error_file = open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const pid_t child = internal::start_program(program, arguments, output, error_file);
  close(error_file);
  const int exit_code = internal::exit_code_of(child);
  return {exit_code, read_file(output), read_file(errors)};
}

/// Version with a terminal as error stream.
inline Program_result run_program_on_terminal(const std::string& program, const std::vector<std::string>& arguments)
{
  const Scratch_directory streams;
  const std::string output = (streams / "output").string();
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) throw std::runtime_error("no terminal");
  const int program_side = open(ptsname(terminal), O_RDWR | O_NOCTTY);
  const pid_t child = internal::start_program(program, arguments, output, program_side);
  close(program_side);
  std::string errors;
  char block[4096];
  for (ssize_t n; (n = read(terminal, block, sizeof(block))) > 0;) errors.append(block, std::size_t(n));
  close(terminal);
  const int exit_code = internal::exit_code_of(child);
  return {exit_code, read_file(output), errors};
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_PROGRAM_RUNNER_H
