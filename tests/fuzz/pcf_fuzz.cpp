// Fuzzes the reader of piping files: the first byte chooses the unit, the rest is the file.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "vision/design/gltf_writer.h"
#include "vision/design/readers.h"
#include "vision/piping/cut_list.h"
#include "vision/piping/pcf_reader.h"

namespace {

// Longer files are read, not drawn: bodies take a hundred times as long as the text.
constexpr std::size_t kMostDrawn = 1024;

void check(bool holds) {
  if (!holds) std::abort();
}

void check_design(const spool::DesignModel& design) {
  check(design.triangle_part.size() == design.mesh.triangles.size());
  for (const spool::Triangle& triangle : design.mesh.triangles) {
    for (const std::uint32_t vertex : triangle) {
      check(vertex < design.mesh.vertices.size());
      check(design.mesh.vertices[vertex].allFinite());
    }
  }
  const auto has_port = [&](int part, int port) {
    return part >= 0 && static_cast<std::size_t>(part) < design.parts.size() && port >= 0 &&
           static_cast<std::size_t>(port) <
               design.parts[static_cast<std::size_t>(part)].ports.size();
  };
  for (const spool::Joint& joint : design.joints) {
    check(has_port(joint.part_a, joint.port_a));
    check(has_port(joint.part_b, joint.port_b));
  }
  for (const spool::Part& part : design.parts) {
    for (const spool::Port& port : part.ports) {
      check(port.position.allFinite());
      check(std::abs(port.direction.norm() - 1) < 1e-6);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  std::optional<spool::LengthUnit> unit;
  if (data[0] % 3 == 1) unit = spool::LengthUnit::kMillimetre;
  if (data[0] % 3 == 2) unit = spool::LengthUnit::kInch;
  const std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  const auto pipework = spool::piping::read_pcf(bytes, "design.pcf");
  if (pipework) {
    for (const auto& pipe : spool::piping::cut_list(*pipework, 0.003))
      check(std::isfinite(pipe.cut()));
  }
  if (size > kMostDrawn) return 0;
  const auto design = spool::read_pcf_design({"design.pcf", bytes, unit});
  if (!design) {
    check(!design.error().message.empty());
    return 0;
  }
  check_design(*design);
  check(spool::write_gltf(*design).has_value());
  return 0;
}
