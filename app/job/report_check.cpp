// The numbers of a check out of an inspection's report.json.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/report_check.h"

#include <cmath>

#include "app/common/json_file.h"
#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"

namespace spool::job {
namespace {

using nlohmann::json;

std::string text_of(const json& object, const char* key) {
  if (!object.is_object()) return {};
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::optional<double> number_of(const json& object, const std::string& key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return std::nullopt;  // null: not measured
  return found->get<double>();
}

const json& list_of(const json& object, const char* key) {
  static const json empty = json::array();
  if (!object.is_object()) return empty;
  const auto found = object.find(key);
  return found != object.end() && found->is_array() ? *found : empty;
}

bool is_at(const std::string& place, const std::string& part) {
  return place == part || place.starts_with(part + "/");
}

// In metres or radians, by which of the two keys there is.
CheckNumber dimension_of(const json& entry) {
  const std::string unit = entry.contains("nominal_rad") ? "rad" : "m";
  const std::string end = "_" + unit;
  return {text_of(entry, "name"),
          text_of(entry, "kind"),
          unit,
          number_of(entry, "nominal" + end),
          number_of(entry, "measured" + end),
          number_of(entry, "deviation" + end),
          number_of(entry, "u" + end),
          number_of(entry, "tolerance" + end),
          text_of(entry, "status")};
}

CheckNumber size_of(const json& entry) {
  CheckNumber size{text_of(entry, "quantity"), "size", "m", number_of(entry, "nominal_m"),
                   number_of(entry, "measured_m")};
  size.u = number_of(entry, "u_m");
  if (size.nominal && size.measured) size.deviation = *size.measured - *size.nominal;
  size.status = text_of(entry, "status");
  return size;
}

template <std::size_t N>
std::optional<std::array<double, N>> numbers_of(const json& object, const char* key) {
  const json& list = list_of(object, key);
  if (list.size() != N) return std::nullopt;
  std::array<double, N> numbers{};
  for (std::size_t i = 0; i < N; ++i) {
    if (!list[i].is_number()) return std::nullopt;
    numbers[i] = list[i].get<double>();
  }
  return numbers;
}

// pose_error is inverse(nominal) * measured in the part's own frame.
void take_pose(const json& entry, const Part& part, CheckRecord& record) {
  const auto found = entry.find("pose_error");
  if (found == entry.end()) return;
  const auto t = numbers_of<3>(*found, "translation_m");
  const auto r = numbers_of<3>(*found, "rotation_rad");
  if (!t || !r) return;
  Vector6d error;
  error << (*t)[0], (*t)[1], (*t)[2], (*r)[0], (*r)[1], (*r)[2];
  record.T_design_part = row_major(part.T_design_part * pose_from_small(error));
  record.covariance = numbers_of<36>(*found, "covariance");
}

}  // namespace

Result<CheckRecord> check_from_report(const std::filesystem::path& report, const Part& part,
                                      const std::string& design_sha256) {
  const auto refuse = [&](const std::string& why) {
    return Error{ErrorCode::kBadInput, report.string() + ": " + why};
  };
  constexpr std::uint64_t kMaxBytes = std::uint64_t{64} << 20;
  const auto bytes = read_file(report, kMaxBytes);
  if (!bytes) return bytes.error();
  const auto parsed = parse_json(*bytes, report.string());
  if (!parsed) return parsed.error();
  if (text_of(*parsed, "schema") != "spoolsight-report/1")
    return refuse("is no report of spoolsight-inspect (schema spoolsight-report/1)");
  if (!parsed->contains("design") || text_of((*parsed)["design"], "sha256") != design_sha256)
    return refuse("is of another design; inspect against the job's own design.glb");
  CheckRecord record;
  bool is_there = false;
  for (const json& entry : list_of(*parsed, "parts")) {
    if (text_of(entry, "name") != part.name) continue;
    is_there = true;
    record.status = text_of(entry, "status");
    for (const json& size : list_of(entry, "size_checks")) {
      if (size.is_object()) record.numbers.push_back(size_of(size));
    }
    take_pose(entry, part, record);
  }
  if (!is_there) return refuse("says nothing of " + part.name);
  for (const json& entry : list_of(*parsed, "dimensions")) {
    if (!entry.is_object()) continue;
    if (is_at(text_of(entry, "from"), part.name) || is_at(text_of(entry, "to"), part.name))
      record.numbers.push_back(dimension_of(entry));
  }
  record.report_sha256 = sha256_hex(*bytes);
  return record;
}

}  // namespace spool::job
