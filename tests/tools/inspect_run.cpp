// One run of spoolsight-inspect and what it left, ready to be asked.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/tools/inspect_run.h"

#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

#include "app/common/json_file.h"
#include "tests/app/evidence/json_schema.h"
#include "tests/support/shared_data.h"
#include "vision/core/file_io.h"

namespace spool::test {

namespace fs = std::filesystem;

Eigen::Isometry3d InspectRun::T_design_scan() const {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const auto& numbers = report.at("alignment").at("T_design_scan");
  for (int i = 0; i < 12; ++i)
    pose.matrix()(i / 4, i % 4) = numbers.at(static_cast<std::size_t>(i)).get<double>();
  return pose;
}

InspectRun run_inspect(std::vector<std::string> arguments, const fs::path& folder) {
  arguments.insert(arguments.end(), {"--out", folder.string()});
  InspectRun result;
  result.process = run(program("spoolsight-inspect"), arguments);
  const auto report = read_json(folder / "report.json");
  const auto schema = read_json(source_dir() / "assets" / "report.schema.json");
  if (!report || !schema) {
    ADD_FAILURE() << result.process.err << (report ? "" : report.error().message);
    return result;
  }
  result.report = *report;
  for (const auto& violation : schema_violations(*schema, *report)) ADD_FAILURE() << violation;
  const auto points = read_points_ply(folder / "points.ply");
  EXPECT_TRUE(points);
  if (points) result.points = *points;
  const auto html = read_file(folder / "report.html");
  EXPECT_TRUE(html);
  if (html) result.html = *html;
  for (const char* outside : {"http:", "https:", "<script", "<link", "url(", "file:"})
    EXPECT_EQ(result.html.find(outside), std::string::npos) << outside;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".png") result.pictures.push_back(entry.path());
  std::sort(result.pictures.begin(), result.pictures.end());
  return result;
}

void write_pose(const fs::path& path, const Eigen::Isometry3d& T_design_scan) {
  nlohmann::json numbers = nlohmann::json::array();
  for (int i = 0; i < 16; ++i) numbers.push_back(T_design_scan.matrix()(i / 4, i % 4));
  std::ofstream(path) << nlohmann::json{{"T_design_scan", numbers}};
}

Eigen::Isometry3d pose_of(const nlohmann::json& rows) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 4; ++c)
      pose.matrix()(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) =
          rows.at(r).at(c).get<double>();
  return pose;
}

PoseDifference difference(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b,
                          const Eigen::Vector3d& centre_scan) {
  return {(a * centre_scan - b * centre_scan).norm(),
          Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle()};
}

}  // namespace spool::test
