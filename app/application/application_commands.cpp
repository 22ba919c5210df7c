// What taps, gestures and buttons do.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "app/application/application.h"
#include "app/application/landmark_evidence.h"
#include "app/application/last_seconds.h"
#include "app/application/picking.h"
#include "vision/core/file_io.h"

namespace spool {

namespace {
constexpr double kNoticeSeconds = 4.0;
constexpr int kViewModes = 4;
}  // namespace

void Application::handle(const ui::Command& command) {
  switch (command.action) {
    case ui::Action::kAlign:
      start_align();
      break;
    case ui::Action::kFind:
      start_find();
      break;
    case ui::Action::kCancelFind:
      stop_find();
      break;
    case ui::Action::kNext:
      show_next_choice();
      break;
    case ui::Action::kAccept:
      accept_choice();
      break;
    case ui::Action::kAcceptStep:
      accept_step();
      break;
    case ui::Action::kCaptureAgain:
    case ui::Action::kEvidence:
    case ui::Action::kOpenCapture:
    case ui::Action::kTurnPage:
    case ui::Action::kNcr:
    case ui::Action::kTypeField:
    case ui::Action::kChooseField:
    case ui::Action::kWriteNcr:
    case ui::Action::kLeave:
    case ui::Action::kKey:
    case ui::Action::kKeyRole:
      handle_evidence(command);
      break;
    case ui::Action::kFinish:
      finish_align();
      break;
    case ui::Action::kResults:
      open_results(-1, false);
      break;
    case ui::Action::kOpenResult:
      open_results(command.value, false);
      break;
    case ui::Action::kBack:
      if (screen_ == ui::Screen::kResults) {
        leave_results();
        break;
      }
      stop_find();
      picks_.clear();
      box_.clear();
      menu_open_ = false;
      release_picture();
      screen_ = ui::Screen::kWork;
      break;
    case ui::Action::kSkip:
      picks_.skip();
      break;
    case ui::Action::kUndo:
      picks_.undo();
      if (!picks_.can_undo()) release_picture();
      break;
    case ui::Action::kCheck:
      start_check(false);
      break;
    case ui::Action::kShot:
      pending_screen_ = fmt::format("screen_{:03}.png", ++shots_);
      break;
    case ui::Action::kView:
      view_mode_ = static_cast<ViewMode>((static_cast<int>(view_mode_) + 1) % kViewModes);
      break;
    case ui::Action::kCameraView:
      results_eye_ = ViewControl();
      detached_ = false;
      break;
    case ui::Action::kToggleList:
      list_open_ = !list_open_;
      break;
    case ui::Action::kLightPart:
      lit_part_ = lit_part_ == command.part ? -1 : command.part;
      break;
    case ui::Action::kBox:
      press_box();
      break;
    case ui::Action::kFreeze:
      frozen_ = frozen_ || !shows_pose() ? nullptr : shown();
      break;
    case ui::Action::kMenu:
      menu_open_ = !menu_open_;
      break;
    case ui::Action::kSaveLast:
      menu_open_ = false;
      save_last();
      break;
    case ui::Action::kReplay: {
      Result<std::unique_ptr<Feed>> feed = in_.open_feed();
      if (!feed) {
        fail(feed.error());
        break;
      }
      stop_find();
      drop_results();
      feed_ = std::move(*feed);
      ended_ = aligned_ = awaiting_alignment_ = false;
      alignments_asked_ = 0;
      state_ = seen_ = held_ = moved_search_ = nullptr;
      no_search_before_s_ = 0;
      box_.clear();
      start_align();
      break;
    }
  }
}

void Application::handle(const ui::Gesture& gesture) {
  if (screen_ == ui::Screen::kEvidence || screen_ == ui::Screen::kNcr ||
      screen_ == ui::Screen::kTyping)
    return;  // there is no picture of the steel
  if (gesture.kind == ui::Gesture::Kind::kTap) {
    tap(gesture);
    return;
  }
  if (screen_ == ui::Screen::kAlign) {
    const bool on_design = layout_.design_view.contains(gesture.start_x, gesture.start_y);
    ViewControl& eye = on_design ? design_eye_ : scan_eye_;
    if (eye.is_started()) eye.apply(gesture, on_design ? layout_.design_view : layout_.scan_view);
    return;
  }
  const VisionStatePtr& state = shown();
  if (!shows_pose()) return;
  if (screen_ == ui::Screen::kResults) {
    if (!results_eye_.is_started()) {
      const render::View view = results_view();
      results_eye_.start(view, (view.T_camera_design * in_.design->model.bounds().center()).z());
    }
    results_eye_.apply(gesture, layout_.results_view);
    return;
  }
  if (!detached_) {
    const render::View view = camera_view(state.get(), in_.width, in_.height);
    work_eye_.start(view, (view.T_camera_design * in_.design->model.bounds().center()).z());
    detached_ = true;
  }
  work_eye_.apply(gesture, layout_.work_view);
}

void Application::tap(const ui::Gesture& gesture) {
  const double slop = tap_slop_px(in_.dots_per_inch);
  if (screen_ != ui::Screen::kAlign) {
    const VisionStatePtr& state = shown();
    if (!shows_pose()) return;
    const bool on_results = screen_ == ui::Screen::kResults;
    const ui::Rect& rect = on_results ? layout_.results_view : layout_.work_view;
    if (!rect.contains(gesture.x, gesture.y)) return;
    const render::View view = on_results  ? results_view()
                              : detached_ ? work_eye_.view()
                                          : camera_view(state.get(), in_.width, in_.height);
    const auto hit = pick_design(in_.design->model, *in_.design->surface, {}, view,
                                 gesture.x - rect.x, gesture.y - rect.y, slop);
    if (hit && (on_results || shows_readout()) && open_results_of(hit->part)) return;
    if (on_results) return;
    lit_part_ = hit && hit->part != lit_part_ ? hit->part : -1;
    return;
  }
  if (awaiting_alignment_ || !design_eye_.is_started() || !scan_eye_.is_started()) return;
  const auto is_on = [&](const ui::Rect& view) { return view.contains(gesture.x, gesture.y); };
  if (!is_on(layout_.design_view) && !is_on(layout_.scan_view)) return;
  if (box_.is_asking()) {
    tap_box(gesture, slop);
    return;
  }
  // Who taps does not wait for the search any more; its picture is the one that was tapped.
  const bool was_searching = find_.is_running();
  finder_.cancel();
  find_.cancel();
  moved_search_.reset();
  pick(gesture, slop);
  if (was_searching && !picks_.can_undo()) release_picture();
}

void Application::pick(const ui::Gesture& gesture, double slop) {
  if (layout_.design_view.contains(gesture.x, gesture.y)) {
    const auto hit = pick_design(in_.design->model, *in_.design->surface, landmarks_.landmarks,
                                 design_eye_.view(), gesture.x - layout_.design_view.x,
                                 gesture.y - layout_.design_view.y, slop);
    const bool is_there =
        hit && (!in_.job || hit->part < 0 || on_table_[static_cast<std::size_t>(hit->part)]);
    if (hit && !is_there) {
      notice("That part is not built yet: tap one that stands.");
    } else if (hit && shown()) {
      hold_picture();
      picks_.choose_design_point(*hit);
    } else {
      notice("No part of the drawing there: tap on it.");
    }
    return;
  }
  if (!shown()) return;
  const auto index =
      pick_point(shown()->scan.points, scan_eye_.view(), gesture.x - layout_.scan_view.x,
                 gesture.y - layout_.scan_view.y, slop);
  if (!index) {
    picks_.refuse_scan_point();
    return;
  }
  const Eigen::Vector3d point = shown()->scan.points[*index].cast<double>();
  hold_picture();
  if (!picks_.pick_scan_point(point)) {
    notice("Tap a point of the drawing first.");
  }
}

void Application::start_align() {
  screen_ = ui::Screen::kAlign;
  frozen_.reset();
  menu_open_ = false;
  picks_.clear();
  list_open_ = false;
}

std::vector<double> Application::landmark_evidence(std::span<const PointPair> pairs) const {
  const VisionStatePtr& state = shown();
  std::vector<double> likelihood;
  if (!state) {
    leave_out_absent(likelihood);
    return likelihood;
  }
  PickScene scene{*in_.design, in_.camera, *state->frame, state->scan.points, std::nullopt};
  if (state->quality != TrackQuality::kUnaligned) scene.T_design_camera = state->T_design_camera;
  likelihood = measured_likelihood(scene, landmarks_.landmarks, pairs);
  leave_out_absent(likelihood);
  return likelihood;
}

// Picks are made on one frame: the picture stands still, a recording waits, a camera is followed.
void Application::hold_picture() {
  if (held_) return;
  held_ = seen_;
  feed_->pause(true);
}

void Application::release_picture() {
  if (!held_) return;
  held_.reset();
  feed_->pause(false);
}

void Application::finish_align() {
  if (picks_.result().status != PairsStatus::kOk || !held_ || awaiting_alignment_) return;
  ask_for_alignment(held_, picks_.result().T_design_scan, AlignMethod::kThreePoint);
}

void Application::ask_for_alignment(VisionStatePtr on, const Pose& T_design_camera,
                                    AlignMethod method) {
  awaiting_alignment_ = true;
  asked_by_ = method;
  ++alignments_asked_;
  feed_->command({VisionCommand::Kind::kAlign, std::move(on), T_design_camera});
}

// The pose was believed: on with the work.
void Application::leave_align() {
  aligned_by_ = asked_by_;
  // Nobody is taken away from what they are writing: a spool that was moved is aligned by itself.
  if (screen_ == ui::Screen::kAlign || screen_ == ui::Screen::kChoose) screen_ = ui::Screen::kWork;
  menu_open_ = false;
  box_.clear();  // from now on the region of interest follows the design
  picks_.clear();
  held_.reset();
  detached_ = false;
  feed_->pause(false);
  // A spool that is moved is looked for without delay; who waits for jobs need not wait for this.
  if (!in_.wait_for_jobs) finder_.warm_up();
}

void Application::save_screen(const std::string& file) {
  const std::filesystem::path path = in_.out / file;
  notice("Saved " + path.string());
  jobs_.run([this, path, image = picture_->target().read()] {
    Status written = make_folder(path.parent_path());
    if (written) written = render::write_png(path, image);
    if (!written) static_cast<void>(write_errors_.push(written.error()));
  });
}

// What the sensor gave until now, all of it, not only what vision came to.
void Application::save_last() {
  auto last = std::make_shared<LastSeconds>(
      LastSeconds{in_.camera, feed_->last_frames(), PoseTable(in_.design->model.origin)});
  std::vector<std::int64_t> numbers;
  for (const sensor::PackedDepthPtr& frame : last->frames) numbers.push_back(frame->index);
  last->poses = poses_.renumbered(numbers);
  ++saves_open_;
  notice(fmt::format("Saving the last {:.0f} seconds.", last->seconds()));
  saving_.run([this, last] {
    const Result<std::filesystem::path> folder = save_last_seconds(in_.out, *last);
    Result<std::string> said = std::string();
    if (folder)
      said = fmt::format("Saved the last {:.1f} s in {}.", last->seconds(), folder->string());
    else
      said = folder.error();
    static_cast<void>(saved_.push(std::move(said)));
  });
}

void Application::take_saved() {
  while (const std::optional<Result<std::string>> said = saved_.try_pop()) {
    --saves_open_;
    if (*said)
      notice(**said);
    else
      fail(said->error());
  }
}

void Application::notice(std::string text) {
  notice_ = std::move(text);
  notice_until_s_ = now_s_ + kNoticeSeconds;
}

void Application::fail(const Error& error) {
  if (!first_write_error_) first_write_error_ = error;
  notice(error.message);
}

Status Application::finish() {
  stop_find();
  pending_screen_ = "screen_end.png";
  if (Status status = frame(now_s_, {}); !status) return status;
  if (last_tracked_) start_check(true);
  jobs_.wait();   // the inspection
  take_checks();  // draws its pictures
  jobs_.wait();   // writes them
  take_captures();
  take_accepted();
  capture_again();  // what could not be, once more: after this nobody has it any more
  jobs_.wait();
  take_captures();
  if (!uncaptured_.empty() && !first_write_error_)
    first_write_error_ = capture_error_.value_or(
        Error{ErrorCode::kUsage,
              "A check was not captured: nobody said who checked; start with "
              "--operator NAME, or say it on the screen."});
  saving_.wait();
  take_saved();
  while (const std::optional<Error> error = write_errors_.try_pop()) fail(*error);
  if (first_write_error_) return *first_write_error_;
  return {};
}

}  // namespace spool
