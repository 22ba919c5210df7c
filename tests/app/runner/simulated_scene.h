// A bracket over a floor seen by a depth camera, ray-cast in memory, and a source that plays it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "app/sensor/depth_source.h"
#include "vision/core/camera.h"
#include "vision/core/pose.h"
#include "vision/inspector.h"

namespace spool::test {

// Three boxes without any symmetry: parts "base", "arm" and "post".
[[nodiscard]] DesignModel bracket_design();
[[nodiscard]] std::shared_ptr<const PreparedDesign> prepared_bracket();

// A plate that looks the same from above when it is turned half round, but for a peg under it that
// the camera cannot see; without the peg that is its symmetry.
[[nodiscard]] std::shared_ptr<const PreparedDesign> prepared_plate(bool with_peg = true);

// 160 x 120 px with the field of view of a PrimeSense.
[[nodiscard]] Camera small_camera();
// The same view with so many times as many pixels across and down.
[[nodiscard]] Camera larger_camera(double times);
// Looks down on the bracket from about 0.85 m; `turn_rad` walks it round the vertical, `shift_m`
// aside.
[[nodiscard]] Pose T_design_camera(double turn_rad = 0, double shift_m = 0);

// The depth image at that pose over a floor 0.1 m below the design, with Gaussian noise of
// `noise_m`.
[[nodiscard]] std::shared_ptr<const DepthFrame> render_frame(const PreparedDesign& design,
                                                             const Pose& T_design_camera,
                                                             std::int64_t index,
                                                             double noise_m = 0.0005);
// The same in a workshop whose things stand still: floor and boxes round the design, which lies at
// T_shop_design in it (identity: where it lies in the other pictures); null: it is not there.
[[nodiscard]] std::shared_ptr<const DepthFrame> render_in_workshop(
    const PreparedDesign* design, const Pose& T_shop_design, const Pose& T_shop_camera,
    std::int64_t index, const Camera& camera = small_camera());
// The floor alone.
[[nodiscard]] std::shared_ptr<const DepthFrame> empty_frame(const Pose& T_design_camera,
                                                            std::int64_t index);

// A source that hands out what it was given, in order; then kEnd (a recording) or timeouts.
struct Step {
  sensor::SourceOutput output;
  std::chrono::milliseconds delay{0};  // slept before it is handed out
  std::optional<Error> error;          // in the place of the output
};
class ScriptedSource final : public sensor::DepthSource {
 public:
  ScriptedSource(std::vector<Step> steps, bool recording);
  [[nodiscard]] const Camera& camera() const override { return camera_; }
  [[nodiscard]] std::string description() const override { return "scripted"; }
  [[nodiscard]] bool is_recording() const override { return recording_; }
  [[nodiscard]] Result<sensor::SourceOutput> next(std::chrono::milliseconds timeout) override;

 private:
  std::deque<Step> steps_;
  bool recording_;
  Camera camera_ = small_camera();
};

[[nodiscard]] Step frame_step(std::shared_ptr<const DepthFrame> frame);

}  // namespace spool::test
