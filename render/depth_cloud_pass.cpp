// Pass: every pixel of a depth image as a point, coloured by its distance to the design in a
// volume.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/depth_cloud_pass.h"

#include <cassert>
#include <cstddef>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include "render/deviation_colour.h"
#include "render/gl_state.h"

namespace spool::render {

Result<DepthCloudPass> DepthCloudPass::create() {
  auto points = ShaderProgram::create("depth_cloud", "cloud");
  if (!points) return points.error();
  auto discs = ShaderProgram::create("depth_cloud", "cloud_disc");
  if (!discs) return discs.error();
  DepthCloudPass pass;
  pass.points_ = std::move(*points);
  pass.discs_ = std::move(*discs);
  pass.no_attributes_ = make_vertex_array();
  pass.largest_px_ = largest_point_px();
  return pass;
}

void DepthCloudPass::set_depth(const DepthPoints& points) {
  const int width = points.camera.width;
  const int height = points.camera.height;
  assert(points.depth.size() ==
             static_cast<std::size_t>(width) * static_cast<std::size_t>(height) &&
         "an image of the camera's size");
  glActiveTexture(GL_TEXTURE0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
  const bool fits = depth_ && shown_.camera.width == width && shown_.camera.height == height;
  if (!fits) {
    depth_ = make_texture();
    glBindTexture(GL_TEXTURE_2D, depth_.id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R16UI, width, height, 0, GL_RED_INTEGER, GL_UNSIGNED_SHORT,
                 points.depth.data());
  } else {
    glBindTexture(GL_TEXTURE_2D, depth_.id());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RED_INTEGER, GL_UNSIGNED_SHORT,
                    points.depth.data());
  }
  shown_ = points;
  shown_.depth = {};
}

void DepthCloudPass::draw(const Offscreen& target, const View& view,
                          const CloudStyle& style) const {
  assert(has_distances() && depth_ && "distances and a depth image were set");
  target.bind();
  set_draw_state({.depth_test = DepthTest::kNearer, .depth_write = true});
  glBindVertexArray(no_attributes_.id());
  const ShaderProgram& program = style.spacing_m > 0 ? discs_ : points_;
  program.use();
  set_point_look(program, view, style, largest_px_);
  distances_.bind(program, 1);
  glBindTexture(GL_TEXTURE_2D, depth_.id());
  program.set("u_depth", 0);
  const Camera& camera = shown_.camera;
  program.set("u_depth_unit_m", static_cast<float>(camera.depth_unit_m));
  program.set("u_focal_px", Eigen::Vector2d(camera.fx, camera.fy).cast<float>().eval());
  program.set("u_centre_px", Eigen::Vector2d(camera.cx, camera.cy).cast<float>().eval());
  const Eigen::Matrix4f design_from_camera = shown_.T_design_camera.matrix().cast<float>();
  program.set("u_design_from_camera", glm::make_mat4(design_from_camera.data()));
  program.set("u_facing_beyond_m", static_cast<float>(shown_.facing_beyond_m));
  program.set("u_facing_cosine", static_cast<float>(shown_.facing_cosine));
  program.set("u_clutter_colour", clutter_colour());
  program.set("u_show_clutter", style.show_clutter ? 1 : 0);
  glDrawArrays(GL_POINTS, 0, camera.width * camera.height);
}

}  // namespace spool::render
