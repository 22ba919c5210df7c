// A scene as files: cloud.ply, sensor.json, design/model.glb and truth/.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/scene_files.h"

#include <nlohmann/json.hpp>

#include "app/common/json_file.h"
#include "vision/core/file_io.h"
#include "vision/scan/cloud_file.h"

namespace spool::campaign {
namespace {

using nlohmann::json;

json numbers(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

json rows(const Pose& pose) {
  json matrix = json::array();
  for (int i = 0; i < 4; ++i) {
    const Eigen::RowVector4d row = pose.matrix().row(i);
    matrix.push_back({row[0], row[1], row[2], row[3]});
  }
  return matrix;
}

// A motion as its shift and rotation vector, and their lengths.
json error_of(const Pose& motion) {
  const Eigen::AngleAxisd turn(motion.linear());
  const Eigen::Vector3d degrees = turn.angle() * 180 / EIGEN_PI * turn.axis();
  const Eigen::Vector3d shift = 1000 * motion.translation();
  return {{"t_mm", numbers(shift)},
          {"r_deg", numbers(degrees)},
          {"t_norm_mm", shift.norm()},
          {"r_norm_deg", degrees.norm()}};
}

json ports(const PartSpec& spec, const Pose& T_design_part) {
  json all = json::object();
  for (const PartPort& port : ports_of(spec)) {
    const Pose pose = T_design_part * port.T_part_port;
    all[std::string(port.name)] = {{"position", numbers(pose.translation())},
                                   {"direction", numbers(pose.linear().col(2))}};
  }
  return all;
}

// How a part stands on the part that it should hang on: its own frame seen from that part's port.
Pose on_its_joint(const Member& planned, const Assembly& assembly, const std::vector<Pose>& poses,
                  std::size_t part) {
  const auto parent = static_cast<std::size_t>(planned.parent);
  const auto from = ports_of(assembly.members[parent].spec);
  const auto port = static_cast<std::size_t>(planned.parent_port);
  return (poses[parent] * from[port].T_part_port).inverse() * poses[part];
}

json components(const Scene& scene) {
  const std::vector<Pose> design = poses_of(scene.design);
  const std::vector<Pose> built = poses_of(scene.as_built);
  json all = json::array();
  for (std::size_t i = 0; i < scene.as_built.members.size(); ++i) {
    const Member& member = scene.as_built.members[i];
    json component = {{"label", i},
                      {"name", member.spec.name},
                      {"kind", word(member.spec.kind)},
                      {"nps", member.spec.nps},
                      {"missing", member.missing},
                      {"extra", i >= design.size()},
                      {"pose_asbuilt", rows(built[i])},
                      {"ports_asbuilt", ports(member.spec, built[i])}};
    if (i < design.size()) {
      const Member& planned = scene.design.members[i];
      component["pose_design"] = rows(design[i]);
      component["ports_design"] = ports(planned.spec, design[i]);
      component["error_root"] = error_of(design[i].inverse() * built[i]);
      component["length_error_mm"] = 1000 * (member.spec.length_m - planned.spec.length_m);
      if (planned.parent >= 0) {
        component["parent"] =
            scene.design.members[static_cast<std::size_t>(planned.parent)].spec.name;
        component["joint"] = error_of(on_its_joint(planned, scene.design, design, i).inverse() *
                                      on_its_joint(planned, scene.as_built, built, i));
      }
    }
    all.push_back(component);
  }
  return all;
}

json defects(const Scene& scene) {
  json all = json::array();
  for (const Defect& each : scene.request.defects) {
    const bool millimetres = each.kind == DefectKind::kLong || each.kind == DefectKind::kOffset;
    json defect = {{"type", name(each.kind)}, {"component", each.part}};
    if (!each.other.empty()) defect["other"] = each.other;
    if (each.amount != 0) defect[millimetres ? "mm" : "deg"] = each.amount;
    all.push_back(defect);
  }
  return all;
}

json truth(const Scene& scene) {
  json poses = json::array();
  for (const Instance& instance : scene.objects) poses.push_back(rows(instance.T_scan_design));
  json symmetries = json::array();
  for (const Pose& pose : scene.symmetries) symmetries.push_back(rows(pose));
  json all = {{"design", scene.design.name},
              {"seed", scene.request.seed},
              {"points", scene.cloud.size()},
              {"object_points", scene.object_points},
              {"clutter_ratio", scene.clutter_ratio},
              {"completeness", scene.completeness},
              {"poses", poses},
              {"symmetries", symmetries},
              {"defects", defects(scene)},
              {"components", components(scene)},
              {"labels",
               {{"floor", kFloor},
                {"wall", kWall},
                {"table", kTable},
                {"stand", kStand},
                {"box", kBox},
                {"cylinder", kCylinder},
                {"other_pipe", kOtherPipe},
                {"structure", kStructure},
                {"mixed_pixel", kMixedPixel}}}};
  if (!poses.empty()) all["pose"] = poses.front();
  return all;
}

json sensor(const Scene& scene) {
  if (scene.request.sensor == SensorKind::kHandheld)
    return {{"type", "depth_camera"}, {"frames", scene.T_scan_camera.size()}};
  json stations = json::array();
  for (const Eigen::Vector3d& p : scene.station_positions) stations.push_back(numbers(p));
  return {{"type", "laser_scanner"}, {"sigma_m", scene.request.noise_m}, {"stations", stations}};
}

Status write_json(const std::filesystem::path& path, const json& content) {
  return write_file_whole(path, json_text(content));
}

}  // namespace

Status write_scene(const Scene& scene, const std::filesystem::path& folder) {
  for (const char* each : {"", "design", "truth"})
    if (Status made = make_folder(folder / each); !made) return made;
  const bool handheld = scene.request.sensor == SensorKind::kHandheld;
  PlyColumn station{.name = handheld ? "frame" : "station", .type = PlyColumn::Type::kUchar};
  station.uchars = scene.stations;
  if (Status s = write_ply(folder / "cloud.ply", scene.cloud, {station}); !s) return s;
  if (Status s = write_json(folder / "sensor.json", sensor(scene)); !s) return s;
  if (Status s = write_file_whole(folder / "design" / "model.glb", scene.glb()); !s) return s;
  std::string labels;
  for (const std::uint16_t label : scene.labels) {
    labels.push_back(static_cast<char>(label & 0xFF));
    labels.push_back(static_cast<char>(label >> 8));
  }
  if (Status s = write_file_whole(folder / "truth" / "labels.bin", labels); !s) return s;
  if (!scene.objects.empty()) {
    const Pose T_design_scan = scene.objects.front().T_scan_design.inverse();
    const json pose = {{"T_design_scan", row_major(T_design_scan)}};
    if (Status s = write_json(folder / "truth" / "pose.json", pose); !s) return s;
  }
  if (handheld) {
    json cameras = json::array();
    for (std::size_t i = 0; i < scene.T_scan_camera.size(); ++i)
      cameras.push_back({{"frame", i}, {"camera_to_world", rows(scene.T_scan_camera[i])}});
    if (Status s = write_json(folder / "truth" / "poses.json", cameras); !s) return s;
  }
  return write_json(folder / "truth" / "truth.json", truth(scene));
}

}  // namespace spool::campaign
