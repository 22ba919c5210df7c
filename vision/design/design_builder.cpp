// From what a reader found in a file to a DesignModel: one frame, one origin, one mesh, names
// told apart.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/design_builder.h"

#include <cassert>
#include <set>
#include <utility>

namespace spool {
namespace {

// Further out than this (m) float steps exceed two micrometres, a tenth of what a laser tracker
// sees.
constexpr double kNearEnough = 16.0;

bool has_area(const RawPart& raw, const Triangle& triangle) {
  const Eigen::Vector3d& a = raw.vertices[triangle[0]];
  return (raw.vertices[triangle[1]] - a).cross(raw.vertices[triangle[2]] - a).norm() > 0;
}

// The same question after rounding to float, which is what the surface is built over.
bool has_area(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
  return a != b && b != c && c != a &&
         (b - a).cast<double>().cross((c - a).cast<double>()).norm() > 0;
}

void append(const RawPart& raw, DesignModel& design, std::size_t& flat) {
  constexpr std::uint32_t kUnused = 0xFFFFFFFFU;
  const std::int32_t part_index = static_cast<std::int32_t>(design.parts.size());
  Part part = raw.part;
  part.T_design_part.translation() -= design.origin;
  part.first_triangle = static_cast<std::uint32_t>(design.mesh.triangles.size());
  std::vector<Eigen::Vector3f> rounded(raw.vertices.size());
  for (std::size_t v = 0; v < rounded.size(); ++v) {
    rounded[v] = (raw.vertices[v] - design.origin).cast<float>();
  }
  std::vector<std::uint32_t> place(raw.vertices.size(), kUnused);
  for (const Triangle& triangle : raw.triangles) {
    if (!has_area(rounded[triangle[0]], rounded[triangle[1]], rounded[triangle[2]])) {
      ++flat;
      continue;
    }
    Triangle placed{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& slot = place[triangle[k]];
      if (slot == kUnused) {
        slot = static_cast<std::uint32_t>(design.mesh.vertices.size());
        design.mesh.vertices.push_back(rounded[triangle[k]]);
      }
      placed[k] = slot;
    }
    design.mesh.triangles.push_back(placed);
    design.triangle_part.push_back(part_index);
  }
  part.triangle_count =
      static_cast<std::uint32_t>(design.mesh.triangles.size()) - part.first_triangle;
  if (part.triangle_count == 0) {
    design.warnings.push_back("part '" + part.name + "' has no triangle and is left out");
    return;
  }
  design.parts.push_back(std::move(part));
}

}  // namespace

Eigen::Vector3d design_origin(const Eigen::AlignedBox3d& bounds) {
  if (bounds.isEmpty() || bounds.center().norm() <= kNearEnough) return Eigen::Vector3d::Zero();
  return bounds.center().array().round();
}

void make_names_unique(std::vector<Part>& parts, std::vector<std::string>& warnings) {
  std::set<std::string> taken;
  for (const Part& part : parts) taken.insert(part.name);
  std::set<std::string> seen;
  for (Part& part : parts) {
    if (seen.insert(part.name).second) continue;
    std::string fresh;
    for (int number = 2; fresh.empty() || taken.count(fresh) != 0; ++number) {
      fresh = part.name + "_" + std::to_string(number);
    }
    warnings.push_back("another part is named '" + part.name + "': this one becomes '" + fresh +
                       "'");
    taken.insert(fresh);
    seen.insert(fresh);
    part.name = std::move(fresh);
  }
}

Status build_mesh(std::vector<RawPart> raw, DesignModel& design) {
  Eigen::AlignedBox3d bounds;
  std::size_t triangles = 0;
  for (const RawPart& each : raw) {
    triangles += each.triangles.size();
    for (const Eigen::Vector3d& vertex : each.vertices) {
      // Past 1e9 m not even double keeps a tenth of a millimetre, and float products overflow.
      if (!vertex.allFinite() || vertex.cwiseAbs().maxCoeff() > 1e9) {
        return Error{ErrorCode::kBadInput,
                     design.path + " has a vertex of part '" + each.part.name +
                         "' that is not a finite place; export the design again"};
      }
    }
    // Only what a triangle uses counts: a stray vertex must not move the origin.
    for (const Triangle& triangle : each.triangles) {
      if (!has_area(each, triangle)) continue;
      for (const std::uint32_t vertex : triangle) bounds.extend(each.vertices[vertex]);
    }
  }
  if (triangles > kMaxDesignTriangles) {
    return Error{ErrorCode::kBadInput,
                 design.path + " has " + std::to_string(triangles) + " triangles, more than the " +
                     std::to_string(kMaxDesignTriangles) + " that are read; export it coarser"};
  }
  design.origin = design_origin(bounds);
  std::size_t flat = 0;
  for (RawPart& each : raw) {
    append(each, design, flat);
    each = {};  // its memory is not needed twice
  }
  if (flat > 0) {
    design.warnings.push_back("triangles without area are left out: " + std::to_string(flat));
  }
  if (design.mesh.triangles.empty()) {
    return Error{ErrorCode::kBadInput,
                 design.path + " has no surface: not one triangle with an area"};
  }
  make_names_unique(design.parts, design.warnings);
  return {};
}

}  // namespace spool
