// The check of a sensor on a flat wall: frames in, sensor.json and what is said of it out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/sensor_check_files.h"

#include <chrono>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "app/common/json_file.h"
#include "app/sensor/depth_source.h"
#include "vision/core/file_digest.h"
#include "vision/scan/back_projection.h"

namespace spool::evidence {
namespace {

constexpr std::size_t kMostFrames = 30;  // a second: random noise is spent by then
constexpr auto kTimeout = std::chrono::seconds(5);

constexpr const char* kNoScale =
    "A flat wall does not tell a sensor's scale: scale_u is what it was before. Pieces of known "
    "size in a scan narrow it, or a scale bar.";

std::string text_of(const char* format, double a, double b = 0) {
  char text[160];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

}  // namespace

Result<SensorCheckRecord> check_sensor(const std::string& text,
                                       const std::optional<Calibration>& known,
                                       const std::string& created) {
  auto source = sensor::open_source(text, {.speed = 0});
  if (!source) return source.error();
  Camera camera = (*source)->camera();
  const Calibration before = known.value_or(camera.calibration);
  camera.calibration = {};
  SensorCheck check(camera, NoiseModel{});
  std::string id;
  std::size_t frames = 0;
  const auto end = std::chrono::steady_clock::now() + kTimeout;
  while (frames < kMostFrames) {
    const auto output = (*source)->next(std::chrono::milliseconds(200));
    if (!output) return output.error();
    if (output->event == sensor::SourceEvent::kEnd) break;
    if (output->event != sensor::SourceEvent::kFrame) {
      if (std::chrono::steady_clock::now() < end) continue;
      break;
    }
    const DepthFrame& frame = *output->frame;
    const auto cloud = back_project(frame, camera);
    if (!cloud) return Error{cloud.error().code, text + ": " + cloud.error().message};
    if (const Status status = check.add(*cloud); !status)
      return Error{status.error().code,
                   text + ": frame " + std::to_string(frame.index) + ": " + status.error().message};
    if (id.empty())
      id = sha256_hex({reinterpret_cast<const char*>(frame.depth.data()),
                       frame.depth.size() * sizeof(frame.depth[0])})
               .substr(0, 8);
    ++frames;
  }
  if (frames == 0)
    return Error{ErrorCode::kNoDevice,
                 text + ": gave no frame; check the recording or that the sensor is plugged in"};
  SensorCheckRecord record{text, (*source)->description(), created, check.finish(before.scale_u)};
  record.result.calibration.id = "wall-" + id;
  record.result.calibration.date = created.substr(0, 10);
  return record;
}

std::string sensor_json(const SensorCheckRecord& record) {
  const SensorCheckResult& result = record.result;
  nlohmann::json noise = nlohmann::json::array(), serves = nlohmann::json::array();
  for (const NoiseAtRange& each : result.noise)
    noise.push_back({{"range_m", each.range_m},
                     {"measured_m", each.measured_m},
                     {"model_m", each.model_m},
                     {"readings", each.readings}});
  for (const ServedTolerance& each : result.serves) {
    nlohmann::json at = nlohmann::json::array();
    for (const ServedLength& length : each.at)
      at.push_back({{"range_m", length.range_m}, {"longest_m", length.longest_m}});
    serves.push_back({{"tolerance_m", each.tolerance_m}, {"at", at}});
  }
  nlohmann::json bend = nlohmann::json::array(), u = nlohmann::json::array();
  for (const FlatCells::Cell& cell : result.map.cells) {
    const bool is_seen = cell.readings > 0;
    bend.push_back(is_seen ? nlohmann::json(result.range_m * cell.off) : nlohmann::json(nullptr));
    u.push_back(is_seen ? nlohmann::json(result.range_m * cell.u) : nlohmann::json(nullptr));
  }
  return json_text({{"schema", "spoolsight-sensor/1"},
                    {"calibration", calibration_to_json(result.calibration)},
                    {"source", record.source},
                    {"sensor", record.sensor},
                    {"created", record.created},
                    {"frames", result.frames},
                    {"range_m", result.range_m},
                    {"corner_m", result.corner_m},
                    {"corner_u_m", result.corner_u_m},
                    {"left_m", result.left_m},
                    {"noise", noise},
                    {"noise_ratio", result.noise_ratio},
                    {"warp_map",
                     {{"columns", FlatCells::kColumns},
                      {"rows", FlatCells::kRows},
                      {"bend_m", bend},
                      {"u_m", u}}},
                    {"serves", serves},
                    {"scale", kNoScale}});
}

std::string sensor_text(const SensorCheckRecord& record) {
  const SensorCheckResult& result = record.result;
  std::string text = text_of("warp: corners are bent by up to %.1f mm ± %.1f mm",
                             1000 * result.corner_m, 2000 * result.corner_u_m) +
                     text_of(" at %.2f m; the calibration takes it off, %.1f mm are left\n",
                             result.range_m, 1000 * result.left_m);
  for (const NoiseAtRange& each : result.noise)
    text += text_of("noise at %.2f m: %.1f mm", each.range_m, 1000 * each.measured_m) +
            text_of(", the model says %.1f mm\n", 1000 * each.model_m);
  text += text_of("scale: uncertain by %.2g %%. ", 100 * result.calibration.scale_u) +
          std::string(kNoScale) + "\n";
  for (const ServedTolerance& each : result.serves) {
    text += text_of("± %.0f mm can be proved ", 1000 * each.tolerance_m);
    std::string lengths;
    for (const ServedLength& at : each.at)
      if (at.longest_m > 0.05)
        lengths += (lengths.empty() ? "on lengths to " : ", ") +
                   text_of("%.1f m from %.2g m", at.longest_m, at.range_m);
    text +=
        (lengths.empty() ? "on no length: calibrate the sensor or use another" : lengths) + "\n";
  }
  return text;
}

}  // namespace spool::evidence
