// A depth stream as OpenNI2's driver interface wants it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/driver_stream.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace spool::simulator {
namespace {

// Writes a property's value where there is room for it.
template <class T>
OniStatus give(const T& value, void* data, int* size) {
  if (data == nullptr || size == nullptr || *size < static_cast<int>(sizeof(T)))
    return ONI_STATUS_BAD_PARAMETER;
  std::memcpy(data, &value, sizeof(T));
  *size = static_cast<int>(sizeof(T));
  return ONI_STATUS_OK;
}

template <class T>
bool take(const void* data, int size, T& value) {
  if (data == nullptr || size != static_cast<int>(sizeof(T))) return false;
  std::memcpy(&value, data, sizeof(T));
  return true;
}

}  // namespace

DepthStream::DepthStream(const Camera& camera, int frames_per_second, bool mirrored)
    : mode_{camera.depth_unit_m > 5e-4 ? ONI_PIXEL_FORMAT_DEPTH_1_MM
                                       : ONI_PIXEL_FORMAT_DEPTH_100_UM,
            camera.width, camera.height, frames_per_second},
      horizontal_fov_rad_(static_cast<float>(2 * std::atan(camera.width / (2 * camera.fx)))),
      vertical_fov_rad_(static_cast<float>(2 * std::atan(camera.height / (2 * camera.fy)))),
      mirrored_(mirrored) {
  cropping_.width = camera.width;
  cropping_.height = camera.height;
}

OniStatus DepthStream::getProperty(int property, void* data, int* size) {
  const std::scoped_lock lock(mutex_);
  switch (property) {
    case ONI_STREAM_PROPERTY_VIDEO_MODE:
      return give(mode_, data, size);
    case ONI_STREAM_PROPERTY_HORIZONTAL_FOV:
      return give(horizontal_fov_rad_, data, size);
    case ONI_STREAM_PROPERTY_VERTICAL_FOV:
      return give(vertical_fov_rad_, data, size);
    case ONI_STREAM_PROPERTY_MAX_VALUE:
      return give(65535, data, size);  // beyond any count sent: the recorder garbles this one
    case ONI_STREAM_PROPERTY_MIN_VALUE:
      return give(0, data, size);
    case ONI_STREAM_PROPERTY_STRIDE:
      return give(mode_.resolutionX * static_cast<int>(sizeof(OniDepthPixel)), data, size);
    case ONI_STREAM_PROPERTY_MIRRORING:
      return give(static_cast<OniBool>(mirrored_ ? TRUE : FALSE), data, size);
    case ONI_STREAM_PROPERTY_CROPPING:  // without an answer a recording plays back empty
      return give(cropping_, data, size);
    default:
      return ONI_STATUS_NOT_IMPLEMENTED;
  }
}

OniStatus DepthStream::setProperty(int property, const void* data, int size) {
  const std::scoped_lock lock(mutex_);
  if (property == ONI_STREAM_PROPERTY_MIRRORING) {
    OniBool mirrored = FALSE;
    if (!take(data, size, mirrored)) return ONI_STATUS_BAD_PARAMETER;
    mirrored_ = mirrored != FALSE;
    return ONI_STATUS_OK;
  }
  if (property == ONI_STREAM_PROPERTY_VIDEO_MODE) {
    OniVideoMode mode{};
    if (!take(data, size, mode)) return ONI_STATUS_BAD_PARAMETER;
    const bool same = mode.pixelFormat == mode_.pixelFormat &&
                      mode.resolutionX == mode_.resolutionX &&
                      mode.resolutionY == mode_.resolutionY && mode.fps == mode_.fps;
    return same ? ONI_STATUS_OK : ONI_STATUS_NOT_SUPPORTED;
  }
  if (property == ONI_STREAM_PROPERTY_CROPPING) {
    OniCropping cropping{};
    if (!take(data, size, cropping)) return ONI_STATUS_BAD_PARAMETER;
    return cropping.enabled == FALSE ? ONI_STATUS_OK : ONI_STATUS_NOT_SUPPORTED;
  }
  return ONI_STATUS_NOT_IMPLEMENTED;
}

OniBool DepthStream::isPropertySupported(int property) {
  switch (property) {
    case ONI_STREAM_PROPERTY_VIDEO_MODE:
    case ONI_STREAM_PROPERTY_HORIZONTAL_FOV:
    case ONI_STREAM_PROPERTY_VERTICAL_FOV:
    case ONI_STREAM_PROPERTY_MAX_VALUE:
    case ONI_STREAM_PROPERTY_MIN_VALUE:
    case ONI_STREAM_PROPERTY_STRIDE:
    case ONI_STREAM_PROPERTY_MIRRORING:
    case ONI_STREAM_PROPERTY_CROPPING:
      return TRUE;
    default:
      return FALSE;
  }
}

void DepthStream::raise(std::span<const std::uint16_t> depth, std::uint64_t microseconds,
                        int index) {
  OniFrame* frame = getServices().acquireFrame();
  if (frame == nullptr) return;
  const auto width = static_cast<std::size_t>(mode_.resolutionX);
  const std::size_t bytes = depth.size_bytes();
  if (frame->data == nullptr || static_cast<std::size_t>(frame->dataSize) < bytes) {
    getServices().releaseFrame(frame);
    return;
  }
  auto* to = static_cast<std::uint16_t*>(frame->data);
  std::copy(depth.begin(), depth.end(), to);
  {
    const std::scoped_lock lock(mutex_);
    for (std::size_t v = 0; mirrored_ && v < static_cast<std::size_t>(mode_.resolutionY); ++v)
      std::reverse(to + v * width, to + (v + 1) * width);
  }
  frame->dataSize = static_cast<int>(bytes);
  frame->sensorType = ONI_SENSOR_DEPTH;
  frame->timestamp = microseconds;
  frame->frameIndex = index;
  frame->width = mode_.resolutionX;
  frame->height = mode_.resolutionY;
  frame->videoMode = mode_;
  frame->croppingEnabled = FALSE;
  frame->cropOriginX = 0;
  frame->cropOriginY = 0;
  frame->stride = static_cast<int>(width * sizeof(OniDepthPixel));
  raiseNewFrame(frame);
  getServices().releaseFrame(frame);
}

}  // namespace spool::simulator
