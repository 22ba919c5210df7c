// Where tests find files.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/shared_data.h"

#include <cstdlib>

namespace spool::test {

std::filesystem::path source_dir() { return SPOOL_SOURCE_DIR; }

std::filesystem::path program(const char* name) {
  return std::filesystem::path(SPOOL_BINARY_DIR) / "bin" / name;
}

std::optional<std::filesystem::path> shared_data() {
  if (const char* set = std::getenv("SPOOL_SHARED_DATA")) return std::filesystem::path(set);
  const std::filesystem::path beside = source_dir().parent_path() / "shared" / "data";
  if (std::filesystem::is_directory(beside)) return beside;
  return std::nullopt;
}

}  // namespace spool::test
