// The whole application without a window, on the bracket, driven frame by frame.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/application/application.h"
#include "render/egl_context.h"
#include "tests/app/application/robot_fitter.h"
#include "tests/app/runner/simulated_scene.h"
#include "tests/support/temporary_folder.h"

namespace spool::test {

[[nodiscard]] inline std::vector<Step> standing_still(
    int frames, const PreparedDesign& design = *prepared_bracket()) {
  std::vector<Step> steps;
  for (int i = 0; i < frames; ++i) {
    steps.push_back(frame_step(render_frame(design, T_design_camera(), i)));
  }
  return steps;
}

// Lock step, and what the test says of the sensor besides.
class NotedFeed final : public Feed {
 public:
  NotedFeed(std::unique_ptr<Feed> feed, std::shared_ptr<std::deque<SensorNote>> notes)
      : feed_(std::move(feed)), notes_(std::move(notes)) {}
  VisionStatePtr poll() override { return feed_->poll(); }
  std::optional<SensorNote> note() override {
    if (notes_->empty()) return feed_->note();
    SensorNote first = std::move(notes_->front());
    notes_->pop_front();
    return first;
  }
  std::vector<TrackRow> take_track() override { return feed_->take_track(); }
  void command(VisionCommand command) override { feed_->command(std::move(command)); }
  std::vector<sensor::PackedDepthPtr> last_frames() const override { return feed_->last_frames(); }
  void pause(bool paused) override { feed_->pause(paused); }

 private:
  std::unique_ptr<Feed> feed_;
  std::shared_ptr<std::deque<SensorNote>> notes_;
};

class Bench : public testing::Test {
 protected:
  void SetUp() override {
    auto context = render::EglContext::surfaceless();
    if (!context && std::getenv("SPOOL_REQUIRE_GL") == nullptr) {
      GTEST_SKIP() << context.error().message;
    }
    ASSERT_TRUE(context.has_value());
    context_ = std::make_unique<render::EglContext>(std::move(*context));
  }

  void start(std::vector<Step> steps, int width = 800, int height = 480) {
    ApplicationInputs in;
    in.design = design_;
    in.camera = small_camera();
    in.noise = noise_;
    in.source_text = in.source_description = "scripted";
    in.is_recording = true;
    in.out = folder_.path() / "out";
    in.width = width;
    in.height = height;
    in.wait_for_jobs = wait_for_jobs_;
    in.has_graphics_card = has_graphics_card_;
    in.job = std::move(job_);
    const NoiseModel noise = in.noise;
    in.open_feed = [steps, noise, design = design_,
                    notes = notes_]() -> Result<std::unique_ptr<Feed>> {
      auto feed =
          make_lock_step_feed(std::make_unique<ScriptedSource>(steps, true),
                              FrameProcessor(design, small_camera(), noise, {.stride_px = 1}));
      return std::unique_ptr<Feed>(std::make_unique<NotedFeed>(std::move(feed), notes));
    };
    auto app = Application::create(std::move(in));
    ASSERT_TRUE(app.has_value()) << app.error().message;
    app_ = std::move(*app);
    step();
  }

  // One frame of sensor and screen.
  void step(const std::vector<ui::TouchEvent>& events = {},
            const std::vector<ui::KeyPress>& keys = {}) {
    now_ += app_->advance().value_or(1.0 / 30);
    const Status drawn = app_->frame(now_, events, keys);
    ASSERT_TRUE(drawn.has_value()) << drawn.error().message;
    if (const std::string line = app_->changed_targets(); !line.empty()) {
      screen_ = nlohmann::json::parse(line);
    }
  }
  void play_to_the_end() {
    for (int i = 0; i < 1000 && !app_->source_has_ended(); ++i) step();
    ASSERT_TRUE(app_->source_has_ended());
  }
  void tap_at(const Spot& spot) {
    step(tap(spot));
    for (int i = 0; i < 3; ++i) step();
  }
  void press(const std::string& name) {
    const auto spot = target(screen_, name);
    ASSERT_TRUE(spot.has_value()) << name << " is not on the screen: " << screen_.dump();
    tap_at(*spot);
  }
  [[nodiscard]] bool offers(const std::string& name) const {
    return target(screen_, name).has_value();
  }

  // Where three well-chosen points stand on the screen now.
  [[nodiscard]] std::vector<SpotPair> three() const {
    const auto frame = render_frame(*prepared_bracket(), T_design_camera(), 0);
    return choose_three(screen_, *prepared_bracket(), small_camera(), *frame, T_design_camera());
  }
  void pick(const SpotPair& pair) {
    tap_at(pair.design);
    tap_at(pair.scan);
  }
  void pick_three() {
    const auto pairs = three();
    ASSERT_EQ(pairs.size(), 3U);
    for (const SpotPair& pair : pairs) pick(pair);
  }

  TemporaryFolder folder_;
  std::shared_ptr<const PreparedDesign> design_ = prepared_bracket();
  bool wait_for_jobs_ = true;
  bool has_graphics_card_ = false;
  NoiseModel noise_{.constant_m = 0.0008};
  std::unique_ptr<JobSession> job_;  // of design_; start() takes it
  std::shared_ptr<std::deque<SensorNote>> notes_ = std::make_shared<std::deque<SensorNote>>();
  std::unique_ptr<render::EglContext> context_;
  std::unique_ptr<Application> app_;  // goes before its context
  nlohmann::json screen_;
  double now_ = 0;
};

}  // namespace spool::test
