// One thread that does jobs in the order given and loses none.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/job_thread.h"

#include <cassert>
#include <chrono>
#include <utility>

namespace spool {

JobThread::JobThread()
    : thread_([this] {
        while (!jobs_.is_finished()) {
          auto job = jobs_.pop(std::chrono::milliseconds(1000));
          if (!job) continue;
          (*job)();
          const std::scoped_lock lock(mutex_);
          --open_;
          idle_.notify_all();
        }
      }) {}

JobThread::~JobThread() { jobs_.close(); }

void JobThread::run(std::function<void()> job) {
  {
    const std::scoped_lock lock(mutex_);
    ++open_;
  }
  const bool taken = jobs_.push(std::move(job));
  assert(taken && "no jobs while the thread is being destroyed");
  static_cast<void>(taken);
}

void JobThread::wait() {
  std::unique_lock lock(mutex_);
  idle_.wait(lock, [this] { return open_ == 0; });
}

}  // namespace spool
