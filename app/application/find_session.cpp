// What a search for the design is at.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/find_session.h"

#include <algorithm>
#include <utility>

namespace spool {

std::string_view name(FindSession::Phase phase) {
  switch (phase) {
    case FindSession::Phase::kRunning:
      return "running";
    case FindSession::Phase::kNotFound:
      return "not found";
    case FindSession::Phase::kChoosing:
      return "choosing";
    case FindSession::Phase::kIdle:
      break;
  }
  return "idle";
}

// Nothing of an earlier phase is left over.
void FindSession::become(Phase phase) {
  phase_ = phase;
  progress_ = {};
  reason_.clear();
  choices_.clear();
  choice_ = 0;
}

void FindSession::start() { become(Phase::kRunning); }
void FindSession::cancel() { become(Phase::kIdle); }

void FindSession::report(const FindProgress& progress) {
  if (!is_running()) return;
  // A bar that goes back says nothing.
  const double share = std::clamp(progress.share, progress_.share, 1.0);
  progress_ = {progress.stage, share};
}

VisionStatePtr FindSession::answer(FindAnswer answer) {
  if (!is_running()) return nullptr;
  if (answer.poses.empty()) {
    fail(std::move(answer.reason));
    return nullptr;
  }
  if (answer.poses.size() == 1) {
    become(Phase::kIdle);
    return std::move(answer.poses.front());
  }
  become(Phase::kChoosing);
  choices_ = std::move(answer.poses);
  return nullptr;
}

void FindSession::fail(std::string reason) {
  become(Phase::kNotFound);
  reason_ = std::move(reason);
}

void FindSession::next() {
  if (!choices_.empty()) choice_ = (choice_ + 1) % choices_.size();
}

VisionStatePtr FindSession::accept() {
  VisionStatePtr chosen = shown();
  if (chosen) become(Phase::kIdle);
  return chosen;
}

const VisionStatePtr& FindSession::shown() const {
  static const VisionStatePtr none;
  return choices_.empty() ? none : choices_[choice_];
}

}  // namespace spool
