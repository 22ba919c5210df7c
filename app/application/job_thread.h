// One thread that does jobs in the order given and loses none.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "app/runner/command_queue.h"

namespace spool {

class JobThread {
 public:
  JobThread();
  JobThread(const JobThread&) = delete;
  JobThread& operator=(const JobThread&) = delete;
  ~JobThread();  // does what is left first

  void run(std::function<void()> job);  // any thread
  void wait();                          // until every job given so far is done

 private:
  CommandQueue<std::function<void()>> jobs_;
  std::mutex mutex_;
  std::condition_variable idle_;
  std::size_t open_ = 0;  // given and not done
  std::jthread thread_;   // last: starts when all else stands
};

}  // namespace spool
