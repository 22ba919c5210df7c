// A volume of distances on the graphics card, for shaders that include distance_volume.glsl.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/distance_textures.h"

#include <array>
#include <cassert>

#include "render/gl_status.h"

namespace spool::render {
namespace {

struct Format {
  GLint internal;
  GLenum format, type;
  GLint filter;
};
constexpr Format kWords{GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, GL_NEAREST};
constexpr Format kDistances{GL_RG16F, GL_RG, GL_HALF_FLOAT, GL_LINEAR};
constexpr std::array<GLenum, 3> kAxes{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R};

template <class T>
TextureHandle upload(const Texels<T>& texels, const Format& as) {
  TextureHandle texture = make_texture();
  glBindTexture(GL_TEXTURE_3D, texture.id());
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, as.filter);
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, as.filter);
  for (const GLenum axis : kAxes) glTexParameteri(GL_TEXTURE_3D, axis, GL_CLAMP_TO_EDGE);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  const auto& [width, height, depth] = texels.size;
  glTexImage3D(GL_TEXTURE_3D, 0, as.internal, width, height, depth, 0, as.format, as.type,
               texels.data.data());
  return texture;
}

}  // namespace

Status DistanceTextures::set(const DistanceVolume& volume) {
  assert(!volume.bricks.data.empty() && "a volume with something in it");
  glActiveTexture(GL_TEXTURE0);
  grid_ = upload(volume.grid, kWords);
  nodes_ = upload(volume.nodes, kWords);
  bricks_ = upload(volume.bricks, kDistances);
  lowest_m_ = volume.lowest;
  cell_m_ = volume.cell_m;
  band_m_ = volume.band_m;
  Status status = gl_status("uploading the design's distances");
  if (!status) *this = {};
  return status;
}

void DistanceTextures::bind(const ShaderProgram& program, int first_unit) const {
  assert(is_set() && "a volume was uploaded");
  const auto give = [&](const char* uniform, const TextureHandle& texture, int unit) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_3D, texture.id());
    program.set(uniform, unit);
  };
  give("u_grid", grid_, first_unit);
  give("u_nodes", nodes_, first_unit + 1);
  give("u_bricks", bricks_, first_unit + 2);
  glActiveTexture(GL_TEXTURE0);
  program.set("u_lowest_m", lowest_m_);
  program.set("u_cell_m", cell_m_);
  program.set("u_band_m", band_m_);
}

}  // namespace spool::render
