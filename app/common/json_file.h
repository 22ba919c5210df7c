// JSON from files of strangers: size and depth bounded, every error a sentence with the file's
// name.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "vision/align/three_point.h"
#include "vision/core/camera.h"
#include "vision/core/pose.h"
#include "vision/core/result.h"

namespace spool {

// The parser recurses once a level: deeper nesting than this is refused before it starts.
constexpr int kJsonMaxDepth = 64;

// A whole JSON file of at most 64 MiB. kBadInput names the file, the line and what is wrong there.
[[nodiscard]] Result<nlohmann::json> read_json(const std::filesystem::path& path);
// The same from memory; `name` stands for the file in sentences.
[[nodiscard]] Result<nlohmann::json> parse_json(std::string_view text, const std::string& name);
// The text of a file that we write: two spaces a level, a line end, invalid UTF-8 (a file's name)
// replaced.
[[nodiscard]] std::string json_text(const nlohmann::json& json);

// pairs.json, pose.json, camera.json and calibration files of ARCHITECTURE, Interfaces. kBadInput
// names the file and the key. Metres, each point in its own file's frame; three pairs or more.
[[nodiscard]] Result<std::vector<PointPair>> read_pairs(const std::filesystem::path& path);
// T_design_scan; scales, mirrors and shears are refused with that reason.
[[nodiscard]] Result<Pose> read_pose(const std::filesystem::path& path);
[[nodiscard]] Result<Camera> read_camera(const std::filesystem::path& path);
// The "calibration" object of a sensor check's file or of a camera.json.
[[nodiscard]] Result<Calibration> read_calibration(const std::filesystem::path& path);
[[nodiscard]] nlohmann::json camera_to_json(const Camera& camera);
[[nodiscard]] nlohmann::json calibration_to_json(const Calibration& calibration);

// One object of a JSON file being read by key; the first thing wrong is kept as one sentence with
// file and key, later reads then give neutral values. Ask error() once, at the end.
class JsonObject {
 public:
  // `json` and `file` must outlive this; `where` is the path of keys down to here, "" at the top.
  JsonObject(const nlohmann::json& json, std::string file, std::string where = "");

  [[nodiscard]] bool has(const std::string& key) const;
  double number(const std::string& key);                   // finite
  double number_or(const std::string& key, double other);  // where the key is absent
  int integer(const std::string& key);
  std::string text_or(const std::string& key, const std::string& other);
  // Exactly `count` finite numbers.
  std::vector<double> numbers(const std::string& key, std::size_t count);
  // The array under `key`; an empty one where something is wrong.
  const nlohmann::json& array(const std::string& key);

  void fail(const std::string& key, const std::string& what);  // keeps the first only
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 private:
  const nlohmann::json* member(const std::string& key);

  const nlohmann::json& json_;
  std::string file_;
  std::string where_;
  std::optional<Error> error_;
};

}  // namespace spool
