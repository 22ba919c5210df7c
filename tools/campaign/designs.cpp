// The objects that scenes are made of: spools of standard parts and a frame of square tube.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/designs.h"

#include <cmath>
#include <numbers>

#include "tools/campaign/random.h"
#include "tools/campaign/random_spool.h"
#include "tools/campaign/spool_router.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;
constexpr double kQuarter = std::numbers::pi / 2;

// 3 x 2 x 0.5 m, curvilinear, after the pipe spool of thesis 4.4: the long legs lie in a plane and
// two short ends leave it.
Assembly pipe_spool_3m(std::uint32_t seed) {
  Random random(seed, 11);
  const auto about = [&](double length) { return length * random.uniform(0.93, 1.07); };
  SpoolRouter r("pipe_spool_3m", 4);
  r.start_with_flange();
  r.pipe(about(1.20));
  const int first_tee = r.tee(3, 0);
  r.pipe(about(1.05));
  r.elbow(90, 0);
  r.pipe(about(0.55));
  const int second_tee = r.tee(4, 0);
  r.pipe(about(0.60));
  r.elbow(90, kQuarter);
  r.pipe(about(0.14));
  r.flange();
  r.branch(first_tee);
  r.pipe(about(0.80));
  r.elbow(90, 0);
  r.pipe(about(0.40));
  r.flange();
  r.branch(second_tee);
  r.pipe(about(0.16));
  r.reducer(2);
  r.pipe(about(0.12));
  r.elbow(45, about(kQuarter));
  r.pipe(about(0.15));
  r.flange();
  return r.assembly();
}

// 0.3 x 0.4 x 0.5 m of NPS 2: what stands on a fitter's table.
Assembly small_spool(std::uint32_t seed) {
  Random random(seed, 12);
  const auto about = [&](double length) { return length * random.uniform(0.9, 1.1); };
  SpoolRouter r("small_spool", 2);
  r.start_with_flange();
  r.pipe(about(0.07));
  const int tee = r.tee(2, about(kQuarter));
  r.pipe(about(0.06));
  r.elbow(90, 0);
  r.pipe(about(0.12));
  r.flange();
  r.branch(tee);
  r.pipe(about(0.06));
  r.elbow(90, about(kQuarter));
  r.pipe(about(0.08));
  r.cap();
  return r.assembly();
}

// About 2 x 1.5 m, after the assembly of thesis 5: a header with flanges and four branches, no two
// alike.
Assembly four_branch(std::uint32_t seed) {
  Random random(seed, 14);
  const auto about = [&](double length) { return length * random.uniform(0.93, 1.07); };
  SpoolRouter r("four_branch", 4);
  r.start_with_flange();
  r.pipe(about(0.15));
  const int tee_1 = r.tee(3, 0);
  r.pipe(about(0.25));
  const int tee_2 = r.tee(3, std::numbers::pi);
  r.pipe(about(0.22));
  const int tee_3 = r.tee(3, std::numbers::pi);
  r.pipe(about(0.28));
  const int tee_4 = r.tee(2, std::numbers::pi);
  r.pipe(about(0.15));
  r.flange();
  r.branch(tee_1);
  r.pipe(about(0.60));
  r.flange();
  r.branch(tee_2);
  r.pipe(about(0.30));
  r.elbow(90, about(kQuarter));
  r.pipe(about(0.25));
  r.flange();
  r.branch(tee_3);
  r.pipe(about(0.25));
  r.elbow(45, -about(kQuarter));
  r.pipe(about(0.30));
  r.flange();
  r.branch(tee_4);
  r.pipe(about(0.45));
  r.elbow(90, about(0.8));
  r.pipe(about(0.12));
  r.cap();
  return r.assembly();
}

// 3.5 x 2 x 2 m of 100 mm square tube, after the box frame of thesis 4.4.
Assembly box_frame(std::uint32_t seed, bool braced) {
  Random random(seed, 13);
  constexpr double kWidth = 0.1;
  const double x = 3.5 * random.uniform(0.97, 1.03);
  const double side = 2.0 * random.uniform(0.97, 1.03);
  const double near = kWidth / 2;
  const double far = side - near;
  Assembly frame{"box_frame", {}};
  const auto tube = [&](const Vector3d& from, const Vector3d& to) {
    PartSpec spec{.kind = PartKind::kTube};
    spec.name = "tube_" + std::to_string(frame.members.size() + 1);
    spec.length_m = (to - from).norm();
    spec.width_m = kWidth;
    Pose pose = Pose::Identity();
    pose.translation() = from;
    const Vector3d z = (to - from).normalized();
    // Flat sides face the frame's sides; a brace lies in the x-z plane.
    const Vector3d y = std::abs(z.y()) > 0.9 ? Vector3d::UnitX() : Vector3d::UnitY();
    pose.linear().col(2) = z;
    pose.linear().col(0) = y.cross(z).normalized();
    pose.linear().col(1) = z.cross(pose.linear().col(0));
    frame.place(spec, pose);
  };
  for (const double y : {near, far})
    for (const double z : {near, far}) tube({0, y, z}, {x, y, z});
  for (const double at : {near, x - near}) {
    for (const double z : {near, far}) tube({at, kWidth, z}, {at, side - kWidth, z});
    for (const double y : {near, far}) tube({at, y, kWidth}, {at, y, side - kWidth});
  }
  if (braced) {
    const double third = x * random.uniform(0.28, 0.38);
    tube({third, near, kWidth}, {third, near, side - kWidth});
    tube({third, kWidth, far}, {third, side - kWidth, far});
    // A brace in the far side's plane, clear of the corners by its own width.
    tube({x - 0.25, far, 0.2}, {third + 0.25, far, side - 0.2});
  }
  return frame;
}

}  // namespace

Assembly design_of(ObjectKind kind, std::uint32_t seed, bool braced) {
  switch (kind) {
    case ObjectKind::kSmallSpool:
      return small_spool(seed);
    case ObjectKind::kBoxFrame:
      return box_frame(seed, braced);
    case ObjectKind::kFourBranch:
      return four_branch(seed);
    case ObjectKind::kRandomSpool:
      return random_spool(seed);
    case ObjectKind::kPipeSpool3m:
      break;
  }
  return pipe_spool_3m(seed);
}

}  // namespace spool::campaign
