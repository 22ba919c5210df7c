// pairs.json and pose.json of ARCHITECTURE, Command lines: where the scan lies, as a person or
// another program says it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <Eigen/LU>

#include "app/common/json_file.h"

namespace spool {
namespace {

Eigen::Vector3d vector3(const std::vector<double>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

// Why 16 numbers are not a rigid pose.
std::string not_rigid(const std::vector<double>& numbers) {
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> matrix(numbers.data());
  if ((matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() > 1e-9)
    return "has to end in 0, 0, 0, 1: give the matrix row by row";
  const Eigen::Matrix3d turn = matrix.topLeftCorner<3, 3>();
  const double volume = turn.determinant();
  if (volume < 0) return "mirrors: a part cannot be turned inside out; check the axes it came from";
  const Eigen::Matrix3d gram = turn.transpose() * turn;
  const double scale = std::cbrt(std::abs(volume));
  const Eigen::Matrix3d uniform = scale * scale * Eigen::Matrix3d::Identity();
  if (scale > 0 && (gram - uniform).cwiseAbs().maxCoeff() < 1e-3 * scale * scale)
    return "scales by " + std::to_string(scale) +
           ": say the files' units by --design-unit and --scan-unit instead";
  return "is not a rigid motion: its first three columns have to be unit and at right angles to "
         "1e-4";
}

}  // namespace

Result<std::vector<PointPair>> read_pairs(const std::filesystem::path& path) {
  const auto json = read_json(path);
  if (!json) return json.error();
  JsonObject top(*json, path.string());
  const auto& list = top.array("pairs");
  if (top.error()) return *top.error();
  std::vector<PointPair> pairs;
  for (std::size_t i = 0; i < list.size(); ++i) {
    JsonObject entry(list[i], path.string(), "pairs[" + std::to_string(i) + "]");
    PointPair pair;
    pair.design = vector3(entry.numbers("design", 3));
    pair.scan = vector3(entry.numbers("scan", 3));
    if (entry.error()) return *entry.error();
    pairs.push_back(pair);
  }
  if (pairs.size() < 3) {
    top.fail("pairs", "holds " + std::to_string(pairs.size()) +
                          " pairs and three or more are needed; pick another point");
    return *top.error();
  }
  return pairs;
}

Result<Pose> read_pose(const std::filesystem::path& path) {
  const auto json = read_json(path);
  if (!json) return json.error();
  JsonObject top(*json, path.string());
  const auto numbers = top.numbers("T_design_scan", 16);
  if (top.error()) return *top.error();
  const auto pose = pose_from_row_major(numbers);
  if (pose) return *pose;
  top.fail("T_design_scan", not_rigid(numbers));
  return *top.error();
}

}  // namespace spool
