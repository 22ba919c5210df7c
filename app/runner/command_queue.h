// A queue that loses nothing: commands, sensor events and evidence, in the order given.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace spool {

// All functions from any thread.
template <class T>
class CommandQueue {
 public:
  // False after close(): the caller still has the value's meaning to deal with.
  [[nodiscard]] bool push(T value) {
    {
      const std::scoped_lock lock(mutex_);
      if (closed_) return false;
      values_.push_back(std::move(value));
    }
    filled_.notify_one();
    return true;
  }

  [[nodiscard]] std::optional<T> try_pop() {
    const std::scoped_lock lock(mutex_);
    return pop_locked();
  }

  // Waits for a value; nothing when `timeout` passed or the queue is closed and empty.
  [[nodiscard]] std::optional<T> pop(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    filled_.wait_for(lock, timeout, [this] { return !values_.empty() || closed_; });
    return pop_locked();
  }

  // No more values; those given before are still handed out.
  void close() {
    {
      const std::scoped_lock lock(mutex_);
      closed_ = true;
    }
    filled_.notify_all();
  }

  [[nodiscard]] bool is_finished() const {
    const std::scoped_lock lock(mutex_);
    return closed_ && values_.empty();
  }

 private:
  [[nodiscard]] std::optional<T> pop_locked() {
    if (values_.empty()) return std::nullopt;
    std::optional<T> value(std::move(values_.front()));
    values_.pop_front();
    return value;
  }

  mutable std::mutex mutex_;
  std::condition_variable filled_;
  std::deque<T> values_;
  bool closed_ = false;
};

}  // namespace spool
