// Where parts stand, in the reports; and the ghost of a job's next part on what a report says.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/part_pose_report.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "app/common/json_file.h"
#include "app/evidence/writer.h"
#include "app/job/report_check.h"
#include "tests/app/evidence/json_schema.h"
#include "tests/app/evidence/sample_record.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "tests/vision/measure/three_leg_spool.h"
#include "vision/guide/assembly_order.h"
#include "vision/guide/ghost_pose.h"
#include "vision/measure/part_poses.h"

namespace spool::evidence {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;

PartPose sample_pose() {
  PartPose pose;
  pose.is_measured = true;
  pose.error << 0.004, 0, 0, 0, 2 * kDegree, 0;
  pose.covariance = 1e-6 * Matrix6d::Identity();
  pose.covariance(3, 3) = 1;
  pose.weak = {{Vector6d::Unit(3), 1, "a turn about its axis"}};
  pose.rests_on = {"its axis", "the face of flange_1"};
  pose.datum = "flange_1/face";
  pose.is_off = true;
  return pose;
}

nlohmann::json parsed(const std::string& text) {
  const auto report = parse_json(text, "report.json");
  EXPECT_TRUE(report);
  return report ? *report : nlohmann::json();
}

TEST(PartPoseReport, FollowsTheSchemaAndGivesNullWhereNothingIsKnown) {
  InspectionRecord record = test::sample_record();
  record.inspection.parts[0].pose = sample_pose();
  record.inspection.parts[1].pose.reason = "Not measured: nobody looked.";
  const nlohmann::json report = parsed(report_json(record));
  const auto schema = read_json(test::source_dir() / "assets" / "report.schema.json");
  ASSERT_TRUE(schema);
  for (const auto& violation : test::schema_violations(*schema, report)) ADD_FAILURE() << violation;
  const auto& error = report["parts"][0]["pose_error"];
  EXPECT_EQ(error["translation_m"][0], 0.004);
  EXPECT_EQ(error["covariance"][21], 1);
  EXPECT_EQ(error["weak_directions"][0]["direction"][3], 1);
  EXPECT_EQ(error["weak_directions"][0]["text"], "a turn about its axis");
  EXPECT_TRUE(report["parts"][1]["pose_error"].is_null());
  EXPECT_EQ(report["parts"][1]["pose_error_reason"], "Not measured: nobody looked.");
}

TEST(PartPoseReport, SaysInWordsWhatIsOffAndWhatNobodyKnows) {
  PartPose pose = sample_pose();
  EXPECT_EQ(pose_words(pose, LengthStyle::kMillimetre),
            " It stands 4.0 mm and 2.0° off where the drawing has it, seen from the datum (by its "
            "axis and the face of flange_1). Not observed: a turn about its axis.");
  pose.is_off = false;
  EXPECT_EQ(pose_words(pose, LengthStyle::kMillimetre), "");
  InspectionRecord record = test::sample_record();
  record.inspection.parts[0].pose = sample_pose();
  EXPECT_NE(report_html(record, {}).find("It stands 4.0 mm and 2.0°"), std::string::npos);
}

// The three legs' spool as far as it is put together, features where it was built.
PartFeatures features_of_built(const DesignModel& design, const std::vector<Pose>& T_design_built,
                               int last) {
  PartFeatures features =
      test::features_of_legs(design, test::legs_moved_from(test::kLegParts, Pose::Identity()), 1);
  std::erase_if(features.features, [&](const PartFeature& each) { return each.part > last; });
  for (PartFeature& each : features.features)
    each.T_design_measured =
        T_design_built[static_cast<std::size_t>(each.part)] * each.T_design_nominal;
  return features;
}

guide::BuiltPose built_pose(int part, const job::CheckRecord& check) {
  guide::BuiltPose built{.part = part};
  built.T_design_part = pose_from_row_major(*check.T_design_part).value();
  built.covariance =
      Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(check.covariance->data());
  return built;
}

TEST(PartPoseReport, LetsTheGhostOfTheNextPartFollowAnElbowThatIsTwoDegreesOff) {
  const DesignModel design = test::three_leg_spool();
  // Opened by two degrees about its centre; pipe_2 stands on it, elbow_2 is next.
  const Vector3d centre(0, 0, 0.65);
  Pose motion = Pose::Identity();
  motion.linear() = rotation_from_vector(2 * kDegree * Vector3d::UnitY());
  motion.translation() = centre - motion.linear() * centre;
  const std::vector<Pose> built = test::legs_moved_from(test::kLeg2, motion);
  InspectionRecord record = test::sample_record();
  record.design = test::prepared(design);
  record.inspection.parts.clear();
  const std::vector<PartPose> poses = measure_part_poses(
      design, drawing_of(design), features_of_built(design, built, test::kLeg2), pfi_es3(), 0.0002);
  for (int p = 0; p < test::kLegParts; ++p) {
    PartFinding finding;
    finding.part = p;
    finding.pose = poses[static_cast<std::size_t>(p)];
    record.inspection.parts.push_back(finding);
  }
  const test::TemporaryFolder folder;
  const auto path = test::write_file(folder.path() / "report.json", report_json(record));
  const auto check =
      job::check_from_report(path, design.parts[test::kLeg2], record.design->model.sha256);
  ASSERT_TRUE(check) << check.error().message;
  ASSERT_TRUE(check->T_design_part && check->covariance);

  const std::vector<int> order = guide::propose_order(design);
  const auto steps = guide::assembly_steps(design, order, {});
  const auto step = std::ranges::find(steps, static_cast<int>(test::kElbow2),
                                      [](const auto& each) { return each.part; });
  ASSERT_NE(step, steps.end());
  const auto ghost = guide::ghost_pose(design, *step, {built_pose(test::kLeg2, *check)});
  ASSERT_TRUE(ghost);
  EXPECT_NEAR(ghost->angle_rad, 2 * kDegree, 1e-4);
  // Where the pipe ends now: along it the stop across elbow_1 holds it.
  const Vector3d port(0.65, 0, 0.65);
  EXPECT_LT((ghost->T_design_part * port - motion * port).norm(), 1e-4);
  // That nothing tells how the pipe is turned about itself hides neither.
  EXPECT_GT(ghost->distance_m, 2 * ghost->u_distance_m);
  EXPECT_GT(ghost->angle_rad, 2 * ghost->u_angle_rad);
  EXPECT_LT(ghost->u_distance_m, 0.01);
  // A part of which nothing is known leaves no pose in the check.
  const auto unknown =
      job::check_from_report(path, design.parts[test::kLegFlangeB], record.design->model.sha256);
  ASSERT_TRUE(unknown) << unknown.error().message;
  EXPECT_FALSE(unknown->T_design_part);
  EXPECT_FALSE(unknown->covariance);
}

}  // namespace
}  // namespace spool::evidence
