// Closest point and first hit on triangles: Embree's tree, our triangle arithmetic and sign.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cassert>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <embree3/rtcore.h>

#include "vision/design/closest_on_triangle.h"
#include "vision/design/pseudonormals.h"
#include "vision/design/surface_kinds.h"

namespace spool {
namespace {

struct DeviceRelease {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneRelease {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using DevicePointer = std::unique_ptr<RTCDeviceTy, DeviceRelease>;
using ScenePointer = std::unique_ptr<RTCSceneTy, SceneRelease>;

using Corners = std::array<Eigen::Vector3f, 3>;

// What one closest-point search carries through Embree's callback.
struct Search {
  const Corners* corners = nullptr;
  Eigen::Vector3f query = Eigen::Vector3f::Zero();
  float best_squared = 0;
  TrianglePoint best;
  std::uint32_t primitive = RTC_INVALID_GEOMETRY_ID;
};

// Embree calls this for each triangle whose box the ball touches. Returns true where the ball
// shrank.
bool visit(RTCPointQueryFunctionArguments* arguments) {
  Search& search = *static_cast<Search*>(arguments->userPtr);
  const Corners& p = search.corners[arguments->primID];
  const TrianglePoint found =
      closest_to_origin(p[0] - search.query, p[1] - search.query, p[2] - search.query);
  const float squared = found.point.squaredNorm();
  if (!(squared <= search.best_squared)) return false;
  // Of triangles equally near the first in the file counts, so that the answer does not hang on the
  // tree.
  if (squared == search.best_squared && arguments->primID >= search.primitive) return false;
  search.best_squared = squared;
  search.best = found;
  search.primitive = arguments->primID;
  arguments->query->radius = std::sqrt(squared);
  return true;
}

class TriangleSurface final : public SurfaceKind {
 public:
  TriangleSurface(DevicePointer device, ScenePointer scene, std::vector<Corners> corners,
                  std::vector<std::uint32_t> triangle, std::vector<TriangleNormals> normals,
                  std::vector<std::int32_t> part)
      : device_(std::move(device)),
        scene_(std::move(scene)),
        corners_(std::move(corners)),
        triangle_(std::move(triangle)),
        normals_(std::move(normals)),
        part_(std::move(part)) {}

  std::optional<SurfacePoint> closest(const Eigen::Vector3f& query,
                                      float max_distance) const override {
    if (!query.allFinite() || !(max_distance >= 0)) return std::nullopt;
    Search search;
    search.corners = corners_.data();
    search.query = query;
    search.best_squared = max_distance * max_distance;
    RTCPointQuery ball{query.x(), query.y(), query.z(), 0.0F, max_distance};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene_.get(), &ball, &context, &visit, &search);
    if (search.primitive == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    SurfacePoint answer;
    answer.element = triangle_[search.primitive];
    answer.part = part_[answer.element];
    answer.point = query + search.best.point;
    answer.normal = normals_[answer.element][static_cast<std::size_t>(search.best.feature)];
    // best.point leads from the query to the surface: outside it runs against the normal.
    const float length = std::sqrt(search.best_squared);
    answer.distance = answer.normal.dot(search.best.point) > 0 ? -length : length;
    return answer;
  }

  std::optional<RayHit> cast(const Eigen::Vector3f& from, const Eigen::Vector3f& direction,
                             float max_distance) const override {
    assert(std::abs(direction.norm() - 1) < 1e-3F && "a unit direction");
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit ray{};
    ray.ray.org_x = from.x();
    ray.ray.org_y = from.y();
    ray.ray.org_z = from.z();
    ray.ray.dir_x = direction.x();
    ray.ray.dir_y = direction.y();
    ray.ray.dir_z = direction.z();
    ray.ray.tnear = 0;
    ray.ray.tfar = max_distance;
    ray.ray.mask = 0xFFFFFFFFU;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_.get(), &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    const std::uint32_t triangle = triangle_[ray.hit.primID];
    return RayHit{ray.ray.tfar, normals_[triangle][0], part_[triangle]};
  }

 private:
  DevicePointer device_;
  ScenePointer scene_;
  std::vector<Corners> corners_;          // of each Embree primitive, side by side for the cache
  std::vector<std::uint32_t> triangle_;   // of each Embree primitive
  std::vector<TriangleNormals> normals_;  // of each triangle
  std::vector<std::int32_t> part_;        // of each triangle
};

DevicePointer make_device() {
#ifdef SPOOL_SERIAL
  return DevicePointer(rtcNewDevice("threads=1"));  // Debian's TBB is not instrumented
#else
  return DevicePointer(rtcNewDevice(nullptr));
#endif
}

}  // namespace

Result<std::unique_ptr<SurfaceKind>> make_triangle_surface(const TriangleMesh& mesh,
                                                           std::span<const std::int32_t> part) {
  assert(part.size() == mesh.triangles.size() && "a part for every triangle");
  std::vector<TriangleNormals> normals = pseudonormals(mesh, part);
  std::vector<Corners> corners;
  std::vector<std::uint32_t> triangle;
  corners.reserve(mesh.triangles.size());
  triangle.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (normals[t][0].isZero()) continue;  // no area: its neighbours have its edges
    const Triangle& own = mesh.triangles[t];
    corners.push_back({mesh.vertices[own[0]], mesh.vertices[own[1]], mesh.vertices[own[2]]});
    triangle.push_back(t);
  }
  if (corners.empty()) {
    return Error{ErrorCode::kBadInput, "the design has no triangle with an area"};
  }
  const auto refused = [] {
    return Error{ErrorCode::kInternal,
                 "Embree could not build its tree over the design's triangles"};
  };
  DevicePointer device = make_device();
  if (!device) return refused();
  ScenePointer scene(rtcNewScene(device.get()));
  rtcSetSceneFlags(scene.get(),
                   RTC_SCENE_FLAG_ROBUST);  // no ray slips through between two triangles
  // Not high quality: its split triangles are visited once for every piece.
  rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_MEDIUM);
  RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* positions = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              3 * sizeof(float), mesh.vertices.size()));
  auto* indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), triangle.size()));
  if (positions != nullptr && indices != nullptr) {
    for (const Eigen::Vector3f& vertex : mesh.vertices) {
      for (int axis = 0; axis < 3; ++axis) *positions++ = vertex[axis];
    }
    for (const std::uint32_t t : triangle) {
      for (const std::uint32_t vertex : mesh.triangles[t]) *indices++ = vertex;
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene.get(), geometry);
    rtcCommitScene(scene.get());
  }
  rtcReleaseGeometry(geometry);
  if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE) return refused();
  return std::unique_ptr<SurfaceKind>(std::make_unique<TriangleSurface>(
      std::move(device), std::move(scene), std::move(corners), std::move(triangle),
      std::move(normals), std::vector<std::int32_t>(part.begin(), part.end())));
}

}  // namespace spool
