// The files of a depth folder (ARCHITECTURE, Files): what lies in it, and writing one frame after
// another.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "vision/core/camera.h"
#include "vision/core/depth_frame.h"
#include "vision/core/result.h"

namespace spool::sensor {

struct DepthFile {
  std::filesystem::path path;
  double seconds = 0;  // s, never less than that of the file before
};

struct DepthFolder {
  Camera camera;
  std::vector<DepthFile> files;  // in name order; of TUM's depth.txt in its order
};

// Reads camera.json and the list of frames, no image yet. Times come from times.csv (its `frame` is
// the number in a file's name, or the place in name order where names are no numbers), else from
// TUM's depth.txt, else 1/30 s a frame. kBadInput names the file that is missing or wrong.
[[nodiscard]] Result<DepthFolder> read_depth_folder(const std::filesystem::path& folder);

// Writes a depth folder as it comes: each file whole or not at all, so that whatever ends the
// program leaves a folder that opens with the frames so far.
class DepthFolderWriter {
 public:
  // kUsage where the folder already holds something, kIo where it cannot be made.
  [[nodiscard]] static Result<DepthFolderWriter> create(const std::filesystem::path& folder,
                                                        const Camera& camera);
  // Frames are numbered as they come. kBadInput for a frame of another size, kIo for a full disk.
  [[nodiscard]] Status write(const DepthFrame& frame);
  [[nodiscard]] std::int64_t count() const { return count_; }

 private:
  DepthFolderWriter(std::filesystem::path folder, int width, int height)
      : folder_(std::move(folder)), width_(width), height_(height) {}

  std::filesystem::path folder_;
  int width_;
  int height_;
  std::int64_t count_ = 0;
};

}  // namespace spool::sensor
