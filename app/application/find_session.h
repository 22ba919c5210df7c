// What a search for the design is at, as the fitter sees it: running, not found, a choice to make.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "app/application/find_worker.h"

namespace spool {

// Holds what is shown of a search; the search itself is FindWorker's.
class FindSession {
 public:
  enum class Phase {
    kIdle,      // never asked, cancelled, or found and handed on
    kRunning,   // progress()
    kNotFound,  // reason()
    kChoosing,  // shown() is one of several poses that explain the picture
  };

  void start();
  void cancel();
  // Nothing of it counts unless a search runs.
  void report(const FindProgress& progress);
  // The one pose that was found, to be aligned with; nothing where none was, where there is a
  // choice, or where no search runs.
  [[nodiscard]] VisionStatePtr answer(FindAnswer answer);
  void fail(std::string reason);  // it cannot go on, or what it gave was not believed

  void next();                            // the next pose of the choice, the first after the last
  [[nodiscard]] VisionStatePtr accept();  // the pose shown; nothing where there is no choice

  [[nodiscard]] Phase phase() const { return phase_; }
  [[nodiscard]] bool is_running() const { return phase_ == Phase::kRunning; }
  [[nodiscard]] const FindProgress& progress() const { return progress_; }
  [[nodiscard]] const std::string& reason() const { return reason_; }
  [[nodiscard]] std::size_t choice() const { return choice_; }
  [[nodiscard]] std::size_t choices() const { return choices_.size(); }
  [[nodiscard]] const VisionStatePtr& shown() const;  // null where there is no choice

 private:
  void become(Phase phase);

  Phase phase_ = Phase::kIdle;
  FindProgress progress_;
  std::string reason_;
  std::vector<VisionStatePtr> choices_;
  std::size_t choice_ = 0;
};

[[nodiscard]] std::string_view name(FindSession::Phase phase);

}  // namespace spool
