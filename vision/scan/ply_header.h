// The header of a PLY file: what elements follow and what each is made of.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vision/core/result.h"
#include "vision/scan/scalar.h"

namespace spool {

struct PlyProperty {
  std::string name;
  Scalar type = Scalar::kFloat;                 // of the value, or of a list's items
  std::optional<Scalar> list_length_type = {};  // set: a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties = {};

  [[nodiscard]] bool has_lists() const;
  [[nodiscard]] std::size_t stride() const;  // bytes of one, its lists empty
};

struct PlyHeader {
  enum class Format { kAscii, kBinary } format = Format::kAscii;
  ByteOrder order = ByteOrder::kLittle;
  std::vector<PlyElement> elements = {};
  std::string_view body;  // what follows the header
  std::size_t lines = 0;  // of the header
};

// kBadInput with one sentence for anything that is no PLY header.
[[nodiscard]] Result<PlyHeader> read_ply_header(std::string_view bytes, const std::string& name);

}  // namespace spool
