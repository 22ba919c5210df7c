// What fingers mean on a picture: tap, turn, pinch, pan and roll.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "app/ui/touch_event.h"

namespace spool::ui {

struct Gesture {
  enum class Kind {
    kTap,    // at (x, y)
    kOrbit,  // one finger moved by (dx, dy)
    kMove,   // two fingers, or the right button: pan by (dx, dy), zoom by factor and roll about (x,
             // y)
  };
  Kind kind = Kind::kTap;
  double x = 0, y = 0;    // px: of the tap, or the middle of two fingers
  double dx = 0, dy = 0;  // px
  double factor = 1;      // over 1: fingers apart, closer
  double roll_rad = 0;    // clockwise as seen
  double start_x = 0,
         start_y = 0;  // px: where the first finger came down; says which picture is meant
};

// Fed with every event that no widget wanted. A tap is a finger that came up within `slop_px` of
// where it came down, alone, however long it stayed (gloves are slow).
class GestureRecogniser {
 public:
  explicit GestureRecogniser(double slop_px) : slop_px_(slop_px) {}
  [[nodiscard]] std::vector<Gesture> feed(const std::vector<TouchEvent>& events);
  void cancel() { fingers_.clear(); }

 private:
  struct Finger {
    double x = 0, y = 0, start_x = 0, start_y = 0;
    bool dragged = false;  // left the slop
    bool alone = true;     // all the time that it was down: else it is no tap
  };
  void move(const TouchEvent& event, std::vector<Gesture>& out);
  void lift(int id);

  double slop_px_;
  std::map<int, Finger> fingers_;  // down now
};

}  // namespace spool::ui
