// points.ply: every point of the scan in the design file's frame, with what it was taken for.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/points_ply.h"

#include <limits>
#include <vector>

#include "vision/scan/cloud_file.h"

namespace spool::evidence {

Status write_points(const std::filesystem::path& path, const InspectionRecord& record) {
  const auto& inspection = record.inspection;
  const std::size_t count = inspection.scan_design.size();
  const bool judged = inspection.declutter.classes.size() == count &&
                      inspection.deviations.distance_m.size() == count &&
                      inspection.deviations.part.size() == count;
  PointCloud cloud;
  cloud.points = inspection.scan_design.points;
  cloud.origin = inspection.scan_design.origin + record.design->model.origin;
  PlyColumn object{"object", PlyColumn::Type::kUchar, {}, {}, std::vector<std::uint8_t>(count, 0)};
  PlyColumn part{"part", PlyColumn::Type::kInt, {}, std::vector<std::int32_t>(count, -1), {}};
  PlyColumn deviation{"deviation",
                      PlyColumn::Type::kFloat,
                      std::vector<float>(count, std::numeric_limits<float>::quiet_NaN()),
                      {},
                      {}};
  for (std::size_t i = 0; judged && i < count; ++i) {
    const PointClass kind = inspection.declutter.classes[i];
    if (kind == PointClass::kClutter) continue;
    object.uchars[i] = static_cast<std::uint8_t>(kind);
    part.ints[i] = inspection.deviations.part[i];
    deviation.floats[i] = inspection.deviations.distance_m[i];
  }
  return write_ply(path, cloud, {object, part, deviation});
}

}  // namespace spool::evidence
