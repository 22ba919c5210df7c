// What the results of a check say: rows worst first, the numbers of one, the readout on the card.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/ui/status_mark.h"

namespace spool::ui {

// One row of the list.
struct ResultLine {
  StatusMark status = StatusMark::kNotMeasured;
  std::string name;    // "F2 face to E2 centre"
  std::string number;  // "+4.6 mm ± 0.7 mm, limit ± 3.0 mm"; empty: there is none
};

// All that is known of one row.
struct ResultDetail {
  StatusMark status = StatusMark::kNotMeasured;
  std::string name;
  std::string number;                                      // "+4.6 mm"; empty: there is none
  std::string doubt;                                       // "± 0.7 mm, limit ± 3.0 mm, too long"
  std::vector<std::string> to_do;                          // one sentence each, the first first
  std::vector<std::pair<std::string, std::string>> facts;  // "Drawing", "300.0 mm"
  std::string words;                                       // what was found, whole sentences
};

// The Results screen.
struct ResultsState {
  StatusMark overall = StatusMark::kNotMeasured;
  std::string of;      // "Checked 12 s ago"
  std::string reason;  // of the overall status
  std::vector<ResultLine> lines;
  int open = -1;              // the row whose numbers are open; -1: the list
  ResultDetail detail;        // of it
  bool opened_alone = false;  // by a tap on the part: there is no list to go back to
  bool view_turned = false;   // not the camera's
};

}  // namespace spool::ui
