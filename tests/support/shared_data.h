// Where tests find files: the repository's own, the built programs, and third-party data beside
// the checkout.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

namespace spool::test {

[[nodiscard]] std::filesystem::path source_dir();
[[nodiscard]] std::filesystem::path program(const char* name);  // build/<preset>/bin/name

// The folder of third-party data: $SPOOL_SHARED_DATA, else ../shared/data beside the checkout;
// nothing where there is none. Use SPOOL_REQUIRE_SHARED to skip.
[[nodiscard]] std::optional<std::filesystem::path> shared_data();

}  // namespace spool::test

// Skips the test with its reason where the third-party file or folder is absent; else defines
// `variable`.
#define SPOOL_REQUIRE_SHARED(variable, relative)                                   \
  const auto variable##_root = spool::test::shared_data();                         \
  if (!variable##_root || !std::filesystem::exists(*variable##_root / (relative))) \
    GTEST_SKIP() << "third-party data is absent: " << (relative);                  \
  const std::filesystem::path variable = *variable##_root / (relative)
