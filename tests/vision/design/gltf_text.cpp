// glTF and GLB files written by hand, good ones and bad ones.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/design/gltf_text.h"

#include <cstring>

namespace spool::test {
namespace {

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

std::string word(std::uint32_t value) { return bytes_of(std::vector<std::uint32_t>{value}); }

}  // namespace

std::string floats(const std::vector<float>& values) { return bytes_of(values); }
std::string shorts(const std::vector<std::uint16_t>& values) { return bytes_of(values); }

std::string glb(std::string json, std::string bin) {
  while (json.size() % 4 != 0) json += ' ';
  while (bin.size() % 4 != 0) bin += '\0';
  std::string body = word(static_cast<std::uint32_t>(json.size())) + "JSON" + json;
  if (!bin.empty()) {
    body += word(static_cast<std::uint32_t>(bin.size())) + std::string("BIN\0", 4) + bin;
  }
  return "glTF" + word(2) + word(static_cast<std::uint32_t>(body.size() + 12)) + body;
}

Pieces::Pieces()
    : bin(floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) +
          shorts({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3})) {
  buffers = R"([{"byteLength": )" + std::to_string(bin.size()) + "}]";
}

std::string Pieces::json() const {
  return R"({"asset": )" + asset + R"(, "buffers": )" + buffers + R"(, "bufferViews": )" + views +
         R"(, "accessors": )" + accessors + R"(, "meshes": )" + meshes + R"(, "nodes": )" + nodes +
         R"(, "scenes": )" + scenes + extra + "}";
}

}  // namespace spool::test
