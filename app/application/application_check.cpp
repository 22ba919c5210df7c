// A check of what is shown: inspected beside the screen, written, said.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "app/application/application.h"
#include "app/application/result_lines.h"
#include "app/evidence/writer.h"
#include "vision/core/file_digest.h"
#include "vision/scan/back_projection.h"
#include "vision/scan/reading_noise.h"

namespace spool {

namespace {

std::string digest_of(const DepthFrame& frame) {
  return sha256_hex({reinterpret_cast<const char*>(frame.depth.data()),
                     frame.depth.size() * sizeof(frame.depth.front())});
}

}  // namespace

void Application::start_check(bool final) {
  const VisionStatePtr state = final ? last_tracked_ : shown();
  if (!state || !(final || shows_pose())) return;
  ++checks_open_;
  int step_part = -1;
  if (in_.job && !final) {
    in_.job->begin_check();
    step_part = in_.job->part();
  }
  InspectorOptions options;
  options.align = AlignMethod::kPose;
  options.units_confirmed = !in_.design->model.unit_inferred;
  options.single_frame = true;
  options.posed_by = aligned_by_;
  options.scale_u = in_.camera.calibration.scale_u;
  options.warp_u_m = in_.camera.calibration.warp_u_m;
  options.correlated = correlated_readings(in_.camera, 1);
  Pose T = state->T_design_camera;  // into the design file's own coordinates
  T.translation() += in_.design->model.origin;
  options.T_design_scan = T;
  jobs_.run([this, state, options, final, step_part] {
    const Result<PointCloud> cloud = back_project(*state->frame, in_.camera);
    Result<Inspection> inspection = cloud
                                        ? Inspector(in_.design).process(*cloud, in_.noise, options)
                                        : Result<Inspection>(cloud.error());
    static_cast<void>(checked_.push({state, std::move(inspection), final, step_part}));
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
    auto record = std::make_shared<evidence::InspectionRecord>();
    record->design = in_.design;
    record->inspection = std::move(*done->inspection);
    record->over_frames = done->state->coverage.parts;
    record->scan.file = in_.source_text;
    record->scan.sha256 = digest_of(*done->state->frame);
    record->scan.kind = in_.is_recording ? "recording" : "device";
    record->scan.frame = done->state->frame->index;
    for (const std::uint16_t depth : done->state->frame->depth) record->scan.points += depth != 0;
    record->sensor = in_.source_description;
    record->calibration = in_.camera.calibration;
    record->noise_m = done->state->point_noise_m;
    for (const int part : in_.design->model.datums)
      record->datum.push_back(in_.design->model.parts.at(static_cast<std::size_t>(part)).name);
    record->feet_inches = in_.lengths == LengthStyle::kFeetInch;
    record->warnings = in_.design->model.warnings;
    if (!done->final) keep_results(done->state, record, done->step_part);
    last_check_ = {mark_of(record->inspection.status), record->inspection.status_reason};
    Result<std::vector<evidence::OverlayPicture>> pictures = evidence::draw_overlays(*record);
    if (!pictures) {
      fail(pictures.error());
      continue;
    }
    const std::filesystem::path folder =
        done->final ? in_.out : in_.out / fmt::format("check_{:03}", ++checks_);
    if (!done->final) {
      notice(fmt::format("{}: {} Saved in {}.", ui::word(last_check_->first), last_check_->second,
                         folder.string()));
    }
    const int step_part = done->step_part;
    jobs_.run([this, folder, record, step_part, shown = std::move(*pictures)] {
      const Status written = evidence::write_inspection(folder, *record, shown);
      if (!written)
        static_cast<void>(write_errors_.push(written.error()));
      else if (step_part >= 0)
        static_cast<void>(reports_.push({folder / "report.json", step_part}));
    });
  }
}

}  // namespace spool
