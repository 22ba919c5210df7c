// Ends a computation from another thread while it runs.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cancelling.h"

#include <atomic>
#include <chrono>
#include <ctime>
#include <thread>

#include <pthread.h>

namespace spool::test {
namespace {

clockid_t clock_of_this_thread() {
  clockid_t clock = CLOCK_MONOTONIC;
  pthread_getcpuclockid(pthread_self(), &clock);
  return clock;
}

double seconds_on(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

double seconds_of(const std::function<void()>& work) {
  const clockid_t clock = clock_of_this_thread();
  const double start = seconds_on(clock);
  work();
  return seconds_on(clock) - start;
}

std::optional<double> seconds_until_obeyed(double after_s,
                                           const std::function<void(const Watch&)>& work) {
  const clockid_t clock = clock_of_this_thread();
  const double start = seconds_on(clock);
  std::stop_source stop;
  std::atomic<bool> done{false};
  std::optional<double> asked;
  std::thread other([&] {
    while (!done && seconds_on(clock) - start < after_s)
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    if (done) return;
    asked = seconds_on(clock);
    stop.request_stop();
  });
  work(Watch{stop.get_token(), {}});
  const double ended = seconds_on(clock);
  done = true;
  other.join();
  if (!asked || *asked > ended) return std::nullopt;
  return ended - *asked;
}

}  // namespace spool::test
