// What speaks for a branch of the spool being somewhere else: refined on the scan and weighed.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "vision/design/design_model.h"
#include "vision/design/sampling.h"
#include "vision/inspect/chain_motions.h"
#include "vision/inspect/chain_scan.h"

namespace spool {

struct WeighedMotion {
  ChainMotion motion;                 // refined
  std::vector<std::uint32_t> points;  // into scan.left: on the moved piece, or on a pipe's excess
  std::vector<std::uint32_t> explained;  // into scan.explained: on it as well
  double gain = 0;                       // points won, less chance and those lost
};

// All outlive it. `shapes`: one a branch of `tree`.
class ChainWeigher {
 public:
  ChainWeigher(std::span<const JointBranch> tree, std::span<const PieceShape> shapes,
               const DesignModel& design, const SurfaceSamples& samples,
               const ChainOptions& options);

  // Nothing where too little speaks for it. `least`: share of the piece's surface that has to show
  // where it has moved to. Thread-safe.
  [[nodiscard]] std::optional<WeighedMotion> weigh(const ChainScan& scan, const ChainMotion& motion,
                                                   double least) const;

  // Below that nothing can speak for a motion.
  [[nodiscard]] std::size_t least_points() const;

 private:
  // What hangs, as designed, where this one is moved to; null where it is not hung elsewhere.
  [[nodiscard]] const JointBranch* counterpart(const ChainMotion& motion) const;

  // How many of the points would lie on the branch that hangs where this one is moved to, were it
  // hung at this one's joint: two that changed places.
  [[nodiscard]] std::size_t on_counterpart(const ChainMotion& motion,
                                           std::span<const Eigen::Vector3f> points) const;

  // Whether what the moved piece hangs on shows where they meet: else nothing says that it is the
  // spool's and not something that looks like it.
  [[nodiscard]] bool is_joined(const ChainScan& scan, const ChainMotion& motion) const;

  std::span<const JointBranch> tree_;
  std::span<const PieceShape> shapes_;
  const DesignModel& design_;
  const SurfaceSamples& samples_;
  ChainOptions options_;
  double gate_m_ = 0;
};

}  // namespace spool
