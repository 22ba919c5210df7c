// Stands in for the display with a touch screen where the driver's protocol is not installed.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/app/e2e/touch_display.h"

namespace spool::test {

Result<std::unique_ptr<TouchDisplay>> TouchDisplay::start(const std::filesystem::path&) {
  return Error{ErrorCode::kNoDevice, "the test was built without xserver-xorg-dev"};
}
TouchDisplay::~TouchDisplay() = default;
bool TouchDisplay::down(std::uint32_t, const Spot&) const { return false; }
bool TouchDisplay::move(std::uint32_t, const Spot&) const { return false; }
bool TouchDisplay::up(std::uint32_t, const Spot&) const { return false; }
bool TouchDisplay::tap(const Spot&) const { return false; }

}  // namespace spool::test
