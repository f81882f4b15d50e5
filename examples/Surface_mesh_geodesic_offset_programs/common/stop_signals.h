// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Removal of temporary files when a signal ends the program. A thread waits for the signals, so that the removal is not
// restricted to operations allowed in signal handlers, and cannot interrupt a rename.

#ifndef GEODESIC_OFFSET_STOP_SIGNALS_H
#define GEODESIC_OFFSET_STOP_SIGNALS_H

#include <csignal>
#include <initializer_list>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include <unistd.h>

namespace geodesic_offset {

// Temporary files of the program. Outlives static objects, as the thread of the signals does.
class Temporary_files
{
  std::mutex m_mutex;
  std::set<std::string> m_names;

public:
  static Temporary_files& instance()
  {
    static Temporary_files* const files = new Temporary_files;
    return *files;
  }

  // While a lock exists, no signal ends the program.
  std::unique_lock<std::mutex> lock() { return std::unique_lock<std::mutex>(m_mutex); }

  // Precondition: the caller has the lock.
  void add(const std::string& name) { m_names.insert(name); }
  void forget(const std::string& name) { m_names.erase(name); }

  void remove_all()
  {
    for(const std::string& name : m_names) ::unlink(name.c_str());
  }
};

// On SIGINT, SIGTERM and SIGHUP, removes the temporary files and ends the program with exit code 128 + signal; signals that
// the caller ignores, as nohup does, remain ignored. Failed writes are errors of the writing functions and not signals,
// both for closed pipes and for file size limits. Must be called before other threads exist. Throws std::system_error if no
// thread can be started.
inline void end_cleanly_on_signals()
{
  for(int ignored : {SIGPIPE, SIGXFSZ}) std::signal(ignored, SIG_IGN);
  sigset_t signals;
  sigemptyset(&signals);
  bool is_any = false;
  for(int number : {SIGINT, SIGTERM, SIGHUP})
  {
    struct sigaction action;
    if(sigaction(number, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    sigaddset(&signals, number);
    is_any = true;
  }
  if(!is_any || pthread_sigmask(SIG_BLOCK, &signals, nullptr) != 0) // also for subsequent threads
    return;
  std::thread([signals] {
    int number = 0;
    if(sigwait(&signals, &number) != 0) return;
    const std::unique_lock<std::mutex> lock = Temporary_files::instance().lock();
    Temporary_files::instance().remove_all();
    ::_exit(128 + number);
  }).detach();
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_STOP_SIGNALS_H
