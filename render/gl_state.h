// The whole state of a draw call in one place: every pass sets it at entry, nobody restores.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace spool::render {

enum class Blend { kOpaque, kOver, kMultiply };  // none; by alpha; destination times source
enum class DepthTest { kOff, kNearer, kNearerOrEqual, kFarther };

struct DrawState {
  Blend blend = Blend::kOpaque;
  DepthTest depth_test = DepthTest::kOff;
  bool depth_write = false;
  bool colour_write = true;
  bool cull_back_faces = false;
};

// Sets all of it, and scissor, stencil and dithering off. Whatever the blend, a target
// that was opaque stays so. GL thread only.
void set_draw_state(const DrawState& state);

}  // namespace spool::render
