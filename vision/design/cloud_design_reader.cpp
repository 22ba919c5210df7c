// A bare cloud as a design: one part without triangles, as the thesis uses it (4.3.2).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "vision/design/readers.h"
#include "vision/scan/cloud_file.h"
#include "vision/scan/normals.h"
#include "vision/scan/ply_header.h"
#include "vision/scan/point_index.h"

namespace spool {
namespace {
constexpr int kNormalNeighbours = 16;  // two rings round a point on an even sampling
}  // namespace

Result<DesignModel> read_cloud_design(const DesignFile& file) {
  Result<CloudFile> read = read_cloud_bytes(file.bytes, file.path, file.unit);
  if (!read) return read.error();
  DesignModel design;
  design.path = file.path.string();
  design.unit = read->unit;
  design.unit_inferred = read->unit_inferred;
  design.warnings = std::move(read->warnings);
  design.cloud = std::move(read->cloud);
  design.origin = design.cloud.origin;
  if (!design.cloud.has_normals()) {
    const PointIndex index(design.cloud.points);
    estimate_neighbour_normals(design.cloud, index, kNormalNeighbours, std::nullopt);
    design.warnings.push_back(
        "the design is a cloud without normals: which side of it is outside "
        "is not known, so the signs of deviations mean nothing");
  }
  Part part;
  part.name = file.path.stem().string();
  design.parts.push_back(std::move(part));
  return design;
}

Result<DesignModel> read_ply_design(const DesignFile& file) {
  const Result<PlyHeader> header = read_ply_header(file.bytes, file.path.string());
  if (!header) return header.error();
  bool has_faces = false;
  for (const PlyElement& element : header->elements) {
    // No element takes less than a byte: a count beyond that must not be given memory by any
    // reader.
    if (element.count > header->body.size() && !element.properties.empty()) {
      return Error{ErrorCode::kBadInput, file.path.string() +
                                             " is cut short: its header promises " +
                                             std::to_string(element.count) + " " + element.name +
                                             " elements; export it again"};
    }
    has_faces = has_faces || (element.name == "face" && element.count > 0);
  }
  return has_faces ? read_mesh_design(file) : read_cloud_design(file);
}

}  // namespace spool
