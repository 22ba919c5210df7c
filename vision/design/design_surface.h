// The design's surface as geometry: closest point, signed distance, the first hit of a ray.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vision/core/cloud_view.h"
#include "vision/core/result.h"
#include "vision/design/design_model.h"
#include "vision/design/surface_memory.h"

namespace spool {

// The surface point closest to a query.
struct SurfacePoint {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();  // m, design frame
  Eigen::Vector3f normal =
      Eigen::Vector3f::Zero();  // unit, outward; of a cloud design: as far as it is known
  float distance = 0;           // m, + outside the surface
  std::int32_t part = -1;
  std::uint32_t element = 0;  // triangle, or point of a cloud design
};

struct RayHit {
  float distance = 0;  // m along the unit direction
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  std::int32_t part = -1;
};

// Immutable; const queries from many threads. Embree over triangles; for a cloud design the local
// plane through the nearest design points (so that sampling spacing does not show).
class DesignSurface {
 public:
  // Builds over `design`, which must outlive it. kBadInput where there is nothing to build over.
  [[nodiscard]] static Result<DesignSurface> build(const DesignModel& design);
  // Over any cloud with normals as one part (for cloud-to-cloud registration); must outlive it.
  [[nodiscard]] static Result<DesignSurface> build(const CloudView& cloud);
  DesignSurface(DesignSurface&&) noexcept;
  DesignSurface& operator=(DesignSurface&&) noexcept;
  ~DesignSurface();

  [[nodiscard]] const Eigen::AlignedBox3d& bounds() const;  // m, design frame

  // Nothing where the surface is further than `max_distance` (m). The sign comes from the
  // angle-weighted pseudonormal (Baerentzen & Aanaes 2005) at edges and vertices.
  [[nodiscard]] std::optional<SurfacePoint> closest(const Eigen::Vector3f& query,
                                                    float max_distance) const;
  // The same answer, to the bit where no two elements are equally near, for a query that comes back
  // a little moved: `memory` (one for each such query) answers while it can, else is searched anew
  // `margin` (m) further than the answer needs, which is room for the query to move in by half.
  [[nodiscard]] std::optional<SurfacePoint> closest(const Eigen::Vector3f& query,
                                                    float max_distance, float margin,
                                                    SurfaceMemory& memory) const;
  // Of triangles the same. Of a cloud the tangent plane of the nearest design point alone, for half
  // the price: its spacing shows in the distance, which is for queries that are far from home.
  [[nodiscard]] std::optional<SurfacePoint> closest_tangent(const Eigen::Vector3f& query,
                                                            float max_distance) const;
  // Whether closest() would give an answer; quicker.
  [[nodiscard]] bool is_within(const Eigen::Vector3f& query, float max_distance) const;
  // The first surface along a ray, within `max_distance` (m); always nothing for a cloud design.
  [[nodiscard]] std::optional<RayHit> cast(const Eigen::Vector3f& from,
                                           const Eigen::Vector3f& direction,
                                           float max_distance) const;

 private:
  struct Impl;
  explicit DesignSurface(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace spool
