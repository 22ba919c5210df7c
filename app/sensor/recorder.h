// Records what any source gives, to a depth folder or an .oni file.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "app/sensor/depth_source.h"
#include "vision/core/cancel.h"

namespace spool::sensor {

struct RecordOptions {
  std::int64_t frames = std::numeric_limits<std::int64_t>::max();  // ends after so many
  double seconds = std::numeric_limits<double>::infinity();  // ends after so long, source's clock
  double patience = 10;  // s without a frame from a camera before it is given up
};

struct Recorded {
  std::int64_t frames = 0;
  double seconds = 0;  // s from the first frame to the last
};

// Records until a limit of `options`, the end of a recording, or watch.stop. `path` ending in .oni
// makes an OpenNI2 recording, anything else a depth folder. Depth counts are kept bit for bit. An
// .oni file appears whole or not at all: it is written beside its place, played to its end and its
// frames counted, then renamed; a depth folder keeps the frames that were written when something
// fails. kIo for a full disk, kUsage where `path` exists already, the source's own error otherwise.
// Unplugging is waited out.
[[nodiscard]] Result<Recorded> record(DepthSource& source, const std::string& path,
                                      const RecordOptions& options = {}, const Watch& watch = {});

}  // namespace spool::sensor
