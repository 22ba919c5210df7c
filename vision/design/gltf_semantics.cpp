// What extras.spoolsight says of a glTF's nodes and scene (ARCHITECTURE, Files).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/gltf_semantics.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <tiny_gltf.h>

#include "vision/design/json_fields.h"

namespace spool {
namespace {

// The longest list that is read of ports, marks or joints: any more is no spool.
constexpr std::size_t kMaxListed = 100'000;

std::optional<Eigen::Vector3d> direction(const JsonFields& fields, const NodeFrame& frame) {
  const std::optional<Eigen::Vector3d> given = fields.vector("direction");
  if (!given) return std::nullopt;
  const Eigen::Vector3d turned = frame.part_from_node * *given;
  if (!(turned.norm() > 1e-9 * frame.part_from_node.norm())) {
    fields.warn("has a direction without length; it is left out");
    return std::nullopt;
  }
  return turned.normalized();
}

std::optional<Port> read_port(const JsonFields& fields, const NodeFrame& frame) {
  Port port;
  const std::optional<Eigen::Vector3d> position = fields.vector("position");
  const std::optional<Eigen::Vector3d> outward = direction(fields, frame);
  const std::optional<std::string> name = fields.text("name");
  if (!position || !outward || !name) {
    fields.warn("lacks a name, a position or a direction; the port is left out");
    return std::nullopt;
  }
  port.name = *name;
  port.position = frame.part_from_node * *position;
  port.direction = *outward;
  port.nps = fields.size("nps").value_or(0);
  if (const auto end = fields.text("end")) {
    if (const std::optional<EndType> known = parse_end_type(*end)) {
      port.end = *known;
    } else {
      fields.warn("has an end '" + *end + "' that is none of BW FL SW SC PL; plain is taken");
    }
  }
  return port;
}

std::optional<Mark> read_mark(const JsonFields& fields, const NodeFrame& frame) {
  const std::optional<Eigen::Vector3d> position = fields.vector("position");
  const std::optional<Eigen::Vector3d> outward = direction(fields, frame);
  const std::optional<std::string> type = fields.text("type");
  if (!position || !outward || !type) {
    fields.warn("lacks a type, a position or a direction; the mark is left out");
    return std::nullopt;
  }
  return Mark{*type, frame.part_from_node * *position, *outward,
              frame.scale * fields.size("size_m").value_or(0)};
}

std::optional<BoltHoles> read_holes(const JsonFields& fields, const NodeFrame& frame) {
  const int count = fields.integer("count").value_or(0);
  const double circle = frame.scale * fields.size("bolt_circle_m").value_or(0);
  if (count <= 0 || count > 1000 || !(circle > 0)) {
    fields.warn("needs a count and a bolt_circle_m over zero; the holes are left out");
    return std::nullopt;
  }
  double clocking = fields.number("clocking_rad").value_or(0);
  // A part's frame has x turned over against a mirrored node's: angles from x run the other way.
  if (frame.mirrored) clocking = std::numbers::pi - clocking;
  return BoltHoles{count, circle, clocking};
}

std::optional<Section> read_section(const JsonFields& fields, const NodeFrame& frame) {
  const std::optional<std::string> shape = fields.text("shape");
  if (!shape) {
    fields.warn("lacks a shape; the section is left out");
    return std::nullopt;
  }
  return Section{*shape, frame.scale * fields.size("width_m").value_or(0),
                 frame.scale * fields.size("height_m").value_or(0)};
}

// Reads the elements of a list that a reader accepts.
template <class T, class Read>
std::vector<T> read_list(const JsonFields& fields, const std::string& key, const Read& read) {
  std::vector<T> out;
  const auto elements = fields.list(key);
  for (std::size_t i = 0; i < elements.size() && i < kMaxListed; ++i) {
    if (std::optional<T> each = read(fields.element(*elements[i], key, i))) {
      out.push_back(std::move(*each));
    }
  }
  return out;
}

int part_named(const DesignModel& design, const std::string& name) {
  for (std::size_t i = 0; i < design.parts.size(); ++i) {
    if (design.parts[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

// "part/port" as indices; names of parts may hold slashes, names of ports do not.
bool resolve(const DesignModel& design, const std::string& text, int& part, int& port) {
  const std::size_t slash = text.rfind('/');
  if (slash == std::string::npos) return false;
  part = part_named(design, text.substr(0, slash));
  if (part < 0) return false;
  const std::vector<Port>& ports = design.parts[static_cast<std::size_t>(part)].ports;
  for (std::size_t i = 0; i < ports.size(); ++i) {
    if (ports[i].name == text.substr(slash + 1)) port = static_cast<int>(i);
  }
  return port >= 0;
}

std::optional<Joint> read_joint(const JsonFields& fields, const DesignModel& design) {
  Joint joint;
  joint.weld = fields.text("weld", true).value_or("");
  const std::string a = fields.text("a").value_or("");
  const std::string b = fields.text("b").value_or("");
  if (!resolve(design, a, joint.part_a, joint.port_a) ||
      !resolve(design, b, joint.part_b, joint.port_b)) {
    fields.warn("joins '" + a + "' and '" + b +
                "', of which one is no part/port of this design; the joint is left out");
    return std::nullopt;
  }
  if (const auto type = fields.text("type")) {
    if (const std::optional<JointType> known = parse_joint_type(*type)) {
      joint.type = *known;
    } else {
      fields.warn("has a type '" + *type + "' that is none of fab field yaw; fab is taken");
    }
  }
  return joint;
}

}  // namespace

void read_part_semantics(const tinygltf::Value& extras, const NodeFrame& frame, Part& part,
                         std::vector<std::string>& warnings) {
  if (!extras.IsObject() || !extras.Has("spoolsight")) return;
  const JsonFields fields(extras.Get("spoolsight"), "node '" + part.name + "' extras.spoolsight",
                          warnings);
  if (const auto kind = fields.text("kind")) {
    if (const std::optional<PartKind> known = parse_part_kind(*kind)) {
      part.kind = *known;
    } else {
      fields.warn("has an unknown kind '" + *kind + "'; other is taken");
    }
  }
  part.nps = fields.size("nps").value_or(0);
  part.nps2 = fields.size("nps2").value_or(0);
  part.schedule = fields.text("schedule", true).value_or("");
  part.rating = fields.text("rating", true).value_or("");
  part.spool = fields.text("spool", true).value_or("");
  part.piece = fields.text("piece", true).value_or("");
  part.heat = fields.text("heat", true).value_or("");
  part.order = fields.integer("order").value_or(-1);
  part.ports = read_list<Port>(fields, "ports",
                               [&](const JsonFields& each) { return read_port(each, frame); });
  part.marks = read_list<Mark>(fields, "marks",
                               [&](const JsonFields& each) { return read_mark(each, frame); });
  if (const auto holes = fields.object("holes")) part.holes = read_holes(*holes, frame);
  if (const auto section = fields.object("section")) part.section = read_section(*section, frame);
}

void read_scene_semantics(const tinygltf::Value& extras, DesignModel& design) {
  if (!extras.IsObject() || !extras.Has("spoolsight")) return;
  std::vector<std::string> warnings;
  const JsonFields fields(extras.Get("spoolsight"), "the scene's extras.spoolsight", warnings);
  design.line = fields.text("line", true).value_or("");
  design.spool = fields.text("spool", true).value_or("");
  design.revision = fields.text("revision", true).value_or("");
  design.root_gap_m = fields.size("root_gap_m").value_or(0);
  design.joints = read_list<Joint>(
      fields, "joints", [&](const JsonFields& each) { return read_joint(each, design); });
  for (const tinygltf::Value* datum : fields.list("datums")) {
    const std::string name = datum->IsString() ? datum->Get<std::string>() : "";
    const int part = part_named(design, name);
    if (part < 0) {
      fields.warn("names a datum '" + name + "' that is no part of this design; it is left out");
    } else {
      design.datums.push_back(part);
    }
  }
  design.warnings.insert(design.warnings.end(), warnings.begin(), warnings.end());
}

}  // namespace spool
