// A part of a spool or frame by its standard sizes: its ports, and its surface as patches.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/part.h"

#include <array>
#include <cmath>
#include <numbers>

#include "tools/campaign/standard_sizes.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;

Pose at_height(double z) { return Pose(Eigen::Translation3d(0, 0, z)); }

// A frame at `origin` whose z is `z` and whose x is as near to `x` as can be.
Pose frame(const Vector3d& origin, const Vector3d& z, const Vector3d& x) {
  Pose pose = Pose::Identity();
  pose.translation() = origin;
  pose.linear().col(2) = z.normalized();
  pose.linear().col(1) = z.cross(x).normalized();
  pose.linear().col(0) = pose.linear().col(1).cross(pose.linear().col(2));
  return pose;
}

PartPort lower(double nps, std::string_view name = "in", std::string_view end = "BW") {
  return {name, frame(Vector3d::Zero(), -Vector3d::UnitZ(), Vector3d::UnitX()), nps, end};
}

PartPort upper(double z, double nps, std::string_view name = "out", std::string_view end = "BW") {
  return {name, at_height(z), nps, end};
}

double bore_radius(const StandardSizes& s) { return s.outside_diameter / 2 - s.wall; }

// Appends patches that lie in the part's own frame or shifted along z.
struct Builder {
  std::vector<Patch> patches = {};

  void add(const Shape& shape, const Pose& pose = Pose::Identity(), bool inward = false) {
    patches.push_back({shape, pose, inward, {}});
  }
  void disc(const Annulus& annulus, double z, bool down) { add(annulus, at_height(z), down); }

  // A round wall between the two radii from z0 to z1, open at its ends.
  void pipe(double outer, double inner, double z0, double z1) {
    add(Cylinder{outer, z0, z1});
    add(Cylinder{inner, z0, z1}, Pose::Identity(), true);
  }
};

std::vector<Patch> pipe(const PartSpec& spec) {
  const StandardSizes& s = sizes_of(spec.nps);
  const double outer = s.outside_diameter / 2;
  Builder b;
  b.pipe(outer, bore_radius(s), 0, spec.length_m);
  b.disc({bore_radius(s), outer}, 0, true);
  b.disc({bore_radius(s), outer}, spec.length_m, false);
  return b.patches;
}

std::vector<Patch> elbow(const PartSpec& spec) {
  const StandardSizes& s = sizes_of(spec.nps);
  const double bend = bend_radius(spec);
  // The bend's centre lies on x; the torus starts at the part's origin and turns upwards.
  Pose T_part_bend = Pose::Identity();
  T_part_bend.translation() = Vector3d(bend, 0, 0);
  T_part_bend.linear().col(0) = -Vector3d::UnitX();
  T_part_bend.linear().col(1) = Vector3d::UnitZ();
  T_part_bend.linear().col(2) = Vector3d::UnitY();
  const double outer = s.outside_diameter / 2;
  Builder b;
  b.add(Torus{bend, outer, spec.angle_rad}, T_part_bend);
  b.add(Torus{bend, bore_radius(s), spec.angle_rad}, T_part_bend, true);
  b.disc({bore_radius(s), outer}, 0, true);
  b.add(Annulus{bore_radius(s), outer}, ports_of(spec)[1].T_part_port);
  return b.patches;
}

std::vector<Patch> tee(const PartSpec& spec) {
  const StandardSizes& run = sizes_of(spec.nps);
  const StandardSizes& branch = sizes_of(spec.nps2);
  const double outlet = tee_outlet(spec.nps, spec.nps2);
  const Pose T_part_centre = at_height(run.tee);
  const Pose T_part_branch = frame(Vector3d(0, 0, run.tee), Vector3d::UnitX(), Vector3d::UnitZ());
  const Vector3d x = Vector3d::UnitX();
  const Vector3d z = Vector3d::UnitZ();
  std::vector<Patch> patches;
  const auto legs = [&](double run_radius, double branch_radius, bool inward) {
    // The run ends where the branch's bore or wall begins, and the branch where the run's does. In
    // the branch's frame the run lies along x.
    patches.push_back({Cylinder{run_radius, -run.tee, run.tee}, T_part_centre, inward,
                       Trim{x, x, branch_radius}});
    patches.push_back(
        {Cylinder{branch_radius, 0, outlet}, T_part_branch, inward, Trim{x, z, run_radius}});
  };
  legs(run.outside_diameter / 2, branch.outside_diameter / 2, false);
  legs(bore_radius(run), bore_radius(branch), true);
  Builder b{std::move(patches)};
  b.disc({bore_radius(run), run.outside_diameter / 2}, 0, true);
  b.disc({bore_radius(run), run.outside_diameter / 2}, 2 * run.tee, false);
  b.add(Annulus{bore_radius(branch), branch.outside_diameter / 2}, ports_of(spec)[2].T_part_port);
  return b.patches;
}

std::vector<Patch> reducer(const PartSpec& spec) {
  const StandardSizes& large = sizes_of(spec.nps);
  const StandardSizes& small = sizes_of(spec.nps2);
  const double length = large.reducer;
  Builder b;
  b.add(Cone{large.outside_diameter / 2, small.outside_diameter / 2, 0, length});
  b.add(Cone{bore_radius(large), bore_radius(small), 0, length}, Pose::Identity(), true);
  b.disc({bore_radius(large), large.outside_diameter / 2}, 0, true);
  b.disc({bore_radius(small), small.outside_diameter / 2}, length, false);
  return b.patches;
}

std::vector<Patch> flange(const PartSpec& spec) {
  const StandardSizes& s = sizes_of(spec.nps);
  const double bore = bore_radius(s);
  const double pipe_radius = s.outside_diameter / 2;
  const double rim = s.flange_diameter / 2;
  const double circle = s.bolt_circle / 2;
  // A straight land at the weld end, as welders expect it.
  const double land = s.weld_neck - 0.006;
  Builder b;
  b.disc({bore, s.raised_face / 2}, 0, true);
  b.add(Cylinder{s.raised_face / 2, 0, kRaisedFaceHeight});
  b.disc({s.raised_face / 2, rim, s.holes, circle, s.hole / 2, hole_clocking(s.holes)},
         kRaisedFaceHeight, true);
  b.add(Cylinder{rim, kRaisedFaceHeight, s.flange_thickness});
  b.disc({s.hub / 2, rim, s.holes, circle, s.hole / 2, hole_clocking(s.holes)}, s.flange_thickness,
         false);
  for (int i = 0; i < s.holes; ++i) {
    const double angle = hole_clocking(s.holes) + 2 * std::numbers::pi * i / s.holes;
    const Eigen::Translation3d place(circle * std::cos(angle), circle * std::sin(angle), 0);
    b.add(Cylinder{s.hole / 2, kRaisedFaceHeight, s.flange_thickness}, Pose(place), true);
  }
  b.add(Cone{s.hub / 2, pipe_radius, s.flange_thickness, land});
  b.add(Cylinder{pipe_radius, land, s.weld_neck});
  b.disc({bore, pipe_radius}, s.weld_neck, false);
  b.add(Cylinder{bore, 0, s.weld_neck}, Pose::Identity(), true);
  return b.patches;
}

std::vector<Patch> cap(const PartSpec& spec) {
  const StandardSizes& s = sizes_of(spec.nps);
  const double outer = s.outside_diameter / 2;
  // A 2:1 ellipsoidal head on a straight skirt.
  const double skirt = s.cap - outer / 2;
  Builder b;
  b.pipe(outer, bore_radius(s), 0, skirt);
  b.disc({bore_radius(s), outer}, 0, true);
  b.add(Dome{outer, outer / 2}, at_height(skirt));
  b.add(Dome{bore_radius(s), outer / 2 - s.wall}, at_height(skirt), true);
  return b.patches;
}

std::vector<Patch> tube(const PartSpec& spec) {
  const double half = spec.width_m / 2;
  const double inner = half - kTubeWall;
  const double middle = spec.length_m / 2;
  Builder b;
  for (int side = 0; side < 4; ++side) {
    const double angle = std::numbers::pi / 2 * side;
    const Vector3d out(std::cos(angle), std::sin(angle), 0);
    const auto face = [&](double distance) {
      return frame(distance * out + Vector3d(0, 0, middle), out, Vector3d::UnitZ());
    };
    b.add(Rectangle{middle, half}, face(half));
    b.add(Rectangle{middle, inner}, face(inner), true);
  }
  b.add(Rectangle{half, half, inner, inner}, Pose::Identity(), true);
  b.add(Rectangle{half, half, inner, inner}, at_height(spec.length_m));
  return b.patches;
}

}  // namespace

const char* word(PartKind kind) {
  constexpr std::array kWords = {"pipe", "elbow", "tee", "reducer", "flange", "cap", "tube"};
  return kWords[static_cast<std::size_t>(kind)];
}

double bend_radius(const PartSpec& elbow) {
  const StandardSizes& s = sizes_of(elbow.nps);
  const bool right_angle = elbow.angle_rad > std::numbers::pi / 3;
  return right_angle ? s.elbow_90 : s.elbow_45 / std::tan(elbow.angle_rad / 2);
}

double hole_clocking(int holes) { return std::numbers::pi / holes; }

std::vector<PartPort> ports_of(const PartSpec& spec) {
  const double nps = spec.nps;
  switch (spec.kind) {
    case PartKind::kPipe:
      return {lower(nps), upper(spec.length_m, nps)};
    case PartKind::kElbow: {
      const double bend = bend_radius(spec);
      const double c = std::cos(spec.angle_rad);
      const double s = std::sin(spec.angle_rad);
      return {lower(nps),
              {"out", frame({bend * (1 - c), 0, bend * s}, {s, 0, c}, {c, 0, -s}), nps, "BW"}};
    }
    case PartKind::kTee: {
      const double centre = sizes_of(nps).tee;
      const Vector3d outlet(tee_outlet(nps, spec.nps2), 0, centre);
      return {lower(nps),
              upper(2 * centre, nps),
              {"branch", frame(outlet, Vector3d::UnitX(), Vector3d::UnitZ()), spec.nps2, "BW"}};
    }
    case PartKind::kReducer:
      return {lower(nps), upper(sizes_of(nps).reducer, spec.nps2)};
    case PartKind::kFlange:
      return {lower(nps, "face", "FL"), upper(sizes_of(nps).weld_neck, nps, "weld")};
    case PartKind::kCap:
      return {lower(nps)};
    case PartKind::kTube:
      return {lower(0, "in", "PL"), upper(spec.length_m, 0, "out", "PL")};
  }
  return {};
}

std::vector<Patch> patches_of(const PartSpec& spec) {
  switch (spec.kind) {
    case PartKind::kPipe:
      return pipe(spec);
    case PartKind::kElbow:
      return elbow(spec);
    case PartKind::kTee:
      return tee(spec);
    case PartKind::kReducer:
      return reducer(spec);
    case PartKind::kFlange:
      return flange(spec);
    case PartKind::kCap:
      return cap(spec);
    case PartKind::kTube:
      return tube(spec);
  }
  return {};
}

}  // namespace spool::campaign
