// The two kinds of surface behind DesignSurface: triangles and bare points.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "vision/core/cloud_view.h"
#include "vision/core/triangle_mesh.h"
#include "vision/design/design_surface.h"

namespace spool {

// What DesignSurface asks of either. Const queries from many threads; contracts as there.
class SurfaceKind {
 public:
  virtual ~SurfaceKind() = default;
  [[nodiscard]] virtual std::optional<SurfacePoint> closest(const Eigen::Vector3f& query,
                                                            float max_distance) const = 0;
  [[nodiscard]] virtual std::optional<SurfacePoint> closest(const Eigen::Vector3f& query,
                                                            float max_distance, float margin,
                                                            SurfaceMemory& memory) const = 0;
  [[nodiscard]] virtual std::optional<SurfacePoint> closest_tangent(const Eigen::Vector3f& query,
                                                                    float max_distance) const = 0;
  [[nodiscard]] virtual bool is_within(const Eigen::Vector3f& query, float max_distance) const = 0;
  [[nodiscard]] virtual std::optional<RayHit> cast(const Eigen::Vector3f& from,
                                                   const Eigen::Vector3f& direction,
                                                   float max_distance) const = 0;
};

// Embree over the triangles that have an area. Copies what it needs. kInternal where Embree
// refuses.
[[nodiscard]] Result<std::unique_ptr<SurfaceKind>> make_triangle_surface(
    const TriangleMesh& mesh, std::span<const std::int32_t> part);

// Local planes through the finite points of a cloud that outlives it, all of part 0. Normals are
// estimated where the cloud has none.
[[nodiscard]] Result<std::unique_ptr<SurfaceKind>> make_cloud_surface(const CloudView& cloud);

}  // namespace spool
