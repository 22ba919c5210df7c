// Reads hand-written glTF bytes as designs, good or refused.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/vision/design/gltf_text.h"
#include "vision/design/design_reader.h"

namespace spool::test {

class GltfReader : public testing::Test {
 protected:
  Result<DesignModel> read(const std::string& bytes, const std::string& name = "design.glb",
                           std::optional<LengthUnit> unit = std::nullopt) {
    return read_design(write(folder_.path(), name, bytes), unit);
  }
  DesignModel good(const std::string& bytes, const std::string& name = "design.glb",
                   std::optional<LengthUnit> unit = std::nullopt) {
    Result<DesignModel> design = read(bytes, name, unit);
    EXPECT_TRUE(design.has_value()) << (design ? "" : design.error().message);
    return design ? std::move(*design) : DesignModel{};
  }
  void refused(const std::string& bytes, const std::string& why,
               const std::string& name = "design.glb") {
    const Result<DesignModel> design = read(bytes, name);
    ASSERT_FALSE(design.has_value()) << why;
    EXPECT_EQ(design.error().code, ErrorCode::kBadInput);
    EXPECT_NE(design.error().message.find(name), std::string::npos) << design.error().message;
    EXPECT_NE(design.error().message.find(why), std::string::npos) << design.error().message;
    EXPECT_EQ(design.error().message.find('\n'), std::string::npos);
  }
  TemporaryFolder folder_;
};

}  // namespace spool::test
