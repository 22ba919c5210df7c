// One scan as an inspection takes it: a cloud file, or one frame of a recording, with what the
// report says of it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/evidence/inspection_record.h"
#include "vision/core/camera.h"
#include "vision/core/depth_frame.h"
#include "vision/core/length_unit.h"
#include "vision/core/point_cloud.h"
#include "vision/core/result.h"
#include "vision/scan/noise_model.h"

namespace spool::evidence {

struct ScanSnapshot {
  PointCloud
      cloud;  // m; a file's points in its order, NaN kept; a frame's measured points with normals
  NoiseModel noise;       // of the sensor; of a cloud a constant found in the cloud itself
  double noise_m = 0;     // m, of a typical point
  double correlated = 1;  // readings of a depth image that are worth one
  ScanRecord record;
  std::string sensor;
  Calibration calibration;
  bool single_frame = false;
  std::vector<std::string> warnings;
};

// One frame of what open_source() takes, `number` counted from 0. Errors name file or device.
struct OneFrame {
  std::shared_ptr<const DepthFrame> frame;
  Camera camera;
  std::string description;  // of the source
};
[[nodiscard]] Result<OneFrame> read_one_frame(const std::string& text, std::int64_t number);
// What an inspection takes of a frame that is at hand: `file` and `kind` are how the report names
// where it is from. kBadInput: of another size than the camera's, or it measured nothing. Any
// thread.
[[nodiscard]] Result<ScanSnapshot> frame_snapshot(const OneFrame& one, const std::string& file,
                                                  const std::string& kind,
                                                  const NoiseModel& noise = {});
// SHA-256 of a frame's counts, as ScanRecord has it.
[[nodiscard]] std::string digest_of(const DepthFrame& frame);

// Reads a cloud file, or `frame` of what open_source() takes. `unit` is for cloud files only:
// kUsage for a recording, whose camera says its own. `known`: in place of the camera's own
// calibration. Errors name the file or device.
[[nodiscard]] Result<ScanSnapshot> read_scan(const std::string& text,
                                             std::optional<LengthUnit> unit,
                                             std::optional<std::int64_t> frame,
                                             const std::optional<Calibration>& known = {});

}  // namespace spool::evidence
