// What the panels read: words and numbers ready to be shown, all of one state.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/ui/evidence_state.h"
#include "app/ui/results_state.h"
#include "app/ui/status_mark.h"

namespace spool::ui {

enum class Screen { kAlign, kChoose, kWork, kResults, kEvidence, kNcr, kTyping };

// How well the camera's place is known.
enum class TrackingMark { kNone, kGood, kPoor, kPaused, kFrozen, kLost };

// One pick of the alignment.
struct PairChip {
  bool set = false;
  bool current = false;  // the one that the next tap makes
  std::string residual;  // after three: how far it is off, "1.2 mm"
};

// One line of the list of parts, worst first.
struct PartLine {
  int part = -1;
  std::string name;
  StatusMark status = StatusMark::kNotMeasured;
  std::string number;  // mean deviation: "+1.2 mm"
  std::string doubt;   // of it: "± 0.4 mm"
  std::string side;    // of the drawing's surface: "outside"
  std::string seen;    // of the part's surface: "72 %"
};

struct ScreenState {
  Screen screen = Screen::kAlign;
  std::string title;   // the spool
  std::string step;    // of a job: "step 4 of 11"; empty: there is no job
  std::string source;  // one line: camera or recording
  std::string unit;    // that lengths are said in: "mm", "ft-in"
  bool source_is_well = true;
  TrackingMark tracking = TrackingMark::kNone;
  std::string hint;  // what to do next: never empty
  bool hint_is_warning = false;
  std::string notice;  // what just happened ("Saved screen_001.png"); empty: nothing

  bool menu_open = false;  // what More has

  // Align
  std::vector<PairChip> chips;
  std::string proposed;   // the design point that is lit, in words
  bool can_skip = false;  // another design point in the place of the lit one
  bool can_undo = false;
  bool can_finish = false;   // three picks that make a pose
  bool can_go_back = false;  // an alignment stands already
  std::string box_word;      // of the acquisition box: what Box does now; empty: set one

  // Find, on both screens
  bool can_find = false;
  bool finding = false;   // a search runs
  double find_share = 0;  // 0 to 1, done of it

  // Choose: the drawing fits in more than one way
  std::string choice;           // "1 of 2"
  std::string choice_evidence;  // what speaks for this one

  // Work
  bool aligned = false;
  bool still_shown = false;     // the spool is lost, its last good view stands in layout.still
  bool measured = false;        // numbers below belong to the picture
  std::vector<PartLine> parts;  // worst first
  int lit_part = -1;
  std::string point_noise;  // one standard deviation of a point here: "0.8 mm"
  StatusMark overall = StatusMark::kNotMeasured;
  std::string overall_reason;
  bool checked = false;      // `overall` is from a check of this very frame
  bool checking = false;     // one is on its way
  bool frozen = false;       // the picture stands, with its pose and numbers, until Live
  bool detached = false;     // the view is not the camera's
  bool can_replay = false;   // a recording came to its end
  std::string view_word;     // what View shows now: "both", "scan", "drawing", "seen"
  bool sight_shown = false;  // the drawing carries marks of how well it is known
  bool list_open = false;
  std::string step_part;           // of a job: what the step is of
  bool can_accept = false;         // the step, on the check just made
  std::string accept_word;         // under Accept: what the check said, or what is missing
  bool has_evidence = false;       // there is a job, whose captures can be looked at
  bool can_capture_again = false;  // a check could not be written; the hint says why

  // Of the last check
  bool has_results = false;
  bool readout_shown = false;  // on the card: the picture is still as it was checked
  ResultDetail readout;        // the number that decides
  std::string readout_of;      // "Checked 12 s ago", and the worst of all
  ResultsState results;        // Results

  EvidenceState evidence;
  FormState form;
  TypingState typing;
};

enum class Action {
  kAlign,
  kFind,
  kCancelFind,
  kNext,    // of the poses to choose from
  kAccept,  // the pose shown
  kAcceptStep,
  kCaptureAgain,  // what could not be written
  kEvidence,      // the captures of the job
  kOpenCapture,   // of the number `value`
  kTurnPage,      // of captures or of the form, by `value`
  kNcr,           // the form on the capture that is open
  kTypeField,     // of the form: `value`
  kChooseField,   // the same, choice `part`
  kWriteNcr,
  kLeave,    // Evidence and what is in it: one back
  kKey,      // of the keyboard: letter `value`
  kKeyRole,  // the same: KeyRole `value`
  kCheck,
  kShot,
  kView,
  kCameraView,
  kReplay,
  kFreeze,    // or go on with the live picture
  kMenu,      // More: open or close it
  kSaveLast,  // the last seconds of the sensor
  kBox,       // ask for an acquisition box, or drop it
  kSkip,
  kUndo,
  kFinish,
  kBack,
  kToggleList,
  kLightPart,
  kResults,     // of the last check: their list
  kOpenResult,  // the row `value` of them
};

struct Command {
  Action action = Action::kShot;
  int part = -1;  // of kLightPart
  int value = 0;  // see the action
};

}  // namespace spool::ui
