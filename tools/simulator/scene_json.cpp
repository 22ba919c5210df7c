// Scenes from JSON.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <set>

#include "app/common/json_file.h"
#include "tools/simulator/scene.h"

namespace spool::simulator {
namespace {

using nlohmann::json;

// One object of the scene with the checks that every part of it needs.
class Reader {
 public:
  Reader(const json& object, const std::string& file, const std::string& where,
         std::set<std::string> known)
      : json_(object), object_(object, file, where) {
    if (!json_.is_object()) return;
    for (const auto& [key, value] : json_.items())
      if (known.count(key) == 0) object_.fail(key, "is not known here; correct the spelling");
  }

  const json* child(const char* key) const {
    const auto found = json_.is_object() ? json_.find(key) : json_.end();
    return json_.is_object() && found != json_.end() ? &*found : nullptr;
  }
  void range(const char* key, double& value, double low, double high) {
    value = object_.number_or(key, value);
    if (value < low || value > high)
      object_.fail(key, "has to lie between " + short_text(low) + " and " + short_text(high));
  }
  void flag(const char* key, bool& value) {
    const json* found = child(key);
    if (found == nullptr) return;
    if (!found->is_boolean()) return object_.fail(key, "has to be true or false");
    value = found->get<bool>();
  }
  void seed(const char* key, std::uint32_t& value) {
    double number = value;
    range(key, number, 0, 4294967295.0);
    value = static_cast<std::uint32_t>(number);
  }
  void vector(const char* key, Eigen::Vector3d& value, double limit) {
    if (child(key) == nullptr) return;
    const auto numbers = object_.numbers(key, 3);
    if (numbers.size() != 3) return;
    value = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
    if (value.cwiseAbs().maxCoeff() > limit)
      object_.fail(key, "has to lie within " + short_text(limit));
  }
  bool pose(const char* key, Pose& value) {
    if (child(key) == nullptr) return false;
    const auto pose = pose_from_row_major(object_.numbers(key, 16));
    if (pose)
      value = *pose;
    else
      object_.fail(key, "has to be 16 numbers of a rigid pose, row by row");
    return pose.has_value();
  }
  JsonObject& object() { return object_; }
  const std::optional<Error>& error() const { return object_.error(); }

 private:
  static std::string short_text(double x) {
    std::string text = std::to_string(x);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
  }
  const json& json_;
  JsonObject object_;
};

constexpr double kRoom = 100;  // m; nothing in a scene is further away

std::optional<Error> read_change(const json& from, const std::string& file,
                                 const std::string& where, AsBuiltChange& change) {
  Reader reader(
      from, file, where,
      {"part", "translation_m", "rotation_rad", "about", "length_m", "followers", "missing"});
  change.part = reader.object().text_or("part", "");
  if (change.part.empty()) reader.object().fail("part", "has to name a part of the design");
  change.about = reader.object().text_or("about", "");
  reader.vector("translation_m", change.translation_m, 10);
  reader.vector("rotation_rad", change.rotation_rad, 7);
  reader.range("length_m", change.length_m, -1, 1);
  reader.flag("followers", change.followers);
  reader.flag("missing", change.missing);
  return reader.error();
}

std::optional<Error> read_body(const json& from, const std::string& file, const std::string& where,
                               Body& body) {
  Reader reader(from, file, where,
                {"name", "kind", "size_m", "diameter_m", "length_m", "position_m", "rotation_rad",
                 "bright_metal"});
  const std::string kind = reader.object().text_or("kind", "");
  body.name = reader.object().text_or("name", kind);
  if (kind == "box") {
    reader.vector("size_m", body.size_m, kRoom);
  } else if (kind == "cylinder") {
    body.kind = BodyKind::kCylinder;
    double diameter = 0.1, length = 1;
    reader.range("diameter_m", diameter, 1e-4, kRoom);
    reader.range("length_m", length, 1e-4, kRoom);
    body.size_m = {diameter, diameter, length};
  } else {
    reader.object().fail("kind", "has to be box or cylinder");
  }
  if (!(body.size_m.minCoeff() > 0)) reader.object().fail("size_m", "has to be more than 0");
  Eigen::Vector3d position = Eigen::Vector3d::Zero(), rotation = Eigen::Vector3d::Zero();
  reader.vector("position_m", position, kRoom);
  reader.vector("rotation_rad", rotation, 7);
  body.T_map_body.linear() = rotation_from_vector(rotation);
  body.T_map_body.translation() = position;
  reader.flag("bright_metal", body.bright_metal);
  return reader.error();
}

std::optional<Error> read_trajectory(const json& from, const std::string& file, Trajectory& to) {
  Reader reader(from, file, "trajectory",
                {"kind", "centre_m", "near_m", "far_m", "sweep_rad", "start_rad", "low_rad",
                 "high_rad", "period_s", "tremor_m", "tremor_rad", "seed", "T_map_camera"});
  const std::string kind = reader.object().text_or("kind", "orbit");
  if (kind != "orbit" && kind != "fixed") reader.object().fail("kind", "has to be orbit or fixed");
  to.kind = kind == "fixed" ? TrajectoryKind::kFixed : TrajectoryKind::kOrbit;
  if (reader.child("centre_m") != nullptr) {
    to.centre_m = Eigen::Vector3d::Zero();
    reader.vector("centre_m", *to.centre_m, kRoom);
  }
  reader.range("near_m", to.near_m, 0.05, kRoom);
  reader.range("far_m", to.far_m, to.near_m, kRoom);
  reader.range("sweep_rad", to.sweep_rad, 0, 7);
  reader.range("start_rad", to.start_rad, -7, 7);
  reader.range("low_rad", to.low_rad, -1.5, 1.5);
  reader.range("high_rad", to.high_rad, to.low_rad, 1.5);
  reader.range("period_s", to.period_s, 1, 1e6);
  reader.range("tremor_m", to.tremor_m, 0, 0.1);
  reader.range("tremor_rad", to.tremor_rad, 0, 0.2);
  reader.seed("seed", to.seed);
  if (!reader.pose("T_map_camera", to.T_map_camera) && to.kind == TrajectoryKind::kFixed)
    reader.object().fail("T_map_camera", "is missing, a fixed camera needs it");
  return reader.error();
}

std::optional<Error> read_sensor(const json& from, const std::string& file, SensorSettings& to) {
  Reader reader(from, file, "sensor",
                {"width", "height", "focal_px", "depth_unit_m", "frames_per_second", "noise",
                 "dropout", "shadow", "seed", "baseline_m", "near_m", "far_m", "radial_warp",
                 "scale_error", "mirrored"});
  double width = to.camera.width, height = to.camera.height;
  reader.range("width", width, 8, 4096);
  reader.range("height", height, 8, 4096);
  to.camera.width = static_cast<int>(width);
  to.camera.height = static_cast<int>(height);
  to.camera.fx = 575.0 * to.camera.width / 640;
  reader.range("focal_px", to.camera.fx, 1, 1e5);
  to.camera.fy = to.camera.fx;
  to.camera.cx = to.camera.width / 2.0;  // what OpenNI2 takes it to be
  to.camera.cy = to.camera.height / 2.0;
  reader.range("depth_unit_m", to.camera.depth_unit_m, 1e-4, 1e-3);
  if (to.camera.depth_unit_m != 1e-3 && to.camera.depth_unit_m != 1e-4)
    reader.object().fail("depth_unit_m", "has to be 0.001 or 0.0001, as OpenNI2 has them");
  reader.range("frames_per_second", to.frames_per_second, 1, 120);
  reader.flag("noise", to.noise);
  reader.flag("dropout", to.dropout);
  reader.flag("shadow", to.shadow);
  reader.seed("seed", to.seed);
  reader.range("baseline_m", to.baseline_m, 1e-3, 1);
  reader.range("near_m", to.near_m, 0.01, 60);
  reader.range("far_m", to.far_m, to.near_m, 65534 * to.camera.depth_unit_m);
  reader.range("radial_warp", to.radial_warp, -0.1, 0.1);
  reader.range("scale_error", to.scale_error, -0.1, 0.1);
  reader.flag("mirrored", to.mirrored);
  return reader.error();
}

Body standing(const std::string& name, const Eigen::Vector3d& size, double top_m) {
  Body body;
  body.name = name;
  body.size_m = size;
  body.T_map_body.translation() = Eigen::Vector3d(0, 0, top_m - size.z() / 2);
  return body;
}

// The table and the floor below it: there unless the scene says null.
std::optional<Error> read_ground(Reader& reader, const std::string& file, Scene& scene) {
  const json* table = reader.child("table");
  if (table == nullptr || !table->is_null()) {
    Eigen::Vector3d size(2.0, 1.4, 0.03);
    scene.table_height_m = 0.8;
    if (table != nullptr) {
      Reader top(*table, file, "table", {"height_m", "size_m"});
      top.range("height_m", scene.table_height_m, 0.05, 10);
      top.vector("size_m", size, kRoom);
      if (!(size.minCoeff() > 0)) top.object().fail("size_m", "has to be more than 0");
      if (top.error()) return top.error();
    }
    scene.bodies.push_back(standing("table", size, scene.table_height_m));
  }
  bool floor = true;
  reader.flag("floor", floor);
  if (floor) scene.bodies.push_back(standing("floor", {12, 12, 0.1}, 0));
  return std::nullopt;
}

template <class T, class Read>
std::optional<Error> read_list(Reader& reader, const char* key, const Read& read,
                               std::vector<T>& to) {
  if (reader.child(key) == nullptr) return std::nullopt;
  const json& list = reader.object().array(key);
  for (std::size_t i = 0; i < list.size(); ++i) {
    T one;
    if (auto error = read(list[i], key + ("[" + std::to_string(i) + "]"), one)) return error;
    to.push_back(std::move(one));
  }
  return std::nullopt;
}

}  // namespace

Result<Scene> read_scene(const std::filesystem::path& path) {
  const auto text = read_json(path);
  if (!text) return text.error();
  const std::string file = path.string();
  Reader reader(*text, file, "",
                {"design", "T_map_design", "as_built", "clutter", "table", "floor", "trajectory",
                 "sensor", "unplug"});
  Scene scene;
  scene.sensor.camera.width = 640;
  scene.sensor.camera.height = 480;
  const std::string design = reader.object().text_or("design", "");
  if (!design.empty()) scene.design = path.parent_path() / design;
  scene.on_table = !reader.pose("T_map_design", scene.T_map_design);
  const auto change = [&](const json& from, const std::string& where, AsBuiltChange& to) {
    return read_change(from, file, where, to);
  };
  const auto body = [&](const json& from, const std::string& where, Body& to) {
    return read_body(from, file, where, to);
  };
  const auto unplugging = [&](const json& from, const std::string& where,
                              Unplugging& to) -> std::optional<Error> {
    Reader one(from, file, where, {"at_s", "for_s"});
    one.range("at_s", to.at_s, 0, 1e6);
    one.range("for_s", to.for_s, 0, 1e6);
    return one.error();
  };
  if (auto error = read_ground(reader, file, scene)) return *error;
  if (auto error = read_list(reader, "as_built", change, scene.as_built)) return *error;
  if (auto error = read_list(reader, "clutter", body, scene.bodies)) return *error;
  if (auto error = read_list(reader, "unplug", unplugging, scene.unplug)) return *error;
  const json nothing = json::object();
  const json* trajectory = reader.child("trajectory");
  const json* sensor = reader.child("sensor");
  if (auto error =
          read_trajectory(trajectory != nullptr ? *trajectory : nothing, file, scene.trajectory))
    return *error;
  if (auto error = read_sensor(sensor != nullptr ? *sensor : nothing, file, scene.sensor))
    return *error;
  if (reader.error()) return *reader.error();
  return scene;
}

}  // namespace spool::simulator
