// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fork and join for many short rounds of work. TBB lends threads once per team; they wait for the rounds in a loop. With
// tbb::parallel_for() in its place, a build takes 4 to 8 % longer (armadillo, bunny00, Stanford dragon, two threads).

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WORKERS_WORKER_TEAM_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WORKERS_WORKER_TEAM_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <CGAL/assertions.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <thread>
#include <utility>
#include <vector>

#if defined(__SSE2__) || defined(_M_X64)
#include <emmintrin.h>
#define CGAL_GEODESIC_OFFSET_PAUSE() _mm_pause()
#else
#define CGAL_GEODESIC_OFFSET_PAUSE() ((void)0)
#endif

// ThreadSanitizer sees the synchronization in this file, but not that inside libtbb unless libtbb is instrumented. So it is
// informed that a task starts after its insertion into the arena, and ignores TBB's own task objects.
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

namespace CGAL::Geodesic_offset::internal {

// Worker 0 is the calling thread, the others are helpers. No round waits for a missing helper: each present helper
// processes some of the items, and if TBB lends no thread, worker 0 processes all of them.
class Worker_team
{
public:
  // The number of threads that TBB allows at the place of the call.
  static unsigned possible_size()
  {
    const std::size_t allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    const int here = tbb::this_task_arena::max_concurrency();
    return unsigned((std::max)(std::size_t(1), (std::min)(allowed, std::size_t((std::max)(here, 1)))));
  }

  explicit Worker_team(unsigned size) : m_size(size)
  {
    if (size < 2) return;
    m_shared = std::make_shared<Shared>(size);
#ifdef CGAL_GEODESIC_OFFSET_THREAD_SANITIZER
    __tsan_release(m_shared.get());
    __tsan_ignore_thread_begin();
#endif
    try
    {
      tbb::task_arena& waiting = arena();
      for (unsigned i = 1; i < size; ++i) waiting.enqueue(Helper{m_shared, size});
    }
    catch (...)
    {
      dismiss();
      throw;
    }
#ifdef CGAL_GEODESIC_OFFSET_THREAD_SANITIZER
    __tsan_ignore_thread_end();
#endif
  }

  Worker_team(const Worker_team&) = delete;
  Worker_team& operator=(const Worker_team&) = delete;

  ~Worker_team()
  {
    if (m_shared) dismiss();
  }

  unsigned size() const { return m_size; }

  // Calls f(worker, i) for each i < n, concurrently, with worker < size(). Each worker starts with a contiguous share of
  // the items, in the order of the workers and of similar weight, so that it mostly has the same items in each round; idle
  // workers steal items. All workers see what was written before the call, and the caller sees what they write. Rethrows
  // the exception of the first item that throws; f may or may not be called for later items.
  template <class Weight, class Function>
  void for_each(Index n, const Weight& weight, bool is_worth_help, const Function& f)
  {
    CGAL_assertion(n < (Index(1) << 16));
    if (!m_shared || !is_worth_help)
    {
      for (Index i = 0; i < n; ++i) f(0u, i);
      return;
    }
    Shared& s = *m_shared;
    s.done.store(0, std::memory_order_relaxed);
    s.function = &f;
    s.call = [](const void* function, unsigned worker, Index i) { (*static_cast<const Function*>(function))(worker, i); };
    if (++m_round == Shared::no_more) m_round = 1;
    std::size_t sum = 0, before = 0;
    for (Index i = 0; i < n; ++i) sum += weight(i);
    s.order.resize(n);
    std::iota(s.order.begin(), s.order.end(), Index(0));
    Index first = 0;
    for (unsigned worker = 0; worker < m_size; ++worker)
    {
      Index end = first;
      for (; end < n && (worker + 1 == m_size || (before + weight(end) / 2) * m_size < sum * (worker + 1)); ++end)
        before += weight(end);
      std::sort(s.order.begin() + first, s.order.begin() + end, [&](Index i, Index j) { return weight(i) > weight(j); });
      s.share[worker].store(Shared::share_of(m_round, first, end));
      first = end;
    }
    const Index mine = s.work(0, m_size, m_round);
    Patience patience;
    while (s.done.load(std::memory_order_acquire) + mine != n) patience.wait();
    s.rethrow();
  }

private:
  // Present helpers leave; late helpers find no work.
  void dismiss()
  {
    for (auto& share : m_shared->share) share.store(Shared::share_of(Shared::no_more, 0, 0));
  }

  // Arena in which helpers wait for threads, shared by all teams created under the same thread limit. A short build may end
  // before a thread arrives, so arenas per team would accumulate.
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

  // Back-off while waiting: spin, then yield, then sleep.
  class Patience
  {
  public:
    void wait()
    {
      if (m_turns < 2000)
        for (int i = 0; i < 8; ++i) CGAL_GEODESIC_OFFSET_PAUSE();
      else if (m_turns < 4000) std::this_thread::yield();
      else std::this_thread::sleep_for(std::chrono::microseconds(50));
      ++m_turns;
    }
    void renew() { m_turns = 0; }

  private:
    unsigned m_turns = 0;
  };

  struct Shared
  {
    static constexpr std::uint32_t no_more = ~std::uint32_t(0); // round number: the team is dismissed

    // Remaining items of a worker in a round: the round number and the range [first, end).
    struct alignas(64) Share
    {
      std::atomic<std::uint64_t> items{0};
      void store(std::uint64_t i) { items.store(i, std::memory_order_release); }
    };
    static std::uint64_t share_of(std::uint32_t round, Index first, Index end)
    {
      return std::uint64_t(round) << 32 | first << 16 | end;
    }
    static std::uint32_t round_of(std::uint64_t share) { return std::uint32_t(share >> 32); }
    static Index first_of(std::uint64_t share) { return Index(share >> 16) & 0xffffu; }
    static Index end_of(std::uint64_t share) { return Index(share) & 0xffffu; }

    explicit Shared(unsigned size) : share(size) { std::fegetenv(&environment); }

    std::vector<Share> share;
    std::vector<Index> order;
    const void* function = nullptr;
    void (*call)(const void*, unsigned, Index) = nullptr;
    alignas(64) std::atomic<Index> done{0}; // number of items, by helpers
    alignas(64) std::atomic<unsigned> helpers{0};
    std::fenv_t environment; // of worker 0; helpers use the same rounding mode
    std::mutex mutex;
    std::exception_ptr exception; // of the first item that threw
    Index failed_item = no_index;

    // Removes the first or last item of the share of worker `of`.
    bool take(unsigned of, std::uint32_t round, bool is_first, Index& i)
    {
      std::uint64_t s = share[of].items.load(std::memory_order_relaxed), less;
      Index place;
      do {
        const Index first = first_of(s), end = end_of(s);
        if (round_of(s) != round || first == end) return false;
        place = is_first ? first : end - 1;
        less = is_first ? share_of(round, first + 1, end) : share_of(round, first, end - 1);
      } while (!share[of].items.compare_exchange_weak(s, less, std::memory_order_acquire, std::memory_order_relaxed));
      i = order[place];
      return true;
    }

    // Processes the share of a worker, then steals from other shares. Returns the number of processed items.
    Index work(unsigned worker, unsigned size, std::uint32_t round)
    {
      Index number = 0, i;
      for (; take(worker, round, true, i); ++number) try_call(worker, i);
      for (unsigned k = 1; k < size; ++k)
        for (; take((worker + k) % size, round, false, i); ++number) try_call(worker, i);
      return number;
    }

    void try_call(unsigned worker, Index i)
    {
      try
      {
        call(function, worker, i);
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        if (i >= failed_item) return;
        failed_item = i;
        exception = std::current_exception();
      }
    }

    // Passes the exception to the caller; called when all items are done.
    void rethrow()
    {
      if (failed_item == no_index) return;
      failed_item = no_index;
      std::rethrow_exception(std::exchange(exception, nullptr));
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
      if (worker >= size) return;
      std::fenv_t own;
      std::fegetenv(&own);
      std::fesetenv(&shared->environment);
      Patience patience;
      std::uint32_t last = 0;
      while (true)
      {
        const std::uint32_t round = Shared::round_of(shared->share[worker].items.load(std::memory_order_acquire));
        if (round == Shared::no_more) break;
        if (round == last)
        {
          patience.wait();
          continue;
        }
        last = round;
        if (const Index n = shared->work(worker, size, round)) shared->done.fetch_add(n, std::memory_order_release);
        patience.renew();
      }
      std::fesetenv(&own);
    }
  };

  const unsigned m_size;
  std::shared_ptr<Shared> m_shared;
  std::uint32_t m_round = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#undef CGAL_GEODESIC_OFFSET_PAUSE
#undef CGAL_GEODESIC_OFFSET_THREAD_SANITIZER

#endif
