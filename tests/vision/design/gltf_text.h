// glTF and GLB files written by hand, good ones and bad ones.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace spool::test {

// The bytes of a GLB with this JSON and BIN chunk, padded and counted as the format asks.
[[nodiscard]] std::string glb(std::string json, std::string bin);

// Numbers as little-endian bytes.
[[nodiscard]] std::string floats(const std::vector<float>& values);
[[nodiscard]] std::string shorts(const std::vector<std::uint16_t>& values);

// The pieces of a one-mesh file: a tetrahedron of unit legs as 4 points and 12 indices. A test
// replaces the piece that it is about.
struct Pieces {
  std::string bin;  // positions first (48 bytes), indices after (24)
  std::string asset = R"({"version": "2.0"})";
  std::string buffers;  // set by the constructor
  std::string views =
      R"([{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}])";
  std::string accessors =
      R"([{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},)"
      R"( {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}])";
  std::string meshes = R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}])";
  std::string nodes = R"([{"mesh": 0, "name": "corner"}])";
  std::string scenes = R"([{"nodes": [0]}])";
  std::string extra;  // further members, each with a comma before it

  Pieces();
  [[nodiscard]] std::string json() const;
  [[nodiscard]] std::string glb() const { return test::glb(json(), bin); }
};

}  // namespace spool::test
