// All that one written inspection needs beside its findings: the inputs by name and hash, who
// measured, in which units.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "vision/core/camera.h"
#include "vision/inspect/inspection.h"
#include "vision/inspect/part_reading.h"
#include "vision/inspector.h"

namespace spool::evidence {

// The scan as the report names it.
struct ScanRecord {
  std::string file;
  std::string sha256;       // of the file; of a sequence: of the frame's depth counts
  std::string kind;         // "cloud", "depth folder", "oni", "device"
  std::size_t points = 0;   // measured (finite)
  std::int64_t frame = -1;  // the frame used; -1 for a cloud
  std::string unit = "m";
  bool unit_inferred = false;
};

struct InspectionRecord {
  std::shared_ptr<const PreparedDesign> design;
  Inspection inspection;
  std::vector<PartReading> over_frames;  // of a live check: one a part; else empty
  ScanRecord scan;
  std::string sensor;  // description of the source, or "cloud file"
  Calibration calibration;
  std::string standard = "pfi-es3";
  std::vector<std::string> datum;  // part names
  bool feet_inches = false;        // display only
  double noise_m = 0;   // m, typical random error of a point: the neutral band of the colours
  std::string created;  // ISO 8601 in UTC, when the inspection was made; empty: not said
  std::vector<std::string> warnings;
  // The flags that it was made with, as replay takes them, and the SHA-256 of files among them;
  // empty where it was made of more than one frame.
  std::map<std::string, std::string> options = {};
};

}  // namespace spool::evidence
