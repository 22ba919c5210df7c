// One image of depth as the sensor gave it: counts, not metres.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spool {

// Row-major, row 0 at the top; 0 = no measurement. Becomes metres in back_project() only.
struct DepthFrame {
  std::int64_t index = 0;                 // counts from 0 in the source
  double seconds = 0;                     // s on the source's own clock
  int width = 0;                          // px
  int height = 0;                         // px
  std::vector<std::uint16_t> depth = {};  // width * height counts of Camera::depth_unit_m

  [[nodiscard]] bool is_consistent() const {
    return width > 0 && height > 0 &&
           depth.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

}  // namespace spool
