// A recording of any length: a short one there and back again, by links to its pictures.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>

#include "vision/core/result.h"

namespace spool::soak {

// A depth folder among the system's temporary files, gone with this object.
class LongRecording {
 public:
  // Plays the depth folder `of` there and back for `seconds`, neighbour after neighbour, its clock
  // going on. kBadInput where it cannot be read or has fewer than two frames, kIo where the links
  // cannot be made.
  [[nodiscard]] static Result<LongRecording> make(const std::filesystem::path& of, double seconds);

  LongRecording(LongRecording&& other) noexcept;
  LongRecording& operator=(LongRecording&&) = delete;
  ~LongRecording();

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::size_t frames() const { return frames_; }

 private:
  LongRecording() = default;

  std::filesystem::path folder_;  // empty: nothing to remove
  std::size_t frames_ = 0;
};

}  // namespace spool::soak
