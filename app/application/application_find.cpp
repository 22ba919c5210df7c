// Find: the search for the design in the held picture, from the press of the button to the pose.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "app/application/application.h"

namespace spool {

namespace {
constexpr double kSearchAgainSeconds = 2;  // after a moved spool was not found
}  // namespace

bool Application::can_find() const { return seen_ && !awaiting_alignment_ && has_pictures(); }

void Application::start_find() {
  if (!can_find()) return;
  stop_find();  // a second press begins anew, on the newest picture
  moved_search_.reset();
  start_align();
  hold_picture();
  find_.start();
  finder_.start(shown());  // what lies outside a box is not looked at
}

// Whatever the search is at; the picture goes on.
void Application::stop_find() {
  if (find_.phase() == FindSession::Phase::kIdle) return;
  finder_.cancel();
  find_.cancel();
  if (screen_ == ui::Screen::kChoose) screen_ = ui::Screen::kAlign;
  release_picture();
}

// The spool is not where it was: looked for everywhere, beside the work, while the camera goes on.
void Application::look_for_moved_spool() {
  if (!state_ || !state_->is_gone || screen_ != ui::Screen::kWork || moved_search_ || !can_find() ||
      state_->frame->seconds < no_search_before_s_)
    return;
  moved_search_ = state_;
  finder_.start(state_);
}

// Aligned with, without a tap, where the picture leaves no choice; else looked for again in a
// while.
void Application::take_moved_spool() {
  const std::optional<FindAnswer> answer = finder_.take();
  if (!answer) return;
  const VisionStatePtr searched = std::exchange(moved_search_, nullptr);
  no_search_before_s_ = searched->frame->seconds + kSearchAgainSeconds;
  if (screen_ != ui::Screen::kWork || awaiting_alignment_ || answer->poses.size() != 1) return;
  ask_for_alignment(searched, answer->poses.front()->T_design_camera, AlignMethod::kFind);
}

void Application::take_find() {
  if (in_.wait_for_jobs) finder_.wait();
  if (moved_search_) take_moved_spool();
  if (!find_.is_running()) return;
  if (const auto progress = finder_.progress()) find_.report(*progress);
  std::optional<FindAnswer> answer = finder_.take();
  if (!answer) return;
  if (const VisionStatePtr found = find_.answer(std::move(*answer))) {
    align_as_found(*found);
  } else if (find_.phase() == FindSession::Phase::kChoosing) {
    screen_ = ui::Screen::kChoose;
    detached_ = false;
  } else {
    release_picture();  // so that the camera can look from elsewhere
  }
}

void Application::show_next_choice() {
  find_.next();
  detached_ = false;  // an eye beside one pose is nowhere beside the next
}

void Application::accept_choice() {
  const VisionStatePtr chosen = find_.accept();
  if (!chosen) return;
  screen_ = ui::Screen::kAlign;
  align_as_found(*chosen);
}

// As three picks do.
void Application::align_as_found(const VisionState& found) {
  ask_for_alignment(held_, found.T_design_camera, AlignMethod::kFind);
}

// The frame that the search was made on bore the pose out, so this is rare; nothing may hang on it.
void Application::refuse_found() {
  start_align();
  find_.fail(
      "What was found does not fit what is seen: hold still, press Find again, or pick three "
      "points.");
  feed_->command({VisionCommand::Kind::kForget, nullptr, Pose::Identity()});
  release_picture();
}

void Application::lose_sensor() {
  if (moved_search_) finder_.cancel();
  moved_search_.reset();
  if (!find_.is_running()) return;
  finder_.cancel();
  find_.fail("The sensor went away during the search: press Find when it is back.");
  release_picture();
}

// True where the search has something to say, which then comes before the picks.
bool Application::fill_find(ui::ScreenState& out) const {
  out.can_find = can_find() && !find_.is_running();
  switch (find_.phase()) {
    case FindSession::Phase::kRunning: {
      const FindProgress& progress = find_.progress();
      out.finding = true;
      out.find_share = progress.share;
      out.hint = progress.stage == "find"  ? "Looking for the spool in the picture."
                 : progress.stage == "fit" ? "Fitting the drawing to the steel."
                                           : "Getting the drawing ready to be looked for.";
      out.proposed = "Cancel stops it; a tap on a picture picks a point instead.";
      return true;
    }
    case FindSession::Phase::kNotFound:
      out.hint = find_.reason();
      out.hint_is_warning = true;
      out.proposed = "Point the camera at the spool and press Find again, or pick three points.";
      return true;
    case FindSession::Phase::kChoosing:
    case FindSession::Phase::kIdle:
      break;
  }
  return false;
}

void Application::fill_choose(ui::ScreenState& out) const {
  const VisionStatePtr& pose = find_.shown();
  if (!pose) return;
  out.choice = fmt::format("{} of {}", find_.choice() + 1, find_.choices());
  out.hint = fmt::format(
      "The drawing fits the steel in {} ways. Press Accept if it lies like this, else Next.",
      find_.choices());
  out.choice_evidence = fmt::format("{:.0f} % of what should be seen is seen, {} off it.",
                                    100 * pose->agreement, length_text(pose->rms_m, in_.lengths));
  out.detached = detached_;
}

}  // namespace spool
