// Fuzzes the cloud readers: the first byte chooses the format, the rest is the file.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "vision/scan/cloud_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr const char* kNames[] = {"cloud.ply", "cloud.pcd", "cloud.xyz", "cloud.obj"};
  const std::string_view bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  const auto file = spool::read_cloud_bytes(bytes, kNames[data[0] % 4], std::nullopt);
  // Read or refused, what is said holds.
  if (file && (!file->cloud.is_consistent() || file->finite == 0)) std::abort();
  if (!file && file.error().message.empty()) std::abort();
  return 0;
}
