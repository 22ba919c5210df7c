// The context without a window, and the sentence where there is none.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <iostream>
#include <string>

#include <GLES3/gl3.h>

#include "render/egl_context.h"
#include "render/gl_handle.h"
#include "render/shader.h"
#include "tests/render/gl_test.h"

namespace spool::render {
namespace {

class EglContextGl : public test::GlTest {};

TEST_F(EglContextGl, OffersAtLeastGles30AndSaysWhatDraws) {
  GLint major = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  EXPECT_GE(major, 3);
  EXPECT_NE(gl_description().find("OpenGL ES 3"), std::string::npos) << gl_description();
  RecordProperty("driver", gl_description());
  std::cout << "drawn by " << gl_description() << '\n';
}

TEST_F(EglContextGl, TwoCanLiveAndTheSecondsEndLeavesTheFirstUsable) {
  // EGL has one display a process: ending one context must not end the display under the other.
  {
    const auto second = EglContext::surfaceless();
    ASSERT_TRUE(second) << second.error().message;
    EXPECT_TRUE(gl_context_is_current());
  }
  EXPECT_FALSE(gl_context_is_current());
  TearDownTestSuite();
  SetUpTestSuite();
  EXPECT_TRUE(gl_context_is_current());
}

// Ends the process: 0 where the context was refused with a good sentence.
void refuse_and_exit() {
  ::setenv("MESA_GLES_VERSION_OVERRIDE", "2.0", 1);
  const auto context = EglContext::surfaceless();
  if (context) std::_Exit(1);
  const std::string& text = context.error().message;
  const bool good = context.error().code == ErrorCode::kNoDevice &&
                    text.find("eglC") != std::string::npos &&
                    text.find("install") != std::string::npos;
  std::cerr << text << '\n';
  std::_Exit(good ? 0 : 2);
}

TEST(EglContextDeathTest, SaysWhatFailedWhereTheDriverIsTooOld) {
  ::testing::FLAGS_gtest_death_test_style =
      "threadsafe";  // a fresh process: Mesa reads the variable once
  EXPECT_EXIT(refuse_and_exit(), ::testing::ExitedWithCode(0), "no OpenGL ES 3.0 driver");
}

TEST_F(EglContextGl, HandlesMoveAndDeleteOnce) {
  BufferHandle a = make_buffer();
  const GLuint id = a.id();
  glBindBuffer(GL_ARRAY_BUFFER, id);
  BufferHandle b = std::move(a);
  EXPECT_EQ(b.id(), id);
  EXPECT_TRUE(glIsBuffer(id));
  BufferHandle c = make_buffer();
  c = std::move(b);
  EXPECT_EQ(c.id(), id);
  EXPECT_TRUE(glIsBuffer(id));
  c.reset();
  EXPECT_FALSE(c);
  EXPECT_FALSE(glIsBuffer(id));
}

TEST_F(EglContextGl, AShaderThatDoesNotCompileIsNamed) {
  const auto program = link_program({"broken.vert", "#version 300 es\nvoid main() { nonsense; }\n"},
                                    {"fine.frag", "#version 300 es\nvoid main() {}\n"});
  ASSERT_FALSE(program);
  EXPECT_EQ(program.error().code, ErrorCode::kNoDevice);
  EXPECT_NE(program.error().message.find("broken.vert"), std::string::npos)
      << program.error().message;
  EXPECT_NE(program.error().message.find("nonsense"), std::string::npos) << program.error().message;
}

TEST_F(EglContextGl, ShadersThatDoNotLinkAreNamed) {
  const auto program = link_program(
      {"one.vert",
       "#version 300 es\nout vec3 v; void main() { v = vec3(0); gl_Position = vec4(0); }\n"},
      {"two.frag",
       "#version 300 es\nprecision highp float; in vec2 v; out vec4 o; void main() { o = v.xyxy; "
       "}\n"});
  ASSERT_FALSE(program);
  EXPECT_NE(program.error().message.find("one.vert and two.frag"), std::string::npos)
      << program.error().message;
}

}  // namespace
}  // namespace spool::render
