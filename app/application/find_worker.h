// The thread that looks for the design in a picture, so that no other thread waits for it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "app/application/job_thread.h"
#include "app/runner/command_queue.h"
#include "app/runner/mailbox.h"
#include "vision/live/find_in_picture.h"

namespace spool {

struct FindProgress {
  std::string stage;  // "prepare", "find", "fit"
  double share = 0;   // 0 to 1, of the whole search
};

// All functions on the main thread. One search at a time; what is asked of a search that was
// cancelled is never answered.
class FindWorker {
 public:
  FindWorker(std::shared_ptr<const PreparedDesign> design, const Camera& camera,
             const NoiseModel& noise);
  FindWorker(const FindWorker&) = delete;
  FindWorker& operator=(const FindWorker&) = delete;
  ~FindWorker();  // within 100 ms

  // Cancels a search that still runs. The first one prepares the design besides, which takes about
  // a second once.
  void start(VisionStatePtr picture);
  // Prepares the design, so that the first search need not.
  void warm_up();
  void cancel();  // returns at once; the thread is free again within 100 ms
  [[nodiscard]] std::optional<FindProgress> progress();  // the newest since the last call
  [[nodiscard]] std::optional<FindAnswer> take();
  void wait() { thread_.wait(); }  // until the thread is free

 private:
  template <class T>
  struct Numbered {
    std::uint64_t search = 0;
    T value;
  };
  void search(std::uint64_t number, const VisionState& picture, const std::stop_token& stop);
  // Nothing where it was stopped before the design was ready.
  [[nodiscard]] const FinderModel* ready_finder(const Watch& watch);

  std::shared_ptr<const PreparedDesign> design_;
  Camera camera_;
  NoiseModel noise_;
  std::unique_ptr<const FinderModel> finder_;  // the search's thread only
  std::stop_source stop_;                      // of the newest search
  std::stop_source closing_;                   // of a preparation ahead of the first one
  bool is_warm_ = false;
  std::uint64_t searches_ = 0;
  std::uint64_t wanted_ = 0;  // the search whose answer is awaited; 0: none
  Mailbox<Numbered<FindProgress>> progress_;
  CommandQueue<Numbered<FindAnswer>> answers_;
  JobThread thread_;  // last: its jobs use what stands above
};

}  // namespace spool
