// One dimension of the drawing as it was measured, judged, and what its doubt is made of.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/inspect/verdict.h"

namespace spool {

// All standard uncertainties, metres or radians as the dimension is.
struct UncertaintyBudget {
  double fit = 0;    // random noise, its correlation, tolerances held in the fits, the datum's fit
  double scale = 0;  // of the sensor
  double warp = 0;   // of the sensor, what its calibration leaves

  [[nodiscard]] double total() const;
};

struct Dimension {
  std::string name;
  std::string kind;  // face_to_face, centre_to_face, … angle, face_alignment, offset, rotation
  std::string from, to;      // part/port, part/centre, part/axis
  bool is_angle = false;     // rad; else m
  double nominal = 0;        // by the design's own features, the same way as measured
  bool is_measured = false;  // false: nothing below but tolerance, rule, status and reason counts
  double measured = 0;
  double deviation = 0;  // measured - nominal; of face_alignment the size of the tilt
  UncertaintyBudget u;
  double tolerance = 0;    // either way; 0: no rule applies
  std::string rule;        // the clause, or why there is none
  double probability = 0;  // of lying within the tolerance (JCGM 106)
  Verdict status = Verdict::kNotMeasured;
  std::string reason;         // why not better, and what would settle it
  std::vector<int> parts;     // between its ends, both included
  bool is_one_holed = false;  // a rotation: it is off by about half the pitch of the holes
  int answers = -1;  // the part that is wrong where the dimension is: a cut length's pipe, an
                     // elbow, a flange
};

// A size that a part's own surface tells.
struct SizeCheck {
  std::string quantity;  // outside_diameter
  double nominal_m = 0, measured_m = 0, u_m = 0;
  Verdict status = Verdict::kNotMeasured;
  std::string reason;  // why not ok
};

}  // namespace spool
