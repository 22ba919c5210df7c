// A design as a .glb file: one node a part, semantics in extras.spoolsight (ARCHITECTURE, Files).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/design_glb.h"

#include <bit>
#include <cstdint>

#include <nlohmann/json.hpp>

#include "tools/campaign/part_mesh.h"
#include "tools/campaign/standard_sizes.h"

namespace spool::campaign {
namespace {

using nlohmann::json;
static_assert(std::endian::native == std::endian::little, "the file is little-endian");

json numbers(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

// As glTF designs spell it (ARCHITECTURE, Files).
const char* kind_word(PartKind kind) { return kind == PartKind::kTube ? "structure" : word(kind); }

json semantics(const PartSpec& spec, std::size_t order, const std::string& spool) {
  json s = {{"kind", kind_word(spec.kind)}, {"order", order}, {"spool", spool}};
  if (spec.nps > 0) {
    s["nps"] = spec.nps;
    s["schedule"] = "STD";
  }
  if (spec.nps2 > 0) s["nps2"] = spec.nps2;
  for (const PartPort& port : ports_of(spec)) {
    json p = {{"name", port.name},
              {"position", numbers(port.T_part_port.translation())},
              {"direction", numbers(port.T_part_port.linear().col(2))},
              {"end", port.end}};
    if (port.nps > 0) p["nps"] = port.nps;
    s["ports"].push_back(p);
  }
  if (spec.kind == PartKind::kFlange) {
    const StandardSizes& sizes = sizes_of(spec.nps);
    s["rating"] = "150";
    s["holes"] = {{"count", sizes.holes},
                  {"bolt_circle_m", sizes.bolt_circle},
                  {"clocking_rad", hole_clocking(sizes.holes)}};
  }
  if (spec.kind == PartKind::kTube)
    s["section"] = {{"shape", "square"}, {"width_m", spec.width_m}, {"height_m", spec.width_m}};
  return s;
}

json scene_semantics(const Assembly& assembly) {
  json joints = json::array();
  for (const Member& member : assembly.members) {
    if (member.parent < 0) continue;
    const PartSpec& parent = assembly.members[static_cast<std::size_t>(member.parent)].spec;
    const auto port = [](const PartSpec& spec, int index) {
      return spec.name + "/" + std::string(ports_of(spec)[static_cast<std::size_t>(index)].name);
    };
    joints.push_back({{"weld", "W" + std::to_string(joints.size() + 1)},
                      {"a", port(parent, member.parent_port)},
                      {"b", port(member.spec, member.own_port)},
                      {"type", "fab"}});
  }
  return {{"line", "100-" + assembly.name},
          {"spool", assembly.name},
          {"revision", "0"},
          {"joints", joints},
          {"datums", {assembly.members.front().spec.name}},
          {"root_gap_m", 0.0}};
}

// The binary chunk and what describes it.
struct Buffers {
  std::string bytes;
  json views = json::array(), accessors = json::array();

  template <class T>
  std::size_t add(const std::vector<T>& data, std::size_t count, int component, const char* type,
                  int target) {
    const std::size_t size = data.size() * sizeof(T);
    views.push_back(
        {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}, {"target", target}});
    bytes.append(reinterpret_cast<const char*>(data.data()), size);
    bytes.append((4 - bytes.size() % 4) % 4, '\0');
    accessors.push_back({{"bufferView", views.size() - 1},
                         {"componentType", component},
                         {"count", count},
                         {"type", type}});
    return accessors.size() - 1;
  }

  json primitive(const TriangleMesh& mesh) {
    std::vector<float> positions;
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& p : mesh.vertices) {
      positions.insert(positions.end(), {p.x(), p.y(), p.z()});
      box.extend(p);
    }
    std::vector<std::uint32_t> indices;
    for (const Triangle& t : mesh.triangles) indices.insert(indices.end(), t.begin(), t.end());
    constexpr int kFloat = 5126, kUnsignedInt = 5125, kArray = 34962, kElements = 34963;
    const std::size_t position = add(positions, mesh.vertices.size(), kFloat, "VEC3", kArray);
    accessors[position]["min"] = {box.min().x(), box.min().y(), box.min().z()};
    accessors[position]["max"] = {box.max().x(), box.max().y(), box.max().z()};
    const std::size_t index = add(indices, indices.size(), kUnsignedInt, "SCALAR", kElements);
    return {{"attributes", {{"POSITION", position}}}, {"indices", index}, {"mode", 4}};
  }
};

void append_u32(std::string& bytes, std::size_t value) {
  const auto word = static_cast<std::uint32_t>(value);
  bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
}

}  // namespace

std::string design_glb(const Assembly& assembly) {
  const std::vector<Pose> poses = poses_of(assembly);
  Buffers buffers;
  json nodes = json::array();
  json meshes = json::array();
  json roots = json::array();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const PartSpec& spec = assembly.members[i].spec;
    meshes.push_back({{"name", spec.name}, {"primitives", {buffers.primitive(mesh_of(spec))}}});
    const Eigen::Matrix4d matrix = poses[i].matrix();
    json columns = json::array();
    for (int k = 0; k < 16; ++k) columns.push_back(matrix(k % 4, k / 4));
    nodes.push_back({{"name", spec.name},
                     {"mesh", i},
                     {"matrix", columns},
                     {"extras", {{"spoolsight", semantics(spec, i, assembly.name)}}}});
    roots.push_back(i);
  }
  const json scene = {{"name", assembly.name},
                      {"nodes", roots},
                      {"extras", {{"spoolsight", scene_semantics(assembly)}}}};
  const json gltf = {{"asset", {{"version", "2.0"}, {"generator", "spoolsight-scenes"}}},
                     {"scene", 0},
                     {"scenes", {scene}},
                     {"nodes", nodes},
                     {"meshes", meshes},
                     {"accessors", buffers.accessors},
                     {"bufferViews", buffers.views},
                     {"buffers", {{{"byteLength", buffers.bytes.size()}}}}};
  std::string text = gltf.dump();
  text.append((4 - text.size() % 4) % 4, ' ');
  std::string bytes = "glTF";
  append_u32(bytes, 2);
  append_u32(bytes, 12 + 8 + text.size() + 8 + buffers.bytes.size());
  append_u32(bytes, text.size());
  bytes += "JSON" + text;
  append_u32(bytes, buffers.bytes.size());
  bytes.append("BIN\0", 4);
  return bytes + buffers.bytes;
}

TriangleMesh design_mesh(const Assembly& assembly) {
  const std::vector<Pose> poses = poses_of(assembly);
  TriangleMesh whole;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const TriangleMesh part = mesh_of(assembly.members[i].spec);
    const auto first = static_cast<std::uint32_t>(whole.vertices.size());
    for (const Eigen::Vector3f& p : part.vertices)
      whole.vertices.push_back((poses[i] * p.cast<double>()).cast<float>());
    for (const Triangle& t : part.triangles)
      whole.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return whole;
}

}  // namespace spool::campaign
