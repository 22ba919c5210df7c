// Files read whole and written whole or not at all.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "vision/core/result.h"

namespace spool {

// All bytes of a regular file. kBadInput: missing, a directory, or longer than `limit_bytes`; kIo:
// the read itself failed.
[[nodiscard]] Result<std::string> read_file(const std::filesystem::path& path,
                                            std::uint64_t limit_bytes = std::uint64_t{4} << 30);

// Writes `bytes` to a temporary file beside `path`, syncs it and renames it over `path`: readers
// see the old file or the new one, never half of it. kIo names the file and why (disk full, no
// permission).
[[nodiscard]] Status write_file_whole(const std::filesystem::path& path, std::string_view bytes);

// Makes a folder and those above it. kIo names it and why.
[[nodiscard]] Status make_folder(const std::filesystem::path& path);

}  // namespace spool
