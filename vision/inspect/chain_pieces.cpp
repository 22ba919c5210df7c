// Pieces of the spool that are elsewhere than the design has them: joint after joint, turned, moved
// or hung elsewhere, until it meets what is left of the scan.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/chain_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "vision/core/parallel.h"
#include "vision/find/field_icp.h"
#include "vision/find/occupancy.h"
#include "vision/find/pose_search.h"
#include "vision/find/surface_field.h"
#include "vision/inspect/joint_tree.h"

namespace spool {
namespace {

constexpr double kRough = 0.012;      // of the size: as far as a tried motion may miss
constexpr double kSlide = 0.06;       // of the size: as far as a pipe is tried too long
constexpr int kSlides = 30;           // each way
constexpr int kTurns = 180;           // of two degrees
constexpr int kSpins = 24;            // of fifteen degrees, where a piece hangs elsewhere
constexpr std::size_t kProbes = 200;  // of a piece's surface
constexpr float kRoughGain = 0.2F;    // of a piece's surface that a motion has to win
constexpr std::size_t kRefined = 16;  // motions looked at closely, each round
constexpr std::size_t kLeastPoints = 25;
constexpr double kLeastCoverage = 0.35;  // of the moved piece, by what is left of the scan…
constexpr double kElsewhere = 0.6;       // …of one hung elsewhere: any like pipe lies elsewhere
constexpr double kMostChance = 0.25;     // of the points on it, that clutter would put there
constexpr double kAlike = 0.97;          // this near in gain: the shorter piece is meant
constexpr std::size_t kMostPieces = 4;

struct Motion {
  std::size_t branch = 0;  // into the joint tree
  PieceFault fault = PieceFault::kTurned;
  Eigen::Isometry3f move = Eigen::Isometry3f::Identity();
  float gain = 0;  // share of the piece's surface
};

// A branch as geometry: its samples, and some of them to probe with.
struct BranchShape {
  PointCloud samples;
  std::vector<Eigen::Vector3f> probes;
};

BranchShape shape_of(const JointBranch& branch, const SurfaceSamples& samples) {
  BranchShape shape;
  for (std::size_t s = 0; s < samples.part.size(); ++s) {
    if (!branch.holds(samples.part[s])) continue;
    shape.samples.points.push_back(samples.cloud.points[s]);
    shape.samples.normals.push_back(samples.cloud.normals[s]);
  }
  // Samples come in random order (Poisson disk): every nth is spread as they are.
  const std::size_t step = shape.samples.size() / kProbes + 1;
  for (std::size_t s = 0; s < shape.samples.size(); s += step)
    shape.probes.push_back(shape.samples.points[s]);
  return shape;
}

// `move` moves the design; is the moved surface where the scan has points?
float met(const Eigen::Isometry3f& move, const Occupancy& occupancy, const BranchShape& shape) {
  return pose_score(move.inverse(), occupancy, shape.probes);
}

Eigen::Isometry3f turn_about(const Eigen::Vector3f& point, const Eigen::Vector3f& axis,
                             float angle) {
  Eigen::Isometry3f move = Eigen::Isometry3f::Identity();
  move.linear() = Eigen::AngleAxisf(angle, axis).toRotationMatrix();
  move.translation() = point - move.linear() * point;
  return move;
}

void keep_promising(std::vector<Motion>& motions, std::size_t count) {
  std::stable_sort(motions.begin(), motions.end(),
                   [](const Motion& a, const Motion& b) { return a.gain > b.gain; });
  if (motions.size() > count) motions.resize(count);
}

// The best few of each kind of motion of one branch.
std::vector<Motion> motions_of(const std::vector<JointBranch>& tree, std::size_t b,
                               const BranchShape& shape, const Occupancy& occupancy,
                               double size_m) {
  const JointBranch& branch = tree[b];
  const float here = met(Eigen::Isometry3f::Identity(), occupancy, shape);
  std::vector<Motion> all;
  if (here > 1 - kRoughGain) return all;
  constexpr float kPi = std::numbers::pi_v<float>;
  std::vector<Motion> some;
  const auto take = [&](PieceFault fault, const Eigen::Isometry3f& move) {
    const float gain = met(move, occupancy, shape) - here;
    if (gain > kRoughGain) some.push_back({b, fault, move, gain});
  };
  const auto keep = [&](std::size_t count) {
    keep_promising(some, count);
    all.insert(all.end(), some.begin(), some.end());
    some.clear();
  };
  for (int i = 1; i < kTurns; ++i)
    take(PieceFault::kTurned,
         turn_about(branch.point, branch.outward, 2 * kPi * static_cast<float>(i) / kTurns));
  keep(3);
  for (int i = -kSlides; i <= kSlides; ++i) {
    if (i == 0) continue;
    Eigen::Isometry3f move = Eigen::Isometry3f::Identity();
    move.translation() = static_cast<float>(kSlide * size_m * i / kSlides) * branch.outward;
    take(i > 0 ? PieceFault::kTooLong : PieceFault::kTooShort, move);
  }
  keep(3);
  for (const JointBranch& other : tree) {
    if (&other == &branch || branch.holds(other.part_far)) continue;
    Eigen::Isometry3f carry = Eigen::Isometry3f::Identity();
    carry.linear() =
        Eigen::Quaternionf::FromTwoVectors(branch.outward, other.outward).toRotationMatrix();
    carry.translation() = other.point - carry.linear() * branch.point;
    for (int i = 0; i < kSpins; ++i)
      take(
          PieceFault::kExchanged,
          turn_about(other.point, other.outward, 2 * kPi * static_cast<float>(i) / kSpins) * carry);
  }
  keep(3);
  return all;
}

// A motion refined on what is left and weighed: the points on the moved piece, less those that lie
// on the piece in its place and would no longer be explained.
struct Weighed {
  Motion motion;
  std::vector<std::uint32_t> points;  // into scan.left
  double gain = 0;                    // points
};

class Weigher {
 public:
  Weigher(const ChainScan& scan, const ChainOptions& options) : scan_(scan), options_(options) {}

  [[nodiscard]] std::optional<Weighed> weigh(const Motion& motion, const JointBranch& branch,
                                             const BranchShape& shape) const {
    const double reach = 2.5 * kRough * options_.size_m;
    const SurfaceField field(shape.samples, options_.size_m / 200, reach);
    const double gate = std::max(3.5 * options_.noise_m, 0.001 * options_.size_m);
    std::vector<Eigen::Vector3f> all(scan_.left.begin(), scan_.left.end());
    all.insert(all.end(), scan_.explained.begin(), scan_.explained.end());
    const FieldIcpResult icp = refine_on_field(
        all, shape.samples, field, motion.move.inverse(),
        {.iterations = 15, .start_gate_m = 1.5 * kRough * options_.size_m, .end_gate_m = gate});
    Weighed weighed{motion, {}, 0};
    weighed.motion.move = icp.T_design_scan.inverse();
    const auto is_on = [&](const Eigen::Vector3f& p_scan, const Eigen::Isometry3f& T,
                           bool& is_round) {
      const Eigen::Vector3f p = T * p_scan;
      const std::uint16_t s = field.nearest(p);
      is_round = s != SurfaceField::kFar;
      if (!is_round) return false;
      const Eigen::Vector3f offset = p - shape.samples.points[s];
      const double beside = 2 * field.cell_m() + gate;
      return std::abs(shape.samples.normals[s].dot(offset)) < gate &&
             double{offset.squaredNorm()} < beside * beside;
    };
    std::size_t round_it = 0;
    bool is_round = false;
    std::vector<Eigen::Vector3f> on;
    for (std::uint32_t i = 0; i < scan_.left.size(); ++i) {
      if (is_on(scan_.left[i], icp.T_design_scan, is_round)) {
        weighed.points.push_back(i);
        on.push_back(icp.T_design_scan * scan_.left[i]);
      } else {
        round_it += is_round ? 1U : 0U;
      }
    }
    const double chance = static_cast<double>(round_it) * gate / std::max(gate, reach - gate);
    std::size_t lost = 0;
    for (std::size_t i = 0; i < scan_.explained.size(); ++i)
      if (branch.holds(scan_.explained_part[i]) &&
          !is_on(scan_.explained[i], icp.T_design_scan, is_round))
        ++lost;
    if (weighed.points.size() < kLeastPoints ||
        chance + 3 * std::sqrt(chance) > kMostChance * static_cast<double>(weighed.points.size()))
      return std::nullopt;
    weighed.gain = static_cast<double>(weighed.points.size()) - chance - static_cast<double>(lost);
    const Occupancy vouched(on, kRough * options_.size_m);
    const float coverage = pose_score(Eigen::Isometry3f::Identity(), vouched, shape.probes);
    const double least = motion.fault == PieceFault::kExchanged ? kElsewhere : kLeastCoverage;
    if (coverage < least || weighed.gain < kLeastPoints) return std::nullopt;
    return weighed;
  }

 private:
  const ChainScan& scan_;
  const ChainOptions& options_;
};

Piece piece_of(const Weighed& weighed, const std::vector<JointBranch>& tree,
               const DesignModel& design) {
  const JointBranch& branch = tree[weighed.motion.branch];
  Piece piece;
  piece.joint = branch.joint;
  piece.parts = branch.parts;
  piece.fault = weighed.motion.fault;
  piece.motion = weighed.motion.move.cast<double>();
  piece.motion.linear() = Eigen::Quaterniond(piece.motion.linear()).normalized().toRotationMatrix();
  piece.points = weighed.points;
  piece.part = branch.part_far;
  if (piece.fault == PieceFault::kTooLong || piece.fault == PieceFault::kTooShort) {
    piece.amount = piece.motion.translation().dot(branch.outward.cast<double>());
    const auto near = static_cast<std::size_t>(branch.part_near);
    if (design.parts[near].kind == PartKind::kPipe) piece.part = branch.part_near;
  } else {
    piece.amount = pose_size(piece.motion).rotation_rad;
  }
  return piece;
}

}  // namespace

std::vector<Piece> chain_pieces(const DesignModel& design, const SurfaceSamples& samples,
                                const ChainScan& scan, const ChainOptions& options,
                                const Watch& watch) {
  std::vector<Piece> pieces;
  const std::vector<JointBranch> tree = joint_tree(design);
  if (tree.empty() || scan.left.size() < kLeastPoints || !samples.cloud.has_normals())
    return pieces;
  std::vector<BranchShape> shapes;
  for (const JointBranch& branch : tree) shapes.push_back(shape_of(branch, samples));

  ChainScan now = scan;
  std::vector<Eigen::Vector3f> left(scan.left.begin(), scan.left.end());
  std::vector<std::uint32_t> place(left.size());
  for (std::uint32_t i = 0; i < place.size(); ++i) place[i] = i;
  std::vector<std::uint8_t> is_done(tree.size(), 0);
  while (pieces.size() < kMostPieces && !watch.cancelled()) {
    now.left = left;
    std::vector<Eigen::Vector3f> all(left);
    all.insert(all.end(), scan.explained.begin(), scan.explained.end());
    const Occupancy occupancy(all, kRough * options.size_m);
    std::vector<std::vector<Motion>> of_branch(tree.size());
    parallel_chunks(tree.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end && !watch.cancelled(); ++b)
        if (is_done[b] == 0 && !shapes[b].probes.empty())
          of_branch[b] = motions_of(tree, b, shapes[b], occupancy, options.size_m);
    });
    std::vector<Motion> motions;
    for (const auto& some : of_branch) motions.insert(motions.end(), some.begin(), some.end());
    // By surface won, not by share: a long piece tells more than a short one.
    for (Motion& motion : motions)
      motion.gain *= static_cast<float>(shapes[motion.branch].samples.size());
    keep_promising(motions, kRefined);
    const Weigher weigher(now, options);
    std::vector<std::optional<Weighed>> weighed(motions.size());
    parallel_chunks(motions.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t m = begin; m < end && !watch.cancelled(); ++m)
        weighed[m] = weigher.weigh(motions[m], tree[motions[m].branch], shapes[motions[m].branch]);
    });
    const Weighed* best = nullptr;
    for (const std::optional<Weighed>& each : weighed) {
      if (!each) continue;
      const bool is_shorter = best != nullptr && tree[each->motion.branch].parts.size() <
                                                     tree[best->motion.branch].parts.size();
      const double needed = best == nullptr ? 0
                            : is_shorter    ? kAlike * best->gain
                                            : best->gain / kAlike;
      if (best == nullptr || each->gain > needed) best = &*each;
    }
    if (best == nullptr) break;
    pieces.push_back(piece_of(*best, tree, design));
    // What it explains is no longer left, and what hangs on it has moved with it.
    std::vector<std::uint8_t> taken(left.size(), 0);
    for (std::uint32_t& i : pieces.back().points) {
      taken[i] = 1;
      i = place[i];
    }
    std::vector<Eigen::Vector3f> still;
    std::vector<std::uint32_t> still_place;
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (taken[i] != 0) continue;
      still.push_back(left[i]);
      still_place.push_back(place[i]);
    }
    left = std::move(still);
    place = std::move(still_place);
    for (std::size_t b = 0; b < tree.size(); ++b)
      if (tree[best->motion.branch].holds(tree[b].part_far)) is_done[b] = 1;
  }
  return pieces;
}

}  // namespace spool
