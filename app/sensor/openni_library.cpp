// What the OpenNI2 files share.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/sensor/openni_library.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <dlfcn.h>
#include <link.h>

#ifdef __SANITIZE_THREAD__
// In the program and not in a file of the tests: a test that only lists its names reports as well.
// What is left out happens inside the libraries: they unlock mutexes that they do not hold when
// they end; and they lock a recorder and its stream in both orders, which is why OniWriter stays on
// one thread.
extern "C" const char* __tsan_default_suppressions();
extern "C" const char* __tsan_default_suppressions() {
  return "mutex:libOpenNI2.so\n"
         "mutex:libOniFile.so\n"
         "deadlock:libOpenNI2.so\n"
         "deadlock:libOniFile.so\n";
}
#endif

namespace spool::sensor {
namespace {

// Who keeps OpenNI2 alive, and the lock for its start and end.
struct Leases {
  std::mutex mutex;
  std::set<std::string> uris;
};

Leases& leases() {
  static Leases all;
  return all;
}

// Keeps the drivers that OpenNI2 has loaded in memory when it lets go of them: they cancel threads
// of theirs that do not end in time, and those may still run in the driver's code then.
void keep_drivers_loaded() {
  std::vector<std::string> drivers;
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* to) {
        if (std::strstr(info->dlpi_name, "/OpenNI2/Drivers/") != nullptr)
          static_cast<std::vector<std::string>*>(to)->emplace_back(info->dlpi_name);
        return 0;
      },
      &drivers);
  for (const std::string& driver : drivers)
    if (void* library = dlopen(driver.c_str(), RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE))
      dlclose(library);
}

}  // namespace

std::string library_says() {
  std::string text = openni::OpenNI::getExtendedError();
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  text.erase(0, text.find_first_not_of(" "));
  return text.empty() ? std::string() : " (" + text + ")";
}

Result<std::unique_ptr<Lease>> Lease::take(const std::string& uri) {
  Leases& all = leases();
  const std::scoped_lock lock(all.mutex);
  if (all.uris.count(uri) != 0)
    return Error{ErrorCode::kNoDevice, uri + ": is open already; close it before opening it again"};
  if (all.uris.empty() && openni::OpenNI::initialize() != openni::STATUS_OK) {
    const std::string why = library_says();
    openni::OpenNI::shutdown();
    return Error{ErrorCode::kNoDevice, uri + ": OpenNI2 does not start" + why +
                                           "; look into the folder openni2 beside the programs"};
  }
  if (all.uris.empty()) keep_drivers_loaded();
  openni::OpenNI::setLogConsoleOutput(false);
  openni::OpenNI::setLogFileOutput(false);
  all.uris.insert(uri);
  return std::unique_ptr<Lease>(new Lease(uri));
}

Lease::~Lease() {
  Leases& all = leases();
  const std::scoped_lock lock(all.mutex);
  all.uris.erase(uri_);
  if (all.uris.empty()) openni::OpenNI::shutdown();
}

std::optional<double> count_metres(openni::PixelFormat format) {
  if (format == openni::PIXEL_FORMAT_DEPTH_1_MM) return 1e-3;
  if (format == openni::PIXEL_FORMAT_DEPTH_100_UM) return 1e-4;
  return std::nullopt;
}

std::optional<openni::VideoMode> best_mode(const openni::SensorInfo& info) {
  const auto& modes = info.getSupportedVideoModes();
  const auto cost = [](const openni::VideoMode& mode) {
    return 10 * std::abs(mode.getResolutionX() - 640) + 10 * std::abs(mode.getResolutionY() - 480) +
           2 * std::abs(mode.getFps() - 30) +
           (mode.getPixelFormat() == openni::PIXEL_FORMAT_DEPTH_1_MM ? 0 : 1);
  };
  std::optional<openni::VideoMode> best;
  for (int i = 0; i < modes.getSize(); ++i)
    if (count_metres(modes[i].getPixelFormat()) && (!best || cost(modes[i]) < cost(*best)))
      best = modes[i];
  return best;
}

// OpenNI2 puts the principal point at (w/2, h/2) and the focal length into the fields of view:
// X = (x/w - 1/2) 2 tan(hfov/2) Z with x the integer pixel. With pixel centres at integers that is
// cx = w/2 and fx = w / (2 tan(hfov/2)); its Y points up, ours down. In a mirrored image pixel x
// shows what the plain one shows at w-1-x, so there cx becomes w/2 - 1.
std::optional<Camera> camera_of(const openni::VideoStream& stream, bool mirrored) {
  const openni::VideoMode mode = stream.getVideoMode();
  const double hfov = stream.getHorizontalFieldOfView();
  const double vfov = stream.getVerticalFieldOfView();
  const auto unit = count_metres(mode.getPixelFormat());
  const auto is_angle = [](double x) { return x > 0.01 && x < std::numbers::pi - 0.01; };
  if (!unit || !is_angle(hfov) || !is_angle(vfov)) return std::nullopt;
  Camera camera;
  camera.width = mode.getResolutionX();
  camera.height = mode.getResolutionY();
  camera.fx = camera.width / (2 * std::tan(hfov / 2));
  camera.fy = camera.height / (2 * std::tan(vfov / 2));
  camera.cx = camera.width / 2.0 - (mirrored ? 1 : 0);
  camera.cy = camera.height / 2.0;
  camera.depth_unit_m = *unit;
  if (!camera.is_valid()) return std::nullopt;
  return camera;
}

bool copy_depth(const openni::VideoFrameRef& from, bool mirrored, DepthFrame& to) {
  const int width = from.getWidth(), height = from.getHeight(), stride = from.getStrideInBytes();
  const bool cropped = from.getCroppingEnabled();
  const int left = cropped ? from.getCropOriginX() : 0, top = cropped ? from.getCropOriginY() : 0;
  const std::size_t row = static_cast<std::size_t>(std::max(width, 0)) * sizeof(std::uint16_t);
  if (width <= 0 || height <= 0 || left < 0 || top < 0 || left > to.width - width ||
      top > to.height - height || stride < 0 || static_cast<std::size_t>(stride) < row ||
      from.getDataSize() < 0 ||
      static_cast<std::size_t>(from.getDataSize()) <
          static_cast<std::size_t>(stride) * static_cast<std::size_t>(height - 1) + row ||
      (!cropped && (width != to.width || height != to.height)))
    return false;
  to.depth.assign(static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height), 0);
  const char* data = static_cast<const char*>(from.getData());
  for (int v = 0; v < height; ++v) {
    std::uint16_t* line = to.depth.data() + static_cast<std::ptrdiff_t>(top + v) * to.width;
    std::memcpy(line + left, data + static_cast<std::ptrdiff_t>(v) * stride, row);
    if (mirrored) std::reverse(line, line + to.width);
  }
  return true;
}

}  // namespace spool::sensor
