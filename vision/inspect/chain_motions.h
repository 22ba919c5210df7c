// Where a branch of the spool may be instead: turned, slid or hung elsewhere, tried roughly.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vision/find/occupancy.h"
#include "vision/inspect/joint_tree.h"
#include "vision/inspect/piece_shape.h"
#include "vision/inspect/pipe_end.h"

namespace spool {

// What is wrong at the joint that a piece hangs on.
enum class PieceFault : std::uint8_t { kTurned, kTooLong, kTooShort, kExchanged };

// So far (share of the design's size) a tried motion may miss.
inline constexpr double kRoughMotion = 0.012;

struct ChainMotion {
  std::size_t branch = 0;  // into the joint tree
  PieceFault fault = PieceFault::kTurned;
  Eigen::Isometry3f move = Eigen::Isometry3f::Identity();  // of the branch, design frame
  float gain = 0;                                          // share of the branch's surface
  int hangs_at = -1;                                       // exchanged: the joint
};

// A branch as it is moved.
struct MovedBranch {
  std::size_t place = 0;  // in the joint tree
  const JointBranch& branch;
  const PieceShape& shape;
  const std::vector<PipeEndPoint>& end;  // of the pipe at its joint
};

// The best few of each kind of motion of one branch by the surface that they lay on scan points
// beyond what lies there unmoved; where a pipe is too long, the length that is too much counts as
// well. `occupancy`: of the scan off floor and walls, design frame.
[[nodiscard]] std::vector<ChainMotion> chain_motions(const MovedBranch& moved,
                                                     const Occupancy& occupancy, double size_m);

// A branch hung at `frame` instead of at its own, in every fifteen degrees of turn.
[[nodiscard]] std::vector<Eigen::Isometry3f> hung_at(const JointFrame& own,
                                                     const JointFrame& frame);

// The most promising first, no more than `count`.
void keep_promising(std::vector<ChainMotion>& motions, std::size_t count);

}  // namespace spool
