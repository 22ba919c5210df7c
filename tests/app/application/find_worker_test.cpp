// The thread of the search: answers, cancels and ends at any moment.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/find_worker.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

#include <gtest/gtest.h>

#include "tests/app/runner/simulated_scene.h"
#include "tests/support/cancelling.h"
#include "vision/live/frame_processor.h"

namespace spool {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

NoiseModel noise() {
  NoiseModel model;
  model.constant_m = 0.0008;
  return model;
}

VisionStatePtr picture(const std::shared_ptr<const DepthFrame>& frame) {
  FrameProcessor vision(test::prepared_bracket(), test::small_camera(), noise(), {.stride_px = 1});
  auto state = vision.process(frame);
  return state ? *state : nullptr;
}
VisionStatePtr with_bracket() {
  return picture(test::render_frame(*test::prepared_bracket(), test::T_design_camera(), 0));
}
VisionStatePtr without_bracket() { return picture(test::empty_frame(test::T_design_camera(), 0)); }

std::unique_ptr<FindWorker> worker() {
  return std::make_unique<FindWorker>(test::prepared_bracket(), test::small_camera(), noise());
}

TEST(FindWorker, FindsThePoseAndSaysHowFarItIs) {
  const auto finder = worker();
  finder->start(with_bracket());
  std::vector<FindProgress> said;
  std::optional<FindAnswer> answer;
  const auto deadline = Clock::now() + std::chrono::seconds(120);
  while (!answer && Clock::now() < deadline) {
    if (const auto progress = finder->progress()) said.push_back(*progress);
    answer = finder->take();
    std::this_thread::sleep_for(milliseconds(1));
  }
  ASSERT_TRUE(answer.has_value());
  ASSERT_EQ(answer->poses.size(), 1U) << answer->reason;
  const PoseSize error =
      pose_size(test::T_design_camera().inverse() * answer->poses[0]->T_design_camera);
  EXPECT_LT(error.translation_m, 0.0015);  // as three picks on such a frame
  EXPECT_LT(error.rotation_rad, 0.004);
  ASSERT_FALSE(said.empty());
  EXPECT_EQ(said.front().stage, "prepare");
  for (const FindProgress& progress : said) EXPECT_LE(progress.share, 1.0);
  EXPECT_TRUE(std::is_sorted(said.begin(), said.end(),
                             [](const auto& a, const auto& b) { return a.share < b.share; }));
  EXPECT_FALSE(finder->take().has_value()) << "one answer";

  finder->start(with_bracket());  // the design is ready now
  finder->wait();
  const auto progress = finder->progress();
  ASSERT_TRUE(progress.has_value());
  EXPECT_NE(progress->stage, "prepare");
  EXPECT_TRUE(finder->take().has_value());
}

TEST(FindWorker, SaysWhyNothingWasFound) {
  const auto finder = worker();
  finder->start(without_bracket());
  finder->wait();
  const auto answer = finder->take();
  ASSERT_TRUE(answer.has_value());
  EXPECT_TRUE(answer->poses.empty());
  EXPECT_FALSE(answer->reason.empty());
}

// How long (s) the thread stays busy after a cancel `after_ms` into a search: the least of a few
// tries, since other programs may hold the cores.
double busy_after_cancel_s(int after_ms, const VisionStatePtr& seen) {
  double least = 1e9;
  for (int i = 0; i < 5 && least > test::kObeyed_s; ++i) {
    const auto finder = worker();
    finder->start(seen);
    std::this_thread::sleep_for(milliseconds(after_ms));
    const auto asked = Clock::now();
    finder->cancel();
    finder->wait();
    least = std::min(least, std::chrono::duration<double>(Clock::now() - asked).count());
    EXPECT_FALSE(finder->take().has_value()) << "nobody waits for it any more";
  }
  return least;
}

TEST(FindWorker, CancelFreesTheThreadWithinATenthOfASecond) {
  const VisionStatePtr seen = without_bracket();  // the longest search
  for (const int after_ms : {0, 40, 150, 300, 500, 900})
    EXPECT_LT(busy_after_cancel_s(after_ms, seen), test::kObeyed_s) << after_ms << " ms into it";
}

TEST(FindWorker, CancelReturnsAtOnce) {
  const auto finder = worker();
  finder->start(without_bracket());
  std::this_thread::sleep_for(milliseconds(50));
  const auto asked = Clock::now();
  finder->cancel();
  EXPECT_LT(std::chrono::duration<double>(Clock::now() - asked).count(), 0.02);
}

TEST(FindWorker, ASecondSearchTakesThePlaceOfTheFirst) {
  const auto finder = worker();
  finder->start(without_bracket());
  std::this_thread::sleep_for(milliseconds(20));
  finder->start(with_bracket());
  finder->wait();
  const auto answer = finder->take();
  ASSERT_TRUE(answer.has_value());
  EXPECT_EQ(answer->poses.size(), 1U) << "of the second picture";
  EXPECT_FALSE(finder->take().has_value()) << "the first was given up";
}

TEST(FindWorker, AnAnswerThatCameJustBeforeTheCancelIsNotHandedOut) {
  const auto finder = worker();
  finder->start(with_bracket());
  finder->wait();
  finder->cancel();
  EXPECT_FALSE(finder->take().has_value());
  EXPECT_FALSE(finder->progress().has_value());
}

TEST(FindWorker, EndsInTheMiddleOfASearch) {
  const VisionStatePtr seen = without_bracket();
  for (int i = 0; i < 4; ++i) {
    auto finder = worker();
    finder->start(seen);
    std::this_thread::sleep_for(milliseconds(60 * i));
    finder.reset();
  }
  EXPECT_EQ(seen.use_count(), 1) << "nobody keeps the picture";
}

}  // namespace
}  // namespace spool
