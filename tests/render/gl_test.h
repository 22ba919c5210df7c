// The fixture of tests that need a GL context: one a suite, skipped with the reason where there
// is none.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <gtest/gtest.h>

#include "render/egl_context.h"

namespace spool::test {

// SPOOL_REQUIRE_GL=1 turns the skip into a failure: a build machine must not pass by drawing
// nothing. After each test no GL error may be pending.
class GlTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite();
  static void TearDownTestSuite();
  void SetUp() override;
  void TearDown() override;

 private:
  static std::optional<render::EglContext> context_;
  static std::string why_not_;
};

}  // namespace spool::test
