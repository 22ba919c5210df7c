// One design, one scan, one folder with what was found.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/inspection.h"

#include <chrono>
#include <cmath>
#include <ctime>
#include <iostream>

#include "app/common/json_file.h"
#include "app/common/length_text.h"
#include "app/common/progress.h"
#include "app/evidence/scan_snapshot.h"
#include "app/evidence/writer.h"
#include "render/egl_context.h"
#include "tools/inspect_designs.h"
#include "tools/replay_options.h"
#include "tools/sensor_check.h"

namespace spool::tools {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string now_utc() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

// ARCHITECTURE, Command lines: 3 outranks the statuses.
int exit_code_of(const Inspection& inspection) {
  const Alignment& alignment = inspection.alignment;
  if (!alignment.found || (alignment.ambiguous && !alignment.is_symmetric)) return 3;
  if (inspection.status == Verdict::kNotOk) return 1;
  return inspection.status == Verdict::kOk ? 0 : 2;
}

// Pictures, or why there are none as a warning: the numbers do not need a graphics driver.
Result<std::vector<evidence::OverlayPicture>> pictures_of(evidence::InspectionRecord& record) {
  const auto context = render::EglContext::surfaceless();
  if (!context) {
    record.warnings.push_back("There are no pictures: " + context.error().message);
    return std::vector<evidence::OverlayPicture>{};
  }
  return evidence::draw_overlays(record);
}

void print_summary(const evidence::InspectionRecord& record, bool has_pictures,
                   const InspectOptions& options) {
  const auto& inspection = record.inspection;
  const auto style = record.feet_inches ? LengthStyle::kFeetInch : LengthStyle::kMillimetre;
  std::cout << name(inspection.status) << ": " << inspection.status_reason << "\n";
  for (const auto& finding : inspection.findings) std::cout << "  found: " << finding.text << "\n";
  for (const auto& warning : record.warnings) std::cout << "warning: " << warning << "\n";
  for (const auto& finding : inspection.parts) {
    const auto& part = record.design->model.parts.at(static_cast<std::size_t>(finding.part));
    std::cout << "  " << part.name << ": " << name(finding.status) << ", "
              << percent_text(finding.deviation.coverage) << " seen";
    if (finding.deviation.points > 0)
      std::cout << ", mean " << signed_length_text(finding.deviation.mean_m, style)
                << ", 95 % within " << length_text(finding.deviation.p95_abs_m, style);
    std::cout << "\n";
  }
  for (const auto& dimension : inspection.dimensions)
    std::cout << "  " << dimension.kind << " " << dimension.name << ": " << name(dimension.status)
              << ". " << dimension.reason << "\n";
  const auto& alignment = inspection.alignment;
  if (alignment.found && alignment.overlap > 0)
    std::cout << "alignment: " << name(alignment.method) << ", "
              << length_text(alignment.rms_m, style) << " RMS, " << percent_text(alignment.overlap)
              << " of the points on the design\n";
  else if (alignment.found)
    std::cout << "alignment: " << name(alignment.method)
              << ", no point of the scan lies on the design there\n";
  std::cout << "written to " << options.out << ": report.html report.json points.ply"
            << (has_pictures ? " overlay_*.png\n" : "\n");
}

}  // namespace

Result<int> inspect(const InspectOptions& options) {
  Progress progress;
  if (auto status = check(options); !status) return status.error();
  if (!options.sensor_check.empty()) return run_sensor_check(options, now_utc());
  auto settings = inspector_options(options);
  if (!settings) return settings.error();
  std::optional<Calibration> calibration;
  if (!options.calibration.empty()) {
    const auto read = read_calibration(options.calibration);
    if (!read) return read.error();
    calibration = *read;
  }
  // The scan.
  progress.report("scan", 0);
  const auto scan_start = Clock::now();
  auto scan = evidence::read_scan(options.scan, parse_length_unit(options.scan_unit), options.frame,
                                  calibration);
  if (!scan) return scan.error();
  const double scan_s = seconds_since(scan_start);
  // The main path, for each design that may lie there.
  progress.report("design", 0);
  settings->single_frame = scan->single_frame;
  const Calibration& sensor = calibration ? *calibration : scan->calibration;
  settings->scale_u = sensor.scale_u;
  settings->warp_u_m = sensor.warp_u_m;
  settings->correlated = scan->correlated;
  const Watch watch{{},
                    [&](std::string_view stage, double share) { progress.report(stage, share); }};
  auto inspected = inspect_designs(options, *settings, scan->cloud, scan->noise,
                                   scan->record.unit_inferred, watch);
  if (!inspected) return inspected.error();
  const auto& design = inspected->design;
  inspected->inspection.timing_s["read_design"] = inspected->read_s;
  inspected->inspection.timing_s["read_scan"] = scan_s;
  const auto flags = options_text(options);
  if (!flags) return flags.error();
  const auto datum = datum_parts(options.datum, design->model);
  if (!datum) return datum.error();
  // What is left behind.
  evidence::InspectionRecord record{.design = design,
                                    .inspection = std::move(inspected->inspection),
                                    .scan = scan->record,
                                    .sensor = scan->sensor,
                                    .calibration = calibration.value_or(scan->calibration),
                                    .standard = options.standard,
                                    .datum = *datum,
                                    .feet_inches = options.units == "ft-in",
                                    .noise_m = scan->noise_m,
                                    .created = now_utc(),
                                    .warnings = design->model.warnings,
                                    .options = *flags};
  record.warnings.insert(record.warnings.end(), inspected->warnings.begin(),
                         inspected->warnings.end());
  record.warnings.insert(record.warnings.end(), scan->warnings.begin(), scan->warnings.end());
  progress.report("pictures", 0);
  const auto pictures = pictures_of(record);
  if (!pictures) return pictures.error();
  progress.report("writing", 0);
  if (auto status = evidence::write_inspection(options.out, record, *pictures); !status)
    return status.error();
  print_summary(record, !pictures->empty(), options);
  return exit_code_of(record.inspection);
}

}  // namespace spool::tools
