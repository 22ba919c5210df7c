// Pictures compared with those kept in tests/goldens.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "render/image.h"
#include "render/image_compare.h"

namespace spool::test {

// What became of one comparison; a sentence for the console where it failed.
struct GoldenResult {
  bool passed = false;
  std::string text;
};

// Compares with FOLDER/NAME.png under the limits that FOLDER/goldens.json gives NAME. On failure
// NAME-actual, -expected and -difference.png are written to `report`. With `update` the picture is
// written instead.
[[nodiscard]] GoldenResult check_golden(const std::filesystem::path& folder,
                                        const std::filesystem::path& report,
                                        const std::string& name, const render::Image& actual,
                                        bool update);

// The same for tests/goldens and the build folder's goldens/; a failure of the running test where
// it fails. SPOOL_UPDATE_GOLDENS=1 in the environment updates.
void expect_golden(const std::string& name, const render::Image& actual);

}  // namespace spool::test
