// Pieces of the spool that are elsewhere than the design has them: joint after joint, turned, moved
// or hung elsewhere, until it meets what is left of the scan.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/chain_pieces.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "vision/core/parallel.h"
#include "vision/inspect/chain_weigher.h"

namespace spool {
namespace {

constexpr std::size_t kRefined = 16;     // motions looked at closely, each round
constexpr double kLeastCoverage = 0.35;  // of the moved piece, by what is left of the scan…
constexpr double kElsewhere = 0.6;       // …of one hung elsewhere: any like pipe lies elsewhere
constexpr double kAlike = 0.97;          // this near in gain, the name decides…
constexpr double kFromTheJoint = 0.9;    // …and of what changed places, the joint where it did
constexpr float kParallel = 0.9986F;     // cosine of three degrees
constexpr double kInLine = 0.01;         // of the size

// Two branches that changed places: of the second there is no doubt where it hangs.
bool is_counterpart(const ChainMotion& motion, const JointBranch& branch,
                    const std::vector<ChainMotion>& before, std::span<const JointBranch> tree) {
  return motion.fault == PieceFault::kExchanged &&
         std::any_of(before.begin(), before.end(), [&](const ChainMotion& first) {
           return first.hangs_at == branch.joint && tree[first.branch].joint == motion.hangs_at;
         });
}

// Of what is explained about as well the shorter piece is meant: the elbow that is turned, not the
// pipe before it. But where branches changed places, they did so from the joint on.
bool is_better(const WeighedMotion& one, const WeighedMotion& best,
               std::span<const JointBranch> tree) {
  const bool both_hang =
      one.motion.fault == PieceFault::kExchanged && best.motion.fault == PieceFault::kExchanged;
  const std::size_t parts = tree[one.motion.branch].parts.size();
  const std::size_t best_parts = tree[best.motion.branch].parts.size();
  const bool is_meant = both_hang ? parts > best_parts : parts < best_parts;
  const double alike = both_hang ? kFromTheJoint : kAlike;
  return one.gain > (is_meant ? alike * best.gain : best.gain / alike);
}

// A joint in line with a motion's own: the same motion could have gone wrong there.
bool is_in_line(const JointBranch& one, const JointBranch& other, double size_m) {
  return one.turns && one.frame.outward.dot(other.frame.outward) > kParallel &&
         double{(one.frame.point - other.frame.point).cross(other.frame.outward).norm()} <
             kInLine * size_m &&
         (one.holds(other.part_far) || other.holds(one.part_far));
}

// Takes the parts of `gone` from the branch; false where it had none of them.
bool without_parts(const JointBranch& gone, JointBranch& branch) {
  for (const int part : gone.parts) branch.is_part[static_cast<std::size_t>(part)] = 0;
  return std::erase_if(branch.parts, [&](int part) { return gone.holds(part); }) > 0;
}

// The scan as it is used up: what a piece explains is no longer left, and no piece loses by it.
class RestOfScan {
 public:
  explicit RestOfScan(const ChainScan& scan)
      : scan_(scan),
        explained_part_(scan.explained_part.begin(), scan.explained_part.end()),
        left_(scan.left.begin(), scan.left.end()),
        place_(left_.size()) {
    for (std::uint32_t i = 0; i < place_.size(); ++i) place_[i] = i;
  }

  [[nodiscard]] ChainScan scan() const {
    return {scan_.explained, explained_part_, scan_.is_well, left_};
  }
  // All points, near to which a moved surface may be.
  [[nodiscard]] Occupancy occupancy(double near_m) const {
    std::vector<Eigen::Vector3f> all(left_);
    all.insert(all.end(), scan_.explained.begin(), scan_.explained.end());
    return {all, near_m};
  }
  // Takes the motion's points, and returns their places in the scan as it was.
  std::vector<std::uint32_t> take(const WeighedMotion& weighed) {
    for (const std::uint32_t i : weighed.explained) explained_part_[i] = -1;
    std::vector<std::uint32_t> taken;
    std::vector<std::uint8_t> is_taken(left_.size(), 0);
    for (const std::uint32_t i : weighed.points) {
      is_taken[i] = 1;
      taken.push_back(place_[i]);
    }
    std::size_t to = 0;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      if (is_taken[i] != 0) continue;
      left_[to] = left_[i];
      place_[to++] = place_[i];
    }
    left_.resize(to);
    place_.resize(to);
    return taken;
  }

 private:
  ChainScan scan_;
  std::vector<std::int32_t> explained_part_;
  std::vector<Eigen::Vector3f> left_;
  std::vector<std::uint32_t> place_;
};

Piece piece_of(const WeighedMotion& weighed, std::vector<std::uint32_t> points,
               std::span<const JointBranch> tree, const DesignModel& design) {
  const JointBranch& branch = tree[weighed.motion.branch];
  Piece piece;
  piece.joint = branch.joint;
  piece.parts = branch.parts;
  piece.fault = weighed.motion.fault;
  piece.motion = weighed.motion.move.cast<double>();
  piece.motion.linear() = Eigen::Quaterniond(piece.motion.linear()).normalized().toRotationMatrix();
  piece.points = std::move(points);
  piece.explained = weighed.explained;
  piece.part = branch.part_far;
  if (piece.fault == PieceFault::kTooLong || piece.fault == PieceFault::kTooShort) {
    piece.amount = piece.motion.translation().dot(branch.frame.outward.cast<double>());
    const auto near = static_cast<std::size_t>(branch.part_near);
    if (design.parts[near].kind == PartKind::kPipe) piece.part = branch.part_near;
  } else {
    piece.amount = pose_size(piece.motion).rotation_rad;
  }
  return piece;
}

// One round: the motion that explains most of what is left.
class Round {
 public:
  Round(std::span<const JointBranch> tree, const ChainWeigher& weigher, const ChainScan& scan,
        const std::vector<ChainMotion>& before)
      : tree_(tree), weigher_(weigher), scan_(scan), before_(before) {}

  // Adds the best of `motions` where it is better than what there is.
  void weigh(const std::vector<ChainMotion>& motions, const Watch& watch) {
    std::vector<std::optional<WeighedMotion>> weighed(motions.size());
    parallel_chunks(motions.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t m = begin; m < end && !watch.cancelled(); ++m) {
        const bool is_doubtful =
            motions[m].fault == PieceFault::kExchanged &&
            !is_counterpart(motions[m], tree_[motions[m].branch], before_, tree_);
        weighed[m] = weigher_.weigh(scan_, motions[m], is_doubtful ? kElsewhere : kLeastCoverage);
      }
    });
    for (std::optional<WeighedMotion>& each : weighed)
      if (each && (!best_ || is_better(*each, *best_, tree_))) best_ = std::move(each);
  }
  [[nodiscard]] const std::optional<WeighedMotion>& best() const { return best_; }

 private:
  std::span<const JointBranch> tree_;
  const ChainWeigher& weigher_;
  ChainScan scan_;
  const std::vector<ChainMotion>& before_;
  std::optional<WeighedMotion> best_;
};

}  // namespace

std::vector<Piece> chain_pieces(const DesignModel& design, std::span<const JointBranch> joints,
                                const SurfaceSamples& samples, const ChainScan& scan,
                                const ChainOptions& options, const Watch& watch) {
  std::vector<Piece> pieces;
  std::vector<JointBranch> tree(joints.begin(), joints.end());
  std::vector<ChainMotion> moved;
  if (tree.empty() || !samples.cloud.has_normals()) return pieces;
  std::vector<PieceShape> shapes;
  std::vector<std::vector<PipeEndPoint>> ends;
  for (const JointBranch& branch : tree) {
    shapes.emplace_back(branch.is_part, samples);
    ends.push_back(pipe_end(design, branch, samples));
  }
  const ChainWeigher weigher(tree, shapes, design, samples, options);
  if (scan.left.size() < weigher.least_points()) return pieces;

  RestOfScan rest(scan);
  std::vector<std::uint8_t> is_done(tree.size(), 0);
  while (pieces.size() < options.most_pieces && !watch.cancelled()) {
    const Occupancy occupancy = rest.occupancy(kRoughMotion * options.size_m);
    std::vector<std::vector<ChainMotion>> of_branch(tree.size());
    parallel_chunks(tree.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end && !watch.cancelled(); ++b)
        if (is_done[b] == 0 && !shapes[b].probes.empty())
          of_branch[b] = chain_motions({b, tree[b], shapes[b], ends[b]}, occupancy, options.size_m);
    });
    std::vector<ChainMotion> motions;
    for (const auto& some : of_branch) motions.insert(motions.end(), some.begin(), some.end());
    // By surface won, not by share: a long piece tells more than a short one.
    for (ChainMotion& motion : motions)
      motion.gain *= static_cast<float>(shapes[motion.branch].samples.size());
    keep_promising(motions, kRefined);
    Round round(tree, weigher, rest.scan(), moved);
    round.weigh(motions, watch);
    if (!round.best()) break;
    // At which of the joints in line it went wrong is too fine for the rough look.
    const ChainMotion found = round.best()->motion;
    motions.clear();
    for (std::size_t b = 0; b < tree.size(); ++b) {
      if (b == found.branch || is_done[b] != 0 || found.fault == PieceFault::kExchanged ||
          !is_in_line(tree[b], tree[found.branch], options.size_m))
        continue;
      if (found.fault == PieceFault::kTooShort &&
          double{found.move.translation().norm()} > tree[b].most_shorter_m)
        continue;  // no pipe there to be so short
      motions.push_back(found);
      motions.back().branch = b;
    }
    round.weigh(motions, watch);
    const WeighedMotion& best = *round.best();
    pieces.push_back(piece_of(best, rest.take(best), tree, design));
    moved.push_back(best.motion);
    // What hangs on it has moved with it, and what it hung on moves without it from now on.
    const JointBranch gone = tree[best.motion.branch];
    for (std::size_t b = 0; b < tree.size(); ++b) {
      if (gone.holds(tree[b].part_far)) is_done[b] = 1;
      if (is_done[b] != 0 || !without_parts(gone, tree[b])) continue;
      shapes[b] = PieceShape(tree[b].is_part, samples);
    }
  }
  return pieces;
}

}  // namespace spool
