// A design from glTF: one part for each node with a mesh, placed by the tree of transforms.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "vision/design/design_builder.h"
#include "vision/design/gltf_file.h"
#include "vision/design/gltf_mesh.h"
#include "vision/design/gltf_semantics.h"
#include "vision/design/readers.h"

namespace spool {
namespace {

// A longest side outside these (m) is no spool, part or frame in metres.
constexpr double kSmallest = 0.01;
constexpr double kLargest = 50.0;

struct PlacedNode {
  std::size_t node = 0;
  Eigen::Affine3d T_file_node =
      Eigen::Affine3d::Identity();  // file units; may scale, shear, mirror
};

Error bad(const DesignFile& file, const std::string& what) {
  return {ErrorCode::kBadInput, file.path.string() + " " + what};
}

// The node's own transform: a matrix, or translation, rotation and scale (glTF 2.0, 3.5.3).
std::optional<Eigen::Affine3d> local_transform(const tinygltf::Node& node) {
  const auto fits = [](const std::vector<double>& v, std::size_t n) {
    return v.empty() || v.size() == n;
  };
  if (!fits(node.matrix, 16) || !fits(node.translation, 3) || !fits(node.rotation, 4) ||
      !fits(node.scale, 3)) {
    return std::nullopt;
  }
  Eigen::Affine3d T = Eigen::Affine3d::Identity();
  if (!node.matrix.empty()) {
    T.matrix() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());  // column by column
    if (!T.matrix().row(3).isApprox(Eigen::RowVector4d(0, 0, 0, 1), 1e-6)) return std::nullopt;
    T.makeAffine();
  } else {
    if (!node.translation.empty()) {
      T.translate(Eigen::Map<const Eigen::Vector3d>(node.translation.data()));
    }
    if (!node.rotation.empty()) {
      const Eigen::Quaterniond q(node.rotation[3], node.rotation[0], node.rotation[1],
                                 node.rotation[2]);
      if (!(q.norm() > 1e-3)) return std::nullopt;
      T.rotate(q.normalized());
    }
    if (!node.scale.empty()) T.scale(Eigen::Map<const Eigen::Vector3d>(node.scale.data()));
  }
  if (!T.matrix().allFinite()) return std::nullopt;
  return T;
}

// The nodes to start from: the default scene's, else the first's, else all that are nobody's child.
Result<std::vector<int>> root_nodes(const DesignFile& file, const tinygltf::Model& model,
                                    const tinygltf::Scene*& scene,
                                    std::vector<std::string>& warnings) {
  if (model.defaultScene >= 0 || !model.scenes.empty()) {
    const auto index = static_cast<std::size_t>(std::max(model.defaultScene, 0));
    if (index >= model.scenes.size())
      return bad(file, "is damaged: its default scene is not there");
    if (model.defaultScene < 0 && model.scenes.size() > 1) {
      warnings.push_back("the file has " + std::to_string(model.scenes.size()) +
                         " scenes and no default; the first is read");
    }
    scene = &model.scenes[index];
    return scene->nodes;
  }
  std::vector<bool> is_child(model.nodes.size(), false);
  for (const tinygltf::Node& node : model.nodes) {
    for (const int child : node.children) {
      if (child >= 0 && static_cast<std::size_t>(child) < is_child.size()) {
        is_child[static_cast<std::size_t>(child)] = true;
      }
    }
  }
  std::vector<int> roots;
  for (std::size_t i = 0; i < is_child.size(); ++i) {
    if (!is_child[i]) roots.push_back(static_cast<int>(i));
  }
  return roots;
}

// All nodes below the roots in file order of the tree, each with its place. A stack of our own: no
// chain of nodes is too deep.
Result<std::vector<PlacedNode>> place_nodes(const DesignFile& file, const tinygltf::Model& model,
                                            const std::vector<int>& roots) {
  std::vector<PlacedNode> placed;
  std::vector<bool> reached(model.nodes.size(), false);
  std::vector<std::pair<int, Eigen::Affine3d>> open;
  for (auto root = roots.rbegin(); root != roots.rend(); ++root) {
    open.emplace_back(*root, Eigen::Affine3d::Identity());
  }
  while (!open.empty()) {
    const auto [index, T_file_parent] = open.back();
    open.pop_back();
    const std::string name = "node " + std::to_string(index);
    if (index < 0 || static_cast<std::size_t>(index) >= model.nodes.size()) {
      return bad(file, "is damaged: " + name + " is not there");
    }
    const auto i = static_cast<std::size_t>(index);
    if (reached[i]) return bad(file, "is damaged: " + name + " has two parents or is its own");
    reached[i] = true;
    const tinygltf::Node& node = model.nodes[i];
    const std::optional<Eigen::Affine3d> local = local_transform(node);
    if (!local) return bad(file, "is damaged: " + name + " has a transform that cannot be");
    placed.push_back({i, T_file_parent * *local});
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
      open.emplace_back(*child, placed.back().T_file_node);
    }
  }
  return placed;
}

// Splits a node's transform into the part's rigid pose (m) and what is left for its own frame. A
// mirror is taken along the node's x, so that its z, a flange's axis, stays the part's.
std::optional<NodeFrame> split(const Eigen::Affine3d& T_file_node, double unit_m,
                               Pose& T_file_part) {
  const Eigen::Matrix3d linear = T_file_node.linear();
  NodeFrame frame;
  frame.mirrored = linear.determinant() < 0;
  Eigen::Matrix3d upright = linear;
  if (frame.mirrored) upright.col(0) *= -1;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(upright, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d stretch = svd.singularValues();
  if (!(stretch[2] > 1e-9 * stretch[0]) || !(stretch[2] > 1e-12)) return std::nullopt;
  const Eigen::Matrix3d R = svd.matrixU() * svd.matrixV().transpose();  // nearest rotation
  T_file_part = Pose::Identity();
  T_file_part.linear() = R;
  T_file_part.translation() = unit_m * T_file_node.translation();
  frame.part_from_node = unit_m * R.transpose() * linear;
  frame.scale = std::cbrt(stretch.prod());
  return frame;
}

bool is_uneven(const NodeFrame& frame) {
  const Eigen::Vector3d lengths = frame.part_from_node.colwise().norm();
  return lengths.maxCoeff() > 1.001 * lengths.minCoeff();
}

// The part of one placed node, its mesh brought to metres in the file's frame.
RawPart make_part(const tinygltf::Node& node, const GltfMesh& mesh, const PlacedNode& placed,
                  double unit_m, const NodeFrame& frame, const Pose& T_file_part,
                  std::vector<std::string>& warnings) {
  RawPart raw;
  raw.part.name = node.name;
  raw.part.T_design_part = T_file_part;
  read_part_semantics(node.extras, frame, raw.part, warnings);
  if (is_uneven(frame) && (raw.part.holes || !raw.part.ports.empty())) {
    warnings.push_back("node '" + node.name +
                       "' is scaled unevenly: sizes that its extras give are scaled by the mean");
  }
  raw.vertices.reserve(mesh.vertices.size());
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    raw.vertices.push_back(unit_m * (placed.T_file_node * vertex));
  }
  raw.triangles = mesh.triangles;
  if (frame.mirrored) {  // a mirror turns triangles inside out
    for (Triangle& triangle : raw.triangles) std::swap(triangle[1], triangle[2]);
  }
  return raw;
}

void warn_of_size(const DesignFile& file, DesignModel& design) {
  const double longest = design.bounds().sizes().maxCoeff();
  if (file.unit || (longest >= kSmallest && longest <= kLargest)) return;
  std::string size = std::to_string(longest);
  design.warnings.push_back("read as metres, as glTF is, the design is " + size +
                            " m long: where it was drawn in another unit, say so by --design-unit");
}

}  // namespace

Result<DesignModel> read_gltf_design(const DesignFile& file) {
  Result<GltfModel> loaded = load_gltf(file);
  if (!loaded) return loaded.error();
  const tinygltf::Model& model = **loaded;
  DesignModel design;
  design.path = file.path.string();
  design.unit = file.unit.value_or(LengthUnit::kMetre);
  const double unit_m = metres(design.unit);
  const tinygltf::Scene* scene = nullptr;
  const Result<std::vector<int>> roots = root_nodes(file, model, scene, design.warnings);
  if (!roots) return roots.error();
  const Result<std::vector<PlacedNode>> placed = place_nodes(file, model, *roots);
  if (!placed) return placed.error();

  std::vector<RawPart> parts;
  std::map<int, GltfMesh> meshes;  // read once, placed by every node that uses it
  std::size_t triangles = 0;
  for (const PlacedNode& each : *placed) {
    tinygltf::Node node = model.nodes[each.node];
    if (node.mesh < 0) continue;
    const std::string name = "node " + std::to_string(each.node);
    if (static_cast<std::size_t>(node.mesh) >= model.meshes.size()) {
      return bad(file, "is damaged: " + name + " names a mesh that is not there");
    }
    auto mesh = meshes.find(node.mesh);
    if (mesh == meshes.end()) {
      Result<GltfMesh> read = read_gltf_mesh(model, static_cast<std::size_t>(node.mesh));
      if (!read) return bad(file, "is damaged: " + read.error().message);
      if (read->skipped_primitives > 0) {
        design.warnings.push_back("mesh " + std::to_string(node.mesh) + " has " +
                                  std::to_string(read->skipped_primitives) +
                                  " primitives of points or lines, which are left out");
      }
      mesh = meshes.emplace(node.mesh, std::move(*read)).first;
    }
    if (node.name.empty()) node.name = "part_" + std::to_string(parts.size() + 1);
    triangles += mesh->second.triangles.size();
    if (triangles > kMaxDesignTriangles) {
      return bad(file, "places more than " + std::to_string(kMaxDesignTriangles) +
                           " triangles; export it coarser");
    }
    Pose T_file_part;
    const std::optional<NodeFrame> frame = split(each.T_file_node, unit_m, T_file_part);
    if (!frame) {
      design.warnings.push_back("node '" + node.name + "' is scaled to nothing and is left out");
      continue;
    }
    parts.push_back(
        make_part(node, mesh->second, each, unit_m, *frame, T_file_part, design.warnings));
  }
  if (parts.empty()) {
    return bad(file, "has no mesh in its scene; export the design with its surfaces");
  }
  if (Status built = build_mesh(std::move(parts), design); !built) return built.error();
  if (scene != nullptr) read_scene_semantics(scene->extras, design);
  warn_of_size(file, design);
  return design;
}

}  // namespace spool
