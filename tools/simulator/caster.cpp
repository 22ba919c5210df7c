// What an ideal camera sees, by Embree's ray packets.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/caster.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <embree3/rtcore.h>

#include "vision/core/parallel.h"

namespace spool::simulator {
namespace {

constexpr int kPacket = 16;

struct DeviceRelease {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneRelease {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

// Copies `from` into a buffer that Embree owns.
template <class T>
bool fill_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                 const std::vector<T>& from) {
  void* to = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), from.size());
  if (to == nullptr) return false;
  std::copy(from.begin(), from.end(), static_cast<T*>(to));
  return true;
}

}  // namespace

struct Caster::Impl {
  std::unique_ptr<RTCDeviceTy, DeviceRelease> device;
  std::unique_ptr<RTCSceneTy, SceneRelease> scene;
  const World* world = nullptr;

  void cast_row(const Camera& camera, const Pose& T_map_camera, float far_m, int v,
                IdealImage& image) const;
};

Caster::Caster(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Caster::Caster(Caster&&) noexcept = default;
Caster& Caster::operator=(Caster&&) noexcept = default;
Caster::~Caster() = default;

Result<Caster> Caster::create(const World& world) {
  auto impl = std::make_unique<Impl>();
  impl->world = &world;
#ifdef SPOOL_SERIAL
  impl->device.reset(rtcNewDevice("threads=1"));
#else
  impl->device.reset(rtcNewDevice(nullptr));
#endif
  if (!impl->device) return Error{ErrorCode::kInternal, "Embree does not start"};
  impl->scene.reset(rtcNewScene(impl->device.get()));
  rtcSetSceneFlags(impl->scene.get(), RTC_SCENE_FLAG_ROBUST);  // no gaps along edges
  RTCGeometry geometry = rtcNewGeometry(impl->device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  const bool filled =
      fill_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, world.mesh.vertices) &&
      fill_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, world.mesh.triangles);
  if (filled) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(impl->scene.get(), geometry);
  }
  rtcReleaseGeometry(geometry);
  rtcCommitScene(impl->scene.get());
  if (!filled || rtcGetDeviceError(impl->device.get()) != RTC_ERROR_NONE)
    return Error{ErrorCode::kInternal, "Embree cannot build over the scene; make it smaller"};
  return Caster(std::move(impl));
}

void Caster::Impl::cast_row(const Camera& camera, const Pose& T_map_camera, float far_m, int v,
                            IdealImage& image) const {
  // Directions have length 1 along the optical axis, so that Embree's distance is the depth.
  const Eigen::Matrix3f rotation = T_map_camera.linear().cast<float>();
  const Eigen::Vector3f origin = T_map_camera.translation().cast<float>();
  alignas(64) std::array<int, kPacket> valid{};
  alignas(64) RTCRayHit16 packet{};
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (int first = 0; first < camera.width; first += kPacket) {
    for (int i = 0; i < kPacket; ++i) {
      const auto lane = static_cast<std::size_t>(i);
      const Eigen::Vector3f direction =
          rotation * camera.back_project(first + i, v, 1.0).cast<float>();
      valid[lane] = first + i < camera.width ? -1 : 0;
      packet.ray.org_x[lane] = origin.x();
      packet.ray.org_y[lane] = origin.y();
      packet.ray.org_z[lane] = origin.z();
      packet.ray.dir_x[lane] = direction.x();
      packet.ray.dir_y[lane] = direction.y();
      packet.ray.dir_z[lane] = direction.z();
      packet.ray.tnear[lane] = 0.01F;
      packet.ray.tfar[lane] = far_m;
      packet.ray.mask[lane] = 0xFFFFFFFFU;
      packet.ray.flags[lane] = 0;
      packet.ray.time[lane] = 0;
      packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
      packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect16(valid.data(), scene.get(), &context, &packet);
    for (int i = 0; i < kPacket && first + i < camera.width; ++i) {
      const auto lane = static_cast<std::size_t>(i);
      const auto pixel = static_cast<std::size_t>(v) * static_cast<std::size_t>(camera.width) +
                         static_cast<std::size_t>(first + i);
      const bool hit = packet.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;
      const std::uint32_t triangle = packet.hit.primID[lane];
      image.depth[pixel] = hit ? packet.ray.tfar[lane] : 0.0F;
      image.part[pixel] = hit ? world->triangle_part[triangle] : -1;
      image.bright[pixel] = hit ? world->bright[triangle] : std::uint8_t{0};
      const Eigen::Vector3f normal(packet.hit.Ng_x[lane], packet.hit.Ng_y[lane],
                                   packet.hit.Ng_z[lane]);
      const Eigen::Vector3f ray(packet.ray.dir_x[lane], packet.ray.dir_y[lane],
                                packet.ray.dir_z[lane]);
      const float cosine = std::abs(normal.dot(ray)) /
                           std::max(std::sqrt(normal.squaredNorm() * ray.squaredNorm()), 1e-30F);
      image.incidence[pixel] = hit ? std::acos(std::min(cosine, 1.0F)) : 0.0F;
    }
  }
}

void Caster::cast(const Camera& camera, const Pose& T_map_camera, double far_m,
                  IdealImage& image) const {
  const auto pixels =
      static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
  image.width = camera.width;
  image.height = camera.height;
  image.depth.resize(pixels);
  image.incidence.resize(pixels);
  image.part.resize(pixels);
  image.bright.resize(pixels);
  parallel_chunks(static_cast<std::size_t>(camera.height), 16,
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t v = begin; v < end; ++v)
                      impl_->cast_row(camera, T_map_camera, static_cast<float>(far_m),
                                      static_cast<int>(v), image);
                  });
}

}  // namespace spool::simulator
