// From what a reader found in a file to a DesignModel: one frame, one origin, one mesh, names
// told apart.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "vision/core/result.h"
#include "vision/design/design_model.h"

namespace spool {

// A part as a reader hands it over: everything metres in the file's own frame, in double. Its names
// and semantics are set; T_design_part is still in the file's frame, the triangle range is not
// known yet.
struct RawPart {
  Part part;
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Triangle> triangles;  // each index < vertices.size()
};

// More would not fit the memory of a tablet.
inline constexpr std::size_t kMaxDesignTriangles = 20'000'000;

// Fills parts, mesh, triangle_part, origin and warnings of `design`, whose path is set. Triangles
// without area are dropped and counted, parts without a triangle are dropped by name, equal names
// are numbered. The origin leaves zero only where the design lies so far out that float would lose
// micrometres. kBadInput where no triangle is left, a coordinate is not finite, or there are too
// many triangles.
[[nodiscard]] Status build_mesh(std::vector<RawPart> raw, DesignModel& design);

// The origin (m, whole metres) for a design with these bounds: zero where they are near enough for
// float.
[[nodiscard]] Eigen::Vector3d design_origin(const Eigen::AlignedBox3d& bounds);

// "part", "part_2", "part_3": gives every part a name of its own; warns of those that had to
// change.
void make_names_unique(std::vector<Part>& parts, std::vector<std::string>& warnings);

}  // namespace spool
