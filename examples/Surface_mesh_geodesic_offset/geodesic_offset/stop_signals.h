// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Signals that end a program: before it ends, its temporary files are removed. A thread waits for the signals, so that the
// removal is not restricted to what a signal handler may do, and so that it cannot happen in the middle of a rename.

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

// The temporary files of the program. They outlive static objects, as the thread of the signals does.
class Temporary_files
{
  std::mutex            m_mutex;
  std::set<std::string> m_names;

public:
  static Temporary_files& instance()
  {
    static Temporary_files* const files = new Temporary_files;
    return *files;
  }

  // While a lock exists, the program is not ended by a signal.
  std::unique_lock<std::mutex> lock() { return std::unique_lock<std::mutex>(m_mutex); }

  // These need the lock.
  void add(const std::string& name) { m_names.insert(name); }
  void forget(const std::string& name) { m_names.erase(name); }

  void remove_all()
  {
    for(const std::string& name : m_names)
      ::unlink(name.c_str());
  }
};

// On SIGINT, SIGTERM and SIGHUP the temporary files are removed, and the program ends with the exit code 128 + signal; a signal
// that the caller ignores, as nohup does, remains ignored. Failures to write are errors of the functions that write, and no
// signals: neither on a closed pipe nor on a file at its size limit. To be called before other threads exist.
inline void end_cleanly_on_signals()
{
  for(int ignored : {SIGPIPE, SIGXFSZ})
    std::signal(ignored, SIG_IGN);
  sigset_t signals;
  sigemptyset(&signals);
  bool is_any = false;
  for(int number : {SIGINT, SIGTERM, SIGHUP})
  {
    struct sigaction action;
    if(sigaction(number, nullptr, &action) != 0 || action.sa_handler == SIG_IGN)
      continue;
    sigaddset(&signals, number);
    is_any = true;
  }
  if(!is_any || pthread_sigmask(SIG_BLOCK, &signals, nullptr) != 0) // also for the threads that follow
    return;
  std::thread([signals] {
    int number = 0;
    if(sigwait(&signals, &number) != 0)
      return;
    const std::unique_lock<std::mutex> lock = Temporary_files::instance().lock();
    Temporary_files::instance().remove_all();
    ::_exit(128 + number);
  }).detach();
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_STOP_SIGNALS_H
