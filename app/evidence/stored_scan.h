// The frames that a report's numbers rest on, as an entry keeps them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "app/evidence/scan_snapshot.h"
#include "vision/core/result.h"

namespace spool::evidence {

// Writes folder/scan, a depth folder of this frame alone, without loss, and folder/plain.png: the
// frame as a grey picture (near is bright, black nothing measured), without any overlay. kIo.
[[nodiscard]] Status store_frame(const OneFrame& one, const std::filesystem::path& folder);

// About as many bytes as store_frame() writes at most.
[[nodiscard]] std::uint64_t stored_bytes(const DepthFrame& frame);

}  // namespace spool::evidence
