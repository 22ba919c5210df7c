// A tee as triangles: the run unrolled with the branch's opening in it, the branch on its rim.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "tools/campaign/part_mesh.h"
#include "tools/campaign/standard_sizes.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;
constexpr int kAcross = kCircleSteps;  // steps of an end of the run
constexpr int kAlong = 12;             // steps along the seam on the run's back
constexpr int kRings = 16;             // loops between the opening and the run's rim

// The border of the unrolled run, (z, angle round the run from the branch), clockwise about x seen
// from where the branch looks to.
std::vector<Eigen::Vector2d> border(double half_run) {
  constexpr double kPi = std::numbers::pi;
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < kAcross; ++i) points.emplace_back(half_run, -kPi + 2 * kPi * i / kAcross);
  for (int i = 0; i < kAlong; ++i) points.emplace_back(half_run * (1 - 2.0 * i / kAlong), kPi);
  for (int i = 0; i < kAcross; ++i) points.emplace_back(-half_run, kPi - 2 * kPi * i / kAcross);
  for (int i = 0; i < kAlong; ++i) points.emplace_back(-half_run * (1 - 2.0 * i / kAlong), -kPi);
  return points;
}

struct Ends {
  Loop branch, top;  // clockwise about x, counter-clockwise about z
};

// One shell in the tee's frame with its centre at z = 0.
Ends add_shell(double run_radius, double branch_radius, double half_run, double outlet,
               MeshBuilder& b) {
  const auto edge = border(half_run);
  const auto loop_at = [&](double share) {
    Loop loop;
    for (const Eigen::Vector2d& e : edge) {
      const double phi = std::atan2(e.y() / std::numbers::pi, e.x() / half_run);
      const Eigen::Vector2d opening(branch_radius * std::cos(phi),
                                    std::asin(branch_radius * std::sin(phi) / run_radius));
      const Eigen::Vector2d at = opening + share * (e - opening);
      loop.emplace_back(run_radius * std::cos(at.y()), run_radius * std::sin(at.y()), at.x());
    }
    return loop;
  };
  // Closer at the opening, where the border's corners are far from round.
  const auto share = [](int ring) { return std::pow(ring / static_cast<double>(kRings), 1.3); };
  for (int ring = 0; ring < kRings; ++ring) b.strip(loop_at(share(ring)), loop_at(share(ring + 1)));
  Ends ends;
  const Loop rim = loop_at(0);
  for (const Vector3d& p : rim) ends.branch.emplace_back(outlet, p.y(), p.z());
  b.strip(ends.branch, rim);
  const Loop outermost = loop_at(1);
  ends.top.assign(outermost.begin(), outermost.begin() + kAcross);
  return ends;
}

}  // namespace

void add_tee(const PartSpec& spec, MeshBuilder& b) {
  const StandardSizes& run = sizes_of(spec.nps);
  const StandardSizes& branch = sizes_of(spec.nps2);
  const double outlet = tee_outlet(spec.nps, spec.nps2);
  const Pose T_part_centre(Eigen::Translation3d(0, 0, run.tee));
  const auto shell = [&](double inset_run, double inset_branch, bool inward) {
    b.in_frame(T_part_centre, inward);
    return add_shell(run.outside_diameter / 2 - inset_run,
                     branch.outside_diameter / 2 - inset_branch, run.tee, outlet, b);
  };
  const Ends outer = shell(0, 0, false);
  const Ends inner = shell(run.wall, branch.wall, true);
  b.in_frame(T_part_centre, false);
  b.strip(inner.branch, outer.branch);
  b.strip(outer.top, inner.top);
  const auto lowered = [&](Loop loop) {
    for (Vector3d& p : loop) p.z() = -run.tee;
    return loop;
  };
  b.strip(lowered(inner.top), lowered(outer.top));
}

}  // namespace spool::campaign
