// One scan as an inspection takes it: a cloud file, or one frame of a recording, with what the
// report says of it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/scan_snapshot.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "app/sensor/depth_source.h"
#include "vision/core/file_digest.h"
#include "vision/scan/back_projection.h"
#include "vision/scan/cloud_file.h"
#include "vision/scan/noise_estimate.h"
#include "vision/scan/normals.h"
#include "vision/scan/reading_noise.h"

namespace spool::evidence {
namespace {

constexpr std::chrono::seconds kFrameTimeout{5};  // a camera needs up to 2 s for its first frame

Result<ScanSnapshot> read_cloud_scan(const std::filesystem::path& path,
                                     std::optional<LengthUnit> unit) {
  auto file = read_cloud(path, unit);
  if (!file) return file.error();
  ScanSnapshot scan;
  scan.record.file = path.string();
  scan.record.sha256 = file->sha256;
  scan.record.kind = "cloud";
  scan.record.points = file->finite;
  scan.record.unit = name(file->unit);
  scan.record.unit_inferred = file->unit_inferred;
  scan.sensor = "cloud file";
  scan.warnings = file->warnings;
  scan.noise_m = estimate_noise(file->cloud);
  scan.noise.constant_m = scan.noise_m;
  // Stations that were merged lie off each other; how far nobody knows of a bare file. A quarter of
  // the noise of a point is assumed, unless a calibration says more.
  scan.calibration.warp_u_m = scan.noise_m / 4;
  scan.cloud = std::move(file->cloud);
  return scan;
}

// The first frame the source gives.
Result<std::shared_ptr<const DepthFrame>> first_frame(sensor::DepthSource& source,
                                                      const std::string& text, std::int64_t frame) {
  const auto end = std::chrono::steady_clock::now() + kFrameTimeout;
  while (std::chrono::steady_clock::now() < end) {
    auto output = source.next(std::chrono::milliseconds(200));
    if (!output) return output.error();
    if (output->event == sensor::SourceEvent::kFrame) return output->frame;
    if (output->event == sensor::SourceEvent::kEnd)
      return Error{ErrorCode::kBadInput, text + ": has no frame " + std::to_string(frame) +
                                             "; frames count from 0, choose an earlier one"};
  }
  return Error{ErrorCode::kNoDevice,
               text + ": gave no frame within five seconds; check that the sensor is plugged in"};
}

std::string kind_of(const std::string& text) {
  std::error_code ignored;
  if (std::filesystem::is_directory(text, ignored)) return "depth folder";
  return text.ends_with(".oni") ? "oni" : "device";
}

// The middle of the measured ranges (m).
double median_range(const PointCloud& cloud) {
  std::vector<float> ranges;
  for (const auto& point : cloud.points) ranges.push_back(point.z());
  const auto middle = ranges.begin() + static_cast<std::ptrdiff_t>(ranges.size() / 2);
  std::nth_element(ranges.begin(), middle, ranges.end());
  return static_cast<double>(*middle);
}

Result<ScanSnapshot> read_frame_scan(const std::string& text, std::int64_t number,
                                     const std::optional<Calibration>& known) {
  auto one = read_one_frame(text, number);
  if (!one) return one.error();
  if (known) one->camera.calibration = *known;
  return frame_snapshot(*one, text, kind_of(text));
}

}  // namespace

Result<ScanSnapshot> frame_snapshot(const OneFrame& one, const std::string& file,
                                    const std::string& kind, const NoiseModel& noise) {
  const DepthFrame& frame = *one.frame;
  auto organised = back_project(frame, one.camera);
  if (!organised) return Error{organised.error().code, file + ": " + organised.error().message};
  ScanSnapshot scan;
  scan.noise = noise;
  estimate_organised_normals(*organised, one.camera, scan.noise);
  scan.cloud = measured_points(*organised);
  if (scan.cloud.empty())
    return Error{ErrorCode::kBadInput, file + ": frame " + std::to_string(frame.index) +
                                           " measured nothing; choose another frame"};
  scan.record.file = file;
  scan.record.sha256 = digest_of(frame);
  scan.record.kind = kind;
  scan.record.points = scan.cloud.size();
  scan.record.frame = frame.index;
  scan.sensor = one.description;
  scan.calibration = one.camera.calibration;
  scan.correlated = correlated_readings(one.camera, 1);
  scan.noise_m = scan.noise.axial_m(median_range(scan.cloud));
  scan.single_frame = true;
  scan.warnings.push_back("One frame of the recording is used, frame " +
                          std::to_string(frame.index) + "; the others are not looked at.");
  return scan;
}

Result<OneFrame> read_one_frame(const std::string& text, std::int64_t number) {
  auto source = sensor::open_source(text, {.speed = 0, .first_frame = number});
  if (!source) return source.error();
  const auto frame = first_frame(**source, text, number);
  if (!frame) return frame.error();
  return OneFrame{*frame, (*source)->camera(), (*source)->description()};
}

std::string digest_of(const DepthFrame& frame) {
  const auto* bytes = reinterpret_cast<const char*>(frame.depth.data());
  return sha256_hex({bytes, frame.depth.size() * sizeof(frame.depth[0])});
}

Result<ScanSnapshot> read_scan(const std::string& text, std::optional<LengthUnit> unit,
                               std::optional<std::int64_t> frame,
                               const std::optional<Calibration>& known) {
  if (is_cloud_file(text)) {
    if (frame)
      return Error{ErrorCode::kUsage, "--frame is for recordings; " + text + " is one cloud"};
    return read_cloud_scan(text, unit);
  }
  if (unit)
    return Error{ErrorCode::kUsage,
                 "--scan-unit is for cloud files; " + text + " says the unit of its depth itself"};
  return read_frame_scan(text, frame.value_or(0), known);
}

}  // namespace spool::evidence
