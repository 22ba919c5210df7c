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

enum Group : std::size_t { kClutter, kUnknown, kObject, kContradicting, kNotDrawn };

Group group_of(const Eigen::Vector3f& point, float deviation_m, std::uint8_t point_class) {
  if (!point.allFinite()) return kNotDrawn;
  if (point_class == 2) return kContradicting;
  if (point_class != 1) return kClutter;
  return std::isfinite(deviation_m) ? kObject : kUnknown;
}

}  // namespace

void set_point_look(const ShaderProgram& program, const View& view, const CloudStyle& style,
                    float largest_px) {
  program.set("u_clip_from_design", clip_from_eye(view) * eye_from_design(view));
  program.set("u_size_px", style.size_px);
  program.set("u_spacing_px_m", static_cast<float>(style.spacing_m * view.camera.fx));
  program.set("u_largest_px", largest_px);
  program.set("u_inside_stops", inside_stops());
  program.set("u_outside_stops", outside_stops());
  program.set("u_neutral_m", static_cast<float>(style.neutral_m));
  program.set("u_range_m", static_cast<float>(style.range_m));
}

float largest_point_px() {
  std::array<GLfloat, 2> sizes{1, 1};
  glGetFloatv(GL_ALIASED_POINT_SIZE_RANGE, sizes.data());
  return sizes[1];
}

Result<CloudPass> CloudPass::create() {
  auto points = ShaderProgram::create("cloud");
  if (!points) return points.error();
  auto discs = ShaderProgram::create("cloud", "cloud_disc");
  if (!discs) return discs.error();
  auto contradicting = ShaderProgram::create("contradicting");
  if (!contradicting) return contradicting.error();
  CloudPass pass;
  pass.points_ = std::move(*points);
  pass.discs_ = std::move(*discs);
  pass.contradicting_ = std::move(*contradicting);
  pass.buffer_ = make_buffer();
  pass.attributes_ = make_vertex_array();
  glBindVertexArray(pass.attributes_.id());
  glBindBuffer(GL_ARRAY_BUFFER, pass.buffer_.id());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Eigen::Vector4f), nullptr);
  pass.largest_px_ = largest_point_px();
  return pass;
}

void CloudPass::set_points(std::span<const Eigen::Vector3f> points_design,
                           std::span<const float> deviation_m,
                           std::span<const std::uint8_t> classes) {
  assert(points_design.size() == deviation_m.size() && points_design.size() == classes.size() &&
         "a deviation and a class for every point");
  std::array<std::size_t, 5> count{};
  for (std::size_t i = 0; i < points_design.size(); ++i) {
    ++count[group_of(points_design[i], deviation_m[i], classes[i])];
  }
  std::array<std::size_t, 4> next{};
  for (std::size_t group = 1; group < next.size(); ++group) {
    next[group] = next[group - 1] + count[group - 1];
  }
  std::vector<Eigen::Vector4f> vertices(points_design.size() - count[kNotDrawn]);
  for (std::size_t i = 0; i < points_design.size(); ++i) {
    const Group group = group_of(points_design[i], deviation_m[i], classes[i]);
    if (group == kNotDrawn) continue;
    // Only the object's deviations are coloured; a NaN elsewhere would still pass through the mix.
    const float deviation = group == kObject ? deviation_m[i] : 0.0F;
    vertices[next[group]++] << points_design[i], deviation;
  }
  for (std::size_t group = 0; group < count_.size(); ++group) {
    count_[group] = static_cast<GLsizei>(count[group]);
  }
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Eigen::Vector4f)),
               vertices.data(), GL_STREAM_DRAW);
}

void CloudPass::draw(const Offscreen& target, const View& view, const CloudStyle& style) const {
  target.bind();
  set_draw_state({.depth_test = DepthTest::kNearer, .depth_write = true});
  glBindVertexArray(attributes_.id());
  // Small squares are told from discs by nobody, and spare the driver a test of every pixel.
  const ShaderProgram& points = style.spacing_m > 0 ? discs_ : points_;
  points.use();
  set_point_look(points, view, style, largest_px_);
  GLint first = 0;
  const auto draw_next = [&first](GLsizei count, bool shown) {
    if (shown && count > 0) glDrawArrays(GL_POINTS, first, count);
    first += count;
  };
  points.set("u_use_deviation", 0.0F);
  points.set("u_colour", clutter_colour());
  draw_next(count_[kClutter], style.show_clutter);
  points.set("u_colour", unknown_colour());
  draw_next(count_[kUnknown], true);
  points.set("u_use_deviation", 1.0F);
  draw_next(count_[kObject], true);
  if (count_[kContradicting] > 0) {
    contradicting_.use();
    contradicting_.set("u_clip_from_design", clip_from_eye(view) * eye_from_design(view));
    contradicting_.set("u_size_px", std::min(std::max(1.5F * style.size_px, 5.0F), largest_px_));
    contradicting_.set("u_colour", contradicting_colour());
    contradicting_.set("u_hatch", Eigen::Vector3f(0.20F, 0.0F, 0.17F));
    contradicting_.set("u_hatch_px", 3.0F * style.size_px);
    draw_next(count_[kContradicting], true);
  }
}

}  // namespace spool::render
