// Names of GL objects as move-only values: empty until created, deleted once.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <utility>

#include <GLES3/gl3.h>

namespace spool::render {

// True where a GL context is current on the calling thread.
[[nodiscard]] bool gl_context_is_current();

// Owns one GL name. Empty by default, so that it can be a member before there is a context. GL
// thread only; must go before its context does.
template <auto Delete>
class GlHandle {
 public:
  GlHandle() = default;
  explicit GlHandle(GLuint id) : id_(id) {}
  GlHandle(GlHandle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  GlHandle& operator=(GlHandle&& other) noexcept {
    if (this != &other) {
      reset();
      id_ = std::exchange(other.id_, 0);
    }
    return *this;
  }
  GlHandle(const GlHandle&) = delete;
  GlHandle& operator=(const GlHandle&) = delete;
  ~GlHandle() { reset(); }

  [[nodiscard]] GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

  void reset() {
    if (id_ == 0) return;
    assert(gl_context_is_current() &&
           "a GL object is deleted on its GL thread, before its context");
    Delete(std::exchange(id_, 0));
  }

 private:
  GLuint id_ = 0;
};

namespace detail {
inline void delete_buffer(GLuint id) { glDeleteBuffers(1, &id); }
inline void delete_vertex_array(GLuint id) { glDeleteVertexArrays(1, &id); }
inline void delete_texture(GLuint id) { glDeleteTextures(1, &id); }
inline void delete_framebuffer(GLuint id) { glDeleteFramebuffers(1, &id); }
inline void delete_shader(GLuint id) { glDeleteShader(id); }
inline void delete_program(GLuint id) { glDeleteProgram(id); }
}  // namespace detail

using BufferHandle = GlHandle<&detail::delete_buffer>;
using VertexArrayHandle = GlHandle<&detail::delete_vertex_array>;
using TextureHandle = GlHandle<&detail::delete_texture>;
using FramebufferHandle = GlHandle<&detail::delete_framebuffer>;
using ShaderHandle = GlHandle<&detail::delete_shader>;
using ProgramHandle = GlHandle<&detail::delete_program>;

[[nodiscard]] BufferHandle make_buffer();
[[nodiscard]] VertexArrayHandle make_vertex_array();
[[nodiscard]] TextureHandle make_texture();
[[nodiscard]] FramebufferHandle make_framebuffer();

}  // namespace spool::render
