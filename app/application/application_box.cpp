// The acquisition box in the application: asked for by a button, set by two taps on the scan.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>

#include "app/application/application.h"
#include "app/application/picking.h"

namespace spool {

namespace {
// Of the picture's points, those in the box.
double percent_inside(const VisionState& inside, const VisionState& whole) {
  if (whole.scan.empty()) return 0;
  return 100 * static_cast<double>(inside.scan.size()) / static_cast<double>(whole.scan.size());
}
}  // namespace

// Asks for a box, or drops the one there is.
void Application::press_box() {
  menu_open_ = false;
  if (box_.phase() != BoxSession::Phase::kNone) {
    box_.clear();
    if (!picks_.can_undo()) release_picture();
    return;
  }
  stop_find();
  box_.ask();
}

void Application::tap_box(const ui::Gesture& gesture, double slop) {
  if (!layout_.scan_view.contains(gesture.x, gesture.y)) {
    notice("The box is set in the camera picture: tap there.");
    return;
  }
  if (!shown()) return;
  const auto index =
      pick_point(shown()->scan.points, scan_eye_.view(), gesture.x - layout_.scan_view.x,
                 gesture.y - layout_.scan_view.y, slop);
  if (!index) {
    notice("No depth there: tap on the steel, or on what it lies on.");
    return;
  }
  hold_picture();  // both taps are made on one picture
  box_.tap(*held_, held_->scan.points[*index], in_.design->model);
  if (box_.is_asking()) return;
  notice(fmt::format("{:.0f} % of what is seen lies in the box: the rest is left out.",
                     percent_inside(*shown(), *held_)));
  // A camera that is not followed knows the box in this picture only.
  if (!picks_.can_undo() && held_->camera != PoseQuality::kLost) release_picture();
}

// True where the box has something to say, which then comes before search and picks.
bool Application::fill_box(ui::ScreenState& out) const {
  switch (box_.phase()) {
    case BoxSession::Phase::kFirst:
      out.box_word = "tap 1 of 2";
      out.hint = "Box: tap a corner of where the spool lies, in the camera picture.";
      out.proposed =
          "What lies outside is left out of the search and of the picks. Box again: none.";
      return true;
    case BoxSession::Phase::kSecond:
      out.box_word = "tap 2 of 2";
      out.hint = "Box: tap the opposite corner, as you look at it.";
      return true;
    case BoxSession::Phase::kSet: {
      out.box_word = "clear";
      const VisionStatePtr& whole = held_ ? held_ : seen_;
      if (!whole || box_.is_known_in(*whole)) return false;
      out.hint = "The box is out of sight: look where it was set, or press Box to be without.";
      out.hint_is_warning = true;
      return true;
    }
    case BoxSession::Phase::kNone:
      break;
  }
  return false;
}

// For --print-targets; empty without a box.
std::string Application::box_in_words() const {
  const VisionStatePtr& whole = held_ ? held_ : seen_;
  if (box_.phase() != BoxSession::Phase::kSet || screen_ != ui::Screen::kAlign || !whole)
    return box_.is_asking() ? "asking" : "";
  return fmt::format("{} %", std::lround(percent_inside(*shown(), *whole)));
}

}  // namespace spool
