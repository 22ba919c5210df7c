// Unpacks LZF, the compression inside binary_compressed PCD files.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/lzf.h"

#include <cstring>

namespace spool {

// The format: a control byte c, then
//   c < 32   c + 1 bytes as they are;
//   else     a repeat of length 2 + (c >> 5), where 7 there means that one more byte is added to
//   the length,
//            from 1 + ((c & 31) << 8) + (the next byte) bytes back in what is unpacked already. The
//            repeat may overlap what it makes.
std::optional<std::string> unpack_lzf(std::string_view packed, std::size_t length) {
  if (length > lzf_longest(packed.size())) return std::nullopt;
  std::string out(length, '\0');
  std::size_t from = 0, to = 0;
  const auto byte = [&](std::size_t i) {
    return static_cast<std::size_t>(static_cast<unsigned char>(packed[i]));
  };
  while (from < packed.size()) {
    const std::size_t control = byte(from++);
    if (control < 32) {
      const std::size_t run = control + 1;
      if (run > packed.size() - from || run > length - to) return std::nullopt;
      std::memcpy(out.data() + to, packed.data() + from, run);
      from += run;
      to += run;
      continue;
    }
    std::size_t repeat = 2 + (control >> 5U);
    if (repeat == 9) {
      if (from == packed.size()) return std::nullopt;
      repeat += byte(from++);
    }
    if (from == packed.size()) return std::nullopt;
    const std::size_t back = 1 + ((control & 31U) << 8U) + byte(from++);
    if (back > to || repeat > length - to) return std::nullopt;
    for (std::size_t i = 0; i < repeat; ++i, ++to) out[to] = out[to - back];
  }
  if (to != length) return std::nullopt;
  return out;
}

}  // namespace spool
