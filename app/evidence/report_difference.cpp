// What differs between a report that was stored and the same inspection made again.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/report_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace spool::evidence {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 10> kIgnored = {
    "/created",    "/timing_s",  "/alignment/seconds",  "/options", "/design/file", "/scan/file",
    "/scan/frame", "/scan/kind", "/sensor/description", "/software"};

class Comparison {
 public:
  explicit Comparison(const CompareOptions& options) : options_(options) {}

  void compare(const json& stored, const json& again, const std::string& at) {
    if (std::find(kIgnored.begin(), kIgnored.end(), at) != kIgnored.end()) return;
    if (again.is_null() && at.starts_with("/parts/") && at.ends_with("/over_frames")) {
      ++result_.over_frames;
      return;
    }
    if (stored.is_number() && again.is_number()) {
      compare_numbers(stored.get<double>(), again.get<double>(), at);
    } else if (stored.is_object() && again.is_object()) {
      for (const auto& [key, value] : stored.items()) {
        const auto found = again.find(key);
        compare(value, found == again.end() ? json() : *found, at + "/" + key);
      }
      for (const auto& [key, value] : again.items()) {
        if (!stored.contains(key)) compare(json(), value, at + "/" + key);
      }
    } else if (stored.is_array() && again.is_array() && stored.size() == again.size()) {
      for (std::size_t i = 0; i < stored.size(); ++i)
        compare(stored[i], again[i], at + "/" + std::to_string(i));
    } else if (stored.is_string() && again.is_string()) {
      const std::string text = renamed(again.get<std::string>());
      if (text != stored.get<std::string>()) tell(at, stored, text);
    } else if (stored != again) {
      tell(at, stored, again);
    }
  }
  [[nodiscard]] ReportDifference result() && { return std::move(result_); }

 private:
  void compare_numbers(double stored, double again, const std::string& at) {
    ++result_.numbers;
    const double difference = std::abs(stored - again);
    result_.largest = std::max(result_.largest, difference);
    if (!(difference <= options_.tolerance)) tell(at, stored, again);
  }
  void tell(const std::string& at, const json& stored, const json& again) {
    const auto text = [](const json& value) {
      constexpr std::size_t kLongest = 80;
      std::string all = value.dump(-1, ' ', false, json::error_handler_t::replace);
      if (all.size() > kLongest) all = all.substr(0, kLongest) + "...";
      return all;
    };
    result_.differences.push_back(at + ": is " + text(again) + " and was " + text(stored));
  }
  [[nodiscard]] std::string renamed(std::string text) const {
    for (const auto& [from, to] : options_.renamed) {
      if (from.empty()) continue;
      for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    }
    return text;
  }

  const CompareOptions& options_;
  ReportDifference result_;
};

}  // namespace

ReportDifference compare_reports(const json& stored, const json& again,
                                 const CompareOptions& options) {
  Comparison comparison(options);
  comparison.compare(stored, again, "");
  return std::move(comparison).result();
}

}  // namespace spool::evidence
