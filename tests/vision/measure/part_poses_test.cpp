// Tests of where parts stand: as drawn, moved, how sure it is, what is not observed, the datum.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/part_poses.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stop_token>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "tests/vision/measure/holed_spool.h"
#include "tests/vision/measure/three_leg_spool.h"
#include "vision/measure/pose_datum.h"

namespace spool {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kCalibrated = 0.0002;

std::vector<PartPose> poses_of(const DesignModel& design, const PartFeatures& features,
                               double scale_u = kCalibrated) {
  return measure_part_poses(design, drawing_of(design), features, pfi_es3(), scale_u);
}

// The error of every part of a spool built so, the datum aligned: from the features as they would
// be without noise.
std::vector<Vector6d> truth_of(const DesignModel& design, const PartFeatures& features,
                               const std::vector<Pose>& T_design_built) {
  const Drawing drawing = drawing_of(design);
  const FeatureGeometry geometry(design, drawing, features);
  const PoseDatum datum = pose_datum(design, drawing, features, geometry);
  FeatureState built = geometry.nominal();
  for (std::size_t f = 0; f < built.size(); ++f)
    built[f] = T_design_built[static_cast<std::size_t>(features.features[f].part)] * built[f];
  const Pose align =
      datum.T_design_datum(geometry.nominal()) * datum.T_design_datum(built).inverse();
  std::vector<Vector6d> truth;
  for (std::size_t p = 0; p < design.parts.size(); ++p) {
    const Pose& T = design.parts[p].T_design_part;
    const Pose error = T.inverse() * align * T_design_built[p] * T;
    truth.emplace_back();
    truth.back() << error.translation(), rotation_vector(error.linear());
  }
  return truth;
}

// What is left between the truth and what was measured, as the covariance is told (a small motion
// after the error).
Vector6d left_of(const PartPose& pose, const Vector6d& truth) {
  const auto motion = [](const Vector6d& v) {
    Pose T = Pose::Identity();
    T.translation() = v.head<3>();
    T.linear() = rotation_from_vector(v.tail<3>());
    return T;
  };
  const Pose left = motion(pose.error).inverse() * motion(truth);
  Vector6d small;
  small << left.translation(), rotation_vector(left.linear());
  return small;
}

double squared_in_sigmas(const PartPose& pose, const Vector6d& truth) {
  const Vector6d left = left_of(pose, truth);
  return left.dot(pose.covariance.ldlt().solve(left));
}

bool is_weak(const PartPose& pose, const Vector6d& direction) {
  // In the space of what is said to be weak.
  Eigen::MatrixXd space(6, static_cast<Eigen::Index>(pose.weak.size()));
  for (std::size_t w = 0; w < pose.weak.size(); ++w)
    space.col(static_cast<Eigen::Index>(w)) = pose.weak[w].direction;
  const Vector6d unit = direction.normalized();
  if (space.cols() == 0) return false;
  return (unit - space * space.colPivHouseholderQr().solve(unit)).norm() < 0.05;
}

Pose turned(const Vector3d& point, const Vector3d& axis, double degrees) {
  Pose pose = Pose::Identity();
  pose.linear() = rotation_from_vector(axis * degrees * kDegree);
  pose.translation() = point - pose.linear() * point;
  return pose;
}

// Every weld off at random as the trade lets it be: so is what lies beyond it.
std::vector<Pose> badly_welded(const DesignModel& design, std::mt19937& random) {
  std::normal_distribution<double> normal;
  // Half of what PFI ES-3 allows a length of NPS 4 and the alignment of a pipe's end of 114.3 mm
  // (1/32 in across it).
  const double u_m = 0.0015, u_rad = 0.5 * 0.00079375 / 0.1143;
  std::vector<Pose> built(design.parts.size(), Pose::Identity());
  for (const Joint& joint : design.joints) {  // they come in order, from the datum outward
    const Part& a = design.parts[static_cast<std::size_t>(joint.part_a)];
    const Vector3d weld =
        a.T_design_part * a.ports[static_cast<std::size_t>(joint.port_a)].position;
    Vector6d off;
    for (int k = 0; k < 6; ++k) off[k] = normal(random) * (k < 3 ? u_m : u_rad);
    const Eigen::Translation3d to(weld);
    built[static_cast<std::size_t>(joint.part_b)] =
        built[static_cast<std::size_t>(joint.part_a)] * to * pose_from_small(off) * to.inverse();
  }
  return built;
}

std::vector<Pose> as_drawn() { return test::legs_moved_from(test::kLegParts, Pose::Identity()); }

TEST(PartPoses, OfASpoolAsDrawnAreNotOff) {
  const DesignModel design = test::three_leg_spool();
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    const std::vector<PartPose> poses =
        poses_of(design, test::features_of_legs(design, as_drawn(), seed));
    ASSERT_EQ(poses.size(), design.parts.size());
    for (std::size_t p = 0; p < poses.size(); ++p) {
      ASSERT_TRUE(poses[p].is_measured) << design.parts[p].name << poses[p].reason;
      EXPECT_FALSE(poses[p].is_off) << design.parts[p].name << poses[p].error.transpose();
      EXPECT_LT(poses[p].error.head<3>().norm(), 0.003) << design.parts[p].name;
    }
  }
}

TEST(PartPoses, SayWhatTheyRestOnAndWhatIsNotObserved) {
  const DesignModel design = test::three_leg_spool();
  const std::vector<PartPose> poses =
      poses_of(design, test::features_of_legs(design, as_drawn(), 1));
  const auto turn = [](const Vector3d& point, const Vector3d& axis) {
    Vector6d motion;
    motion << point.cross(axis), axis;
    return motion;
  };
  // The parts' frames are the design's. A pipe turns about itself; what stops its slide is a face
  // or an axis across an elbow.
  const PartPose& pipe = poses[test::kLeg2];
  ASSERT_EQ(pipe.weak.size(), 1U);
  EXPECT_TRUE(is_weak(pipe, turn({0, 0, 0.65}, Vector3d::UnitX())));
  EXPECT_EQ(pipe.weak[0].text, "a turn about its axis");
  EXPECT_NEAR(pipe.weak[0].sigma, 1, 0.2);
  EXPECT_EQ(pipe.rests_on,
            (std::vector<std::string>{"its axis", "the axis of pipe_1 across elbow_1",
                                      "the axis of pipe_3 across elbow_2"}));
  // A flange without holes turns in its face.
  const PartPose& flange = poses[test::kLegFlangeB];
  ASSERT_EQ(flange.weak.size(), 1U);
  EXPECT_TRUE(is_weak(flange, turn({0.8, 0, 0.65}, Vector3d::UnitY())));
  EXPECT_EQ(flange.rests_on,
            (std::vector<std::string>{"its face", "the axis of pipe_3, through W6"}));
  // An elbow between two pipes is held by both.
  EXPECT_TRUE(poses[test::kElbow1].weak.empty());
  EXPECT_EQ(poses[test::kElbow1].rests_on,
            (std::vector<std::string>{"the axis of pipe_1, through W2",
                                      "the axis of pipe_2, through W3"}));
}

TEST(PartPoses, OfWhatHasOnlyOneNeighbourAreOpenAlongAndAboutIt) {
  const DesignModel design = test::three_leg_spool();
  PartFeatures features = test::features_of_legs(design, as_drawn(), 1);
  // Nothing beyond elbow_2 was seen: it slides along and turns about pipe_2.
  std::erase_if(features.features,
                [](const PartFeature& each) { return each.part > test::kElbow2; });
  const std::vector<PartPose> poses = poses_of(design, features);
  const PartPose& elbow = poses[test::kElbow2];
  ASSERT_TRUE(elbow.is_measured);
  ASSERT_EQ(elbow.weak.size(), 2U);
  EXPECT_EQ(elbow.weak[0].text, "a slide along the axis of pipe_2");
  EXPECT_EQ(elbow.weak[1].text, "a turn about the axis of pipe_2");
  EXPECT_TRUE(is_weak(elbow, Vector6d::Unit(0)));
  EXPECT_FALSE(poses[test::kLegFlangeB].is_measured);
  EXPECT_NE(poses[test::kLegFlangeB].reason.find("Not measured"), std::string::npos);
}

TEST(PartPoses, WithoutADatumAreNotMeasured) {
  const DesignModel design = test::three_leg_spool();
  PartFeatures features = test::features_of_legs(design, as_drawn(), 1);
  std::erase_if(features.features,
                [](const PartFeature& each) { return each.part == test::kLegFlangeA; });
  for (const PartPose& pose : poses_of(design, features)) {
    EXPECT_FALSE(pose.is_measured);
    EXPECT_NE(pose.reason.find("datum was not measured"), std::string::npos) << pose.reason;
  }
}

TEST(PartPoses, WithoutAnythingThatHoldsTheDatumsTurnSaySoOfEveryPart) {
  const DesignModel design = test::three_leg_spool();
  PartFeatures features = test::features_of_legs(design, as_drawn(), 1);
  std::erase_if(features.features,
                [](const PartFeature& each) { return each.part > test::kElbow1; });
  const std::vector<PartPose> poses = poses_of(design, features);
  const Vector6d about_z = Vector6d::Unit(5);
  for (const int p : {test::kLegFlangeA, test::kLeg1, test::kElbow1}) {
    const PartPose& pose = poses[static_cast<std::size_t>(p)];
    ASSERT_TRUE(pose.is_measured) << p;
    EXPECT_TRUE(is_weak(pose, about_z)) << p;
    ASSERT_FALSE(pose.weak.empty());
    EXPECT_NE(pose.weak[0].text.find("datum's axis"), std::string::npos) << pose.weak[0].text;
    EXPECT_NEAR(pose.weak[0].sigma, std::numbers::sqrt2, 0.1);  // both that and its own turn
  }
}

TEST(PartPoses, FindAnElbowThatIsBuiltTwoDegreesOff) {
  const DesignModel design = test::three_leg_spool();
  // Turned about y in its centre, with all beyond it.
  const Pose motion = turned({0, 0, 0.65}, Vector3d::UnitY(), 1.2);
  const std::vector<Pose> built = test::legs_moved_from(test::kLeg2, motion);
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    const PartFeatures features = test::features_of_legs(design, built, seed);
    const std::vector<PartPose> poses = poses_of(design, features);
    const std::vector<Vector6d> truth = truth_of(design, features, built);
    const PartPose& pipe = poses[test::kLeg2];
    EXPECT_TRUE(pipe.is_off);
    // About y through the elbow's centre by 1.2 degrees: three standard deviations in all that is
    // observed.
    EXPECT_NEAR(pipe.error[4], 1.2 * kDegree, 3 * std::sqrt(pipe.covariance(4, 4)));
    EXPECT_LT(std::sqrt(pipe.covariance(4, 4)), 0.1 * kDegree);
    EXPECT_LT(squared_in_sigmas(pipe, truth[test::kLeg2]), 25) << seed;
    EXPECT_LT(squared_in_sigmas(poses[test::kLegFlangeB], truth[test::kLegFlangeB]), 25) << seed;
    EXPECT_FALSE(poses[test::kLeg1].is_off);
  }
}

// Standard deviation (m) of a place on the part along `way`; design frame, which is the part's
// here.
double sigma_of(const PartPose& pose, const Vector3d& place, const Vector3d& way) {
  Vector6d slope;
  slope << way, place.cross(way);  // way . (t + w x place)
  return std::sqrt(slope.dot(pose.covariance * slope));
}

TEST(PartPoses, AreLessSureTheFurtherFromTheDatum) {
  const DesignModel design = test::three_leg_spool();
  const PartFeatures features = test::features_of_legs(design, as_drawn(), 1);
  const std::vector<PartPose> poses = poses_of(design, features, 0);
  const Vector3d up = Vector3d::UnitZ();
  const double second = sigma_of(poses[test::kLeg2], {0.65, 0, 0.65}, up);
  const double third = sigma_of(poses[test::kLeg3], {0.8, 0.65, 0.65}, up);
  EXPECT_LT(sigma_of(poses[test::kLeg1], {0, 0, 0.5}, Vector3d::UnitX()), second);
  EXPECT_LT(second, third);
  // A scale that is unsure by 1 % moves the far face by 1 % of its 0.68 m off the datum's axis.
  const std::vector<PartPose> scaled = poses_of(design, features, 0.01);
  const Vector3d face(0.8, 0.68, 0.65), out = Vector3d::UnitY();
  EXPECT_NEAR(sigma_of(scaled[test::kLegFlangeB], face, out), 0.0068, 0.0003);
  EXPECT_LT(sigma_of(poses[test::kLegFlangeB], face, out), 0.001);
}

TEST(PartPoses, AreRelativeToTheDatum) {
  DesignModel design = test::three_leg_spool();
  // Elbow_2 is closed by 1.2 degrees. Without holes flange A is turned by the far face, which takes
  // a part of that; flange B by the near one, which lies on the axis that the leg is turned about.
  const std::vector<Pose> built =
      test::legs_moved_from(test::kLeg3, turned({0.8, 0, 0.65}, Vector3d::UnitZ(), 1.2));
  const PartFeatures features = test::features_of_legs(design, built, 1);
  const std::vector<PartPose> from_a = poses_of(design, features);
  const std::vector<Vector6d> truth_a = truth_of(design, features, built);
  EXPECT_FALSE(from_a[test::kLeg1].is_off);
  EXPECT_TRUE(from_a[test::kLeg3].is_off);
  EXPECT_LT(squared_in_sigmas(from_a[test::kLeg3], truth_a[test::kLeg3]), 25);
  design.datums = {test::kLegFlangeB};
  const std::vector<PartPose> from_b = poses_of(design, features);
  const std::vector<Vector6d> truth_b = truth_of(design, features, built);
  EXPECT_TRUE(from_b[test::kLeg2].is_off);
  EXPECT_FALSE(from_b[test::kLeg3].is_off);
  EXPECT_LT(squared_in_sigmas(from_b[test::kLeg2], truth_b[test::kLeg2]), 25);
  EXPECT_NEAR(from_b[test::kLeg2].error[5], -1.2 * kDegree,
              3 * std::sqrt(from_b[test::kLeg2].covariance(5, 5)));
  EXPECT_GT(std::abs(from_b[test::kLeg2].error[5] - from_a[test::kLeg2].error[5]), 0.3 * kDegree);
}

TEST(PartPoses, OfAFlangeHoldItsTurnByItsHolesAndItsTiltByItsFace) {
  DesignModel design = test::holed_spool(8);
  design.datums = {test::kFlangeA};
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    test::HoledScan built;
    built.spool.per_square_metre = 100000;  // 3 mm apart, as holes of 19 mm want
    // Its own x is the design's y: tilted about that by 0.8 degrees in its face's middle, and
    // turned in its face.
    built.spool.T_design_built[test::kFlangeB] = turned({0.68, 0, 0.65}, Vector3d::UnitY(), 0.8);
    built.turn_b_rad = 2 * kDegree;
    const PartFeatures features = test::holed_features(design, test::scan_of_holed(built, seed));
    const PartPose flange = poses_of(design, features)[test::kFlangeB];
    ASSERT_TRUE(flange.is_measured);
    ASSERT_TRUE(flange.weak.empty())
        << flange.weak[0].text << features.why_no_holes[test::kFlangeB];
    EXPECT_NE(std::ranges::find(flange.rests_on, "its bolt holes"), flange.rests_on.end());
    const auto sigma = [&](int k) { return std::sqrt(flange.covariance(k, k)); };
    EXPECT_NEAR(flange.error[3], 0.8 * kDegree, 3 * sigma(3)) << seed;
    EXPECT_NEAR(flange.error[5], 2 * kDegree, 3 * sigma(5)) << seed;
    EXPECT_LT(sigma(3), 0.1 * kDegree);
    EXPECT_LT(sigma(5), 1.0 * kDegree);  // a quarter of 3 mm round the circle of both

    EXPECT_TRUE(flange.is_off);
  }
}

// Sums over many spools of how far the truth is off, in what is said of it.
class Tally {
 public:
  explicit Tally(const DesignModel& design) : design_(design), parts_(design.parts.size()) {}

  void add(const std::vector<PartPose>& poses, const std::vector<Vector6d>& truth) {
    for (std::size_t p = 0; p < poses.size(); ++p) {
      ASSERT_TRUE(poses[p].is_measured) << poses[p].reason;
      Counts& counts = parts_[p];
      counts.sum += squared_in_sigmas(poses[p], truth[p]);
      counts.components += 6 - static_cast<int>(poses[p].weak.size());
      const Vector6d left = left_of(poses[p], truth[p]);
      for (int k = 0; k < 6; ++k) {
        const double sigma = std::sqrt(poses[p].covariance(k, k));
        if (sigma > 0.1 * kUnobservedSigma) continue;
        ++counts.looked_at;
        counts.within += std::abs(left[k]) < 2 * sigma ? 1 : 0;
      }
    }
    ++seeds_;
  }

  // `least`, `most`: of chi-squared a component, besides four standard deviations of its mean. The
  // datum's own flange and pipe define their axis: they are known better than is said, by the
  // micrometre that is added where nothing errs.
  void expect(double least, double most) const {
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      const Counts& counts = parts_[p];
      const std::string& name = design_.parts[p].name;
      const double mean = counts.sum / counts.components;
      const double spread = std::sqrt(2.0 / counts.components);
      const double share = static_cast<double>(counts.within) / counts.looked_at;
      std::printf("%-10s chi-squared a component %.2f, within two sigma %.3f\n", name.c_str(), mean,
                  share);
      EXPECT_LT(mean, most * (1 + 4 * spread)) << name;
      const double from = p > test::kLeg1 ? least : 0;
      EXPECT_GE(mean, from * (1 - 4 * spread)) << name;
      // Components of one part hang together: a spool counts as two of them.
      EXPECT_GT(share, 0.954 - 4 * std::sqrt(0.954 * 0.046 / (2 * seeds_))) << name;
    }
  }

 private:
  struct Counts {
    double sum = 0;
    int components = 0, within = 0, looked_at = 0;
  };
  const DesignModel& design_;
  std::vector<Counts> parts_;
  int seeds_ = 0;
};

TEST(PartPoses, AreAsSureAsTheySayWhereFeaturesAre) {
  const DesignModel design = test::three_leg_spool();
  const PartFeatures nominal = test::features_of_legs(design, as_drawn(), 1);
  Tally tally(design);
  for (std::uint32_t seed = 1; seed <= 300; ++seed) {
    std::mt19937 random{seed};
    std::normal_distribution<double> normal;
    const std::vector<Pose> built = badly_welded(design, random);
    PartFeatures features = nominal;
    for (PartFeature& each : features.features) {  // drawn from what they say of themselves
      Vector6d white;
      for (int k = 0; k < 6; ++k) white[k] = normal(random);
      const Eigen::SelfAdjointEigenSolver<Matrix6d> eigen(each.fit_covariance);
      const Vector6d noise =
          eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).cwiseSqrt().cwiseProduct(white);
      each.T_design_measured = built[static_cast<std::size_t>(each.part)] * each.T_design_nominal *
                               pose_from_small(noise);
    }
    tally.add(poses_of(design, features, 0), truth_of(design, features, built));
  }
  tally.expect(1, 1);
}

TEST(PartPoses, AreAsSureAsTheySayOfScans) {
  const DesignModel design = test::three_leg_spool();
  Tally drawn(design);
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    const PartFeatures features = test::features_of_legs(design, as_drawn(), seed);
    drawn.add(poses_of(design, features), truth_of(design, features, as_drawn()));
  }
  // Fittings are as their welds were as drawn, far better than is said; fits are that of points.
  drawn.expect(0, 1.3);
  // Where parts stand millimetres off, the points near their ends are taken for their neighbours',
  // which moves axes by more than noise does.
  Tally tally(design);
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    std::mt19937 random{seed};
    const std::vector<Pose> built = badly_welded(design, random);
    const PartFeatures features = test::features_of_legs(design, built, seed);
    tally.add(poses_of(design, features), truth_of(design, features, built));
  }
  tally.expect(0, 2);
}

}  // namespace
}  // namespace spool
