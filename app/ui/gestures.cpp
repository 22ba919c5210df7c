// What fingers mean on a picture.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ui/gestures.h"

#include <cmath>
#include <iterator>
#include <numbers>

namespace spool::ui {

namespace {
constexpr double kZoomOfWheelStep = 1.15;
// Fingers nearer than this (px) give no steady direction to roll by.
constexpr double kMinSpan = 10.0;

double wrapped(double angle) { return std::remainder(angle, 2.0 * std::numbers::pi); }
}  // namespace

void GestureRecogniser::move(const TouchEvent& event, std::vector<Gesture>& out) {
  const auto found = fingers_.find(event.id);
  if (found == fingers_.end()) return;
  Finger& finger = found->second;
  const double dx = event.x - finger.x;
  const double dy = event.y - finger.y;
  if (dx == 0 && dy == 0) return;
  if (fingers_.size() == 1) {
    if (!finger.dragged) {
      if (std::hypot(dx, dy) <= slop_px_) return;
      finger.dragged = true;  // the whole way so far counts: the picture stays under the finger
    }
    const bool pan = event.id == kRightButton;
    Gesture gesture;
    gesture.kind = pan ? Gesture::Kind::kMove : Gesture::Kind::kOrbit;
    gesture.x = event.x;
    gesture.y = event.y;
    gesture.dx = dx;
    gesture.dy = dy;
    gesture.start_x = finger.start_x;
    gesture.start_y = finger.start_y;
    out.push_back(gesture);
  } else if (fingers_.size() == 2) {
    const auto other_it =
        fingers_.begin()->first == event.id ? std::next(fingers_.begin()) : fingers_.begin();
    const Finger& other = other_it->second;
    const double before = std::hypot(finger.x - other.x, finger.y - other.y);
    const double after = std::hypot(event.x - other.x, event.y - other.y);
    Gesture gesture;
    gesture.kind = Gesture::Kind::kMove;
    gesture.x = 0.5 * (event.x + other.x);
    gesture.y = 0.5 * (event.y + other.y);
    gesture.dx = 0.5 * dx;
    gesture.dy = 0.5 * dy;
    if (before > kMinSpan && after > kMinSpan) {
      gesture.factor = after / before;
      gesture.roll_rad = wrapped(std::atan2(event.y - other.y, event.x - other.x) -
                                 std::atan2(finger.y - other.y, finger.x - other.x));
    }
    gesture.start_x = other.start_x;
    gesture.start_y = other.start_y;
    out.push_back(gesture);
  }
  finger.x = event.x;
  finger.y = event.y;
}

// Fingers never lift at one moment: the one that stays has to leave the slop again before it turns
// what two have just put in place.
void GestureRecogniser::lift(int id) {
  fingers_.erase(id);
  if (fingers_.size() == 1) fingers_.begin()->second.dragged = false;
}

std::vector<Gesture> GestureRecogniser::feed(const std::vector<TouchEvent>& events) {
  std::vector<Gesture> out;
  for (const TouchEvent& event : events) {
    switch (event.phase) {
      case TouchPhase::kDown:
        fingers_[event.id] = {event.x, event.y, event.x, event.y, event.id == kRightButton, true};
        if (fingers_.size() > 1) {
          for (auto& [id, finger] : fingers_) finger.alone = false;
        }
        break;
      case TouchPhase::kMove:
        move(event, out);
        break;
      case TouchPhase::kUp: {
        const auto found = fingers_.find(event.id);
        if (found == fingers_.end()) break;
        move(event, out);
        const Finger finger = found->second;
        lift(event.id);
        if (!finger.dragged && finger.alone) {
          Gesture tap;
          tap.x = finger.start_x;  // where it came down: a glove rolls when it lifts
          tap.y = finger.start_y;
          tap.start_x = finger.start_x;
          tap.start_y = finger.start_y;
          out.push_back(tap);
        }
        break;
      }
      case TouchPhase::kCancel:
        lift(event.id);
        break;
      case TouchPhase::kWheel: {
        Gesture zoom;
        zoom.kind = Gesture::Kind::kMove;
        zoom.x = zoom.start_x = event.x;
        zoom.y = zoom.start_y = event.y;
        zoom.factor = std::pow(kZoomOfWheelStep, event.steps);
        out.push_back(zoom);
        break;
      }
      case TouchPhase::kHover:
        break;
    }
  }
  return out;
}

}  // namespace spool::ui
