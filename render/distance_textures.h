// A volume of distances on the graphics card, for shaders that include distance_volume.glsl.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/gl_handle.h"
#include "render/shader.h"
#include "vision/core/distance_volume.h"
#include "vision/core/result.h"

namespace spool::render {

// GL thread only. Empty until set().
class DistanceTextures {
 public:
  // Uploads a volume in place of the one before; it is not needed afterwards. kNoDevice where the
  // driver has no room for it: then there is none.
  [[nodiscard]] Status set(const DistanceVolume& volume);
  [[nodiscard]] bool is_set() const { return static_cast<bool>(bricks_); }
  // Gives the volume to a program in use, on three texture units from `first_unit` on; leaves unit
  // 0 the active one.
  void bind(const ShaderProgram& program, int first_unit) const;

 private:
  TextureHandle grid_, nodes_, bricks_;
  Eigen::Vector3f lowest_m_ = Eigen::Vector3f::Zero();
  float cell_m_ = 1;
  float band_m_ = 0;
};

}  // namespace spool::render
