// camera.json and calibration files of ARCHITECTURE, Files, read and written.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "app/common/json_file.h"

namespace spool {
namespace {

// The object under "calibration"; its own error is handed up to `parent`.
Result<Calibration> calibration_of(const nlohmann::json& parent, const std::string& file) {
  JsonObject object(parent.at("calibration"), file, "calibration");
  Calibration calibration;
  calibration.id = object.text_or("id", "");
  calibration.date = object.text_or("date", "");
  calibration.scale_u = object.number_or("scale_u", calibration.scale_u);
  calibration.warp_u_m = object.number_or("warp_u_m", calibration.warp_u_m);
  if (object.has("warp")) {
    const auto share = object.numbers("warp", DepthWarp::kTerms);
    if (!object.error()) std::ranges::copy(share, calibration.warp.share.begin());
    // A fifth of the depth no camera is bent by, and a depth that turns round is none.
    if (!(calibration.warp.most() < 0.2))
      object.fail("warp", "bends the picture by a fifth of its depth");
  }
  // A tenth is already no depth camera; a negative uncertainty is none at all.
  if (calibration.scale_u < 0 || calibration.scale_u > 0.1)
    object.fail("scale_u", "has to lie between 0 and 0.1 (a fraction)");
  if (calibration.warp_u_m < 0 || calibration.warp_u_m > 0.1)
    object.fail("warp_u_m", "has to lie between 0 and 0.1 m");
  if (object.error()) return *object.error();
  return calibration;
}

}  // namespace

Result<Camera> read_camera(const std::filesystem::path& path) {
  const auto json = read_json(path);
  if (!json) return json.error();
  JsonObject object(*json, path.string());
  Camera camera;
  camera.width = object.integer("width");
  camera.height = object.integer("height");
  camera.fx = object.number("fx");
  camera.fy = object.number("fy");
  camera.cx = object.number("cx");
  camera.cy = object.number("cy");
  camera.depth_unit_m = object.number("depth_unit_m");
  if (object.error()) return *object.error();
  const auto positive = [&](const char* key, double value) {
    if (!(value > 0)) object.fail(key, "has to be more than 0");
  };
  positive("width", camera.width);
  positive("height", camera.height);
  positive("fx", camera.fx);
  positive("fy", camera.fy);
  positive("depth_unit_m", camera.depth_unit_m);
  // Between a twentieth of a degree and 179 from side to side.
  const auto sees = [](double f, int side) { return f > 0.004 * side && f < 1150.0 * side; };
  if (!object.error() &&
      !(camera.is_valid() && sees(camera.fx, camera.width) && sees(camera.fy, camera.height)))
    object.fail("", "holds intrinsics no camera has");
  if (object.error()) return *object.error();
  if (object.has("calibration")) {
    const auto calibration = calibration_of(*json, path.string());
    if (!calibration) return calibration.error();
    camera.calibration = *calibration;
  }
  return camera;
}

Result<Calibration> read_calibration(const std::filesystem::path& path) {
  const auto json = read_json(path);
  if (!json) return json.error();
  if (!json->is_object() || !json->contains("calibration"))
    return Error{
        ErrorCode::kBadInput,
        path.string() +
            ": \"calibration\" is missing; name a calibration or a camera.json that holds one"};
  return calibration_of(*json, path.string());
}

nlohmann::json calibration_to_json(const Calibration& calibration) {
  nlohmann::json json = {{"id", calibration.id},
                         {"date", calibration.date},
                         {"scale_u", calibration.scale_u},
                         {"warp_u_m", calibration.warp_u_m}};
  if (!calibration.warp.is_flat()) json["warp"] = calibration.warp.share;
  return json;
}

nlohmann::json camera_to_json(const Camera& camera) {
  nlohmann::json json = {{"width", camera.width},
                         {"height", camera.height},
                         {"fx", camera.fx},
                         {"fy", camera.fy},
                         {"cx", camera.cx},
                         {"cy", camera.cy},
                         {"depth_unit_m", camera.depth_unit_m}};
  if (!camera.calibration.id.empty()) json["calibration"] = calibration_to_json(camera.calibration);
  return json;
}

}  // namespace spool
