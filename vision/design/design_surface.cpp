// The design's surface as geometry: picks the kind that the design has.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/design_surface.h"

#include <utility>

#include "vision/design/surface_kinds.h"

namespace spool {

struct DesignSurface::Impl {
  std::unique_ptr<SurfaceKind> kind;
  Eigen::AlignedBox3d bounds;
};

DesignSurface::DesignSurface(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
DesignSurface::DesignSurface(DesignSurface&&) noexcept = default;
DesignSurface& DesignSurface::operator=(DesignSurface&&) noexcept = default;
DesignSurface::~DesignSurface() = default;

Result<DesignSurface> DesignSurface::build(const DesignModel& design) {
  auto kind = design.is_cloud() ? make_cloud_surface(design.cloud)
                                : make_triangle_surface(design.mesh, design.triangle_part);
  if (!kind) {
    return Error{kind.error().code,
                 "no surface can be built over " + design.path + ": " + kind.error().message};
  }
  return DesignSurface(std::make_unique<Impl>(Impl{std::move(*kind), design.bounds()}));
}

Result<DesignSurface> DesignSurface::build(const CloudView& cloud) {
  auto kind = make_cloud_surface(cloud);
  if (!kind) return kind.error();
  Eigen::AlignedBox3d bounds;
  for (const Eigen::Vector3f& point : cloud.points)
    if (point.allFinite()) bounds.extend(point.cast<double>());
  return DesignSurface(std::make_unique<Impl>(Impl{std::move(*kind), bounds}));
}

const Eigen::AlignedBox3d& DesignSurface::bounds() const { return impl_->bounds; }

std::optional<SurfacePoint> DesignSurface::closest(const Eigen::Vector3f& query,
                                                   float max_distance) const {
  return impl_->kind->closest(query, max_distance);
}

std::optional<SurfacePoint> DesignSurface::closest(const Eigen::Vector3f& query, float max_distance,
                                                   float margin, SurfaceMemory& memory) const {
  return impl_->kind->closest(query, max_distance, margin, memory);
}

std::optional<SurfacePoint> DesignSurface::closest_tangent(const Eigen::Vector3f& query,
                                                           float max_distance) const {
  return impl_->kind->closest_tangent(query, max_distance);
}

bool DesignSurface::is_within(const Eigen::Vector3f& query, float max_distance) const {
  return impl_->kind->is_within(query, max_distance);
}

std::optional<RayHit> DesignSurface::cast(const Eigen::Vector3f& from,
                                          const Eigen::Vector3f& direction,
                                          float max_distance) const {
  return impl_->kind->cast(from, direction, max_distance);
}

}  // namespace spool
