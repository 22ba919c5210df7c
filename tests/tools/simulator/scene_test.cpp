// Scenes: what is read, what is refused, how the camera moves.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/scene.h"

#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/support/shared_data.h"
#include "tests/tools/simulator/test_scene.h"
#include "tools/simulator/trajectory.h"

namespace spool::simulator {
namespace {

TEST(Scene, RefusesWhatItDoesNotUnderstandByKey) {
  struct Case {
    const char* json;
    const char* says;
  };
  const Case cases[] = {
      {R"("colour": "red")", "colour"},
      {R"("clutter": [{"kind": "sphere"}])", "clutter[0].kind"},
      {R"("clutter": [{"kind": "box", "size_m": [1, 2]}])", "size_m"},
      {R"("clutter": [{"kind": "box", "size_m": [1, 2, -1]}])", "size_m"},
      {R"("clutter": [{"kind": "box", "size_m": [1, 2, 1e300]}])", "size_m"},
      {R"("clutter": 7)", "clutter"},
      {R"("sensor": {"width": 1e9})", "sensor.width"},
      {R"("sensor": {"noise": "loud"})", "sensor.noise"},
      {R"("sensor": {"depth_unit_m": 0.0005})", "sensor.depth_unit_m"},
      {R"("unplug": [{"at_s": -1}])", "unplug[0].at_s"},
      {R"("as_built": [{"translation_m": [0, 0, 1]}])", "as_built[0].part"},
      {R"("T_map_design": [1, 2, 3])", "T_map_design"},
      {"", "the scene is empty"},
  };
  for (const Case& one : cases) {
    SCOPED_TRACE(one.json);
    test::expect_refused(open_scene(one.json), ErrorCode::kBadInput, "scene", one.says);
  }
  // Here the file at fault is the design.
  test::expect_refused(open_scene(R"("design": "no_such.glb")"), ErrorCode::kBadInput,
                       "no_such.glb", "cannot be opened");
}

TEST(Scene, OfTheSampleOpensAndShowsTheSpool) {
  const auto simulator = Simulator::open(test::source_dir() / "assets" / "sample" / "scene.json");
  ASSERT_TRUE(simulator) << simulator.error().message;
  const IdealImage image = simulator->ideal(30);
  const auto on_spool =
      std::count_if(image.part.begin(), image.part.end(), [](int p) { return p >= 0; });
  EXPECT_GT(on_spool, 20000);
}

TEST(Trajectory, IsHeldByAHand) {
  const Trajectory trajectory;  // the default: 0.6 to 1.2 m round the spool
  const Eigen::Vector3d centre(0.1, -0.2, 0.8);
  double fastest = 0;
  for (int n = 0; n < 1200; ++n) {
    const Pose a = camera_pose(trajectory, centre, n / 30.0);
    const Pose b = camera_pose(trajectory, centre, (n + 1) / 30.0);
    EXPECT_NEAR((a.linear().transpose() * a.linear() - Eigen::Matrix3d::Identity()).norm(), 0,
                1e-9);
    const double distance = (a.translation() - centre).norm();
    EXPECT_GT(distance, 0.6 - 0.03);  // tremor's few standard deviations of 4 mm
    EXPECT_LT(distance, 1.2 + 0.03);
    const Eigen::Vector3d seen = a.inverse() * centre;
    EXPECT_LT(std::hypot(seen.x(), seen.y()) / seen.z(), 0.1) << "it looks at the spool";
    EXPECT_GT((a.linear() * Eigen::Vector3d(0, -1, 0)).z(), 0) << "the image's up is up";
    const PoseSize step = pose_size(a.inverse() * b);
    fastest = std::max(fastest, step.translation_m * 30);
    EXPECT_LT(step.rotation_rad, 0.04) << "smooth";
  }
  EXPECT_GT(fastest, 0.05);
  EXPECT_LT(fastest, 0.6);  // m/s
}

TEST(Trajectory, IsTheSameForTheSameSeed) {
  Trajectory trajectory;
  const auto at = [&] { return camera_pose(trajectory, Eigen::Vector3d::Zero(), 3.7).matrix(); };
  const Eigen::Matrix4d first = at();
  EXPECT_EQ(first, at());
  trajectory.seed = 2;
  EXPECT_NE(first, at());
}

}  // namespace
}  // namespace spool::simulator
