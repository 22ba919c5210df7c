// The fixture of tests that need a GL context: one a suite, skipped with the reason where there
// is none.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/render/gl_test.h"

#include <cstdlib>
#include <string_view>

#include "render/gl_status.h"

namespace spool::test {

std::optional<render::EglContext> GlTest::context_;
std::string GlTest::why_not_;

void GlTest::SetUpTestSuite() {
  auto context = render::EglContext::surfaceless();
  if (context) {
    context_.emplace(std::move(*context));
  } else {
    why_not_ = context.error().message;
  }
}

void GlTest::TearDownTestSuite() { context_.reset(); }

void GlTest::SetUp() {
  if (context_) return;
  const char* required = std::getenv("SPOOL_REQUIRE_GL");
  if (required != nullptr && std::string_view(required) == "1") FAIL() << why_not_;
  GTEST_SKIP() << why_not_;
}

void GlTest::TearDown() {
  if (!context_) return;
  const Status status = render::gl_status("running the test");
  EXPECT_TRUE(status) << status.error().message;
}

}  // namespace spool::test
