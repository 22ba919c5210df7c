// The check of a sensor on a flat wall: frames in, sensor.json and what is said of it out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "vision/core/result.h"
#include "vision/measure/sensor_check.h"

namespace spool::evidence {

struct SensorCheckRecord {
  std::string source, sensor;  // as it was opened; the driver's description
  std::string created;         // ISO 8601 in UTC
  SensorCheckResult result;
};

// Looks at up to 30 frames of a recording, depth folder or device. The scale stays what `known`
// says, or else the camera's own calibration; its warp is not applied to what is looked at. Errors
// name the source; kBadInput where it shows nothing flat, with the frame.
[[nodiscard]] Result<SensorCheckRecord> check_sensor(const std::string& source,
                                                     const std::optional<Calibration>& known,
                                                     const std::string& created);

// schema spoolsight-sensor/1: a calibration that --calibration takes, and what it rests on.
[[nodiscard]] std::string sensor_json(const SensorCheckRecord& record);
// The verdict for people, lines with units.
[[nodiscard]] std::string sensor_text(const SensorCheckRecord& record);

}  // namespace spool::evidence
