// A design as a GLB file with the semantics of extras.spoolsight (ARCHITECTURE, Files).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/gltf_writer.h"

#include <cstring>
#include <map>
#include <sstream>
#include <utility>

#include <tiny_gltf.h>

#include "vision/core/version.h"

namespace spool {
namespace {

using tinygltf::Value;
using Object = Value::Object;

Value vector(const Eigen::Vector3d& v) {
  return Value(Value::Array{Value(v.x()), Value(v.y()), Value(v.z())});
}

void set_text(Object& object, const std::string& key, const std::string& text) {
  if (!text.empty()) object[key] = Value(text);
}
void set_size(Object& object, const std::string& key, double size) {
  if (size > 0) object[key] = Value(size);
}

Value port_value(const Port& port) {
  Object out;
  out["name"] = Value(port.name);
  out["position"] = vector(port.position);
  out["direction"] = vector(port.direction);
  set_size(out, "nps", port.nps);
  out["end"] = Value(std::string(name(port.end)));
  return Value(out);
}

Value mark_value(const Mark& mark) {
  Object out;
  out["type"] = Value(mark.type);
  out["position"] = vector(mark.position);
  out["direction"] = vector(mark.direction);
  set_size(out, "size_m", mark.size_m);
  return Value(out);
}

template <class T, class Write>
void set_list(Object& object, const std::string& key, const std::vector<T>& list,
              const Write& write) {
  if (list.empty()) return;
  Value::Array array;
  for (const T& each : list) array.push_back(write(each));
  object[key] = Value(std::move(array));
}

Value part_extras(const Part& part) {
  Object out;
  out["kind"] = Value(std::string(name(part.kind)));
  set_size(out, "nps", part.nps);
  set_size(out, "nps2", part.nps2);
  set_text(out, "schedule", part.schedule);
  set_text(out, "rating", part.rating);
  if (part.order >= 0) out["order"] = Value(part.order);
  set_text(out, "spool", part.spool);
  set_text(out, "piece", part.piece);
  set_text(out, "heat", part.heat);
  set_list(out, "ports", part.ports, port_value);
  set_list(out, "marks", part.marks, mark_value);
  if (part.holes) {
    out["holes"] = Value(Object{{"count", Value(part.holes->count)},
                                {"bolt_circle_m", Value(part.holes->bolt_circle_m)},
                                {"clocking_rad", Value(part.holes->clocking_rad)}});
  }
  if (part.section) {
    out["section"] = Value(Object{{"shape", Value(part.section->shape)},
                                  {"width_m", Value(part.section->width_m)},
                                  {"height_m", Value(part.section->height_m)}});
  }
  return Value(Object{{"spoolsight", Value(out)}});
}

Value scene_extras(const DesignModel& design) {
  Object out;
  set_text(out, "line", design.line);
  set_text(out, "spool", design.spool);
  set_text(out, "revision", design.revision);
  set_size(out, "root_gap_m", design.root_gap_m);
  const auto port_text = [&](int part, int port) {
    const Part& each = design.parts[static_cast<std::size_t>(part)];
    return Value(each.name + "/" + each.ports[static_cast<std::size_t>(port)].name);
  };
  set_list(out, "joints", design.joints, [&](const Joint& joint) {
    Object each;
    each["weld"] = Value(joint.weld);
    each["a"] = port_text(joint.part_a, joint.port_a);
    each["b"] = port_text(joint.part_b, joint.port_b);
    each["type"] = Value(std::string(name(joint.type)));
    return Value(each);
  });
  set_list(out, "datums", design.datums,
           [&](int part) { return Value(design.parts[static_cast<std::size_t>(part)].name); });
  return Value(Object{{"spoolsight", Value(out)}});
}

// The file's one buffer, with a view and an accessor for each stretch.
class Packer {
 public:
  explicit Packer(tinygltf::Model& model) : model_(model) { model_.buffers.resize(1); }

  int positions(const std::vector<Eigen::Vector3f>& points) {
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& point : points) box.extend(point);
    tinygltf::Accessor accessor;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.type = TINYGLTF_TYPE_VEC3;
    accessor.count = points.size();
    for (Eigen::Index i = 0; i < 3; ++i) {  // the format asks for the bounds of positions
      accessor.minValues.push_back(static_cast<double>(box.min()[i]));
      accessor.maxValues.push_back(static_cast<double>(box.max()[i]));
    }
    return add(accessor, points.data(), points.size() * sizeof(Eigen::Vector3f),
               TINYGLTF_TARGET_ARRAY_BUFFER);
  }

  int indices(const std::vector<Triangle>& triangles) {
    tinygltf::Accessor accessor;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    accessor.type = TINYGLTF_TYPE_SCALAR;
    accessor.count = 3 * triangles.size();
    return add(accessor, triangles.data(), triangles.size() * sizeof(Triangle),
               TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  }

 private:
  int add(tinygltf::Accessor accessor, const void* data, std::size_t bytes, int target) {
    std::vector<unsigned char>& buffer = model_.buffers[0].data;
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = buffer.size();
    view.byteLength = bytes;
    view.target = target;
    buffer.resize(buffer.size() + bytes);  // floats and 32-bit indices stay aligned to 4 bytes
    if (bytes > 0) std::memcpy(buffer.data() + view.byteOffset, data, bytes);
    accessor.bufferView = static_cast<int>(model_.bufferViews.size());
    model_.bufferViews.push_back(view);
    model_.accessors.push_back(std::move(accessor));
    return static_cast<int>(model_.accessors.size()) - 1;
  }
  tinygltf::Model& model_;
};

// The part's triangles in its own frame.
tinygltf::Mesh part_mesh(const DesignModel& design, const Part& part, Packer& packer) {
  const Pose T_part_design = part.T_design_part.inverse();
  std::vector<Eigen::Vector3f> points;
  std::vector<Triangle> triangles;
  std::map<std::uint32_t, std::uint32_t> places;
  for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
    Triangle local{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = design.mesh.triangles[t][k];
      const auto [place, is_new] =
          places.emplace(vertex, static_cast<std::uint32_t>(points.size()));
      if (is_new)
        points.emplace_back(
            (T_part_design * design.mesh.vertices[vertex].cast<double>()).cast<float>());
      local[k] = place->second;
    }
    triangles.push_back(local);
  }
  tinygltf::Primitive primitive;
  primitive.attributes["POSITION"] = packer.positions(points);
  primitive.indices = packer.indices(triangles);
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  tinygltf::Mesh mesh;
  mesh.name = part.name;
  mesh.primitives.push_back(std::move(primitive));
  return mesh;
}

}  // namespace

Result<std::string> write_gltf(const DesignModel& design) {
  if (design.is_cloud())
    return Error{ErrorCode::kBadInput,
                 design.path + " is a cloud of points without a surface, which glTF is not for"};
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "SpoolSight " + std::string(version());
  Packer packer(model);
  tinygltf::Node root;
  root.name = design.line.empty() ? "design" : design.line;
  root.translation = {design.origin.x(), design.origin.y(), design.origin.z()};
  model.nodes.emplace_back();  // the root's place
  for (const Part& part : design.parts) {
    tinygltf::Node node;
    node.name = part.name;
    node.mesh = static_cast<int>(model.meshes.size());
    const Eigen::Vector3d at = part.T_design_part.translation();
    const Eigen::Quaterniond q(part.T_design_part.linear());
    node.translation = {at.x(), at.y(), at.z()};
    node.rotation = {q.x(), q.y(), q.z(), q.w()};
    node.extras = part_extras(part);
    model.meshes.push_back(part_mesh(design, part, packer));
    root.children.push_back(static_cast<int>(model.nodes.size()));
    model.nodes.push_back(std::move(node));
  }
  model.nodes[0] = std::move(root);
  tinygltf::Scene scene;
  scene.name = design.spool;
  scene.nodes = {0};
  scene.extras = scene_extras(design);
  model.scenes.push_back(std::move(scene));
  model.defaultScene = 0;
  std::ostringstream out;
  tinygltf::TinyGLTF writer;
  if (!writer.WriteGltfSceneToStream(&model, out, false, true) || !out)
    return Error{ErrorCode::kInternal, "the design cannot be written as glTF"};
  return std::move(out).str();
}

}  // namespace spool
