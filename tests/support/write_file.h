// Writes a file as a test wants it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace spool::test {

// `bytes` as the whole file `path`, its folders made where they are missing. Gives the path back.
std::filesystem::path write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace spool::test
