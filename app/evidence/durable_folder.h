// Files and folders that are on the disk once a function returns.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "vision/core/result.h"

namespace spool::evidence {

// Copies a file of any length and syncs the copy. kBadInput: `from` cannot be read; kIo: `to`
// cannot be written.
[[nodiscard]] Status copy_durably(const std::filesystem::path& from,
                                  const std::filesystem::path& to);
// Sets the modification time (s since 1970, UTC) and syncs it. kIo.
[[nodiscard]] Status date_file(const std::filesystem::path& path, double seconds);
// Syncs what a folder lists, not what is below. kIo.
[[nodiscard]] Status sync_folder(const std::filesystem::path& folder);
// The same of a folder and every one below it.
[[nodiscard]] Status sync_folders(const std::filesystem::path& folder);

}  // namespace spool::evidence
