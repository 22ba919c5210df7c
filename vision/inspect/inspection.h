// Everything one inspection found: what reports are written from and overlays drawn from.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "vision/align/icp.h"
#include "vision/core/pose.h"
#include "vision/inspect/chain_pieces.h"
#include "vision/inspect/declutter.h"
#include "vision/inspect/deviation.h"
#include "vision/inspect/dimension.h"
#include "vision/inspect/joint_error.h"
#include "vision/inspect/part_pose.h"
#include "vision/inspect/sensor_evidence.h"
#include "vision/inspect/unexpected.h"
#include "vision/inspect/verdict.h"

namespace spool {

enum class AlignMethod { kPose, kThreePoint, kPrincipalAxes, kFind };
[[nodiscard]] std::string_view name(
    AlignMethod method);  // "pose", "three-point", "principal-axes", "find"
[[nodiscard]] std::optional<AlignMethod> parse_align_method(std::string_view text);

struct Alignment {
  AlignMethod method = AlignMethod::kPose;
  bool found = false;                     // false: nothing below means anything
  std::string reason;                     // why not, or what to mind
  Pose T_design_scan = Pose::Identity();  // between the files' own frames (origins included)
  Matrix6d covariance = Matrix6d::Zero();
  std::vector<WeakDirection> weak_directions;
  double rms_m = 0;
  double overlap = 0;
  bool ambiguous = false;     // alternatives explain the scan about as well
  bool is_symmetric = false;  // all of them are the design's own symmetry: no matter which
  std::vector<Pose> alternatives;
  std::vector<double> pair_residual_m;
  double seconds = 0;
};

struct PartFinding {
  int part = -1;
  Verdict status = Verdict::kNotMeasured;
  std::string reason;  // why not better, and what would settle it
  PartDeviation deviation;
  std::vector<SizeCheck> size_checks;
  PartPose pose;  // where it stands, the datum aligned
};

struct Finding {
  std::string kind;  // missing | unexpected | misplaced | one_holed | mirrored | wrong_size | scale
                     // | symmetry
  std::string part;
  std::string text;
  std::string evidence;
};

// One state: everything here belongs to the same points at the same pose (promise 5).
struct Inspection {
  Alignment alignment;
  DeclutterResult declutter;
  PointCloud scan_design;  // every input point in input order, in the design frame (design origin
                           // taken off)
  Deviations deviations;   // one entry a point of scan_design; none of a stopped inspection
  std::vector<Piece> pieces;           // of the spool that are there, but elsewhere
  std::vector<Unexpected> unexpected;  // steel on it that the design does not have
  std::vector<PartFinding> parts;      // in the design's order
  std::vector<Dimension> dimensions;   // of the drawing
  ChainResult chain;                   // joint by joint from the datum, and what to do
  std::string datum;  // what positions are relative to, or why there is nothing; empty: not asked
  std::optional<ScaleCheck> scale;  // nothing: no piece of known size was measured
  std::optional<WarpCheck> warp;    // nothing: no plane was looked at
  std::vector<Finding> findings;
  Verdict status = Verdict::kNotMeasured;
  std::string status_reason;  // the first finding, then what was and was not judged
  double scan_rms_m = 0;      // eq. 3.1, scan quality
  std::map<std::string, double> timing_s;
};

}  // namespace spool
