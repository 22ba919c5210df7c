// The frames that a report's numbers rest on, as an entry keeps them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/stored_scan.h"

#include <algorithm>

#include "app/sensor/depth_folder.h"
#include "render/image.h"

namespace spool::evidence {
namespace {

// The nearest hundredth is white and the farthest dark grey: single wild readings do not count.
render::Image grey_picture(const DepthFrame& frame) {
  std::vector<std::uint16_t> measured;
  for (const std::uint16_t count : frame.depth) {
    if (count > 0) measured.push_back(count);
  }
  std::sort(measured.begin(), measured.end());
  const double near = measured.empty() ? 0 : measured[measured.size() / 100];
  const double far = measured.empty() ? 1 : measured[measured.size() - 1 - measured.size() / 100];
  render::Image image{frame.width, frame.height, {}};
  image.rgba.reserve(4 * frame.depth.size());
  constexpr double kBright = 255, kDark = 48;
  for (const std::uint16_t count : frame.depth) {
    const double share = std::clamp((far - count) / std::max(far - near, 1.0), 0.0, 1.0);
    const auto grey =
        count == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(kDark + share * (kBright - kDark));
    image.rgba.insert(image.rgba.end(), {grey, grey, grey, std::uint8_t{255}});
  }
  return image;
}

}  // namespace

std::uint64_t stored_bytes(const DepthFrame& frame) {
  constexpr std::uint64_t kBytesPerPixel = 4, kSmallFiles = 16384;
  return kBytesPerPixel * frame.depth.size() + kSmallFiles;
}

Status store_frame(const OneFrame& one, const std::filesystem::path& folder) {
  auto writer = sensor::DepthFolderWriter::create(folder / "scan", one.camera);
  if (!writer) return writer.error();
  if (Status written = writer->write(*one.frame); !written) return written;
  return render::write_png(folder / "plain.png", grey_picture(*one.frame));
}

}  // namespace spool::evidence
