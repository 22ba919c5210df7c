// Pieces of the spool that are there, but elsewhere than the design has them: a joint turned, a
// pipe too long, branches exchanged.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vision/core/cancel.h"
#include "vision/core/pose.h"
#include "vision/design/design_model.h"
#include "vision/design/sampling.h"
#include "vision/inspect/chain_motions.h"
#include "vision/inspect/chain_scan.h"
#include "vision/inspect/joint_tree.h"

namespace spool {

struct Piece {
  int joint = -1;  // of the design: between what is right and the piece
  int part = -1;   // that is to be named: the first of the piece, or the pipe of wrong length
  std::vector<int> parts;  // of the piece
  PieceFault fault = PieceFault::kTurned;
  Pose motion = Pose::Identity();        // from where the design has the piece to where it is
  double amount = 0;                     // rad turned, m too long or short
  std::vector<std::uint32_t> points;     // of those left that lie on the moved piece, ascending
  std::vector<std::uint32_t> explained;  // of those explained that lie on it as well, ascending
};

// Takes the branches at `joints` one by one (joint_tree() or datum_sides()) and looks whether each
// is where the design has it; if not, whether turned about the joint's axis, moved along it or hung
// where another part should be it meets what is left. The kinematic chain of thesis 3.3.2 (Nahangi
// & Haas 2014), searched instead of measured. The best explained piece first.
[[nodiscard]] std::vector<Piece> chain_pieces(const DesignModel& design,
                                              std::span<const JointBranch> joints,
                                              const SurfaceSamples& samples, const ChainScan& scan,
                                              const ChainOptions& options, const Watch& watch = {});

}  // namespace spool
