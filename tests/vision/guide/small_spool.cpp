// A spool of eight parts written down by hand: ports and joints, no surface.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/guide/small_spool.h"

namespace spool::test {
namespace {

using Eigen::Vector3d;

Port port(const char* name, const Vector3d& position, const Vector3d& direction,
          EndType end = EndType::kButtWeld) {
  return {name, position, direction, 4, end};
}

Part part(const char* name, PartKind kind, const Vector3d& place, std::vector<Port> ports) {
  Part made;
  made.name = name;
  made.kind = kind;
  made.nps = 4;
  made.ports = std::move(ports);
  made.T_design_part.translation() = place;
  return made;
}

Part pipe(const char* name, const Vector3d& from, const Vector3d& along, double length) {
  return part(name, PartKind::kPipe, from,
              {port("a", Vector3d::Zero(), -along), port("b", length * along, along)});
}

}  // namespace

DesignModel small_spool() {
  const Vector3d x = Vector3d::UnitX(), z = Vector3d::UnitZ();
  DesignModel design;
  design.path = "small.glb";
  // A flange of 76 mm, a tee of 105 mm, an elbow of 152 mm.
  design.parts = {
      pipe("pipe_1", {0.076, 0, 0}, x, 0.4),
      part("flange_1", PartKind::kFlange, Vector3d::Zero(),
           {port("face", Vector3d::Zero(), -x, EndType::kFlanged), port("weld", 0.076 * x, x)}),
      part("tee_1", PartKind::kTee, {0.581, 0, 0},
           {port("a", -0.105 * x, -x), port("b", 0.105 * x, x), port("branch", 0.105 * z, z)}),
      pipe("pipe_2", {0.686, 0, 0}, x, 0.9),
      part("flange_2", PartKind::kFlange, {1.662, 0, 0},
           {port("face", Vector3d::Zero(), x, EndType::kFlanged), port("weld", -0.076 * x, -x)}),
      pipe("pipe_3", {0.581, 0, 0.105}, z, 0.3),
      part("elbow_1", PartKind::kElbow, {0.581, 0, 0.557},
           {port("a", -0.152 * z, -z), port("b", 0.152 * x, x)}),
      pipe("pipe_4", {0.733, 0, 0.557}, x, 0.2)};
  const auto join = [&](const char* weld, int a, int port_a, int b, int port_b) {
    design.joints.push_back({weld, a, port_a, b, port_b, JointType::kFab});
  };
  join("W1", 1, 1, 0, 0);
  join("W2", 0, 1, 2, 0);
  join("W3", 2, 1, 3, 0);
  join("W4", 3, 1, 4, 1);
  join("W5", 2, 2, 5, 0);
  join("W6", 5, 1, 6, 0);
  join("W7", 6, 1, 7, 0);
  return design;
}

int part_named(const DesignModel& design, const std::string& name) {
  for (std::size_t p = 0; p < design.parts.size(); ++p) {
    if (design.parts[p].name == name) return static_cast<int>(p);
  }
  return -1;
}

std::vector<std::string> names_of(const DesignModel& design, const std::vector<int>& order) {
  std::vector<std::string> names;
  for (const int part : order)
    names.push_back(design.parts.at(static_cast<std::size_t>(part)).name);
  return names;
}

}  // namespace spool::test
