// A linked pair of embedded shaders and its uniforms.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <utility>

#include <Eigen/Core>
#include <glm/mat4x4.hpp>

#include "render/gl_handle.h"
#include "vision/core/result.h"

namespace spool::render {

// GL thread only. The setters need the program in use().
class ShaderProgram {
 public:
  ShaderProgram() = default;
  explicit ShaderProgram(ProgramHandle program) : program_(std::move(program)) {}
  // Compiles the embedded "NAME.vert" and "NAME.frag", or two of different names; kNoDevice with
  // the file's name and the driver's own words where it refuses them.
  [[nodiscard]] static Result<ShaderProgram> create(std::string_view name) {
    return create(name, name);
  }
  [[nodiscard]] static Result<ShaderProgram> create(std::string_view vertex,
                                                    std::string_view fragment);

  void use() const;
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const Eigen::Vector2f& value) const;
  void set(const char* uniform, const Eigen::Vector3f& value) const;
  void set(const char* uniform, const Eigen::Vector4f& value) const;
  void set(const char* uniform, const glm::mat4& value) const;
  void set(const char* uniform, std::span<const Eigen::Vector3f> values) const;

 private:
  [[nodiscard]] GLint location(const char* uniform) const;
  ProgramHandle program_;
};

// Compiles and links two sources; the names are for the error's sentence.
struct ShaderSource {
  std::string_view name;
  std::string_view text;
};
[[nodiscard]] Result<ProgramHandle> link_program(const ShaderSource& vertex,
                                                 const ShaderSource& fragment);

}  // namespace spool::render
