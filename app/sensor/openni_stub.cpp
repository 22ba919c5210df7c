// What answers for OpenNI2 in a build without it: a sentence.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <system_error>

#include "app/sensor/openni.h"
#include "app/sensor/source_kinds.h"

namespace spool::sensor {
namespace {

Error without_openni(const std::string& what) {
  return Error{
      ErrorCode::kNoDevice,
      what + ": this build has no OpenNI2; use a depth folder, or build with SPOOL_OPENNI on"};
}

}  // namespace

OpenedSource open_openni_device(const std::string& uri) {
  return without_openni(uri.empty() ? "openni" : "openni:" + uri);
}

OpenedSource open_simulated(const std::string& scene) {
  return without_openni(scene.empty() ? "simulated" : "simulated:" + scene);
}

OpenedSource open_oni_file(const std::string& path, const SourceOptions&) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
    return Error{ErrorCode::kBadInput, path + ": is no file that can be read; check the path"};
  return without_openni(path);
}

OpenedSource open_oni_unchecked(const std::string& path, const SourceOptions&) {
  return without_openni(path);
}

Result<std::unique_ptr<OniWriter>> create_oni(const std::string& path, const Camera&) {
  return without_openni(path);
}

}  // namespace spool::sensor
