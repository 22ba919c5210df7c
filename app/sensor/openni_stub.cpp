// What answers for OpenNI2 in a build without it: a sentence.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
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

OpenedSource open_oni_unchecked(const std::string& path, const SourceOptions&) {
  return without_openni(path);
}

Result<std::unique_ptr<OniWriter>> create_oni(const std::string& path, const Camera&) {
  return without_openni(path);
}

}  // namespace spool::sensor
