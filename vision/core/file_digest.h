// SHA-256 of bytes, as reports and manifests name their inputs.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "vision/core/result.h"

namespace spool {

// 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256_hex(std::string_view bytes);

// The same of a file of any length, never whole in memory. kBadInput: missing; kIo: reading failed.
[[nodiscard]] Result<std::string> sha256_file(const std::filesystem::path& path);

}  // namespace spool
