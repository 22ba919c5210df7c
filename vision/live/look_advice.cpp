// What the fitter may do so that more of the spool is known.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/look_advice.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

namespace spool {
namespace {

constexpr std::size_t kMostPatches = 500;  // of a frame that are asked
constexpr double kFacing = 0.5;            // flatter than 60 degrees a pixel may well be lost
constexpr double kOfLate_s = 0.7;
constexpr double kMany = 1.0 / 3;  // of the patches not known
// Of what is in sight, not known yet: fewer are done with here; and when they are more again.
constexpr double kFewLeft = 0.2, kManyLeft = 0.4;
constexpr double kBefore_m = 0.01;  // and three standard deviations: something is in front
// Within so little a PrimeSense measures nothing, beyond so much hardly anything.
constexpr double kNearest_m = 0.45, kFarthest_m = 3.5;
// Frames, each from a new place: if a second's do not make a patch known, something is wrong.
constexpr double kLooks = 30;

constexpr std::array<std::string_view, kLookTroubles> kWords = {
    "",
    "Something is in front of it: take it away, or look past it.",
    "Too near: go back a little.",
    "Too bright or too dark there to be measured: shade it, or look from a little aside.",
    "Slower: the picture smears.",
    "Closer: from here it is not measured well enough.",
    "Move on slowly: from one place no more is learned."};

constexpr std::array<std::string_view, 6> kWays = {"",
                                                   " from further left",
                                                   " from further right",
                                                   " from above",
                                                   " from below",
                                                   " from the other side"};

}  // namespace

LookAdviser::LookAdviser(const DesignModel& design, const DesignSurface& surface,
                         const Camera& camera, const NoiseModel& noise)
    : design_(design), surface_(surface), camera_(camera), noise_(noise) {}

void LookAdviser::clear() {
  counts_.fill(0);
  in_sight_ = frames_ = 0;
  said_ = LookTrouble::kNone;
  says_next_ = false;
  way_ = 0;
}

// Nothing of a patch that the camera cannot see from there.
std::optional<LookTrouble> LookAdviser::trouble_of(const VisionState& state,
                                                   const PatchReadings& readings, std::size_t k,
                                                   const Pose& T_camera_design) const {
  const SurfacePatch& patch = readings.patches().all()[k];
  const Eigen::Vector3d p = patch.point.cast<double>();
  const Eigen::Vector3d p_camera = T_camera_design * p;
  if (p_camera.z() <= 0) return std::nullopt;
  const Eigen::Vector2d pixel = camera_.project(p_camera);
  const auto u = std::lround(pixel.x()), v = std::lround(pixel.y());
  constexpr long kBeside = 2;  // px: an edge of the picture, or of what is lost, decides nothing
  const DepthFrame& frame = *state.frame;
  if (u < kBeside || v < kBeside || u >= frame.width - kBeside || v >= frame.height - kBeside)
    return std::nullopt;
  const Eigen::Vector3d to_eye = state.T_design_camera.translation() - p;
  const double range = to_eye.norm();
  const Eigen::Vector3f way = (to_eye / range).cast<float>();
  if (patch.normal.dot(way) < kFacing) return std::nullopt;
  const Eigen::Vector3f from = patch.point + (0.1F * patch.radius_m) * (patch.normal + way);
  if (surface_.cast(from, way, static_cast<float>(range))) return std::nullopt;

  const auto depth_at = [&](long du, long dv) {
    const auto at = (v + dv) * frame.width + u + du;
    return frame.depth[static_cast<std::size_t>(at)];
  };
  const std::array<std::uint16_t, 5> depths = {depth_at(0, 0), depth_at(kBeside, 0),
                                               depth_at(-kBeside, 0), depth_at(0, kBeside),
                                               depth_at(0, -kBeside)};
  if (std::ranges::all_of(depths, [](std::uint16_t d) { return d == 0; })) {
    if (p_camera.z() < kNearest_m) return LookTrouble::kTooNear;
    return p_camera.z() > kFarthest_m ? LookTrouble::kTooFar : LookTrouble::kTooBright;
  }
  const double before =
      p_camera.z() - static_cast<double>(*std::ranges::max_element(depths)) * camera_.depth_unit_m;
  if (before > kBefore_m + 3 * noise_.axial_m(p_camera.z())) return LookTrouble::kHidden;
  const double look_m2 = readings.variance_of_a_look(k, state.T_design_camera.translation());
  constexpr double kEnough_m2 = kLooks * kKnownSigma_m * kKnownSigma_m;
  if (look_m2 > kEnough_m2) return LookTrouble::kTooFar;
  if (look_m2 + readings.smear_m2(k) > kEnough_m2) return LookTrouble::kTooFast;
  return readings.is_spent(k) ? LookTrouble::kTooStill : LookTrouble::kNone;
}

void LookAdviser::count(const VisionState& state, const PatchReadings& readings) {
  const double time = state.frame->seconds;
  const double now = std::isfinite(time) ? time : last_s_ + 1.0 / 30;
  const double kept = std::exp(-std::max(0.0, now - last_s_) / kOfLate_s);
  last_s_ = now;
  for (double& count : counts_) count *= kept;
  in_sight_ *= kept;
  frames_ = kept * frames_ + 1;
  const Pose T_camera_design = state.T_design_camera.inverse();
  const std::size_t all = readings.patches().all().size();
  const std::size_t step = all / kMostPatches + 1;
  for (std::size_t k = 0; k < all; k += step) {
    const auto trouble = trouble_of(state, readings, k, T_camera_design);
    if (!trouble) continue;
    in_sight_ += 1;
    if (!readings.is_known(k)) counts_[static_cast<std::size_t>(*trouble)] += 1;
  }
}

LookAdvice LookAdviser::advise(const VisionState& state, const PatchReadings& readings,
                               const std::optional<NextLook>& next) {
  count(state, readings);
  const double not_known = std::accumulate(counts_.begin(), counts_.end(), 0.0);
  // How many have the trouble, and how sure that is; frames on end see the same patches.
  const auto is_many = [&](std::size_t trouble, double sigmas) {
    if (not_known <= 0) return false;
    const double share = counts_[trouble] / not_known;
    const double patches = not_known / frames_;
    return share + sigmas * std::sqrt(share * (1 - share) / patches) > kMany && patches >= 1;
  };
  const auto worst = static_cast<std::size_t>(std::max_element(counts_.begin() + 1, counts_.end()) -
                                              counts_.begin());
  const auto said = static_cast<std::size_t>(said_);
  if (said == 0 || !is_many(said, 2))
    said_ = is_many(worst, -2) ? static_cast<LookTrouble>(worst) : LookTrouble::kNone;
  const double left = in_sight_ > 0 ? not_known / in_sight_ : 0;
  says_next_ = left < (says_next_ ? kManyLeft : kFewLeft);

  LookAdvice advice;
  if (said_ != LookTrouble::kNone && !says_next_) {
    advice.text = kWords[static_cast<std::size_t>(said_)];
  } else if (says_next_ && next) {
    advice.text = words_for(*next, state.T_design_camera);
    advice.part = next->part;
    advice.target = next->target;
  }
  return advice;
}

// "from further left", as the fitter sees it now; the way that was said last while it is about
// that.
std::string LookAdviser::words_for(const NextLook& next, const Pose& T_design_camera) {
  const Eigen::Vector3d target = next.target.cast<double>();
  const Eigen::Vector3d side = next.direction.cast<double>();
  const Eigen::Vector3d now = (T_design_camera.translation() - target).normalized();
  const Eigen::Vector3d aside = T_design_camera.linear().transpose() * side;  // x right, y down
  const double along = side.dot(now);
  // How well each way fits: what it says of the side, as cosines.
  const std::array<double, kWays.size()> fits = {2 * along - 1, -aside.x(), aside.x(),
                                                 -aside.y(),    aside.y(),  -2 * along - 0.4};
  const auto best = static_cast<std::size_t>(std::ranges::max_element(fits) - fits.begin());
  constexpr double kClearly = 0.15;
  if (way_ >= kWays.size() || fits[best] > fits[way_] + kClearly) way_ = best;
  const std::string part = next.part < 0 ? std::string("the spool")
                                         : design_.parts[static_cast<std::size_t>(next.part)].name;
  // From where the camera is: what is in its picture is too far off to be known.
  const Eigen::Vector3d p = T_design_camera.inverse() * target;
  const Eigen::Vector2d pixel = p.z() > 0 ? camera_.project(p) : Eigen::Vector2d(-1, -1);
  const bool is_in_picture =
      pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < camera_.width && pixel.y() < camera_.height;
  if (way_ == 0 && is_in_picture) return "Next: go closer to " + part + ".";
  return "Next: look at " + part + std::string(kWays[way_]) + ".";
}

}  // namespace spool
