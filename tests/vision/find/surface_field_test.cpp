// The field of nearest samples against brute force, at its borders and on poor input.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/surface_field.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace spool {
namespace {

using Eigen::Vector3f;

float distance_to(const std::vector<Vector3f>& samples, const Vector3f& query) {
  float least = std::numeric_limits<float>::infinity();
  for (const Vector3f& sample : samples) least = std::min(least, (sample - query).norm());
  return least;
}

struct FieldCase {
  const char* name;
  Vector3f middle, half;  // m, of the box that the samples lie in
  std::size_t samples;
};

class Fields : public testing::TestWithParam<FieldCase> {};

TEST_P(Fields, GiveTheNearestSampleToWithinACell) {
  const auto& [name, middle, half, count] = GetParam();
  std::mt19937 random{1};
  std::uniform_real_distribution<float> unit(-1, 1);
  const auto anywhere = [&](float wide) -> Vector3f {
    const float x = unit(random), y = unit(random), z = unit(random);
    return middle + (half.array() * Vector3f(x, y, z).array()).matrix() +
           wide * Vector3f(unit(random), unit(random), unit(random));
  };
  std::vector<Vector3f> samples;
  for (std::size_t i = 0; i < count; ++i) samples.push_back(anywhere(0));
  const float scale = half.norm();
  const double cell = 0.02 * double{scale}, reach = 0.2 * double{scale};
  const SurfaceField field(CloudView(samples), cell, reach);
  // A query is off its cell's middle by half a diagonal at most, for it and for whatever sample is
  // compared; the distance transform itself errs by far less than the rest of a cell.
  const auto slack = static_cast<float>(2.0 * cell);
  std::size_t near = 0, far = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vector3f query = anywhere(0.4F * scale);
    const float truth = distance_to(samples, query);
    const std::uint16_t found = field.nearest(query);
    if (found == SurfaceField::kFar) {
      ++far;
      EXPECT_GT(truth, static_cast<float>(reach) - slack);
    } else {
      ++near;
      EXPECT_LT((samples[found] - query).norm(), truth + slack);
      EXPECT_LT(truth, static_cast<float>(reach) + slack);
    }
  }
  EXPECT_GT(near, 20U);
  EXPECT_GT(far, 100U);
}

INSTANTIATE_TEST_SUITE_P(
    Boxes, Fields,
    testing::Values(FieldCase{"cube", {0, 0, 0}, {1, 1, 1}, 300},
                    FieldCase{"plate", {0, 0, 0}, {1, 0.7F, 0}, 300},
                    FieldCase{"wire", {0, 0, 0}, {0, 2, 0}, 50},
                    FieldCase{"point", {3, 4, 5}, {1e-3F, 1e-3F, 1e-3F}, 1},
                    FieldCase{"one_centimetre", {0, 0, 0}, {0.004F, 0.004F, 0.003F}, 200},
                    FieldCase{"hundred_metres", {0, 0, 0}, {40, 30, 10}, 300},
                    FieldCase{"half_a_kilometre_off", {500, -300, 20}, {1, 1, 0.5F}, 300}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(SurfaceField, IsFarOutsideAndForNaN) {
  const std::vector<Vector3f> samples = {{0, 0, 0}, {1, 0, 0}};
  const SurfaceField field(CloudView(samples), 0.05, 0.2);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const Vector3f& query : {Vector3f(nan, 0, 0), Vector3f(0, 0, nan), Vector3f(infinity, 0, 0),
                                Vector3f(0, -infinity, 0), Vector3f(1e30F, 0, 0),
                                Vector3f(-1e30F, 1e30F, 0), Vector3f(0, 0, 0.5F)})
    EXPECT_EQ(field.nearest(query), SurfaceField::kFar) << query.transpose();
  EXPECT_EQ(field.nearest({0.01F, 0, 0}), 0);
  EXPECT_EQ(field.nearest({0.99F, 0.1F, 0}), 1);
}

TEST(SurfaceField, OfNothingIsFarEverywhere) {
  EXPECT_EQ(SurfaceField().nearest(Vector3f::Zero()), SurfaceField::kFar);
  EXPECT_EQ(SurfaceField(CloudView(), 0.1, 0.2).nearest(Vector3f::Zero()), SurfaceField::kFar);
}

}  // namespace
}  // namespace spool
