// The header of a PCD file: its fields, size and kind of data.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "vision/core/result.h"
#include "vision/scan/scalar.h"

namespace spool {

struct PcdField {
  std::string name;  // "_" is padding
  Scalar type = Scalar::kFloat;
  std::uint64_t count = 1;   // numbers a point
  std::uint64_t offset = 0;  // bytes from the start of the point
  std::uint64_t word = 0;    // numbers from the start of the point's line

  [[nodiscard]] std::uint64_t bytes() const { return count * bytes_of(type); }
};

struct PcdHeader {
  enum class Data { kAscii, kBinary, kCompressed } data = Data::kAscii;
  std::vector<PcdField> fields = {};
  std::uint64_t points = 0;
  std::uint64_t width = 0;
  std::uint64_t height = 1;
  std::uint64_t point_bytes = 0;  // the fields' together
  std::uint64_t point_words = 0;
  std::string_view body;  // what follows the header
  std::size_t lines = 0;  // of the header

  [[nodiscard]] const PcdField* find(std::string_view name) const;
};

// kBadInput with one sentence for anything that is no PCD header, and for fields that do not fit
// into the file's own size.
[[nodiscard]] Result<PcdHeader> read_pcd_header(std::string_view bytes, const std::string& name);

}  // namespace spool
