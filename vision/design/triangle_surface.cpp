// Closest point and first hit on triangles: Embree's tree, our triangle arithmetic and sign.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
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

// What a search carries that leaves a memory behind: the nearest triangles, nearest first, of
// equally near ones the first in the file.
struct WideSearch {
  const Corners* corners = nullptr;
  Eigen::Vector3f query = Eigen::Vector3f::Zero();
  float margin = 0;
  float radius = 0;  // all nearer than this are kept
  std::size_t count = 0;
  std::array<float, SurfaceMemory::kElements> squared{};
  std::array<std::uint32_t, SurfaceMemory::kElements> primitive{};
};

bool visit_wide(RTCPointQueryFunctionArguments* arguments) {
  WideSearch& search = *static_cast<WideSearch*>(arguments->userPtr);
  const std::uint32_t primitive = arguments->primID;
  const Corners& p = search.corners[primitive];
  const float squared =
      closest_to_origin(p[0] - search.query, p[1] - search.query, p[2] - search.query)
          .point.squaredNorm();
  if (!(squared < search.radius * search.radius)) return false;
  const auto goes_before = [&](std::size_t i) {
    return squared < search.squared[i] ||
           (squared == search.squared[i] && primitive < search.primitive[i]);
  };
  constexpr std::size_t kMost = SurfaceMemory::kElements;
  const bool was_full = search.count == kMost;
  if (!was_full) ++search.count;
  std::size_t i = search.count - 1;
  if (was_full && !goes_before(i)) {
    search.radius = std::sqrt(search.squared[i]);  // equally near: not all of those are kept
  } else {
    for (; i > 0 && goes_before(i - 1); --i) {
      search.squared[i] = search.squared[i - 1];
      search.primitive[i] = search.primitive[i - 1];
    }
    search.squared[i] = squared;
    search.primitive[i] = primitive;
    search.radius = std::min(search.radius, std::sqrt(search.squared[0]) + search.margin);
    if (was_full) search.radius = std::min(search.radius, std::sqrt(search.squared[kMost - 1]));
  }
  if (!(search.radius < arguments->query->radius)) return false;
  arguments->query->radius = search.radius;
  return true;
}

// Ends the search at the first triangle that the ball touches.
struct AnySearch {
  const Corners* corners = nullptr;
  Eigen::Vector3f query = Eigen::Vector3f::Zero();
  float squared = 0;
  bool found = false;
};

bool visit_any(RTCPointQueryFunctionArguments* arguments) {
  AnySearch& search = *static_cast<AnySearch*>(arguments->userPtr);
  if (search.found) return false;
  const Corners& p = search.corners[arguments->primID];
  search.found = closest_to_origin(p[0] - search.query, p[1] - search.query, p[2] - search.query)
                     .point.squaredNorm() <= search.squared;
  if (search.found) arguments->query->radius = 0;
  return search.found;
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
    return answer_from(search);
  }

  std::optional<SurfacePoint> closest(const Eigen::Vector3f& query, float max_distance,
                                      float margin, SurfaceMemory& memory) const override {
    if (!query.allFinite() || !(max_distance >= 0)) return std::nullopt;
    Search search = among(memory, query, max_distance);
    const float moved = (query - memory.at).norm();
    const bool found = search.primitive != RTC_INVALID_GEOMETRY_ID;
    const float needed = found ? std::sqrt(search.best_squared) : max_distance;
    if (needed + moved + kMemorySlack < memory.reach_m)
      return found ? std::optional(answer_from(search)) : std::nullopt;

    // Nothing is nearer than what was found among those remembered, so it need not look further.
    WideSearch wide;
    wide.corners = corners_.data();
    wide.query = query;
    wide.margin = margin + 2 * kMemorySlack;
    wide.radius = needed + wide.margin;
    RTCPointQuery ball{query.x(), query.y(), query.z(), 0.0F, wide.radius};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene_.get(), &ball, &context, &visit_wide, &wide);
    memory.at = query;
    memory.reach_m = wide.radius;
    memory.elements.fill(SurfaceMemory::kNone);
    std::copy_n(wide.primitive.begin(), wide.count, memory.elements.begin());
    search = among(memory, query, max_distance);
    if (search.primitive == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return answer_from(search);
  }

  std::optional<SurfacePoint> closest_tangent(const Eigen::Vector3f& query,
                                              float max_distance) const override {
    return closest(query, max_distance);
  }

  bool is_within(const Eigen::Vector3f& query, float max_distance) const override {
    if (!query.allFinite() || !(max_distance >= 0)) return false;
    AnySearch search{corners_.data(), query, max_distance * max_distance};
    RTCPointQuery ball{query.x(), query.y(), query.z(), 0.0F, max_distance};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene_.get(), &ball, &context, &visit_any, &search);
    return search.found;
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
  // The nearest of the triangles that are remembered, by the same arithmetic as visit().
  [[nodiscard]] Search among(const SurfaceMemory& memory, const Eigen::Vector3f& query,
                             float max_distance) const {
    Search search;
    search.query = query;
    search.best_squared = max_distance * max_distance;
    if (memory.reach_m < 0) return search;
    for (const std::uint32_t primitive : memory.elements) {
      if (primitive == SurfaceMemory::kNone) break;
      const Corners& p = corners_[primitive];
      const TrianglePoint found = closest_to_origin(p[0] - query, p[1] - query, p[2] - query);
      const float squared = found.point.squaredNorm();
      if (!(squared <= search.best_squared)) continue;
      if (squared == search.best_squared && primitive >= search.primitive) continue;
      search.best_squared = squared;
      search.best = found;
      search.primitive = primitive;
    }
    return search;
  }

  [[nodiscard]] SurfacePoint answer_from(const Search& search) const {
    SurfacePoint answer;
    answer.element = triangle_[search.primitive];
    answer.part = part_[answer.element];
    answer.point = search.query + search.best.point;
    answer.normal = normals_[answer.element][static_cast<std::size_t>(search.best.feature)];
    // best.point leads from the query to the surface: outside it runs against the normal.
    const float length = std::sqrt(search.best_squared);
    answer.distance = answer.normal.dot(search.best.point) > 0 ? -length : length;
    return answer;
  }

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
