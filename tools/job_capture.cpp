// spoolsight-job capture and keygen: an inspection's folder and its scan become evidence of a job.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "app/common/json_file.h"
#include "app/evidence/capture.h"
#include "app/evidence/stored_scan.h"
#include "tools/job_commands.h"
#include "vision/scan/cloud_file.h"

namespace spool::tools {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string text_of(const json& report, const char* object, const char* key) {
  const auto found = report.find(object);
  if (found == report.end() || !found->is_object()) return {};
  const auto value = found->find(key);
  return value != found->end() && value->is_string() ? value->get<std::string>() : std::string();
}

// What of the report an entry says itself, so that one file tells what the capture is.
json context_of(const json& report) {
  json context = json::object();
  for (const char* key : {"alignment", "datum", "datum_text", "standard", "decision_rule", "sensor",
                          "software", "scan", "status"}) {
    if (report.contains(key)) context[key] = report[key];
  }
  return context;
}

// The report's files, in name order.
void take_report(const fs::path& folder, const std::string& report_sha256,
                 evidence::CaptureRequest& request) {
  request.files.push_back({folder / "report.json", "report.json", report_sha256});
  for (const char* file : {"report.html", "points.ply"})
    request.files.push_back({folder / file, file, ""});
  std::error_code code;
  std::vector<std::string> pictures;
  for (const auto& each : fs::directory_iterator(folder, code)) {
    const std::string file = each.path().filename().string();
    if (file.starts_with("overlay_") && file.ends_with(".png")) pictures.push_back(file);
  }
  std::sort(pictures.begin(), pictures.end());
  for (const std::string& file : pictures) request.files.push_back({folder / file, file, ""});
  if (!pictures.empty()) request.picture = pictures.front();
}

// The cloud as it is, or the one frame that the report is of.
Status take_scan(const std::string& scan, const json& report, evidence::CaptureRequest& request) {
  const std::string sha256 = text_of(report, "scan", "sha256");
  if (is_cloud_file(scan)) {
    const std::string name = "scan/scan" + fs::path(scan).extension().string();
    request.files.push_back({scan, name, sha256});
    request.options["scan"] = name;
    return {};
  }
  const auto& frame = report["scan"].value("frame", json());
  auto one =
      evidence::read_one_frame(scan, frame.is_number_integer() ? frame.get<std::int64_t>() : 0);
  if (!one) return one.error();
  if (evidence::digest_of(*one->frame) != sha256)
    return Error{ErrorCode::kBadInput,
                 scan +
                     ": is not the recording that the report was made with (the frame's SHA-256 "
                     "is another); name that"};
  request.more_bytes = evidence::stored_bytes(*one->frame);
  request.options["scan"] = "scan";
  request.options.erase("frame");
  request.write_more = [one = *one](const fs::path& folder) {
    return evidence::store_frame(one, folder);
  };
  return {};
}

// The flags that the report was made with; the small files among them come along.
void take_options(const json& report, evidence::CaptureRequest& request) {
  const auto options = report.find("options");
  if (options == report.end() || !options->is_object()) return;
  for (const auto& [name, value] : options->items()) {
    if (value.is_string()) request.options[name] = value.get<std::string>();
  }
  for (const char* name : {"pairs", "pose", "standard", "calibration"}) {
    const auto sha256 = request.options.find(std::string(name) + "_sha256");
    if (sha256 == request.options.end()) continue;
    const std::string stored = std::string("inputs/") + name + ".json";
    request.files.push_back({request.options[name], stored, sha256->second});
    request.options[name] = stored;
  }
}

}  // namespace

Result<int> capture(const JobOptions& options) {
  auto job = work_on(options);
  if (!job) return job.error();
  const fs::path folder = options.report;
  const fs::path report_file = folder / "report.json";
  const auto record = check_of(options, *job, report_file.string());
  if (!record) return record.error();
  const auto report = read_json(report_file);
  if (!report) return report.error();
  evidence::CaptureRequest request;
  request.step = options.step - 1;
  request.check = *record;
  request.state = record->report_sha256;
  request.context = context_of(*report);
  if (!options.key.empty()) {
    const auto key = evidence::read_key(options.key);
    if (!key) return key.error();
    request.key.emplace(*key);
  }
  take_report(folder, record->report_sha256, request);
  take_options(*report, request);
  const std::string scan = options.scan.empty() ? text_of(*report, "scan", "file") : options.scan;
  if (Status taken = take_scan(scan, *report, request); !taken) return taken.error();
  const auto captured = evidence::capture(*job, request);
  if (!captured) return captured.error();
  std::cout << "captured " << captured->folder.string() << ": check " << captured->check_id
            << " of step " << options.step << ", " << options.outcome << ", measured "
            << record->status << (request.key ? ", signed" : ", not signed") << "\n";
  return 0;
}

Result<int> keygen(const JobOptions& options) {
  const auto made = evidence::make_key(options.out);
  if (!made) return made.error();
  std::cout << "made " << options.out << " (keep it to yourself) and " << options.out
            << ".pub (give it to whoever verifies): " << *made << "\n";
  return 0;
}

}  // namespace spool::tools
