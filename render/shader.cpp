// A linked pair of embedded shaders and its uniforms.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/shader.h"

#include <cassert>
#include <string>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include "render/embedded_files.h"

namespace spool::render {
namespace {

std::string first_line(std::string text) {
  text.resize(std::min(text.find('\n'), text.size()));
  return text;
}

Result<ShaderHandle> compile(GLenum kind, const ShaderSource& source) {
  ShaderHandle shader(glCreateShader(kind));
  const auto* text = source.text.data();
  const auto length = static_cast<GLint>(source.text.size());
  glShaderSource(shader.id(), 1, &text, &length);
  glCompileShader(shader.id());
  GLint good = GL_FALSE;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &good);
  if (good == GL_TRUE) return shader;
  std::string log(1024, '\0');
  GLsizei written = 0;
  glGetShaderInfoLog(shader.id(), static_cast<GLsizei>(log.size()), &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  return Error{ErrorCode::kNoDevice, "the graphics driver refuses shader " +
                                         std::string(source.name) + ": " + first_line(log) +
                                         "; update the driver"};
}

}  // namespace

Result<ProgramHandle> link_program(const ShaderSource& vertex, const ShaderSource& fragment) {
  auto vertex_shader = compile(GL_VERTEX_SHADER, vertex);
  if (!vertex_shader) return vertex_shader.error();
  auto fragment_shader = compile(GL_FRAGMENT_SHADER, fragment);
  if (!fragment_shader) return fragment_shader.error();
  ProgramHandle program(glCreateProgram());
  glAttachShader(program.id(), vertex_shader->id());
  glAttachShader(program.id(), fragment_shader->id());
  glLinkProgram(program.id());
  GLint good = GL_FALSE;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &good);
  if (good == GL_TRUE) return program;
  std::string log(1024, '\0');
  GLsizei written = 0;
  glGetProgramInfoLog(program.id(), static_cast<GLsizei>(log.size()), &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  return Error{ErrorCode::kNoDevice,
               "the graphics driver cannot link shaders " + std::string(vertex.name) + " and " +
                   std::string(fragment.name) + ": " + first_line(log) + "; update the driver"};
}

Result<ShaderProgram> ShaderProgram::create(std::string_view vertex_stem,
                                            std::string_view fragment_stem) {
  std::string vertex_name(vertex_stem);
  vertex_name += ".vert";
  std::string fragment_name(fragment_stem);
  fragment_name += ".frag";
  const auto vertex = embedded_file(vertex_name);
  const auto fragment = embedded_file(fragment_name);
  assert(vertex && fragment && "the shader is listed in render/CMakeLists.txt");
  auto program = link_program({vertex_name, *vertex}, {fragment_name, *fragment});
  if (!program) return program.error();
  ShaderProgram result;
  result.program_ = std::move(*program);
  return result;
}

void ShaderProgram::use() const { glUseProgram(program_.id()); }

GLint ShaderProgram::location(const char* uniform) const {
  const GLint found = glGetUniformLocation(program_.id(), uniform);
  assert(found >= 0 && "the shader has and uses this uniform");
  return found;
}

void ShaderProgram::set(const char* uniform, int value) const {
  glUniform1i(location(uniform), value);
}
void ShaderProgram::set(const char* uniform, float value) const {
  glUniform1f(location(uniform), value);
}
void ShaderProgram::set(const char* uniform, const Eigen::Vector2f& value) const {
  glUniform2fv(location(uniform), 1, value.data());
}
void ShaderProgram::set(const char* uniform, const Eigen::Vector3f& value) const {
  glUniform3fv(location(uniform), 1, value.data());
}
void ShaderProgram::set(const char* uniform, const Eigen::Vector4f& value) const {
  glUniform4fv(location(uniform), 1, value.data());
}
void ShaderProgram::set(const char* uniform, const glm::mat4& value) const {
  glUniformMatrix4fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void ShaderProgram::set(const char* uniform, std::span<const Eigen::Vector3f> values) const {
  glUniform3fv(location(uniform), static_cast<GLsizei>(values.size()), values.front().data());
}

}  // namespace spool::render
