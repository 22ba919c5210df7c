// An inspection's folder and the scan that it was made of, as a capture takes them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "app/evidence/capture.h"
#include "app/evidence/scan_snapshot.h"
#include "vision/core/result.h"

namespace spool::evidence {

// Report, pictures and points of the folder that write_inspection() wrote, what the report says of
// itself, and the options that it was made with; the small files among these come along. The state
// is the report's SHA-256. Check, step, key and scan are left to the caller. kBadInput: no report
// there; kIo. Any thread.
[[nodiscard]] Result<CaptureRequest> report_request(const std::filesystem::path& folder);

// The one frame that the report is of, which is written as a depth folder with the picture of it
// that has no overlay. kBadInput: it is not the report's (its SHA-256 is another); `name` is what
// the sentence calls it.
[[nodiscard]] Status add_frame(OneFrame one, const std::string& name, CaptureRequest& request);

// The same out of a scan by its name: a cloud as it is, or the report's frame of a recording. "":
// the scan that the report names. kBadInput, kIo: as for the frame, or it cannot be read.
[[nodiscard]] Status add_scan(const std::string& scan, CaptureRequest& request);

}  // namespace spool::evidence
