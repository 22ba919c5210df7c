// A design out of pipework: parts with bodies from the catalogue, joints, datums.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/pipework_design.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <utility>

#include "vision/core/parallel.h"
#include "vision/design/design_builder.h"
#include "vision/design/readers.h"
#include "vision/piping/part_solid.h"
#include "vision/piping/pcf_reader.h"

namespace spool {
namespace {

using piping::Component;
using piping::ComponentKind;
using piping::Pipework;

// East, north, up to the design frame's x, y, z: east, up, south.
Eigen::Matrix3d design_from_file() {
  Eigen::Matrix3d R;
  R << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return R;
}

PartKind part_kind(ComponentKind kind) {
  switch (kind) {
    case ComponentKind::kPipe:
      return PartKind::kPipe;
    case ComponentKind::kElbow:
      return PartKind::kElbow;
    case ComponentKind::kTee:
      return PartKind::kTee;
    case ComponentKind::kCross:
      return PartKind::kCross;
    case ComponentKind::kOlet:
      return PartKind::kOlet;
    case ComponentKind::kFlange:
      return PartKind::kFlange;
    case ComponentKind::kBlind:
      return PartKind::kBlind;
    case ComponentKind::kReducer:
      return PartKind::kReducer;
    case ComponentKind::kCap:
      return PartKind::kCap;
    case ComponentKind::kValve:
      return PartKind::kValve;
    case ComponentKind::kGasket:
      return PartKind::kGasket;
    default:
      return PartKind::kOther;
  }
}

JointType joint_type(const piping::PipeJoint& joint) {
  if (joint.number.empty()) return JointType::kField;  // bolted or screwed together on site
  if (joint.where == piping::WeldPlace::kYaw) return JointType::kYaw;
  return joint.where == piping::WeldPlace::kFab ? JointType::kFab : JointType::kField;
}

RawPart raw_part(const Component& component, const std::string& name, piping::PartShape shape) {
  RawPart raw;
  Part& part = raw.part;
  part.name = name;
  part.kind = part_kind(component.kind);
  part.nps = shape.nps;
  part.nps2 = shape.nps2;
  part.schedule = component.schedule;
  part.rating = component.rating;
  part.spool = component.spool;
  part.piece = component.piece;
  part.heat = component.heat;
  for (const piping::PartPort& each : shape.ports) {
    part.ports.push_back({each.name, each.position, each.direction, each.nps,
                          parse_end_type(each.end).value_or(EndType::kPlain)});
  }
  if (shape.holes)
    part.holes = BoltHoles{shape.holes->count, shape.holes->bolt_circle, shape.holes->clocking};
  for (const piping::PartMark& each : shape.marks)
    part.marks.push_back({each.type, each.position, each.direction, each.size});
  part.T_design_part.linear() = design_from_file() * shape.T_file_part.linear();
  part.T_design_part.translation() = design_from_file() * shape.T_file_part.translation();
  raw.vertices = std::move(shape.solid.vertices);
  for (Eigen::Vector3d& vertex : raw.vertices) vertex = part.T_design_part * vertex;
  raw.triangles = std::move(shape.solid.triangles);
  return raw;
}

int port_named(const Part& part, const std::string& name) {
  for (std::size_t i = 0; i < part.ports.size(); ++i) {
    if (part.ports[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

// The first open face of the widest flanges: where a spool is bolted to what stands already.
std::vector<int> datums_of(const DesignModel& design) {
  const auto is_bolted = [&](int part, int port) {
    return std::any_of(design.joints.begin(), design.joints.end(), [&](const Joint& joint) {
      return (joint.part_a == part && joint.port_a == port) ||
             (joint.part_b == part && joint.port_b == port);
    });
  };
  int best = -1;
  for (std::size_t p = 0; p < design.parts.size(); ++p) {
    const Part& part = design.parts[p];
    const int face = port_named(part, "face");
    if (part.kind != PartKind::kFlange || face < 0 || is_bolted(static_cast<int>(p), face))
      continue;
    if (best < 0 || part.nps > design.parts[static_cast<std::size_t>(best)].nps)
      best = static_cast<int>(p);
  }
  return best < 0 ? std::vector<int>{} : std::vector<int>{best};
}

void warn_of_problems(const std::vector<piping::Problem>& problems, DesignModel& design) {
  for (const piping::Problem& each : problems) {
    design.warnings.push_back(
        (each.line > 0 ? "line " + std::to_string(each.line) + ": " : std::string()) + each.text);
  }
}

// How the root gaps of the file's welds are drawn, where they are: the middle one.
double drawn_root_gap(const Pipework& pipework) {
  std::vector<double> gaps;
  for (const piping::PipeJoint& joint : pipework.joints) {
    if (joint.weld >= 0 && joint.gap > 0.0005) gaps.push_back(joint.gap);
  }
  if (gaps.empty()) return 0;
  std::sort(gaps.begin(), gaps.end());
  return gaps[gaps.size() / 2];
}

}  // namespace

std::vector<std::string> part_names(const Pipework& pipework) {
  std::vector<std::string> names;
  std::map<ComponentKind, int> counts;
  for (const Component& each : pipework.components) {
    names.push_back(is_body(each)
                        ? std::string(name(each.kind)) + "-" + std::to_string(++counts[each.kind])
                        : std::string());
  }
  return names;
}

Status design_of(const Pipework& pipework, DesignModel& design) {
  const std::vector<std::string> names = part_names(pipework);
  const std::size_t count = pipework.components.size();
  std::vector<std::optional<piping::PartShape>> shapes(count);
  std::vector<std::vector<piping::Problem>> found(count);
  // build_mesh() would refuse them too, but a hostile file would fill the memory before.
  std::atomic<std::size_t> triangles{0};
  parallel_chunks(count, 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end && triangles <= kMaxDesignTriangles; ++c) {
      shapes[c] = piping::shape_of(pipework, static_cast<int>(c), found[c]);
      if (shapes[c]) triangles += shapes[c]->solid.triangles.size();
    }
  });
  if (triangles > kMaxDesignTriangles) {
    return Error{ErrorCode::kBadInput,
                 design.path + " draws more than " + std::to_string(kMaxDesignTriangles) +
                     " triangles; convert one spool of it at a time (spoolsight-convert --spool)"};
  }
  std::vector<piping::Problem> problems = pipework.problems;
  for (const auto& each : found) problems.insert(problems.end(), each.begin(), each.end());
  std::stable_sort(problems.begin(), problems.end(),
                   [](const auto& a, const auto& b) { return a.line < b.line; });
  warn_of_problems(problems, design);
  std::vector<RawPart> raw;
  std::vector<int> part_of(count, -1);
  std::map<std::pair<int, int>, int> ports;  // component's port, to the part's
  std::vector<int> fittings(count, 0);
  for (std::size_t c = 0; c < count; ++c) {
    if (!shapes[c]) continue;
    part_of[c] = static_cast<int>(raw.size());
    for (std::size_t p = 0; p < shapes[c]->ports.size(); ++p)
      ports[{static_cast<int>(c), shapes[c]->ports[p].port}] = static_cast<int>(p);
    raw.push_back(raw_part(pipework.components[c], names[c], std::move(*shapes[c])));
  }
  for (const piping::PipeJoint& each : pipework.joints) {
    Joint joint;
    joint.weld = each.number;
    joint.type = joint_type(each);
    joint.part_a = part_of[static_cast<std::size_t>(each.a)];
    joint.part_b = part_of[static_cast<std::size_t>(each.b)];
    if (joint.part_a < 0 || joint.part_b < 0) continue;
    if (each.port_a == piping::kOnRun) {
      const Part& run = raw[static_cast<std::size_t>(joint.part_a)].part;
      const Part& fitting = raw[static_cast<std::size_t>(joint.part_b)].part;
      joint.port_a =
          port_named(run, "olet" + std::to_string(++fittings[static_cast<std::size_t>(each.a)]));
      joint.port_b = port_named(fitting, "run");
    } else {
      const auto a = ports.find({each.a, each.port_a});
      const auto b = ports.find({each.b, each.port_b});
      joint.port_a = a == ports.end() ? -1 : a->second;
      joint.port_b = b == ports.end() ? -1 : b->second;
    }
    if (joint.port_a >= 0 && joint.port_b >= 0) design.joints.push_back(std::move(joint));
  }
  if (Status built = build_mesh(std::move(raw), design); !built) return built;
  if (!pipework.pipelines.empty()) {
    design.line = pipework.pipelines.front().reference;
    design.revision = pipework.pipelines.front().revision;
  }
  if (pipework.spools.size() == 1) design.spool = pipework.spools.front().name;
  design.root_gap_m = drawn_root_gap(pipework);
  design.unit_inferred = pipework.coordinate_unit_inferred;
  design.datums = datums_of(design);
  return {};
}

Result<DesignModel> read_pcf_design(const DesignFile& file) {
  std::optional<double> unit;
  if (file.unit) unit = metres(*file.unit);
  const Result<Pipework> pipework = piping::read_pcf(file.bytes, file.path.string(), unit);
  if (!pipework) return pipework.error();
  DesignModel design;
  design.path = file.path.string();
  if (Status built = design_of(*pipework, design); !built) return built.error();
  if (file.unit) design.unit = *file.unit;
  return design;
}

}  // namespace spool
