// Writes an inspection's folder: report.json, report.html, points.ply, overlay_*.png (ARCHITECTURE,
// What inspect writes).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/evidence/inspection_record.h"
#include "render/image.h"
#include "vision/core/result.h"

namespace spool::evidence {

struct OverlayPicture {
  std::string file;  // "overlay_1.png"
  std::string text;  // from where it is seen
  render::Image image;
};

// The few views that together show every part, drawn with the current GL context; none where no
// pose was found: points and design would not belong together.
[[nodiscard]] Result<std::vector<OverlayPicture>> draw_overlays(const InspectionRecord& record,
                                                                int width = 1280, int height = 800);

// How the statuses of this version are decided: one or two sentences for reports.
[[nodiscard]] std::string decision_rule();

// report.json as ARCHITECTURE, What inspect writes fixes it (schema spoolsight-report/1).
[[nodiscard]] std::string report_json(const InspectionRecord& record);
// One offline file with the pictures inside.
[[nodiscard]] std::string report_html(const InspectionRecord& record,
                                      const std::vector<OverlayPicture>& pictures);

// Everything into `folder`: prepared beside it and moved into place only when all of it is there,
// so that a failure leaves what the folder held before. report.json comes last: its presence says
// the folder is complete. Pictures of an earlier inspection are replaced. kIo names the file that
// could not be written.
[[nodiscard]] Status write_inspection(const std::filesystem::path& folder,
                                      const InspectionRecord& record,
                                      const std::vector<OverlayPicture>& pictures);

}  // namespace spool::evidence
