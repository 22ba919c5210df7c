// Which of the cameras that are plugged in is opened, and what is said of the others.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace spool::sensor {

struct PluggedCamera {
  std::string uri, name;
};
struct CameraChoice {
  std::string uri;
  std::string remark;  // one sentence where there are others; else empty
};

// The first of them: nothing tells which is meant. Nothing where there is none.
[[nodiscard]] inline std::optional<CameraChoice> choose_camera(
    const std::vector<PluggedCamera>& cameras) {
  if (cameras.empty()) return std::nullopt;
  CameraChoice choice{cameras.front().uri, {}};
  if (cameras.size() == 1) return choice;
  choice.remark = std::to_string(cameras.size()) + " cameras are plugged in; this is " +
                  cameras.front().name + " at " + cameras.front().uri +
                  ", openni:URI picks another (";
  for (std::size_t i = 1; i < cameras.size(); ++i)
    choice.remark += (i > 1 ? ", " : "") + cameras[i].uri;
  choice.remark += ").";
  return choice;
}

}  // namespace spool::sensor
