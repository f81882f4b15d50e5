// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Number of threads.

#ifndef GEODESIC_OFFSET_THREADS_H
#define GEODESIC_OFFSET_THREADS_H

#include "common/command_line.h"
#include "common/common.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>

namespace geodesic_offset {

constexpr bool has_threads = std::is_same<CGAL::Parallel_if_available_tag, CGAL::Parallel_tag>::value;

namespace internal {

// Maximum of --threads, more than any machine runs concurrently: TBB reserves memory for every permitted thread.
constexpr std::size_t most_threads = 1024;

inline std::optional<std::size_t> number_of_threads(const po::variables_map& map)
{
  const std::optional<std::size_t> number = optional_whole_number(map, "threads");
  if(!has_threads && number.value_or(1) > 1)
    throw Usage_error("--threads " + std::to_string(*number) + ": the program was built without TBB");
  if(number.value_or(1) > most_threads)
    throw Usage_error("--threads " + std::to_string(*number) + ": no more than " + std::to_string(most_threads) +
                      " threads are allowed");
  return number;
}

} // namespace internal

// Calls f(concurrency tag) for a number of the option --threads.
template <class Function>
void with_concurrency_tag(std::optional<std::size_t> threads, const Function& f)
{
  if(threads == 1)
    f(CGAL::Sequential_tag());
  else
    f(CGAL::Parallel_if_available_tag());
}

// During its life, at most the given number of threads work; those of the machine if no number is given.
class Working_threads
{
#ifdef CGAL_LINKED_WITH_TBB
  std::optional<tbb::global_control> m_control;
#endif
  std::size_t m_number = 1;

public:
  explicit Working_threads(std::optional<std::size_t> number)
  {
#ifdef CGAL_LINKED_WITH_TBB
    if(number) m_control.emplace(tbb::global_control::max_allowed_parallelism, *number);
    if(number != 1) m_number = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
#else
    (void)number;
#endif
  }

  std::size_t number() const { return m_number; }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_THREADS_H
