// What a simulated scene really holds.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/truth.h"

#include <nlohmann/json.hpp>

namespace spool::simulator {
namespace {

using nlohmann::json;

json vector_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

json pose_error(const Pose& error) {
  return {{"translation_m", vector_json(error.translation())},
          {"rotation_rad", vector_json(rotation_vector(error.linear()))}};
}

// The frame of a port in its part: z outward. x is any direction, the same wherever it is asked
// for.
Pose port_pose(const Port& port) {
  Pose pose = Pose::Identity();
  pose.linear() =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), port.direction).matrix();
  pose.translation() = port.position;
  return pose;
}

// A part's port as built: on a longer pipe the far port (the one beyond the middle) has moved out.
Pose built_port(const Part& part, const BuiltPart& built, std::size_t port) {
  Pose pose = port_pose(part.ports[port]);
  if (built.length_m != 0 && part.ports.size() == 2 && port == built.far_port)
    pose.translation() += built.length_m * part.ports[port].direction;
  return built.T_design_part * pose;
}

json joint_json(const DesignModel& design, const AsBuilt& built, const Joint& joint) {
  const auto a = static_cast<std::size_t>(joint.part_a), b = static_cast<std::size_t>(joint.part_b);
  const auto pa = static_cast<std::size_t>(joint.port_a),
             pb = static_cast<std::size_t>(joint.port_b);
  const Part &part_a = design.parts[a], &part_b = design.parts[b];
  const Pose nominal = (part_a.T_design_part * port_pose(part_a.ports[pa])).inverse() *
                       part_b.T_design_part * port_pose(part_b.ports[pb]);
  const Pose as_built =
      built_port(part_a, built.parts[a], pa).inverse() * built_port(part_b, built.parts[b], pb);
  return {{"weld", joint.weld},
          {"between", {part_a.name, part_b.name}},
          {"error", pose_error(nominal.inverse() * as_built)}};
}

}  // namespace

json truth_json(const Simulator& simulator, std::int64_t frames) {
  const World& world = simulator.world();
  json truth = {{"schema", "spoolsight-truth/1"},
                {"T_map_design", row_major(world.T_map_design)},
                {"parts", json::array()},
                {"joints", json::array()},
                {"frames", json::array()}};
  if (world.design) {
    const DesignModel& design = *world.design;
    truth["design"] = {{"path", design.path}, {"sha256", design.sha256}};
    const std::size_t datum =
        design.datums.empty() ? 0 : static_cast<std::size_t>(design.datums.front());
    // The datum stands where it is drawn; all else is seen from it.
    const Pose back =
        design.parts[datum].T_design_part * world.as_built.parts[datum].T_design_part.inverse();
    for (std::size_t p = 0; p < design.parts.size(); ++p) {
      const BuiltPart& built = world.as_built.parts[p];
      truth["parts"].push_back({{"name", design.parts[p].name},
                                {"missing", built.missing},
                                {"length_error_m", built.length_m},
                                {"T_design_part", row_major(built.T_design_part)},
                                {"pose_error", pose_error(design.parts[p].T_design_part.inverse() *
                                                          back * built.T_design_part)}});
    }
    for (const Joint& joint : design.joints)
      truth["joints"].push_back(joint_json(design, world.as_built, joint));
  }
  for (std::int64_t n = 0; n < frames; ++n)
    truth["frames"].push_back(
        {{"frame", n},
         {"seconds", static_cast<double>(n) / simulator.scene().sensor.frames_per_second},
         {"T_map_camera", row_major(simulator.T_map_camera(n))}});
  return truth;
}

}  // namespace spool::simulator
