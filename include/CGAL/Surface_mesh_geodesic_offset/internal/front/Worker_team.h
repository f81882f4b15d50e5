// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fork and join for many short rounds of work: TBB lends threads once, and these wait for the rounds in a loop.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_WORKER_TEAM_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_WORKER_TEAM_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#if defined(__SSE2__) || defined(_M_X64)
#include <emmintrin.h>
#define CGAL_GEODESIC_OFFSET_PAUSE() _mm_pause()
#else
#define CGAL_GEODESIC_OFFSET_PAUSE() ((void)0)
#endif

// ThreadSanitizer sees how this file synchronizes threads, but not how libtbb does, unless that is built with it. It is
// told that a task begins after it was put into the arena; of TBB's own task objects it is told nothing.
#if defined(__SANITIZE_THREAD__)
#define CGAL_GEODESIC_OFFSET_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CGAL_GEODESIC_OFFSET_THREAD_SANITIZER
#endif
#endif
#ifdef CGAL_GEODESIC_OFFSET_THREAD_SANITIZER
extern "C" void __tsan_acquire(void*);
extern "C" void __tsan_release(void*);
extern "C" void __tsan_ignore_thread_begin();
extern "C" void __tsan_ignore_thread_end();
#endif

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// The calling thread, worker 0, and helpers. No round waits for a helper that is not there: who comes takes part of the
// items, and if TBB has no thread to lend, worker 0 does all.
class Worker_team
{
public:
  // As many as TBB may use where it is called.
  static unsigned possible_size()
  {
    const std::size_t allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    const int here = tbb::this_task_arena::max_concurrency();
    return unsigned((std::max)(std::size_t(1), (std::min)(allowed, std::size_t((std::max)(here, 1)))));
  }

  explicit Worker_team(unsigned size) : m_size(size)
  {
    if (size < 2) return;
    m_shared = std::make_shared<Shared>();
#ifdef CGAL_GEODESIC_OFFSET_THREAD_SANITIZER
    __tsan_release(m_shared.get());
    __tsan_ignore_thread_begin();
#endif
    tbb::task_arena& waiting = arena();
    for (unsigned i = 1; i < size; ++i) waiting.enqueue(Helper{m_shared, size});
#ifdef CGAL_GEODESIC_OFFSET_THREAD_SANITIZER
    __tsan_ignore_thread_end();
#endif
  }

  Worker_team(const Worker_team&) = delete;
  Worker_team& operator=(const Worker_team&) = delete;

  // Those that have come leave; those that have not will find nothing to do.
  ~Worker_team()
  {
    if (m_shared) m_shared->work.store(no_more, std::memory_order_release);
  }

  unsigned size() const { return m_size; }

  // Calls f(worker, first, last) for ranges [first, last) that make up [0, n), from several threads at once, where
  // worker < size(). What was written before is seen by all of them, and what they write afterwards by the caller. An
  // exception is thrown on once all have ended.
  template <class Function>
  void for_each(Index n, bool is_worth_help, const Function& f)
  {
    if (!m_shared || !is_worth_help)
    {
      f(0u, Index(0), n);
      return;
    }
    Shared& s = *m_shared;
    s.done.store(0, std::memory_order_relaxed);
    s.function = &f;
    s.call = [](const void* function, unsigned worker, Index first, Index last) {
      (*static_cast<const Function*>(function))(worker, first, last);
    };
    m_round = (m_round + 1) & 0x7fffffffu; // not that of no_more
    std::uint64_t work = m_round << 32 | n;
    s.work.store(work, std::memory_order_release);
    while (s.take_part(0, m_size, work)) {}
    Patience patience;
    while (s.done.load(std::memory_order_acquire) != n) patience.wait();
    if (s.failed.load(std::memory_order_relaxed)) s.rethrow();
  }

private:
  // Where helpers wait for threads, those of all teams that are made where TBB may use as many. Short builds may be over
  // before a thread comes, and arenas of their own would heap up.
  static tbb::task_arena& arena()
  {
    static std::mutex mutex;
    static std::map<unsigned, std::unique_ptr<tbb::task_arena>> arenas;
    const unsigned size = (std::max)(possible_size(), 2u);
    const std::lock_guard<std::mutex> lock(mutex);
    std::unique_ptr<tbb::task_arena>& arena = arenas[size];
    if (!arena) arena = std::make_unique<tbb::task_arena>(int(size), 1);
    return *arena;
  }

  static constexpr std::uint64_t no_more = ~std::uint64_t(0);

  // Waits a little: first on the core, for work that comes soon, then leaving it to others.
  class Patience
  {
  public:
    void wait()
    {
      if (m_turns < 2000)
        for (int i = 0; i < 8; ++i) CGAL_GEODESIC_OFFSET_PAUSE();
      else if (m_turns < 4000)
        std::this_thread::yield();
      else
        std::this_thread::sleep_for(std::chrono::microseconds(50));
      ++m_turns;
    }
    void renew() { m_turns = 0; }

  private:
    unsigned m_turns = 0;
  };

  struct Shared
  {
    // the number of the round, and below it how many items have not been taken: the first ones
    alignas(64) std::atomic<std::uint64_t> work{0};
    const void* function = nullptr;
    void (*call)(const void*, unsigned, Index, Index) = nullptr;
    alignas(64) std::atomic<Index> done{0};
    alignas(64) std::atomic<unsigned> helpers{0};
    std::atomic<bool> failed{false};
    std::mutex mutex;
    std::exception_ptr exception;

    // Takes some of the items that are left, in the state `w` of the work; false if there are none.
    bool take_part(unsigned worker, unsigned size, std::uint64_t& w)
    {
      Index left, n;
      do
      {
        left = Index(w & 0xffffffffu);
        if (left == 0 || w == no_more) return false;
        n = (std::max)(Index(1), Index(left / (4 * size)));
      } while (!work.compare_exchange_weak(w, w - n, std::memory_order_acquire, std::memory_order_acquire));
      try
      {
        call(function, worker, left - n, left);
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        exception = std::current_exception();
        failed.store(true, std::memory_order_relaxed);
      }
      w -= n;
      done.fetch_add(n, std::memory_order_release);
      return true;
    }

    void rethrow()
    {
      failed.store(false, std::memory_order_relaxed);
      std::rethrow_exception(exception);
    }
  };

  struct Helper
  {
    std::shared_ptr<Shared> shared;
    unsigned size;

    void operator()() const
    {
#ifdef CGAL_GEODESIC_OFFSET_THREAD_SANITIZER
      __tsan_acquire(shared.get());
#endif
      const unsigned worker = 1 + shared->helpers.fetch_add(1, std::memory_order_relaxed);
      Patience patience;
      std::uint64_t w = 0;
      while (true)
      {
        w = shared->work.load(std::memory_order_acquire);
        if (w == no_more) break;
        if (shared->take_part(worker, size, w)) patience.renew();
        else patience.wait();
      }
    }
  };

  const unsigned m_size;
  std::shared_ptr<Shared> m_shared;
  std::uint64_t m_round = 0;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#undef CGAL_GEODESIC_OFFSET_PAUSE
#undef CGAL_GEODESIC_OFFSET_THREAD_SANITIZER

#endif
