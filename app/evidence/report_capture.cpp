// An inspection's folder and the scan that it was made of, as a capture takes them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/report_capture.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/common/json_file.h"
#include "app/evidence/stored_scan.h"
#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"
#include "vision/scan/cloud_file.h"

namespace spool::evidence {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uint64_t kMaxReportBytes = std::uint64_t{64} << 20U;

const json& scan_of(const CaptureRequest& request) {
  static const json none = json::object();
  const auto found = request.context.find("scan");
  return found != request.context.end() && found->is_object() ? *found : none;
}

std::string text_of(const json& object, const char* key) {
  const auto value = object.find(key);
  return value != object.end() && value->is_string() ? value->get<std::string>() : std::string();
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
                 CaptureRequest& request) {
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

// The flags that the report was made with; the small files among them come along.
void take_options(const json& report, CaptureRequest& request) {
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

Result<CaptureRequest> report_request(const fs::path& folder) {
  const fs::path file = folder / "report.json";
  const auto bytes = read_file(file, kMaxReportBytes);
  if (!bytes) return bytes.error();
  const auto report = parse_json(*bytes, file.string());
  if (!report) return report.error();
  if (!report->is_object())
    return Error{ErrorCode::kBadInput, file.string() + ": is no report of spoolsight-inspect"};
  CaptureRequest request;
  request.state = sha256_hex(*bytes);
  request.context = context_of(*report);
  take_report(folder, request.state, request);
  take_options(*report, request);
  return request;
}

Status add_frame(OneFrame one, const std::string& name, CaptureRequest& request) {
  if (digest_of(*one.frame) != text_of(scan_of(request), "sha256"))
    return Error{ErrorCode::kBadInput,
                 name +
                     ": is not the recording that the report was made with (the frame's SHA-256 "
                     "is another); name that"};
  request.more_bytes = stored_bytes(*one.frame);
  request.options["scan"] = "scan";
  request.options.erase("frame");
  request.write_more = [one = std::move(one)](const fs::path& folder) {
    return store_frame(one, folder);
  };
  return {};
}

Status add_scan(const std::string& scan, CaptureRequest& request) {
  const json& named = scan_of(request);
  const std::string name = scan.empty() ? text_of(named, "file") : scan;
  if (is_cloud_file(name)) {
    const std::string stored = "scan/scan" + fs::path(name).extension().string();
    request.files.push_back({name, stored, text_of(named, "sha256")});
    request.options["scan"] = stored;
    return {};
  }
  const auto frame = named.find("frame");
  auto one = read_one_frame(
      name, frame != named.end() && frame->is_number_integer() ? frame->get<std::int64_t>() : 0);
  if (!one) return one.error();
  return add_frame(*std::move(one), name, request);
}

}  // namespace spool::evidence
