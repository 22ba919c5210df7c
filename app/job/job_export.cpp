// The checks of a job for other programs: CSV, and JSON lines.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/job_export.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/job/job_progress.h"

namespace spool::job {
namespace {

std::string cell(const std::string& text) {
  std::string quoted = "\"";
  if (!text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos)
    quoted += '\'';
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

std::string cell(std::optional<double> number) { return number ? fmt::format("{}", *number) : ""; }

std::string line(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

nlohmann::json value(std::optional<double> number) {
  return number ? nlohmann::json(*number) : nlohmann::json(nullptr);
}

nlohmann::json number_json(const CheckNumber& number) {
  const std::string end = "_" + number.unit;
  return {{"name", number.name},
          {"kind", number.kind},
          {"nominal" + end, value(number.nominal)},
          {"measured" + end, value(number.measured)},
          {"deviation" + end, value(number.deviation)},
          {"u" + end, value(number.u)},
          {"tolerance" + end, value(number.tolerance)},
          {"status", number.status}};
}

nlohmann::json check_json(const JobFile& job, const CheckRecord& record) {
  nlohmann::json json = {{"event", "check"},
                         {"spool", job.spool},
                         {"id", record.id},
                         {"time", utc_text(record.at.wall_s)},
                         {"boot", record.at.boot},
                         {"boot_s", record.at.boot_s},
                         {"step", record.step},
                         {"part", record.part},
                         {"joint", record.joint},
                         {"phase", name(record.phase)},
                         {"outcome", name(record.outcome)},
                         {"status", record.status},
                         {"operator", record.operator_name},
                         {"remark", record.remark},
                         {"override_reason", record.override_reason},
                         {"picture", record.picture},
                         {"report_sha256", record.report_sha256},
                         {"T_design_part", nullptr},
                         {"covariance", nullptr},
                         {"numbers", nlohmann::json::array()}};
  if (record.T_design_part) json["T_design_part"] = *record.T_design_part;
  if (record.covariance) json["covariance"] = *record.covariance;
  for (const CheckNumber& each : record.numbers) json["numbers"].push_back(number_json(each));
  return json;
}

}  // namespace

std::string csv_text(const JobFile& job, const std::vector<CheckRecord>& records) {
  std::string text =
      "id,time_utc,spool,step,part,joint,phase,outcome,status,operator,remark,override_reason,"
      "picture,report_sha256,number,kind,unit,nominal,measured,deviation,u,tolerance,"
      "number_status\r\n";
  for (const CheckRecord& record : records) {
    std::string check = fmt::format("{},{},{},{}", record.id, utc_text(record.at.wall_s),
                                    cell(job.spool), record.step);
    for (const std::string& each :
         {record.part, record.joint, std::string(name(record.phase)),
          std::string(name(record.outcome)), record.status, record.operator_name, record.remark,
          record.override_reason, record.picture, record.report_sha256})
      check += "," + cell(each);
    if (record.numbers.empty()) text += check + ",,,,,,,,,\r\n";
    for (const CheckNumber& each : record.numbers) {
      text += check + "," + cell(each.name) + "," + cell(each.kind) + "," + cell(each.unit);
      for (const auto& number :
           {each.nominal, each.measured, each.deviation, each.u, each.tolerance})
        text += "," + cell(number);
      text += "," + cell(each.status) + "\r\n";
    }
  }
  return text;
}

std::string json_lines(const JobFile& job, const std::vector<CheckRecord>& records) {
  std::string text;
  for (const CheckRecord& record : records) text += line(check_json(job, record));
  for (const JointHistory& history : joint_histories(records)) {
    nlohmann::json json = {{"event", "joint"},
                           {"spool", job.spool},
                           {"joint", history.joint},
                           {"part", history.part},
                           {"tries", history.tries},
                           {"checks", history.checks},
                           {"overrides", history.overrides},
                           {"seconds", history.seconds},
                           {"time_is_whole", history.time_is_whole},
                           {"accepted", history.is_accepted},
                           {"shrinkage", nlohmann::json::array()}};
    for (const Shrinkage& each : history.shrinkage)
      json["shrinkage"].push_back({{"number", each.number},
                                   {"change_" + each.unit, each.change},
                                   {"u_" + each.unit, each.u}});
    text += line(json);
  }
  return text;
}

}  // namespace spool::job
