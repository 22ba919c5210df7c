// Pictures of the Work screen, good, poor and lost, against those kept; numbers asserted beside.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/application/application.h"
#include "tests/app/application/robot_fitter.h"
#include "tests/app/e2e/sample_files.h"
#include "tests/render/gl_test.h"
#include "tests/render/golden.h"
#include "tests/support/temporary_folder.h"
#include "vision/inspect/facing.h"

namespace spool {
namespace {

constexpr int kWidth = 800, kHeight = 480;

// States that are known beforehand, so that the pictures are of the screen and not of the tracker.
class PreparedFeed final : public Feed {
 public:
  explicit PreparedFeed(std::shared_ptr<std::deque<VisionStatePtr>> states)
      : states_(std::move(states)) {}
  // The first one stays until it is aligned.
  VisionStatePtr poll() override {
    if (states_->empty() || (is_held_ && is_shown_)) return nullptr;
    is_shown_ = true;
    VisionStatePtr next = states_->front();
    states_->pop_front();
    return next;
  }
  std::optional<SensorNote> note() override { return std::nullopt; }
  std::vector<TrackRow> take_track() override { return {}; }
  void command(VisionCommand /*command*/) override { is_held_ = false; }
  std::vector<sensor::PackedDepthPtr> last_frames() const override { return {}; }
  void pause(bool /*paused*/) override {}

 private:
  std::shared_ptr<std::deque<VisionStatePtr>> states_;
  bool is_held_ = true, is_shown_ = false;
};

// The sample's frame as the live path thins it, not aligned.
VisionState unaligned(const test::SampleFiles& sample, std::size_t frame) {
  FrameProcessor vision(sample.prepared, sample.camera, NoiseModel{});
  const auto state = vision.process(sample.frames[frame]);
  EXPECT_TRUE(state.has_value());
  VisionState out;
  out.revision = frame + 1;
  out.frame = (*state)->frame;
  out.scan = (*state)->scan;
  out.stride_px = (*state)->stride_px;
  return out;
}

// The same at its true pose, measured there.
VisionState measured(const test::SampleFiles& sample, std::size_t frame) {
  VisionState state = unaligned(sample, frame);
  const DesignSurface& surface = *sample.prepared->surface;
  state.revision += 1000;  // another state than the one without a pose
  state.alignment = 1;
  state.quality = TrackQuality::kGood;
  state.T_design_camera = sample.T_design_camera[frame];
  state.T_design_camera.translation() -= sample.prepared->model.origin;
  state.point_noise_m = 0.0012;
  state.agreement = 1;
  state.scan_design = moved(state.scan, state.T_design_camera);
  state.classes.assign(state.scan_design.size(), PointClass::kObject);
  state.deviations = measure_deviations(state.scan_design, state.classes, surface, 0.03F);
  drop_turned_away(state.scan_design, state.T_design_camera.translation(), surface,
                   static_cast<float>(3 * state.point_noise_m), state.classes, state.deviations);
  // One frame in place of many, and a doubt that is simply said.
  for (const PartDeviation& part :
       summarise_parts(sample.prepared->model, state.scan_design, state.classes, state.deviations,
                       sample.prepared->samples))
    state.coverage.parts.push_back({part.points > 0, part.mean_m, 0.0008, part.coverage});
  return state;
}

// Pixels of a clear red or blue: steel that is not where the drawing wants it.
std::size_t coloured(const render::Image& image, const ui::Rect& within) {
  std::size_t count = 0;
  for (int y = static_cast<int>(within.y); y < within.y + within.height; ++y)
    for (int x = static_cast<int>(within.x); x < within.x + within.width; ++x) {
      const std::uint8_t* p = image.pixel(x, y);
      count += std::abs(p[0] - p[2]) > 60 ? 1U : 0U;
    }
  return count;
}

class WorkGolden : public test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    ASSERT_TRUE(sample_.prepared);
  }
  void TearDown() override {
    app_.reset();
    GlTest::TearDown();
  }

  void step(const std::vector<ui::TouchEvent>& events = {}) {
    now_s_ += 0.1;
    static_cast<void>(app_->advance());
    const Status drawn = app_->frame(now_s_, events);
    ASSERT_TRUE(drawn.has_value()) << drawn.error().message;
    if (const std::string line = app_->changed_targets(); !line.empty())
      screen_ = nlohmann::json::parse(line);
  }
  void tap(const test::Spot& spot) {
    step(test::tap(spot));
    for (int i = 0; i < 3; ++i) step();
  }

  // The Work screen of the last of the states, a while after it came.
  render::Image draw(const std::vector<VisionState>& states) {
    auto queue = std::make_shared<std::deque<VisionStatePtr>>();
    queue->push_back(std::make_shared<VisionState>(unaligned(sample_, kFrame)));
    for (const VisionState& state : states) queue->push_back(std::make_shared<VisionState>(state));
    ApplicationInputs in;
    in.design = sample_.prepared;
    in.camera = sample_.camera;
    in.source_text = in.source_description = "sample recording";
    in.is_recording = true;
    in.out = folder_.path();
    in.width = kWidth;
    in.height = kHeight;
    in.wait_for_jobs = true;
    in.open_feed = [queue]() -> Result<std::unique_ptr<Feed>> {
      return std::unique_ptr<Feed>(std::make_unique<PreparedFeed>(queue));
    };
    auto app = Application::create(std::move(in));
    EXPECT_TRUE(app.has_value()) << app.error().message;
    app_ = std::move(*app);
    step();
    for (const test::SpotPair& pair :
         test::choose_three(screen_, *sample_.prepared, sample_.camera, *sample_.frames[kFrame],
                            states.front().T_design_camera)) {
      tap(pair.design);
      tap(pair.scan);
    }
    const auto done = test::target(screen_, "Done");
    EXPECT_TRUE(done.has_value()) << screen_.dump();
    if (done) tap(*done);
    now_s_ += 60;  // what was said on the way is gone
    while (!queue->empty()) step();
    step();
    EXPECT_EQ(screen_["screen"], "work") << screen_.dump();
    return app_->picture().target().read();
  }
  // The steel, without panels, legend and the still.
  [[nodiscard]] static ui::Rect steel() { return {260, 60, 420, 270}; }

  static constexpr std::size_t kFrame = 20, kLost = 2;
  test::SampleFiles sample_ = test::read_sample();
  test::TemporaryFolder folder_;
  std::unique_ptr<Application> app_;
  nlohmann::json screen_;
  double now_s_ = 0;
};

TEST_F(WorkGolden, Good) {
  const render::Image image = draw({measured(sample_, kFrame)});
  EXPECT_EQ(screen_["tracking"], "good");
  EXPECT_TRUE(test::target(screen_, "Check").has_value());
  EXPECT_GT(coloured(image, steel()), 500U);  // its one end is 11 mm off
  test::expect_golden("work_good", image);
}

TEST_F(WorkGolden, Poor) {
  VisionState poor = measured(sample_, kFrame);
  poor.quality = TrackQuality::kPoor;
  poor.hint = "Unsure: look where a flange or an elbow is seen too.";
  const render::Image image = draw({poor});
  EXPECT_EQ(screen_["tracking"], "poor");
  EXPECT_EQ(screen_["hint"], poor.hint);
  EXPECT_GT(coloured(image, steel()), 500U);
  test::expect_golden("work_poor", image);
}

TEST_F(WorkGolden, Lost) {
  VisionState lost = unaligned(sample_, kLost);
  lost.alignment = 1;
  lost.quality = TrackQuality::kLost;
  lost.hint = "Lost: hold still and look where it was last seen.";
  const render::Image image = draw({measured(sample_, kFrame), lost});
  EXPECT_EQ(screen_["tracking"], "lost");
  EXPECT_TRUE(screen_.contains("still"));
  EXPECT_FALSE(test::target(screen_, "Check").has_value());
  EXPECT_EQ(coloured(image, steel()), 0U) << "no overlay at a pose that is not believed";
  test::expect_golden("work_lost", image);
}

}  // namespace
}  // namespace spool
