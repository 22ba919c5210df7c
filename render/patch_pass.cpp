// Pass: marks on the design of how well each patch of it is known.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/patch_pass.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "render/gl_state.h"

namespace spool::render {
namespace {

// sRGB. No status's colours but where they mean the same: a patch that is known may be out.
const Eigen::Vector3f kKnown{0.92F, 0.96F, 0.98F};
const Eigen::Vector3f kPartly{0.941F, 0.706F, 0.161F};   // can't tell
const Eigen::Vector3f kNotSeen{0.655F, 0.678F, 0.710F};  // not seen

struct MarkInstance {
  Eigen::Vector3f position;  // m, design frame
  Eigen::Vector3f normal;
  float radius_m = 0;
  float sight = 0;
};

}  // namespace

Result<PatchPass> PatchPass::create() {
  auto program = ShaderProgram::create("patch");
  if (!program) return program.error();
  PatchPass pass;
  pass.program_ = std::move(*program);
  pass.instances_ = make_buffer();
  pass.attributes_ = make_vertex_array();
  glBindVertexArray(pass.attributes_.id());
  glBindBuffer(GL_ARRAY_BUFFER, pass.instances_.id());
  const auto attribute = [](GLuint at, GLint size, std::size_t offset) {
    glEnableVertexAttribArray(at);
    glVertexAttribPointer(at, size, GL_FLOAT, GL_FALSE, sizeof(MarkInstance),
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(at, 1);
  };
  attribute(0, 3, offsetof(MarkInstance, position));
  attribute(1, 3, offsetof(MarkInstance, normal));
  attribute(2, 1, offsetof(MarkInstance, radius_m));
  attribute(3, 1, offsetof(MarkInstance, sight));
  return pass;
}

void PatchPass::set_patches(std::span<const PatchMark> patches) {
  std::vector<MarkInstance> marks;
  marks.reserve(patches.size());
  for (const PatchMark& patch : patches)
    marks.push_back({patch.position, patch.normal, patch.radius_m,
                     static_cast<float>(static_cast<int>(patch.sight))});
  count_ = static_cast<GLsizei>(marks.size());
  glBindBuffer(GL_ARRAY_BUFFER, instances_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(marks.size() * sizeof(MarkInstance)),
               marks.data(), GL_STREAM_DRAW);
}

void PatchPass::draw(const Offscreen& target, const View& view, double tolerance_m) const {
  if (count_ == 0) return;
  target.bind();
  set_draw_state({.blend = Blend::kOver, .depth_test = DepthTest::kNearer});
  program_.use();
  program_.set("u_eye_from_design", eye_from_design(view));
  program_.set("u_clip_from_eye", clip_from_eye(view));
  program_.set("u_shift_m", static_cast<float>(0.5 * tolerance_m));
  program_.set("u_known", kKnown);
  program_.set("u_partly", kPartly);
  program_.set("u_not_seen", kNotSeen);
  glBindVertexArray(attributes_.id());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
}

}  // namespace spool::render
