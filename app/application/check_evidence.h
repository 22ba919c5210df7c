// All that one check of the screen leaves behind, kept until it is on the disk.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/evidence/scan_snapshot.h"
#include "app/evidence/writer.h"
#include "vision/core/pose.h"
#include "vision/core/result.h"

namespace spool {

// All of one state: report, pictures and the frame that the numbers rest on.
struct CheckEvidence {
  std::filesystem::path folder;  // that the report is written to
  evidence::InspectionRecord record;
  std::vector<evidence::OverlayPicture> pictures;
  evidence::OneFrame frame;
  int part = -1;            // of the job, whose step was checked; -1: it becomes no capture
  std::uint64_t asked = 0;  // counts the checks of a run, as they were asked for
  std::string pose_file;    // text of folder/pose.json; "": none is written
};

// Makes the report one that `spoolsight-inspect --replay` can make again: the pose that was
// inspected at (m, the design file's own coordinates), and how it was come by. As read back from
// pose.json, whatever the last bits are.
void keep_options(const Pose& T_design_scan, AlignMethod posed_by, CheckEvidence& check);

// The pose as keep_options() writes it and a replay reads it, to the last bit.
[[nodiscard]] Pose as_read_back(const Pose& pose);

// The check's folder: pose.json, then as evidence::write_inspection(). Again over what is there.
// kIo. One thread.
[[nodiscard]] Status write_check(const CheckEvidence& check);

}  // namespace spool
