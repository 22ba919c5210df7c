// What should be: the parts of a spool with their ports, the joints between them, the surface.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vision/core/length_unit.h"
#include "vision/core/point_cloud.h"
#include "vision/core/pose.h"
#include "vision/core/triangle_mesh.h"

namespace spool {

enum class PartKind {
  kPipe,
  kElbow,
  kTee,
  kCross,
  kReducer,
  kFlange,
  kBlind,
  kCap,
  kOlet,
  kValve,
  kGasket,
  kSupport,
  kStructure,
  kOther
};
[[nodiscard]] std::string_view name(PartKind kind);  // as ARCHITECTURE, Files spells it
[[nodiscard]] std::optional<PartKind> parse_part_kind(std::string_view text);

enum class EndType { kButtWeld, kFlanged, kSocketWeld, kScrewed, kPlain };
[[nodiscard]] std::string_view name(EndType end);  // BW FL SW SC PL
[[nodiscard]] std::optional<EndType> parse_end_type(std::string_view text);

// Where another part joins; in the part's own frame.
struct Port {
  std::string name;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();    // m
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // unit, outward
  double nps = 0;                                        // nominal pipe size, inches; 0 unknown
  EndType end = EndType::kPlain;
};

// The bolt holes of a flange about its z axis; clocking of the first hole from x, right-handed
// about +z.
struct BoltHoles {
  int count = 0;
  double bolt_circle_m = 0;
  double clocking_rad = 0;
};

// A tap, vent, drain, spindle or flat side: what breaks a part's symmetry.
struct Mark {
  std::string type;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();    // m, part's own frame
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // unit
  double size_m = 0;
};

// The profile of a structural part.
struct Section {
  std::string shape;
  double width_m = 0;
  double height_m = 0;
};

struct Part {
  std::string name;
  PartKind kind = PartKind::kOther;
  double nps = 0;   // inches; 0 unknown
  double nps2 = 0;  // the smaller end or the branch
  std::string schedule, rating, spool, piece, heat;
  int order = -1;  // assembly order; -1: as it stands in the file
  std::vector<Port> ports;
  std::optional<BoltHoles> holes;
  std::vector<Mark> marks;
  std::optional<Section> section;
  Pose T_design_part = Pose::Identity();
  std::uint32_t first_triangle = 0;  // its triangles of DesignModel::mesh
  std::uint32_t triangle_count = 0;
};

enum class JointType { kFab, kField, kYaw };
[[nodiscard]] std::string_view name(JointType type);  // fab field yaw
[[nodiscard]] std::optional<JointType> parse_joint_type(std::string_view text);

// A weld or bolted joint between two ports.
struct Joint {
  std::string weld;
  int part_a = -1, port_a = -1;  // into parts and their ports
  int part_b = -1, port_b = -1;
  JointType type = JointType::kFab;
};

// A design as read. Everything is metres in the design frame, relative to `origin` (file
// coordinates = origin + ours), immutable once built and shared between threads by shared_ptr<const
// DesignModel>. Either `mesh` or `cloud` (the thesis's bare design cloud: one part, no triangles)
// holds the surface.
struct DesignModel {
  std::string path;
  std::string sha256;
  std::vector<Part> parts;
  std::vector<Joint> joints;
  std::vector<int> datums;  // parts that numbers are relative to; empty: to be chosen
  std::string line, spool, revision;
  double root_gap_m = 0;
  TriangleMesh mesh;
  std::vector<std::int32_t> triangle_part;  // the part of each triangle
  PointCloud cloud;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // m
  LengthUnit unit = LengthUnit::kMetre;
  bool unit_inferred = false;
  std::vector<std::string> warnings;  // one sentence each

  [[nodiscard]] bool is_cloud() const { return mesh.triangles.empty(); }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const;  // m
};

}  // namespace spool
