// Files packed into one ZIP in memory.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/core/result.h"

namespace spool::ncr {

struct ZipEntry {
  std::string path;  // with '/' between folders
  std::string bytes;
};

// The bytes of the ZIP. No clock is read (every entry is of 1980-01-01): equal files, equal bytes.
// kInternal where libzip fails.
[[nodiscard]] Result<std::string> zip_bytes(const std::vector<ZipEntry>& entries);

}  // namespace spool::ncr
