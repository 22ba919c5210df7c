// Fuzzes the design readers: the first byte chooses the format, the rest is the file.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <string>

#include "vision/design/design_surface.h"
#include "vision/design/readers.h"

namespace {

// What read_design() does once it has the bytes; a library's exception counts as a refusal there.
spool::Result<spool::DesignModel> read(unsigned format, std::string bytes) {
  const spool::LengthUnit unit = spool::LengthUnit::kMetre;
  try {
    switch (format % 5) {
      case 0:
        return spool::read_gltf_design({"design.glb", std::move(bytes), unit});
      case 1:
        return spool::read_gltf_design({"design.gltf", std::move(bytes), unit});
      case 2:
        return spool::read_mesh_design({"design.stl", std::move(bytes), unit});
      case 3:
        return spool::read_mesh_design({"design.obj", std::move(bytes), unit});
      default:
        return spool::read_ply_design({"design.ply", std::move(bytes), unit});
    }
  } catch (const std::exception& failure) {
    return spool::Error{spool::ErrorCode::kBadInput, failure.what()};
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto design = read(data[0], std::string(reinterpret_cast<const char*>(data + 1), size - 1));
  if (!design) {
    if (design.error().message.empty()) std::abort();
    return 0;
  }
  // Read: then every index holds, every number is finite and a surface can be built.
  if (design->triangle_part.size() != design->mesh.triangles.size()) std::abort();
  for (const spool::Triangle& triangle : design->mesh.triangles) {
    for (const std::uint32_t vertex : triangle) {
      if (vertex >= design->mesh.vertices.size()) std::abort();
      if (!design->mesh.vertices[vertex].allFinite()) std::abort();
    }
  }
  for (const std::int32_t part : design->triangle_part) {
    if (part < 0 || static_cast<std::size_t>(part) >= design->parts.size()) std::abort();
  }
  if (size < 4096 && !spool::DesignSurface::build(*design)) std::abort();
  return 0;
}
