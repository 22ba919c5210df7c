// Claims about the agreement of expected surface and measured depth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/surface_agreement.h"

#include <gtest/gtest.h>

#include "tests/app/runner/simulated_scene.h"

namespace spool {
namespace {

constexpr double kGate = 0.01;  // m: the slant of a surface across a pixel of 6 mm, and the noise

SurfaceAgreement agreement_of(const DepthFrame& frame) {
  return surface_agreement(test::prepared_bracket()->samples, *test::prepared_bracket()->surface,
                           frame, test::small_camera(), test::T_design_camera(), kGate);
}

DepthFrame true_frame() {
  return *test::render_frame(*test::prepared_bracket(), test::T_design_camera(), 0);
}

TEST(SurfaceAgreement, IsNearlyWholeAtTheTruePose) {
  const SurfaceAgreement agreement = agreement_of(true_frame());
  EXPECT_GT(agreement.seen, 200U);
  EXPECT_GT(agreement.share(), 0.9);  // the rest are samples on edges, seen past by half a pixel
}

TEST(SurfaceAgreement, IsNothingOverAnEmptyFloor) {
  const SurfaceAgreement agreement = agreement_of(*test::empty_frame(test::T_design_camera(), 0));
  EXPECT_LT(agreement.share(), 0.05);
  EXPECT_GT(agreement.seen_through, 200U);
}

TEST(SurfaceAgreement, CountsWhatAHandHidesAsHidden) {
  DepthFrame frame = true_frame();
  for (std::uint16_t& depth : frame.depth) depth = 300;  // a hand 0.3 m before the whole picture
  const SurfaceAgreement agreement = agreement_of(frame);
  EXPECT_EQ(agreement.seen, 0U);
  EXPECT_EQ(agreement.seen_through, 0U);
  EXPECT_GT(agreement.hidden, 200U);
}

TEST(SurfaceAgreement, CountsMissingDepthAsUnmeasured) {
  DepthFrame frame = true_frame();
  for (std::uint16_t& depth : frame.depth) depth = 0;
  const SurfaceAgreement agreement = agreement_of(frame);
  EXPECT_EQ(agreement.share(), 0.0);
  EXPECT_GT(agreement.unmeasured, 200U);
}

}  // namespace
}  // namespace spool
