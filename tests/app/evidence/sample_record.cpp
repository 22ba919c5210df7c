// A small inspection made by hand: two boxes, a few points each, every kind of point and status.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/app/evidence/sample_record.h"

#include <array>
#include <cassert>
#include <limits>

namespace spool::test {

void add_box(DesignModel& model, const std::string& name, const Eigen::Vector3d& low,
             const Eigen::Vector3d& high) {
  const auto first = static_cast<std::uint32_t>(model.mesh.vertices.size());
  for (unsigned corner = 0; corner < 8; ++corner)
    model.mesh.vertices.emplace_back(static_cast<float>(((corner & 1U) != 0 ? high : low).x()),
                                     static_cast<float>(((corner & 2U) != 0 ? high : low).y()),
                                     static_cast<float>(((corner & 4U) != 0 ? high : low).z()));
  // Quads counter-clockwise seen from outside: -z, +z, -y, +y, -x, +x.
  constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  Part part;
  part.name = name;
  part.kind = PartKind::kOther;
  part.first_triangle = static_cast<std::uint32_t>(model.mesh.triangles.size());
  part.triangle_count = 12;
  for (const auto& face : kFaces) {
    model.mesh.triangles.push_back({first + face[0], first + face[1], first + face[2]});
    model.mesh.triangles.push_back({first + face[0], first + face[2], first + face[3]});
  }
  model.triangle_part.resize(model.mesh.triangles.size(),
                             static_cast<std::int32_t>(model.parts.size()));
  model.parts.push_back(part);
}

std::shared_ptr<const PreparedDesign> prepared(DesignModel model) {
  auto design = PreparedDesign::prepare(std::move(model));
  assert(design && "boxes make a design");
  return *design;
}

evidence::InspectionRecord sample_record() {
  DesignModel model;
  model.path = "sample/spool.glb";
  model.sha256 = std::string(64, 'a');
  model.spool = "60085";
  model.origin = {100, 0, 0};
  add_box(model, "base", {0, 0, 0}, {0.4, 0.1, 0.2});
  add_box(model, "post", {0.3, 0.1, 0.0}, {0.4, 0.5, 0.1});
  evidence::InspectionRecord record;
  record.design = prepared(std::move(model));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  auto& inspection = record.inspection;
  inspection.alignment.found = true;
  inspection.alignment.method = AlignMethod::kThreePoint;
  inspection.alignment.rms_m = 0.002;
  inspection.alignment.overlap = 0.9;
  inspection.alignment.pair_residual_m = {0.004, 0.006, 0.005};
  inspection.scan_design.points = {{0.1F, 0.102F, 0.1F},
                                   {0.2F, 0.098F, 0.1F},
                                   {nan, nan, nan},
                                   {0.9F, 0.9F, 0.9F},
                                   {0.42F, 0.3F, 0.05F}};
  inspection.declutter.k = 3;
  inspection.declutter.classes = {PointClass::kObject, PointClass::kObject, PointClass::kClutter,
                                  PointClass::kClutter, PointClass::kContradicting};
  inspection.declutter.object = 2;
  inspection.declutter.clutter = 2;
  inspection.declutter.contradicting = 1;
  inspection.deviations.distance_m = {0.002F, -0.002F, nan, nan, 0.02F};
  inspection.deviations.part = {0, 0, -1, -1, 1};
  inspection.parts = {
      {0, Verdict::kSuspicious, "no dimension is judged", {2, 0.0, 0.002, 0.002, 0.002, 0.4}},
      {1, Verdict::kNotMeasured, "too little was seen", {}}};
  inspection.status = Verdict::kSuspicious;
  inspection.status_reason = "Seen, but no dimension is judged.";
  inspection.scan_rms_m = 0.002;
  inspection.timing_s = {{"align", 0.1}};
  record.scan = {"sample/scan.ply", std::string(64, 'b'), "cloud", 4, -1, "m", false};
  record.sensor = "cloud file";
  record.noise_m = 0.001;
  return record;
}

std::vector<Dimension> sample_dimensions() {
  Dimension length;
  length.name = "base/face to post/centre";
  length.kind = "centre_to_face";
  length.from = "base/face";
  length.to = "post/centre";
  length.nominal = 0.5;
  length.is_measured = true;
  length.measured = 0.5061;
  length.deviation = 0.0061;
  length.u = {0.0003, 0.0004, 0};
  length.tolerance = 0.003;
  length.rule = "PFI ES-3 2.2";
  length.probability = 0.001;
  length.status = Verdict::kNotOk;
  length.reason = "Off by 6.1 mm.";
  Dimension angle = length;
  angle.kind = "angle";
  angle.is_angle = true;
  angle.nominal = angle.measured = 1.5707963;
  angle.deviation = 0;
  angle.tolerance = 0;
  angle.rule = "the rules give it no tolerance";
  angle.status = Verdict::kSuspicious;
  Dimension unseen = length;
  unseen.kind = "face_alignment";
  unseen.is_angle = true;
  unseen.is_measured = false;
  unseen.tolerance = 0.0039;
  unseen.status = Verdict::kNotMeasured;
  unseen.reason = "Not measured: nobody looked.";
  return {length, angle, unseen};
}

}  // namespace spool::test
