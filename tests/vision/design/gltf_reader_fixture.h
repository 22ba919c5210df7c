// Reads hand-written glTF bytes as designs, good or refused.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "tests/vision/design/gltf_text.h"
#include "vision/design/design_reader.h"

namespace spool::test {

class GltfReader : public testing::Test {
 protected:
  Result<DesignModel> read(const std::string& bytes, const std::string& name = "design.glb",
                           std::optional<LengthUnit> unit = std::nullopt) {
    return read_design(write_file(folder_.path() / name, bytes), unit);
  }
  DesignModel good(const std::string& bytes, const std::string& name = "design.glb",
                   std::optional<LengthUnit> unit = std::nullopt) {
    Result<DesignModel> design = read(bytes, name, unit);
    EXPECT_TRUE(design.has_value()) << (design ? "" : design.error().message);
    return design ? std::move(*design) : DesignModel{};
  }
  void refused(const std::string& bytes, const std::string& why,
               const std::string& name = "design.glb") {
    expect_refused(read(bytes, name), ErrorCode::kBadInput, name, why);
  }
  TemporaryFolder folder_;
};

}  // namespace spool::test
