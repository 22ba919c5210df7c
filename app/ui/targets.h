// Everything that can be tapped, by name and place, for tests and assistive tools.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/ui/layout.h"

namespace spool::ui {

struct Target {
  std::string name;
  Rect rect;
};

// Filled anew in every frame by what is drawn.
struct TargetList {
  std::vector<Target> targets;
  std::vector<Rect> panels;  // whatever floats on the steel and keeps taps to itself

  [[nodiscard]] bool is_covered(double x, double y) const {
    for (const Rect& panel : panels) {
      if (panel.contains(x, y)) return true;
    }
    return false;
  }
};

}  // namespace spool::ui
