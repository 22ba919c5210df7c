// What speaks for a branch of the spool being somewhere else.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/chain_weigher.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "vision/find/field_icp.h"
#include "vision/find/pose_search.h"
#include "vision/find/surface_field.h"

namespace spool {
namespace {

constexpr std::size_t kLeastPoints = 25;
constexpr double kMostChance = 0.25;  // of the points on it, that clutter would put there
constexpr double kClose = 3;          // gates: steel there is no clutter that happens to be near…
constexpr double kMostBeside = 0.4;   // …and this many of it to one point on the piece: not it
constexpr double kSetBack = 0.02;     // m: so far from its end a pipe's surface is looked at
constexpr std::size_t kCounterpartPoints = 400;
constexpr double kJoinShown = 0.35;    // of what a piece hangs on, along the joint…
constexpr float kRoundJoint = 4;       // …so many times what a tried motion may miss
constexpr double kExcessShown = 0.75;  // of the length that is too much

// Whether points lie on a surface, told by its samples.
class OnSurface {
 public:
  OnSurface(const PointCloud& samples, double size_m, double gate_m)
      : samples_(samples),
        field_(samples, size_m / 200, 2.5 * kRoughMotion * size_m),
        gate_m_(gate_m) {}

  [[nodiscard]] const SurfaceField& field() const { return field_; }
  [[nodiscard]] bool is_round(const Eigen::Vector3f& p) const {
    return field_.nearest(p) != SurfaceField::kFar;
  }
  [[nodiscard]] bool is_on(const Eigen::Vector3f& p) const { return is_within(p, gate_m_); }
  // On it, or so near that steel of another form lies there.
  [[nodiscard]] bool is_close(const Eigen::Vector3f& p) const {
    return is_within(p, kClose * gate_m_);
  }

 private:
  [[nodiscard]] bool is_within(const Eigen::Vector3f& p, double gate_m) const {
    const std::uint16_t s = field_.nearest(p);
    if (s == SurfaceField::kFar) return false;
    const Eigen::Vector3f offset = p - samples_.points[s];
    const double aside = 2 * field_.cell_m() + gate_m;
    return double{std::abs(samples_.normals[s].dot(offset))} < gate_m &&
           double{offset.squaredNorm()} < aside * aside;
  }

  const PointCloud& samples_;
  SurfaceField field_;
  double gate_m_;
};

// The length of pipe that is too much: where the pipe on either side of the joint would go on.
class Excess {
 public:
  Excess(const DesignModel& design, const SurfaceSamples& samples, const JointBranch& branch,
         const Eigen::Isometry3f& move, const ChainOptions& options, double gate_m)
      : frame_(branch.frame), by_m_(move.translation().dot(branch.frame.outward)) {
    is_shown_.assign(static_cast<std::size_t>(std::max(
                         1L, std::lround(double{by_m_} / (kRoughMotion * options.size_m)))),
                     0);
    for (const int part : {branch.part_near, branch.part_far}) {
      if (design.parts[static_cast<std::size_t>(part)].kind != PartKind::kPipe) continue;
      std::vector<std::uint8_t> is_part(design.parts.size(), 0);
      is_part[static_cast<std::size_t>(part)] = 1;
      samples_.push_back(std::make_unique<PointCloud>(samples_of(is_part, samples)));
      pipes_.push_back({OnSurface(*samples_.back(), options.size_m, gate_m),
                        part == branch.part_near ? -1.0F : 1.0F});
    }
  }

  // Whether the point lies on it; if so, that length of it shows.
  bool takes(const Eigen::Vector3f& p) {
    const float along = (p - frame_.point).dot(frame_.outward);
    if (along < 0 || along > by_m_) return false;
    const bool holds = std::any_of(pipes_.begin(), pipes_.end(), [&](const Pipe& pipe) {
      const float to = pipe.side * static_cast<float>(kSetBack);
      return pipe.surface.is_on(p + (to - along) * frame_.outward);
    });
    const auto slices = static_cast<float>(is_shown_.size());
    if (holds)
      is_shown_[std::min(is_shown_.size() - 1, static_cast<std::size_t>(slices * along / by_m_))] =
          1;
    return holds;
  }

  // What is joined to a pipe that is too long is joined to it by what is too much: a piece that
  // lies further out with nothing between is something else.
  [[nodiscard]] bool shows() const {
    const auto shown = std::count(is_shown_.begin(), is_shown_.end(), 1);
    return pipes_.empty() ||
           static_cast<double>(shown) >= kExcessShown * static_cast<double>(is_shown_.size());
  }

 private:
  struct Pipe {
    OnSurface surface;
    float side;  // of the joint
  };
  JointFrame frame_;
  float by_m_;
  std::vector<std::uint8_t> is_shown_;  // of each length, as long as a motion may miss
  std::vector<std::unique_ptr<PointCloud>> samples_;
  std::vector<Pipe> pipes_;
};

// How far (m) the motion takes the piece, where most.
double farthest_m(const Eigen::Isometry3f& move, const PieceShape& shape) {
  float farthest = 0;
  for (const Eigen::Vector3f& p : shape.probes)
    farthest = std::max(farthest, (move * p - p).norm());
  return double{farthest};
}

}  // namespace

ChainWeigher::ChainWeigher(std::span<const JointBranch> tree, std::span<const PieceShape> shapes,
                           const DesignModel& design, const SurfaceSamples& samples,
                           const ChainOptions& options)
    : tree_(tree),
      shapes_(shapes),
      design_(design),
      samples_(samples),
      options_(options),
      gate_m_(options.gate_m()) {}

std::size_t ChainWeigher::least_points() const { return kLeastPoints; }

const JointBranch* ChainWeigher::counterpart(const ChainMotion& motion) const {
  const auto other = std::find_if(tree_.begin(), tree_.end(), [&](const JointBranch& each) {
    return each.joint == motion.hangs_at;
  });
  return other == tree_.end() ? nullptr : &*other;
}

std::size_t ChainWeigher::on_counterpart(const ChainMotion& motion,
                                         std::span<const Eigen::Vector3f> points) const {
  const JointBranch& branch = tree_[motion.branch];
  const JointBranch* other = counterpart(motion);
  if (!branch.turns || other == nullptr || points.empty()) return 0;
  const PieceShape& shape = shapes_[static_cast<std::size_t>(other - tree_.data())];
  const double rough_m = kRoughMotion * options_.size_m;
  const OnSurface surface(shape.samples, options_.size_m, rough_m);
  const std::size_t step = points.size() / kCounterpartPoints + 1;
  std::size_t most = 0;
  for (const Eigen::Isometry3f& move : hung_at(other->frame, branch.frame)) {
    const Eigen::Isometry3f T = move.inverse();
    std::size_t on = 0;
    for (std::size_t i = 0; i < points.size(); i += step)
      on += surface.is_on(T * points[i]) ? 1U : 0U;
    most = std::max(most, on);
  }
  return std::min(points.size(), most * step);
}

bool ChainWeigher::is_joined(const ChainScan& scan, const ChainMotion& motion) const {
  const JointBranch* at = counterpart(motion);
  const JointBranch& joint = at == nullptr ? tree_[motion.branch] : *at;
  const auto rough_m = static_cast<float>(kRoughMotion * options_.size_m);
  std::vector<Eigen::Vector3f> surface, shown;
  for (std::size_t s = 0; s < samples_.part.size(); ++s) {
    const Eigen::Vector3f off = samples_.cloud.points[s] - joint.frame.point;
    if (samples_.part[s] == joint.part_near &&
        std::abs(off.dot(joint.frame.outward)) < kRoundJoint * rough_m)
      surface.push_back(samples_.cloud.points[s]);
  }
  if (surface.empty()) return true;
  for (std::size_t i = 0; i < scan.explained.size(); ++i)
    if (scan.explained_part[i] == joint.part_near) shown.push_back(scan.explained[i]);
  const Occupancy near(shown, double{rough_m});
  return double{pose_score(Eigen::Isometry3f::Identity(), near, surface)} >= kJoinShown;
}

std::optional<WeighedMotion> ChainWeigher::weigh(const ChainScan& scan, const ChainMotion& motion,
                                                 double least) const {
  if (!is_joined(scan, motion)) return std::nullopt;
  const JointBranch& branch = tree_[motion.branch];
  const PieceShape& shape = shapes_[motion.branch];
  const OnSurface surface(shape.samples, options_.size_m, gate_m_);
  std::vector<Eigen::Vector3f> all(scan.left.begin(), scan.left.end());
  all.insert(all.end(), scan.explained.begin(), scan.explained.end());
  const FieldIcpResult icp =
      refine_on_field(all, shape.samples, surface.field(), motion.move.inverse(),
                      {.iterations = 15,
                       .start_gate_m = 1.5 * kRoughMotion * options_.size_m,
                       .end_gate_m = gate_m_});
  WeighedMotion weighed{motion, {}, {}, 0};
  const Pose refinement = (icp.T_design_scan * motion.move).cast<double>();
  const HeldBy held_by = motion.fault == PieceFault::kExchanged ? HeldBy::kShape : HeldBy::kJoint;
  const Eigen::Isometry3f T_piece_scan =
      shape.as_held(refinement, held_by).cast<float>() * motion.move.inverse();
  weighed.motion.move = T_piece_scan.inverse();

  if (farthest_m(weighed.motion.move, shape) < options_.least_move_m) return std::nullopt;
  const bool is_longer = motion.fault == PieceFault::kTooLong;
  const auto excess = is_longer ? std::make_unique<Excess>(design_, samples_, branch,
                                                           weighed.motion.move, options_, gate_m_)
                                : nullptr;
  std::size_t round_it = 0, beside = 0;
  std::vector<Eigen::Vector3f> on, stays, lost;  // on the piece in its place; where they were
  std::size_t on_excess = 0;
  for (std::uint32_t i = 0; i < scan.left.size(); ++i) {
    const Eigen::Vector3f p = T_piece_scan * scan.left[i];
    if (surface.is_on(p)) {
      weighed.points.push_back(i);
      on.push_back(p);
    } else if (excess && excess->takes(scan.left[i])) {
      weighed.points.push_back(i);
      ++on_excess;
    } else {
      round_it += surface.is_round(p) ? 1U : 0U;
      beside += surface.is_close(p) ? 1U : 0U;
    }
  }
  const auto won = static_cast<double>(on.size());
  // What stays on it although it moves, as a pipe does that slides along itself, or the first
  // length of two branches that changed places; what lies on it and was taken for another part;
  // what would lie on nothing any more. What lay only near the
  // design and lies on the piece is won, and costs nothing where it does not.
  const JointBranch* other = counterpart(motion);
  // Of two sides of the datum each is nearly all of the spool: they have more than a length in
  // common, and that one lies on the other says nothing.
  if (other != nullptr && other->holds(branch.part_far)) other = nullptr;
  for (std::uint32_t i = 0; i < scan.explained.size(); ++i) {
    const bool was_on = branch.holds(scan.explained_part[i]);
    const bool was_well = scan.is_well.empty() || scan.is_well[i] != 0;
    const Eigen::Vector3f p = T_piece_scan * scan.explained[i];
    if (surface.is_on(p)) {
      weighed.explained.push_back(i);
      if (was_on)
        (was_well ? stays : on).push_back(p);
      else if (other != nullptr && other->holds(scan.explained_part[i]))
        stays.push_back(p);
    } else {
      const bool is_excess = excess && excess->takes(scan.explained[i]);
      if (was_on && was_well && !is_excess) lost.push_back(scan.explained[i]);
    }
  }
  if (excess && !excess->shows()) return std::nullopt;
  const double reach = surface.field().reach_m();
  const double chance =
      static_cast<double>(round_it) * gate_m_ / std::max(gate_m_, reach - gate_m_);
  // By what is left: that is far from the design.
  if (won < kLeastPoints || chance + 3 * std::sqrt(chance) > kMostChance * won) return std::nullopt;
  // A stand's square post lies on a pipe along its four faces, and its edges beside it.
  if (static_cast<double>(beside) > kMostBeside * won) return std::nullopt;
  std::size_t missed = lost.size();
  if (motion.fault == PieceFault::kExchanged) missed -= on_counterpart(motion, lost);
  weighed.gain = static_cast<double>(on.size()) + static_cast<double>(on_excess) - chance -
                 static_cast<double>(missed);
  const auto covered = [&] {
    return double{pose_score(Eigen::Isometry3f::Identity(),
                             Occupancy(on, kRoughMotion * options_.size_m), shape.probes)};
  };
  const double by_left = covered();
  on.insert(on.end(), stays.begin(), stays.end());
  const double by_stays_alone = std::max(0.0, covered() - by_left);
  if (by_left < least * (1 - by_stays_alone) || weighed.gain < kLeastPoints) return std::nullopt;
  return weighed;
}

}  // namespace spool
