// A finger, a mouse button or a wheel: all input that the program knows, whatever it came from.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace spool::ui {

enum class TouchPhase {
  kDown,
  kMove,
  kUp,
  kCancel,  // the system took the finger away; nothing may come of it
  kHover,   // a mouse without a button
  kWheel,   // `steps` of a mouse wheel
};

// Ids of a mouse's buttons; fingers count from 0.
inline constexpr int kLeftButton = -1;
inline constexpr int kRightButton = -2;

struct TouchEvent {
  int id = 0;
  TouchPhase phase = TouchPhase::kMove;
  double x = 0;  // px in the window, from the left
  double y = 0;  // px, from the top
  double t_s = 0;
  double steps = 0;  // of kWheel, away from the hand positive
};

}  // namespace spool::ui
