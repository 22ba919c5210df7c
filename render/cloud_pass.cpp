// Pass: the measured points, coloured by deviation; clutter dim, what contradicts marked.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/cloud_pass.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "render/deviation_colour.h"
#include "render/gl_state.h"

namespace spool::render {
namespace {

enum Group : std::size_t { kClutter, kObject, kContradicting, kNotDrawn };

Group group_of(const Eigen::Vector3f& point, float deviation_m, std::uint8_t point_class) {
  if (!point.allFinite()) return kNotDrawn;
  if (point_class == 2) return kContradicting;
  return point_class == 1 && std::isfinite(deviation_m) ? kObject : kClutter;
}

}  // namespace

Result<CloudPass> CloudPass::create() {
  auto points = ShaderProgram::create("cloud");
  if (!points) return points.error();
  auto contradicting = ShaderProgram::create("contradicting");
  if (!contradicting) return contradicting.error();
  CloudPass pass;
  pass.points_ = std::move(*points);
  pass.contradicting_ = std::move(*contradicting);
  pass.buffer_ = make_buffer();
  pass.attributes_ = make_vertex_array();
  glBindVertexArray(pass.attributes_.id());
  glBindBuffer(GL_ARRAY_BUFFER, pass.buffer_.id());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Eigen::Vector4f), nullptr);
  std::array<GLfloat, 2> sizes{1, 1};
  glGetFloatv(GL_ALIASED_POINT_SIZE_RANGE, sizes.data());
  pass.largest_px_ = sizes[1];
  return pass;
}

void CloudPass::set_points(std::span<const Eigen::Vector3f> points_design,
                           std::span<const float> deviation_m,
                           std::span<const std::uint8_t> classes) {
  assert(points_design.size() == deviation_m.size() && points_design.size() == classes.size() &&
         "a deviation and a class for every point");
  std::array<std::size_t, 4> count{};
  for (std::size_t i = 0; i < points_design.size(); ++i) {
    ++count[group_of(points_design[i], deviation_m[i], classes[i])];
  }
  std::array<std::size_t, 3> next{0, count[kClutter], count[kClutter] + count[kObject]};
  std::vector<Eigen::Vector4f> vertices(count[kClutter] + count[kObject] + count[kContradicting]);
  for (std::size_t i = 0; i < points_design.size(); ++i) {
    const Group group = group_of(points_design[i], deviation_m[i], classes[i]);
    if (group == kNotDrawn) continue;
    // Only the object's deviations are coloured; a NaN elsewhere would still pass through the mix.
    const float deviation = group == kObject ? deviation_m[i] : 0.0F;
    vertices[next[group]++] << points_design[i], deviation;
  }
  clutter_count_ = static_cast<GLsizei>(count[kClutter]);
  object_count_ = static_cast<GLsizei>(count[kObject]);
  contradicting_count_ = static_cast<GLsizei>(count[kContradicting]);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Eigen::Vector4f)),
               vertices.data(), GL_STREAM_DRAW);
}

void CloudPass::draw(const Offscreen& target, const View& view, const CloudStyle& style) const {
  target.bind();
  set_draw_state({.depth_test = DepthTest::kNearer, .depth_write = true});
  const glm::mat4 clip_from_design = clip_from_eye(view) * eye_from_design(view);
  glBindVertexArray(attributes_.id());
  points_.use();
  points_.set("u_clip_from_design", clip_from_design);
  points_.set("u_size_px", style.size_px);
  points_.set("u_spacing_px_m", static_cast<float>(style.spacing_m * view.camera.fx));
  points_.set("u_largest_px", largest_px_);
  points_.set("u_inside_stops", inside_stops());
  points_.set("u_outside_stops", outside_stops());
  points_.set("u_neutral_m", static_cast<float>(style.neutral_m));
  points_.set("u_range_m", static_cast<float>(style.range_m));
  points_.set("u_colour", clutter_colour());
  if (style.show_clutter && clutter_count_ > 0) {
    points_.set("u_use_deviation", 0.0F);
    glDrawArrays(GL_POINTS, 0, clutter_count_);
  }
  if (object_count_ > 0) {
    points_.set("u_use_deviation", 1.0F);
    glDrawArrays(GL_POINTS, clutter_count_, object_count_);
  }
  if (contradicting_count_ > 0) {
    contradicting_.use();
    contradicting_.set("u_clip_from_design", clip_from_design);
    contradicting_.set("u_size_px", std::min(std::max(1.5F * style.size_px, 5.0F), largest_px_));
    contradicting_.set("u_colour", contradicting_colour());
    contradicting_.set("u_hatch", Eigen::Vector3f(0.20F, 0.0F, 0.17F));
    contradicting_.set("u_hatch_px", 3.0F * style.size_px);
    glDrawArrays(GL_POINTS, clutter_count_ + object_count_, contradicting_count_);
  }
}

}  // namespace spool::render
