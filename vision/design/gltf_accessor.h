// The numbers behind glTF accessors: every range, stride, type and index checked.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vision/core/result.h"

namespace tinygltf {
class Model;
}

namespace spool {

// The points of a VEC3 accessor in the file's units: float, or integers as KHR_mesh_quantization
// allows; interleaved, sparse or both; bounds that the file states are not believed. The error's
// message has no file name yet and reads on from one: "accessor 3 ...".
[[nodiscard]] Result<std::vector<Eigen::Vector3d>> read_gltf_points(const tinygltf::Model& model,
                                                                    int accessor);

// The whole numbers of a SCALAR accessor of unsigned integers, each below `limit`.
[[nodiscard]] Result<std::vector<std::uint32_t>> read_gltf_indices(const tinygltf::Model& model,
                                                                   int accessor, std::size_t limit);

}  // namespace spool
