// A small spool made from formulas, and what a depth camera would see of it: what the pictures
// show.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "render/view.h"
#include "vision/core/triangle_mesh.h"

namespace spool::test {

enum Part : std::int32_t { kPipe, kElbow, kFlange };

struct Scene {
  TriangleMesh mesh;
  std::vector<std::int32_t> part;  // of each triangle
};

// A 114.3 mm pipe along +x from the origin, an elbow turning up to +z, a flange with eight studs on
// it. About 0.5 m over all; part numbers as in Part.
[[nodiscard]] Scene make_spool();

// Where the pipe's top and the middle of the flange's face lie (m, design frame).
inline const Eigen::Vector3d kPipeTop{0.15, 0.0, 0.05715};
inline const Eigen::Vector3d kFlangeFace{0.4524, 0.0, 0.2774};

struct Measured {
  std::vector<Eigen::Vector3f> points;  // m, design frame
  std::vector<float> deviation;         // m; NaN: clutter
  std::vector<std::uint8_t> classes;    // 0 clutter, 1 object, 2 contradicting
};

// Every pixel's first surface seen in `view`, each point moved out along its normal by what
// `deviation_m` says of its part and place. With `floor_z` below the spool: a floor there, as
// clutter.
[[nodiscard]] Measured measure(
    const Scene& scene, const render::View& view,
    const std::function<double(Part, const Eigen::Vector3d&)>& deviation_m, double floor_z = -1e9);

// The view that the pictures are made from.
[[nodiscard]] render::View spool_view(int width, int height);

}  // namespace spool::test
