// What GL says went wrong, as a Status.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/gl_status.h"

#include <string>

#include <GLES3/gl3.h>

namespace spool::render {
namespace {

std::string error_name(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    default:
      return "GL error " + std::to_string(error);
  }
}

}  // namespace

Status gl_status(std::string_view doing) {
  const GLenum first = glGetError();
  if (first == GL_NO_ERROR) return {};
  // A lost context reports errors without end: take only as many as there are kinds.
  for (int i = 0; i < 8 && glGetError() != GL_NO_ERROR; ++i) {
  }
  const std::string advice = first == GL_OUT_OF_MEMORY
                                 ? "; close other programs or use a smaller picture"
                                 : "; this is a fault of the program or its graphics driver";
  return Error{ErrorCode::kInternal,
               "OpenGL ES reported " + error_name(first) + " while " + std::string(doing) + advice};
}

}  // namespace spool::render
