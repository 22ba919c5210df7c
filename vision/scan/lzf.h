// Unpacks LZF, the compression inside binary_compressed PCD files.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace spool {

// The longest that LZF can make of `packed` bytes: three of them repeat 264.
[[nodiscard]] constexpr std::size_t lzf_longest(std::size_t packed) { return packed * 88; }

// The `length` bytes that `packed` stands for; nothing where it is damaged or stands for another
// number of bytes. Nothing is read or written out of bounds whatever the bytes are.
[[nodiscard]] std::optional<std::string> unpack_lzf(std::string_view packed, std::size_t length);

}  // namespace spool
