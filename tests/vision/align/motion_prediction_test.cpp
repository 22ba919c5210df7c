// Motion prediction: standing still is always one of the guesses, moving on another.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/motion_prediction.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace spool {
namespace {

Pose screw(double seconds) {
  Vector6d motion;
  motion << 0.3 * seconds, -0.1 * seconds, 0, 0, 0, 0;
  Pose pose = pose_from_small(motion);
  pose.rotate(Eigen::AngleAxisd(0.5 * seconds, Eigen::Vector3d::UnitX()));
  return pose;
}

TEST(MotionPrediction, StandsStillAtFirst) {
  MotionPrediction motion;
  EXPECT_FALSE(motion.is_known());
  motion.follow(screw(1), 0.1);
  const std::vector<Pose> guesses = motion.guesses(0.1);
  ASSERT_EQ(guesses.size(), 1U);
  EXPECT_TRUE(guesses[0].isApprox(screw(1), 1e-12));
}

TEST(MotionPrediction, GuessesWhatMovesOnAndWhatStops) {
  MotionPrediction motion;
  motion.follow(screw(0), 0.1);
  motion.follow(screw(0.1), 0.1);
  const std::vector<Pose> guesses = motion.guesses(0.2);
  ASSERT_EQ(guesses.size(), 3U);
  EXPECT_TRUE(guesses[0].isApprox(screw(0.1), 1e-12));
  // In a straight line instead of the screw: 5 mm of 60 in the second it takes to turn by 0.1 rad.
  EXPECT_LT(pose_size(guesses[2].inverse() * screw(0.3)).translation_m, 0.005);
  EXPECT_LT(pose_size(guesses[2].inverse() * screw(0.3)).rotation_rad, 1e-9);
  EXPECT_LT(pose_size(guesses[1].inverse() * screw(0.2)).translation_m, 0.003);
  motion.stop();
  EXPECT_EQ(motion.guesses(0.2).size(), 1U);
}

TEST(MotionPrediction, HasAGuessNearATremorAtAnyTimeOfIt) {
  // 5 mm at 8 Hz, the fastest that hands do, filmed at 30 frames a second.
  const auto at = [](int frame) {
    return 0.005 * std::sin(2 * std::numbers::pi * 8 * frame / 30.0);
  };
  MotionPrediction motion;
  double worst_of_best = 0, worst_straight = 0;
  for (int i = 0; i < 30; ++i) {
    Pose now = Pose::Identity();
    now.translation().x() = at(i);
    if (i > 1) {
      const std::vector<Pose> guesses = motion.guesses(1 / 30.0);
      double best = 1;
      for (const Pose& guess : guesses)
        best = std::min(best, std::abs(guess.translation().x() - at(i)));
      worst_of_best = std::max(worst_of_best, best);
      worst_straight = std::max(worst_straight, std::abs(guesses.back().translation().x() - at(i)));
    }
    motion.follow(now, 1 / 30.0);
  }
  // Standing still is off by 2 sin(pi f / rate) = 1.49 amplitudes, a constant velocity by the
  // square of that, 2.21.
  EXPECT_LT(worst_of_best, 0.0075);
  EXPECT_GT(worst_straight, 0.0108);
}

TEST(MotionPrediction, IsLessSureTheLongerItHasToGuess) {
  const Matrix6d at_30 = MotionPrediction::covariance(1 / 30.0);
  const Matrix6d at_5 = MotionPrediction::covariance(1 / 5.0);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(at_5(i, i) / at_30(i, i), 36, 1e-9);
}

}  // namespace
}  // namespace spool
