// Files that are part of the program: shaders and the font, so that it needs none at run time.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace spool::render {

// The bytes of a file embedded at build time ("cloud.vert", "font.otf"); nothing for any other
// name.
[[nodiscard]] std::optional<std::string_view> embedded_file(std::string_view name);

}  // namespace spool::render
