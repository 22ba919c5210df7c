// A check of what is shown: inspected beside the screen, written, said.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>

#include "app/application/application.h"
#include "app/application/result_lines.h"
#include "app/job/check_record.h"

namespace spool {

void Application::start_check(bool final) {
  const VisionStatePtr state = final ? last_tracked_ : shown();
  if (!state || !(final || shows_pose())) return;
  ++checks_open_;
  int step_part = -1;
  std::uint64_t asked = 0;
  if (in_.job && !final) {
    in_.job->begin_check();
    step_part = in_.job->part();
    asked = ++checks_asked_;
    if (step_part >= 0 && in_.job->operator_name().empty()) ask_for_name();
  }
  InspectorOptions options;
  options.align = AlignMethod::kPose;
  options.units_confirmed = !in_.design->model.unit_inferred;
  options.posed_by = aligned_by_;
  Pose T = state->T_design_camera;  // into the design file's own coordinates
  T.translation() += in_.design->model.origin;
  options.T_design_scan = as_read_back(T);
  jobs_.run([this, state, options, final, step_part, asked, T]() mutable {
    Checked checked{state, Error{}, Error{}, T, *options.posed_by, final, step_part, asked};
    checked.frame = {state->frame, in_.camera, in_.source_description};
    const char* kind = in_.is_recording ? "recording" : "device";
    Result<evidence::ScanSnapshot> scan =
        evidence::frame_snapshot(checked.frame, in_.source_text, kind, in_.noise);
    if (scan) {
      options.single_frame = scan->single_frame;
      options.scale_u = scan->calibration.scale_u;
      options.warp_u_m = scan->calibration.warp_u_m;
      options.correlated = scan->correlated;
      checked.inspection = Inspector(in_.design).process(scan->cloud, scan->noise, options);
      scan->cloud = {};  // the inspection has it in the design's frame
    } else {
      checked.inspection = scan.error();
    }
    checked.scan = std::move(scan);
    static_cast<void>(checked_.push(std::move(checked)));
  });
}

// Pictures need the GL thread: drawn here, written by the job thread.
void Application::take_checks() {
  while (std::optional<Checked> done = checked_.try_pop()) {
    --checks_open_;
    if (!done->inspection) {
      fail(done->inspection.error());
      continue;
    }
    auto check = std::make_shared<CheckEvidence>();
    check->folder = done->final ? in_.out : in_.out / fmt::format("check_{:03}", ++checks_);
    check->frame = done->frame;
    check->part = done->step_part;
    check->asked = done->asked;
    evidence::InspectionRecord* record = &check->record;
    record->design = in_.design;
    record->inspection = std::move(*done->inspection);
    record->over_frames = done->state->coverage.parts;
    record->scan = done->scan->record;
    record->sensor = done->scan->sensor;
    record->calibration = done->scan->calibration;
    record->noise_m = done->scan->noise_m;
    for (const int part : in_.design->model.datums)
      record->datum.push_back(in_.design->model.parts.at(static_cast<std::size_t>(part)).name);
    record->feet_inches = in_.lengths == LengthStyle::kFeetInch;
    record->created = job::utc_text(std::floor(job::now().wall_s));
    record->warnings = in_.design->model.warnings;
    record->warnings.insert(record->warnings.end(), done->scan->warnings.begin(),
                            done->scan->warnings.end());
    // Made again by the sensor's own noise, which no option says.
    if (check->part >= 0 && in_.noise.constant_m == 0)
      keep_options(done->T_design_scan, done->posed_by, *check);
    if (!done->final) keep_results(done->state, {check, record}, done->step_part);
    last_check_ = {mark_of(record->inspection.status), record->inspection.status_reason};
    Result<std::vector<evidence::OverlayPicture>> pictures = evidence::draw_overlays(*record);
    if (!pictures) {
      fail(pictures.error());
      continue;
    }
    check->pictures = std::move(*pictures);
    if (!done->final) {
      notice(fmt::format("{}: {} Saved in {}.", ui::word(last_check_->first), last_check_->second,
                         check->folder.string()));
    }
    if (check->part >= 0) {
      capture(check);
      continue;
    }
    jobs_.run([this, check] {
      if (const Status written = write_check(*check); !written)
        static_cast<void>(write_errors_.push(written.error()));
    });
  }
}

}  // namespace spool
