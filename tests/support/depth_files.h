// The files of a depth folder, made by code that shares nothing with their reader and writer.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace spool::test {

// camera.json with each value as text, so that a test can write what no camera has.
struct CameraText {
  std::string width = "640", height = "480";  // px
  std::string fx = "575", fy = "575";         // px; empty: the key is left out
  std::string cx = "320", cy = "240";         // px
  std::string depth_unit_m = "0.001";
  std::string more;  // further members, each with a comma before it

  [[nodiscard]] std::string json() const;
};

// A grey PNG of width x height values, row 0 at the top, of 16 bits or (the values' low bytes) 8.
[[nodiscard]] std::string grey_png(std::span<const std::uint16_t> values, int width, int height,
                                   int bits = 16);

// A recording of `frames` images of width x height px without a reading, whose camera may say
// otherwise. The folder must not exist.
void write_blank_recording(const std::filesystem::path& folder, const CameraText& camera,
                           int frames, int width, int height);

}  // namespace spool::test
