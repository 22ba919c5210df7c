// The bracket of the simulated scene as files: a design and a recording of it standing still.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "vision/inspector.h"

namespace spool::test {

struct BracketFiles {
  std::filesystem::path design, recording;
  std::shared_ptr<const PreparedDesign> prepared;  // of the file
};

// Into `folder`; nothing prepared where something failed. `frames` of the recording at 30 a second.
[[nodiscard]] BracketFiles write_bracket(const std::filesystem::path& folder, int frames);

}  // namespace spool::test
