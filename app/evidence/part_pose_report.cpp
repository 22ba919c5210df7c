// Where each part stands, in the reports.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/part_pose_report.h"

#include <cstdio>
#include <numbers>

namespace spool::evidence {
namespace {

using nlohmann::json;

json three(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

std::string joined(const std::vector<std::string>& texts, const char* last) {
  std::string all;
  for (std::size_t i = 0; i < texts.size(); ++i)
    all += (i == 0 ? "" : i + 1 == texts.size() ? last : ", ") + texts[i];
  return all;
}

}  // namespace

json pose_error_json(const PartPose& pose) {
  if (!pose.is_measured) return nullptr;
  json covariance = json::array(), weak = json::array();
  for (int i = 0; i < 36; ++i) covariance.push_back(pose.covariance(i / 6, i % 6));
  for (const WeakMotion& motion : pose.weak) {
    json direction = json::array();
    for (int k = 0; k < 6; ++k) direction.push_back(motion.direction[k]);
    weak.push_back({{"direction", direction}, {"sigma", motion.sigma}, {"text", motion.text}});
  }
  return {{"translation_m", three(pose.error.head<3>())},
          {"rotation_rad", three(pose.error.tail<3>())},
          {"covariance", covariance},
          {"weak_directions", weak},
          {"rests_on", pose.rests_on},
          {"relative_to", pose.datum},
          {"significant", pose.is_off}};
}

std::string pose_words(const PartPose& pose, LengthStyle style) {
  if (!pose.is_measured || !pose.is_off) return "";
  char degrees[32];
  std::snprintf(degrees, sizeof degrees, "%.1f°",
                pose.error.tail<3>().norm() * 180 / std::numbers::pi);
  std::string text = " It stands " + length_text(pose.error.head<3>().norm(), style) + " and " +
                     degrees + " off where the drawing has it, seen from the datum (by " +
                     joined(pose.rests_on, " and ") + ").";
  std::vector<std::string> open;
  for (const WeakMotion& motion : pose.weak) open.push_back(motion.text);
  if (!open.empty()) text += " Not observed: " + joined(open, " and ") + ".";
  return text;
}

}  // namespace spool::evidence
