// Names of GL objects as move-only values: empty until created, deleted once.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/gl_handle.h"

#include <EGL/egl.h>

namespace spool::render {

bool gl_context_is_current() { return eglGetCurrentContext() != EGL_NO_CONTEXT; }

BufferHandle make_buffer() {
  GLuint id = 0;
  glGenBuffers(1, &id);
  return BufferHandle(id);
}

VertexArrayHandle make_vertex_array() {
  GLuint id = 0;
  glGenVertexArrays(1, &id);
  return VertexArrayHandle(id);
}

TextureHandle make_texture() {
  GLuint id = 0;
  glGenTextures(1, &id);
  return TextureHandle(id);
}

FramebufferHandle make_framebuffer() {
  GLuint id = 0;
  glGenFramebuffers(1, &id);
  return FramebufferHandle(id);
}

}  // namespace spool::render
