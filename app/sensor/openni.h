// What the one OpenNI2 file offers beside a live camera: raw .oni playback, and writing .oni.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "app/sensor/source_kinds.h"

namespace spool::sensor {

// Plays an .oni file without the check. Only for a file that this program wrote or that oni_check.h
// has passed: a damaged header crashes OpenNI2's own reader.
[[nodiscard]] OpenedSource open_oni_unchecked(const std::string& path,
                                              const SourceOptions& options);

// Records frames to an .oni file, through a device of our plug-in that passes on what it is given.
// One thread.
class OniWriter {
 public:
  virtual ~OniWriter() = default;
  // kBadInput for a frame of another size or with a count of 65535, which the format cannot hold.
  [[nodiscard]] virtual Status write(const DepthFrame& frame) = 0;
  // Ends the recording; the file is complete when it returns.
  virtual void finish() = 0;
};

// kBadInput for a camera that the format cannot describe: it knows the fields of view, so the
// principal point must be the middle (width / 2, height / 2), and a count must be 1 mm or 0.1 mm.
[[nodiscard]] Result<std::unique_ptr<OniWriter>> create_oni(const std::string& path,
                                                            const Camera& camera);

}  // namespace spool::sensor
