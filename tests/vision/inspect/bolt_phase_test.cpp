// A flange's turn is told by its bolt holes, by them alone, and with an uncertainty that is true.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/bolt_phase.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/shared_data.h"
#include "vision/design/design_reader.h"
#include "vision/design/design_surface.h"

namespace spool {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kFrame_s = 0.1;
const BoltHoles kHoles{4, 0.12, 0.3};

// What a ring shows whose holes, a fifth of the pitch each, are turned by so much. A hole's edge
// moves by `shake_rad` from look to look.
struct Ring {
  std::mt19937 random{3};
  BoltHoles holes = kHoles;
  double shake_rad = 0.5 * kDegree;
  double from_rad = 0, to_rad = 2 * std::numbers::pi;  // the part that is seen

  BoltLook look(double turn_rad) {
    std::normal_distribution<double> shake(0, shake_rad);
    const double phase = holes.clocking_rad + turn_rad + shake(random);
    const double pitch = 2 * std::numbers::pi / holes.count;
    BoltLook look;
    look.bins.resize(static_cast<std::size_t>(16 * holes.count));
    look.pixel_m = 0.0012;
    std::uniform_real_distribution<double> anywhere(from_rad, to_rad);
    for (int i = 0; i < 600; ++i) {
      const double angle = anywhere(random);
      const double off = std::abs(std::remainder(angle - phase, pitch));
      RingBin& bin = look.bins[static_cast<std::size_t>(angle / (2 * std::numbers::pi) *
                                                        static_cast<double>(look.bins.size()))];
      bin.seen += 1;
      bin.through += off < 0.1 * pitch ? 1.0F : 0.0F;
    }
    return look;
  }
};

BoltPhase seen(Ring& ring, double turn_rad, int frames) {
  BoltPhase phase(ring.holes, {});
  for (int i = 0; i < frames; ++i) phase.add(ring.look(turn_rad), kFrame_s);
  return phase;
}

class Turned : public testing::TestWithParam<double> {};

TEST_P(Turned, IsToldWithinItsUncertainty) {
  const double turn = GetParam() * kDegree;
  for (const int count : {4, 8, 12}) {
    SCOPED_TRACE(count);
    Ring ring;
    ring.holes.count = count;
    // Half a pitch further the holes are where others were.
    if (std::abs(turn) > 0.8 * std::numbers::pi / count) continue;
    const auto told = seen(ring, turn, 30).turn();
    ASSERT_TRUE(told);
    EXPECT_NEAR(told->turn_rad, turn, 3 * told->sigma_rad);
    EXPECT_LT(told->sigma_rad, 0.5 * kDegree);
    EXPECT_GT(told->sigma_rad, 0.0003 / 0.0601) << "edges err together by a quarter of a pixel";
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, Turned, testing::Values(0.0, 1.0, -4.0, 11.0, 30.0));

TEST(BoltPhase, ScattersAsItSays) {
  double squares = 0;
  constexpr int kRuns = 40;
  for (int run = 0; run < kRuns; ++run) {
    Ring ring;
    ring.random.seed(static_cast<unsigned>(100 + run));
    ring.shake_rad = 4 * kDegree;
    BoltPhase phase(ring.holes, {.bias_px = 0});
    for (int i = 0; i < 30; ++i) phase.add(ring.look(0), 0.4);
    const auto told = phase.turn();
    ASSERT_TRUE(told);
    squares += std::pow(told->turn_rad / told->sigma_rad, 2);
  }
  // Chi-squared of 40: 20 to 66 in all but one of a thousand, and Student's spread besides.
  EXPECT_GT(squares / kRuns, 0.5);
  EXPECT_LT(squares / kRuns, 1.8);
}

TEST(BoltPhase, GoesWithTheScan) {
  Ring ring;
  BoltPhase phase(ring.holes, {});
  for (int i = 0; i < 20; ++i) phase.add(ring.look(5 * kDegree), kFrame_s);
  phase.follow(-5 * kDegree);
  EXPECT_NEAR(phase.turn()->turn_rad, 0, 0.5 * kDegree);
  for (int i = 0; i < 20; ++i) phase.add(ring.look(0), kFrame_s);
  ASSERT_TRUE(phase.turn());
  EXPECT_NEAR(phase.turn()->turn_rad, 0, 0.5 * kDegree);
  phase.clear();
  EXPECT_FALSE(phase.turn());
}

TEST(BoltPhase, SaysNothingOfOneLook) {
  Ring ring;
  BoltPhase phase(ring.holes, {});
  for (int i = 0; i < 8; ++i) phase.add(ring.look(0), 0.01);
  EXPECT_FALSE(phase.turn());
}

TEST(BoltPhase, SaysNothingOfTwoHoles) {
  Ring ring;
  ring.to_rad = std::numbers::pi;
  EXPECT_FALSE(seen(ring, 0, 40).turn());
}

// A ring that hangs over the rim on one side looks through there, and a blind one nowhere.
TEST(BoltPhase, TakesNoEdgeForHoles) {
  for (const double width : {0.0, 0.5, 1.0, 2.0, 3.0}) {
    SCOPED_TRACE(width);
    Ring ring;
    BoltPhase phase(ring.holes, {});
    for (int i = 0; i < 40; ++i) {
      BoltLook look = ring.look(0);
      const auto bins = static_cast<double>(look.bins.size());
      for (std::size_t b = 0; b < look.bins.size(); ++b)
        look.bins[b].through =
            static_cast<double>(b) < width / (2 * std::numbers::pi) * bins ? look.bins[b].seen : 0;
      phase.add(look, kFrame_s);
    }
    EXPECT_FALSE(phase.turn());
  }
}

// The sample's first flange, turned, as rays of a depth camera meet it.
class SampleFlange : public testing::Test {
 protected:
  static const DesignModel& design() {
    static const DesignModel model =
        *read_design((test::source_dir() / "assets/sample/spool.glb").string());
    return model;
  }
  static int flange() { return design().datums.front(); }

  // The camera looks at the face from `distance_m`, `slant_rad` off its axis.
  static Pose camera_at(double distance_m, double slant_rad) {
    const Part& part = design().parts[static_cast<std::size_t>(flange())];
    const auto face = std::find_if(part.ports.begin(), part.ports.end(),
                                   [](const Port& port) { return port.end == EndType::kFlanged; });
    EXPECT_NE(face, part.ports.end());
    const Vector3d middle = part.T_design_part * face->position;
    const Vector3d out = part.T_design_part.linear() * face->direction;
    const Vector3d aside = part.T_design_part.linear().col(0);
    const Vector3d to_eye = std::cos(slant_rad) * out + std::sin(slant_rad) * aside;
    Pose T = Pose::Identity();
    const Vector3d x = out.cross(aside).normalized();
    T.linear() << x, -to_eye.cross(x), -to_eye;
    T.translation() = middle + distance_m * to_eye;
    return T;
  }

  // The frame of a camera at T_design_camera that sees the spool turned about the flange's axis.
  static DepthFrame frame_of(const Pose& T_design_camera, double turn_rad, unsigned seed) {
    static const DesignSurface surface = std::move(*DesignSurface::build(design()));
    const Part& part = design().parts[static_cast<std::size_t>(flange())];
    const Vector3d centre = part.T_design_part.translation();
    Pose back = Pose::Identity();
    back.linear() =
        Eigen::AngleAxisd(-turn_rad, part.T_design_part.linear().col(2)).toRotationMatrix();
    back.translation() = centre - back.linear() * centre;
    const Pose T = back * T_design_camera;
    std::mt19937 random{seed};
    std::normal_distribution<double> noise(0, 0.0015);
    DepthFrame frame;
    frame.width = kCamera.width;
    frame.height = kCamera.height;
    frame.depth.assign(static_cast<std::size_t>(frame.width * frame.height), 0);
    for (int v = 0; v < frame.height; ++v)
      for (int u = 0; u < frame.width; ++u) {
        const Vector3d ray = kCamera.back_project(u, v, 1);
        const auto hit = surface.cast(T.translation().cast<float>(),
                                      (T.linear() * ray.normalized()).cast<float>(), 5.0F);
        const double z = hit ? double{hit->distance} / ray.norm() : 2.0;  // a wall behind
        frame.depth[static_cast<std::size_t>(v * frame.width + u)] =
            static_cast<std::uint16_t>(std::lround(1000 * (z + noise(random))));
      }
    return frame;
  }

  static constexpr int kFrames = 6;
  static std::optional<BoltTurn> turn_seen(double distance_m, double slant_rad, double turn_rad) {
    const auto ring = BoltRing::of(design(), flange());
    EXPECT_TRUE(ring);
    BoltPhase phase(ring->holes(), {});
    for (int i = 0; i < kFrames; ++i) {
      const Pose T = camera_at(distance_m + 0.004 * i, slant_rad + 0.01 * i);
      const auto look = ring->read(frame_of(T, turn_rad, static_cast<unsigned>(i)), kCamera, {}, T);
      if (look) phase.add(*look, 0.4);
    }
    return phase.turn();
  }

  inline static const Camera kCamera{640, 480, 570, 570, 319.5, 239.5, 0.001, {}};
};

TEST_F(SampleFlange, IsReadFromDepthFrames) {
  for (const double turn : {0.0, 3.0, -7.0})
    for (const double slant : {0.1, 0.5, 0.9}) {
      SCOPED_TRACE(testing::Message() << turn << " degrees, seen at " << slant);
      const auto told = turn_seen(0.7, slant, turn * kDegree);
      ASSERT_TRUE(told);
      EXPECT_NEAR(told->turn_rad / kDegree, turn, 0.6);
      EXPECT_NEAR(told->turn_rad, turn * kDegree, 3 * told->sigma_rad);
    }
}

TEST_F(SampleFlange, IsNotReadEdgeOnNorFromAfarNorFromAPicture) {
  EXPECT_FALSE(turn_seen(0.7, 1.4, 0));
  const auto ring = BoltRing::of(design(), flange());
  const Pose T = camera_at(0.7, 0.2);
  DepthFrame blank = frame_of(T, 0, 1);
  std::fill(blank.depth.begin(), blank.depth.end(), std::uint16_t{0});
  EXPECT_FALSE(ring->read(blank, kCamera, {}, T)) << "nothing measured";
  std::fill(blank.depth.begin(), blank.depth.end(), std::uint16_t{400});
  EXPECT_FALSE(ring->read(blank, kCamera, {}, T)) << "a board before it";
  const Pose away = T * Eigen::Translation3d(2, 0, 0);
  EXPECT_FALSE(ring->read(frame_of(away, 0, 1), kCamera, {}, away)) << "beside the picture";
}

TEST_F(SampleFlange, APartWithoutHolesHasNoRing) {
  for (std::size_t p = 0; p < design().parts.size(); ++p)
    EXPECT_EQ(BoltRing::of(design(), static_cast<int>(p)).has_value(),
              design().parts[p].kind == PartKind::kFlange);
  DesignModel none = design();
  none.parts[static_cast<std::size_t>(flange())].triangle_count = 0;
  EXPECT_FALSE(BoltRing::of(none, flange()));
}

}  // namespace
}  // namespace spool
