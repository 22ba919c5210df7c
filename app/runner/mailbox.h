// A place for one thing between a fast giver and a slow taker: the newest wins.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace spool {

// All functions from any thread.
template <class T>
class Mailbox {
 public:
  // Puts `value` in the place of what was not taken yet. Dropped after close().
  void put(T value) {
    {
      const std::scoped_lock lock(mutex_);
      if (closed_) return;
      value_ = std::move(value);
    }
    filled_.notify_one();
  }

  // What lies there, at once; nothing where nothing does.
  [[nodiscard]] std::optional<T> try_take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(value_, std::nullopt);
  }

  // Waits for something to lie there; nothing when `timeout` passed or the mailbox was closed
  // empty.
  [[nodiscard]] std::optional<T> take(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    filled_.wait_for(lock, timeout, [this] { return value_.has_value() || closed_; });
    return std::exchange(value_, std::nullopt);
  }

  // Wakes every waiter. What lies there may still be taken; nothing more is accepted.
  void close() {
    {
      const std::scoped_lock lock(mutex_);
      closed_ = true;
    }
    filled_.notify_all();
  }

  [[nodiscard]] bool is_closed() const {
    const std::scoped_lock lock(mutex_);
    return closed_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable filled_;
  std::optional<T> value_;
  bool closed_ = false;
};

}  // namespace spool
