// One run of spoolsight-inspect and what it left, ready to be asked.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "tests/support/points_ply.h"
#include "tests/support/process.h"

namespace spool::test {

struct InspectRun {
  ProcessResult process;
  nlohmann::json report;          // checked against the published schema
  std::vector<PointsRow> points;  // of points.ply
  std::string html;
  std::vector<std::filesystem::path> pictures;

  [[nodiscard]] Eigen::Isometry3d T_design_scan() const;
};

// Runs the program with `arguments` and --out `folder`; test failures where an output is missing,
// the report does not follow its schema or the page refers to anything outside itself.
[[nodiscard]] InspectRun run_inspect(std::vector<std::string> arguments,
                                     const std::filesystem::path& folder);

// pose.json of a pose.
void write_pose(const std::filesystem::path& path, const Eigen::Isometry3d& T_design_scan);

// A row-major list of lists, as truth files hold poses.
[[nodiscard]] Eigen::Isometry3d pose_of(const nlohmann::json& rows);

// How far apart two poses are: the shift (m) of `centre` and the angle (rad) between them.
struct PoseDifference {
  double shift_m = 0;
  double angle_rad = 0;
};
[[nodiscard]] PoseDifference difference(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b,
                                        const Eigen::Vector3d& centre_scan);

}  // namespace spool::test
