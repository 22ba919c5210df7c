// All that one check of the screen leaves behind, kept until it is on the disk.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/check_evidence.h"

#include "app/common/json_file.h"
#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"

namespace spool {

namespace {

std::filesystem::path pose_path(const CheckEvidence& check) { return check.folder / "pose.json"; }

}  // namespace

Pose as_read_back(const Pose& pose) {
  const auto numbers = row_major(pose);
  return pose_from_row_major(numbers).value_or(pose);
}

void keep_options(const Pose& T_design_scan, AlignMethod posed_by, CheckEvidence& check) {
  check.pose_file = json_text({{"T_design_scan", row_major(T_design_scan)}});
  check.record.options = {{"align", std::string(name(AlignMethod::kPose))},
                          {"pose", pose_path(check).string()},
                          {"pose_sha256", sha256_hex(check.pose_file)},
                          {"posed_by", std::string(name(posed_by))},
                          {"standard", check.record.standard},
                          {"units", "mm"},
                          {"seed", "1"},
                          {"frame", std::to_string(check.frame.frame->index)}};
}

Status write_check(const CheckEvidence& check) {
  if (!check.pose_file.empty()) {
    if (Status made = make_folder(check.folder); !made) return made;
    if (Status written = write_file_whole(pose_path(check), check.pose_file); !written)
      return written;
  }
  return evidence::write_inspection(check.folder, check.record, check.pictures);
}

}  // namespace spool
