// What differs between a report that was stored and the same inspection made again.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace spool::evidence {

struct CompareOptions {
  double tolerance = 1e-6;  // of numbers, in their own unit (m, rad, shares)
  // Texts in the report made again that stand for others in the stored one: paths.
  std::vector<std::pair<std::string, std::string>> renamed;
};

struct ReportDifference {
  std::vector<std::string> differences;  // "/parts/0/status: ok was suspicious", all of them
  std::size_t numbers = 0;               // compared
  double largest = 0;                    // between two numbers
  std::size_t over_frames = 0;           // parts[].over_frames that were not made again
};

// Compares everything but times and dates (created, timing_s, alignment/seconds), the options, what
// the stored frame is called (file, kind and frame of the scan, the source's description) and which
// software made it. What a live check says of many frames beside its numbers (parts[].over_frames)
// cannot be made again of one, and is counted. Pure.
[[nodiscard]] ReportDifference compare_reports(const nlohmann::json& stored,
                                               const nlohmann::json& again,
                                               const CompareOptions& options = {});

}  // namespace spool::evidence
